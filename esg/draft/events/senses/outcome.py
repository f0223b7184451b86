"""Verbs of where a mover ends or what it gets by: enter, pot, score, miss, avoid."""

from __future__ import annotations

from functools import partial

from esg.draft import lexicon as lex
from esg.draft.discourse.core import aimable, entity_of, kind_of, mark_used, movable, structural
from esg.draft.discourse.places import holds
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.events.acts import add_event, add_hit, ensure_mover
from esg.draft.events.consequences import already_hit
from esg.draft.events.senses.contact import aim_of_mates, hit_targets
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import enter, enterable, time_of
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent


@sense("enter")
def read_enter(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    onto = f.phrase("onto", "on", "against")
    met = onto.mention.entities if onto is not None and onto.mention is not None else []
    if s and not o and f.phrase("into", "in") is None and any(map(partial(aimable, d), met)):
        read_as(d, "land", f, s, [])  # "splashes onto a parked car"
        return
    into = f.phrase("into", "in")
    if not o and into is not None and into.mention is not None:
        o = [i for i in into.mention.entities if enterable(d, i) or holds(d, i)]
    for actor in s:
        target = next((t for t in o if not structural(d, t)), None)
        if target is not None and actor in d.world.entities and movable(d, actor):
            ensure_mover(d, f, actor, target)
            enter(d, f, actor, target, f.object, time_of(d, f))
        else:
            mark_used(d, f, "continues on its way")


@sense("pocket")
def read_pocket(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.verb.passive:
        by = f.phrase("by")
        o, s = s, list(by.mention.entities) if by and by.mention else []
    bodies = o
    if f.verb.lemma == "sink" and any(kind_of(d, x) == "watercraft" for x in o or s):
        d.scene.ignored[(f.verb.start, f.verb.end)] = "sinking is not simulated"
        return
    strikers = [x for x in s if kind_of(d, x) in ("billiard", "ball")]
    if strikers and bodies and not already_hit(d, f, strikers, bodies):
        add_hit(d, f, strikers[:1], bodies, time_of(d, f))
    for b in bodies[:1]:
        p = f.phrase("in", "into", "to")
        goal = [i for i in (p.mention.entities if p and p.mention else [])]
        if goal:
            enter(d, f, b, goal[0], p.mention if p else None, time_of(d, f))
        else:
            d.scene.needs.append(("billiard_table", b))
            add_event(
                d,
                NodeEvent.ENTER_REGION,
                (b,),
                f,
                time_of(d, f),
                region="billiard_table_1/bottom left pocket",
            )


@sense("score")
def read_score(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    balls = [i for i, e in d.world.entities.items() if e.noun.kind in ("ball", "sliding")]
    ball = next((i for i in [*o, *s] if i in balls), balls[-1] if balls else None)
    if ball is None:
        ball = add_entity(d.world, lex.nouns()["soccer ball"], "soccer ball", mentioned=False).id
    goal = next((i for i, e in d.world.entities.items() if "goal" in e.noun.traits), None)
    if goal is None:
        name = "basketball hoop" if entity_of(d, ball).noun.name == "basketball" else "goal"
        goal = add_entity(d.world, lex.nouns()[name], name, mentioned=False).id
    if any(n.event is NodeEvent.ENTER_REGION and ball in n.participants for n in d.timeline.nodes):
        mark_used(d, f, "goal")
        return
    ensure_mover(d, f, ball, goal)
    enter(d, f, ball, goal, None, time_of(d, f))


@sense("miss")
def read_miss(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    by = f.phrase("by")
    if f.verb.passive and by is not None and by.mention is not None and by.mention.entities:
        s, o = list(by.mention.entities), s  # "is nearly hit by a motorbike"
    targets = hit_targets(f, s, o)
    if f.verb.lemma in ("catch", "grab") and f.verb.negated:
        d.scene.ignored[(f.verb.start, f.verb.end)] = "negated"
        return
    if not targets and len(s) > 1:
        s, targets = s[:1], s[1:2]  # "they nearly collide"
    for actor in s:
        if not targets and actor in d.moves.aim:
            targets = [d.moves.aim[actor]]
        if not targets:
            targets = target_of_mates(d, actor)
        ensure_mover(d, f, actor, targets[0] if targets else None)
        for other in targets[:1]:
            if other != actor:
                add_event(d, NodeEvent.MISS, (actor, other), f, time_of(d, f))


def target_of_mates(d: Discourse, actor: str) -> list[str]:
    """ "A ball hits a window, a second ball misses": what the others aimed at or hit."""
    aimed = aim_of_mates(d, actor)
    if aimed is not None and aimed != actor:
        return [aimed]
    kind = entity_of(d, actor).noun.name
    for node in reversed(d.timeline.nodes):
        like = [p for p in node.participants if entity_of(d, p).noun.name == kind and p != actor]
        others = [p for p in node.participants if p not in like and p != actor]
        if node.event in (NodeEvent.COLLISION, NodeEvent.MISS) and like and others:
            return others[:1]
    return []


@sense("clear")
def read_clear(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "clears the fence": goes over it without touching it."""
    moving = [a for a in s if movable(d, a) and kind_of(d, a) != "person"] or s
    if moving and o and d.timeline.tracks.get(moving[0]) is not None:
        read_avoid(d, f, moving, o)
    else:
        d.scene.ignored[(f.verb.start, f.verb.end)] = "clearing away is not simulated"


@sense("avoid")
def read_avoid(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    event = f.object is not None and f.object.head in ("collision", "crash", "accident")
    if event and not o and len(s) == 1:  # "brakes hard and avoids a collision"
        named = [ids[0] for ids in reversed(d.world.salience) if len(ids) == 1]
        fit = [i for i in named if i in d.world.entities and i not in s]
        o = [i for i in fit if aimable(d, i)][:1]
    for actor in s:
        for other in [x for x in o if x != actor][:1]:
            add_event(d, NodeEvent.MISS, (actor, other), f, time_of(d, f))
