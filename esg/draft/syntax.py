"""Shallow syntax of a prompt: tokens become noun phrases, verb groups and small words.

The lexicon decides first, because statistical taggers misread ungrammatical prompts ("A car move
towards ..."); spaCy's tags only settle words that the lexicon does not know.
"""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.elements import Element, Mention, Verb, Word
from esg.draft.multiwords import MULTIWORDS
from esg.draft.nominals import RETOLD_NOUNS
from esg.draft.nounphrases import NounPhrases
from esg.draft.nounstarts import EXTENTS
from esg.draft.numerals import parse_number
from esg.draft.verbphrases import verb_readings

_HEADINGS = frozenset(
    {"scene", "shot", "prompt", "description", "task", "note", "step", "phase", "part", "act",
     "system", "user", "assistant", "title", "setting", "action", "input", "output", "example",
     "scenario", "story", "instruction", "instructions", "request"}
)  # fmt: skip
_TITLES = frozenset(
    {"puzzle", "demo", "test", "experiment", "simulation", "clip", "video", "level", "case",
     "report", "update", "log", "challenge", "exercise", "problem", "question", "idea", "concept",
     "caption", "benchmark", "variant", "trial", "sequence", "storyboard", "demonstration", "event"}
)  # fmt: skip
"""Last words of titles that have more than one ("Physics puzzle:")."""
_ASKED = lex.DETERMINERS | {"you", "we", "i", "it", "they", "there"}
_ASKING = frozenset({"can", "could", "will", "would", "may", "does", "did", "is", "are"})
_BOUNDS = (
    ("at", "least"), ("at", "most"), ("no", "fewer", "than"), ("no", "more", "than"),
    ("no", "less", "than"), ("not", "more", "than"), ("more", "than"), ("fewer", "than"),
    ("less", "than"), ("up", "to"), ("as", "many", "as"), ("exactly",), ("precisely",), ("about",),
    ("around",), ("roughly",), ("nearly",), ("almost",),
)  # fmt: skip
"""What bounds a count: "at least two of the pins"."""
_SO_AS_TO = (("in", "order", "to"), ("so", "as", "to"))
_MOMENTS = frozenset({"instant", "moment", "minute"})


_AIMS = frozenset({"into", "onto", "at", "against", "toward", "towards", "off", "down", "over"})
"""What follows what is pushed or dropped: "Drop A onto B"."""


class Chunker(NounPhrases):
    """Turns tokens into mentions, verb groups and small words."""

    def run(self) -> list[Element]:
        i = 0
        while i < len(self.tokens):
            i = self._step(i)
        return self.elements

    def _step(self, i: int) -> int:
        token = self.tokens[i]
        low = token.low
        if token.kind == "punct":
            self.elements.append(Word(token.start, token.end, "punct", token.text))
            return i + 1
        used = self._heading(i)
        if used:
            return i + used
        previous = self._previous()
        opens = previous is None or (isinstance(previous, Word) and previous.low in ".;!?\n")
        if low in _ASKING and opens and self._low(i + 1) in _ASKED:
            self.elements.append(Word(token.start, token.end, "adv", "indeed"))
            return i + 1  # "Can a ball hit a box?"
        if token.kind == "qty":
            j = self._noun_phrase(i)
            if j is not None:
                return j
            self.elements.append(Word(token.start, token.end, "qty", token.low, token.amount))
            return i + 1
        used = self._multiword(i) if low in ("to", "which", "that") else 0
        if used:
            return i + used
        if (low, self._low(i + 1), self._low(i + 2)) in _SO_AS_TO and verb_readings(
            self._low(i + 3)
        ):
            j = self._step(i + 2)  # "in order to ram it"
            self.elements[-1].start = token.start
            return j
        if low == "to":
            nxt = verb_readings(self._low(i + 1))
            base = next((v for v in nxt if v.form == "base"), None)
            if base is not None and (
                self._low(i + 1) not in lex.nouns() or self._verb_after_to(i + 1)
            ):
                j = self._verb_group(i + 1)
                if j is not None:
                    verb = self.elements[-1]
                    assert isinstance(verb, Verb)
                    verb.infinitive = True
                    verb.start = token.start
                    return j
            self.elements.append(Word(token.start, token.end, "prep", "to"))
            return i + 1
        if low in ("which", "who", "whose", "whom") or (
            low == "that"
            and isinstance(self._previous(), Mention)
            and (self._verb_ahead(i + 1) or self._clause_of_noun(i))
        ):
            self.elements.append(Word(token.start, token.end, "rel", low))
            return i + 1
        degree = {self._low(i - 2), self._low(i - 3)} & {"so", "such"}
        if low == "that" and degree and self._verb_soon(i + 1):
            self.elements.append(Word(token.start, token.end, "sub", "so"))
            return i + 1
        if low in ("and", "or", "but", "plus", "nor"):
            self.elements.append(Word(token.start, token.end, "conj", low))
            return i + 1
        used = self._bounded_count(i)
        if used:
            self.elements.append(Word(token.start, self.tokens[i + used - 1].end, "adv", "exactly"))
            return i + used
        used = self._multiword(i)
        if used:
            return i + used
        size = self._previous()
        if low in EXTENTS and isinstance(size, Word) and size.kind == "qty":
            self.elements.append(Word(token.start, token.end, "unknown", low))
            return i + 1  # "15 cm tall and 7 cm wide tips over"
        if self._last_of_compound(i) and (j := self._noun_phrase(i)) is not None:
            head, first = self.elements.pop(), self.elements.pop()
            if isinstance(head, Mention) and isinstance(first, Mention):
                head.start, head.text = first.start, f"{first.text} {head.text}"
                head.adjectives.insert(0, first.head)
            self.elements.append(head)
            return j  # "Rain barrel topples"
        named = self._noun_phrase(i) if self._named_thing(i) else None
        if named is not None:
            return named
        if self._verb_here(i) or self._verb_after_amount(i):
            j = self._verb_group(i)
            if j is not None:
                return j
        if low in ("then", "meanwhile", "simultaneously"):
            self.elements.append(Word(token.start, token.end, "adv", low))
            return i + 1
        if (
            low in ("after", "before")
            and self._low(i + 1) in ("that", "this", "which")
            and self._low(i + 2) not in RETOLD_NOUNS
        ):
            self.elements.append(Word(token.start, token.end, "adv", "then"))
            return i + 2
        if low in lex.SUBORDINATORS and self._clause_follows(i):
            self.elements.append(Word(token.start, token.end, "sub", low))
            return i + 1
        if self._unknown_verb(i):
            self.elements.append(Verb(token.start, token.end, low, "unknown", "s"))
            return i + 1
        j = self._noun_phrase(i)
        if j is not None:
            return j
        if low == "in" and self._low(i + 1) == "off":
            self.elements.append(Word(token.start, token.end, "adv", "in"))
            return i + 1  # "goes in off the cushion"
        verb = self._previous()
        leaves = isinstance(verb, Verb) and verb.sense in ("fall", "roll", "slide", "knock")
        if low == "of" and leaves and self._low(i + 1) in lex.DETERMINERS:
            low = "off"  # "falls of the shelf"
        if low in lex.PREPOSITIONS or low in lex.SUBORDINATORS:
            self.elements.append(Word(token.start, token.end, "prep", low))
            return i + 1
        if low in lex.ADVERBS or low.endswith("ly") or token.tag == "ADV":
            self.elements.append(Word(token.start, token.end, "adv", low))
            return i + 1
        if low in lex.MODALS:
            self.elements.append(Word(token.start, token.end, "adv", low))
            return i + 1
        previous = self._previous()
        if (
            (token.tag == "VERB" or low.endswith(("s", "ed", "ing")))
            and low.isalpha()
            and (
                isinstance(previous, Mention)
                or (isinstance(previous, Word) and previous.kind in ("conj", "rel", "adv"))
            )
        ):
            form = "ing" if low.endswith("ing") else "s"
            self.elements.append(Verb(token.start, token.end, low, "unknown", form))
            return i + 1
        self.elements.append(Word(token.start, token.end, "unknown", low))
        return i + 1

    def _clause_of_noun(self, i: int) -> bool:
        """ "the bottle that the ball knocked off": a subject of its own follows."""
        head = self._previous()
        if not isinstance(head, Mention) or head.attribute or head.pronoun:
            return False
        if {"so", "such"} & {self._low(k) for k in range(max(0, i - 5), i)}:
            return False
        if self._low(i + 1) not in lex.DETERMINERS:
            return self._low(i + 1) in ("it", "he", "she", "they") and self._verb_ahead(i + 2)
        noun = self._match_noun(i + 2) or self._match_noun(i + 3)
        return noun is not None and any(self._verb_ahead(k) for k in (i + 3, i + 4))

    def _heading(self, i: int) -> int:
        """ "Scene 1:", "SYSTEM:", "Prompt:" in front of a sentence names no object."""
        previous = self._previous()
        if previous is not None and not (isinstance(previous, Word) and previous.low in ".;!?-"):
            return 0
        token = self.tokens[i]
        titled = self._title(i)
        if titled:
            self.elements.append(
                Word(token.start, self.tokens[i + titled - 1].end, "adv", "heading")
            )
            return titled
        n = 2 if self._tok(i + 1) is not None and self.tokens[i + 1].kind == "number" else 1
        colon = self._tok(i + n)
        if token.kind != "word" or colon is None or colon.text != ":":
            return 0
        unknown = self._match_noun(i) is None and not verb_readings(token.low)
        if token.low not in _HEADINGS and not (unknown and token.text.isupper()):
            return 0
        if len(token.text) == 1:
            return 0
        self.elements.append(Word(token.start, colon.end, "adv", "heading"))
        return n + 1

    def _title(self, i: int) -> int:
        """ "Pushing task:", "Physics puzzle:": the words of a title and its colon."""
        for n in (2, 3, 4):
            colon = self._tok(i + n)
            words = self.tokens[i : i + n]
            if colon is None or any(t.kind != "word" for t in words):
                return 0
            if colon.text == ":":
                return n + 1 if words[-1].low in _HEADINGS | _TITLES else 0
        return 0

    def _last_of_compound(self, i: int) -> bool:
        """ "Rain barrel topples": after a bare noun a verb has an ending, and one follows."""
        first = self._previous()
        bare = isinstance(first, Mention) and not (first.plural or first.determiner or first.count)
        if not bare or first.pronoun or first.letters or first.end + 1 != self.tokens[i].start:
            return False
        forms = {r.form for r in verb_readings(self._low(i))}
        follows = verb_readings(self._low(i + 1))
        finite = any(r.form in ("s", "past") for r in follows) or self._low(i + 1) in ("is", "was")
        return forms == {"base"} and finite and self._match_noun(i) is not None

    def _named_thing(self, i: int) -> bool:
        """ "Block A slides into block B": a verb's form, but a noun with its letter."""
        letter = self._tok(i + 1)
        if letter is None or not re.fullmatch(r"[A-Z]|#?\d", letter.text):
            return False
        if letter.text[-1].isdigit() and letter.kind != "number":
            return False
        clear = not isinstance(self._previous(), Mention) and self._match_noun(i) is not None
        return clear and self._low(i + 2) not in _AIMS

    def _verb_after_amount(self, i: int) -> bool:
        """ "with a mass of 25 kg slides": a noun cannot follow a quantity that "of" introduces."""
        previous = self._previous()
        return (
            isinstance(previous, Word)
            and previous.amount is not None
            and self._finite_after_of(i - 1, i)
        )

    def _bounded_count(self, i: int) -> int:
        """Words that bound a count: "at least two pins fall"."""
        first = self._low(i)
        for words in _BOUNDS:
            if words[0] != first:
                continue
            k = i + len(words)
            counted = self._tok(k)
            if counted is None or any(self._low(i + n) != w for n, w in enumerate(words)):
                continue
            value = parse_number(counted.low) if counted.kind in ("word", "number") else None
            whole = isinstance(value, float) and value.is_integer() and value >= 1.0
            if not whole or counted.low in ("a", "an"):
                continue
            thing = k + 1
            while self._is_adjective(thing) and self._match_noun(thing) is None:
                thing += 1
            if self._low(k + 1) == "of" or self._match_noun(thing) is not None:
                return len(words)
        return 0

    def _many_reverse(self) -> bool:
        """Whether a plural stands here whose verb is still to come."""
        previous, before = self._previous(), self.elements[-2] if len(self.elements) > 1 else None
        opens = before is None or getattr(before, "low", "") in (*".;!?,:", "and", "but", "then")
        return opens and isinstance(previous, Mention) and previous.plural

    def _multiword(self, i: int) -> int:
        for words, kind, low in MULTIWORDS.get(self._low(i), ()):
            if self._lows[i : i + len(words)] == words:
                if words[0] in ("left", "right") and self._previous_is_turn():
                    continue
                if words == ("back", "into") and self._many_reverse():
                    continue  # "Two vans back into each other"
                if words[0] in ("at", "in", "on") and self._low(i + len(words)) in ("of", "to"):
                    continue  # "at the end of the ramp", "on the way to the door"
                if words[-1] in ("that", "this") and self._low(i + len(words)) in RETOLD_NOUNS:
                    continue  # "because of that bump"
                one = self._previous() if words == ("at", "the", "end") else None
                if isinstance(one, Mention) and one.pronoun == "one" and one.determiner == "the":
                    continue  # "the one at the end"
                if words == ("down", "to") and verb_readings(self._low(i + 2)):
                    continue
                if words in (("on", "to"), ("in", "to")) and verb_readings(self._low(i + 2)):
                    continue
                if (
                    kind == "sub"
                    and words[-1] in _MOMENTS
                    and not self._clause_follows(i + len(words) - 1)
                ):
                    continue  # "at the moment of impact"
                if kind == "prep" and low in ("after", "before") and words[-1] == low:
                    kind = "sub" if self._clause_follows(i + len(words) - 1) else kind
                if words == ("from", "behind") and self._thing_named(i + 2):
                    kind, low = "prep", "behind"  # "runs out from behind a bus"
                start, end = self.tokens[i].start, self.tokens[i + len(words) - 1].end
                self.elements.append(Word(start, end, kind, low))
                return len(words)
        return 0

    def _previous_is_turn(self) -> bool:
        p = self._previous()
        return isinstance(p, Verb) and p.sense in ("turn", "swerve")

    def _verb_after_to(self, i: int) -> bool:
        """Whether an ambiguous word after "to" is an infinitive ("to hit the ball")."""
        nxt = self._low(i + 1)
        token = self._tok(i)
        if nxt in lex.DETERMINERS or nxt in lex.PRONOUNS or nxt in ("into", "with", "onto", "to"):
            return True
        return token is not None and token.tag == "VERB"

    def _goes_on(self, j: int) -> bool:
        """Whether a finite verb stands at token j, after a conjunction, and no noun."""
        j += self._low(j) in ("then", "also", "finally")
        finite = any(r.form in ("s", "past") for r in verb_readings(self._low(j)))
        plural = self._match_noun(j) is not None and not self._acts_on_something(j + 1)
        return finite and not plural

    def _clause_follows(self, i: int) -> bool:
        """Whether a subordinator starts a clause ("after it hits") and not "after 3 seconds"."""
        token = self._tok(i + 1)
        if token is None or token.kind in ("qty", "number"):
            return False
        if self._low(i) in ("so", "since") and self._low(i + 1) in ("hard", "fast", "much"):
            return False
        first = i + 1 + (self._low(i + 1) in lex.DETERMINERS)
        if (
            self._low(first)
            in (
                "collision",
                "impact",
                "crash",
                "hit",
                "contact",
                "turn",
                "stop",
                "strike",
                "kick",
            )
            and not verb_readings(self._low(first + 1))
            and self._low(first + 1) not in lex.MODALS
            and (self._low(first + 1) != "by" or first > i + 1)
        ):
            return False
        for j in range(i + 1, min(i + 14, len(self.tokens))):
            t = self.tokens[j]
            going = any(r.form in ("ing", "pp") for r in verb_readings(self._low(j + 1)))
            if t.text == "," and going and any(x.text == "," for x in self.tokens[j + 1 : j + 8]):
                return True  # "when the truck, going 10 m/s, brakes"
            if t.kind == "punct" and t.text in ".;,!?":
                return False
            if t.low in ("and", "but", "or", "then") and j > i + 1 and self._goes_on(j + 1):
                return False  # "stops before the wall and turns", "just before a gate but hits it"
            readings = verb_readings(t.low)
            if (readings or t.low in lex.MODALS) and (
                (self._low(j) not in lex.nouns() and self._low(j) not in lex.ATTRIBUTES)
                or self._low(j - 1) not in lex.DETERMINERS
            ):
                if t.low in lex.nouns() and j == i + 1:
                    return any(r.form == "ing" for r in readings)
                return not (self._low(i) == "as" and j == i + 1)
        return False
