"""Makes the table of nouns outside the library from WordNet 3.0 (licence: esg/lexicon/).

    python -m esg.assets.library.wordnet /usr/share/wordnet      (Debian: wordnet-base)

`data/anchors.csv` says which kind of the library stands for a WordNet concept and what is usual
below it; names and synonyms of the library anchor their own concepts. Every other noun for a
physical thing goes to the first anchor above it: samovar -> urn -> vase. Run it again after the
catalogue or the anchors were edited.
"""

from __future__ import annotations

import csv
from importlib.resources import files
from pathlib import Path
import re
import sys

from esg.assets.library.catalogue import Entry, entries_by_name, lexicon, normalize
from esg.lexicon.hypernyms import TABLE
from esg.lexicon.wordnet import WordNet, above, read_wordnet

_ANIMAL, _ARTIFACT, _BODY, _FOOD, _OBJECT, _PERSON, _PLANT = 5, 6, 8, 13, 17, 18, 20
_PHYSICAL = (_ANIMAL, _ARTIFACT, _FOOD, _OBJECT, _PERSON, _PLANT)
_CLASSES = {"animal": _ANIMAL, "person": _PERSON, "plant": _PLANT, "food": _FOOD}
_PEOPLE = [
    "worker.1",
    "entertainer.1",
    "athlete.1",
    "scientist.1",
    "musician.1",
    "artist.1",
    "clergyman.1",
    "aristocrat.1",
    "traveler.1",
    "performer.1",
    "military_officer.1",
    "scholar.1",
    "relative.1",
    "serviceman.1",
    "dancer.1",
    "expert.1",
    "ruler.1",
    "magician.1",
    "acrobat.1",
]
"""People are nouns by the thousand; these are roles that a scene may cast."""
_RUDE = re.compile(
    r"offensive|slur|disparag|derogat|vulgar|obscen|prostitut|sexual|contempt|homosexual|racist"
)
_FLESH = re.compile(
    r"^\(?(lean |cooked |edible |fatty )*(flesh|meat|tentacles|roe) of|prepared as food"
)
"""Animals as food come back as the animals themselves."""
_DOER = re.compile(r"(?:er|or)$")
_OF_ANYTHING = frozenset({"piece"})
"""Nouns of no shape of their own: a piece of styrofoam is no gun, another of its senses."""
_USUAL = 0.5
"""Share of the weight of a noun's senses that are things from which on a sense is the usual one."""
_WORDS = re.compile(r"[a-z][a-z' -]*")


def _files(kind: Entry) -> tuple[int, ...]:
    for name, file in _CLASSES.items():
        if kind.name == name or name in kind.parents:
            return (file,)
    return (_ARTIFACT, _OBJECT)


def own_anchors(net: WordNet) -> dict[str, tuple[str, str, str]]:
    """Concepts that the library's own names and synonyms mean, with their kind."""
    found: dict[str, list[tuple[bool, str]]] = {}
    for term, name in lexicon().items():
        kind = entries_by_name()[name]
        for offset in net.senses.get(term.replace(" ", "_"), ()):
            if net.concepts[offset].file in _files(kind) and not net.concepts[offset].instance:
                found.setdefault(offset, []).append((normalize(name) != term, name))
                break
    return {offset: (min(kinds)[1], "", "") for offset, kinds in found.items()}


def stated_anchors(net: WordNet) -> dict[str, tuple[str, str, str]]:
    """The anchors of `data/anchors.csv`: kind, longest extent [cm] and mass [kg] by offset."""
    text = files("esg.assets.data").joinpath("anchors.csv").read_text(encoding="utf-8")
    return {
        net.find(row["anchor"]): (row["kind"], row["longest_cm"], row["mass_kg"])
        for row in csv.DictReader(text.splitlines())
    }


def proper(net: WordNet) -> dict[str, set[str]]:
    """The concepts that a kind's own names mean: what is below one of them is such a thing."""
    found: dict[str, set[str]] = {}
    for term, name in lexicon().items():
        kind = entries_by_name()[name]
        for offset in net.senses.get(term.replace(" ", "_"), ()):
            if net.concepts[offset].file in _files(kind) and not net.concepts[offset].instance:
                found.setdefault(name, set()).add(offset)
                break
    return found


def is_one(net: WordNet, word: str, used: str, kind: set[str]) -> bool:
    """Whether a noun is such a thing in the sense in which it is used, and that is the usual one.

    Persons named by what they do lose to things that do it ("checker", "mover").

    Args:
        net: The database.
        word: The noun.
        used: Offset of the sense.
        kind: Offsets of the concepts that the kind's own names mean.
    """
    if not above(net, used) & kind:
        return False
    senses = net.senses[word]
    files = [net.concepts[o].file for o in senses]
    if net.concepts[used].file == _PERSON and _DOER.search(word) and _ARTIFACT in files:
        return False
    weights = [net.counts.get((word, n), 0) + 1.0 / n for n in range(1, len(senses) + 1)]
    plant = net.concepts[used].file == _PLANT  # "poplar" is its wood, too
    such = sum(
        w
        for w, o, f in zip(weights, senses, files, strict=True)
        if above(net, o) & kind or (plant and f == _PLANT)
    )
    things = (w for w, f in zip(weights, files, strict=True) if f in (*_PHYSICAL, _BODY))
    return such >= _USUAL * sum(things)


def climb(net: WordNet, start: str, anchors: dict[str, tuple[str, str, str]]) -> str | None:
    """Offset of the nearest anchor above a concept, breadth first."""
    level, seen = [start], set()
    while level:
        for offset in level:
            if offset in anchors:
                return offset if anchors[offset][0] else None
        seen |= set(level)
        level = [a for o in level for a in net.concepts[o].above if a not in seen]
    return None


def _usable(net: WordNet, word: str, offset: str, people: set[str]) -> bool:
    concept = net.concepts[offset]
    if concept.file not in _PHYSICAL or concept.instance or _RUDE.search(concept.gloss):
        return False
    if concept.file == _FOOD and _FLESH.search(concept.gloss):
        return False
    spelled = next(w for w in concept.words if w.lower() == word)
    if spelled != word and concept.file not in (_ARTIFACT, _FOOD):
        return False  # Latin names of species, names of people and places
    return concept.file != _PERSON or bool(above(net, offset) & people)


def table(net: WordNet) -> str:
    """The shipped table, one line an anchor.

    Kind, longest [cm], mass [kg], its word, nouns of such things, nouns that it only stands for.
    """
    stated, kinds = stated_anchors(net), proper(net)
    anchors = own_anchors(net) | stated
    people = {net.find(p) for p in _PEOPLE}
    known = lexicon()
    groups: dict[str, tuple[list[str], list[str]]] = {}
    for word, offsets in sorted(net.senses.items()):
        text = word.replace("_", " ")
        if not _WORDS.fullmatch(text) or len(text.split()) > 3:
            continue
        single = normalize(text)
        if single in _OF_ANYTHING:
            continue
        if single != text and single.replace(" ", "_") in net.senses:
            continue  # "glasses" must not speak for a glass
        usable = [o for o in offsets if stated.get(o, ("",))[0] or _usable(net, word, o, people)]
        # A concept of its own in the list of anchors is what its word means; else the commonest
        # sense, but fruit before the tree that bears it.
        usable.sort(
            key=lambda o: (
                o not in stated,
                o in stated and net.concepts[o].words[0].lower() != word,
                net.concepts[o].file == _PLANT,
            )
        )
        ways = ((o, climb(net, o, anchors)) for o in usable)
        used, reached = next(((o, a) for o, a in ways if a is not None), ("", None))
        if single in known and reached not in {o for o in usable if o in stated}:
            continue  # the library knows better, unless the noun's own size is stated
        if reached is not None:
            such = is_one(net, word, used, kinds.get(anchors[reached][0], set()))
            groups.setdefault(reached, ([], []))[not such].append(single)
    lines = [
        "\t".join(
            (
                *anchors[a],
                net.concepts[a].words[0].lower().replace("_", " "),
                *(";".join(words) for words in nouns),
            )
        )
        for a, nouns in groups.items()
    ]
    return "\n".join(sorted(lines)) + "\n"


def main() -> None:
    """Writes `esg/lexicon/hypernyms.txt` from the folder of a WordNet database."""
    net = read_wordnet(Path(sys.argv[1]))
    TABLE.write_text(table(net), encoding="utf-8")
    print(f"wrote {TABLE}: {TABLE.stat().st_size} bytes")


if __name__ == "__main__":
    main()
