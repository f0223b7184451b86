"""Who "they" are that meet, "the first one" of two alike, and "the rest" of a plural."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity

_KINDS = lex.word_set("kinds")


def meeting(subjects: list[list[str]], recent: list[str], entities: dict[str, Entity]) -> list[str]:
    """ "A car passes a lorry, a bus comes and they collide": the car and the bus.

    Args:
        subjects: Node ids of the subjects so far, in the order of the text.
        recent: Ids of what was named, the last one first; two at least.
        entities: Objects by node id.

    Returns:
        Ids of the two, or none where the last clause is about something else.
    """
    told = [ids[0] for ids in subjects[-3:] if len(ids) == 1 and ids[0] in entities]
    two = list(dict.fromkeys(reversed(told)))[:2]
    if len(two) < 2 or two[0] != recent[0] or two[1] == recent[1]:
        return []
    return two[::-1] if all(entities[i].noun.kind in _KINDS for i in two) else []


def before_this(ordinal: str | None, avoid: list[str], entities: dict[str, Entity]) -> list[str]:
    """ "A second car runs into the first one": the one like it that was named before.

    Args:
        ordinal: The ordinal of the phrase, if it has one.
        avoid: Ids of the clause's subject.
        entities: Objects by node id.
    """
    actor = entities.get(avoid[0]) if len(avoid) == 1 else None
    if ordinal != "first" or actor is None or actor.group is not None:
        return []
    if not {"second", "third", "another"} & {*actor.adjectives, actor.place}:
        return []
    like = [e for e in entities.values() if e.noun == actor.noun and e.id != actor.id]
    return [like[0].id] if like and all(e.group is None for e in like) else []


def the_others(
    salience: list[list[str]], groups: dict[str, list[str]], entities: dict[str, Entity]
) -> list[str]:
    """ "the first pipe hits a cone, and the rest roll away": all but the ones told of.

    Args:
        salience: Ids of what was named so far, in the order of the text.
        groups: Members of plurals by group.
        entities: Objects by node id.
    """
    for ids in reversed(salience):
        group = groups.get(entities[ids[0]].group or "", []) if ids and ids[0] in entities else []
        if len(group) < 2 or not set(ids) < set(group):
            continue
        named = [i for i in group if entities[i].place] or ids
        return [i for i in group if i not in named]
    return []
