"""What somebody wears and how he looks: statements of what the drawn model has."""

from __future__ import annotations

from collections.abc import Iterator
import csv
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of
from esg.draft.statements.account import NOTHING, nodes_of
from esg.draft.statements.book import Told
from esg.draft.text.elements import Mention, Put, Token
from esg.graph.models import Predicate
from esg.lexicon.garments import Worn, read, wearers

USED = "worn"
"""What became of words that statements of what is worn hold."""


_NOUNS = frozenset({"NOUN", "PROPN"})
_OF_AGE = "grey hair"
"""What shows age, where nothing else is said of the hair."""


@cache
def _adjectives() -> dict[str, str]:
    """What adjectives say of a body, as phrases: "bearded" is "beard"."""
    out: dict[str, str] = {}
    with open(lex.DATA / "looks.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";"):
            out |= dict.fromkeys(row["words"].split("|"), row["says"])
    return out


def worn(t: Told) -> None:
    """Writes down what noun phrases say of those whom they mean, each garment once."""
    of_hair = set[str]()
    adjectives = [token for token in t.tokens if token.low in _adjectives()]
    for m in t.d.mentions if adjectives else [m for m in t.d.mentions if m.wears]:
        others = {i for one in m.coordinated for i in nodes_of(t.d, one)}
        ids = tuple(i for i in nodes_of(t.d, m) if i not in others)
        puts = (*m.wears, *_told_by_adjectives(t, m, adjectives))
        haired = [p for p in puts if _of_hair(p)]
        for put in puts:
            said = read(put.phrase, lex.COLORS)
            if put.phrase == _OF_AGE and (len(haired) > 1 or of_hair & {*ids}):
                t.d.scene.used[put.start, put.end] = USED  # "a bald old man"
            elif said is not None and ids and _is_held(t, put, said, ids):
                _state(t, put, said, ids)
                of_hair |= {*ids} if said.garment.place == "hair" else set()
            elif put in m.wears:
                t.book.add(Predicate.NOT_REPRESENTED, put.start, put.end, object=ids, note=NOTHING)


def _of_hair(put: Put) -> bool:
    said = read(put.phrase, lex.COLORS)
    return said is not None and said.garment.place == "hair"


def _is_held(t: Told, put: Put, said: Worn, ids: tuple[str, ...]) -> bool:
    """Whether all can be drawn with it, and no noun makes another thing of it ("bear suit")."""
    named = {x.low for x in t.tokens if put.start <= x.start < put.end and x.tag in _NOUNS}
    return not named & {*said.unread} and all(_drawn(t, i, said) for i in ids)


def _drawn(t: Told, who: str, said: Worn) -> bool:
    """Whether somebody can be drawn with a garment; clothes in general need a colour."""
    dressed = wearers().get(entity_of(t.d, who).noun.name, frozenset[str]())
    usual = said.garment.kind != "clothes" or bool(said.color)
    return bool(dressed & said.garment.on) and usual


def _state(t: Told, put: Put, said: Worn, ids: tuple[str, ...]) -> None:
    """One garment, and those of its words that nothing shows."""
    told = [w for w in re.split(r"[\s-]+", put.phrase.lower()) if w not in said.unread]
    phrase = re.sub(r"^(?:and )+", "", " ".join(told))
    says = Predicate.LOOKS if said.garment.looks else Predicate.WEARS
    t.book.add(says, put.start, put.end, object=ids, noun=phrase)
    t.d.scene.used[put.start, put.end] = USED
    if put.verb is not None:
        t.d.scene.used[put.verb] = USED
    for word in said.unread:
        at = t.d.text.lower().find(word, put.start, put.end)
        if at >= 0 and word not in lex.DETERMINERS:
            t.book.add(Predicate.NOT_REPRESENTED, at, at + len(word), object=ids, note=NOTHING)


def _told_by_adjectives(t: Told, m: Mention, words: list[Token]) -> Iterator[Put]:
    """ "A bearded man", "a red-haired girl", "an old woman"; the last may be left before it."""
    first = m.start
    for token in reversed(words):
        if token.end <= first and not t.d.text[token.end : first].strip():
            first = token.start
    for token in words:
        if first <= token.start < m.end:
            yield Put(_adjectives()[token.low], token.start, token.end)
