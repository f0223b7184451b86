"""The fused surrogate obeys the analytic truths and the contract of the engines."""

from __future__ import annotations

import pytest

from esg.engines import get_engine
from esg.engines.program import batch_programs
from tests.engines.lab import DT, PROGRAM, SCENE
from tests.engines.test_analytic import *  # noqa: F403  # the same truths, measured on `lab` below
from tests.engines.test_analytic import Track


@pytest.fixture(scope="module")
def lab():
    batch = batch_programs([PROGRAM], SCENE.names)
    return Track(get_engine("surrogate").rollout(SCENE, batch, dt=DT, ground_contacts=True))
