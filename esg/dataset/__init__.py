"""Datasets of dynamic scenes: what to make, making it in batches, putting it together.

Nothing here knows about schedulers (docs/dataset.md): `tasks/dataset.py` calls `make_batch`.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.dataset.batch import make_batch
    from esg.dataset.distribution import Distribution
    from esg.dataset.finish import finish
    from esg.dataset.folder import DatasetFolder
    from esg.dataset.grammar import SampledScene, sample_scenes
    from esg.dataset.job import BatchJob, BatchResult
    from esg.dataset.plan import DatasetSpec, PlannedScene, Shard

_HOME = {
    "BatchJob": "job",
    "BatchResult": "job",
    "make_batch": "batch",
    "finish": "finish",
    "DatasetFolder": "folder",
    "Distribution": "distribution",
    "SampledScene": "grammar",
    "sample_scenes": "grammar",
    "DatasetSpec": "plan",
    "PlannedScene": "plan",
    "Shard": "plan",
}

__all__ = [
    "BatchJob",
    "BatchResult",
    "DatasetFolder",
    "DatasetSpec",
    "Distribution",
    "PlannedScene",
    "SampledScene",
    "Shard",
    "finish",
    "make_batch",
    "sample_scenes",
]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"esg.dataset.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
