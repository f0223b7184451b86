"""What a run leaves in Prefect's UI: a table of results, the failures, a link to the report."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
import contextlib
import os
from pathlib import Path
import re
from typing import Any
from urllib.parse import quote

from prefect.artifacts import (
    create_link_artifact,
    create_markdown_artifact,
    create_table_artifact,
)

REPORTS_URL = "ESG_REPORTS_URL"
"""Where the folder of the nights (`--out`) is served, e.g. by `python -m http.server -d`."""
MAX_ROWS = 200
"""Rows of an artifact at most: it is a summary, the data are in Parquet."""


def artifact_name(*parts: str) -> str:
    """A key as Prefect wants it: lower-case letters, digits and dashes."""
    return re.sub(r"[^a-z0-9]+", "-", "-".join(parts).lower()).strip("-")


def table(name: str, rows: Sequence[Mapping[str, Any]], description: str) -> None:
    """A table; call it inside a flow. An API that does not take it is no reason to fail."""
    shown = [{k: _cell(v) for k, v in row.items()} for row in rows[:MAX_ROWS]]
    with contextlib.suppress(Exception):
        create_table_artifact(table=shown, key=artifact_name(name), description=description)


def failures(name: str, rows: Sequence[Mapping[str, Any]]) -> None:
    """The rows of a `failures.jsonl`; call it inside a flow."""
    lines = [f"{len(rows)} scenes failed." if rows else "No scene failed.", ""]
    if rows:
        lines += ["| scene | outcome | stage | reason |", "| --- | --- | --- | --- |"]
        for row in rows[:MAX_ROWS]:
            reason = str(row["reason"]).replace("|", "\\|").replace("\n", " ")[:200]
            lines.append(f"| {row['scene']} | {row['outcome']} | {row['stage']} | {reason} |")
    with contextlib.suppress(Exception):
        create_markdown_artifact(
            markdown="\n".join(lines), key=artifact_name(name, "failures"), description="Failures"
        )


def report_link(name: str, path: Path, out: Path) -> None:
    """A link to a report; call it inside a flow.

    Args:
        name: Of the run.
        path: Of the report.
        out: The folder that `ESG_REPORTS_URL` serves, if that is set.
    """
    link, where = _address(path.resolve(), out.resolve())
    with contextlib.suppress(Exception):
        create_link_artifact(
            link=link, link_text="Report", key=artifact_name(name, "report"), description=where
        )


def _address(path: Path, out: Path) -> tuple[str, str]:
    """Where a browser finds a file, and what to say about that.

    Browsers do not follow links from a page of a server to files, so a server's links need one too.
    """
    base = os.environ.get(REPORTS_URL, "").strip().rstrip("/")
    if base and path.is_relative_to(out):
        return f"{base}/{quote(path.relative_to(out).as_posix())}", "Opens from here"
    return path.as_uri(), f"Copy into a browser on the machine that wrote it, or set {REPORTS_URL}"


def _cell(value: Any) -> Any:
    return round(value, 4) if isinstance(value, float) else value
