"""Which source files a module depends on, read from their import statements without running anything."""

import ast
import hashlib
import platform
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Self

from report.cache.stage_store import StageStore

SUFFIXES = (".py", ".pyi")
PACKAGES = ("derivations", "trimmer", "report")
ROOT = Path(__file__).parents[2]
IMPORTS = "imports"  # Name under which the imports of all sources are kept

Names = tuple[str, ...]
NOTHING_KNOWN: Mapping[str, Names] = MappingProxyType({})


@dataclass(frozen=True)
class SourceFile:
    """A source file as it is now."""

    digest: str  # Of its content
    imports: Names  # Dotted names of the modules it imports, and of what it imports from them


@dataclass(frozen=True)
class SourceTree:
    """All sources of the three packages."""

    sources: Mapping[str, SourceFile]  # By path from the folder of the packages, with slashes

    @classmethod
    def read(cls, root: Path = ROOT, known: Mapping[str, Names] = NOTHING_KNOWN) -> Self:
        """Read all sources, and their imports where they are not known by the digest of the content.

        Imports inside functions and for type checking count too: they may name too much, never too little.
        """
        sources = {}
        for path in sorted(path for package in PACKAGES for path in (root / package).rglob("*.py*")):
            if path.suffix not in SUFFIXES:
                continue
            content = path.read_bytes()
            digest = hashlib.sha256(content).hexdigest()
            package = path.parent.relative_to(root).as_posix().replace("/", ".")
            imports = known[digest] if digest in known else tuple(_imports(ast.parse(content), package))
            sources[path.relative_to(root).as_posix()] = SourceFile(digest, imports)
        return cls(sources)

    @classmethod
    def kept(cls, store: StageStore, root: Path = ROOT) -> Self:
        """Read all sources; the imports of those that have not changed are kept from the last time.

        Raises:
            FileWriteError: if the imports cannot be kept.
        """
        key = platform.python_version()
        known = store.load(IMPORTS, key) or NOTHING_KNOWN
        tree = cls.read(root, known)
        if tree.imports != known:
            store.keep(IMPORTS, key, tree.imports)
        return tree

    @cached_property
    def imports(self) -> dict[str, Names]:
        """What each source imports, by the digest of its content."""
        return {source.digest: source.imports for source in self.sources.values()}

    def closure(self, module: str) -> frozenset[str]:
        """Return the paths of the sources of a module and of all that it imports, directly or not.

        What is no module of the three packages has none.
        """
        seen: set[str] = set()
        waiting = set(self._of(module))
        while waiting:
            seen |= waiting
            waiting = {path for begun in waiting for path in self._imported[begun]} - seen
        return frozenset(seen)

    def digest(self, modules: Iterable[str], *others: object) -> str:
        """Return a digest of all sources that modules depend on, and of other things by their ``repr``."""
        summary = hashlib.sha256(repr(others).encode())
        for path in sorted(frozenset().union(*map(self.closure, modules))):
            summary.update(f"{path}\0{self.sources[path].digest}\0".encode())
        return summary.hexdigest()

    @cached_property
    def _imported(self) -> dict[str, frozenset[str]]:
        """The sources that each source imports itself."""
        return {
            path: frozenset(imported for name in source.imports for imported in self._of(name))
            for path, source in self.sources.items()
        }

    @cached_property
    def _exported(self) -> dict[str, str]:
        """The name in its module of each name that a package's stub exports."""
        stubs = {path: source for path, source in self.sources.items() if path.endswith("/__init__.pyi")}
        return {
            f"{path.rpartition('/')[0].replace('/', '.')}.{name.rpartition('.')[2]}": name
            for path, source in stubs.items()
            for name in source.imports
        }

    def _of(self, name: str) -> Iterator[str]:
        """Yield the source of a module, or of the module that a name is imported from, and its packages'.

        Of a package that imports its names on first use, a name alone depends on that name's module, and the
        package itself on all.
        """
        names = dict.fromkeys((self._exported.get(name, name), name))
        stems = [
            "/".join(each.split(".")[:length]) for each in names for length in range(1, each.count(".") + 2)
        ]
        paths = [path for stem in stems for path in (f"{stem}/__init__.py", f"{stem}.py")]
        paths.append(f"{name.replace('.', '/')}/__init__.pyi")
        yield from (path for path in paths if path in self.sources)


def _imports(module: ast.Module, package: str) -> Iterator[str]:
    for node in ast.walk(module):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module is not None and node.level <= 1:
            # What is imported may be a module itself.
            source = f"{package}.{node.module}" if node.level else node.module
            yield from (f"{source}.{alias.name}" for alias in node.names)
