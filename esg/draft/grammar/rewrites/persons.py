"""What "he" and "him" mean where no person is named, and whom they cannot mean."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity

_BEINGS = frozenset({"animal", "robot"})
_HE = lex.word_set("he")
_SHE = lex.word_set("she")
_DRIVEN = lex.word_set("driven (persons)")


def of_other_gender(word: str, head: str) -> bool:
    """Whether "he" or "she" is no word for somebody called a woman or a boy.

    Args:
        word: The pronoun.
        head: The noun by which a person goes.
    """
    female = head in _SHE or head.endswith("woman")
    male = head in _HE or (head.endswith("man") and not female)
    return (word in ("he", "him", "himself") and female) or (
        word in ("she", "her", "herself") and male
    )


def named_by_no_person(
    word: str,
    entities: Mapping[str, Entity],
    salience: Sequence[Sequence[str]],
    subject: bool,
    avoid: Sequence[str],
) -> list[str]:
    """What "he" or "him" means where no known person was named.

    Args:
        word: The pronoun.
        entities: Things named so far.
        salience: Referent sets, most recent last.
        subject: Whether it is the subject of its clause.
        avoid: What it cannot mean.

    Returns:
        One id: a thing with an unknown name, which is a person from now on; else an animal or a
        robot; for an object also a vehicle ("overtakes him"). Empty if there is none.
    """
    alone = [
        entities[ids[0]]
        for ids in reversed(salience)
        if len(ids) == 1 and ids[0] in entities and ids[0] not in avoid
    ]
    for e in alone:
        if e.noun.kind == "generic" and not e.known and e.group is None:
            e.noun, e.known = lex.nouns()["person"], True
            return [e.id]
    kinds = _BEINGS if subject or word in ("she", "her") else _BEINGS | _DRIVEN
    return next(([e.id] for e in alone if e.noun.kind in kinds), [])
