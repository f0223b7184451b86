"""What a noun names among the things around it: a net that is a goal, a bar that is a counter."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.slopes import ASLANT
from esg.draft.text.elements import Mention

_AT_A_BAR = lex.word_set("at a bar")
_FRICTION = frozenset({"frictionless", "rough", "smooth", "slippery"})
_ROOMS = lex.word_set("rooms")
_BALLS = {
    "golfer": "golf ball", "batter": "baseball", "pitcher": "baseball", "batsman": "cricket ball",
    "goalkeeper": "soccer ball", "goalie": "soccer ball", "striker": "soccer ball",
    "footballer": "soccer ball", "tennis player": "tennis ball", "bowling alley": "bowling ball",
}  # fmt: skip
"""The ball of who plays with it."""


def noun_here(
    m: Mention,
    noun: lex.Noun,
    named: list[Entity],
    movers: list[Entity],
    *,
    net_sport: bool,
    cricket: bool,
) -> lex.Noun:
    """The noun of a new object, by its preposition and by what was named before it.

    Args:
        m: The noun phrase.
        noun: What it names anywhere else.
        named: The objects so far.
        movers: Those that the clause is about.
        net_sport: Whether the prompt is about a game over a net.
        cricket: Whether it is about cricket.
    """
    into = m.after_prep in ("into", "in")
    played = not movers or any(e.noun.kind in ("ball", "person") for e in movers)
    basket = m.after_prep == "through" or (into and played)
    balls = [_BALLS[e.head] for e in named if e.head in _BALLS]
    name = noun.name
    if name == "net" and into and not net_sport:
        name = "goal"
    elif m.head == "bar" and m.after_prep in _AT_A_BAR:
        name = "counter"
    elif name == "building" and m.head in _ROOMS and m.after_prep in ("in", "inside"):
        name = "floor"  # "in a garage a ball rolls": where the scene is
    elif name == "hoop" and (basket or any(e.noun.name == "basketball" for e in named)):
        name = "basketball hoop"
    elif name == "roof tile" and m.plural and m.determiner == "the":
        name = "floor"  # "over the edge onto the tiles"
    elif m.head == "ball" and balls:
        name = balls[0]
    elif name == "stump" and m.plural and cricket:
        name = "cricket stump"
    elif m.head == "plane" and _sloped(m):
        name = "ramp"
    return noun if name == noun.name else lex.nouns()[name]


def _sloped(m: Mention) -> bool:
    """ "A 30 degree plane", "down a smooth plane": no aircraft."""
    tilted = any(a.dimension == "angle" for a in m.amounts) or bool(ASLANT & {*m.adjectives})
    return tilted or m.after_prep in ("down", "up") or bool(_FRICTION & {*m.adjectives})
