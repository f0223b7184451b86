"""Ropes and chains: they are drawn as the joint that they are, and are no things of the scene."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used
from esg.draft.discourse.event_coreference import sentence
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import SELF_POWERED, Scene, Tow
from esg.draft.grammar.clauses.frames import Frame

LINKS = lex.word_set("links")
"""Heads of phrases that may name what joins two things."""
def is_link(scene: Scene, node: str) -> bool:
    """Whether a node is a rope, a chain, a cable."""
    e = scene.world.entities.get(node)
    return e is not None and e.head.lower().split()[-1] in LINKS


def link_of(d: Discourse, f: Frame) -> str:
    """The rope that the sentence of a clause names; "" if none."""
    words = sentence(d, f)
    start = d.text.index(words)
    told = [m for m in d.mentions if start <= m.start < start + len(words)]
    return next((i for m in told for i in m.entities if is_link(d.scene, i)), "")


def can_tow(d: Discourse, f: Frame, doers: list[str], drawn: list[str]) -> bool:
    """Whether a clause tells of something that draws others along behind it, on the ground."""
    if not doers or not drawn or kind_of(d, doers[0]) not in SELF_POWERED:
        return False
    loose = [i for i in drawn if "fixed" not in entity_of(d, i).noun.traits]
    return loose == drawn and (kind_of(d, doers[0]) != "person" or bool(link_of(d, f)))


def tow(d: Discourse, f: Frame, doers: list[str], drawn: list[str]) -> None:
    """Joins things to what draws them along, one behind the other.

    Args:
        d: The discourse.
        f: The clause that tells of it.
        doers: Who draws; the first does.
        drawn: What is drawn, in its order.
    """
    ahead, link = doers[0], link_of(d, f)
    for node in drawn:
        if node != ahead and node not in d.scene.tows:
            d.scene.tows[node] = Tow(ahead, link)
            d.scene.relations = [
                r for r in d.scene.relations if {r.source, r.target} != {node, ahead}
            ]
            ahead = node
    if link:
        drop_link(d, link)


def drop_link(d: Discourse, link: str) -> None:
    """Takes a rope out of what has a place in the scene: a joint draws it."""
    scene = d.scene
    scene.links.add(link)
    for m in (m for m in d.mentions if link in m.entities):
        mark_used(d, m, "a joint")
    scene.relations = [r for r in scene.relations if link not in (r.source, r.target)]
    for places in (scene.supported_by, scene.inside_of, scene.marked, scene.attached):
        for node in [n for n, at in places.items() if link in (n, at)]:
            del places[node]
