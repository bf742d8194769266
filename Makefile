# `make` alone lists the targets. Every target that needs Python packages installs them first, from a lock file
# with hashes, into .venv; when nothing has changed that costs a few hundredths of a second.

PYTHON ?= python3
BOOTSTRAP = "$(PYTHON)" scripts/bootstrap.py
COMPILE = uv pip compile --quiet --universal --generate-hashes --no-annotate --no-header \
  --no-emit-index-url --no-emit-find-links pyproject.toml

.DEFAULT_GOAL := help
.PHONY: help report test lint format derive lock benchmark check-install clean python

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1|\2/p' Makefile | awk -F'|' '{ printf "%-22s %s\n", $$1, $$2 }'

report: python ## derive, solve, judge; writes build/report/report.html, report.pdf and claims.json
	@$(BOOTSTRAP) requirements.lock -- trimmer report

# The tests of a file share what they make once.
test: python ## run the tests; ARGS="-k claim" passes options to pytest
	@$(BOOTSTRAP) requirements-dev.lock -- python -m pytest -n auto --maxprocesses 4 --dist loadfile $(ARGS)

lint: python ## ruff (rules and format), mypy, import-linter; changes nothing
	@$(BOOTSTRAP) requirements-dev.lock -- ruff check .
	@$(BOOTSTRAP) requirements-dev.lock -- ruff format --check .
	@$(BOOTSTRAP) requirements-dev.lock -- mypy
	@$(BOOTSTRAP) requirements-dev.lock -- lint-imports

format: python ## sort imports and format the sources
	@$(BOOTSTRAP) requirements-dev.lock -- ruff check --select I --fix .
	@$(BOOTSTRAP) requirements-dev.lock -- ruff format .

derive: python ## write trimmer/generated again from the derivation
	@$(BOOTSTRAP) requirements.lock -- trimmer derive --module trimmer/generated/linear_trimmer.py

lock: python ## write both lock files again, keeping versions that still fit; ARGS=--upgrade takes the newest
	@$(BOOTSTRAP) requirements-dev.lock -- $(COMPILE) $(ARGS) --group build -o requirements.lock
	@$(BOOTSTRAP) requirements-dev.lock -- $(COMPILE) $(ARGS) --group dev -c requirements.lock -o requirements-dev.lock

benchmark: python ## measure the build and the start, each beside a peer in the same run
	@$(BOOTSTRAP) requirements-dev.lock -- python benchmarks/run.py

check-install: python ## build the wheel, install it in a fresh environment, use it from another folder (needs network)
	@$(BOOTSTRAP) requirements-dev.lock -- python scripts/check_install.py

clean: ## remove what the targets above have written, except .venv
	rm -rf build dist .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache

python:
	@command -v "$(PYTHON)" >/dev/null 2>&1 || \
	  { echo "error: '$(PYTHON)' is not there; install Python 3.11 or newer, or run make PYTHON=/path/to/python" >&2; exit 1; }
