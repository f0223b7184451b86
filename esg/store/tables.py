"""Parquet tables with fixed schemas: written as parts, assembled into split files.

Workers write parts (`<folder>/<table>/<name>.parquet`), each complete or absent;
`esg.store.assembling` merges them into the files of a dataset.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from esg.files import atomic_write
from esg.outcomes import UserError
from esg.store.checking import DIGEST_KEY, check_footer, content_digest, seal_footer
from esg.store.columns import arrow_type, features_metadata
from esg.store.shapes import EXPECTATION, MEASURED, PARAMETERS, upgraded

if TYPE_CHECKING:
    import pyarrow as pa
    import pyarrow.parquet as pq

    from esg.store.records import SceneRecord

FORMAT_VERSION = "2.0.0"
READABLE = ("1", "2")
"""Major versions of files that are read; those of 1 have JSON texts where 2 has types."""
ROW_GROUP_SCENES = 100
MOST_VALUES = 1_000_000_000
"""Of one file that is read: 8 GB of numbers. Our own have a tenth of it."""
COMPRESSION = "zstd"

KEYS: dict[str, tuple[str, ...]] = {
    "runs": ("run_id",),
    "scenes": ("scene_key",),
    "trajectories": ("scene_key", "engine"),
    "metrics": ("scene_key", "engine", "event_id"),
    "constraints": ("scene_key", "engine", "constraint_index"),
    "coverage": ("scene_key", "item_index"),
    "statements": ("scene_key", "engine", "source", "statement_id"),
    "plausibility_checks": ("scene_key", "engine", "check_name"),
    "timings": ("scene_key", "stage"),
    "captions": ("scene_key",),
    "questions": ("scene_key", "question_index"),
    "engine_events": ("scene_key", "engine", "dt_s", "event_id"),
    "what_ifs": ("scene_key", "variable", "engine"),
    "meshes": ("scene_key", "mesh"),
    "clips": ("scene_key", "camera"),
    "truth_checks": ("scene_key", "camera", "check_name"),
}
"""Primary key of every table; `scene_key` is run, suite, scene and seed (esg.store.records)."""

_RUN = {"run_id": "string"}
_SCENE = {
    **_RUN, "scene_key": "string", "suite": "string", "scene_id": "string", "seed": "int64",
    "prompt": "string",
}  # fmt: skip

COLUMNS: dict[str, dict[str, str]] = {
    "runs": {
        "run_id": "string", "kind": "string", "suite": "string", "started_at": "timestamp",
        "strategy": "string", "engine": "string", "dt_s": "float64", "seeds": "int32",
        "version": "string", "code_version": "string", "machine": "string",
    },
    "scenes": {
        **_SCENE, "level": "string", "family": "string", "split": "string",
        "drafter": "string", "strategy": "string", "engine": "string", "device": "string",
        "dt_s": "float64", "proof": "string", "outcome": "string", "reason": "string",
        "verified": "bool", "slr": "bool", "max_penetration_m": "float64", "n_events": "int32",
        "n_completed": "int32", "ppa": "float64", "ppa_strict": "float64",
        "ppa_lenient": "float64", "seconds": "float64", "cached_stages": "int32",
        "esg_draft": "string", "esg_resolve": "string", "esg_cast": "string",
        "esg_layout": "string", "esg_optimize": "string", "esg_sha256": "string",
        "artifacts": "string",
        "rule": "string", "pair": "string", "changed": "string", "parameters": PARAMETERS,
        "expectation": EXPECTATION, "manifest": "string",
        "fully_understood": "bool", "statements_kept": "float64", "plausible": "bool",
        "engines_agree": "bool",
        "preview": "image", "duplicate_of": "string",
    },
    "trajectories": {
        **_SCENE, "split": "string", "engine": "string", "dt_s": "float64", "fps": "float64",
        "n_frames": "int32", "bodies": "list<string>", "time_s": "list<float32>",
        "position_m": "list<float32>", "quaternion_xyzw": "list<float32>",
        "linear_velocity_mps": "list<float32>", "angular_velocity_radps": "list<float32>",
        "contact_time_s": "list<float32>", "contact_a": "list<int16>", "contact_b": "list<int16>",
        "contact_impulse_ns": "list<float32>", "contact_depth_m": "list<float32>",
        "contact_point_m": "list<float32>", "contact_normal": "list<float32>",
    },
    "metrics": {
        **_SCENE, "strategy": "string", "engine": "string", "dt_s": "float64",
        "event_id": "string", "event_index": "int32", "event_type": "string",
        "completed": "bool", "time_s": "float64", "bodies": "list<string>", "reason": "string",
        "measured": MEASURED,
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
    "statements": {
        **_SCENE, "strategy": "string", "engine": "string", "source": "string",
        "statement_id": "string", "statement_index": "int32", "says": "string",
        "words": "string", "start": "int32", "stop": "int32", "status": "string",
        "kept": "bool", "measured": MEASURED, "reason": "string",
    },
    "plausibility_checks": {
        **_SCENE, "strategy": "string", "engine": "string", "check_name": "string",
        "check_index": "int32", "unit": "string", "ok": "bool", "measured": "float64",
        "limit_value": "float64", "body": "string", "time_s": "float64", "note": "string",
    },
    "timings": {
        **_SCENE, "stage": "string", "stage_index": "int32", "seconds": "float64",
        "cached": "bool", "outcome": "string",
    },
    "captions": {
        **_SCENE, "short": "string", "medium": "string", "long": "string",
        "event_ids": "list<string>", "event_texts": "list<string>",
        "event_times_s": "list<float64>", "hit_a": "list<string>", "hit_b": "list<string>",
        "hit_times_s": "list<float64>", "hit_impulses_ns": "list<float64>",
        "statements": "list<string>",
    },
    "questions": {
        **_SCENE, "question_index": "int32", "kind": "string", "question": "string",
        "answer": "string", "choices": "list<string>", "value": "float64", "unit": "string",
        "measure": "string", "arguments": "list<string>", "measured_by": "string",
    },
    "engine_events": {
        **_SCENE, "engine": "string", "dt_s": "float64", "event_id": "string",
        "event_index": "int32", "event_type": "string", "completed": "bool", "time_s": "float64",
        "agrees": "bool", "reason": "string",
    },
    "what_ifs": {
        **_SCENE, "variable": "string", "engine": "string", "pair": "string", "amount": "string",
        "body": "string", "value_before": "float64", "value": "float64", "unit": "string",
        "dt_s": "float64", "duration_s": "float64", "outcome": "string", "reason": "string",
        "event_ids": "list<string>", "completed": "list<bool>", "event_times_s": "list<float64>",
        "bodies": "list<string>", "final_position_m": "list<float32>", "apart_m": "float64",
        "engines_apart_m": "float64", "agrees": "bool",
    },
    "meshes": {
        **_SCENE, "mesh": "string", "asset": "string", "gltf": "string", "buffer": "string",
        "bytes": "int64", "license": "string", "attribution": "string",
    },
    "clips": {
        **_SCENE, "split": "string", "camera": "int32", "camera_kind": "string",
        "width": "int32", "height": "int32", "fps": "float64",
        "n_frames": "int32", "time_s": "list<float32>", "renderer": "string", "samples": "int32",
        "intrinsics": "struct<fx:float64,fy:float64,cx:float64,cy:float64>",
        "camera_position_m": "list<float32>", "camera_quaternion_xyzw": "list<float32>",
        "channels": "list<string>",
        "files": "list<struct<channel:string,path:string,bytes:int64>>",
        "objects": "list<struct<id:int32,name:string,label:string,category:string,static:bool>>",
        "object_bounds_m": "list<float32>", "object_position_m": "list<float32>",
        "object_quaternion_xyzw": "list<float32>",
        "depth_offset": "list<float32>", "depth_scale": "list<float32>",
        "flow_scale": "list<float32>", "backward_flow_scale": "list<float32>",
        "boxes2d": "list<struct<frame:int32,id:int32,x0:int32,y0:int32,x1:int32,y1:int32,"
        "visible_px:int32>>",
        "boxes3d": "list<struct<frame:int32,id:int32,x_m:float32,y_m:float32,z_m:float32,"
        "half_x_m:float32,half_y_m:float32,half_z_m:float32,qx:float32,qy:float32,qz:float32,"
        "qw:float32>>",
        "track_ids": "list<int32>", "track_point_m": "list<float32>",
        "track_xy_px": "list<float32>", "track_visible": "list<bool>",
        "place": "string", "sky": "string", "video": "video",
    },
    "truth_checks": {
        **_SCENE, "camera": "int32", "check_name": "string", "unit": "string",
        "samples": "int64", "p50": "float64", "p90": "float64", "p99": "float64",
        "worst": "float64", "limit_value": "float64", "ok": "bool", "note": "string",
    },
}  # fmt: skip
"""Column name to type of every table (esg.store.columns)."""

ADDED_COLUMNS: dict[str, tuple[str, ...]] = {
    "scenes": (
        "rule", "pair", "changed", "parameters", "expectation", "manifest", "esg_cast",
        "fully_understood", "statements_kept", "plausible", "preview", "duplicate_of",
        "engines_agree",
    ),
    "trajectories": ("prompt", "contact_point_m", "contact_normal"),
    **dict.fromkeys(
        (
            "metrics", "constraints", "coverage", "statements",
            "plausibility_checks", "timings",
        ),
        ("prompt",),
    ),
}  # fmt: skip
"""Columns that files of an older format lack (`esg_cast` is of 1.2, what became of statements of
1.3, `plausible` of 1.4, `preview`, `engines_agree`, where contacts are and the prompt on every
row of 2.0): they read as null."""

TABLES = tuple(COLUMNS)


@cache
def arrow_schema(table: str) -> pa.Schema:
    """The explicit Arrow schema of a table; its metadata name the table and the format."""
    import pyarrow as pa

    fields = [
        pa.field(name, arrow_type(kind), nullable=name not in KEYS[table])
        for name, kind in COLUMNS[table].items()
    ]
    metadata = {b"esg.table": table.encode(), b"esg.format": FORMAT_VERSION.encode()}
    metadata |= features_metadata(COLUMNS[table])
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


def _local(path: Path) -> str:
    """A path that Arrow takes for no URL, as it does with `run:1/scenes.parquet`."""
    return str(Path(path).absolute())


def write_part(data: pa.Table, path: Path) -> None:
    """Writes one Parquet file, whole or not at all, in row groups that fit its table.

    Raises:
        OSError: With the remedy in its text if the disk is full, read-only or forbidden.
    """
    import pyarrow.parquet as pq

    facts = {**(data.schema.metadata or {}), DIGEST_KEY: content_digest(data)}
    rows = _row_group_rows(facts.get(b"esg.table", b"").decode())
    data = data.replace_schema_metadata(facts)

    def write(temporary: Path) -> None:
        pq.write_table(
            data, _local(temporary), compression=COMPRESSION, row_group_size=rows,
            store_schema=True, write_page_checksum=True,
        )  # fmt: skip
        seal_footer(temporary)

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
            write_part(to_table(table, found), path)
            out[table] = path
    return out


def _row_group_rows(table: str) -> int:
    """Rows a row group of a table."""
    heavy = ("scenes", "trajectories", "clips")
    return ROW_GROUP_SCENES if table in heavy else 100 * ROW_GROUP_SCENES


def table_of(path: Path) -> str:
    """Which table a Parquet file holds, by its metadata.

    Raises:
        UserError: If the file is damaged, no Parquet file or not one of this project's.
    """
    import pyarrow.parquet as pq

    try:
        check_footer(Path(path))
        facts = pq.read_metadata(_local(path))
        metadata = facts.schema.to_arrow_schema().metadata or {}
        values = _values(facts)
    except FileNotFoundError:
        raise UserError(f"{path} does not exist; check the path") from None
    except Exception as error:  # whatever the reader meets in a damaged footer
        why = (str(error).splitlines() or [type(error).__name__])[0]
        raise UserError(
            f"{path} is damaged or no Parquet file ({why}); delete it and run again to write it "
            "anew"
        ) from None
    table = metadata.get(b"esg.table", b"").decode("utf-8", "replace")
    if table not in COLUMNS:
        raise UserError(f"{path} is not a table of this project (no esg.table metadata)")
    version = metadata.get(b"esg.format", b"").decode("utf-8", "replace")
    if version.split(".")[0] not in READABLE:
        raise UserError(f"{path} has format {version}; this software reads {FORMAT_VERSION}")
    if values > MOST_VALUES:
        raise UserError(f"{path} says it holds {values} values, at most {MOST_VALUES} are read")
    return table


def _values(facts: pq.FileMetaData) -> int:
    """Values of all columns together, elements of lists counted."""
    return sum(
        facts.row_group(group).column(column).num_values
        for group in range(facts.num_row_groups)
        for column in range(facts.num_columns)
    )


def sound_table(
    path: Path,
    table: str,
    columns: Sequence[str] | None = None,
    *,
    known: bool = False,
    threads: bool = False,
) -> pa.Table:
    """Rows of one Parquet file as they lie, once its checksums fit.

    Args:
        path: The file.
        table: That it holds, by `table_of`.
        columns: Only these, which every version of the table has; default all.
        known: Whether this command has read all of it before: its digest is not computed again.
        threads: Whether several read it; of a part they would be in each other's way.

    Raises:
        UserError: If it is damaged, of another format or lacks columns.
    """
    import pyarrow.parquet as pq

    wanted = None if columns is None else list(columns)
    try:
        with pq.ParquetFile(_local(path), page_checksum_verification=True) as file:
            data = file.read(columns=wanted, use_threads=threads)
        digest = (data.schema.metadata or {}).get(DIGEST_KEY)
        whole = columns is None and not known
        if whole and digest not in (None, content_digest(data)):
            raise ValueError("its digest does not fit")
    except Exception as error:  # whatever the reader meets in a damaged file
        raise _damaged(path, error) from None
    if columns is None and missing_columns(table, data.column_names):
        missing = [c for c in COLUMNS[table] if c not in data.column_names]
        raise UserError(f"{path} lacks the columns {', '.join(missing)} of table {table!r}")
    return data


def _damaged(path: Path, error: Exception) -> UserError:
    why = (str(error).splitlines() or [type(error).__name__])[0]
    return UserError(f"{path} is damaged ({why}); delete it and run again")


def format_of(data: pa.Table) -> int:
    """Major version of the format of rows as they lie in a file."""
    return int((data.schema.metadata or {})[b"esg.format"].split(b".")[0])


def read_table(
    path: Path, columns: Sequence[str] | None = None, *, known: bool = False
) -> pa.Table:
    """Reads and checks one Parquet file of this project, and gives its rows the types of today.

    Args:
        path: The file.
        columns: Only these, which every version of the table has; default all.
        known: Whether this command has read all of it before: its digest is not computed again.

    Raises:
        UserError: If it is damaged, of another format or lacks columns.
    """
    import pyarrow as pa

    table = table_of(path)
    data = sound_table(path, table, columns, known=known, threads=True)
    try:
        data = upgraded(table, data, COLUMNS[table])
    except Exception as error:  # texts that are no JSON
        raise _damaged(path, error) from None
    if columns is not None:
        return data
    for column in (c for c in COLUMNS[table] if c not in data.column_names):
        kind = arrow_schema(table).field(column).type
        data = data.append_column(column, pa.nulls(data.num_rows, kind))
    return data.select(list(COLUMNS[table])).cast(arrow_schema(table))


def missing_columns(table: str, found: Sequence[str]) -> list[str]:
    """Columns of a table that a file must have and lacks; later additions may be absent."""
    added = ADDED_COLUMNS.get(table, ())
    return [c for c in COLUMNS[table] if c not in found and c not in added]


def part_files(folder: Path, table: str | None = None) -> list[Path]:
    """Finished Parquet files below a folder, in name order; temporary ones are not looked at."""
    pattern = f"{table}/*.parquet" if table else "*/*.parquet"
    return sorted(p for p in Path(folder).glob(pattern) if not p.name.startswith("."))


def iter_batches(
    paths: Iterable[Path], columns: Sequence[str] | None = None, *, rows: int = ROW_GROUP_SCENES
) -> Iterator[pa.RecordBatch]:
    """Rows of several files, few in memory at a time.

    Args:
        paths: The files.
        columns: Only these, which every version of their table has; default all.
        rows: At a time.

    Raises:
        UserError: If a file is damaged, with its path.
    """
    import pyarrow.parquet as pq

    wanted = None if columns is None else list(columns)
    for path in paths:
        table_of(path)
        try:
            with pq.ParquetFile(_local(path), page_checksum_verification=True) as file:
                yield from file.iter_batches(batch_size=rows, columns=wanted)
        except Exception as error:  # whatever the reader meets in a damaged file
            raise _damaged(path, error) from None


def iter_rows(
    paths: Iterable[Path], columns: Sequence[str] | None = None, *, rows: int = ROW_GROUP_SCENES
) -> Iterator[dict[str, Any]]:
    """The same as dictionaries."""
    for batch in iter_batches(paths, columns, rows=rows):
        yield from batch.to_pylist()
