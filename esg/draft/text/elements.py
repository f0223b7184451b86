"""Elements of shallow syntax: tokens, noun phrases, verb groups and small words."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from esg.draft import lexicon as lex
from esg.draft.text.quantities import Amount


@dataclass
class Token:
    """A word, a punctuation mark or a whole quantity."""

    text: str
    start: int
    end: int
    kind: Literal["word", "number", "punct", "qty"]
    amount: Amount | None = None
    tag: str = ""
    """spaCy's coarse part of speech, if a model is there."""

    low: str = field(init=False, repr=False, compare=False)
    """The text in lower case."""

    def __post_init__(self) -> None:
        self.low = self.text.lower()


@dataclass(frozen=True)
class Put:
    """Something that is worn, and where the words stand that say so.

    Args:
        phrase: What is worn, with its colour: "black t-shirt".
        start, end: Of the words.
        verb: Where the verb stands that says it ("wears"); None without one.
    """

    phrase: str
    start: int
    end: int
    verb: tuple[int, int] | None = None


ONE_OF_THESE = "@one of these"
"""Adjective of a phrase that says where one of those just told of is (", the van in front")."""


@dataclass
class Mention:
    """A noun phrase."""

    start: int
    end: int
    head: str = ""
    noun: lex.Noun | None = None
    determiner: str = ""
    adjectives: list[str] = field(default_factory=list[str])
    count: int | None = None
    vague: bool = False
    plural: bool = False
    letters: list[str] = field(default_factory=list[str])
    amounts: list[Amount] = field(default_factory=list[Amount])
    part: str = ""
    pattern: str | None = None
    group_word: str = ""
    single: bool = False
    """ "one of the three eggs": a single member."""
    subset: int = 0
    """2 in "two of the ten pins": how many members."""
    stacked: bool = False
    """ "the top crate of the stack": one level of a stack."""
    counted_from: str = ""
    """left, right, top ... in "the second crate from the left"."""
    pick: str = ""
    """Which member is meant: "first" in "the first of two barrels"."""
    pronoun: str = ""
    role: str = ""
    """driver, pilot: a person that stands for the vehicle."""
    text: str = ""
    drives: bool = False
    """Whether its verb is what the vehicle does ("the bus driver brakes")."""
    possessor: Mention | None = None
    attribute: bool = False
    """Names a measure or an event, not an object."""
    coordinated: list[Mention] = field(default_factory=lambda: list[Mention]())
    known: bool = True
    wears: list[Put] = field(default_factory=lambda: list[Put]())
    """What is said to be worn by it."""
    entities: list[str] = field(default_factory=list[str])
    """Filled by the world model: node ids."""
    after_prep: str = ""


@dataclass
class Verb:
    """A verb group."""

    start: int
    end: int
    lemma: str
    sense: str
    form: str
    note: str = ""
    passive: bool = False
    negated: bool = False
    auxiliary: str = ""
    infinitive: bool = False
    modal: str = ""
    """would, can, should ... of the verb group."""
    extra: dict[str, str] = field(default_factory=dict[str, str])


WordKind = Literal["prep", "adv", "conj", "punct", "rel", "sub", "qty", "to", "unknown"]
PARTING = ("punct", "conj", "sub", "rel")
"""Kinds of words between clauses."""


@dataclass
class Word:
    """Everything else: prepositions, adverbs, conjunctions, punctuation, relatives."""

    start: int
    end: int
    kind: WordKind
    low: str
    amount: Amount | None = None


Element = Mention | Verb | Word


def element_at(elements: list[Element], i: int) -> Element | None:
    """The element at a place; None before the first and after the last."""
    return elements[i] if 0 <= i < len(elements) else None
