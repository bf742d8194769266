# `make` alone lists the targets. Those that need Python packages first install them, from a lock file with hashes,
# into .venv; a file in .venv says that this is done, so that it costs nothing until a lock file changes.

PYTHON ?= python3
# The Python to make .venv of, after = if the .venv that is there will do; nothing if it is too old.
FOUND := $(shell "$(PYTHON)" -I scripts/environment.py --find 2>/dev/null)
COMPILE = uv pip compile --quiet --universal --generate-hashes --no-annotate --no-header \
  --no-emit-index-url --no-emit-find-links pyproject.toml
export PATH := $(CURDIR)/.venv/bin:$(PATH)

.DEFAULT_GOAL := help
.PHONY: help report docs maps test test-all test-kernels lint format derive lock mutate benchmark peers check-install clean

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1|\2/p' Makefile | awk -F'|' '{ printf "%-22s %s\n", $$1, $$2 }'

report: .venv/for-use ## derive, solve, judge; writes build/report/report.html, report.pdf, cards.pdf and claims.json
	@trimmer report

# Pictures are kept in build/site-pictures until their page or script, or the package, changes.
docs: .venv/for-development ## build the site, build/site/index.html; fails on a broken link or a block that prints something else
	@NO_MKDOCS_2_WARNING=1 MPLBACKEND=agg python -m mkdocs build --strict # not --quiet: that hides warnings from --strict
	@echo build/site/index.html

# BLAS with several threads is slower here: its matrices are small, and the cells already use all cores.
maps: .venv/for-use ## compute the maps, branches and answers again, report/data/twin; goes on where it was interrupted
	@OPENBLAS_NUM_THREADS=1 python -m report.twin.make_maps

# The tests of a file share what they make once. Bytecode is kept, also where the environment forbids it: or else
# each process, and the tests start many, compiles all sources again. BLAS has one thread, as the matrices are small and
# the processes of the tests use all cores; test-kernels asks with one and with two.
test: .venv/for-development ## run the tests; ARGS="-k claim" passes options to pytest
	@PYTHONDONTWRITEBYTECODE= OPENBLAS_NUM_THREADS=1 python -m pytest -n auto --maxprocesses 4 --dist loadfile $(ARGS)

test-all: .venv/for-development ## run all tests, the slow ones too
	@ALL_TESTS=1 PYTHONDONTWRITEBYTECODE= OPENBLAS_NUM_THREADS=1 python -m pytest -n auto --maxprocesses 4 --dist loadfile -m "slow or not slow" $(ARGS)

# Claims and digits are the same on every processor and Python; scripts/kernels says how others are imitated here.
test-kernels: .venv/for-development ## run the tests that rest on digits as on other processors and Pythons; ARGS="--list" says which; half an hour
	@python -m scripts.kernels $(ARGS)

lint: .venv/for-development ## ruff (rules and format), mypy, import-linter, tests by doors; changes nothing
	@ruff check .
	@ruff format --check .
	@mypy
	@lint-imports
	@python -m scripts.doors

format: .venv/for-development ## sort imports and format the sources
	@ruff check --select I --fix .
	@ruff format .

derive: .venv/for-use ## write trimmer/generated again from the derivation
	@trimmer derive --module trimmer/generated/linear_trimmer.py

lock: .venv/for-development ## write both lock files again, keeping versions that still fit; ARGS=--upgrade takes the newest
	@$(COMPILE) $(ARGS) --group build -o requirements.lock
	@$(COMPILE) $(ARGS) --all-extras --group dev -c requirements.lock -o requirements-dev.lock

mutate: .venv/for-development ## change the sources at random in a copy, and count what tests and claims notice; goes on where it was; an hour or two
	@OPENBLAS_NUM_THREADS=1 python -m scripts.mutation all $(ARGS)

peers: .venv/for-development ## run SciPy, python-control, MuJoCo, pyHarm, Siconos on the problems they can do, beside ours (needs network)
	@OPENBLAS_NUM_THREADS=1 python -m benchmarks.peers.run

benchmark: .venv/for-development ## measure the build and the start, each beside a peer in the same run
	@python benchmarks/run.py

check-install: .venv/for-development ## build the wheel, install it in a fresh environment, use it from another folder (needs network)
	@python scripts/check_install.py

clean: ## remove what the targets above have written, except .venv
	rm -rf build dist .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache

.venv/for-use: requirements.lock pyproject.toml
	$(install)

.venv/for-development: requirements-dev.lock pyproject.toml
	$(install)

define install
	@command -v "$(PYTHON)" >/dev/null || \
	  { echo "error: '$(PYTHON)' is not there; install Python 3.11 or newer, or run make PYTHON=/path/to/it" >&2; exit 1; }
	@test -n "$(FOUND)" || { echo "error: this project needs Python 3.11 or newer, but '$(PYTHON)' is \
	$$("$(PYTHON)" -V 2>&1); run make PYTHON=/path/to/newer/python" >&2; exit 1; }
	@"$(patsubst =%,%,$(FOUND))" -I scripts/environment.py $<
endef

ifeq ($(filter =%,$(FOUND)),)
.PHONY: .venv/for-use .venv/for-development
endif
