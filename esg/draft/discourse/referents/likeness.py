"""Nouns outside the lexicon: what they are like, and so their size, shape and behaviour."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import nameless
from esg.lexicon import Kind, kinds
from esg.lexicon.hypernyms import hypernyms
from esg.lexicon.senses import no_things

_PEOPLE = re.compile(
    r"(?:man|men|woman|women|person|(?<!e)ist|player|keeper|worker|driver|officer|smith|monger"
    r"|(?<=.)dresser|herder|ologist|ographer|istrator|in-law|brother|sister|mother|father)$"
    r"|^(?:step|grand|ex-|god|vice-)(?!stand)\w+"
)
"""Words that name persons by how they are built."""
_ROOTED_KG = 100.0
"""What is lighter and only like a fixture may move."""
_OF_THE_GROUND = frozenset({"structural", "decal"})
_SCENES = lex.word_set("scenes")
_ALIKE = lex.word_set("behave alike")
_NO_SUCH = lex.word_set("drawn as another")
_DRIVEN = frozenset({"flyer", "vehicle", "watercraft"})
_TWINS = lex.word_set("twins")


def unknown_noun(head: str, adjectives: list[str] | None = None) -> lex.Noun:
    """What a noun outside the lexicon is taken for.

    Args:
        head: The noun ("bookkeeper", "yo-yo", "feeder").
        adjectives: What stands before it, of which the last may be part of the noun ("bird").

    Returns:
        A person, what the noun is like (`Noun.like` says so), or a box of 40 cm.
    """
    if _PEOPLE.search(head):
        like = lex.nouns()["person"]
        return replace(like, name=head, description=f"{head}, a person", synonyms=(), like="person")
    before = [a for a in (adjectives or [])[-1:] if a.isalpha()]
    one = [head.removesuffix("s")] if head in _TWINS else []  # "the tongs", in WordNet "tong"
    said = [re.sub(r"[^a-z0-9]+", " ", w) for w in (" ".join([*before, head]), head, *one)]
    return next((n for words in said if (n := _like(words, head))), None) or nameless(head)


@cache
def _like(words: str, head: str) -> lex.Noun | None:
    """The noun with figures and behaviour of the kind nearest to it; None if there is none."""
    own, above = _drawn().get(words), hypernyms().get(words)
    kind = own or (_named().get(above.kind) if above is not None else None)
    if kind is None:
        return None
    model = _behaves(kind)
    model = replace(model, traits=model.traits - {"topples"})  # it falls as other things do
    place = no_things().get(head) == "place" or head in _SCENES
    if _OF_THE_GROUND & model.traits or (place and model.kind in ("animal", "person")):
        return None  # a quarry is no game
    if model.kind not in _ALIKE or place:
        model = replace(model, kind="generic")
    figures = above if own is None else None
    none_such = words in _NO_SUCH or (own is None and above is not None and above.stands_in)
    mass = figures.mass_kg if figures is not None else None
    if (mass or kind.mass_kg) < _ROOTED_KG:
        model = replace(model, traits=model.traits - {"fixed"})  # "a tumbleweed" is like a bush
    longest = figures.longest_cm if figures is not None else None
    scale = longest / max(kind.dimensions_cm) if longest else 1.0
    length, width, height = (round(scale * d, 3) for d in kind.dimensions_cm)
    cube = length == width == height
    return replace(
        model,
        name=head,
        dimensions_cm=(length, width, height),
        mass_kg=mass or max(round(kind.mass_kg * scale**3, 4), 0.001),
        shape="" if cube and model.shape == "box" else model.shape,
        description=head,
        synonyms=(),
        like=f"{kind.name} of {max(length, width, height):g} cm",
        stand_in=kind.name if none_such else "",
    )


def names_another(words: str, last: str) -> bool:
    """ "A pipe cleaner": whether a noun of two words is another thing than its last one names.

    So it is where the library has a row of its own for it, of another size or behaviour, or where
    WordNet puts it under a concept that is not its last word, and the kind that stands for it
    is not that of the last word.

    Args:
        words: The noun as the dictionaries spell it, in the singular and lower case ("cable car").
        last: Its last word, a noun of the lexicon.
    """
    own, above = _drawn().get(words), hypernyms().get(words)
    kind = own or (_named().get(above.kind) if above is not None else None)
    head = lex.nouns()[last]
    if kind is None or "part" in kind.flags or _OF_THE_GROUND & head.traits:
        return False  # "a bus lane"
    behaves = _behaves(kind).kind
    if head.kind == behaves == "person" or head.kind in _DRIVEN:
        return False  # a cable car goes as cars do
    if own is not None:
        ratio = max(own.dimensions_cm) / max(head.dimensions_cm)
        return own.name != head.name and (behaves != head.kind or not 0.5 < ratio < 2.0)
    assert above is not None
    if head.kind == "person":
        return True  # "a mud guard", "a pipe cleaner"
    named = _drawn().get(last)
    hyponym = above.concept == last and named is not None and named.name == last  # "a bell tower"
    return above.stands_in and above.kind != head.category and not hyponym


def in_wordnet(words: str) -> bool:
    """Whether WordNet has a noun of a thing that is spelled so, in the singular and lower case."""
    return words in hypernyms()


def in_dictionary(words: str) -> bool:
    """Whether the library or WordNet has a noun of a thing that is spelled so.

    Args:
        words: The noun in the singular and lower case.
    """
    return words in _drawn() or words in hypernyms()


@cache
def _named() -> dict[str, Kind]:
    """Kinds that are drawn, by name with underscores."""
    return {kind.slug: kind for kind in kinds() if kind.builder}


@cache
def _drawn() -> dict[str, Kind]:
    """Kinds that are drawn, by every name that the library knows."""
    found: dict[str, Kind] = {}
    for kind in _named().values():
        for name in (kind.name, *kind.found_as):
            found.setdefault(re.sub(r"[^a-z0-9]+", " ", name), kind)
    return found


@cache
def _behaves(kind: Kind) -> lex.Noun:
    """A noun that moves and behaves like a kind, be that one of the drafter's or not."""
    if kind.name in lex.nouns():
        return lex.nouns()[kind.name]
    classes = {noun.kind for noun in lex.nouns().values()}
    return lex.Noun(
        name=kind.name,
        kind=next((p for p in kind.parents if p in classes), "generic"),
        dimensions_cm=kind.dimensions_cm,
        mass_kg=kind.mass_kg,
        material=kind.material or "plastic",
        shape="",
        traits=frozenset({"fixed", "wheeled", "container"} & kind.flags)
        | frozenset({"round"} if "rolls" in kind.flags else ())
        | frozenset({"rolls"} if kind.rolls else ()),
        description=kind.name,
    )
