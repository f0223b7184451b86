"""MCAP: transforms of bodies over time (foxglove.FrameTransforms), shapes, a manifest if there is.

What `esg export --to mcap` writes holds the manifest of its scene. Of others' recordings bodies are
the child frames of `/tf`, shapes the cubes, spheres and cylinders of `/scene` in those frames.
"""

from __future__ import annotations

import json
from pathlib import Path
import struct
from typing import Any

import numpy as np

from esg.engines.breaking.swap import HIDDEN_M
from esg.engines.manifest import Manifest
from esg.engines.scene import Shape
from esg.judging.readers.carried import manifest_of
from esg.judging.recording import MOST_THINGS, Faults, Floats, Frame, Recording, Thing

MOST_MESSAGES = 2_000_000
MOST_BYTES = 2**31
"""Of its chunks, unpacked."""
_TF, _SCENE = "foxglove.FrameTransforms", "foxglove.SceneUpdate"


def read_mcap(path: Path, frame: Frame, faults: Faults) -> Recording:
    """Reads `.mcap`; its frame is ROS's (Z up, metres), so `frame` does not matter."""
    from google.protobuf.message import DecodeError
    from mcap.exceptions import McapError

    try:
        times, tracks, things, manifest = _messages(path, faults)
    except (McapError, DecodeError, OSError, ValueError, EOFError, struct.error) as error:
        raise faults.fail(f"it is no MCAP file that can be read ({str(error)[:120]})") from None
    names = [n for n in tracks if len(tracks[n]) == len(times)]
    for name in sorted(set(tracks) - set(names)):
        faults.add(f"{name!r} has {len(tracks[name])} transforms, there are {len(times)} instants")
    if not names:
        raise faults.fail(f"it has no transforms ({_TF})")
    faults.stop()
    held = np.array([tracks[n] for n in names]).swapaxes(0, 1)
    position = held[..., :3].copy()
    # What is not there is drawn far below its place.
    position[..., 2] += HIDDEN_M * (position[..., 2] < -0.5 * HIDDEN_M)
    return Recording(
        "mcap",
        np.array(times) - times[0],
        position,
        held[..., 3:],
        tuple(things.get(n, Thing(n)) for n in names),
        manifest=manifest,
        centered=manifest is not None,
        notes=() if manifest is not None else ("it carries no manifest: shapes are those drawn",),
    )


def _messages(
    path: Path, faults: Faults
) -> tuple[list[float], dict[str, list[Floats]], dict[str, Thing], Manifest | None]:
    from foxglove_schemas_protobuf.FrameTransforms_pb2 import FrameTransforms
    from foxglove_schemas_protobuf.SceneUpdate_pb2 import SceneUpdate
    from mcap.reader import make_reader

    times: list[float] = []
    tracks: dict[str, list[Floats]] = {}
    things: dict[str, Thing] = {}
    manifest = None
    with path.open("rb") as file:
        reader = make_reader(file)
        summary = reader.get_summary()
        count = summary.statistics.message_count if summary and summary.statistics else 0
        if count > MOST_MESSAGES:
            raise faults.fail(f"it says it has {count} messages, at most {MOST_MESSAGES} are read")
        chunks = summary.chunk_indexes if summary else []
        size = sum(chunk.uncompressed_size for chunk in chunks)
        if size > MOST_BYTES:
            raise faults.fail(f"it unpacks to {size} bytes, at most {MOST_BYTES} are read")
        for schema, _, message in reader.iter_messages():
            name = "" if schema is None else schema.name
            if name == _TF:
                update = FrameTransforms.FromString(message.data)
                times.append(message.log_time * 1e-9)
                for item in update.transforms:
                    pose = _pose(item.translation, item.rotation)
                    tracks.setdefault(item.child_frame_id, []).append(pose)
                if len(tracks) > MOST_THINGS:
                    raise faults.fail(f"it moves more than {MOST_THINGS} frames")
            elif name == _SCENE:
                things |= _drawn(SceneUpdate.FromString(message.data))
        for attachment in reader.iter_attachments():
            if attachment.name == "manifest.json":
                manifest = manifest_of(json.loads(attachment.data), faults)
    return times, tracks, things, manifest


def _pose(at: Any, turn: Any) -> Floats:
    return np.array([at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w])


def _drawn(update: Any) -> dict[str, Thing]:
    """Things by the primitives that are drawn in their frames."""
    out: dict[str, Thing] = {}
    for entity in update.entities:
        shapes = [_shape("box", item) for item in entity.cubes]
        shapes += [_shape("sphere", item) for item in entity.spheres]
        shapes += [_shape("cylinder", item) for item in entity.cylinders]
        said = {pair.key: pair.value for pair in entity.metadata}
        try:
            mass = float(said.get("mass_kg", ""))
        except ValueError:
            mass = None
        out[entity.frame_id] = Thing(
            entity.frame_id,
            tuple(shapes),
            mass=mass,
            label=said.get("label", ""),
            category=said.get("category", ""),
        )
    return out


def _shape(kind: Any, item: Any) -> Shape:
    x, y, z = 0.5 * item.size.x, 0.5 * item.size.y, 0.5 * item.size.z
    size = {"box": (x, y, z), "sphere": (x, x, x), "cylinder": (x, x, z)}[kind]
    at, turn = item.pose.position, item.pose.orientation
    quaternion = (turn.x, turn.y, turn.z, turn.w)
    if not any(quaternion):
        quaternion = (0.0, 0.0, 0.0, 1.0)
    return Shape(kind, size, (at.x, at.y, at.z), quaternion)
