"""Noun phrases: head noun, modifiers, identifiers and counts.

One parser reads both sides of a binding, the suite's phrase and the texts of a body, so that both
are folded the same way ("trash can", "trash-can" and "dustbin" all become head `bin`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
import re

from esg.metrics.normalization import normalize, singular

_ARTICLES = {"a", "an", "the", "this", "that", "these", "those", "its", "his", "her", "their"}
_QUANTIFIERS = {"several", "many", "some", "multiple", "few", "various", "all", "numerous"}
_DISTRIBUTIVE = {"each", "every", "any", "either"}
_COUNTS = {
    "one": 1,
    "single": 1,
    "two": 2,
    "both": 2,
    "pair": 2,
    "three": 3,
    "four": 4,
    "five": 5,
    "six": 6,
    "seven": 7,
    "eight": 8,
    "nine": 9,
    "ten": 10,
    "eleven": 11,
    "twelve": 12,
    "dozen": 12,
}
ORDINALS = {
    "first": 1,
    "second": 2,
    "third": 3,
    "fourth": 4,
    "fifth": 5,
    "sixth": 6,
    "seventh": 7,
    "eighth": 8,
    "ninth": 9,
    "tenth": 10,
    "other": 2,
    "another": 2,
    "last": -1,
    "final": -1,
}
_COLLECTIVE = {
    "set", "row", "group", "pair", "stack", "pile", "rack", "line", "cluster", "bunch", "column",
    "number", "couple", "tower", "pyramid", "queue", "collection", "heap", "dozen", "rest",
}  # fmt: skip
COMPOUNDS = {
    "stack",
    "pile",
    "heap",
    "tower",
    "pyramid",
    "cluster",
    "bunch",
    "column",
    "queue",
    "row",
}
"""Collectives that may follow what they are made of: a tire stack, a brick pile."""
_PREPOSITIONS = {
    "on", "in", "at", "by", "near", "under", "behind", "beside", "next", "of", "with", "without",
    "from", "to", "inside", "above", "below", "along", "across", "over", "that", "which", "for",
    "ahead", "standing", "lying", "sitting", "parked", "stopped", "placed", "moving", "made",
    "labeled", "weighing", "weigh", "named", "called",
}  # fmt: skip

_HEAD_SYNONYMS = {
    "car": ("automobile", "auto", "sedan", "hatchback", "coupe", "motorcar", "saloon"),
    "jeep": ("suv", "4x4"),
    "truck": ("lorry", "pickup"),
    "van": ("minivan",),
    "taxi": ("cab", "taxicab"),
    "bus": ("minibus",),
    "bicycle": ("bike", "cycle", "pushbike"),
    "motorcycle": ("motorbike", "moped"),
    "bin": ("trashbin", "trashcan", "dustbin", "wastebasket", "dumpster", "wastebin"),
    "ball": ("sphere", "orb", "billiard"),
    "pin": ("tenpin", "ninepin", "skittle"),
    "box": ("carton", "parcel", "package", "cuboid"),
    "block": ("cube", "brick"),
    "cone": ("pylon",),
    "cup": ("mug",),
    "glass": ("tumbler",),
    "sofa": ("couch", "settee"),
    "shelf": ("bookshelf", "bookcase", "rack"),
    "cabinet": ("cupboard", "wardrobe"),
    "cart": ("trolley",),
    "barrel": ("keg",),
    "rock": ("stone", "boulder"),
    "pole": ("post", "pillar"),
    "ramp": ("slope", "incline"),
    "stairs": ("staircase", "steps", "stairway", "stair"),
    "mailbox": ("postbox", "letterbox"),
    "television": ("tv",),
    "monitor": ("screen",),
    "phone": ("telephone", "smartphone", "cellphone"),
    "bucket": ("pail",),
    "suitcase": ("luggage",),
    "person": ("pedestrian", "man", "woman", "human"),
    "goal": ("goalpost", "goalmouth"),
    "puck": (),
    "streetlamp": ("streetlight", "lamppost"),
    "flowerpot": ("planter",),
    "fence": ("railing",),
    "aeroplane": ("airplane", "plane", "aircraft"),
    "boat": ("ship",),
    "laptop": ("notebook",),
    "plate": ("dish",),
    "tyre": ("tire",),
}
_CANONICAL = {word: head for head, words in _HEAD_SYNONYMS.items() for word in words}

_MODIFIER_SYNONYMS = {
    "football": "soccer", "foot": "soccer", "pool": "billiard", "snooker": "billiard",
    "billiards": "billiard", "tenpin": "bowling", "wood": "wooden", "grey": "gray",
    "metallic": "metal", "steel": "metal", "leading": "front", "lead": "front",
    "forward": "front", "ahead": "front",
    "back": "rear", "trailing": "rear", "following": "rear", "hind": "rear", "behind": "rear",
    "upper": "top", "lower": "bottom", "leftmost": "left", "rightmost": "right",
    "center": "middle", "centre": "middle", "central": "middle", "little": "small",
    "tiny": "small", "big": "large", "huge": "large", "giant": "large", "racing": "race",
    "cardboard": "cardboard", "sport": "sports", "crimson": "red", "scarlet": "red",
    "golden": "gold", "ebony": "black",
}  # fmt: skip

CLASS_MODIFIERS = {
    "soccer", "basket", "bowling", "billiard", "cue", "tennis", "golf", "base", "volley", "beach",
    "pingpong", "cricket", "medicine", "snow", "hand", "hockey", "rugby", "yoga", "exercise",
    "picnic", "dining", "coffee", "police", "race", "toy", "fire", "garbage", "cargo", "school",
    "wine", "water", "beer", "milk", "tool", "lunch", "cannon", "crystal", "rolling", "street",
    "floor", "traffic", "stop", "marble", "bocce", "disco", "wrecking",
}  # fmt: skip
"""Modifiers that name another kind of thing: a soccer ball is not a bowling ball."""

POSITIONS = {"front", "rear", "left", "right", "top", "bottom", "middle"}
OPPOSITE = {"front": "rear", "rear": "front", "left": "right", "right": "left", "top": "bottom",
            "bottom": "top"}  # fmt: skip

COMPARISONS: dict[str, tuple[str, int]] = {
    **dict.fromkeys(("lighter", "lightest"), ("mass", -1)),
    **dict.fromkeys(("heavier", "heaviest"), ("mass", 1)),
    **dict.fromkeys(("taller", "tallest"), ("height", 1)),
    **dict.fromkeys(("shorter", "shortest"), ("height", -1)),
    **dict.fromkeys(("longer", "longest"), ("length", 1)),
    **dict.fromkeys(("wider", "widest", "broader", "broadest"), ("width", 1)),
    **dict.fromkeys(("narrower", "narrowest", "thinner", "thinnest"), ("width", -1)),
    **dict.fromkeys(("bigger", "biggest", "larger", "largest"), ("size", 1)),
    **dict.fromkeys(("smaller", "smallest"), ("size", -1)),
    **dict.fromkeys(("higher", "highest"), ("altitude", 1)),
    "lowest": ("altitude", -1),
    **dict.fromkeys(("nearer", "nearest", "closer", "closest"), ("distance", -1)),
    **dict.fromkeys(("farther", "farthest", "further", "furthest"), ("distance", 1)),
}
"""What comparatives and superlatives compare, and whether the most (1) or the least has it."""

COLORS: dict[str, tuple[float, float, float]] = {
    "black": (0.05, 0.05, 0.05),
    "white": (0.95, 0.95, 0.95),
    "gray": (0.5, 0.5, 0.5),
    "red": (0.8, 0.1, 0.1),
    "green": (0.1, 0.6, 0.15),
    "blue": (0.1, 0.2, 0.8),
    "yellow": (0.95, 0.85, 0.1),
    "orange": (0.95, 0.5, 0.05),
    "purple": (0.5, 0.1, 0.6),
    "pink": (0.95, 0.55, 0.7),
    "brown": (0.45, 0.28, 0.12),
    "gold": (0.85, 0.65, 0.15),
    "silver": (0.75, 0.75, 0.78),
    "cyan": (0.1, 0.8, 0.85),
    "beige": (0.88, 0.82, 0.68),
}

# fmt: off
HYPERNYMS: dict[str, set[str]] = {
    "vehicle": {
        "car", "jeep", "truck", "bus", "van", "taxi", "motorcycle", "tractor", "bicycle", "scooter",
    },
    "car": {"jeep", "taxi"},
    "motorcycle": {"scooter"},
    "furniture": {"desk", "table", "chair", "sofa", "shelf", "cabinet", "bench", "stool", "bed"},
    "container": {"box", "crate", "bin", "bucket", "barrel", "basket", "suitcase"},
    "plant": {"tree", "flowerpot", "bush"},
    "seat": {"chair", "stool", "sofa", "bench"},
    "computer": {"laptop", "monitor"},
    "toy": {"ball", "block", "car", "train"},
}
# fmt: on
RELATED: dict[str, set[str]] = {
    "desk": {"table"},
    "table": {"desk"},
    "box": {"crate", "block"},
    "crate": {"box"},
    "block": {"box"},
    "bin": {"basket", "bucket"},
    "basket": {"bin", "hoop"},
    "hoop": {"basket"},
    "cup": {"glass"},
    "glass": {"cup"},
    "truck": {"van"},
    "wall": {"fence"},
    "bench": {"table"},
    "barrel": {"drum"},
    "drum": {"barrel"},
}
GROUND_WORDS = {
    "ground", "floor", "street", "road", "pavement", "asphalt", "grass", "lawn", "field", "earth",
    "pitch", "sidewalk", "parkinglot", "terrain", "sand", "snow", "ice", "carpet",
}  # fmt: skip

PORTIONS = frozenset(
    {"sheet", "slab", "block", "pane", "piece", "plate", "floe", "lump", "chunk", "loaf", "bar"}
)
"""What something of a stuff is called that goes by the stuff alone: a "sheet of ice" is the ice."""


@dataclass(frozen=True)
class Phrase:
    """A parsed noun phrase.

    Args:
        text: Normalised text.
        head: Canonical singular head noun, "" if there is none.
        word: The head as it is written, singular ("sedan", whose canonical head is "car").
        modifiers: Canonical words before the head, in order, without articles and counts.
        identifier: Letter or number that names one of several ("ball A" -> "a", "car 2" -> "2").
        ordinal: 1 for "first", -1 for "last", None without.
        count: Stated number ("two cars" -> 2), None without.
        plural: Whether the phrase names a set.
    """

    text: str
    head: str
    word: str
    modifiers: tuple[str, ...]
    identifier: str | None
    ordinal: int | None
    count: int | None
    plural: bool

    @property
    def classes(self) -> frozenset[str]:
        """Modifiers that tell kinds of things apart, such as `billiard`."""
        return frozenset(m for m in self.modifiers if m in CLASS_MODIFIERS)

    @property
    def colors(self) -> frozenset[str]:
        """Modifiers that are colours."""
        return frozenset(m for m in self.modifiers if m in COLORS)

    @property
    def positions(self) -> frozenset[str]:
        """Modifiers that say where among others, such as `left`."""
        return frozenset(m for m in self.modifiers if m in POSITIONS)


def canonical_modifier(word: str) -> str:
    """Folds a modifier: soccer for football, front for leading, gray for grey."""
    return _MODIFIER_SYNONYMS.get(word, word)


@lru_cache(maxsize=4096)
def parse(text: str) -> Phrase:
    """Parses a noun phrase; never fails (an empty phrase has an empty head)."""
    norm = normalize(text)
    words, count, plural = _without_count(norm.split())
    words, tail = _without_clause(words)
    words, identifier = _without_identifier(words)
    ordinal, kept = _without_ordinal(words[:-1])
    head = words[-1] if words else ""
    stem = singular(head)
    plural = plural or stem != head or (count or 0) > 1
    if stem == "billiard" and head == "billiards":
        kept.append("billiard")
    head, implied = _split_head(stem)
    modifiers = tuple(canonical_modifier(m) for m in (*kept, *implied, *_place_words(tail)))
    return Phrase(norm, head, stem, modifiers, identifier, ordinal, count, plural)


def _without_count(words: list[str]) -> tuple[list[str], int | None, bool]:
    """The words after articles and counts, the number they state, and whether they name a set."""
    count: int | None = None
    plural = False
    # "one of the cars", "a set of bowling pins": the head stands behind "of".
    for i, w in enumerate(words[:-1]):
        if words[i + 1] == "of" and (w in _COLLECTIVE or w in _COUNTS or w in _DISTRIBUTIVE):
            plural = w in _COLLECTIVE
            count = 2 if w in ("pair", "couple") else None
            words = words[i + 2 :]
            break
    words = _strip_leading(words)
    if words and (words[0] in _QUANTIFIERS or words[0] in _DISTRIBUTIVE):
        plural = True
        words = _strip_leading(words[1:])
    if len(words) > 1 and (words[0] in _COUNTS or words[0].isdigit()):
        n = _COUNTS.get(words[0]) or int(words[0])
        # "8 ball" names a ball; "8 balls" counts them.
        if words[-1] != singular(words[-1]) or (words[0] in _COUNTS and n == 1):
            count, words = n, words[1:]
    return words, count, plural


def _without_clause(words: list[str]) -> tuple[list[str], list[str]]:
    """Cuts a trailing clause ("bicycle stopped in the road"), but never everything."""
    cut = next((i for i, w in enumerate(words) if i > 0 and w in _PREPOSITIONS), len(words))
    return words[:cut], words[cut:]


def _without_identifier(words: list[str]) -> tuple[list[str], str | None]:
    """Takes "a" from "ball a", 2 from "car number two", 8 from "8 ball"."""
    if len(words) < 2:
        return words, None
    last = words[-1]
    if re.fullmatch(r"[a-z]|\d+", last) or last in _COUNTS:
        words = words[:-1]
        if len(words) > 1 and words[-1] in ("number", "no", "nr"):
            words = words[:-1]
        return words, str(_COUNTS.get(last, last))
    if re.fullmatch(r"\d+", words[0]):
        return words[1:], words[0]
    return words, None


def _without_ordinal(words: list[str]) -> tuple[int | None, list[str]]:
    """The place in a row that words before a head name, and their other words."""
    ordinal: int | None = None
    kept: list[str] = []
    for w in words:
        match = re.fullmatch(r"(\d+)(st|nd|rd|th)", w)
        if w in ORDINALS:
            ordinal = ORDINALS[w]
        elif match:
            ordinal = int(match[1])
        elif w not in _ARTICLES and w not in _QUANTIFIERS:
            kept.append(w)
    return ordinal, kept


def members_of(phrase: Phrase) -> Phrase | None:
    """What a collective behind a noun is made of: a "tire stack" of tires; None for other phrases.

    It names the set as "a stack of tires" does.
    """
    if phrase.head not in COMPOUNDS or not phrase.modifiers or phrase.identifier:
        return None
    what = phrase.modifiers[-1]
    if what in COLORS or what in POSITIONS or what in ORDINALS:
        return None
    stem = singular(what)
    head, implied = _split_head(stem)
    modifiers = (*phrase.modifiers[:-1], *implied)
    return replace(phrase, head=head, word=stem, modifiers=modifiers, plural=True, count=None)


def _place_words(tail: list[str]) -> list[str]:
    """Position words of a trailing clause that says nothing else: "the car in front"."""
    fillers = _ARTICLES | {"in", "on", "at", "to", "side", "hand"}
    found = [w for w in tail if w not in fillers]
    if found and all(canonical_modifier(w) in POSITIONS for w in found):
        return found
    return []


def _strip_leading(words: list[str]) -> list[str]:
    while len(words) > 1 and words[0] in _ARTICLES:
        words = words[1:]
    return words


def _split_head(word: str) -> tuple[str, tuple[str, ...]]:
    """Canonical head and the modifiers hidden in it: basketball -> ball, (basket)."""
    if word in _CANONICAL:
        implied = ("billiard",) if word == "billiard" else ()
        return _CANONICAL[word], implied
    if word.endswith("ball") and len(word) > 4:
        return "ball", (word[:-4],)
    if word.endswith("table") and word not in ("vegetable", "turntable") and len(word) > 5:
        return "table", (word[:-5],)
    return word, ()
