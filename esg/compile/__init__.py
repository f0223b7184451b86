"""Stage 5: the Unreal class of a scene, its proof by execution, and exports.

The names below are loaded on first use, so that importing the package stays cheap.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.compile.build import ClassError, ClassFiles, CompilerMissing, compile_many
    from esg.compile.emit import EmittedClass, emit_class
    from esg.compile.export import export
    from esg.compile.model import WatchedEvent
    from esg.compile.replay import ClassReplay, ReplayError, replay_class
    from esg.compile.scene import CompiledScene, compile_scene, document_program, watch_list

_HOME = {
    "ClassError": "build",
    "ClassFiles": "build",
    "ClassReplay": "replay",
    "CompiledScene": "scene",
    "CompilerMissing": "build",
    "EmittedClass": "emit",
    "ReplayError": "replay",
    "WatchedEvent": "model",
    "compile_many": "build",
    "compile_scene": "scene",
    "document_program": "scene",
    "emit_class": "emit",
    "export": "export",
    "replay_class": "replay",
    "watch_list": "scene",
}

__all__ = [
    "ClassError",
    "ClassFiles",
    "ClassReplay",
    "CompiledScene",
    "CompilerMissing",
    "EmittedClass",
    "ReplayError",
    "WatchedEvent",
    "compile_many",
    "compile_scene",
    "document_program",
    "emit_class",
    "export",
    "replay_class",
    "watch_list",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    import importlib

    return getattr(importlib.import_module(f"esg.compile.{_HOME[name]}"), name)
