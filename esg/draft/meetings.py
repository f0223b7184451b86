"""Who "they" are that meet: two things that single clauses set in motion."""

from __future__ import annotations

from esg.draft.entities import Entity

_KINDS = frozenset({"vehicle", "cart", "toyvehicle", "robot"})


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
