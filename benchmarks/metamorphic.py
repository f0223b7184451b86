"""One story told in many ways: which wordings of the same events change the draft.

    python -m benchmarks.metamorphic                     # every wording of every story
    python -m benchmarks.metamorphic --every 5 --worst 40
    python -m benchmarks.metamorphic --kinds hit speed --show

`data/prompts/rewordings.tsv` holds wordings with places for things ({a} ... {d}) and verbs ({x.s},
{y.ing}): of two events, the second of what was hit (patient), of what hit it (agent)
or of something else (other), of one hit, and of one hit with a stated speed, time or mass. Each is
filled with the stories below and drafted; a wording changes nothing: every other event is a fault.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
import json
from pathlib import Path
import re
import sys
import time
from typing import Any

from benchmarks.drafting import PROMPTS, Score, score_row
from esg.draft import draft

WORDINGS = PROMPTS / "rewordings.tsv"
KINDS = ("patient", "agent", "other", "hit", "speed", "time", "mass")


@dataclass(frozen=True)
class VerbForms:
    """Forms of a verb with its particle or preposition."""

    base: str
    s: str
    past: str
    pp: str
    ing: str


_FORMS = {
    "hit": "hits hit hit hitting", "strike": "strikes struck struck striking",
    "crash into": "crashes crashed crashed crashing", "bump into": "bumps bumped bumped bumping",
    "smash into": "smashes smashed smashed smashing", "ram": "rams rammed rammed ramming",
    "fall off": "falls fell fallen falling", "roll off": "rolls rolled rolled rolling",
    "slide off": "slides slid slid sliding", "tip over": "tips tipped tipped tipping",
    "topple": "topples toppled toppled toppling", "stop": "stops stopped stopped stopping",
    "come to rest": "comes came come coming", "turn left": "turns turned turned turning",
    "swerve right": "swerves swerved swerved swerving", "fall over": "falls fell fallen falling",
    "roll into": "rolls rolled rolled rolling", "fall into": "falls fell fallen falling",
    "land on": "lands landed landed landing",
}  # fmt: skip


def verb(lemma: str) -> VerbForms:
    """The forms of a verb of the stories ("fall off")."""
    word, _, rest = lemma.partition(" ")
    rest = f" {rest}" if rest else ""
    s, past, pp, ing = (w + rest for w in _FORMS[lemma].split())
    return VerbForms(word + rest, s, past, pp, ing)


_TWO = {
    "patient": (
        "ball hit vase;fall off shelf", "cat bump into mug;roll off table",
        "robot ram crate;slide off ramp", "puck strike bottle;fall off table",
        "forklift crash into barrel;fall off platform", "car crash into scooter;tip over",
        "ball hit domino;topple", "dog bump into flowerpot;tip over",
    ),
    "agent": (
        "car crash into fence;stop", "marble hit block;come to rest",
        "apple fall off table;hit stool", "orange roll off counter;strike bowl",
        "car turn left;crash into hydrant", "cyclist swerve right;hit bollard",
        "bookcase fall over;smash into chair", "stone fall off wall;fall into barrel",
    ),
    "other": (
        "red car hit cone;blue car crash into barrier", "bear bump into tent;wolf strike bucket",
        "goat ram barn door;milk churn tip over",
    ),
}  # fmt: skip
"""Two events: mover, verb, thing; the mover of the second only where it is new."""
_ONE = (
    ("car", "fence"), ("ball", "box"), ("truck", "lamp post"), ("puck", "bottle"),
    ("robot", "shelf"), ("cyclist", "bollard"), ("dog", "bucket"), ("shopping cart", "pillar"),
)  # fmt: skip
_STATED = {
    "speed": {"quantity": "speed", "object": "a", "value": 3.0, "unit": "m/s"},
    "time": {"quantity": "time", "event": "collision", "value": 2.0, "unit": "s"},
    "mass": {"quantity": "mass", "object": "a", "value": 5.0, "unit": "kg"},
}


def _clause(text: str) -> tuple[str, str, str]:
    """Mover, verb and thing of "ball hit vase"; "" for what it lacks."""
    for lemma in sorted(_FORMS, key=len, reverse=True):
        m = re.fullmatch(rf"(?:(.+?) )?{lemma}(?: (.+))?", text)
        if m:
            return m[1] or "", lemma, m[2] or ""
    raise ValueError(f"no verb of the stories in {text!r}")


def _event(mover: str, lemma: str, thing: str) -> dict[str, Any]:
    if lemma in ("tip over", "topple", "fall over"):
        return {"type": "topples", "object": mover}
    if lemma in ("stop", "come to rest"):
        return {"type": "stops", "object": mover}
    if lemma.endswith((" left", " right")):
        return {"type": "turns", "object": mover, "direction": lemma.split()[-1]}
    if lemma.endswith(" off"):
        return {"type": "falls", "object": mover}
    if lemma == "fall into":
        return {"type": "enters", "object": mover, "target": thing}
    return {"type": "collision", "a": mover, "b": thing}


def rows(kinds: tuple[str, ...] = KINDS) -> Iterator[tuple[str, dict[str, Any]]]:
    """Every wording of every story: the wording, and a row as those of the corpus."""
    for line in WORDINGS.read_text(encoding="utf-8").splitlines()[1:]:
        kind, wording = line.split("\t")
        if kind not in kinds:
            continue
        for k, values in enumerate(_stories(kind)):
            events, slots = values
            named = [{**_STATED[kind]}] if kind in _STATED else []
            for c in named:
                c.update({"object": slots["a"]} if "object" in c else {})
            row = {"id": f"{kind}-{k}", "band": kind, "events": events, "constraints": named}
            yield wording, {**row, "objects": [], "prompt": _fill(wording, slots)}


def _stories(kind: str) -> Iterator[tuple[list[dict[str, Any]], dict[str, Any]]]:
    if kind not in _TWO:
        for a, b in _ONE:
            yield [_event(a, "hit", b)], {"a": a, "b": b}
        return
    for story in _TWO[kind]:
        first, second = (_clause(c) for c in story.split(";"))
        mover = second[0] or (first[2] if kind == "patient" else first[0])
        slots = {"a": first[0], "b": first[2], "x": verb(first[1]), "y": verb(second[1])}
        slots |= {"c": mover, "d": second[2]} if kind == "other" else {"c": second[2]}
        yield [_event(*first), _event(mover, *second[1:])], slots


def _fill(wording: str, slots: dict[str, Any]) -> str:
    """The wording with the story's words; what an intransitive verb lacks is left out."""
    for name, value in slots.items():
        if value == "":
            wording = re.sub(rf" (?:a|the) \{{{name}\}}", "", wording)
    text = wording.replace("\\n", "\n").format(**slots)
    text = re.sub(r"\b([Aa]) (?=[aeiou])", r"\1n ", text)
    return re.sub(r"(?:^|(?<=[.!?]\s))[a-z]", lambda m: m[0].upper(), text)


def run(kinds: tuple[str, ...], every: int) -> tuple[dict[str, Score], dict[str, Score], float]:
    """Scores by kind and by wording, and the mean CPU time of draft and score [s]."""
    by_kind = {k: Score() for k in kinds} | {"total": Score()}
    by_wording: dict[str, Score] = {}
    began, count = time.process_time(), 0
    for n, (wording, row) in enumerate(rows(kinds)):
        if n % every:
            continue
        one = score_row(row, draft)
        count += 1
        for score in (by_kind[row["band"]], by_kind["total"]):
            score.add(one)
        by_wording.setdefault(f"{row['band']}: {wording}", Score()).add(one)
    return by_kind, by_wording, (time.process_time() - began) / max(1, count)


def _changed(score: Score) -> float:
    """Share of events lost or invented and of quantities lost [%]."""
    wrong = score.events - score.events_found + score.invented
    wrong += score.quantities - score.quantities_found
    return 100.0 * wrong / max(1, score.events + score.quantities)


def main(argv: list[str] | None = None) -> int:
    """Prints the tables; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=KINDS)
    parser.add_argument("--every", type=int, default=1, metavar="N", help="every N-th prompt only")
    parser.add_argument("--worst", type=int, default=20, metavar="N", help="wordings to list")
    parser.add_argument("--show", action="store_true", help="list every miss")
    parser.add_argument("--json", metavar="FILE", help="write the numbers here")
    args = parser.parse_args(argv)
    draft("A ball hits a box.")
    by_kind, by_wording, seconds = run(tuple(args.kinds), max(1, args.every))
    print(
        f"{'kind':<10}{'prompts':>9}{'usable':>8}{'lost':>8}{'quantities lost':>17}{'invented':>10}"
    )
    for kind, score in by_kind.items():
        row = score.row()
        print(
            f"{kind:<10}{score.prompts:>9}{row['usability']:>8}{100 - row['event_recall']:>8.1f}"
            f"{100 - row['quantity_recall']:>17.1f}{row['invented_events']:>10}"
        )
    print(f"\n{1000.0 * seconds:.1f} ms CPU a prompt (draft, verify, score)")
    worst = sorted(by_wording, key=lambda w: (-_changed(by_wording[w]), w))
    changed = [w for w in worst if by_wording[w].problems]
    print(f"{len(changed)} of {len(worst)} wordings change something; the worst:")
    for wording in changed[: args.worst]:
        score = by_wording[wording]
        lost = score.events - score.events_found
        print(f"  {lost:>3} lost {score.invented:>3} invented of {score.events:>3}  {wording}")
    if args.show:
        for line in by_kind["total"].problems:
            print("  " + line)
    if args.json:
        data = {k: s.row() for k, s in by_kind.items()}
        Path(args.json).write_text(json.dumps(data, indent=2) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
