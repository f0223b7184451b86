"""The referents of a prompt: objects by node id, their groups, and who was named when."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.ranks import Facts
from esg.draft.text.elements import Mention

_LINKS = lex.word_set("links")
_RESTING = lex.word_set("resting (underway)")


class Resolve(Protocol):
    """Node ids of a noun phrase (see `world.resolve`)."""

    def __call__(
        self, m: Mention, *, subject: bool = False, avoid: list[str] | None = None
    ) -> list[str]: ...


@dataclass
class World:
    """Entities and groups in order of mention.

    `resolve` ties the recursion of reference together: what a possessor means is asked while the
    thing it possesses is looked for.
    """

    facts: Facts
    """What the prompt tells of a node."""
    resolve: Resolve
    entities: dict[str, Entity] = field(default_factory=dict[str, Entity])
    groups: dict[str, list[str]] = field(default_factory=dict[str, list[str]])
    group_words: dict[str, str] = field(default_factory=dict[str, str])
    """"tower" of "a tower of cups", by group."""
    vague: set[str] = field(default_factory=set[str])
    """Groups whose number the prompt does not say."""
    collective: set[str] = field(default_factory=set[str])
    """Groups that "it" can mean ("a tower of blocks")."""
    salience: list[list[str]] = field(default_factory=list[list[str]])
    """Referent sets, most recent last."""
    renamed: dict[str, str] = field(default_factory=dict[str, str])
    subjects: list[list[str]] = field(default_factory=list[list[str]])
    resolved: dict[int, list[str]] = field(default_factory=dict[int, list[str]])
    movers: list[str] = field(default_factory=list[str])
    """What the clause that is being read is about."""
    warnings: list[str] = field(default_factory=list[str])
    conflicts: list[str] = field(default_factory=list[str])
    """Two values stated for one property."""
    net_sport: bool = False
    """The prompt is about a game over a net, which is no goal."""
    billiards: bool = False
    """The prompt is about billiards: "the black" is a ball."""
    filled: dict[str, str] = field(default_factory=dict[str, str])
    """By what a vessel is filled with, the noun of that vessel."""
    cricket: bool = False
    """Whether the prompt is about cricket."""
    breaking: bool = False
    """Whether something is told to come apart."""


def is_solid(world: World, i: str) -> bool:
    """Whether an id is a thing of the scene, and none of its floors and walls."""
    return i in world.entities and "structural" not in world.entities[i].noun.traits


def last_group(world: World) -> list[str]:
    """Members of the plural that was named last; none while there is no plural.

    "Two cars meet between parked cars. The green one ...": one of those that act.
    """
    groups = [ids for ids in reversed(world.groups.values()) if ids[0] in world.entities]
    groups = [ids for ids in groups if not links(world, ids)]
    if not groups:
        return []
    last = groups[0]
    if all_rest(world, last):
        alike = world.entities[last[0]].noun
        acting = (g for g in groups if not all_rest(world, g))
        last = next((g for g in acting if world.entities[g[0]].noun == alike), last)
    return last


def links(world: World, ids: list[str]) -> bool:
    """Whether things are the strings and chains by which others hang, of which nothing is told."""
    return all({world.entities[i].head, world.entities[i].noun.name} & _LINKS for i in ids)


def all_rest(world: World, ids: list[str]) -> bool:
    """Whether things are called parked or waiting, which who comes and acts is not."""
    return all(_RESTING & {*world.entities[i].adjectives} for i in ids)


def named_alone(world: World) -> list[list[str]]:
    """What was named as one thing, as sets of one node id, most recent first."""
    return [ids for ids in reversed(world.salience) if len(ids) == 1]
