"""Drafts of a language model through request files, scored against the labelled corpora.

    python -m benchmarks.frontier DIR                     # asks: writes DIR/full/requests.jsonl
    python -m benchmarks.frontier DIR                     # with answers there: goes on, scores
    python -m benchmarks.frontier DIR --variants single_shot no_validation full --of 60
    python -m benchmarks.frontier DIR --layouts --json FILE
    python -m benchmarks.frontier DIR --handout 8       # the requests, for eight who answer by hand
    python -m benchmarks.frontier DIR --served --of 20  # of the server that ESG_LLM_… names
    python -m benchmarks.frontier DIR --answers FILE --tokens  # kept answers (benchmarks/answers)

200 prompts (`data/prompts/frontier.json`): 60 of `test`, 60 of `blind2`, 40 of each half of
`public`, those with the least hashes of their ids. Nothing is asked here: whoever has a model
answers the requests (docs/drafting_llm.md). The rules drafter's row is of the same prompts. Exit
code 3 while scenes wait.

*High-quality given usable* is the paper's "percentage of usable drafts admitting low-energy
layout"; it names no threshold. Here: the layout is feasible and leaves no relation that was asked
for unmet.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
import hashlib
import json
from pathlib import Path
import sys
from typing import Any, get_args

from benchmarks.answers import KeptAnswers, counter
from benchmarks.drafting.corpus import PROMPTS, load
from benchmarks.drafting.score import PAPER, Score, score_document
from benchmarks.drafting.whole import Outcome as Verdicts
from benchmarks.drafting.whole import Verdict, summary
from esg.draft import draft
from esg.draft.llm.drafter import draft_llm_batch
from esg.draft.llm.gathering import gather
from esg.draft.llm.records import LlmDraft, Variant
from esg.draft.llm.settings import load_settings
from esg.graph import verify
from esg.graph.models import EsgDocument
from esg.outcomes import Outcome, UserError

IDS = PROMPTS / "frontier.json"
WANTED = {"test": 60, "blind2": 60, "public": 40, "public_blind": 40}
SETS = {"test": ("test",), "blind2": ("blind2",), "public": ("public", "public_blind")}
"""The rows of the table, by the splits that they are made of."""
PAPER_HIGH = {"single_shot": 58.0, "no_validation": 79.7, "full": 89.5}
"""High-quality given usable [%] of the paper's ablation."""
ASSUMED = 0.5
"""Confidence up to which a heading is a default that nobody asked for."""


@dataclass(frozen=True)
class Made:
    """What a drafter made of a row of the corpus; `call` is None for the rules."""

    row: dict[str, Any]
    document: EsgDocument | None
    reason: str
    call: LlmDraft | None = None
    high: bool | None = None


def pick() -> dict[str, list[str]]:
    """Ids by split: those with the least hashes."""

    def rank(name: str) -> str:
        return hashlib.sha256(f"frontier/{name}".encode()).hexdigest()

    return {
        split: sorted(sorted((row["id"] for row in load(split)), key=rank)[:count])
        for split, count in WANTED.items()
    }


def rows_of(limit: int | None = None) -> list[dict[str, Any]]:
    """The picked rows of the corpora; with a limit, its share of each split, from the beginning."""
    picked: dict[str, list[str]] = json.loads(IDS.read_text(encoding="utf-8"))
    total = sum(len(ids) for ids in picked.values())
    out: list[dict[str, Any]] = []
    for split, ids in picked.items():
        share = len(ids) if limit is None else round(len(ids) * limit / total)
        by_id = {row["id"]: row for row in load(split)}
        out += [by_id[name] | {"split": split} for name in ids[:share]]
    return out


def of_rules(rows: Sequence[dict[str, Any]]) -> list[Made]:
    """The rules drafter on the same prompts."""
    out: list[Made] = []
    for row in rows:
        try:
            out.append(Made(row, draft(row["prompt"]), ""))
        except UserError as error:
            out.append(Made(row, None, f"refused: {error}"))
    return out


def of_model(rows: Sequence[dict[str, Any]], drafts: Sequence[LlmDraft]) -> list[Made]:
    """A model's drafts; one that breaks a rule is no draft, as in the pipeline."""
    out: list[Made] = []
    for row, made in zip(rows, drafts, strict=True):
        if made.waiting:
            continue
        good = made.outcome is Outcome.SOLVED
        out.append(Made(row, made.document if good else None, f"invalid: {made.reason}", made))
    return out


def is_high(doc: EsgDocument) -> bool:
    """Whether a draft admits a low-energy layout: feasible, and every relation asked for holds."""
    from esg.graph import canonical_json
    from esg.pipeline import SceneRequest, SceneState, run_stage
    from esg.stages import load_doc

    request = SceneRequest(
        doc.scene_definition.original_description, document=canonical_json(doc).decode()
    )
    state = SceneState(request)
    for stage in ("draft", "resolve", "cast", "layout"):
        state = run_stage(stage, state)
    if "layout" not in state.artifacts:
        return False
    found = load_doc(state, "layout")
    layout = found.layout_result
    assumed = {
        f"{e.from_} face {e.to}"
        for e in found.spatial_relation_graph.edges.binary_relations
        if e.relation_type.value == "face" and e.confidence <= ASSUMED
    }
    return bool(
        layout
        and layout.feasible
        and all(r.satisfied or r.edge in assumed for r in layout.relations)
    )


def table(made: Sequence[Made]) -> dict[str, dict[str, Any]]:
    """Figures by set and in total."""
    out: dict[str, dict[str, Any]] = {}
    for name, splits in {**SETS, "all": tuple(WANTED)}.items():
        part = [m for m in made if m.row["split"] in splits]
        if part:
            out[name] = _figures(part)
    return out


def _figures(made: Sequence[Made]) -> dict[str, Any]:
    score = Score()
    for m in made:
        score.add(score_document(m.row, m.document, m.reason))
    out: dict[str, Any] = score.row()
    if score.verdicts:
        whole = summary(score.verdicts)
        out |= {k: whole["classes"][k] for k in ("fully_right", "silent_wrong")}
        out |= {k: v for k, v in whole["classes"].items() if k not in out}
        out["statements"] = whole["statement_recall"]
        out["unsayable_named"] = whole["unsayable_named"]
        out["fully_right_but_owns_up"] = whole["fully_right_but_owns_up"]
        out["causes"] = causes(score.verdicts)
        out["sayable"] = _sayable(made)
    calls = [m.call for m in made if m.call is not None]
    if calls:
        n = len(calls)
        out |= {
            "replies": round(sum(len(c.calls) for c in calls) / n, 2),
            "rounds": round(sum(c.rounds for c in calls) / n, 2),
            "tokens_in": round(sum(c.input_tokens for c in calls) / n),
            "tokens_out": round(sum(c.output_tokens for c in calls) / n),
            "characters_in": round(sum(r.characters_in for c in calls for r in c.calls) / n),
            "characters_out": round(sum(len(r.text) for c in calls for r in c.calls) / n),
            "mended": mended(calls),
            "models": sorted({r.model for c in calls for r in c.calls if r.model}),
        }
        prices = [c.cost_usd for c in calls if c.cost_usd is not None]
        out["usd_per_scene"] = round(sum(prices) / n, 5) if len(prices) == n else None
    tried = [m.high for m in made if m.high is not None]
    if tried:
        out["high_quality_given_usable"] = round(100.0 * sum(tried) / len(tried), 1)
    return out


def mended(calls: Sequence[LlmDraft]) -> dict[str, dict[str, int]]:
    """By code: how often a model was told of it, and how often the next answer was without."""
    out: dict[str, dict[str, int]] = {}
    for call in calls:
        left = tuple({v.code for v in call.violations})
        following = (*call.told[1:], left)[: len(call.told)]
        for told, after in zip(call.told, following, strict=True):
            for code in told:
                row = out.setdefault(code, {"told": 0, "gone": 0})
                row["told"] += 1
                row["gone"] += code not in after
    return dict(sorted(out.items(), key=lambda item: -item[1]["told"]))


CAUSES = {
    "content no document can hold": ("unsayable",),
    "event missing": ("missing",),
    "statement not held": ("statement",),
    "event invented": ("invented",),
    "no thing, but drawn": ("absent",),
    "objects missing, twice, never asked for": ("object", "twice", "spurious"),
    "no usable draft": ("unusable",),
    "quantity lost": ("quantity",),
}
"""Kinds of faults by what keeps a draft from being fully right."""


def causes(verdicts: Sequence[Verdict]) -> dict[str, dict[str, int]]:
    """By cause: drafts with it, of them those with nothing else, and those that are silent."""
    out = {name: {"drafts": 0, "alone": 0, "silent": 0} for name in (*CAUSES, "any")}
    for v in verdicts:
        kinds = {f.kind for f in v.faults}
        found = [name for name, of in CAUSES.items() if kinds & {*of}]
        for name in (*found, *(["any"] if found else [])):
            out[name]["drafts"] += 1
            out[name]["alone"] += len(found) == 1
            out[name]["silent"] += v.outcome is Verdicts.SILENT
    return {name: row for name, row in out.items() if row["drafts"]}


def _sayable(made: Sequence[Made]) -> float:
    """Share of the prompts of which a document can hold everything: no more can be fully right."""
    whole = [m for m in made if "unsayable" in m.row]
    return round(100.0 * sum(not m.row["unsayable"] for m in whole) / max(1, len(whole)), 1)


def judged(made: Sequence[Made]) -> list[Made]:
    """The same with a layout of every usable draft."""
    from dataclasses import replace

    return [
        replace(m, high=is_high(m.document))
        if m.document is not None and not verify(m.document)
        else m
        for m in made
    ]


def main(argv: list[str] | None = None) -> int:
    """Writes requests or scores answers; returns the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("folder", type=Path, help="a folder of request files a variant lies below")
    parser.add_argument("--variants", nargs="+", choices=get_args(Variant), default=["full"])
    parser.add_argument("--of", type=int, metavar="N", help="only N of the prompts, evenly")
    parser.add_argument("--served", action="store_true", help="ask the configured server instead")
    parser.add_argument("--answers", type=Path, metavar="FILE", help="score kept answers instead")
    parser.add_argument("--tokens", action="store_true", help="count tokens of kept answers")
    parser.add_argument("--partial", action="store_true", help="score what is drafted by now")
    parser.add_argument("--layouts", action="store_true", help="high-quality given usable, too")
    parser.add_argument("--show", action="store_true", help="list misses of the opened prompts")
    parser.add_argument("--handout", type=int, metavar="N", help="requests as N texts for people")
    parser.add_argument("--json", metavar="FILE", help="write the figures here")
    args = parser.parse_args(argv)
    every, rows = rows_of(), rows_of(args.of)
    config = load_settings()
    found: dict[str, list[Made]] = {}
    waiting = 0
    for variant in args.variants:
        # The folder of `full` is of all prompts: fewer would drop the others' requests from it.
        asked = every if variant == "full" else rows
        if args.served or args.answers:
            kept = _kept(args)
            prompts = [r["prompt"] for r in rows]
            drafts = draft_llm_batch(prompts, settings=config, variant=variant, client=kept)
            found[variant] = of_model(rows, drafts)
            if kept is not None:
                print(f"{variant}: {kept.text()}")
            continue
        got = gather(
            [row["prompt"] for row in asked],
            args.folder / variant,
            settings=config,
            variant=variant,
        )
        print(f"{variant}: {got.text() or 'nothing waits'}")
        waiting += got.waiting
        if args.handout and got.requests:
            for path in handout(args.folder / variant, args.handout):
                print(f"  {path}")
        wanted = {row["id"] for row in rows}
        found[variant] = [m for m in of_model(asked, got.drafts) if m.row["id"] in wanted]
    if waiting and not args.partial:
        return 3
    found = {"rules": of_rules(rows), **found}
    if args.layouts:
        found = {name: judged(made) for name, made in found.items()}
    tables = {name: table(made) for name, made in found.items()}
    _print(tables)
    if args.show:
        _show(found)
    if args.json:
        text = json.dumps({"prompts": len(rows), "drafters": tables}, indent=2) + "\n"
        Path(args.json).write_text(text, encoding="utf-8")
    return 3 if waiting else 0


def _kept(args: argparse.Namespace) -> KeptAnswers | None:
    """The kept answers that are to be scored; None asks the configured server."""
    if args.answers is None:
        return None
    return KeptAnswers(args.answers, counter() if args.tokens else None)


HOW = """Answer every request below. Write one JSON Lines file, one line a request:
{"custom_id": "<as given>", "response": {"status_code": 200, "body": {"model": \
"<your model name>", "choices": [{"finish_reason": "stop", "message": {"content": \
<the JSON object, as an object>}}]}}}
Each request stands for itself: answer from its own text only."""


def handout(folder: Path, parts: int) -> list[Path]:
    """Writes the open requests of a folder as texts in which what they share stands once.

    Args:
        folder: Of request files.
        parts: Number of texts, each with about as many requests.

    Returns:
        Files written below `folder/handout`.
    """
    from esg.draft.llm.requestfiles import REQUESTS
    from esg.draft.llm.schema import schema_of

    lines = (folder / REQUESTS).read_text(encoding="utf-8").splitlines()
    place = folder / "handout"
    place.mkdir(exist_ok=True)
    for old in place.glob("part-*.md"):
        old.unlink()
    out: list[Path] = []
    for k in range(parts):
        told: list[str] = [HOW]
        stage = ""
        for line in lines[k::parts]:
            request = json.loads(line)
            messages = request["body"]["messages"]
            if (new := request["custom_id"].partition("-")[0]) != stage:
                stage = new
                schema = json.dumps(schema_of(stage), separators=(",", ":"))
                told += [f"# Instructions for {stage}", messages[0]["content"]]
                told += [f"JSON Schema of the answer:\n{schema}", f"# Requests for {stage}"]
            told.append(f"## {request['custom_id']}")
            roles = {"user": "", "assistant": "Your answer before:\n"}
            told += [roles[m["role"]] + m["content"] for m in messages[1:]]
        if len(told) > 1:
            path = place / f"part-{k + 1:02d}.md"
            path.write_text("\n\n".join(told) + "\n", encoding="utf-8")
            out.append(path)
    return out


def _print(tables: dict[str, dict[str, dict[str, Any]]]) -> None:
    columns = (
        "prompts", "usability", "event_recall", "quantity_recall", "invented_events",
        "fully_right", "silent_wrong", "statements", "high_quality_given_usable", "rounds",
        "replies", "tokens_in", "tokens_out", "characters_in", "characters_out", "usd_per_scene",
    )  # fmt: skip
    print(f"\n{'drafter':<15}{'set':<8}" + "".join(f"{c[:14]:>15}" for c in columns))
    for name, sets in tables.items():
        for part, row in sets.items():
            cells = "".join(f"{row[c] if row.get(c) is not None else '-':>15}" for c in columns)
            print(f"{name:<15}{part:<8}{cells}")
    for name, sets in tables.items():
        for code, row in sets["all"].get("mended", {}).items():
            print(f"{name}: {code} told {row['told']} times, gone with the answer {row['gone']}")
    for name, sets in tables.items():
        for cause, row in sets["all"].get("causes", {}).items():
            told = f"{row['drafts']} drafts, {row['alone']} alone, {row['silent']} silent"
            print(f"{name}: {cause}: {told}")
    for name in tables:
        if name in PAPER:
            print(f"paper, {name}: usability {PAPER[name]}, high-quality {PAPER_HIGH[name]}")


def _show(found: dict[str, list[Made]]) -> None:
    """Misses of the half that is opened for development; the others are held out."""
    for name, made in found.items():
        for m in made:
            if m.row["split"] == "public":
                for line in score_document(m.row, m.document, m.reason).problems:
                    print(f"{name}: {line}")


if __name__ == "__main__":
    sys.exit(main())
