"""The process that simulates: gathers the jobs of all crews and plays them together."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.fleet.crew import MAX_VARIANTS
from esg.dynamics.search import REFERENCE_DT_S
from esg.dynamics.search.simulate import ENSEMBLE
from esg.engines.base import SURROGATE
from esg.engines.jobs import Buffer, Expected, Job, Pieces, Played
from esg.engines.shapes import SceneShapes
from esg.graph.models import EsgDocument

STATE_BYTES = 56
"""Of one body in one frame of a result."""


@dataclass
class Clock:
    """Where the time of `optimize_many` went.

    Args:
        seconds: Wall clock of the simulating process by part: surrogate, newton, and of these
            load, run and read; newton_build, newton_ahead (built while a GPU played the
            surrogate), newton_beside (played piece by piece in the meantime), wait (for the
            processes beside it).
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


@dataclass
class _Beside:
    """Jobs that Newton plays piece by piece while a GPU plays the surrogate.

    Args:
        served: The jobs.
        pieces: Of their simulation.
        played: The results, once there are any.
        seconds: Wall clock of the pieces.
    """

    served: list[_Asked]
    pieces: Pieces[list[Played]]
    played: list[Played] | None = None
    seconds: float = 0.0

    def advance(self) -> bool:
        """Plays another piece; false when there is none left."""
        begin = time.perf_counter()
        try:
            next(self.pieces)
        except StopIteration as end:
            self.played = end.value
        self.seconds += time.perf_counter() - begin
        return self.played is None


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
        self._beside: _Beside | None = None

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
        self._beside = None
        left -= self._begin(crews, shifts)
        half = len(self.memory) // 2
        waiting: Iterable[int] = everybody
        while left:
            left -= self._gather(crews, waiting)
            if not left:
                break
            if waiting is everybody:
                self._begin_beside(Buffer(self.memory[half:]))
            served, played = self._step(half)
            waiting = self._answer(crews, served, played)
        for crew in crews:
            for part, seconds in crew.parts.items():
                total = self.clock.processor.get(part, 0.0)
                self.clock.processor[part] = total + seconds
        for name, engine in self._engines.items():
            for part, seconds in getattr(engine, "seconds", {}).items():
                self.clock.add(f"{name}_{part}", seconds)
        return [r for r in self.results if r is not None]

    def _begin(self, crews: Sequence[Any], shifts: int) -> int:
        """Plays the first candidates, a shift of scenes at a time; returns how many have ended.

        A GPU is given a shift while it still plays the one before: few worlds take long, and only
        in the end there is room beside them.
        """
        everybody = range(len(crews))
        # What a shift got is read while the next one's jobs are played: nothing is written over.
        buffer = Buffer(self.memory)
        expected: list[Expected] = []
        flights: list[tuple[list[_Asked], Any]] = []
        ended = 0
        for k in range(shifts):
            ended += self._gather(crews, everybody)
            promised = sum(a.bytes(self.shapes[a.job.key]) for f in flights for a in f[0])
            served = self._choose(buffer, SURROGATE, promised)
            begin = time.perf_counter()
            jobs, shapes = self._jobs(served)
            flights.append((served, self._engine(SURROGATE).begin(jobs, shapes)))
            self.clock.add(SURROGATE, time.perf_counter() - begin)
            expected += [_confirmation(a.job) for a in served if _is_first(a.job)]
            self._build_ahead(expected, k == shifts - 1)
            while flights and (len(flights) > 1 or k == shifts - 1):
                served, flight = flights.pop(0)
                begin = time.perf_counter()
                played = self._engine(SURROGATE).finish(flight, buffer)
                self._record(SURROGATE, served, time.perf_counter() - begin)
                self._answer(crews, served, played, everybody)
        return ended

    def _begin_beside(self, buffer: Buffer) -> None:
        """Lets Newton begin with the confirmations that are asked for, if others still explore.

        Once only: after that, what is asked for together depends on how long things take, and with
        it, on a GPU, the last bits.
        """
        if not any(a.job.engine == SURROGATE for a in self.pending):
            return
        served = self._choose(buffer, "newton")
        if served:
            jobs, shapes = self._jobs(served)
            self._beside = _Beside(served, self._engine("newton").pieces(jobs, shapes, buffer))

    def _step(self, half: int) -> tuple[list[_Asked], list[Played]]:
        """Plays something: the surrogate's jobs, what is left of Newton's beside them, Newton's."""
        beside = self._beside
        size = half if beside is not None else len(self.memory)
        buffer = Buffer(self.memory[:size])
        if not any(a.job.engine == SURROGATE for a in self.pending) and beside is not None:
            while beside.advance():
                pass
            served: list[_Asked] = []
            played: list[Played] = []
        else:
            served = self._choose(buffer)
            played = self._play(served, buffer, beside.advance if beside is not None else None)
        if beside is not None and beside.played is not None:
            self._record("newton", beside.served, beside.seconds, beside=True)
            served, played = served + beside.served, played + beside.played
            self._beside = None
        return served, played

    def _jobs(self, served: Sequence[_Asked]) -> tuple[list[Job], list[SceneShapes]]:
        jobs = [a.job for a in served]
        return jobs, [self.shapes[j.key] for j in jobs]

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

    def _choose(self, buffer: Buffer, only: str | None = None, promised: int = 0) -> list[_Asked]:
        """Takes what is played next: the surrogate's jobs before Newton's, as many as fit.

        Args:
            buffer: Where results will be put.
            only: The engine; the surrogate, if anybody asks for it, by default.
            promised: Bytes of it that others will need.
        """
        asks = {a.job.engine for a in self.pending}
        engine = only or (SURROGATE if SURROGATE in asks else "newton")
        room = int(0.9 * len(buffer.array)) - buffer.used - promised
        chosen: list[_Asked] = []
        for asked in sorted(self.pending, key=lambda a: (a.job.key, a.number)):
            if asked.job.engine != engine:
                continue
            room -= asked.bytes(self.shapes[asked.job.key])
            if room < 0 and (chosen or buffer.used or promised):
                break
            chosen.append(asked)
        taken = {id(a) for a in chosen}
        self.pending = [a for a in self.pending if id(a) not in taken]
        return chosen

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
        meanwhile: Callable[[], bool] | None = None,
    ) -> list[Played]:
        begin = time.perf_counter()
        jobs, shapes = self._jobs(served)
        name = jobs[0].engine
        options = {"meanwhile": meanwhile} if name == SURROGATE else {}
        played = self._engine(name).play(jobs, shapes, buffer, **options)
        self._record(name, served, time.perf_counter() - begin)
        return played

    def _record(
        self, name: str, served: Sequence[_Asked], seconds: float, *, beside: bool = False
    ) -> None:
        """Adds a launch to the clock.

        Args:
            name: Engine.
            served: What was played.
            seconds: Wall clock.
            beside: Whether another engine's launches went on in the meantime.
        """
        self.clock.add(f"{name}_beside" if beside else name, seconds)
        if not served:
            return
        jobs = [a.job for a in served]
        launch = {
            "engine": name,
            "scenes": len(jobs),
            "worlds": sum(j.n_worlds for j in jobs),
            "longest_s": max(j.frames.n_steps * j.frames.dt for j in jobs),
            "seconds": round(seconds, 3),
            **({"beside": True} if beside else {}),
        }
        self.clock.launches.append(launch)
        if self.clock.progress is not None:
            self.clock.progress(launch)

    def _engine(self, name: str) -> Any:
        if name not in self._engines:
            make: Callable[[str], Any]
            if name == SURROGATE:
                from esg.engines.fleet import FleetSurrogate as make
            else:
                from esg.engines.fleet import FleetNewton as make
            self._engines[name] = make(self.device)
        return self._engines[name]


def _is_first(job: Job) -> bool:
    """Whether this is a scene's preview at the reference engine's step."""
    return job.key % MAX_VARIANTS == 0 and job.frames.dt == REFERENCE_DT_S


def _confirmation(job: Job) -> Expected:
    """What a scene will ask Newton for: its best candidate under the ensemble."""
    return Expected(job.key, len(ENSEMBLE), job.frames)
