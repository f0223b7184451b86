"""Parquet tables with fixed schemas: written as parts, assembled into split files.

Workers write parts (`<folder>/<table>/<name>.parquet`), each complete or absent. `assemble` merges
parts, in order of their keys, into `<table>/{split}-{i:05d}-of-{n:05d}.parquet` with a dataset
card and `meta/info.json`. The same records give the same bytes, whatever parts they came in.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from esg.outcomes import UserError
from esg.store.files import atomic_file, atomic_write

if TYPE_CHECKING:
    import pyarrow as pa

    from esg.store.records import SceneRecord

FORMAT_VERSION = "1.0.0"
ROW_GROUP_SCENES = 100
MAX_FILE_BYTES = 200 * 2**20
PART_PATTERN = "{split}-{index:05d}-of-{count:05d}.parquet"
SPLITS = ("train", "validation", "test")
COMPRESSION = "zstd"

KEYS: dict[str, tuple[str, ...]] = {
    "runs": ("run_id",),
    "scenes": ("scene_key",),
    "trajectories": ("scene_key", "engine"),
    "metrics": ("scene_key", "engine", "event_id"),
    "constraints": ("scene_key", "engine", "constraint_index"),
    "coverage": ("scene_key", "item_index"),
    "timings": ("scene_key", "stage"),
}
"""Primary key of every table; `scene_key` is run, suite, scene and seed (esg.store.records)."""

_RUN = {"run_id": "string"}
_SCENE = {**_RUN, "scene_key": "string", "suite": "string", "scene_id": "string", "seed": "int64"}

COLUMNS: dict[str, dict[str, str]] = {
    "runs": {
        "run_id": "string", "kind": "string", "suite": "string", "started_at": "timestamp",
        "strategy": "string", "engine": "string", "dt_s": "float64", "seeds": "int32",
        "version": "string", "code_version": "string", "machine": "string",
    },
    "scenes": {
        **_SCENE, "level": "string", "prompt": "string", "family": "string", "split": "string",
        "drafter": "string", "strategy": "string", "engine": "string", "device": "string",
        "dt_s": "float64", "proof": "string", "outcome": "string", "reason": "string",
        "verified": "bool", "slr": "bool", "max_penetration_m": "float64", "n_events": "int32",
        "n_completed": "int32", "ppa": "float64", "ppa_strict": "float64",
        "ppa_lenient": "float64", "seconds": "float64", "cached_stages": "int32",
        "esg_draft": "string", "esg_resolve": "string", "esg_layout": "string",
        "esg_optimize": "string", "esg_sha256": "string", "artifacts": "string",
    },
    "trajectories": {
        **_SCENE, "split": "string", "engine": "string", "dt_s": "float64", "fps": "float64",
        "n_frames": "int32", "bodies": "list<string>", "time_s": "list<float32>",
        "position_m": "list<float32>", "quaternion_xyzw": "list<float32>",
        "linear_velocity_mps": "list<float32>", "angular_velocity_radps": "list<float32>",
        "contact_time_s": "list<float32>", "contact_a": "list<int16>", "contact_b": "list<int16>",
        "contact_impulse_ns": "list<float32>", "contact_depth_m": "list<float32>",
    },
    "metrics": {
        **_SCENE, "strategy": "string", "engine": "string", "dt_s": "float64",
        "event_id": "string", "event_index": "int32", "event_type": "string",
        "completed": "bool", "time_s": "float64", "bodies": "list<string>", "reason": "string",
        "measured": "string",
    },
    "constraints": {
        **_SCENE, "strategy": "string", "engine": "string", "constraint_index": "int32",
        "constraint": "string", "kind": "string", "quantity": "string", "unit": "string",
        "target_low": "float64", "target_high": "float64", "measured": "float64",
        "error": "float64", "score": "float64", "score_strict": "float64",
        "score_lenient": "float64", "reason": "string",
    },
    "coverage": {
        **_SCENE, "item_index": "int32", "text": "string", "start": "int32", "stop": "int32",
        "kind": "string", "status": "string", "pointer": "string", "note": "string",
    },
    "timings": {
        **_SCENE, "stage": "string", "stage_index": "int32", "seconds": "float64",
        "cached": "bool", "outcome": "string",
    },
}  # fmt: skip
"""Column name to type of every table."""

TABLES = tuple(COLUMNS)


@cache
def arrow_schema(table: str) -> pa.Schema:
    """The explicit Arrow schema of a table; its metadata name the table and the format."""
    import pyarrow as pa

    types = {
        "string": pa.string(),
        "int16": pa.int16(),
        "int32": pa.int32(),
        "int64": pa.int64(),
        "float32": pa.float32(),
        "float64": pa.float64(),
        "bool": pa.bool_(),
        "timestamp": pa.timestamp("us", tz="UTC"),
    }

    def arrow(name: str) -> pa.DataType:
        if name.startswith("list<"):
            return pa.list_(types[name[5:-1]])
        return types[name]

    fields = [
        pa.field(name, arrow(kind), nullable=name not in KEYS[table])
        for name, kind in COLUMNS[table].items()
    ]
    metadata = {b"esg.table": table.encode(), b"esg.format": FORMAT_VERSION.encode()}
    return pa.schema(fields, metadata=metadata)


def to_table(table: str, rows: Sequence[Mapping[str, Any]]) -> pa.Table:
    """Rows as an Arrow table in the order of their key.

    Raises:
        ValueError: If a row has a column that the table lacks.
    """
    import pyarrow as pa

    known = set(COLUMNS[table])
    extra = sorted({name for row in rows for name in row} - known)
    if extra:
        raise ValueError(f"table {table!r} has no columns {extra}")
    ordered = sorted(rows, key=lambda r: tuple(r[k] for k in KEYS[table]))
    return pa.Table.from_pylist([dict(r) for r in ordered], schema=arrow_schema(table))


def write_part(data: pa.Table, path: Path, *, row_group: int = ROW_GROUP_SCENES) -> None:
    """Writes one Parquet file, whole or not at all.

    Raises:
        OSError: With the remedy in its text if the disk is full, read-only or forbidden.
    """
    import pyarrow.parquet as pq

    def write(temporary: Path) -> None:
        pq.write_table(
            data, temporary, compression=COMPRESSION, row_group_size=max(1, row_group),
            store_schema=True,
        )  # fmt: skip

    atomic_write(path, write)


def write_tables(folder: Path, records: Iterable[SceneRecord], *, name: str) -> dict[str, Path]:
    """Writes the parts of a batch of scenes: one file a table that has rows.

    Args:
        folder: Folder of the parts.
        records: The scenes.
        name: File name without suffix; the same name replaces the same part.

    Returns:
        Path by table.
    """
    rows: dict[str, list[Mapping[str, Any]]] = {table: [] for table in TABLES}
    for record in records:
        for table, found in record.rows.items():
            rows[table] += found
    rows["runs"] = list({r["run_id"]: r for r in rows["runs"]}.values())
    out: dict[str, Path] = {}
    for table, found in rows.items():
        if found:
            path = Path(folder) / table / f"{name}.parquet"
            write_part(to_table(table, found), path, row_group=_row_group(table))
            out[table] = path
    return out


def _row_group(table: str) -> int:
    return ROW_GROUP_SCENES if table in ("scenes", "trajectories") else 100 * ROW_GROUP_SCENES


def table_of(path: Path) -> str:
    """Which table a Parquet file holds, by its metadata.

    Raises:
        UserError: If the file is damaged, no Parquet file or not one of this project's.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        metadata = pq.read_schema(path).metadata or {}
    except FileNotFoundError:
        raise UserError(f"{path} does not exist; check the path") from None
    except (pa.ArrowInvalid, OSError) as error:
        raise UserError(
            f"{path} is damaged or no Parquet file ({str(error).splitlines()[0]}); delete it and "
            "run again to write it anew"
        ) from None
    table = metadata.get(b"esg.table", b"").decode()
    if table not in COLUMNS:
        raise UserError(f"{path} is not a table of this project (no esg.table metadata)")
    version = metadata.get(b"esg.format", b"").decode()
    if version.split(".")[0] != FORMAT_VERSION.split(".")[0]:
        raise UserError(f"{path} has format {version}; this software reads {FORMAT_VERSION}")
    return table


def read_table(path: Path) -> pa.Table:
    """Reads and checks one Parquet file of this project.

    Raises:
        UserError: If it is damaged, of another format or lacks columns.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    table = table_of(path)
    try:
        data = pq.read_table(path)
    except (pa.ArrowInvalid, OSError) as error:
        raise UserError(
            f"{path} is damaged ({str(error).splitlines()[0]}); delete it and run again"
        ) from None
    missing = [c for c in COLUMNS[table] if c not in data.column_names]
    if missing:
        raise UserError(f"{path} lacks the columns {', '.join(missing)} of table {table!r}")
    return data.select(list(COLUMNS[table])).cast(arrow_schema(table))


def part_files(folder: Path, table: str | None = None) -> list[Path]:
    """Finished Parquet files below a folder, in name order; temporary ones are not looked at."""
    pattern = f"{table}/*.parquet" if table else "*/*.parquet"
    return sorted(p for p in Path(folder).glob(pattern) if not p.name.startswith("."))


def assemble(
    parts: Path,
    out: Path,
    *,
    title: str = "dynamic scenes",
    tables: Sequence[str] = TABLES,
    max_bytes: int = MAX_FILE_BYTES,
    scenes_per_file: int | None = None,
) -> dict[str, int]:
    """Merges parts into the split files of a dataset, with card and `meta/info.json`.

    A scene's rows of all tables go to the split of its prompt family. The result depends on the
    records only, not on how they were dealt to parts.

    Args:
        parts: Folder that `write_tables` filled.
        out: Dataset folder.
        title: For the card.
        tables: Which tables to include.
        max_bytes: Size a file aims to stay under [bytes, uncompressed in memory].
        scenes_per_file: Fixed number of rows a file instead.

    Returns:
        Rows by table.

    Raises:
        UserError: If a part is damaged, with its path.
    """
    splits = _scene_splits(parts)
    counts: dict[str, int] = {}
    per_split: dict[str, int] = dict.fromkeys(SPLITS, 0)
    for table in tables:
        files = part_files(parts, table)
        if not files:
            continue
        if table == "runs":
            rows = {r["run_id"]: r for f in files for r in read_table(f).to_pylist()}
            data = to_table("runs", list(rows.values()))
            write_part(data, out / "runs" / "runs.parquet")
            counts["runs"] = data.num_rows
            continue
        counts[table] = 0
        for split in SPLITS:
            data = _merged(table, files, splits, split)
            counts[table] += data.num_rows
            if table == "scenes":
                per_split[split] = data.num_rows
            _write_split(data, table, split, out, max_bytes, scenes_per_file)
    _write_info(out, title, counts, per_split)
    return counts


def _scene_splits(parts: Path) -> dict[str, str]:
    out: dict[str, str] = {}
    for path in part_files(parts, "scenes"):
        data = read_table(path).select(["scene_key", "split"])
        pairs = zip(data["scene_key"].to_pylist(), data["split"].to_pylist(), strict=True)
        out.update(pairs)
    return out


def _merged(table: str, files: list[Path], splits: Mapping[str, str], split: str) -> pa.Table:
    """All rows of one split, sorted by key, the last part winning where a key repeats."""
    import pyarrow as pa

    wanted = {k for k, s in splits.items() if s == split}
    pieces = []
    for path in files:
        data = read_table(path)
        keep = [key in wanted for key in data["scene_key"].to_pylist()]
        pieces.append(data.filter(pa.array(keep, pa.bool_())))
    data = pa.concat_tables(pieces) if pieces else arrow_schema(table).empty_table()
    keys = [data[k].to_pylist() for k in KEYS[table]]
    last = {key: i for i, key in enumerate(zip(*keys, strict=True))}
    return data.take(pa.array([last[k] for k in sorted(last)], pa.int64())).combine_chunks()


def _write_split(
    data: pa.Table, table: str, split: str, out: Path, max_bytes: int, fixed: int | None
) -> None:
    folder = out / table
    for old in folder.glob(f"{split}-*-of-*.parquet"):
        old.unlink()
    if not data.num_rows:
        return
    if fixed is not None:
        count = -(-data.num_rows // max(1, fixed))
    else:
        count = max(1, -(-data.nbytes // max_bytes))
    bounds = [data.num_rows * i // count for i in range(count + 1)]
    for i in range(count):
        name = PART_PATTERN.format(split=split, index=i, count=count)
        piece = data.slice(bounds[i], bounds[i + 1] - bounds[i])
        write_part(piece, folder / name, row_group=_row_group(table))


def _write_info(out: Path, title: str, counts: dict[str, int], per_split: dict[str, int]) -> None:
    info = {
        "format": "esg-scenes",
        "format_version": FORMAT_VERSION,
        "title": title,
        "rows": counts,
        "scenes_per_split": per_split,
        "path_template": "{table}/" + PART_PATTERN,
        "compression": COMPRESSION,
        "row_group_scenes": ROW_GROUP_SCENES,
        "tables": COLUMNS,
        "keys": {t: list(k) for t, k in KEYS.items()},
        "units": "SI: m, kg, s, N s, rad; columns carry theirs in the name",
        "trajectory_layout": "flat arrays of shape [frame, body, component], C order; bodies in "
        "the order of `bodies`; contact bodies are indices into it, -1 is the ground",
    }
    with atomic_file(out / "meta" / "info.json") as file:
        file.write((json.dumps(info, indent=2, sort_keys=True) + "\n").encode())
    with atomic_file(out / "README.md") as file:
        file.write(dataset_card(title, counts, per_split).encode())


def dataset_card(title: str, counts: Mapping[str, int], per_split: Mapping[str, int]) -> str:
    """The dataset card: a header that `datasets.load_dataset` reads, then what is inside."""
    lines = ["---", f"pretty_name: {json.dumps(title)}", "license: apache-2.0", "configs:"]
    for table in (t for t in counts if t != "runs"):
        lines += [f"- config_name: {table}", "  data_files:"]
        for split in SPLITS:
            if per_split.get(split):
                lines += [f"  - split: {split}", f"    path: {table}/{split}-*.parquet"]
        if table == "scenes":
            lines.append("  default: true")
    lines += ["---", "", f"# {title}", ""]
    lines += ["| table | rows | one row is |", "| --- | ---: | --- |"]
    what = {
        "runs": "a run",
        "scenes": "a scene of a run",
        "trajectories": "a scene's replay in one engine",
        "metrics": "an event of a scene's replay",
        "constraints": "a prompt-specified parameter of a scene's replay",
        "coverage": "a noun, event or quantity of a prompt",
        "timings": "a pipeline stage of a scene",
    }
    lines += [f"| {t} | {n} | {what[t]} |" for t, n in counts.items()]
    lines += ["", "| split | scenes |", "| --- | ---: |"]
    lines += [f"| {s} | {n} |" for s, n in per_split.items()]
    lines += [
        "",
        "Splits are by prompt family (the prompt without its numbers), so that no family is in "
        "two splits. Columns, keys and array layouts: `meta/info.json`.",
        "",
    ]
    return "\n".join(lines)


def iter_rows(paths: Iterable[Path]) -> Iterator[dict[str, Any]]:
    """Rows of several files, one row group in memory at a time."""
    import pyarrow.parquet as pq

    for path in paths:
        table_of(path)
        with pq.ParquetFile(path) as file:
            for batch in file.iter_batches(batch_size=ROW_GROUP_SCENES):
                yield from batch.to_pylist()
