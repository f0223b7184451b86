"""One clause in many forms: does the draft depend on voice and word order?

    python -m benchmarks.voices                  # every clause in every form
    python -m benchmarks.voices --every 10 --show

`data/prompts/clauses.tsv` holds clauses: who acts, a verb by its lemma, on what, and the rest
("off a table"). Each is drafted as an active sentence and in the forms below, which tell the same;
a form agrees if its facts are those of the active, or if both own up to something. No labels.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
import json
from pathlib import Path
import sys

from benchmarks.drafting import PROMPTS
from esg.draft import draft
from esg.draft import lexicon as lex
from esg.draft.audit.facts import facts_of
from esg.graph.models import Predicate
from esg.outcomes import UserError

CLAUSES = PROMPTS / "clauses.tsv"
ACTIVE = "{subject} {s} {object} {rest}"
FORMS = {
    "progressive": "{subject} is {ing} {object} {rest}",
    "participle": "{subject} {ing} {object} {rest}",
    "relative": "There is {subject} that {s} {object} {rest}",
    "passive": "{object} is {pp} {rest} by {subject}",
    "caption": "{object} {pp} {rest} by {subject}",
    "relative passive": "There is {object} that is {pp} {rest} by {subject}",
}
"""What tells the same as the active."""
OUTCOMES = ("agrees", "told otherwise", "silent", "owns up")
"""Of a form: as its active, other facts and neither owns up, silent where the active owns up, and
the other way round."""


@dataclass(frozen=True)
class Clause:
    """A clause by its words; `object` and `rest` may be empty."""

    subject: str
    verb: str
    object: str
    rest: str

    def told(self, form: str) -> str:
        """A sentence of the clause in a form."""
        words = {**vars(self), **_inflected(self.verb)}
        text = " ".join(form.format(**words).split())
        return text[0].upper() + text[1:] + "."


@dataclass(frozen=True)
class Reading:
    """What became of a sentence: its facts by kinds of things, and whether it owns up."""

    facts: tuple[tuple[str, ...], ...]
    owns_up: bool


@cache
def _by_lemma() -> dict[tuple[str, str], str]:
    words: dict[tuple[str, str], str] = {}
    for word, readings in lex.verb_forms().items():
        for r in readings:
            words.setdefault((r.lemma, r.form), word)
    return words


@cache
def _inflected(lemma: str) -> dict[str, str]:
    """The forms of a verb that the lexicon has; regular ones of others."""
    stem = lemma.removesuffix("e")
    regular = {"s": f"{lemma}s", "ing": f"{stem}ing", "pp": f"{stem}ed"}
    return {form: _by_lemma().get((lemma, form), word) for form, word in regular.items()}


def clauses() -> list[Clause]:
    """The table."""
    lines = CLAUSES.read_text(encoding="utf-8").splitlines()[1:]
    return [Clause(*line.split("\t")) for line in lines]


def read(text: str) -> Reading:
    """Drafts a sentence."""
    try:
        doc = draft(text)
    except UserError:
        return Reading((), owns_up=True)
    graph, said = doc.spatial_relation_graph, doc.statements or ()
    kinds = {n: doc.asset_requirement[x.asset_id].asset_category for n, x in graph.nodes.items()}
    facts = sorted(
        (f.kind, *sorted(kinds[n] for n in f.who), ">", *sorted(kinds[n] for n in f.whom), f.way)
        for f in facts_of(doc, doc.coverage, said).facts
    )
    lost = any(s.predicate is Predicate.NOT_REPRESENTED for s in said)
    lost = lost or any(i.status == "not_understood" for i in doc.coverage.items)
    return Reading(tuple(facts), lost)


def compared(form: Reading, active: Reading) -> str:
    """One of `OUTCOMES`."""
    if form.owns_up and active.owns_up:
        return "agrees"
    if form.owns_up != active.owns_up:
        return "owns up" if form.owns_up else "silent"
    return "agrees" if form.facts == active.facts else "told otherwise"


def run(every: int = 1) -> Iterator[tuple[str, str, str]]:
    """Each form of every N-th clause: its name, the sentence and the outcome."""
    for clause in clauses()[::every]:
        active = read(clause.told(ACTIVE))
        for name, form in FORMS.items():
            if clause.object or "{pp}" not in form:
                text = clause.told(form)
                yield name, text, compared(read(text), active)


def main(argv: list[str] | None = None) -> int:
    """Prints the table; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--every", type=int, default=1, metavar="N", help="every N-th clause only")
    parser.add_argument("--show", action="store_true", help="list what does not agree")
    parser.add_argument("--json", metavar="FILE", help="write the numbers here")
    args = parser.parse_args(argv)
    counts: dict[str, Counter[str]] = {name: Counter() for name in (*FORMS, "total")}
    shown: list[str] = []
    for name, text, outcome in run(max(1, args.every)):
        counts[name][outcome] += 1
        counts["total"][outcome] += 1
        if outcome != "agrees":
            shown.append(f"  {outcome:<15} {text}")
    print(f"{'form':<18}{'sentences':>10}" + "".join(f"{o:>16}" for o in OUTCOMES))
    for name, found in counts.items():
        print(f"{name:<18}{found.total():>10}" + "".join(f"{found[o]:>16}" for o in OUTCOMES))
    if args.show:
        print("\n".join(sorted(shown)))
    if args.json:
        data = {name: {o: found[o] for o in OUTCOMES} for name, found in counts.items()}
        Path(args.json).write_text(json.dumps(data, indent=2) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
