"""The process that simulates: gathers the jobs of all crews and plays them together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.base import SURROGATE
from esg.engines.fleet_jobs import Job, Played, SceneShapes
from esg.graph.models import EsgDocument

STATE_BYTES = 56
"""Of one body in one frame of a result."""


@dataclass
class Clock:
    """Where the time of `optimize_many` went.

    Args:
        seconds: Wall clock of the simulating process by part: surrogate, newton, newton_build,
            wait (for the processes beside it).
        processor: Seconds of the other processes by part: plans, jobs, results, and search
            (programs, losses and decisions).
        launches: Engine, scenes, worlds and seconds of every launch.
        progress: Is told of every launch.
    """

    seconds: dict[str, float] = field(default_factory=dict)
    processor: dict[str, float] = field(default_factory=dict)
    launches: list[dict[str, Any]] = field(default_factory=list)
    progress: Callable[[dict[str, Any]], None] | None = None

    def add(self, part: str, seconds: float) -> None:
        self.seconds[part] = self.seconds.get(part, 0.0) + seconds


@dataclass
class _Asked:
    """A job of a crew that waits to be played."""

    crew: int
    number: int
    job: Job

    def bytes(self, shapes: SceneShapes) -> int:
        moving = int(shapes.dynamic.sum())
        return self.job.n_worlds * self.job.frames.n_frames * moving * STATE_BYTES


class Server:
    """Plays the jobs of all crews.

    Args:
        device: Warp device.
        memory: Where results are put.
        clock: Is told where the time goes.
    """

    def __init__(self, device: str, memory: NDArray[np.uint8], clock: Clock) -> None:
        self.device, self.memory, self.clock = device, memory, clock
        self.shapes: dict[int, SceneShapes] = {}
        self._engines: dict[str, Any] = {}

    def run(self, crews: Sequence[Any], n: int) -> list[EsgDocument]:
        """Serves until all scenes are done."""
        results: list[EsgDocument | None] = [None] * n
        pending: list[_Asked] = []
        waiting = set(range(len(crews)))
        left = n
        while True:
            begin = time.perf_counter()
            for c in sorted(waiting):
                jobs, finished = crews[c].gather()
                for number, job in jobs:
                    if job.shapes is not None:
                        self.shapes[job.key] = job.shapes
                    pending.append(_Asked(c, number, job))
                for index, result in finished:
                    if isinstance(result, Exception):
                        raise result
                    results[index] = result
                    left -= 1
            self.clock.add("wait", time.perf_counter() - begin)
            if not left:
                break
            served, pending = self._choose(pending)
            answers: dict[int, dict[int, Played]] = {}
            for asked, played in zip(served, self._play(served), strict=True):
                answers.setdefault(asked.crew, {})[asked.number] = played
            for c, answer in answers.items():
                crews[c].answer(answer)
            waiting = set(answers)
        for crew in crews:
            for part, seconds in crew.parts.items():
                total = self.clock.processor.get(part, 0.0)
                self.clock.processor[part] = total + seconds
        for name, engine in self._engines.items():
            for part, seconds in getattr(engine, "seconds", {}).items():
                self.clock.add(f"{name}_{part}", seconds)
        return [r for r in results if r is not None]

    def _choose(self, pending: list[_Asked]) -> tuple[list[_Asked], list[_Asked]]:
        """What is played next: the surrogate's jobs before Newton's, as many as results fit."""
        pending = sorted(pending, key=lambda a: (a.job.engine != SURROGATE, a.job.key, a.number))
        engine = pending[0].job.engine
        room, count = int(0.9 * len(self.memory)), 0
        for asked in pending:
            room -= asked.bytes(self.shapes[asked.job.key])
            if asked.job.engine != engine or (room < 0 and count):
                break
            count += 1
        return pending[:count], pending[count:]

    def _play(self, served: list[_Asked]) -> list[Played]:
        from esg.engines.fleet_arena import Buffer

        begin = time.perf_counter()
        jobs = [a.job for a in served]
        shapes = [self.shapes[j.key] for j in jobs]
        name = jobs[0].engine
        played = self._engine(name).play(jobs, shapes, Buffer(self.memory))
        seconds = time.perf_counter() - begin
        self.clock.add(name, seconds)
        launch = {
            "engine": name,
            "scenes": len(jobs),
            "worlds": sum(j.n_worlds for j in jobs),
            "longest_s": max(j.frames.n_steps * j.frames.dt for j in jobs),
            "seconds": round(seconds, 3),
        }
        self.clock.launches.append(launch)
        if self.clock.progress is not None:
            self.clock.progress(launch)
        return played

    def _engine(self, name: str) -> Any:
        if name not in self._engines:
            make: Callable[[str], Any]
            if name == SURROGATE:
                from esg.engines.fleet_surrogate import FleetSurrogate as make
            else:
                from esg.engines.fleet_newton import FleetNewton as make
            self._engines[name] = make(self.device)
        return self._engines[name]
