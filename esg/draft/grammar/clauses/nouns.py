"""Noun phrases of a clause: subject, object, or part of a prepositional phrase."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame, Phrase, State, finite_ahead
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.grammar.clauses.words import OWNED, PROPERTIES
from esg.draft.text.elements import Element, Mention, Verb, Word, element_at
from esg.lexicon.hypernyms import hypernyms

_OCCASIONS = lex.word_set("occasions")
_BEINGS = frozenset({"person", "animal", "robot"})
_WAYS = frozenset({"ramp", "stairs", "ground", "water"})
_RIDDEN = frozenset({"sliding", "cart", "vehicle", "watercraft", "animal", "toyvehicle"})
"""Kinds of ways, and of what somebody is on who goes along them."""
_THIS = lex.word_set("this")
_OF_NOUNS = lex.word_set("prepositions of nouns")
_PLACED = lex.BESIDE | {"on", "in", "under", "above", "on top of", "inside"}
_SENDING = frozenset({"launch", "hit", "knock", "drop", "cause", "topple", "carry", "tow"})
_OUT = frozenset({"into", "onto", "off", "out of", "through", "across"})
_OVER = frozenset({"over", "past", *_OUT})
_INTO = frozenset({"in", "into", "on", "onto", "inside"})
_GONE_WITH = frozenset({"it", "him", "her", "them", "both"})
_WITH = frozenset({"with", ".", ";", "!", "?", ":"})
_ALSO_OF_VERBS = lex.word_set("senses with the place of their object")


_LETS = lex.word_set("letting (noun questions)")
"""Verbs of which the object does what the next verb says."""


def _in_a_list(c: Clauses, s: State, previous: Element | None, i: int) -> bool:
    """Whether a noun goes on a list of objects, so that the verb ahead has another subject."""
    if s.frame is None or s.last is None or not isinstance(previous, Word):
        return False
    if s.last is s.frame.subject:
        return False
    if _before_a_bare_verb(c, i):
        return True
    if len(s.last.coordinated) < 2:
        return False
    if previous.kind == "conj" and getattr(c.elements[i - 2], "low", "") == ",":
        return False  # ", and a cat and a dog run": a clause of its own
    nouns = 0
    for e in c.elements[i + 1 :]:
        if isinstance(e, Verb):
            return False
        if isinstance(e, Mention) and nouns:
            return True  # a conjunction and another noun come before the verb
        if isinstance(e, Word) and e.kind == "conj":
            nouns += 1
        if isinstance(e, Word) and e.low in ".;:!?":
            return False
    return False


def _before_a_bare_verb(c: Clauses, i: int) -> bool:
    """Whether a noun ends a list, and a verb without a subject follows its conjunction.

    "Rides past a sandbox and a seesaw and stops": the verb goes on with the subject before.
    """
    relative = False
    after = c.elements[i + 1 :]
    for k, e in enumerate(after):
        if isinstance(e, Verb):
            if relative or (e.form == "ing" and not e.auxiliary):
                relative = False
                continue  # "a truck that waits and hits", "a bus waiting there and stops"
            return False
        if not isinstance(e, Word):
            continue
        if e.kind == "rel":
            relative = True
        elif e.kind == "conj" and e.low in ("and", "but"):
            rest = [x for x in after[k + 1 : k + 4] if getattr(x, "kind", "") != "adv"]
            nxt = rest[0] if rest else None
            if isinstance(nxt, Verb):
                return nxt.form in ("s", "past") and not nxt.passive and not nxt.auxiliary
            if not isinstance(nxt, Mention):
                return False
        elif e.kind in ("punct", "sub", "conj") and e.low != ",":
            return False
    return False


def mention(c: Clauses, s: State, m: Mention, i: int) -> None:
    """Gives a noun phrase its place in the clause."""
    m.after_prep, s.prep = s.prep, ""
    if id(m) in c.told or _stated_beside(c, m, i):
        return
    if _names_where(c, s, m, i) or _tag(c, s, m, i):
        m.attribute = True
        return
    listed = _coordinated(c, s, i) and not _part_going(c, m, i)
    if not m.after_prep and (_property(c, s, m, listed) or _stated_of_it(c, s, m, i)):
        return
    new_clause = _begins_clause(c, s, m, i)
    if s.boundary_kind == "whose" and m.attribute and m.possessor is None:
        m.possessor = s.relative  # "a ball whose mass is 300 g"
    if _says_nothing(c, s, m, i):
        return
    if listed and _other_end(c, s, m, i):
        assert s.last is not None
        s.last.coordinated.append(m)
        s.boundary = False
    elif _opens_a_relative_clause(s):
        _subject_of_relative(s, m)
    elif m.after_prep:
        _part_of_a_phrase(c, s, m, i)
    elif listed and _another_with_a_place(c, s, m, i):
        assert s.subject is not None
        s.subject.coordinated.append(m)
        s.last, s.last_after_prep, s.boundary = m, False, False
    elif listed and s.last is not None and not new_clause and s.last is not s.relative:
        s.last.coordinated.append(m)
        s.subject = s.last if s.frame is None and s.subject is None else s.subject
    elif listed and new_clause and _more_subjects(s):
        assert s.subject is not None
        s.subject.coordinated.append(m)  # "a car and a truck drive": one subject
        s.boundary = False
    elif s.boundary or s.frame is None:
        _subject(s, m, new_clause)
    else:
        _object(s.frame, m)
        s.last, s.last_after_prep = m, False


def _names_where(c: Clauses, s: State, m: Mention, i: int) -> bool:
    """ "Past the Brandenburg Gate, Berlin", "at a market, Nairobi, Kenya": names of places."""
    link, k = element_at(c.elements, i - 1), i
    if not _a_name(m) or m.after_prep or getattr(link, "low", "") != ",":
        return False
    if s.last is None or getattr(s.last.noun, "kind", "") == "person":
        return False  # "to Tom, Anna and Kim"
    while (
        _a_name(element_at(c.elements, k))
        and getattr(element_at(c.elements, k + 1), "low", "") == ","
    ):
        k += 2
    after = element_at(c.elements, k + 1)
    return _a_name(element_at(c.elements, k)) and (
        after is None or getattr(after, "low", "") == "."
    )


def _tag(c: Clauses, s: State, m: Mention, i: int) -> bool:
    """ "A prism on a table, refraction.": a bare noun that nobody knows, after a comma."""
    link, after = element_at(c.elements, i - 1), element_at(c.elements, i + 1)
    told = m.determiner or m.adjectives or m.count or m.plural or m.letters or m.amounts
    bare = not told and m.noun is None and bool(m.head) and m.head not in hypernyms()
    ends = after is None or (isinstance(after, Word) and after.low == ".")
    listed = s.last is not None and s.last.coordinated  # "a cup, a plate, zorb"
    return bare and ends and getattr(link, "low", "") == "," and s.last is not None and not listed


def _a_name(e: Element | None) -> bool:
    """A capital in mid-sentence that may be somebody's name, and is no usual one."""
    if not isinstance(e, Mention) or e.determiner or e.adjectives or e.possessor is not None:
        return False
    name = getattr(e.noun, "kind", "") == "person" and e.head not in lex.nouns()
    return name and e.text[:1].isupper() and e.head not in lex.FIRST_NAMES


def _another_with_a_place(c: Clauses, s: State, m: Mention, i: int) -> bool:
    """ "A man on a horse and a boy on a bike ride": the horse is not on the bike."""
    link = element_at(c.elements, i - 1)
    ahead = element_at(c.elements, i + 1)
    if s.frame is not None or s.subject is None or s.last is None or s.last is s.subject:
        return False
    placed = isinstance(ahead, Word) and ahead.kind == "prep" and ahead.low in _INTO
    one, place, other = (x.noun.kind if x.noun else "" for x in (s.subject, s.last, m))
    joined = getattr(link, "low", "") == "and" and bool(s.last.after_prep)
    return joined and placed and {one, other} <= _BEINGS and place != other


def _opens_a_relative_clause(s: State) -> bool:
    """Whether a relative pronoun stands right before."""
    return s.relative is not None and s.boundary and s.boundary_kind in ("rel", "whose")


def _part_going(c: Clauses, m: Mention, i: int) -> bool:
    """ "Shatters on the floor, its lid rolling away": no second floor."""
    verb = element_at(c.elements, i + 1)
    going = isinstance(verb, Verb) and verb.form == "ing" and not verb.auxiliary
    comma = getattr(element_at(c.elements, i - 1), "low", "") == ","
    return comma and going and m.attribute and bool(m.part)


def _other_end(c: Clauses, s: State, m: Mention, i: int) -> bool:
    """ "Between the plate and the cup": one thing has nothing between it."""
    first = element_at(c.elements, i - 2)
    joined = getattr(element_at(c.elements, i - 1), "low", "") == "and"
    if not isinstance(first, Mention) or first is not s.last or not joined or m.after_prep:
        return False
    return first.after_prep == "between" and not first.plural and not first.coordinated


def _coordinated(c: Clauses, s: State, i: int) -> bool:
    """Whether a conjunction or a comma links a noun to the one before."""
    link, before = (element_at(c.elements, i - n) for n in (1, 2))
    if not isinstance(link, Word) or s.last is None or not isinstance(before, (Mention, Word)):
        return False
    return link.kind == "conj" or link.low in (",", "then", "finally", "lastly")


def _property(c: Clauses, s: State, m: Mention, listed: bool) -> bool:
    """ "radius 9 cm and mass 2 kg"."""
    if not listed or not m.attribute or m.head not in OWNED or m.possessor is not None:
        return False
    if s.frame is not None or s.last is None or s.last.attribute:
        return False
    c.attachments.append((s.last, Phrase("with", m)))
    return True


def _begins_clause(c: Clauses, s: State, m: Mention, i: int) -> bool:
    """Whether a noun without a preposition is the subject of a clause that it begins."""
    previous = element_at(c.elements, i - 1)
    if m.after_prep:
        return False
    if s.boundary:
        if _let_do_so(c, s, i):
            return False
        # "a clock, a pillow and a plant in a room and a ball rolls"
        return finite_ahead(c.elements, i + 1) and not _in_a_list(c, s, previous, i)
    if s.frame is None:
        return False
    verb = element_at(c.elements, i + 1)
    after_noun = isinstance(previous, Mention)
    acts = isinstance(verb, Verb) and not verb.infinitive and verb.form in ("s", "past")
    if after_noun and acts and m.pronoun in ("it", "he", "she", "they"):
        s.boundary, s.boundary_kind = True, "comma"
        return True
    state = after_noun or "state" in getattr(previous, "extra", ())
    first = s.frame.subordinate and s.frame.start_of_sentence
    if state and first and finite_ahead(c.elements, i + 1):
        s.boundary, s.boundary_kind = True, "comma"  # "After being hit by a truck a cone ..."
    return False


def _let_do_so(c: Clauses, s: State, i: int) -> bool:
    """ "Let a ball and a cube slide": one more of those that do so, and no clause of its own."""
    before, joined = element_at(c.elements, i - 2), element_at(c.elements, i - 1)
    lets = s.frame is not None and s.frame.verb.lemma in _LETS and before is s.frame.object
    verb = element_at(c.elements, i + 1)
    does = isinstance(verb, Verb) and verb.form == "base" and not verb.auxiliary
    return lets and before is s.last and isinstance(joined, Word) and joined.low == "and" and does


def _says_nothing(c: Clauses, s: State, m: Mention, i: int) -> bool:
    """ "cyclists, who all avoid it", "and this time it goes in"."""
    if m.after_prep:
        return False
    ahead = element_at(c.elements, i + 1)
    floats = m.pronoun in ("all", "both", "each") and isinstance(ahead, Verb)
    if floats and s.boundary_kind == "rel" and s.relative is not None:
        return True
    return m.attribute and m.head in _OCCASIONS and m.determiner in _THIS


def _subject_of_relative(s: State, m: Mention) -> None:
    """ "the box that the ball hits"."""
    whole = s.frame.object or s.frame.subject if s.frame is not None else None
    assert s.relative is not None
    if whole is not None and m.determiner == "the" and m.head == s.relative.head:
        s.relative = whole  # "a fence behind a van, which the van backs into"
    s.subject = s.last = m
    s.boundary = False
    s.boundary_kind = "objrel" if s.boundary_kind == "rel" else "own"


def _part_of_a_phrase(c: Clauses, s: State, m: Mention, i: int) -> None:
    """ "rolls off the table": a noun after a preposition."""
    _attach(c, s, Phrase(m.after_prep, m), i)
    if not m.attribute:
        s.last, s.last_after_prep = m, True
    if s.frame is not None:
        s.boundary = False


def _more_subjects(s: State) -> bool:
    return s.frame is None and s.subject is not None and s.boundary_kind in ("conj", "comma")


def _subject(s: State, m: Mention, new_clause: bool) -> None:
    s.last = m
    if s.frame is None and s.subject is not None and not s.boundary:
        return
    if s.frame is None or new_clause:
        s.last_after_prep = False
    s.subject, s.frame, s.boundary = m, None, False


def _object(frame: Frame, m: Mention) -> None:
    if frame.object is None and not frame.verb.passive:
        frame.object = m
    elif frame.object2 is None:
        frame.object2 = m


def runs_on(c: Clauses, i: int) -> bool:
    """Whether the conjunction before a participle follows the clause without a comma."""
    return getattr(element_at(c.elements, i - 2), "low", "") != ","


def _stated_of_it(c: Clauses, s: State, m: Mention, i: int) -> bool:
    """ "its radius is 12 cm and its mass 4 kg", "one ball weighs 5 g, the other 8 g"."""
    value = element_at(c.elements, i + 1)
    subject = s.frame.subject if s.frame is not None else s.subject
    if not isinstance(value, Word) or value.amount is None or subject is None:
        return False
    if m.attribute and m.head in OWNED and m.determiner in lex.POSSESSIVES:
        c.attachments.append((subject.possessor or subject, Phrase("with", m)))
        return True
    bare = m.attribute and m.head in PROPERTIES and not m.determiner
    last = s.last
    if bare and s.boundary_kind in ("conj", "comma") and last is not None and not last.attribute:
        c.attachments.append((last, Phrase("with", m)))  # "height 5 cm and radius 1 cm"
        return True
    told = s.frame is not None and s.frame.verb.sense in ("weigh", "measure") and s.boundary
    if told and not m.attribute and m is not subject:
        m.amounts.append(value.amount)
        c.told.add(id(value))
        return True
    return False


def _stated_beside(c: Clauses, m: Mention, i: int) -> bool:
    """ "the red sphere (mass 2 kg)": the property belongs to the noun before."""
    els = c.elements
    if not m.attribute or i < 2 or i + 1 >= len(els):
        return False
    owner, mark, value = els[i - 2], els[i - 1], els[i + 1]
    if getattr(value, "low", "") in (":", "=", "of", "is") and i + 2 < len(els):
        value = els[i + 2]  # "(mass: 5 kg)"
    if not (isinstance(owner, Mention) and isinstance(mark, Word) and isinstance(value, Word)):
        return False
    if mark.low not in "(,–—-" or value.amount is None or owner.pronoun or owner.attribute:
        return False
    if value.amount.dimension not in ("mass", "length") or m.head not in PROPERTIES:
        return False
    owner.amounts.append(value.amount)
    if value.amount.dimension == "length":
        owner.adjectives.append(f"@{value.amount.start}:{m.head}")
    c.told.add(id(value))
    return True


def _attach(c: Clauses, s: State, phrase: Phrase, i: int) -> None:
    """Gives a phrase to the verb, to the noun before it, or to what is to come."""
    m = phrase.mention
    assert m is not None
    if _goes_with_it(c, s, phrase, m, i) or _gapped(c, s, phrase, i):
        return
    if s.frame is None:
        _attach_to_noun(c, s, phrase, m)
    elif _rides_on_it(s, s.frame, phrase, m):
        s.frame.phrases.append(phrase)
    elif (sent := _sent_there(c, s.frame, phrase, i)) is not None:
        sent.phrases.append(phrase)
    elif _of_the_verb(s, s.frame, phrase, m):
        s.frame.phrases.append(phrase)
    elif s.boundary and s.boundary_kind == "comma" and finite_ahead(c.elements, i + 1):
        s.loose.append(phrase)
    elif not _of_the_noun(c, s, s.frame, phrase, m, i):
        s.frame.phrases.append(phrase)


def _rides_on_it(s: State, f: Frame, phrase: Phrase, m: Mention) -> bool:
    """ "Slides down a hill on a sledge": no hill is on a sledge, who slides is."""
    way = s.last.noun if s.last is not None and s.last_after_prep else None
    rider = f.subject.noun if f.subject is not None else None
    if phrase.prep not in ("on", "in") or way is None or rider is None or m.noun is None:
        return False
    return rider.kind in _BEINGS and way.kind in _WAYS and m.noun.kind in _RIDDEN


def _sent_there(c: Clauses, f: Frame, phrase: Phrase, i: int) -> Frame | None:
    """ "Launches a bear sitting on a plank into the air and over a hedge": not where it sits."""
    sends = f.parent
    rests = f.reduced and f.verb.sense in ("posture", "be", "park") and f.object is None
    if not rests or sends is None or sends.object is not f.subject or sends.verb.passive:
        return None
    ways = _OVER if f.phrases else _OUT  # "kicks a ball lying on the grass over a fence"
    goes = sends.verb.sense in _SENDING and phrase.prep in ways
    joined = getattr(element_at(c.elements, i - 2), "low", "") == "and"
    again = joined and any(p.prep in _OUT for p in sends.phrases) and phrase.prep in _OVER
    return sends if goes or again else None


def _goes_with_it(c: Clauses, s: State, phrase: Phrase, m: Mention, i: int) -> bool:
    """ "A tent with a flag behind it and a pot in front of it": the pot is there."""
    y, link = element_at(c.elements, i - 2), element_at(c.elements, i - 3)
    if m.pronoun not in _GONE_WITH or not isinstance(y, Mention) or y.after_prep or y.pronoun:
        return False
    if getattr(link, "low", "") not in ("and", ",") or s.subject is y:
        return False
    k = next((k for k in range(i - 4, 0, -1) if getattr(c.elements[k], "low", "") in _WITH), 0)
    owner = element_at(c.elements, k - 1)
    owner = element_at(c.elements, k - 2) if getattr(owner, "low", "") == "," else owner
    if getattr(c.elements[k], "low", "") != "with" or not isinstance(owner, Mention):
        return False
    for x in c.mentions:
        x.coordinated[:] = [z for z in x.coordinated if z is not y]
    c.attachments += [(owner, Phrase("with", y)), (y, phrase)]
    return True


def _gapped(c: Clauses, s: State, phrase: Phrase, i: int) -> bool:
    """ "A spoon lies in a red cup and a fork next to a blue one": the fork is there."""
    y, link = element_at(c.elements, i - 2), element_at(c.elements, i - 3)
    if s.frame is None or s.frame.verb.sense != "posture" or not isinstance(y, Mention):
        return False
    if s.frame.object is not None or not any(p.prep in _PLACED for p in s.frame.phrases):
        return False
    new = y.determiner in ("a", "an", "one") and not y.after_prep and not y.attribute
    joined = getattr(link, "low", "") == "and" and isinstance(
        element_at(c.elements, i - 4), Mention
    )
    if not (new and joined and phrase.prep in _PLACED) or finite_ahead(c.elements, i + 1):
        return False
    for x in c.mentions:
        x.coordinated[:] = [z for z in x.coordinated if z is not y]
    c.attachments.append((y, phrase))
    return True


def _of_the_verb(s: State, f: Frame, phrase: Phrase, m: Mention) -> bool:
    """Phrases that belong to the verb, whatever stands before them."""
    if phrase.prep in ("at", "against") and not s.boundary and f.verb.sense == "launch":
        return True  # "throws a ball at a wall": not a ball at a wall
    if phrase.prep == "with" and m.pronoun in ("it", "them"):
        return True  # "takes the pin with it"
    if phrase.prep == "by" and f.verb.passive:
        return True
    if phrase.prep == "with" and m.determiner in lex.POSSESSIVES and m.head in lex.BODY_PARTS:
        return f.verb.sense not in ("be", "posture", "have")  # "shuts a chest with his elbow"
    owned = phrase.prep == "with" and m.head in PROPERTIES and s.last is not f.subject
    return m.attribute and phrase.prep != "of" and not owned


def _of_the_noun(c: Clauses, s: State, f: Frame, phrase: Phrase, m: Mention, i: int) -> bool:
    """Attaches a phrase to the noun it follows, if it says something of that."""
    noun = s.last
    if noun is None:
        return False
    if phrase.prep == "of":
        if noun.head in lex.BODY_PARTS | lex.OWN_PARTS:
            noun.possessor = noun.possessor or m
        elif not noun.attribute:
            c.attachments.append((noun, phrase))
        else:
            return False
        return True
    follows = isinstance(element_at(c.elements, i - 2), Mention)
    if phrase.prep not in _OF_NOUNS or not follows or noun.pronoun in ("it", "them"):
        return False  # "pulls a wagon with a bear in it along a road"
    if f.object is not noun and not s.last_after_prep:
        return False
    c.attachments.append((noun, phrase))
    beside = noun.after_prep == "with" and phrase.prep in lex.BESIDE
    put = f.object is not None and noun.after_prep in _INTO and phrase.prep in lex.BESIDE
    put = put and f.verb.sense == "posture" and not m.pronoun  # "in the bowl beside the mug"
    if f.verb.sense in _ALSO_OF_VERBS and not beside and not put:
        f.phrases.append(phrase)  # not "a clock hangs on a wall with a lamp to the right of it"
    return True


def _attach_to_noun(c: Clauses, s: State, phrase: Phrase, m: Mention) -> None:
    """Attaches a phrase that comes before any verb."""
    owner, last = s.subject, s.last or s.subject
    of = phrase.prep == "of"
    measured = owner if owner is not None and owner.attribute and owner.head in OWNED else None
    if of and measured is not None and measured.possessor is None:
        measured.possessor = m  # "the speed of the car"
        return
    part = last if last is not None and last.head in lex.OWN_PARTS - {"door"} else None
    if of and part is not None and not part.possessor and not s.boundary:
        part.possessor = m  # "a wheel of the cart hits a stone"
        return
    if owner is None or s.boundary:
        s.loose.append(phrase)
    else:
        its_side = m.head in ("left", "right") and m.determiner in lex.POSSESSIVES
        near = last if (its_side or phrase.prep in _OF_NOUNS) and last is not None else owner
        c.attachments.append((near, phrase))
