"""Propositions of a text by a dependency parse: who does what to whom, with which small words.

The second reading of a prompt: it knows no lexicon, no frames and nothing of what was drafted.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

_SUBJECTS = frozenset({"nsubj", "nsubjpass", "csubj"})
_OBJECTS = frozenset({"dobj", "dative", "attr"})
_RELATIVES = frozenset({"who", "which", "that", "whom"})
_PLACES = frozenset({"where", "when", "why"})
_NOBODY = frozenset({"nobody", "nothing", "none", "neither", "noone"})
_HARDLY = frozenset({"hardly", "scarcely", "barely"})
_SMALL = frozenset({"prt", "advmod"})
_UNREAL_AUX = frozenset({"would", "could", "should", "might", "may", "must"})
_PARTICIPLES = frozenset({"VBG", "VBN"})


@dataclass(frozen=True)
class Arg:
    """A noun phrase by its head word.

    Args:
        start, end: The head word in the text.
        word: The head in lower case.
        tag: Its fine part of speech ("NNS").
        left: Words in lower case that determine, count or describe it.
        of: Heads of what it is of ("the edge of a table").
    """

    start: int
    end: int
    word: str
    tag: str
    left: tuple[str, ...] = ()
    of: tuple[Arg, ...] = ()


@dataclass
class Proposition:
    """One verb with what depends on it.

    Args:
        start, end: The verb in the text.
        word: The verb in lower case, as it stands.
        tag: Its fine part of speech.
        how: main, conj, participle, relative, clause, purpose.
        passive, negated, unreal: Of the verb group.
        subjects: Who does it; of passives whom it is done to.
        objects: Whom it is done to, of actives.
        agents: Of passives, after "by".
        obliques: Prepositions with what they govern.
        small: Particles and adverbs with their places.
    """

    start: int
    end: int
    word: str
    tag: str
    how: str
    passive: bool = False
    negated: bool = False
    unreal: bool = False
    subjects: list[Arg] = field(default_factory=list[Arg])
    objects: list[Arg] = field(default_factory=list[Arg])
    agents: list[Arg] = field(default_factory=list[Arg])
    obliques: list[tuple[str, int, Arg]] = field(default_factory=list[tuple[str, int, Arg]])
    small: list[tuple[str, int, int]] = field(default_factory=list[tuple[str, int, int]])

    def args(self) -> Iterator[Arg]:
        """Everything that it is about."""
        yield from (*self.subjects, *self.objects, *self.agents)
        yield from (arg for _, _, arg in self.obliques)


@dataclass(frozen=True)
class Noun:
    """A noun by what it depends on.

    Args:
        start, end: The word in the text.
        role: Its dependency; of coordinated and explaining nouns that of the first.
        prep: The preposition before it, "" if there is none.
        governors: Places of the words that it depends on: preposition and verb, or noun.
        unreal: Whether it belongs to what is only wished, tried or possible.
        tag: Its fine part of speech ("NNS").
        left: Words in lower case that determine, count or describe it.
    """

    start: int
    end: int
    role: str
    prep: str
    governors: tuple[tuple[int, int], ...]
    unreal: bool
    tag: str = ""
    left: tuple[str, ...] = ()

    def arg(self, text: str) -> Arg:
        """As an argument, to be looked up by."""
        return Arg(self.start, self.end, text[self.start : self.end].lower(), self.tag, self.left)


def nouns(doc: Any) -> list[Noun]:
    """The nouns of a parsed text, in its order.

    Args:
        doc: A spaCy document with tags and dependencies.
    """
    return [_noun(token) for token in doc if _is(token)]


def _is(token: Any) -> bool:
    return token.tag_[:2] == "NN"


def _denies(subject: Any) -> bool:
    """ "Nobody", "no dog"."""
    return subject.lower_ in _NOBODY or any(c.lower_ in ("no", "neither") for c in subject.children)


def _noun(token: Any) -> Noun:
    top = token
    while top.dep_ in ("conj", "appos") and _is(top.head) and top.head is not top:
        top = top.head
    above = [top.head, top.head.head] if top.dep_ == "pobj" else [top.head]
    aux = [c for v in above for c in v.children if c.dep_ in ("aux", "neg")]
    unreal = any(c.lower_ in _UNREAL_AUX | {"to"} or c.dep_ == "neg" for c in aux)
    unreal |= any(_denies(c) for v in above for c in v.children if c.dep_ in _SUBJECTS)
    places = tuple((t.idx, t.idx + len(t)) for t in above)
    prep = top.head.lower_ if top.dep_ == "pobj" else ""
    end, left = token.idx + len(token), _arg(token).left
    return Noun(token.idx, end, top.dep_, prep, places, unreal, token.tag_, left)


def propositions(doc: Any) -> list[Proposition]:
    """The propositions of a parsed text, in its order.

    Args:
        doc: A spaCy document with tags and dependencies.
    """
    found: dict[int, Proposition] = {}
    for token in doc:
        if token.tag_[:2] == "VB" and token.dep_ not in ("aux", "auxpass", "amod", "compound"):
            _read(token, found)
    return [found[i] for i in sorted(found)]


def _read(token: Any, found: dict[int, Proposition]) -> Proposition:
    if token.i in found:
        return found[token.i]
    p = Proposition(token.idx, token.idx + len(token), token.lower_, token.tag_, _how(token))
    found[token.i] = p
    for child in token.children:
        _child(p, child)
    _inherit(p, token, found)
    return p


def _how(token: Any) -> str:
    dep = token.dep_
    if dep == "conj" and token.head.tag_[:2] == "VB":
        return "conj"
    if dep == "relcl":
        return "relative"
    infinitive = any(c.dep_ == "aux" and c.lower_ == "to" for c in token.children)
    if infinitive:
        return "purpose"
    if dep == "acl" or (dep in ("advcl", "dep") and token.tag_ in _PARTICIPLES):
        return "participle"
    return "main" if dep == "ROOT" else "clause"


def _child(p: Proposition, child: Any) -> None:
    dep = child.dep_
    if dep in _SUBJECTS:
        p.subjects += _args(child)
        p.passive |= dep == "nsubjpass"
        p.negated |= _denies(child)
    elif dep in _OBJECTS:
        p.objects += _args(child)
    elif dep == "auxpass":
        p.passive = True
    elif dep == "neg":
        p.negated = True
    elif dep == "aux":
        p.unreal |= child.lower_ in _UNREAL_AUX
    elif dep == "agent":
        p.agents += [a for c in child.children if c.dep_ == "pobj" for a in _args(c)]
    elif dep == "prep":
        _prep(p, child)
    elif dep in _SMALL:
        p.negated |= child.lower_ in _HARDLY
        p.small += [(c.lower_, c.idx, c.idx + len(c)) for c in _coordinated(child)]
        for c in child.children:
            if c.dep_ == "prep":
                _prep(p, c)


def _prep(p: Proposition, prep: Any) -> None:
    objects = [c for c in prep.children if c.dep_ == "pobj"]
    for c in objects:
        p.obliques += [(prep.lower_, prep.idx, a) for a in _args(c)]
    for c in prep.children:
        if c.dep_ == "prep" or (c.dep_ == "conj" and c.pos_ == "ADP"):
            _prep(p, c)
    if not objects:
        p.small.append((prep.lower_, prep.idx, prep.idx + len(prep)))


def _coordinated(token: Any) -> Iterator[Any]:
    yield token
    for child in token.children:
        if child.dep_ == "conj":
            yield from _coordinated(child)


def _args(token: Any) -> list[Arg]:
    """A noun and what is coordinated with it."""
    return [_arg(t) for t in _coordinated(token) if t.tag_[:2] != "VB"]


def _arg(token: Any) -> Arg:
    left = tuple(
        c.lower_ for c in token.children if c.i < token.i and c.dep_ not in ("prep", "punct")
    )
    of = tuple(
        a
        for c in token.children
        if c.dep_ == "prep" and c.lower_ == "of"
        for o in c.children
        if o.dep_ == "pobj"
        for a in _args(o)
    )
    return Arg(token.idx, token.idx + len(token), token.lower_, token.tag_, left, of)


def _inherit(p: Proposition, token: Any, found: dict[int, Proposition]) -> None:
    """Subjects and objects that stand with another word."""
    head, dep = token.head, token.dep_
    if p.how == "relative" or (dep == "conj" and head.dep_ == "relcl"):
        noun = head if p.how == "relative" else head.head
        _relative(p, _arg(noun))
    if p.subjects:
        return
    if dep == "acl" and head.tag_[:2] != "VB":
        if p.how == "participle":
            p.passive = token.tag_ == "VBN"
            p.subjects = [_arg(head)]
        return
    if head is token or head.tag_[:2] != "VB":
        return
    above = _read(head, found)
    if dep == "conj":
        p.subjects = [*above.subjects]
        p.unreal |= above.unreal
        p.passive |= token.tag_ == "VBN" and above.passive
    elif dep in ("advcl", "xcomp", "ccomp", "dep"):
        theirs = above.objects if dep in ("xcomp", "ccomp") and above.objects else above.subjects
        p.subjects = [*theirs]
        p.passive |= token.tag_ == "VBN"


def _relative(p: Proposition, noun: Arg) -> None:
    """Puts the noun in the place of "who", "which", or of nothing."""
    roles = (p.subjects, p.objects)
    for role in roles:
        for k, a in enumerate(role):
            if a.word in _RELATIVES:
                role[k] = noun
                return
            if any(o.word in _RELATIVES for o in a.of):  # "two of which"
                role[k] = Arg(noun.start, noun.end, noun.word, noun.tag, (a.word, *a.left, "of"))
                return
    for k, (prep, at, a) in enumerate(p.obliques):
        if a.word in _RELATIVES:
            p.obliques[k] = (prep, at, noun)
            return
    if any(word in _PLACES for word, _, _ in p.small):
        return  # "toward the exit, where it knocks over a cone"
    if not p.subjects:
        p.subjects.append(noun)
    elif not p.objects and not p.passive:
        p.objects.append(noun)
