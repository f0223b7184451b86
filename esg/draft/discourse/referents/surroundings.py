"""What a noun names among the things around it: a net that is a goal, a bar that is a counter."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.slopes import ASLANT
from esg.draft.text.elements import Mention

_AT_A_BAR = lex.word_set("at a bar")
_FRICTION = frozenset({"frictionless", "rough", "smooth", "slippery"})
_HILLSIDES = lex.word_set("hillsides")
_LEANT = lex.word_set("boards (leant)")
_ROOMS = lex.word_set("rooms")


@dataclass(frozen=True)
class Beside:
    """A row of `beside.csv`: what a word names where another thing was named before it.

    Args:
        word: Head of a noun phrase.
        beside: Heads or kinds of things, any of which was named before.
        names: What it names then.
        example: A prompt in which it does.
    """

    word: str
    beside: frozenset[str]
    names: str
    example: str


@cache
def rows() -> tuple[Beside, ...]:
    """The table."""
    with open(lex.DATA / "beside.csv", encoding="utf-8", newline="") as file:
        told = list(csv.DictReader(file, delimiter=";"))
    return tuple(
        Beside(r["word"], frozenset(r["beside"].split("|")), r["names"], r["example"]) for r in told
    )


def _beside(m: Mention, named: list[Entity]) -> str:
    """What a phrase names beside the things so far; "" if none of them says so."""
    there = {name for e in named for name in (e.head, e.noun.name)}
    there |= {f"{word} {e.head}" for e in named for word in e.adjectives}
    return next(
        (r.names for r in rows() if r.word == m.head and not r.beside.isdisjoint(there)), ""
    )


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
    name = noun.name
    if beside := _beside(m, named):
        name = beside
    elif name == "net" and into and not net_sport:
        name = "goal"
    elif m.head == "bar" and m.after_prep in _AT_A_BAR:
        name = "counter"
    elif name == "building" and m.head in _ROOMS and m.after_prep in ("in", "inside"):
        name = "floor"  # "in a garage a ball rolls": where the scene is
    elif name == "hula hoop" and m.head == "hoop" and basket:
        name = "basketball hoop"
    elif m.plural:
        name = _of_many(m, name, cricket=cricket)
    elif m.head == "arm" and _of_a_machine(m, named):
        name = "robot arm"
    elif (
        (m.head in _HILLSIDES and m.after_prep in ("down", "up"))
        or (m.head == "plane" and _sloped(m))
        or (m.head in _LEANT and m.after_prep == "down")
    ):
        name = "ramp"
    return noun if name == noun.name else lex.nouns()[name]


def _of_many(m: Mention, name: str, *, cricket: bool) -> str:
    """What a plural names that is another thing than one of its kind."""
    if name == "roof tile" and m.determiner == "the":
        return "floor"  # "over the edge onto the tiles"
    return "cricket stump" if name == "stump" and cricket else name


def _of_a_machine(m: Mention, named: list[Entity]) -> bool:
    """ "The arm pushes the can": who has it was not named, and it does something itself."""
    told = m.determiner == "the" and not (m.plural or m.possessor or m.after_prep)
    return told and not any(e.noun.kind in ("person", "animal", "robot") for e in named)


def _sloped(m: Mention) -> bool:
    """ "A 30 degree plane", "down a smooth plane": no aircraft."""
    tilted = any(a.dimension == "angle" for a in m.amounts) or bool(ASLANT & {*m.adjectives})
    return tilted or m.after_prep in ("down", "up") or bool(_FRICTION & {*m.adjectives})
