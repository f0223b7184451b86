"""Verbs that mean something else in a phrase: "slams on the brakes", "comes to a stop"."""

from __future__ import annotations

from functools import lru_cache
import re

from esg.draft import lexicon as lex
from esg.draft.particles import LEMMAS, particles

PHRASES: dict[str, list[tuple[re.Pattern[str], str, dict[str, str]]]] = {}


def _phrase(lemma: str, rest: str, sense: str, **extra: str) -> None:
    """`rest` follows the verb and belongs to it, or is only looked at: "(?=...)"."""
    seen = r"(?=\s+" + rest[3:] if rest.startswith("(?=") else r"\s+" + rest + r"(?![\w-])"
    pattern = re.compile(seen, re.IGNORECASE)
    PHRASES.setdefault(lemma, []).append((pattern, sense, extra))


_NO_OBJECT = r"(?!\s+(?:an?|the|its|his|her|their|some|it|him|them|one|two|three|another)\b)"
DECKS = frozenset(
    {
        "pier",
        "jetty",
        "quay",
        "wharf",
        "dock",
        "breakwater",
        "mole",
        "pontoon",
        "bridge",
        "overpass",
    }
    | {"viaduct", "platform", "deck", "bay", "terrace", "veranda", "stage", "roof", "rooftop"}
    | {"apron"}
)
"""Last words of large things that one walks and drives about on."""
DECK_PHRASE = r"(?:(?!(?:on|at|near|by|and|in|from|of|into|onto|off|with)\b)[\w.'-]+\s+){1,6}?"
"""What stands before such a word in its phrase, the article included."""
_DECK = rf"{DECK_PHRASE}(?:{'|'.join(sorted(DECKS))})\b"
_NO_DECK = rf"(?!\s+{_DECK})"
_NO_EDGE = r"(?!\s+(?:an?|the|its|their)\s+(?:\w+\s+)?(?:edge|side|end|rim|lip|brink|cliff)\b)"
_ADJ = r"(?:(?:[a-z-]+)\s+)?"
for _v in ("kick", "throw", "toss", "hit", "push"):  # "is kicked over the crossbar"
    _phrase(_v, r"over(?=\s+(?:an?|the|its|his|her|their|some)\b)", "", only_passive="1")
for _v in ("slam", "hit", "apply", "press", "step", "stamp", "stand", "use", "tap", "push", "pull"):
    _phrase(
        _v,
        rf"(?:on\s+|down\s+on\s+)?(?:(?:the|its|his|her|their)\s+)?{_ADJ}"
        r"(?:brakes?|brake pedal|breaks)",
        "brake",
    )
for _v in (
    "come",
    "grind",
    "get",
    "slow",
    "roll",
    "skid",
    "screech",
    "coast",
    "be",
    "glide",
    "slide",
    "drift",
    "bring",
    "brake",
    "drop",
):
    _phrase(
        _v,
        rf"(?:down\s+)?to\s+(?:an?\s+|the\s+)?{_ADJ}{_ADJ}(?:stop|halt|rest|standstill)",
        "stop",
        via=_v,
    )
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
_phrase("back", r"(?:straight\s+|right\s+|slowly\s+)?into", "hit", motion="reverse")
_phrase("reverse", r"into", "hit", motion="reverse")
_phrase("move", r"backwards?", "reverse")
_phrase("drive", r"backwards?", "reverse")
_phrase("go", r"backwards?", "reverse")
_phrase("pull", rf"over{_NO_OBJECT}", "stop", via="pull")
_phrase("pull", r"(?:over|down)(?=\s+(?:an?|the|its)\b)", "topple", transitive="1", contact="1")

_phrase("take", r"off", "own")
_phrase("set", r"off", "own")
_phrase("set", r"out", "own")
_phrase("drive", rf"off(?!\s+(?:(?:an?|the|its)\s+(?:edge|end|side|rim)\b|{_DECK}))", "own")
for _v in ("run", "go", "race", "rush", "dash", "sprint", "jump", "dive", "swim"):
    _phrase(
        _v,
        r"after(?=\s+(?:(?:it|him|her|them)\b|(?:an?|the|its|his|her)\s+(?:\w+\s+)?\w+\s*"
        r"(?:[.,;!]|$|and\s|but\s|until\s)))",
        "follow",
    )
_phrase("run", r"into", "hit", motion="own")
_phrase("run", rf"over{_NO_EDGE}", "hit", motion="own")
_phrase("drive", rf"over{_NO_EDGE}{_NO_DECK}", "hit", motion="own")
_phrase("bump", r"into", "hit")
_phrase("knock", r"(?:over|down)", "topple", transitive="1", contact="1")
_phrase("kick", r"(?:over|down)", "topple", transitive="1", contact="1")
_phrase("push", r"over", "topple", transitive="1", contact="1")
_phrase("bowl", r"over", "topple", transitive="1", contact="1")
_phrase("tip", rf"(?:over{_NO_EDGE}|onto)", "topple")
_phrase("fall", rf"(?:over{_NO_OBJECT}|down\s+flat|onto\s+(?:its|their)\s+side)", "topple")
_phrase("topple", rf"(?:over{_NO_EDGE}|down)", "topple")
_phrase("turn", rf"over{_NO_OBJECT}", "topple")
_phrase("roll", rf"over{_NO_OBJECT}", "topple")
_phrase("keel", r"over", "topple")
_phrase("flip", rf"over{_NO_EDGE}", "topple")
_phrase("fall", r"down(?!\s+(?:the|a|an|from|onto|on|into))", "fall", particle="down")
for _verb in ("make", "take", "do", "perform", "execute", "complete"):
    _phrase(
        _verb,
        r"(?:an?\s+)?(?:quarter|half|full|\d+(?:\.\d+)?[-\s]*(?:degrees?|deg|°))[-\s]+"
        r"(?:(?P<dir>left|right|u)(?:-hand)?[- ]+)?turn",
        "turn",
    )
_phrase("make", rf"(?:an?\s+){_ADJ}(?P<dir>left|right|u)(?:-hand)?[- ]?turn", "turn")
_phrase("make", r"(?:an?\s+)(?P<dir>left|right)", "turn")
_phrase("tip", r"the\s+scales?(?=\s+at)", "weigh")
_phrase("make", rf"(?:an?\s+){_ADJ}turn\s+(?:to\s+the\s+)?(?P<dir>left|right)", "turn")
_phrase(
    "take",
    rf"(?:an?\s+|the\s+){_ADJ}(?P<dir>left|right)(?:-hand)?(?:[- ]?turn)?(?!-)"
    r"(?!\s+(?:pin|ball|one|cone|box|can|bottle|side|skittle|post|wheel|hand)\b)",
    "turn",
)  # not "takes the left pin with it"
_phrase("hang", r"(?:an?\s+)(?P<dir>left|right)", "turn")
for _v in ("make", "take", "do", "perform", "execute", "complete"):
    _phrase(_v, rf"(?:an?\s+){_ADJ}(?P<dir>u|left|right)(?:-hand)?[- ]turn", "turn")
    _phrase(
        _v,
        r"(?:an?\s+)(?:sharp|hard|quick|sudden|tight|wide)\s+(?P<dir>left|right)"
        r"(?=\s*(?:[.,;!]|$|(?:and|at|into|onto|then|after|before|to)\b))",
        "turn",
    )
_phrase("let", r"(?:slip|fall|drop|go\s+of)(?=\s+(?:an?|the|his|her|its|their|it|them)\b)", "drop")
_phrase("lose", r"(?:hold|(?:(?:his|her|its|the|their)\s+)?grip)\s+(?:of|on)", "drop")
_phrase("spill", r"(?=(?:off|from|out of)\b)", "fall", particle="down")
_phrase("crash", r"down(?=\s+(?:from|off)\b)", "fall", particle="down")
_phrase("flip", rf"over{_NO_OBJECT}", "topple")
_phrase("fall", r"(?:to\s+(?:one|the|its)\s+side|sideways|flat)(?!\s+of\b)", "topple")
_phrase(
    "change",
    r"(?:(?:its|his|her|the)\s+)?(?:direction|course|heading)\s+to\s+the\s+(?P<dir>left|right)",
    "turn",
)
for _v in ("make", "do", "perform", "execute"):
    _phrase(
        _v,
        r"an?\s+(?:(?:full|complete|sudden|emergency|brief|short|quick|abrupt|hard|final|dead)\s+)?"
        r"(?:stop|halt)",
        "stop",
        via="come",
    )
_phrase("cease", r"(?:to\s+move|moving|(?:all\s+)?motion)", "stop", via="come")
for _v in ("decelerate", "slow", "brake"):
    _phrase(_v, r"(?:down\s+)?to\s+(?:zero|0(?:\s*m/s)?)(?!\d|\.\d)", "stop", via=_v)
for _v in ("disappear", "vanish"):
    _phrase(_v, r"(?=(?:into|in)\s+(?:an?|the|its)\b)", "enter")
_phrase("steer", r"(?=(?:around|round)\s)", "own")
_phrase("avoid", r"colliding\s+with", "avoid")
_phrase("set", r"in(?:to)?\s+motion", "launch")
_phrase("come", r"in\s+contact\s+with", "hit", obj="1")
_phrase("get", r"in(?:to)?\s+contact\s+with", "hit", obj="1")
_phrase("reach", r"(?:a|its)\s+(?:\w+\s+)?(?:stop|halt|standstill)", "stop", via="come")
_phrase("end", r"(?:its|his|her|their)\s+(?:motion|movement|run|journey)", "stop", via="come")
_phrase("do", rf"(?:an?\s+){_ADJ}(?P<dir>u|left|right)[- ]?turn", "turn")
_phrase("perform", rf"(?:an?\s+){_ADJ}(?P<dir>u|left|right)[- ]?turn", "turn")
_phrase("turn", r"(?P<dir>around|back)", "turn")
_phrase("change", r"(?:the\s+|its\s+)?lanes?", "merge")
_phrase("switch", r"(?:the\s+|its\s+)?lanes?", "merge")
_phrase("go", r"straight(?:\s+(?:ahead|on))?", "own")
_phrase("stay", r"still", "posture")
_phrase(
    "stop",
    r"(?:short|just)?\s*(?:before|in\s+front\s+of|short\s+of)\s+(?=hitting|touching|reaching|crashing|colliding)(?:hitting|touching|reaching|crashing\s+into|colliding\s+with)",
    "stop",
    before="1",
)
_phrase("fall", r"short\s+of", "miss")
_phrase("come", r"off", "fall", particle="off")
_phrase("come", r"down(?=\s+(?:from|off|on|onto|into)\b(?!\s+\d))", "fall", particle="down")
_phrase("take", r"(?:an?|the)\s+(?:\w+\s+)?(?:corner|bend|curve)", "turn")
for _v in ("break", "come", "work"):
    _phrase(_v, r"(?:loose|away|free)(?=\s+(?:from|of)\b)", "fall", particle="down")
_phrase("knock", r"out(?=\s+(?:an?|the|one|two|three|some)\b)", "knock", transitive="1")
_phrase(
    "avoid", r"(?:hitting|touching|striking|ramming|(?:crashing|running|bumping)\s+into)", "avoid"
)
_phrase("avoid", r"(?:a\s+)?(?:collision|crash)\s+with", "avoid")
_phrase("make", r"(?:contact|impact)\s+with", "hit", obj="1")
_phrase("come", r"into\s+contact\s+with", "hit", obj="1")
_phrase("get", r"hit", "hit", passive="1")
_phrase("get", r"past", "overtake")
_phrase(
    "pull",
    r"up(?=\s*(?:[.,;!]|$|(?:at|in\s+front\s+of|beside|next\s+to|outside|behind|and)\b))",
    "stop",
    via="pull",
)
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
_phrase("cut", r"(?:in|across|off|through|in front of)", "own")
_phrase("go", r"off(?!\s+(?:the|an?|its|his|her|their|towards?|to|down|into|with|at)\b)", "noop")
_phrase(
    "go",
    r"(?:down|over)(?=\s*(?:[.,;!]|$|\s+(?:and|like|one by one|in turn)\b))",
    "topple",
    down="1",
)
_phrase("hold", r"hands", "noop")
_phrase("let", r"go(?!\s+of\b)", "noop")
_phrase("let", r"go\s+of(?=\s+(?:an?|the|its|his|her|their|it|them)\b)", "drop")
_phrase(
    "lose", r"(?:control|traction|grip|(?:its|his|her|their)\s+(?:grip|balance|footing))", "noop"
)
_phrase("catch", r"fire", "noop")
_phrase("catch", r"up\s+(?:with|to)", "approach")
_phrase("stick", r"(?:in|into|to)", "hit")
_phrase("run", r"out(?!\s+of)", "own")
_phrase("fall", r"apart|asleep|silent", "noop")
_phrase("set", r"down(?=\s+(?:on|onto|in|at|beside|next)\b)", "posture")
_phrase("set", r"down", "noop")
_phrase("get", r"up", "noop")
_phrase("stand", r"up", "noop")
_phrase("get", r"(?:off|out(?:\s+of)?|into|in)", "noop")

_OWN_PHRASES, PHRASES = PHRASES, {}
for _entry in particles():
    _phrase(_entry.lemma, _entry.follows, _entry.sense, **_entry.notes)
for _lemma, _phrases in _OWN_PHRASES.items():
    PHRASES.setdefault(_lemma, []).extend(_phrases)

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
    for lemma, words in (_EXTRA_LEMMAS | LEMMAS).items()
    for word, form in [(lemma, "base"), *zip(words, ("s", "past", "pp", "ing"), strict=True)]
}


@lru_cache(maxsize=16384)
def verb_readings(word: str) -> tuple[lex.VerbForm, ...]:
    """Readings of a word as a verb, phrase heads included."""
    low = word.lower()
    found = lex.verb_forms().get(low, ())
    if not found and low in _EXTRA_FORMS:
        lemma, form = _EXTRA_FORMS[low]
        return (lex.VerbForm(lemma, "noop", form),)
    return found


def particle_sense(lemma: str, words: str) -> tuple[str, dict[str, str]] | None:
    """Sense of a verb whose particle stands elsewhere ("over it goes").

    Args:
        lemma: The verb.
        words: Its particle, and the word after it if there is one.
    """
    for pattern, sense, extra in PHRASES.get(lemma, []):
        if sense and "only_passive" not in extra and pattern.match(" " + words):
            return sense, {k: v for k, v in extra.items() if k != "dir"}
    return None
