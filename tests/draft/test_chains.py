"""Chains of events: who falls, follows, passes, is carried along, and what pronouns take up."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument

_POINTS = {"Collision", "EnterRegion", "Fall", "Topple", "Stop", "Reach", "Miss"}


def told(doc: EsgDocument) -> list[str]:
    """Point events in order, scaffolding left out."""
    assert doc.timeline_system is not None
    nodes = doc.timeline_system.sequence_graph.nodes
    return [f"{n.event.value} {' '.join(n.participants)}" for n in nodes if n.event in _POINTS]


@pytest.mark.parametrize(
    ("prompt", "events"),
    [
        # what lies between a subject and its verb
        (
            "A ball hits the fence and the dog, unable to stop, also hits the fence.",
            ["Collision ball_1 fence_1", "Collision dog_1 fence_1"],
        ),
        # falls over where it stands
        (
            "A broom leaning on a wall is bumped by a boy and falls onto a bucket.",
            ["Collision boy_1 broom_1", "Topple broom_1", "Collision broom_1 bucket_1"],
        ),
        (
            "A van knocks over a bicycle. The bicycle falls against a second bicycle, which falls too.",
            [
                "Collision van_1 bicycle_1",
                "Topple bicycle_1",
                "Collision bicycle_1 second_bicycle_1",
                "Topple second_bicycle_1",
            ],
        ),
        # the other one is not the subject of the clause before; parts belong to what is there
        (
            "A truck hits a traffic cone, the cone hits another cone, and the other cone hits a wall.",
            [
                "Collision truck_1 traffic_cone_1",
                "Collision traffic_cone_1 traffic_cone_2",
                "Collision traffic_cone_2 wall_1",
            ],
        ),
        # one of many: bounded counts, and a plural whose member is named afterwards
        (
            "A bowling ball strikes ten pins and at least one of them falls.",
            ["Collision bowling_ball_1 pin_1", "Topple pin_1"],
        ),
        (
            "A ball hits six bottles. No fewer than three bottles topple.",
            ["Collision ball_1 bottle_1", "Topple bottle_1"],
        ),
        (
            "A truck hits three barrels and sends the red barrel into a wall.",
            ["Collision truck_1 red_barrel_1", "Collision red_barrel_1 wall_1"],
        ),
        (
            "A dog runs into a row of four bins and pushes the first bin into the second.",
            ["Collision dog_1 first_bin_1", "Collision first_bin_1 second_bin_1"],
        ),
        # a ball bounces into a vessel, off what it was thrown at; into a box it may bump
        ("A ping pong ball bounces into a cup.", ["EnterRegion ping_pong_ball_1"]),
        (
            "A ball is thrown at a door and bounces into a bucket.",
            ["Collision ball_1 door_1", "EnterRegion ball_1"],
        ),
        ("A tennis ball bounces into a box.", ["Collision tennis_ball_1 box_1"]),
        # leaves its support once
        (
            "A tile slides from the roof, just missing a woman, and smashes on the pavement.",
            ["Fall tile_1", "Miss tile_1 woman_1"],
        ),
        (
            "A mug slides along the bar and falls off the end into a bucket.",
            ["Fall mug_1", "EnterRegion mug_1"],
        ),
        # the thing itself, not what it is aimed at or stands by
        (
            "The first truck stops at the barrier, the second truck fails to brake and rams it.",
            ["Stop first_truck_1", "Collision second_truck_1 first_truck_1"],
        ),
        (
            "A snowball hits a window, then a second snowball is thrown and misses.",
            ["Collision snowball_1 window_1", "Miss second_snowball_1 window_1"],
        ),
        (
            "One log rolls into a hut, and another hits a box.",
            ["Collision log_1 hut_1", "Collision second_log_1 box_1"],
        ),
        ("Two trains pass each other.", ["Miss train_1 train_2"]),
        ("A shelf shakes as a truck passes.", ["Miss truck_1 shelf_1"]),
        # verbs whose sense depends on their arguments
        (
            "A rock breaks off the cliff and hits a car.",
            ["Fall rock_1", "Collision rock_1 car_1"],
        ),
        ("The elevator doors shut on a suitcase.", ["Collision door_1 suitcase_1"]),
        (
            "A man steps on a rake and falls.",
            ["Collision man_1 rake_1", "Topple man_1"],
        ),
        ("A coin is flipped and lands on the table.", ["Collision coin_1 table_1"]),
        ("A car hits a patch of ice and slides into a bus.", ["Collision car_1 bus_1"]),
        (
            "A tractor drags the carriage into a fountain.",
            ["Collision carriage_1 fountain_1"],
        ),
        (
            "A runner stumbles and falls just before reaching the gate.",
            ["Topple runner_1"],
        ),
        # what a pronoun takes up
        (
            "Two dominoes stand there. A marble rolls into the first one, it falls and pushes the "
            "second one over.",
            [
                "Collision marble_1 first_domino_1",
                "Topple first_domino_1",
                "Collision first_domino_1 second_domino_1",
                "Topple second_domino_1",
            ],
        ),
        (
            "A robot arm picks up a block, moves it over a box and drops it into the box.",
            ["EnterRegion block_1"],
        ),
        (
            "A cyclist brakes hard, and another cyclist behind him runs into him.",
            ["Collision rear_cyclist_1 cyclist_1"],
        ),
        (
            "A ball rolls down the stairs, and a man steps on it and falls.",
            ["Collision man_1 ball_1", "Topple man_1"],
        ),
        (
            "A squash ball hits the front wall, then the side wall, and finally the player.",
            [
                "Collision squash_ball_1 front_wall_1",
                "Collision squash_ball_1 wall_1",
                "Collision squash_ball_1 player_1",
            ],
        ),
        # who goes on
        (
            "A bus stops to let a woman cross, then drives on and stops at a kiosk.",
            ["Stop bus_1", "Stop bus_1"],
        ),
        (
            "An arrow is shot at a target and hits the tree behind it.",
            ["Collision arrow_1 rear_tree_1"],
        ),
        (
            "A cart rolls backward down a slope until a wall stops it.",
            ["Collision cart_1 wall_1", "Stop cart_1"],
        ),
        (
            "A stone hits a window and falls to the ground.",
            ["Collision stone_1 window_1", "Fall stone_1"],
        ),
        (
            "A ball hits a hurdle with its rim and rolls into a box.",
            ["Collision ball_1 hurdle_1", "Collision ball_1 box_1"],
        ),
    ],
)
def test_chain(prompt: str, events: list[str]) -> None:
    """Tell every event once, between the right things, and no other."""
    doc = draft(prompt)
    assert verify(doc) == ()
    assert told(doc) == events
