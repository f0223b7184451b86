"""Several things that are told by where they are beside one: a place for each.

"A pot with a spoon to its right and a lemon behind it" is a pot, a spoon to the right of the pot,
and a lemon behind the pot.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from esg.draft import lexicon as lex
from esg.draft.text.elements import Element, Mention, Verb, Word, element_at

_THINGS = frozenset({"it", "itself"})
_PEOPLE = frozenset({"him", "her", "himself", "herself"})
_ALL = frozenset({"them", "both"})
_OWN = {"its": "it", "his": "him", "her": "her", "their": "them"}
_SIDES = {
    "left": "left of", "right": "right of", "front": "in front of", "back": "behind",
    "rear": "behind",
}  # fmt: skip
_PLACES = lex.word_set("places (companions)")
_TO_A_SIDE = frozenset({"to", "on", "at"})
_NEW = frozenset({"a", "an", "one", "another", "some", ""})
_RESTING = frozenset({"be", "posture", "park"})
_WITHIN = frozenset({"on", "in", "inside", "on top of"})
_STRANDED = lex.word_set("places without a noun")
_ENDS = frozenset({"punct", "conj", "sub"})
_MOST = 6
"""Most things that are told so of one."""


@dataclass
class _Told:
    """One thing with its place: what precedes its preposition, that, and where it ends."""

    who: list[Element]
    prep: Word
    place: Mention
    by: str
    """The pronoun of what it is beside."""
    end: int
    sided: bool = False
    """Whether a side of its owner is named ("to its left"), or it is beside several."""


@dataclass
class _Group:
    told: list[_Told] = field(default_factory=list[_Told])
    end: int = 0
    with_: bool = False
    """Whether "with" opens it."""


def set_apart(elements: list[Element]) -> list[Element]:
    """Gives each of several things that are told beside one a sentence with its place.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        group = _group(elements, i) if _opens(elements, i, out) else None
        if group is not None and not _told_of(group, out):
            group = None
        made = list(_sentences(group, out, elements[i])) if group is not None else []
        if group is not None and made:
            out += made
            i = group.end
        elif (used := _without_its_noun(elements, i, out)) > 0:
            i += used
        else:
            out.append(elements[i])
            i += 1
    return out


def _without_its_noun(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Underneath, a bus drives", "a cat sits below": of what was named before.

    Returns:
        How many elements it takes from i on, with what they mean put down; 0 if there is none.
    """
    prep, after = elements[i], element_at(elements, i + 1)
    if not isinstance(prep, Word) or prep.low not in _STRANDED:
        return 0
    whom, verb = element_at(elements, i + 2), element_at(elements, i + 3)
    opens = not out or getattr(out[-1], "low", "") in (".", ";", ":", ",", "and", "while")
    comma = getattr(after, "low", "") == ","
    if opens and comma and isinstance(whom, Mention) and isinstance(verb, Verb):
        other = _named_before(out, whom)
        if other is not None:
            out += [whom, prep, _named(other, prep)]
            return 3
    if not isinstance(after, Word | None) or getattr(after, "kind", "punct") not in _ENDS:
        return 0
    last = out[-1] if out else None
    subject = next((e for e in _clause(out) if isinstance(e, Mention)), None)
    if not isinstance(last, Verb) or last.passive or subject is None:
        return 0
    other = _named_before(out[: _index(out, subject)], subject)
    if other is None:
        return 0
    out += [prep, _named(other, prep)]
    return 1


def _index(out: list[Element], e: Element) -> int:
    return next(k for k, x in enumerate(out) if x is e)


def _named_before(out: list[Element], whom: Mention) -> Mention | None:
    """The thing that was named last, but for the one that is placed."""
    named = (m for m in reversed(out) if isinstance(m, Mention) and not m.attribute)
    found = next((m for m in named if m.noun is None or "structural" not in m.noun.traits), None)
    thing = found is not None and not found.pronoun and found.noun is not None
    return found if found is not None and thing and found.head != whom.head else None


def _opens(elements: list[Element], i: int, out: list[Element]) -> bool:
    """Whether "with" or a comma stands behind a thing."""
    e = elements[i]
    if not isinstance(e, Word) or not out or not isinstance(out[-1], Mention):
        return False
    return e.low in ("with", ",")


def _told_of(group: _Group, out: list[Element]) -> bool:
    """Whether things are told so: of what rests, or by a side; one alone not in a list."""
    verbs = [v for v in _clause(out) if isinstance(v, Verb)]
    rests = all(v.sense in _RESTING or v.form == "ing" for v in verbs)
    alone = len(group.told) == 1 and not group.with_ and not verbs
    return not alone and (rests or all(t.sided for t in group.told))


def _clause(out: list[Element]) -> Iterator[Element]:
    """The elements of the sentence so far, from its end."""
    for e in reversed(out):
        if isinstance(e, Word) and e.low in (".", ";", "!", "?", "\n"):
            return
        yield e


def _group(elements: list[Element], i: int) -> _Group | None:
    """The things from place i on with their places; None unless they end the sentence."""
    group = _Group()
    k = i + 1
    group.with_ = "with" in (getattr(e, "low", "") for e in elements[i : i + 2])
    k += group.with_ and getattr(elements[i], "low", "") == ","
    while len(group.told) < _MOST:
        told = _one(elements, k)
        if told is None:
            return None
        group.told.append(told)
        k = told.end
        following = element_at(elements, k)
        if following is None or (isinstance(following, Word) and following.low in ".;!\n"):
            break
        k += _links(elements, k)
        if k == told.end:
            return None
    group.end = k
    sided = any(t.sided for t in group.told)
    return group if sided or len(group.told) > 1 else None


def _links(elements: list[Element], k: int) -> int:
    """How many of ",", "and", "with" stand at a place."""
    n = 0
    while getattr(element_at(elements, k + n), "low", "") in (",", "and", "with") and n < 3:
        n += 1
    return n


def _one(elements: list[Element], k: int) -> _Told | None:
    """ "A lemon in front of it", "a flag fluttering behind it", "a spoon to its right"."""
    who = element_at(elements, k)
    if not isinstance(who, Mention) or who.attribute or who.pronoun or who.determiner not in _NEW:
        return None
    parts: list[Element] = [who]
    k += 1
    verb = element_at(elements, k)
    if isinstance(verb, Verb) and verb.form in ("ing", "pp") and not verb.auxiliary:
        parts.append(verb)
        k += 1
    prep, place = element_at(elements, k), element_at(elements, k + 1)
    if not isinstance(prep, Word) or not isinstance(place, Mention):
        return None
    if place.pronoun and prep.low in _PLACES:
        return _Told(parts, prep, place, place.pronoun, k + 2, place.pronoun in _ALL)
    side = place.part or place.head
    if place.attribute and side in _SIDES and prep.low in _TO_A_SIDE:
        owner = _OWN.get(place.determiner, "")
        word = replace(prep, kind="prep", low=_SIDES[side])
        return _Told(parts, word, place, owner, k + 2, True) if owner else None
    return None


def _sentences(group: _Group, out: list[Element], at: Element) -> Iterator[Element]:
    """A sentence for each thing, with what it is beside in place of the pronoun."""
    clause = [*_clause(out)]
    before = [e for e in clause if isinstance(e, Mention) and not e.attribute and not e.pronoun]
    placed = len(clause) > 1 and isinstance(clause[1], Word) and clause[1].kind == "prep"
    rests = placed and any(isinstance(e, Verb) for e in clause)
    made: list[Element] = []
    for k, told in enumerate(group.told):
        earlier = [m for t in group.told[:k] for m in t.who if isinstance(m, Mention)]
        topic = before[-1:] if rests and told.prep.low not in _WITHIN else before[:1]
        owners = _owners(told, topic, before, earlier)
        if not owners:
            return
        for owner in owners:
            made += [Word(at.start, at.start, "punct", "."), *told.who, told.prep]
            made.append(_named(owner, told.place))
    yield from made


def _owners(
    told: _Told, topic: list[Mention], before: list[Mention], earlier: list[Mention]
) -> list[Mention]:
    """What a pronoun of a group stands for; several for "them".

    Args:
        told: The thing with its place.
        topic: What the sentence is about.
        before: What the sentence named before the group, the last first.
        earlier: What the group named before.
    """
    if told.by in _PEOPLE:
        people = [m for m in before if m.noun is not None and m.noun.kind == "person"]
        return people[:1] or topic  # "a snowman with a broom beside him"
    if told.by in _ALL:
        several = [m for m in before if m.plural or (m.count or 1) > 1]
        if several and told.by != "both":
            return several[:1]
        return [*topic, *earlier] if earlier else before[:2]
    return topic if told.by in _THINGS else []


def _named(owner: Mention, place: Mention | Word) -> Mention:
    """The owner again, in place of the pronoun or of its side, or with the preposition."""
    return replace(
        owner, start=place.start, end=place.end, determiner="the", coordinated=[], entities=[],
        amounts=[], text=owner.text, part="", after_prep="",
    )  # fmt: skip
