"""The judge: SLR, ECR and PPA of a replay, measured against a suite (docs/metrics.md)."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.metrics.aggregate import SceneRun, bench_json, comparison_table, load_paper_results
    from esg.metrics.binding import Binding, bind
    from esg.metrics.expectations import expectations_from_timeline
    from esg.metrics.judging import judge
    from esg.metrics.models import (
        ConstraintVerdict,
        EventVerdict,
        LayoutVerdict,
        SceneVerdict,
        StatementVerdict,
        Suite,
        SuiteConstraint,
        SuiteEvent,
        SuiteScene,
        SuiteStatement,
    )
    from esg.metrics.suite import load_suite, own_suites, parse_suite, suite_file

_HOME = {
    "SceneRun": "aggregate",
    "bench_json": "aggregate",
    "comparison_table": "aggregate",
    "load_paper_results": "aggregate",
    "Binding": "binding",
    "bind": "binding",
    "expectations_from_timeline": "expectations",
    "judge": "judging",
    "ConstraintVerdict": "models",
    "EventVerdict": "models",
    "LayoutVerdict": "models",
    "SceneVerdict": "models",
    "StatementVerdict": "models",
    "Suite": "models",
    "SuiteConstraint": "models",
    "SuiteEvent": "models",
    "SuiteScene": "models",
    "SuiteStatement": "models",
    "load_suite": "suite",
    "own_suites": "suite",
    "parse_suite": "suite",
    "suite_file": "suite",
}

__all__ = [
    "Binding",
    "ConstraintVerdict",
    "EventVerdict",
    "LayoutVerdict",
    "SceneRun",
    "SceneVerdict",
    "StatementVerdict",
    "Suite",
    "SuiteConstraint",
    "SuiteEvent",
    "SuiteScene",
    "SuiteStatement",
    "bench_json",
    "bind",
    "comparison_table",
    "expectations_from_timeline",
    "judge",
    "load_paper_results",
    "load_suite",
    "own_suites",
    "parse_suite",
    "suite_file",
]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"esg.metrics.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
