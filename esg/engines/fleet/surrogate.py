"""The fused surrogate for worlds of different scenes: one launch for all of them.

A thread simulates a world with the very functions of the single-scene kernel, on the arrays of its
scene. Those of all scenes lie in a few large buffers; an array of structs tells where.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import cycle
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.fleet.arena import Buffer
from esg.engines.fleet.jobs import Job, Played, SceneShapes
from esg.engines.fleet.launch import Launch
from esg.engines.newton.setup import quiet_warp
from esg.engines.surrogate.model import CONTACTS, ROWS_PER_FRAME, _radius

MAX_CONTACTS = 4096
MEMORY_BYTES = {"cpu": 2_000_000_000, "cuda": 40_000_000_000}
CUDA_CONTACTS = 256
"""Room on a GPU, where memory is plentiful and a second launch is not."""


@dataclass
class Playing:
    """Jobs on their way.

    Args:
        jobs: Rollouts.
        shapes: Their scenes.
        rooms: Contacts and log rows of a world, per job.
        pending: Indices of jobs that have not been launched, in order.
        out: Results.
        part: Indices of the jobs that have been launched.
        run: Their simulation; None if there is nothing left.
    """

    jobs: list[Job]
    shapes: list[SceneShapes]
    rooms: list[tuple[int, int]]
    pending: list[int]
    out: list[Played | None]
    part: list[int] = field(default_factory=list)
    run: Launch | None = None


class FleetSurrogate:
    """Simulates jobs of many scenes at once.

    Args:
        device: Warp device: "cpu" or "cuda:0".
    """

    def __init__(self, device: str) -> None:
        self.wp = quiet_warp()
        from newton import GeoType

        self.device = device
        self.kinds = {
            "sphere": int(GeoType.SPHERE),
            "box": int(GeoType.BOX),
            "capsule": int(GeoType.CAPSULE),
            "cylinder": int(GeoType.CYLINDER),
            "convex": int(GeoType.CONVEX_MESH),
        }
        self._meshes: dict[bytes, Any] = {}
        self._fields: dict[int, dict[str, NDArray[Any]]] = {}
        self.contacts: dict[int, int] = {}
        self.seconds = {"load": 0.0, "run": 0.0, "read": 0.0}
        self._first_room = CONTACTS if device == "cpu" else CUDA_CONTACTS
        # One launch may begin before the one before it has ended, and both beside other work.
        streams = [None] if device == "cpu" else [self.wp.Stream(device) for _ in range(2)]
        self._streams = cycle(streams)

    def play(
        self,
        jobs: list[Job],
        shapes: list[SceneShapes],
        buffer: Buffer,
        meanwhile: Callable[[], bool] | None = None,
    ) -> list[Played]:
        """Simulates all jobs; `begin` and `finish` in one."""
        return self.finish(self.begin(jobs, shapes), buffer, meanwhile)

    def begin(self, jobs: list[Job], shapes: list[SceneShapes]) -> Playing:
        """Lets a GPU begin with jobs; a CPU has played the first of them when this returns.

        Args:
            jobs: Rollouts.
            shapes: Their scenes.
        """
        # The longest first: what is left in the end fills the gaps.
        cost = [j.frames.n_steps * len(s.kind) ** 2 for j, s in zip(jobs, shapes, strict=True)]
        pending = sorted(range(len(jobs)), key=lambda k: (-cost[k], k))
        rooms = [
            (self.contacts.get(j.key, self._first_room), ROWS_PER_FRAME * j.frames.n_frames)
            for j in jobs
        ]
        playing = Playing(jobs, shapes, rooms, pending, [None] * len(jobs))
        self._launch(playing)
        return playing

    def finish(
        self, playing: Playing, buffer: Buffer, meanwhile: Callable[[], bool] | None = None
    ) -> list[Played]:
        """The results of jobs that have begun, in order.

        Args:
            playing: What `begin` returned.
            buffer: Where states are put.
            meanwhile: Does a piece of other work and says whether more is left. It is called at
                least once and, while a GPU simulates, again and again.
        """
        more = meanwhile() if meanwhile is not None else False
        while playing.run is not None:
            while more and meanwhile is not None and not playing.run.done:
                # Not ahead of the GPU: what reads the results queues up behind that work.
                self.wp.synchronize_stream(self.wp.get_stream(self.device))
                more = meanwhile()
            self._collect(playing, buffer)
            self._launch(playing)
        return [p for p in playing.out if p is not None]

    def _launch(self, playing: Playing) -> None:
        """Launches as many of the pending jobs as fit."""
        playing.run = None
        if not playing.pending:
            return
        begin = time.perf_counter()
        jobs, shapes, rooms = playing.jobs, playing.shapes, playing.rooms
        limit = MEMORY_BYTES["cpu" if self.device == "cpu" else "cuda"]
        size, count = 0, 0
        for k in playing.pending:
            size += _bytes(jobs[k], *rooms[k])
            if size > limit and count:
                break
            count += 1
        part, playing.pending = playing.pending[:count], playing.pending[count:]
        kept = [self.fields(jobs[k].key, shapes[k]) for k in part]
        playing.part = part
        playing.run = Launch(
            self.wp, self.device, [jobs[k] for k in part], [shapes[k] for k in part], kept,
            [rooms[k] for k in part],
        )  # fmt: skip
        launched = time.perf_counter()
        playing.run.launch(next(self._streams))
        self.seconds["load"] += launched - begin
        self.seconds["run"] += time.perf_counter() - launched

    def _collect(self, playing: Playing, buffer: Buffer) -> None:
        """Reads what was launched; jobs that need more room are granted it and stay pending."""
        begin = time.perf_counter()
        run, part, jobs, rooms = playing.run, playing.part, playing.jobs, playing.rooms
        assert run is not None
        dropped, rows = run.needs()
        ran = time.perf_counter()
        again: list[int] = []
        for i, k in enumerate(part):
            contacts, room = rooms[k]
            needed = (contacts * (2 if dropped[i] else 1), max(room, int(rows[i])))
            if needed != rooms[k] and needed[0] <= MAX_CONTACTS:
                rooms[k] = needed
                self.contacts[jobs[k].key] = needed[0]
                again.append(k)
        done = set(part) - set(again)
        for i, played in run.collect(buffer, [i for i, k in enumerate(part) if k in done]):
            playing.out[part[i]] = played
        playing.pending = again + playing.pending
        self.seconds["run"] += ran - begin
        self.seconds["read"] += time.perf_counter() - ran

    def fields(self, key: int, shapes: SceneShapes) -> dict[str, NDArray[Any]]:
        """A scene's own arrays in the form of the kernel's `Model`; kept for the next call."""
        if key not in self._fields:
            s = shapes
            kind = [self.kinds[k] for k in s.kind]
            reach = np.zeros(max(1, s.n_bodies))
            for b in range(s.n_bodies):
                for i in range(s.first[b], s.first[b + 1]):
                    far = np.linalg.norm(s.centre[i]) + np.linalg.norm(s.half[i])
                    reach[b] = max(reach[b], float(far))
            radius = [_radius(k, c, h, self.kinds) for k, c, h in
                      zip(kind, s.scale, s.half, strict=True)]  # fmt: skip
            mesh = [self._mesh(h, o) for h, o in zip(s.hulls, s.offset, strict=True)]
            single, n = np.float32, len(kind)
            self._fields[key] = {
                "first": s.first.astype(np.int32),
                "kind": np.array(kind or [0], np.int32),
                "scale": (s.scale if n else np.zeros((1, 3))).astype(single),
                "mesh": np.array(mesh or [[0.0] * 3], single),
                "position": (s.centre if n else np.zeros((1, 3))).astype(single),
                "rotation": (s.rotation if n else np.array([[0, 0, 0, 1.0]])).astype(single),
                "half": (s.half if n else np.zeros((1, 3))).astype(single),
                "radius": np.array(radius or [0.0], single),
                "reach": reach.astype(single),
                "dynamic": s.dynamic.astype(np.int32),
                "wheeled": s.wheeled.astype(np.int32),
                "inertia": s.inertia.astype(single),
                "inverse_inertia": np.linalg.inv(s.inertia).astype(single),
            }
        return self._fields[key]

    def forget(self, key: int) -> None:
        """Drops what is kept of a scene."""
        self._fields.pop(key, None)

    def _mesh(self, hull: Any, offset: NDArray[np.float64]) -> list[float]:
        if hull is None:
            return [0.0, 0.0, 0.0]
        vertices = (hull[0] - offset).astype(np.float32)
        # Support maps read the points only: hulls of equal points share a mesh.
        key = vertices.tobytes()
        wp = self.wp
        if key not in self._meshes:
            self._meshes[key] = wp.Mesh(
                points=wp.array(vertices, dtype=wp.vec3, device=self.device),
                indices=wp.array(hull[1].reshape(-1), dtype=int, device=self.device),
                **({} if self.device == "cpu" else {"bvh_constructor": "lbvh"}),
            )
        bits = int(self._meshes[key].id)
        return [float(bits & 0x3FFFFF), float((bits >> 22) & 0x3FFFFF), float(bits >> 44)]


def _bytes(job: Job, contacts: int, rows: int) -> int:
    """Device memory of a job, roughly."""
    w, b = job.mass.shape
    a_world = job.frames.n_frames * b * 52 + rows * 48 + contacts * 188 + 12 * b * b + 300 * b
    return w * a_world
