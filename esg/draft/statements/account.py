"""What has been told and stated of a text, and what a clause and a noun phrase are about."""

from __future__ import annotations

from dataclasses import dataclass, field

from esg.draft import lexicon as lex
from esg.draft.discourse.record import Discourse
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Element, Mention, Token
from esg.graph.models import NodeEvent, Predicate, Statement

PASSED_OVER = lex.word_set("passed over (unclaimed)")
"""Words that show nothing of their own: of order, degree and chance."""
NOTHING = "nothing in the scene stands for it"
CHAINS = frozenset({"row", "pins", "rack"})
"""Patterns of which one member fells the next."""


@dataclass(frozen=True)
class Gap:
    """Words, from `start` to `end` in the text, that nothing stands for, and what is missing.

    Args:
        nodes: What they are about.
    """

    start: int
    end: int
    missing: str
    nodes: tuple[str, ...] = ()


@dataclass
class Account:
    """What has been told and stated: the text's elements, its clauses, its statements.

    Args:
        d: The discourse, after everything has been read.
        frames: The clauses whose verbs are kept.
        elements: What the text was read as.
        tokens: Its words.
        said: Its statements.
        untold: Where adverbs of what does not happen stand.
        lost: The clauses of which no verb is kept: what they name has a place all the same.
    """

    d: Discourse
    frames: list[Frame]
    elements: list[Element]
    tokens: list[Token]
    said: list[Statement]
    untold: set[tuple[int, int]] = field(default_factory=set[tuple[int, int]])
    lost: list[Frame] = field(default_factory=list[Frame])

    @property
    def kept(self) -> list[Statement]:
        """The statements that the document holds."""
        return [s for s in self.said if s.predicate is not Predicate.NOT_REPRESENTED]


def nodes_of(d: Discourse, m: Mention | None) -> list[str]:
    """What a noun phrase stands for in the scene."""
    named = [] if m is None else m.entities or d.world.resolved.get(id(m), [])
    return [i for i in named if i in d.world.entities]


def about_of(d: Discourse, f: Frame) -> set[str]:
    """Who a clause is about, and who the event that was made of it."""
    about = {i for c in d.scene.clauses if c.frame.verb is f.verb for i in c.movers}
    about |= {i for m in (f.subject, f.object, f.object2) for i in nodes_of(d, m)}
    made = d.timeline.node(d.scene.used.get((f.verb.start, f.verb.end), ""))
    return about | ({*made.participants} if made is not None else set())


def turns(d: Discourse, about: set[str] | None = None) -> bool:
    """Whether a turn or a spin is told of, of some of them if they are given."""
    kinds = (NodeEvent.HEADING_REACHED, NodeEvent.SPIN)
    told = [n for n in d.timeline.nodes if n.event in kinds]
    return any(about is None or about & {*n.participants} for n in told)


def held(d: Discourse, about: set[str], others: set[str]) -> bool:
    """Whether some stand on, lie in or hang from some of the others, or the other way round."""
    scene = d.scene
    places = (scene.supported_by, scene.inside_of, scene.attached, scene.marked)
    pairs = [{*pair} for at in places for pair in at.items()]
    pairs += [{node, tow.by} for node, tow in scene.tows.items()]
    pairs += [{j.child, j.parent or ""} for j in scene.joints]
    return any(pair & about and pair & others for pair in pairs)


def starts_somewhere(d: Discourse, who: str) -> bool:
    """Whether something holds or carries a thing at the start, or says how high it is."""
    s = d.scene
    held_ = any(who in at for at in (s.supported_by, s.inside_of, s.attached, s.hung, s.heights))
    return held_ or who in s.loosed or who in s.tows or any(j.child == who for j in s.joints)
