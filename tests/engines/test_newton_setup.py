"""What this package changes in Newton keeps its results: the sort of contacts on the CPU."""

from __future__ import annotations

import numpy as np
import pytest

from esg.engines.newton import clear_cache
from esg.engines.newton.setup import quiet_warp
from esg.engines.newton.sharing import sort_few_contacts
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from tests.engines.lab import ball, box


@pytest.mark.parametrize("count", [0, 1, 2, 7, 8, 9, 16, 17, 24, 31, 33, 100, 257])
@pytest.mark.parametrize("kinds", [3, 10**12])
def test_pairs_are_sorted_stably(count: int, kinds: int) -> None:
    """Sort the pairs in use by key, keep equal keys in order and leave what is not in use."""
    wp = quiet_warp()
    from esg.engines.newton.kernels import sort_pairs

    room = 300
    keys = np.full(2 * room, 2**63 - 1, np.int64)
    keys[:count] = np.random.default_rng(count).integers(0, kinds, count)
    values = np.zeros(2 * room, np.int32)
    values[:room] = np.arange(room)
    sorted_keys, sorted_values = wp.array(keys, dtype=wp.int64), wp.array(values, dtype=int)
    wp.launch(
        sort_pairs,
        dim=1,
        inputs=[wp.array([count], dtype=int), room, sorted_keys, sorted_values],
        device="cpu",
    )
    order = np.argsort(keys[:room], kind="stable")
    assert np.array_equal(sorted_values.numpy()[:room], order)
    assert np.array_equal(sorted_keys.numpy()[:room], keys[order])


def test_rollouts_are_those_of_the_usual_sort() -> None:
    """Play a ball into a stack with either sort: every number is the same."""
    from newton._src.solvers.steel.friction_patches import _FrictionPatchState

    bodies = (
        box("low", (0.1, 0.1, 0.1), 1.0, (0, 0, 0.1)),
        box("high", (0.1, 0.1, 0.1), 1.0, (0, 0, 0.3)),
        ball("ball", 0.1, 2.0, (-1.0, 0.02, 0.1)),
        box("beside", (0.3, 0.1, 0.1), 1.0, (0, 0.8, 0.1)),
    )
    scene = SimScene("stack", bodies)
    programs = [Program((SetVelocity("ball", 0.0, (v, 0.1, 0.0)),), 0.6) for v in (3.0, 5.0)]
    batch = batch_programs(programs, scene.names)

    def played() -> tuple[np.ndarray, ...]:
        clear_cache()
        rollout = get_engine("newton").rollout(scene, batch)
        log = rollout.contacts
        return rollout.position, rollout.quaternion, log.impulse, log.point

    sort_few_contacts()
    ours, few = _FrictionPatchState.build, played()
    assert ours.__wrapped__ is not ours
    _FrictionPatchState.build = ours.__wrapped__
    try:
        usual = played()
    finally:
        _FrictionPatchState.build = ours
        clear_cache()
    assert len(few[2]) > 20
    assert all(np.array_equal(a, b) for a, b in zip(few, usual, strict=True))
