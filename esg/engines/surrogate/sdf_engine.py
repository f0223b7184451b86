"""The fused surrogate with contacts from voxel signed distance fields of some bodies.

For the refinement pass of a search (`esg.dynamics.gradient.refine`). Two bodies with fields meet by
them, and so do a field and a ball; all other pairs collide by their shapes. On the ground a body
with a field rests on samples of its surface.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.newton.model import quiet_warp
from esg.engines.scene import Body, SimScene
from esg.engines.surrogate.engine import SurrogateEngine
from esg.engines.surrogate.model import SceneArrays, Worlds, _fill, _Uploader

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
            arrays = SceneArrays(scene, self.device)
            self._prepared = {key: (arrays, self._upload(scene, arrays))}
        return self._prepared[key]

    def _arrays(self, scene: SimScene) -> SceneArrays:
        return self._prepare(scene)[0]

    def _worlds(self, scene: SimScene) -> Callable[..., Worlds]:
        return partial(_FieldWorlds, self._prepare(scene)[1])

    def _upload(self, scene: SimScene, arrays: SceneArrays) -> Any:
        """Fields of a scene on the device; the reach of a body then holds all its samples."""
        wp = quiet_warp()
        from esg.engines.surrogate.sdf_kernels import Fields

        names = [b.name for b in scene.bodies if b.collides and b.name in self.fields]
        found = [self.fields[n] for n in names]
        index = [names.index(b.name) if b.name in names else -1 for b in scene.bodies]
        reach = np.array(arrays.fields["reach"].numpy(), float)
        for i, f in enumerate(index):
            if f >= 0:
                reach[i] = max(reach[i], float(np.linalg.norm(found[f].samples, axis=1).max()))
        to = _Uploader(wp, self.device)
        arrays.fields["reach"] = to(reach, float)
        n = found[0].values.shape[0] if found else 2
        none = np.zeros((1, n, n, n))
        return _fill(
            Fields(),
            {
                "n": n,
                "of_body": to(index or [-1], int),
                "ball": to([is_ball(b) for b in scene.bodies] or [0], int),
                "values": to(np.stack([f.values for f in found]) if found else none, float),
                "origin": to([f.origin for f in found] or [[0] * 3], wp.vec3),
                "cell": to([f.cell for f in found] or [1.0], float),
                "first": to(np.cumsum([0, *[len(f.samples) for f in found]]), int),
                "sample": to(np.concatenate([f.samples for f in found] or [np.zeros((1, 3))]),
                             wp.vec3),
            },
        )  # fmt: skip


class _FieldWorlds(Worlds):
    """Arrays of a rollout whose contacts come from fields."""

    def __init__(self, fields: Any, *args: Any, **options: Any) -> None:
        from esg.engines.surrogate.sdf_kernels import SLOTS

        super().__init__(*args, **options)
        self.fields = fields
        wp, w = self.wp, self.n_worlds
        self.raw = (
            self._zeros((w, SLOTS), wp.vec3),
            self._zeros((w, SLOTS), wp.vec3),
            self._zeros((w, SLOTS), float),
            self._zeros((w,), int),
        )

    def _kernel(self) -> tuple[Any, tuple[Any, ...]]:
        from esg.engines.surrogate.sdf_kernels import roll

        return roll, (self.fields,)


def is_ball(body: Body) -> bool:
    """Whether a body is one sphere, which collides exactly without a field."""
    return len(body.shapes) == 1 and body.shapes[0].kind == "sphere"
