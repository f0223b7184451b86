"""Looking at tokens: is this word a noun, an adjective or a verb here?"""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.elements import Element, Mention, Verb, Word
from esg.draft.nounlookup import NounLookup
from esg.draft.tokens import is_name
from esg.draft.verbphrases import PHRASES, verb_readings

_NOUNS_FIRST = frozenset(
    {"back", "left", "ground", "wound", "found", "end", "step", "set", "lead", "rest"}
)
"""Forms of verbs that are something else unless a noun precedes them."""
_ALSO_NOUNS = frozenset({"can", "has", "have", "had", "having", "might", "will"})
"""Modals that are nouns or main verbs too."""


_ADJECTIVES = frozenset().union(
    lex.COLORS, lex.MATERIALS, lex.SIZES, lex.STRETCHES, lex.WEIGHTS, lex.PLACE_ADJECTIVES,
    lex.PLAIN_ADJECTIVES,
)  # fmt: skip


class Reader(NounLookup):
    """Tokens read so far as elements, and questions about the next ones."""

    def _acts(self, i: int) -> bool:
        """Whether a word in -s that could be a plural is the verb of the noun before it."""
        token, nxt = self._tok(i), self._tok(i + 1)
        if token is None or not any(r.form == "s" for r in verb_readings(token.low)):
            return False
        if nxt is None or nxt.kind in ("punct", "qty"):
            return True
        return nxt.low in lex.PREPOSITIONS | lex.DETERMINERS | lex.ADVERBS | lex.PRONOUNS | {"and"}

    def _previous(self) -> Element | None:
        return self.elements[-1] if self.elements else None

    @staticmethod
    def _known_adjective(low: str) -> bool:
        if "-" in low and any(p in lex.COLORS or p in lex.SIZES for p in low.split("-")):
            return True
        return low in _ADJECTIVES

    def _is_adjective(self, i: int) -> bool:
        token = self._tok(i)
        if token is None or token.kind != "word":
            return False
        low = token.low
        if self._known_adjective(low):
            return True
        return (
            token.tag == "ADJ"
            and not self._named_before(i)
            and self._match_noun(i) is None
            and not verb_readings(low)
            and low not in lex.PREPOSITIONS
        )

    def _bare(self, mention: Mention) -> bool:
        return not mention.determiner and not mention.pronoun and not mention.letters

    def _verb_context(self, i: int) -> bool:
        nxt = self._tok(i + 1)
        if nxt is None:
            return self.tokens[i].tag in ("VERB", "")
        low = nxt.low
        return (
            self._individual(i + 1)
            or low in lex.DETERMINERS
            or low in lex.PRONOUNS
            or low in lex.PREPOSITIONS
            or nxt.kind in ("qty",)
            or low in lex.ADVERBS
            or low == "to"
            or (nxt.kind == "punct" and self.tokens[i].tag in ("VERB", ""))
        )

    def _individual(self, i: int) -> bool:
        """ "then rams pallet P2", "and hits car 3", "rams R2": a name in place of an article."""
        noun = self._match_noun(i)
        if noun is not None and noun[2]:
            return False
        name = self._tok(i + (noun[1] if noun is not None else 0))
        return name is not None and is_name(name, after_noun=noun is not None)

    def _noun_soon(self, i: int) -> bool:
        """Whether adjectives and then a noun follow without a determiner."""
        for j in range(i, min(i + 4, len(self.tokens))):
            low = self._low(j)
            if self.tokens[j].kind != "word" or low in lex.DETERMINERS or low in lex.PREPOSITIONS:
                return False
            if self._match_noun(j) is not None:
                return True
            if verb_readings(low) and not self._is_adjective(j):
                return False
            if low in lex.ADVERBS and not self._is_adjective(j):
                return False
            if not self._is_adjective(j):
                return self.tokens[j].tag in ("NOUN", "PROPN")
        return False

    def _verb_ahead(self, i: int) -> bool:
        for j in range(i, min(i + 3, len(self.tokens))):
            low = self._low(j)
            if low in lex.MODALS or verb_readings(low):
                return True
            if low not in lex.ADVERBS:
                return False
        return False

    def _participle(self, j: int, also_been: bool = False) -> bool:
        for k in range(j, min(j + 3, len(self.tokens))):
            low = self._low(k)
            if also_been and low == "been":
                return True
            if any(r.form in ("pp", "ing") for r in verb_readings(low)):
                return True
            if low not in lex.ADVERBS and not low.endswith("ly"):
                return False
        return False

    def _verb_here(self, i: int) -> bool:
        """Whether the token starts a verb group here."""
        low = self._low(i)
        token = self.tokens[i]
        previous = self._previous()
        if low in ("is", "are", "was", "were", "be", "been", "being", "'s", "gets", "get"):
            return low != "'s" or isinstance(previous, Mention)
        if low in ("cannot", "can't", "couldn't"):
            return True
        if low in lex.MODALS - _ALSO_NOUNS:
            return True
        if low in ("will", "can", "might", "has", "have", "had", "having"):
            return isinstance(previous, Mention) or low in ("has", "have", "had", "having")
        readings = verb_readings(low)
        if not readings:
            return False
        prev_low = self._low(i - 1)
        nxt = self._low(i + 1)
        forms = {r.form for r in readings}
        noun = self._match_noun(i)
        nounish = noun is not None or low in lex.ATTRIBUTES or low in lex.PARTS
        nounish = nounish or lex.singular(low)[0] in lex.ATTRIBUTES
        adjectival = self._is_adjective(i)
        if prev_low == "whose":
            return False  # "a car whose speed is 12 m/s"
        if adjectival and prev_low in ("too", "very", "so", "quite") and forms <= {"base"}:
            return False  # "is too slow"
        if noun is not None and noun[1] > 1 and not isinstance(previous, Mention):
            return False
        if prev_low in lex.DETERMINERS and not (
            isinstance(previous, Mention) and previous.end == self.tokens[i - 1].end
        ):
            return False
        if low in _NOUNS_FIRST:
            if not isinstance(previous, Mention):
                return low == "back" and isinstance(previous, Word) and previous.kind == "conj"
            if low == "left":
                return nxt in ("the", "its", "a")
            if low in ("back", "end", "wound", "ground"):
                return any(
                    p.match(self.text, token.end)
                    for p, _, _ in PHRASES.get(low if low != "wound" else "wind", [])
                )
            return True
        dangles = isinstance(previous, Word) and previous.low in ("behind", "ahead", "opposite")
        if dangles and "s" in forms and isinstance((self.elements[-2:-1] or [None])[0], Mention):
            return True  # "bike behind hits bumper"
        if isinstance(previous, Word) and previous.kind == "prep" and not (forms & {"ing"}):
            return not (nounish or adjectival) and previous.low != "by"
        if isinstance(previous, Mention):
            if adjectival and forms <= {"pp", "past", "ing"} and self._noun_soon(i + 1):
                return bool(forms & {"past", "pp"}) and not self._bare(previous)
            if forms & {"s", "past", "pp", "ing"} or not nounish:
                return True
            return True
        if isinstance(previous, Verb):
            before = self.elements[-3:-1]
            if forms & {"s", "past"} and [type(e) for e in before] == [Mention, Mention]:
                return noun is None  # "the tray he was carrying crashes"
            own = previous.form == "ing" and not previous.auxiliary and bool(before)
            if (
                own
                and isinstance(before[-1], Mention)
                and "s" in forms
                and (noun is None or nxt in lex.DETERMINERS | lex.PRONOUNS)
            ):
                return True  # "a car changing lanes knocks it over"
            within = [getattr(e, "kind", "") for e in before[:1]] == ["rel"]
            clause = within and isinstance(before[-1], Mention) and bool(forms & {"s", "past"})
            if clause and (noun is None or nxt in lex.DETERMINERS | lex.PREPOSITIONS):
                return True  # "the trolley whose brakes fail rolls into a pond"
            after_that = [getattr(e, "kind", "") for e in before[-1:]] == ["rel"]
            if after_that and forms & {"s", "past"} and (noun is None or nxt in lex.DETERMINERS):
                return True  # "a ball that is rolling hits a box"
            return (
                bool(forms & {"ing", "base"})
                and not (nounish and (self._noun_soon(i + 1) is False))
                and not (adjectival and self._noun_soon(i + 1))
            )
        if (
            adjectival
            and self._noun_soon(i + 1)
            and not (previous is not None and previous.kind in ("rel", "sub"))
        ):
            return "ing" in forms and nxt in lex.DETERMINERS
        if previous is None or (previous.kind == "punct" and previous.low in ".;!?:\n"):
            if nounish:
                by = nxt == "by" and "pp" in forms  # "Hit by an apple, he ..."
                by = by or (noun is None and "s" in forms and self._report(i))
                return by or (nxt in lex.DETERMINERS and "base" in forms)
            return True
        if (
            nounish
            and forms & {"s", "past"}
            and previous.kind in ("punct", "conj", "adv")
            and (nxt == "" or nxt in ("and", "then"))
            and any(isinstance(e, Verb) for e in self.elements)
        ):
            return True  # "..., slides, and hits"
        if previous.kind == "rel" and "s" in forms and not (verb_readings(nxt) and nxt != "open"):
            return True  # ", which swings round": no plural without an article
        if nounish and noun is not None:
            inflected = forms & {"past", "pp", "ing"}
            if previous.kind in ("conj", "adv", "punct", "rel"):
                return self._verb_context(i) or bool(inflected)
            return bool(inflected) or token.tag == "VERB"
        return True

    def _looks_like_verb(self, j: int, m: Mention) -> bool:
        """An unknown word in -s or -ed after a singular noun, with no verb after it ("derails")."""
        low = self._low(j)
        if (
            not low.endswith(("s", "ed"))
            or low.endswith("ss")
            or m.determiner not in ("a", "an", "the", "this", "that", "its")
        ):
            return False
        nxt = self._low(j + 1)
        return not (verb_readings(nxt) or nxt in lex.MODALS or nxt == "'s")

    def _unknown_verb(self, i: int) -> bool:
        """ "The bag rips, and", ", rounds a shelf": an unknown word in -s in place of a verb."""
        low, token, nxt = self._low(i), self.tokens[i], self._tok(i + 1)
        noun, previous = self._match_noun(i), self._previous()
        after_one = isinstance(previous, Mention) and previous.determiner in ("a", "an")
        after_one = (
            after_one and noun is not None and noun[2] and noun[1] == 1
        )  # "a cyclist signals,"
        known = (noun is not None and not after_one) or verb_readings(low) or self._is_adjective(i)
        if known or not low.isalpha() or not low.endswith("s") or low.endswith("ss"):
            return False
        singular = lex.singular(low)[0]
        closed = lex.PREPOSITIONS | lex.ADVERBS | lex.MODALS | lex.DETERMINERS | lex.PRONOUNS
        if low in closed | lex.SUBORDINATORS or {low, singular} & (lex.PARTS | lex.ATTRIBUTES):
            return False
        ends = nxt is None or nxt.kind in ("punct", "qty")
        object_ = nxt is not None and nxt.low in lex.DETERMINERS | lex.PRONOUNS
        way = nxt is not None and nxt.low in lex.PREPOSITIONS | lex.ADVERBS - {"of"}
        if isinstance(previous, Mention):
            before = self.elements[-2] if len(self.elements) > 1 else None
            opens = before is None or getattr(before, "kind", "") in ("punct", "conj", "sub", "adv")
            one = previous.determiner in ("a", "an", "the", "this", "that", "its", "one")
            alone = one and not previous.plural and previous.end == self.tokens[i - 1].end
            return opens and alone and (ends or object_ or way or nxt.low in ("and", "but", "to"))
        told = any(isinstance(e, Verb) for e in self.elements)
        listed = isinstance(previous, Word) and (previous.kind == "conj" or previous.low == ",")
        return listed and told and token.tag == "VERB" and (object_ or way)

    def _compound_noun(self, k: int, m: Mention) -> bool:
        """Whether an ambiguous word continues a compound ("picnic park") and is no verb."""
        nxt = self._tok(k + 1)
        if nxt is None:
            return self.tokens[k].tag == "NOUN"
        if nxt.low in lex.DETERMINERS or nxt.low in lex.PRONOUNS:
            return False
        readings = verb_readings(self._low(k))
        base = all(r.form == "base" for r in readings)
        after = self._match_noun(k + 1)
        if m.determiner and after is not None and after[2] and "pp" in {r.form for r in readings}:
            return True  # "the engine shed doors"
        if base and m.determiner in ("a", "an") and after is not None and not after[2]:
            return self.tokens[k].tag == "NOUN"  # "a ski lift chair"
        return self.tokens[k].tag == "NOUN" and bool(verb_readings(nxt.low))

    def _unknown_noun(self, j: int) -> bool:
        token = self._tok(j)
        if token is None or token.kind != "word" or token.text == "'s":
            return False
        low = token.low
        if (
            low in lex.PREPOSITIONS
            or low in lex.ADVERBS
            or low in lex.MODALS
            or low in lex.PRONOUNS
            or low in lex.DETERMINERS
            or low in lex.SUBORDINATORS
            or low in ("and", "or", "but", "to", "which", "who", "that", "not")
            or verb_readings(low)
        ):
            return False
        if token.tag in ("NOUN", "PROPN"):
            return True
        if token.tag in ("ADJ", "VERB", "X", "INTJ"):
            return not self._noun_soon(j + 1)
        return (token.tag == "" and not low.endswith("ly")) or self._named_before(j)

    def _named_before(self, j: int) -> bool:
        """ "The storm fells the poplar; poplar crushes a shed": a noun by now."""
        word = lex.singular(self._low(j))[0]
        return any(isinstance(e, Mention) and e.head == word for e in self.elements)

    def _report(self, i: int) -> bool:
        """ "Truck, 9 m/s. Brakes at 3 s. Stops 2 s later.": verbs of what was named before."""
        nxt = self._tok(i + 1)
        if not any(isinstance(e, Mention) for e in self.elements) or nxt is None:
            return False
        if nxt.kind == "word" and self._match_noun(i + 1) and not self._low(i + 2).endswith("ing"):
            return True  # "Hits shed door."
        small = lex.PREPOSITIONS - {"of"} | lex.ADVERBS | {"and"}
        return (nxt.kind in ("qty", "punct") and nxt.text != ":") or nxt.low in small

    def _noun_not_verb(self, k: int, m: Mention) -> bool:
        """ "a cereal bowl off the chair": a bare verb does not follow a singular noun phrase."""
        readings = verb_readings(self._low(k))
        bare = all(r.form == "base" for r in readings)
        nxt = self._low(k + 1)
        one = m.determiner in ("a", "an", "this", "that", "each", "every", "another")
        previous = self._previous()
        done = isinstance(previous, Verb) and previous.sense not in ("cause", "noop")
        one = one or (done and bool(m.determiner))  # "knocks its food bowl off": it has its verb
        return bare and one and nxt not in lex.DETERMINERS and nxt not in lex.PRONOUNS

    def _thing_named(self, i: int) -> bool:
        """Whether a noun phrase with an article or a pronoun starts here."""
        low = self._low(i)
        named = low in lex.DETERMINERS or self._match_noun(i) is not None
        return named or low in ("it", "them", "him", "her", "its", "his", "their")

    def _verb_soon(self, i: int) -> bool:
        return any(verb_readings(self._low(k)) for k in range(i, min(i + 6, len(self.tokens))))

    def _acts_on_something(self, j: int) -> bool:
        low = self._low(j)
        small = lex.DETERMINERS | lex.PREPOSITIONS | lex.PRONOUNS | lex.ADVERBS
        return low in small or low in ("", ".", ",")
