"""What a noun names among the things around it: a net that is a goal, a bar that is a counter."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.text.elements import Mention

_TO_THE_HOLE = lex.word_set("to the hole")
_AT_A_BAR = lex.word_set("at a bar")
_ROOMS = lex.word_set("rooms")
_BALLS = {
    "golfer": "golf ball", "batter": "baseball", "pitcher": "baseball", "batsman": "cricket ball",
    "goalkeeper": "soccer ball", "goalie": "soccer ball", "striker": "soccer ball",
    "footballer": "soccer ball", "tennis player": "tennis ball", "bowling alley": "bowling ball",
}  # fmt: skip
"""The ball of who plays with it."""


def noun_here(
    m: Mention, noun: lex.Noun, named: list[Entity], movers: list[Entity], *, net_sport: bool
) -> lex.Noun:
    """The noun of a new object, by its preposition and by what was named before it.

    Args:
        m: The noun phrase.
        noun: What it names anywhere else.
        named: The objects so far.
        movers: Those that the clause is about.
        net_sport: Whether the prompt is about a game over a net.
    """
    if noun.name == "net" and m.after_prep in ("into", "in") and not net_sport:
        noun = lex.nouns()["goal"]
    elif noun.name == "cup" and about_golf(named, movers) and m.after_prep in _TO_THE_HOLE:
        noun = lex.nouns()["hole"]
    elif noun.name == "building" and m.after_prep in ("in", "inside") and m.head in _ROOMS:
        noun = lex.nouns()["floor"]  # "in a garage a ball rolls": where the scene is
    elif m.head == "bar" and noun.name in ("gold bar", "floor") and m.after_prep in _AT_A_BAR:
        noun = lex.nouns()["counter"]
    elif m.text.lower().split()[-1:] == ["bar"] and m.after_prep in ("in", "inside"):
        noun = lex.nouns()["floor"]  # "in a bar a glass slides": where the scene is
    elif noun.name == "hoop" and (
        m.after_prep == "through"
        or (m.after_prep in ("into", "in") and _ball_game(movers))
        or any(e.noun.name == "basketball" for e in named)
    ):
        noun = lex.nouns()["basketball hoop"]
    elif noun.name == "stump" and any(e.noun.name == "cricket ball" for e in named):
        noun = lex.nouns()["cricket stump"]
    elif noun.name == "roof tile" and m.plural and m.determiner == "the":
        noun = lex.nouns()["floor"]  # "over the edge onto the tiles"
    elif m.head == "ball":
        played = (_BALLS.get(e.head) for e in named)
        noun = lex.nouns()[next((b for b in played if b), noun.name)]
    return noun


def _ball_game(movers: list[Entity]) -> bool:
    """Whether a ball, or someone who may have one, goes for the hoop."""
    return not movers or any(e.noun.kind in ("ball", "person") for e in movers)


def about_golf(named: list[Entity], movers: list[Entity]) -> bool:
    """Whether what the clause is about is a golf ball, or the prompt's only ball is one."""
    if any(e.noun.name == "golf ball" for e in movers):
        return True
    people = all(e.noun.kind == "person" for e in movers)
    return people and any(e.noun.name == "golf ball" for e in named)
