"""Every meeting of the table takes place where a prompt tells it, and the docs list all of them."""

from __future__ import annotations

from pathlib import Path

import pytest

from esg.dynamics.choreography import choreograph, meetings
from esg.dynamics.choreography.meetings import MEETINGS, Meeting
from esg.dynamics.choreography.stage import Encounter, Stage
from tests.dynamics.stories import cast

PROMPTS = {
    "a drives past b": "A car overtakes a truck driving at 8 m/s and then turns right.",
    "a is let go over b, which ran into": "A car hits a tree, and a ball is dropped onto the car.",
    "a runs into the back of b, which ran into": "A red car hits a parked van, then a blue car rams "
    "the red car.",
    "both are let go": "Two balls are dropped and collide with each other.",
    "one is let go over the place": "A car drives forward at 5 m/s. A ball is dropped onto the car.",
    "who overtook before": "A motorbike overtakes a bus, cuts in front of it and brakes; the bus "
    "hits the motorbike.",
    "one runs into the back": "The red car rear-ends the blue car after the blue car brakes.",
    "one runs into the side": "A car drives along, and a truck hits its side.",
    "they run, or are thrown": "Two trams collide in a depot.",
    "a was set in motion": "Ball A hits ball B. B hits ball C.",
    "a left its support": "A pumpkin rolls off a hay bale and hits a milk can.",
    "a tips over": "A tree falls on a car.",
    "a flies on": "In the school gym a basketball hits the backboard and then falls onto a blue mat.",
    "a is thrown at the board": "A basketball bounces off the backboard and goes through the hoop.",
    "a comes down on the top": "A ball is dropped from 3 m onto a table, bounces off and lands in a "
    "basket.",
    "a hangs drawn back": "A pendulum is released and hits a box.",
    "a turns about an upright axle": "A door swings open and knocks over a vase.",
    "a slides out on its joint": "The top drawer of a dresser slides out and pushes a stool.",
    "a is let go over b": "A basketball is dropped onto a wooden crate.",
    "a comes down a chute": "A marble rolls down a chute into a tin cup.",
    "a comes down a ramp": "A ball rolls down a ramp and hits a box.",
    "a brakes": "A sled slides at 7 m/s, brakes and hits a snowman.",
    "a was pushed": "A hockey puck slides into a goal.",
    "a drives, walks": "A car hits a bin.",
}
"""A prompt for the meeting whose sentence begins so; the longest beginning counts."""


def _begins(meeting: Meeting) -> str:
    return max((k for k in PROMPTS if meeting.what.startswith(k)), key=len, default="")


@pytest.mark.parametrize("meeting", MEETINGS, ids=lambda m: m.what)
def test_what_a_prompt_tells_is_what_is_solved(
    meeting: Meeting, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[Meeting] = []
    real = meetings._take_place

    def noted(stage: Stage, e: Encounter, table: tuple[Meeting, ...]) -> Meeting:
        told.append(real(stage, e, table))
        return told[-1]

    monkeypatch.setattr(meetings, "_take_place", noted)
    choreograph(cast(PROMPTS[_begins(meeting)]))
    assert meeting in told


def test_the_page_on_dynamics_lists_every_meeting() -> None:
    page = (Path(__file__).parents[3] / "docs" / "dynamics" / "meetings.md").read_text(
        encoding="utf-8"
    )
    assert [m.what for m in MEETINGS if f"| {m.what} |" not in page] == []
