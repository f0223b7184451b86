"""From clause frames to objects, relations, motions and events."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.antecedents import STATES
from esg.draft.discourse.concurrence import one_time_each
from esg.draft.discourse.core import (
    aimable,
    amounts_of,
    entity_of,
    facts_of,
    ids_of,
    kind_of,
    mark_used,
    movable,
)
from esg.draft.discourse.dodging import dodge
from esg.draft.discourse.event_coreference import sentence
from esg.draft.discourse.jointed import behind_doors, loosen
from esg.draft.discourse.links import (
    comes_off,
    drop_link,
    held_by,
    is_link,
    let_loose,
    snapped,
    take_links,
)
from esg.draft.discourse.places import holds, place, share_tops
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.references import RIDDEN, refer_all
from esg.draft.discourse.referents.parts import has_counted_parts
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.referents.registry import apply_amount
from esg.draft.discourse.referents.thinghood import without
from esg.draft.discourse.scene import SELF_POWERED, Scene
from esg.draft.discourse.timeline import TimelineBuilder
from esg.draft.discourse.windows import Draft
from esg.draft.events.acts import add_event, outcomes
from esg.draft.events.courses import (
    by_its_participle,
    come_on,
    follow,
    snapshot,
)
from esg.draft.events.cupboards import out_of_a_cupboard
from esg.draft.events.denials import BY_NONE, falls_short, touches_none
from esg.draft.events.following import follow_on
from esg.draft.events.hanging import (
    SWAYING,
    UNMET,
    by_their_doors,
    closed_instead,
    hanging,
    named_parts,
    sense_on_joint,
    sprung_back,
    told_by_their_parts,
    turned_instead,
)
from esg.draft.events.motions import hold_back
from esg.draft.events.senses import SENSES
from esg.draft.events.senses.breaking import gone_through, sense_of_breaking, who_breaks
from esg.draft.events.senses.gestures import makes_gesture
from esg.draft.events.senses.outcome import target_of_mates
from esg.draft.events.senses.postures import takes_posture
from esg.draft.events.senses.state import attachment, mass_of_load, stands_there
from esg.draft.events.stated import CENTRE
from esg.draft.events.table import read_as
from esg.draft.events.timing import hand_on, precedes, settle, time_of
from esg.draft.events.together import come_down
from esg.draft.events.told import (
    at_rest,
    constrain,
    has_stopped,
    ignore,
    last_event,
    last_of,
    mates_of,
    moves,
    one_that,
    size_of,
    things,
    traits_of,
    unread,
)
from esg.draft.events.tops import join_on_top, keep_on, share_their_top
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.grammar.clauses.modality import NOBODY_DOES
from esg.draft.text.elements import Mention
from esg.graph.models import NodeEvent, Role
from esg.lexicon.senses import no_things

_IN_PLACE = lex.word_set("acts in place")
_ABOUT = frozenset({"slide", "roll", "own", "spin", "coast"})
_GONE_ROUND_IN = lex.word_set("gone round in")
_THINGS_DO = lex.word_set("things do")
_THINGS_DO_TO = lex.word_set("things do to")
_RIDERS_OWN = ("be", "posture", "weigh", "fall", "topple")
_BREAKING = lex.word_set("breaking (interpret)")
_INSTEAD = re.compile(r"\binstead\b(?! of)", re.IGNORECASE)
_BUT = re.compile(r"\b(?:but|yet)\b[^.;,]*$", re.IGNORECASE)
_AT_FIRST = re.compile(
    r"\b(?:first|initially|until|till|before|for|after|yet|while|when|at the start|beginning)\b",
    re.IGNORECASE,
)
_AT_ALL = re.compile(r"\s*(?:at all|an inch|from its place)\b(?!\s+until)", re.IGNORECASE)
_HITS = (NodeEvent.COLLISION,)
_HANDLED = {
    **dict.fromkeys((("posture", v) for v in lex.word_set("puts")), "put"),
    **dict.fromkeys((("carry", v) for v in lex.word_set("picks up")), "pick"),
    **dict.fromkeys((("own", v) for v in lex.word_set("jumps")), "jump"),
    ("carry", "lower"): "put",
    ("noop", "take"): "pick",
    ("noop", "remove"): "pick",
}
"""Verbs of states and motions that may tell of a hand, or of a leap, by sense and lemma."""
_NAMED_EVENTS = {
    **dict.fromkeys(("collision", "impact", "crash", "hit", "strike", "contact", "smash"), _HITS),
    **dict.fromkeys(("bump", "blow", "knock", "accident", "touch"), _HITS),
    "fall": (NodeEvent.FALL, NodeEvent.TOPPLE),
    "stop": (NodeEvent.STOP,),
    "turn": (NodeEvent.HEADING_REACHED,),
}
"""Nouns for events, and the point events they name."""
_ANIMAL_VERBS = lex.word_set("animal verbs")
_SINGLY = frozenset({"drop", "launch", "fall", "carry", "pick", "posture", "enter", "roll"})
_MOST_SINGLY = 5
"""Most members of a plural that are told to do something one by one, of which each does it."""
_SENT = frozenset({"launch", "drop", "scatter", "pocket"})
"""Senses of which only the object moves."""
_AGAINST = frozenset({"against", "into", "onto", "at", "past"})
_TWO_WHEELED = lex.word_set("two wheeled")
_CARRY_PEOPLE = frozenset({"cart", "elevator", "flyer", "sliding", "vehicle", "watercraft"})
"""Kinds and names of what people are in or on who go with it."""
_WAYS = frozenset({"along", "down", "up"})
"""What leads to the way that something takes: no place of a load."""
_SET_SWINGING = frozenset({"pull", "draw", "let", "release"})
_STUFF, _REFLEXIVE = lex.word_set("substances"), lex.word_set("reflexive")
_SLOWER_GAITS, _FASTER_GAITS = lex.word_set("gaits, slow"), lex.word_set("gaits, fast")

_PERSON_VERBS = lex.word_set("person verbs")
_BENDS, _LINES = lex.word_set("bends (shapes)"), frozenset({"row", "queue", "column"})
STRAIGHT = "it is drawn straight"
_VEHICLE_VERBS = lex.word_set("vehicle verbs")


def begin(world: World, text: str, mentions: list[Mention]) -> Discourse:
    """The discourse of a prompt of which nothing has been read yet."""
    for m in mentions:
        if without(m, text):
            m.count = 0  # "without a driver": nothing is drawn
    timeline = TimelineBuilder()

    def event(
        kind: NodeEvent, participants: tuple[str, ...], f: Frame, time: Time | None, **more: object
    ) -> str:
        return add_event(d, kind, participants, f, time, **more)

    d = Discourse(
        world=world,
        text=text,
        timeline=timeline,
        scene=Scene(world, timeline),
        mentions=mentions,
        told=[],
        attached=[],
        add_event=event,
        outcomes=lambda f, actors: outcomes(d, f, actors),
    )
    world.facts = partial(facts_of, d)
    return d


def interpret(
    d: Discourse, frames: list[Frame], attachments: list[tuple[Mention, Phrase]]
) -> Scene:
    """Walks over frames in order of time and fills the scene."""
    # references are resolved in the order of the text, events in the order of time
    d.told, d.attached = frames, attachments
    named = [m for m, p in attachments for m in (m, p.mention)]
    named += [m for f in frames for m in (f.subject, f.object, *(p.mention for p in f.phrases))]
    for m in named:
        if m is not None and has_counted_parts(m):
            ids_of(d, m)  # "the first ball of a Newton's cradle": there before its parts
    refer_all(d, frames)
    told_by_their_parts(d)
    named_parts(d)
    _on_what_has_it(d, frames, attachments)
    _acts_upon(frames)
    _loads(d)
    linked = take_links(d)
    loosen(d.scene, d.text)
    dodge(frames, d.text)
    goals = {id(p.mention) for f in frames for p in f.phrases if _is_goal(f, p)}
    for m, p in attachments:
        if p.mention is None or id(p.mention) not in goals | linked:
            attachment(d, m, p)
    come_on(d, frames)
    before = -1
    for f in frames:
        d.now.telling = (f.sentence, before, f.verb.sense)
        for g in one_time_each(f):
            join_on_top(d, g)
            read_frame(d, g)
        before = f.verb.start
    settle(d, None, None)
    share_their_top(d)
    share_tops(d)
    keep_on(d)
    hold_back(d)
    follow_on(d)
    for actor in d.moves.still:
        track = d.timeline.tracks.get(actor)
        if track is not None and track.role is Role.ACTIVE and actor in d.world.entities:
            label = entity_of(d, actor).label
            d.world.conflicts.append(f'"{label}" is said to move and not to move')
    for actor, amount in list(d.scene.travel.items()):
        if moves(d, actor):
            node = d.timeline.trigger(actor, f"{actor} has travelled {amount.text}")
            constrain(d.timeline.node(node), "distance", amount.value, actor)
        else:
            d.scene.used.pop((amount.start, amount.end), None)
    return d.scene


def _acts_upon(frames: list[Frame]) -> None:
    """ "Two toy cars collide in the middle of a table": they are on it, where is owned up to."""
    for f in frames:
        for p in f.phrases if f.verb.sense not in ("be", "posture", "noop") else ():
            noun = p.mention.noun if p.mention is not None else None
            if p.prep == CENTRE and noun is not None and "support" in noun.traits:
                p.prep = "on"


def _loads(d: Discourse) -> None:
    """ "A lorry's load of pipes": on the lorry, whatever becomes of it."""
    for m in d.mentions:
        owner = m.possessor.entities if m.possessor is not None and m.group_word == "load" else []
        if owner and m.entities and kind_of(d, owner[0]) in SELF_POWERED:
            place(d, m.entities, owner[:1], "on")


def _on_what_has_it(
    d: Discourse, frames: list[Frame], attachments: list[tuple[Mention, Phrase]]
) -> None:
    """ "Drops a tray with a cup on it": on the tray, and no place that the clause tells.

    "A cart with a box lying on it rolls" tells the same with a participle.
    """
    laden = {id(m) for m, p in attachments if p.mention is not None and p.mention.pronoun == "it"}
    for k, (m, p) in enumerate(attachments):
        if p.prep == "with" and id(p.mention) in laden:
            attachments[k] = (_who_takes_the_way(frames, m), p)
    owners = {id(p.mention): m for m, p in attachments if p.prep == "with"}
    for m, p in attachments:
        if p.prep == "with" and p.mention is not None:
            _lies_on_it(d, frames, m, p.mention)
    _put_aboard(d, frames, attachments)
    for m, p in attachments:
        owner = owners.get(id(m))
        if owner is None or p.mention is None:
            continue
        its = p.mention.determiner in lex.POSSESSIVES and bool(p.mention.entities)
        if its and {*p.mention.entities} <= {*m.entities}:
            p.mention.entities = d.world.resolved[id(p.mention)] = [*owner.entities]
            continue  # "a car with two bikes on its roof"
        if p.mention.pronoun not in ("it", "them"):
            continue
        if p.mention.pronoun == "them" and len(owner.entities) == 1:
            continue  # "a pot with a spoon beside it and a lemon in front of them"
        p.mention.entities = d.world.resolved[id(p.mention)] = [*owner.entities]
        for f in frames:
            f.phrases[:] = [q for q in f.phrases if q.mention is not p.mention]


def _put_aboard(
    d: Discourse, frames: list[Frame], attachments: list[tuple[Mention, Phrase]]
) -> None:
    """ "A boat with three people": they are in it."""
    placed = {id(m) for m, _ in attachments}
    for k, (m, p) in enumerate(attachments):
        had = p.mention if p.prep == "with" else None
        if had is not None and id(had) not in placed and _on_board(d, frames, m, had):
            on = m.noun is not None and m.noun.name in _TWO_WHEELED
            attachments[k] = (had, Phrase("on" if on else "in", m))


def _on_board(d: Discourse, frames: list[Frame], owner: Mention, had: Mention) -> bool:
    """Whether somebody goes with what carries people, and nothing else is told of him."""
    who, what = had.noun, owner.noun
    if who is None or what is None or who.kind != "person" or not had.entities:
        return False
    if what.kind not in _CARRY_PEOPLE and what.name not in _CARRY_PEOPLE:
        return False
    return not any(
        f.subject is had or (f.verb.start >= had.end and not d.text[had.end : f.verb.start].strip()
                             and f.verb.form == "ing")
        for f in frames
    )  # fmt: skip


def _lies_on_it(d: Discourse, frames: list[Frame], owner: Mention, had: Mention) -> None:
    """ "A cart with a box lying on it": the box lies, on the cart."""
    for f in frames:
        between = d.text[had.end : f.verb.start]
        follows = f.verb.start >= had.end > owner.end and not between.strip()
        if f.verb.form != "ing" or not follows:
            continue
        its = [q.mention for q in f.phrases if q.mention is not None]
        its = [q for q in its if q.pronoun in ("it", "him", "her", "them")]
        for q in its:
            q.entities = d.world.resolved[id(q)] = [*owner.entities]
        f.subject = had if its else f.subject


def _who_takes_the_way(frames: list[Frame], m: Mention) -> Mention:
    """ "A cart rolls down a slope with a barrel on it": what goes there has it, not the slope."""
    for f in frames:
        way = any(p.mention is m and p.prep in _WAYS for p in f.phrases)
        way = way or (f.object is m and not m.entities)  # "makes a turn with a bear on it"
        if f.subject is not None and way:
            return f.subject
    return m


_MOVED_THERE = frozenset({"launch", "roll", "slide", "tow"})
_OUT_OF_SIGHT = frozenset({"under", "beneath", "underneath", "behind", "between"})
"""What follows what is pushed: "pushes a box behind a couch" tells where it goes."""


def _is_goal(f: Frame, p: Phrase) -> bool:
    """ "Drops a ball in a bowl", "puts a cup on a shelf": it is not there at first."""
    sent = f.verb.sense in ("drop", "launch") and f.object is not None and not f.reduced
    if _tells_of_hands(f) or (sent and p.prep in ("in", "inside")):
        return True
    moved = f.verb.sense in _MOVED_THERE and f.object is not None and not f.verb.passive
    named = p.mention is not None and not p.mention.pronoun  # "drags a sledge behind it"
    return moved and named and p.prep in _OUT_OF_SIGHT


def _tells_of_hands(f: Frame) -> bool:
    """Whether a clause tells where something is put: not where it is at first."""
    put = f.verb.sense in ("park", "put") or _HANDLED.get((f.verb.sense, f.verb.lemma)) == "put"
    put = put or f.verb.lemma in ("move", "shift")  # "move the cup to the left of the plate"
    return put and not f.verb.passive and not f.reduced and f.object is not None


@dataclass
class Parts:
    """Who acts in a clause, and on what (node ids)."""

    subject: list[str]
    objects: list[str]


Step = Callable[[Discourse, Frame, Parts], bool]
"""Finds out more about who a clause is about; True if nothing is left to read."""


def read_frame(d: Discourse, f: Frame) -> None:
    """Reads a clause: who it is about, then what its verb's sense says, then what is left."""
    d.now.each = _one_by_one(d, f)
    parts = _parts(d, f)
    if any(step(d, f, parts) for step in STEPS):
        return
    sense = _sense_here(d, f, parts)
    handler = SENSES.get(sense)
    was = snapshot(d)
    posed = makes_gesture(d, f, parts.subject) or takes_posture(d, f, parts.subject)
    if handler is None and not posed:
        ignore(d, f, "no physical meaning")
        stands_there(d, f, parts.subject)
        hand_on(d, f)
        return
    _goes_round_in(d, f, parts.subject)
    if f.verb.lemma in _IN_PLACE:
        stands_there(d, f, parts.subject)  # "jumps next to a dog": there it starts
    if handler is not None and not posed:
        handler(d, f, parts.subject, parts.objects)
    gone_through(d, f)
    d.scene.clauses += by_its_participle(d, f, was, parts.subject)
    d.scene.clauses.append(follow(d, f, was, parts.subject, parts.objects))
    hand_on(d, f)
    for p, a in amounts_of(d, f):
        span = precedes(d, a) or (p == "for" and sense in ("fall", "drop"))
        if a.dimension == "time" and span and unread(d, a):
            d.times.gap, d.times.gap_of = a, f  # "falls for 0.6 s before it hits a bucket"


def _goes_round_in(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """ "Butter slides around a pan": about in it, and not around the outside."""
    around = f.phrase("around", "round")
    hosts = [i for i in things(around) if f.verb.sense in _ABOUT and i in d.world.entities]
    hosts = [h for h in hosts if {*entity_of(d, h).head.split()} & _GONE_ROUND_IN]
    inner = [i for i in bodies if at_rest(d, i) and i not in d.scene.supported_by]
    inner = [i for i in inner if hosts and max(size_of(d, i)) <= max(size_of(d, hosts[0]))]
    if any(h in d.scene.supported_by for h in hosts) or f.phrase("across", "over", "on"):
        return  # "drives around a plate on a table": there it goes
    if hosts:
        place(d, inner, hosts[:1], "in" if holds(d, hosts[0]) else "on")


def _parts(d: Discourse, f: Frame) -> Parts:
    subject = list(f.subject.entities) if f.subject is not None else []
    named = [i for m in (f.object, f.object2) if m is not None for i in m.entities]
    return Parts(subject, [i for i in dict.fromkeys(named) if kind_of(d, i) != "region"])


def _comes_apart(d: Discourse, f: Frame, parts: Parts) -> bool:
    """Verbs of breaking have their sense where what they are about can break."""
    who = who_breaks(d, f, parts.subject)
    if sense_of_breaking(d, f, who, parts.objects):
        f.verb.sense, parts.subject = "break", who
    return False


def _turns_on_its_joint(d: Discourse, f: Frame, parts: Parts) -> bool:
    """What swings open or slams shut is what can."""
    parts.subject = turned_instead(d, f, parts.subject)
    acted_on = bool(parts.objects) and not f.verb.passive
    if acted_on:
        parts.objects = closed_instead(d, f, parts.objects)
        parts.objects = by_their_doors(d, f, parts.objects)
    else:
        parts.subject = by_their_doors(d, f, parts.subject)
    return False


def _mount_instead(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "A girl rides a skateboard ... she hits a hydrant": the skateboard does."""
    mounts = {d.scene.supported_by.get(i, "") for i in parts.subject}
    if len(mounts) != 1 or f.verb.sense not in RIDDEN or f.verb.passive:
        return False
    mount = mounts.pop()
    riding = mount and kind_of(d, mount) in SELF_POWERED | {"sliding"}
    alone = not parts.objects[1:] and mount not in parts.objects
    if riding and alone and kind_of(d, parts.subject[0]) == "person":
        parts.subject = [mount]
    return False


def _no_ground(d: Discourse, f: Frame, parts: Parts) -> bool:
    """What is built or painted neither acts nor is moved."""
    sense = f.verb.sense
    if sense not in STATES:
        still = ("water", "hole")
        acting = [i for i in parts.subject if aimable(d, i) and kind_of(d, i) not in still]
        if parts.subject and not acting and not f.verb.passive:
            ignore(d, f, "the ground does not act")
            return True
        parts.subject = acting
    return False


def _lies_in_a_bend(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "A row of dominoes curving around a mug", "a fence winding uphill": no motion."""
    if f.verb.form != "ing" or f.verb.auxiliary or f.verb.lemma not in _BENDS or f.object:
        return False
    lined = {entity_of(d, i).pattern for i in parts.subject if i in d.world.entities}
    stands = parts.subject and not any(movable(d, i) for i in parts.subject)
    plural = len(parts.subject) > 2 and lined <= _LINES and bool(lined)
    if not (stands or plural) or (f.subject is not None and f.subject.pronoun):
        return False
    ignore(d, f, STRAIGHT)
    return True


def _abreast(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "Race side by side": the members of a plural in a row, else one beside the other."""
    bodies = (parts.subject or parts.objects) if "side by side" in f.adverbs else []
    for one, other in pairwise(bodies):
        group = entity_of(d, one).group
        if group is not None and group == entity_of(d, other).group:
            entity_of(d, one).pattern = entity_of(d, other).pattern = "row"
        else:
            place(d, [one], [other], "beside")
    return False


def _instead(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "throws a ball at a can but hits a box": it does not hit what it was aimed at."""
    d.now.instead = _INSTEAD.search(sentence(d, f)) is not None or (
        _BUT.search(d.text, max(0, f.verb.start - 30), f.verb.start) is not None
    )
    return False


def _speeds_and_masses(d: Discourse, f: Frame, parts: Parts) -> bool:
    """Quantities of the things themselves, whatever the verb."""
    sense, subject = f.verb.sense, parts.subject
    speeds = [a for _, a in amounts_of(d, f) if a.dimension == "speed"]
    if len(speeds) == len(subject) > 1 and sense in ("hit", "miss"):
        d.moves.own_speed.update(zip(subject, speeds, strict=True))  # "one at 1 m/s, the other"
    if f.verb.lemma in ("happen", "occur"):
        _happens(d, f)
    if sense == "noop" and subject and speeds:
        d.moves.stated[subject[0]] = speeds[0]  # "a lorry doing 60 mph"
    masses = [a for _, a in amounts_of(d, f) if a.dimension == "mass"]
    one_each = len(masses) == len(subject) > 1  # "one of 7.5 t and one of 12 t"
    loaded = parts.objects[:1] if sense not in ("weigh", "be") else []
    all_of_them = sense in ("weigh", "be", "have")
    for k, a in enumerate(masses):
        if not one_each and (mass_of_load(d, a) or not subject):
            continue
        owners = [subject[k]] if one_each else subject if all_of_them else loaded or subject[:1]
        for o in owners:
            apply_amount(d.world, entity_of(d, o), a)
        mark_used(d, a, owners[0])
    return False


def _does_not_happen(d: Discourse, f: Frame, parts: Parts) -> bool:
    """What is planned, feared or denied; a hit that is denied is a miss."""
    sense, negated = f.verb.sense, f.verb.negated
    if f.unreal and not (negated and sense == "hit" and f.verb.extra.get("denied") == BY_NONE):
        ignore(d, f, f.unreal)
        for p in f.phrases:
            if p.amount is not None and f.unreal != NOBODY_DOES:
                d.scene.used.setdefault((p.amount.start, p.amount.end), f.unreal)
        return True
    if negated and sense == "hit" and touches_none(d, f, parts.subject, parts.objects):
        return True
    if negated and sense == "hit" and f.verb.form == "ing" and _settled(d, parts.subject):
        mark_used(d, f, UNMET)  # "places it on a plate without touching the cup"
        return True
    if negated and sense == "reach" and falls_short(d, f, parts.subject, parts.objects):
        return True
    if negated and sense in ("hit", "enter"):
        f.verb.sense = "miss"
    elif negated and sense not in ("be", "miss"):
        ignore(d, f, "negated")
        at_all = _AT_ALL.match(d.text, f.verb.end) is not None
        at_first = not at_all and _AT_FIRST.search(sentence(d, f)) is not None
        if f.verb.lemma in ("move", "budge", "stir") and not at_first:
            d.moves.still.update((i, f.verb.start) for i in parts.subject)
        return True
    return False


def _settled(d: Discourse, subject: list[str]) -> bool:
    """Whether what a clause is about is where it was put by hands, or where it has stopped."""
    last = last_of(d, subject[0]) if subject else None
    put = last is not None and last.event in (NodeEvent.PLACED, NodeEvent.PICKED_UP)
    return put or (bool(subject) and has_stopped(d, subject[0]))


def _thrown_instead(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "She throws a ball and hits a can": what she has thrown does."""
    sense, m = f.verb.sense, f.subject
    things_do = sense in _THINGS_DO or (sense in _THINGS_DO_TO and parts.objects)
    flying = d.refs.thrown.get(id(m), []) if m is not None and m.start < f.verb.start else []
    people = all(kind_of(d, i) == "person" for i in parts.subject)
    if things_do and flying and people and not set(flying) & set(parts.objects):
        parts.subject = list(flying)
    _what_the_thrower_misses(d, f, parts)
    return False


def _ridden_instead(d: Discourse, f: Frame, parts: Parts) -> bool:
    """What a person of an earlier clause rides acts for him; unknown nouns get a kind."""
    for node in parts.subject if not f.verb.passive else []:
        _guess_kind(d, node, f.verb.lemma)
    mount = d.refs.mounts.get(id(f.subject)) if f.subject is not None else None
    if mount is not None and f.verb.sense not in _RIDERS_OWN:
        parts.subject = list(mount)
    over = f.verb.sense == "topple" and f.verb.lemma == "roll" and not f.verb.passive
    if over and parts.subject and "round" in traits_of(d, parts.subject[0]):
        f.verb.sense = "roll"  # "a ball rolls over and hits it": comes over
    return False


def _nothing_to_move(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "A farmer throws hay": what is thrown is no body, and the farmer does not fly instead."""
    m = f.object
    if f.verb.sense not in _SENT or f.verb.passive or m is None or parts.objects:
        return False
    stuff = no_things().get(m.head) == "substance" or m.head in _STUFF
    if m.amounts or m.count == 0 or m.pronoun in _REFLEXIVE or (m.attribute and not stuff):
        return False
    ignore(d, f, "nothing of the kind happens in the scene")
    return True


def _no_hand(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "A crate lands on the seesaw and lifts a box": what has no hands takes nothing."""
    picks = _HANDLED.get((f.verb.sense, f.verb.lemma)) == "pick" and bool(parts.objects)
    inert = [i for i in parts.subject if kind_of(d, i) not in SELF_POWERED]
    if picks and any(i in d.timeline.tracks for i in inert):
        ignore(d, f, "nothing of the kind happens in the scene")
        return True
    return False


def _runs_now(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "Is walking, then suddenly starts running": it gains speed."""
    if f.verb.lemma not in _FASTER_GAITS or f.verb.sense != "own" or f.verb.passive or f.object:
        return False
    slower = {i for c in d.scene.clauses if c.frame.verb.lemma in _SLOWER_GAITS for i in c.movers}
    afoot = parts.subject and {*parts.subject} <= slower
    if afoot and all(moves(d, i) for i in parts.subject) and not f.phrases:
        f.verb.sense = "accelerate"
    return False


def _breaks_away(d: Discourse, f: Frame, node: str) -> None:
    """What is towed breaks away as who tows it speeds up, and rolls on by itself."""
    tow = d.scene.tows[node]
    d.scene.loosed.add(node)
    read_as(d, "accelerate", f, [tow.by], [])
    track, ahead = d.timeline.track(node), d.timeline.track(tow.by)
    track.at, track.hit, track.role, track.closed = ahead.at, True, Role.PASSIVE, False
    for link in f.subject.entities if f.subject is not None else []:
        if is_link(d.scene, link):
            drop_link(d, link)
    mark_used(d, f, "gives way")


def _comes_off(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """What comes off the ceiling hangs below it until then, and falls."""
    for body in bodies:
        _by_a_rope(d, body)
        d.scene.loosed.add(body)
    mark_used(d, f, "gives way")
    _then_falls(d, f, bodies)


def _by_a_rope(d: Discourse, body: str) -> None:
    """What is to come down hangs by a rope, and not on the ceiling itself."""
    host = d.scene.attached.pop(body, "")
    told = d.scene.relations
    told[:] = [r for r in told if (r.source, r.target) != (body, host)]
    d.scene.hung.setdefault(body, "")


def _swings_on_a_rope(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "Hangs from the ceiling. It is pulled aside and let go": by a rope, as it can swing."""
    let = f.verb.lemma in SWAYING | _SET_SWINGING and f.phrase("off", "down") is None
    for body in [*parts.subject, *parts.objects] if let and not f.unreal else []:
        host = d.scene.attached.get(body, "")
        if host and kind_of(d, host) == "ceiling" and at_rest(d, body):
            was = [*d.scene.relations]
            _by_a_rope(d, body)
            if not hanging(d, [body]):  # nothing swings that is not made for it
                d.scene.attached[body], d.scene.relations[:] = host, was
                d.scene.hung.pop(body, None)
    return False


def _it_hung(d: Discourse, f: Frame, link: list[str], held: list[str]) -> None:
    """ "The chain snaps and it falls": no chain, which is drawn as a joint."""
    for g in d.told:
        m = g.subject
        if g.verb.start > f.verb.start and m is not None and m.pronoun and m.entities == link:
            m.entities = d.world.resolved[id(m)] = [*held]


def _then_falls(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """Lets what nothing holds any more fall, unless that is told next."""
    later = [g.subject for g in d.told if g.verb.start > f.verb.start and _comes_down(g)]
    if f.verb.sense == "fall" or not any({*bodies} & {*m.entities} for m in later if m is not None):
        read_as(d, "fall", f, bodies, [])


def _comes_down(f: Frame) -> bool:
    return f.verb.sense in ("fall", "drop")


def _gives_way(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "The rope snaps": what hangs by it comes down."""
    for node in (towed := let_loose(d, f)):
        _breaks_away(d, f, node)
    if off := comes_off(d, f):
        _comes_off(d, f, off)
        return True
    if towed or not snapped(d, f):
        return bool(towed)
    held = [h for i in parts.subject if (h := held_by(d, i)) and h in d.scene.hung]
    for body in held:
        if kind_of(d, d.scene.attached.get(body, body)) == "ceiling":
            _by_a_rope(d, body)
    if not held or not hanging(d, held):
        return False
    _it_hung(d, f, parts.subject, held)
    d.scene.loosed.update(held)
    mark_used(d, f, "gives way")
    for mate in (m for i in parts.subject for m in mates_of(d, i) if m not in parts.subject):
        drop_link(d, mate)  # "one of its two chains"
    _then_falls(d, f, held)
    return True


def _meets_a_link(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "A gull flies against the cable": what is drawn as a joint is no body to meet."""
    links = d.scene.links
    met = [i for p in f.phrases if p.prep in _AGAINST for i in things(p)]
    lost = links & {*parts.subject, *parts.objects, *met}
    parts.subject = [i for i in parts.subject if i not in links]
    parts.objects = [i for i in parts.objects if i not in links]
    if not lost or (parts.subject and (parts.objects or not f.object) and not links & {*met}):
        return False
    ignore(d, f, "nothing happens to what is drawn as a joint")
    return True


def _what_sways(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "A hammer strikes the bell, then it sways": of those named last, what hangs."""
    if f.verb.lemma in SWAYING:
        parts.subject = one_that(d, f.subject, parts.subject, lambda i: bool(hanging(d, [i])))
    return False


def _comes_out(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "The fridge door opens and a bottle falls out": who, and of what."""
    parts.subject = out_of_a_cupboard(d, f, parts.subject)
    hollow = behind_doors(d.scene, d.text) if parts.subject and "out" in f.adverbs else {}
    inside = any(d.scene.inside_of.get(i) in hollow for i in parts.subject)
    if inside and f.verb.sense in ("slide", "roll"):
        f.verb.sense = "fall"
    return False


def _springs_back(d: Discourse, f: Frame, parts: Parts) -> bool:
    """ "The spring throws it back", "it is pushed back": a rebound, and no motion of its own."""
    if sprung_back(d, f, [*parts.subject, *parts.objects]) and d.moves.last_hit is not None:
        parts.subject, parts.objects = [d.moves.last_hit[0]], []
        f.verb.sense = "bounce"
    return False


STEPS: tuple[Step, ...] = (
    _gives_way,
    _swings_on_a_rope,
    _meets_a_link,
    _what_sways,
    _springs_back,
    _comes_out,
    _comes_apart,
    _turns_on_its_joint,
    _mount_instead,
    _lies_in_a_bend,
    _no_ground,
    _instead,
    _speeds_and_masses,
    _does_not_happen,
    _thrown_instead,
    _ridden_instead,
    _abreast,
    _nothing_to_move,
    _no_hand,
    _runs_now,
)
"""What is found out about who a clause is about before its verb is read, in this order."""


def _sense_here(d: Discourse, f: Frame, parts: Parts) -> str:
    """The sense to read the clause by: "ends up in", "breaks on a rock" have one of their own."""
    on_joint = sense_on_joint(d, f, [*parts.subject, *parts.objects])
    if on_joint is not None:
        f.verb.sense = on_joint
    sense, lemma = f.verb.sense, f.verb.lemma
    handled = _HANDLED.get((sense, lemma))
    taken = parts.subject if f.verb.passive else parts.objects
    if sense == "noop" and not any(_in_reach(d, i) for i in taken):
        handled = None
    if handled is not None:
        return handled
    if lemma in ("end", "wind", "finish") and sense in ("noop", "reach"):
        return "end"
    against = f.phrase("on", "against", "at") is not None
    if sense == "noop" and lemma in _BREAKING and against and parts.subject:
        return "hit"
    return sense


def _in_reach(d: Discourse, body: str) -> bool:
    """Whether hands can take a thing ("takes a book from the shelf", not "takes a bus")."""
    loose = body in d.world.entities and entity_of(d, body).noun.kind not in SELF_POWERED
    return loose and "fixed" not in traits_of(d, body)


def _what_the_thrower_misses(d: Discourse, f: Frame, parts: Parts) -> None:
    """ "She throws a ball at a can. She misses it and hits a box": the ball does both."""
    subject, objects = parts.subject, parts.objects
    shot = d.refs.launched_by.get(subject[0], []) if len(subject) == 1 else []
    flying = [t for t in shot if moves(d, t)]
    missed = f.verb.sense == "miss"
    if f.verb.passive or f.verb.sense not in ("miss", "hit") or not flying:
        return
    aim = d.moves.aim.get(flying[0])
    aims = [aim] if aim else target_of_mates(d, flying[0])
    aimed = {*aims[:1], *[i for t in aims[:1] for i in mates_of(d, t)]} & {*objects}
    itself = set(objects) <= set(flying)  # "kicks another ball and hits it"
    if not aimed and not (itself and (missed or aims)):
        return
    if f.subject is not None:
        d.refs.thrown[id(f.subject)] = flying
    if itself:
        parts.objects = [] if missed else aims[:1]
    parts.subject = flying


def _one_by_one(d: Discourse, f: Frame) -> set[str]:
    """Few things that "both" or "each" distributes over; a row or a stack stays one chain."""
    out: set[str] = set()
    for m in (f.subject, f.object, *[p.mention for p in f.phrases]):
        singly = "one by one" in f.adverbs and f.verb.sense in _SINGLY and m is not None
        if m is not None and come_down(d, f, m):
            out |= set(m.entities)
        if m is None or not (2 <= len(m.entities) <= (_MOST_SINGLY if singly else 3)):
            continue
        counted = (m.subset or m.count) == len(m.entities) and not m.vague and not m.single
        told = m is f.object and counted
        apart = all(entity_of(d, i).pattern != "stack" for i in m.entities)
        chained = any(entity_of(d, i).pattern in ("row", "pins", "rack") for i in m.entities)
        some = not m.head and m.count == len(m.entities) and not chained  # "two of them fall"
        felled = told and apart and f.verb.sense in ("knock", "topple")  # "mows down two cones"
        singly = singly and apart and not chained and m in (f.subject, f.object)
        if {"both", "each"} & {m.determiner, m.pronoun} or felled or some or singly:
            out |= set(m.entities)
    return out


def _happens(d: Discourse, f: Frame) -> None:
    """ "The crash happens after 3 seconds", "the second collision 2 s after the first"."""
    last = _told_event(d, f.subject) or last_event(d)
    if last is None or last.time is not None or last.constraints:
        return
    time = time_of(d, f)
    if time is not None and (last is d.timeline.nodes[0] or time[2] == "at"):
        last.time, last.time_prescribed = time[0], True
        mark_used(d, time[1], f"time of {last.id}")
        mark_used(d, f, f"time of {last.id}")


def _told_event(d: Discourse, m: Mention | None) -> Draft | None:
    """The event that a noun names: "the second collision", "the fall"."""
    kinds = _NAMED_EVENTS.get(m.head) if m is not None and m.attribute else None
    if m is None or kinds is None:
        return None
    told = [n for n in d.timeline.nodes if n.event in kinds]
    place = next((lex.ORDINALS[a] for a in m.adjectives if a in lex.ORDINALS), -1)
    return told[place] if -len(told) <= place < len(told) else None


def _guess_kind(d: Discourse, node: str, lemma: str) -> None:
    """An unknown noun is what its verb says: what gallops is an animal."""
    entity = entity_of(d, node)
    if entity.known or entity.noun.kind != "generic":
        return
    model = "dog" if lemma in _ANIMAL_VERBS else "car" if lemma in _VEHICLE_VERBS else None
    model = "person" if lemma in _PERSON_VERBS else model
    if model is not None:
        like = lex.nouns()[model]
        entity.noun = replace(
            like,
            name=entity.head,
            description=f"{entity.head}, like a {model}",
            synonyms=(),
            # Somebody is drawn as a person, and a vehicle as a car; no animal looks like another.
            stand_in=entity.noun.stand_in if model == "dog" else "",
        )
