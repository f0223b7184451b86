"""Gestures: who waves, nods, points or looks where, and whom he turns to for it."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used, structural
from esg.draft.discourse.record import Discourse, Gesturing
from esg.draft.discourse.scene import LIVING, SELF_POWERED
from esg.draft.events.senses.state import stands_there
from esg.draft.events.stated import start_of
from esg.draft.events.told import things
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Mention
from esg.lexicon.gestures import gestures
from esg.lexicon.postures import plan_of

USED = "gesture"
"""What became of a verb of a gesture that is held."""
MUTUAL = "each other"
ANY = "*"
"""Of a row whose verb takes whatever is looked at."""
_AIMS = ("at", "to", "toward", "towards")
_AWAY = {"up": ("down", "away"), "down": ("up", "away")}
_MEANWHILE = ("while", "simultaneously")


@dataclass(frozen=True)
class _Row:
    lemma: str
    object: str
    tail: str
    gesture: str
    example: str

    @property
    def objects(self) -> tuple[str, ...]:
        return tuple(self.object.split("|"))


@cache
def rows() -> tuple[_Row, ...]:
    """The table: verbs of gestures."""
    with open(lex.DATA / "gestures.csv", encoding="utf-8", newline="") as file:
        return tuple(_Row(**r) for r in csv.DictReader(file, delimiter=";"))


def makes_gesture(d: Discourse, f: Frame, s: list[str]) -> bool:
    """Reads who makes a gesture, or looks at something, where bodies can.

    Returns:
        Whether nothing is left to read.
    """
    row = _row(d, f)
    if row is None or not s or f.unreal or f.verb.negated or f.verb.passive:
        return False
    if f.subject is not None and f.subject.pronoun:  # "a person sits on a chair. They stretch"
        s = [a for a in s if kind_of(d, a) in LIVING] or s
    target = _target(d, f, s, row)
    if not _may(d, f, s, row, target):
        return False
    end = _end(d, f, row)
    meanwhile = f.link in _MEANWHILE or f.subordinate in _MEANWHILE
    for actor in s:
        to = s[0] if actor == target else target
        if to:
            d.scene.facing.setdefault(actor, to)
        d.moves.gestures.append(
            Gesturing(actor, row.gesture, (f.verb.start, end), meanwhile, to or None)
        )
    _use(d, f, row, end, target)
    stands_there(d, f, s)
    return True


def _may(d: Discourse, f: Frame, s: list[str], row: _Row, target: str) -> bool:
    """Whether all of them can, and what the gesture is meant for is there where it is told."""
    m = f.subject
    if m is not None and m.plural and not m.pronoun and len(s) == 1:
        return False  # "the crowd", where one boy is named
    if any(not _can(d, actor, row) for actor in s):
        return False
    lost = not target and (not row.gesture or (row.gesture == "points" and _aimed(f)))
    told = [g for g in d.moves.gestures if g.actor in s and g.gesture]
    # "Cheers and claps": the hands do one of them.
    busy = row.gesture and any(not _between(d, g.words[1], f.verb.start, s) for g in told)
    return not lost and not busy


def _row(d: Discourse, f: Frame) -> _Row | None:
    """The row of a verb with its object and what follows it."""
    lemma, *rest = f.verb.lemma.split()
    part = _object(f)
    head = ""
    if part is not None:
        head = (part.head.split() or [part.pronoun or "?"])[-1] + "s" * part.plural
    named = () if part is None else part.entities
    loose = part is not None and any(
        i in d.world.entities and entity_of(d, i).head == part.head for i in named
    )  # a thing of its own, no part of somebody
    said = {*rest, *f.adverbs, *d.text[f.verb.start : f.verb.end].lower().split()[1:]}
    preps = {p.prep for p in f.phrases}
    for row in rows():
        if row.lemma != lemma:
            continue
        fits = ANY in row.objects if head and loose else head in row.objects
        mutual = MUTUAL in f.adverbs and not head
        fits = fits or (mutual and ANY in row.objects)
        tail = {row.tail} <= said | preps | ({"at"} if mutual else set())
        if not fits or (row.tail and not tail):
            continue
        if row.tail in _AWAY and {*_AWAY[row.tail]} & said:
            continue
        return row
    return None


def _object(f: Frame) -> Mention | None:
    """What a verb is about: "raises his hand", "holds up his hand"."""
    if f.object is not None:
        return f.object
    return next((p.mention for p in f.phrases if p.prep == "up" and p.mention is not None
                 and p.mention.head in lex.BODY_PARTS), None)  # fmt: skip


def _can(d: Discourse, actor: str, row: _Row) -> bool:
    """Whether a body is drawn with such parts, and has them free."""
    if actor not in d.world.entities or kind_of(d, actor) not in LIVING:
        return False
    plan = plan_of(entity_of(d, actor).head, person=kind_of(d, actor) == "person")
    if row.gesture and (row.gesture, plan) not in gestures():
        return False
    if plan is None:
        return False
    under = d.scene.supported_by.get(actor)
    rides = under is not None and not structural(d, under) and kind_of(d, under) in SELF_POWERED
    return not rides and actor not in d.scene.inside_of and actor not in d.scene.tows


def _aimed(f: Frame) -> bool:
    return any(p.prep in _AIMS for p in f.phrases)


def _target(d: Discourse, f: Frame, s: list[str], row: _Row) -> str:
    """Whom or what a gesture is meant for; nothing if nobody says, or it is no thing."""
    if ANY in row.objects and f.object is not None:
        found = [i for i in f.object.entities if i in d.world.entities]
    else:
        found = [i for p in f.phrases if p.prep in _AIMS for i in things(p)]
    mutual = s[1] if MUTUAL in f.adverbs and len(s) == 2 else ""
    return next((i for i in found if i not in s and not structural(d, i)), mutual)


def _between(d: Discourse, start: int, end: int, s: list[str]) -> bool:
    """Whether somebody does something else between two places in the text."""
    acts = (c for c in d.scene.clauses if start <= c.frame.verb.start < end)
    return any({*c.movers} & {*s} for c in acts)


_TAILS = r"\s+(?:(?:back|right|slowly|suddenly|quickly)\s+)*"


def _end(d: Discourse, f: Frame, row: _Row) -> int:
    """Where the words of a gesture end: with its object, or what belongs to its verb."""
    end = f.verb.end
    part = _object(f)
    if part is not None and ANY not in row.objects:
        end = max(end, part.end)
    if row.tail:
        m = re.compile(rf"{_TAILS}{row.tail}\b", re.IGNORECASE).match(d.text, f.verb.end)
        end = max(end, m.end()) if m is not None else end
    return end


def _use(d: Discourse, f: Frame, row: _Row, end: int, target: str) -> None:
    """Notes that the words of a gesture are held."""
    mark_used(d, f, USED)
    if end > f.verb.end:
        d.scene.used[(f.verb.end, end)] = USED
    part = _object(f)
    if part is not None and ANY not in row.objects:
        d.scene.used[(part.start, part.end)] = USED
    for p in f.phrases:
        if p.mention is not None and p.prep in _AIMS and target in things(p):
            d.scene.used[(start_of(p, d.text), p.mention.end)] = USED
