"""Reference engine: Newton's Steel solver, all worlds of a batch in one model."""

from __future__ import annotations

from collections import OrderedDict
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.base import VERIFY_DT_S
from esg.engines.newton_model import ITERATIONS, NewtonModel, quiet_warp, structure_key
from esg.engines.program import ProgramBatch
from esg.engines.scene import ContactLog, Rollout, SimScene, Variation
from esg.engines.worlds import (
    MAX_SPEED_MPS,
    Frames,
    Values,
    check,
    join_logs,
    rest_states,
    world_values,
)
from esg.outcomes import UserError

MAX_MODELS = 6
"""Compiled models kept; the least recently used one is dropped."""

MAX_WORLDS_CPU = 128
MAX_WORLDS_CUDA = 16384
_BUCKETS = (1, 8, 16, 32, 64, 128)

_models: OrderedDict[object, NewtonModel] = OrderedDict()


class NewtonEngine:
    """Newton 1.8, solver Steel (see `esg.engines.base.Engine`).

    Args:
        device: Warp device: "cpu" or "cuda:0".

    Raises:
        UserError: If the device does not exist.
    """

    name = "newton"

    def __init__(self, device: str = "cpu") -> None:
        wp = quiet_warp()
        known = [str(d) for d in wp.get_devices()]
        if device not in known:
            raise UserError(f"no device {device!r} for Newton; this machine has {', '.join(known)}")
        self.device = device

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

        check(scene, batch)
        frames = Frames.of(batch.duration if duration is None else duration, dt, record_every)
        values = world_values(scene, variation, batch.n_worlds)
        states = rest_states(values, frames)
        sound = np.isfinite(values.position).all((1, 2)) & np.isfinite(values.quaternion).all(
            (1, 2)
        )
        valid = sound.copy()
        most = MAX_WORLDS_CPU if self.device == "cpu" else MAX_WORLDS_CUDA
        logs: list[ContactLog] = []
        order = np.nonzero(sound)[0]
        for start in range(0, len(order), most):
            worlds = order[start : start + most]
            logs += self._run(scene, batch, values, frames, ground_contacts, worlds, states, valid)
        log = join_logs(logs)
        keep = np.lexsort((log.b, log.a, log.frame, log.world))
        return Rollout(
            engine=self.name,
            dt=dt,
            time=frames.time,
            position=states[0],
            quaternion=states[1],
            linear_velocity=states[2],
            angular_velocity=states[3],
            contacts=ContactLog(**{n: getattr(log, n)[keep] for n in log.__dataclass_fields__}),
            valid=valid,
            extra={
                "version": newton.__version__,
                "solver": "Steel",
                "iterations": ITERATIONS,
                "device": self.device,
            },
        )

    def _run(
        self,
        scene: SimScene,
        batch: ProgramBatch,
        values: Values,
        frames: Frames,
        ground_contacts: bool,
        worlds: NDArray[np.int64],
        states: tuple[Any, Any, Any, Any],
        valid: NDArray[np.bool_],
    ) -> list[ContactLog]:
        """Simulates some worlds and writes their rows of `states` and `valid`."""
        model = _model(scene, len(worlds), self.device)
        # Surplus worlds of the bucket repeat the first one.
        slots = np.concatenate([worlds, np.full(model.n_worlds - len(worlds), worlds[0])])
        model.load(
            scene,
            Values(**{n: getattr(values, n)[slots] for n in Values.__dataclass_fields__}),
            ProgramBatch(batch.kind, batch.body, batch.until, batch.table[slots], batch.duration),
            frames.dt,
            frames.record_every,
            ground_contacts,
        )
        w, moving = len(worlds), model.moving
        ends = np.full(w, frames.n_frames)
        logs: list[ContactLog] = []
        if len(moving) == 0:
            return logs
        columns = np.ix_(worlds, np.arange(1), moving)
        for start in range(0, frames.n_frames - 1, model.chunk_frames):
            n = min(model.chunk_frames, frames.n_frames - 1 - start)
            chunk = model.run_chunk(start, n)
            pose = chunk["pose"][:, :w].swapaxes(0, 1)
            velocity = chunk["velocity"][:, :w].swapaxes(0, 1)
            span = np.arange(start + 1, start + 1 + n)
            columns = np.ix_(worlds, span, moving)
            states[0][columns], states[1][columns] = pose[..., :3], pose[..., 3:]
            states[2][columns], states[3][columns] = velocity[..., :3], velocity[..., 3:]
            bad = _bad(pose, velocity)
            first_bad = np.where(bad.any(1), start + 1 + bad.argmax(1), frames.n_frames)
            ends = np.minimum(ends, first_bad)
            logs.append(_log(chunk, model, frames, start, worlds, ends))
        for k in np.nonzero(ends < frames.n_frames)[0]:
            valid[worlds[k]] = False
            for array in states:
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
    from esg.engines.newton_kernels import FIXED_POINT

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


def _model(scene: SimScene, n_worlds: int, device: str) -> NewtonModel:
    size = next((b for b in _BUCKETS if b >= n_worlds), None)
    if size is None:
        size = 1 << (n_worlds - 1).bit_length()
    key = (structure_key(scene), size, device)
    if key in _models:
        _models.move_to_end(key)
        return _models[key]
    while len(_models) >= MAX_MODELS:
        _models.popitem(last=False)
    _models[key] = NewtonModel(scene, size, device)
    return _models[key]


def clear_cache() -> None:
    """Drops all compiled models and their memory."""
    _models.clear()
