"""Many scenes at once: their searches run side by side and share every launch of the engines.

Each scene is searched by the very code that searches a single one (`search`, `batched`). Only its
engines differ: a rollout is a job that is handed in, and the search waits until all scenes that are
still searching have handed in theirs. Then one launch of the surrogate plays all candidates of all
scenes; when no scene asks for the surrogate any more, one Newton model plays what is left to
confirm. Python's share (plans, programs, losses) is spread over processes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
import mmap
import multiprocessing
import os
from threading import Condition, Event, Lock, Thread
import time
import traceback
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.baselines import BASELINES
from esg.dynamics.search import MAX_ROUNDS, optimize
from esg.engines.base import SURROGATE, VERIFY_DT_S
from esg.engines.fleet_jobs import Job, Played, SceneShapes, make_job, read
from esg.engines.program import ProgramBatch
from esg.engines.scene import Rollout, SimScene, Variation
from esg.graph.models import EsgDocument
from esg.outcomes import UserError

STRATEGIES = ("batched", "fd", "none", *BASELINES)
BUFFER_BYTES = {"cpu": 1_000_000_000, "cuda": 16_000_000_000}
MAX_VARIANTS = 64
"""Of one document's scene: their keys are this far apart."""
TOUCHED_BYTES = 2_000_000
"""Usual size of the first results of a scene."""
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


def optimize_many(
    docs: Sequence[EsgDocument],
    seeds: Sequence[int],
    *,
    device: str = "cpu",
    strategy: str = "batched",
    max_rounds: int = MAX_ROUNDS,
    processes: int = 1,
    clock: Clock | None = None,
) -> list[EsgDocument]:
    """Grounds the timelines of many documents together; see `esg.dynamics.optimize`.

    Args:
        docs: Documents with assets and layout.
        seeds: One per document.
        device: Where the engines run.
        strategy: As for single scenes, except those that differentiate the surrogate.
        max_rounds: As for single scenes.
        processes: That plan, compile and measure beside the one that simulates; 1 for none.
        clock: Is told where the time went.

    Returns:
        The documents with `dynamics_result`, in order: found by the same decisions as if each had
        been optimized alone. The surrogate gives the same bytes; Newton does, too, on the CPU,
        unless a more crowded scene in the batch makes its solver add up in another order.

    Raises:
        UserError: For an unknown strategy, or as many seeds as documents are not given.
    """
    if strategy not in STRATEGIES:
        raise UserError(f"unknown strategy {strategy!r}; many at once: {', '.join(STRATEGIES)}")
    if len(seeds) != len(docs):
        raise UserError(f"{len(docs)} documents need as many seeds, not {len(seeds)}")
    if not docs:
        return []
    kind = "cpu" if device == "cpu" else "cuda"
    task = _Task(tuple(docs), tuple(seeds), strategy, max_rounds)
    indices = np.arange(len(docs))
    memory = _memory(BUFFER_BYTES[kind], shared=processes > 1)
    crews: list[Any]
    if processes > 1:
        parts = [indices[k::processes] for k in range(min(processes, len(docs)))]
        crews = [_Remote(task, part, memory) for part in parts]
    else:
        crews = [_Crew(task, indices, memory)]
    if processes > 1:
        size = min(len(memory), TOUCHED_BYTES * len(docs))
        Thread(target=_touch, args=(memory[:size],), daemon=True).start()
    try:
        return _Server(device, memory, clock or Clock()).run(crews, len(docs))
    finally:
        for crew in crews:
            crew.close()


@dataclass(frozen=True)
class _Task:
    docs: tuple[EsgDocument, ...]
    seeds: tuple[int, ...]
    strategy: str
    max_rounds: int


def _memory(size: int, *, shared: bool) -> NDArray[np.uint8]:
    """Memory for results; pages exist from their first use on."""
    if not shared:
        return np.zeros(size, np.uint8)
    return np.frombuffer(mmap.mmap(-1, size), np.uint8)


def _touch(memory: NDArray[np.uint8]) -> None:
    """Lets pages exist before they are needed, while the processes plan their scenes."""
    # Reading is enough, and harmless to what has been written already.
    np.add.reduce(memory[:: mmap.PAGESIZE], dtype=np.int64)


# -- a scene ---------------------------------------------------------------------------------------


class _Ticket:
    """A job on its way."""

    def __init__(self, job: Job) -> None:
        self.job = job
        self.done = Event()
        self.played: Played | None = None


class _Scenes:
    """The physical scenes of one document (as it is, with other proxies) and their keys."""

    def __init__(self, index: int) -> None:
        self._index = index
        self._known: dict[int, tuple[SimScene, int, SceneShapes]] = {}

    def of(self, scene: SimScene) -> tuple[int, SceneShapes]:
        if id(scene) not in self._known:
            # Keeping the scene keeps its id from being given to another.
            key = self._index * MAX_VARIANTS + len(self._known)
            self._known[id(scene)] = (scene, key, SceneShapes.of(scene))
        return self._known[id(scene)][1:]


class _FleetEngine:
    """An engine whose rollouts are played together with those of other scenes."""

    def __init__(self, name: str, crew: _Crew, scenes: _Scenes) -> None:
        self.name = name
        self._crew, self._scenes = crew, scenes

    def rollout(
        self,
        scene: SimScene,
        batch: ProgramBatch,
        *,
        dt: float = VERIFY_DT_S,
        record_every: int = 1,
        duration: float | None = None,
        variation: Variation | None = None,
        ground_contacts: bool = False,
    ) -> Rollout:
        """Hands the rollout in and waits for its result (`Engine.rollout`)."""
        if duration is not None or ground_contacts:
            raise ValueError("searches ask for whole programs and no contacts with the ground")
        begin = time.process_time()
        key, shapes = self._scenes.of(scene)
        job, start = make_job(
            self.name, key, scene, shapes, batch,
            dt=dt, record_every=record_every, variation=variation,
        )  # fmt: skip
        middle = time.process_time()
        played = self._crew.ask(job)
        again = time.process_time()
        rollout = read(job, start, played)
        self._crew.spent("jobs", middle - begin)
        self._crew.spent("results", time.process_time() - again)
        return rollout

    def together(self, calls: Sequence[Callable[[], Any]]) -> list[Any]:
        """Results of calls whose rollouts do not depend on each other."""
        return self._crew.together(calls)


def _optimize(task: _Task, index: int, crew: _Crew) -> EsgDocument:
    scenes = _Scenes(index)
    return optimize(
        task.docs[index],
        seed=task.seeds[index],
        strategy=task.strategy,
        max_rounds=task.max_rounds,
        engines=lambda name, _: _FleetEngine(name, crew, scenes),
    )


# -- the scenes of a process -----------------------------------------------------------------------


class _Crew:
    """Searches of some scenes, one thread each, of which one runs at a time.

    Args:
        task: All documents.
        indices: Those of this crew.
        memory: Where results are.
    """

    def __init__(self, task: _Task, indices: NDArray[np.int64], memory: NDArray[np.uint8]) -> None:
        self.memory = memory
        self._lock, self._turn = Condition(), Lock()
        self._running = len(indices)
        self._asked: list[_Ticket] = []
        self._finished: list[tuple[int, EsgDocument | Exception]] = []
        self._waiting: dict[int, _Ticket] = {}
        self._next = 0
        self._sent: set[int] = set()
        self.parts: dict[str, float] = {}
        self._threads = [
            Thread(target=self._search, args=(task, int(i)), daemon=True) for i in indices
        ]
        for thread in self._threads:
            thread.start()

    def _search(self, task: _Task, index: int) -> None:
        result: EsgDocument | Exception
        with self._turn:
            try:
                result = _optimize(task, index, self)
            except Exception as error:
                error.add_note(traceback.format_exc())
                result = error
        with self._lock:
            self._finished.append((index, result))
            self._running -= 1
            self._lock.notify_all()

    def spent(self, part: str, seconds: float) -> None:
        """Adds processor seconds to a part."""
        self.parts[part] = self.parts.get(part, 0.0) + seconds

    def ask(self, job: Job) -> Played:
        """Hands a job in and waits until it is played; meanwhile other searches run."""
        ticket = _Ticket(job)
        with self._lock:
            self._asked.append(ticket)
            self._running -= 1
            self._lock.notify_all()
        self._turn.release()
        ticket.done.wait()
        self._turn.acquire()
        assert ticket.played is not None
        return ticket.played

    def together(self, calls: Sequence[Callable[[], Any]]) -> list[Any]:
        """Makes calls that may ask, all of which may wait at the same time."""
        results: list[Any] = [None] * len(calls)
        errors: list[Exception] = []
        left, over = len(calls), Event()

        def make(k: int) -> bool:
            """Makes a call; true if it was the last one, which goes on in the caller's place."""
            nonlocal left
            try:
                results[k] = calls[k]()
            except Exception as error:
                errors.append(error)
            with self._lock:
                left -= 1
                if left:
                    self._running -= 1
                    self._lock.notify_all()
                    return False
            over.set()
            return True

        def helper(k: int) -> None:
            with self._turn:
                make(k)

        with self._lock:
            self._running += len(calls) - 1
        for k in range(1, len(calls)):
            Thread(target=helper, args=(k,), daemon=True).start()
        if not make(0):
            self._turn.release()
            over.wait()
            self._turn.acquire()
        if errors:
            raise errors[0]
        return results

    def gather(self) -> tuple[list[tuple[int, Job]], list[tuple[int, Any]]]:
        """Waits until every search has asked or ended: new jobs with numbers, and results."""
        with self._lock:
            while self._running:
                self._lock.wait()
            jobs: list[tuple[int, Job]] = []
            for ticket in self._asked:
                self._waiting[self._next] = ticket
                # A scene's shapes travel once.
                known = ticket.job.key in self._sent
                self._sent.add(ticket.job.key)
                job = replace(ticket.job, shapes=None) if known else ticket.job
                jobs.append((self._next, job))
                self._next += 1
            finished, self._asked, self._finished = self._finished, [], []
            return jobs, finished

    def answer(self, played: dict[int, Played]) -> None:
        """Lets the searches go on whose jobs have been played."""
        with self._lock:
            self._running += len(played)
        for number, result in played.items():
            ticket = self._waiting.pop(number)
            ticket.played = result
            ticket.done.set()

    def close(self) -> None:
        """Threads are daemons; those that wait end with the process."""


# -- crews of other processes ----------------------------------------------------------------------


def _crew_process(task: _Task, indices: Any, memory: Any, pipe: Any) -> None:
    try:
        begin = time.process_time()
        crew = _Crew(task, indices, memory)
        while True:
            jobs, finished = crew.gather()
            crew.parts["all"] = time.process_time() - begin
            pipe.send((jobs, finished, crew.parts))
            answer = pipe.recv()
            if answer is None:
                break
            crew.answer({n: _rebuild(p, memory) for n, p in answer.items()})
    finally:
        pipe.close()
        # Nothing of the parent's, such as a GPU's context, is to be torn down here.
        os._exit(0)


class _Remote:
    """A crew in a process of its own."""

    def __init__(self, task: _Task, indices: Any, memory: NDArray[np.uint8]) -> None:
        context = multiprocessing.get_context("fork")
        self.memory = memory
        self.pipe, there = context.Pipe()
        self.parts: dict[str, float] = {}
        self.process = context.Process(
            target=_crew_process, args=(task, indices, memory, there), daemon=True
        )
        self.process.start()
        there.close()

    def gather(self) -> tuple[list[tuple[int, Job]], list[tuple[int, Any]]]:
        jobs, finished, self.parts = self.pipe.recv()
        return jobs, finished

    def answer(self, played: dict[int, Played]) -> None:
        self.pipe.send({n: _located(p, self.memory) for n, p in played.items()})

    def close(self) -> None:
        with suppress(OSError):
            self.pipe.send(None)
        self.process.join(5.0)
        if self.process.is_alive():
            self.process.terminate()
        self.pipe.close()


_STATES = ("position", "quaternion", "linear", "angular")


def _located(p: Played, memory: NDArray[np.uint8]) -> Any:
    """A result whose states are named by where they lie in the shared memory."""
    base = memory.__array_interface__["data"][0]
    places = []
    for name in _STATES:
        a = getattr(p, name)
        places.append((a.__array_interface__["data"][0] - base, a.shape, a.strides))
    return places, p.end, p.deepest, p.log


def _rebuild(sent: Any, memory: NDArray[np.uint8]) -> Played:
    places, end, deepest, log = sent
    x, r, v, o = (
        np.ndarray(shape, np.float32, buffer=memory, offset=at if np.prod(shape) else 0,
                   strides=strides)
        for at, shape, strides in places
    )  # fmt: skip
    return Played(x, r, v, o, end, deepest, log)


# -- the simulating process ------------------------------------------------------------------------


@dataclass
class _Asked:
    """A job of a crew that waits to be played."""

    crew: int
    number: int
    job: Job

    def bytes(self, shapes: SceneShapes) -> int:
        moving = int(shapes.dynamic.sum())
        return self.job.n_worlds * self.job.frames.n_frames * moving * STATE_BYTES


class _Server:
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
