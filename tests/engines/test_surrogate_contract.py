"""The fused surrogate keeps the contract of the engines: repeats, batches, divergence, programs."""

from __future__ import annotations

import numpy as np
import pytest

from esg.engines import get_engine
from esg.engines.scene import Variation
from tests.engines import test_contract, test_program
from tests.engines.test_contract import (  # noqa: F401  # the same tests, run with `engine` below
    test_a_world_does_not_depend_on_its_batch,
    test_diverging_worlds_are_flagged_and_leave_the_others_alone,
    test_flat_convex_shapes_are_named,
    test_frames_accumulate_contacts,
    test_impossible_input_is_named,
    test_repeats_are_bit_identical_whatever_ran_in_between,
    test_restitution_offset_is_clipped_and_static_bodies_may_move_between_worlds,
    test_threads_may_share_an_engine,
    test_variations_act_per_world,
    test_wheeled_and_normal_bodies_collide,
    test_wheeled_bodies_touch_only_the_vehicle_ground,
)
from tests.engines.test_program import random_batch  # noqa: F401  # a fixture


@pytest.fixture(scope="module")
def engine():
    return get_engine("surrogate")


def test_random_programs_match_the_reference_executor(engine, random_batch):  # noqa: F811
    factor = np.array([[1.0, 2.0, 0.5]] * 5)
    rollout = engine.rollout(
        test_program.SCENE, random_batch, dt=test_program.DT, variation=Variation(mass_scale=factor)
    )
    for w in range(5):
        masses = [b.mass * k for b, k in zip(test_program.SCENE.bodies, factor[w], strict=True)]
        v, omega = test_program.reference(random_batch, w, masses, len(rollout.time) - 1)
        np.testing.assert_allclose(rollout.linear_velocity[w], v, atol=2e-5)
        np.testing.assert_allclose(rollout.angular_velocity[w], omega, atol=2e-4)


def test_threads_do_not_change_results(monkeypatch):
    results, batch = [], test_contract.batch([1.0, 2.0, 3.0, 4.0, 5.0])
    for threads in ("1", "3"):
        monkeypatch.setenv("ESG_THREADS", threads)
        results.append(get_engine("surrogate").rollout(test_contract.SCENE, batch))
    one, three = results
    assert len(one.contacts.impulse)
    assert one.position.tobytes() == three.position.tobytes()
    assert one.contacts.impulse.tobytes() == three.contacts.impulse.tobytes()
