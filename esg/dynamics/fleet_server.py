"""The process that simulates: gathers the jobs of all crews and plays them together."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import partial
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.fleet_crew import MAX_VARIANTS
from esg.dynamics.panel import REFERENCE_DT_S
from esg.dynamics.simulate import ENSEMBLE
from esg.engines.base import SURROGATE
from esg.engines.fleet_arena import Buffer
from esg.engines.fleet_jobs import Expected, Job, Played, SceneShapes
from esg.graph.models import EsgDocument

STATE_BYTES = 56
"""Of one body in one frame of a result."""


@dataclass
class Clock:
    """Where the time of `optimize_many` went.

    Args:
        seconds: Wall clock of the simulating process by part: surrogate, newton, and of these
            load, run and read; newton_build, newton_ahead (built while a GPU played the
            surrogate), wait (for the processes beside it).
        processor: Seconds of the other processes by part: plans, jobs, results, and search
            (programs, losses and decisions).
        launches: Engine, scenes, worlds and seconds of every launch.
        waits: Seconds of every wait for the other processes.
        progress: Is told of every launch.
    """

    seconds: dict[str, float] = field(default_factory=dict)
    processor: dict[str, float] = field(default_factory=dict)
    launches: list[dict[str, Any]] = field(default_factory=list)
    waits: list[float] = field(default_factory=list)
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
        self.pending: list[_Asked] = []
        self.results: list[EsgDocument | None] = []
        self._engines: dict[str, Any] = {}

    def run(self, crews: Sequence[Any], n: int, shifts: int) -> list[EsgDocument]:
        """Serves until all scenes are done.

        Args:
            crews: Of which each has a part of every shift.
            n: Number of scenes.
            shifts: Parts in which the scenes begin.
        """
        self.results[:], left = [None] * n, n
        self.pending.clear()
        everybody = range(len(crews))
        # What a shift got is read while the next one's jobs are played: nothing is written over.
        buffer = Buffer(self.memory)
        expected: list[Expected] = []
        for k in range(shifts):
            left -= self._gather(crews, everybody)
            served = self._choose(buffer, SURROGATE)
            expected += [_confirmation(a.job) for a in served if _is_first(a.job)]
            ahead = partial(self._build_ahead, expected, k == shifts - 1)
            self._answer(crews, served, self._play(served, buffer, ahead), everybody)
        waiting: Iterable[int] = everybody
        while left:
            left -= self._gather(crews, waiting)
            if left:
                buffer = Buffer(self.memory)
                served = self._choose(buffer)
                waiting = self._answer(crews, served, self._play(served, buffer))
        for crew in crews:
            for part, seconds in crew.parts.items():
                total = self.clock.processor.get(part, 0.0)
                self.clock.processor[part] = total + seconds
        for name, engine in self._engines.items():
            for part, seconds in getattr(engine, "seconds", {}).items():
                self.clock.add(f"{name}_{part}", seconds)
        return [r for r in self.results if r is not None]

    def _gather(self, crews: Sequence[Any], waiting: Iterable[int]) -> int:
        """Waits for the jobs and results of some crews; returns the number of results."""
        begin = time.perf_counter()
        ended = 0
        for c in sorted(waiting):
            jobs, finished = crews[c].gather()
            for number, job in jobs:
                if job.shapes is not None:
                    self.shapes[job.key] = job.shapes
                self.pending.append(_Asked(c, number, job))
            for index, result in finished:
                if isinstance(result, Exception):
                    raise result
                self.results[index] = result
                ended += 1
        self.clock.waits.append(time.perf_counter() - begin)
        self.clock.add("wait", self.clock.waits[-1])
        return ended

    def _choose(self, buffer: Buffer, only: str | None = None) -> list[_Asked]:
        """Takes what is played next: the surrogate's jobs before Newton's, as many as fit."""
        pending = sorted(
            self.pending, key=lambda a: (a.job.engine != SURROGATE, a.job.key, a.number)
        )
        engine = only or pending[0].job.engine
        room, count = int(0.9 * len(self.memory)) - buffer.used, 0
        for asked in pending:
            room -= asked.bytes(self.shapes[asked.job.key])
            if asked.job.engine != engine or (room < 0 and (count or buffer.used)):
                break
            count += 1
        self.pending = pending[count:]
        return pending[:count]

    def _answer(
        self,
        crews: Sequence[Any],
        served: Sequence[_Asked],
        played: Sequence[Played],
        everybody: Iterable[int] = (),
    ) -> Iterable[int]:
        """Gives crews the results of their jobs, `everybody` even if there are none.

        Returns:
            Those who got an answer.
        """
        answers: dict[int, dict[int, Played]] = {c: {} for c in everybody}
        for asked, result in zip(served, played, strict=True):
            answers.setdefault(asked.crew, {})[asked.number] = result
        for c, answer in answers.items():
            crews[c].answer(answer)
        return answers

    def _build_ahead(self, expected: Sequence[Expected], complete: bool) -> None:
        """Lets Newton build what the first confirmations need, while a GPU plays the surrogate."""
        begin = time.perf_counter()
        shapes = [self.shapes[e.key] for e in expected]
        self._engine("newton").expect(expected, shapes, complete=complete)
        self.clock.add("newton_ahead", time.perf_counter() - begin)

    def _play(
        self,
        served: Sequence[_Asked],
        buffer: Buffer,
        meanwhile: Callable[[], None] | None = None,
    ) -> list[Played]:
        if not served:
            return []
        begin = time.perf_counter()
        jobs = [a.job for a in served]
        shapes = [self.shapes[j.key] for j in jobs]
        name = jobs[0].engine
        options = {"meanwhile": meanwhile} if name == SURROGATE else {}
        played = self._engine(name).play(jobs, shapes, buffer, **options)
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


def _is_first(job: Job) -> bool:
    """Whether this is a scene's preview at the reference engine's step."""
    return job.key % MAX_VARIANTS == 0 and job.frames.dt == REFERENCE_DT_S


def _confirmation(job: Job) -> Expected:
    """What a scene will ask Newton for: its best candidate under the ensemble."""
    return Expected(job.key, len(ENSEMBLE), job.frames)
