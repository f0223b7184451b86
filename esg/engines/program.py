"""The control program: the one executable meaning of a timeline and its theta.

An ordered list of timed atomic primitives on named bodies. Every engine executes it with the same
semantics. Before the physics step that leads from t to t + dt, in list order:

* `SetVelocity`, `ApplyImpulse` and `AdjustProperties` whose `time` <= t + dt/2 and that have not
  fired yet fire once.
* A `HoldVelocity` is active from the first step with `start` <= t + dt/2 until t + dt/2 > `end`, or
  until its body has touched (normal impulse > 0 in an earlier step, at or after `start`) one of
  `until_contact`; it never becomes active again. While active it sets, with s = t - start,
  speed = max(0, speed + acceleration s) clipped to `max_speed` for positive acceleration,
  heading = heading + turn_rate s; horizontal velocity = speed (cos heading, sin heading); the
  vertical velocity is kept. Angular velocity: (0, 0, turn_rate) for bodies with roll_radius = 0;
  otherwise that of rolling without slipping, (-vy, vx, 0) / roll_radius.
  With a `climb` (powered flight) the vertical velocity becomes climb - g_z dt, which the gravity
  of the step turns into `climb`; the body does not roll, whatever its roll_radius.
  With `gains` and `loses` the horizontal velocity comes to that one by and by, from what the body
  has: turned by turn_rate dt, along the heading by at most gains dt a step, or loses dt where it
  is too fast, and across it by loses dt. So what a hit has slowed down takes its time to go on.
* A `GuideAlong` is active as a hold is, with end = start + times[-1]. Its path P(s) is the cubic
  Hermite curve through `points` with `velocities` at `times`, and straight on with the first or
  last velocity outside of them. While active it sets, with s = t - start and x the centre of mass,
  linear velocity = (P(s + dt) - P(s)) / dt + GUIDE_RATE (P(s) - x), its vertical part less g_z dt,
  and angular velocity = (0, 0, turn_rate). Let go, the body keeps what it has.
* A `HoldSpin` is active as a hold is. While active it sets angular velocity = rate times the unit
  vector along `axis`, in the world's axes; the linear velocity is left to physics.
* A `BuoyUp` is active from the first step with `start` <= t + dt/2 until t + dt/2 > `end`. Its
  basin of liquid stays where it is: a box that reaches `basin` to either side of `center` along
  `heading` and across it, and 2 `basin`[2] down from its level, `center`. While active, of a body
  whose centre of mass x is between its sides and not below its bottom, with
  h = |R_z| . `extents`, where R_z is the vertical row of its rotation matrix, and
  u = clip((level - x_z + h) / 2h, 0, 1): f = u, or u^2 (3 - 2u) of what is `round`, is the share
  of it in the liquid. Then v becomes v / (1 + f dt (`linear_drag` + `quadratic_drag` |v|)),
  f `lift` dt is added to its vertical part, and w becomes w / (1 + f dt `turning_drag`). A later
  hold or guide of the same body sets what it sets.
* After them, the brakes act on every body whose `braking` an `AdjustProperties` has set: its
  horizontal velocity loses min(|v_h|, braking dt), and the horizontal part of the angular velocity
  of a body with roll_radius > 0 the same share, so that what rolls goes on without slipping. Of an
  upright body with a `tyre_drop` it is the part along its X axis: the rest is its tyres' to brake.
* Then the tyres of a wheeled body with `tyre_friction` mu act while it is upright: its up axis is
  within 45 degrees of the vertical. With k = sqrt(Izz / m) and q = m h / Ixx (body axes), f the
  horizontal part of its X axis as a unit vector, s = z x f, u its Z axis, h = `tyre_drop` u.z +
  `tyre_foot` |u.s| (how high it is over the edge that what leans stands on), limit =
  sqrt((mu g dt)^2 - l^2) where l is what the brakes have taken (none if l is larger): the slips
  of its axles are (v.s + h w.f) / (1 + h q) + k w_z and (...) - k w_z, each clipped to
  +-limit; with their half sum a and half difference b, v loses a s, w loses q a f + b / k z.
  So a body is pushed to the side by at most mu m g, and kept from turning about the vertical.
* A two-wheeler (`tyre_drop` > 0) whose horizontal velocity has changed by more than BLOW_MPS
  (`esg.engines.traction`) in the last step, from after all this to before the primitives, has lost
  its balance: in the next step in which these act, if it is upright and no drive has come first,
  |w.f| is raised to sqrt(TIPPING_RAD_S^2 + 2 m g (r - c) / (Ixx + m r^2)), with c = `tyre_drop`,
  d = `tyre_foot` and r = |(c, d)|, keeping its sign; if it is less than LEAST_LEAN_RAD_S the one
  that tilts the body further (positive, to the right, up to a tilt of LEAST_TILT). It turns about
  the edge of its foot: v gains what w.f gains times f x a, where a is (0, +-d, c) in its axes, with
  the sign of w.f.
* A `DriveJoint` fires as `SetVelocity` does: from then on the joint has that motor instead of the
  one it had, or none (`esg.engines.joints.Motor`).
* A `ChangeBody` fires as `SetVelocity` does: `into`, which stands in for `body` in another posture,
  is there from then on instead of what was there of it before, with its velocities: where it lies
  by the scene's poses of both, turning with it (`esg.engines.breaking.stances`); with a
  `position` it rests there, as if `body` had come there. What the program asks of
  `body` later it asks of the one that is there.
* Brakes and tyres do not act in a step in which a hold or a guide sets the body's velocity, nor on
  what nothing carries: a body that lost more than g dt / 2 of its vertical velocity in the last
  step, from after all this to before the primitives (in the first step everything is carried).

Damping is applied by every engine as v *= max(0, 1 - c dt) once per step.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import asdict, dataclass, fields, replace
from enum import IntEnum
from itertools import pairwise
import math
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

PROGRAM_VERSION = 1

Vec = tuple[float, float, float]


@dataclass(frozen=True)
class SetVelocity:
    """Sets linear [m/s] and, where given, angular [rad/s] velocity of `body` at `time` [s]."""

    kind: ClassVar[str] = "SetVelocity"
    body: str
    time: float
    linear: Vec
    angular: Vec | None = None


@dataclass(frozen=True)
class ApplyImpulse:
    """Applies `impulse` [N s] at the centre of mass of `body` at `time` [s]."""

    kind: ClassVar[str] = "ApplyImpulse"
    body: str
    time: float
    impulse: Vec


@dataclass(frozen=True)
class AdjustProperties:
    """Changes properties of `body` at `time` [s]; None leaves one as it is.

    Args:
        body: Name.
        time: [s].
        linear_damping, angular_damping: [1/s].
        friction: Friction coefficient.
        braking: Deceleration by its brakes from then on (module docstring) [m/s^2]; 0 lets go.
    """

    kind: ClassVar[str] = "AdjustProperties"
    body: str
    time: float
    linear_damping: float | None = None
    angular_damping: float | None = None
    friction: float | None = None
    braking: float | None = None


@dataclass(frozen=True)
class DriveJoint:
    """Sets the motor of a hinge or slider at `time` [s]; without speed and position it lets go.

    Args:
        joint: Name.
        time: [s].
        speed: [rad/s or m/s]; with a position, the greatest on the way there, None for any.
        position: That it drives to [rad or m].
        limit: Greatest torque or force [N m or N]; may be math.inf.
    """

    kind: ClassVar[str] = "DriveJoint"
    joint: str
    time: float
    speed: float | None = None
    position: float | None = None
    limit: float = math.inf

    @property
    def body(self) -> str:
        """It moves no body by name."""
        return ""

    @property
    def lets_go(self) -> bool:
        """Whether the joint has no motor from then on."""
        return self.speed is None and self.position is None


@dataclass(frozen=True)
class ChangeBody:
    """Lets `into` be there instead of `body`, or `body` itself again, from `time` [s] on.

    Args:
        body: Name.
        time: [s].
        into: Name of the body that is there from then on.
        position: Where `body` would be then [m]; None where it is.
        heading: Which way it would face there [rad].
    """

    kind: ClassVar[str] = "ChangeBody"
    body: str
    time: float
    into: str
    position: Vec | None = None
    heading: float = 0.0


@dataclass(frozen=True)
class HoldVelocity:
    """Motion of `body` under its own power (module docstring).

    Args:
        body: Name of the driven body.
        start, end: [s]; `end` may be math.inf.
        speed: At `start` [m/s].
        heading: At `start` [rad], 0 along +X, counter-clockwise positive.
        acceleration: [m/s^2], may be negative.
        max_speed: Upper limit with positive acceleration [m/s].
        turn_rate: [rad/s], counter-clockwise positive.
        roll_radius: Of a rolling round body [m], else 0.
        until_contact: Names of bodies whose touch ends the hold.
        climb: Vertical velocity held against gravity [m/s], 0 in level flight; None keeps the
            vertical velocity the body has.
        gains, loses: How fast it comes to that speed, at most, where that is faster, or slower or
            another way [m/s^2]; None for at once. Both or none.
    """

    kind: ClassVar[str] = "HoldVelocity"
    body: str
    start: float
    end: float
    speed: float
    heading: float
    acceleration: float = 0.0
    max_speed: float = 500.0
    turn_rate: float = 0.0
    roll_radius: float = 0.0
    until_contact: tuple[str, ...] = ()
    climb: float | None = None
    gains: float | None = None
    loses: float | None = None

    @property
    def time(self) -> float:
        return self.start


MAX_KNOTS = 6
"""Points of a guided path."""
GUIDE_RATE = 10.0
"""How fast a guided body that is off its path returns to it [1/s]; what is in its way is pushed no
faster than its lag grows."""


@dataclass(frozen=True)
class GuideAlong:
    """Moves `body` along a path without turning it over, until it is let go (module docstring).

    Args:
        body: Name of the guided body.
        start: [s].
        times: Of the points since `start` [s]: 2 to MAX_KNOTS numbers, the first 0, rising.
        points: Where the centre of mass shall be then [m].
        velocities: How fast it shall move there [m/s].
        turn_rate: [rad/s] about the vertical, counter-clockwise positive.
        until_contact: Names of bodies whose touch ends it.

    Raises:
        ValueError: If the points are too few or too many, or their times do not rise from 0.
    """

    kind: ClassVar[str] = "GuideAlong"
    body: str
    start: float
    times: tuple[float, ...]
    points: tuple[Vec, ...]
    velocities: tuple[Vec, ...]
    turn_rate: float = 0.0
    until_contact: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        n, times = len(self.times), self.times
        if not 2 <= n <= MAX_KNOTS or len(self.points) != n or len(self.velocities) != n:
            raise ValueError(
                f"path of {self.body!r} has {n} times, {len(self.points)} points and "
                f"{len(self.velocities)} velocities; it needs 2 to {MAX_KNOTS} of each"
            )
        if times[0] != 0.0 or not all(a < b for a, b in pairwise(times)):
            raise ValueError(f"times {list(times)} of the path of {self.body!r} must rise from 0")

    @property
    def time(self) -> float:
        return self.start

    @property
    def end(self) -> float:
        return self.start + self.times[-1]

    def at(self, s: float) -> Vec:
        """Where the path is `s` seconds after its start [m]."""
        return path_point(self.times, self.points, self.velocities, s)


def buoyed(
    row: Sequence[float],
    x: Sequence[float],
    up: Sequence[float],
    v: Sequence[float],
    w: Sequence[float],
    dt: float,
) -> tuple[Vec, Vec] | None:
    """Linear and angular velocity of a body after a `BuoyUp`; None where it is in no liquid.

    Args:
        row: Numbers of the primitive in the order of `Column`.
        x: Centre of mass [m].
        up: Vertical parts of the axes of the body: the last row of its rotation matrix.
        v, w: Linear [m/s] and angular [rad/s] velocity.
        dt: Physics step [s].
    """
    across, along = math.sin(row[Column.BASIN_HEADING]), math.cos(row[Column.BASIN_HEADING])
    east, north, down = (float(x[i]) - row[Column.LEVEL + i] for i in range(3))
    length, width, depth = row[Column.BASIN : Column.BASIN + 3]
    if abs(along * east + across * north) > length or abs(along * north - across * east) > width:
        return None
    half = sum(abs(float(up[i])) * row[Column.EXTENTS + i] for i in range(3))
    share = min(1.0, 0.5 * (half - down) / half)
    if share <= 0.0 or down < -2.0 * depth:
        return None
    if row[Column.ROUND] > 0.0:
        share = share * share * (3.0 - 2.0 * share)
    wet = share * dt
    speed = math.sqrt(sum(float(a) * float(a) for a in v))
    kept = 1.0 / (1.0 + wet * (row[Column.LINEAR_DRAG] + row[Column.QUADRATIC_DRAG] * speed))
    turned = 1.0 / (1.0 + wet * row[Column.TURNING_DRAG])
    rise = float(v[2]) * kept + wet * row[Column.LIFT]
    return (
        (float(v[0]) * kept, float(v[1]) * kept, rise),
        _vec(float(a) * turned for a in w),
    )


def path_point(
    times: Sequence[float], points: Sequence[Vec], velocities: Sequence[Vec], s: float
) -> Vec:
    """A point of a guided path (module docstring) [m].

    Args:
        times, points, velocities: Of a `GuideAlong`.
        s: Time since its start [s].
    """
    last = len(times) - 1
    if s <= times[0] or s >= times[last]:
        k = 0 if s <= times[0] else last
        return _vec(p + v * (s - times[k]) for p, v in zip(points[k], velocities[k], strict=True))
    k = max(i for i in range(last) if times[i] <= s)
    h = times[k + 1] - times[k]
    u = (s - times[k]) / h
    a, b = u * u * (3.0 - 2.0 * u), u * (1.0 - u)
    from_here, to_there = h * b * (1.0 - u), h * b * u
    ends = zip(points[k], points[k + 1], velocities[k], velocities[k + 1], strict=True)
    return _vec(p + a * (q - p) + from_here * v - to_there * w for p, q, v, w in ends)


def _vec(values: Iterable[float]) -> Vec:
    x, y, z = values
    return x, y, z


@dataclass(frozen=True)
class HoldSpin:
    """Keeps `body` spinning, wherever it goes (module docstring).

    Args:
        body: Name of the spinning body.
        start, end: [s]; `end` may be math.inf.
        rate: [rad/s], positive by the right hand about `axis`.
        axis: In the world's axes, of any length but 0.
        until_contact: Names of bodies whose touch ends it.

    Raises:
        ValueError: If the axis has no length.
    """

    kind: ClassVar[str] = "HoldSpin"
    body: str
    start: float
    end: float
    rate: float
    axis: Vec = (0.0, 0.0, 1.0)
    until_contact: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not math.hypot(*self.axis) > 0.0:
            raise ValueError(f"spin of {self.body!r} has the axis {self.axis}")

    @property
    def time(self) -> float:
        return self.start

    @property
    def spin(self) -> Vec:
        """Angular velocity [rad/s]."""
        length = math.hypot(*self.axis)
        return _vec(self.rate * a / length for a in self.axis)


@dataclass(frozen=True)
class BuoyUp:
    """A liquid bears `body` up and slows it down where it is in it (module docstring).

    Args:
        body: Name of the body.
        start, end: [s]; `end` may be math.inf.
        center: Middle of the liquid's level [m].
        basin: Half its length, width and depth [m].
        extents: Half the size of the body in its axes [m].
        lift: What all of the body in it adds to its vertical velocity [m/s^2]: the liquid's density
            over the body's, times gravity.
        linear_drag: Drag that grows with the speed [1/s].
        quadratic_drag: Drag that grows with its square [1/m].
        turning_drag: Of the angular velocity [1/s].
        heading: Of the basin's length [rad].
        round: Whether the body is a ball, whose volume is in its middle.

    Raises:
        ValueError: If the basin or the body has no size.
    """

    kind: ClassVar[str] = "BuoyUp"
    body: str
    start: float
    end: float
    center: Vec
    basin: Vec
    extents: Vec
    lift: float
    linear_drag: float = 0.0
    quadratic_drag: float = 0.0
    turning_drag: float = 0.0
    heading: float = 0.0
    round: bool = False
    until_contact: ClassVar[tuple[str, ...]] = ()

    def __post_init__(self) -> None:
        if not min(*self.basin, *self.extents) > 0.0:
            raise ValueError(
                f"liquid around {self.body!r} reaches {self.basin}, the body {self.extents}; "
                "all must be greater than 0"
            )

    @property
    def time(self) -> float:
        return self.start


Moving = HoldVelocity | GuideAlong | HoldSpin
"""What moves a body from its start until its end or a touch."""
Lasting = Moving | BuoyUp
"""What goes on from its start until its end or a touch."""
Primitive = SetVelocity | ApplyImpulse | AdjustProperties | DriveJoint | ChangeBody | Lasting
KINDS: tuple[type[Any], ...] = (
    SetVelocity,
    ApplyImpulse,
    AdjustProperties,
    DriveJoint,
    ChangeBody,
    HoldVelocity,
    GuideAlong,
    HoldSpin,
    BuoyUp,
)


class Action(IntEnum):
    """What a primitive does: its index into KINDS, in arrays and kernels; what lasts comes last."""

    SET_VELOCITY = 0
    APPLY_IMPULSE = 1
    ADJUST = 2
    DRIVE = 3
    CHANGE = 4
    HOLD = 5
    GUIDE = 6
    SPIN = 7
    BUOY = 8


class Column(IntEnum):
    """Columns of the numeric table; what they mean depends on the action."""

    START = 0
    END = 1
    # SET_VELOCITY: three columns each; an angular velocity of NaN keeps the body's.
    LINEAR = 2
    ANGULAR = 5
    # APPLY_IMPULSE: three columns.
    IMPULSE = 2
    # ADJUST: NaN keeps a property.
    LINEAR_DAMPING = 2
    ANGULAR_DAMPING = 3
    FRICTION = 4
    BRAKING = 5
    # DRIVE: NaN is no speed or position; neither lets go.
    MOTOR_SPEED = 2
    MOTOR_POSITION = 3
    MOTOR_LIMIT = 4
    # CHANGE: number of the body that is there from then on; a place of NaN is where it is.
    INTO = 2
    PLACE = 3
    FACING = 6
    # HOLD: a climb of NaN keeps the vertical velocity, gains of NaN ask for no time.
    SPEED = 2
    HEADING = 3
    ACCELERATION = 4
    MAX_SPEED = 5
    TURN_RATE = 6
    ROLL_RADIUS = 7
    CLIMB = 8
    GAINS = 9
    LOSES = 10
    # GUIDE: turn rate, number of points, then per point its time, place and velocity.
    GUIDE_TURN_RATE = 2
    KNOTS = 3
    KNOT = 4
    # SPIN: three columns.
    SPIN = 2
    # BUOY: three columns each, then one each.
    LEVEL = 2
    BASIN = 5
    EXTENTS = 8
    LIFT = 11
    LINEAR_DRAG = 12
    QUADRATIC_DRAG = 13
    TURNING_DRAG = 14
    BASIN_HEADING = 15
    ROUND = 16


OPTIONAL = frozenset({"climb", "braking", "gains", "loses"})
"""Fields that programs without them do not mention."""

KNOT_FIELDS = 7
"""Floats per point of a guided path."""


@dataclass(frozen=True)
class Program:
    """Primitives in order of execution, and how long the scene plays.

    Args:
        primitives: Sorted by time; ties keep list order.
        duration: [s].
    """

    primitives: tuple[Primitive, ...]
    duration: float

    def __post_init__(self) -> None:
        times = [p.time for p in self.primitives]
        if times != sorted(times):
            ordered = tuple(sorted(self.primitives, key=lambda p: p.time))
            object.__setattr__(self, "primitives", ordered)


FIELDS = Column.KNOT + KNOT_FIELDS * MAX_KNOTS
"""Floats per primitive in the numeric table."""


@dataclass(frozen=True)
class ProgramBatch:
    """W programs of the same structure as arrays (P primitives each).

    Args:
        kind: `Action`, shape [P].
        body: Body index, -1 where a joint is driven, shape [P].
        until: Bodies whose touch ends a hold, shape [P, B] bool.
        table: Numbers in the order of `Column`, shape [W, P, FIELDS].
        duration: [s].
        joint: Name of the joint that is driven, else "", shape [P]; empty where none is.
    """

    kind: NDArray[np.int32]
    body: NDArray[np.int32]
    until: NDArray[np.bool_]
    table: NDArray[np.float64]
    duration: float
    joint: tuple[str, ...] = ()

    @property
    def n_worlds(self) -> int:
        return self.table.shape[0]


def _never(primitive: Primitive) -> Primitive | None:
    """One that another world needs, such that it never begins; None where it must be there."""
    if isinstance(primitive, HoldVelocity | BuoyUp):
        return replace(primitive, start=math.inf, end=math.inf)
    return replace(primitive, time=math.inf) if isinstance(primitive, DriveJoint) else None


def _union(programs: list[Program]) -> list[Primitive]:
    """Those of the fullest program, and after them what others have more of of one kind."""
    union = [*max(programs, key=lambda p: len(p.primitives)).primitives]
    have = Counter(_subject(p) for p in union)
    for program in programs:
        seen = Counter[tuple[str, str, str]]()
        for p in program.primitives:
            seen[_subject(p)] += 1
            if seen[_subject(p)] > have[_subject(p)]:
                have[_subject(p)] += 1
                union.append(p)
    return union


def redirected(program: Program, names: Collection[str]) -> list[Primitive]:
    """The primitives of a program, each of the body that is there when it begins.

    Args:
        program: What it asks of a body that changes it asks of that body by its own name.
        names: Bodies of the scene; a change into another one, which the surrogate does not know of,
            is left out.
    """
    there: dict[str, str] = {}
    changes = [p for p in program.primitives if isinstance(p, ChangeBody) and p.into in names]
    out: list[Primitive] = []
    for p in program.primitives:
        if isinstance(p, ChangeBody):
            if p.into in names and (p.into != p.body or p.body in there):
                there[p.body] = p.into
                out.append(p)
            continue
        if isinstance(p, Lasting) and changes:
            ends = (
                n for o in p.until_contact for n in (o, *(c.into for c in changes if c.body == o))
            )
            if not isinstance(p, BuoyUp):
                p = replace(p, until_contact=tuple(dict.fromkeys(ends)))
        moved = p.body in there and not isinstance(p, DriveJoint)
        out.append(replace(p, body=there[p.body]) if moved else p)
    return out


def batch_programs(programs: list[Program], names: tuple[str, ...]) -> ProgramBatch:
    """Stacks programs of one structure (kinds and bodies in the same order).

    Primitives are kept in the order of the program that has the most, what others have more of
    follows; a batch whose primitives
    change order between worlds is still executed correctly, because primitives of different bodies
    commute and those of one body must keep their order. A hold that another world needs, as it has
    to slow down to a speed first, never begins, and a motor that only another one has to switch
    never fires.

    Args:
        programs: W programs.
        names: Body names in `SimScene.bodies` order.

    Raises:
        ValueError: If structures differ otherwise or a body is unknown.
    """
    if not programs:
        raise ValueError("need at least one program")
    index = {n: i for i, n in enumerate(names)}
    if any(isinstance(p, ChangeBody) for program in programs for p in program.primitives):
        programs = [Program(tuple(redirected(p, names)), p.duration) for p in programs]
    union = _union(programs)
    signature = [_subject(p) for p in union]
    until = _ends(union, index)
    table = np.full((len(programs), len(signature), FIELDS), np.nan)
    for w, program in enumerate(programs):
        for k, row in enumerate(_rows(program, union, f"program {w}")):
            table[w, k] = _row(row)
            if isinstance(row, ChangeBody):
                table[w, k, Column.INTO] = index[row.into]
    kinds = [c.kind for c in KINDS]
    return ProgramBatch(
        kind=np.array([kinds.index(k) for k, _, _ in signature], np.int32),
        body=np.array([index.get(b, -1) for _, b, _ in signature], np.int32),
        until=until,
        table=table,
        duration=max(p.duration for p in programs),
        joint=tuple(j for _, _, j in signature) if any(j for _, _, j in signature) else (),
    )


def _ends(primitives: list[Primitive], index: dict[str, int]) -> NDArray[np.bool_]:
    """Which bodies' contact ends which primitive: (primitives, bodies).

    Raises:
        ValueError: If one names an unknown body.
    """
    until = np.zeros((len(primitives), len(index)), bool)
    for k, p in enumerate(primitives):
        if p.body not in index and not isinstance(p, DriveJoint):
            raise ValueError(f"program moves unknown body {p.body!r}; bodies are {list(index)}")
        for other in p.until_contact if isinstance(p, Lasting) else ():
            if other not in index:
                raise ValueError(f"hold of {p.body!r} ends at unknown body {other!r}")
            until[k, index[other]] = True
    return until


def _rows(program: Program, union: list[Primitive], name: str) -> list[Primitive]:
    """The program's primitives in the order of the union, with those it lacks never beginning.

    Raises:
        ValueError: If it lacks one that must be there.
    """
    remaining = list(program.primitives)
    out: list[Primitive] = []
    for k, p in enumerate(union):
        key = _subject(p)
        row = next((q for q in remaining if _subject(q) == key), None)
        if row is not None:
            remaining.remove(row)
        elif (row := _never(p)) is None:
            raise ValueError(f"{name} has no {key[0]} of {key[1] or key[2]!r} in position {k}")
        out.append(row)
    assert not remaining
    return out


def _subject(p: Primitive) -> tuple[str, str, str]:
    """What a primitive does to which body or joint."""
    return p.kind, p.body, p.joint if isinstance(p, DriveJoint) else ""


def _row(p: Primitive) -> NDArray[np.float64]:
    row, nan = np.full(FIELDS, np.nan), math.nan
    row[Column.START] = p.time
    row[Column.END] = p.end if isinstance(p, Lasting) else p.time
    values: tuple[float | None, ...]
    if isinstance(p, SetVelocity):
        values = (*p.linear, *((nan, nan, nan) if p.angular is None else p.angular))
    elif isinstance(p, ApplyImpulse):
        values = p.impulse
    elif isinstance(p, AdjustProperties):
        values = (p.linear_damping, p.angular_damping, p.friction, p.braking)
    elif isinstance(p, DriveJoint):
        values = (p.speed, p.position, p.limit)
    elif isinstance(p, ChangeBody):
        values = (nan, *((nan, nan, nan) if p.position is None else p.position), p.heading)
    elif isinstance(p, GuideAlong):
        knots = zip(p.times, p.points, p.velocities, strict=True)
        values = (p.turn_rate, float(len(p.times)), *(v for t, x, u in knots for v in (t, *x, *u)))
    elif isinstance(p, HoldSpin):
        values = p.spin
    elif isinstance(p, BuoyUp):
        values = (*p.center, *p.basin, *p.extents, p.lift, p.linear_drag,
                  p.quadratic_drag, p.turning_drag, p.heading, float(p.round))  # fmt: skip
    else:
        values = (p.speed, p.heading, p.acceleration, p.max_speed, p.turn_rate, p.roll_radius,
                  p.climb, p.gains, p.loses)  # fmt: skip
    # The columns of every action follow each other in this order.
    row[Column.END + 1 : Column.END + 1 + len(values)] = [nan if v is None else v for v in values]
    return row


def program_to_json(program: Program) -> dict[str, Any]:
    """Plain JSON of a program; an infinite hold end is null, `OPTIONAL` ones are left out."""
    out: list[dict[str, Any]] = []
    for p in program.primitives:
        item: dict[str, Any] = {"kind": p.kind}
        for key, value in asdict(p).items():
            if key in OPTIONAL and value is None:
                continue
            if isinstance(value, float) and math.isinf(value):
                value = None
            item[key] = _listed(value)
        out.append(item)
    return {"version": PROGRAM_VERSION, "duration": program.duration, "primitives": out}


def _listed(value: Any) -> Any:
    return [_listed(v) for v in value] if isinstance(value, tuple) else value


def _tupled(value: Any) -> Any:
    return tuple(_tupled(v) for v in value) if isinstance(value, (list, tuple)) else value


def program_from_json(data: dict[str, Any]) -> Program:
    """Inverse of program_to_json.

    Raises:
        ValueError: For an unknown version, primitive kind or field, with its position.
    """
    if data.get("version") != PROGRAM_VERSION:
        raise ValueError(f"program version {data.get('version')!r}, expected {PROGRAM_VERSION}")
    by_kind = {c.kind: c for c in KINDS}
    out: list[Primitive] = []
    for i, item in enumerate(data["primitives"]):
        cls = by_kind.get(item.get("kind", ""))
        if cls is None:
            raise ValueError(
                f"/primitives/{i}/kind: {item.get('kind')!r}, expected {list(by_kind)}"
            )
        known = {f.name for f in fields(cls)}
        values: dict[str, Any] = {k: _tupled(v) for k, v in item.items() if k != "kind"}
        unknown = set(values) - known
        if unknown:
            raise ValueError(f"/primitives/{i}: unknown fields {sorted(unknown)}")
        if cls in (HoldVelocity, HoldSpin, BuoyUp) and values.get("end") is None:
            values["end"] = math.inf
        if cls is DriveJoint and values.get("limit") is None:
            values["limit"] = math.inf
        out.append(cls(**values))
    return Program(tuple(out), float(data["duration"]))
