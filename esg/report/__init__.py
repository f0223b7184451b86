"""The run report: one page that opens from disk and shows what a run made."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.report.page import write_report
    from esg.report.run import Run, load_run

__all__ = ["Run", "load_run", "write_report"]

_WHERE = {"Run": "run", "load_run": "run", "write_report": "page"}


def __getattr__(name: str) -> Any:
    import importlib

    if name not in _WHERE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_WHERE[name]}"), name)
