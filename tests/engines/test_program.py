"""One program means the same in every engine: compared with plain arithmetic."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.engines import ENGINES, get_engine
from esg.engines.executor import Executor
from esg.engines.program import (
    MAX_KNOTS,
    AdjustProperties,
    ApplyImpulse,
    Column,
    DriveJoint,
    GuideAlong,
    HoldSpin,
    HoldVelocity,
    Program,
    SetVelocity,
    batch_programs,
    program_from_json,
    program_to_json,
)
from esg.engines.scene import SimScene, Variation
from esg.engines.traction import features
from tests.engines.lab import ball, box

DT = 1.0 / 240.0
NAMES = ("a", "b", "c")
SCENE = SimScene(
    "void",
    tuple(ball(n, 0.1, 1.0 + i, (0.0, 100.0 * i, 1e3)) for i, n in enumerate(NAMES)),
    gravity=(0.0, 0.0, 0.0),
)


class Points:
    """Free bodies without forces or contacts: the executor's world for the reference."""

    def __init__(self, masses):
        self.x = np.array([b.position for b in SCENE.bodies])
        self.v = np.zeros((len(masses), 3))
        self.w = np.zeros((len(masses), 3))
        self.damping = np.zeros((len(masses), 2))
        self.masses = masses

    def position(self, body):
        return tuple(self.x[body])

    def linear(self, body):
        return tuple(self.v[body])

    def read(self, body):
        return self.x[body], (0.0, 0.0, 0.0, 1.0), self.v[body], self.w[body]

    def set_linear(self, body, velocity):
        self.v[body] = velocity

    def set_flight(self, body, velocity, pull):
        self.v[body] = (*velocity[:2], velocity[2] - pull)

    def set_angular(self, body, velocity):
        self.w[body] = velocity

    def mass(self, body):
        return self.masses[body]

    def set_linear_damping(self, body, damping):
        self.damping[body, 0] = damping

    def set_angular_damping(self, body, damping):
        self.damping[body, 1] = damping

    def set_friction(self, body, friction):
        pass


def reference(batch, world, masses, n_steps, home=None):
    points, executor = Points(masses), Executor(batch, world, 0.0, features(SCENE))
    points.x = points.x if home is None else home
    v, w = [points.v.copy()], [points.w.copy()]
    for step in range(n_steps):
        executor.before_step(step * DT, DT, (), points)
        points.v *= np.maximum(0.0, 1.0 - points.damping[:, :1] * DT)
        points.w *= np.maximum(0.0, 1.0 - points.damping[:, 1:] * DT)
        points.x = points.x + points.v * DT
        v.append(points.v.copy())
        w.append(points.w.copy())
    return np.array(v), np.array(w)


def random_program(rng, signature):
    out = []
    for kind, body in signature:
        t = float(np.round(rng.uniform(0.0, 0.5), 3))
        x = [float(v) for v in rng.normal(size=6)]
        if kind == 0:
            spin = tuple(x[3:]) if rng.random() < 0.5 else None
            out.append(SetVelocity(body, t, tuple(x[:3]), spin))
        elif kind == 1:
            out.append(ApplyImpulse(body, t, tuple(x[:3])))
        elif kind == 2:
            damping = float(rng.uniform(0, 3)) if rng.random() < 0.7 else None
            spin = float(rng.uniform(0, 3)) if rng.random() < 0.7 else None
            braking = float(rng.uniform(0, 3)) if rng.random() < 0.5 else None
            out.append(AdjustProperties(body, t, damping, spin, 0.3, braking))
        elif kind == 4:
            end = math.inf if rng.random() < 0.3 else t + abs(x[0]) * 0.2
            out.append(HoldSpin(body, t, end, x[1], tuple(x[2:5])))
        else:
            end = math.inf if rng.random() < 0.3 else t + abs(x[0]) * 0.2
            rates = {"gains": abs(x[5]) * 4, "loses": abs(x[4]) * 4} if rng.random() < 0.5 else {}
            out.append(
                HoldVelocity(
                    body, t, end, abs(x[1]), x[2], acceleration=x[3] * 3, max_speed=1.5,
                    turn_rate=x[4], roll_radius=0.1 if rng.random() < 0.3 else 0.0, **rates,
                )
            )  # fmt: skip
    return Program(tuple(out), 0.7)


@pytest.fixture(scope="module")
def random_batch():
    rng = np.random.default_rng(7)
    signature = [(int(rng.integers(5)), NAMES[int(rng.integers(3))]) for _ in range(12)]
    # Several primitives of one kind and body exercise the order within a list.
    signature += signature[:4]
    programs = [random_program(rng, signature) for _ in range(5)]
    return batch_programs(programs, NAMES)


@pytest.mark.parametrize("name", ENGINES)
def test_random_programs_match_the_reference_executor(name, random_batch):
    factor = np.array([[1.0, 2.0, 0.5]] * 5)
    rollout = get_engine(name).rollout(
        SCENE, random_batch, dt=DT, variation=Variation(mass_scale=factor)
    )
    for w in range(5):
        masses = [b.mass * k for b, k in zip(SCENE.bodies, factor[w], strict=True)]
        v, omega = reference(random_batch, w, masses, len(rollout.time) - 1)
        np.testing.assert_allclose(rollout.linear_velocity[w], v, atol=2e-5)
        np.testing.assert_allclose(rollout.angular_velocity[w], omega, atol=2e-4)


@pytest.mark.parametrize("name", (*ENGINES, "surrogate"))
def test_what_is_under_way_at_the_start_has_its_velocity_in_frame_0(name):
    """The first frame shows what the first step is given, in every world; later things are not."""
    spin = (0.0, 0.0, 2.0)
    path = ((0.0, 200.0, 1e3), (1.0, 200.0, 1e3))
    programs = [
        Program(
            (
                SetVelocity("a", 0.0, (speed, 0.0, 1.0)),
                HoldSpin("a", 0.001, math.inf, 2.0),
                ApplyImpulse("a", 0.0, (0.0, 4.0, 0.0)),
                HoldVelocity("b", 0.0, 1.0, speed, math.pi / 2, 1.0, 2.5, roll_radius=0.1),
                GuideAlong("c", late, (0.0, 1.0), path, ((1.0, 0.0, 0.0),) * 2, 0.5),
            ),
            0.1,
        )
        for speed, late in ((2.0, 0.0), (3.0, 0.05))
    ]
    factor = np.array([[1.0, 1.0, 1.0], [2.0, 1.0, 1.0]])
    r = get_engine(name).rollout(
        SCENE, batch_programs(programs, NAMES), dt=DT, variation=Variation(mass_scale=factor)
    )
    first = [[(2, 4, 1), (0, 2, 0), (1, 0, 0)], [(3, 2, 1), (0, 2.5, 0), (0, 0, 0)]]
    np.testing.assert_allclose(r.linear_velocity[:, 0], first, atol=1e-5)
    turning = [[spin, (-20, 0, 0), (0, 0, 0.5)], [spin, (-25, 0, 0), (0, 0, 0)]]
    np.testing.assert_allclose(r.angular_velocity[:, 0], turning, atol=1e-5)


@pytest.fixture(scope="module")
def random_paths():
    """Near the origin, where single precision tells tenths of micrometres apart."""
    scene = replace(
        SCENE,
        bodies=tuple(replace(b, position=(0.0, 4.0 * i, 4.0)) for i, b in enumerate(SCENE.bodies)),
    )
    rng = np.random.default_rng(11)

    def path(body):
        n = int(rng.integers(2, MAX_KNOTS + 1))
        times = (0.0, *np.cumsum(rng.uniform(0.02, 0.1, n - 1)).tolist())
        home = np.array(body.position)
        points = tuple(map(tuple, (home + rng.normal(0.0, 0.05, (n, 3))).tolist()))
        velocities = tuple(map(tuple, rng.normal(0.0, 0.5, (n, 3)).tolist()))
        start, turn = float(rng.uniform(0.0, 0.2)), float(rng.normal())
        return GuideAlong(body.name, start, times, points, velocities, turn)

    programs = [Program(tuple(map(path, scene.bodies)), 0.7) for _ in range(5)]
    return scene, batch_programs(programs, NAMES)


@pytest.mark.parametrize("name", (*ENGINES, "surrogate"))
def test_random_paths_match_the_reference_executor(name, random_paths):
    scene, batch = random_paths
    rollout = get_engine(name).rollout(scene, batch, dt=DT)
    for w in range(5):
        home = np.array([b.position for b in scene.bodies])
        v, omega = reference(batch, w, [1.0] * 3, len(rollout.time) - 1, home)
        np.testing.assert_allclose(rollout.linear_velocity[w], v, atol=5e-4)
        np.testing.assert_allclose(rollout.angular_velocity[w], omega, atol=2e-4)


def hold(**more):
    return HoldVelocity("a", 0.0, 1.0, 1.0, 0.0, **more)


def executor_of(*primitives):
    return Executor(batch_programs([Program(primitives, 1.0)], NAMES), 0)


def test_hold_ends_the_step_after_its_contact_only_if_it_was_active():
    executor, points = executor_of(hold(until_contact=("b",))), Points([1, 1, 1])
    touch = [(0, 1)]
    # A touch reported before the first active step happened before `start`.
    executor.before_step(0.0, DT, touch, points)
    assert points.linear(0)[0] == 1.0
    points.v[:] = 0.0
    executor.before_step(DT, DT, [(0, 2)], points)
    assert points.linear(0)[0] == 1.0
    points.v[:] = 0.0
    executor.before_step(2 * DT, DT, touch, points)
    executor.before_step(3 * DT, DT, (), points)
    assert points.linear(0)[0] == 0.0


def test_primitives_fire_in_the_step_whose_middle_is_past_their_time():
    executor, points = executor_of(SetVelocity("a", 1.4 * DT, (1, 0, 0))), Points([1, 1, 1])
    executor.before_step(0.0, DT, (), points)
    assert points.linear(0)[0] == 0.0
    executor.before_step(DT, DT, (), points)
    assert points.linear(0)[0] == 1.0


def test_hold_keeps_the_vertical_velocity_and_never_reverses():
    executor, points = executor_of(hold(acceleration=-4.0)), Points([1, 1, 1])
    points.v[0, 2] = -3.0
    executor.before_step(0.5, DT, (), points)
    assert points.linear(0) == (0.0, 0.0, -3.0)


@pytest.mark.parametrize("name", (*ENGINES, "surrogate"))
def test_a_hold_that_takes_its_time_starts_at_the_speed_that_a_body_has(name):
    """One stands and comes to 2 m/s, one comes down to it; what a hit took comes back likewise."""
    places = ((0.0, 0.0, 0.1), (0.0, 10.0, 0.1), (0.0, 20.0, 0.1))
    sledges = (
        box(n, (0.2, 0.2, 0.1), 1.0, x, friction=0.0) for n, x in zip("abc", places, strict=True)
    )
    scene = SimScene("ice", tuple(sledges), ground_friction=0.0)
    holds = (HoldVelocity(n, 0.1, 9.0, 2.0, 0.0, gains=4.0, loses=3.0) for n in "abc")
    hit = SetVelocity("c", 0.0, (2.0, 0.0, 0.0)), SetVelocity("c", 1.0, (0.0, -1.0, 0.0))
    program = Program((SetVelocity("b", 0.0, (5.0, 0.0, 0.0)), *hit, *holds), 2.0)
    rollout = get_engine(name).rollout(scene, batch_programs([program], scene.names))
    v = rollout.linear_velocity[0]
    at = [round(t / DT) for t in (0.1, 0.35, 0.6, 1.1, 1.6)]
    np.testing.assert_allclose(v[at, 0, 0], (0.0, 1.0, 2.0, 2.0, 2.0), atol=0.03)
    np.testing.assert_allclose(v[at, 1, 0], (5.0, 4.25, 3.5, 2.0, 2.0), atol=0.03)
    assert v[round(0.9 / DT), 2, 0] == pytest.approx(2.0, abs=1e-3)
    change = np.diff(v[:, 2, :2], axis=0)[round(1.02 / DT) :] / DT
    np.testing.assert_allclose(np.abs(change).max(axis=0), (4.0, 3.0), rtol=0.02)
    np.testing.assert_allclose(v[-1, 2, :2], (2.0, 0.0), atol=1e-3)


def flying(dt):
    """A ball (which would roll) flies level, climbs in a turn, then sinks; another one falls."""
    scene = SimScene(
        "sky",
        tuple(ball(n, 0.1, 1.0, (0.0, 10.0 * i, 20.0)) for i, n in enumerate("ab")),
        gravity=(0.0, 0.0, -5.0),
    )
    program = Program(
        (
            HoldVelocity("a", 0.0, 0.5, 2.0, 0.0, roll_radius=0.1, climb=0.0),
            HoldVelocity("b", 0.0, 0.5, 2.0, 0.0),
            HoldVelocity("a", 0.5, 1.0, 2.0, 0.0, turn_rate=math.pi, climb=1.5),
            HoldVelocity("a", 1.0, 1.5, 0.0, 0.0, climb=-3.0),
        ),
        2.0,
    )
    return scene, program, lambda t: round(t / dt)


@pytest.mark.parametrize("dt", [1 / 240, 1 / 120])
@pytest.mark.parametrize("name", (*ENGINES, "surrogate"))
def test_powered_flight_is_the_same_path_in_every_engine(name, dt):
    scene, program, at = flying(dt)
    rollout = get_engine(name).rollout(scene, batch_programs([program], scene.names), dt=dt)
    path, spin = rollout.position[0, :, 0], rollout.angular_velocity[0, :, 0]
    np.testing.assert_allclose(path[: at(0.5) + 1, 2], 20.0, atol=1e-4)
    np.testing.assert_allclose(path[at(0.5), :2], (1.0, 0.0), atol=1e-4)
    np.testing.assert_allclose(path[at(1.0)], (1 + 2 / math.pi, 2 / math.pi, 20.75), atol=0.01)
    np.testing.assert_allclose(path[at(1.5), 2], 20.75 - 1.5, atol=1e-3)
    # Released, it falls; whoever flies does not roll.
    fallen = 20.75 - 1.5 - 3.0 * 0.5 - 0.5 * 5.0 * 0.5**2
    np.testing.assert_allclose(path[at(2.0), 2], fallen, atol=0.03)
    np.testing.assert_allclose(spin[1 : at(0.5)], 0.0, atol=1e-6)
    # A hold without a climb keeps falling, as it always did.
    np.testing.assert_allclose(rollout.position[0, at(1.0), 1, 2], 20.0 - 2.5, atol=0.03)


def test_a_climb_ends_at_the_touch_and_a_program_without_one_reads_as_before():
    (p,) = program_to_json(Program((hold(),), 1.0))["primitives"]
    assert "climb" not in p
    flies = Program((hold(climb=0.0, until_contact=("b",)),), 1.0)
    assert program_from_json(program_to_json(flies)) == flies
    points, executor = Points([1.0] * 3), Executor(batch_programs([flies], NAMES), 0, -9.81)
    executor.before_step(0.0, DT, (), points)
    assert points.v[0, 2] == pytest.approx(9.81 * DT)
    points.v[0] = (0.0, 0.0, -1.0)
    executor.before_step(DT, DT, [(0, 1)], points)
    assert points.v[0, 2] == -1.0


def guided():
    """A crate is lifted, carried and set down beside a spinning top; a ball is let go in flight."""
    scene = SimScene(
        "crane",
        (
            box("crate", (0.2, 0.15, 0.1), 3.0, (0.0, 0.0, 0.1), restitution=0.0),
            box("top", (0.1, 0.1, 0.1), 1.0, (0.0, 3.0, 0.1), friction=0.0, wheeled=True),
            ball("ball", 0.1, 1.0, (0.0, 6.0, 3.0)),
        ),
    )
    rest = (0.0, 0.0, 0.0)
    program = Program(
        (
            GuideAlong(
                "crate",
                0.2,
                (0.0, 0.5, 1.3, 1.8),
                ((0.0, 0.0, 0.1), (0.0, 0.0, 0.6), (1.0, 0.5, 0.6), (1.0, 0.5, 0.102)),
                (rest, (0.3, 0.1, 0.2), (0.2, 0.1, -0.3), rest),
                turn_rate=0.5,
            ),
            HoldSpin("top", 0.1, 2.1, 4.0),
            GuideAlong("ball", 0.0, (0.0, 0.5), ((0.0, 6.0, 3.0), (0.5, 6.0, 3.4)),
                       (rest, (2.0, 0.0, 0.0))),
        ),
        2.5,
    )  # fmt: skip
    return scene, program, lambda t, dt: round(t / dt)


@pytest.mark.parametrize("dt", [1 / 240, 1 / 120])
@pytest.mark.parametrize("name", (*ENGINES, "surrogate"))
def test_a_guided_thing_goes_its_way_in_every_engine(name, dt):
    scene, program, at = guided()
    r = get_engine(name).rollout(scene, batch_programs([program], scene.names), dt=dt)
    crate = next(p for p in program.primitives if p.body == "crate")
    for s in (0.25, 0.5, 0.9, 1.3, 1.6):
        expected = crate.at(s)
        np.testing.assert_allclose(r.position[0, at(0.2 + s, dt), 0], expected, atol=0.004)
    # Let go at rest, it stays where it was put, turned and upright.
    np.testing.assert_allclose(r.position[0, -1, 0], (1.0, 0.5, 0.1), atol=0.006)
    np.testing.assert_allclose(r.linear_velocity[0, -1, 0], 0.0, atol=0.02)
    turn = 2.0 * math.atan2(r.quaternion[0, -1, 0, 2], r.quaternion[0, -1, 0, 3])
    assert turn == pytest.approx(0.9, abs=0.03)
    # The top turns on the spot: 8 rad.
    spin = r.angular_velocity[0, :, 1, 2]
    assert spin[at(1.0, dt)] == pytest.approx(4.0, abs=0.2)
    off = r.position[0, : at(2.1, dt), 1, :2] - np.array([0.0, 3.0])
    assert np.abs(off).max() < 0.02
    assert float(spin[: at(2.1, dt)].sum()) * dt == pytest.approx(8.0, abs=0.4)
    # The ball flies on with the velocity it had at the end of its path.
    np.testing.assert_allclose(r.linear_velocity[0, at(0.5, dt), 2, 0], 2.0, atol=0.06)
    drop = 3.4 - r.position[0, at(0.9, dt), 2, 2]
    assert drop == pytest.approx(0.5 * 9.81 * 0.4**2, abs=0.05)


def test_a_motor_that_only_another_world_has_to_switch_never_fires():
    """A lid that comes to rest by itself needs no end of its motor; one that does not has it."""
    lifts = DriveJoint("hinge", 0.2, 1.0, 1.5, 20.0)
    programs = [Program((lifts,), 2.0), Program((lifts, DriveJoint("hinge", 1.2)), 2.0)]
    start = batch_programs(programs, NAMES).table[:, :, Column.START]
    assert start.tolist() == [[0.2, math.inf], [0.2, 1.2]]


def test_a_hold_that_only_another_world_needs_never_begins():
    slower = HoldVelocity("a", 0.5, 0.8, 6.0, 0.0, acceleration=-4.0)
    worlds = [
        (HoldVelocity("a", 0.0, 0.5, 5.0, 0.0), *between, HoldVelocity("a", end, 2.0, 5.0, 0.0))
        for between, end in (((), 0.5), ((slower,), 0.8))
    ]
    programs = [Program(primitives, 2.0) for primitives in worlds]
    batch = batch_programs(programs, NAMES)
    alone = [batch_programs([program], NAMES) for program in programs]
    for world, single in enumerate(alone):
        shared, own = Points([1.0] * 3), Points([1.0] * 3)
        together, apart = Executor(batch, world, 0.0), Executor(single, 0, 0.0)
        speeds: list[float] = []
        for time in np.arange(0.0, 2.0, DT):
            together.before_step(time, DT, (), shared)
            apart.before_step(time, DT, (), own)
            np.testing.assert_array_equal(shared.v, own.v)
            speeds.append(shared.v[0, 0])
        assert max(speeds) == (6.0 if world else 5.0)
    with pytest.raises(ValueError, match="ApplyImpulse"):
        batch_programs(
            [Program((), 1.0), Program((ApplyImpulse("a", 0.0, (1, 0, 0)),), 1.0)], NAMES
        )


def test_worlds_that_have_more_of_different_kinds_share_a_batch() -> None:
    """Neither of two programs of the same length holds the other; each keeps what it has."""

    def held(name: str, *starts: float) -> list[HoldVelocity]:
        return [HoldVelocity(name, t, t + 0.4, 1.0, 0.0) for t in starts]

    one = Program((*held("a", 0.0, 0.5), *held("b", 0.0)), 1.0)
    other = Program((*held("a", 0.0), *held("b", 0.0, 0.5)), 1.0)
    batch = batch_programs([one, other], NAMES)
    start = batch.table[:, :, Column.START]
    assert sorted(batch.body.tolist()) == [0, 0, 1, 1]
    assert np.isfinite(start).sum(axis=1).tolist() == [3, 3]
    assert np.sort(start[1, batch.body == 1]).tolist() == [0.0, 0.5]


def test_a_path_passes_its_points_with_their_velocities():
    path = GuideAlong("a", 1.0, (0.0, 0.5, 2.0), ((0, 0, 0), (1, 2, 3), (4, 4, 4)),
                      ((1, 0, 0), (0, 1, 0), (0, 0, -2)))  # fmt: skip
    assert path.end == 3.0
    for s, point, velocity in zip(path.times, path.points, path.velocities, strict=True):
        np.testing.assert_allclose(path.at(s), point, atol=1e-12)
        for a, b in ((s - 1e-6, s), (s, s + 1e-6)):
            slope = (np.array(path.at(b)) - np.array(path.at(a))) / 1e-6
            np.testing.assert_allclose(slope, velocity, atol=1e-4)


@pytest.mark.parametrize("times", [(0.0,), (0.1, 1.0), (0.0, 1.0, 1.0), tuple(range(7))])
def test_a_path_that_cannot_be_followed_is_refused(times):
    points = ((0.0, 0.0, 0.0),) * len(times)
    with pytest.raises(ValueError, match="of 'a'"):
        GuideAlong("a", 0.0, times, points, points)


def test_what_lasts_ends_at_a_touch_and_survives_json():
    rest = (0.0, 0.0, 0.0)
    guide = GuideAlong("a", 0.0, (0.0, 1.0), (rest, (1.0, 0.0, 0.0)), (rest, rest),
                       until_contact=("b",))  # fmt: skip
    for primitive in (guide, HoldSpin("a", 0.0, math.inf, 2.0, (0.0, 3.0, 4.0), ("b",))):
        program = Program((primitive,), 1.0)
        assert program_from_json(program_to_json(program)) == program
        points, executor = Points([1.0] * 3), Executor(batch_programs([program], NAMES), 0, 0.0)
        executor.before_step(0.0, DT, (), points)
        assert points.v[0].any() or points.w[0].any()
        points.v[0] = points.w[0] = 0.0
        executor.before_step(DT, DT, [(0, 1)], points)
        assert not points.v[0].any() and not points.w[0].any()
    np.testing.assert_allclose(primitive.spin, (0.0, 1.2, 1.6))
