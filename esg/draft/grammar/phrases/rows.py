"""Members of rows: "the first domino in a row of six", "the last in a line of cars"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.nouns import low_at
from esg.draft.text.elements import Mention
from esg.draft.text.numerals import parse_number

_ENDS = lex.word_set("ends (rows)")


def _row_follows(c: Chunks, j: int) -> bool:
    """Whether "in a row of", "of the line of" and the like start at token j."""
    word = lex.singular(low_at(c, j + 2))[0]
    ordered = lex.GROUP_WORDS.get(word) in ("row", "queue", "column", "stack")
    article = low_at(c, j + 1) in ("a", "an", "the", "this", "that")
    return low_at(c, j) in ("in", "of", "from") and article and ordered


def the_rest(c: Chunks, j: int, m: Mention) -> int:
    """Reads "the rest", "the rest of them", "the rest of the cans" as the others."""
    m.pronoun, m.count = "ones", None
    m.adjectives.append("other")
    after = low_at(c, j + 1) == "of" and low_at(c, j + 2) in ("them", "these", "those")
    return j + 3 if after else j + 1


def member_of_row(c: Chunks, j: int, m: Mention) -> int:
    """Reads the row that a member with a place belongs to; the next index, 0 if there is none.

    The member becomes the whole row, with its place as what is picked of it.

    Args:
        j: Where the words after the member's noun start.
        m: The member; its adjectives hold "first", "last" and the like.
    """
    place = next((a for a in m.adjectives if a in lex.ORDINALS or a in _ENDS), "")
    if not place or m.plural or not _row_follows(c, j):
        return 0
    if low_at(c, j + 3) != "of":
        return _of_its_row(c, j, m, place)
    size = len(c.elements)
    end = c.noun_phrase(j + 1)
    row = c.elements[-1] if end is not None and len(c.elements) == size + 1 else None
    del c.elements[size:]
    if isinstance(row, Mention) and row.head and not row.pronoun and end is not None:
        if m.noun is not None and row.noun != m.noun:
            return 0
        m.noun, m.head, m.known, m.adjectives = row.noun, row.head, row.known, row.adjectives
        m.count, m.vague, m.pattern, m.group_word = (
            row.count,
            row.vague,
            row.pattern,
            row.group_word,
        )
    else:
        count = parse_number(low_at(c, j + 4)) if m.noun is not None else None
        if not isinstance(count, float) or not count.is_integer() or count < 2.0:
            return 0
        m.group_word = lex.singular(low_at(c, j + 2))[0]
        m.count, m.pattern = int(count), lex.GROUP_WORDS[m.group_word]
        m.adjectives = [a for a in m.adjectives if a != place]
        end = j + 5
    m.pick, m.pronoun, m.plural, m.determiner = place, "", True, "a"
    return end


def _of_its_row(c: Chunks, j: int, m: Mention, place: str) -> int:
    """ "The first brick in the row": of several, unless a row of them has been named."""
    word = lex.singular(low_at(c, j + 2))[0]
    named = [x for x in c.elements if isinstance(x, Mention) and (x.plural or x.group_word)]
    alike = any(x.noun is not None and x.noun == m.noun for x in named)
    if m.noun is None or alike or lex.GROUP_WORDS[word] != "row":
        return 0
    m.pattern, m.group_word, m.pick, m.plural, m.determiner = "row", word, place, True, "a"
    m.adjectives = [a for a in m.adjectives if a != place]
    return j + 3


def inner_phrase(c: Chunks, j: int, m: Mention) -> int | None:
    """ "a roll of tape": the thing itself, from the start of the whole phrase."""
    size = len(c.elements)
    end = c.noun_phrase(j)
    if end is None or len(c.elements) != size + 1:
        del c.elements[size:]
        return None
    thing = c.elements[-1]
    if not isinstance(thing, Mention):
        del c.elements[size:]
        return None
    thing.start, thing.determiner = m.start, m.determiner or thing.determiner
    thing.count, thing.plural = m.count or 1, False
    return end
