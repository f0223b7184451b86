"""What "it" means when the clauses around it decide."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, ids_of, kind_of, movable, structural
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.pronouns import of_other_gender, pronoun
from esg.draft.discourse.scene import SELF_POWERED
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.grammar.rewrites.nominals import RETOLD_NOUNS
from esg.draft.text.elements import Mention

_TAKING = lex.word_set("taking (anaphora)")
_ALONG = lex.word_set("along")
_BESIDE = lex.word_set("beside")
_STEERED = lex.word_set("steered (anaphora)")
_DRIVEN = lex.word_set("driven (anaphora)")


def _mass(e: Entity) -> float:
    return e.mass_kg or e.noun.mass_kg


def it_is_the_target(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "The first misses, the second hits it": what all of them were thrown at."""
    m, (shot, target) = f.object, d.refs.shot
    if m is None or m.pronoun != "it" or id(m) in d.world.resolved or not subject:
        return
    mates = d.world.groups.get(entity_of(d, subject[0]).group or "", [])
    one_of_them = subject[0] in shot and len(shot) > 1 and set(shot) <= set(mates)
    if one_of_them and len(target) == 1 and d.refs.last_subject != subject:
        d.world.resolved[id(m)] = m.entities = list(target)


def struck_on_its_way(d: Discourse, f: Frame) -> bool:
    """ "A ball hits a cushion before it falls into a pocket": what hits goes on."""
    m, main = f.subject, f.main
    if m is None or m.pronoun != "it" or f.subordinate != "before" or main is None:
        return False
    round_ = main.subject is not None and "round" in getattr(main.subject.noun, "traits", ())
    ids = main.subject.entities if round_ and main.subject is not None else []
    if main.verb.sense != "hit" or main.verb.passive or len(ids) != 1 or not f.phrases:
        return False
    d.world.resolved[id(m)] = m.entities = list(ids)
    return True


def run_into_falls(d: Discourse, f: Frame) -> bool:
    """ "slides into a bottle, so it tips over": what is run into."""
    m, (met, sentence) = f.subject, d.refs.met
    if m is None or m.pronoun != "it" or id(m) in d.world.resolved or len(met) != 1:
        return False
    if met[0] not in d.world.entities or not movable(d, met[0]):
        return False
    hitter = d.world.entities.get(d.refs.hitter) if d.refs.hitter else None
    if hitter is not None and hitter.noun.name == "arm":
        hitter = None  # "An elbow catches a box. It goes over the edge.": the box
    off = "off" in f.adverbs or f.verb.extra.get("particle") == "off"
    leaves = f.verb.sense in ("fall", "roll", "slide")
    leaves = leaves and (off or f.phrase("off", "from") is not None)
    upright = f.verb.sense == "topple" or (f.verb.sense == "fall" and not f.phrases)
    upright = upright and not leaves
    driven = f.subordinate == "so" and hitter is not None and f.verb.sense in _DRIVEN
    if (upright or driven) and sentence == f.sentence:
        pass
    elif hitter is None or sentence < f.sentence - 1 or not (upright or leaves):
        return False
    elif upright and _mass(entity_of(d, met[0])) >= _mass(hitter):
        met = [hitter.id]  # "The scooter hits a truck. It falls over.": the scooter
    elif (
        f.verb.sense == "roll" and "round" in hitter.noun.traits - entity_of(d, met[0]).noun.traits
    ):
        return False  # "A ball hits a box, and it rolls off the table": the ball
    d.world.resolved[id(m)] = m.entities = list(met)
    return True


def what_can_drive(d: Discourse, f: Frame) -> None:
    """ "When a can hits the bus, it brakes": of two that met, the one that drives."""
    m, (met, sentence) = f.subject, d.refs.met
    if m is None or m.pronoun != "it" or id(m) in d.world.resolved or len(met) != 1:
        return
    hitter = d.world.entities.get(d.refs.hitter) if d.refs.hitter else None
    if f.verb.sense not in _STEERED or f.verb.passive or sentence < f.sentence - 1:
        return
    drives = met[0] in d.world.entities and kind_of(d, met[0]) in SELF_POWERED
    if hitter is not None and drives and hitter.noun.kind not in SELF_POWERED:
        d.world.resolved[id(m)] = m.entities = list(met)


def made_to(d: Discourse, f: Frame) -> None:
    """ "hits a vase, which makes it fall", "The impact makes it fall": what was hit."""
    m, s, (met, sentence) = f.object, f.subject, d.refs.met
    if m is None or m.pronoun != "it" or id(m) in d.world.resolved or s is None:
        return
    if f.verb.sense != "cause" or len(met) != 1 or sentence < f.sentence - 1:
        return
    event = (s.attribute and s.head in RETOLD_NOUNS) or s.pronoun in ("this", "that")
    hard = f.verb.infinitive and f.parent is not None and s is f.parent.subject
    driven = f.causer is not None and f.causer.verb.sense in ("hit", "knock")
    event = event or hard or driven  # "hits it hard enough to make it fall"
    if f.relative and f.parent is not None and f.parent.verb.sense == "hit":
        event = s in (f.parent.object, *[p.mention for p in f.parent.phrases])
    if event and met[0] in d.world.entities:
        d.world.resolved[id(m)] = m.entities = list(met)


def it_stopped_there(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "A van stops in front of a school, and a car hits it": the van."""
    s, m = f.subject, f.object
    mentions = [x for x in (m, *[p.mention for p in f.phrases]) if x is not None]
    it = next((x for x in mentions if x.pronoun == "it"), None)
    if it is None or id(it) in d.world.resolved or s is None or s.pronoun:
        return
    before = [g for g in d.told if g.sentence == f.sentence and g.verb.start < s.start]
    last = before[-1] if before else None
    if last is None or last.verb.sense not in ("stop", "park", "brake", "wait"):
        return
    stopped = last.subject.entities if last.subject is not None else []
    where = {p.prep for p in last.phrases if p.mention is not None and p.mention.entities}
    placed = last.object is None and bool(where) and where <= _BESIDE
    if placed and len(stopped) == 1 and stopped != subject and stopped[0] not in subject:
        d.world.resolved[id(it)] = it.entities = list(stopped)


def sent_back(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "throws a ball to a seal, which hits it back": the ball."""
    m, before = f.object, f.parent
    if m is None or m.pronoun != "it" or id(m) in d.world.resolved or before is None:
        return
    sent = before.object.entities if before.object is not None else []
    to = before.phrase("to", "toward", "towards")
    arrives = to is not None and to.mention is f.subject
    arrives = arrives and (before.object is None or before.verb.lemma == "come")
    arrives = arrives and before.verb.sense != "launch"
    if f.relative and arrives and before.subject is not None and f.verb.sense == "launch":
        sent = before.subject.entities  # "comes off the post to a player, who shoots it in"
    launched = before.verb.sense == "launch" or arrives
    if f.relative and launched and len(sent) == 1 and sent != subject:
        d.world.resolved[id(m)] = m.entities = list(sent)


def it_again(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "moves it over a box and drops it": what the same subject acted on just before."""
    m, (before, things, sentence) = f.object, d.refs.acted
    if f.verb.sense == "launch" or f.verb.lemma in _TAKING:
        things = d.refs.handled  # "kicks the ball against a wall, catches it"
    if m is None or m.pronoun != "it" or id(m) in d.world.resolved or len(things) != 1:
        return
    same = f.subject is not None and f.subject is before and sentence == f.sentence
    if same and things[0] not in subject and things[0] in d.world.entities:
        d.world.resolved[id(m)] = m.entities = list(things)


def it_is_no_way(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "A vase stands there. A cat walks along the sill and brushes against it": the vase."""
    mentions = [f.object, *[p.mention for p in f.phrases]]
    m = next((x for x in mentions if x is not None and x.pronoun == "it"), None)
    before, ways = d.refs.ways
    d.refs.ways = (f.sentence, ways if before == f.sentence else set())
    if m is not None and id(m) not in d.world.resolved and ways and before == f.sentence:
        found = pronoun(d.world, m, False, subject)  # pyright: ignore[reportPrivateUsage]
        earlier = d.refs.stood.get(f.sentence - (not set(found) <= d.refs.reasons), [])
        if set(found) <= ways and earlier and not set(earlier) & {*subject, *ways}:
            d.world.resolved[id(m)] = m.entities = list(earlier)
    if not f.reduced and f.sentence not in d.refs.stood:
        thing = f.object.entities if f.object is not None and f.object.entities else subject
        lone = len(thing) == 1 and kind_of(d, thing[0]) != "person"
        d.refs.stood[f.sentence] = list(thing) if lone and movable(d, thing[0]) else []


def note_ways(d: Discourse, f: Frame) -> None:
    """Remembers what a clause goes along or through, which "it" rarely means."""
    for p in f.phrases:
        if p.mention is not None and f.object is None and p.prep in _ALONG | {"for"}:
            d.refs.ways[1].update(p.mention.entities)
            d.refs.reasons |= set(p.mention.entities if p.prep == "for" else ())


def it_of_the_main_clause(d: Discourse, f: Frame) -> None:
    """ "A barrel rolls off a cart after the cart hits a stone. It rolls on": the barrel."""
    m = f.subject
    main, last = d.refs.mains.get(f.sentence - 1, ([], []))
    if m is None or m.pronoun not in ("it", "he", "she") or id(m) in d.world.resolved:
        return
    if not f.start_of_sentence or len(main) != 1 or not last or last == main:
        return
    if m.pronoun != "it":  # "A nurse comes out as a guest gets up. She brakes": the nurse
        who = d.world.entities.get(main[0])
        person = who is not None and who.noun.kind == "person"
        if person and who is not None and not of_other_gender(m.pronoun, who.head):
            d.world.resolved[id(m)] = m.entities = list(main)
        return
    if f.verb.sense in ("fall", "topple") or main[0] not in d.world.entities:
        return
    if kind_of(d, main[0]) != "person" and movable(d, main[0]):
        d.world.resolved[id(m)] = m.entities = list(main)


def after_a_when_clause(d: Discourse, f: Frame) -> None:
    """ "A vase sways when a dog bumps a shelf, and then it falls": the vase."""
    m = f.subject
    if m is None or m.pronoun != "it" or f.subordinate or id(m) in d.world.resolved:
        return
    told = [g for g in d.told if g.sentence == f.sentence and g.verb.start < m.start]
    last = max(told, key=lambda g: g.verb.start, default=None)
    main = last.main if last is not None and last.subordinate in ("when", "as") else None
    if last is None or main is None or main.subject is None or main.subject.pronoun:
        return
    first = main.verb.start < last.verb.start and main.verb.sense in ("noop", "posture", "be")
    who = main.subject.entities
    if first and len(who) == 1 and movable(d, who[0]) and kind_of(d, who[0]) != "person":
        d.world.resolved[id(m)] = m.entities = list(who)


def note_main(d: Discourse, f: Frame, subject: list[str]) -> None:
    """Remembers the subject of a sentence's main clause, and that of a clause after it."""
    main = d.refs.mains.get(f.sentence, ([], []))[0]
    if not subject or f.reduced:
        return
    if f.subordinate in ("", "so"):
        d.refs.mains[f.sentence] = (list(subject), [])
    elif main:
        d.refs.mains[f.sentence] = (main, list(subject))


def it_of_the_next(d: Discourse, f: Frame, subject: list[str]) -> None:
    """ "The first truck stops, the second truck rams it": the first truck."""
    m, before = f.object, d.refs.subject_before
    if m is None or m.pronoun != "it" or id(m) in d.world.resolved:
        return
    if d.refs.last_subject != subject:
        before, acted = d.refs.last_subject, d.refs.acts_on
    else:
        acted = d.refs.last_had_object
    if len(subject) != 1 or len(before) != 1 or subject == before or acted:
        return
    mine, other = entity_of(d, subject[0]), entity_of(d, before[0])
    words = {mine.place, *mine.adjectives}
    placed = mine.place in lex.ORDINALS or bool({"last", "rear", "final"} & words)
    if mine.noun == other.noun and placed:
        d.world.resolved[id(m)] = m.entities = list(before)


def it_of_the_owner(d: Discourse, f: Frame) -> None:
    """ "A crate falls, its parachute does not open, and it hits a barn": the crate."""
    m = f.subject
    if m is None or m.pronoun != "it" or id(m) in d.world.resolved:
        return
    before = [g for g in d.told if g.sentence == f.sentence and g.verb.start < m.start]
    last = max(before, key=lambda g: g.verb.start, default=None)
    part = last.subject if last is not None else None
    idle = last is not None and (last.verb.negated or last.verb.sense in ("noop", "be"))
    if part is None or part.determiner != "its" or not idle:
        return
    owner = d.refs.subject_before
    if len(owner) == 1 and owner != part.entities and owner[0] in d.world.entities:
        d.world.resolved[id(m)] = m.entities = list(owner)


def named_between(d: Discourse, subject: Mention | None, m: Mention) -> bool:
    """Whether the clause names something before a pronoun ("hits the nine and pots it")."""
    if subject is None:
        return False
    start, end = subject.end, m.start
    between = [x for x in d.mentions if start <= x.start < end and not x.pronoun]
    return any(x.entities and not structural(d, x.entities[0]) for x in between)


def named_later(d: Discourse, f: Frame) -> None:
    """ "As it hits a block, a marble stops": the subject of the main clause to come."""
    main = f.main.subject if f.main is not None else None
    if not f.subordinate or main is None or main.pronoun or main.start < f.verb.start:
        return
    for m in (f.subject, f.object, *[p.mention for p in f.phrases]):
        if m is None or m.pronoun != "it" or id(m) in d.world.resolved:
            continue
        if d.world.salience or main.attribute:
            return
        d.world.resolved[id(m)] = m.entities = ids_of(d, main, subject=True)
