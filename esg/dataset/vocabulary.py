"""The nouns of the scene grammar, with what may be said of them.

Ranges are what English speakers plausibly state and what the motion allows: they keep sampled
prompts physically possible, so that a failure is the pipeline's and not the prompt's.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Noun:
    """An object that prompts name.

    Args:
        name: The noun phrase, singular, without article.
        speeds_mps: Lowest and highest speed that prompts state [m/s]; none: never stated.
        masses_kg: Masses that prompts state [kg]; none: never stated.
    """

    name: str
    speeds_mps: tuple[float, float] | None = None
    masses_kg: tuple[float, ...] = ()

    @property
    def article(self) -> str:
        """a or an."""
        return "an" if self.name[0] in "aeiou" else "a"

    @property
    def phrase(self) -> str:
        """The noun with its article."""
        return f"{self.article} {self.name}"


def _nouns(names: str, *args: tuple[float, float]) -> tuple[Noun, ...]:
    return tuple(Noun(name.strip(), *args) for name in names.split(","))


VEHICLES = _nouns("car, taxi, van, truck, bus, jeep, delivery van, pickup truck", (5.0, 14.0))
STREET_TARGETS = _nouns(
    "wooden fence, brick wall, concrete barrier, lamp post, mailbox, trash can, fire hydrant, "
    "wooden crate, barrel, bench, parked car, parked motorcycle"
)
STREET_MOVABLES = _nouns("trash can, wooden crate, barrel, shopping cart, cardboard box")
STREET_ENDS = _nouns("parked car, brick wall, wooden fence, bench, mailbox, concrete barrier")

BALLS = (
    Noun("ball", (1.5, 5.0), (1.0, 2.0, 4.0, 8.0)),
    Noun("soccer ball", (2.0, 7.0)),
    Noun("basketball", (2.0, 6.0)),
    Noun("bowling ball", (2.0, 6.0), (4.0, 5.0, 6.0, 7.0)),
    Noun("rubber ball", (2.0, 5.0), (0.5, 1.0, 2.0)),
    Noun("volleyball", (2.0, 5.0)),
)
FLOOR_TARGETS = _nouns(
    "chair, desk, wooden box, cardboard box, wall, bucket, suitcase, wooden crate, sofa, bench"
)
THROWN = (
    Noun("basketball", (5.0, 9.0), (1.0, 2.0, 5.0)),
    Noun("tennis ball", (6.0, 12.0)),
    Noun("stone", (6.0, 12.0), (0.5, 1.0, 2.0)),
    Noun("soccer ball", (6.0, 12.0)),
    Noun("baseball", (8.0, 15.0)),
)
THROW_TARGETS = _nouns("wooden box, wall, chair, picnic table, desk, trash can, wooden crate")
SLIDERS = (
    Noun("wooden crate", (2.0, 5.0), (10.0, 20.0, 30.0)),
    Noun("suitcase", (2.0, 5.0), (8.0, 12.0, 16.0)),
    Noun("cardboard box", (2.0, 5.0), (2.0, 4.0, 6.0)),
    Noun("hockey puck", (3.0, 8.0)),
)
SLIDE_TARGETS = _nouns("chair, wall, sofa, bench, desk, wooden crate")
DROPPED = _nouns("basketball, tennis ball, soccer ball, stone, wooden box")
DROP_TARGETS = _nouns("wooden crate, table, desk, bench, cardboard box")
ROLL_OFF = _nouns("ball, toy car, soccer ball, tennis ball")
ROLL_OFF_SUPPORTS = _nouns("table, desk, picnic table")
TOPPLED = _nouns("tall bottle, vase, traffic cone, bottle")
TOPPLERS = (
    Noun("soccer ball", (3.0, 7.0)),
    Noun("bowling ball", (2.0, 5.0)),
    Noun("basketball", (3.0, 6.0)),
)
TABLE_ITEMS = _nouns("cup, bottle, vase, mug")
TABLE_BALLS = _nouns("ball, tennis ball, rubber ball")

BALL_COLORS = ("white", "red", "blue", "green", "yellow", "black", "orange")
VEHICLE_COLORS = ("", "red", "blue", "white", "black", "green")
POOL_BALLS = _nouns("red ball, black ball, blue ball, yellow ball")
NUMBER_WORDS = {2: "two", 3: "three", 4: "four", 5: "five", 6: "six", 8: "eight", 10: "ten"}
