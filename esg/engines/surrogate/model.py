"""Device arrays of the fused surrogate: scene, worlds and program in, states and contacts out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.newton.setup import quiet_warp
from esg.engines.newton.shapes import hull
from esg.engines.program import ProgramBatch
from esg.engines.rest import starts_at_rest
from esg.engines.scene import Shape, SimScene
from esg.engines.worlds import Frames, Values, moving

CONTACTS, TRACED_CONTACTS = 160, 48
"""Room for contacts of one world and step before it has to grow; less where every step keeps its
own. Unused room costs memory only, while too little costs a second rollout."""
ROWS_PER_FRAME = 12
"""Room for rows of the contact log before it has to grow."""
_POINTS = 8


@dataclass(frozen=True)
class Room:
    """How many contacts a step and how many rows a log may have."""

    contacts: int
    rows: int


class SceneArrays:
    """What of a scene is the same in all worlds: shapes and bodies.

    Args:
        scene: The scene.
        device: Warp device.
    """

    def __init__(self, scene: SimScene, device: str) -> None:
        wp = quiet_warp()
        from newton import GeoType

        kinds = {
            "sphere": GeoType.SPHERE,
            "box": GeoType.BOX,
            "capsule": GeoType.CAPSULE,
            "cylinder": GeoType.CYLINDER,
            "convex": GeoType.CONVEX_MESH,
        }
        first, kind, scale, mesh, position, rotation, half = [0], [], [], [], [], [], []
        reach = np.zeros(max(1, len(scene.bodies)))
        self.meshes: list[Any] = []
        for i, body in enumerate(scene.bodies):
            for shape in body.shapes:
                size, centre, bounds = _dimensions(shape)
                kind.append(int(kinds[shape.kind]))
                scale.append(size)
                half.append(bounds)
                offset = np.array(shape.position) + _rotate(shape.quaternion, centre)
                position.append(offset)
                rotation.append(shape.quaternion)
                mesh.append(self._mesh(wp, shape, centre, device))
                reach[i] = max(reach[i], float(np.linalg.norm(offset) + np.linalg.norm(bounds)))
            first.append(len(kind))
        self.device = device
        dynamic = moving(scene)
        self.dynamic = np.nonzero(dynamic)[0]
        inertia = np.stack(
            [
                np.array(b.inertia) if m else np.eye(3)
                for b, m in zip(scene.bodies, dynamic, strict=True)
            ]
            or [np.eye(3)]
        )
        to = _Uploader(wp, device)
        self.fields = {
            "n_bodies": len(scene.bodies),
            "gravity": wp.vec3(*map(float, scene.gravity)),
            "first": to(first, int),
            "kind": to(kind or [0], int),
            "scale": to(scale or [[0] * 3], wp.vec3),
            "mesh": to(mesh or [[0] * 3], wp.vec3),
            "position": to(position or [[0] * 3], wp.vec3),
            "rotation": to(rotation or [[0, 0, 0, 1]], wp.quat),
            "half": to(half or [[0] * 3], wp.vec3),
            "radius": to(
                [_radius(k, s, h, kinds) for k, s, h in zip(kind, scale, half, strict=True)] or [0],
                float,
            ),
            "reach": to(reach, float),
            "dynamic": to(dynamic if len(dynamic) else [False], int),
            "wheeled": to([b.wheeled for b in scene.bodies] or [False], int),
            "inertia": to(inertia, wp.mat33),
            "inverse_inertia": to(np.linalg.inv(inertia), wp.mat33),
        }

    def _mesh(self, wp: Any, shape: Shape, centre: NDArray[np.float64], device: str) -> list[float]:
        """The address of a hull in the three floats that Newton's support maps take."""
        if shape.kind != "convex":
            return [0.0, 0.0, 0.0]
        vertices, faces = hull(np.array(shape.vertices))
        made = wp.Mesh(
            points=wp.array((vertices - centre).astype(np.float32), dtype=wp.vec3, device=device),
            indices=wp.array(faces.reshape(-1), dtype=int, device=device),
        )
        self.meshes.append(made)
        bits = int(made.id)
        return [float(bits & 0x3FFFFF), float((bits >> 22) & 0x3FFFFF), float(bits >> 44)]


class Worlds:
    """All arrays of one rollout of W worlds.

    Args:
        arrays: The scene.
        scene: The same scene, for what is not an array there.
        values: Initial states and materials of W worlds.
        batch: W programs.
        frames: The time grid.
        room: For contacts and log rows.
        ground_contacts: Whether the log includes contacts with the ground.
        trace: Keep the contacts of every step instead of the current one's.
    """

    def __init__(
        self,
        arrays: SceneArrays,
        scene: SimScene,
        values: Values,
        batch: ProgramBatch,
        frames: Frames,
        room: Room,
        ground_contacts: bool,
        trace: bool = False,
    ) -> None:
        self.wp = wp = quiet_warp()
        from esg.engines.surrogate import types

        self.arrays, self.frames, self.room = arrays, frames, room
        self.device = device = arrays.device
        to = _Uploader(wp, device)
        w, b = values.mass.shape
        self.n_worlds, self.n_bodies = w, b
        p = len(batch.kind)
        self.model = _fill(
            types.Model(),
            arrays.fields
            | {
                "n_primitives": p,
                "n_worlds": w,
                "mass": to(_at_least(values.mass, 1.0), float),
                "factor": to(_factor(scene, values), float),
                "restitution": to(values.restitution, float),
                "ground": to(values.ground, wp.vec3),
                "friction_scale": to(values.friction_scale, float),
                "action": to(batch.kind if p else [0], int),
                "target": to(batch.body if p else [0], int),
                "until": to(batch.until if p else np.zeros((1, b)), int),
                "table": to(batch.table if p else np.zeros((w, 1, 1)), wp.float64),
            },
        )
        damping = np.array([(x.linear_damping, x.angular_damping) for x in scene.bodies])
        awake = np.tile(moving(scene), (w, 1))
        if not ground_contacts:
            awake &= ~starts_at_rest(scene, values.position, values.quaternion)
        self.state = _fill(
            types.State(),
            {
                "x": to(values.position, wp.vec3),
                "r": to(values.quaternion, wp.quat),
                "v": self._zeros((w, b), wp.vec3),
                "o": self._zeros((w, b), wp.vec3),
                "friction": to(values.friction, float),
                "damping": to(np.tile(damping, (w, 1, 1)), wp.vec2),
                "awake": to(awake, int),
                "idle": self._zeros((w, b), int),
                "inverse": self._zeros((w, b), wp.mat33),
                "light": self._zeros((w, b), float),
                "before_v": self._zeros((w, b), wp.vec3),
                "before_o": self._zeros((w, b), wp.vec3),
                "delay": self._zeros((w, b), wp.vec2),
                "touched": wp.full((w, b, b), -1, dtype=int, device=device),
                "done": self._zeros((w, max(1, p)), int),
                "active": self._zeros((w, max(1, p)), int),
            },
        )
        slots = room.contacts * (frames.n_steps if trace else 1)
        con: dict[str, Any] = {
            name: self._zeros((w, slots), int) for name in ("a", "b", "shape_a", "shape_b", "used")
        }
        con |= {
            n: self._zeros((w, slots), float)
            for n in ("gap", "friction", "wanted", "delay", "early")
        }
        vectors = ("normal", "side", "arm_a", "arm_b", "share", "impulse")
        con |= {n: self._zeros((w, slots), wp.vec3) for n in vectors}
        con |= {n: self._zeros((w, slots), wp.quat) for n in ("turn_a", "turn_b")}
        con["base"] = room.contacts if trace else 0
        con["count"] = self._zeros((w, frames.n_steps if trace else 1), int)
        con["dropped"] = self._zeros((w,), int)
        self.contacts = _fill(types.Contacts(), con)
        rows = room.rows
        log: dict[str, Any] = {n: self._zeros((w, rows), int) for n in ("frame", "a", "b", "step")}
        log |= {n: self._zeros((w, rows), float) for n in ("impulse", "depth")}
        log |= {n: self._zeros((w, rows), wp.vec3) for n in ("point", "normal")}
        log["ground"] = int(ground_contacts)
        log["count"] = self._zeros((w,), int)
        log["row"] = wp.full((w, b + 1, b + 1), -1, dtype=int, device=device)
        self.log = _fill(types.Log(), log)
        self.raw = (
            self._zeros((w, _POINTS), wp.vec3),
            self._zeros((w, _POINTS), wp.vec3),
            self._zeros((w, _POINTS), float),
            self._zeros((w,), int),
        )
        steps = frames.n_steps if trace else 0
        self.trace = _fill(
            types.Trace(),
            {
                "steps": steps,
                "awake": self._zeros((w, max(1, steps), b), int),
                "fired": self._zeros((w, max(1, steps), max(1, p)), int),
                "sweeps": self._zeros((w, max(1, steps)), int),
            },
        )
        self.deepest = self._zeros((w,), float)
        self.end = self._zeros((w,), int)
        shape = (w, frames.n_frames, b)
        # Static bodies are never written; a trace reads them too.
        kept = trace and [np.repeat(v[:, None], frames.n_frames, axis=1)
                          for v in (values.position, values.quaternion)]  # fmt: skip
        self.out = (
            to(kept[0], wp.vec3) if kept else self._zeros(shape, wp.vec3),
            to(kept[1], wp.quat) if kept else self._zeros(shape, wp.quat),
            self._zeros(shape, wp.vec3),
            self._zeros(shape, wp.vec3),
        )

    def _zeros(self, shape: tuple[int, ...], dtype: Any) -> Any:
        return self.wp.zeros(shape, dtype=dtype, device=self.device)

    def _kernel(self) -> tuple[Any, tuple[Any, ...]]:
        """The kernel and what it takes before the arguments all such kernels share."""
        from esg.engines.surrogate.kernels import roll

        return roll, ()

    def launch(self, first: int, count: int) -> None:
        """Simulates worlds first .. first + count - 1 to the end, in one launch."""
        kernel, own = self._kernel()
        f = self.frames
        self.wp.launch(
            kernel,
            dim=count,
            inputs=[
                *own, self.model, self.state, *self.raw, self.contacts, self.log, f.dt, f.n_steps,
                f.record_every, first, self.trace, self.deepest, self.end, *self.out,
            ],
            device=self.device,
            block_dim=64,
        )  # fmt: skip

    def needs(self) -> Room:
        """The room this rollout would have needed."""
        dropped = int(self.contacts.dropped.numpy().max(initial=0))
        rows = int(self.log.count.numpy().max(initial=0))
        contacts = self.room.contacts * (2 if dropped else 1)
        return Room(contacts, max(self.room.rows, rows))


class _Uploader:
    def __init__(self, wp: Any, device: str) -> None:
        self.wp, self.device = wp, device

    def __call__(self, values: Any, dtype: Any) -> Any:
        kind = np.int32 if dtype is int else np.float64 if dtype is self.wp.float64 else np.float32
        return self.wp.array(
            np.ascontiguousarray(np.asarray(values).astype(kind)), dtype=dtype, device=self.device
        )


def _fill(struct: Any, values: dict[str, Any]) -> Any:
    for name, value in values.items():
        setattr(struct, name, value)
    return struct


def _at_least(mass: NDArray[np.float64], low: float) -> NDArray[np.float64]:
    """Masses of immovable bodies are never used; keep them from being zero."""
    return np.where(mass > 0.0, mass, low)


def _factor(scene: SimScene, values: Values) -> NDArray[np.float64]:
    """By how much each world's inertia exceeds the scene's, shape [W, B]."""
    own = np.array([b.mass if b.mass > 0.0 else 1.0 for b in scene.bodies])
    return _at_least(values.mass, 1.0) / own


def _rotate(q: Any, p: NDArray[np.float64]) -> NDArray[np.float64]:
    from esg.units import quat_rotate

    return quat_rotate(np.array(q, float), p)


def _dimensions(
    shape: Shape,
) -> tuple[tuple[float, float, float], NDArray[np.float64], NDArray[np.float64]]:
    """Newton's scale, the centre in the shape's frame [m], and half extents around it [m]."""
    x, y, z = shape.size
    zero = np.zeros(3)
    if shape.kind == "sphere":
        return (x, x, x), zero, np.array([x, x, x])
    if shape.kind == "box":
        return (x, y, z), zero, np.array([x, y, z])
    if shape.kind == "capsule":
        return (x, z, 0.0), zero, np.array([x, x, z + x])
    if shape.kind == "cylinder":
        return (x, z, 0.0), zero, np.array([x, x, z])
    points = np.array(shape.vertices)
    centre = points.mean(axis=0)
    return (1.0, 1.0, 1.0), centre, np.abs(points - centre).max(axis=0)


def _radius(kind: int, scale: Any, half: NDArray[np.float64], kinds: dict[str, Any]) -> float:
    if kind == int(kinds["sphere"]):
        return float(scale[0])
    if kind == int(kinds["capsule"]):
        return float(scale[0] + scale[1])
    if kind == int(kinds["cylinder"]):
        return float(np.hypot(scale[0], scale[1]))
    return float(np.linalg.norm(half))
