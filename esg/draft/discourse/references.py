"""Which thing every noun phrase of a clause means, in the order of the text."""

from __future__ import annotations

from functools import partial

from esg.draft import lexicon as lex
from esg.draft.discourse.anaphora import (
    after_a_when_clause,
    it_again,
    it_is_no_way,
    it_is_the_target,
    it_of_the_main_clause,
    it_of_the_next,
    it_of_the_owner,
    it_stopped_there,
    made_to,
    named_between,
    named_later,
    note_main,
    note_ways,
    run_into_falls,
    sent_back,
    struck_on_its_way,
    what_can_drive,
)
from esg.draft.discourse.core import aimable, entity_of, ids_of, kind_of, movable, quantity_of
from esg.draft.discourse.places import enterable
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import ACTING_PARTS
from esg.draft.discourse.referents.registry import add_entity, current_id, note_referents
from esg.draft.discourse.referents.resolution import resolve
from esg.draft.discourse.scene import SELF_POWERED
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Mention

_FLYING_ON = lex.word_set("flying on")
_HALTING = lex.word_set("halting")
_DRIVING = lex.word_set("driving (references)")
_MOVING = lex.word_set("moving (references)")
RIDDEN = lex.word_set("ridden")
STATES = lex.word_set("states (references)")


_PLACES = lex.word_set("places (references)")
_SPEEDS = lex.word_set("speeds")
_STACKING = lex.word_set("stacking")
_STACKS = lex.word_set("stacks (references)")


def refer_all(d: Discourse, frames: list[Frame]) -> None:
    """Resolves every noun phrase, frame by frame and in the order of the text."""
    framed = d.framed
    for host, p in d.attached:
        if p.mention is not None and p.prep in _PLACES:
            d.refs.stand_there.setdefault(id(p.mention), []).append(host)
    items: list[tuple[int, int, Frame | Mention]] = []
    for f in frames:
        mentions = [f.subject, f.object, f.object2, *[p.mention for p in f.phrases]]
        own = [m for m in mentions if m is not None and id(m) not in framed]
        framed |= {id(m) for m in own}
        framed |= {id(c) for m in own for c in m.coordinated}
        items.append((min([f.verb.start, *[m.start for m in own]]), f.verb.start, f))
    for m in d.mentions:
        if id(m) not in framed:
            items.append((m.start, m.start, m))
    items.sort(key=lambda item: item[:2])
    for _, _, item in items:
        if isinstance(item, Frame):
            refer(d, item)
        elif id(item) not in d.world.resolved and (item.head or item.pronoun) and item.count != 0:
            resolve(d.world, item)


def refer(d: Discourse, f: Frame) -> None:
    """Resolves the noun phrases of a frame, subject first."""
    thrown = f.verb.sense in ("fall", "land") or (
        f.verb.sense in ("launch", "topple") and f.verb.passive
    )
    if f.subject is not None and thrown and f.subject.role in ("rider", "cyclist"):
        f.subject.role = ""  # who falls is the rider, not what is ridden
    control = f.verb.sense in RIDDEN and f.verb.sense not in ("hit", "miss", "enter", "reach")
    if f.subject is not None and f.subject.role and f.subject.role != "rider":
        f.subject.drives = control and f.object is None
    for p in f.phrases if f.subject is not None and f.subject.pronoun else []:
        m = p.mention  # "Of four stacked tins, the top one is hit"
        if m is not None and not m.pronoun and m.start < f.subject.start:
            ids_of(d, m)
    for p in f.phrases if f.verb.sense == "reach" else []:
        if p.mention is not None:
            p.mention.after_prep = "to"  # "arrives at the depot": no scene, but where to
    subject = subject_of(d, f)
    made_to(d, f)
    if (f.verb.lemma in _DRIVING and f.object is None) or f.verb.sense == "overtake":
        fit = [i for i in subject if kind_of(d, i) in ("person", "generic")]
        d.world.drivers |= set(fit)
    for m in d.mentions:
        between = f.subject is not None and f.subject.start < m.start < f.verb.start
        named = bool(m.head or m.pronoun)
        if between and id(m) not in d.framed and named and m.count != 0:
            ids_of(d, m, avoid=subject)
    for m in (f.object, *[p.mention for p in f.phrases]):
        # "A lamp falls on the sofa when a dog bumps it": the lamp
        if (
            m is not None
            and m.pronoun == "it"
            and f.subordinate in ("when", "after", "as", "because", "once")
            and d.refs.last_subject
            and len(d.refs.last_subject) == 1
            and d.refs.last_subject != subject
            and id(m) not in d.world.resolved
        ):
            d.world.resolved[id(m)] = m.entities = list(d.refs.last_subject)
        # "It rolls toward a car, but a man stops it": what was moving
        if (
            m is f.object
            and m is not None
            and m.pronoun == "it"
            and id(m) not in d.world.resolved
            and f.verb.lemma in _HALTING
            and f.subject is not None
            and f.subject.pronoun != "it"
            and len(d.refs.last_moving) == 1
            and d.refs.last_moving[0] not in subject
        ):
            d.world.resolved[id(m)] = m.entities = list(d.refs.last_moving)
        # "A log rolls off a truck. The car behind swerves to avoid it.": the log
        if (
            m is not None
            and m.pronoun == "it"
            and id(m) not in d.world.resolved
            and d.refs.lead.get(f.sentence - 1)
            and not named_between(d, f.subject, m)
            and d.refs.lead[f.sentence - 1] not in subject
            and f.subject is not None
            and not f.subject.pronoun
        ):
            d.world.resolved[id(m)] = m.entities = [d.refs.lead[f.sentence - 1]]
        # "A vase stands on a table. A ball hits it.": the vase
        if (
            m is not None
            and m.pronoun == "it"
            and d.refs.topic is not None
            and f.sentence - 1 <= d.refs.topic[0] <= f.sentence
            and len(d.refs.topic[1]) == 1
            and d.refs.topic[1] != subject
            and id(m) not in d.world.resolved
            and not _just_acted_on(d, f)
            and f.subject is not None
            and (f.subject.determiner in ("a", "an") or f.subject.attribute)
        ):
            d.world.resolved[id(m)] = m.entities = list(d.refs.topic[1])
    it_stopped_there(d, f, subject)
    sent_back(d, f, subject)
    it_again(d, f, subject)
    it_is_no_way(d, f, subject)
    _one_thrown_by_each(d, f, subject)
    it_is_the_target(d, f, subject)
    it_of_the_next(d, f, subject)
    if f.object is not None and f.subject is not None and f.object.start < f.subject.start:
        both = bool(f.object.pronoun and f.subject.pronoun)  # "Having hit it, it stops"
        objects = list(f.object.entities) or ids_of(d, f.object, avoid=subject if both else None)
    else:
        for p in f.phrases:  # "heavier than a 1 kg box strikes the box": as the text goes
            m = p.mention
            if f.object is None or m is None or m.pronoun or m.start > f.object.start:
                continue
            ids_of(d, m, avoid=subject)
        objects = ids_of(d, f.object, avoid=subject)
    objects = _one_for_each(d, f, subject, objects)
    d.world.movers = subject + objects
    ids_of(d, f.object2, avoid=subject + objects)
    for p in f.phrases:
        if p.mention is not None:
            ids_of(d, p.mention, avoid=subject + objects)
    _rather_than_its_place(d, f)
    subject[:] = map(
        partial(current_id, d.world), subject
    )  # which a phrase may have made more precise
    objects[:] = map(partial(current_id, d.world), objects)
    if f.subject is not None and not f.subject.pronoun:
        into = f.phrase("into", "against")
        met = into.mention.entities if into is not None and into.mention is not None else []
        hits = f.verb.sense in ("hit", "knock") and not f.verb.passive and not f.verb.negated
        with_ = f.phrase("with") if hits else None
        met = met or (objects if hits else [])
        if with_ is not None and with_.mention is not None:
            met = met or with_.mention.entities
        d.refs.hitter = subject[0] if hits and len(subject) == 1 else ""
        d.refs.met = (
            [i for i in met if aimable(d, i) and not enterable(d, i)],
            f.sentence,
        )
    if f.subject is not None and not f.reduced:
        aims = f.phrase("at", "toward", "towards", "against", "to") is not None
        d.refs.acted = (f.subject, () if aims else tuple(objects), f.sentence)
        d.refs.handled = tuple(objects)
    set_going = f.verb.sense in ("roll", "slide") and f.object is not None
    struck = (f.verb.sense in ("launch", "drop") or set_going) and not f.verb.passive
    driven = f.verb.sense == "hit" and f.object is not None and not f.verb.passive
    driven = driven and f.phrase("against", "toward", "towards", "into") is not None
    d.refs.launched = list(objects) if struck or driven else []
    d.refs.dropped = f.verb.sense == "drop" or set_going
    aimed = f.phrase("at", "toward", "towards", "against")
    if f.verb.sense in ("launch", "hit") and aimed is not None and aimed.mention is not None:
        d.refs.shot = (objects or subject, list(aimed.mention.entities))
        objects = aimed.mention.entities or objects  # "throws a stone at a can and it falls"
    elif f.verb.sense in ("roll", "slide", "fly") and aimed is not None and aimed.mention:
        d.refs.shot = (objects or subject, list(aimed.mention.entities))
    if (f.verb.lemma in _STACKING and f.verb.sense != "hit") or any(
        p.prep in ("in", "into") and p.mention is not None and p.mention.head in _STACKS
        for p in f.phrases
    ):
        for i in subject or objects:
            for mate in d.world.groups.get(entity_of(d, i).group or "", []):
                entity_of(d, mate).pattern = "stack"
    speed = quantity_of(d, f, "speed")
    s = f.subject
    its = s is not None and s.attribute and s.head in _SPEEDS and s.possessor is None
    its = its and s is not None and s.determiner in ("its", "his", "her")
    if its and not subject and len(d.refs.last_subject) == 1:
        subject = list(d.refs.last_subject)  # "Its speed is 3 m/s."
    owned = f.verb.sense == "have" and f.object is not None and f.object.head in _SPEEDS
    if owned and speed is not None and len(subject) == 1:
        d.moves.stated[subject[0]] = speed[1]  # "has a speed of 3 m/s and hits"
    if (
        f.verb.sense == "be"
        and f.subject is not None
        and f.subject.attribute
        and speed is not None
        and len(subject) == 1
    ):
        d.moves.stated[subject[0]] = speed[1]  # "the speed of the car is 12 m/s"
    if objects:
        d.refs.patient_at = f.sentence
    d.refs.patient = objects or d.refs.patient
    lone_object = f.object is not None and len(objects) == 1 and aimable(d, objects[0])
    if lone_object and (struck or f.verb.sense in _MOVING):
        d.refs.last_moving = list(d.refs.handled if struck and d.refs.handled else objects)
    elif f.verb.sense in _MOVING and len(subject) == 1 and kind_of(d, subject[0]) != "person":
        d.refs.last_moving = list(subject)
    if subject and (not f.reduced or (f.relative and f.verb.sense in STATES)):
        if d.refs.last_subject != subject:
            d.refs.subject_before, d.refs.last_had_object = d.refs.last_subject, d.refs.acts_on
            d.refs.acts_on = False
        d.refs.acts_on = d.refs.acts_on or bool(objects)
    if f.verb.sense in ("posture", "park") and subject and f.phrase(*_PLACES) is not None:
        note_referents(d.world, list(subject))  # "a tower stands on a table": "it" is the tower
    note_ways(d, f)
    note_main(d, f, subject)
    d.refs.last_subject = subject or d.refs.last_subject
    if f.verb.sense == "be" and subject:
        for word in f.adverbs:  # "the first car is red"
            if (
                word in lex.COLORS
                or word in lex.MATERIALS
                or word in lex.WEIGHTS
                or word in lex.SIZES
            ):
                for node in subject:
                    entity_of(d, node).adjectives.append(word)
    moving = f.verb.sense not in STATES and f.subject is not None and not f.subject.pronoun
    lone = len(subject) == 1 and kind_of(d, subject[0]) != "person"
    if moving and not f.reduced and f.sentence not in d.refs.lead:
        single = not objects and lone and aimable(d, subject[0])
        d.refs.lead[f.sentence] = subject[0] if single else ""
    if f.verb.sense == "be" and f.subject is None and len(objects) == 1:
        d.world.subjects.append(list(objects))  # "There is a vase on a shelf. It ..."
    if f.verb.sense in ("be", "posture", "have", "park") and (subject or objects):
        d.refs.topic = (f.sentence, subject or objects)


def _rather_than_its_place(d: Discourse, f: Frame) -> None:
    """ "throws a stone at a bottle on a wall. It hits it": the bottle, not the wall."""
    told = [m for m in (f.object, *[p.mention for p in f.phrases]) if m is not None]
    here = {id(m) for m in told}
    for m in told:
        for host in d.refs.stand_there.get(id(m), ()):
            if id(host) in here and host.entities:
                note_referents(d.world, list(host.entities))


def _just_acted_on(d: Discourse, f: Frame) -> bool:
    """ "hits the van and pushes it": the same subject acted on a thing just before."""
    return d.refs.acted[0] is f.subject and any(map(partial(movable, d), d.refs.acted[1]))


def _part_that_hits(d: Discourse, f: Frame) -> None:
    """ "The cart rolls on, its wheel hits a stone": the cart does."""
    m = f.subject
    if m is None or id(m) in d.world.resolved:
        return
    touches = f.verb.sense in ("hit", "knock", "miss") and not f.verb.passive and f.object
    touches = touches or (f.verb.sense == "topple" and f.object and "contact" in f.verb.extra)
    touches = touches or (f.verb.sense in ("turn", "swerve") and m.head in ("bow", "prow"))
    if not touches or m.head not in ACTING_PARTS or m.plural:
        return
    if m.determiner != "its" and m.possessor is None:
        return
    whole = d.refs.last_subject if m.possessor is None else ids_of(d, m.possessor)
    if len(whole) == 1 and kind_of(d, whole[0]) in SELF_POWERED | {"cart", "sliding"}:
        d.world.resolved[id(m)] = m.entities = list(whole)
        m.attribute = False


def _one_thrown_by_each(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "Two boys throw stones": as many stones as boys, if the prompt gives no number."""
    o = f.object
    if o is None or f.verb.passive or f.verb.sense not in ("launch", "roll", "slide", "drop"):
        return
    bare = o.plural and o.count is None and not o.determiner and o.pattern is None
    people = len(subject) > 1 and all(kind_of(d, i) == "person" for i in subject)
    if bare and people and not any(entity_of(d, i).group in d.world.vague for i in subject):
        o.count, o.vague = min(len(subject), 6), True


def _one_for_each(d: Discourse, f: Frame, subject: list[str], objects: list[str]) -> list[str]:
    """ "Each ball hits a pin": a pin for every ball."""
    s, o = f.subject, f.object
    if s is None or o is None or not 2 <= len(subject) <= 6 or len(objects) != 1:
        return objects
    if "each" not in (s.determiner, s.pronoun) and s.determiner != "every":
        return objects
    if o.determiner not in ("a", "an") or entity_of(d, objects[0]).origin != o.start:
        return objects
    if f.verb.sense not in ("hit", "knock", "topple") or not aimable(d, objects[0]):
        return objects
    like = entity_of(d, objects[0])
    ids = [objects[0]]
    for _ in subject[1:]:
        ids.append(
            add_entity(d.world, 
                like.noun, like.head, adjectives=list(like.adjectives), label=like.label,
                known=like.known, origin=o.start,
            ).id
        )  # fmt: skip
    o.entities = ids
    d.world.resolved[id(o)] = ids
    d.now.pairs.update(zip(subject, ids, strict=True))
    return ids


def _patient_since(d: Discourse, sentence: int) -> bool:
    """Whether something was acted on in this sentence."""
    return d.refs.patient_at == sentence


def _sends(d: Discourse, f: Frame) -> bool:
    """ "slides the glass down the bar, and it knocks a cup off": the glass."""
    acts = f.verb.sense in ("knock", "hit") and f.object is not None and not f.verb.passive
    return acts and f.object is not None and f.object.pronoun != "it"


def _as_one(d: Discourse, things: list[str]) -> bool:
    """Whether several things go by one name ("a tower of blocks")."""
    return entity_of(d, things[0]).group in d.world.collective


def subject_of(d: Discourse, f: Frame) -> list[str]:
    """Referents of the subject; what falls after a push is the thing pushed."""
    m = f.subject
    named_later(d, f)
    it_of_the_owner(d, f)
    after_a_when_clause(d, f)
    if (
        m is not None
        and m.pronoun == "it"
        and id(m) not in d.world.resolved
        and f.verb.sense in ("fall", "topple", "land")
        and not f.start_of_sentence
        and d.refs.topic is not None
        and d.refs.topic[0] == f.sentence - 1
        and len(d.refs.topic[1]) == 1
        and d.refs.last_subject
        and kind_of(d, d.refs.last_subject[0]) in SELF_POWERED
        and not _patient_since(d, f.sentence)
    ):
        # "A book lies on a shelf. When a truck passes, it falls.": the book
        d.world.resolved[id(m)] = m.entities = list(d.refs.topic[1])
    if (
        m is not None
        and m.pronoun in ("it", "they")
        and id(m) not in d.world.resolved
        and not struck_on_its_way(d, f)
        and not run_into_falls(d, f)
        and f.verb.sense in ("fall", "topple", "land", "pocket", "drop")
        and (f.verb.sense != "drop" or f.object is None)
        and d.refs.patient
        and (m.pronoun == "it") == (len(d.refs.patient) == 1 or _as_one(d, d.refs.patient))
    ):
        d.world.resolved[id(m)] = m.entities = list(d.refs.patient)
    if (
        m is not None
        and m.pronoun in ("he", "she")
        and id(m) not in d.world.resolved
        and (f.verb.sense in RIDDEN or f.verb.sense == "own")
        and len(d.refs.last_subject) == 1
        and kind_of(d, d.refs.last_subject[0]) in SELF_POWERED
        and not any(e.noun.kind == "person" for e in d.world.entities.values())
    ):  # "The truck begins to brake and he stops"
        d.world.resolved[id(m)] = m.entities = list(d.refs.last_subject)
    it_of_the_main_clause(d, f)
    what_can_drive(d, f)
    _part_that_hits(d, f)
    dropped = f.verb.sense in ("miss", "hit", "land") and d.refs.dropped
    if (
        m is not None
        and m.pronoun == "it"
        and id(m) not in d.world.resolved
        and (f.verb.sense in _FLYING_ON or dropped or f.link == "until" or _sends(d, f))
        and len(d.refs.launched) == 1
    ):
        d.world.resolved[id(m)] = m.entities = list(d.refs.launched)
    whom = f.object if f.reduced and m is not None and m.pronoun == "it" else None
    whom = whom or next((p.mention for p in f.phrases if f.reduced and m and m.pronoun), None)
    told = whom is not None and m is not None and whom.start < m.start
    return ids_of(d, m, subject=True, avoid=whom.entities if told and whom else None)
