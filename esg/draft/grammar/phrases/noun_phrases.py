"""Noun phrases: determiner, count, group word, adjectives, amounts, head, individual letters."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.noun_heads import read_head
from esg.draft.grammar.phrases.noun_questions import goes_off, is_she, side_acts
from esg.draft.grammar.phrases.noun_starts import (
    EXTENTS,
    alone,
    count_of,
    finite_after_of,
    last_of_sizes,
    lone_letter,
    noun_at_or_after,
    numbered,
    part_of_plural,
    parts_of,
    verb_next,
)
from esg.draft.grammar.phrases.nouns import low_at, match_noun, token_at
from esg.draft.grammar.phrases.reader import acts, is_adjective, known_adjective, noun_soon
from esg.draft.grammar.rewrites.nominals import RETOLD_NOUNS
from esg.draft.text.elements import Mention, Word
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings


def noun_phrase(c: Chunks, i: int) -> int | None:
    """Parses a noun phrase at token i; returns the next index or None."""
    tokens = c.tokens
    if i >= len(tokens):
        return None
    j = i
    m = Mention(tokens[i].start, tokens[i].end)
    low = low_at(c, j)
    if lone_letter(c, j):
        m.letters, m.head, m.determiner = [tokens[j].text.lstrip("#")], "@", "the"
        m.text, m.end = tokens[j].text, tokens[j].end
        while (
            low_at(c, j + 1) == "and"
            and lone_letter(c, j + 2)
            and not verb_readings(low_at(c, j + 3) if False else "")
        ):
            m.letters.append(tokens[j + 2].text)
            j += 2
            m.end = tokens[j].end
        c.elements.append(m)
        return j + 1
    previous = c.elements[-1] if c.elements else None
    retold = isinstance(previous, Word) and previous.kind in ("prep", "sub")
    if retold and low in ("this", "that") and low_at(c, j + 1) in RETOLD_NOUNS:
        m.determiner, m.head, m.attribute = low, low_at(c, j + 1), True
        m.end = tokens[j + 1].end
        m.text = c.text[m.start : m.end]
        c.elements.append(m)
        return j + 2
    if low == "the" and low_at(c, j + 1) in ("latter", "former") and alone(c, j + 2):
        m.pronoun, m.end = low_at(c, j + 1), tokens[j + 1].end
        m.text = c.text[m.start : m.end]
        c.elements.append(m)
        return j + 2
    if is_she(c, i) or (low in ("this", "that", "these", "those") and verb_next(c, j + 1)):
        m.pronoun, m.text, m.end = low, tokens[j].text, tokens[j].end
        c.elements.append(m)
        return j + 1
    # "all", "both of", "one of", "each of"
    if (
        low in ("all", "both", "each", "one", "half", "most", "some", "none")
        and low_at(c, j + 1) == "of"
    ):
        if low in ("one", "each"):
            m.count = 1
        m.single = low == "one"
        j += 2
    elif low in ("all", "both") and low_at(c, j + 1) in lex.DETERMINERS:
        j += 1
    elif part_of_plural(c, j):
        m.subset = int(parse_number(low) or 0)
        j += 2
    # determiner
    if low_at(c, j) in lex.DETERMINERS:
        m.determiner = low_at(c, j)
        if m.determiner == "no":
            m.count = 0
        j += 1
        if m.determiner in ("a", "an") and low_at(c, j) in (
            "few",
            "couple",
            "dozen",
            "hundred",
            "lot",
            "number",
            "handful",
            "pair",
        ):
            pass
    if m.determiner in lex.VAGUE_COUNTS:
        m.count, m.vague = lex.VAGUE_COUNTS[m.determiner], m.determiner != "both"
    if (
        low_at(c, j)
        in (
            "few",
            "many",
            "several",
            "multiple",
            "numerous",
            "various",
            "couple",
            "dozen",
            "dozens",
            "handful",
            "lots",
            "pair",
        )
        and low_at(c, j) != m.determiner
    ):
        word = low_at(c, j)
        if word not in lex.GROUP_WORDS or low_at(c, j + 1) != "of":
            m.count, m.vague = lex.VAGUE_COUNTS[word], word not in ("couple", "dozen", "pair")
            j += 1
    # count
    j = count_of(c, j, m)
    # group word: "set of", "row of five"
    word = lex.singular(low_at(c, j))[0]
    adjective_skip = 0
    if (
        is_adjective(c, j)
        and lex.singular(low_at(c, j + 1))[0] in lex.GROUP_WORDS
        and low_at(c, j + 2) == "of"
    ):
        adjective_skip = 1
        word = lex.singular(low_at(c, j + 1))[0]
    if (
        word in lex.GROUP_WORDS
        and low_at(c, j + 1 + adjective_skip) == "of"
        # "a pile of snow" is one thing, "a tower of blocks" several
        and ((match_noun(c, j) or (None, 1))[1] < 3 or lex.singular(low_at(c, j + 2))[1])
        and not (word in ("wall",) and low_at(c, j + 2 + adjective_skip) in lex.DETERMINERS)
    ):
        m.pattern = lex.GROUP_WORDS[word]
        m.group_word = word
        multiplier = m.count if m.count and m.count > 1 else 1
        default = {
            "pair": 2,
            "couple": 2,
            "trio": 3,
            "dozen": 12,
            "half-dozen": 6,
            "dozens": 12,
        }.get(word)
        m.count = default * multiplier if default else None
        m.vague = False
        m.plural = True
        j += 2 + adjective_skip
        if low_at(c, j) in lex.DETERMINERS:
            if low_at(c, j) in lex.VAGUE_COUNTS:
                m.count, m.vague = lex.VAGUE_COUNTS[low_at(c, j)], True
            j += 1
        j = count_of(c, j, m)
    if low_at(c, j) in ("other", "more", "additional", "extra"):
        m.adjectives.append("other")
        j += 1
        j = count_of(c, j, m)
    # adjectives and attributive amounts
    while j < len(tokens):
        token = tokens[j]
        if (
            token.kind == "qty"
            and token.amount is not None
            and token.amount.dimension in ("mass", "length", "speed", "angle", "volume")
        ):
            nxt = low_at(c, j + 1)
            nxt = nxt.lstrip("-")
            k = j + 1
            if token_at(c, k) is not None and tokens[k].text == "-":
                k += 1
                nxt = low_at(c, k)
            if not (noun_at_or_after(c, k)):
                break
            if j == i and finite_after_of(c, i, k):
                break
            if j == i and nxt in EXTENTS and last_of_sizes(c, i, k):
                break
            m.amounts.append(token.amount)
            j = k
            if nxt in EXTENTS:
                m.adjectives.append(f"@{token.amount.start}:{nxt}")
                j += 1
            continue
        if token.kind == "number" and token.text[0] == "#" and match_noun(c, j + 1):
            m.letters.append(token.text[1:])  # "the No. 4 car"
            j += 1
            continue
        listed = token_at(c, j + 1)
        if token.text == "," and m.amounts and listed is not None and listed.kind == "qty":
            j += 1  # "a 2 m long, 30 kg heavy log"
            continue
        if (
            token.kind == "punct"
            and token.text == ","
            and m.adjectives
            and is_adjective(c, j + 1)
            and noun_soon(c, j + 1)
        ):
            j += 1
            continue
        if (
            token.low == "and"
            and m.adjectives
            and is_adjective(c, j + 1)
            and m.adjectives[-1] in lex.COLORS
            and low_at(c, j + 1) in lex.COLORS
        ):
            j += 1
            continue
        noun = match_noun(c, j)
        ends_in_s = noun is not None and noun[2]
        if (
            (ends_in_s or lex.singular(token.low)[0] in lex.ATTRIBUTES)
            and m.determiner in ("a", "an")
            and m.adjectives
            and not m.group_word
            and not known_adjective(m.adjectives[-1])
            and any(r.form == "s" for r in verb_readings(token.low))
        ):
            # "a pendulum swings": an unknown noun and its verb
            m.head, m.known = lex.singular(m.adjectives.pop())[0], False
            m.end = tokens[j - 1].end
            m.text = c.text[tokens[j - 1].start : m.end]
            c.elements.append(m)
            return j
        if side_acts(c, j, m):
            m.head, m.attribute, m.end = m.adjectives.pop(), True, tokens[j - 1].end
            m.text = c.text[m.start : m.end]
            c.elements.append(m)
            return j
        if m.determiner == "the" and m.adjectives and m.adjectives[-1] in lex.ALONE:
            nxt = low_at(c, j + 1)
            after = nxt in lex.PRONOUNS or nxt in lex.DETERMINERS
            plural = noun is None or (ends_in_s and m.count is None)
            after = after or (plural and nxt in (lex.PREPOSITIONS | lex.ADVERBS) - {"of"})
            if after and any(r.form == "s" for r in verb_readings(token.low)):
                m.pronoun, m.end = "one", tokens[j - 1].end  # "the second hits it"
                m.text = c.text[m.start : m.end]
                c.elements.append(m)
                return j
        if noun is not None and (noun[1] > 1 or not is_adjective(c, j)):
            break
        if noun is not None and is_adjective(c, j) and not noun_soon(c, j + 1):
            break
        if noun is not None and is_adjective(c, j) and m.determiner and acts(c, j + 1):
            break  # "the brick slides off it": a material that is a thing of its own
        if noun is not None and not m.determiner and not m.count and goes_off(c, j + 1):
            break  # "glass slides off"
        if noun is not None and is_adjective(c, j) and numbered(c, j):
            break  # "Marble one hits marble two"
        if token.low in lex.ADVERBS and not is_adjective(c, j):
            if token.low in (
                "very",
                "too",
                "slightly",
                "heavily",
                "fully",
                "evenly",
                "brightly",
            ) and is_adjective(c, j + 1):
                j += 1
                continue
            break
        if is_adjective(c, j):
            if (
                low_at(c, j + 1) in ("one", "ones")
                and token.low in lex.PLACE_ADJECTIVES | lex.COLORS.keys()
            ):
                m.adjectives.append(token.low)
                j += 1
                break
            if token.low in lex.PARTS and not noun_soon(c, j + 1):
                break
            if (
                token.low
                in (
                    "near",
                    "past",
                    "like",
                    "over",
                    "next",
                    "inside",
                    "back",
                    "left",
                    "right",
                    "top",
                    "bottom",
                    "outer",
                    "far",
                    "opposite",
                    "last",
                    "first",
                    "close",
                    "still",
                    "fast",
                    "hard",
                    "straight",
                    "only",
                    "low",
                    "high",
                )
                and not noun_soon(c, j + 1)
                and not m.determiner
                and not parts_of(c, j + 1)
            ):
                break
            m.adjectives.append(token.low)
            j += 1
            continue
        readings = verb_readings(token.low)
        if (
            any(r.form in ("ing", "pp") for r in readings)
            and (m.determiner or m.count)
            and noun_soon(c, j + 1)
            and token.low not in lex.nouns()
        ):
            m.adjectives.append(token.low)
            j += 1
            continue
        bare = readings and all(r.form == "base" for r in readings) and bool(m.adjectives)
        if bare and m.determiner in ("a", "an") and match_noun(c, j + 1) is not None:
            m.adjectives.append(token.low)  # "an empty jam jar"
            j += 1
            continue
        break
    return read_head(c, i, j, m)
