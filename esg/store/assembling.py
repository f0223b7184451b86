"""Parts into a dataset: split files in order of their keys, a card and `meta/info.json`.

Files are `<table>/{split}-{i:05d}-of-{n:05d}.parquet`. The same records give the same bytes,
whatever parts they came in. A few output files (`AT_ONCE`) are in memory at a time, beside a part
each.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
import contextlib
from dataclasses import dataclass
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.files import atomic_file
from esg.store.columns import value_bytes
from esg.store.tables import (
    COLUMNS,
    COMPRESSION,
    FORMAT_VERSION,
    KEYS,
    ROW_GROUP_SCENES,
    TABLES,
    arrow_schema,
    part_files,
    read_table,
    to_table,
    write_part,
)
from esg.workers import usable_cores

if TYPE_CHECKING:
    import pyarrow as pa

MAX_FILE_BYTES = 200 * 2**20
AT_ONCE = 4
"""Output files that are put together at a time: disks gain little from more, memory does not."""
PART_PATTERN = "{split}-{index:05d}-of-{count:05d}.parquet"
SPLITS = ("train", "validation", "test")

Counts = dict[str, dict[str, int]]
"""Rows by table and split."""


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

    A scene's rows of all tables go to the split of its prompt family.

    Args:
        parts: Folder that `write_tables` filled.
        out: Dataset folder.
        title: For the card.
        tables: Which tables to include.
        max_bytes: Size a file aims to stay under [bytes, uncompressed values].
        scenes_per_file: Fixed number of rows a file instead.

    Returns:
        Rows by table.

    Raises:
        UserError: If a part is damaged, with its path.
    """
    counts = assemble_tables(
        parts, out, tables=tables, max_bytes=max_bytes, scenes_per_file=scenes_per_file
    )
    with atomic_file(out / "README.md") as file:
        file.write(dataset_card(title, counts).encode())
    write_info(out, title, counts)
    return totals(counts)


def assemble_tables(
    parts: Path,
    out: Path,
    *,
    tables: Sequence[str] = TABLES,
    max_bytes: int = MAX_FILE_BYTES,
    scenes_per_file: int | None = None,
    scenes: Path | None = None,
    left_out: Collection[str] = (),
    changed: Callable[[str, pa.Table], pa.Table] | None = None,
) -> Counts:
    """The split files alone (`assemble`); returns rows by table and split.

    Args:
        parts, out, tables, max_bytes, scenes_per_file: As of `assemble`.
        scenes: Where table `scenes` is that says the splits; default among the parts.
        left_out: Keys of scenes that go to no split.
        changed: Given a table's name and its rows, what is written of them: as many, with the same
            keys. Default: the rows.

    Raises:
        UserError: If a part is damaged, with its path.
    """
    known = _scene_splits(scenes or parts)
    splits = {key: split for key, split in known.items() if key not in left_out}
    counts: Counts = {}
    for table in tables:
        files = part_files(parts, table)
        if not files:
            continue
        if table == "runs":
            rows = {r["run_id"]: r for f in files for r in read_table(f).to_pylist()}
            data = to_table("runs", list(rows.values()))
            write_part(data, out / "runs" / "runs.parquet")
            counts["runs"] = {"": data.num_rows}
            continue
        ordered = _in_order(table, files, splits)
        counts[table] = {split: len(places) for split, places in ordered.items()}
        outputs = [
            (table, *output)
            for split, places in ordered.items()
            for output in _outputs(out / table, split, places, max_bytes, scenes_per_file)
        ]
        with ThreadPoolExecutor(min(AT_ONCE, usable_cores())) as threads:
            written = [threads.submit(_write, *output, files, changed) for output in outputs]
        for one in written:
            one.result()
    return counts


def totals(counts: Counts) -> dict[str, int]:
    """Rows by table."""
    return {table: sum(by_split.values()) for table, by_split in counts.items()}


@dataclass(frozen=True)
class _Places:
    """Where rows are, in their order.

    Args:
        file: Which part, shape [n].
        row: Which row of it, shape [n].
        size: How large they are [bytes], shape [n].
    """

    file: NDArray[np.int64]
    row: NDArray[np.int64]
    size: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.file)

    def some(self, chosen: NDArray[Any] | slice) -> _Places:
        """Those that are chosen, by a mask, by their places or as a slice."""
        return _Places(self.file[chosen], self.row[chosen], self.size[chosen])


def _scene_splits(parts: Path) -> dict[str, str]:
    out: dict[str, str] = {}
    for path in part_files(parts, "scenes"):
        data = read_table(path, ["scene_key", "split"])
        pairs = zip(data["scene_key"].to_pylist(), data["split"].to_pylist(), strict=True)
        out.update(pairs)
    return out


def _in_order(table: str, files: Sequence[Path], splits: Mapping[str, str]) -> dict[str, _Places]:
    """Places of all rows by split, sorted by key, the last part winning where a key repeats.

    Arrow sorts texts as Python does; as tuples of Python, eight million keys took five gigabytes.
    """
    import pyarrow as pa
    import pyarrow.compute

    pc: Any = pyarrow.compute  # its functions are made at run time
    names = tuple(dict.fromkeys((*KEYS[table], "scene_key")))
    parts: list[pa.Table] = []
    sizes: list[NDArray[np.int64]] = []
    for path in files:
        data = read_table(path)
        sizes.append(_row_sizes(data))
        parts.append(pa.table({n: _wide(data[n]) for n in names}))
    counts = [len(s) for s in sizes]
    places = _Places(
        np.repeat(np.arange(len(files)), counts),
        np.concatenate([np.arange(n) for n in counts]),
        np.concatenate(sizes),
    )
    keys = pa.concat_tables(parts)
    known = pa.array(list(splits), pa.large_string())
    found = pc.index_in(keys["scene_key"], value_set=known).to_numpy(zero_copy_only=False)
    codes = np.array([SPLITS.index(s) for s in splits.values()] + [-1])
    split = codes[np.nan_to_num(found, nan=-1).astype(np.int64)]
    # Rows come in the order of their places, which the sort leaves among equal keys.
    order = pc.sort_indices(keys, sort_keys=[(k, "ascending") for k in KEYS[table]]).to_numpy()
    order = order[_last(keys.select(KEYS[table]), order)]
    return {s: places.some(order[split[order] == k]) for k, s in enumerate(SPLITS)}


def _wide(column: pa.ChunkedArray) -> pa.ChunkedArray:
    """A column whose texts may take more than two gigabytes together."""
    import pyarrow as pa

    return column.cast(pa.large_string()) if pa.types.is_string(column.type) else column


def _last(keys: pa.Table, order: NDArray[Any]) -> NDArray[np.bool_]:
    """Which rows of a sorted table no other follows that has the same key, shape [n]."""
    import pyarrow.compute

    pc: Any = pyarrow.compute  # its functions are made at run time
    same = np.ones(max(0, len(order) - 1), bool)
    for column in keys.columns:
        values = column.take(order)
        equal = pc.equal(values.slice(0, len(same)), values.slice(1))
        same &= pc.fill_null(equal, False).to_numpy()
    return ~np.append(same, np.zeros(min(1, len(order)), bool))


def _row_sizes(data: pa.Table) -> NDArray[np.int64]:
    """Size of every row's values [bytes]: how rows are dealt to parts makes no difference."""
    import pyarrow as pa
    import pyarrow.compute

    pc: Any = pyarrow.compute  # its functions are made at run time
    total = pa.array([0] * data.num_rows, pa.int64())
    for column in data.columns:
        kind = column.type
        if pa.types.is_struct(kind) and kind.get_field_index("bytes") >= 0:
            column = pc.struct_field(column, "bytes")  # of a file, whose size is that of the row
            kind = column.type
        if pa.types.is_string(kind) or pa.types.is_binary(kind):
            size = pc.cast(pc.binary_length(column), pa.int64())
        elif pa.types.is_list(kind):
            lengths = pc.cast(pc.list_value_length(column), pa.int64())
            size = pc.multiply(lengths, value_bytes(kind.value_type))
        else:
            continue
        total = pc.add(total, pc.fill_null(size, 0))
    fixed = 8 * sum(not (pa.types.is_string(t) or pa.types.is_list(t)) for t in data.schema.types)
    return pc.cast(total, pa.int64()).to_numpy() + fixed


def _outputs(
    folder: Path, split: str, places: _Places, max_bytes: int, fixed: int | None
) -> list[tuple[Path, _Places]]:
    """The files of a split, with the rows of each; those of an earlier attempt are removed."""
    for old in folder.glob(f"{split}-*-of-*.parquet"):
        old.unlink()
    if not len(places):
        return []
    if fixed is not None:
        count = -(-len(places) // max(1, fixed))
    else:
        count = max(1, -(-int(places.size.sum()) // max_bytes))
    bounds = [len(places) * i // count for i in range(count + 1)]
    return [
        (
            folder / PART_PATTERN.format(split=split, index=i, count=count),
            places.some(slice(*bounds[i : i + 2])),
        )
        for i in range(count)
    ]


def _write(
    table: str,
    file: Path,
    places: _Places,
    files: Sequence[Path],
    changed: Callable[[str, pa.Table], pa.Table] | None,
) -> None:
    data = _gather(table, files, places)
    write_part(data if changed is None else changed(table, data), file)


def _gather(table: str, files: Sequence[Path], places: _Places) -> pa.Table:
    """The rows at some places, in their order."""
    import pyarrow as pa

    pieces = [arrow_schema(table).empty_table()]
    by_file = np.argsort(places.file, kind="stable")
    for number in np.unique(places.file):
        part = read_table(files[number], known=True)
        pieces.append(part.take(places.row[places.file == number]))
    data = pa.concat_tables(pieces)
    if (by_file[1:] < by_file[:-1]).any():
        data = data.take(np.argsort(by_file))
    return data.combine_chunks()


def write_info(
    out: Path, title: str, counts: Counts, more: Mapping[str, Any] | None = None
) -> None:
    """Writes `meta/info.json`: format, rows, schemas, how to read the arrays."""
    scenes = counts.get("scenes", {})
    info = {
        "format": "esg-scenes",
        "format_version": FORMAT_VERSION,
        "title": title,
        "rows": totals(counts),
        "scenes_per_split": {s: scenes.get(s, 0) for s in SPLITS},
        "path_template": "{table}/" + PART_PATTERN,
        "compression": COMPRESSION,
        "row_group_scenes": ROW_GROUP_SCENES,
        "tables": COLUMNS,
        "keys": {t: list(k) for t, k in KEYS.items()},
        "units": "SI: m, kg, s, N s, rad; columns carry theirs in the name",
        "trajectory_layout": "flat arrays of shape [frame, body, component], C order; bodies in "
        "the order of `bodies`; contact bodies are indices into it, -1 is the ground",
        **(more or {}),
    }
    with atomic_file(out / "meta" / "info.json") as file:
        file.write((json.dumps(info, indent=2, sort_keys=True) + "\n").encode())


_ONE_ROW = {
    "runs": "a run",
    "scenes": "a scene of a run",
    "trajectories": "a scene's replay in one engine",
    "metrics": "an event of a scene's replay",
    "constraints": "a prompt-specified parameter of a scene's replay",
    "coverage": "a noun, event or quantity of a prompt",
    "statements": "a statement of a prompt or a suite and whether a scene's replay keeps it",
    "plausibility_checks": "a check of a scene's replay: measured value and limit",
    "timings": "a pipeline stage of a scene",
    "captions": "a scene's captions at three lengths, with the events and hits that they tell",
    "questions": "a question about a scene, with its measured answer",
    "engine_events": "an event of a scene in one engine at one step",
    "what_ifs": "a scene with one variable changed, replayed in one engine",
    "meshes": "a mesh that a scene's manifest names: glTF, its buffer in `meshes/buffers`",
    "clips": "what one camera saw of a scene: files, camera, boxes, tracks",
    "truth_checks": "a check of a clip's ground truth against geometry: residuals and limit",
}


def card_header(title: str, counts: Counts, license_id: str = "apache-2.0") -> list[str]:
    """The header of a card: which files belong to which table and split (`load_dataset`)."""
    lines = ["---", f"pretty_name: {json.dumps(title)}", f"license: {license_id}", "configs:"]
    for table, by_split in counts.items():
        if table == "runs":
            continue
        lines += [f"- config_name: {table}", "  data_files:"]
        for split in SPLITS:
            if by_split.get(split):
                lines += [f"  - split: {split}", f"    path: {table}/{split}-*.parquet"]
        if table == "scenes":
            lines.append("  default: true")
    return [*lines, "---", ""]


def card_tables(counts: Counts) -> list[str]:
    """The tables of a card and their rows, and the scenes of every split."""
    lines = ["| table | rows | one row is |", "| --- | ---: | --- |"]
    lines += [f"| {t} | {n} | {_ONE_ROW[t]} |" for t, n in totals(counts).items()]
    lines += ["", "| split | scenes |", "| --- | ---: |"]
    return [*lines, *(f"| {s} | {counts.get('scenes', {}).get(s, 0)} |" for s in SPLITS)]


def dataset_card(title: str, counts: Counts) -> str:
    """The dataset card: a header that `datasets.load_dataset` reads, then what is inside."""
    return "\n".join(
        [
            *card_header(title, counts),
            f"# {title}",
            "",
            *card_tables(counts),
            "",
            "Splits are by prompt family (the prompt without its numbers), so that no family is in "
            "two splits. Columns, keys and array layouts: `meta/info.json`.",
            "",
        ]
    )


def sweep_temporary(folder: Path) -> None:
    """Deletes temporary files that a killed writer left anywhere below a folder."""
    for path in folder.rglob(".*.tmp"):
        with contextlib.suppress(OSError):
            path.unlink()
