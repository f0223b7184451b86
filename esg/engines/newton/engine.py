"""Reference engine: Newton's Steel solver, all worlds of a batch in one model."""

from __future__ import annotations

from collections import OrderedDict, defaultdict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from threading import RLock

import numpy as np
from numpy.typing import NDArray

from esg.engines.base import VERIFY_DT_S
from esg.engines.breaking import brittle
from esg.engines.breaking.stances import stances
from esg.engines.jobs import Job, Played, finish, job_of
from esg.engines.newton.builder import Drafts
from esg.engines.newton.model import NewtonModel, Points
from esg.engines.newton.setup import ITERATIONS, cpu_threads, known_device
from esg.engines.program import ProgramBatch
from esg.engines.scene import Rollout, SimScene, Variation
from esg.engines.shapes import SceneShapes
from esg.engines.worlds import Start, moving

Worlds = NDArray[np.int64]

POINTS = Points(world=10, body=4, shape=1, rounded=False)
"""Room for contact points. Thirty kernels a step visit all of it, at 15 ns each on the CPU. None of
72 scenes of the suites and of other prompts needed more, where four for each shape left three
quarters unused."""
MAX_MODELS = 12
"""Compiled models kept; the least recently used one is dropped."""

MAX_WORLDS_CPU = 128
MIN_WORLDS_PER_THREAD = 8
"""Fewer do not pay for a thread: each needs a model of its own, which takes as long to build as
four crowded worlds take to play."""
MAX_WORLDS_CUDA = 16384
_BUCKETS = (1, 4, 8, 16, 32, 64, 128)

MAX_GROWTH = 64

_lock = RLock()
_growth: dict[object, int] = {}
"""Of structures that needed more room, those found last: one has all vertices of its hulls."""
_models: OrderedDict[object, NewtonModel] = OrderedDict()


class NewtonEngine:
    """Newton 1.8, solver Steel (see `esg.engines.base.Engine`).

    On the CPU a batch is split over as many threads as there are cores, at most four; the
    environment variable ESG_THREADS sets another number. The split does not change results.

    Args:
        device: Warp device: "cpu" or "cuda:0".

    Raises:
        UserError: If the device does not exist.
    """

    name = "newton"

    def __init__(self, device: str = "cpu") -> None:
        self.device = known_device(device, "Newton")
        self.threads = cpu_threads() if device == "cpu" else 1

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
        """Simulates all worlds of the batch at once (`Engine.rollout`)."""
        import newton

        start = Start.of(
            scene, batch, dt=dt, record_every=record_every, duration=duration, variation=variation
        )
        # Poses of what stands still are computed from what was given, not from rounded numbers.
        job = replace(
            job_of(self.name, 0, start, None, ground_contacts=ground_contacts),
            position=start.values.position,
            quaternion=start.values.quaternion,
        )
        order = np.nonzero(start.valid)[0] if moving(scene).any() else np.zeros(0, np.int64)
        most = MAX_WORLDS_CUDA
        if self.device == "cpu":
            share = -(-len(order) // self.threads)
            most = int(np.clip(share, MIN_WORLDS_PER_THREAD, MAX_WORLDS_CPU))
        parts = [order[k : k + most] for k in range(0, len(order), most)]
        extra = {
            "version": newton.__version__,
            "solver": "Steel",
            "iterations": ITERATIONS,
            "device": self.device,
        }
        done: list[tuple[Worlds, Played]] = []
        # Models are shared by all callers in the process, and one model serves one batch at a time.
        with _lock:
            for k in range(0, len(parts), self.threads):
                done += _simulate(job, scene, parts[k : k + self.threads], self.device)
        return finish(self.name, start, done, extra)


def _simulate(
    job: Job, scene: SimScene, parts: list[Worlds], device: str
) -> list[tuple[Worlds, Played]]:
    """Simulates groups of worlds side by side, one thread and model each.

    Warp's kernels are serial on the CPU but release the interpreter's lock.
    """
    structure = structure_key(scene)
    growth = _growth.get(structure, 1)
    while True:
        models = [_model(scene, len(w), device, k, growth) for k, w in enumerate(parts)]
        # Models are loaded one by one, since that may compile kernels.
        plays = [_Play(m, job, w) for m, w in zip(models, parts, strict=True)]
        if len(parts) == 1:
            played = [plays[0].finish()]
        else:
            with ThreadPoolExecutor(len(parts)) as pool:
                played = list(pool.map(_Play.finish, plays))
        if growth >= MAX_GROWTH or not any(p.full for p in plays):
            return list(zip(parts, played, strict=True))
        # Contacts were dropped: simulate again with more room, and remember it.
        growth *= 2
        _growth[structure] = growth
        while len(_growth) > MAX_MODELS:
            _growth.pop(next(iter(_growth)), None)


class _Play:
    """A group of worlds on its way: the model is loaded, and `finish` plays it."""

    def __init__(self, model: NewtonModel, job: Job, worlds: Worlds) -> None:
        self.n = len(worlds)
        # Surplus worlds of the bucket repeat the first one.
        slots = np.concatenate([worlds, np.full(model.n_worlds - self.n, worlds[0])])
        self._pieces = model.play([job.of_worlds(slots)], None, defaultdict(float))
        self.full = False
        next(self._pieces)

    def finish(self) -> Played:
        while True:
            try:
                next(self._pieces)
            except StopIteration as end:
                (played,), full = end.value
                self.full = bool(full.any())
                return played.first(self.n)


def structure_key(scene: SimScene) -> tuple[object, ...]:
    """What a compiled model depends on; scenes with equal keys share one."""
    bodies = tuple((b.static, b.wheeled, b.shapes) for b in scene.bodies)
    joints = (scene.joints, scene.names) if scene.joints else ()
    breaks = tuple(
        (b.name, b.break_impulse, (b.fragments, b.postures), b.position, b.quaternion)
        for b in scene.bodies
    )
    return bodies, tuple(scene.gravity), joints, breaks if brittle(scene) or stances(scene) else ()


def _model(scene: SimScene, n_worlds: int, device: str, part: int, growth: int) -> NewtonModel:
    size = next((b for b in _BUCKETS if b >= n_worlds), None)
    if size is None:
        size = 1 << (n_worlds - 1).bit_length()
    key = (structure_key(scene), size, device, part, growth)
    if key in _models:
        _models.move_to_end(key)
        return _models[key]
    while len(_models) >= MAX_MODELS:
        _models.popitem(last=False)
    wanted, shapes = ((0, size, growth),), [SceneShapes.of(scene)]
    blueprint = Drafts(keep=False).take(wanted, shapes)
    _models[key] = NewtonModel(wanted, shapes, blueprint, device, POINTS, ground=True)
    return _models[key]


def clear_cache() -> None:
    """Drops all compiled models and their memory."""
    with _lock:
        _models.clear()
        _growth.clear()
