"""The nouns of WordNet 3.0, and the table of those that name no thing (licence beside it).

    python -m esg.lexicon.wordnet /usr/share/wordnet      (Debian: wordnet-base)

What a noun names is weighed over its senses, the commoner the more (their counts in the texts that
WordNet's authors tagged, and their order). Run it again after the rules here were edited.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
import re
import sys

from esg.lexicon.senses import TABLE, NounClass

_THING, _BODY, _SUBSTANCE, _PLACE = (5, 6, 13, 17, 18, 20), 8, 27, 15
"""Lexicographer files (lexnames(5WN)); what is in no other of these names no thing."""
_PLACES = (
    "room.1", "facility.1", "road.1", "passageway.1", "hallway.1", "stairway.1", "waterway.1",
    "geological_formation.1", "body_of_water.1", "tract.1", "building_complex.1", "atmosphere.3",
)  # fmt: skip
_SUBSTANCES = (
    "foodstuff.2", "beverage.1", "condiment.1", "sauce.1", "dough.1", "batter.2", "fuel.1", "gas.2",
    "liquid.1",
)  # fmt: skip
_SHAPED = ("coin.1", "paper_money.1", "bread.1", "solid.3", "disk.1")
"""Concepts below which all names a place, a substance or a thing, whatever it is filed with."""
_LEAST_SHARE = 0.25
"""From this weight of its senses that are things on, a noun may name one."""
_MARKS = (
    "abyss addition backdrop bulge by-product cleft clink composition crack crater creation crevice"
    " dent draft draught footing furrow gap grip groove harvest indentation interface invention"
    " lighting modification niche opening outlet overhang physic physics plume product"
    " protuberance puff rendering requirement rift rut scenery scraping seam segment soundtrack"
    " spray stretch stuff subject subsection texture total workings wrinkle"
)
"""Filed with artifacts and objects, but marks on things, results and words for pictures."""
_THINGS = (
    "adversary aerial animal atlas award bait beacon bearing beast belt birdcage biscuit body"
    " bone bonfire bracket cage campfire cargo catheter charm club coral cork couple cracker"
    " creature crowd diamond diary dime display document droplet drum duplicate eggs enemy estate"
    " family fawn feather fieldstone fig file fireplace flint floe food fragment furnace ghost"
    " guidepost hailstone hatch incinerator individual insert item journal kiln leaflet ledger"
    " letter level lid limb mail mechanism medal memorial menu milestone mite model mountain"
    " nickel object obstacle opener organ packet page party patch payload pennant pennies penny"
    " pick pickle placard plant plaything pounder press pretzel prize probe puppet quiver rattle"
    " ray relic rival rubble rule sampler sandbank scale seat shaft shard showcase shred sign"
    " silver skull somebody spotlight straw strut tag target team thing thorn ticket toast token"
    " tool triangle tug unit wafer wagon waterfall yardstick zip"
)
"""What prompts mean as things, whatever is commonest in texts."""
_WORD = re.compile(r"[a-z][a-z-]+")


@dataclass(frozen=True)
class Concept:
    """A synset: lexicographer file, words, concepts above it, instance of something, gloss."""

    file: int
    words: tuple[str, ...]
    above: tuple[str, ...]
    instance: bool
    gloss: str


@dataclass(frozen=True)
class WordNet:
    """The nouns of a WordNet database."""

    concepts: dict[str, Concept]
    senses: dict[str, tuple[str, ...]]

    counts: dict[tuple[str, int], int]
    """How often a sense (from 1) of a word was tagged."""

    def find(self, name: str) -> str:
        """Offset of "word.2", the second sense of a word."""
        word, _, sense = name.rpartition(".")
        return self.senses[word][int(sense) - 1]


def read_wordnet(folder: Path) -> WordNet:
    """Reads data.noun, index.noun and cntlist.rev (wndb(5WN), cntlist(5WN))."""
    concepts, senses, counts = {}, {}, {}
    for line in (folder / "data.noun").read_text(encoding="latin-1").splitlines():
        if line.startswith("  "):
            continue
        head, _, gloss = line.partition(" | ")
        f = head.split()
        count = int(f[3], 16)
        start = 4 + 2 * count
        pointers = [f[start + 1 + 4 * k : start + 5 + 4 * k] for k in range(int(f[start]))]
        concepts[f[0]] = Concept(
            file=int(f[1]),
            words=tuple(f[4:start:2]),
            above=tuple(p[1] for p in pointers if p[0] in ("@", "@i")),
            instance=any(p[0] == "@i" for p in pointers),
            gloss=gloss.strip(),
        )
    for line in (folder / "index.noun").read_text(encoding="latin-1").splitlines():
        if not line.startswith("  "):
            f = line.split()
            senses[f[0]] = tuple(f[-int(f[2]) :])
    for line in (folder / "cntlist.rev").read_text(encoding="latin-1").splitlines():
        key, sense, count = line.split()
        word, _, code = key.partition("%")
        if code.startswith("1:"):
            counts[word, int(sense)] = int(count)
    return WordNet(concepts, senses, counts)


def above(net: WordNet, start: str) -> set[str]:
    """A concept and all above it."""
    out, todo = set[str](), [start]
    while todo:
        offset = todo.pop()
        if offset not in out:
            out.add(offset)
            todo += net.concepts[offset].above
    return out


def _class_of(net: WordNet, offset: str, wider: dict[str, set[str]]) -> NounClass | None:
    """What a concept is; None for a thing."""
    file, all_above = net.concepts[offset].file, above(net, offset)
    if all_above & wider["shaped"]:
        return None
    if file == _PLACE or all_above & wider["places"]:
        return "place"
    if file == _SUBSTANCE or all_above & wider["substances"]:
        return "substance"
    if file == _BODY:
        return "body"
    return None if file in _THING else "nothing"


def classes(net: WordNet) -> dict[str, NounClass]:
    """The single words that as nouns name no thing, and what they name instead."""
    groups = {"places": _PLACES, "substances": _SUBSTANCES, "shaped": _SHAPED}
    wider = {name: {net.find(x) for x in words} for name, words in groups.items()}
    found: dict[str, NounClass] = {}
    for word, offsets in sorted(net.senses.items()):
        own = [(n, o) for n, o in enumerate(offsets, 1) if not net.concepts[o].instance]
        if not _WORD.fullmatch(word) or all(word not in net.concepts[o].words for _, o in own):
            continue  # names, and what is spelled with a capital
        weights: dict[NounClass | None, float] = {}
        for n, offset in own:
            kind = _class_of(net, offset, wider)
            weights[kind] = weights.get(kind, 0.0) + net.counts.get((word, n), 0) + 1.0 / n
        if weights.get(None, 0.0) < _LEAST_SHARE * sum(weights.values()):
            others: list[NounClass] = [k for k in weights if k is not None]
            found[word] = max(others, key=lambda k: weights[k])
    found.update(dict.fromkeys(_MARKS.split(), "nothing"))
    for word in _THINGS.split():
        found.pop(word, None)
    return found


def main() -> None:
    """Writes the table from the folder of a WordNet database."""
    lines: dict[tuple[str, str], list[str]] = {}
    for word, kind in classes(read_wordnet(Path(sys.argv[1]))).items():
        lines.setdefault((kind, word[0]), []).append(word)
    text = "".join(f"{kind}\t{';'.join(words)}\n" for (kind, _), words in sorted(lines.items()))
    TABLE.write_text(text, encoding="utf-8")
    print(f"wrote {TABLE}: {TABLE.stat().st_size} bytes")


if __name__ == "__main__":
    main()
