"""Verbs of what turns or slides on a joint: opens, closes, swings."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used, movable
from esg.draft.discourse.jointed import articulation_of
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.tracks import Motion
from esg.draft.events.acts import add_event, add_hit
from esg.draft.events.consequences import already_hit
from esg.draft.events.roles import doer_and_done
from esg.draft.events.senses.contact import hit_targets
from esg.draft.events.senses.handling import so_often
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import moved_by_others, time_of
from esg.draft.events.told import amount, at_rest
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import ForceDirection, NodeEvent
from esg.lexicon.articulations import Articulation

_SHUT = lex.word_set("shutting") | {"closed"}
_TO_AND_FRO = 3
"""How often what swings back and forth passes its lowest point, at least."""


def _row(d: Discourse, node: str) -> Articulation | None:
    return articulation_of(d.scene, d.text, entity_of(d, node))


def _openable(d: Discourse, bodies: list[str]) -> list[str]:
    return [b for b in bodies if (row := _row(d, b)) is not None and row.opened is not None]


def _hanging(d: Discourse, bodies: list[str]) -> list[str]:
    return [b for b in bodies if (row := _row(d, b)) is not None and row.drawn is not None]


@sense("open")
def read_open(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "The gate swings open", "a ball pushes the door open", "the drawer closes"."""
    doers, moved = doer_and_done(f, s, o) if o or f.verb.passive else ([], s)
    moved = _openable(d, moved)
    if not moved:
        read_as(d, "noop", f, s, o)
        return
    shut = f.verb.extra.get("result", f.verb.lemma) in _SHUT
    event = NodeEvent.CLOSE if shut else NodeEvent.OPEN
    things = [i for i in doers if movable(d, i) and kind_of(d, i) != "person" and i not in moved]
    for body in moved:
        if shut and body not in d.timeline.tracks:
            row = _row(d, body)
            d.scene.openings.setdefault(body, (row.opened or 0.0) if row else 0.0)
    if things and not already_hit(d, f, things, moved):
        add_hit(d, f, things[:1], moved, time_of(d, f))
    for body in moved:
        if at_rest(d, body) and not moved_by_others(d, body):
            d.timeline.move(body, Motion("drive"), ForceDirection.ANY_3D)
        add_event(d, event, (body,), f, time_of(d, f))
        d.timeline.track(body).motion = None
    mark_used(d, f, "closes" if shut else "opens")


@sense("swing")
def read_swing(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "A pendulum swings into a box", "the lamp sways": what hangs is let go, or was hit."""
    doers, hung = doer_and_done(f, s, o) if o or f.verb.passive else ([], s)
    hung = _hanging(d, hung)
    if not hung:
        read_as(d, "open" if _openable(d, o or s) else "swing_round", f, s, o)
        return
    things = [i for i in doers if movable(d, i) and i not in hung]
    if things and not already_hit(d, f, things, hung):
        add_hit(d, f, things[:1], hung, time_of(d, f))
    let_go(d, f, hung)
    met = f.phrase("at", "into", "against", "through", "on") is not None
    target = [i for i in hit_targets(f, s, o) if i not in hung] if met else []
    if target:
        add_hit(d, f, hung[:1], target, time_of(d, f))
    else:
        for body in hung:
            node = add_event(d, NodeEvent.SWING, (body,), f, time_of(d, f))
            so_often(d, f, node)
            draft = d.timeline.node(node)
            if draft is not None and {"forth", "fro"} & {*f.adverbs}:
                draft.extra.setdefault("times", _TO_AND_FRO)
    mark_used(d, f, "swings")


def let_go(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """What hangs and nothing has moved yet starts drawn back: by a stated angle or a usual one."""
    angle = amount(d, f, "angle")
    for body in bodies:
        row = _row(d, body)
        if row is None or moved_by_others(d, body) or body in d.timeline.tracks:
            continue
        d.scene.openings[body] = row.drawn or 0.0 if angle is None else angle.high
        if angle is not None:
            mark_used(d, angle, "where it is let go")
        d.timeline.move(body, Motion("release"), ForceDirection.ANY_3D)


@sense("let_go")
def read_let_go(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "A pendulum is released at 40 degrees", "the wrecking ball is let go"."""
    hung = _hanging(d, s if f.verb.passive or not o else o)
    if not hung:
        read_as(d, "drop", f, s, o)
        return
    let_go(d, f, hung)
    mark_used(d, f, "let go")
