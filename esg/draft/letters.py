"""Individual names after a noun: "ball A", "balls A, B and C", "car 1", "player two"."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.elements import Mention
from esg.draft.verbgroups import VerbGroups
from esg.draft.verbphrases import verb_readings

_NAMING = frozenset({"one", "two", "three", "four", "five"})


class Letters(VerbGroups):
    """Reads individual names."""

    def _letters(self, j: int, m: Mention) -> int:
        """Individual names after a head: "ball A", "balls A, B and C", "car 1", "ball #2"."""

        def letter(k: int) -> str | None:
            token = self._tok(k)
            if token is None:
                return None
            if token.kind == "word" and re.fullmatch(r"[A-Z]", token.text):
                return token.text
            if token.low in _NAMING and not m.determiner and not m.plural and m.count is None:
                return token.low if self._match_noun(k + 1) is None else None
            if token.kind == "word" and re.fullmatch(r"[b-hj-z]", token.text):
                return token.text.upper()
            if token.kind == "word" and token.text == "a" and m.noun is not None:
                nxt = self._low(k + 1)
                known = bool(self._match_noun(k + 1)) or self._is_adjective(k + 1)
                if (verb_readings(nxt) or nxt in lex.MODALS) and not known and not m.determiner:
                    return "A"
                if nxt in ("and", "'s") and not m.determiner:
                    return "A"
            if token.kind == "number" and re.fullmatch(r"#?\d{1,2}", token.text):
                nxt = self._tok(k + 1)
                if nxt is None or nxt.kind != "word" or not self._match_noun(k + 1):
                    return token.text.lstrip("#")
            return None

        if not m.head or m.pronoun or m.attribute:
            return j
        opening = self._tok(j)
        if (
            m.plural
            and opening is not None
            and opening.text in (",", "(", ":")
            and letter(j + 1)
            and self._tok(j + 2) is not None
            and (self.tokens[j + 2].text == "," or self._low(j + 2) == "and")
        ):
            j += 1
            m.letters.append(letter(j) or "")
            j += 1
            while True:
                k = j
                while self._tok(k) is not None and (
                    self.tokens[k].text == "," or self._low(k) == "and"
                ):
                    k += 1
                found = letter(k) if k > j else None
                if found is None:
                    break
                m.letters.append(found)
                j = k + 1
            if self._tok(j) is not None and self.tokens[j].text == ")":
                j += 1
            return j
        if (
            self._tok(j) is not None
            and self.tokens[j].text in ('"', "'", "“", "(")
            and letter(j + 1)
        ):
            found = letter(j + 1)
            closing = self._tok(j + 2)
            if found and closing is not None and closing.text in ('"', "'", "”", ")"):
                m.letters.append(found)
                return j + 3
        if self._low(j) in ("labeled", "labelled", "named", "called", "number") and letter(j + 1):
            j += 1
        found = letter(j)
        if found is None:
            return j
        m.letters.append(found)
        j += 1
        while True:
            k = j
            if self._tok(k) is not None and self.tokens[k].text == ",":
                k += 1
            if self._low(k) == "and":
                k += 1
            if k == j:
                return j
            found = letter(k) if (m.plural or len(m.letters) > 1) else None
            if found is None:
                return j
            m.letters.append(found)
            j = k + 1
