"""What is loaded ahead for one scene: engines in a companion, pictures while that searches."""

from __future__ import annotations

from collections.abc import Callable
import importlib
import sys

SEARCH = ("esg.dynamics", "esg.dynamics.strategies", "newton", "newton.sensors")
FILM = ("esg.view.preview", "av", "esg.compile.export")
PICTURES = (
    "sapien", "pxr.Sdf", "pxr.Usd", "pxr.UsdGeom", "pxr.UsdPhysics", "pxr.UsdShade",
    "esg.compile.export", "esg.view.preview", "esg.view.setting",
)  # fmt: skip
RECORDS = ("duckdb", "pyarrow.parquet", "esg.store", "pandas")  # which pyarrow asks for at tables
"""Libraries and modules, in the order in which a scene comes to need them."""
DRAWN, TRACED = "esg.view.scan.kernels", "esg.view.tracer.kernels"
"""Kernels of films and of sheets, whose source is hashed before they are taken from the cache."""


def cold() -> bool:
    """Whether this process has not loaded what searches, as a warm worker has."""
    return "newton" not in sys.modules


def load_search() -> None:
    """Loads what a search needs, its engines' kernels included."""
    from esg.engines.doctor import load_kernels

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


def _load(modules: tuple[str, ...]) -> None:
    from esg.engines.newton import quiet_warp

    quiet_warp()
    for module in modules:
        importlib.import_module(module)


def _kernels(module: str) -> None:
    from esg.engines.newton import quiet_warp

    importlib.import_module(module)
    quiet_warp().load_module(module, device="cpu")
