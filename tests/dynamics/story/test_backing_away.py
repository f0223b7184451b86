"""What came forward goes tail first from the start of its last motion on, and only from there."""

from __future__ import annotations

import pytest

from esg.dynamics.story.story import read_story, turns_back
from tests.dynamics.stories import cast


@pytest.mark.parametrize(
    ("prompt", "turned"),
    [
        ("A car drives up to a gate, stops and reverses.", [False, False, True]),
        ("A car drives up to a gate, stops and drives on.", [False, False, False]),
        ("A car reverses and stops.", [False, False]),
    ],
)
def test_the_heading_turns_where_it_backs_away(prompt: str, turned: list[bool]) -> None:
    """Neither braking nor going on turns it round, nor does a first motion that is tail first."""
    story = read_story(cast(prompt))
    phases = next(iter(story.phases.values()))
    assert [turns_back(story, p, lambda _: False) for p in phases] == turned
