"""Facts of bodies and contacts as tables give them: beside motion in columns, or in arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
import math
from pathlib import Path
from typing import Any

import numpy as np

from esg.engines.scene import GROUND, ContactLog, Shape
from esg.judging.forms import of_extents, of_mesh
from esg.judging.recording import Faults, Floats, Frame, Thing
from esg.strangers.folders import file_in

SIZE = ("size_x", "size_y", "size_z")
FACTS = ("body", "label", "shape", *SIZE, "mass", "static", "mesh", "color")
CONTACT = ("time", "a", "b", "impulse")
CONTACT_MORE = ("depth",)
_TRUTH = {"1": True, "true": True, "yes": True, "0": False, "false": False, "no": False}


def number(value: Any) -> float:
    """A number, NaN where there is none or something else."""
    try:
        return float(value) if value not in (None, "") else math.nan
    except (TypeError, ValueError):
        return math.nan


def thing_of(row: Mapping[str, Any], folder: Path, frame: Frame, faults: Faults) -> Thing:
    """One body by a row of facts.

    Args:
        row: Values of `FACTS`; all but `body` may be missing or empty.
        folder: Where its mesh may lie.
        frame: Its units and axes; a mesh is glTF and states its own.
        faults: Of the file.
    """
    name = str(row.get("body") or "")
    kind = str(row.get("shape") or "").strip().lower()
    sizes = [frame.metres * number(row.get(key)) for key in SIZE]
    mesh = str(row.get("mesh") or "").strip()
    shapes, box = (), None
    if mesh:
        shapes = _mesh(folder, mesh, name, faults)
    elif kind:
        if kind in ("sphere",) and math.isfinite(sizes[0]):
            sizes = [sizes[0]] * 3
        if not all(math.isfinite(v) and v > 0.0 for v in sizes):
            faults.add(f"{name!r} is a {kind} without {', '.join(SIZE)} above 0")
        else:
            half = np.abs(frame.directions(0.5 * np.array(sizes)))
            box = (-half, half)
            try:
                shapes = tuple(_turned(s, frame) for s in of_extents(kind, sizes))
            except ValueError as error:
                faults.add(f"{name!r}: {error}")
    mass, static = number(row.get("mass")), str(row.get("static") or "").strip().lower()
    if static and static not in _TRUTH:
        faults.add(f"{name!r}: static is {static!r}; write true or false")
    return Thing(
        name,
        shapes,
        box=box,
        mass=None if math.isnan(mass) else mass,
        static=_TRUTH.get(static),
        label=str(row.get("label") or ""),
        color=_color(str(row.get("color") or ""), name, faults),
    )


def _turned(shape: Shape, frame: Frame) -> Shape:
    """A shape about the origin of a body whose axes are theirs, in ours."""
    from scipy.spatial.transform import Rotation

    axes = np.array(frame.axes, float)
    if np.linalg.det(axes) < 0.0:
        # What is round or square is its own mirror image.
        axes = axes @ np.diag([1.0, -1.0, 1.0])
    x, y, z, w = (float(v) for v in Rotation.from_matrix(axes).as_quat())
    return replace(shape, quaternion=(x, y, z, w))


def _color(text: str, name: str, faults: Faults) -> tuple[float, float, float] | None:
    if not text:
        return None
    digits = text.removeprefix("#")
    try:
        if len(digits) != 6:
            raise ValueError
        red, green, blue = (int(digits[k : k + 2], 16) / 255.0 for k in (0, 2, 4))
    except ValueError:
        faults.add(f"{name!r}: the color {text!r} is not written #rrggbb")
        return None
    return red, green, blue


def _mesh(folder: Path, mesh: str, name: str, faults: Faults) -> tuple[Any, ...]:
    """Hulls of a GLB that lies beside the file."""
    from esg.assets.gltf.parts import parts_of
    from esg.strangers.gltf import MOST_BYTES

    path = file_in(folder, mesh)
    if path is None or path.suffix.lower() != ".glb":
        faults.add(f"{name!r}: the mesh {mesh!r} is no .glb file in the folder")
        return ()
    if path.stat().st_size > MOST_BYTES:
        faults.add(f"{name!r}: the mesh {mesh!r} has more than {MOST_BYTES} bytes")
        return ()
    try:
        parts = parts_of(path.read_bytes())
    except (ValueError, OSError) as error:
        faults.add(f"{name!r}: the mesh {mesh!r} cannot be read ({error})")
        return ()
    return tuple(s for part in parts for s in of_mesh(part.vertices, part.faces))


def contact_log(
    columns: Mapping[str, Sequence[Any]], names: Sequence[str], time: Floats, faults: Faults
) -> ContactLog:
    """A contact log from columns of `CONTACT` and `CONTACT_MORE`; bodies by name.

    Args:
        columns: Of equal length.
        names: Of the bodies, in order.
        time: Of the frames [s].
        faults: Of the file.
    """
    index = {name: k for k, name in enumerate(names)} | {GROUND: -1}
    missing = [c for c in CONTACT if c not in columns]
    if missing:
        faults.add(f"its contacts lack {', '.join(missing)}")
        return ContactLog.empty()
    count = len(columns["time"])
    for side in ("a", "b"):
        unknown = sorted({str(n) for n in columns[side]} - set(index))
        for name in unknown[:5]:
            faults.add(f"a contact is with {name!r}, which is no body of it")
        if unknown:
            return ContactLog.empty()
    at = np.array([number(v) for v in columns["time"]])
    impulse = np.array([number(v) for v in columns["impulse"]])
    depth = np.array([number(v) for v in columns.get("depth", [0.0] * count)])
    if not (np.isfinite(at).all() and np.isfinite(impulse).all() and np.isfinite(depth).all()):
        faults.add("its contacts have times, impulses or depths that are no numbers")
        return ContactLog.empty()
    a = np.array([index[str(n)] for n in columns["a"]], np.int32)
    b = np.array([index[str(n)] for n in columns["b"]], np.int32)
    # The ground is always the second, else the smaller index the first.
    swap = np.where(b == -1, False, (a > b) | (a == -1))
    a, b = np.where(swap, b, a).astype(np.int32), np.where(swap, a, b).astype(np.int32)
    order = np.lexsort((b, a, at))
    frame = np.clip(np.searchsorted(time, at - 1e-9), 0, len(time) - 1).astype(np.int32)
    return ContactLog(
        world=np.zeros(count, np.int32),
        frame=frame[order],
        a=a[order],
        b=b[order],
        time=at[order],
        impulse=impulse[order],
        depth=np.maximum(depth[order], 0.0),
        point=np.zeros((count, 3)),
        normal=np.tile([0.0, 0.0, 1.0], (count, 1)),
    )
