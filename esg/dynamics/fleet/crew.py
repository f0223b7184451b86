"""The searches of some scenes, one thread each, whose engines hand their rollouts in as jobs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from threading import Condition, Event, Lock, Thread
import time
import traceback
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.strategies import optimize
from esg.engines.base import VERIFY_DT_S
from esg.engines.jobs import Job, Played, make_job, read
from esg.engines.program import ProgramBatch
from esg.engines.scene import Rollout, SimScene, Variation
from esg.engines.shapes import SceneShapes
from esg.graph.models import EsgDocument

MAX_VARIANTS = 64
"""Of one document's scene: their keys are this far apart."""


@dataclass(frozen=True)
class Task:
    docs: tuple[EsgDocument, ...]
    seeds: tuple[int, ...]
    strategy: str
    max_rounds: int
    hold: bool = True
    """Whether bystanders are held still; on a GPU, which builds worlds ahead, they cost little."""
    breadth: int = 1
    """Candidates that the surrogate plays in about the time of one."""


class _Ticket:
    """A job on its way."""

    def __init__(self, job: Job, shift: int) -> None:
        self.job, self.shift = job, shift
        self.done = Event()
        self.played: Played | None = None


class _Scenes:
    """The physical scenes of one document (as it is, with other proxies) and their keys."""

    def __init__(self, index: int) -> None:
        self.index = index
        self._known: dict[int, tuple[SimScene, int, SceneShapes]] = {}

    def of(self, scene: SimScene) -> tuple[int, SceneShapes]:
        if id(scene) not in self._known:
            # Keeping the scene keeps its id from being given to another.
            key = self.index * MAX_VARIANTS + len(self._known)
            self._known[id(scene)] = (scene, key, SceneShapes.of(scene))
        return self._known[id(scene)][1:]


class _FleetEngine:
    """An engine whose rollouts are played together with those of other scenes."""

    def __init__(self, name: str, crew: Crew, scenes: _Scenes, task: Task) -> None:
        self.name = name
        self.holds, self.breadth = task.hold, task.breadth
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
        return self._crew.together(self._scenes.index, calls)


def _optimize(task: Task, index: int, crew: Crew) -> EsgDocument:
    scenes = _Scenes(index)
    return optimize(
        task.docs[index],
        seed=task.seeds[index],
        strategy=task.strategy,
        max_rounds=task.max_rounds,
        engines=lambda name, _: _FleetEngine(name, crew, scenes, task),
    )


class Crew:
    """Searches of some scenes, one thread each, of which one runs at a time.

    They begin in shifts: while the first jobs of a shift are played, the next one plans its scenes.

    Args:
        task: All documents.
        shifts: Indices of the documents of this crew, by shift.
        memory: Where results are.
    """

    def __init__(
        self, task: Task, shifts: Sequence[NDArray[np.int64]], memory: NDArray[np.uint8]
    ) -> None:
        self.memory = memory
        self._task, self._shifts = task, shifts
        self._lock, self._turn = Condition(), Lock()
        self._shift = {int(i): k for k, part in enumerate(shifts) for i in part}
        self._begun = 0
        self._running = [0 for _ in shifts]
        self._asked: list[_Ticket] = []
        self._finished: list[tuple[int, EsgDocument | Exception]] = []
        self._waiting: dict[int, _Ticket] = {}
        self._next = 0
        self._sent: set[int] = set()
        self.parts: dict[str, float] = {}

    def _begin(self) -> int:
        """Starts the searches of the next shift; returns its number."""
        k = self._begun
        self._begun += 1
        self._running[k] = len(self._shifts[k])
        for index in self._shifts[k]:
            Thread(target=self._search, args=(self._task, int(index)), daemon=True).start()
        return k

    def _search(self, task: Task, index: int) -> None:
        result: EsgDocument | Exception
        with self._turn:
            try:
                result = _optimize(task, index, self)
            except Exception as error:
                error.add_note(traceback.format_exc())
                result = error
        with self._lock:
            self._finished.append((index, result))
            self._running[self._shift[index]] -= 1
            self._lock.notify_all()

    def spent(self, part: str, seconds: float) -> None:
        """Adds processor seconds to a part."""
        self.parts[part] = self.parts.get(part, 0.0) + seconds

    def ask(self, job: Job) -> Played:
        """Hands a job in and waits until it is played; meanwhile other searches run."""
        ticket = _Ticket(job, self._shift[job.key // MAX_VARIANTS])
        with self._lock:
            self._asked.append(ticket)
            self._running[ticket.shift] -= 1
            self._lock.notify_all()
        self._turn.release()
        ticket.done.wait()
        self._turn.acquire()
        assert ticket.played is not None
        return ticket.played

    def together(self, index: int, calls: Sequence[Callable[[], Any]]) -> list[Any]:
        """Makes calls of a scene that may ask, all of which may wait at the same time."""
        shift = self._shift[index]
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
                    self._running[shift] -= 1
                    self._lock.notify_all()
                    return False
            over.set()
            return True

        def helper(k: int) -> None:
            with self._turn:
                make(k)

        with self._lock:
            self._running[shift] += len(calls) - 1
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
        """Waits until every search has asked or ended: new jobs with numbers, and results.

        The first calls start one shift each and wait for it only.
        """
        shift = self._begin() if self._begun < len(self._shifts) else None
        with self._lock:
            while any(self._running if shift is None else self._running[shift : shift + 1]):
                self._lock.wait()
            jobs: list[tuple[int, Job]] = []
            asked = [t for t in self._asked if shift is None or t.shift == shift]
            self._asked = [t for t in self._asked if t not in asked]
            for ticket in asked:
                self._waiting[self._next] = ticket
                # A scene's shapes travel once.
                known = ticket.job.key in self._sent
                self._sent.add(ticket.job.key)
                job = replace(ticket.job, shapes=None) if known else ticket.job
                jobs.append((self._next, job))
                self._next += 1
            finished, self._finished = self._finished, []
            return jobs, finished

    def answer(self, played: dict[int, Played]) -> None:
        """Lets the searches go on whose jobs have been played."""
        tickets = [(self._waiting.pop(number), result) for number, result in played.items()]
        with self._lock:
            for ticket, _ in tickets:
                self._running[ticket.shift] += 1
        for ticket, result in tickets:
            ticket.played = result
            ticket.done.set()

    def close(self) -> None:
        """Threads are daemons; those that wait end with the process."""
