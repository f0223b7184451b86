"""The fused surrogate with contacts from voxel signed distance fields of some bodies.

For the refinement pass of a search (`esg.dynamics.gradient.refine`). Two bodies with fields meet by
them, and so do a field and a ball; all other pairs collide by their shapes. On the ground a body
with a field rests on samples of its surface.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.newton.setup import quiet_warp
from esg.engines.scene import Body, SimScene
from esg.engines.shapes import SceneShapes
from esg.engines.surrogate.engine import SurrogateEngine
from esg.engines.surrogate.scene import SceneArrays

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class BodyField:
    """Signed distance field of one body in its frame (origin at the centre of mass), and samples.

    Args:
        values: Distances at the centres of cubic cells [m], negative inside, shape [n, n, n].
        origin: Corner of the grid [m], shape [3].
        cell: Edge of a cell [m].
        samples: Points on the surface [m], shape [k, 3].
    """

    values: NDArray[np.float32]
    origin: Floats
    cell: float
    samples: Floats


_NOTHING = BodyField(np.zeros((2, 2, 2), np.float32), np.zeros(3), 1.0, np.zeros((1, 3)))
"""Stands for the fields of a scene that has none."""


class SdfSurrogateEngine(SurrogateEngine):
    """The surrogate whose bodies may collide by fields (see `esg.engines.base.Engine`).

    Args:
        fields: Fields by name of body, all of one resolution.
        device: Warp device.

    Raises:
        UserError: If the device does not exist.
        ValueError: If the resolutions differ.
    """

    name = "surrogate-sdf"

    def __init__(self, fields: Mapping[str, BodyField], device: str = "cpu") -> None:
        super().__init__(device)
        self.fields = dict(fields)
        if len({f.values.shape for f in self.fields.values()}) > 1:
            raise ValueError("all fields need the same number of cells")
        self._prepared: dict[object, tuple[SceneArrays, Any]] = {}

    def _prepare(self, scene: SimScene) -> tuple[SceneArrays, Any]:
        key = (scene.bodies, tuple(scene.gravity))
        if key not in self._prepared:
            arrays = SceneArrays(SceneShapes.of(scene), self.device)
            self._prepared = {key: (arrays, _upload(scene, self.fields, arrays))}
        return self._prepared[key]


def _upload(scene: SimScene, fields: Mapping[str, BodyField], arrays: SceneArrays) -> Any:
    """Fields of a scene on the device; the reach of a body then holds all its samples."""
    wp = quiet_warp()
    from esg.engines.surrogate.types import Fields

    device = arrays.device
    names = [b.name for b in scene.bodies if b.collides and b.name in fields]
    found = [fields[n] for n in names] or [_NOTHING]
    index = [names.index(b.name) if b.name in names else -1 for b in scene.bodies]
    for i, f in enumerate(index):
        if f >= 0:
            far = float(np.linalg.norm(found[f].samples, axis=1).max())
            arrays.fields["reach"][i] = max(float(arrays.fields["reach"][i]), far)

    def to(values: Any, dtype: Any) -> Any:
        kind = np.int32 if dtype is int else np.float32
        return wp.array(np.asarray(values).astype(kind), dtype=dtype, device=device)

    made: Any = Fields()
    made.n = found[0].values.shape[0]
    made.of_body = to(index or [-1], int)
    made.ball = to([is_ball(b) for b in scene.bodies] or [0], int)
    made.values = to(np.stack([f.values for f in found]), float)
    made.origin = to([f.origin for f in found], wp.vec3)
    made.cell = to([f.cell for f in found], float)
    made.first = to(np.cumsum([0, *[len(f.samples) for f in found]]), int)
    made.sample = to(np.concatenate([f.samples for f in found]), wp.vec3)
    return made


def is_ball(body: Body) -> bool:
    """Whether a body is one sphere, which collides exactly without a field."""
    return len(body.shapes) == 1 and body.shapes[0].kind == "sphere"
