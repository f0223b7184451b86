"""Motions: how fast, in which way and towards what an actor starts to move."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.concurrence import on_its_own
from esg.draft.discourse.core import (
    aimable,
    amounts_of,
    entity_of,
    kind_of,
    mark_used,
    movable,
    quantity_of,
)
from esg.draft.discourse.places import carries, elevated, fits_on, place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import GROUND, LIVING, SELF_POWERED, SPEEDS
from esg.draft.discourse.timeline import LAUNCHES, START
from esg.draft.discourse.tracks import Motion
from esg.draft.events.gaits import gaits, on_legs
from esg.draft.events.hanging import hanging, let_go
from esg.draft.events.lengths import distance
from esg.draft.events.roles import filling, role
from esg.draft.events.timing import SETS_OFF, moved_by_others, speed_after, time_of
from esg.draft.events.told import at_rest, constrain, last_event, last_of, things, unread
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.grammar.clauses.links import CAUSE_SENSES
from esg.draft.text.quantities import Amount
from esg.graph.models import ForceDirection, NodeEvent, Quantity

_AIRBORNE = lex.word_set("airborne")
_ONCE = frozenset({"after", "once", "when", "whenever", "as soon as"})
_BEHIND = frozenset({"behind", "after"})
_CHECKS = frozenset({"brake", "stop", "slow", "swerve", "turn", "hit", "reverse"})
"""Senses of what somebody may do who is on the way already."""
THEN = lex.word_set("then")
ROLLING = "rolling"
"""Adjective of what is on its way round and round."""
AFTER_THAT = r"\bafter (?:that|this|which)\b"
_PACES = {
    "crawl": (0.3, 0.0, 0.7, 0.0),
    "slow": (0.5, 0.0, 1.0, 0.15),
    "fast": (1.0, 0.5, 1.0, 1.0),
}
"""Least and greatest speed by pace, each as a share of the range's lower end, and of its width
added to that: a car that creeps goes at a walk (0.9 to 2.1 m/s), a slow one at up to 20 km/h."""
_SLOWEST_CM_S = 25.0
"""No word makes anything slower than this, a little more than what counts as motion."""


_FLOATERS = lex.word_set("floaters")
_CARRYING = ("on", "atop", "on top of")
_TOPS = ("top", "roof", "bed", "ridge", "deck")
"""Parts of a thing that something goes along or across on it."""
_COMES_ONTO = lex.word_set("comes onto")
_IN_THE_AIR = lex.word_set("in the air")
_WINGED = lex.word_set("winged")


PRESSES = "press"
"""The verb of what is led on by a hand, slowly: a nail into a sponge."""


def speed_of(d: Discourse, f: Frame, actors: list[str], mode: str) -> tuple[Quantity | None, bool]:
    """The speed that a motion starts with [cm/s], and whether the prompt states it."""
    found = quantity_of(d, f, "speed")
    told = [d.moves.own_speed[x] for x in actors if x in d.moves.own_speed]
    told += [found[1]] if found is not None else []
    told += [d.moves.stated[x] for x in actors if x in d.moves.stated]
    if not told:
        if f.verb.lemma == PRESSES:
            return SPEEDS["press"], False
        kind = kind_of(d, actors[0]) if actors else "ball"
        wings = bool(actors) and flies_itself(d, actors[0]) and f.verb.lemma not in gaits()
        afoot = kind in LIVING and not (wings or d.moves.flying & {*actors})
        if afoot and (legs := on_legs(entity_of(d, actors[0]), f.verb.lemma)) is not None:
            return legs, False
        launched = mode in LAUNCHES and kind not in ("billiard", "projectile")
        if not launched and actors and kind != "flyer" and _floats(d, actors[0]):
            kind = "floater"
        return SPEEDS[mode] if launched else SPEEDS.get(kind, (50.0, 600.0)), False
    a = told[0]
    mark_used(d, a, "speed")
    if a.bound == "min":
        return (a.low, 2.0 * a.low), True
    if a.bound == "max":
        return (0.04 * a.high, a.high), True
    return a.value, True


def flies_itself(d: Discourse, actor: str) -> bool:
    """Whether it stays in the air by its own power: aircraft, birds, winged insects."""
    e = entity_of(d, actor)
    winged = e.noun.material == "feather" or e.label.rpartition(" ")[2] in _WINGED
    if _floats(d, actor):
        return True
    return e.noun.kind == "flyer" or (e.noun.kind == "animal" and winged)


def _floats(d: Discourse, actor: str) -> bool:
    return entity_of(d, actor).label.rpartition(" ")[2] in _FLOATERS


def can_roll(d: Discourse, actor: str) -> bool:
    """Whether it is round about some axis: balls, and coins, barrels, pencils and tyres."""
    noun = entity_of(d, actor).noun
    shaped = noun.shape in ("cylinder", "capsule") and noun.kind not in SELF_POWERED
    return shaped or bool({"round", "rolls"} & noun.traits)


def direction_of(d: Discourse, actor: str, mode: str) -> ForceDirection:
    flies = kind_of(d, actor) == "flyer" or actor in d.moves.flying
    if mode in ("throw", "drop", "fly") or flies:
        return ForceDirection.ANY_3D
    if mode in LAUNCHES:
        return ForceDirection.HORIZONTAL_PLANE
    return ForceDirection.ALONG_FORWARD_ONLY


def _launch(
    d: Discourse,
    actor: str,
    mode: str,
    speed: Quantity | None,
    prescribed: bool,
    target: str | None = None,
) -> None:
    params: dict[str, object] = {}
    if mode == "throw" or mode == "fly":
        params = {"elevation_deg": (-10.0, 60.0), "spin": "none"}
    elif mode == "drop":
        params, speed = {"elevation_deg": -90.0, "spin": "none"}, 0.0
    elif mode == "roll":
        params = {"spin": "roll" if can_roll(d, actor) else "slide"}
    elif mode == "slide":
        params = {"spin": "slide"}
    d.timeline.move(
        actor, Motion(mode, speed, prescribed, target, params), direction_of(d, actor, mode)
    )


def wait(d: Discourse, actor: str) -> None:
    """Stands still for the stated time before the motion that is about to start."""
    amount = d.moves.waiting.pop(actor, None)
    track = d.timeline.track(actor)
    if actor in d.moves.patient and amount is None and track.motion is None:
        d.moves.patient.discard(actor)
        _stand(d, actor, None, d.timeline.last_event, f"{actor} has waited")
        return
    if amount is None or (track.motion is not None and not track.closed):
        return
    since = track.at
    if since != START and d.timeline.node(since) is None:
        return
    begin = None if since == START else since
    node = _stand(d, actor, amount.value, begin, f"{actor} has waited {amount.text}")
    mark_used(d, amount, f"time of {node}")


def sets_off_late(d: Discourse, f: Frame, actors: list[str]) -> None:
    """ "After 3 s it drives off", "starts to roll at 2 s": it stands still until then."""
    begins = f.verb.lemma in SETS_OFF or f.verb.extra.get("start")
    met = role(f, "obstacle") is not None
    time = time_of(d, f) if begins and not met else None
    for actor in actors:
        track = d.timeline.track(actor)
        if time is None or track.motion is not None or not movable(d, actor):
            continue
        since = track.at if track.at != START else d.timeline.last_event
        if time[2] == "at" or on_its_own(d, f, (actor,), time):
            since = None
        _stand(d, actor, time[0], since, f"{actor} sets off")
        mark_used(d, time[1], "when it sets off")


def told_after(d: Discourse, f: Frame) -> list[Frame]:
    """Earlier clauses that words put a clause after, whoever acts in them.

    "When the ball hits the box, the dog runs away", "and then a dog crosses".
    """
    if f.link == "cause":
        return causes_of(d, f)
    if f.link != "then" or f.relative or f.reduced or f not in d.told:
        return []
    earlier = [g for g in d.told[: d.told.index(f)] if not g.unreal and not g.reduced]
    if not earlier:
        return []
    last = earlier[-1]
    named = [g for g in earlier if g.main is f and g.subordinate in _ONCE]
    if any(on_the_way_with(f, g) for g in named):
        return []
    if named or f.subordinate == "before":
        return named or [last]
    begin = last.verb.end if last.verb.end < f.verb.start else f.verb.start
    between = d.text[begin : f.verb.end].lower().replace(",", " ")
    words = {*between.split(), *f.adverbs}
    return earlier if words & THEN or re.search(AFTER_THAT, between) else []


def on_the_way_with(f: Frame, g: Frame) -> bool:
    """ "Follows a van when the van brakes": who follows is on the way by then."""
    after = [p.mention for p in f.phrases if p.prep in _BEHIND]
    ahead = {i for m in (f.object, *after) if m is not None for i in m.entities}
    who = {*g.subject.entities} if g.subject is not None else set[str]()
    follows = f.verb.sense == "follow" or any(after)
    then = f.verb.start < g.verb.start and g.verb.sense in _CHECKS
    return follows and then and bool(who & ahead)


def causes_of(d: Discourse, f: Frame) -> list[Frame]:
    """ "An apple falls on a board, making a nut jump": the clause that tells the cause."""
    told = [g for g in d.told if not g.unreal and not g.reduced and g.verb.start < f.verb.start]
    cause = f.causer
    if cause is not None and cause.verb.sense in CAUSE_SENSES:
        own = [g for g in told if g.sentence == f.sentence and g.verb.start < cause.verb.start]
        cause = cause.causer or next(reversed(own), None)
    elif cause is None and f.subordinate == "so":
        cause = next(reversed(told), None)
    lets = f.causer is not None and f.causer.verb.lemma == "let"
    if cause is None or lets or cause.unreal or cause.verb.negated or cause is f:
        return []
    return [] if f.subject is cause.subject else [cause]


def comes_after(d: Discourse, f: Frame) -> list[Frame]:
    """Those clauses, and of the same doer the one before ("drops it and runs")."""
    named = told_after(d, f)
    if named or f.link != "then" or f.relative or f.reduced or f not in d.told:
        return named
    earlier = [g for g in d.told[: d.told.index(f)] if not g.unreal and not g.reduced]
    if not earlier:
        return []
    last = earlier[-1]
    doer, before = ([*m.entities] if m is not None else [] for m in (f.subject, last.subject))
    return [last] if doer and doer == before and last.link == "then" else []


def hold_back(d: Discourse) -> None:
    """Lets those wait whose first motion comes after what others do, as far as that is an event."""
    moved: set[str] = set()
    for c in d.scene.clauses:
        fresh = [m for m in c.movers if m not in moved]
        moved |= {*fresh}
        for actor in fresh if c.frame.verb.sense == "hit" else []:
            d.moves.held_back.setdefault(actor, told_after(d, c.frame))
    for actor, clauses in d.moves.held_back.items():
        verbs = {id(g.verb) for g in clauses}
        events = [d.timeline.node(n) for g, n in d.times.of_frame if id(g.verb) in verbs]
        others = [n for n in events if n is not None and actor not in n.participants]
        if others:
            d.timeline.hold(actor, others[-1].id)


def _stand(
    d: Discourse, actor: str, until: Quantity | None, since: str | None, description: str
) -> str:
    """Stands still for a time since an event, or until a time since the start, if one is said."""
    d.timeline.move(actor, Motion("own", 0.0), direction_of(d, actor, "own"))
    node = d.timeline.trigger(actor, description)
    draft = d.timeline.node(node)
    if until is None:
        if draft is not None and since is not None:
            draft.after.append(since)
    elif draft is not None and since is None:
        draft.time, draft.time_prescribed = until, True
    else:
        constrain(draft, "time_since", until, actor, since)
    return node


def own(
    d: Discourse, actor: str, speed: Quantity | None, prescribed: bool, target: str | None = None
) -> None:
    wait(d, actor)
    d.timeline.move(actor, Motion("own", speed, prescribed, target), direction_of(d, actor, "own"))


def hover(d: Discourse, actor: str) -> None:
    """ "Hovers above a table", "floats in the air": its motors hold it where it is."""
    d.moves.hovering.add(actor)
    d.moves.flying.add(actor)
    own(d, actor, 0.0, False)


def start_motion(
    d: Discourse, f: Frame, actors: list[str], mode: str | None = None, target: str | None = None
) -> None:
    for actor in actors:
        if not movable(d, actor):
            continue
        if hanging(d, [actor]):
            let_go(d, f, [actor])
            continue
        chosen = mode or natural(d, actor)
        chosen = "own" if f.verb.lemma == PRESSES else chosen
        chosen = "roll" if chosen == "slide" and called_rolling(d, actor) else chosen
        if f.verb.lemma in _IN_THE_AIR and flies_itself(d, actor):
            d.moves.flying.add(actor)
        speed, prescribed = speed_of(d, f, [actor], chosen)
        if chosen in LAUNCHES:
            _launch(d, actor, chosen, speed, prescribed, target)
        else:
            own(d, actor, speed, prescribed, target)


def each_passed(f: Frame, o: list[str]) -> list[str]:
    """What is passed one by one: "a bus and a van", "both"; of a plural its first member."""
    m = f.object
    if m is None or f.verb.passive:
        return o[:1]
    if m.pronoun in ("both", "each") or m.determiner in ("both", "each"):
        return o[:3]
    named = [x.entities[0] for x in (m, *m.coordinated) if x.entities and not x.attribute]
    listed = [i for i in dict.fromkeys(named) if i in o]
    if m.count == len(o) <= 3:
        return o  # "overtakes two trucks"
    return listed if m.coordinated and len(listed) > 1 else o[:1]


def natural(d: Discourse, actor: str) -> str:
    kind = kind_of(d, actor)
    if kind in SELF_POWERED:
        return "own"
    if kind in _AIRBORNE:
        return "throw"
    return "roll" if "round" in entity_of(d, actor).noun.traits else "slide"


def called_rolling(d: Discourse, actor: str) -> bool:
    """ "A rolling can hits a candle": it is round about some axis, too."""
    return ROLLING in entity_of(d, actor).adjectives and can_roll(d, actor)


def target_of(d: Discourse, f: Frame, avoid: list[str]) -> list[str]:
    """What a motion is aimed at."""
    return [i for i in filling(f, "aim") if i not in avoid]


def motion(d: Discourse, f: Frame, actors: list[str], mode: str | None) -> None:
    """Common part of all self motion: speed, target, and what the phrases say happens."""
    jolted_off(d, f, actors)
    _hovered_before(d, f, actors)
    fresh = [a for a in actors if at_rest(d, a)]
    under = moves_on_it(d, f, fresh)
    d.moves.on_top.update((a, under[0]) for a in fresh if under)
    actors = mounts_of(d, f, actors)
    speeds = [a for _, a in amounts_of(d, f) if a.dimension == "speed"]
    if len(speeds) == len(actors) > 1:
        d.moves.own_speed = dict(zip(actors, speeds, strict=True))
    if not actors:
        d.scene.warnings.append(
            f'It is not clear what "{d.text[f.verb.start : f.verb.end]}" moves.'
        )
        return
    fresh = [a for a in actors if at_rest(d, a)]
    aim = next((t for t in target_of(d, f, actors) if aimable(d, t) and t not in under), None)
    _leaves_from(d, f, fresh)
    sets_off_late(d, f, actors)
    d.moves.held_back.update((a, comes_after(d, f)) for a in fresh)
    meet = len(actors) == 2 and "each other" in f.adverbs and _toward_each_other(d, f)
    for actor, other in zip(actors, reversed(actors), strict=True):
        its = other if meet else aim
        if its is not None:
            d.moves.aim[actor] = its
        _moves_on(d, f, actor, mode, its)
    if speeds and all(moved_by_others(d, a) for a in actors):
        speed_after(d, actors[0], speeds[0])
    elif speeds and len(actors) == 1:
        _speed_told_late(d, f, actors[0], speeds[0])
    mark_used(d, f, "motion")
    distance(d, f, actors, aim)
    if "off" in f.adverbs:
        _comes_off(d, f, actors, fresh)
    _lasts_for(d, f, actors)
    d.outcomes(f, actors)


def _hovered_before(d: Discourse, f: Frame, actors: list[str]) -> None:
    """ "Hovers, then flies away": it holds its height until then."""
    for actor in actors:
        track = d.timeline.tracks.get(actor)
        motion_ = track.motion if track is not None else None
        if track is not None and motion_ is not None and motion_.speed == 0.0:
            d.add_event(NodeEvent.TRIGGER, (actor,), f, time_of(d, f))
            track.motion = None


def jolted_off(d: Discourse, f: Frame, actors: list[str]) -> None:
    """ "A cart hits a wall and the box slides off": by what stopped the cart, and not by itself."""
    off = {"off", "out", "down"} & {*f.adverbs} or f.phrase("off", "out of", "from") is not None
    for actor in actors if off else []:
        host = d.scene.supported_by.get(actor) or d.scene.inside_of.get(actor, "")
        last = last_of(d, host)
        met = last is not None and last.event is NodeEvent.COLLISION
        met = met and last is not None and last.participants[0] == host
        if last is not None and met and kind_of(d, actor) not in LIVING and at_rest(d, actor):
            d.timeline.carry(actor, last.id)


def _toward_each_other(d: Discourse, f: Frame) -> bool:
    said = d.text[f.verb.end : f.verb.end + 40].lower()
    return said.strip().startswith(("toward each other", "towards each other"))


def _leaves_from(d: Discourse, f: Frame, fresh: list[str]) -> None:
    """ "A dog runs from a chair to a table": it starts by the one, a bird on a roof."""
    hidden = f.phrase("out from behind")
    for host in [h for h in things(hidden) if aimable(d, h) and _said_behind(d, hidden)][:1]:
        place(d, [a for a in fresh if a != host], [host], "behind")
    p = f.phrase("from")
    if p is None or p.mention is None:
        return
    for host in [h for h in things(p) if aimable(d, h)][:1]:
        for actor in fresh:
            own_way = kind_of(d, actor) in SELF_POWERED and actor not in d.scene.supported_by
            perched = flies_itself(d, actor) and elevated(d, host) and carries(d, host, actor)
            if own_way and host != actor and (perched or not p.mention.part):
                place(d, [actor], [host], "on" if perched else "near")


def _said_behind(d: Discourse, p: Phrase | None) -> bool:
    """ "Out from behind a van", and not "out from under a table"."""
    return p is not None and p.mention is not None and " behind " in d.text[: p.mention.start][-14:]


def moves_on_it(d: Discourse, f: Frame, fresh: list[str]) -> list[str]:
    """ "A ball rolls on a table", "drives out on the pier": it is on that from the start."""
    on = None if f.verb.lemma in _COMES_ONTO else _what_carries(f)
    if on is None or _crosses_the_floor(d, f):
        return []
    hosts = [h for h in things(on) if aimable(d, h) and all(carries(d, h, a) for a in fresh)]
    if not fresh or not hosts or any(a in d.scene.supported_by for a in fresh):
        return [h for h in hosts if all(d.scene.supported_by.get(a) == h for a in fresh)]
    place(d, fresh, hosts, "on")
    return hosts[:1]


def _crosses_the_floor(d: Discourse, f: Frame) -> bool:
    """ "Rolls across the floor past a lamp on a table": the lamp is on the table."""
    floors = [i for p in f.phrases if p.prep in ("across", "along") for i in things(p)]
    return GROUND in floors


def mounts_of(d: Discourse, f: Frame, actors: list[str]) -> list[str]:
    """ "A man on a bicycle rides": what those who ride are on, else they themselves."""
    mounted = [d.scene.supported_by.get(a, "") for a in actors]
    riding = all(m and kind_of(d, m) in SELF_POWERED | {"sliding"} for m in mounted)
    if not actors or not riding or kind_of(d, actors[0]) != "person":
        return actors
    if f.subject is not None:
        d.refs.mounts[id(f.subject)] = list(dict.fromkeys(mounted))
    return list(dict.fromkeys(mounted))


def _moves_on(d: Discourse, f: Frame, actor: str, mode: str | None, aim: str | None) -> None:
    """Starts a motion, or tells more of one that is under way."""
    if moved_by_others(d, actor) and (mode != "own" or kind_of(d, actor) not in SELF_POWERED):
        return
    track = d.timeline.tracks.get(actor)
    now = track.motion if track is not None else None
    if track is not None and now is not None and track.launched and mode in (None, *LAUNCHES):
        if not track.closed and quantity_of(d, f, "speed") is not None:
            now.speed, now.prescribed = speed_of(d, f, [actor], now.mode)
        if not track.closed and aim is not None:
            now.target = aim
        return
    goes_on = now is not None and f.verb.extra.get("continue") and not _just_hit(d, actor)
    # "brakes, skids for 2 s": sliding on locked wheels is how it brakes
    skids = now is not None and f.verb.sense == "slide" and now.mode == "brake"
    if not goes_on and not skids:
        start_motion(d, f, [actor], mode, aim)


def _just_hit(d: Discourse, actor: str) -> bool:
    """ "Hits a cone and keeps going": what drives, and whose motion ended at what it hit."""
    told = [n for n in d.timeline.nodes if actor in n.participants]
    hit = bool(told) and told[-1].event is NodeEvent.COLLISION and told[-1].participants[0] == actor
    return hit and kind_of(d, actor) in SELF_POWERED


def _comes_off(d: Discourse, f: Frame, actors: list[str], fresh: list[str]) -> None:
    """ "bumps the shelf; two candles roll off": they fall from what they stand or lie on."""
    if f.verb.sense in ("roll", "slide") and f.phrase("off", "from") is None:
        on_what_was_hit(d, f, fresh)
    for actor in actors:
        if f.verb.sense in ("fly", "own") and flies_itself(d, actor):
            continue
        came = actor in d.moves.came_down and f.verb.lemma in ("roll", "tumble")
        slid = f.verb.lemma in ("slide", "slip") or came
        held = actor in d.scene.supported_by or entity_of(d, actor).pattern == "stack"
        held = held or (actor in fresh and _tipped(d, actor))
        if held or (slid and lies_on_something(d, actor) and not _goes_a_way(f)):
            d.add_event(NodeEvent.FALL, (actor,), f, time_of(d, f))


def _lasts_for(d: Discourse, f: Frame, actors: list[str]) -> None:
    """ "rolls for 2 s": how long the motion lasts."""
    duration = next((a for p, a in amounts_of(d, f) if lasts(p, a)), None)
    if duration is None:
        return
    for actor in actors:
        track = d.timeline.tracks.get(actor)
        motion = track.motion if track is not None else None
        falls = f.verb.sense in ("fall", "drop")
        if motion is None or motion.mode in ("brake", "coast") or falls:
            d.times.gap, d.times.gap_of = duration, f  # "brakes, skids for 2 s and slams into"
        else:
            motion.duration = duration.value
    mark_used(d, duration, "duration")


def lasts(prep: str, a: Amount) -> bool:
    """Whether a time says how long a motion lasts: "for", "over", "during the first 2 s"."""
    first = a.text.lower().startswith(("for the", "during the", "over", "through"))
    return a.dimension == "time" and (prep == "for" or first)


def _speed_told_late(d: Discourse, f: Frame, actor: str, amount: Amount) -> None:
    """ "Two balls collide; the left one moves at 3 m/s": how fast it came."""
    if not unread(d, amount) or f.link != "then" or f.phrases[1:]:
        return
    plain = f.verb.lemma in ("move", "travel", "go", "drive", "roll", "slide", "come")
    edges = [e for e in d.timeline.edges if e.actor == actor]
    if not plain or f.adverbs or len(edges) != 1 or edges[0].speed_is_prescribed:
        return
    d.timeline.set_speed(actor, amount.value, prescribed=True)
    mark_used(d, amount, "speed")


def _goes_a_way(f: Frame) -> bool:
    """ "Slides off to the right": which way it goes on, not what it comes off."""
    sides = (p.mention.head for p in f.phrases if p.prep == "to" and p.mention is not None)
    return bool({*sides, *f.adverbs} & {"left", "right", "out of view"})


def lies_on_something(d: Discourse, actor: str) -> bool:
    """Whether it came to lie on what it last touched ("drops it on a cube. It slides off")."""
    last = last_of(d, actor)
    return last is not None and last.event is NodeEvent.COLLISION


def _tipped(d: Discourse, actor: str) -> bool:
    """ "The seesaw tips and a boy slides off": from what has just toppled."""
    last = last_event(d)
    if last is None or last.event is not NodeEvent.TOPPLE or actor in last.participants:
        return False
    host = last.participants[0]
    if fits_on(d, actor, host):
        place(d, [actor], [host], "on")
    return kind_of(d, host) not in LIVING


def on_what_was_hit(d: Discourse, f: Frame, things: list[str]) -> None:
    """ "pushed into a shelf, causing three jars to fall down": they stood on the shelf."""
    if d.moves.last_hit is None or not (
        {"down", "off"} & {*f.adverbs, f.verb.extra.get("particle", "")}
    ):
        return
    host = d.moves.last_hit[1]
    for t in things:
        fits = host in d.world.entities and fits_on(d, t, host)
        if fits and t not in d.scene.supported_by and t not in d.moves.last_hit:
            place(d, [t], [host], "on")


def reverse(d: Discourse, actors: list[str]) -> None:
    for actor in actors:
        if not movable(d, actor):
            continue
        track = d.timeline.track(actor)
        if track.motion is None:
            own(
                d,
                actor,
                SPEEDS.get(kind_of(d, actor), (50.0, 400.0)),
                False,
                d.moves.aim.get(actor),
            )
        if track.direction in (None, ForceDirection.ALONG_FORWARD_ONLY):
            track.direction = ForceDirection.ALONG_FORWARD_OR_BACKWARD
        if track.motion is not None and (track.at == START or not track.closed):
            track.motion.params["backward"] = True
            if not track.motion.prescribed and track.motion.speed is not None:
                track.motion.speed = paced(track.motion.speed, "slow")


def paced(speed: Quantity, pace: str) -> Quantity:
    """The part of a range of speeds that a word such as "slowly" leaves [cm/s]."""
    if not isinstance(speed, tuple):
        return speed
    low, high = speed
    least, more, most, wider = _PACES[pace]
    wide, slowest = high - low, min(low, _SLOWEST_CM_S)
    first = max(least * low + more * wide, slowest)
    return (round(first, 4), round(max(most * low + wider * wide, min(1.4 * first, high)), 4))


def _what_carries(f: Frame) -> Phrase | None:
    """The phrase of what a clause goes on: on it, on top of it, or across it from end to end."""
    top = next((p for p in f.phrases if p.mention and p.mention.part in _TOPS), None)
    if top is not None and top.prep in (*_CARRYING, "along", "across"):
        return top
    on = f.phrase(*_CARRYING) or f.phrase("from")
    if on is None:
        return None
    part = on.mention.part.split()[-1:] if on.mention is not None else []
    if on.prep != "from":
        return None if part else on
    ends = part in (["side"], ["end"], ["edge"])
    return on if ends and f.phrase("to") is not None else None  # "from one end to the other"
