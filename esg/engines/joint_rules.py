"""What joints do beyond holding bodies together, for engines that step one world at a time.

* Stiffness and damping act as impulses before the step. With x the position of what they draw
  back (distance less length, angle, way), I its effective inertia (that of the two bodies, held
  as the joint holds them), w^2 = min(k, I / dt^2) / I and e = exp(-c dt / I), the impulse is

      -I ((1 + e - 2 sqrt(e) cos(dt sqrt(w^2 - c^2 / 4 I^2))) / dt x + (1 - e) dx/dt),

  after which the positions of a step of symplectic Euler are those of the damped oscillator:
  nothing is lost that damping does not take, and nothing explodes.
* Motors and friction are one drive of the engine, towards a speed with a limited force: that of
  the motor (`drive_of`), or 0 with the joint's friction where no motor is on.
* A rope gives before the step what keeps its anchors within its length at the end of it, so that
  it neither stretches nor throws back; so does the cone of a ball joint with its angle.
* A joint breaks once it has taken more than `break_impulse` (`JointLoads`).
"""

from __future__ import annotations

import cmath
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass, replace
import math
from typing import Any, Protocol

import numpy as np

from esg.engines.executor import Touch
from esg.engines.joints import Floats, Joint, Motor, joint_state
from esg.engines.program import Vec
from esg.engines.scene import SimScene
from esg.engines.worlds import Principal, Values, moving, principal_axes
from esg.units import quat_multiply, quat_rotate

APPROACH_RATE = 10.0
"""A motor nears a place at no more than this times the way that is left [1/s]."""


BREAK_WINDOW_S = 1.0 / 60.0
"""Over which what a joint takes adds up [s]: four steps at 240 Hz."""
STOP_ROUNDS = 8
"""How often the ropes and cones of a scene with several are gone through before a step."""


def stops(joint: Joint) -> bool:
    """Whether a rule stops it and not the engine: a rope, a cone."""
    return joint.kind == "rope" or (joint.kind == "ball" and joint.upper is not None)


class Bodies(Protocol):
    """Access to bodies by index."""

    def read(self, body: int) -> tuple[Any, Any, Any, Any]: ...
    def set_linear(self, body: int, velocity: Vec) -> None: ...
    def set_angular(self, body: int, velocity: Vec) -> None: ...


@dataclass(frozen=True)
class Masses:
    """How easily the bodies of a world are moved; not at all what stays put.

    Args:
        position, quaternion: At the start [m], shapes [B, 3] and [B, 4].
        mass: [kg], shape [B].
        inverse: Of the mass [1/kg], shape [B].
        inverse_inertia: In body axes [1/(kg m^2)], shape [B, 3, 3].
    """

    position: Floats
    quaternion: Floats
    mass: Floats
    inverse: Floats
    inverse_inertia: Floats

    @staticmethod
    def of(scene: SimScene, values: Values, w: int, principal: Principal | None = None) -> Masses:
        """Those of world `w`; `principal` as in the engines."""
        n = len(scene.bodies)
        inverse, inertia = np.zeros(n), np.zeros((n, 3, 3))
        for i in np.nonzero(moving(scene))[0].tolist():
            moments, axes = (principal or {}).get(i) or principal_axes(values.inertia[w, i])
            columns = quat_rotate(np.tile(axes, (3, 1)), np.eye(3)).T
            inverse[i] = 1.0 / values.mass[w, i]
            inertia[i] = columns @ np.diag(1.0 / moments) @ columns.T
        where = values.position[w], values.quaternion[w]
        return Masses(*where, values.mass[w], inverse, inertia)


def drive_of(joint: Joint, motor: Motor | None, position: float, dt: float) -> tuple[float, float]:
    """Speed and greatest force of a joint's drive in the step to come [rad/s or m/s, N m or N].

    Args:
        joint: Whose friction brakes while no motor is on.
        motor: That is on.
        position: Of the joint [rad or m].
        dt: The step [s].
    """
    if motor is None:
        return 0.0, joint.friction
    if motor.position is None:
        return motor.speed, motor.limit
    left = motor.position - position
    speed = min(APPROACH_RATE, 1.0 / dt) * left
    most = abs(motor.speed) or math.inf
    return min(max(speed, -most), most), motor.limit


def kick(stiffness: float, damping: float, inertia: float, dt: float) -> tuple[float, float]:
    """Impulse by the position and by the speed of what is drawn back (module docstring).

    Args:
        stiffness: [N/m or N m/rad].
        damping: [N s/m or N m s/rad].
        inertia: Effective [kg or kg m^2].
        dt: The step [s].
    """
    keep = math.exp(-damping * dt / inertia)
    square = min(stiffness / inertia, 1.0 / dt**2) - (0.5 * damping / inertia) ** 2
    turn = cmath.cos(dt * cmath.sqrt(square)).real
    return -inertia * (1.0 + keep - 2.0 * math.sqrt(keep) * turn) / dt, -inertia * (1.0 - keep)


@dataclass(frozen=True)
class Placed:
    """A body in the world: centre, rotation, velocities, and how easily it is moved."""

    at: Floats
    turn: Floats
    linear: Floats
    angular: Floats
    inverse: float
    inverse_inertia: Floats


_WORLD = Placed(
    np.zeros(3), np.array([0.0, 0.0, 0.0, 1.0]), np.zeros(3), np.zeros(3), 0.0, np.zeros((3, 3))
)


class JointRules:
    """All that joints of one world do besides holding its bodies together.

    Args:
        scene: Its joints.
        masses: Of its bodies.
        dt: The step [s].
    """

    def __init__(self, scene: SimScene, masses: Masses, dt: float) -> None:
        index = {name: i for i, name in enumerate(scene.names)}
        self.dt, self.joints = dt, scene.joints
        self.ends = [(index[j.child], index.get(j.parent, -1)) for j in scene.joints]
        self.motors: list[Motor | None] = [j.motor for j in scene.joints]
        self._forces = JointForces(scene, masses)
        breaks = any(j.break_impulse is not None for j in scene.joints)
        self._loads = JointLoads(scene, masses, dt) if breaks else None
        self._given: dict[int, float] = {}

    def before_step(self, world: Bodies) -> dict[int, tuple[float, float]]:
        """Acts on the bodies; returns speed and greatest force of every drive by joint."""
        gone = self._loads.gone if self._loads else ()
        self._given = self._forces.act(self.dt, world, gone)
        if self._loads:
            self._loads.before(world)
        return {
            k: self._drive(k, joint, world)
            for k, joint in enumerate(self.joints)
            if joint.kind in ("hinge", "slider", "ball") and k not in gone
        }

    def _drive(self, k: int, joint: Joint, world: Bodies) -> tuple[float, float]:
        motor, position = self.motors[k], 0.0
        if motor is not None and motor.position is not None:
            child, parent = (self._forces.pose(world, body) for body in self.ends[k])
            state = joint_state(joint, (child.at, child.turn), (parent.at, parent.turn))
            position = float(state.position)
        return drive_of(joint, motor, position, self.dt)

    def after_step(self, world: Bodies, touches: Iterable[Touch]) -> list[int]:
        """Joints that have broken in the step; `touches` are the ground's as well."""
        return self._loads.after(world, touches, self._given) if self._loads else []


class JointForces:
    """What ropes, springs, cones, stiffness and damping of one world do before a step.

    Args:
        scene: Its joints.
        masses: Of its bodies.
    """

    def __init__(self, scene: SimScene, masses: Masses) -> None:
        self._masses, self._gravity = masses, np.array(scene.gravity)
        index = {name: i for i, name in enumerate(scene.names)}
        ends = [(index[j.child], index.get(j.parent, -1)) for j in scene.joints]
        every = [(k, j, e) for k, (j, e) in enumerate(zip(scene.joints, ends, strict=True))]
        self._elastic = [row for row in every if row[1].stiffness > 0.0 or row[1].damping > 0.0]
        self._stops = [row for row in every if stops(row[1])]

    def act(self, dt: float, world: Bodies, gone: Iterable[int]) -> dict[int, float]:
        """Pushes the bodies before a step of `dt` seconds.

        Args:
            dt: The step [s].
            world: The bodies.
            gone: Joints that have broken.

        Returns:
            What each rope and spring gave [N s]; other joints are held by the engine.
        """
        out: dict[int, float] = {}
        lost = set(gone)
        for k, joint, ends in self._elastic:
            if k not in lost:
                impulse = self._draw(joint, ends, dt, world)
                if joint.kind == "spring":
                    out[k] = impulse
        taut = [row for row in self._stops if row[0] not in lost]
        given = dict.fromkeys((k for k, _, _ in taut), 0.0)
        for _ in range(STOP_ROUNDS if len(taut) > 1 else 1):
            for k, joint, ends in taut:
                given[k] += self._stop(joint, ends, dt, world, given[k])
        out.update((k, given[k]) for k, joint, _ in taut if joint.kind == "rope")
        return out

    def _draw(self, joint: Joint, ends: tuple[int, int], dt: float, world: Bodies) -> float:
        """Stiffness and damping of a joint; returns a spring's impulse [N s]."""
        pair = self._pair(joint, ends, world)
        if not len(pair.free):
            return 0.0
        moves, axes = np.linalg.eigh(pair.free @ pair.pushed)
        impulse = np.zeros(len(pair.free))
        speeds = pair.free @ pair.velocity
        for move, axis in zip(moves, axes.T, strict=True):
            if move > 0.0:
                by_x, by_v = kick(joint.stiffness, joint.damping, 1.0 / move, dt)
                impulse += axis * (by_x * (axis @ pair.position) + by_v * (axis @ speeds))
        self._push(pair, ends, impulse, world)
        return float(impulse[0])

    def _stop(
        self, joint: Joint, ends: tuple[int, int], dt: float, world: Bodies, given: float
    ) -> float:
        """Holds a rope or a cone to its limit at the end of the step.

        `given` is what it has in this step; no rope pushes. Returns what it gave besides [N s].
        """
        pair = self._pair(joint, ends, world, stop=True)
        if not len(pair.free):
            return 0.0
        falling = pair.velocity + pair.gravity(self._gravity * dt)
        if len(pair.locked):
            falling = falling - pair.held(pair.locked @ falling)
        (position,), (move,) = pair.position, (pair.free @ pair.pushed)[0]
        if not move > 0.0:
            return 0.0
        if joint.kind == "rope":
            # The way of the anchors is straight, which its length along their line is not.
            way = pair.way + dt * (pair.drift @ falling)
            pull = dt * (pair.drift @ pair.pushed)[:, 0]
            need = _shortened(way, pull, joint.upper or 0.0)
        else:
            need = -(position + dt * (pair.free @ falling)[0]) / (dt * move)
        more = max(-need, -given)
        if more != 0.0:
            self._push(pair, ends, np.array([-more]), world)
        return more

    def _push(self, pair: _Pair, ends: tuple[int, int], impulse: Floats, world: Bodies) -> None:
        change = pair.velocity + pair.pushed @ impulse
        for n, i in enumerate(ends[::-1]):
            if i >= 0 and self._masses.inverse[i] > 0.0:
                world.set_linear(i, _vec(change[6 * n : 6 * n + 3]))
                world.set_angular(i, _vec(change[6 * n + 3 : 6 * n + 6]))

    def _pair(
        self, joint: Joint, ends: tuple[int, int], world: Bodies, *, stop: bool = False
    ) -> _Pair:
        child, parent = (self.pose(world, i) for i in ends)
        return _pair(joint, child, parent, stop)

    def pose(self, world: Bodies, body: int) -> Placed:
        """A body as it is; -1 is the world."""
        if body < 0:
            return _WORLD
        if not self._masses.inverse[body] > 0.0:
            where = self._masses.position[body], self._masses.quaternion[body]
            return replace(_WORLD, at=where[0], turn=where[1])
        at, turn, linear, angular = world.read(body)
        q = np.array([float(v) for v in turn])
        columns = quat_rotate(np.tile(q, (3, 1)), np.eye(3)).T
        return Placed(
            np.array(at, float),
            q,
            np.array(linear, float),
            np.array(angular, float),
            float(self._masses.inverse[body]),
            columns @ self._masses.inverse_inertia[body] @ columns.T,
        )


@dataclass(frozen=True)
class _Pair:
    """Two bodies of a joint as it holds them; velocities are of parent and child, shape [12].

    Args:
        velocity: They have.
        free, locked: Velocities that it leaves free and locks, as rows, shapes [F, 12], [L, 12].
        position: Of what is free; of a stop, what it is beyond its limit, shape [F].
        easy: Inverse mass, shape [12, 12].
        pushed: Velocity by an impulse on what is free, shape [12, F].
        way: From the parent's anchor to the child's, shape [3]; `drift` is its speed, as rows.
        drift: Shape [3, 12].
    """

    velocity: Floats
    free: Floats
    locked: Floats
    position: Floats
    easy: Floats
    pushed: Floats
    way: Floats
    drift: Floats

    def held(self, speeds: Floats) -> Floats:
        """Change of velocity that goes with taking speeds of what is locked away."""
        response = self.easy @ self.locked.T
        return response @ np.linalg.lstsq(self.locked @ response, speeds, rcond=1e-12)[0]

    def gravity(self, gain: Floats) -> Floats:
        """What gravity adds to the velocity of what moves."""
        moves = np.diag(self.easy)[[0, 6]] > 0.0
        zero = np.zeros(3)
        return np.concatenate([gain * moves[0], zero, gain * moves[1], zero])


def _pair(joint: Joint, child: Placed, parent: Placed, stop: bool) -> _Pair:
    to_child = quat_rotate(child.turn, np.array(joint.child_anchor))
    to_parent = quat_rotate(parent.turn, np.array(joint.parent_anchor))
    way = child.at + to_child - parent.at - to_parent
    drift = _shifts(np.eye(3), to_child, to_parent)
    if joint.flexible:
        free, locked, position = _along(joint, way, drift)
    elif stop:
        free, locked, position = _beyond_cone(joint, child, parent, drift)
    else:
        free, locked, position = _drawn(joint, child, parent, drift)
    # Columns: linear and angular velocity of the parent, then of the child.
    easy = np.zeros((12, 12))
    for n, body in enumerate((parent, child)):
        easy[6 * n : 6 * n + 3, 6 * n : 6 * n + 3] = body.inverse * np.eye(3)
        easy[6 * n + 3 : 6 * n + 6, 6 * n + 3 : 6 * n + 6] = body.inverse_inertia
    velocity = np.concatenate([parent.linear, parent.angular, child.linear, child.angular])
    pushed = easy @ free.T
    out = _Pair(velocity, free, locked, position, easy, pushed, way, drift)
    if len(locked) and len(free):
        out = replace(out, pushed=pushed - out.held(locked @ pushed))
    return out


_NONE = np.zeros((0, 12))
Rows = tuple[Floats, Floats, Floats]
"""What is free, what is locked, and the position of what is free (`_Pair`)."""


def _along(joint: Joint, way: Floats, drift: Floats) -> Rows:
    """Of a rope or spring: the line between its anchors."""
    length = float(np.linalg.norm(way))
    if length < 1e-9:
        return _NONE, _NONE, np.zeros(0)
    return (way / length)[None] @ drift, _NONE, np.array([length - (joint.upper or 0.0)])


def _beyond_cone(joint: Joint, child: Placed, parent: Placed, drift: Floats) -> Rows:
    """Of a ball joint: the turn that opens the angle between its axes."""
    x = np.array([1.0, 0.0, 0.0])
    own = quat_rotate(quat_multiply(child.turn, np.array(joint.child_rotation)), x)
    given = quat_rotate(quat_multiply(parent.turn, np.array(joint.parent_rotation)), x)
    axis = np.cross(given, own)
    size = float(np.linalg.norm(axis))
    if size < 1e-9:
        return _NONE, drift, np.zeros(0)
    angle = math.atan2(size, float(given @ own))
    return _turns((axis / size)[None]), drift, np.array([angle - (joint.upper or 0.0)])


def _drawn(joint: Joint, child: Placed, parent: Placed, drift: Floats) -> Rows:
    """Of the other kinds: what they leave free."""
    frame = quat_rotate(
        np.tile(quat_multiply(parent.turn, np.array(joint.parent_rotation)), (3, 1)), np.eye(3)
    )
    state = joint_state(joint, (child.at, child.turn), (parent.at, parent.turn))
    position = np.array([float(state.position)])
    if joint.kind == "slider":
        # The rail pushes where the child is.
        to_child = quat_rotate(child.turn, np.array(joint.child_anchor))
        shifts = _shifts(frame, to_child, child.at + to_child - parent.at)
        return shifts[:1], np.concatenate([shifts[1:], _turns(np.eye(3))]), position
    if joint.kind == "hinge":
        return _turns(frame[:1]), np.concatenate([drift, _turns(frame[1:])]), position
    if joint.kind == "ball":
        return _turns(np.eye(3)), drift, np.zeros(3)
    return _NONE, _NONE, np.zeros(0)


def _shortened(way: Floats, pull: Floats, length: float) -> float:
    """Factor on `pull` with which `way` is as long as `length` [m]; 0 if it is not too long.

    Where no factor does, the one with which it is shortest.
    """
    a, b, c = float(pull @ pull), float(way @ pull), float(way @ way) - length * length
    if c <= 0.0 or a == 0.0:
        return 0.0
    root = b * b - a * c
    return -b / a if root < 0.0 else (-b + math.copysign(math.sqrt(root), b)) / a


def _shifts(axes: Floats, to_child: Floats, to_parent: Floats) -> Floats:
    """Speed of the child's anchor against the parent's along axes, shape [n, 12]."""
    return np.concatenate(
        [-axes, -np.cross(to_parent, axes), axes, np.cross(to_child, axes)], axis=1
    )


def _turns(axes: Floats) -> Floats:
    """Spin of the child against the parent about axes, shape [n, 12]."""
    zero = np.zeros_like(axes)
    return np.concatenate([zero, -axes, zero, axes], axis=1)


class JointLoads:
    """What the joints of one world take, and which of them break.

    A body's momentum changes by gravity, the normal impulses of its contacts and what its joints
    give it. So the joints' impulses are those that together explain what remains of every body's
    change over a step, the smallest if they may be shared in several ways; friction of contacts
    is not told apart. A rope or spring takes what it has given. What a joint took within
    `BREAK_WINDOW_S` counts together, since a hit may take an engine more than one step.

    Args:
        scene: Its joints.
        masses: Of its bodies.
        dt: The step [s].
    """

    def __init__(self, scene: SimScene, masses: Masses, dt: float) -> None:
        self._scene, self._masses, self._dt = scene, masses, dt
        index = {name: i for i, name in enumerate(scene.names)}
        self._ends = [(index[j.child], index.get(j.parent, -1)) for j in scene.joints]
        joined = {i for ends in self._ends for i in ends if i >= 0}
        self._bodies = sorted(i for i in joined if masses.inverse[i] > 0.0)
        self._before = np.zeros((len(self._bodies), 3))
        self._damping = np.array([scene.bodies[i].linear_damping for i in self._bodies])
        self.gone: set[int] = set()
        self._share = self._shares()
        steps = max(1, round(BREAK_WINDOW_S / dt))
        self._taken: deque[Floats] = deque(maxlen=steps)

    def _shares(self) -> Floats:
        """From the bodies' unexplained momentum to the joints' impulses, shape [J, bodies]."""
        rows = {body: n for n, body in enumerate(self._bodies)}
        gives = np.zeros((len(self._bodies), len(self._ends)))
        for k, (joint, ends) in enumerate(zip(self._scene.joints, self._ends, strict=True)):
            if k not in self.gone and not joint.flexible:
                for body, sign in zip(ends, (1.0, -1.0), strict=True):
                    if body in rows:
                        gives[rows[body], k] = sign
        return np.asarray(np.linalg.pinv(gives), np.float64)

    def before(self, world: Bodies) -> None:
        """Looks at the bodies once everything that acts before the step has acted."""
        for n, body in enumerate(self._bodies):
            self._before[n] = world.read(body)[2]

    def after(self, world: Bodies, touches: Iterable[Touch], given: dict[int, float]) -> list[int]:
        """Joints that have broken in a step.

        Args:
            world: The bodies.
            touches: Of the step, the ground's as well.
            given: What each rope and spring gave [N s].
        """
        rows = {body: n for n, body in enumerate(self._bodies)}
        after = np.array([world.read(body)[2] for body in self._bodies], float)
        keep = np.maximum(0.0, 1.0 - self._damping * self._dt)[:, None]
        moved = keep * (self._before + np.array(self._scene.gravity) * self._dt)
        rest = self._masses.mass[self._bodies][:, None] * (after - moved)
        for a, b, impulse, _, _, normal in touches:
            for body, sign in ((a, 1.0), (b, -1.0)):
                if body in rows:
                    rest[rows[body]] -= sign * impulse * np.asarray(normal, float)
        taken = self._share @ rest
        for k, impulse in given.items():
            taken[k] = (impulse, 0.0, 0.0)
        self._taken.append(taken)
        load = np.linalg.norm(np.sum(self._taken, axis=0), axis=1)
        out = [
            k
            for k, joint in enumerate(self._scene.joints)
            if joint.break_impulse is not None
            and k not in self.gone
            and load[k] > joint.break_impulse
        ]
        if out:
            self.gone.update(out)
            self._share = self._shares()
        return out


def _vec(v: Floats) -> Vec:
    return float(v[0]), float(v[1]), float(v[2])
