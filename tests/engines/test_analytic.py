"""Analytic truths, in every engine at 240 Hz."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.engines import ENGINES, get_engine
from esg.engines.program import batch_programs
from esg.units import quat_rotate, yaw_from_quat
from tests.engines.lab import DT, PROGRAM, SCENE, TURN_RATE, G


class Track:
    """States and contacts of one rollout, looked up by body name."""

    def __init__(self, rollout):
        self.rollout = rollout
        self.time = rollout.time

    def __getattr__(self, field):
        def look(name, step=slice(None)):
            return getattr(self.rollout, field)[0, step, SCENE.index(name)].astype(float)

        return look

    def hits(self, a, b):
        i, j = sorted((SCENE.index(a), SCENE.index(b)))
        log = self.rollout.contacts
        return np.nonzero((log.a == i) & (log.b == j))[0]


@pytest.fixture(scope="module", params=ENGINES)
def lab(request):
    batch = batch_programs([PROGRAM], SCENE.names)
    return Track(get_engine(request.param).rollout(SCENE, batch, dt=DT, ground_contacts=True))


def step(seconds):
    return round(seconds / DT)


def test_frames_cover_the_duration_from_the_initial_state(lab):
    assert lab.time[0] == 0.0
    assert lab.time[-1] == pytest.approx(2.0)
    for body in SCENE.bodies:
        assert lab.position(body.name, 0) == pytest.approx(body.position, abs=1e-6)
    assert lab.rollout.valid.tolist() == [True]


def between(value, exact, one_step, tolerance=2e-3):
    """Engines that split a step lie between the exact parabola and that of one step of Euler."""
    low, high = sorted((exact, one_step))
    return low - tolerance <= value <= high + tolerance


def test_free_fall_takes_the_ballistic_time(lab):
    t = step(0.75) * DT
    drop = 9.0 - lab.position("drop", step(t))[2]
    assert lab.linear_velocity("drop", step(t))[2] == pytest.approx(-G * t, rel=1e-4)
    assert between(drop, 0.5 * G * t**2, 0.5 * G * t * (t + DT))


def test_throw_follows_the_parabola_and_keeps_its_spin(lab):
    n0, n = step(0.5), step(1.5)
    start, end, t = lab.position("throw", n0), lab.position("throw", n), (n - n0) * DT
    assert end[0] - start[0] == pytest.approx(3.0 * t, rel=1e-4)
    assert between(end[2] - start[2], 4.0 * t - 0.5 * G * t**2, 4.0 * t - 0.5 * G * t * (t + DT))
    assert lab.angular_velocity("throw", n) == pytest.approx([0, 0, 2.0], abs=0.02)


@pytest.mark.parametrize(
    ("pair", "masses", "e"),
    [("elastic", (1.0, 2.0), 1.0), ("half", (1.0, 3.0), 0.5), ("dead", (1.0, 1.0), 0.0)],
)
def test_head_on_impact_obeys_newtons_law_with_the_average_restitution(lab, pair, masses, e):
    m1, m2 = masses
    v = (
        lab.linear_velocity(f"{pair} 1", step(1.0))[0],
        lab.linear_velocity(f"{pair} 2", step(1.0))[0],
    )
    common = m1 * 2.0 / (m1 + m2)
    expected = common - m2 / (m1 + m2) * e * 2.0, common + m1 / (m1 + m2) * e * 2.0
    assert v == pytest.approx(expected, abs=0.02)
    rows = lab.hits(f"{pair} 1", f"{pair} 2")
    log = lab.rollout.contacts
    assert log.impulse[rows].sum() == pytest.approx(m2 * expected[1], rel=0.02)
    # Surfaces are 0.3 m apart at 2 m/s; speculative contacts may come up to 2 cm early.
    assert log.time[rows[0]] == pytest.approx(0.15, abs=0.02 / 2.0 + DT)
    assert log.normal[rows[0]] == pytest.approx([-1.0, 0.0, 0.0], abs=0.01)
    assert log.point[rows[0], 0] == pytest.approx(0.4, abs=0.03)
    assert (log.depth[rows] >= 0.0).all() and log.depth[rows].max() < 0.01


def test_sliding_box_stops_after_v2_over_2_mu_g(lab):
    expected = 3.0**2 / (2.0 * 0.5 * G)
    assert lab.position("slide", -1)[0] == pytest.approx(expected, rel=0.015)
    assert np.abs(lab.linear_velocity("slide", -1)).max() < 1e-3


def test_damping_multiplies_by_one_minus_c_dt_every_step(lab):
    n = step(1.0)
    assert lab.linear_velocity("damped", n)[0] == pytest.approx(2.0 * (1 - 0.5 * DT) ** n, rel=1e-3)
    assert lab.angular_velocity("damped", n)[2] == pytest.approx(
        3.0 * (1 - 0.8 * DT) ** n, rel=1e-3
    )


def test_hold_ends_at_its_contact_and_never_resumes(lab):
    rows = lab.hits("bowl", "wall")
    t = lab.rollout.contacts.time[rows[0]]
    assert t == pytest.approx(0.25 + (1.5 - 0.1) / 2.0, abs=0.02 / 2.0 + DT)
    before, after = step(t) - 2, step(t) + 2
    assert lab.linear_velocity("bowl", before)[0] == pytest.approx(2.0, abs=1e-3)
    assert lab.angular_velocity("bowl", before) == pytest.approx([0, 20.0, 0], abs=0.3)
    assert np.abs(lab.linear_velocity("bowl", slice(after, None))[:, 0]).max() < 0.4
    assert lab.position("bowl", step(0.25))[0] == pytest.approx(0.0, abs=1e-3)


def test_hold_with_turn_rate_drives_a_circle(lab):
    heading = yaw_from_quat(lab.quaternion("turner"))
    t = lab.time[-1]
    assert heading[-1] == pytest.approx(TURN_RATE * t, abs=0.02)
    radius = 4.0 / TURN_RATE
    expected = radius * np.array([math.sin(TURN_RATE * t), 1.0 - math.cos(TURN_RATE * t)])
    assert lab.position("turner", -1)[:2] - [0.0, 40.0] == pytest.approx(expected, abs=0.05)


def test_rolling_ball_keeps_rolling(lab):
    n = step(1.4)
    assert lab.linear_velocity("roller", n) == pytest.approx([-2.0, 0, 0], abs=0.02)
    assert lab.angular_velocity("roller", n) == pytest.approx([0, -2.0 / 0.15, 0], abs=0.15)
    assert lab.position("roller", n)[0] == pytest.approx(-2.0 * n * DT, abs=0.02)


def test_damping_set_during_the_run_slows_the_rolling_ball(lab):
    # A rolling ball shares its loss of momentum between translation and spin: c 5/7.
    t = 0.5
    expected = -2.0 * math.exp(-2.0 * 5.0 / 7.0 * t)
    assert lab.linear_velocity("roller", -1)[0] == pytest.approx(expected, rel=0.03)


def test_wheeled_body_coasts_on_the_vehicle_ground(lab):
    assert lab.linear_velocity("coaster", -1) == pytest.approx([-5.0, 0, 0], abs=0.01)
    assert lab.position("coaster", -1)[2] == pytest.approx(0.4, abs=2e-3)


def test_friction_set_during_the_run_brakes_at_the_average(lab):
    n0, n1 = step(0.5), step(1.0)
    assert lab.linear_velocity("braker", n0)[0] == pytest.approx(5.0, abs=0.01)
    # Friction 1 of the body and 0 of the vehicle ground give 0.5.
    lost = 5.0 - lab.linear_velocity("braker", n1)[0]
    assert lost == pytest.approx(0.5 * G * (n1 - n0) * DT, rel=0.03)


def test_impulse_changes_velocity_by_its_share_of_the_mass(lab):
    assert lab.linear_velocity("kicked", step(0.5))[:2] == pytest.approx([0, 0], abs=1e-6)
    assert lab.linear_velocity("kicked", step(0.9))[:2] == pytest.approx([1.0, 2.0], abs=1e-4)


def test_impulse_and_velocity_fire_in_list_order(lab):
    # At 1 s the impulse comes first, and the velocity set after it replaces its effect.
    n = step(1.0)
    assert lab.linear_velocity("kicked", n + 1)[:2] == pytest.approx([1.0, 0.0], abs=1e-4)


def test_hold_accelerates_up_to_its_limit_and_then_lets_go(lab):
    for t in (0.6, 0.8, 0.95):
        n = step(t)
        s = (n - 1) * DT - 0.5
        assert lab.linear_velocity("racer", n)[0] == pytest.approx(1.0 + 3.0 * s, abs=2e-3)
    assert lab.linear_velocity("racer", step(1.4))[0] == pytest.approx(2.5, abs=1e-3)
    assert lab.linear_velocity("racer", step(0.45))[0] == pytest.approx(0.0, abs=1e-4)


def test_ball_falls_through_the_hole_of_a_static_compound(lab):
    assert lab.position("pocketed", -1) == pytest.approx([0.0, 60.0, 0.1], abs=0.03)
    assert lab.position("shelved", -1)[2] == pytest.approx(0.6, abs=0.01)
    assert lab.position("pit", -1) == pytest.approx([0.0, 60.0, 0.25], abs=1e-6)


def test_bodies_without_shapes_stay_where_they_are(lab):
    assert np.ptp(lab.position("decal"), axis=0) == pytest.approx([0, 0, 0], abs=0.0)


def test_inertia_with_tilted_axes_spins_like_the_same_body_in_its_own_axes(lab):
    # The tilted frame spins about a principal axis: no wobble, and the long axis stays upright.
    omega = lab.angular_velocity("spinner")[1:]
    assert np.abs(omega[:, :2]).max() < 0.02
    assert omega[-1, 2] == pytest.approx(5.0, rel=2e-3)
    q0, q1 = lab.quaternion("spinner", 0), lab.quaternion("spinner", -1)
    up = quat_rotate(q1, quat_rotate(q0 * [-1, -1, -1, 1], [0.0, 0.0, 1.0]))
    assert up[2] == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize(
    ("name", "height"), [("capsule", 0.3), ("cylinder", 0.3), ("convex", 0.15)]
)
def test_shapes_rest_at_their_height(lab, name, height):
    assert lab.position(name, step(1.0))[2] == pytest.approx(height, abs=2e-3)


def test_bounce_height_is_e_squared(lab):
    z = lab.position("bouncer")[:, 2] - 0.1
    landed = np.argmax(z < 0.05)
    # Restitution 0.8 on 0.4 gives 0.6.
    assert z[landed:].max() == pytest.approx(2.0 * 0.6**2, rel=0.06)


def test_ground_contacts_carry_the_weight(lab):
    log = lab.rollout.contacts
    i = SCENE.index("cylinder")
    rows = (log.a == i) & (log.b == -1) & (log.time > 1.0)
    assert log.impulse[rows].sum() == pytest.approx(1.0 * G * 1.0, rel=0.03)
    assert log.normal[rows][:, 2] == pytest.approx(np.ones(rows.sum()), abs=1e-3)


def test_log_is_sorted_and_positive(lab):
    log = lab.rollout.contacts
    keys = list(zip(log.world, log.frame, log.a, log.b, strict=True))
    assert keys == sorted(keys) and len(set(keys)) == len(keys)
    assert (log.impulse > 0.0).all()
    assert ((log.a < log.b) | (log.b == -1)).all()
    assert np.linalg.norm(log.normal, axis=1) == pytest.approx(np.ones(len(log.a)), abs=1e-4)
