"""What shines, burns, falls from the sky or sways in the wind: taken out of the text.

"A car with its headlights on drives away" is read as "a car drives away", "a lamp goes out" as "a
lamp stands", and what was said is kept beside: it changes how things look, and moves nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.graph.models import Predicate
from esg.lexicon.shown import LIVELY, lights, swaying, weathers

SCENE, BEFORE = -1, -2
"""What words may be said of: the scene, or what is named last before them."""
Blank = Callable[[int, int, str], None]


@dataclass(frozen=True)
class Shown:
    """Something that is said of how things look in time.

    Args:
        says: `lit`, `weather` or `sways`.
        start, end: Words that say so.
        noun: As of the statement: "turned off", "flashing red", "heavy rain".
        about: Where the noun of what it is said of begins; `SCENE` or `BEFORE`.
        light: How the light is called, of those of its owner.
        act: Words of an act by which it is brought about; None where it changes by itself.
    """

    says: Predicate
    start: int
    end: int
    noun: str
    about: int = SCENE
    light: str = ""
    act: tuple[int, int] | None = None


def take_shown(text: str, blank: Blank) -> list[Shown]:
    """Reads and takes out of a text what is said of lights, weather and wind.

    Args:
        text: A prompt as it was screened.
        blank: Puts other words, no longer than they are, in the place of some.
    """
    found: list[Shown] = []
    if not _ANY.search(text):
        return found
    for read in (_weather, _sways, _switched, _changes, _with_lights, _alight):
        for shown, places in read(text):
            if any(s.start < shown.end and shown.start < s.end for s in found):
                continue
            found.append(shown)
            for start, end, instead in places:
                blank(start, end, instead)
    return sorted(found, key=lambda s: s.start)


_ANY = re.compile(
    r"\b(?:turn|switch|lit\b|light|head\s?l|tail\s?l|siren|candle|torch|extinguish|ignit|lamp|lantern|led\b|burn|flam|fire\b|flash|flicker|blink|glow|shin"
    r"|goes\s+(?:on|out|off)|rain|snow|hail|fog|mist|haz[ey]|storm|drizzl|downpour|blizzard|sway|"
    r"swing|wind\b|breeze|flutter|flap|blaz|ablaze|(?:tv|television|screen|monitor)s?\b)",
    re.IGNORECASE,
)
Read = Iterator[tuple[Shown, list[tuple[int, int, str]]]]
_WORDS = r"(?:[\w-]+\s+){0,2}?"
_BY = r"(?:suddenly\s+|slowly\s+|then\s+|all\s+|both\s+|brightly\s+|steadily\s+)?"
_ACTED = r"(?:by\s+(?:itself|themselves)\s*)?"


def _any(words: list[str] | tuple[str, ...]) -> str:
    listed = sorted({*words}, key=lambda w: (-len(w), w))
    return "|".join(re.escape(w) for w in listed)


@cache
def _owners(*, flame: bool) -> str:
    """Nouns of what can be lit, or burns; vehicles only by their lights."""
    kinds = {k for row in lights().values() if row.flame is flame for k in row.of}
    words = [w for w, noun in lex.nouns().items() if noun.name in kinds or w in kinds]
    words += [*kinds - {"@vehicle"}, *(() if flame else ("led", "light"))]
    return _any([*words, *(w + "s" for w in words)])


@cache
def _parts() -> str:
    return _any([w for row in lights().values() if not row.flame for w in row.words])


@cache
def _colors() -> str:
    return _any([c for c in lex.COLORS if c.isalpha()])


@cache
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern, re.IGNORECASE)


def _color(text: str) -> str:
    return next((w for w in re.findall(r"[a-z]+", text.lower()) if w in lex.COLORS), "")


def _instead(words: str, *options: str) -> str:
    """The first of some words that is no longer than those whose place it takes."""
    return next((w for w in options if len(w) <= len(words)), "")


def _named(m: re.Match[str]) -> list[tuple[int, int, str]]:
    """ "The led", "the light": a lamp."""
    word, at = m["owner"].lower(), m.span("owner")
    if word in ("light", "lights"):
        return [(*at, "lamps" if word == "lights" else "lamp")]
    return [(m.start("det"), at[1], "a lamp")] if word == "led" else []


def _switched(text: str) -> Read:
    """ "Turns the lamp off", "toggle the button to turn off the led", "lights a candle"."""
    by = (
        r"(?P<by>(?:toggle|move|press|push|flip|flick|pull|click|hit|use)(?:s|es|ing)?\s+(?:the|a)"
        r"\s+(?:[\w-]+\s+){0,2}?(?:switch|button|lever|knob|cord|chain)\s+to\s+)?"
    )
    verb = (
        r"(?P<verb>(?P<is>(?:is|are|was|were)\s+)?(?:turn|switch|flip)(?:s|es|ed|ing)?\s+"
        r"(?:(?P<how>on|off)\s+)?)"
    )
    owner = rf"(?P<det>(?:the|a|an|his|her|its|their)\s+)(?P<adj>{_WORDS})(?P<owner>@)\b"
    lamp = owner.replace("@", _owners(flame=False))
    for m in _compiled(rf"\b{by}{verb}{lamp}(?(how)|\s+(?P<last>on|off)\b)").finditer(text):
        if (light := re.compile(r"\s+(?:switch|bulb|button)").match(text, m.end())) is not None:
            if not light[0].strip().startswith("bulb"):
                continue
        on = (m["how"] or m["last"]).lower()
        first = m.start("by") if m["by"] else m.start("verb")
        own = _compiled(r"(?:^|[.,;]|\band|\bthen|\bto)\s*$").search(text[:first]) is not None
        near = "see" if own or m["by"] else _instead(text[first:m.start("det")], "stands near", "is near", "near", "by")
        end = m.end("verb")
        places = [(first, end, near), *_named(m)]
        if m["last"]:
            places.append((*m.span("last"), ""))
        last = m.end() if m["last"] else m.end("owner")
        act = m.span("by") if m["by"] else m.span("verb")
        act = (act[0], act[0] + len(text[act[0]:act[1]].rstrip()))
        color = _color(m["adj"]) if m["owner"].lower().startswith(("light", "led")) else ""
        noun = f"turned {on} {color}".strip()
        yield Shown(Predicate.LIT, first, last, noun, m.start("owner"), act=act), places
    lights_up = (
        r"(?P<verb>(?P<is>(?:is|are|was|were)\s+)?(?:(?:lights?|lit|lighting|ignites?|ignit(?:ed|ing))"
        r"(?:\s+up)?|(?P<out>(?:blows?|blew|blowing|puts?|putting)\s+out|extinguish(?:es|ed|ing)?)|"
        r"sets?\s+fire\s+to)\s+)"
    )
    burning = owner.replace("@", _owners(flame=True))
    for m in _compiled(rf"(?<!\w)(?<!a )(?<!the ){lights_up}{burning}").finditer(text):
        near = _instead(text[m.start("verb"):m.start("det")], "stands near", "is near", "near", "by")
        noun = "turned out" if m["out"] else "turned burning"
        act = (m.start("verb"), m.start("verb") + len(m["verb"].rstrip()))
        shown = Shown(Predicate.LIT, m.start("verb"), m.end("owner"), noun, m.start("owner"), act=act)
        yield shown, [(*m.span("verb"), near)]


def _changes(text: str) -> Read:
    """ "The lamp goes out", "a traffic light turns red", "a candle burns", "the screen is on"."""
    color = rf"(?P<color>{_colors()})"
    says = (
        rf"(?P<told>(?:that\s+|which\s+)?(?:(?:is|are|was|were)\s+)?{_BY}"
        r"(?:(?P<to>(?:turn|switch|come|go|flick)(?:s|es|ed|ing)?|came|went)\s+"
        rf"(?:back\s+)?(?:(?P<how>on|off|out)|(?:from\s+\w+\s+)?(?:to\s+)?{color})|(?P<up>lights?\s+up|lit\s+up)|"
        r"(?P<flash>flash|blink|flicker|strobe)(?:s|es|ed|ing)?(?:\s+(?:on\s+and\s+off|brightly|"
        rf"rapidly|slowly|(?P<hue>{_colors()})))*|(?P<glow>glow|shine)(?:s|d|ing)?(?:\s+brightly|\s+(?P<tint>{_colors()}))?"
        r"|(?<=is\s)(?:(?P<state>on|off|lit)|(?P<being>red|green|amber|yellow))(?=\s*(?:[.,;]|$|and\b|while\b|as\b))))"
    )
    owner = rf"\b(?P<owner>{_owners(flame=False)}|{_parts()})\s+"
    for m in _compiled(owner + says + r"(?!\s+(?:the|a|an|his|her|its)\b)\b").finditer(text):
        noun, word = _state(m), m["owner"].lower()
        at, places = m.start("owner"), [(*m.span("told"), _stay(m["told"]))]
        if word in ("light", "lights"):
            # Of a vehicle named before, or a lamp of its own.
            kind = _compiled(r"\b(?:traffic|stop|street)\s+$").search(text[:at])
            if kind is None and _compiled(r"\b(?:its|their|his|her|car|police|ambulance)\s*(?:'s)?\s+(?:\w+\s+)?$").search(text[:at]):
                yield _of_owner(m, noun, text), [_whole(text, m)]
                continue
            places += [] if kind else [(*m.span("owner"), "lamps" if word == "lights" else "lamp")]
        elif re.fullmatch(_parts(), word) and not re.fullmatch(_owners(flame=False), word):
            yield _of_owner(m, noun, text), [_whole(text, m)]
            continue
        yield Shown(Predicate.LIT, *m.span("told"), noun, at), places
    burns = (
        rf"\b(?P<owner>{_owners(flame=True)})\s+(?P<told>(?:(?:is|are|was|were)\s+)?{_BY}(?:"
        r"(?P<burn>burn(?:s|ed|ing|t)?|flames|flickers|blazes)(?:\s+(?:brightly|steadily|slowly|down))?|"
        r"(?P<catch>catch(?:es|ing)?\s+fire|bursts?\s+into\s+flames?|ignites?)|"
        r"(?P<out>goes\s+out|go\s+out|burns\s+out)|(?:that\s+is\s+)?(?:on\s+fire|ablaze|alight|in\s+flames)))\b"
    )
    for m in _compiled(burns).finditer(text):
        noun = "turned burning" if m["catch"] else "turned out" if m["out"] else "burning"
        only = not re.match(r"(?:is|are|was|were)\s", m["told"]) and not m["catch"] and not m["burn"] and not m["out"]
        shown = Shown(Predicate.LIT, *m.span("told"), noun, m.start("owner"))
        yield shown, [(*m.span("told"), "" if only else _stay(m["told"]))]


def _stay(words: str) -> str:
    """What stands in the place of a verb: nothing moves."""
    if re.match(r"(?:that|which)\s", words) or re.match(r"(?:flash|blink|flicker|glow|shin|burn)\w*ing\b", words, re.IGNORECASE):
        return ""
    return _instead(words, "stands", "lies", "is")


def _whole(text: str, m: re.Match[str]) -> tuple[int, int, str]:
    """Words about the lights of something, with what joins them to the sentence."""
    before = _compiled(r"(?:[,;]?\s*(?:\b(?:and|with|while|as|but)\s+)?(?:(?:its|the|his|her|their|all)\s+)?(?:[\w-]+\s+)?)$")
    joined = before.search(text[: m.start("owner")])
    joined_words = _compiled(r"[,;]?\s*\b(?:and|with|while|as|but)?\s*(?:its|the|his|her|their)\s+(?:[\w-]+\s+)?$")
    joined = joined_words.search(text[: m.start("owner")])
    return (joined.start() if joined else m.start("owner"), m.end("told"), "")


def _of_owner(m: re.Match[str], noun: str, text: str) -> Shown:
    return Shown(
        Predicate.LIT, m.start("owner"), m.end("told"), noun, BEFORE, light=m["owner"].lower()
    )


def _state(m: re.Match[str]) -> str:
    """The noun of a statement by what a pattern found."""
    if m["flash"]:
        return f"flashing {(m['hue'] or '').lower()}".strip()
    if m["glow"]:
        return f"on {(m['tint'] or '').lower()}".strip()
    if m["being"]:
        return f"on {m['being'].lower()}"
    if m["state"]:
        return "off" if m["state"].lower() == "off" else "on"
    if m["up"]:
        return "turned on"
    if m["color"]:
        return f"turned on {m['color'].lower()}"
    return "turned on" if m["how"].lower() == "on" else "turned off"


def _with_lights(text: str) -> Read:
    """ "With its headlights on", "with flashing blue lights", "its lights flashing"."""
    shine = r"(?P<how>on|off|flashing|blinking|flickering|blazing|shining|glowing|lit|lit\s+up|ablaze)"
    part = rf"(?P<owner>(?:[\w-]+\s+)?(?:{_parts()}))"
    first = rf"(?:,?\s*\bwith\s+|,\s*)(?:(?:its|his|her|their|the|all|both)\s+){{0,2}}{part}\s+{shine}\b"
    for m in _compiled(first).finditer(text):
        yield _carried(m, m["owner"], m["how"])
    how = r"(?P<how>flashing|blinking|flickering|shining|glowing|bright|burning|lit)"
    colors = rf"(?P<adj>(?:(?:{_colors()}|bright|emergency)\s+(?:and\s+)?){{0,3}})"
    second = rf",?\s*\bwith\s+(?:its\s+|their\s+)?{how}\s+{colors}(?P<owner>{_parts()})\b"
    for m in _compiled(second).finditer(text):
        yield _carried(m, m["owner"], m["how"], m["adj"])


def _carried(
    m: re.Match[str], light: str, how: str, adj: str = ""
) -> tuple[Shown, list[tuple[int, int, str]]]:
    how = how.lower()
    flashes = how in ("flashing", "blinking", "flickering")
    color = _color(adj) or _color(light)
    noun = f"{'flashing' if flashes else 'off' if how == 'off' else 'on'} {color}".strip()
    word = re.sub(rf"^(?:{_colors()})\s+", "", light.lower())
    start = m.start() + len(m[0]) - len(m[0].lstrip(" ,"))
    shown = Shown(Predicate.LIT, start, m.end(), noun, BEFORE, light=word)
    return shown, [(*m.span(), "")]


def _alight(text: str) -> Read:
    """ "A burning stick", "a lit candle", "a flashing ambulance", "a car on fire"."""
    lamp = rf"(?P<told>lit|lighted|glowing|flashing|blinking|flickering|illuminated)\s+(?P<adj>{_WORDS})(?P<owner>{_owners(flame=False)})\b"
    fire = rf"(?P<told>burning|lit|lighted|flaming|blazing|flickering)\s+(?P<adj>{_WORDS})(?P<owner>{_owners(flame=True)})\b"
    for pattern, burns in ((fire, True), (lamp, False)):
        for m in _compiled(r"(?<![\w-])" + pattern).finditer(text):
            if _compiled(r"\b(?:of|and|with|the|a|an)\b").search(m["adj"]):
                continue
            flashes = m["told"].lower() in ("flashing", "blinking", "flickering")
            noun = "burning" if burns else f"{'flashing' if flashes else 'on'} {_color(m['adj'])}".strip()
            yield Shown(Predicate.LIT, *m.span("told"), noun, m.start("owner")), [(*m.span("told"), "")]


def _lively(words: str) -> str:
    return next((w for w in re.findall(r"[a-z]+", words.lower()) if w in LIVELY), "")


@cache
def _said_as() -> dict[str, str]:
    return {w: row.name for row in weathers().values() for w in row.said_as}


def _weather(text: str) -> Read:
    """ "In the rain", "it is snowing and", "on a foggy night", "snow is falling"."""
    said = _any([*_said_as()])
    lying = r"(?P<falls>\s+(?:is\s+|are\s+|was\s+)?(?:fall|pour|com)(?:s|es|ing)?(?:\s+down)?(?:\s+(?:heavily|hard|gently|softly|steadily))?)"
    adj = r"(?P<adj>(?:(?:heavy|light|thick|dense|pouring|driving|gentle|strong|steady|cold|fierce|raging|violent|freezing)\s+){0,2})"
    patterns = (
        rf"\b(?:(?:and|while|as|when)\s+)?it\s+(?:is|was|starts\s+off)?\s*(?P<adj>(?:heavily\s+|lightly\s+)?)(?P<said>{said}|hails)\b(?:\s+(?:heavily|hard|lightly|outside|softly))?(?:\s*,?\s*(?:and|while|as|when)\b)?",
        rf"(?:,?\s*\b(?:and|while|as)\s+)?(?:(?<=^)|(?<=\s)|(?<=,))(?:the\s+)?{adj}(?P<said>{said}|snow){lying}(?=\s*(?:[.,;]|$|and\b|on\b|onto\b|as\b|while\b|from\b|around\b|over\b))(?:\s+(?:on|onto|over|around|from)\s+(?:the\s+)?(?:ground|sky|him|her|them|it|outside))?(?:\s*,?\s*(?:and|while|as)\b)?",
        rf"\b(?:in|through|during|under|amid|amidst|into|despite|against)\s+(?:(?:the|a|an|some)\s+)?{adj}(?P<said>{said}|falling\s+snow)\b(?!\s+(?:\w+s?\b)?(?:forest|day|night|street|road|window|coat|boots|jacket|sea|ocean|weather|morning|evening|city|alley|field|mountain|beach))",
        rf"\b(?P<said>rainy|foggy|misty|stormy|hazy)(?=\s+(?:and\s+\w+\s+)?(?:day|night|street|road|weather|morning|evening|city|alley|field|mountain|beach|afternoon|forest|sea|highway|bridge|park)\b)",
    )
    for k, pattern in enumerate(patterns):
        for m in _compiled(pattern).finditer(text):
            word = re.sub(r"\s+", " ", m["said"].lower())
            name = _said_as().get(word, "snow" if "snow" in word else "hail")
            much = _lively(m["adj"]) if k < 3 else ""
            much = {"heavily": "heavy", "lightly": "light"}.get((m["adj"] if k < 3 else "").strip().lower(), much)
            start = m.start() + len(m[0]) - len(m[0].lstrip(" ,"))
            words = m[0].rstrip()
            end = m.start() + len(re.sub(r"\s*,?\s*(?:and|while|as|when)$", "", words, flags=re.IGNORECASE))
            yield Shown(Predicate.WEATHER, start, end, f"{much} {name}".strip()), [(*m.span(), "")]


def _sways(text: str) -> Read:
    """ "Flowers sway in the wind", "a flag waves", "branches blowing in the breeze"."""
    kinds = {*swaying()}
    words = [w for w, noun in lex.nouns().items() if noun.name in kinds or w in kinds]
    owners = _any([*words, *kinds, *(w + "s" for w in words), *(w + "es" for w in kinds), "branches", "leaves", "grasses"])
    verb = r"(?:sway|swing|wav|wave|flutter|flap|blow|rustl|rustle|danc|dance|bend|mov|move|rippl|ripple|trembl|tremble|shak|shake|bob|stream|fl(?:y|ie))(?:s|es|ed|ing)?"
    gently = r"(?:\s+(?:gently|softly|slowly|slightly|proudly|back\s+and\s+forth|violently|wildly|freely|lightly|around|about))*"
    wind = r"\s+(?:in|with|by|under)\s+(?:(?:the|a|an)\s+)?(?P<adj>(?:strong|gentle|light|soft|heavy|summer|warm|cool|cold)\s+)?(?:wind|winds|breeze|gusts?)\b"
    alone = r"(?:sways?|flutters?|flaps?|swaying|fluttering|flapping)"
    pattern = (
        rf"\b(?P<owner>{owners})\s+(?P<told>(?:that\s+|which\s+)?(?:is\s+|are\s+|was\s+|were\s+)?(?:(?:gently|softly|slowly)\s+)?"
        rf"(?:{verb}{gently}{wind}|{alone}{gently}(?=\s*(?:[.,;]|$|and\b|beside\b|on\b|over\b|while\b|as\b))))"
    )
    for m in _compiled(pattern).finditer(text):
        much = _lively(m["adj"] or "")
        ing = re.match(r"(?:that|which)\b|\w+ing\b", m["told"], re.IGNORECASE)
        shown = Shown(Predicate.SWAYS, *m.span("told"), much, m.start("owner"))
        yield shown, [(*m.span("told"), "" if ing else "stand" if m["owner"].lower().endswith("s") else _stay(m["told"]))]
