"""The rules of the scene grammar: kinds of scenes, their slots and weights (docs/dataset.md).

What a rule's filled slots say and mean is in esg.dataset.sentences.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from esg.dataset import sentences as say
from esg.dataset import vocabulary as words
from esg.dataset.sentences import Rendered
from esg.dataset.slots import (
    Slot,
    Values,
    adjective_slot,
    choice_slot,
    count_slot,
    mass_slot,
    mover_slot,
    noun_slot,
    speed_slot,
    time_slot,
)
from esg.dataset.vocabulary import Noun


@dataclass(frozen=True)
class Rule:
    """One kind of scene.

    Args:
        name: Stable; part of scene ids.
        level: single, chain or multi_phase.
        slots: In the order they are drawn.
        render: Sentence and meaning of filled slots.
        movers: Nouns of the slot `mover`.
        where: What the rule needs of a place that the sentence may name (`data/settings.csv`):
            vehicles, floor, table or indoors; street and hall have theirs.
        weight: Within the level.
    """

    name: str
    level: str
    slots: tuple[Slot, ...]
    render: Callable[[Values], Rendered]
    movers: tuple[Noun, ...]
    where: str
    weight: float = 1.0


_HIT_VERBS = ("hits", "crashes into", "runs into", "collides with")
_CHAIN_WORDINGS = (
    "{head} {middle}, knocking it into {target}.",
    "{head} {middle}, which then hits {target}.",
    "{head} {middle} and the {it} then crashes into {target}.",
)
_OVER_WORDINGS = (
    "{mover} rolls into {target}{speed} and knocks it over.",
    "{mover} hits {target}{speed} and the {it} topples.",
)
_LIGHT = ("cardboard box", "wooden box", "bucket", "suitcase")
"""Floor targets that a bowling ball pushes along."""
_COLOR = choice_slot("color", *words.VEHICLE_COLORS)

RULES: tuple[Rule, ...] = (
    Rule(
        "drive_into", "single",
        (mover_slot(words.VEHICLES), noun_slot("target", words.STREET_TARGETS), _COLOR,
         choice_slot("verb", *_HIT_VERBS), speed_slot(), time_slot(1.0, 3.0)),
        say.drive_into, words.VEHICLES, "vehicles", 3.0,
    ),
    Rule(
        "roll_into", "single",
        (mover_slot(words.BALLS), noun_slot("target", words.FLOOR_TARGETS),
         choice_slot("verb", "rolls into", "runs into", "bumps into"), mass_slot(), speed_slot(),
         time_slot(1.0, 2.0)),
        say.roll_into, words.BALLS, "floor", 3.0,
    ),
    Rule(
        "throw_at", "single",
        (mover_slot(words.THROWN), noun_slot("target", words.THROW_TARGETS), mass_slot(),
         time_slot(0.6, 1.0)),
        say.throw_at, words.THROWN, "floor", 1.5,
    ),
    Rule(
        "slide_into", "single",
        (mover_slot(words.SLIDERS), noun_slot("target", words.SLIDE_TARGETS),
         choice_slot("verb", "hits", "bumps into"), mass_slot(), speed_slot()),
        say.slide_into, words.SLIDERS, "indoors", 1.5,
    ),
    Rule(
        "drop_onto", "single",
        (mover_slot(words.DROPPED), noun_slot("target", words.DROP_TARGETS),
         choice_slot("verb", "is dropped onto", "falls onto")),
        say.drop_onto, words.DROPPED, "table",
    ),
    Rule(
        "bowl", "single",
        (mover_slot(tuple(n for n in words.BALLS if n.name == "bowling ball")),
         count_slot(3, 4, 5, 6, 10), mass_slot(), speed_slot(optional=False)),
        say.bowl, tuple(n for n in words.BALLS if n.name == "bowling ball"), "hall", 0.7,
    ),
    Rule(
        "drive", "single",
        (mover_slot(words.VEHICLES), _COLOR, choice_slot("verb", "drives", "moves"),
         choice_slot("place", "down the street", "along the road"), speed_slot(optional=False)),
        say.drive, words.VEHICLES, "street", 0.7,
    ),
    Rule(
        "roll_off", "single",
        (mover_slot(words.ROLL_OFF), noun_slot("target", words.ROLL_OFF_SUPPORTS)),
        say.roll_off, words.ROLL_OFF, "table", 0.6,
    ),
    Rule(
        "head_on", "single",
        (mover_slot(words.VEHICLES), choice_slot("verb", "drive", "move"),
         speed_slot(optional=False),
         time_slot(1.0, 2.0)),
        say.head_on, words.VEHICLES, "vehicles", 0.7,
    ),
    Rule(
        "street_chain", "chain",
        (mover_slot(words.VEHICLES), noun_slot("middle", words.STREET_MOVABLES),
         noun_slot("target", words.STREET_ENDS), choice_slot("wording", *_CHAIN_WORDINGS),
         speed_slot()),
        say.street_chain, words.VEHICLES, "vehicles", 3.0,
    ),
    Rule(
        "floor_chain", "chain",
        (mover_slot(words.TOPPLERS[1:2]),
         noun_slot("middle", tuple(n for n in words.FLOOR_TARGETS if n.name in _LIGHT)),
         noun_slot("target", tuple(n for n in words.FLOOR_TARGETS if n.name not in _LIGHT)),
         choice_slot("wording", *_CHAIN_WORDINGS), speed_slot()),
        say.floor_chain, words.TOPPLERS[1:2], "floor",
    ),
    Rule(
        "ball_chain", "chain",
        (mover_slot(words.BALLS[:1]), count_slot(3, 3, 4), choice_slot("named", "letters",
         "colors"),
         choice_slot("first_color", *range(7)), speed_slot()),
        say.ball_chain, words.BALLS[:1], "floor", 2.0,
    ),
    Rule(
        "knock_off", "chain",
        (mover_slot(words.TABLE_BALLS), noun_slot("item", words.TABLE_ITEMS),
         noun_slot("target", words.ROLL_OFF_SUPPORTS)),
        say.knock_off, words.TABLE_BALLS, "table",
    ),
    Rule(
        "knock_over", "chain",
        (mover_slot(words.TOPPLERS), noun_slot("target", words.TOPPLED),
         choice_slot("wording", *_OVER_WORDINGS), speed_slot()),
        say.knock_over, words.TOPPLERS, "floor", 2.0,
    ),
    Rule(
        "pocket", "chain",
        (mover_slot((Noun("cue ball"),)), adjective_slot("target", words.POOL_BALLS),
         choice_slot("verb", "strikes", "hits"),
         choice_slot("pocket", "a corner pocket", "the bottom pocket", "the corner pocket")),
        say.pocket, (Noun("cue ball"),), "hall", 1.0,
    ),
    Rule(
        "brake_to_stop", "multi_phase",
        (mover_slot(words.VEHICLES), _COLOR, speed_slot(optional=False),
         time_slot(2.5, 4.0, optional=False)),  # tyres brake with 7 m/s² at most
        say.brake_to_stop, words.VEHICLES, "street", 2.0,
    ),
    Rule(
        "turn_and_hit", "multi_phase",
        (mover_slot(words.VEHICLES), noun_slot("target", words.STREET_TARGETS),
         choice_slot("side", "left", "right"), speed_slot()),
        say.turn_and_hit, words.VEHICLES, "street",
    ),
    Rule(
        "rear_end", "multi_phase",
        (mover_slot(words.VEHICLES), speed_slot(optional=False), time_slot(1.0, 2.0,
         optional=False)),
        say.rear_end, words.VEHICLES, "street",
    ),
    Rule(
        "brake_and_hit", "multi_phase",
        (mover_slot(words.VEHICLES), noun_slot("target", words.STREET_TARGETS), _COLOR,
         speed_slot()),
        say.brake_and_hit, words.VEHICLES, "street",
    ),
)  # fmt: skip
"""All rules."""
