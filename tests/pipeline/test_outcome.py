"""What the judge stage makes of the optimizer's claim."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from esg.draft import draft
from esg.outcomes import Outcome
from esg.stages import _outcome


def verdict(*events: Any) -> Any:
    return SimpleNamespace(events=events, slr=True, layout=None)


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A ball hits a box.", Outcome.SOLVED),
        ("A lamp stands on a desk.", Outcome.SOLVED),
        ("A wizard enchants a frog.", Outcome.NOT_CONVERGED),
    ],
)
def test_a_scene_without_the_events_of_its_prompt_is_not_solved(
    prompt: str, expected: Outcome
) -> None:
    outcome, reason = _outcome(draft(prompt), verdict())
    assert outcome is expected
    assert ("enchants" in reason) == (expected is not Outcome.SOLVED)


def test_a_replay_that_disagrees_overrules_the_claim() -> None:
    missed = SimpleNamespace(id="e1", type="collision", reason="never touch", completed=False)
    outcome, reason = _outcome(draft("A ball hits a box."), verdict(missed))
    assert outcome is Outcome.NOT_CONVERGED
    assert reason == "the replay disagrees: e1 (collision): never touch"
