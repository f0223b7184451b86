"""Clauses that tell an event again ("hit by the apple, it ...") or presuppose a motion."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, mark_used
from esg.draft.discourse.record import Discourse, Time
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent

_RETOLD = frozenset(
    {NodeEvent.COLLISION, NodeEvent.FALL, NodeEvent.TOPPLE, NodeEvent.STOP, NodeEvent.MISS,
     NodeEvent.ENTER_REGION, NodeEvent.REACH}
)  # fmt: skip
_AGAIN = re.compile(
    r"\b(?:again|twice|second time|two times|three times|once more|another time|repeatedly)\b",
    re.IGNORECASE,
)
_CONTROL = lex.word_set("control")
_ON = lex.word_set("on")
_DRIVING = lex.word_set("driving (underway)")
_RESTING = lex.word_set("resting (underway)")


def told_before(
    d: Discourse, kind: NodeEvent, participants: tuple[str, ...], f: Frame, region: str = ""
) -> str:
    """The event that a clause refers back to ("hit by the apple"), or "" if it is a new one.

    A second telling concerns the same things, and nothing has happened to them in between.
    """
    back = f.subordinate in ("after", "before") and f.verb.form == "ing"
    if kind not in _RETOLD or (_AGAIN.search(sentence(d, f)) and not back):
        return ""
    among = set(participants)
    for node in reversed(d.timeline.nodes):
        if node.event is NodeEvent.TRIGGER or not among & set(node.participants):
            continue
        if kind is NodeEvent.FALL and node.event is NodeEvent.MISS:
            continue  # "slides from the roof, just missing a woman, and smashes on the road"
        if kind is NodeEvent.FALL and node.event is NodeEvent.TOPPLE:
            off = f.phrase("off", "from", "out of", "over")
            leaves = off is not None or participants[0] in d.scene.supported_by
            return "" if leaves else node.id
        same = node.event is kind and among == set(node.participants)
        if not same or (region and node.extra.get("region") != region):
            return ""
        turned = kind is NodeEvent.COLLISION and participants[0] != node.participants[0]
        if turned and not (f.verb.passive or f.reduced or node.extra.get("mutual")):
            return ""  # "the bag swings back and hits him"
        return "" if _set_off_again(d, participants[0], kind) else node.id
    return ""


def _set_off_again(d: Discourse, actor: str, kind: NodeEvent) -> bool:
    """Whether the actor has started a new motion since its last event."""
    track = d.timeline.tracks.get(actor)
    moving = track is not None and track.motion is not None and not track.closed
    return moving and kind not in (NodeEvent.TOPPLE, NodeEvent.MISS)


def time_of_told(d: Discourse, told: str, time: Time | None) -> None:
    """A time stated with the second telling is the time of the event."""
    node = d.timeline.node(told)
    if node is None or time is None or (time[1].start, time[1].end) in d.scene.used:
        return
    if node.time is None and not node.constraints and (time[2] == "at" or not node.after):
        node.time, node.time_prescribed = time[0], True
        mark_used(d, time[1], f"time of {told}")


def goes_on(d: Discourse, f: Frame, actor: str) -> bool:
    """Whether what a clause hits was moving: what is told of it next presupposes that."""
    later = d.told[next((k + 1 for k, g in enumerate(d.told) if g.verb is f.verb), len(d.told)) :]
    own = (g for g in later if g.subject is not None and actor in g.subject.entities)
    after = next(own, None)
    if after is None or _RESTING & {*entity_of(d, actor).adjectives}:
        return False
    if after.unreal or after.verb.negated or after.verb.passive or after.verb.infinitive:
        return False
    words = {*after.adverbs, *d.text[after.verb.start : after.verb.end].lower().split()}
    on = bool(_ON & words) or "continue" in after.verb.extra or after.verb.sense == "continue"
    return after.verb.sense in _CONTROL or (on and after.verb.sense in _DRIVING)


def sentence(d: Discourse, f: Frame) -> str:
    start = max(d.text.rfind(x, 0, f.verb.start) for x in ".;!?")
    ends = [d.text.find(x, f.verb.end) for x in ".;!?"]
    return d.text[start + 1 : min([e for e in ends if e >= 0], default=len(d.text))]
