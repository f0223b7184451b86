"""Importing what scenes need before somebody waits for it."""

from __future__ import annotations

import contextlib
import importlib

SAMPLES = (
    "A red ball rolls across the floor and hits a wooden box.",
    "A car collides with a trashbin, knocking it into a picnic table by the street side.",
)
"""Scenes whose way through the stages loads what scenes need."""


def load_usd() -> None:
    """Loads USD's libraries, which no thread may do while another one imports anything native.

    Their constructors let go of Python's lock while the loader's is held and then wait for it; a
    thread that holds Python's and waits for the loader's (any import of a compiled module) never
    gives it back, and the command hangs without a word.
    """
    with contextlib.suppress(ImportError):  # reported by the stage that needs it
        for library in ("Sdf", "Usd", "UsdGeom", "UsdPhysics", "UsdShade"):
            importlib.import_module(f"pxr.{library}")


def warm_up(shared_cores: bool = False) -> None:
    """Imports what scenes need and silences it; results do not depend on it.

    Args:
        shared_cores: Others need the cores while this process waits for a GPU.
    """
    if shared_cores:
        from esg.machine.waiting import sleep_for_gpus

        sleep_for_gpus()
    with contextlib.suppress(Exception):  # a missing library is reported by the stage that needs it
        from esg.engines.newton import quiet_warp

        quiet_warp()
        load_usd()
        for library in ("newton", "newton.sensors", "sapien", "spacy", "trimesh"):
            importlib.import_module(library)
