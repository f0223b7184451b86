"""What every engine promises besides physics: repeatability, isolation, variations, bad input."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from esg.engines import ENGINES, available, get_engine
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.scene import Body, Shape, SimScene, Variation
from esg.outcomes import UserError
from tests.engines.lab import ball, box

DT = 1.0 / 240.0
SCENE = SimScene(
    "pool",
    (
        ball("a", 0.1, 1.0, (0.0, 0.0, 0.1), friction=0.2, restitution=0.8),
        ball("b", 0.1, 1.0, (0.8, 0.03, 0.1), friction=0.2, restitution=0.8),
        box("c", (0.2, 0.2, 0.2), 2.0, (1.5, 0.0, 0.2)),
    ),
    ground_friction=0.4,
)
FIELDS = ("position", "quaternion", "linear_velocity", "angular_velocity")


def batch(speeds, duration=0.8):
    programs = [Program((SetVelocity("a", 0.0, (v, 0.0, 0.0)),), duration) for v in speeds]
    return batch_programs(programs, SCENE.names)


def same(one, two, world_one=slice(None), world_two=slice(None)):
    for name in FIELDS:
        np.testing.assert_array_equal(
            getattr(one, name)[world_one], getattr(two, name)[world_two], err_msg=name
        )


@pytest.fixture(params=ENGINES)
def engine(request):
    return get_engine(request.param)


def test_repeats_are_bit_identical_whatever_ran_in_between(engine):
    first = engine.rollout(SCENE, batch([3.0, 2.0]))
    engine.rollout(
        SCENE, batch([5.0, 1.0], 0.4), variation=Variation(mass_scale=np.full((2, 3), 3))
    )
    second = engine.rollout(SCENE, batch([3.0, 2.0]))
    same(first, second)
    for name in first.contacts.__dataclass_fields__:
        np.testing.assert_array_equal(
            getattr(first.contacts, name), getattr(second.contacts, name), err_msg=name
        )
    assert len(first.contacts.world)


def test_a_world_does_not_depend_on_its_batch(engine):
    alone = engine.rollout(SCENE, batch([3.0]))
    together = engine.rollout(SCENE, batch([1.0, 4.0, 3.0]))
    same(alone, together, 0, 2)
    np.testing.assert_array_equal(alone.contacts.impulse, together.contacts.select(2).impulse)


def test_diverging_worlds_are_flagged_and_leave_the_others_alone(engine):
    alone = engine.rollout(SCENE, batch([3.0]))
    position = np.tile(np.array([b.position for b in SCENE.bodies]), (4, 1, 1))
    position[2, 1, 0] = np.nan
    together = engine.rollout(
        SCENE, batch([3.0, 7000.0, 3.0, 3.0]), variation=Variation(position=position)
    )
    assert together.valid.tolist() == [True, False, False, True]
    same(alone, together, 0, 0)
    same(alone, together, 0, 3)
    assert not np.isin(together.contacts.world, [1, 2]).any()
    for name in FIELDS:
        assert np.isfinite(getattr(together, name)[[0, 1, 3]]).all()


def test_frames_accumulate_contacts(engine):
    fine = engine.rollout(SCENE, batch([3.0]))
    coarse = engine.rollout(SCENE, batch([3.0]), record_every=4)
    np.testing.assert_array_equal(fine.position[:, ::4], coarse.position)
    np.testing.assert_allclose(coarse.time, fine.time[::4])
    assert coarse.contacts.impulse.sum() == pytest.approx(fine.contacts.impulse.sum(), rel=1e-5)
    assert coarse.contacts.time[0] == pytest.approx(fine.contacts.time[0])
    assert coarse.contacts.frame[0] == -(-fine.contacts.frame[0] // 4)
    assert coarse.contacts.depth.max() == pytest.approx(fine.contacts.depth.max(), abs=1e-6)


def test_variations_act_per_world(engine):
    scene = SimScene(
        "slides", (box("a", (0.2, 0.2, 0.1), 2.0, (0, 0, 0.1), friction=0.3),), ground_friction=0.7
    )
    programs = [Program((SetVelocity("a", 0.0, (2.0, 0.0, 0.0)),), 1.2)] * 3
    position = np.array([[[0, 0, 0.1]], [[0, 5, 0.1]], [[0, 0, 0.1]]], float)
    rollout = engine.rollout(
        scene,
        batch_programs(programs, scene.names),
        variation=Variation(
            position=position,
            mass_scale=np.array([[1.0], [10.0], [1.0]]),
            friction_scale=np.array([1.0, 1.0, 0.5]),
        ),
    )
    stop = rollout.position[:, -1, 0, 0]
    expected = 4.0 / (2.0 * 0.5 * 9.81)
    assert stop[:2] == pytest.approx([expected, expected], rel=0.03)
    assert stop[2] == pytest.approx(2.0 * expected, rel=0.03)
    assert rollout.position[1, -1, 0, 1] == pytest.approx(5.0, abs=1e-3)


def test_restitution_offset_is_clipped_and_static_bodies_may_move_between_worlds(engine):
    wall = Body("wall", True, 0.0, SCENE.bodies[0].inertia, SCENE.bodies[2].shapes, (1.0, 0, 0.3))
    scene = SimScene("bounce", (ball("a", 0.1, 1.0, (0, 0, 0.3), restitution=0.4), wall),
                     gravity=(0, 0, 0))  # fmt: skip
    scene = replace(scene, bodies=(scene.bodies[0], replace(wall, restitution=0.4)))
    programs = [Program((SetVelocity("a", 0.0, (2.0, 0.0, 0.0)),), 0.8)] * 3
    position = np.array([[[0, 0, 0.3], [x, 0, 0.3]] for x in (1.0, 1.0, 0.7)])
    rollout = engine.rollout(
        scene,
        batch_programs(programs, scene.names),
        variation=Variation(position=position, restitution_offset=np.array([0.0, 0.9, 0.0])),
    )
    assert rollout.linear_velocity[:, -1, 0, 0] == pytest.approx([-0.8, -2.0, -0.8], abs=0.03)
    # Gaps of 0.7 m and 0.4 m to the walls.
    times = [rollout.contacts.select(w).time[0] for w in range(3)]
    assert times == pytest.approx([0.35, 0.35, 0.2], abs=0.02 + DT)
    assert rollout.position[2, -1, 1, 0] == pytest.approx(0.7, abs=1e-6)


def test_wheeled_bodies_touch_only_the_vehicle_ground(engine):
    scene = SimScene(
        "grounds",
        (
            box("cart", (0.3, 0.2, 0.1), 10.0, (0, 0, 0.1), friction=0.0, wheeled=True),
            box("crate", (0.3, 0.2, 0.1), 10.0, (0, 3, 0.1), friction=0.0),
        ),
        ground_friction=0.8,
        vehicle_ground_friction=0.1,
    )
    push = tuple(SetVelocity(n, 0.0, (3.0, 0.0, 0.0)) for n in scene.names)
    rollout = engine.rollout(scene, batch_programs([Program(push, 0.5)], scene.names))
    lost = 3.0 - rollout.linear_velocity[0, -1, :, 0]
    assert lost == pytest.approx([0.05 * 9.81 * 0.5, 0.4 * 9.81 * 0.5], rel=0.03)


def test_wheeled_and_normal_bodies_collide(engine):
    scene = SimScene(
        "crash",
        (
            box("cart", (0.3, 0.2, 0.1), 10.0, (0, 0, 0.1), friction=0.0, wheeled=True),
            box("crate", (0.3, 0.2, 0.1), 10.0, (1.0, 0, 0.1)),
        ),
    )
    push = Program((SetVelocity("cart", 0.0, (3.0, 0.0, 0.0)),), 0.5)
    rollout = engine.rollout(scene, batch_programs([push], scene.names))
    assert (rollout.contacts.a == 0).any() and (rollout.contacts.b == 1).any()
    assert rollout.position[0, -1, 1, 0] > 1.05


def test_impossible_input_is_named(engine):
    bad = SimScene(
        "bad",
        (
            replace(SCENE.bodies[0], mass=-1.0),
            replace(SCENE.bodies[1], name="a"),
            replace(SCENE.bodies[2], static=True),
        ),
    )
    programs = batch_programs([Program((SetVelocity("c", 0.0, (1, 0, 0)),), 1.0)], bad.names)
    with pytest.raises(ValueError, match=r"mass -1.0.*'a' is reserved or used twice.*cannot move"):
        engine.rollout(bad, programs)
    with pytest.raises(ValueError, match="mass_scale has shape"):
        engine.rollout(SCENE, batch([1.0]), variation=Variation(mass_scale=np.ones(3)))
    with pytest.raises(ValueError, match="dt is 0"):
        engine.rollout(SCENE, batch([1.0]), dt=0.0)


def test_flat_convex_shapes_are_named(engine):
    flat = Shape("convex", (0.1, 0.1, 0.0), vertices=((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)))
    bad = SCENE.with_bodies((replace(SCENE.bodies[0], shapes=(flat,)), *SCENE.bodies[1:]))
    with pytest.raises(ValueError, match="'a' has a convex shape without volume"):
        engine.rollout(bad, batch([1.0]))


def test_threads_may_share_an_engine(engine):
    alone = [engine.rollout(SCENE, batch([v], 0.3)) for v in (1.0, 2.0, 3.0)]
    with ThreadPoolExecutor(3) as pool:
        together = list(pool.map(lambda v: engine.rollout(SCENE, batch([v], 0.3)), (1.0, 2.0, 3.0)))
    for one, other in zip(alone, together, strict=True):
        same(one, other)


def test_unknown_engines_and_devices_are_user_errors():
    with pytest.raises(UserError, match="bullet"):
        get_engine("bullet")
    with pytest.raises(UserError, match="cuda:9"):
        get_engine("newton", device="cuda:9")


def test_available_reports_every_engine():
    assert {n: ok for n, (ok, _) in available().items()} == dict.fromkeys(ENGINES, True)


def test_newton_keeps_its_model_while_only_values_change():
    from esg.engines.newton import engine as newton_engine

    newton_engine.clear_cache()
    engine = get_engine("newton")
    engine.rollout(SCENE, batch([3.0], 0.1))
    (model,) = newton_engine._models.values()
    graphs = dict(model._graphs)
    moved = SCENE.with_bodies(
        tuple(replace(b, friction=0.1, mass=b.mass * 2, linear_damping=0.3) for b in SCENE.bodies)
    )
    engine.rollout(moved, batch([1.0], 0.2), record_every=2)
    assert list(newton_engine._models.values()) == [model]
    assert model._graphs == graphs


HEAP = SimScene(
    "heap",
    tuple(
        box(f"b{i}", (0.2, 0.2, 0.1), 1.0, (0.1 * (i % 3), 0.1 * (i % 2), 0.15 + 0.25 * i))
        for i in range(8)
    ),
)


def test_newton_makes_room_when_contacts_overflow(monkeypatch):
    from esg.engines.newton import engine as newton_engine

    def run():
        newton_engine.clear_cache()
        programs = batch_programs([Program((), 0.8)] * 2, HEAP.names)
        return get_engine("newton").rollout(HEAP, programs)

    roomy = run()
    few = replace(newton_engine.POINTS, world=8, body=0, shape=0)
    monkeypatch.setattr(newton_engine, "POINTS", few)
    tight = run()
    assert max(newton_engine._growth.values()) > 1
    same(roomy, tight)
    newton_engine.clear_cache()


@pytest.mark.parametrize("threads", ["1", "3"])
def test_newton_threads_do_not_change_results(threads, monkeypatch):
    speeds = np.linspace(1.0, 4.0, 20)
    monkeypatch.setenv("ESG_THREADS", "2")
    expected = get_engine("newton").rollout(SCENE, batch(speeds, 0.4))
    monkeypatch.setenv("ESG_THREADS", threads)
    same(expected, get_engine("newton").rollout(SCENE, batch(speeds, 0.4)))


def test_thread_number_must_be_positive(monkeypatch):
    monkeypatch.setenv("ESG_THREADS", "many")
    with pytest.raises(UserError, match="ESG_THREADS"):
        get_engine("newton")


def test_principal_axes_are_stable_under_rebuilding() -> None:
    """Moments and axes of a rebuilt tensor are the same again, and nearest to the body's axes."""
    from esg.engines.worlds import principal_axes
    from esg.units import quat_rotate

    rng = np.random.default_rng(4)
    for _ in range(50):
        a = rng.normal(size=(3, 3))
        inertia = a @ a.T + np.eye(3)
        moments, quaternion = principal_axes(inertia)
        axes = quat_rotate(quaternion, np.eye(3)).T
        rebuilt = axes @ np.diag(moments) @ axes.T
        assert np.allclose(rebuilt, inertia, rtol=1e-9)
        again, quaternion_again = principal_axes(rebuilt * (1.0 + 1e-14))
        assert np.allclose(again, moments)
        assert abs(abs(float(quaternion @ quaternion_again)) - 1.0) < 1e-9


def test_physx_holds_what_a_heavy_body_presses_against_a_wall() -> None:
    """8 t at 2 m/s press 15 kg on a wall: with 16 sweeps it sinks 6.4 cm in."""
    truck = box("truck", (3.8, 1.2, 1.0), 8000.0, (-4.4, 0.0, 1.0), friction=0.1, restitution=0.0)
    crate = box("crate", (0.3, 0.3, 0.3), 15.0, (0.0, 0.0, 0.3), friction=0.45, restitution=0.0)
    wall = replace(box("wall", (0.1, 2.0, 1.0), 1.0, (0.6, 0.0, 1.0)), static=True)
    scene = SimScene("press", (replace(truck, wheeled=True), crate, wall))
    program = Program((SetVelocity("truck", 0.0, (2.0, 0.0, 0.0)),), 1.0)
    r = get_engine("physx").rollout(scene, batch_programs([program], scene.names))
    assert r.extra["iterations"] == [64, 1]
    assert r.contacts.depth.max() < 0.03
    even = scene.with_bodies((replace(truck, mass=1500.0, wheeled=True), crate, wall))
    r = get_engine("physx").rollout(even, batch_programs([program], even.names), duration=0.1)
    assert r.extra["iterations"] == [16, 1]


def test_contacts_tell_nothing_of_where_physx_has_put_its_shapes() -> None:
    """Two feet land at once; which shape lies first in memory follows from what was played before."""
    import sapien

    feet = tuple(
        Shape("box", (0.1, 0.1, 0.1), (x, y, -0.1)) for x in (-0.3, 0.0, 0.3) for y in (-0.2, 0.2)
    )
    stool = replace(box("stool", (0.4, 0.3, 0.2), 5.0, (0.0, 0.0, 0.45)), shapes=feet)
    table = replace(box("table", (1.0, 1.0, 0.1), 0.0, (0.0, 0.0, 0.1)), static=True)
    scene, program = SimScene("lands", (stool, table)), Program((), 0.4)
    rng, kept = np.random.default_rng(0), []
    points: list[np.ndarray] = []
    for _ in range(4):
        played = sapien.Scene([sapien.physx.PhysxCpuSystem()])
        bodies = []
        for _ in range(400):
            builder = played.create_actor_builder()
            for _ in range(rng.integers(1, 5)):
                builder.add_box_collision(half_size=[0.1, 0.1, 0.1])
            bodies.append(builder.build_static())
        for k in rng.permutation(400)[:300]:
            played.remove_entity(bodies[k])
        del bodies, builder
        kept.append(played)
        rollout = get_engine("physx").rollout(scene, batch_programs([program], scene.names))
        points.append(rollout.contacts.point)
    assert len(points[0])
    for other in points[1:]:
        np.testing.assert_array_equal(points[0], other)
