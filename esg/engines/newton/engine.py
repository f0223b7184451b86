"""Reference engine: Newton's Steel solver, all worlds of a batch in one model."""

from __future__ import annotations

from collections import OrderedDict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from threading import RLock
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.base import VERIFY_DT_S
from esg.engines.newton.model import NewtonModel, structure_key
from esg.engines.newton.setup import ITERATIONS, cpu_threads, known_device
from esg.engines.program import ProgramBatch
from esg.engines.scene import ContactLog, Rollout, SimScene, Variation
from esg.engines.worlds import MAX_SPEED_MPS, Frames, Start, Values, join_logs

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
        logs: list[ContactLog] = []
        order = np.nonzero(start.valid)[0]
        most = MAX_WORLDS_CUDA
        if self.device == "cpu":
            share = -(-len(order) // self.threads)
            most = int(np.clip(share, MIN_WORLDS_PER_THREAD, MAX_WORLDS_CPU))
        job = _Job(start, ground_contacts, self.device)
        parts = [order[k : k + most] for k in range(0, len(order), most)]
        # Models are shared by all callers in the process, and one model serves one batch at a time.
        with _lock:
            for k in range(0, len(parts), self.threads):
                logs += job.run(parts[k : k + self.threads])
        log = join_logs(logs)
        keep = np.lexsort((log.b, log.a, log.frame, log.world))
        extra = {
            "version": newton.__version__,
            "solver": "Steel",
            "iterations": ITERATIONS,
            "device": self.device,
        }
        ordered = ContactLog(**{n: getattr(log, n)[keep] for n in log.__dataclass_fields__})
        return start.rollout(self.name, ordered, extra)


@dataclass(frozen=True)
class _Job:
    """One rollout; the arrays of its start are written in place."""

    start: Start
    ground_contacts: bool
    device: str

    def run(self, parts: list[NDArray[np.int64]]) -> list[ContactLog]:
        """Simulates groups of worlds side by side, one thread and model each.

        Warp's kernels are serial on the CPU but release the interpreter's lock.
        """
        structure = structure_key(self.start.scene)
        growth = _growth.get(structure, 1)
        while True:
            models = [self._load(worlds, k, growth) for k, worlds in enumerate(parts)]
            if len(parts) == 1:
                logs = [self._play(models[0], parts[0])]
            else:
                with ThreadPoolExecutor(len(parts)) as pool:
                    logs = list(pool.map(self._play, models, parts))
            if growth >= MAX_GROWTH or not any(m.overflowed() for m in models):
                return [log for part in logs for log in part]
            # Contacts were dropped: simulate again with more room, and remember it.
            growth *= 2
            _growth[structure] = growth

    def _load(self, worlds: NDArray[np.int64], part: int, growth: int) -> NewtonModel:
        start, b = self.start, self.start.batch
        model = _model(start.scene, len(worlds), self.device, part, growth)
        # Surplus worlds of the bucket repeat the first one.
        slots = np.concatenate([worlds, np.full(model.n_worlds - len(worlds), worlds[0])])
        model.load(
            start.scene,
            Values(**{n: getattr(start.values, n)[slots] for n in Values.__dataclass_fields__}),
            ProgramBatch(b.kind, b.body, b.until, b.table[slots], b.duration),
            start.frames.dt,
            start.frames.record_every,
            self.ground_contacts,
        )
        model.prepare()
        return model

    def _play(self, model: NewtonModel, worlds: NDArray[np.int64]) -> list[ContactLog]:
        w, moving, frames = len(worlds), model.moving, self.start.frames
        ends = np.full(w, frames.n_frames)
        logs: list[ContactLog] = []
        if len(moving) == 0:
            return logs
        position, quaternion, linear, angular = self.start.states
        for first in range(0, frames.n_frames - 1, model.chunk_frames):
            n = min(model.chunk_frames, frames.n_frames - 1 - first)
            chunk = model.run_chunk(first, n)
            pose = chunk["pose"][:, :w].swapaxes(0, 1)
            velocity = chunk["velocity"][:, :w].swapaxes(0, 1)
            rows = np.ix_(worlds, np.arange(first + 1, first + 1 + n), moving)
            position[rows], quaternion[rows] = pose[..., :3], pose[..., 3:]
            linear[rows], angular[rows] = velocity[..., :3], velocity[..., 3:]
            bad = _bad(pose, velocity)
            first_bad = np.where(bad.any(1), first + 1 + bad.argmax(1), frames.n_frames)
            ends = np.minimum(ends, first_bad)
            logs.append(_log(chunk, model, frames, first, worlds, ends))
        self.start.valid[worlds] = ends >= frames.n_frames
        for k in np.nonzero(ends < frames.n_frames)[0]:
            for array in self.start.states:
                array[worlds[k], ends[k] :] = array[worlds[k], ends[k] - 1]
        return logs


def _bad(pose: NDArray[np.float32], velocity: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Frames, shape [W, F], with a value that is not finite or a speed above 500 m/s."""
    with np.errstate(invalid="ignore", over="ignore"):
        fast = (velocity[..., :3].astype(float) ** 2).sum(-1) > MAX_SPEED_MPS**2
    broken = ~(np.isfinite(pose).all(-1) & np.isfinite(velocity).all(-1))
    return (fast | broken).any(-1)


def _log(
    chunk: dict[str, NDArray[Any]],
    model: NewtonModel,
    frames: Frames,
    start: int,
    worlds: NDArray[np.int64],
    ends: NDArray[np.int64],
) -> ContactLog:
    """Sparse rows of a chunk's dense pair sums; nothing is logged from a world's bad frame on."""
    from esg.engines.newton.kernels import FIXED_POINT

    frame, world, pair = np.nonzero(chunk["impulse"][:, : len(worlds)] > 0)
    alive = start + 1 + frame < ends[world]
    frame, world, pair = frame[alive], world[alive], pair[alive]
    impulse = chunk["impulse"][frame, world, pair].astype(float)
    moments = chunk["moments"][frame, world, pair].astype(float) / impulse[:, None]
    normal = moments[:, 3:]
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    bodies = model.pairs[pair] - 1
    ground = bodies[:, 0] < 0
    return ContactLog(
        world=worlds[world].astype(np.int32),
        frame=(start + 1 + frame).astype(np.int32),
        a=np.where(ground, bodies[:, 1], bodies[:, 0]).astype(np.int32),
        b=np.where(ground, -1, bodies[:, 1]).astype(np.int32),
        time=(chunk["first"][frame, world, pair] + 1) * frames.dt,
        impulse=impulse / FIXED_POINT,
        depth=np.maximum(chunk["depth"][frame, world, pair].astype(float), 0.0),
        point=moments[:, :3],
        normal=normal / np.where(length > 0.0, length, 1.0),
    )


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
    _models[key] = NewtonModel(scene, size, device, growth)
    return _models[key]


def clear_cache() -> None:
    """Drops all compiled models and their memory."""
    with _lock:
        _models.clear()
        _growth.clear()
