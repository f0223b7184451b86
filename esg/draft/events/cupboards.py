"""What comes out of a cupboard was in there, what drops through a trapdoor on it."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, movable
from esg.draft.discourse.jointed import behind_doors, is_flap
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.events.hanging import openable, row_of
from esg.draft.events.told import recent, things
from esg.draft.grammar.clauses.frames import Frame

_COMING_OUT = frozenset({"fall", "drop", "slide", "roll"})
"""Senses of how things come out of a cupboard by themselves."""


def out_of_a_cupboard(d: Discourse, f: Frame, actors: list[str]) -> list[str]:
    """Puts what falls out where it falls out of: behind the door that was told of last.

    "The fridge door opens and a bottle falls out" names no fridge, "it falls out" after "a man
    opens the fridge" is what was said to be in there.

    Returns:
        Who comes out.
    """
    through = [i for i in things(f.phrase("through")) if is_flap(d.scene, d.text, i)]
    if f.verb.sense in _COMING_OUT and through:
        place(d, [i for i in actors if i not in d.scene.supported_by], through[:1], "on")
        return actors  # "a sack drops through the trapdoor"
    told = f.phrase("out of", "from")
    if f.verb.sense not in _COMING_OUT or (told is None and "out" not in f.adverbs):
        return actors
    hollow = behind_doors(d.scene, d.text)
    if f.subject is not None and f.subject.pronoun and any(i in hollow for i in actors):
        held = d.scene.inside_of | d.scene.shut_in
        actors = [i for i, host in held.items() if host in actors][:1] or actors
    loose = [i for i in actors if i not in hollow and _waits_inside(d, i)]
    hosts = [i for i in things(told) if i in hollow]
    doors = [i for i in recent(d) if told is None and (i in hollow or openable(d, [i]))]
    for door in doors[:1] if loose and not hosts else []:
        hosts = [i for i in hollow if door in (i, hollow[i])] or _whole_of(d, door)
    place(d, loose, hosts[:1], "in")
    return actors


def _waits_inside(d: Discourse, i: str) -> bool:
    """Whether nothing is told of where a thing is or goes; not so of a drawer that slides out."""
    told = i in d.scene.supported_by or i in d.timeline.tracks
    return i in d.world.entities and not told and movable(d, i) and not openable(d, [i])


def _whole_of(d: Discourse, door: str) -> list[str]:
    """The thing whose door it is, which is there from then on: a fridge that nobody has named."""
    row = row_of(d, door)
    name = next((n for n in row.serves if n in entity_of(d, door).adjectives), "") if row else ""
    if name not in lex.nouns():
        return []
    return [add_entity(d.world, lex.nouns()[name], name, mentioned=False).id]
