"""A replay as an MCAP file that Foxglove, Lichtblick or Rerun open.

Channels: `/scene` (foxglove.SceneUpdate, once), `/tf` (foxglove.FrameTransforms, 60 per second),
`/events` (JSON with schema: the judge's verdicts and every hit), `/log` (foxglove.Log).
Attachments: `esg.json`, `manifest.json`, `verdict.json`. Times are simulation time, so that the
same replay gives the same bytes.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from esg.engines.breaking.swap import HIDDEN_M
from esg.engines.program import Program
from esg.engines.scene import GROUND, Body, Rollout, Shape, SimScene
from esg.files import atomic_write
from esg.metrics.models import SceneVerdict
from esg.metrics.replay import Hit, Replay

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument

WORLD = "world"
FPS = 60.0
EVENT_SCHEMA: dict[str, Any] = {
    "title": "esg.Event",
    "type": "object",
    "required": ["kind", "time_s"],
    "properties": {
        "kind": {"type": "string", "enum": ["event", "hit"]},
        "time_s": {"type": "number"},
        "id": {"type": "string", "description": "event id of the suite"},
        "type": {"type": "string", "description": "event type of the suite"},
        "completed": {"type": "boolean"},
        "bodies": {"type": "array", "items": {"type": "string"}},
        "reason": {"type": "string"},
        "measured": {"type": "object", "additionalProperties": {"type": "number"}},
        "impulse_ns": {"type": "number", "description": "accumulated normal impulse [N s]"},
        "depth_m": {"type": "number", "description": "penetration at contact [m]"},
    },
}


def write_mcap(
    path: Path,
    scene: SimScene,
    program: Program,
    rollout: Rollout,
    verdict: SceneVerdict | None = None,
    document: EsgDocument | bytes | None = None,
    *,
    manifest: bytes | None = None,
    world: int = 0,
    fps: float = FPS,
) -> None:
    """Writes one world of a rollout.

    Args:
        path: The file; it appears complete or not at all.
        scene: The scene.
        program: Its control program.
        rollout: The replay.
        verdict: What the judge said about it.
        document: The ESG to attach.
        manifest: The manifest to attach; default: made from scene and program.
        world: Which world of the rollout.
        fps: Transforms per second at most (a slower recording keeps its own rate).

    Raises:
        OSError: With the remedy in its text if the disk is full, read-only or forbidden.
    """
    replay = Replay(scene, program, rollout, world)
    attachments = _attachments(scene, program, rollout, verdict, document, manifest)

    def write(temporary: Path) -> None:
        with temporary.open("wb") as file:
            _write(file, replay, rollout, verdict, attachments, fps)

    atomic_write(Path(path), write)


def _attachments(
    scene: SimScene,
    program: Program,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    document: EsgDocument | bytes | None,
    manifest: bytes | None,
) -> dict[str, bytes]:
    from esg.engines.manifest import manifest_bytes, manifest_to_json

    out: dict[str, bytes] = {}
    if isinstance(document, bytes):
        out["esg.json"] = document
    elif document is not None:
        from esg.graph import canonical_json

        out["esg.json"] = canonical_json(document)
    if manifest is None:
        manifest = manifest_bytes(manifest_to_json(scene, program, dt=rollout.dt))
    out["manifest.json"] = manifest
    if verdict is not None:
        text = json.dumps(verdict.to_json(), indent=2, sort_keys=True, allow_nan=False)
        out["verdict.json"] = text.encode()
    return out


def _write(
    file: Any,
    replay: Replay,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    attachments: dict[str, bytes],
    fps: float,
) -> None:
    from foxglove_schemas_protobuf.FrameTransforms_pb2 import FrameTransforms
    from foxglove_schemas_protobuf.Log_pb2 import Log
    from foxglove_schemas_protobuf.SceneUpdate_pb2 import SceneUpdate
    from mcap.well_known import MessageEncoding, SchemaEncoding
    from mcap.writer import Writer
    from mcap_protobuf.schema import register_schema

    writer = Writer(file)
    writer.start(profile="", library="esg")
    channels = {
        topic: writer.register_channel(
            topic=topic,
            message_encoding=MessageEncoding.Protobuf,
            schema_id=register_schema(writer, message),
        )
        for topic, message in (("/scene", SceneUpdate), ("/tf", FrameTransforms), ("/log", Log))
    }
    channels["/events"] = writer.register_channel(
        topic="/events",
        message_encoding=MessageEncoding.JSON,
        schema_id=writer.register_schema(
            "esg.Event",
            SchemaEncoding.JSONSchema,
            json.dumps(EVENT_SCHEMA, sort_keys=True).encode(),
        ),
    )
    messages: list[tuple[int, int, str, bytes]] = [
        (0, 0, "/scene", _scene_update(replay).SerializeToString())
    ]
    for frame in _frames(replay, fps):
        stamp = _ns(float(replay.time[frame]))
        messages.append((stamp, 1, "/tf", _transforms(replay, frame, stamp).SerializeToString()))
    for time_s, data, text, level in _events(replay, verdict):
        stamp = _ns(time_s)
        messages.append((stamp, 2, "/events", json.dumps(data, sort_keys=True).encode()))
        messages.append((stamp, 3, "/log", _log(stamp, text, level).SerializeToString()))
    messages.sort(key=lambda m: (m[0], m[1]))
    for sequence, (stamp, _, topic, payload) in enumerate(messages):
        writer.add_message(
            channel_id=channels[topic],
            log_time=stamp,
            publish_time=stamp,
            data=payload,
            sequence=sequence,
        )
    for name, data in attachments.items():
        writer.add_attachment(0, 0, name, "application/json", data)
    writer.add_metadata("scene", _metadata(replay, rollout, verdict))
    writer.finish()


def _metadata(replay: Replay, rollout: Rollout, verdict: SceneVerdict | None) -> dict[str, str]:
    data = {
        "scene_id": replay.scene.scene_id,
        "engine": rollout.engine,
        "dt_s": repr(float(rollout.dt)),
        "duration_s": repr(replay.end),
        "valid": str(replay.valid).lower(),
    }
    if verdict is not None:
        data["events"] = f"{verdict.completed}/{verdict.n_events}"
        data["verified"] = str(verdict.verified).lower()
    return data


def _ns(time_s: float) -> int:
    return round(time_s * 1e9)


def _stamp(target: Any, ns: int) -> None:
    target.seconds, target.nanos = divmod(ns, 10**9)


def _frames(replay: Replay, fps: float) -> list[int]:
    """Frames to show: the nearest one to every 1/fps, and the last."""
    count = int(np.floor(replay.end * fps + 1e-6)) + 1
    wanted = np.arange(count) / fps
    index = np.searchsorted(replay.time, wanted - 0.5 * replay.frame_s)
    index = np.clip(index, 0, len(replay.time) - 1)
    return sorted({*index.tolist(), len(replay.time) - 1})


def _pose(target: Any, position: Any, quaternion: Any) -> None:
    target.position.x, target.position.y, target.position.z = (float(v) for v in position)
    o = target.orientation
    o.x, o.y, o.z, o.w = (float(v) for v in quaternion)


def _color(target: Any, rgb: tuple[float, float, float], alpha: float = 1.0) -> None:
    target.r, target.g, target.b, target.a = (*rgb, alpha)


def _scene_update(replay: Replay) -> Any:
    from foxglove_schemas_protobuf.SceneUpdate_pb2 import SceneUpdate

    update = SceneUpdate()
    ground = update.entities.add(id=GROUND, frame_id=WORLD)
    plate = ground.cubes.add()
    extent = float(np.abs(replay.position[..., :2]).max(initial=5.0)) + 5.0
    _pose(plate.pose, (0, 0, -0.005), (0, 0, 0, 1))
    plate.size.x, plate.size.y, plate.size.z = 2 * extent, 2 * extent, 0.01
    _color(plate.color, (0.82, 0.83, 0.85))
    for body in replay.scene.bodies:
        entity = update.entities.add(id=body.name, frame_id=body.name, frame_locked=True)
        for key, value in (("label", body.label), ("category", body.category)):
            entity.metadata.add(key=key, value=value)
        entity.metadata.add(key="mass_kg", value=repr(float(body.mass)))
        for shape in body.shapes:
            _draw(entity, shape, body)
        if not body.shapes:
            _decal(entity, body)
    return update


def _draw(entity: Any, shape: Shape, body: Body) -> None:
    r, _, h = shape.size
    if shape.kind == "sphere":
        item = entity.spheres.add()
        item.size.x = item.size.y = item.size.z = 2 * r
    elif shape.kind == "box":
        item = entity.cubes.add()
        item.size.x, item.size.y, item.size.z = (2 * v for v in shape.size)
    elif shape.kind == "cylinder":
        item = entity.cylinders.add()
        item.size.x, item.size.y, item.size.z = 2 * r, 2 * r, 2 * h
        item.top_scale = item.bottom_scale = 1.0
    elif shape.kind == "capsule":
        _capsule(entity, shape, body)
        return
    else:
        item = entity.triangles.add()
        _triangles(item, shape)
    _pose(item.pose, shape.position, shape.quaternion)
    _color(item.color, body.color)


def _capsule(entity: Any, shape: Shape, body: Body) -> None:
    from esg.units import quat_rotate

    r, _, h = shape.size
    tube = entity.cylinders.add()
    tube.size.x, tube.size.y, tube.size.z = 2 * r, 2 * r, 2 * h
    tube.top_scale = tube.bottom_scale = 1.0
    _pose(tube.pose, shape.position, shape.quaternion)
    _color(tube.color, body.color)
    for end in (-h, h):
        cap = entity.spheres.add()
        cap.size.x = cap.size.y = cap.size.z = 2 * r
        center = np.array(shape.position) + quat_rotate(
            np.array(shape.quaternion), np.array([0.0, 0.0, end])
        )
        _pose(cap.pose, center, shape.quaternion)
        _color(cap.color, body.color)


def _triangles(item: Any, shape: Shape) -> None:
    from scipy.spatial import ConvexHull, QhullError

    points = np.array(shape.vertices, float)
    for p in points:
        item.points.add(x=float(p[0]), y=float(p[1]), z=float(p[2]))
    try:
        hull = ConvexHull(points)
    except (QhullError, ValueError):
        return
    center = points.mean(0)
    for a, b, c in hull.simplices:
        normal = np.cross(points[b] - points[a], points[c] - points[a])
        outward = float(normal @ (points[a] - center)) >= 0
        item.indices.extend([int(a), int(b), int(c)] if outward else [int(a), int(c), int(b)])


def _decal(entity: Any, body: Body) -> None:
    """A body without collision shapes: its outline, thin and translucent."""
    hx, hy, hz = body.half_extents
    item = entity.cubes.add()
    item.size.x, item.size.y, item.size.z = 2 * hx, 2 * hy, max(2 * hz, 0.002)
    center = np.array(body.origin_offset) + np.array([0.0, 0.0, hz])
    _pose(item.pose, center, (0, 0, 0, 1))
    _color(item.color, body.color, 0.6)


def _transforms(replay: Replay, frame: int, stamp: int) -> Any:
    from foxglove_schemas_protobuf.FrameTransforms_pb2 import FrameTransforms

    message = FrameTransforms()
    for i, body in enumerate(replay.scene.bodies):
        item = message.transforms.add(parent_frame_id=WORLD, child_frame_id=body.name)
        _stamp(item.timestamp, stamp)
        t, r = item.translation, item.rotation
        t.x, t.y, t.z = (float(v) for v in replay.position[frame, i])
        t.z -= HIDDEN_M * float(replay.absent[frame, i])
        r.x, r.y, r.z, r.w = (float(v) for v in replay.quaternion[frame, i])
    return message


def _hits(replay: Replay) -> list[Hit]:
    """All hits of the contact log, by time."""
    c = replay.contacts
    seen = sorted({(int(a), int(b)) for a, b in zip(c.a, c.b, strict=True) if b >= 0})
    return sorted((h for a, b in seen for h in replay.hits(a, b)), key=lambda h: (h.time, h.a, h.b))


def _events(
    replay: Replay, verdict: SceneVerdict | None
) -> list[tuple[float, dict[str, Any], str, int]]:
    """Time, JSON, text and log level (2 info, 3 warning) of everything worth a mark."""
    out: list[tuple[float, dict[str, Any], str, int]] = []
    names = [b.name for b in replay.scene.bodies]
    for hit in _hits(replay):
        pair = [names[hit.a], names[hit.b]]
        data = {
            "kind": "hit",
            "time_s": hit.time,
            "bodies": pair,
            "impulse_ns": hit.impulse,
            "depth_m": hit.depth,
        }
        out.append((hit.time, data, f"{pair[0]} hits {pair[1]}: {hit.impulse:.2f} N s", 2))
    for event in verdict.events if verdict is not None else ():
        time_s = event.time_s if event.time_s is not None else replay.end
        data = {
            "kind": "event",
            "time_s": time_s,
            "id": event.id,
            "type": event.type,
            "completed": event.completed,
            "bodies": list(event.bodies),
            "reason": event.reason,
            "measured": event.measured,
        }
        text = f"{event.id} {event.type} " + (
            f"completed at {time_s:.3f} s" if event.completed else f"incomplete: {event.reason}"
        )
        out.append((time_s, data, text, 2 if event.completed else 3))
    return out


def _log(stamp: int, text: str, level: int) -> Any:
    from foxglove_schemas_protobuf.Log_pb2 import Log

    message: Any = Log(message=text, name="judge")
    message.level = level
    _stamp(message.timestamp, stamp)
    return message
