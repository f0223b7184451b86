"""The reference engine for worlds of different scenes: one Newton model for all of them.

Scenes that nobody asks for play their last job again: a smaller model would take longer to build.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
import time
from typing import Protocol

import numpy as np

from esg.engines.jobs import Buffer, Expected, Job, Pieces, Played
from esg.engines.newton.builder import Drafts, Wanted
from esg.engines.newton.engine import MAX_GROWTH
from esg.engines.newton.model import NewtonModel, Points
from esg.engines.newton.setup import quiet_warp
from esg.engines.shapes import SceneShapes
from esg.engines.worlds import Frames

MAX_WORLDS = {"cpu": 64, "cuda": 16384}
ENOUGH_WORLDS = 4000
"""With fewer worlds a step takes a GPU half a millisecond, whatever their number."""
LONGER = 1.5
"""Scenes that last longer than others by this factor wait for a pass of their own."""
CROWDS = ((6, 24), (16, 64))
"""Moving bodies and their shapes: the classes of scenes that share a pass."""
SPARE_SHARE = 0.2
"""Share of a model's scenes that must be asked for, for it to be used again."""
MODELS = 3
POINTS = Points(world=16, body=0, shape=4, rounded=True)
"""Generous: one scene that needs more lets all of them play again."""


class Pending(Protocol):
    """What decides in which pass a job is played."""

    @property
    def key(self) -> int: ...

    @property
    def n_worlds(self) -> int: ...

    @property
    def frames(self) -> Frames: ...


class FleetNewton:
    """Plays jobs of many scenes at once.

    Args:
        device: Warp device: "cpu" or "cuda:0".
        ahead: Whether `expect` builds anything; on a GPU if None, because a CPU has no time to
            spare while it simulates.
    """

    def __init__(self, device: str, *, ahead: bool | None = None) -> None:
        quiet_warp()
        self.device = device
        self.ahead = device != "cpu" if ahead is None else ahead
        self._models: list[NewtonModel] = []
        self.drafts = Drafts(keep=self.ahead)
        self._growth: dict[int, int] = {}
        self.seconds = {"build": 0.0, "load": 0.0, "run": 0.0, "read": 0.0}

    def expect(
        self, jobs: Sequence[Expected], shapes: Sequence[SceneShapes], *, complete: bool
    ) -> None:
        """Builds ahead, without the device, what jobs will need that are handed in soon.

        Args:
            jobs: In the order in which they will come.
            shapes: Their scenes.
            complete: Whether these are all that will come together.
        """
        if not self.ahead:
            return
        for job, s in zip(jobs, shapes, strict=True):
            self.drafts.world(job.key, s)
        pending = list(range(len(jobs))) if complete else []
        while pending:
            part = self._pass(pending, jobs, shapes)
            self.drafts.prepare(self._wanted([jobs[k] for k in part]), [shapes[k] for k in part])
            chosen = set(part)
            pending = [k for k in pending if k not in chosen]

    def play(self, jobs: list[Job], shapes: list[SceneShapes], buffer: Buffer) -> list[Played]:
        """Simulates all jobs; `shapes` are their scenes."""
        pieces = self.pieces(jobs, shapes, buffer)
        while True:
            try:
                next(pieces)
            except StopIteration as end:
                return end.value

    def pieces(
        self, jobs: list[Job], shapes: list[SceneShapes], buffer: Buffer
    ) -> Pieces[list[Played]]:
        """The same in pieces, between which a GPU may be asked for something else."""
        out: list[Played | None] = [None] * len(jobs)
        pending = list(range(len(jobs)))
        while pending:
            part = self._pass(pending, jobs, shapes)
            again = yield from self._play(part, jobs, shapes, buffer, out)
            chosen = set(part)
            pending = again + [k for k in pending if k not in chosen]
        return [p for p in out if p is not None]

    def _pass(
        self, pending: list[int], jobs: Sequence[Pending], shapes: Sequence[SceneShapes]
    ) -> list[int]:
        """The jobs of the next pass.

        A pass takes as long as its longest job, and the solver visits as many contacts of every
        world as its most crowded one may have: while there are many worlds, like goes with like.
        """
        most = MAX_WORLDS["cpu" if self.device == "cpu" else "cuda"]
        many = sum(jobs[k].n_worlds for k in pending) > ENOUGH_WORLDS
        # Worlds without joints share no pass with others, which would take them longer.
        size = {k: (bool(shapes[k].joints), _crowd(shapes[k]) if many else 0) for k in pending}
        order = sorted(
            pending, key=lambda k: (jobs[k].frames.dt, size[k], jobs[k].frames.n_steps, k)
        )
        part: list[int] = []
        worlds = 0
        for k in order:
            j = jobs[k]
            if part:
                first = jobs[part[0]].frames
                alike = j.frames.dt == first.dt and size[k] == size[part[0]]
                longer = j.frames.n_steps > LONGER * first.n_steps
                if not alike or worlds + j.n_worlds > most:
                    break
                if many and longer and worlds > ENOUGH_WORLDS // 2:
                    break
            part.append(k)
            worlds += j.n_worlds
        return part

    def _play(
        self,
        part: list[int],
        jobs: list[Job],
        shapes: list[SceneShapes],
        buffer: Buffer,
        out: list[Played | None],
    ) -> Pieces[list[int]]:
        """Plays some of the jobs; returns those whose contacts found no room (more is granted)."""
        begin = time.perf_counter()
        model = self._model_of([jobs[k] for k in part], [shapes[k] for k in part])
        self.seconds["build"] += time.perf_counter() - begin
        yield
        played, full = yield from model.play([jobs[k] for k in part], buffer, self.seconds)
        again: list[int] = []
        for k, p, over in zip(part, played, full, strict=True):
            growth = self._growth.get(jobs[k].key, 1)
            if over and growth < MAX_GROWTH:
                self._growth[jobs[k].key] = 2 * growth
                again.append(k)
            else:
                out[k] = p
        return again

    def _model_of(self, jobs: list[Job], shapes: list[SceneShapes]) -> NewtonModel:
        """A model that has these scenes, the last ones used or a new one.

        It may have a few more on a GPU, where building a smaller one takes longer than what
        they cost.
        """
        wanted = self._wanted(jobs)
        needed, share = Counter(wanted), 1.0 if self.device == "cpu" else SPARE_SHARE
        for model in self._models:
            enough = needed <= Counter(model.wanted)
            if enough and len(wanted) >= share * len(model.wanted):
                self._models.remove(model)
                break
        else:
            model = NewtonModel(
                wanted, shapes, self.drafts.take(wanted, shapes), self.device, POINTS
            )
        self._models = [model, *self._models[: MODELS - 1]]
        return model

    def _wanted(self, jobs: Sequence[Pending]) -> Wanted:
        return tuple((j.key, j.n_worlds, self._growth.get(j.key, 1)) for j in jobs)


def _crowd(s: SceneShapes) -> int:
    """The class of a scene: how much the solver has to visit."""
    bodies, shapes = int(s.dynamic.sum()), int(np.diff(s.first)[s.dynamic].sum())
    for k, (most_bodies, most_shapes) in enumerate(CROWDS):
        if bodies <= most_bodies and shapes <= most_shapes:
            return k
    return len(CROWDS)
