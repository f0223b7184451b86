"""The reference executor of control programs, for engines that step one world at a time.

It implements the semantics stated in `esg.engines.program` word for word in double precision; the
Warp kernel of the Newton engine is tested against it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
import math
from typing import Any, Protocol

import numpy as np

from esg.engines.breaking.stances import Changes, fill_in, own_names, stances
from esg.engines.joints import Motor
from esg.engines.program import (
    GUIDE_RATE,
    KNOT_FIELDS,
    Action,
    Column,
    ProgramBatch,
    Vec,
    buoyed,
    path_point,
)
from esg.engines.scene import ContactLog, Floats
from esg.engines.traction import Traction, features
from esg.engines.worlds import MAX_SPEED_MPS, ContactRecorder, Frames, Start, join_logs
from esg.units import GRAVITY_MPS2


class BodyAccess(Protocol):
    """What the executor needs from a world: velocities and properties by body index."""

    def position(self, body: int) -> Vec: ...
    def linear(self, body: int) -> Vec: ...
    def set_linear(self, body: int, velocity: Vec) -> None: ...
    def set_flight(self, body: int, velocity: Vec, pull: float) -> None:
        """Velocity after gravity has added `pull` [m/s] to its vertical part in the next step."""
        ...

    def set_angular(self, body: int, velocity: Vec) -> None: ...
    def mass(self, body: int) -> float: ...
    def read(self, body: int) -> tuple[Any, Any, Any, Any]:
        """Position, quaternion (x, y, z, w), linear and angular velocity."""
        ...

    def set_linear_damping(self, body: int, damping: float) -> None: ...
    def set_angular_damping(self, body: int, damping: float) -> None: ...
    def set_friction(self, body: int, friction: float) -> None: ...
    def set_motor(self, joint: int, motor: Motor | None) -> None:
        """Gives a joint, by index, another motor, or none."""
        ...


Touch = tuple[int, int, float, float, Any, Any]
"""(a, b, impulse [N s], depth [m], point [m], unit normal from b to a); the ground is -1."""


def touch_order(touch: Touch) -> tuple[float, ...]:
    """Bodies, then the strongest contact, then its place: nothing that memory decides."""
    a, b, impulse, depth, (x, y, z), _ = touch
    place = (float(x), float(y), float(z))
    return (a, b, -impulse, depth, *place) if a < b else (b, a, -impulse, depth, *place)


class World(BodyAccess, Protocol):
    """One world that can be stepped."""

    moving: list[int]
    """Indices of the bodies whose state changes."""

    def step(self) -> None: ...
    def states(self) -> dict[int, tuple[Any, Any, Any, Any]]:
        """Pose and velocities of bodies that are not there: fragments, what has broken."""
        ...

    def placed(self, body: int) -> tuple[float, ...]:
        """Position [m] and quaternion (x, y, z, w), seven numbers."""
        ...

    def motion(self, body: int) -> tuple[float, ...]:
        """Linear [m/s] and angular velocity [rad/s], six numbers."""
        ...

    def contacts(self, ground: bool) -> Iterator[Touch]:
        """Pairs that touched in the last step; contacts with the ground only if asked for."""
        ...


class Executor:
    """Executes one world's program step by step.

    Args:
        batch: W programs.
        world: Which of them.
        gravity_z: Of the scene, which powered flight works against [m/s^2].
        rows: `esg.engines.traction.features` of the bodies; None if all move and none is
            round or has tyres.
        joints: Names of the scene's joints.
        changes: Who changes his posture; None for nobody.
    """

    def __init__(
        self,
        batch: ProgramBatch,
        world: int,
        gravity_z: float = -GRAVITY_MPS2,
        rows: Floats | None = None,
        joints: Sequence[str] = (),
        changes: Changes | None = None,
    ) -> None:
        self._changes = changes
        self._gravity_z = gravity_z
        self._traction = Traction(batch, world, rows, gravity_z)
        self._kind = [Action(k) for k in batch.kind]
        self._body = [int(b) for b in batch.body]
        self._rows = [[float(v) for v in row] for row in batch.table[world]]
        self._joint = [list(joints).index(name) if name else -1 for name in batch.joint]
        self._until = [frozenset(np.nonzero(u)[0].tolist()) for u in batch.until]
        n = len(self._kind)
        self._done = [False] * n
        self._active = [False] * n
        self._pending = list(range(n))

    def before_step(
        self, t: float, dt: float, touched: Iterable[tuple[int, int]], world: BodyAccess
    ) -> None:
        """Does what the program asks for before the step from t to t + dt.

        Args:
            t: Time of the state [s].
            dt: Physics step [s].
            touched: Body pairs (a < b) with a normal impulse > 0 in the step before this one.
            world: The bodies.
        """
        self._traction.look(dt, world)
        driven = self._act(t, dt, set(touched), world) if self._pending else {}
        self._traction.act(dt, driven, world)

    def _act(
        self, t: float, dt: float, hits: set[tuple[int, int]], world: BodyAccess
    ) -> dict[int, float]:
        """Executes the primitives; returns the bodies whose velocity a hold or a guide has set, and
        the vertical velocity that they start the step with [m/s]."""
        driven: dict[int, float] = {}
        now = t + 0.5 * dt
        for k in self._pending:
            row, body = self._rows[k], self._body[k]
            if self._kind[k] >= Action.HOLD:
                if self._is_active(k, now, hits):
                    pull = self._gravity_z * dt
                    if self._kind[k] is Action.HOLD:
                        driven[body] = _hold(row, body, t, dt, world, pull)
                    elif self._kind[k] is Action.GUIDE:
                        driven[body] = _guide(row, body, t, dt, world, pull)
                    elif self._kind[k] is Action.BUOY:
                        _buoy(row, body, dt, world)
                    else:
                        world.set_angular(body, _vector(row, Column.SPIN))
            elif row[Column.START] <= now:
                self._done[k] = True
                if self._kind[k] is Action.DRIVE:
                    world.set_motor(self._joint[k], _motor(row))
                elif self._kind[k] is Action.CHANGE:
                    if self._changes is not None:
                        self._changes.change(body, row, world)
                else:
                    _fire(self._kind[k], row, body, world)
                if self._kind[k] is Action.ADJUST and not math.isnan(row[Column.BRAKING]):
                    self._traction.set_braking(body, row[Column.BRAKING])
        self._pending = [k for k in self._pending if not self._done[k]]
        return driven

    def _is_active(self, k: int, now: float, hits: set[tuple[int, int]]) -> bool:
        body, row = self._body[k], self._rows[k]
        if self._active[k] and any(
            (min(body, other), max(body, other)) in hits for other in self._until[k]
        ):
            self._done[k] = True
        if now > row[Column.END]:
            self._done[k] = True
        if not self._done[k] and row[Column.START] <= now:
            self._active[k] = True
        return self._active[k] and not self._done[k]


def play_all(start: Start, world: Callable[[int], World], ground_contacts: bool) -> ContactLog:
    """Steps every sound world of a rollout, one after the other.

    Args:
        start: Arrays of the rollout; states and validity are written.
        world: Makes the world of a number.
        ground_contacts: Whether the log includes contacts with the ground.
    """
    logs: list[ContactLog] = []
    for w in range(start.batch.n_worlds):
        if not start.valid[w]:
            continue
        recorder = ContactRecorder(w, start.frames)
        rows = features(start.scene, float(start.values.friction_scale[w]))
        joints = [j.name for j in start.scene.joints]
        changes = Changes(start.scene) if stances(start.scene) else None
        program = Executor(start.batch, w, start.scene.gravity[2], rows, joints, changes)
        played = world(w)
        if changes is not None:
            changes.open(played)
        start.valid[w] = play(
            played, program, start.frames, start.states, recorder, ground_contacts
        )
        logs.append(recorder.log())
    log = join_logs(logs)
    if stances(start.scene):
        fill_in(start.scene, start.batch, start.frames.time, start.frames.dt, start.states)
        log = own_names(start.scene, log)
    return log


def play(
    world: World,
    program: Executor,
    frames: Frames,
    states: tuple[Any, Any, Any, Any],
    recorder: ContactRecorder,
    ground_contacts: bool,
) -> bool:
    """Steps one world through all frames.

    Args:
        world: The world in its initial state.
        program: Its control program.
        frames: The time grid.
        states: Arrays of the rollout (`esg.engines.worlds.rest_states`); the row of the recorder's
            world is written.
        recorder: Receives the contacts.
        ground_contacts: Whether they include those with the ground.

    Returns:
        Whether the world stayed finite and slower than 500 m/s. When it does not, stepping stops
        and the remaining frames repeat the last sound one.
    """
    w = recorder.world
    touched: list[tuple[int, int]] = []
    tape = _Tape(world)
    for step in range(frames.n_steps):
        program.before_step(step * frames.dt, frames.dt, touched, world)
        world.step()
        touched = []
        for a, b, impulse, depth, point, normal in world.contacts(ground_contacts):
            recorder.add(step, a, b, impulse, depth, point, normal)
            touched.append((min(a, b), max(a, b)))
        frame, rest = divmod(step + 1, frames.record_every)
        if rest == 0 and not tape.add(frame):
            tape.write(states, w)
            for array in states:
                array[w, frame:] = array[w, frame - 1]
            recorder.drop_from(frame)
            return False
    tape.write(states, w)
    return True


class _Tape:
    """Poses and velocities of a world's bodies, frame after frame, until they are written at once.

    Numpy takes as long to store three numbers as an engine to step a body.

    Args:
        world: The world.
    """

    def __init__(self, world: World) -> None:
        self._world = world
        self._at: list[int] = []
        self._rows: list[float] = []

    def add(self, frame: int) -> bool:
        """Takes the bodies as they are; whether all are finite and slower than they may be."""
        world = self._world
        there = [(i, world.placed(i) + world.motion(i)) for i in world.moving]
        for i, state in world.states().items():
            there.append((i, tuple(float(v) for part in state for v in part)))
        for i, row in there:
            self._at += (frame, i)
            self._rows += row
            if not _sound(row):
                return False
        return True

    def write(self, states: tuple[Any, Any, Any, Any], w: int) -> None:
        """Writes the rows into the arrays of a rollout."""
        rows = np.array(self._rows, float).reshape(-1, 13)
        frame, body = np.array(self._at, np.intp).reshape(-1, 2).T
        for array, part in zip(states, np.split(rows, (3, 7, 10), axis=1), strict=True):
            array[w, frame, body] = part


def _sound(row: tuple[float, ...]) -> bool:
    """Whether the 13 numbers of a body are finite, and it is no faster than it may be."""
    _, _, _, _, _, _, _, x, y, z, _, _, _ = row
    # The comparison is also false for NaN.
    return x * x + y * y + z * z <= MAX_SPEED_MPS**2 and math.isfinite(sum(row))


def _fire(kind: Action, row: list[float], body: int, world: BodyAccess) -> None:
    if kind is Action.SET_VELOCITY:
        world.set_linear(body, _vector(row, Column.LINEAR))
        if not math.isnan(row[Column.ANGULAR]):
            world.set_angular(body, _vector(row, Column.ANGULAR))
    elif kind is Action.APPLY_IMPULSE:
        v, p, m = world.linear(body), _vector(row, Column.IMPULSE), world.mass(body)
        world.set_linear(body, (v[0] + p[0] / m, v[1] + p[1] / m, v[2] + p[2] / m))
    elif kind is Action.ADJUST:
        for column, change in (
            (Column.LINEAR_DAMPING, world.set_linear_damping),
            (Column.ANGULAR_DAMPING, world.set_angular_damping),
            (Column.FRICTION, world.set_friction),
        ):
            if not math.isnan(row[column]):
                change(body, row[column])


def _motor(row: list[float]) -> Motor | None:
    speed, position = row[Column.MOTOR_SPEED], row[Column.MOTOR_POSITION]
    if math.isnan(speed) and math.isnan(position):
        return None
    return Motor(
        0.0 if math.isnan(speed) else speed,
        None if math.isnan(position) else position,
        row[Column.MOTOR_LIMIT],
    )


def _vector(row: list[float], column: Column) -> Vec:
    return row[column], row[column + 1], row[column + 2]


def _buoy(row: list[float], body: int, dt: float, world: BodyAccess) -> None:
    """Bears a body up where it is in its liquid; one that is not stays as it is."""
    x, turn, v, w = world.read(body)
    a, b, c, d = (float(q) for q in turn)
    up = (2.0 * (a * c - d * b), 2.0 * (b * c + d * a), 1.0 - 2.0 * (a * a + b * b))
    found = buoyed(row, x, up, v, w, dt)
    if found is not None:
        world.set_linear(body, found[0])
        world.set_angular(body, found[1])


def _guide(
    row: list[float], body: int, t: float, dt: float, world: BodyAccess, pull: float
) -> float:
    """Moves a body along its path; `pull` is what gravity adds in the step [m/s].

    Returns:
        The vertical velocity that it starts the step with [m/s].
    """
    s, n = t - row[Column.START], int(row[Column.KNOTS])
    knots = [Column.KNOT + KNOT_FIELDS * k for k in range(n)]
    times = [row[k] for k in knots]
    points = [(row[k + 1], row[k + 2], row[k + 3]) for k in knots]
    velocities = [(row[k + 4], row[k + 5], row[k + 6]) for k in knots]
    here = path_point(times, points, velocities, s)
    there = path_point(times, points, velocities, s + dt)
    x = world.position(body)
    v = [(there[i] - here[i]) / dt + GUIDE_RATE * (here[i] - x[i]) for i in range(3)]
    world.set_flight(body, (v[0], v[1], v[2]), pull)
    world.set_angular(body, (0.0, 0.0, row[Column.GUIDE_TURN_RATE]))
    return v[2] - pull


def _hold(
    row: list[float], body: int, t: float, dt: float, world: BodyAccess, pull: float
) -> float:
    """Drives a body; `pull` is what gravity adds to its vertical velocity in the step [m/s].

    Returns:
        The vertical velocity that it starts the step with [m/s].
    """
    s, acceleration = t - row[Column.START], row[Column.ACCELERATION]
    speed = max(0.0, row[Column.SPEED] + acceleration * s)
    if acceleration > 0.0:
        speed = min(speed, row[Column.MAX_SPEED])
    heading = row[Column.HEADING] + row[Column.TURN_RATE] * s
    vx, vy = speed * math.cos(heading), speed * math.sin(heading)
    if not math.isnan(row[Column.GAINS]):
        x, y, _ = world.linear(body)
        before = heading - row[Column.TURN_RATE] * dt
        gains, loses = row[Column.GAINS] * dt, row[Column.LOSES] * dt
        along = math.cos(before) * x + math.sin(before) * y
        across = math.cos(before) * y - math.sin(before) * x
        along += max(-loses, min(gains, speed - along))
        across -= max(-loses, min(loses, across))
        vx = math.cos(heading) * along - math.sin(heading) * across
        vy = math.sin(heading) * along + math.cos(heading) * across
    radius, climb = row[Column.ROLL_RADIUS], row[Column.CLIMB]
    flies = not math.isnan(climb)
    rise = climb - pull if flies else world.linear(body)[2]
    if flies:
        world.set_flight(body, (vx, vy, climb), pull)
    else:
        world.set_linear(body, (vx, vy, rise))
    if flies or radius == 0.0:
        world.set_angular(body, (0.0, 0.0, row[Column.TURN_RATE]))
    else:
        world.set_angular(body, (-vy / radius, vx / radius, 0.0))
    return rise
