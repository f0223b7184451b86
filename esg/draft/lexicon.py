"""The lexicon: nouns with commonsense physics, verbs with senses, adjectives, function words.

Nouns are read from `esg.lexicon`, the other words from `data/`; docs/drafting.md names sources.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from esg.lexicon import Kind, kinds, morphology

DATA = Path(__file__).parent / "data"


@cache
def _word_sets() -> dict[str, frozenset[str]]:
    with open(DATA / "word_sets.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE))
    return {row["set"]: frozenset(row["words"].split("|")) for row in rows}


def word_set(name: str) -> frozenset[str]:
    """Words that a reading treats alike: a row of `data/word_sets.csv`.

    Raises:
        KeyError: If the table has no such row.
    """
    return _word_sets()[name]


def every_set() -> tuple[frozenset[str], ...]:
    """All word sets, in the order of their table."""
    return tuple(_word_sets().values())


@dataclass(frozen=True)
class Noun:
    """One kind of object.

    Args:
        name: Canonical singular noun ("trash bin").
        kind: Class of objects that move and behave alike ("vehicle", "ball", "container").
        dimensions_cm: Length along the front axis, width, height.
        mass_kg: Typical mass.
        material: Main material.
        shape: sphere, box, cylinder, capsule or compound.
        traits: wheeled, round, container, support, fixed, goal, decal, structural,
            topples, incline; rolls (round about some axis, from the library's flags).
        description: Phrase for retrieval.
        like: What a noun outside the lexicon is shaped and sized like ("disc of 6 cm").
        stand_in: What is drawn for a noun that is no such thing ("tire", for a pulley).
    """

    name: str
    kind: str
    dimensions_cm: tuple[float, float, float]
    mass_kg: float
    material: str
    shape: str
    traits: frozenset[str]
    description: str
    synonyms: tuple[str, ...] = ()
    like: str = ""
    stand_in: str = ""

    @property
    def category(self) -> str:
        return self.name.replace(" ", "_").replace("-", "_")


@dataclass(frozen=True)
class VerbForm:
    """One inflected form: base, s, past, pp or ing."""

    lemma: str
    sense: str
    form: str
    note: str = ""


@cache
def nouns() -> dict[str, Noun]:
    """Lexicon entries by every name and synonym (lower case, singular, single spaces)."""
    table: dict[str, Noun] = {}
    entries = [_noun(kind) for kind in kinds() if kind.kind]
    for noun in entries:
        table[noun.name] = noun
    for noun in entries:
        for synonym in noun.synonyms:
            table.setdefault(synonym, noun)
    for name in word_set("persons"):
        table.setdefault(name, table["person"])
    # Tokens part the possessive: "rubik 's cube".
    for name in [n for n in table if "'s " in n]:
        table.setdefault(name.replace("'s ", " 's "), table[name])
    return table


@cache
def part(name: str) -> Noun:
    """A part of a jointed thing, which no prompt is read with.

    Raises:
        KeyError: If no row of the table of kinds is a part of that name.
    """
    found = {kind.name: kind for kind in kinds() if "part" in kind.flags}[name]
    noun = _noun(found)
    fixed = frozenset({"fixed"}) if "fixed" in found.flags else frozenset[str]()
    return replace(noun, kind="structure", description=found.description, traits=fixed)


def _noun(kind: Kind) -> Noun:
    return Noun(
        name=kind.name,
        kind=kind.kind,
        dimensions_cm=kind.dimensions_cm,
        mass_kg=kind.mass_kg,
        material=kind.material,
        shape=kind.shape,
        traits=kind.traits | (frozenset({"rolls"}) if kind.rolls else frozenset[str]()),
        description=kind.request,
        synonyms=kind.said_as,
    )


@cache
def stand_ins() -> dict[str, str]:
    """Nouns of the lexicon that the library draws as something else, and as what."""
    with open(DATA / "stand_ins.csv", encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file, delimiter=";")
        return {noun: row["drawn"] for row in rows for noun in row["nouns"].split("|")}


@cache
def packed() -> dict[str, str]:
    """What stuff that hands take is packed in, by the stuff: nouns of the lexicon."""
    with open(DATA / "packed.csv", encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file, delimiter=";")
        return {stuff: row["packed"] for row in rows for stuff in row["stuff"].split("|")}


@cache
def longest_nouns() -> dict[str, int]:
    """Most words of an entry by its first word, where entries have several; at most all there are.

    Tokens may keep the hyphens of an entry or part it there, so either may end the first word.
    """
    limit = max(len(n.split()) for n in nouns())
    found: dict[str, int] = {}
    for name in nouns():
        cuts = [k for k, c in enumerate(name) if c in " -"]
        for left, k in enumerate(reversed(cuts), start=2):
            found[name[:k]] = max(found.get(name[:k], 0), min(left, limit))
    return found


def singular(word: str) -> tuple[str, bool]:
    """Singular of a noun and whether the word was a plural."""
    low = word.lower()
    one = morphology.singular(low)
    return one, one != low


@cache
def _wholes() -> dict[str, frozenset[str]]:
    found: dict[str, frozenset[str]] = {}
    with open(DATA / "wholes.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";"):
            for word in row["parts"].split("|"):
                found[word] = found.get(word, frozenset()) | {*row["wholes"].split("|")}
    return found


def is_part(head: str, whole: Noun | None = None) -> bool:
    """Whether a noun names a part of some thing, or of the thing that is given: `wholes.csv`.

    Args:
        head: Noun of a phrase ("seat").
        whole: What the part may belong to, by its kind or its name.
    """
    wholes = _wholes().get(singular(head)[0], _wholes().get(head, frozenset()))
    return bool(wholes) if whole is None else bool(wholes & {whole.kind, whole.name})


_VOWELS = "aeiou"
_DOUBLING = ("stop", "drop", "skid", "slip", "plod", "trip")


def _regular(lemma: str) -> dict[str, str]:
    if lemma.endswith("e"):
        past, ing = lemma + "d", lemma[:-1] + "ing"
    elif lemma.endswith("y") and lemma[-2] not in _VOWELS:
        past, ing = lemma[:-1] + "ied", lemma + "ing"
    elif lemma in _DOUBLING or (
        len(lemma) == 3 and lemma[1] in _VOWELS and lemma[2] not in _VOWELS + "wxy"
    ):
        past, ing = lemma + lemma[-1] + "ed", lemma + lemma[-1] + "ing"
    else:
        past, ing = lemma + "ed", lemma + "ing"
    if lemma.endswith("y") and lemma[-2] not in _VOWELS:
        third = lemma[:-1] + "ies"
    elif lemma.endswith(("s", "sh", "ch", "x", "z", "o")):
        third = lemma + "es"
    else:
        third = lemma + "s"
    return {"s": third, "past": past, "pp": past, "ing": ing}


@cache
def _verb_tables() -> tuple[dict[str, tuple[VerbForm, ...]], dict[str, tuple[VerbForm, ...]]]:
    """Readings by inflected form: of verbs, and of those that mean something only in a phrase."""
    verbs: dict[str, list[VerbForm]] = {}
    in_phrases: dict[str, list[VerbForm]] = {}
    with open(DATA / "verbs.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";"):
            lemma, sense, note = row["lemma"], row["sense"], row["notes"] or ""
            table = verbs
            if sense == "phrase":
                table, sense = in_phrases, "noop"
            forms = _regular(lemma)
            if row["forms"]:
                forms = dict(zip(("s", "past", "pp", "ing"), row["forms"].split(","), strict=True))
            table.setdefault(lemma, []).append(VerbForm(lemma, sense, "base", note))
            for form, words in forms.items():
                for word in words.split("|"):
                    table.setdefault(word, []).append(VerbForm(lemma, sense, form, note))
    return {w: tuple(v) for w, v in verbs.items()}, {w: (v[-1],) for w, v in in_phrases.items()}


def verb_forms() -> dict[str, tuple[VerbForm, ...]]:
    """Verb readings by inflected form."""
    return _verb_tables()[0]


def phrase_verb_forms() -> dict[str, tuple[VerbForm, ...]]:
    """Forms of verbs that mean something for the drafter only in a phrase ("gains speed")."""
    return _verb_tables()[1]


COLORS: dict[str, str] = {c: c for c in word_set("colors")} | {"grey": "gray", "golden": "gold"}

MATERIALS: dict[str, tuple[str, float]] = {
    "wooden": ("wood", 650.0), "wood": ("wood", 650.0), "oak": ("wood", 750.0),
    "pine": ("wood", 550.0), "bamboo": ("wood", 600.0),
    "metal": ("steel", 7800.0), "metallic": ("steel", 7800.0), "steel": ("steel", 7850.0),
    "iron": ("iron", 7200.0), "lead": ("lead", 11340.0), "copper": ("copper", 8960.0),
    "brass": ("brass", 8500.0), "aluminum": ("aluminium", 2700.0),
    "aluminium": ("aluminium", 2700.0), "stone": ("stone", 2600.0), "granite": ("stone", 2700.0),
    "marble": ("stone", 2700.0), "concrete": ("concrete", 2400.0), "brick": ("brick", 1900.0),
    "glass": ("glass", 2500.0), "plastic": ("plastic", 1000.0), "rubber": ("rubber", 1100.0),
    "foam": ("foam", 60.0), "styrofoam": ("foam", 30.0), "cardboard": ("cardboard", 200.0),
    "paper": ("paper", 300.0), "leather": ("leather", 900.0), "ceramic": ("ceramic", 2300.0),
    "porcelain": ("ceramic", 2400.0), "clay": ("ceramic", 1900.0), "fabric": ("cloth", 300.0),
    "cloth": ("cloth", 300.0), "wool": ("cloth", 200.0), "silver": ("silver", 10500.0),
    "gold": ("gold", 19300.0), "golden": ("gold", 19300.0), "ice": ("ice", 917.0),
    "wicker": ("wicker", 300.0), "carbon": ("carbon", 1600.0), "titanium": ("titanium", 4500.0),
    "inflatable": ("plastic", 20.0),
}  # fmt: skip
"""Adjective -> material name and density [kg/m^3] (engineering tables; docs/drafting.md)."""

SIZES: dict[str, float] = {
    "toy": 1.0, "model": 1.0, "miniature": 1.0, "tiny": 0.5, "mini": 0.5, "small": 0.75,
    "little": 0.75, "compact": 0.85,
    "large": 1.35, "big": 1.35, "huge": 1.8, "giant": 2.0, "enormous": 2.0, "gigantic": 2.2,
    "massive": 1.6, "oversized": 1.5, "medium": 1.0, "medium-sized": 1.0,
    "large-sized": 1.35, "small-sized": 0.75,
    **dict.fromkeys(("larger", "bigger", "largest", "biggest"), 1.35),
    **dict.fromkeys(("smaller", "smallest", "tiniest"), 0.75),
}  # fmt: skip
STRETCHES: dict[str, tuple[float, float, float]] = {
    "tall": (1.0, 1.0, 1.35), "high": (1.0, 1.0, 1.35), "short": (1.0, 1.0, 0.7),
    "low": (1.0, 1.0, 0.7), "long": (1.4, 1.0, 1.0), "wide": (1.0, 1.35, 1.0),
    "narrow": (1.0, 0.7, 1.0), "thin": (0.8, 0.8, 1.0), "thick": (1.2, 1.2, 1.0),
    "fat": (1.2, 1.2, 1.0), "slim": (0.8, 0.8, 1.0),
    **dict.fromkeys(("taller", "tallest"), (1.0, 1.0, 1.15)),
    **dict.fromkeys(("shorter", "shortest"), (1.0, 1.0, 0.85)),
    **dict.fromkeys(("longer", "longest"), (1.4, 1.0, 1.0)),
    **dict.fromkeys(("wider", "widest", "broader", "broadest"), (1.0, 1.35, 1.0)),
    **dict.fromkeys(("narrower", "narrowest"), (1.0, 0.7, 1.0)),
}  # fmt: skip
WEIGHTS: dict[str, float] = {
    "heavy": 2.0, "light": 0.5, "lightweight": 0.5, "massive": 3.0, "weighty": 2.0,
    **dict.fromkeys(("heavier", "heaviest"), 2.0), **dict.fromkeys(("lighter", "lightest"), 0.5),
    "empty": 0.6, "full": 2.0, "loaded": 2.0, "hollow": 0.4, "solid": 1.5, "filled": 2.0,
}  # fmt: skip
PLACE_ADJECTIVES = word_set("place adjectives")
PLAIN_ADJECTIVES = word_set("plain adjectives")
DETERMINERS = word_set("determiners")
POSSESSIVES = frozenset({"its", "his", "her", "their"})
PRONOUNS = word_set("pronouns")
PREPOSITIONS = word_set("prepositions")
BESIDE = frozenset({"left of", "right of", "in front of", "behind", "beside", "next to", "near"})
ONTO = ("on", "onto", "on top of", "upon", "atop")
MODALS = word_set("auxiliaries")
ADVERBS = word_set("adverbs")
SUBORDINATORS = word_set("subordinators")
PARTS = word_set("parts")
PARTS_OF = PARTS | word_set("parts before of")
GARMENTS = word_set("garments")
ATTRIBUTES = word_set("attributes") | word_set("cities") | word_set("countries")
"""Nouns that name no object: measures, events, media."""
RETOLD_NOUNS = word_set("retold nouns")
"""Nouns of events that a prompt has told before: "after that bump it falls"."""
SUBSTANCES = word_set("substances")
"""What a thing is made of or filled with: "a glass of water", "a ball of steel"."""
FIRST_NAMES = word_set("first names")
PERSON_ROLES = word_set("person roles")
GROUP_WORDS: dict[str, str | None] = {
    "set": None, "group": "scatter", "bunch": "scatter", "pile": "stack", "stack": "stack",
    "row": "row", "line": "row", "column": "column", "queue": "queue", "pair": None,
    "couple": None, "cluster": "scatter", "collection": "scatter", "number": "scatter",
    "series": "row", "rack": "rack", "pyramid": "stack", "tower": "stack", "heap": "stack",
    "lot": "scatter", "wall": "stack", "array": "row", "handful": "scatter", "chain": "row",
    "triangle": "pins",
    "formation": "pins", "convoy": "queue", "crowd": "scatter", "herd": "scatter",
    "flock": "scatter", "display": "stack", "mound": "stack", "mountain": "stack",
    "string": "queue", "fleet": "queue", "clutch": "scatter", "gaggle": "scatter",
    "procession": "queue",
    "team": "scatter", "circle": "scatter", "dozens": "scatter", "dozen": None,
    "half-dozen": None, "trio": None, "load": "scatter", "pack": "scatter",
    **dict.fromkeys(("swarm", "school", "shoal", "colony", "litter", "bouquet", "troupe", "batch",
                     "assortment", "throng", "brood", "family", "gang", "squad", "pride"),
                    "scatter"),
}  # fmt: skip
ARRANGEMENTS: dict[str, str] = {
    "triangle": "pins", "formation": "pins", "pyramid": "stack", "tower": "stack", "pile": "stack",
    "stack": "stack", "heap": "stack", "column": "column", "queue": "queue", "rack": "rack",
    "file": "queue", "line": "row", "row": "row", "circle": "ring", "ring": "ring",
    "semicircle": "ring", "arc": "ring", "cluster": "scatter", "group": "scatter",
    "bunch": "scatter", "convoy": "queue", "procession": "queue", "parade": "queue",
}  # fmt: skip
"""What "standing in a ..." says about a plural."""
SHAPES_OF_GROUPS = word_set("shapes of groups")
VAGUE_COUNTS: dict[str, int] = {
    "several": 4, "many": 6, "few": 3, "multiple": 4, "numerous": 6, "various": 4, "some": 3,
    "couple": 2, "duo": 2, "trio": 3, "both": 2, "pair": 2, "dozen": 12, "dozens": 12, "lots": 6,
    "handful": 4,
}  # fmt: skip

ORDINALS: dict[str, int] = {
    "first": 0, "1st": 0, "second": 1, "2nd": 1, "third": 2, "3rd": 2, "fourth": 3, "4th": 3,
    "fifth": 4, "5th": 4, "sixth": 5, "seventh": 6, "eighth": 7, "ninth": 8, "tenth": 9,
}  # fmt: skip
STACKED: dict[str, int] = {
    "top": -1, "topmost": -1, "uppermost": -1, "upper": -1, "highest": -1,
    "bottom": 0, "lowest": 0, "lowermost": 0, "lower": 0, "bottommost": 0,
    "middle": 1, "center": 1, "centre": 1, "central": 1,
}  # fmt: skip
"""Members of a stack by where they lie: first (at the bottom), last or in the middle."""
COUNTED_FROM = {"left": 1, "bottom": 1, "front": 1, "right": -1, "top": -1, "back": -1, "end": -1}
"""From which end "the second from the ..." counts; the members of a row go left to right."""
_COMPARISONS = {
    "mass": ("heavier heaviest", "lighter lightest"),
    "size": ("larger largest bigger biggest", "smaller smallest tiniest"),
    "height": ("taller tallest", "shorter shortest"),
    "length": ("longer longest", ""),
    "width": ("wider widest broader broadest", "narrower narrowest"),
    "speed": ("faster fastest quicker quickest speedier speediest", "slower slowest"),
}
RANKS: dict[str, tuple[str, float]] = {
    word: (quantity, sign)
    for quantity, both in _COMPARISONS.items()
    for sign, words in zip((1.0, -1.0), both, strict=True)
    for word in words.split()
}
"""Comparatives and superlatives: what they compare, and which end they mean."""
ALONE = RANKS.keys() | ORDINALS.keys() | word_set("ends of rows")
"""What stands for a thing without its noun: "the second", "the heavier", "the last"."""
BODY_PARTS = word_set("body parts")
OWN_PARTS = word_set("own parts")
