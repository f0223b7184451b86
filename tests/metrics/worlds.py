"""Synthetic replays with known answers: bodies on prescribed paths, contacts written by hand."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from esg.engines.joints import Joint, JointKind, joint_between
from esg.engines.program import Primitive, Program
from esg.engines.scene import Body, ContactLog, Region, Rollout, Shape, SimScene
from esg.metrics import (
    SuiteConstraint,
    SuiteEvent,
    SuiteScene,
    SuiteStatement,
    judge,
)
from esg.units import quat_from_euler_deg, quat_multiply

DT = 1.0 / 240.0
Path = Callable[[np.ndarray], np.ndarray]
_UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def body(name: str, shape: Shape | None = None, **more: object) -> Body:
    """A unit-mass box of 0.2 m unless said otherwise."""
    shape = Shape("box", (0.1, 0.1, 0.1)) if shape is None else shape
    values: dict[str, object] = {
        "name": name,
        "static": False,
        "mass": 1.0,
        "inertia": _UNIT,
        "shapes": (shape,),
        "position": (0.0, 0.0, shape.size[2]),
        "half_extents": shape.size,
        "origin_offset": (0.0, 0.0, -shape.size[2]),
        "category": name.rsplit("_", 1)[0],
    }
    return Body(**{**values, **more})  # type: ignore[arg-type]


def ball(name: str, radius: float = 0.1, **more: object) -> Body:
    return body(
        name, Shape("sphere", (radius,) * 3), **{"roll_radius": radius, "category": "ball", **more}
    )


class World:
    """Collects paths and contacts, then judges."""

    def __init__(self, duration: float = 3.0, dt: float = DT) -> None:
        self.time = np.arange(round(duration / dt) + 1) * dt
        self.dt = dt
        self.bodies: list[Body] = []
        self.paths: list[np.ndarray] = []
        self.turns: list[np.ndarray] = []
        self.spins: list[np.ndarray] = []
        self.contacts: list[tuple[float, str, str, float, float]] = []
        self.places: dict[tuple[float, str, str], tuple[Sequence[float], Sequence[float]]] = {}
        self.primitives: list[Primitive] = []
        self.regions: list[Region] = []
        self.joints: list[Joint] = []
        self.weather: tuple[str, ...] = ()

    def add(
        self,
        item: Body,
        x: float | Path = 0.0,
        y: float | Path = 0.0,
        z: float | Path | None = None,
        yaw_deg: float | Path = 0.0,
        pitch_deg: float | Path = 0.0,
        rolling: float = 0.0,
        roll_deg: float | Path = 0.0,
    ) -> World:
        """Adds a body on a path; numbers are constant, functions take the time array.

        `rolling` is spin over that of rolling; its attitude, which nothing asks for, does not turn.
        """
        z = item.position[2] if z is None else z
        columns = [self._curve(v) for v in (x, y, z)]
        path = np.stack(columns, axis=1)
        angles = [self._curve(v) for v in (yaw_deg, pitch_deg, roll_deg)]
        self.turns.append(np.array([quat_from_euler_deg(*a) for a in zip(*angles, strict=True)]))
        self.paths.append(path)
        spin = _spin(self.turns[-1], self.dt)
        if rolling:
            velocity = np.diff(path, axis=0, prepend=path[:1]) / self.dt
            about = np.stack([-velocity[:, 1], velocity[:, 0], 0.0 * velocity[:, 2]], axis=1)
            spin = rolling * about / item.roll_radius
        self.spins.append(spin)
        start = {"position": path[0], "quaternion": self.turns[-1][0]}
        self.bodies.append(replace(item, **{k: tuple(v.tolist()) for k, v in start.items()}))
        return self

    def _curve(self, value: float | Path) -> np.ndarray:
        if callable(value):
            return np.asarray(value(self.time), float)
        return np.full(len(self.time), float(value))

    def touch(
        self,
        time: float,
        a: str,
        b: str,
        impulse: float = 1.0,
        depth: float = 0.0,
        at: Sequence[float] = (0.0, 0.0, 0.0),
        normal: Sequence[float] = (0.0, 0.0, 0.0),
    ) -> World:
        """Writes one row of the contact log; the normal points from b, added later, to a."""
        self.contacts.append((time, a, b, impulse, depth))
        self.places[time, a, b] = at, normal
        return self

    def run(self, *primitives: Primitive) -> World:
        self.primitives += primitives
        return self

    def region(self, *regions: Region) -> World:
        self.regions += regions
        return self

    def join(self, kind: JointKind, child: str, parent: str = "", **more: object) -> World:
        """Joins bodies as they stand; `limits`, and what else a joint has beside its place."""
        bodies = {b.name: b for b in self.bodies}
        place = {k: more.pop(k) for k in ("at", "axis", "parent_at", "position") if k in more}
        place.setdefault("at", bodies[child].position)
        name = f"joint_{len(self.joints) + 1}"
        joint = joint_between(name, kind, bodies[child], bodies.get(parent), **place)  # type: ignore[arg-type]
        self.joints.append(replace(joint, **more))  # type: ignore[arg-type]
        return self

    @property
    def scene(self) -> SimScene:
        joints, weather = tuple(self.joints), self.weather
        return SimScene(
            "test", tuple(self.bodies), tuple(self.regions), joints=joints, weather=weather
        )

    @property
    def program(self) -> Program:
        return Program(tuple(self.primitives), float(self.time[-1]))

    def rollout(self, valid: bool = True) -> Rollout:
        position = np.stack(self.paths, axis=1)[None]
        velocity = np.zeros_like(position)
        velocity[:, 1:] = np.diff(position, axis=1) / self.dt
        scene = self.scene
        rows = []
        for time, a, b, impulse, depth in sorted(self.contacts):
            i = scene.index(a)
            j = -1 if b == "ground" else scene.index(b)
            if j >= 0:
                i, j = min(i, j), max(i, j)
            at, normal = self.places[time, a, b]
            rows.append((round(time / self.dt), i, j, time, impulse, depth, *at, *normal))
        rows.sort(key=lambda r: (r[0], r[1], r[2]))
        n = len(rows)
        table = np.array(rows, float).reshape(n, 12)
        log = ContactLog(
            world=np.zeros(n, np.int32),
            frame=table[:, 0].astype(np.int32),
            a=table[:, 1].astype(np.int32),
            b=table[:, 2].astype(np.int32),
            time=table[:, 3],
            impulse=table[:, 4],
            depth=table[:, 5],
            point=table[:, 6:9],
            normal=table[:, 9:12],
        )
        quaternion = np.stack(self.turns, axis=1)[None]
        return Rollout(
            engine="synthetic",
            dt=self.dt,
            time=self.time,
            position=position.astype(np.float32),
            quaternion=quaternion.astype(np.float32),
            linear_velocity=velocity.astype(np.float32),
            angular_velocity=np.stack(self.spins, axis=1)[None].astype(np.float32),
            contacts=log,
            valid=np.array([valid]),
        )

    def judge(
        self,
        events: Sequence[SuiteEvent] = (),
        constraints: Sequence[SuiteConstraint] = (),
        objects: Sequence[str] = (),
        valid: bool = True,
        statements: Sequence[SuiteStatement] = (),
    ):
        """The verdict on the world."""
        expected = SuiteScene(
            id="T",
            prompt="test",
            events=tuple(events),
            constraints=tuple(constraints),
            objects=tuple(objects),
            statements=tuple(statements),
        )
        return judge(self.scene, self.program, self.rollout(valid), expected)

    def event(self, **fields: object):
        """The verdict on one event."""
        return self.judge([SuiteEvent.model_validate({"id": "e1", **fields})]).events[0]

    def states(self, says: str, events: Sequence[SuiteEvent] = (), **fields: object):
        """The verdict on one statement."""
        made = SuiteStatement.model_validate({"id": "s1", "says": says, **fields})
        return self.judge(events, statements=[made]).statements[0]


def _spin(turns: np.ndarray, dt: float) -> np.ndarray:
    """Angular velocity of attitudes over time, shape [T, 3]."""
    steps = quat_multiply(turns[1:], turns[:-1] * np.array([-1.0, -1.0, -1.0, 1.0]))
    steps = steps * np.where(steps[:, 3:] < 0, -1.0, 1.0)
    size = np.linalg.norm(steps[:, :3], axis=1, keepdims=True)
    angle = 2.0 * np.arctan2(size, steps[:, 3:])
    axis = steps[:, :3] / np.where(size > 0, size, 1.0)
    return np.concatenate([np.zeros((1, 3)), axis * angle / dt])


def line(start: float, speed: float, begin: float = 0.0, end: float = np.inf) -> Path:
    """Moves with `speed` between two times and rests otherwise."""
    return lambda t: start + speed * (np.clip(t, begin, end) - begin)
