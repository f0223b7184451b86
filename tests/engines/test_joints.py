"""Joints in the engines: closed forms (`benchmarks.joints`), motors, breaking, what touches what."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from benchmarks.analytic import Film
from benchmarks.joints import (
    Case,
    Row,
    breaks,
    cases,
    cradles,
    hits,
    markdown,
    positions,
    run,
    too_far,
)
from esg.engines import get_engine
from esg.engines.joint_rules import JointForces, Masses, ends_of, kick
from esg.engines.joints import Joint, Motor, joint_between, joint_problems
from esg.engines.manifest import manifest_bytes, manifest_from_json, manifest_to_json
from esg.engines.program import (
    DriveJoint,
    Primitive,
    Program,
    SetVelocity,
    batch_programs,
    program_from_json,
    program_to_json,
)
from esg.engines.rapier_joints import PARTS, Turning
from esg.engines.scene import Body, Rollout, SimScene
from esg.engines.worlds import world_values
from esg.outcomes import UserError
from tests.engines.lab import DT, box

STEPPED = ("newton", "physx", "rapier")
_Z = (0.0, 0.0, 1.0)


def play(
    engine: str, scene: SimScene, *commands: Primitive, duration: float = 1.0, dt: float = DT
) -> Rollout:
    batch = batch_programs([Program(commands, duration)], scene.names)
    return get_engine(engine).rollout(scene, batch, dt=dt)


@pytest.mark.parametrize("engine", ["physx", "rapier"])
def test_every_closed_form_holds(engine: str) -> None:
    assert too_far(run((engine,))) == []


def test_rapier_gives_back_only_to_what_the_world_holds() -> None:
    """A pair that spins as it falls keeps its momentum; what the world holds, its energy."""
    free = next(c for c in cases() if "spinning" in c.name)
    held = next(c for c in cases() if "120 degrees" in c.name)
    for case, groups in ((free, 0), (held, 1)):
        values = world_values(case.scene, None, 1)
        masses = Masses.of(case.scene, values, 0)
        turning = Turning(case.scene, masses, ends_of(case.scene), DT / PARTS)
        assert len(turning._groups) == groups


def test_what_bends_a_straight_way_takes_a_share_of_its_energy() -> None:
    """m (w^2 r t)^2 / 2 of what a ball joint swings at w, after it went straight on for t."""
    case = next(c for c in cases() if "ball joint, 30" in c.name)
    masses = Masses.of(case.scene, world_values(case.scene, None, 1), 0)
    bob, arm = case.scene.bodies[0], 1.0

    class Swinging:
        def read(self, body: int) -> tuple[object, ...]:
            x = np.array(bob.position) - (0.0, 0.0, 3.0)
            spin = np.array([0.0, 2.0, 0.0])
            return np.array(bob.position), bob.quaternion, np.cross(spin, x), spin

    lost, energy = JointForces(case.scene, masses).bent([0], Swinging(), 1e-3)  # type: ignore[arg-type]
    assert energy == pytest.approx(0.5 * (bob.inertia[1][1] + bob.mass * arm**2) * 2.0**2)
    assert lost == pytest.approx(0.5 * bob.mass * (2.0**2 * arm * 1e-3) ** 2, rel=1e-4)


def test_what_misses_its_limit_is_named() -> None:
    case = replace(breaks()[0], exact=(1.0,), limits=(0.1,))
    row = Row(case, {"physx": (1.3,)}, {"physx": (0.3,)}, {"physx": 0.002})
    first, second = too_far([row])
    assert "rope that holds: physx measured (1.3,)" in first
    assert "lets anchors 0.002 m apart" in second
    assert markdown([row], ("physx",)).splitlines()[-1].endswith("| 30.00%; 2.00 mm |")


@pytest.mark.parametrize(("stiffness", "damping"), [(40.0, 0.0), (40.0, 3.0), (40.0, 40.0)])
@pytest.mark.parametrize("dt", [1 / 240, 1 / 60])
def test_a_kick_gives_the_positions_of_the_damped_oscillator(
    stiffness: float, damping: float, dt: float
) -> None:
    inertia = 2.0
    by_x, by_v = kick(stiffness, damping, inertia, dt)
    fade = damping / (2.0 * inertia)
    roots = np.roots([inertia, damping, stiffness]).astype(complex)

    def exact(t: float) -> float:
        # It starts at 1 with the speed -fade, whatever its damping.
        weight = np.linalg.solve([[1.0, 1.0], roots], [1.0, -fade])
        return float((weight @ np.exp(roots * t)).real)

    x, v = exact(dt), (exact(dt) - exact(0.0)) / dt
    for n in range(2, 200):
        v += (by_x * x + by_v * v) / inertia
        x += v * dt
        assert x == pytest.approx(exact(n * dt), abs=1e-9)


def test_a_spring_that_is_too_stiff_for_the_step_does_not_explode() -> None:
    bob = box("bob", (0.1, 0.1, 0.1), 1.0, (0.0, 0.0, 2.4))
    spring = joint_between("s", "spring", bob, None, at=bob.position, parent_at=(0, 0, 3))
    scene = SimScene("s", (bob,), joints=(replace(spring, upper=0.5, stiffness=1e8),))
    for engine in STEPPED:
        out = play(engine, scene, duration=2.0)
        assert out.valid.all()
        assert np.abs(out.position[0, :, 0, 2] - 2.5).max() < 0.13


def turning(**changes: object) -> tuple[SimScene, float]:
    """A disc on a vertical axle, and its moment of inertia."""
    disc = box("disc", (0.3, 0.3, 0.05), 10.0, (0.0, 0.0, 1.0))
    axle = joint_between("axle", "hinge", disc, None, at=disc.position, axis=_Z)
    return SimScene("s", (disc,), joints=(replace(axle, **changes),)), disc.inertia[2][2]


@pytest.mark.parametrize("engine", STEPPED)
def test_a_program_drives_a_joint_and_lets_it_go(engine: str) -> None:
    scene, inertia = turning(friction=0.6)
    out = play(
        engine,
        scene,
        DriveJoint("axle", 0.5, speed=2.0, limit=1.2),
        DriveJoint("axle", 2.0),
        duration=4.5,
    )
    spin = out.angular_velocity[0, :, 0, 2]

    def at(t: float) -> float:
        return float(spin[round(t / DT)])

    gain, loss = 1.2 / inertia, 0.6 / inertia
    assert at(0.49) == pytest.approx(0.0, abs=1e-4)
    assert at(1.0) == pytest.approx(0.5 * gain, rel=0.01)
    assert at(1.9) == pytest.approx(2.0, rel=1e-3)
    assert at(3.0) == pytest.approx(2.0 - loss, rel=0.01)
    assert at(4.4) == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("engine", STEPPED)
def test_a_motor_drives_to_a_place_and_stays_there(engine: str) -> None:
    scene, _ = turning(motor=Motor(4.0, -0.5))
    out = play(engine, scene, DriveJoint("axle", 1.0, speed=0.5, position=0.4), duration=4.0)
    angle = 2.0 * np.arctan2(out.quaternion[0, :, 0, 2], out.quaternion[0, :, 0, 3])
    assert angle[round(0.9 / DT)] == pytest.approx(-0.5, abs=1e-3)
    assert angle[round(2.0 / DT)] == pytest.approx(0.0, abs=5e-3)
    assert angle[-1] == pytest.approx(0.4, abs=1e-3)


def falling(kind: str, *, collide: bool, breaks: bool) -> SimScene:
    """A box joined to a post below it, which is thrown at it."""
    post = replace(box("post", (0.3, 0.3, 0.5), 1.0, (0.0, 0.0, 0.5)), static=True)
    top = box("top", (0.1, 0.1, 0.1), 5.0, (0.0, 0.0, 1.3))
    joint = joint_between("j", kind, top, post, at=top.position)
    joint = replace(joint, collide=collide, break_impulse=1.0 if breaks else None)
    if kind == "rope":
        joint = replace(joint, upper=2.0)
    return SimScene("s", (post, top), joints=(joint,))


@pytest.mark.parametrize("engine", STEPPED)
@pytest.mark.parametrize(
    ("kind", "collide", "breaks", "height"),
    [
        ("fixed", False, False, 1.3),
        ("hinge", False, True, 1.1),
        ("ball", True, True, 1.1),
        ("rope", True, False, 1.1),
        ("rope", False, False, 0.1),
    ],
)
def test_joined_bodies_touch_if_they_may_or_once_their_joint_has_broken(
    engine: str, kind: str, collide: bool, breaks: bool, height: float
) -> None:
    scene = falling(kind, collide=collide, breaks=breaks)
    out = play(engine, scene, SetVelocity("top", 0.1, (0.0, 0.0, -2.0)), duration=1.5)
    assert out.position[0, -1, 1, 2] == pytest.approx(height, abs=2e-3)


@pytest.mark.parametrize("engine", STEPPED)
def test_the_joint_that_breaks_is_the_one_that_took_the_blow(engine: str) -> None:
    """Two boxes hang in a row; the lower one is torn off by a blow that its own joint cannot take.

    What the upper joint took, it passed on; it is stronger.
    """
    upper = box("upper", (0.1, 0.1, 0.1), 2.0, (0.0, 0.0, 3.0))
    lower = box("lower", (0.1, 0.1, 0.1), 2.0, (0.0, 0.0, 2.7))
    joints = (
        replace(joint_between("a", "fixed", upper, None, at=(0, 0, 3.1)), break_impulse=6.0),
        replace(joint_between("b", "fixed", lower, upper, at=(0, 0, 2.85)), break_impulse=3.0),
    )
    scene = SimScene("s", (upper, lower), joints=joints)
    for push, falls in ((1.0, False), (2.0, True)):
        out = play(engine, scene, SetVelocity("lower", 0.2, (0.0, 0.0, -push)), duration=1.0)
        up, down = out.position[0, -1, :, 2].tolist()
        assert up == pytest.approx(3.0, abs=2e-3)
        assert (down < 1.0) == falls


@pytest.mark.parametrize("engine", STEPPED)
def test_a_rope_between_two_bodies_tows_and_keeps_momentum(engine: str) -> None:
    cars = tuple(
        box(n, (0.2, 0.1, 0.1), m, (x, 0.0, 5.0)) for n, x, m in (("a", 0.0, 3.0), ("b", 1.5, 1.0))
    )
    rope = joint_between("r", "rope", cars[0], cars[1], at=(0, 0, 5), parent_at=(1.5, 0, 5))
    scene = SimScene("s", cars, joints=(replace(rope, upper=2.0),), gravity=(0.0, 0.0, 0.0))
    out = play(engine, scene, SetVelocity("b", 0.0, (4.0, 0.0, 0.0)), duration=1.0)
    # Taut, both go on as one: a rope does not throw back.
    assert out.linear_velocity[0, -1, :, 0] == pytest.approx([1.0, 1.0], abs=2e-3)
    gap = out.position[0, :, 1, 0] - out.position[0, :, 0, 0]
    assert gap.max() < 2.001


@pytest.mark.parametrize("engine", STEPPED)
def test_a_body_without_shapes_may_bear_a_joint(engine: str) -> None:
    turn = (0.0, 0.0, math.sin(0.4), math.cos(0.4))
    mark = Body("mark", True, 1.0, ((1, 0, 0), (0, 1, 0), (0, 0, 1)), (), (0.3, 0.2, 2.0), turn)
    lamp = box("lamp", (0.1, 0.1, 0.1), 2.0, (0.3, 0.2, 1.5))
    for kind, upper in (("hinge", None), ("rope", 0.5)):
        joint = joint_between("j", kind, lamp, mark, at=lamp.position, parent_at=(0.3, 0.2, 2.0))
        if kind == "hinge":
            joint = joint_between("j", kind, lamp, mark, at=(0.3, 0.2, 2.0))
        scene = SimScene("s", (mark, lamp), joints=(replace(joint, upper=upper),))
        out = play(engine, scene, duration=0.5)
        np.testing.assert_allclose(out.position[0, -1, 1], lamp.position, atol=1e-3)


@pytest.mark.parametrize("engine", STEPPED)
def test_equal_scenes_give_equal_bytes(engine: str) -> None:
    case: Case = hits()[0]
    one, two = (play(engine, case.scene, *case.commands, duration=0.3) for _ in range(2))
    assert one.position.tobytes() == two.position.tobytes()


def test_only_joints_that_physx_holds_change_its_solver() -> None:
    scene, _ = turning()
    rope = joint_between("r", "rope", scene.bodies[0], None, at=(0, 0, 1), parent_at=(0, 0, 2))
    for joints, expected in (
        (scene.joints, ("TGS", [64, 1])),
        ((replace(rope, upper=1.5),), ("PGS", [16, 1])),
        ((), ("PGS", [16, 1])),
    ):
        extra = play("physx", replace(scene, joints=joints), duration=0.1).extra
        assert (extra["solver"], extra["iterations"]) == expected


@pytest.mark.parametrize("engine", STEPPED)
def test_a_chain_that_carries_a_load_holds_together(engine: str) -> None:
    links = [box(f"link {i}", (0.1, 0.03, 0.03), 0.5, (0.2 * i + 0.1, 0, 5)) for i in range(8)]
    links.append(box("load", (0.1, 0.1, 0.1), 5.0, (1.7, 0.0, 5.0)))
    ends: list[Body | None] = [None, *links[:-1]]
    joints = tuple(
        joint_between(f"j{i}", "ball", link, end, at=(0.2 * i, 0.0, 5.0))
        for i, (link, end) in enumerate(zip(links, ends, strict=True))
    )
    scene = SimScene("s", tuple(links), joints=joints)
    film = Film(scene, play(engine, scene, duration=3.0))
    assert max(float(positions(film, j)[1].max()) for j in joints) < 1e-3


@pytest.mark.parametrize("engine", STEPPED)
def test_two_ropes_hold_a_seat_level(engine: str) -> None:
    seat = box("seat", (0.25, 0.1, 0.02), 8.0, (0.0, 0.0, 1.0))
    ropes = tuple(
        replace(joint_between(f"r{x}", "rope", seat, None, at=(x, 0, 1.02), parent_at=(x, 0, 3)),
                upper=1.98)
        for x in (-0.2, 0.2)
    )  # fmt: skip
    scene = SimScene("s", (seat,), joints=ropes)
    out = play(engine, scene, SetVelocity("seat", 0.0, (0.0, 2.0, 0.0)), duration=4.0)
    film = Film(scene, out)
    assert max(float(positions(film, r)[1].max()) for r in ropes) < 1e-3
    energy = 0.5 * np.square(out.linear_velocity[0, :, 0]).sum(-1) + 9.81 * out.position[0, :, 0, 2]
    assert energy[-200:].mean() - energy[0] == pytest.approx(0.0, abs=0.06 * 2.0)
    assert np.abs(out.position[0, :, 0, 0]).max() < 1e-2


def test_what_cannot_be_is_refused_with_its_reason() -> None:
    scene, _ = turning(upper=4.0)
    with pytest.raises(ValueError, match="/joints/0/upper: a hinge turns by pi at most"):
        play("physx", scene)
    scene, _ = turning()
    with pytest.raises(ValueError, match="DriveJoint of 'door', which has no motor"):
        play("rapier", scene, DriveJoint("door", 0.0, speed=1.0))
    with pytest.raises(ValueError, match="has joints, which the surrogate cannot simulate"):
        play("surrogate", scene)
    both: tuple[Body, ...] = cradles()[0].bodies[:2]
    joint: Joint = joint_between("j", "hinge", *both, at=both[0].position)
    told = joint_problems(SimScene("s", both, joints=(replace(joint, collide=True),)))
    assert told == ["/joints/0/collide: two moving bodies cannot, joined so; leave it out"]


def test_a_driven_joint_goes_through_the_program_and_the_manifest() -> None:
    scene, _ = turning()
    program = Program(
        (DriveJoint("axle", 0.5, speed=2.0, limit=1.5), DriveJoint("axle", 1.0, position=0.3),
         DriveJoint("axle", 2.0)), 3.0,
    )  # fmt: skip
    assert program_from_json(program_to_json(program)) == program
    assert math.isinf(program.primitives[2].limit)  # type: ignore[union-attr]
    data = manifest_to_json(scene, program, dt=DT)
    assert "drive" in data["conventions"]
    assert manifest_bytes(manifest_to_json(scene, Program((), 1.0), dt=DT)).count(b'"drive"') == 0
    assert manifest_from_json(data).program == program
    data["program"]["primitives"][1]["joint"] = "door"
    with pytest.raises(UserError, match="/program/primitives/1/joint: no joint 'door'"):
        manifest_from_json(data)
