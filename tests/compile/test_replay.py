from __future__ import annotations

from dataclasses import replace
import json
import math
from pathlib import Path
import re

from helpers import assert_same, both, first_touches, vouched, written
import numpy as np
import pytest
import scenes
from scenes import box

from esg.compile import ReplayError, WatchedEvent, emit_class, replay_class
from esg.compile.lint import lint
from esg.engines.physx_engine import PhysxWorld
from esg.engines.program import (
    AdjustProperties,
    BuoyUp,
    GuideAlong,
    HoldSpin,
    HoldVelocity,
    Program,
    SetVelocity,
)
from esg.engines.scene import Body, SimScene
from esg.outcomes import UserError
from esg.units import quat_rotate

CASES = {
    "street": (*scenes.street(), scenes.STREET_WATCH),
    "marbles": (*scenes.marbles(), scenes.MARBLES_WATCH),
}


@pytest.mark.parametrize("engine", ["physx", "rapier"])
@pytest.mark.parametrize("name", CASES)
def test_class_and_program_do_the_same(tmp_path: Path, name: str, engine: str) -> None:
    scene, program, watch = CASES[name]
    replayed, rollout = both(tmp_path, scene, program, watch, engine=engine)
    assert replayed.proof == "class" and replayed.rollout.valid.all()
    assert len(first_touches(rollout)) >= 1
    assert_same(replayed.rollout, rollout, tolerance_m=1e-6)


def test_the_class_described_the_scene(tmp_path: Path) -> None:
    scene, program, watch = CASES["marbles"]
    written(tmp_path, scene, program, watch)
    told = replay_class(tmp_path, duration=0.1).scene
    for one, two in zip(told.bodies, scene.bodies, strict=True):
        assert one.name == two.name and one.static == two.static and one.wheeled == two.wheeled
        np.testing.assert_allclose(one.position, two.position, atol=1e-9)
        np.testing.assert_allclose(one.quaternion, two.quaternion, atol=1e-9)
        np.testing.assert_allclose(one.inertia, two.inertia, rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(one.mass, two.mass, rtol=1e-6)
        for a, b in zip(one.shapes, two.shapes, strict=True):
            assert a.kind == b.kind
            np.testing.assert_allclose(a.size, b.size, atol=1e-9)
            np.testing.assert_allclose(a.position, b.position, atol=1e-9)


def test_log_reports_events_in_order(tmp_path: Path) -> None:
    scene, program, watch = CASES["marbles"]
    written(tmp_path, scene, program, watch)
    replayed = replay_class(tmp_path)
    hits = [e for e in replayed.events() if e["event"] == "EVENT_HIT"]
    assert [(h["a"], h["b"], h["pass"]) for h in hits] == [
        ("BallA", "BallB", "1"),
        ("BallB", "BallC", "1"),
    ]
    touches = first_touches(replayed.rollout)
    assert float(hits[0]["t"]) == pytest.approx(touches[0, 1], abs=1e-4)
    assert float(hits[1]["t"]) == pytest.approx(touches[1, 2], abs=1e-4)
    checks = [e for e in replayed.events() if e["event"] == "EVENT_CHECK"]
    assert [c["pass"] for c in checks] == ["1", "1"]
    assert float(checks[0]["t"]) - float(hits[0]["t"]) == pytest.approx(0.2, abs=0.006)
    assert (
        replayed.log[-1].startswith("Display: SCENE_END") and "complete=2 of=2" in replayed.log[-1]
    )


def test_later_event_waits_for_the_earlier_one(tmp_path: Path) -> None:
    scene, program, _ = CASES["marbles"]
    watch = (
        WatchedEvent("never", ("ball_a",), ("pill_1",)),
        WatchedEvent("b hits c", ("ball_b",), ("ball_c",), ("never",)),
    )
    written(tmp_path, scene, program, watch)
    assert replay_class(tmp_path).events() == []


def test_weak_touch_is_no_event(tmp_path: Path) -> None:
    light = (
        scenes.ball("a", (0.0, 0.0, 0.05), 0.05, 0.01),
        scenes.ball("b", (0.2, 0.0, 0.05), 0.05, 0.01),
    )
    program = Program((SetVelocity("a", 0.0, (0.5, 0.0, 0.0)),), 1.0)
    written(tmp_path, SimScene("weak", light), program, (WatchedEvent("e", ("a",), ("b",)),))
    replayed = replay_class(tmp_path)
    assert (0, 1) in first_touches(replayed.rollout)
    assert replayed.events() == []


def test_start_overlap_is_reported_with_its_depth(tmp_path: Path) -> None:
    half = (0.5, 0.5, 0.5)
    bodies = (
        scenes.box("one", (0.0, 0.0, 0.5), half, 10.0),
        scenes.box("two", (0.96, 0.0, 0.5), half, 10.0),
        scenes.box("three", (-1.01, 0.0, 0.5), half, 10.0),
    )
    written(tmp_path, SimScene("overlap", bodies), Program((), 0.2))
    log = replay_class(tmp_path).log
    overlaps = [line for line in log if "LAYOUT_OVERLAP" in line]
    assert len(overlaps) == 1 and "a=One b=Two penetration_cm=4.000" in overlaps[0]
    assert any("LAYOUT overlaps=1 deepest_cm=4.000 pass=0" in line for line in log)


def test_hold_ends_by_time_and_by_touch(tmp_path: Path) -> None:
    wall = scenes.box("wall", (3.0, 0.0, 0.5), (0.1, 2.0, 0.5), 1.0, static=True)
    cart = scenes.box("cart", (0.0, 0.0, 0.3), (0.4, 0.3, 0.3), 50.0, wheeled=True, friction=0.0)
    program = Program(
        (
            HoldVelocity("cart", 0.0, 0.5, 1.0, 0.0),
            HoldVelocity("cart", 1.0, math.inf, 2.0, 0.0, until_contact=("wall",)),
        ),
        4.0,
    )
    replayed, rollout = both(tmp_path, SimScene("holds", (wall, cart)), program)
    assert_same(replayed.rollout, rollout, tolerance_m=1e-6)
    under_way = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)]
    np.testing.assert_allclose(replayed.rollout.linear_velocity[0, 0], under_way, atol=1e-6)
    np.testing.assert_allclose(rollout.linear_velocity[0, 0], under_way, atol=1e-6)
    ends = [line for line in replayed.log if "ends" in line]
    assert "t=0.5" in ends[0] and "at=Wall" in ends[1] and len(ends) == 2


def test_friction_changes_by_material(tmp_path: Path) -> None:
    crate = scenes.box("crate", (0.0, 0.0, 0.3), (0.3, 0.3, 0.3), 5.0, friction=0.0)
    program = Program(
        (
            SetVelocity("crate", 0.0, (6.0, 0.0, 0.0)),
            AdjustProperties("crate", 0.5, friction=0.9),
        ),
        2.0,
    )
    replayed, rollout = both(tmp_path, SimScene("friction", (crate,)), program)
    assert_same(replayed.rollout, rollout, tolerance_m=1e-6)
    speed = np.linalg.norm(replayed.rollout.linear_velocity[0, :, 0], axis=1)
    # Before: only the ground's half of the average; after: half of 0.7 + 0.9.
    drop = (speed[120 + 24] - speed[120 + 48]) / 0.1
    assert drop == pytest.approx(0.8 * 9.81, rel=0.03)


def test_other_steps_agree_too(tmp_path: Path) -> None:
    scene, program, watch = CASES["marbles"]
    replayed, rollout = both(tmp_path, scene, program, watch, dt=1 / 480)
    assert_same(replayed.rollout, rollout, tolerance_m=1e-3)


def test_repeats_are_identical(tmp_path: Path) -> None:
    scene, program, watch = CASES["street"]
    written(tmp_path, scene, program, watch)
    one, two = replay_class(tmp_path), replay_class(tmp_path)
    assert np.array_equal(one.rollout.position, two.rollout.position)
    assert one.log == two.log and two.compile_seconds == 0.0


def test_what_is_left_out_was_heard_by_nobody(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Contacts with the ground that nobody asks for change neither log nor motion nor contacts."""
    written(tmp_path, *CASES["street"])
    left_out: list[list[int]] = []
    usual = PhysxWorld.leave_out

    def noted(world: PhysxWorld, bodies: list[int]) -> None:
        left_out.append(bodies)
        usual(world, bodies)

    monkeypatch.setattr(PhysxWorld, "leave_out", noted)
    one = replay_class(tmp_path)
    monkeypatch.setattr(PhysxWorld, "leave_out", lambda *_: None)
    two = replay_class(tmp_path)
    assert len(left_out) == 1 and left_out[0] and one.log == two.log
    for name in ("position", "quaternion", "linear_velocity", "angular_velocity"):
        assert np.array_equal(getattr(one.rollout, name), getattr(two.rollout, name))
    for name in ("a", "b", "time", "impulse", "depth", "point", "normal"):
        assert np.array_equal(*(getattr(r.rollout.contacts, name) for r in (one, two)))


def test_edited_class_changes_the_replay(tmp_path: Path) -> None:
    """What runs is the class, not the manifest beside it."""
    scene, program, watch = CASES["marbles"]
    written(tmp_path, scene, program, watch)
    before = replay_class(tmp_path, duration=0.3)
    source = tmp_path / "unreal" / "EsgScene_S7.cpp"
    text = source.read_text()
    assert "BallADrive1.Speed = 250.0;" in text
    source.write_text(text.replace("BallADrive1.Speed = 250.0;", "BallADrive1.Speed = 125.0;"))
    after = replay_class(vouched(tmp_path), duration=0.3)
    ratio = after.rollout.position[0, -1, 0, 0] / before.rollout.position[0, -1, 0, 0]
    assert ratio == pytest.approx(0.5, rel=1e-3)


def test_static_bodies_keep_their_centres(tmp_path: Path) -> None:
    scene, program, watch = CASES["street"]
    written(tmp_path, scene, program, watch)
    rollout = replay_class(tmp_path, duration=0.1).rollout
    for i, body in enumerate(scene.bodies):
        np.testing.assert_allclose(rollout.position[0, 0, i], body.position, atol=1e-6)


def test_missing_class_is_a_users_mistake(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="no compiled scene"):
        replay_class(tmp_path)


def test_broken_import_manifest_is_named(tmp_path: Path) -> None:
    written(tmp_path, *CASES["marbles"])
    (tmp_path / "unreal" / "imports.json").write_text("{")
    with pytest.raises(UserError, match=r"imports\.json"):
        replay_class(tmp_path, trust=True)


def test_asset_without_collision_is_refused(tmp_path: Path) -> None:
    written(tmp_path, *CASES["marbles"])
    path = tmp_path / "unreal" / "imports.json"
    data = json.loads(path.read_text())
    data["assets"][0]["collision"] = []
    path.write_text(json.dumps(data))
    with pytest.raises(ReplayError, match="no collision shapes"):
        replay_class(vouched(tmp_path))


def test_tilted_gravity_cannot_be_emitted(tmp_path: Path) -> None:
    scene, program, _ = CASES["marbles"]
    with pytest.raises(ValueError, match="Z component only"):
        written(tmp_path, replace(scene, gravity=(0.0, 1.0, -9.0)), program)


def test_tilted_principal_axes_survive_exactly(tmp_path: Path) -> None:
    """A tensor whose diagonalization has a free choice of signs: still bit for bit the program."""
    car = scenes.box("car", (0.0, 0.0, 0.8), (2.0, 0.9, 0.6), 1400.0, -1.57, wheeled=True)
    tensor = ((495.0128150641395, 0.0, 10.843414748729213), (0.0, 2479.916701051688, 0.0),
              (10.843414748729213, 0.0, 2699.949065249593))  # fmt: skip
    scene = SimScene("tilted", (replace(car, inertia=tensor),))
    program = Program((SetVelocity("car", 0.1, (3.0, 1.0, 2.0), (1.0, -2.0, 0.5)),), 2.0)
    replayed, rollout = both(tmp_path, scene, program)
    assert np.array_equal(replayed.rollout.position[0, 1:], rollout.position[0, 1:])
    assert np.array_equal(replayed.rollout.quaternion[0, 1:], rollout.quaternion[0, 1:])


def test_hits_of_one_step_come_in_one_order() -> None:
    """However the engine lists the shape pairs of a step, the class hears of them alike."""
    from itertools import permutations

    from esg.engines.executor import touch_order

    touches = [
        (0, 1, 3.0, 0.0, (0.0, 0.1, 0.2), (1.0, 0.0, 0.0)),
        (0, 1, 40.0, 0.0, (0.0, 0.3, 0.2), (1.0, 0.0, 0.0)),
        (0, 1, 3.0, 0.0, (0.0, 0.2, 0.2), (1.0, 0.0, 0.0)),
        (0, -1, 1.0, 0.0, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
    ]
    orders = {tuple(sorted(p, key=touch_order)) for p in permutations(touches)}
    assert len(orders) == 1
    assert orders.pop()[1][2] == 40.0


def drone() -> tuple[SimScene, Program, tuple[WatchedEvent, ...]]:
    """Climbs, flies level into a wall in a turnless line, then falls to the ground."""
    scene = SimScene(
        "drone",
        (
            box("drone_1", (0.0, 0.0, 2.0), (0.3, 0.3, 0.1), 1.5, linear_damping=0.1),
            box("wall_1", (4.0, 0.0, 2.0), (0.1, 2.0, 2.0), 0.0, static=True),
        ),
    )
    program = Program(
        (
            HoldVelocity("drone_1", 0.0, 0.5, 2.0, 0.0, climb=0.8),
            HoldVelocity("drone_1", 0.5, 99.0, 2.0, 0.0, until_contact=("wall_1",), climb=0.0),
        ),
        3.0,
    )
    return scene, program, (WatchedEvent("hit", ("drone_1",), ("wall_1",)),)


@pytest.mark.parametrize("dt", [1 / 240, 1 / 120])
def test_the_class_of_powered_flight_flies_as_its_program(tmp_path: Path, dt: float) -> None:
    scene, program, watch = drone()
    replayed, rollout = both(tmp_path, scene, program, watch, dt=dt)
    assert_same(replayed.rollout, rollout)
    height = replayed.rollout.position[0, :, 0, 2]
    assert height[round(0.5 / dt)] == pytest.approx(2.4, abs=1e-3)
    assert height[round(1.5 / dt)] == pytest.approx(2.4, abs=1e-3)
    assert height[-1] < 0.5
    (hit, *_) = replayed.events()
    assert float(hit["t"]) == pytest.approx(1.8, abs=0.05)


def test_the_class_of_a_hold_that_takes_its_time_plays_as_its_program(tmp_path: Path) -> None:
    """A sledge hits a post, slides back, and goes round it at its own pace."""
    scene = SimScene(
        "sledge",
        (
            box("sledge_1", (0.0, 0.0, 0.1), (0.2, 0.2, 0.1), 5.0, friction=0.0),
            box("post_1", (2.0, 0.0, 0.5), (0.1, 0.1, 0.5), 0.0, static=True),
        ),
        ground_friction=0.0,
    )
    drive = HoldVelocity("sledge_1", 0.0, 99.0, 3.0, 0.0, until_contact=("post_1",))
    again = HoldVelocity("sledge_1", 1.0, 2.5, 2.0, 1.2, gains=2.5, loses=4.0)
    turns = HoldVelocity("sledge_1", 3.0, 4.0, 1.0, 1.2, turn_rate=0.5, gains=2.5, loses=0.5)
    replayed, rollout = both(tmp_path, scene, Program((drive, again, turns), 4.0))
    assert_same(replayed.rollout, rollout)
    v = replayed.rollout.linear_velocity[0, :, 0]
    gains = np.diff(np.hypot(v[:, 0], v[:, 1]))[round(0.9 * 240) :] * 240
    assert gains.max() == pytest.approx(2.5, rel=0.02)
    at = v[round(2.9 * 240), :2]
    np.testing.assert_allclose(at, (2.0 * math.cos(1.2), 2.0 * math.sin(1.2)), atol=0.01)
    # Too fast for what is asked, it goes round the turn as it is.
    assert math.atan2(v[-1, 1], v[-1, 0]) == pytest.approx(1.7, abs=0.01)
    assert np.hypot(*v[-1, :2]) == pytest.approx(1.5, abs=0.02)
    emitted = emit_class(scene, Program((drive,), 3.0))
    assert "bTakesTime" not in emitted.header + emitted.source


def test_only_classes_with_flight_speak_of_it() -> None:
    scene, program, _ = drone()
    flying = emit_class(scene, program)
    assert "Drone1Drive1.bFlies = true;" in flying.source
    walking = Program(tuple(replace(p, climb=None) for p in program.primitives), 3.0)  # type: ignore[type-var]
    plain = emit_class(scene, walking)
    assert "Flies" not in plain.header + plain.source


def crane() -> tuple[SimScene, Program, tuple[WatchedEvent, ...]]:
    """A crate with its mass off centre is set onto a table; a top spins; a drop ends at a touch."""
    crate = box("crate_1", (0.0, 0.0, 0.1), (0.2, 0.2, 0.1), 2.0)
    offset = (0.03, -0.02, -0.08)
    shape = replace(crate.shapes[0], position=(0.03, -0.02, 0.02))
    scene = SimScene(
        "crane",
        (
            replace(crate, shapes=(shape,), position=(0.0, 0.0, 0.08), origin_offset=offset),
            box("table_1", (1.0, 0.5, 0.2), (0.4, 0.4, 0.2), 0.0, static=True),
            box("top_1", (0.0, 2.0, 0.1), (0.1, 0.1, 0.1), 1.0, friction=0.0),
            box("bag_1", (-2.0, 0.0, 1.0), (0.1, 0.1, 0.1), 1.0),
            box("wall_1", (-1.0, 0.0, 1.0), (0.1, 0.5, 1.0), 0.0, static=True),
        ),
    )
    rest, bag = (0.0, 0.0, 0.0), (-2.0, 0.0, 1.0)
    program = Program(
        (
            GuideAlong(
                "crate_1",
                0.1,
                (0.0, 0.6, 1.4, 1.9),
                ((0.0, 0.0, 0.08), (0.1, 0.1, 0.8), (0.97, 0.52, 0.8), (0.97, 0.52, 0.483)),
                (rest, (0.4, 0.2, 0.1), (0.1, 0.05, -0.2), rest),
                turn_rate=0.4,
            ),
            HoldSpin("top_1", 0.2, 1.7, 5.0, (0.0, 0.0, 2.0)),
            GuideAlong("bag_1", 0.0, (0.0, 2.0), (bag, (1.0, 0.0, 1.0)), (rest, rest),
                       until_contact=("wall_1",)),
        ),
        2.5,
    )  # fmt: skip
    return scene, program, (WatchedEvent("put", ("crate_1",), ("table_1",)),)


@pytest.mark.parametrize(("engine", "dt"), [("physx", 1 / 240), ("rapier", 1 / 120)])
def test_the_class_guides_and_spins_as_its_program(tmp_path: Path, engine: str, dt: float) -> None:
    scene, program, watch = crane()
    replayed, rollout = both(tmp_path, scene, program, watch, engine=engine, dt=dt)
    if engine == "physx":
        assert_same(replayed.rollout, rollout)
    # A class cannot spare its bodies gravity; Rapier's substeps lift them by 3 mm at 120 Hz.
    apart = np.abs(replayed.rollout.position - rollout.position)[0, :, :3]
    assert apart.max() < 0.5 * dt
    r = replayed.rollout
    np.testing.assert_allclose(r.position[0, -1, 0], (0.97, 0.52, 0.48), atol=0.01)
    assert r.angular_velocity[0, round(1.0 / dt), 2, 2] == pytest.approx(5.0, abs=1.5)
    assert r.position[0, -1, 3, 2] < 0.5  # The bag fell when it met the wall.
    ends = [line for line in replayed.log if "ends body=Bag1" in line.replace("_", "")]
    assert len(ends) == 1 and "GuideAlong ends" in ends[0]


@pytest.mark.parametrize("engine", ["physx", "rapier"])
def test_the_class_bears_up_as_its_program(tmp_path: Path, engine: str) -> None:
    """A light crate floats and turns no more, a heavy one sinks; in both as far as in the other."""
    half = (0.1, 0.08, 0.06)
    light, heavy = (
        box(name, (x, 0.0, 1.0), half, mass, 0.0)
        for name, x, mass in (("l", -0.5, 2.0), ("h", 0.5, 20.0))
    )
    scene = SimScene("pool", (light, heavy))
    basin = {"center": (0.0, 0.0, 0.6), "basin": (1.2, 0.6, 0.3), "heading": 0.2}
    drag = {"linear_drag": 3.0, "quadratic_drag": 8.0, "turning_drag": 4.0}
    program = Program(
        (
            BuoyUp("l", 0.0, math.inf, extents=half, lift=20.0, **basin, **drag),
            BuoyUp("h", 0.0, 4.0, extents=half, lift=2.0, **basin, **drag),
            SetVelocity("l", 0.05, (0.1, 0.0, 0.0), (0.0, 0.0, 3.0)),
        ),
        5.0,
    )
    replayed, rollout = both(tmp_path, scene, program, (), engine=engine, dt=1 / 240)
    r = replayed.rollout
    apart = np.abs(r.position - rollout.position)[0]
    assert apart.max() < 0.005
    assert r.position[0, -1, 0, 2] == pytest.approx(
        0.6 + 0.06 * (1.0 - 2.0 * 9.81 / 20.0), abs=0.003
    )
    assert r.position[0, -1, 1, 2] == pytest.approx(0.06, abs=0.003)
    assert abs(r.angular_velocity[0, -1, 0, 2]) < 0.05


def test_only_classes_that_guide_speak_of_it() -> None:
    scene, program, _ = crane()
    guiding = emit_class(scene, program)
    assert lint(guiding.header, guiding.source, guiding.name) == []
    assert "RunGuideAlong(Crate1Mesh," in guiding.source and "FEsgGuideAlong" in guiding.header
    plain = emit_class(scene, Program((), 2.5))
    assert not re.search("Guid|HoldSpin", plain.header + plain.source)


@pytest.mark.parametrize("engine", ["physx", "rapier"])
def test_the_class_brakes_as_its_program(tmp_path: Path, engine: str) -> None:
    scene = SimScene(
        "brakes",
        (
            box("sledge", (0.0, 0.0, 0.2), (0.5, 0.4, 0.2), 30.0, friction=0.0),
            scenes.ball("ball", (0.0, 4.0, 0.2), 0.2, 3.0),
            box("stone", (0.0, 8.0, 30.0), (0.1, 0.1, 0.1), 1.0),
        ),
        ground_friction=0.0,
    )
    program = Program(
        (
            HoldVelocity("sledge", 0.0, 0.7, 4.0, 0.5),
            SetVelocity("ball", 0.0, (2.0, 0.0, 0.0), (0.0, 10.0, 0.0)),
            SetVelocity("stone", 0.0, (5.0, 0.0, 0.0)),
            *(AdjustProperties(n, 0.5, braking=3.0) for n in scene.names),
            AdjustProperties("sledge", 1.2, braking=0.0),
        ),
        1.5,
    )
    replayed, rollout = both(tmp_path, scene, program, engine=engine)
    assert_same(replayed.rollout, rollout, tolerance_m=1e-6)
    speed = np.linalg.norm(replayed.rollout.linear_velocity[0, -1, :, :2], axis=1)
    np.testing.assert_allclose(speed, (4.0 - 3.0 * 0.5, 0.0, 5.0), atol=0.03)
    plain = tuple(p for p in program.primitives if not isinstance(p, AdjustProperties))
    emitted = emit_class(scene, Program(plain, 1.5))
    assert "Braking" not in emitted.header + emitted.source


@pytest.mark.parametrize("engine", ["physx", "rapier"])
def test_the_class_has_the_tyres_of_its_program(tmp_path: Path, engine: str) -> None:
    """Shoved to the side, hit at a corner with the brakes on, on two wheels, and thrown."""

    def car(name: str, y: float, z: float = 0.6, **more: float) -> Body:
        half = (2.2, 0.9, 0.6)
        body = box(name, (0.0, y, z), half, 1400.0, friction=0.1, wheeled=True, restitution=0.0)
        offset = (0.1, 0.0, -0.6)
        return replace(body, tyre_friction=0.75, origin_offset=offset, **more)

    bike = box("bike_1", (0.0, 30.0, 0.5), (1.0, 0.06, 0.5), 200.0, friction=0.1, wheeled=True)
    bodies = (
        car("car_1", 0.0),
        replace(car("car_2", 10.0), quaternion=(0.0, 0.0, 0.6, 0.8)),
        car("car_3", 20.0, 40.0),
        replace(bike, tyre_friction=0.75, tyre_drop=0.5),
        replace(bike, name="rider_1", position=(0.0, 40.0, 0.5), tyre_friction=0.75, tyre_drop=0.5),
        box("wall_1", (4.0, 40.3, 1.0), (0.1, 2.0, 1.0), 1.0, static=True),
    )
    program = Program(
        (
            HoldVelocity("car_1", 0.0, 0.3, 5.0, 0.0),
            *(SetVelocity(b.name, 0.5, (1.0, 3.0, 0.0), (0.0, 0.0, 2.0)) for b in bodies[:4]),
            HoldVelocity("rider_1", 0.0, math.inf, 5.0, 0.0, until_contact=("wall_1",)),
            AdjustProperties("car_2", 0.6, braking=4.0),
        ),
        2.0,
    )
    replayed, rollout = both(tmp_path, SimScene("tyres", bodies), program, engine=engine)
    # Who falls over on an edge magnifies the rounding of centimetres.
    assert_same(replayed.rollout, rollout, tolerance_m=1e-2)
    apart = np.abs(replayed.rollout.position - rollout.position)[0, :, :4]
    assert apart.max() < 1e-4
    v, spin = replayed.rollout.linear_velocity[0, -1], replayed.rollout.angular_velocity[0, -1]
    ahead = quat_rotate(replayed.rollout.quaternion[0, -1, 0].astype(float), (1.0, 0.0, 0.0))
    assert abs(ahead[0] * v[0, 1] - ahead[1] * v[0, 0]) < 0.02 and abs(spin[0, 2]) < 0.02
    assert np.linalg.norm(v[0]) > 0.2
    assert np.linalg.norm(v[1]) < 0.02
    np.testing.assert_allclose(v[2, :2], (1.0, 3.0), atol=1e-3)
    x, y = replayed.rollout.quaternion[0, -1, 3:5, :2].T
    assert (1.0 - 2.0 * (x**2 + y**2) < 0.3).all()  # They have fallen over.
    plain = SimScene("tyres", tuple(replace(b, tyre_friction=0.0) for b in bodies))
    emitted = emit_class(plain, Program((), 1.0))
    assert "TyreFriction" not in emitted.header + emitted.source
