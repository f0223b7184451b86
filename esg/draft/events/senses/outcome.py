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
from esg.draft.events.ends import implied_goal
from esg.draft.events.motions import motion
from esg.draft.events.roles import doer_and_done, filling, role
from esg.draft.events.senses.contact import aim_of_mates, hit_targets
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import enter, enterable, time_of
from esg.draft.events.told import happened, ignore, moves, things
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent


@sense("enter")
def read_enter(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    into, met = role(f, "inside"), things(f.phrase("onto", "on", "against"))
    if s and not o and into is None and any(map(partial(aimable, d), met)):
        read_as(d, "land", f, s, [])  # "splashes onto a parked car"
        return
    o = o or [i for i in things(into) if enterable(d, i) or holds(d, i)]
    target = next((t for t in o if not structural(d, t)), None)
    for actor in s:
        if target is not None and movable(d, actor):
            ensure_mover(d, f, actor, target)
            enter(d, f, actor, target, time_of(d, f))
        elif f.verb.lemma == "enter" and f.object is None and into is None and not moves(d, actor):
            motion(d, f, [actor], None)  # "enters from the left"
        else:
            mark_used(d, f, "continues on its way")


@sense("pocket")
def read_pocket(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    s, o = doer_and_done(f, s, o)
    if f.verb.lemma == "sink" and any(kind_of(d, x) == "watercraft" for x in o or s):
        ignore(d, f, "sinking is not simulated")
        return
    strikers = [x for x in s if kind_of(d, x) in ("billiard", "ball")]
    if strikers and o and not already_hit(d, f, strikers, o):
        add_hit(d, f, strikers[:1], o, time_of(d, f))
    goal = things(f.phrase("in", "into", "to"))
    for b in o[:1]:
        if goal:
            enter(d, f, b, goal[0], time_of(d, f))
        else:
            d.scene.needs.append(("billiard_table", b))
            region = "billiard_table_1/bottom left pocket"
            add_event(d, NodeEvent.ENTER_REGION, (b,), f, time_of(d, f), region=region)


@sense("score")
def read_score(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """The last ball enters the goal, both of which the prompt need not name."""
    known = d.world.entities
    balls = [i for i, e in known.items() if e.noun.kind in ("ball", "sliding")]
    ball = next(iter([*[i for i in (*o, *s) if i in balls], *balls[-1:]]), "")
    if not ball:
        ball = add_entity(d.world, lex.nouns()["soccer ball"], "soccer ball", mentioned=False).id
    goals = [i for i, e in known.items() if "goal" in e.noun.traits]
    if happened(d, NodeEvent.ENTER_REGION, ball):
        mark_used(d, f, "goal")
        return
    goal = goals[0] if goals else implied_goal(d, ball)
    ensure_mover(d, f, ball, goal)
    enter(d, f, ball, goal, time_of(d, f))


@sense("miss")
def read_miss(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.verb.passive and filling(f, "agent"):
        s, o = doer_and_done(f, s, o)  # "is nearly hit by a motorbike"
    targets = hit_targets(f, s, o)
    if f.verb.lemma in ("catch", "grab") and f.verb.negated:
        ignore(d, f, "negated")
        return
    if not targets and len(s) > 1:
        s, targets = s[:1], s[1:2]  # "they nearly collide"
    for actor in s:
        aim = d.moves.aim.get(actor)
        targets = targets or ([aim] if aim else target_of_mates(d, actor))
        ensure_mover(d, f, actor, targets[0] if targets else None)
        for other in [t for t in targets[:1] if t != actor]:
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
    if moving and o and moving[0] in d.timeline.tracks:
        read_avoid(d, f, moving, o)
    else:
        ignore(d, f, "clearing away is not simulated")


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
