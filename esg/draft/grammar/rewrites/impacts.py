"""Collisions that a noun tells: "Simulate a collision between A and B", "A collision occurs"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.gaps import mention_at, word_at
from esg.draft.text.elements import Element, Mention, Verb, Word

_HITS = lex.word_set("hits (impacts)")
_OCCUR = lex.word_set("occur")
_TO = {"lead": "to", "result": "in", "end": "in", "culminate": "in"}
_ENDS = ".;!?\n:"
_BREAKS = ".;!?\n,:-–—"


def name_impacts(elements: list[Element], i: int, out: list[Element]) -> int:
    """Appends the plain words for a collision that the noun at i tells.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
        i: Where to look.
        out: The elements before it; takes the new ones.

    Returns:
        How many elements they stand for; 0 if it tells none.
    """
    return (
        _of_two(elements, i, out)
        or _takes_part(elements, i, out)
        or _leading_to(elements, i, out)
        or _occurs(elements, i, out)
    )


def _impact(elements: list[Element], i: int) -> bool:
    """Whether a collision is named at i; "crash" and "smash" alone are read as unknown words."""
    noun, word = mention_at(elements, i), word_at(elements, i)
    if noun is not None:
        plain = noun.possessor is None and noun.determiner != "no"
        return noun.attribute and noun.head in _HITS and plain
    return word is not None and word.kind == "unknown" and word.low in _HITS


def _closes(e: Element | None, marks: str = _BREAKS) -> bool:
    return e is None or (isinstance(e, Word) and e.low != "" and e.low in marks)


def _of_two(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "A collision between a car and a van.", "Show the crash of a car into a fence."."""
    if not _impact(elements, i):
        return 0
    link, one, joint = (
        word_at(elements, i + 1),
        mention_at(elements, i + 2),
        word_at(elements, i + 3),
    )
    other = mention_at(elements, i + 4)
    if link is None or one is None or joint is None or other is None or one.attribute:
        return 0
    joints = {"between": ("and",), "of": ("and", "with", "into", "against", "on")}
    if joint.low not in joints.get(link.low, ()) or other.attribute:
        return 0
    before, after = out[-1] if out else None, elements[i + 5] if i + 5 < len(elements) else None
    asked = isinstance(before, Verb) and before.form == "base" and before.sense == "noop"
    first = out[-2] if len(out) > 1 else None
    asked = asked and (_closes(first, _ENDS) or getattr(first, "low", "") == "please")
    if not (asked or _closes(before, _ENDS) or getattr(before, "low", "") == "indeed"):
        return 0
    if isinstance(after, Verb):
        return 0
    if asked:
        assert before is not None
        out[-1] = Word(before.start, before.end, "adv", "heading")
    here = elements[i]
    if joint.low == "and":
        out += [one, joint, other, Verb(here.start, here.end, "collide", "hit", "base")]
    else:
        out += [one, Verb(here.start, here.end, "hit", "hit", "s"), other]
    return 5


def _takes_part(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "is involved in a collision with a car", "come into contact": hits it."""
    verb = elements[i]
    if not isinstance(verb, Verb) or verb.negated:
        return 0
    involved = word_at(elements, i + 1)
    k = i + 1
    if verb.sense == "be" and involved is not None and involved.low == "involved":
        k += 1
    elif not (verb.lemma == "involve" and verb.passive) and verb.lemma not in ("come", "get"):
        return 0
    into = word_at(elements, k)
    if into is None or into.low not in ("in", "into") or not _impact(elements, k + 1):
        return 0
    end = elements[k + 1].end
    link, met = word_at(elements, k + 2), mention_at(elements, k + 3)
    if link is not None and link.low == "with" and met is not None:
        out += [Verb(verb.start, end, "hit", "hit", "s", modal=verb.modal), met]
        return k + 4 - i
    if verb.sense == "be" or link is None or link.kind in ("punct", "conj"):
        out.append(Verb(verb.start, end, "collide", "hit", verb.form, modal=verb.modal))
        return k + 2 - i
    return 0


def _leading_to(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "approaches a fence, resulting in a collision": and they collide."""
    lead, to = elements[i], word_at(elements, i + 1)
    word = getattr(lead, "lemma", "") or getattr(lead, "low", "")
    stem = word.removesuffix("s").removesuffix("ing")
    if to is None or _TO.get(stem) != to.low or not _impact(elements, i + 2) or not out:
        return 0
    if not _closes(elements[i + 3] if i + 3 < len(elements) else None):
        return 0
    here = lead.start
    if isinstance(out[-1], Word) and out[-1].low in ("which", "that"):
        out.pop()
    out.append(Word(here, here, "conj", "and"))
    return _collide(elements, i, i + 2, out)


def _occurs(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "A collision occurs.", "There is a collision.", "Contact!": they collide."""
    if out and not _closes(out[-1], _ENDS + ","):
        return 0
    there, be = word_at(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    if there is not None and there.low == "there" and isinstance(be, Verb) and be.sense == "be":
        closed = _closes(elements[i + 3] if i + 3 < len(elements) else None)
        if closed and _impact(elements, i + 2) and not be.negated and _two(out):
            return _collide(elements, i, i + 2, out)
        return 0
    if not _impact(elements, i) or not _two(out):
        return 0
    noun = mention_at(elements, i)
    verb = elements[i + 1] if i + 1 < len(elements) else None
    if noun is not None and noun.determiner == "a" and isinstance(verb, Verb):
        k = i + 1 + (verb.lemma == "take")
        if verb.lemma in _OCCUR and not verb.negated and (k == i + 1 or _place(elements, k)):
            return _collide(elements, i, k, out)
        return 0
    bare = noun is None or not (noun.determiner or noun.adjectives)
    exclaimed = isinstance(verb, Word) and verb.low in "!." and verb.low != ""
    return _collide(elements, i, i, out) if bare and exclaimed else 0


def _place(elements: list[Element], i: int) -> bool:
    e = elements[i] if i < len(elements) else None
    return "place" in (getattr(e, "head", ""), getattr(e, "low", ""))


def _two(out: list[Element]) -> bool:
    """Whether two things are told of, of which one comes near the other."""
    near = [e for e in out[-12:] if isinstance(e, Verb)]
    return bool(near) and near[-1].sense in ("approach", "own", "roll", "slide", "reach")


def _collide(elements: list[Element], first: int, last: int, out: list[Element]) -> int:
    """Appends "they collide" for the elements from first to last."""
    start, end = elements[first].start, elements[last].end
    out.append(Mention(start, start, pronoun="they", text="they"))
    out.append(Verb(start, end, "collide", "hit", "base"))
    return last + 1 - first
