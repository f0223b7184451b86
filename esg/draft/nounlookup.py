"""Nouns of the lexicon among the tokens of a text."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.elements import Element, Token
from esg.draft.numerals import parse_number
from esg.draft.verbphrases import verb_readings

_TURNS_GREEN = re.compile(
    r"\s+(?:\w+\s+){1,2}?(?:to\s+|back\s+to\s+)?(?:red|green|amber)\b", re.IGNORECASE
)
NounMatch = tuple[lex.Noun, int, bool, str]
"""A noun of the lexicon: entry, tokens used, plural, phrase."""


class NounLookup:
    """Tokens with the longest noun of the lexicon at each."""

    def __init__(self, text: str, tokens: list[Token]) -> None:
        self.text = text
        self.tokens = tokens
        self.elements: list[Element] = []
        self._lows = tuple("" if t.kind == "punct" else t.low for t in tokens)
        self._nouns_at: dict[int, NounMatch | None] = {}

    def _tok(self, i: int) -> Token | None:
        return self.tokens[i] if 0 <= i < len(self.tokens) else None

    def _low(self, i: int) -> str:
        return self._lows[i] if 0 <= i < len(self._lows) else ""

    def _match_noun(self, i: int) -> NounMatch | None:
        """Longest lexicon noun at token i: entry, tokens used, plural, phrase."""
        if i not in self._nouns_at:  # asked several times, of tokens that stay as they are
            self._nouns_at[i] = self._find_noun(i)
        return self._nouns_at[i]

    def _find_noun(self, i: int) -> NounMatch | None:
        table = lex.nouns()
        if not 0 <= i < len(self.tokens):
            return None
        most = lex.longest_nouns().get(self.tokens[i].low, 1)
        for n in range(min(most, len(self.tokens) - i), 0, -1):
            window = self.tokens[i : i + n]
            if any(t.kind != "word" and (t.kind != "number" or n == 1) for t in window):
                continue
            words = [t.low for t in window]
            phrase = " ".join(words)
            last, plural = lex.singular(words[-1])
            single = " ".join([*words[:-1], last])
            for candidate, is_plural in ((phrase, False), (single, plural)):
                if candidate in table:
                    if candidate == phrase and single != phrase and single in table:
                        continue
                    if (
                        is_plural
                        and table[candidate].kind == "ground"
                        and self._lands_on(i + n - 1)
                    ):
                        return None
                    if n > 1 and is_plural and self._subject_and_verb(i, words):
                        continue
                    if n > 1 and is_plural and parse_number(words[0]) is not None:
                        continue  # "eight balls" are not "the eight ball"
                    return table[candidate], n, is_plural or words[-1] == "billiards", candidate
            dashed = "-".join(words)
            if n > 1 and dashed in table:
                return table[dashed], n, False, dashed
        if i < len(self.tokens) and self._low(i).removesuffix("s").endswith("-year-old"):
            return table["child"], 1, self._low(i).endswith("s"), "child"
        if i < len(self.tokens) and "-" in self._low(i):
            last, plural = lex.singular(self._low(i).replace("-", " "))
            if last in table:
                return table[last], 1, plural, last
        if self._low(i) in ("light", "lights") and self._of_traffic(i):
            return table["traffic light"], 1, False, "traffic light"
        return None

    def _of_traffic(self, i: int) -> bool:
        """ "The lights turn green": no lamps."""
        return _TURNS_GREEN.match(self.text, self.tokens[i].end) is not None

    def _lands_on(self, i: int) -> bool:
        """ "The brick lands on a car": a verb, no ground."""
        verb = any(r.form == "s" for r in verb_readings(self._low(i)))
        return verb and self._low(i + 1) in lex.PREPOSITIONS

    def _subject_and_verb(self, i: int, words: list[str]) -> bool:
        """ "The bus stops at the crossing": a subject with its verb, not several bus stops."""
        if i == 0 or self._low(i - 1) not in ("a", "an", "the", "this", "that", "each", "every"):
            return False
        if " ".join(words[:-1]) not in lex.nouns():
            return False
        nxt = self._low(i + len(words))
        plural_verb = nxt in lex.MODALS or nxt in ("are", "were", "have", "that", "which", "of")
        return not plural_verb and any(r.form == "s" for r in verb_readings(words[-1]))
