"""Putting a dataset together once all its batches are done."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
import json
from pathlib import Path
import shutil
from typing import TYPE_CHECKING, Any

from esg.costs.spent import Spent
from esg.dataset.folder import INFO, DatasetFolder
from esg.dataset.job import BatchResult
from esg.dataset.plan import DatasetSpec
from esg.files import atomic_file, sync_folder

if TYPE_CHECKING:
    from esg.store.assembling import Counts

SCAFFOLD = ("parts", "marks", "locks", "work")
"""Folders that only an unfinished dataset has."""


def finish(folder: DatasetFolder, spec: DatasetSpec, results: Mapping[int, BatchResult]) -> None:
    """Writes the split files, `failures.jsonl`, the card and `meta/`; then removes the scaffold.

    `meta/info.json` comes last: a dataset that has it is complete. A process killed before that
    begins again from the parts, one killed after it has only the scaffold left to remove.

    Args:
        folder: With all batches done.
        spec: Of the dataset.
        results: Of all batches.

    Raises:
        UserError: If a part is damaged, with its path.
        OSError: If the dataset cannot be written.
    """
    from esg.dataset.clips.writing import sweep_clips
    from esg.dataset.duplicates import duplicates_in, marking
    from esg.store.assembling import assemble_tables, sweep_temporary
    from esg.store.tables import to_table, write_part

    out = folder.path
    write_part(to_table("runs", [folder.run().row()]), out / "parts" / "runs" / "run.parquet")
    repeated = duplicates_in(out / "parts")
    write_lines(out / "meta" / "duplicates.jsonl", [vars(row) for row in repeated])
    counts = assemble_tables(
        out / "parts",
        out,
        left_out={row.scene_key for row in repeated} if spec.thin else (),
        changed=marking(repeated),
    )
    failed = [dict(row) for n in sorted(results) for row in results[n].failures]
    write_lines(
        out / "meta" / "crashes.jsonl",
        [
            {"scene": scene, "traceback": text}
            for n in sorted(results)
            for scene, text in results[n].crashes.items()
        ],
    )
    write_json(out / "meta" / "timings.json", timings(results))
    for name in ("mcap", "previews", "meshes"):
        sweep_temporary(out / name)
    sweep_clips(out / "clips")
    describe(out, spec, spec.name(), counts, failed)
    clean(out)


def describe(
    out: Path, spec: DatasetSpec, title: str, counts: Counts, failed: Sequence[Mapping[str, Any]]
) -> None:
    """Writes `failures.jsonl`, the card and, last, `meta/info.json` of a dataset's tables.

    Args:
        out: Folder of the dataset.
        spec: Its specification.
        title: What `meta/info.json` calls it.
        counts: Rows by table and split.
        failed: Rows of `failures.jsonl`.
    """
    from esg.dataset.card import write_card
    from esg.store.assembling import write_info

    write_lines(out / "failures.jsonl", failed)
    facts = write_card(out, spec, counts, failed)
    write_info(out, title, counts, {"statistics": facts})


def describe_again(
    out: Path, spec: DatasetSpec, failed: Sequence[Mapping[str, Any]] | None = None
) -> None:
    """The same of a finished dataset that something was added to.

    Args:
        out: Folder of the dataset.
        spec: Its specification.
        failed: Rows of `failures.jsonl`; default as they are.
    """
    title = json.loads((out / INFO).read_bytes())["title"]
    rows = failures_of(out) if failed is None else failed
    describe(out, spec, title, counts_of(out), rows)


def failures_of(out: Path) -> list[dict[str, Any]]:
    """Rows of a dataset's `failures.jsonl`."""
    path = out / "failures.jsonl"
    return [json.loads(t) for t in path.read_text("utf-8").splitlines()] if path.is_file() else []


def counts_of(out: Path) -> Counts:
    """Rows by table and split of a finished dataset."""
    import pyarrow.parquet as pq

    from esg.store.tables import part_files

    counts: Counts = {}
    for path in part_files(out):
        table, split = path.parent.name, path.name.partition("-")[0]
        rows = counts.setdefault(table, {})
        split = "" if table == "runs" else split
        rows[split] = rows.get(split, 0) + pq.read_metadata(path.absolute()).num_rows
    return counts


def clean(out: Path) -> None:
    """Removes the scaffold of a finished dataset; does nothing to an unfinished one."""
    if (out / INFO).is_file():
        for name in SCAFFOLD:
            shutil.rmtree(out / name, ignore_errors=True)
        sync_folder(out)  # or it is back after a power loss


def timings(results: Mapping[int, BatchResult]) -> dict[str, Any]:
    """Seconds of work by stage, in all and a scene.

    What is asked for beside the stages (annotations, meshes, recordings, clips) has its own names;
    `overhead` is the rest.

    Processor time likewise, with `cost`, what `esg dataset` ends with.
    """
    scenes = sum(r.scenes for r in results.values())
    total, whole = _added(r.seconds for r in results.values())
    cores, _ = _added(r.core_seconds for r in results.values())
    return {
        "cost": Spent(scenes, total, cores).to_json(),
        "scenes": scenes,
        "seconds": {k: round(v, 2) for k, v in total.items()},
        "seconds_per_scene": {k: round(v / max(1, scenes), 4) for k, v in total.items()},
        "share": {k: round(v / whole, 4) if whole else 0.0 for k, v in total.items()},
    }


def _added(parts: Iterable[Mapping[str, float]]) -> tuple[dict[str, float], float]:
    """Seconds by stage, what is none of them as `overhead`, and seconds in all."""
    total: dict[str, float] = {}
    for part in parts:
        for name, seconds in part.items():
            total[name] = total.get(name, 0.0) + seconds
    whole = total.pop("batch", 0.0)
    total["overhead"] = whole - sum(total.values())
    return total, whole


def write_lines(path: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    """Writes JSON Lines; without rows there is no file."""
    if not rows:
        path.unlink(missing_ok=True)
        return
    with atomic_file(path) as file:
        for row in rows:
            file.write((json.dumps(dict(row), sort_keys=True, ensure_ascii=False) + "\n").encode())


def write_json(path: Path, value: Any) -> None:
    """Writes a JSON document."""
    with atomic_file(path) as file:
        file.write((json.dumps(value, indent=2, sort_keys=True) + "\n").encode())
