"""Motions: how fast, in which way and towards what an actor starts to move."""

from __future__ import annotations

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
from esg.draft.discourse.places import fits_on, place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import SELF_POWERED, SPEEDS, Relation
from esg.draft.discourse.timeline import LAUNCHES, START
from esg.draft.discourse.tracks import Motion
from esg.draft.events.leftovers import SETS_OFF
from esg.draft.events.lengths import distance
from esg.draft.events.timing import is_airborne, moved_by_others, speed_after, time_of
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount
from esg.graph.models import EventConstraint, ForceDirection, NodeEvent, Quantity

_AIRBORNE = lex.word_set("airborne")


_TALL_CM = 50.0

_IN_THE_AIR = lex.word_set("in the air")
_ON_WHEELS = lex.word_set("on wheels")
_WITH_OFF = lex.word_set("with off")
_WINGED = lex.word_set("winged")


def speed_of(d: Discourse, f: Frame, actors: list[str], mode: str) -> tuple[Quantity | None, bool]:
    found = quantity_of(d, f, "speed")
    own = next((d.moves.own_speed[x] for x in actors if x in d.moves.own_speed), None)
    if own is not None:
        found = ("at", own)
    stated = next((d.moves.stated[x] for x in actors if x in d.moves.stated), None)
    if found is None and stated is not None:
        found = ("at", stated)
    if found is not None:
        mark_used(d, found[1], "speed")
        a = found[1]
        falling = f.verb.sense in ("brake", "slow", "stop")
        if falling and a.low < a.high and a.text.lower().startswith("from"):
            return a.high, True  # "brakes from 15 m/s to 5 m/s"
        if a.bound == "min":
            return (a.low, 2.0 * a.low), True
        if a.bound == "max":
            return (0.04 * a.high, a.high), True
        return a.value, True
    kind = kind_of(d, actors[0]) if actors else "ball"
    if mode in LAUNCHES:
        if kind in ("billiard", "projectile"):
            return SPEEDS[kind], False
        return SPEEDS[mode], False
    return SPEEDS.get(kind, (50.0, 600.0)), False


def flies_itself(d: Discourse, actor: str) -> bool:
    """Whether it stays in the air by its own power: aircraft, birds, winged insects."""
    e = entity_of(d, actor)
    winged = e.noun.material == "feather" or e.label.rpartition(" ")[2] in _WINGED
    return e.noun.kind == "flyer" or (e.noun.kind == "animal" and winged)


def direction_of(d: Discourse, actor: str, mode: str) -> ForceDirection:
    flies = kind_of(d, actor) == "flyer" and actor not in d.moves.taxiing
    if mode in ("throw", "drop", "fly") or flies or actor in d.moves.flying:
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
        noun = entity_of(d, actor).noun  # coins, barrels and tyres roll on their rim
        rolls = "round" in noun.traits or noun.shape == "cylinder"
        params = {"spin": "roll" if rolls else "slide"}
    elif mode == "slide":
        params = {"spin": "slide"}
    d.timeline.move(
        actor, Motion(mode, speed, prescribed, target, params), direction_of(d, actor, mode)
    )


def wait(d: Discourse, actor: str) -> None:
    """Stands still for the stated time before the motion that is about to start."""
    amount = d.moves.waiting.pop(actor, None)
    track = d.timeline.track(actor)
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
    if f.verb.lemma in _WITH_OFF:  # not "after 3 s a car drives into a wall"
        words = {*d.text[f.verb.start : f.verb.end].lower().split(), *f.adverbs}
        begins = bool(words & {"off", "away", "out", "again", "on"})
    met = f.phrase("into", "against", "onto") is not None
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


def _stand(d: Discourse, actor: str, until: Quantity, since: str | None, description: str) -> str:
    """Stands still for a time since an event, or until a time since the start."""
    d.timeline.move(actor, Motion("own", 0.0), direction_of(d, actor, "own"))
    node = d.timeline.trigger(actor, description)
    draft = d.timeline.node(node)
    assert draft is not None
    if since is None:
        draft.time, draft.time_prescribed = until, True
    else:
        draft.constraints.append(
            EventConstraint(quantity="time_since", object=actor, value=until, since=since)
        )
    return node


def own(
    d: Discourse, actor: str, speed: Quantity | None, prescribed: bool, target: str | None = None
) -> None:
    wait(d, actor)
    d.timeline.move(actor, Motion("own", speed, prescribed, target), direction_of(d, actor, "own"))


def start_motion(
    d: Discourse, f: Frame, actors: list[str], mode: str | None = None, target: str | None = None
) -> None:
    for actor in actors:
        if not movable(d, actor):
            continue
        chosen = mode or natural(d, actor)
        if f.verb.lemma in _IN_THE_AIR and flies_itself(d, actor):
            d.moves.flying.add(actor)
        elif f.verb.lemma in _ON_WHEELS and actor not in d.moves.flying:
            d.moves.taxiing.add(actor)
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
    return listed if m.coordinated and len(listed) > 1 else o[:1]


def natural(d: Discourse, actor: str) -> str:
    kind = kind_of(d, actor)
    if kind in SELF_POWERED:
        return "own"
    if kind in _AIRBORNE:
        return "throw"
    return "roll" if "round" in entity_of(d, actor).noun.traits else "slide"


def target_of(d: Discourse, f: Frame, avoid: list[str]) -> list[str]:
    p = f.phrase("towards", "toward", "at", "to", "into", "onto", "against", "after", "on", "in")
    if p is None or p.mention is None:
        return []
    return [i for i in p.mention.entities if i not in avoid]


def motion(d: Discourse, f: Frame, actors: list[str], mode: str | None) -> None:
    """Common part of all self motion: speed, target, and what the phrases say happens."""
    mounted = [d.scene.supported_by.get(a, "") for a in actors]
    riding = all(m and kind_of(d, m) in SELF_POWERED | {"sliding"} for m in mounted)
    if actors and riding and kind_of(d, actors[0]) == "person":
        actors = list(dict.fromkeys(mounted))  # "a man on a bicycle rides"
        if f.subject is not None:
            d.refs.mounts[id(f.subject)] = actors
    speeds = [a for _, a in amounts_of(d, f) if a.dimension == "speed"]
    if len(speeds) == len(actors) > 1:
        d.moves.own_speed = dict(zip(actors, speeds, strict=True))
    if not actors:
        d.scene.warnings.append(
            f'It is not clear what "{d.text[f.verb.start : f.verb.end]}" moves.'
        )
        return
    target = target_of(d, f, actors)
    aim = next((t for t in target if aimable(d, t)), None)
    sets_off_late(d, f, actors)
    told = [(a, d.timeline.tracks.get(a)) for a in actors]
    fresh = [a for a, t in told if t is None or (t.motion is None and not t.hit)]
    for actor in actors:
        if aim is not None:
            d.moves.aim[actor] = aim
        if moved_by_others(d, actor) and (mode != "own" or kind_of(d, actor) not in SELF_POWERED):
            continue
        track = d.timeline.tracks.get(actor)
        if (
            track is not None
            and track.launched
            and track.motion is not None
            and mode in (None, *LAUNCHES)
        ):
            stated = quantity_of(d, f, "speed")
            if stated is not None and not track.closed:
                track.motion.speed, track.motion.prescribed = speed_of(
                    d, f, [actor], track.motion.mode
                )
            if aim is not None and not track.closed:
                track.motion.target = aim
            continue
        if f.verb.extra.get("continue") and track is not None and track.motion is not None:
            continue
        if track is not None and _skids(d, f, actor):
            continue
        start_motion(d, f, [actor], mode, aim)
    found = quantity_of(d, f, "speed")
    if found is not None and actors and all(moved_by_others(d, a) for a in actors):
        speed_after(d, actors[0], found[1])
    elif found is not None and len(actors) == 1:
        _speed_told_late(d, f, actors[0], found[1])
    _order_of(d, f, actors)
    mark_used(d, f, "motion")
    distance(d, f, actors, aim)
    if "off" in f.adverbs:
        if f.verb.sense in ("roll", "slide") and f.phrase("off", "from") is None:
            on_what_was_hit(d, f, fresh)  # "bumps the shelf; two candles roll off"
        for actor in actors:
            slid = f.verb.lemma in ("slide", "slip") and lies_on_something(d, actor)
            came = actor in d.moves.came_down and f.verb.lemma in ("roll", "tumble")
            slid = slid or (came and lies_on_something(d, actor))
            held = actor in d.scene.supported_by or entity_of(d, actor).pattern == "stack"
            held = held or (actor in fresh and _tipped(d, actor))
            if held or slid:
                d.add_event(NodeEvent.FALL, (actor,), f, time_of(d, f))
    duration = next((a for p, a in amounts_of(d, f) if lasts(p, a)), None)
    if duration is not None:
        for actor in actors:
            track = d.timeline.tracks.get(actor)
            motion = track.motion if track is not None else None
            falls = f.verb.sense in ("fall", "drop")
            if motion is None or motion.mode in ("brake", "coast") or falls:
                d.times.gap, d.times.gap_of = duration, f  # "brakes, skids for 2 s and slams into"
                continue
            motion.duration = duration.value
        mark_used(d, duration, "duration")
    d.outcomes(f, actors)


def lasts(prep: str, a: Amount) -> bool:
    """Whether a time says how long a motion lasts: "for", "over", "during the first 2 s"."""
    first = a.text.lower().startswith(("for the", "during the", "over", "through"))
    return a.dimension == "time" and (prep == "for" or first)


def _skids(d: Discourse, f: Frame, actor: str) -> bool:
    """ "brakes, skids for 2 s": sliding on locked wheels is how it brakes."""
    motion = d.timeline.track(actor).motion
    return f.verb.sense == "slide" and motion is not None and motion.mode == "brake"


def _speed_told_late(d: Discourse, f: Frame, actor: str, amount: Amount) -> None:
    """ "Two balls collide; the left one moves at 3 m/s": how fast it came."""
    if (amount.start, amount.end) in d.scene.used or f.link != "then" or f.phrases[1:]:
        return
    plain = f.verb.lemma in ("move", "travel", "go", "drive", "roll", "slide", "come")
    edges = [e for e in d.timeline.edges if e.actor == actor]
    if not plain or f.adverbs or len(edges) != 1 or edges[0].speed_is_prescribed:
        return
    d.timeline.set_speed(actor, amount.value, prescribed=True)
    mark_used(d, amount, "speed")


def lies_on_something(d: Discourse, actor: str) -> bool:
    """Whether it came to lie on what it last touched ("drops it on a cube. It slides off")."""
    last = next((n for n in reversed(d.timeline.nodes) if actor in n.participants), None)
    return last is not None and last.event is NodeEvent.COLLISION


def _order_of(d: Discourse, f: Frame, actors: list[str]) -> None:
    """ "a bus and a taxi drive with the taxi ahead"."""
    p = f.phrase("with")
    if p is None or p.mention is None or len(actors) < 2:
        return
    for side, kind in (
        ("ahead", "in_front_of"),
        ("behind", "behind"),
        ("in front", "in_front_of"),
    ):
        if side in f.adverbs:
            for one in p.mention.entities:
                for other in actors:
                    if other != one:
                        d.scene.relations.append(Relation(one, other, kind))


def _tipped(d: Discourse, actor: str) -> bool:
    """ "The seesaw tips and a boy slides off": from what has just toppled."""
    last = d.timeline.node(d.timeline.last_event or "")
    tipped = last is not None and last.event is NodeEvent.TOPPLE
    if not tipped or last is None or actor in last.participants:
        return False
    host = last.participants[0]
    if fits_on(d, actor, host):
        place(d, [actor], [host], "on")
    return kind_of(d, host) not in ("person", "animal")


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


def stands(d: Discourse, f: Frame, body: str) -> bool:
    """Whether something tall stands or leans on the ground, where it can only tip over."""
    e = entity_of(d, body)
    tall = (e.dimensions_cm or e.noun.dimensions_cm)[2] >= _TALL_CM
    held = body in d.scene.supported_by or body in d.scene.attached
    down = f.phrase("off", "from", "out of", "over") is not None or "off" in f.adverbs
    lifted = body in d.scene.heights or is_airborne(d, body)
    in_row = e.pattern == "row" and e.group is not None and not (held or down or lifted)
    if in_row and moved_by_others(d, body):
        return True  # "hits the first of a row of books, which fall one after another"
    upright = body in d.moves.leaning or ("topples" in e.noun.traits and tall)
    return upright and not (held or down or lifted)


def speed_of_noun(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "a mallet swung at 3 m/s", "a boat making 30 knots": the speed that nothing has read."""
    found = quantity_of(d, f, "speed")
    if found is None or not f.reduced or len(subject) != 1:
        return
    if (found[1].start, found[1].end) in d.scene.used:
        return
    edges = [e for e in d.timeline.edges if e.actor == subject[0]]
    if edges and not any(e.speed_is_prescribed for e in edges):
        d.timeline.set_speed(subject[0], found[1].value, prescribed=True)
        mark_used(d, found[1], "speed")
    elif not edges:
        d.moves.stated[subject[0]] = found[1]
