"""What shines, burns, falls from the sky and sways: stated, and the rest owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, Statement
from esg.lexicon.shown import lights, swaying, weathers


def said(doc: EsgDocument, *kinds: str) -> list[Statement]:
    return [s for s in doc.statements or () if s.predicate.value in kinds]


@pytest.mark.parametrize(
    ("prompt", "noun", "about"),
    [
        ("A car with its headlights on drives through a tunnel.", "headlights on", "car_1"),
        ("An ambulance with flashing lights passes.", "beacon flashing", "ambulance_1"),
        ("A police car with flashing blue lights stops.", "beacon flashing blue", "police_car_1"),
        ("A car stops and its headlights go out.", "headlights turned off", "car_1"),
        ("The car's headlights are on.", "headlights on", "car_1"),
        ("A candle burns on a table.", "flame on", "candle_1"),
        ("A small burning stick is thrown at a wall.", "flame on", "stick_1"),
        ("A house is on fire.", "flame on", "house_1"),
        ("A traffic light turns red and the car stops.", "traffic light turned on red",
         "traffic_light_1"),
        ("When the light turns green, the car moves off.", "traffic light turned on green",
         "signal_1"),
        ("A man turns the lamp off and walks away.", "lamp turned off", "lamp_1"),
        ("A person is turning on the television.", "screen turned on", "television_1"),
        ("Toggle the button to turn off the led.", "lamp turned off", "lamp_1"),
        ("A street lamp flickers.", "lamp flashing", "street_lamp_1"),
    ],
)  # fmt: skip
def test_lights_are_stated(prompt: str, noun: str, about: str) -> None:
    """State which light of what shines, and how."""
    (found,) = said(draft(prompt), "lit")
    assert (found.noun, found.object) == (noun, (about,))


def test_who_turns_it_on_is_owned_up_to() -> None:
    """Hold that the lamp goes on, and say that no hand does it."""
    doc = draft("A person is turning on the desk lamp.")
    (lost,) = said(doc, "not_represented")
    assert (lost.text, lost.note) == (
        "is turning on", "it changes by itself: nobody's hand does it",
    )  # fmt: skip
    assert [r.relation_type.value for r in doc.spatial_relation_graph.edges.binary_relations
            if {r.from_, r.to} == {"person_1", "desk_lamp_1"}] == ["near"]  # fmt: skip


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball hits a lamp and the lamp goes out.",
        "The lamp turns off when a ball hits it.",
    ],
)
def test_lights_change_at_events(prompt: str) -> None:
    """Let a lamp go out when it is hit, whichever is told first."""
    (found,) = said(draft(prompt), "lit")
    assert (found.noun, found.when) == ("lamp turned off", "ball_1_lamp_1_collision")


@pytest.mark.parametrize(
    ("prompt", "nouns"),
    [
        ("A man walks in the rain.", ["rain"]),
        ("It is snowing and a car drives down a road.", ["snow"]),
        ("A dog runs through the heavy rain.", ["heavy rain"]),
        ("A car drives down a road on a foggy night.", ["fog"]),
        ("In heavy rain and fog, a car stops.", ["heavy rain", "fog"]),
        ("Snow is falling on a quiet street and a bus drives past.", ["snow"]),
        ("A ball bounces in the snow.", []),
        ("A knight stands against a stormy sky.", []),
    ],
)
def test_weather_is_stated(prompt: str, nouns: list[str]) -> None:
    """State what falls or hangs in the air, and not what lies on the ground."""
    assert [s.noun for s in said(draft(prompt), "weather")] == nouns


def test_no_weather_indoors() -> None:
    """Own up to weather in a room."""
    doc = draft("In a kitchen a ball rolls off a table in the rain.")
    assert not said(doc, "weather")
    assert "no weather is shown indoors" in {s.note for s in said(doc, "not_represented")}


@pytest.mark.parametrize(
    ("prompt", "count"),
    [
        ("Yellow flowers swing in the wind", 3),
        ("A flag waves in the wind.", 1),
        ("The trees sway in a strong wind.", 3),
        ("Macro shot on branches blowing in the wind.", 3),
        ("A kite flies in the wind.", 0),
        ("A person waves a flag.", 0),
    ],
)
def test_what_sways_is_stated_and_moves_nowhere(prompt: str, count: int) -> None:
    """State what sways; no motion is made of it."""
    doc = draft(prompt)
    found = said(doc, "sways")
    assert sum(len(s.object) for s in found) == count
    if count:
        assert doc.timeline_system is None


@pytest.mark.parametrize(
    "prompt",
    [
        "A truck with its hazard lights flashing stops at the kerb.",
        "The Christmas lights flicker on a tree.",
        "A beam of light falls on a ball.",
        "A boy turns on the faucet.",
        "A car drives through a burning hoop.",
    ],
)
def test_what_is_not_drawn_stays_owned_up_to(prompt: str) -> None:
    """Drop nothing silently of what no table knows."""
    doc = draft(prompt)
    assert not said(doc, "lit", "weather", "sways")
    assert said(doc, "not_represented")


@pytest.mark.parametrize("prompt", ["A light ball rolls.", "A ball rolls to a light blue box."])
def test_light_weights_and_colours_are_no_lamps(prompt: str) -> None:
    """Leave "light" alone where it is no light."""
    assert not said(draft(prompt), "lit")


def test_tables_name_sources_and_known_kinds() -> None:
    """Keep rows that can be drawn: every light has parts or flames, all that falls has a speed."""
    assert all(row.flame != bool(row.parts) for row in lights().values())
    assert {row.name for row in weathers().values() if not row.falls_mps} == {"fog"}
    assert {row.how for row in swaying().values()} == {"bends", "waves"}
