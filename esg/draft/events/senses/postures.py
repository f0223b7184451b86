"""Postures: who sits, lies, kneels, crouches or bends, and who gets up."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used, structural
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse, Posing
from esg.draft.discourse.referents.registry import unique
from esg.draft.discourse.scene import LIVING, SELF_POWERED
from esg.draft.discourse.tracks import Motion
from esg.draft.discourse.windows import Draft
from esg.draft.events.hanging import hanging
from esg.draft.events.senses.state import stands_there
from esg.draft.events.stated import start_of
from esg.draft.events.timing import settle
from esg.draft.events.told import happened, ignore, last_of, things, traits_of
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import EdgeEvent, ForceDirection, MotionParams, NodeEvent
from esg.lexicon.postures import STANDS, plan_of, posture_of

UNPOSED = "bodies keep their pose"
USED = "posture"
"""What became of a verb of a posture that is held."""
_SEATS = lex.word_set("seats")
_TAIL = {
    "up": re.compile(r"\s+(?:(?:back|right|slowly|suddenly|quickly)\s+)*up\b", re.IGNORECASE),
    "down": re.compile(r"\s+(?:(?:back|right|slowly|suddenly|quickly)\s+)*down\b", re.IGNORECASE),
    "over": re.compile(r"\s+over\b", re.IGNORECASE),
    "to feet": re.compile(r"\s+(?:back\s+)?(?:up\s+)?(?:on)?to\s+\w+\s+feet\b", re.IGNORECASE),
}
_BLOWS = (NodeEvent.COLLISION, NodeEvent.FALL, NodeEvent.TOPPLE)
_ON = ("on", "onto", "in", "into", "upon")


@dataclass(frozen=True)
class _Row:
    lemma: str
    tail: str
    posture: str
    how: str
    before: str
    example: str


@cache
def rows() -> tuple[_Row, ...]:
    """The table: verbs of postures."""
    with open(lex.DATA / "postures.csv", encoding="utf-8", newline="") as file:
        return tuple(_Row(**r) for r in csv.DictReader(file, delimiter=";"))


def takes_posture(d: Discourse, f: Frame, s: list[str]) -> bool:
    """Reads who holds himself how, or changes that, where bodies can.

    Returns:
        Whether nothing is left to read; a posture at the start still says where somebody is.
    """
    found = _row(d, f)
    if found is None or not s or f.unreal or f.verb.negated or f.object is not None:
        return False
    row, end = found
    if f.subject is not None and f.subject.pronoun:  # "a person sits on a chair. They stand up"
        s = [a for a in s if _is_being(d, a)] or s
    if not row.posture and all(_is_being(d, a) for a in s):
        ignore(d, f, UNPOSED)
        stands_there(d, f, s)
        return True
    first = _holds_at_first(d, f, s, row)
    if not _may(d, f, s, row, first=first):
        return False
    if row.posture == STANDS:
        _was_on(d, f, s)
    for actor in s if not first else ():
        settle(d, actor, None)
    seat = None if first else _seat(d, f, s)
    if seat == "":
        return False
    for actor in s:
        if first:
            d.moves.postures.append(Posing(actor, row.posture, (f.verb.start, end), None))
        else:
            _change(d, f, actor, row, end, seat)
    _use(d, f, end, first=first)
    return not first


def _is_being(d: Discourse, actor: str) -> bool:
    return kind_of(d, actor) in LIVING


def _holds_at_first(d: Discourse, f: Frame, s: list[str], row: _Row) -> bool:
    """Whether a posture is told of who has done nothing yet, or aside: "hits a dog that lies"."""
    if row.how != "holds" or {p.actor for p in d.moves.postures} & {*s}:
        return False
    return f.relative or f.reduced or not any(_has_acted(d, a) for a in s)


def _may(d: Discourse, f: Frame, s: list[str], row: _Row, *, first: bool) -> bool:
    """Whether all of them can hold themselves so there, as far as what went before tells."""
    if not all(_can(d, a, row) for a in s) or _rides(d, f):
        return False
    if row.posture == STANDS and any(_is_up(d, a) for a in s):
        return False  # nobody says how he had come down
    # How a blow leaves him only the engine knows.
    return first or not any(happened(d, kind, a) for kind in _BLOWS for a in s)


def _use(d: Discourse, f: Frame, end: int, *, first: bool) -> None:
    """Notes that the words of a posture are held."""
    mark_used(d, f, USED)
    for p in f.phrases:
        floor = p.prep in ("from", "off") and any(structural(d, i) for i in things(p))
        if floor and p.mention is not None and not first:
            d.scene.used[(start_of(p, d.text), p.mention.end)] = USED
    if end > f.verb.end:
        d.scene.used[(f.verb.end, end)] = USED


def _row(d: Discourse, f: Frame) -> tuple[_Row, int] | None:
    """The row of a verb and where its words end."""
    words = f.verb.lemma.split()
    for row in rows():
        if row.lemma != words[0] or (len(words) > 1 and words[1:] != [row.tail]):
            continue
        if not row.tail or len(words) > 1:
            return row, f.verb.end
        inside = d.text[f.verb.start : f.verb.end].lower().split()
        if row.tail in inside[1:]:
            return row, f.verb.end
        tail = _TAIL[row.tail].match(d.text, f.verb.end)
        if tail is not None:
            return row, tail.end()
    return None


def _can(d: Discourse, actor: str, row: _Row) -> bool:
    """Whether a body has such a posture, and nobody carries it about."""
    if actor not in d.world.entities or not _is_being(d, actor):
        return False
    entity = entity_of(d, actor)
    plan = plan_of(entity.head, person=kind_of(d, actor) == "person")
    if plan is None or posture_of(plan, row.posture) is None:
        return False
    under = d.scene.supported_by.get(actor)
    carried = under is not None and not structural(d, under) and not _is_seat(d, under)
    return not carried and actor not in d.scene.inside_of and actor not in d.scene.tows


def _has_acted(d: Discourse, actor: str) -> bool:
    track = d.timeline.tracks.get(actor)
    told = any(p.actor == actor for p in d.moves.postures)
    return told or last_of(d, actor) is not None or (track is not None and track.motion is not None)


def _is_up(d: Discourse, actor: str) -> bool:
    """Whether somebody stands, or what has befallen him leaves open whether he does."""
    told = [p.posture for p in d.moves.postures if p.actor == actor]
    return told[-1] == STANDS if told else last_of(d, actor) is not None


def _was_on(d: Discourse, f: Frame, s: list[str]) -> None:
    """ "Gets up from a chair": that is where he was."""
    here = [a for a in s if a not in d.scene.supported_by and not _has_acted(d, a)]
    for p in f.phrases:
        seats = [i for i in things(p) if p.prep in ("from", "off", "out of") and _is_seat(d, i)]
        if seats and here and p.mention is not None:
            place(d, here, seats[:1], "on", p.mention.part)
            d.scene.used[(start_of(p, d.text), p.mention.end)] = USED


def _rides(d: Discourse, f: Frame) -> bool:
    """Whether a clause has somebody sit or lie on what may carry him off: a horse, a swing."""
    on = {i for p in f.phrases if p.prep in (*_ON, "inside", "atop", "astride") for i in things(p)}
    return bool(hanging(d, list(on))) or any(
        kind_of(d, i) in (*SELF_POWERED, *LIVING, "toy") or "wheeled" in traits_of(d, i) for i in on
    )


def _is_seat(d: Discourse, thing: str) -> bool:
    entity = entity_of(d, thing)
    return bool({entity.head, entity.noun.name, entity.head.split()[-1]} & _SEATS)


def _seat(d: Discourse, f: Frame, s: list[str]) -> str | None:
    """What somebody comes to sit or lie on; None for the ground, empty where it cannot be."""
    for p in f.phrases:
        on = [i for i in things(p) if p.prep in _ON and i not in s and not structural(d, i)]
        if on:
            return on[0] if _is_seat(d, on[0]) and _reached(d, on[0], s) else ""
    return next((i for i in d.world.entities if _is_seat(d, i) and _reached(d, i, s)), None)


def _reached(d: Discourse, seat: str, s: list[str]) -> bool:
    """Whether each of them has come there, or is on it."""
    return all(
        d.scene.supported_by.get(a) == seat
        or any(
            n.event is NodeEvent.REACH and {a, seat} <= {*n.participants} for n in d.timeline.nodes
        )
        for a in s
    )


def _change(d: Discourse, f: Frame, actor: str, row: _Row, end: int, seat: str | None) -> None:
    """A change of posture after what is told before; who gets up was down."""
    now = next((p.posture for p in reversed(d.moves.postures) if p.actor == actor), None)
    before = row.before
    if row.posture == STANDS and kind_of(d, actor) == "animal":
        before = "lies"
    if now is None and before != STANDS and last_of(d, actor) is None:
        d.moves.postures.append(Posing(actor, before, (f.verb.start, f.verb.start), None))
    if row.posture == STANDS or row.how == "holds" or row.posture != now:
        params: dict[str, object] = {"posture": row.posture}
        goes_on = None if row.posture == STANDS else seat
        motion = Motion("guide", (LEAST, MOST), target=goes_on, params=params)
        d.timeline.move(actor, motion, ForceDirection.ALONG_FORWARD_ONLY)
        node = d.timeline.trigger(actor, f"{actor} {row.posture}")
        d.timeline.track(actor).motion = None
        d.moves.postures.append(Posing(actor, row.posture, (f.verb.start, end), node))


LEAST, MOST = 30.0, 100.0
"""Speeds of a guide [cm/s]; a change of posture has none of its own."""


def get_up_first(d: Discourse) -> None:
    """ "A boy crouches, then jumps": who does not stand gets up before he goes anywhere."""
    for actor in dict.fromkeys(p.actor for p in d.moves.postures):
        first = next(p for p in d.moves.postures if p.actor == actor)
        now = first.posture if first.node is None else STANDS
        for k, edge in enumerate(d.timeline.edges):
            if edge.actor != actor:
                continue
            if edge.params.posture is not None:
                now = edge.params.posture
            elif now != STANDS and edge.event in _GOES:
                now = STANDS
                node = unique(f"{actor}_stands", (n.id for n in d.timeline.nodes))
                at = next(i for i, n in enumerate(d.timeline.nodes) if n.id == edge.to)
                up = Draft(node, NodeEvent.TRIGGER, (actor,), f"{actor} stands up")
                d.timeline.nodes.insert(at, up)
                name = unique(f"{actor}_stands_up", (e.id for e in d.timeline.edges))
                rises = edge.model_copy(
                    update={"id": name, "to": node, "event": EdgeEvent.GUIDE, "target": None,
                            "params": MotionParams(posture=STANDS)}
                )  # fmt: skip
                d.timeline.edges[k : k + 1] = [rises, edge.model_copy(update={"from_": node})]


_GOES = frozenset(
    {EdgeEvent.UNIFORM_MOTION, EdgeEvent.ACCELERATED_MOTION, EdgeEvent.TURN, EdgeEvent.TOWARD}
)
"""Segments of who moves about by himself."""
