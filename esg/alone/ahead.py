"""What is loaded ahead for one scene: engines in a companion, pictures while that searches."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
import contextlib
import importlib
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import LazyLoader
import sys

SEARCH = ("esg.dynamics", "esg.dynamics.strategies", "newton")
FILM = ("esg.view.preview", "av", "esg.compile.export")
PICTURES = (
    "sapien", "pxr.Sdf", "pxr.Usd", "pxr.UsdGeom", "pxr.UsdPhysics", "pxr.UsdShade",
    "esg.compile.export", "esg.view.preview", "esg.view.setting",
)  # fmt: skip
RECORDS = ("duckdb", "pyarrow.parquet", "esg.store", "pandas")  # which pyarrow asks for at tables
"""Libraries and modules, in the order in which a scene comes to need them."""
LATER = frozenset(
    f"newton.{name}"
    for name in ("actuators", "controllers", "ik", "selection", "sensors", "usd", "utils", "viewer")
)
"""What `newton` imports for whoever asks, a quarter of its time: no search does."""
DRAWN, TRACED = "esg.view.scan.kernels", "esg.view.tracer.kernels"
"""Kernels of films and of sheets, whose source is hashed before they are taken from the cache."""


def cold() -> bool:
    """Whether this process has not loaded what searches, as a warm worker has."""
    return "newton" not in sys.modules


def load_search() -> None:
    """Loads what a search needs, its engines' kernels included."""
    from esg.engines.doctor import load_kernels

    with _at_first_use(LATER):
        _load(SEARCH)
    load_kernels()


def load_film() -> None:
    """Loads what a film needs."""
    _load(FILM)
    _kernels(DRAWN)


def load_pictures() -> None:
    """Loads what a replay, exports and a sheet need."""
    _load(PICTURES)
    _kernels(TRACED)


def load_records() -> None:
    """Loads what the row of a run needs."""
    _load(RECORDS)


AHEAD: tuple[Callable[[], None], ...] = (load_search, load_film)
"""What a companion loads: before the search, and after it."""
MEANWHILE: tuple[Callable[[], None], ...] = (load_pictures, load_records)
"""What the command itself loads while others work."""


class _Finder:
    """Finds modules of some names as usual, to be executed once one of their names is wanted."""

    def __init__(self, names: frozenset[str]) -> None:
        self._names = names

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: object = None
    ) -> ModuleSpec | None:
        spec = PathFinder.find_spec(name, path) if name in self._names else None
        if spec is not None and spec.loader is not None:
            spec.loader = LazyLoader(spec.loader)
        return spec


@contextlib.contextmanager
def _at_first_use(names: frozenset[str]) -> Generator[None]:
    """Modules that the body imports are executed at their first use; for one thread."""
    finder = _Finder(names)
    sys.meta_path.insert(0, finder)
    try:
        yield
    finally:
        sys.meta_path.remove(finder)


def _load(modules: tuple[str, ...]) -> None:
    from esg.engines.newton import quiet_warp

    quiet_warp()
    for module in modules:
        importlib.import_module(module)


def _kernels(module: str) -> None:
    from esg.engines.newton import quiet_warp

    importlib.import_module(module)
    quiet_warp().load_module(module, device="cpu")
