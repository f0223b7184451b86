"""NPZ: arrays of poses, or the exact replay of a scene folder.

Arrays: `names` [B], `time` [T], `position` [T, B, 3], `quaternion` [T, B, 4] (x, y, z, w) and, if
there are, `linear_velocity`, `angular_velocity` [T, B, 3], facts of bodies (`label`, `shape`,
`mass`, `static` [B], `size` [B, 3]), contacts (`contact_time`, `contact_a`, `contact_b`,
`contact_impulse`, `contact_depth` [n]; a and b are names).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any
import zipfile
import zlib

import numpy as np

from esg.judging.readers.columns import SIZE, contact_log, thing_of
from esg.judging.recording import Faults, Floats, Frame, Recording, Thing
from esg.strangers.arrays import check_npz

MOST_BYTES = 2**31
_FACTS = ("label", "shape", "mass", "static", "color", "mesh")
_CONTACT = ("time", "a", "b", "impulse", "depth")


def read_npz(path: Path, frame: Frame, faults: Faults) -> Recording:
    """Reads `.npz`."""
    try:
        check_npz(path, MOST_BYTES)
        with np.load(path, allow_pickle=False) as file:
            held: dict[str, Any] = {name: file[name] for name in file.files}
    except (ValueError, KeyError, EOFError, OSError, zipfile.BadZipFile, zlib.error) as error:
        raise faults.fail(f"it is no archive of arrays ({str(error)[:120]})") from None
    if "names" not in held and (path.parent / "manifest.json").is_file():
        return _own(path, faults)
    names, time, position, quaternion = _poses(held, faults)
    velocity = _vectors(held, "linear_velocity", position.shape, faults)
    spin = _vectors(held, "angular_velocity", position.shape, faults)
    things = _things(held, names, path.parent, frame, faults)
    contacts = None
    if "contact_time" in held:
        columns = {c: held[f"contact_{c}"].tolist() for c in _CONTACT if f"contact_{c}" in held}
        lengths = {len(v) if isinstance(v, list) else -1 for v in columns.values()}
        if len(lengths) > 1:
            faults.add("its contact_ arrays have different lengths")
        else:
            contacts = contact_log(columns, names, time, faults)
    faults.stop()
    notes = () if "shape" in held else ("it has no array shape: nothing can touch",)
    return Recording(
        "npz",
        time,
        frame.lengths(position),
        frame.quaternions(quaternion),
        things,
        velocity=None if velocity is None else frame.lengths(velocity),
        spin=None if spin is None else frame.turns(spin),
        contacts=contacts,
        notes=notes,
    )


def _own(path: Path, faults: Faults) -> Recording:
    """The replay of a scene folder, exact: bodies and program stand in its manifest."""
    from esg.scenereading import read_manifest, read_rollout

    manifest = read_manifest(path.parent / "manifest.json")
    rollout = read_rollout(path, len(manifest.scene.bodies))
    things = tuple(Thing(body.name) for body in manifest.scene.bodies)
    position = rollout.position[0].astype(float)
    return Recording(
        rollout.engine, rollout.time, position, rollout.quaternion[0].astype(float), things,
        manifest=manifest, centered=True, rollout=rollout,
    )  # fmt: skip


def _poses(held: dict[str, Any], faults: Faults) -> tuple[list[str], Floats, Floats, Floats]:
    missing = [n for n in ("names", "time", "position", "quaternion") if n not in held]
    if missing:
        raise faults.fail(f"it lacks the arrays {', '.join(missing)}")
    names = [str(n) for n in np.atleast_1d(held["names"]).ravel()]
    out: list[Floats] = []
    want = {"time": (None,), "position": (None, len(names), 3), "quaternion": (None, len(names), 4)}
    frames = np.shape(held["time"])[:1]
    for name, shape in want.items():
        array = held[name]
        shape = (*frames, *shape[1:])
        if array.shape != shape or not np.issubdtype(array.dtype, np.number):
            told = f"{name} has shape {array.shape} of {array.dtype}, not {shape} of numbers"
            faults.add(told)
        else:
            out.append(np.asarray(array, float))
    faults.stop()
    return names, out[0], out[1], out[2]


def _vectors(
    held: dict[str, Any], name: str, shape: tuple[int, ...], faults: Faults
) -> Floats | None:
    if name not in held:
        return None
    array = held[name]
    if array.shape != shape or not np.issubdtype(array.dtype, np.number):
        faults.add(f"{name} has shape {array.shape}, not {shape}")
        return None
    if not np.isfinite(array).all():
        faults.add(f"{name} holds what is no number")
        return None
    return np.asarray(array, float)


def _things(
    held: dict[str, Any], names: list[str], folder: Path, frame: Frame, faults: Faults
) -> tuple[Thing, ...]:
    count = len(names)
    for name, shape in [*((f, (count,)) for f in _FACTS), ("size", (count, 3))]:
        if name in held and held[name].shape != shape:
            faults.add(f"{name} has shape {held[name].shape}, not {shape}")
    faults.stop()
    things: list[Thing] = []
    for k, body in enumerate(names):
        row: dict[str, Any] = {"body": body}
        row |= {fact: held[fact][k].item() for fact in _FACTS if fact in held}
        if "static" in row:
            row["static"] = str(bool(row["static"]))
        if "size" in held:
            row |= dict(zip(SIZE, held["size"][k].tolist(), strict=True))
        things.append(thing_of(row, folder, frame, faults))
    return tuple(things)
