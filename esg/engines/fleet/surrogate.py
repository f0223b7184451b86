"""The fused surrogate for worlds of different scenes: one launch for all of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import cycle
import time
from typing import Any

from esg.engines.jobs import Buffer, Job, Played
from esg.engines.newton.setup import quiet_warp
from esg.engines.shapes import SceneShapes
from esg.engines.surrogate.launch import CONTACTS, ROWS_PER_FRAME, Launch, Room, world_bytes
from esg.engines.surrogate.scene import SceneArrays

MEMORY_BYTES = {"cpu": 2_000_000_000, "cuda": 40_000_000_000}
CUDA_CONTACTS = 256
"""Room on a GPU, where memory is plentiful and a second launch is not."""


@dataclass
class Playing:
    """Jobs on their way.

    Args:
        jobs: Rollouts.
        shapes: Their scenes.
        rooms: Of a world, per job.
        pending: Indices of jobs that have not been launched, in order.
        out: Results.
        part: Indices of the jobs that have been launched.
        run: Their simulation; None if there is nothing left.
    """

    jobs: list[Job]
    shapes: list[SceneShapes]
    rooms: list[Room]
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
        self.device = device
        self._meshes: dict[bytes, Any] = {}
        self._scenes: dict[int, SceneArrays] = {}
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
            Room(self.contacts.get(j.key, self._first_room), ROWS_PER_FRAME * j.frames.n_frames)
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
            size += world_bytes(jobs[k], rooms[k]) * jobs[k].n_worlds
            if size > limit and count:
                break
            count += 1
        part, playing.pending = playing.pending[:count], playing.pending[count:]
        playing.part = part
        playing.run = Launch(
            self.device,
            [jobs[k] for k in part],
            [self._scene(jobs[k].key, shapes[k]) for k in part],
            [rooms[k] for k in part],
        )
        launched = time.perf_counter()
        playing.run.launch(next(self._streams))
        self.seconds["load"] += launched - begin
        self.seconds["run"] += time.perf_counter() - launched

    def _collect(self, playing: Playing, buffer: Buffer) -> None:
        """Reads what was launched; jobs that need more room are granted it and stay pending."""
        begin = time.perf_counter()
        run, part, jobs, rooms = playing.run, playing.part, playing.jobs, playing.rooms
        assert run is not None
        needed = run.needs()
        ran = time.perf_counter()
        again: list[int] = []
        for k, room in zip(part, needed, strict=True):
            if room != rooms[k]:
                rooms[k] = room
                self.contacts[jobs[k].key] = room.contacts
                again.append(k)
        done = [i for i, k in enumerate(part) if k not in again]
        for i, played in zip(done, run.collect(done, buffer), strict=True):
            playing.out[part[i]] = played
        playing.pending = again + playing.pending
        self.seconds["run"] += ran - begin
        self.seconds["read"] += time.perf_counter() - ran

    def _scene(self, key: int, shapes: SceneShapes) -> SceneArrays:
        """A scene's own arrays; kept for the next call."""
        if key not in self._scenes:
            self._scenes[key] = SceneArrays(shapes, self.device, self._meshes)
        return self._scenes[key]

    def forget(self, key: int) -> None:
        """Drops what is kept of a scene."""
        self._scenes.pop(key, None)
