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
from esg.engines.joints import WORLD, Floats, Joint, Motor
from esg.engines.program import Vec
from esg.engines.scene import SimScene
from esg.engines.worlds import Principal, Values, moving, principal_axes
from esg.units import quat_multiply, quat_rotate

APPROACH_RATE = 10.0
"""A motor nears a place at no more than this times the way that is left [1/s]."""
BREAK_WINDOW_S = 1.0 / 60.0
"""Over which what a joint takes adds up [s]: four steps at 240 Hz."""
STOP_ROUNDS, SETTLED = 8, 1e-9
"""How often the ropes and cones of a scene with several are gone through before a step, at most:
until none gives more than this share of the largest."""


def stops(joint: Joint) -> bool:
    """Whether a rule stops it and not the engine: a rope, a cone."""
    return joint.kind == "rope" or (joint.kind == "ball" and joint.upper is not None)


RIGID_DRIVE = 1e8
"""Damping of a drive that its limit alone holds back [N s/m or N m s/rad]."""
FARTHEST_RAD = math.radians(179.0)
"""A hinge with a limit on one side stops here on the other."""
LARGEST = 3.4e38
"""Stands for no limit in single precision."""
_ONE = np.eye(3)


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
            columns = _axes(*axes)
            inverse[i] = 1.0 / values.mass[w, i]
            inertia[i] = columns @ np.diag(1.0 / moments) @ columns.T
        where = values.position[w], values.quaternion[w]
        return Masses(*where, values.mass[w], inverse, inertia)


def in_world(joint: Joint, masses: Masses, parent: int) -> Joint:
    """The joint told by the world in place of a parent that stays where it is.

    Args:
        joint: Of the scene.
        masses: Of its bodies.
        parent: Body.
    """
    at, turn = masses.position[parent], masses.quaternion[parent]
    x, y, z = (at + quat_rotate(turn, np.array(joint.parent_anchor))).tolist()
    a, b, c, w = quat_multiply(turn, np.array(joint.parent_rotation)).tolist()
    return replace(joint, parent=WORLD, parent_anchor=(x, y, z), parent_rotation=(a, b, c, w))


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
    """A body in the world.

    Args:
        at: Centre [m], shape [3].
        axes: Of its frame, as columns, shape [3, 3].
        velocity: Linear and angular, shape [6].
        inverse: Of its mass [1/kg].
        inverse_inertia: In the world's axes [1/(kg m^2)], shape [3, 3].
    """

    at: Floats
    axes: Floats
    velocity: Floats
    inverse: float
    inverse_inertia: Floats


def _still(at: Floats, axes: Floats) -> Placed:
    return Placed(at, axes, np.zeros(6), 0.0, np.zeros((3, 3)))


@dataclass(frozen=True)
class _Held:
    """A joint with its number, its bodies (child, parent; -1 is the world) and its frames there.

    Args:
        child_anchor, parent_anchor: [m], shape [3].
        child_axes, parent_axes: As columns, shape [3, 3].
    """

    number: int
    joint: Joint
    ends: tuple[int, int]
    child_anchor: Floats
    parent_anchor: Floats
    child_axes: Floats
    parent_axes: Floats

    @staticmethod
    def of(number: int, joint: Joint, ends: tuple[int, int]) -> _Held:
        frames = (_axes(*joint.child_rotation), _axes(*joint.parent_rotation))
        anchors = np.array(joint.child_anchor, float), np.array(joint.parent_anchor, float)
        return _Held(number, joint, ends, *anchors, *frames)

    def position(self, child: Placed, parent: Placed) -> float:
        """Of a hinge or slider, as `joint_state` tells it [rad or m]."""
        frame = parent.axes @ self.parent_axes
        if self.joint.kind == "slider":
            return float(frame[:, 0] @ self.way(child, parent))
        turned = frame.T @ child.axes @ self.child_axes
        return math.atan2(turned[2, 1] - turned[1, 2], turned[1, 1] + turned[2, 2])

    def way(self, child: Placed, parent: Placed) -> Floats:
        """From the parent's anchor to the child's [m], shape [3]."""
        end = child.at + child.axes @ self.child_anchor
        return end - parent.at - parent.axes @ self.parent_anchor


def ends_of(scene: SimScene) -> list[tuple[int, int]]:
    """Child and parent of each joint of a scene, by index; -1 is the world."""
    index = {name: i for i, name in enumerate(scene.names)}
    return [(index[j.child], index.get(j.parent, -1)) for j in scene.joints]


def stop_range(joint: Joint) -> tuple[float, float] | None:
    """Where a hinge or slider stops either way [rad or m]; None if nowhere."""
    if joint.lower is None and joint.upper is None:
        return None
    far = FARTHEST_RAD if joint.kind == "hinge" else math.inf
    low = -far if joint.lower is None else max(joint.lower, -far)
    return low, far if joint.upper is None else min(joint.upper, far)


class JointRules:
    """All that joints of one world do besides holding its bodies together.

    Args:
        scene: Its joints.
        masses: Of its bodies.
        dt: The step [s].
    """

    def __init__(self, scene: SimScene, masses: Masses, dt: float) -> None:
        self.dt, self.joints, self.ends = dt, scene.joints, ends_of(scene)
        self.motors: list[Motor | None] = [j.motor for j in scene.joints]
        self._forces = JointForces(scene, masses)
        breaks = any(j.break_impulse is not None for j in scene.joints)
        self._loads = JointLoads(scene, masses, dt) if breaks else None
        self._given: dict[int, float] = {}

    def before_step(self, world: Bodies) -> dict[int, tuple[float, float]]:
        """Acts on the bodies; returns speed and greatest force of every drive by joint."""
        gone = self.gone
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
            position = self._forces.position(k, world)
        return drive_of(joint, motor, position, self.dt)

    @property
    def gone(self) -> set[int]:
        """Joints that have broken."""
        return self._loads.gone if self._loads else set()

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
        self._still = {
            i: _still(masses.position[i], _axes(*masses.quaternion[i]))
            for i in np.nonzero(masses.inverse == 0.0)[0].tolist()
        }
        self._still[-1] = _still(np.zeros(3), _ONE)
        pairs = zip(scene.joints, ends_of(scene), strict=True)
        self._held = [_Held.of(k, joint, ends) for k, (joint, ends) in enumerate(pairs)]
        elastic = [h for h in self._held if h.joint.stiffness > 0.0 or h.joint.damping > 0.0]
        # The emitted class pushes its springs before the engine draws anything back.
        self._elastic = sorted(elastic, key=lambda h: h.joint.kind != "spring")
        self._stops = [h for h in self._held if stops(h.joint)]

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
        for held in self._elastic:
            if held.number not in lost:
                impulse = self._draw(held, dt, world)
                if held.joint.kind == "spring":
                    out[held.number] = impulse
        out.update(self._hold_back(dt, world, lost))
        return out

    def position(self, joint: int, world: Bodies) -> float:
        """Of a hinge or slider, by number [rad or m]."""
        held = self._held[joint]
        child, parent = (self._placed(world, i) for i in held.ends)
        return held.position(child, parent)

    def bent(self, joints: Iterable[int], world: Bodies, part: float) -> tuple[float, float]:
        """What joints take from bodies that went straight on for a while, and what these have.

        Args:
            joints: Numbers of those that hold a group of bodies together.
            world: The bodies.
            part: How long [s].

        Returns:
            The energy of the velocity that is in the way of the joints then, and of all [J].
        """
        held = [self._held[k] for k in joints]
        names = sorted({i for h in held for i in h.ends})
        now = {i: self._placed(world, i) for i in names}
        then = {i: _moved(b, self._masses.inverse_inertia[i], part) for i, b in now.items()}
        column = {i: 6 * n for n, i in enumerate(i for i in names if i not in self._still)}
        velocity, easy = np.zeros(6 * len(column)), np.zeros((6 * len(column), 6 * len(column)))
        energy = 0.0
        for i, n in column.items():
            body = then[i]
            velocity[n : n + 6] = body.velocity
            easy[n : n + 3, n : n + 3] = body.inverse * _ONE
            easy[n + 3 : n + 6, n + 3 : n + 6] = body.inverse_inertia
            v, w = body.velocity[:3], body.velocity[3:]
            energy += 0.5 * float(
                v @ v / body.inverse + w @ np.linalg.solve(body.inverse_inertia, w)
            )
        rows, way = [], []
        for h in held:
            child, parent = h.ends
            locked = _locked(h, then[child], then[parent])
            own = np.zeros((len(locked), 6 * len(column)))
            for body, part_of in ((parent, locked[:, :6]), (child, locked[:, 6:])):
                if body in column:
                    own[:, column[body] : column[body] + 6] = part_of
            rows.append(own)
            both = np.concatenate([now[parent].velocity, now[child].velocity])
            way.append((locked - _locked(h, now[child], now[parent])) @ both)
        lock, miss = np.concatenate(rows), np.concatenate(way)
        taken = np.linalg.lstsq(lock @ easy @ lock.T, miss, rcond=1e-9)[0]
        return 0.5 * float(taken @ miss), energy

    def _draw(self, held: _Held, dt: float, world: Bodies) -> float:
        """Stiffness and damping of a joint; returns a spring's impulse [N s]."""
        pair = self._pair(held, world, stop=False)
        if not len(pair.free):
            return 0.0
        moves, axes = np.linalg.eigh(pair.free @ pair.pushed)
        impulse = np.zeros(len(pair.free))
        speeds = pair.free @ pair.velocity
        for move, axis in zip(moves.tolist(), axes.T, strict=True):
            if move > 0.0:
                by_x, by_v = kick(held.joint.stiffness, held.joint.damping, 1.0 / move, dt)
                impulse += axis * (by_x * (axis @ pair.position) + by_v * (axis @ speeds))
        velocity = pair.velocity + pair.pushed @ impulse
        self._set(world, held.ends[1], velocity[:6])
        self._set(world, held.ends[0], velocity[6:])
        return float(impulse[0])

    def _hold_back(self, dt: float, world: Bodies, gone: set[int]) -> dict[int, float]:
        """Holds ropes and cones to their limits at the end of the step.

        Returns what each rope gave [N s].
        """
        stops = [h for h in self._stops if h.number not in gone]
        given = {h.number: 0.0 for h in stops}
        near = [h for h in stops if not self._is_far(h, dt, world)]
        pairs = [(h, self._pair(h, world, stop=True)) for h in near]
        pairs = [(h, pair) for h, pair in pairs if len(pair.free)]
        speeds: dict[int, Floats] = {}
        for held, pair in pairs:
            speeds[held.ends[1]], speeds[held.ends[0]] = pair.velocity[:6], pair.velocity[6:]
        for _ in range(STOP_ROUNDS if len(pairs) > 1 else 1):
            news = 0.0
            for held, pair in pairs:
                child, parent = held.ends
                velocity = np.concatenate([speeds[parent], speeds[child]])
                more = _pull(held.joint, pair, velocity, self._gravity, dt, given[held.number])
                if more != 0.0:
                    velocity -= pair.pushed[:, 0] * more
                    speeds[parent], speeds[child] = velocity[:6], velocity[6:]
                    given[held.number] += more
                    news = max(news, abs(more))
            if news <= SETTLED * max(map(abs, given.values()), default=0.0):
                break
        for body, speed in speeds.items() if any(given.values()) else ():
            self._set(world, body, speed)
        return {h.number: given[h.number] for h in stops if h.joint.kind == "rope"}

    def _is_far(self, held: _Held, dt: float, world: Bodies) -> bool:
        """Whether a rope or cone cannot reach its limit in the step, whatever happens in it."""
        child, parent = (self._placed(world, i) for i in held.ends)
        limit = held.joint.upper or 0.0
        if held.joint.kind == "rope":
            arms = np.linalg.norm(held.child_anchor), np.linalg.norm(held.parent_anchor)
            gain = sum(
                float(np.linalg.norm(b.velocity[:3]) + arm * np.linalg.norm(b.velocity[3:]))
                for b, arm in zip((child, parent), arms, strict=True)
            )
            gain += 2.0 * dt * float(np.linalg.norm(self._gravity))
            return float(np.linalg.norm(held.way(child, parent))) + gain * dt < limit
        own = child.axes @ held.child_axes[:, 0]
        given = parent.axes @ held.parent_axes[:, 0]
        spin = child.velocity[3:] - parent.velocity[3:]
        angle = math.acos(max(-1.0, min(1.0, float(own @ given))))
        return angle + dt * (float(np.linalg.norm(spin)) + 1.0) < limit

    def _set(self, world: Bodies, body: int, velocity: Floats) -> None:
        if body not in self._still:
            x, y, z, a, b, c = velocity.tolist()
            world.set_linear(body, (x, y, z))
            world.set_angular(body, (a, b, c))

    def _pair(self, held: _Held, world: Bodies, *, stop: bool) -> _Pair:
        child, parent = (self._placed(world, i) for i in held.ends)
        return _pair(held, child, parent, stop)

    def _placed(self, world: Bodies, body: int) -> Placed:
        """A body as it is; -1 is the world."""
        if body in self._still:
            return self._still[body]
        at, (x, y, z, w), linear, angular = world.read(body)
        axes = _axes(float(x), float(y), float(z), float(w))
        return Placed(
            np.array(at, float),
            axes,
            np.array([*linear, *angular], float),
            float(self._masses.inverse[body]),
            axes @ self._masses.inverse_inertia[body] @ axes.T,
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
        return response @ np.linalg.solve(self.locked @ response, speeds)

    def gravity(self, gain: Floats) -> Floats:
        """What gravity adds to the velocity of what moves."""
        out = np.zeros(12)
        for n in (0, 6):
            if self.easy[n, n] > 0.0:
                out[n : n + 3] = gain
        return out


def _pair(held: _Held, child: Placed, parent: Placed, stop: bool) -> _Pair:
    to_child = child.axes @ held.child_anchor
    way = held.way(child, parent)
    drift = _shifts(_ONE, to_child, parent.axes @ held.parent_anchor)
    if held.joint.flexible:
        free, locked, position = _along(held.joint, way, drift)
    elif stop:
        free, locked, position = _beyond_cone(held, child, parent, drift)
    else:
        free, locked, position = _drawn(held, child, parent, drift)
    # Columns: linear and angular velocity of the parent, then of the child.
    easy = np.zeros((12, 12))
    for n, body in ((0, parent), (6, child)):
        if body.inverse > 0.0:
            easy[n : n + 3, n : n + 3] = body.inverse * _ONE
            easy[n + 3 : n + 6, n + 3 : n + 6] = body.inverse_inertia
    velocity = np.concatenate([parent.velocity, child.velocity])
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


def _beyond_cone(held: _Held, child: Placed, parent: Placed, drift: Floats) -> Rows:
    """Of a ball joint: the turn that opens the angle between its axes."""
    own = child.axes @ held.child_axes[:, 0]
    given = parent.axes @ held.parent_axes[:, 0]
    axis = _cross(given) @ own
    size = float(np.linalg.norm(axis))
    if size < 1e-9:
        return _NONE, drift, np.zeros(0)
    angle = math.atan2(size, float(given @ own))
    return _turns((axis / size)[None]), drift, np.array([angle - (held.joint.upper or 0.0)])


def _drawn(held: _Held, child: Placed, parent: Placed, drift: Floats) -> Rows:
    """Of the other kinds: what they leave free."""
    kind = held.joint.kind
    if kind == "ball":
        return _turns(_ONE), drift, np.zeros(3)
    if kind not in ("hinge", "slider"):
        return _NONE, _NONE, np.zeros(0)
    frame = (parent.axes @ held.parent_axes).T
    position = np.array([held.position(child, parent)])
    if kind == "slider":
        # The rail pushes where the child is.
        to_child = child.axes @ held.child_anchor
        shifts = _shifts(frame, to_child, child.at + to_child - parent.at)
        return shifts[:1], np.concatenate([shifts[1:], _turns(_ONE)]), position
    return _turns(frame[:1]), np.concatenate([drift, _turns(frame[1:])]), position


def _locked(held: _Held, child: Placed, parent: Placed) -> Floats:
    """Velocities of parent and child that a joint which the engine holds locks, shape [L, 12]."""
    drift = _shifts(_ONE, child.axes @ held.child_anchor, parent.axes @ held.parent_anchor)
    if held.joint.kind == "fixed":
        return np.concatenate([drift, _turns(_ONE)])
    return _drawn(held, child, parent, drift)[1]


def _moved(body: Placed, inverse_inertia: Floats, part: float) -> Placed:
    """The body once it went straight on, its velocity as it was."""
    if body.inverse == 0.0:
        return body
    axes = body.axes + part * _cross(body.velocity[3:]) @ body.axes
    return replace(
        body,
        at=body.at + part * body.velocity[:3],
        axes=axes,
        inverse_inertia=axes @ inverse_inertia @ axes.T,
    )


def _pull(
    joint: Joint, pair: _Pair, velocity: Floats, gravity: Floats, dt: float, given: float
) -> float:
    """What a rope or cone has to give besides `given`, against what is free [N s or N m s].

    Args:
        joint: It.
        pair: Its bodies as they stand.
        velocity: Of parent and child, shape [12].
        gravity: [m/s^2], shape [3].
        dt: The step [s].
        given: In this step so far; no rope pushes.
    """
    falling = velocity + pair.gravity(gravity * dt)
    if len(pair.locked):
        falling = falling - pair.held(pair.locked @ falling)
    move = float(pair.free[0] @ pair.pushed[:, 0])
    if not move > 0.0:
        return 0.0
    if joint.kind == "rope":
        # The way of the anchors is straight, which its length along their line is not.
        way = pair.way + dt * (pair.drift @ falling)
        pull = dt * (pair.drift @ pair.pushed[:, 0])
        need = _shortened(way, pull, joint.upper or 0.0)
    else:
        need = -(float(pair.position[0]) + dt * float(pair.free[0] @ falling)) / (dt * move)
    return max(-need, -given)


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
    return np.concatenate([-axes, axes @ _cross(to_parent), axes, -axes @ _cross(to_child)], axis=1)


def _turns(axes: Floats) -> Floats:
    """Spin of the child against the parent about axes, shape [n, 12]."""
    out = np.zeros((len(axes), 12))
    out[:, 3:6], out[:, 9:] = -axes, axes
    return out


def _cross(v: Floats) -> Floats:
    """The matrix that multiplies a vector by v from the left, shape [3, 3]."""
    x, y, z = v.tolist()
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def _axes(x: float, y: float, z: float, w: float) -> Floats:
    """Axes of a frame turned by a quaternion, as columns, shape [3, 3]."""
    return np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )


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
        self._ends = ends_of(scene)
        joined = {i for ends in self._ends for i in ends if i >= 0}
        self._bodies = sorted(i for i in joined if masses.inverse[i] > 0.0)
        self._rows = {body: n for n, body in enumerate(self._bodies)}
        self._before = np.zeros((len(self._bodies), 3))
        self._damping = np.array([scene.bodies[i].linear_damping for i in self._bodies])
        self.gone: set[int] = set()
        self._share = self._shares()
        steps = max(1, round(BREAK_WINDOW_S / dt))
        self._taken: deque[Floats] = deque(maxlen=steps)

    def _shares(self) -> Floats:
        """From the bodies' unexplained momentum to the joints' impulses, shape [J, bodies]."""
        gives = np.zeros((len(self._bodies), len(self._ends)))
        for k, (joint, ends) in enumerate(zip(self._scene.joints, self._ends, strict=True)):
            if k not in self.gone and not joint.flexible:
                for body, sign in zip(ends, (1.0, -1.0), strict=True):
                    if body in self._rows:
                        gives[self._rows[body], k] = sign
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
        after = np.array([world.read(body)[2] for body in self._bodies], float)
        keep = np.maximum(0.0, 1.0 - self._damping * self._dt)[:, None]
        moved = keep * (self._before + np.array(self._scene.gravity) * self._dt)
        rest = self._masses.mass[self._bodies][:, None] * (after - moved)
        for a, b, impulse, _, _, normal in touches:
            for body, sign in ((a, 1.0), (b, -1.0)):
                if body in self._rows:
                    rest[self._rows[body]] -= sign * impulse * np.asarray(normal, float)
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
