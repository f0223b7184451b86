"""Noun phrases: determiner, count, group word, adjectives, amounts, head, individual letters."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.elements import Mention, Word
from esg.draft.nominals import RETOLD_NOUNS
from esg.draft.nounstarts import EXTENTS, NounStarts
from esg.draft.numerals import parse_number
from esg.draft.ranks import ALONE
from esg.draft.verbphrases import verb_readings


class NounPhrases(NounStarts):
    """Reads noun phrases."""

    def _noun_phrase(self, i: int) -> int | None:
        """Parses a noun phrase at token i; returns the next index or None."""
        tokens = self.tokens
        if i >= len(tokens):
            return None
        j = i
        m = Mention(tokens[i].start, tokens[i].end)
        low = self._low(j)
        if self._lone_letter(j):
            m.letters, m.head, m.determiner = [tokens[j].text.lstrip("#")], "@", "the"
            m.text, m.end = tokens[j].text, tokens[j].end
            while (
                self._low(j + 1) == "and"
                and self._lone_letter(j + 2)
                and not verb_readings(self._low(j + 3) if False else "")
            ):
                m.letters.append(tokens[j + 2].text)
                j += 2
                m.end = tokens[j].end
            self.elements.append(m)
            return j + 1
        previous = self.elements[-1] if self.elements else None
        retold = isinstance(previous, Word) and previous.kind in ("prep", "sub")
        if retold and low in ("this", "that") and self._low(j + 1) in RETOLD_NOUNS:
            m.determiner, m.head, m.attribute = low, self._low(j + 1), True
            m.end = tokens[j + 1].end
            m.text = self.text[m.start : m.end]
            self.elements.append(m)
            return j + 2
        if low == "the" and self._low(j + 1) in ("latter", "former") and self._alone(j + 2):
            m.pronoun, m.end = self._low(j + 1), tokens[j + 1].end
            m.text = self.text[m.start : m.end]
            self.elements.append(m)
            return j + 2
        if self._is_she(i) or (
            low in ("this", "that", "these", "those") and self._verb_next(j + 1)
        ):
            m.pronoun, m.text, m.end = low, tokens[j].text, tokens[j].end
            self.elements.append(m)
            return j + 1
        # "all", "both of", "one of", "each of"
        if (
            low in ("all", "both", "each", "one", "half", "most", "some", "none")
            and self._low(j + 1) == "of"
        ):
            if low in ("one", "each"):
                m.count = 1
            m.single = low == "one"
            j += 2
        elif low in ("all", "both") and self._low(j + 1) in lex.DETERMINERS:
            j += 1
        elif self._part_of_plural(j):
            m.subset = int(parse_number(low) or 0)
            j += 2
        # determiner
        if self._low(j) in lex.DETERMINERS:
            m.determiner = self._low(j)
            if m.determiner == "no":
                m.count = 0
            j += 1
            if m.determiner in ("a", "an") and self._low(j) in (
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
            self._low(j)
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
            and self._low(j) != m.determiner
        ):
            word = self._low(j)
            if word not in lex.GROUP_WORDS or self._low(j + 1) != "of":
                m.count, m.vague = lex.VAGUE_COUNTS[word], word not in ("couple", "dozen", "pair")
                j += 1
        # count
        j = self._count(j, m)
        # group word: "set of", "row of five"
        word = lex.singular(self._low(j))[0]
        adjective_skip = 0
        if (
            self._is_adjective(j)
            and lex.singular(self._low(j + 1))[0] in lex.GROUP_WORDS
            and self._low(j + 2) == "of"
        ):
            adjective_skip = 1
            word = lex.singular(self._low(j + 1))[0]
        if (
            word in lex.GROUP_WORDS
            and self._low(j + 1 + adjective_skip) == "of"
            # "a pile of snow" is one thing, "a tower of blocks" several
            and ((self._match_noun(j) or (None, 1))[1] < 3 or lex.singular(self._low(j + 2))[1])
            and not (word in ("wall",) and self._low(j + 2 + adjective_skip) in lex.DETERMINERS)
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
            if self._low(j) in lex.DETERMINERS:
                if self._low(j) in lex.VAGUE_COUNTS:
                    m.count, m.vague = lex.VAGUE_COUNTS[self._low(j)], True
                j += 1
            j = self._count(j, m)
        if self._low(j) in ("other", "more", "additional", "extra"):
            m.adjectives.append("other")
            j += 1
            j = self._count(j, m)
        # adjectives and attributive amounts
        while j < len(tokens):
            token = tokens[j]
            if (
                token.kind == "qty"
                and token.amount is not None
                and token.amount.dimension in ("mass", "length", "speed", "angle", "volume")
            ):
                nxt = self._low(j + 1)
                nxt = nxt.lstrip("-")
                k = j + 1
                if self._tok(k) is not None and tokens[k].text == "-":
                    k += 1
                    nxt = self._low(k)
                if not (self._noun_at_or_after(k)):
                    break
                if j == i and self._finite_after_of(i, k):
                    break
                if j == i and nxt in EXTENTS and self._last_of_sizes(i, k):
                    break
                m.amounts.append(token.amount)
                j = k
                if nxt in EXTENTS:
                    m.adjectives.append(f"@{token.amount.start}:{nxt}")
                    j += 1
                continue
            if token.kind == "number" and token.text[0] == "#" and self._match_noun(j + 1):
                m.letters.append(token.text[1:])  # "the No. 4 car"
                j += 1
                continue
            listed = self._tok(j + 1)
            if token.text == "," and m.amounts and listed is not None and listed.kind == "qty":
                j += 1  # "a 2 m long, 30 kg heavy log"
                continue
            if (
                token.kind == "punct"
                and token.text == ","
                and m.adjectives
                and self._is_adjective(j + 1)
                and self._noun_soon(j + 1)
            ):
                j += 1
                continue
            if (
                token.low == "and"
                and m.adjectives
                and self._is_adjective(j + 1)
                and m.adjectives[-1] in lex.COLORS
                and self._low(j + 1) in lex.COLORS
            ):
                j += 1
                continue
            noun = self._match_noun(j)
            ends_in_s = noun is not None and noun[2]
            if (
                (ends_in_s or lex.singular(token.low)[0] in lex.ATTRIBUTES)
                and m.determiner in ("a", "an")
                and m.adjectives
                and not m.group_word
                and not self._known_adjective(m.adjectives[-1])
                and any(r.form == "s" for r in verb_readings(token.low))
            ):
                # "a pendulum swings": an unknown noun and its verb
                m.head, m.known = lex.singular(m.adjectives.pop())[0], False
                m.end = tokens[j - 1].end
                m.text = self.text[tokens[j - 1].start : m.end]
                self.elements.append(m)
                return j
            if self._side_acts(j, m):
                m.head, m.attribute, m.end = m.adjectives.pop(), True, tokens[j - 1].end
                m.text = self.text[m.start : m.end]
                self.elements.append(m)
                return j
            if m.determiner == "the" and m.adjectives and m.adjectives[-1] in ALONE:
                nxt = self._low(j + 1)
                after = nxt in lex.PRONOUNS or nxt in lex.DETERMINERS
                plural = noun is None or (ends_in_s and m.count is None)
                after = after or (plural and nxt in (lex.PREPOSITIONS | lex.ADVERBS) - {"of"})
                if after and any(r.form == "s" for r in verb_readings(token.low)):
                    m.pronoun, m.end = "one", tokens[j - 1].end  # "the second hits it"
                    m.text = self.text[m.start : m.end]
                    self.elements.append(m)
                    return j
            if noun is not None and (noun[1] > 1 or not self._is_adjective(j)):
                break
            if noun is not None and self._is_adjective(j) and not self._noun_soon(j + 1):
                break
            if noun is not None and self._is_adjective(j) and m.determiner and self._acts(j + 1):
                break  # "the brick slides off it": a material that is a thing of its own
            if noun is not None and not m.determiner and not m.count and self._goes_off(j + 1):
                break  # "glass slides off"
            if noun is not None and self._is_adjective(j) and self._numbered(j):
                break  # "Marble one hits marble two"
            if token.low in lex.ADVERBS and not self._is_adjective(j):
                if token.low in (
                    "very",
                    "too",
                    "slightly",
                    "heavily",
                    "fully",
                    "evenly",
                    "brightly",
                ) and self._is_adjective(j + 1):
                    j += 1
                    continue
                break
            if self._is_adjective(j):
                if (
                    self._low(j + 1) in ("one", "ones")
                    and token.low in lex.PLACE_ADJECTIVES | lex.COLORS.keys()
                ):
                    m.adjectives.append(token.low)
                    j += 1
                    break
                if token.low in lex.PARTS and not self._noun_soon(j + 1):
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
                    and not self._noun_soon(j + 1)
                    and not m.determiner
                    and not self._parts_of(j + 1)
                ):
                    break
                m.adjectives.append(token.low)
                j += 1
                continue
            readings = verb_readings(token.low)
            if (
                any(r.form in ("ing", "pp") for r in readings)
                and (m.determiner or m.count)
                and self._noun_soon(j + 1)
                and token.low not in lex.nouns()
            ):
                m.adjectives.append(token.low)
                j += 1
                continue
            bare = readings and all(r.form == "base" for r in readings) and bool(m.adjectives)
            if bare and m.determiner in ("a", "an") and self._match_noun(j + 1) is not None:
                m.adjectives.append(token.low)  # "an empty jam jar"
                j += 1
                continue
            break
        return self._head(i, j, m)
