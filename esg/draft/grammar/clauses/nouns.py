"""Noun phrases of a clause: subject, object, or part of a prepositional phrase."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Phrase, State, finite_ahead, next_verb
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.grammar.clauses.words import OWNED, PROPERTIES
from esg.draft.text.elements import Element, Mention, Verb, Word

_OCCASIONS = lex.word_set("occasions")
_THIS = lex.word_set("this")


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
    m.after_prep = s.prep
    prep, s.prep = s.prep, ""
    previous = c.elements[i - 1] if i else None
    if id(m) in c.told or _stated_beside(c, m, i):
        return
    coordinated = (
        isinstance(previous, Word)
        and (previous.kind == "conj" or previous.low in (",", "then", "finally", "lastly"))
        and s.last is not None
        and isinstance(c.elements[i - 2] if i >= 2 else None, (Mention, Word))
    )
    if (
        coordinated
        and not prep
        and m.attribute
        and m.head in OWNED
        and s.frame is None
        and s.last is not None
        and not s.last.attribute
        and m.possessor is None
    ):
        c.attachments.append((s.last, Phrase("with", m)))  # "radius 9 cm and mass 2 kg"
        return
    if not prep and _stated_of_it(c, s, m, i):
        return
    new_clause = s.boundary and not prep and finite_ahead(c.elements, i + 1)
    if new_clause and _in_a_list(c, s, previous, i):
        new_clause = False  # "a clock, a pillow and a plant in a room and a ball rolls"
    following = c.elements[i + 1] if i + 1 < len(c.elements) else None
    if (
        m.pronoun in ("it", "he", "she", "they")
        and not prep
        and not s.boundary
        and s.frame is not None
        and isinstance(previous, Mention)
        and isinstance(following, Verb)
        and not following.infinitive
        and following.form in ("s", "past")
    ):
        s.boundary, s.boundary_kind, new_clause = True, "comma", True
    if (
        (isinstance(previous, Mention) or "state" in getattr(previous, "extra", ()))
        and not prep
        and not s.boundary
        and s.frame is not None
        and s.frame.subordinate
        and s.frame.start_of_sentence
        and finite_ahead(c.elements, i + 1)
    ):
        s.boundary, s.boundary_kind = True, "comma"  # "After being hit by a truck a cone ..."
    if s.boundary_kind == "whose" and m.attribute and m.possessor is None:
        m.possessor = s.relative  # "a ball whose mass is 300 g"
    ahead = c.elements[i + 1] if i + 1 < len(c.elements) else None
    floats = m.pronoun in ("all", "both", "each") and isinstance(ahead, Verb)
    if floats and s.boundary_kind == "rel" and s.relative is not None and not prep:
        return  # "cyclists, who all avoid it"
    if m.attribute and not prep and m.head in _OCCASIONS and m.determiner in _THIS:
        return  # "and this time it goes in"
    if s.relative is not None and s.boundary and s.boundary_kind in ("rel", "whose"):
        # object relative: "the box that the ball hits"
        whole = s.frame.object or s.frame.subject if s.frame is not None else None
        if whole is not None and m.determiner == "the" and m.head == s.relative.head:
            s.relative = whole  # "a fence behind a van, which the van backs into"
        s.subject = m
        s.last = m
        s.boundary = False
        s.boundary_kind = "objrel" if s.boundary_kind == "rel" else "own"
        return
    if prep:
        if s.sub and s.frame is None:
            pass
        phrase = Phrase(prep, m)
        _attach(c, s, phrase, i)
        if not m.attribute:
            s.last, s.last_after_prep = m, True
        if not s.boundary or s.boundary_kind != "comma" or s.frame is not None:
            s.boundary = s.boundary and s.frame is None
        return
    if coordinated and s.last is not None and not new_clause and s.last is not s.relative:
        s.last.coordinated.append(m)
        if s.frame is None and s.subject is None:
            s.subject = s.last
        return
    if (
        coordinated
        and s.frame is None
        and s.subject is not None
        and new_clause
        and s.boundary_kind in ("conj", "comma")
    ):
        # "a car and a truck drive": one subject
        s.subject.coordinated.append(m)
        s.boundary = False
        return
    if s.boundary or s.frame is None:
        if s.subject is not None and s.frame is None and not s.boundary:
            s.last = m
            return
        if not new_clause and s.frame is not None and s.boundary:
            verb = next_verb(c.elements, i + 1)
            if verb is None or not isinstance(
                c.elements[min(i + 1, len(c.elements) - 1)], (Verb, Word)
            ):
                s.last = m
                _absolute(c, s, m, i)
                return
            s.last = m
            _absolute(c, s, m, i)
            return
        s.subject = m
        s.frame = None
        s.boundary = False
        s.last, s.last_after_prep = m, False
        return
    frame = s.frame
    if frame.object is None and not frame.verb.passive:
        frame.object = m
    elif frame.object2 is None:
        frame.object2 = m
    s.last, s.last_after_prep = m, False


def runs_on(c: Clauses, i: int) -> bool:
    """Whether the conjunction before a participle follows the clause without a comma."""
    return getattr((c.elements[i - 2 : i - 1] or [None])[0], "low", "") != ","


def _stated_of_it(c: Clauses, s: State, m: Mention, i: int) -> bool:
    """ "its radius is 12 cm and its mass 4 kg", "one ball weighs 5 g, the other 8 g"."""
    value = c.elements[i + 1] if i + 1 < len(c.elements) else None
    subject = s.frame.subject if s.frame is not None else s.subject
    if not isinstance(value, Word) or value.amount is None or subject is None:
        return False
    if m.attribute and m.head in OWNED and m.determiner in ("its", "his", "her", "their"):
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


def _absolute(c: Clauses, s: State, m: Mention, i: int) -> None:
    """ "..., one in front of the other": a subject that a participle or phrase may follow."""
    s.subject = m
    s.boundary = False
    s.frame = None


def _attach(c: Clauses, s: State, phrase: Phrase, i: int) -> None:
    previous = s.last
    aimed = phrase.prep in ("at", "against") and not s.boundary
    if aimed and s.frame is not None and s.frame.verb.sense == "launch":
        s.frame.phrases.append(phrase)  # "throws a ball at a wall": not a ball at a wall
        return
    along = phrase.mention if phrase.prep == "with" else None
    if s.frame is not None and along is not None and along.pronoun in ("it", "them"):
        s.frame.phrases.append(phrase)  # "takes the pin with it"
        return
    if phrase.prep == "by" and s.frame is not None and s.frame.verb.passive:
        s.frame.phrases.append(phrase)
        return
    noun_attached = phrase.prep in (
        "with",
        "of",
        "on",
        "in",
        "near",
        "beside",
        "next to",
        "under",
        "behind",
        "in front of",
        "left of",
        "right of",
        "inside",
        "above",
        "between",
        "by",
        "at",
        "around",
        "against",
        "in the middle of",
        "far from",
        "opposite",
        "below",
        "along",
        "underneath",
        "outside",
        "without",
        "from",
    )
    if (
        s.frame is not None
        and phrase.mention is not None
        and phrase.mention.attribute
        and not (
            phrase.prep == "of"
            or (
                phrase.prep == "with"
                and phrase.mention.head in PROPERTIES
                and s.last is not s.frame.subject
            )
        )
    ):
        s.frame.phrases.append(phrase)
        return
    if s.frame is None:
        owner = s.subject
        if (
            owner is not None
            and owner.attribute
            and owner.head in OWNED
            and phrase.prep == "of"
            and phrase.mention is not None
            and owner.possessor is None
        ):
            owner.possessor = phrase.mention  # "the speed of the car"
            return
        last = s.last or s.subject
        owned = phrase.prep == "of" and phrase.mention is not None and not s.boundary
        part = last if last is not None and last.head in lex.OWN_PARTS - {"door"} else None
        if owned and part is not None and not part.possessor:
            part.possessor = phrase.mention  # "a wheel of the cart hits a stone"
            return
        if s.subject is not None and noun_attached and not s.boundary:
            c.attachments.append((s.last or s.subject, phrase))
        elif s.boundary or s.subject is None:
            s.loose.append(phrase)
        else:
            c.attachments.append((s.subject, phrase))
        return
    if s.boundary and s.boundary_kind == "comma" and finite_ahead(c.elements, i + 1):
        s.loose.append(phrase)
        return
    if (
        previous is not None
        and noun_attached
        and phrase.prep != "of"
        and isinstance(c.elements[i - 2] if i >= 2 else None, Mention)
        and (s.frame.object is previous or s.last_after_prep)
    ):
        c.attachments.append((previous, phrase))
        if s.frame.verb.sense in (
            "posture",
            "be",
            "launch",
            "drop",
            "hit",
            "own",
            "roll",
            "slide",
            "pocket",
            "cause",
            "knock",
            "carry",
        ):
            s.frame.phrases.append(phrase)
        return
    part = previous is not None and previous.head in lex.BODY_PARTS | lex.OWN_PARTS
    if part and previous is not None and phrase.prep == "of" and phrase.mention is not None:
        previous.possessor = previous.possessor or phrase.mention
        return
    if (
        phrase.prep == "of"
        and previous is not None
        and phrase.mention is not None
        and not previous.attribute
    ):
        c.attachments.append((previous, phrase))
        return
    s.frame.phrases.append(phrase)
