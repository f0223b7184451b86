"""What is loaded ahead for one scene: engines in a companion, pictures while that searches."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
import contextlib
import importlib
from importlib.abc import Loader
from importlib.machinery import ModuleSpec, PathFinder
import sys
import threading
from types import ModuleType
from typing import Any

SEARCH = ("esg.dynamics", "esg.dynamics.strategies", "newton", "scipy.spatial")
FILM = (
    "esg.assets.geometry.mesh", "esg.view.preview", "av", "scipy.ndimage", "esg.compile.export",
)  # fmt: skip
PICTURES = (
    "esg.assets.geometry.mesh", "esg.assets.geometry.shapes", "sapien", "esg.compile.replay",
    "pxr.Sdf", "pxr.Usd", "pxr.UsdGeom", "pxr.UsdPhysics", "pxr.UsdShade", "esg.compile.export",
    "esg.view.preview", "esg.view.setting",
)  # fmt: skip
RECORDS = ("duckdb", "pyarrow.parquet", "pyarrow.compute", "esg.store")
"""Libraries and modules, in the order in which a scene comes to need them."""
LATER = frozenset(
    f"newton.{name}"
    for name in (
        "actuators", "controllers", "ik", "selection", "sensors", "usd", "utils", "viewer",
        "_src.solvers.coupled", "_src.solvers.featherstone",
    )
)  # fmt: skip
"""What `newton` imports for whoever asks, a quarter of its time: no search does."""
UNASKED = frozenset({
    "numpy.ctypeslib", "numpy.f2py", "numpy.ma", "numpy.polynomial", "numpy.testing", "requests",
    "sapien.utils.viewer", "scipy.ndimage", "trimesh.boolean", "trimesh.collision",
    "trimesh.curvature", "trimesh.poses", "trimesh.proximity", "trimesh.smoothing", "trimesh.voxel",
})  # fmt: skip
"""What SciPy, SAPIEN and trimesh import for whoever asks."""
WITHOUT = frozenset({"pxr"})
"""Libraries that it takes where they are there, to read files of scenes: no search does."""
DRAWN, TRACED = "esg.view.scan.kernels", "esg.view.tracer.kernels"
"""Kernels of films and of sheets, whose source is hashed before they are taken from the cache."""


def cold() -> bool:
    """Whether this process has not loaded what searches, as a warm worker has."""
    return "newton" not in sys.modules


def load_search() -> None:
    """Loads what a search needs, its engines' kernels included."""
    from esg.engines.doctor import load_kernels

    with _spared(LATER | UNASKED, WITHOUT), _unread():
        _load(SEARCH)
        load_kernels()


def load_film() -> None:
    """Loads what a film needs."""
    with _unread(), _spared(UNASKED):
        _load(FILM)
        _kernels(DRAWN)


def load_pictures() -> None:
    """Loads what a replay and exports need."""
    with _unread(), _spared(UNASKED):
        _load(PICTURES)


def load_records() -> None:
    """Loads what the row of a run needs, but pandas, which pyarrow asks for at its first table."""
    _load(RECORDS)
    with _spared(without=frozenset({"pandas"})):
        vars(sys.modules["pyarrow"])["array"]([{}])


def load_sheet() -> None:
    """Loads what a sheet needs."""
    with _unread():
        _kernels(TRACED)


AHEAD: tuple[Callable[[], None], ...] = (load_search, load_film)
"""What a companion loads: before the search, and after it."""
MEANWHILE: tuple[Callable[[], None], ...] = (load_pictures, load_records, load_sheet)
"""What the command itself loads while others work."""


class _Later(ModuleType):
    """A module that is executed once a name is wanted that it does not have."""

    def __getattr__(self, name: str) -> Any:
        if name in ("__path__", "__file__"):  # asked of any module
            raise AttributeError(name)
        with _executing:
            if type(self) is _Later and "_begun" not in vars(self):
                vars(self)["_begun"] = True
                spec = self.__spec__
                assert spec is not None
                assert spec.loader is not None
                spec.loader.exec_module(self)
                executed: Any = self
                executed.__class__ = ModuleType
        if name in vars(self):
            return vars(self)[name]
        raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")


_executing = threading.RLock()


class _Postponing(Loader):
    """Makes modules that another loader executes later."""

    def __init__(self, loader: Loader) -> None:
        self._loader = loader

    def create_module(self, spec: ModuleSpec) -> None:
        """None: a module as usual."""

    def exec_module(self, module: ModuleType) -> None:
        assert module.__spec__ is not None
        module.__spec__.loader = module.__loader__ = self._loader
        module.__class__ = _Later


class _Finder:
    """Finds modules of some names as usual, to be executed once one of their names is wanted.

    Args:
        later: Their names.
        without: Names of libraries that are not found.
    """

    def __init__(self, later: frozenset[str], without: frozenset[str]) -> None:
        self._later, self._without = later, without

    def find_spec(
        self, name: str, path: Sequence[str] | None = None, target: object = None
    ) -> ModuleSpec | None:
        if name in self._without:
            raise ModuleNotFoundError(f"{name} is left out", name=name)
        spec = PathFinder.find_spec(name, path) if name in self._later else None
        if spec is not None and spec.loader is not None:
            spec.loader = _Postponing(spec.loader)
        return spec


@contextlib.contextmanager
def _spared(
    later: frozenset[str] = frozenset(), without: frozenset[str] = frozenset()
) -> Generator[None]:
    """Modules that the body imports are executed at their first use, or not found; for one thread.

    Args:
        later: Names of modules.
        without: Names of libraries.
    """
    finder = _Finder(later, without)
    sys.meta_path.insert(0, finder)
    try:
        yield
    finally:
        sys.meta_path.remove(finder)


def _unread() -> contextlib.AbstractContextManager[None]:
    from esg.engines.newton import unread

    return unread()


def _load(modules: tuple[str, ...]) -> None:
    from esg.engines.newton import quiet_warp

    quiet_warp()
    for module in modules:
        importlib.import_module(module)


def _kernels(module: str) -> None:
    from esg.engines.newton import quiet_warp

    importlib.import_module(module)
    quiet_warp().load_module(module, device="cpu")
