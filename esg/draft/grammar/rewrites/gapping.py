"""Clauses of which only a noun is told: "then the red cube", ", followed by a dog".

Such a noun does, or undergoes, what the clause before tells: it becomes "and then the red cube does
the same", of which `clauses.builder` makes the clause.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.conditions import STOPS, is_prep, is_word, kind_of, word_at
from esg.draft.text.elements import Element, Mention, Verb, Word, element_at

_FOLLOWED = frozenset({"follow", "accompany"})
_CHASED = lex.word_set("chased")
_SENT = frozenset({"drop", "launch", "posture", "pocket", "carry", "pick", "roll", "slide"})
"""Senses of which the object goes somewhere."""
_MOVES = frozenset({"own", "noop", "tow"})
_PLAIN = frozenset({"own", "fly", "cross", "coast", "continue", "leave"})
"""Senses of those who go along, and of whom no event is told."""
_ENDS_OF_WAYS = frozenset({"off", "from", "out of", "into", "onto", "in", "on"})
_BY_THE_WAY = frozenset({"past", "through", "over", "across", "around", "round"})
_ACTORS = frozenset({"person", "animal", "vehicle", "robot", "flyer"})
_ARRIVES = lex.word_set("arrives (gapping)")
_BY = frozenset({"pass", "enter"})
_LISTED = frozenset({"and", ","})


@dataclass
class _Clause:
    """The last clause that was told: its verb, who acts, on what, and what its phrases name."""

    verb: Verb
    subject: Mention | None
    object: Mention | None
    others: list[Mention]
    first: bool
    arrives: bool
    way: str
    """The last preposition before a noun."""


def fill_gaps(elements: list[Element]) -> list[Element]:
    """Gives nouns that go on from a clause a verb.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        i += _followed(elements, i, out) or _then(elements, i, out)
        if i < len(elements):
            out.append(elements[i])
        i += 1
    return out


def _followed(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "A ball falls into a bin, followed by a cube", "runs off, chased by a dog"."""
    j = i + 1 if is_word(elements[i], ",") else i
    verb, who = element_at(elements, j), element_at(elements, j + 2)
    told = isinstance(verb, Verb) and verb.form in ("past", "pp") and not verb.auxiliary
    if not told or not is_word(element_at(elements, j + 1), "by") or not isinstance(who, Mention):
        return 0
    clause = _before(out)
    if clause is None or who.attribute or not isinstance(verb, Verb):
        return 0
    if verb.lemma == "lead":
        follow = replace(verb, lemma="follow", sense="follow", form="s", passive=False, extra={})
        out += [Word(verb.start, verb.start, "conj", "and"), follow]
        return j + 2 - i
    if verb.lemma not in _FOLLOWED | _CHASED:
        return 0
    role = "behind" if verb.lemma in _CHASED else _role_of_follower(clause, who)
    if verb.lemma == "accompany":
        role = "subject"
    used = _does_same(elements, j + 2, out, verb, role, then=verb.lemma == "follow")
    return j + 2 + used - i


def _role_of_follower(clause: _Clause, who: Mention) -> str:
    if _sends(clause) and kind_of(who) != kind_of(clause.subject or who):
        return "object"
    alone = clause.object is None and not clause.others
    going = clause.verb.sense in _PLAIN or (clause.verb.lemma in _BY and alone)
    ends = clause.first or clause.arrives or clause.verb.passive
    return "behind" if going and not ends else "subject"


def _sends(clause: _Clause) -> bool:
    """Whether a clause tells where its object goes."""
    senses = _SENT | _MOVES if clause.others else _SENT
    return clause.object is not None and clause.verb.sense in senses and not clause.verb.passive


def _then(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Put the blue cube in the bin, then the red cube", "lands first, and then the dog"."""
    j = i
    while is_word(element_at(elements, j), ",", "and", "then", "finally", "lastly"):
        j += 1
    words = {e.low for e in elements[i:j] if isinstance(e, Word)}
    who = element_at(elements, j)
    if not words - _LISTED or not isinstance(who, Mention) or who.attribute:
        return 0
    end = _end_of_phrase(elements, j)
    after = word_at(elements, end)
    clause = _before(out)
    if clause is None or (end < len(elements) and (after is None or not _ends(after))):
        return 0
    role = _role_of_next(clause, who)
    if not role:
        return 0
    _name(who, clause.object if role == "object" else clause.subject)
    verb = Verb(who.start, who.end, "do", "be", "s")
    return j - i + _does_same(elements, j, out, verb, role, then=True)


def _name(one: Mention, model: Mention | None) -> None:
    """ "Drops a red cube, and then a green one": a green cube."""
    if one.pronoun == "one" and model is not None and model.noun is not None:
        one.pronoun, one.head, one.noun, one.known = "", model.head, model.noun, model.known
        one.text = f"{one.text.removesuffix(' one')} {model.head}"


def _ends(w: Word) -> bool:
    return w.low in (*STOPS, ",") or w.kind in ("conj", "sub")


def _role_of_next(clause: _Clause, who: Mention) -> str:
    """Whether it acts as the subject did, or is acted on; "" where it is only one more place."""
    elsewhere = any(_alike(who, m) for m in clause.others)
    one = who.pronoun == "one"
    sent = _sends(clause)
    if clause.first and clause.subject is not None and not sent:
        return "subject"
    if sent and not elsewhere and (clause.others or one or _alike(who, clause.object)):
        return "object"
    named = elsewhere or _alike(who, clause.object)
    if sent or named or clause.subject is None:
        return ""
    goes = clause.way in _ENDS_OF_WAYS and clause.object is None and not _stands(who)
    if goes or _alike(who, clause.subject) or _of_its_sort(clause, who):
        return "subject"
    by = clause.way in _BY_THE_WAY and clause.object is None and bool(kind_of(who))
    return "place" if by else ""


def _of_its_sort(clause: _Clause, who: Mention) -> bool:
    """ "A fox jumps over a fence, then its cubs": who acts is a living thing or a vehicle, too."""
    kind, acts = kind_of(who), kind_of(clause.subject) if clause.subject is not None else ""
    met = [clause.object, *clause.others]
    if any(m is not None and kind_of(m) in _ACTORS for m in met):
        return False
    own = who.determiner in lex.POSSESSIVES and kind in ("", "animal", "person")  # "then its cubs"
    return own or (kind == acts and kind in _ACTORS)


def _stands(m: Mention) -> bool:
    """Whether a noun names what other things are on or in."""
    return m.noun is None or bool({"support", "container", "structural", "fixed"} & m.noun.traits)


def _alike(m: Mention, other: Mention | None) -> bool:
    """Whether both name things of one noun."""
    if other is None or not m.head:
        return False
    same = m.noun is not None and other.noun is not None and m.noun.name == other.noun.name
    return same or m.head == other.head


def _asserts(verb: Verb, told: list[Element]) -> bool:
    """Whether a clause ends with a verb that says what happens; so does a caption's participle."""
    if verb.infinitive or verb.negated:
        return False
    finite = any(isinstance(e, Verb) and e.form != "ing" for e in told)
    return verb.form != "ing" or not finite  # "A horse trotting around a ring": a caption


def _before(out: list[Element]) -> _Clause | None:
    """The clause that has just been told; None at the start of a sentence."""
    begin = next((k for k in range(len(out), 0, -1) if is_word(out[k - 1], *STOPS)), 0)
    told = out[begin:]
    k = next((k for k in reversed(range(len(told))) if isinstance(told[k], Verb)), -1)
    verb = element_at(told, k) if k >= 0 else None
    if not isinstance(verb, Verb) or not _asserts(verb, told):
        return None
    after, before = told[k + 1 :], told[:k]
    named = [n for n, e in enumerate(after) if isinstance(e, Mention)]
    free = [n for n in named if not n or not is_prep(after[n - 1])]
    others = [m for n in named if n not in free and isinstance(m := after[n], Mention)]
    owner = next((e for n, e in reversed([*enumerate(before)]) if isinstance(e, Mention)
                  and (not n or not is_prep(before[n - 1]))), None)  # fmt: skip
    words = {e.low for e in told if isinstance(e, Word)}
    whom = after[free[0]] if free else None
    thing = whom if isinstance(whom, Mention) and not whom.attribute else None
    arrives = bool({e.low for e in after if isinstance(e, Word)} & _ARRIVES)
    ways = [e.low for n, e in enumerate(after) if n + 1 in named and isinstance(e, Word)]
    return _Clause(verb, owner, thing, others, "first" in words, arrives, (ways or [""])[-1])


def _end_of_phrase(elements: list[Element], j: int) -> int:
    """Where the noun phrase at j ends, with its phrases and what is listed with it."""
    j += 1
    while j + 1 < len(elements) and isinstance(elements[j + 1], Mention):
        link, verb = elements[j], element_at(elements, j + 2)
        acts = isinstance(verb, Verb) and verb.form != "ing"
        if acts or not (is_prep(link) or is_word(link, *_LISTED)):
            break
        j += 2
    return j


def _does_same(
    elements: list[Element], j: int, out: list[Element], at: Verb, role: str, *, then: bool
) -> int:
    """Writes "and NOUN does the same"; how many elements the noun and what links it take."""
    end = _end_of_phrase(elements, j)
    who = elements[j:end]
    notes = {"as": role, **({"then": "1"} if then else {})}
    does = replace(
        at,
        lemma="do",
        sense="be",
        form="s",
        passive=False,
        negated=False,
        auxiliary="",
        extra=notes,
    )
    same = Mention(at.start, at.end, adjectives=["same"], attribute=True)
    comma, also = (Word(at.start, at.start, "punct", ","), Word(at.start, at.start, "conj", "and"))
    out += [comma, also, *who, does, same]
    rest = end + 1 if is_word(element_at(elements, end), ",") else end
    small = word_at(elements, rest)
    if (
        small is not None
        and small.kind == "rel"
        and isinstance(element_at(elements, rest + 1), Verb)
    ):
        out.append(replace(small, kind="conj", low="and"))
        return rest + 1 - j  # "followed by a car that stops"
    return end - j
