"""CSV and Parquet: a row a body and frame; bodies and contacts in tables beside it.

`NAME.csv` has the columns time, body, x, y, z, qx, qy, qz, qw and, if there are, vx, vy, vz, wx,
wy, wz; `NAME.bodies.csv` those of `FACTS`, `NAME.contacts.csv` time, a, b, impulse, depth. The
same as `.parquet`.
"""

from __future__ import annotations

from collections.abc import Callable
import csv
from pathlib import Path
from typing import Any

import numpy as np

from esg.engines.base import MOST_STATES
from esg.engines.scene import ContactLog
from esg.judging.readers.columns import FACTS, contact_log, number, thing_of
from esg.judging.recording import Faults, Floats, Frame, Recording, Thing

Table = dict[str, list[Any]]
Load = Callable[[Path, Faults], Table]
POSE = ("x", "y", "z", "qx", "qy", "qz", "qw")
VELOCITY, SPIN = ("vx", "vy", "vz"), ("wx", "wy", "wz")
MOST_CSV_BYTES = 256 * 2**20
_MOST_FIELD = 10_000


def read_csv(path: Path, frame: Frame, faults: Faults) -> Recording:
    """Reads `.csv`."""
    return _read(path, frame, faults, load_csv)


def read_parquet(path: Path, frame: Frame, faults: Faults) -> Recording:
    """Reads `.parquet`."""
    return _read(path, frame, faults, load_parquet)


def load_csv(path: Path, faults: Faults) -> Table:
    """Columns of a CSV file with a line of names, as text."""
    if path.stat().st_size > MOST_CSV_BYTES:
        raise faults.fail(f"it has more than {MOST_CSV_BYTES} bytes; write Parquet or NPZ")
    csv.field_size_limit(_MOST_FIELD)
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows = csv.reader(file)
            names = [name.strip() for name in next(rows, [])]
            table: Table = {name: [] for name in names}
            if len(table) != len(names) or not names:
                raise faults.fail("its first line does not name its columns, each once")
            for line, row in enumerate(rows, 2):
                if not row:
                    continue
                if len(row) != len(names):
                    faults.add(f"line {line} has {len(row)} values, its columns are {len(names)}")
                    faults.stop()
                for name, value in zip(names, row, strict=True):
                    table[name].append(value.strip())
    except UnicodeDecodeError:
        raise faults.fail("it is not UTF-8 text") from None
    except csv.Error as error:
        raise faults.fail(f"it is no CSV: {error}") from None
    return table


def load_parquet(path: Path, faults: Faults) -> Table:
    """Columns of a Parquet file that says it has no more rows than are judged."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        file = pq.ParquetFile(path)
        facts = file.metadata
        if facts.num_rows > MOST_STATES or facts.num_columns > 200:
            raise faults.fail(f"it has {facts.num_rows} rows in {facts.num_columns} columns")
        size = sum(facts.row_group(k).total_byte_size for k in range(facts.num_row_groups))
        if size > 8 * 100 * MOST_STATES:
            raise faults.fail(f"it unpacks to {size} bytes")
        flat = [f.name for f in file.schema_arrow if not pa.types.is_nested(f.type)]
        return file.read(columns=flat).to_pydict()
    except (pa.ArrowException, OSError, ValueError) as error:
        raise faults.fail(f"it is no Parquet file ({str(error).splitlines()[0][:120]})") from None


def _read(path: Path, frame: Frame, faults: Faults, load: Load) -> Recording:
    table = load(path, faults)
    missing = [c for c in ("time", "body", *POSE) if c not in table]
    if missing:
        raise faults.fail(
            f"it lacks the columns {', '.join(missing)}; a row is a body in a frame: "
            f"time, body, {', '.join(POSE)}"
        )
    names = list(dict.fromkeys(str(n) for n in table["body"]))
    values = {c: np.array([number(v) for v in table[c]]) for c in ("time", *POSE)}
    for column, held in values.items():
        for row in np.flatnonzero(~np.isfinite(held))[:3].tolist():
            faults.add(f"row {row + 1}: {column} is {table[column][row]!r}, no number")
    faults.stop()
    if not names:
        raise faults.fail("it has no rows")
    time = np.unique(values["time"])
    cell = _cells(time, values["time"], names, table["body"], faults)
    shape = (len(time), len(names))
    position = _grid(cell, shape, [values[c] for c in ("x", "y", "z")])
    quaternion = _grid(cell, shape, [values[c] for c in ("qx", "qy", "qz", "qw")])
    velocity = _optional(cell, shape, table, VELOCITY, faults)
    spin = _optional(cell, shape, table, SPIN, faults)
    things, notes = _things(path, names, frame, faults, load)
    contacts = _contacts(path, names, time, faults, load)
    faults.stop()
    return Recording(
        path.suffix.removeprefix(".").lower(),
        time,
        frame.lengths(position),
        frame.quaternions(quaternion),
        things,
        velocity=None if velocity is None else frame.lengths(velocity),
        spin=None if spin is None else frame.turns(spin),
        contacts=contacts,
        notes=notes,
    )


def _cells(
    time: Floats, at: Floats, names: list[str], bodies: list[Any], faults: Faults
) -> tuple[Any, Any]:
    """Frame and column of every row; every body needs one row a frame."""
    index = {name: k for k, name in enumerate(names)}
    frame = np.searchsorted(time, at)
    column = np.array([index[str(n)] for n in bodies])
    count = np.zeros((len(time), len(names)), int)
    np.add.at(count, (frame, column), 1)
    for k, name in enumerate(names):
        for what, wrong in (("no row", count[:, k] == 0), ("several rows", count[:, k] > 1)):
            if wrong.any():
                first = time[int(np.argmax(wrong))]
                faults.add(f"{name!r} has {what} at {first:g} s ({int(wrong.sum())} such frames)")
    faults.stop()
    return frame, column


def _grid(cell: tuple[Any, Any], shape: tuple[int, int], columns: list[Floats]) -> Floats:
    out = np.empty((*shape, len(columns)))
    for k, column in enumerate(columns):
        out[cell[0], cell[1], k] = column
    return out


def _optional(
    cell: tuple[Any, Any],
    shape: tuple[int, int],
    table: Table,
    names: tuple[str, ...],
    faults: Faults,
) -> Floats | None:
    if not all(name in table for name in names):
        return None
    columns = [np.array([number(v) for v in table[name]]) for name in names]
    if not all(np.isfinite(c).all() for c in columns):
        faults.add(f"{', '.join(names)} are not numbers in every row")
        return None
    return _grid(cell, shape, columns)


def beside(path: Path, what: str) -> Path | None:
    """The table of bodies or contacts beside a file, None if there is none."""
    stem = path.name[: -len(path.suffix)]
    for suffix in (path.suffix, ".csv", ".parquet"):
        found = path.with_name(f"{stem}.{what}{suffix}")
        if found.is_file():
            return found
    return None


def _rows(path: Path, faults: Faults, load: Load) -> Table:
    own = Faults(path)
    return (load_parquet if path.suffix == ".parquet" else load)(path, own)


def _things(
    path: Path, names: list[str], frame: Frame, faults: Faults, load: Load
) -> tuple[tuple[Thing, ...], tuple[str, ...]]:
    table = beside(path, "bodies")
    if table is None:
        note = "there is no table of bodies beside it: nothing has a shape, nothing can touch"
        return tuple(Thing(name) for name in names), (note,)
    columns = _rows(table, faults, load_csv if table.suffix == ".csv" else load)
    if "body" not in columns:
        faults.add(f"{table.name} lacks the column body; it may have {', '.join(FACTS)}")
        return (), ()
    rows: dict[str, dict[str, Any]] = {}
    for k, name in enumerate(columns["body"]):
        if str(name) in rows:
            faults.add(f"{table.name} has {name!r} several times")
        rows[str(name)] = {key: values[k] for key, values in columns.items()}
    for name in sorted(set(rows) - set(names)):
        faults.add(f"{table.name} has {name!r}, which has no poses")
    things = [
        thing_of(rows.get(name, {"body": name}), path.parent, frame, faults) for name in names
    ]
    bare = [t.name for t in things if t.name not in rows]
    told = (f"{len(bare)} bodies have no shape: {', '.join(bare[:6])}",) if bare else ()
    return tuple(things), told


def _contacts(
    path: Path, names: list[str], time: Floats, faults: Faults, load: Load
) -> ContactLog | None:
    table = beside(path, "contacts")
    if table is None:
        return None
    columns = _rows(table, faults, load_csv if table.suffix == ".csv" else load)
    return contact_log(columns, names, time, faults)
