"""Words whose deletion changes nothing: what a draft lost without saying so.

    python -m benchmarks.ablate                          # opened public prompts and captions
    python -m benchmarks.ablate --corpus dev --most 60
    python -m benchmarks.ablate --names                  # words that only a name has, too
    python -m benchmarks.ablate --json FILE

Of every opened prompt one content word after the other is left out, and the rest drafted again. A
word was lost silently if the document stays the same (things with their sizes, masses, colours and
materials, regions, relations, joints, statements, timeline with its parameters, warnings) and
nothing in the draft owned up to it. Names, descriptions and places in the text are left out of the
comparison; a word that is found there alone is counted apart (a retrieval may still use it).
Held-out prompts are never read.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Iterator, Sequence
import csv
from dataclasses import asdict, dataclass
import json
from pathlib import Path
import re
import sys
from typing import Any

from benchmarks.drafting.corpus import HELD_OUT, PROMPTS, load
from esg.draft import draft
from esg.draft import lexicon as lex
from esg.graph.models import EsgDocument
from esg.outcomes import UserError

READ = {"read.tsv": "", "read2.tsv": "", "read3.tsv": "k", "read4.tsv": ""}
"""Files of captions, and how the ids of those begin that have been opened."""
CORPORA = ("public", "captions", "dev")
SMALL = (
    lex.DETERMINERS | lex.PREPOSITIONS | lex.PRONOUNS | lex.MODALS | lex.word_set("be")
    | frozenset({"and", "or", "but", "to", "not", "who", "which", "that", "then", "there"})
)  # fmt: skip
"""Words of grammar, which are not left out one by one."""
_NAMES = frozenset(
    {"asset_description", "description", "expanded_description", "id", "label",
     "original_description",
     "region_description", "scene_id", "semantic_description"}
)  # fmt: skip
_PLACES = frozenset({"start", "end", "text"})


@dataclass(frozen=True)
class Lost:
    """A word that a draft does not show.

    Args:
        word: As it stands in the prompt.
        prompt: With the word in brackets.
        name: Whether something in the scene is called by it.
    """

    word: str
    prompt: str
    name: bool = False


def opened(corpora: Iterable[str] = CORPORA) -> Iterator[str]:
    """The prompts of the opened halves, each once."""
    seen: set[str] = set()
    for corpus in corpora:
        if corpus in HELD_OUT:
            raise UserError(f"{corpus} is held out: its prompts are not read")
        found = _captions() if corpus == "captions" else (r["prompt"] for r in load(corpus))
        yield from (p for p in found if p not in seen and not seen.add(p))


def _captions() -> Iterator[str]:
    for name, start in READ.items():
        with (PROMPTS / name).open(encoding="utf-8", newline="") as file:
            rows = csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE)
            yield from (r["prompt"] for r in rows if r["id"].startswith(start))


def is_silent(doc: EsgDocument) -> bool:
    """Whether a draft owns up to nothing."""
    said = any(s.predicate.value == "not_represented" for s in doc.statements or ())
    return not said and not doc.coverage.warnings


def lost_words(prompt: str, *, silent_only: bool = True) -> list[Lost]:
    """The content words of a prompt that its draft lost, in their order.

    Args:
        silent_only: Whether a draft that owns up to something is left out; else words that it owns
            up to are.
    """
    doc = _draft(prompt)
    if doc is None or (silent_only and not is_silent(doc)):
        return []
    told = [
        (s.start, s.end) for s in doc.statements or () if s.predicate.value == "not_represented"
    ]
    told += [(i.start, i.end) for i in doc.coverage.items if i.status == "not_understood"]
    out: list[Lost] = []
    for m in re.finditer(r"[A-Za-z][A-Za-z'-]*", prompt):
        if m[0].lower() in SMALL or any(a < m.end() and m.start() < b for a, b in told):
            continue
        other = _draft(" ".join((prompt[: m.start()] + prompt[m.end() :]).split()))
        if other is None or shown(other) != shown(doc):
            continue
        marked = f"{prompt[: m.start()]}[{m[0]}]{prompt[m.end() :]}"
        out.append(Lost(m[0].lower(), marked, shown(other, names=True) != shown(doc, names=True)))
    return out


def _draft(prompt: str) -> EsgDocument | None:
    try:
        return draft(prompt)
    except UserError:
        return None


def shown(doc: EsgDocument, *, names: bool = False) -> str:
    """What a document shows, as text to compare; ids are numbered in their order.

    Args:
        names: Whether what things are called is part of it.
    """
    tree = doc.model_dump(mode="json", by_alias=True, exclude={"provenance", "coverage"})
    order = list(tree["spatial_relation_graph"]["nodes"]) + list(tree["asset_requirement"])
    order += list(tree["spatial_relation_graph"]["semantic_regions"])
    tree["scene_definition"].pop("scene_id")
    without = _PLACES | (_PLACES if names else _NAMES)
    text = json.dumps(_without(tree, without | {"original_description", "expanded_description"}))
    if not names:
        for k, name in sorted(enumerate(order), key=lambda at: -len(at[1])):
            text = text.replace(name, f"<{k}>")
    return text + "".join(sorted(re.sub(r'"[^"]*"', "", w) for w in doc.coverage.warnings))


def _without(tree: Any, keys: frozenset[str]) -> Any:
    if isinstance(tree, dict):
        return {k: _without(v, keys) for k, v in tree.items() if k not in keys}
    return [_without(v, keys) for v in tree] if isinstance(tree, list) else tree


def ranked(lost: Sequence[Lost]) -> list[dict[str, Any]]:
    """Words by the number of their prompts, with up to three of these."""
    found: dict[str, list[str]] = {}
    for one in lost:
        found.setdefault(one.word, []).append(one.prompt)
    rows = sorted(found.items(), key=lambda item: (-len(item[1]), item[0]))
    return [{"word": w, "prompts": len(p), "examples": p[:3]} for w, p in rows]


def main(argv: list[str] | None = None) -> int:
    """Prints the words; returns the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--corpus", nargs="+", choices=CORPORA, default=["public", "captions"])
    parser.add_argument("--all", action="store_true", help="drafts that own up to something, too")
    parser.add_argument("--names", action="store_true", help="words that are part of a name, too")
    parser.add_argument("--most", type=int, default=40, help="lines to print")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write every lost word here")
    args = parser.parse_args(argv)
    prompts = list(opened(args.corpus))
    found = [(p, lost_words(p, silent_only=not args.all)) for p in prompts]
    lost = [one for _, words in found for one in words if args.names or not one.name]
    named = sum(one.name for _, words in found for one in words)
    drafts = sum(any(not w.name for w in words) for _, words in found)
    print(
        f"{len(prompts)} prompts; {sum(not w.name for w in lost)} words lost silently in {drafts} "
        f"drafts, another {named} are in a name only"
    )
    for row in ranked(lost)[: args.most]:
        print(f"{row['prompts']:>5}  {row['word']:<16}{row['examples'][0]}")
    if args.json:
        args.json.write_text(json.dumps([asdict(one) for one in lost], indent=1) + "\n", "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
