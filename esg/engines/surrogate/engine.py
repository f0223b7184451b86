"""Fused surrogate: whole rollouts of many worlds in one launch, for searches and gradients.

It executes the same programs on the same scenes as the reference engine, with the same contact
points and material model but a simpler solver (docs/surrogate.md says how far they agree). One
scene is a launch of one job.
"""

from __future__ import annotations

from collections import OrderedDict
from threading import RLock
from typing import Any

import numpy as np

from esg.engines.base import SURROGATE, VERIFY_DT_S, breadth
from esg.engines.jobs import Job, finish, job_of, refuse_what_it_lacks
from esg.engines.newton.setup import cpu_threads, known_device
from esg.engines.program import ProgramBatch
from esg.engines.scene import Rollout, SimScene, Variation
from esg.engines.shapes import SceneShapes
from esg.engines.surrogate.launch import (
    CONTACTS,
    ROWS_PER_FRAME,
    TRACED_CONTACTS,
    Launch,
    Room,
    world_bytes,
)
from esg.engines.surrogate.scene import SceneArrays
from esg.engines.worlds import Start

SCENES = 16
"""Scenes whose shapes stay on the device."""
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
        self.device = known_device(device, "the surrogate")
        self.threads = cpu_threads() if device == "cpu" else 1
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
        start = Start.of(
            scene, batch, dt=dt, record_every=record_every, duration=duration, variation=variation
        )
        arrays, fields = self._prepare(scene)
        job = job_of(SURROGATE, 0, start, arrays.shapes, ground_contacts=ground_contacts)
        room = Room(CONTACTS, ROWS_PER_FRAME * job.frames.n_frames)
        most = max(1, MEMORY_BYTES // world_bytes(job, room))
        order = np.nonzero(start.valid)[0] if len(scene.bodies) else np.zeros(0, np.int64)
        parts: list[Any] = []
        for k in range(0, len(order), most):
            part = order[k : k + most]
            own = job if len(part) == job.n_worlds else job.of_worlds(part)
            run = simulate(own, arrays, threads=self.threads, fields=fields)
            parts += zip([part], run.collect([0]), strict=True)
        return finish(self.name, start, parts, {"device": self.device}, overlaps=True)

    def _prepare(self, scene: SimScene) -> tuple[SceneArrays, Any]:
        """A scene's arrays, and the fields of its bodies if they collide by fields."""
        return scene_arrays(scene, self.device), None


def scene_arrays(scene: SimScene, device: str) -> SceneArrays:
    """The scene's shapes and bodies on a device; kept for the next call.

    Raises:
        ValueError: If the scene has joints.
    """
    refuse_what_it_lacks(scene)
    key = (scene.bodies, tuple(scene.gravity), device)
    with _lock:
        if key in _scenes:
            _scenes.move_to_end(key)
        else:
            while len(_scenes) >= SCENES:
                _scenes.popitem(last=False)
            _scenes[key] = SceneArrays(SceneShapes.of(scene), device)
        return _scenes[key]


def simulate(
    job: Job, arrays: SceneArrays, *, threads: int = 1, traced: bool = False, fields: Any = None
) -> Launch:
    """Simulates a job, again with more room if contacts or log rows did not fit."""
    contacts = TRACED_CONTACTS if traced else CONTACTS
    room = Room(contacts, ROWS_PER_FRAME * job.frames.n_frames)
    while True:
        run = Launch(
            arrays.device, [job], [arrays], [room], traced=traced, fields=fields and [fields]
        )
        run.launch(threads=threads)
        (needed,) = run.needs()
        if needed == room:
            return run
        room = needed
