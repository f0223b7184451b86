"""Joints in Newton: what trees are made of them, and closed forms that only it has to meet."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from benchmarks import joints as cases
from esg.engines.fleet import FleetNewton
from esg.engines.jobs import Buffer, make_job, read
from esg.engines.joints import Joint, Motor, joint_between, joint_state
from esg.engines.newton import NewtonEngine
from esg.engines.newton.trees import coordinates, plan_trees, turned_around
from esg.engines.program import (
    ApplyImpulse,
    DriveJoint,
    HoldVelocity,
    Program,
    SetVelocity,
    batch_programs,
)
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene, Variation
from esg.engines.shapes import SceneShapes
from esg.outcomes import UserError
from esg.units import quat_from_euler_deg
from tests.engines.lab import DT, ball, box


@pytest.mark.parametrize(
    "case", [c for c in cases.cases() if "newton" not in c.beyond], ids=lambda c: c.name
)
def test_joint_moves_as_its_closed_form_says(case) -> None:
    assert not cases.too_far(cases.run(("newton",), [case]), ("newton",))


def play(scene, *commands, seconds=2.0, worlds=1, variation=None, dt=DT):
    batch = batch_programs([Program(commands, seconds)] * worlds, scene.names)
    return NewtonEngine().rollout(scene, batch, dt=dt, variation=variation)


def paths(rollout, body):
    """Position and orientation of a body in the first world."""
    return tuple(a[0, :, body].astype(float) for a in (rollout.position, rollout.quaternion))


# -- trees -----------------------------------------------------------------------------------------


def links_of(n, *, parents):
    """Boxes in a row along X, half a metre apart, and a hinge of each with its parent (-1: none)."""
    bodies = [box(f"b{i}", (0.2, 0.1, 0.1), 1.0, (0.5 * i, 0.0, 3.0)) for i in range(n)]
    joints = [
        joint_between(
            f"j{i}", "hinge", bodies[i], bodies[p] if p >= 0 else None,
            at=(0.5 * i - 0.25, 0.0, 3.0), axis=(0.0, 1.0, 0.0),
        )
        for i, p in enumerate(parents)
        if p is not None
    ]  # fmt: skip
    return SimScene("s", tuple(bodies), joints=tuple(joints))


def trees_of(scene):
    s = SceneShapes.of(scene)
    return plan_trees(s.joints, s.ends, s.dynamic)


def test_trees_hang_on_the_world_or_float() -> None:
    """A chain on the world, a pair of which the second was declared to carry the first."""
    scene = links_of(5, parents=[-1, 0, None, None, 3])
    back = joint_between("j5", "ball", scene.bodies[2], scene.bodies[3], at=(1.25, 0.0, 3.0))
    plan = trees_of(replace(scene, joints=(*scene.joints, back)))
    found = [[(k.parent, k.child, k.joint) for k in tree] for tree in plan.trees]
    assert found == [[(-1, 0, 0), (0, 1, 1)], [(-1, 3, -1), (3, 4, 2), (3, 2, 3)]]
    assert sorted(plan.apart) == [(0, 1), (3, 2), (3, 4)]


def test_joint_of_a_static_parent_hangs_on_the_world() -> None:
    scene = links_of(2, parents=[None, 0])
    still = scene.with_bodies((replace(scene.bodies[0], static=True), scene.bodies[1]))
    ((link,),) = trees_of(still).trees
    assert (link.parent, link.base, link.child) == (-1, 0, 1)


def test_joint_of_what_does_not_move_is_left_out() -> None:
    """Bodies that no event is about are held still during a search."""
    scene = links_of(2, parents=[None, 0])
    held = scene.with_bodies(tuple(replace(b, static=True) for b in scene.bodies))
    assert trees_of(held).trees == ()


def test_what_closes_a_ring_is_what_needs_no_coordinate() -> None:
    """Of two hinges of a leaf the one with a stop is the branch, whatever their order."""
    scene = links_of(1, parents=[-1])
    (body,) = scene.bodies
    other = joint_between("other", "hinge", body, None, at=(-0.25, 0.0, 3.2), axis=(0.0, 1.0, 0.0))
    stopped = replace(other, upper=1.0)
    for joints, branch in (((*scene.joints, stopped), 1), ((stopped, *scene.joints), 0)):
        plan = trees_of(replace(scene, joints=joints))
        assert [link.joint for link in plan.links] == [branch]
        assert plan.loose == (1 - branch,)
        assert len(plan.ties) == 10, "five locks, each of two sides"


def test_what_neither_branches_nor_ties_can_do_is_refused_by_name() -> None:
    scene = links_of(1, parents=[-1])
    brittle = replace(scene.joints[0], break_impulse=1.0, motor=Motor(1.0))
    with pytest.raises(UserError, match="cannot simulate 'j0', which closes a ring or may break"):
        play(replace(scene, joints=(brittle,)))
    spring = joint_between("s", "spring", scene.bodies[0], None, at=(0.0, 0.0, 3.0))
    spring = replace(spring, upper=0.5, break_impulse=1.0)
    with pytest.raises(UserError, match="cannot simulate 's', a spring that may break"):
        play(replace(scene, joints=(spring,)))


LOOSE = [
    c
    for c in cases.cases()
    if c.name.startswith(("pendulum", "hinge with friction", "cone", "fixed", "door"))
    and not any(j.flexible for j in c.joints)
]


@pytest.mark.parametrize("case", LOOSE, ids=lambda c: c.name)
def test_joint_in_no_tree_moves_as_its_closed_form_says(case) -> None:
    """As one that may break, which it does not."""
    joints = tuple(replace(j, break_impulse=1e9) for j in case.joints)
    assert not cases.too_far(cases.run(("newton",), [replace(case, joints=joints)]), ("newton",))


def test_ring_of_four_hinges_swings_as_its_closed_form_says() -> None:
    """A bar that two arms carry moves without turning: a pendulum of all three."""
    angle, length = 0.5, 1.0
    down = np.array([-math.sin(angle), 0.0, -math.cos(angle)])
    turn = (0.0, math.sin(0.5 * angle), 0.0, math.cos(0.5 * angle))
    arms = [
        box(f"arm{i}", (0.02, 0.02, 0.5), 1.0, tuple(np.array([x, 0.0, 3.0]) + 0.5 * down),
            quaternion=turn)
        for i, x in enumerate((-0.5, 0.5))
    ]  # fmt: skip
    bar = box("bar", (0.5, 0.02, 0.02), 2.0, tuple(np.array([0.0, 0.0, 3.0]) + down))
    y, joints = (0.0, 1.0, 0.0), []
    for i, x in enumerate((-0.5, 0.5)):
        top = np.array([x, 0.0, 3.0])
        joints += [
            joint_between(f"top{i}", "hinge", arms[i], None, at=tuple(top), axis=y),
            joint_between(f"low{i}", "hinge", bar, arms[i], at=tuple(top + down), axis=y),
        ]
    scene = SimScene("s", (*arms, bar), joints=tuple(joints))
    assert len(trees_of(scene).loose) == 1
    r = play(scene, seconds=10.0)
    inertia = 2.0 * (arms[0].inertia[1][1] + 0.25 * length**2) + 2.0 * length**2
    swings = np.arctan2(-r.position[0, :, 2, 0], 3.0 - r.position[0, :, 2, 2])
    exact = cases.elliptic_period(inertia, 3.0, length, angle)
    assert cases.period(swings.astype(float)) == pytest.approx(exact, rel=1e-3)
    assert cases.kept(swings, exact) == pytest.approx(1.0, abs=0.01)
    for joint in joints:
        child, parent = (
            paths(r, scene.index(n)) if n else None for n in (joint.child, joint.parent)
        )
        assert joint_state(joint, child, parent).gap.max() < 1e-3


def test_leaf_on_two_hinges_turns_as_on_one() -> None:
    """What the second one adds is there already."""
    leaf = box("leaf", (0.4, 0.02, 1.0), 20.0, (0.4, 0.0, 1.1))
    hinges = [
        joint_between(f"h{z}", "hinge", leaf, None, at=(0.0, 0.0, z), axis=(0.0, 0.0, 1.0))
        for z in (0.3, 1.9)
    ]
    push = ApplyImpulse("leaf", 0.0, (0.0, 10.0, 0.0))
    spins = []
    for joints in (hinges[:1], hinges):
        r = play(SimScene("s", (leaf,), joints=tuple(joints)), push)
        spins.append(r.angular_velocity[0, 1:, 0, 2])
    assert spins[1] == pytest.approx(spins[0], rel=1e-3)


def test_joint_turned_around_says_the_same() -> None:
    scene = links_of(2, parents=[None, 0])
    joint = replace(scene.joints[0], lower=-0.2, upper=0.7, motor=Motor(0.5))
    back = turned_around(joint)
    assert (back.lower, back.upper, back.motor.speed) == (-0.7, 0.2, -0.5)
    assert turned_around(back) == joint


def test_coordinates_are_positions_of_joints() -> None:
    turn = tuple(quat_from_euler_deg(40.0, 20.0, -70.0))
    body = box("b", (0.2, 0.1, 0.1), 1.0, (0.5, 0.2, 3.0), quaternion=turn)
    poses = (np.array([[body.position]]), np.array([[body.quaternion]]))
    for kind, position in (("hinge", 0.6), ("slider", -0.3)):
        joint = joint_between(
            "j", kind, body, None, at=(0.1, 0.3, 2.0), axis=(1.0, 2.0, 0.5), position=position
        )
        ((link,),) = trees_of(SimScene("s", (body,), joints=(joint,))).trees
        assert coordinates(link, poses) == pytest.approx(position)


# -- programs and momentum -------------------------------------------------------------------------


def pair(kind="hinge", **more):
    """Two boxes in space that a joint holds together."""
    left = box("left", (0.3, 0.1, 0.1), 2.0, (0.0, 0.0, 5.0))
    right = box("right", (0.3, 0.1, 0.1), 3.0, (0.6, 0.0, 5.0))
    joint = joint_between("j", kind, right, left, at=(0.3, 0.0, 5.0), axis=(0.0, 0.0, 1.0), **more)
    return SimScene("s", (left, right), gravity=(0.0, 0.0, 0.0), joints=(joint,))


def test_linked_body_gets_what_its_joints_leave_of_a_velocity() -> None:
    """The velocities that are nearest to the asked ones, by mass, among those the hinge allows."""
    scene = pair()
    for command in (
        ApplyImpulse("right", 0.0, (0.0, 6.0, 0.0)),
        SetVelocity("right", 0.0, (0.0, 2.0, 0.0)),
        HoldVelocity("right", 0.0, DT, 2.0, math.pi / 2),
    ):
        r = play(scene, command, seconds=0.1)
        mass = np.diag([2.0, 2.0, scene.bodies[0].inertia[2][2],
                        3.0, 3.0, scene.bodies[1].inertia[2][2]])  # fmt: skip
        rows = np.array([[1.0, 0.0, 0.0, -1.0, 0.0, 0.0], [0.0, 1.0, 0.3, 0.0, -1.0, 0.3]])
        asked = np.array([0.0, 0.0, 0.0, 0.0, 2.0, 0.0])
        easy = np.linalg.inv(mass)
        force = np.linalg.solve(rows @ easy @ rows.T, rows @ asked)
        exact = asked - easy @ rows.T @ force
        found = [v for b in range(2) for v in (*r.linear_velocity[0, 1, b, :2],
                                               r.angular_velocity[0, 1, b, 2])]  # fmt: skip
        assert found == pytest.approx(exact, abs=0.02)


@pytest.mark.parametrize("kind", ["hinge", "ball", "fixed", "rope", "spring"])
def test_what_floats_keeps_its_momentum(kind) -> None:
    scene = pair(kind)
    if kind in ("rope", "spring"):
        joint = replace(
            joint_between("j", kind, scene.bodies[1], scene.bodies[0], at=(0.9, 0.0, 5.0),
                          parent_at=(-0.3, 0.1, 5.0)),
            upper=1.3 if kind == "rope" else 1.1, stiffness=100.0 if kind == "spring" else 0.0,
        )  # fmt: skip
        scene = replace(scene, joints=(joint,))
    r = play(scene, ApplyImpulse("right", 0.0, (1.0, 6.0, 0.0)))
    momentum = 2.0 * r.linear_velocity[0, 1:, 0] + 3.0 * r.linear_velocity[0, 1:, 1]
    assert np.abs(momentum - (1.0, 6.0, 0.0)).max() < 0.1
    state = joint_state(scene.joints[0], paths(r, 1), paths(r, 0))
    assert state.gap.max() < 1e-4


def test_damping_of_a_linked_body_is_felt_once() -> None:
    """Both bodies of a fixed pair fade as one body does."""
    scene = pair("fixed")
    damped = scene.with_bodies(tuple(replace(b, linear_damping=0.5) for b in scene.bodies))
    both = [SetVelocity(b.name, 0.0, (1.0, 0.0, 0.0)) for b in scene.bodies]
    r = play(damped, *both, seconds=1.0)
    assert r.linear_velocity[0, -1, :, 0] == pytest.approx(math.exp(-0.5), rel=0.005)


def test_joined_bodies_touch_only_if_they_are_told_to() -> None:
    """A block that a rope ties to another falls through it, or lands on it."""
    low = box("low", (0.2, 0.2, 0.2), 5.0, (0.0, 0.0, 0.2))
    high = box("high", (0.1, 0.1, 0.1), 1.0, (0.0, 0.0, 1.0))
    rope = replace(
        joint_between("r", "rope", high, low, at=high.position, parent_at=low.position), upper=3.0
    )
    for collide, height in ((False, 0.1), (True, 0.5)):
        scene = SimScene("s", (low, high), joints=(replace(rope, collide=collide),))
        r = play(scene, seconds=2.0)
        assert r.position[0, -1, 1, 2] == pytest.approx(height, abs=0.01)
        assert (len(r.contacts.world) > 0) == collide


def test_rope_shows_no_touch_and_rubs_nothing() -> None:
    """A pulled sledge stops a rope's length behind, as friction has it, and no contact is logged."""
    sledge = box("sledge", (0.2, 0.2, 0.1), 5.0, (0.0, 0.0, 0.1), friction=0.5)
    rope = replace(
        joint_between("r", "rope", sledge, None, at=sledge.position, parent_at=(-1.0, 0.0, 0.1)),
        upper=1.5,
    )
    scene = SimScene("s", (sledge,), joints=(rope,), ground_friction=0.5)
    r = play(scene, SetVelocity("sledge", 0.0, (4.0, 0.0, 0.0)))
    assert r.position[0, -1, 0, 0] == pytest.approx(0.5, abs=1e-3)
    assert len(r.contacts.world) == 0
    free = play(replace(scene, joints=()), SetVelocity("sledge", 0.0, (2.0, 0.0, 0.0)))
    tied = play(scene, SetVelocity("sledge", 0.0, (2.0, 0.0, 0.0)), seconds=2.0)
    early = slice(0, 40)
    assert np.allclose(free.position[0, early], tied.position[0, early], atol=1e-5)


# -- worlds ----------------------------------------------------------------------------------------


def door():
    """A leaf on a static post, a ball that comes at it, and a lamp on a rope."""
    post = replace(box("post", (0.05, 0.05, 1.0), 1.0, (0.0, 0.0, 1.0)), static=True)
    leaf = box("leaf", (0.4, 0.02, 1.0), 20.0, (0.5, 0.0, 1.05))
    shot = ball("shot", 0.11, 0.5, (0.7, -2.0, 1.0))
    lamp = ball("lamp", 0.1, 1.0, (3.0, 0.0, 2.0))
    hinge = joint_between("hinge", "hinge", leaf, post, at=(0.1, 0.0, 1.05), axis=(0.0, 0.0, 1.0))
    rope = joint_between("rope", "rope", lamp, None, at=(3.0, 0.0, 2.0), parent_at=(3.0, 0.3, 2.4))
    rope = replace(rope, upper=0.5)
    return SimScene("s", (post, leaf, shot, lamp), joints=(hinge, rope))


def test_world_of_a_jointed_scene_does_not_depend_on_its_batch() -> None:
    scene = door()
    speeds = (3.0, 5.0, 7.0)
    programs = [Program((SetVelocity("shot", 0.0, (0.0, v, 1.0)),), 1.0) for v in speeds]
    position = np.tile(np.array([b.position for b in scene.bodies]), (3, 1, 1))
    position[1, :2, 0] += 0.1  # the post, and what hangs on it
    variation = Variation(position=position, mass_scale=np.repeat([[1.0], [1.1], [1.0]], 4, axis=1))
    together = NewtonEngine().rollout(
        scene, batch_programs(programs, scene.names), dt=DT, variation=variation
    )
    for w in range(3):
        own = Variation(position=position[w : w + 1], mass_scale=variation.mass_scale[w : w + 1])
        alone = NewtonEngine().rollout(
            scene, batch_programs(programs[w : w + 1], scene.names), dt=DT, variation=own
        )
        assert np.array_equal(alone.position[0], together.position[w])
    x = together.position[:, :, 1, 0].astype(float)
    anchor = np.array([0.1, 0.2, 0.1])[:, None]
    radius = np.hypot(x - anchor, together.position[:, :, 1, 1])
    assert np.abs(radius - 0.4).max() < 1e-3, "a leaf hangs on its own world's post"


def test_fleet_plays_jointed_scenes_as_if_alone() -> None:
    """What has no joints shares no pass with what has, and either comes out as by itself."""
    jointed = door()
    plain = replace(jointed, joints=())
    fleet, jobs, starts = FleetNewton("cpu"), [], []
    program = Program((SetVelocity("shot", 0.0, (0.0, 5.0, 1.0)),), 0.5)
    for key, scene in enumerate((plain, jointed)):
        batch = batch_programs([program] * 2, scene.names)
        job, start = make_job(
            "newton", key, scene, SceneShapes.of(scene), batch,
            dt=DT, record_every=4, variation=None,
        )  # fmt: skip
        jobs.append(job)
        starts.append(start)
    buffer = Buffer(np.zeros(10_000_000, np.uint8))
    played = fleet.play(jobs, [SceneShapes.of(s) for s in (plain, jointed)], buffer)
    for scene, job, start, result in zip((plain, jointed), jobs, starts, played, strict=True):
        found = read(job, start, result)
        alone = NewtonEngine().rollout(
            scene, batch_programs([program] * 2, scene.names), dt=DT, record_every=4
        )
        assert np.allclose(found.position, alone.position, atol=1e-5)
    assert len(fleet._models) == 2


def test_chain_of_ball_joints_does_not_explode() -> None:
    """Six links that fall from the horizontal and whip about for 5 s."""
    links = [box(f"l{i}", (0.1, 0.03, 0.03), 0.5, (0.1 + 0.2 * i, 0.0, 3.0)) for i in range(6)]
    joints = [
        joint_between(f"j{i}", "ball", b, links[i - 1] if i else None, at=(0.2 * i, 0.0, 3.0))
        for i, b in enumerate(links)
    ]
    r = play(SimScene("s", tuple(links), joints=tuple(joints)), seconds=5.0)
    height = r.position[0, :, :, 2].astype(float) - 3.0
    speed = (r.linear_velocity[0].astype(float) ** 2).sum(-1)
    energy = (0.5 * 9.81 * height + 0.25 * speed).sum(1)
    assert r.valid.all() and energy.max() < 0.2 * (0.5 * 9.81 * 0.1 * 36)


def test_joint_record_with_every_field_is_played() -> None:
    """A motor, limits, damping and friction at once: the arm goes to its place and stays."""
    arm = box("arm", (0.3, 0.05, 0.05), 2.0, (0.3, 0.0, 2.0))
    joint: Joint = replace(
        joint_between("j", "hinge", arm, None, at=(0.0, 0.0, 2.0), axis=(0.0, -1.0, 0.0)),
        lower=-1.0, upper=1.0, damping=0.3, friction=0.5, motor=Motor(1.0, 0.5, 30.0),
    )  # fmt: skip
    r = play(SimScene("s", (arm,), joints=(joint,)), seconds=3.0)
    state = joint_state(joint, paths(r, 0), None)
    assert state.position[-1] == pytest.approx(0.5, abs=0.01)
    assert np.diff(state.position).max() <= 1.0 * DT * 1.05


def workshop():
    """One of everything, side by side: a door, a pendulum, a drawer, a coil, a lamp, a sign."""
    leaf = box("leaf", (0.4, 0.02, 1.0), 20.0, (0.4, 0.0, 1.05))
    shot = ball("shot", 0.11, 1.0, (0.6, -2.0, 1.05))
    bob = ball("bob", 0.1, 4.0, (5.0, 0.0, 1.0))
    crate = box("crate", (0.2, 0.2, 0.2), 6.0, (5.9, 0.0, 0.9))
    shelf = replace(box("shelf", (0.3, 0.3, 0.35), 6.0, (5.9, 0.0, 0.35)), static=True)
    drawer = box("drawer", (0.3, 0.2, 0.1), 3.0, (10.0, 0.0, 1.0))
    coil = box("coil", (0.1, 0.1, 0.1), 2.0, (15.0, 0.0, 2.0))
    lamp = box("lamp", (0.05, 0.05, 0.3), 1.0, (20.0, 0.0, 2.2))
    sign = box("sign", (0.3, 0.02, 0.2), 2.0, (25.0, 0.0, 2.0))
    board = box("board", (0.3, 0.02, 0.2), 2.0, (25.7, 0.0, 2.0))
    bodies = (leaf, shot, bob, crate, shelf, drawer, coil, lamp, sign, board)
    z, y = (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)
    joints = (
        replace(
            joint_between("hinge", "hinge", leaf, None, at=(0.0, 0.0, 1.05), axis=z),
            lower=-0.1, upper=1.2, damping=0.6, friction=0.4,
        ),
        replace(
            joint_between("rope", "rope", bob, None, at=bob.position, parent_at=(5.0, 0.0, 3.0)),
            upper=2.0,
        ),
        replace(joint_between("rail", "slider", drawer, None, at=drawer.position), upper=0.6),
        replace(
            joint_between("spring", "spring", coil, None, at=coil.position,
                          parent_at=(15.0, 0.0, 3.0)),
            upper=0.8, stiffness=150.0, damping=1.0,
        ),
        replace(
            joint_between("hook", "ball", lamp, None, at=(20.0, 0.0, 2.5), axis=z), upper=1.0
        ),
        joint_between("pin", "hinge", sign, None, at=(25.0, 0.0, 2.2), axis=y),
        joint_between("weld", "fixed", board, sign, at=(25.35, 0.0, 2.0)),
    )  # fmt: skip
    commands = (
        SetVelocity("shot", 0.0, (0.0, 5.0, 0.5)),
        ApplyImpulse("bob", 0.2, (12.0, 0.0, 0.0)),
        DriveJoint("rail", 0.1, speed=0.5, limit=20.0),
        DriveJoint("rail", 1.0),
        ApplyImpulse("lamp", 0.0, (1.0, 0.5, 0.0)),
    )
    return SimScene("s", bodies, joints=joints), Program(commands, 1.5)


@pytest.mark.parametrize(("other", "struck"), [("physx", 0.05), ("rapier", 0.15)])
def test_one_program_moves_joints_alike_in_every_engine(other, struck) -> None:
    """What is struck is let off more: Rapier's friction knows nothing of restitution."""
    scene, program = workshop()
    batch = batch_programs([program], scene.names)
    one, two = (get_engine(e).rollout(scene, batch, dt=DT) for e in ("newton", other))
    apart = np.linalg.norm(one.position[0].astype(float) - two.position[0], axis=-1).max(axis=0)
    near = dict.fromkeys(scene.names, 0.01) | dict.fromkeys(("shot", "bob", "crate"), struck)
    assert {n: a for n, a in zip(scene.names, apart, strict=True) if a > near[n]} == {}
