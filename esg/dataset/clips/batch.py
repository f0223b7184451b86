"""Rendering the scenes of a batch: what is there already is kept, what fails is left out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
import time
import traceback
from typing import TYPE_CHECKING, Any

from esg.dataset.clips.records import ClipRecord
from esg.dataset.clips.rendering import Subject, render_scene
from esg.dataset.job import RENDER
from esg.files import unwritable
from esg.outcomes import UserError
from esg.pipeline import retried
from esg.progress import StageEvent, emit
from esg.store.tables import iter_rows, to_table, write_part
from esg.strangers.scrubbing import scrub_all

if TYPE_CHECKING:
    from esg.dataset.job import BatchJob
    from esg.dataset.plan import RenderSpec

NOT_RENDERED = "not_rendered"
PAUSES_S = (0.5, 1.0)


@dataclass
class Rendered:
    """What became of a batch's scenes.

    Args:
        rows: Of table `clips`, by scene id.
        files: Below the dataset's folder.
        failures: Rows of `failures.jsonl`.
        crashes: Traceback by scene id.
    """

    rows: dict[str, list[dict[str, Any]]] = field(default_factory=dict)
    files: list[Path] = field(default_factory=list)
    failures: list[dict[str, Any]] = field(default_factory=list)
    crashes: dict[str, str] = field(default_factory=dict)


def render_batch(
    job: BatchJob, spec: RenderSpec, subjects: Sequence[Subject], dead: dict[int, str]
) -> Rendered:
    """Renders scenes one after the other.

    Args:
        job: Whose folders are used.
        spec: What to render.
        subjects: The scenes.
        dead: Why, of scenes by index that end the process that renders them.

    Raises:
        OSError: If the disk does not take them; finished scenes are kept.
    """
    out = Rendered()
    for subject in subjects:
        if subject.index in dead:
            out.failures.append(_failure(subject, dead[subject.index]))
            continue
        kept = job.work / "clips" / f"{subject.scene_id}.parquet"
        records = _found(kept, job.out)
        if records is None:
            try:
                records = _rendered(subject, spec, job.out)
            except Exception as error:
                if isinstance(error, OSError) and unwritable(error):
                    raise
                out.failures.append(_failure(subject, _told(error)))
                if not isinstance(error, UserError):
                    out.crashes[subject.scene_id] = scrub_all(traceback.format_exc())
                continue
            write_part(to_table("clips", [r.row() for r in records]), kept)
        out.rows[subject.scene_id] = [r.row(job.out) for r in records]
        out.files += [job.out / f.path for r in records for f in r.files]
    return out


def _rendered(subject: Subject, spec: RenderSpec, out: Path) -> list[ClipRecord]:
    """One scene; errors that may pass are tried again."""
    seed = int(subject.common["seed"])
    emit(StageEvent(subject.scene_id, RENDER, "started", seed))
    start = time.perf_counter()
    records = retried(partial(render_scene, subject, spec, out), PAUSES_S)
    seconds = time.perf_counter() - start
    emit(StageEvent(subject.scene_id, RENDER, "finished", seed, seconds=seconds))
    return records


def _found(kept: Path, out: Path) -> list[ClipRecord] | None:
    """The clips of a scene that an earlier attempt has finished; None if there are none."""
    if not kept.is_file():
        return None
    try:
        records = [ClipRecord.of(row) for row in iter_rows([kept])]
        whole = all((out / f.path).stat().st_size == f.bytes for r in records for f in r.files)
    except (UserError, OSError):
        return None
    return records if whole else None


def _told(error: Exception) -> str:
    text = str(error) if isinstance(error, UserError) else f"{type(error).__name__}: {error}"
    return scrub_all(text)


def _failure(subject: Subject, reason: str) -> dict[str, Any]:
    return {
        "scene": subject.scene_id,
        "prompt": subject.common["prompt"],
        "seed": subject.common["seed"],
        "outcome": NOT_RENDERED,
        "reason": reason,
        "stage": RENDER,
        "index": subject.index,
    }
