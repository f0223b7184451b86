"""What shines, burns, falls from the sky or sways in the wind: taken out of the text.

"A car with its headlights on drives away" is read as "a car drives away", "a lamp goes out" as "a
lamp stands", and what was said is kept beside: it changes how things look, and moves nothing.
"""

from __future__ import annotations

from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.text.alternatives import Blank, any_of, taken
from esg.draft.text.plumes import given_off
from esg.draft.text.shown import BEFORE, Read, Shown
from esg.graph.models import Predicate
from esg.lexicon.shown import LIVELY, lights, swaying, weathers


def take_shown(text: str, blank: Blank) -> list[Shown]:
    """Reads and takes out of a text what is said of lights, weather and wind.

    Args:
        text: A prompt as it was screened.
        blank: Puts other words, no longer than they are, in the place of some.
    """
    if not _ANY.search(text):
        return []
    readers = (given_off, _weather, _sways, _switched, _changes, _with_lights, _alight)
    return taken((found for read in readers for found in read(text)), blank)


_ANY = re.compile(
    r"\b(?:smok|smou?lder|steam|vapou?r|fumes|exhaust|dust|sand\b|dirt\b|spark|powder|turn|switch|lit\b|light|head\s?l|tail\s?l|siren|candle|torch|extinguish|ignit|lamp|lantern|led\b|burn|flam|fire\b|flash|flicker|blink|glow|shin"
    r"|goes\s+(?:on|out|off)|rain|snow|hail|fog|mist|haz[ey]|storm|drizzl|downpour|blizzard|sway|"
    r"swing|wind\b|breeze|flutter|flap|blaz|ablaze|(?:tv|television|screen|monitor)s?\b)",
    re.IGNORECASE,
)
_WORDS = r"(?:[\w-]+\s+){0,2}?"
_BY = r"(?:suddenly\s+|slowly\s+|then\s+|all\s+|both\s+|brightly\s+|steadily\s+)?"


@cache
def _owners(*, flame: bool) -> str:
    """Nouns of what can be lit, or burns; vehicles only by their lights."""
    kinds = {k for row in lights().values() if row.flame is flame for k in row.of}
    words = [w for w, noun in lex.nouns().items() if noun.name in kinds or w in kinds]
    words += [*kinds - {"@vehicle"}, *(() if flame else ("led", "light"))]
    return any_of([*words, *(w + "s" for w in words)])


@cache
def _parts() -> str:
    return any_of([w for row in lights().values() if not row.flame for w in row.words])


@cache
def _colors() -> str:
    return any_of([c for c in lex.COLORS if c.isalpha()])


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


_DOES = r"(?P<verb>(?P<is>(?:is|are|was|were)\s+)?"
_DET = r"(?P<det>(?:the|a|an|his|her|its|their)\s+)"
_IMPERATIVE = re.compile(r"(?:^|[.,;]|\band|\bthen|\bto)\s*$", re.IGNORECASE)


@cache
def _switches() -> re.Pattern[str]:
    by = (
        r"(?P<by>(?:toggle|move|press|push|flip|flick|pull|click|hit|use)(?:s|es|ing)?\s+(?:the|a)"
        r"\s+(?:[\w-]+\s+){0,2}?(?:switch|button|lever|knob|cord|chain)\s+to\s+)?"
    )
    verb = rf"{_DOES}(?:turn|switch|flip)(?:s|es|ed|ing)?\s+(?:(?P<how>on|off)\s+)?)"
    owner = rf"{_DET}(?P<adj>{_WORDS})(?P<owner>{_owners(flame=False)})\b"
    end = r"(?(how)|\s+(?P<last>on|off)\b)(?!\s+(?:switch|button))"
    return _compiled(rf"\b{by}{verb}{owner}{end}")


@cache
def _kindles() -> re.Pattern[str]:
    verb = (
        rf"{_DOES}(?:(?:lights?|lit|lighting|ignites?|ignit(?:ed|ing))(?:\s+up)?|(?P<out>"
        r"(?:blows?|blew|blowing|puts?|putting)\s+out|extinguish(?:es|ed|ing)?)|"
        r"sets?\s+fire\s+to)\s+)"
    )
    owner = rf"{_DET}(?P<adj>{_WORDS})(?P<owner>{_owners(flame=True)})\b"
    return _compiled(rf"(?<!\w)(?<!a )(?<!the ){verb}{owner}")


def _switched(text: str) -> Read:
    """ "Turns the lamp off", "toggle the button to turn off the led", "lights a candle"."""
    for m in _switches().finditer(text):
        on = (m["how"] or m["last"]).lower()
        first = m.start("by") if m["by"] else m.start("verb")
        own = m["by"] or _IMPERATIVE.search(text[:first])
        room = m.start("det") - first + (m.end() - m.end("owner"))
        near = "see" if own else _near(text, room, m.end())
        about, places = m.start("owner"), [(first, m.start("det"), near), *_named(m)]
        if m["last"]:  # "turns the lamp off": the noun moves
            told = f"{near} {text[m.start('det') : m.end('owner')]}"
            about = first + len(told) - len(m["owner"])
            told = re.sub(r"\blight(s?)$", r"lamp\1", told)
            places = [(first, m.end(), told)]
        act = m.span("by") if m["by"] else m.span("verb")
        act = (act[0], act[0] + len(text[act[0] : act[1]].rstrip()))
        color = _color(m["adj"]) if m["owner"].lower().startswith(("light", "led")) else ""
        noun = f"turned {on} {color}".strip()
        yield Shown(Predicate.LIT, first, m.end(), noun, about, act=act), places
    for m in _kindles().finditer(text):
        room = m.start("det") - m.start("verb")
        own = _IMPERATIVE.search(text[: m.start("verb")])
        near = "see" if own else _near(text, room, m.end())
        noun = "turned out" if m["out"] else "turned burning"
        act = (m.start("verb"), m.start("verb") + len(m["verb"].rstrip()))
        at = m.start("verb"), m.end("owner")
        shown = Shown(Predicate.LIT, *at, noun, m.start("owner"), act=act)
        yield shown, [(*m.span("verb"), near)]


def _near(text: str, room: int, after: int) -> str:
    """Where somebody is who does something to what stands behind: beside it, unless that is on
    something itself, or there is no room for the words."""
    held = re.compile(r"\s+(?:on|in|at|inside|under)\b").match(text, after)
    words = ("sees", "see") if held else ("stands near", "is near", "sees", "see")
    return next((w for w in words if len(w) < room), "")


@cache
def _change() -> re.Pattern[str]:
    color = rf"(?P<color>{_colors()})"
    says = (
        rf"(?P<told>(?:that\s+|which\s+)?(?:(?:is|are|was|were)\s+)?{_BY}"
        r"(?:(?:(?:turn|switch|come|go|flick)(?:s|es|ed|ing)?|came|went)\s+(?:back\s+)?"
        rf"(?:(?P<how>on|off|out)|(?:from\s+\w+\s+)?(?:to\s+)?{color})|"
        r"(?P<up>lights?\s+up|lit\s+up)|(?P<flash>flash|blink|flicker|strobe)(?:s|es|ed|ing)?"
        rf"(?:\s+(?:on\s+and\s+off|brightly|rapidly|slowly|(?P<hue>{_colors()})))*|"
        rf"(?P<glow>glow|shine)(?:s|d|ing)?(?:\s+brightly|\s+(?P<tint>{_colors()}))?|"
        r"(?:(?<=is\s)|(?<=are\s))(?:(?P<state>on|off|lit)|(?P<being>red|green|amber|yellow))"
        r"(?=\s*(?:[.,;]|$|and\b|while\b|as\b))))"
    )
    owner = rf"\b(?P<owner>{_owners(flame=False)}|{_parts()})\s+"
    return _compiled(owner + says + r"(?!\s+(?:the|a|an|his|her|its|by|past)\b)\b")


def _changes(text: str) -> Read:
    """ "The lamp goes out", "a traffic light turns red", "its lights flash", "the screen is on"."""
    for m in _change().finditer(text):
        noun, word, before = _state(m), m["owner"].lower(), text[: m.start("owner")]
        shown = Shown(Predicate.LIT, *m.span("told"), noun, m.start("owner"))
        lamp = re.fullmatch(_owners(flame=False), word) is not None
        if word in ("light", "lights"):
            of_road = _compiled(r"\b(?:traffic|stop|street)\s+$").search(before) is not None
            signal = _instead(m[0], "signal stands", "signal is")
            if not of_road and m["color"] in _SIGNALS and signal:
                yield shown, [(*m.span(), signal)]  # "the light turns green": of the traffic
                continue
            lamp = of_road or not _owned().search(before)
            if lamp and not of_road:
                if not _bare().search(before):
                    continue  # "hazard lights", "Christmas lights"
                told = "lamps" if word == "lights" else "lamp"
                yield shown, [(*m.span("owner"), told), (*m.span("told"), _stay(m["told"]))]
                continue
        if lamp:
            yield shown, [(*m.span("told"), _stay(m["told"]))]
        else:
            yield _of_owner(m, noun), [_whole(text, m)]
    yield from _burns(text)


def _burns(text: str) -> Read:
    """ "A candle burns", "a car catches fire", "a house on fire", "the torch goes out"."""
    burns = (
        rf"\b(?P<owner>{_owners(flame=True)})\s+(?P<told>(?:(?:is|are|was|were)\s+)?{_BY}(?:"
        r"(?P<burn>burn(?:s|ed|ing|t)?|flames|flickers|blazes)"
        r"(?:\s+(?:brightly|steadily|slowly|down))?|"
        r"(?P<catch>catch(?:es|ing)?\s+fire|bursts?\s+into\s+flames?|ignites?)|"
        r"(?P<out>goes\s+out|go\s+out|burns\s+out)|"
        r"(?:that\s+is\s+)?(?:on\s+fire|ablaze|alight|in\s+flames)))\b"
    )
    for m in _compiled(burns).finditer(text):
        noun = "turned burning" if m["catch"] else "turned out" if m["out"] else "burning"
        acts = m["catch"] or m["burn"] or m["out"] or re.match(r"(?:is|are|was|were)\s", m["told"])
        shown = Shown(Predicate.LIT, *m.span("told"), noun, m.start("owner"))
        yield shown, [(*m.span("told"), _stay(m["told"]) if acts else "")]


_SIGNALS = ("red", "green", "amber", "yellow")


def _stay(words: str) -> str:
    """What stands in the place of a verb: nothing moves."""
    if re.match(r"(?:that|which)\s", words) or re.match(
        r"(?:flash|blink|flicker|glow|shin|burn)\w*ing\b", words, re.IGNORECASE
    ):
        return ""
    return _instead(words, "stands", "lies", "is")


@cache
def _owned() -> re.Pattern[str]:
    """Before lights that are somebody's or something's: "its", "and their bright"."""
    return _compiled(
        r"[,;]?\s*(?:\b(?:and|with|while|as|but)\s+)?\b(?:its|his|her|their)\s+"
        rf"(?:(?:bright|{_colors()})\s+)?$"
    )


@cache
def _bare() -> re.Pattern[str]:
    """Before lights of which nothing else is said than how many and of which colour they are."""
    return _compiled(
        r"(?:^|[.,;:]\s*|\b(?:a|an|the|all|both|and|one|two|three|as|when|while|that|this)\s+)"
        rf"(?:(?:bright|small|little|large|single|{_colors()})\s+){{0,2}}$"
    )


def _whole(text: str, m: re.Match[str]) -> tuple[int, int, str]:
    """Words about the lights of something, with what joins them to the sentence."""
    before = text[: m.start("owner")]
    if (whose := re.search(r"(?:'s|s')\s+(?:[\w-]+\s+)?$", before)) is not None:
        return (whose.start(), m.end("told"), " is")  # "the car's headlights are on"
    owned = _owned().search(before)
    return (owned.start() if owned else m.start("owner"), m.end("told"), "")


def _of_owner(m: re.Match[str], noun: str) -> Shown:
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
    if m["color"]:
        return f"turned on {m['color'].lower()}"
    on = m["up"] or m["how"].lower() == "on"
    return f"turned {'on' if on else 'off'} {_color(m['owner'])}".strip()


def _with_lights(text: str) -> Read:
    """ "With its headlights on", "with flashing blue lights", "its lights flashing"."""
    shine = (
        r"(?P<how>on|off|flashing|blinking|flickering|blazing|shining|glowing|lit|lit\s+up|ablaze)"
    )
    part = rf"(?P<owner>(?:(?:{_colors()}|bright|both|twin)\s+)?(?:{_parts()}))"
    whose = r"(?:(?:its|his|her|their|the|all|both)\s+){0,2}"
    first = rf"(?:,?\s*\bwith\s+|,\s*){whose}{part}\s+{shine}\b"
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
    color = _color(adj) or _color(light)
    noun = f"{'off' if how.lower() == 'off' else _glows(how)} {color}".strip()
    word = re.sub(rf"^(?:{_colors()}|bright|both|twin)\s+", "", light.lower())
    start = m.start() + len(m[0]) - len(m[0].lstrip(" ,"))
    shown = Shown(Predicate.LIT, start, m.end(), noun, BEFORE, light=word)
    return shown, [(*m.span(), "")]


def _glows(word: str) -> str:
    """What a participle says of a light."""
    return "flashing" if word.lower() in ("flashing", "blinking", "flickering") else "on"


def _alight(text: str) -> Read:
    """ "A burning stick", "a lit candle", "a flashing ambulance"."""
    fire, lamp = (
        rf"(?<![\w-])(?P<told>{words})\s+(?P<adj>{_WORDS})(?P<owner>{_owners(flame=flame)})\b"
        for words, flame in (
            ("burning|lit|lighted|flaming|blazing|flickering", True),
            ("lit|lighted|glowing|flashing|blinking|flickering|illuminated", False),
        )
    )
    for pattern, burns in ((fire, True), (lamp, False)):
        for m in _compiled(pattern).finditer(text):
            if re.search(r"\b(?:of|and|with|the|a|an)\b", m["adj"], re.IGNORECASE):
                continue
            noun = "burning" if burns else f"{_glows(m['told'])} {_color(m['adj'])}".strip()
            shown = Shown(Predicate.LIT, *m.span("told"), noun, m.start("owner"))
            yield shown, [(*m.span("told"), "")]


def _lively(words: str) -> str:
    return next((w for w in re.findall(r"[a-z]+", words.lower()) if w in LIVELY), "")


@cache
def _said_as() -> dict[str, str]:
    return {w: row.name for row in weathers().values() for w in row.said_as}


_AND = re.compile(r"\s*,?\s*\b(?:and|while|as|when)$", re.IGNORECASE)
_MUCH = {"heavily": "heavy", "hard": "heavy", "lightly": "light", "gently": "light"}


@cache
def _of_weather() -> tuple[re.Pattern[str], ...]:
    every = [w for w in _said_as()]
    nouns = [w for w in every if not w.endswith(("y", "ing", "s")) or w in ("snow flurries",)]
    said = rf"(?P<said>{any_of(every)}"
    adj = (
        r"(?P<adj>(?:(?:heavy|light|thick|dense|pouring|driving|gentle|strong|steady|cold|fierce|"
        r"raging|violent|freezing)\s+){0,2})"
    )
    how = r"(?P<how>\s+(?:heavily|hard|gently|softly|steadily|lightly))?"
    joined = r"(?:\s*,?\s*\b(?:and|while|as|when)\b)?"
    return (
        _compiled(
            r"\b(?:(?:and|while|as|when)\s+)?it\s+(?:is|was)?\s*(?P<adj>(?:heavily\s+|lightly\s+)?)"
            rf"{said}|hails)\b{how}(?:\s+outside)?{joined}"
        ),
        _compiled(
            rf"(?:,?\s*\b(?:and|while|as)\s+)?\b(?:the\s+)?{adj}{said}|snow)\s+(?:is\s+|was\s+)?"
            rf"(?:fall|pour|com)(?:s|ing)?(?:\s+down)?{how}(?:(?P<on>\s+(?:on|onto|over)\s+)"
            r"(?=(?:a|an|the|his|her)\s+(?!ground\b)\w)|(?:\s+(?:on|onto|over|around|from)\s+"
            r"(?:(?:the\s+)?(?:ground|sky)|him|her|them))?(?=\s*(?:[.,;]|$|and\b|as\b|while\b))"
            rf"{joined})"
        ),
        _compiled(
            rf"\b(?:in|through|during|under|amid|amidst|into|despite)\s+(?:(?:the|a|an|some)\s+)?"
            rf"{adj}(?P<said>{any_of(nouns)}|falling\s+snow)\b(?:\s+and\s+(?P<also>{any_of(nouns)})\b)?"
            r"(?!\s+(?:forest|day|night|street|road|window|coat|boots|jacket|sea|ocean|clouds?)\b)"
        ),
        _compiled(
            r"\b(?P<said>rainy|foggy|misty|stormy|hazy)(?=\s+(?:day|night|street|road|weather|"
            r"morning|evening|city|alley|field|mountain|beach|afternoon|forest|highway|bridge|"
            r"park)\b)"
        ),
    )


def _weather(text: str) -> Read:
    """ "In the rain", "it is snowing and", "on a foggy night", "snow is falling"."""
    for pattern in _of_weather():
        for m in pattern.finditer(text):
            told = m.groupdict()
            word = re.sub(r"\s+", " ", m["said"].lower())
            name = _said_as().get(word, "snow" if "snow" in word else "hail")
            words = f"{told.get('adj') or ''} {told.get('how') or ''}".lower()
            much = next((_MUCH[w] for w in words.split() if w in _MUCH), _lively(words))
            start = m.start() + len(m[0]) - len(m[0].lstrip(" ,"))
            end = m.start() + len(_AND.sub("", m[0].rstrip()))
            instead = ""
            if told.get("on"):
                room = len(m[0].lstrip(" ,"))
                gap = m[0][: len(m[0]) - room]  # what parts it from the word before
                instead, end = gap + _instead(m[0][-room:], "There is "), m.start("on")
            also = told.get("also")
            shown = Shown(
                Predicate.WEATHER, start, m.end("said") if also else end, f"{much} {name}".strip()
            )
            yield shown, [(*m.span(), instead)]
            if also:
                yield Shown(Predicate.WEATHER, *m.span("also"), _said_as()[also.lower()]), []


@cache
def _swayers() -> str:
    kinds = {*swaying()}
    words = [w for w, noun in lex.nouns().items() if noun.name in kinds or w in kinds]
    several = (*(w + "s" for w in words), *(w + "es" for w in kinds), "leaves")
    return any_of([*words, *kinds, *several])


@cache
def _swings() -> re.Pattern[str]:
    verb = (
        r"(?:sway|swing|wav|wave|flutter|flap|blow|rustl|rustle|danc|dance|bend|mov|move|rippl|"
        r"ripple|trembl|tremble|shak|shake|bob|stream|fl(?:y|ie))(?:s|es|ed|ing)?"
    )
    gently = (
        r"(?:\s+(?:gently|softly|slowly|slightly|proudly|back\s+and\s+forth|violently|wildly|"
        r"freely|lightly|around|about))*"
    )
    wind = (
        r"\s+(?:in|with|by|under)\s+(?:(?:the|a|an)\s+)?(?P<adj>(?:strong|gentle|light|soft|heavy|"
        r"summer|warm|cool|cold)\s+)?(?:wind|winds|breeze|gusts?)\b"
    )
    alone = (
        rf"(?:sway|flutter|flap)(?:s|ing)?{gently}"
        r"(?=\s*(?:[.,;]|$|and\b|beside\b|on\b|over\b|while\b|as\b))"
    )
    return _compiled(
        rf"\b(?P<owner>{_swayers()})\s+(?P<told>(?:that\s+|which\s+)?(?:is\s+|are\s+|was\s+|"
        rf"were\s+)?(?:(?:gently|softly|slowly)\s+)?(?:{verb}{gently}{wind}|{alone}))"
    )


def _sways(text: str) -> Read:
    """ "Flowers sway in the wind", "a flag waves", "branches blowing in the breeze"."""
    for m in _swings().finditer(text):
        shown = Shown(Predicate.SWAYS, *m.span("told"), _lively(m["adj"] or ""), m.start("owner"))
        only = re.match(r"(?:that|which)\b|\w+ing\b", m["told"], re.IGNORECASE)
        stays = "stand" if m["owner"].lower().endswith("s") else _stay(m["told"])
        yield shown, [(*m.span("told"), "" if only else stays)]
