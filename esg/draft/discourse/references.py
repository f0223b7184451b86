"""Which thing every noun phrase of a clause means, in the order of the text."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.antecedents import it_means
from esg.draft.discourse.core import entity_of, ids_of, kind_of, movable, quantity_of
from esg.draft.discourse.levers import attached_levers, levers
from esg.draft.discourse.places import RELATION_PREPS
from esg.draft.discourse.record import Discourse, Told
from esg.draft.discourse.referents.entities import ACTING_PARTS
from esg.draft.discourse.referents.registry import current_id
from esg.draft.discourse.referents.resolution import resolve
from esg.draft.discourse.scene import SELF_POWERED
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Mention
from esg.lexicon.hypernyms import hypernyms

_AFOOT = lex.word_set("afoot (references)")
_FILMING = lex.word_set("filming")
_BY_THE_CAMERA = re.compile(r"\b(?:from|to|at|towards?) the (?:camera|viewer)\b", re.IGNORECASE)
"""Ways that the reader takes as one adverb."""
RIDDEN = lex.word_set("ridden")
_NO_WAY = frozenset({"unknown", "noop", "launch"})
"""Senses of verbs that lead nobody into water or out of it."""
_DRIVING = lex.word_set("vehicle verbs")
_DRIVEN = frozenset({"vehicle", "flyer", "cart", "watercraft"})
_AT_THE_WHEEL = frozenset({"chauffeur", "driver", "motorist", "pilot"})
_RIDES = lex.word_set("rides")
_RIDE, _RIDDEN_BY_ONE = ("animal", "person"), ("animal", "sliding", "toyvehicle", "vehicle")
_OBLIQUE = frozenset({"him", "her", "them"})
_STACKING = lex.word_set("stacking")
_LINING = frozenset({"line", "align"})
_STACKS = lex.word_set("stacks (references)")
_MAKES_PLAIN = frozenset({"create", "form", "generate", "show", "depict"})
_THEN = re.compile(r"\b(?:and|then|until|but)\s+(?:then\s+)?$", re.IGNORECASE)


def refer_all(d: Discourse, frames: list[Frame]) -> None:
    """Resolves every noun phrase, frame by frame and in the order of the text."""
    items: list[tuple[int, int, Frame | Mention]] = []
    for f in frames:
        mentions = [f.subject, f.object, f.object2, *[p.mention for p in f.phrases]]
        own = [m for m in mentions if m is not None and id(m) not in d.framed]
        d.framed |= {id(m) for m in own}
        d.framed |= {id(c) for m in own for c in m.coordinated}
        items.append((min([f.verb.start, *[m.start for m in own]]), f.verb.start, f))
    items += [(m.start, m.start, m) for m in d.mentions if id(m) not in d.framed]
    items.sort(key=lambda item: item[:2])
    attached_levers(d)
    for m, p in d.attached:
        if p.prep == "on" and p.mention is not None:
            _each_on_one(m, p.mention)
    hosts = {id(p.mention): m for m, p in d.attached}
    for _, _, item in items:
        if isinstance(item, Frame):
            refer(d, item)
        elif id(item) not in d.world.resolved and (item.head or item.pronoun) and item.count != 0:
            host = hosts.get(id(item)) if item.pronoun in ("them", "both") else None
            resolve(d.world, item, avoid=host.entities if host is not None else None)


def refer(d: Discourse, f: Frame) -> None:
    """Resolves the noun phrases of a frame, subject first."""
    phrases = [p.mention for p in f.phrases if p.mention is not None]
    for m in phrases if f.verb.sense == "reach" else ():
        m.after_prep = "to"  # "arrives at the depot": no scene, but where to
    if _of_another_clause(d, f):
        f.subject = None
    if f.object is not None and _comes_of_it(d, f, f.object):
        f.object.attribute = True
    _other_end(d, f)
    subject = _subject(d, f, phrases)
    _between(d, f, subject)
    no_way = f.verb.sense in _NO_WAY or f.verb.lemma == "splash"
    if f.object is not None and no_way and f.object.head == "water":
        f.object.attribute = f.object.attribute or not f.object.determiner  # "pours water"
    for m in (f.object, *phrases):
        _it(d, f, m, subject if f.verb.sense != "cause" else [])
    _one_each(f, subject)
    objects = _others(d, f, subject, phrases)
    levers(d, f, subject or objects)
    subject[:] = [current_id(d.world, i) for i in subject]  # a phrase may have told more
    objects[:] = [current_id(d.world, i) for i in objects]
    _note_properties(d, f, subject, objects)
    d.refs.told.append(Told(f, subject, objects))


def _comes_of_it(d: Discourse, f: Frame, m: Mention) -> bool:
    """ "Creating a shimmer", "demonstrating capillarity": what nobody knows as a thing."""
    shown = f.verb.sense == "noop" and f.verb.form == "ing" and f.verb.lemma in _MAKES_PLAIN
    unheard = m.noun is None and bool(m.head) and m.head not in hypernyms()
    return shown and unheard and all(e.head != m.head for e in d.world.entities.values())


def _of_another_clause(d: Discourse, f: Frame) -> bool:
    """ "Putting a book on the shelf and then it falls": "it" does not put."""
    m = f.subject
    later = m is not None and m.pronoun == "it" and f.verb.form == "ing" and m.start > f.verb.end
    return later and m is not None and bool(_THEN.search(d.text, f.verb.end, m.start))


def _other_end(d: Discourse, f: Frame) -> None:
    """ "A bear steps onto one end and the other goes up": no other bear."""
    m = f.subject
    if m is None or m.pronoun not in ("other", "one") or "other" not in (m.pronoun, *m.adjectives):
        return
    earlier = [x for x in d.mentions if x.end < m.start and not d.text.count(".", x.end, m.start)]
    last = max(earlier, key=lambda x: x.start, default=None)
    if last is not None and last.head in lex.PARTS and last.count == 1 and last.attribute:
        m.pronoun, m.head, m.attribute = "", last.head, True


def _between(d: Discourse, f: Frame, subject: list[str]) -> None:
    """What stands between a subject and its verb, in no clause of its own."""
    for m in d.mentions:
        between = f.subject is not None and f.subject.start < m.start < f.verb.start
        if id(m) in d.world.resolved:
            continue  # between the subject and a later verb of it
        if between and id(m) not in d.framed and (m.head or m.pronoun) and m.count != 0:
            ids_of(d, m, avoid=subject)


def _one_each(f: Frame, subject: list[str]) -> None:
    """ "Two people riding bicycles": one each."""
    ridden = f.object if f.verb.lemma in _RIDES and len(subject) > 1 else None
    if ridden is not None and ridden.plural and ridden.count is None and not ridden.determiner:
        ridden.count = len(subject)


def _each_on_one(riders: Mention, m: Mention) -> None:
    """ "Two people on bicycles": one each."""
    ridden = m.noun is not None and m.noun.kind in _RIDDEN_BY_ONE and not m.determiner
    several = getattr(riders.noun, "kind", "") in _RIDE and (riders.count or 0) > 1
    if ridden and several and m.plural and m.count is None and not m.group_word:
        m.count = riders.count


def _who_films(d: Discourse, f: Frame, m: Mention | None) -> bool:
    """ "Drives towards the camera as a bike drives away from it": the camera, and no thing."""
    if m is None or m.pronoun != "it" or m.after_prep not in _FILMING:
        return False
    earlier = [x for x in d.mentions if x.start < m.start and x is not f.subject]
    last = max(earlier, key=lambda x: x.start, default=None)
    by = max((x.end() for x in _BY_THE_CAMERA.finditer(d.text, 0, m.start)), default=-1)
    if by > (last.end if last is not None else -1):
        return True
    return last is not None and last.head == "camera" and last.after_prep in _FILMING


def _others(d: Discourse, f: Frame, subject: list[str], phrases: list[Mention]) -> list[str]:
    """Resolves all but the subject in the order of the text; returns what the object means."""
    objects: list[str] = []
    d.world.movers = subject
    rest = [m for m in (f.object, f.object2, *phrases) if m is not None]
    for m in sorted(rest, key=lambda m: m.start):
        himself = m.pronoun in _OBLIQUE and m.after_prep in RELATION_PREPS
        himself = himself and f.object is not None  # "throws it behind him", not "passes her"
        ids = ids_of(d, m, avoid=objects if himself else subject + objects)
        if m is f.object:
            objects = ids
            d.world.movers = subject + objects
    return objects


def _it(d: Discourse, f: Frame, m: Mention | None, avoid: list[str]) -> None:
    """Gives an "it" of a clause its meaning, if the clauses before tell of anything."""
    if m is None or m.pronoun != "it" or id(m) in d.world.resolved:
        return
    if _who_films(d, f, m):
        m.head, m.pronoun, m.attribute = "camera", "", True
        d.world.resolved[id(m)] = m.entities = []
        return
    if found := it_means(d, f, m, avoid) or _of_the_title(d, f, m, avoid):
        for other in m.coordinated:
            found += resolve(d.world, other, avoid=found)
        d.world.resolved[id(m)] = m.entities = found


def _of_the_title(d: Discourse, f: Frame, m: Mention, avoid: list[str]) -> list[str]:
    """ "A vase on a shelf. It falls off.": the first thing of a sentence without a verb."""
    if f.sentence == 0 or any(g.sentence == f.sentence - 1 for g in d.told):
        return []
    before = max((g.verb.end for g in d.told if g.verb.end <= m.start), default=0)
    named = [x for x in d.mentions if before <= x.start < m.start and not x.attribute]
    things = [[i for i in d.world.resolved.get(id(x), []) if movable(d, i)] for x in named]
    for ids in things:
        if ids and not {*ids} & {*avoid}:
            return ids
    return []


def _subject(d: Discourse, f: Frame, phrases: list[Mention]) -> list[str]:
    """Referents of the subject, and of what has to be read before it."""
    m = f.subject
    if m is None:
        return []
    thrown = f.verb.sense in ("fall", "land", "launch", "topple")
    if thrown and m.role in ("rider", "cyclist"):
        m.role = ""  # who falls is the rider, not what is ridden
    if m.role and f.verb.lemma in _AFOOT:
        m.role = ""  # "its driver walks beside it": no car
    if m.pronoun:
        for p in phrases:  # "Of four stacked tins, the top one is hit"
            if p.start < m.start and not p.pronoun:
                ids_of(d, p)
    _named_later(d, f, phrases)
    _drives_what_comes(d, f, m)
    before = [x for x in (f.object, *phrases) if x is not None and x.start < m.start]
    _it(d, f, m, [i for x in before for i in x.entities])
    _part_that_hits(d, f, m)
    return ids_of(d, m, subject=True)


def _named_later(d: Discourse, f: Frame, phrases: list[Mention]) -> None:
    """ "As it hits a block, a marble stops": the subject of the main clause to come."""
    main = f.main.subject if f.main is not None else None
    if main is None or main.pronoun or main.start < f.verb.start or d.world.salience:
        return
    for m in (f.subject, f.object, *phrases):
        if f.subordinate and m is not None and m.pronoun == "it" and not main.attribute:
            d.world.resolved[id(m)] = m.entities = ids_of(d, main, subject=True)


def _drives_what_comes(d: Discourse, f: Frame, m: Mention) -> None:
    """ "The driver swerves and the bus hits a tree": the bus swerves, there is no other vehicle."""
    drives = f.verb.sense in RIDDEN or f.verb.lemma in _DRIVING
    if m.role not in _AT_THE_WHEEL or m.determiner != "the" or not drives or f.verb.passive:
        return
    if f.object is not None or any(e.noun.kind in _DRIVEN for e in d.world.entities.values()):
        return
    driven = [x for x in d.mentions if x.noun is not None and x.noun.kind in _DRIVEN]
    if driven and driven[0].determiner == "the" and not driven[0].plural:
        d.world.resolved[id(m)] = m.entities = list(ids_of(d, driven[0]))


def _part_that_hits(d: Discourse, f: Frame, m: Mention) -> None:
    """ "The cart rolls on, its wheel hits a stone": the cart does."""
    touches = f.verb.sense in ("hit", "knock", "miss", "topple") and not f.verb.passive and f.object
    touches = touches or f.verb.sense in ("turn", "swerve")
    owned = m.determiner == "its" or m.possessor is not None
    if not touches or not owned or m.head not in ACTING_PARTS or m.plural:
        return
    before = d.refs.told[-1].subject if d.refs.told else []
    whole = before if m.possessor is None else ids_of(d, m.possessor)
    thing = m.noun is not None and whole and kind_of(d, whole[0]) == "person"
    if thing:
        return  # "the worker's ladder hits a wall"
    if len(whole) == 1 and kind_of(d, whole[0]) in SELF_POWERED | {"cart", "sliding"}:
        d.world.resolved[id(m)] = m.entities = list(whole)
        m.attribute = False


def _note_pattern(d: Discourse, f: Frame, subject: list[str], objects: list[str]) -> None:
    """ "The boxes are stacked", "piles plates on top of each other", "lines up cones"."""
    piled = f.verb.lemma in _STACKING and f.verb.sense != "hit"
    piled = piled or "on top of each other" in f.adverbs
    onto = f.phrase("in", "into")
    if piled or (onto is not None and onto.mention and onto.mention.head in _STACKS):
        for i in subject or objects:
            for mate in d.world.groups.get(entity_of(d, i).group or "", []):
                entity_of(d, mate).pattern = "stack"
    if f.verb.lemma in _LINING:
        for e in (entity_of(d, i) for i in objects or subject):
            mates = d.world.groups.get(e.group or "", [])
            e.pattern = "row" if mates and e.pattern in (None, "scatter") else e.pattern


def _note_speed(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "The speed of the car is 12 m/s", "its speed is 12 m/s"."""
    speed = quantity_of(d, f, "speed")
    named = f.subject if f.verb.sense == "be" else f.object if f.verb.sense == "have" else None
    if speed is None or named is None or not named.attribute:
        return
    its = named.determiner in lex.POSSESSIVES and bool(d.refs.told)
    who = subject or (d.refs.told[-1].subject if its else [])
    if len(who) == 1:
        d.moves.stated[who[0]] = speed[1]


def _note_properties(d: Discourse, f: Frame, subject: list[str], objects: list[str]) -> None:
    """What a clause says of things besides what they do: stacked, red, 12 m/s fast."""
    _note_pattern(d, f, subject, objects)
    _note_speed(d, f, subject)
    for word in f.adverbs if f.verb.sense == "be" else ():  # "the first car is red"
        if word in {*lex.COLORS, *lex.MATERIALS, *lex.WEIGHTS, *lex.SIZES}:
            for node in subject:
                entity_of(d, node).adjectives.append(word)
