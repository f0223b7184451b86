"""Fused surrogate: whole rollouts of many worlds in one launch, for searches and gradients.

It executes the same programs on the same scenes as the reference engine, with the same contact
points and material model but a simpler solver (docs/surrogate.md says how far they agree).
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
import math
from threading import RLock
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.base import VERIFY_DT_S, breadth
from esg.engines.newton.engine import _threads
from esg.engines.newton.model import quiet_warp
from esg.engines.program import ProgramBatch
from esg.engines.scene import ContactLog, Rollout, SimScene, Variation
from esg.engines.surrogate.model import (
    CONTACTS,
    ROWS_PER_FRAME,
    TRACED_CONTACTS,
    Room,
    SceneArrays,
    Worlds,
)
from esg.engines.worlds import Frames, check, join_logs, rest_states, world_values
from esg.outcomes import UserError

SCENES = 16
"""Scenes whose shapes stay on the device."""
TUNNELLED_M = 0.3
"""A body whose centre is this far below the ground has passed through it."""
_MAX_CONTACTS = 4096
MEMORY_BYTES = 2_000_000_000
"""Batches that would need more are simulated in parts."""

_lock = RLock()
_scenes: OrderedDict[object, SceneArrays] = OrderedDict()


class SurrogateEngine:
    """The fused surrogate (see `esg.engines.base.Engine`).

    Args:
        device: Warp device: "cpu" or "cuda:0".

    Raises:
        UserError: If the device does not exist.
    """

    name = "surrogate"

    def __init__(self, device: str = "cpu") -> None:
        wp = quiet_warp()
        known = [str(d) for d in wp.get_devices()]
        if device not in known:
            raise UserError(
                f"no device {device!r} for the surrogate; this machine has {', '.join(known)}"
            )
        self.device = device
        self.threads = _threads() if device == "cpu" else 1
        self.breadth = breadth(device)

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
        """Simulates all worlds of the batch at once (`Engine.rollout`).

        `extra` holds per world: `tunnelled` (a body's centre passed the ground, or an overlap
        exceeded half of the thinnest body) and `deepest`, the largest overlap [m].
        """
        check(scene, batch)
        frames = Frames.of(batch.duration if duration is None else duration, dt, record_every)
        values = world_values(scene, variation, batch.n_worlds)
        states = rest_states(values, frames)
        sound = np.isfinite(values.position).all((1, 2)) & np.isfinite(values.quaternion).all(
            (1, 2)
        )
        valid = sound.copy()
        deepest = np.zeros(batch.n_worlds)
        logs: list[ContactLog] = []
        order = np.nonzero(sound)[0]
        if len(scene.bodies):
            arrays = self._arrays(scene)
            most = _most_worlds(len(scene.bodies), frames)
            for k in range(0, len(order), most):
                part = order[k : k + most]
                run = simulate(
                    arrays, scene, pick(values, part), pick_batch(batch, part), frames,
                    ground_contacts=ground_contacts, threads=self.threads, make=self._worlds(scene),
                )  # fmt: skip
                logs.append(_collect(run, part, states, valid))
                deepest[part] = run.deepest.numpy()
        below = states[0][..., 2].min(axis=1) < -TUNNELLED_M
        moving = np.array([not b.static and b.collides for b in scene.bodies], bool)
        thin = min((min(b.half_extents) for b in scene.bodies if b.collides), default=math.inf)
        return Rollout(
            engine=self.name,
            dt=dt,
            time=frames.time,
            position=states[0],
            quaternion=states[1],
            linear_velocity=states[2],
            angular_velocity=states[3],
            contacts=join_logs(logs),
            valid=valid,
            extra={
                "device": self.device,
                "deepest": deepest,
                "tunnelled": (below & moving).any(axis=1) | (deepest > thin),
            },
        )

    def _arrays(self, scene: SimScene) -> SceneArrays:
        return scene_arrays(scene, self.device)

    def _worlds(self, scene: SimScene) -> Callable[..., Worlds]:
        """What makes the arrays of a rollout and launches its kernel."""
        return Worlds


def scene_arrays(scene: SimScene, device: str) -> SceneArrays:
    """The scene's shapes and bodies on a device; kept for the next call."""
    key = (scene.bodies, tuple(scene.gravity), device)
    with _lock:
        if key in _scenes:
            _scenes.move_to_end(key)
        else:
            while len(_scenes) >= SCENES:
                _scenes.popitem(last=False)
            _scenes[key] = SceneArrays(scene, device)
        return _scenes[key]


def simulate(
    arrays: SceneArrays,
    scene: SimScene,
    values: Any,
    batch: ProgramBatch,
    frames: Frames,
    *,
    ground_contacts: bool = False,
    threads: int = 1,
    trace: bool = False,
    make: Callable[..., Worlds] = Worlds,
) -> Worlds:
    """Simulates a batch, again with more room if contacts or log rows did not fit."""
    contacts = TRACED_CONTACTS if trace else CONTACTS
    room = Room(contacts, ROWS_PER_FRAME * frames.n_frames)
    while True:
        run = make(arrays, scene, values, batch, frames, room, ground_contacts, trace)
        n = run.n_worlds
        parts = np.array_split(np.arange(n), min(threads, n))
        if len(parts) == 1:
            run.launch(0, n)
        else:
            run.launch(0, 0)
            with ThreadPoolExecutor(len(parts)) as pool:
                jobs = [pool.submit(run.launch, int(p[0]), len(p)) for p in parts]
                for job in jobs:
                    job.result()
        needed = run.needs()
        if needed == room or needed.contacts > _MAX_CONTACTS:
            return run
        room = needed


def pick(values: Any, worlds: NDArray[np.int64]) -> Any:
    """The values of some worlds."""
    return type(values)(**{n: getattr(values, n)[worlds] for n in values.__dataclass_fields__})


def pick_batch(b: ProgramBatch, worlds: NDArray[np.int64]) -> ProgramBatch:
    """The programs of some worlds."""
    return ProgramBatch(b.kind, b.body, b.until, b.table[worlds], b.duration)


def _most_worlds(n_bodies: int, frames: Frames) -> int:
    a_world = (
        frames.n_frames * (n_bodies * 52 + ROWS_PER_FRAME * 48) + 16 * n_bodies**2 + CONTACTS * 188
    )
    return max(1, MEMORY_BYTES // a_world)


def _collect(
    run: Worlds, worlds: NDArray[np.int64], states: Any, valid: NDArray[np.bool_]
) -> ContactLog:
    """Brings states to the host and returns the log; a bad world repeats its last sound frame."""
    moving = run.arrays.dynamic
    end = run.end.numpy()
    n_frames = run.frames.n_frames
    valid[worlds] = end >= n_frames
    for target, source in zip(states, run.out, strict=True):
        target[np.ix_(worlds, np.arange(1, n_frames), moving)] = source.numpy()[:, 1:, moving]
        for k in np.nonzero(end < n_frames)[0]:
            target[worlds[k], end[k] :] = target[worlds[k], end[k] - 1]
    log = {n: getattr(run.log, n).numpy() for n in
           ("frame", "a", "b", "step", "impulse", "depth", "point", "normal")}  # fmt: skip
    used = np.minimum(run.log.count.numpy(), run.log.frame.shape[1])
    alive = np.arange(run.log.frame.shape[1])[None] < used[:, None]
    alive &= log["frame"] < end[:, None]
    world, row = np.nonzero(alive)
    cells = {n: v[world, row] for n, v in log.items()}
    impulse = cells["impulse"].astype(float)
    length = np.linalg.norm(cells["normal"].astype(float), axis=1, keepdims=True)
    order = np.lexsort((cells["b"], cells["a"], cells["frame"], world))
    return ContactLog(
        world=worlds[world][order].astype(np.int32),
        frame=cells["frame"][order],
        a=cells["a"][order],
        b=cells["b"][order],
        time=(cells["step"][order] + 1) * run.frames.dt,
        impulse=impulse[order],
        depth=cells["depth"][order].astype(float),
        point=(cells["point"] / impulse[:, None])[order].astype(float),
        normal=(cells["normal"] / np.where(length > 0.0, length, 1.0))[order].astype(float),
    )
