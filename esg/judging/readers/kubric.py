"""Kubric: `metadata.json` of a rendered scene (MOVi and its kin).

Kubric's world is ours (Z up, metres); its quaternions are (w, x, y, z). An instance's box is that
of its `bboxes_3d`, or 1 by its `scale`; spheres and cylinders of MOVi-A and B are told by name.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any, cast

import numpy as np

from esg.files import read_limited
from esg.judging.forms import of_extents
from esg.judging.recording import Faults, Floats, Frame, Recording, Thing
from esg.units import quat_inverse, quat_rotate
from esg.untyped import is_list, is_object

MOST_BYTES = 256 * 2**20
_ROUND = {"sphere": "sphere", "ball": "sphere", "cylinder": "cylinder"}
_WORDS = ("size_label", "color_label", "color", "material", "shape")


def read_metadata(path: Path, frame: Frame, faults: Faults) -> Recording:
    """Reads Kubric's `metadata.json`; its frame is known, so `frame` does not matter."""
    data = _json(path, faults)
    about, instances = data.get("metadata", data.get("scene", {})), data.get("instances")
    if not is_object(about) or not is_list(instances):
        raise faults.fail("it has no metadata and instances: it is not Kubric's metadata.json")
    rate = about.get("frame_rate")
    if not isinstance(rate, int | float) or isinstance(rate, bool) or not 0.0 < rate < 1e5:
        raise faults.fail(f"metadata/frame_rate is {rate!r}, not frames a second")
    things: list[Thing] = []
    tracks: list[tuple[Floats, Floats, Floats | None, Floats | None]] = []
    counts: dict[str, int] = {}
    for k, item in enumerate(instances):
        if not is_object(item):
            faults.add(f"instances/{k} is no object")
            continue
        track = _track(item, k, faults)
        if track is None:
            continue
        words = _words(item)
        counts[words] = counts.get(words, 0) + 1
        name = f"{words.replace(' ', '_')}_{counts[words]}"
        tracks.append(track)
        things.append(_thing(item, name, words, track))
    lengths = {len(track[0]) for track in tracks}
    if len(lengths) > 1:
        faults.add(f"its instances have different numbers of frames: {sorted(lengths)}")
    faults.stop()
    if not tracks:
        raise faults.fail("it has no instances")
    count = lengths.pop()
    velocity = _stacked([track[2] for track in tracks])
    spin = _stacked([track[3] for track in tracks])
    notes = ["its floor is taken for z = 0"]
    if path.with_name("events.json").is_file():
        notes.append("events.json holds forces of contacts, not impulses, and is not read")
    return Recording(
        "kubric",
        np.arange(count) / float(rate),
        np.stack([track[0] for track in tracks], axis=1),
        np.stack([track[1] for track in tracks], axis=1),
        tuple(things),
        velocity=velocity,
        spin=spin,
        notes=tuple(notes),
    )


def _json(path: Path, faults: Faults) -> dict[str, Any]:
    try:
        data = json.loads(read_limited(path, MOST_BYTES))
    except (ValueError, RecursionError, OSError) as error:
        raise faults.fail(f"it is no JSON ({str(error)[:100]})") from None
    if not is_object(data):
        raise faults.fail("it is no JSON object")
    return data


def _array(item: dict[str, Any], key: str, width: tuple[int, ...]) -> Floats | None:
    """Numbers over frames, shape [T, *width]; None if there are none or others."""
    try:
        array = np.array(item.get(key), float)
    except (TypeError, ValueError):
        return None
    return array if array.shape[1:] == width and array.ndim == 1 + len(width) else None


def _track(
    item: dict[str, Any], k: int, faults: Faults
) -> tuple[Floats, Floats, Floats | None, Floats | None] | None:
    position, turned = _array(item, "positions", (3,)), _array(item, "quaternions", (4,))
    for key, found in (("positions", position), ("quaternions", turned)):
        if found is None:
            faults.add(f"instances/{k}/{key} is no list of numbers over frames")
    if position is None or turned is None:
        return None
    if len(position) != len(turned):
        faults.add(f"instances/{k} has {len(position)} positions and {len(turned)} quaternions")
        return None
    velocity, spin = _array(item, "velocities", (3,)), _array(item, "angular_velocities", (3,))
    wxyz = turned[:, [1, 2, 3, 0]]
    fits = [v if v is not None and len(v) == len(position) else None for v in (velocity, spin)]
    return position, wxyz, fits[0], fits[1]


def _stacked(found: list[Floats | None]) -> Floats | None:
    known = [v for v in found if v is not None]
    return np.stack(known, axis=1) if len(known) == len(found) else None


def _words(item: dict[str, Any]) -> str:
    """What an instance is called: its category, or size, colour, material and shape."""
    category = item.get("category")
    if isinstance(category, str) and category.strip():
        return category.strip().lower()
    said = [item[w] for w in _WORDS if isinstance(item.get(w), str)]
    known = " ".join(dict.fromkeys(w.strip().lower() for w in said if w.strip()))
    asset = item.get("asset_id")
    return known or (asset.replace("_", " ").lower() if isinstance(asset, str) else "thing")


def _thing(
    item: dict[str, Any],
    name: str,
    words: str,
    track: tuple[Floats, Floats, Floats | None, Floats | None],
) -> Thing:
    low, high = _box(item, track)
    kind = next((k for word, k in _ROUND.items() if word in words.split()), "box")
    middle = 0.5 * (low + high)
    x, y, z = (float(v) for v in middle)
    shapes = tuple(
        s.__class__(s.kind, s.size, (x, y, z), s.quaternion)
        for s in of_extents(kind, np.maximum(high - low, 1e-4).tolist())
    )
    mass = item.get("mass")
    known = isinstance(mass, int | float) and not isinstance(mass, bool) and math.isfinite(mass)
    return Thing(
        name,
        shapes,
        box=(low, high),
        mass=float(cast("float", mass)) if known else None,
        center=(0.0, 0.0, 0.0),
        label=words,
        category=words.split()[-1],
    )


def _box(
    item: dict[str, Any], track: tuple[Floats, Floats, Floats | None, Floats | None]
) -> tuple[Floats, Floats]:
    """Corners of an instance's box in its own frame [m]."""
    corners = _array(item, "bboxes_3d", (8, 3))
    if corners is not None and len(corners):
        own = quat_rotate(
            quat_inverse(track[1][0] / np.linalg.norm(track[1][0])), corners[0] - track[0][0]
        )
        return own.min(axis=0), own.max(axis=0)
    scale = item.get("scale", item.get("size", 1.0))
    try:
        half = 0.5 * np.broadcast_to(np.array(scale, float), (3,))
    except (TypeError, ValueError):
        half = np.full(3, 0.5)
    return -half, half.copy()
