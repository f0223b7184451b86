"""Results on disk: artifacts by content, Parquet tables, MCAP logs, DuckDB (docs/store.md)."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.store.artifacts import ArtifactStore, artifact_key
    from esg.store.assembling import assemble
    from esg.store.db import QueryResult, migrate, query, snapshot
    from esg.store.ingesting import IngestReport, ingest, rebuild
    from esg.store.mcap_log import write_mcap
    from esg.store.records import RunInfo, SceneRecord, prompt_family, record_of, split_of
    from esg.store.tables import read_table, write_tables

_HOME = {
    "ArtifactStore": "artifacts",
    "artifact_key": "artifacts",
    "QueryResult": "db",
    "IngestReport": "ingesting",
    "ingest": "ingesting",
    "migrate": "db",
    "query": "db",
    "rebuild": "ingesting",
    "snapshot": "db",
    "write_mcap": "mcap_log",
    "RunInfo": "records",
    "SceneRecord": "records",
    "prompt_family": "records",
    "record_of": "records",
    "split_of": "records",
    "assemble": "assembling",
    "read_table": "tables",
    "write_tables": "tables",
}

__all__ = [
    "ArtifactStore",
    "IngestReport",
    "QueryResult",
    "RunInfo",
    "SceneRecord",
    "artifact_key",
    "assemble",
    "ingest",
    "migrate",
    "prompt_family",
    "query",
    "read_table",
    "rebuild",
    "record_of",
    "snapshot",
    "split_of",
    "write_mcap",
    "write_tables",
]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"esg.store.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
