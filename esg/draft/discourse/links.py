"""Ropes and chains: they are drawn as the joint that they are, and are no things of the scene."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import amounts_of, entity_of, kind_of, mark_used
from esg.draft.discourse.event_coreference import sentence
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import Entity, head_of
from esg.draft.discourse.scene import SELF_POWERED, Scene, Tow
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention
from esg.lexicon.articulations import articulations

LINKS = lex.word_set("links")
"""Heads of phrases that may name what joins two things."""
SNAPPING = lex.word_set("snapping")
"""Verbs of what a rope does that holds no more."""
_HANGING = lex.word_set("hanging")
_SWINGING = _HANGING | lex.word_set("swinging")
_COMING, _FREE = frozenset({"come", "break", "get", "work", "tear"}), frozenset({"loose", "free"})
_DETACHING = frozenset({"detach", "uncouple", "unhitch", "disconnect"})
_BY = ("on", "from", "by", "with")
SPRINGS = frozenset({"spring", "coil spring"})
_DRAWN_BY_HAND = lex.word_set("drawn by hand")
_RODS = frozenset({"rod", "arm", "stick"})
"""What a pendulum may be on besides."""


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
    away = {"out", "off", "down", "apart", "away", "over", "up", "open"} & {*f.adverbs}
    loose = [i for i in drawn if "fixed" not in entity_of(d, i).noun.traits]
    loose = [i for i in loose if not away and not is_link(d.scene, i)]
    by_hand = all(entity_of(d, i).noun.name in _DRAWN_BY_HAND for i in drawn)
    by_hand = by_hand and not _goes_on_alone(d, f, drawn)
    afoot = kind_of(d, doers[0]) == "person" and not by_hand
    return loose == drawn and (not afoot or bool(link_of(d, f)))


def _goes_on_alone(d: Discourse, f: Frame, drawn: list[str]) -> bool:
    """ "Pulls a sled up a hill and lets it go": it does more, which a line would keep from it."""
    later = (g for g in d.told if g.verb.start > f.verb.start)
    named = (m for g in later for m in (g.subject, g.object) if m is not None)
    return any({*m.entities} & {*drawn} for m in named)


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


def take_links(d: Discourse) -> set[int]:
    """Reads what hangs on a rope or a spring; these are joints then, and no things.

    Returns:
        Phrases that say no more than that, by the id of their noun phrase.
    """
    taken: set[int] = set()
    for m, p in d.attached:
        taken |= _of_a_noun(d, m, p)
    for f in d.told:
        taken |= _of_a_clause(d, f)
    for m in d.mentions:
        for node in m.entities if "hanging" in m.adjectives else []:
            _hang(d, node, "")
    return taken


def _of_a_noun(d: Discourse, m: Mention, p: Phrase) -> set[int]:
    """ "A ball on a rope", "the rope of a lamp", "a bob on a rod", "a weight on a spring"."""
    other = p.mention
    if other is None or not (p.prep == "of" or p.prep in _BY):
        return set()
    if p.prep != "of" and other.head in SPRINGS:
        return _sprung(d, m.entities, other)
    rope, held = (m, other.entities) if p.prep == "of" else (other, m.entities)
    links = [i for i in rope.entities if is_link(d.scene, i)]
    if not links and p.prep != "of" and other.head in _RODS:
        links, held = other.entities, [i for i in held if _is_pendulum(d, i)]
    hung = [node for node in held if links and _hangs(d, node)]
    for node in hung:
        _hang(d, node, links[0])
    for link in links[1:] if hung else []:
        drop_link(d, link)  # "on two ropes"
    return {id(other)} if hung else set()


def _of_a_clause(d: Discourse, f: Frame) -> set[int]:
    """ "A bucket dangles on a cord", "a ball bobs on a spring", "the rope snaps"."""
    taken: set[int] = set()
    subject = f.subject.entities if f.subject is not None else []
    named = {i: p.mention for p in f.phrases if p.mention for i in p.mention.entities}
    springs = [p.mention for p in f.phrases if p.mention and p.mention.head in SPRINGS]
    for spring in springs if f.verb.lemma in _SWINGING else []:
        taken |= _sprung(d, subject, spring)
    if f.verb.lemma in _HANGING:
        link = next((i for i in named if is_link(d.scene, i)), "")
        for node in [*subject, *(f.object.entities if f.object is not None else [])]:
            if link or f.phrase("from") is not None or _acted_on(d, f, node):
                _hang(d, node, link or link_of(d, f))
        for other in named[link].entities if link else []:
            drop_link(d, other)  # "on two ropes"
        taken |= {id(named[link])} if link else set()
    for node in subject if snapped(d, f) else []:
        _hang(d, held_by(d, node), node if is_link(d.scene, node) else "")
    return taken


def _sprung(d: Discourse, held: list[str], spring: Mention) -> set[int]:
    """What hangs on a spring, if one may hang it up; the phrase that is read with it."""
    loose = [i for i in held if i in d.world.entities and i not in spring.entities]
    loose = [i for i in loose if kind_of(d, i) not in SELF_POWERED]
    d.scene.sprung.update(loose)
    mark_used(d, spring, "a joint")
    return {id(spring)} if loose else set()


def snapped(d: Discourse, f: Frame) -> bool:
    """ "The rope snaps", "its chain breaks": a clause about a rope that holds no more."""
    before = d.text[: f.verb.start].lower().split()[-1:] or [""]
    m = f.subject
    link = before[0] in LINKS or (m is not None and bool({*m.head.lower().split()[-1:]} & LINKS))
    gives = f.verb.lemma in SNAPPING or (f.verb.lemma == "let" and f.object is None)
    return link and gives and not f.verb.negated


def held_by(d: Discourse, node: str) -> str:
    """What a rope holds: what it is of, what is towed or hangs by it, the only thing that hangs."""
    if not is_link(d.scene, node):
        return node
    by_it = [i for i, link in d.scene.hung.items() if link == node]
    hung = by_it or [*d.scene.hung] or [i for m in d.mentions if "hanging" in m.adjectives
                                        for i in m.entities]  # fmt: skip
    return hung[0] if len({*hung}) == 1 or by_it else ""


def let_loose(d: Discourse, f: Frame) -> list[str]:
    """What is towed, and no more: "the rope breaks", "the trailer comes loose"."""
    tows, m = d.scene.tows, f.subject
    if m is None or f.verb.negated:
        return []
    after = d.text[f.verb.end :].lower().split()[:1]
    freed = f.verb.lemma in _COMING and _FREE & {*f.adverbs, *(w.strip(".,;") for w in after)}
    freed = freed or f.verb.lemma in _DETACHING
    if snapped(d, f) or (freed and any(is_link(d.scene, i) for i in m.entities)):
        by_it = [node for node, tow in tows.items() if tow.link in m.entities]
        only = [*tows] if len(tows) == 1 and not d.scene.hung else []
        return by_it or only
    return [i for i in m.entities if i in tows] if freed else []


def comes_off(d: Discourse, f: Frame) -> list[str]:
    """ "The chandelier tears loose from the ceiling": what hangs there and does so no more."""
    timed = any(a.dimension == "time" for _, a in amounts_of(d, f))  # it gives way at the start
    if f.subject is None or f.verb.negated or f.verb.passive or timed:
        return []
    after = [w.strip(".,;") for w in d.text[f.verb.end :].lower().split()[:1]]
    below = [i for p in f.phrases if p.prep in ("from", "off") and p.mention is not None
             for i in p.mention.entities if kind_of(d, i) == "ceiling"]  # fmt: skip
    freed = f.verb.lemma in _COMING and bool(_FREE & {*f.adverbs, *after})
    freed = freed or (bool(below) and f.verb.sense == "fall")
    bodies = [i for i in f.subject.entities if i in d.world.entities and not is_link(d.scene, i)]
    return [i for i in bodies if freed and (below or i in d.scene.hung or _below(d, i))]


def _below(d: Discourse, node: str) -> bool:
    host = d.scene.attached.get(node, "")
    return host in d.world.entities and kind_of(d, host) == "ceiling"


def _hangs(d: Discourse, node: str) -> bool:
    """Whether something is told of a thing that only what hangs does."""
    if node not in d.world.entities or is_link(d.scene, node):
        return False
    told = {f.verb.lemma for f in d.told for m in (f.subject, f.object) if m and node in m.entities}
    own = articulations().get(head_of(entity_of(d, node)))
    return bool(told & _SWINGING) or (own is not None and own.drawn is not None)


def _is_pendulum(d: Discourse, node: str) -> bool:
    row = articulations().get(head_of(entity_of(d, node))) if node in d.world.entities else None
    return row is not None and row.kind == "hinge" and row.hangs


def _acted_on(d: Discourse, f: Frame, node: str) -> bool:
    """Whether another clause tells that something is done to what hangs in a way of its own."""
    row = articulations().get(f"hanging {head_of(entity_of(d, node))}")
    others = (g.object for g in d.told if g is not f and g.object is not None)
    return row is not None and any(node in m.entities for m in others)


def _hang(d: Discourse, node: str, link: str) -> None:
    if node not in d.world.entities or is_link(d.scene, node):
        return
    if link or node not in d.scene.hung:
        d.scene.hung[node] = link
    if link:
        _as_long(d, entity_of(d, node), entity_of(d, link))
        drop_link(d, link)


def _as_long(d: Discourse, e: Entity, link: Entity) -> None:
    """Makes a pendulum as long as the rod or string that the prompt states for it."""
    if link.dimensions_cm is None or not _is_pendulum(d, e.id):
        return
    part = lex.part(articulations()[head_of(e)].becomes)
    width, depth, height = e.noun.dimensions_cm
    share = max(link.dimensions_cm) / part.dimensions_cm[2]
    e.dimensions_cm = [width, depth, height * share]
    e.dimensions_prescribed = True
