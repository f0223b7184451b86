"""How a child tells what a class did: plain numbers and text, checked before they are believed.

Nothing that a child says is unpickled or evaluated: it may have been taken over by the class.
"""

from __future__ import annotations

from dataclasses import dataclass
import json
import math
import struct
from typing import Any

import numpy as np

from esg.compile.trust.playing import Job, Played
from esg.engines.scene import ContactLog, Rollout

_HEAD = struct.Struct("<4sI")
_MAGIC = b"ESGR"
_MOST_HEAD = 64 * 2**20
_STATES = {"position": 3, "quaternion": 4, "linear_velocity": 3, "angular_velocity": 3}
_CONTACTS = {
    "world": ("<i4", 0), "frame": ("<i4", 0), "a": ("<i4", 0), "b": ("<i4", 0), "time": ("<f8", 0),
    "impulse": ("<f8", 0), "depth": ("<f8", 0), "point": ("<f8", 3), "normal": ("<f8", 3),
}  # fmt: skip
MOST_LINES, MOST_CHARS = 100_000, 4096
"""Of a class's log."""


@dataclass(frozen=True)
class Failed:
    """What went wrong in a child.

    Args:
        kind: refused, memory or broken.
        message: What the shim or Python said.
    """

    kind: str
    message: str


class WireError(ValueError):
    """A child's answer is not what it should be."""


def most_bytes(job: Job) -> int:
    """The longest answer that a job can have."""
    frames, bodies = job.frames.n_frames, job.bodies
    pairs = bodies * (bodies + 1) // 2
    return _MOST_HEAD + frames * (52 * bodies + 88 * min(pairs, 64 * bodies + 64))


def packed(played: Played) -> bytes:
    """An answer as bytes."""
    rollout, contacts = played.rollout, played.rollout.contacts
    arrays = [np.asarray(getattr(rollout, name), "<f4") for name in _STATES]
    arrays += [np.asarray(getattr(contacts, n), kind) for n, (kind, _) in _CONTACTS.items()]
    head = {
        "engine": rollout.engine,
        "valid": bool(rollout.valid[0]),
        "contacts": len(contacts.time),
        "log": [line[:MOST_CHARS] for line in played.log[:MOST_LINES]],
    }
    return _framed(head) + b"".join(np.ascontiguousarray(a).tobytes() for a in arrays)


def packed_failure(failed: Failed) -> bytes:
    """A failure as bytes."""
    return _framed({"failed": failed.kind, "message": failed.message[:MOST_CHARS]})


def _framed(head: dict[str, Any]) -> bytes:
    text = json.dumps(head).encode()
    return _HEAD.pack(_MAGIC, len(text)) + text


def unpacked(data: bytes, job: Job) -> Played | Failed:
    """An answer, of the shapes that the job gives.

    Raises:
        WireError: If it is anything else.
    """
    head, at = _head(data)
    if "failed" in head:
        return Failed(str(head["failed"]), str(head.get("message", ""))[:MOST_CHARS])
    count, log = head.get("contacts"), head.get("log")
    if not isinstance(count, int) or count < 0:
        raise WireError("no number of contacts")
    if not isinstance(log, list) or not all(isinstance(line, str) for line in log):
        raise WireError("no log")
    log = [line[:MOST_CHARS] for line in log[:MOST_LINES]]
    frames, bodies = job.frames.n_frames, job.bodies
    wanted = [(name, "<f4", (1, frames, bodies, width)) for name, width in _STATES.items()]
    wanted += [
        (name, kind, (count, width) if width else (count,))
        for name, (kind, width) in _CONTACTS.items()
    ]
    sizes = [np.dtype(kind).itemsize * math.prod(shape) for _, kind, shape in wanted]
    if len(data) - at != sum(sizes):
        raise WireError(f"{len(data) - at} bytes of numbers where {sum(sizes)} belong")
    found: dict[str, Any] = {}
    for (name, kind, shape), size in zip(wanted, sizes, strict=True):
        found[name] = np.frombuffer(data, kind, math.prod(shape), at).reshape(shape).copy()
        at += size
    contacts = _contacts({name: found[name] for name in _CONTACTS}, frames, bodies)
    states = {name: found[name] for name in _STATES}
    rollout = Rollout(
        engine=job.engine,
        dt=job.dt,
        time=job.frames.time,
        **states,
        contacts=contacts,
        valid=np.array([head.get("valid") is True and _finite(states)]),
        extra={"proof": "class", "log": log},
    )
    return Played(rollout, log, None)


def _finite(states: dict[str, Any]) -> bool:
    return all(bool(np.isfinite(values).all()) for values in states.values())


def _head(data: bytes) -> tuple[dict[str, Any], int]:
    if len(data) < _HEAD.size:
        raise WireError("no answer")
    magic, length = _HEAD.unpack_from(data)
    at = _HEAD.size + length
    if magic != _MAGIC or length > _MOST_HEAD or at > len(data):
        raise WireError("no answer")
    try:
        head = json.loads(data[_HEAD.size : at])
    except (ValueError, RecursionError):
        raise WireError("an answer that is no JSON") from None
    if not isinstance(head, dict):
        raise WireError("an answer that is no object")
    return head, at


def _contacts(columns: dict[str, Any], frames: int, bodies: int) -> ContactLog:
    within = {"world": (0, 1), "frame": (0, frames), "a": (0, bodies), "b": (-1, bodies)}
    for name, (low, high) in within.items():
        values = columns[name]
        if len(values) and (values.min() < low or values.max() >= high):
            raise WireError(f"contacts whose {name} does not exist")
    return ContactLog(**columns)
