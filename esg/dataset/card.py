"""The dataset card: what is inside, how it was drawn, how scenes ended and why some failed.

Everything here follows from the tables, so the card of a dataset is always the same.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
import re
from typing import Any

from esg.dataset.grammar import Distribution
from esg.dataset.plan import DatasetSpec
from esg.fidelity import most_unseen, shortfalls
from esg.outcomes import Outcome
from esg.store.assembling import Counts, card_header, card_tables

_SCENE_COLUMNS = [
    "scene_key", "prompt", "family", "level", "rule", "pair", "changed", "outcome", "verified",
    "slr", "n_events", "n_completed", "ppa", "proof", "fully_understood",
    "plausible",
]  # fmt: skip
_MAX_FAILURES = 20


def statistics(out: Path, spec: DatasetSpec, failed: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Numbers of a dataset whose split files are written.

    Args:
        out: Folder of the dataset.
        spec: Its specification.
        failed: Rows of `failures.jsonl`.
    """
    scenes = list(_rows(out, "scenes", _SCENE_COLUMNS))
    events = Counter(r["event_type"] for r in _rows(out, "metrics", ["event_type"]))
    done = Counter(
        r["event_type"]
        for r in _rows(out, "metrics", ["event_type", "completed"])
        if r["completed"]
    )
    stated: dict[str, list[float]] = {}
    for row in _rows(out, "constraints", ["quantity", "target_low", "score"]):
        stated.setdefault(row["quantity"], []).append(row["score"])
    return {
        "scenes": len(scenes),
        "verified": sum(bool(s["verified"]) for s in scenes),
        "distinct_prompts": len({s["prompt"] for s in scenes}),
        "families": len({s["family"] for s in scenes}),
        "outcomes": _counted(s["outcome"] for s in scenes),
        "partial": sum(s["outcome"] == Outcome.PARTIAL.value for s in scenes),
        "fully_understood": sum(bool(s["fully_understood"]) for s in scenes),
        "plausible": sum(s["plausible"] is True for s in scenes),
        "replayed": sum(s["plausible"] is not None for s in scenes),
        "implausible": _counted(
            r["check_name"]
            for r in _rows(out, "plausibility_checks", ["check_name", "ok"])
            if not r["ok"]
        ),
        "statements": _counted(
            r["status"]
            for r in _rows(out, "statements", ["source", "status"])
            if r["source"] == "prompt"
        ),
        "not_represented": _unseen(out),
        "levels": _by(scenes, "level"),
        "rules": _by(scenes, "rule"),
        "proofs": _counted(s["proof"] for s in scenes if s["proof"]),
        "sizes": _sizes(out, scenes),
        "examples": _examples(scenes),
        "events": {
            kind: {"stated": n, "completed": done[kind]} for kind, n in sorted(events.items())
        },
        "constraints": {
            q: {"stated": len(scores), "mean_score": round(sum(scores) / len(scores), 4)}
            for q, scores in sorted(stated.items())
        },
        "pairs": _pairs(scenes),
        "failures": failure_table(failed),
    }


def _rows(out: Path, table: str, columns: Sequence[str]) -> Iterable[dict[str, Any]]:
    """Rows with some columns; the others (documents, trajectories) are not even read."""
    import pyarrow.parquet as pq

    from esg.store.tables import part_files

    for path in part_files(out, table):
        with pq.ParquetFile(path.absolute()) as file:
            for batch in file.iter_batches(columns=list(columns)):
                yield from batch.to_pylist()


def _unseen(out: Path) -> list[dict[str, Any]]:
    """The words that scenes most often show nothing of: statements and verbs."""
    place = ["scene_key", "start", "stop", "status"]
    said: dict[str, list[dict[str, Any]]] = {}
    for row in _rows(out, "statements", [*place, "source", "words", "reason"]):
        if row["source"] == "prompt":
            said.setdefault(row["scene_key"], []).append({**row, "end": row["stop"]})
    read: dict[str, list[dict[str, Any]]] = {}
    for row in _rows(out, "coverage", [*place, "text", "kind"]):
        read.setdefault(row["scene_key"], []).append({**row, "end": row["stop"]})
    return most_unseen(
        shortfalls({"coverage": {"items": read.get(key, ())}}, said.get(key, ()))
        for key in sorted({*said, *read})
    )


def _sizes(out: Path, scenes: Sequence[Mapping[str, Any]]) -> dict[str, dict[str, float]]:
    """How large scenes are: least, median, mean and most of what can be counted in one."""
    replays = list(_rows(out, "trajectories", ["bodies", "n_frames", "fps"]))
    stated = Counter(r["scene_key"] for r in _rows(out, "constraints", ["scene_key"]))
    hits = [len(r["contact_time_s"]) for r in _rows(out, "trajectories", ["contact_time_s"])]
    counted = {
        "bodies": [len(r["bodies"]) for r in replays],
        "expected events": [s["n_events"] for s in scenes if s["n_events"] is not None],
        "stated numbers": [stated[s["scene_key"]] for s in scenes],
        "length of the replay [s]": [(r["n_frames"] - 1) / r["fps"] for r in replays],
        "contacts in the replay": hits,
    }
    return {name: _spread(values) for name, values in counted.items() if values}


def _spread(values: Sequence[float]) -> dict[str, float]:
    ordered = sorted(values)
    middle = len(ordered) // 2
    median = ordered[middle] if len(ordered) % 2 else (ordered[middle - 1] + ordered[middle]) / 2
    numbers = (ordered[0], median, sum(ordered) / len(ordered), ordered[-1])
    return dict(zip(("min", "median", "mean", "max"), (round(v, 2) for v in numbers), strict=True))


def _examples(scenes: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The first verified and the first other scene of every level."""
    found: dict[tuple[str, bool], dict[str, Any]] = {}
    for s in sorted(scenes, key=lambda row: row["scene_key"]):
        found.setdefault(
            (s["level"] or "", bool(s["verified"])),
            {k: s[k] for k in ("level", "prompt", "outcome")} | {"verified": bool(s["verified"])},
        )
    return [found[key] for key in sorted(found, key=lambda k: (k[0], not k[1]))]


def _counted(values: Iterable[Any]) -> dict[str, int]:
    return dict(sorted(Counter(str(v) for v in values).items()))


def _by(scenes: Sequence[Mapping[str, Any]], column: str) -> dict[str, dict[str, int]]:
    all_of = Counter(s[column] or "" for s in scenes)
    good = Counter(s[column] or "" for s in scenes if s["verified"])
    return {k: {"scenes": all_of[k], "verified": good[k]} for k in sorted(all_of) if k}


def _pairs(scenes: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Counterfactual pairs: how many, what they change, how many are verified on both sides."""
    sides: dict[str, list[bool]] = {}
    for s in scenes:
        if s["pair"]:
            sides.setdefault(s["pair"], []).append(bool(s["verified"]))
    whole = [v for v in sides.values() if len(v) == 2]
    return {
        "pairs": len(whole),
        "both_verified": sum(all(v) for v in whole),
        "changed": _counted(s["changed"] for s in scenes if s["changed"]),
    }


def failure_table(failed: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Failures by outcome and cause, most frequent first; numbers in the cause are left out."""
    groups: dict[tuple[str, str, str], list[str]] = {}
    for row in failed:
        key = (str(row["outcome"]), str(row["stage"]), cause(str(row["reason"])))
        groups.setdefault(key, []).append(str(row["scene"]))
    ordered = sorted(groups.items(), key=lambda item: (-len(item[1]), item[0]))
    return [
        {"outcome": o, "stage": s, "cause": c, "scenes": len(names), "example": min(names)}
        for (o, s, c), names in ordered
    ]


def cause(reason: str) -> str:
    """A reason without what differs from scene to scene: names of bodies and numbers."""
    text = reason.split("; ")[0]
    text = re.sub(r"\b[a-z0-9_]*[a-z]_\d+(?:_[a-z0-9_]*)?\b", "…", text)
    text = re.sub(r"\be\d+\b", "…", text)
    text = re.sub(r"-?\d+(?:\.\d+)?", "#", text)
    return text[:120] or "none given"


def card(spec: DatasetSpec, counts: Counts, facts: Mapping[str, Any]) -> str:
    """Text of `README.md`."""
    title = _title(spec)
    n, good = facts["scenes"], facts["verified"]
    lines = [*card_header(title, counts), f"# {title}", "", _about(spec, n, good), ""]
    lines += [*card_tables(counts), ""]
    lines += [
        "Splits are by hash of the prompt family: of a sampled scene its rule and its mover, else "
        "the prompt without case, articles and numbers. No family, and so no counterfactual pair, "
        "is in two splits. Columns, keys and array layouts: `meta/info.json`.",
        "",
        "## Read it",
        "",
        "```python",
        "from datasets import load_dataset",
        'scenes = load_dataset("PATH", "scenes", split="train")',
        'moves = load_dataset("PATH", "trajectories", split="train")  # join by scene_key',
        "```",
        "```sql",
        "SELECT rule, avg(verified::INTEGER) FROM 'PATH/scenes/*.parquet' GROUP BY rule -- DuckDB",
        "```",
        "```python",
        'import polars as pl; pl.scan_parquet("PATH/scenes/*.parquet")',
        "```",
        "",
    ]
    lines += ["## Made by", "", "```", command(spec), "```", _made(spec, facts), ""]
    lines += _example_lines(facts["examples"])
    lines += _size_lines(facts["sizes"])
    lines += _share_table("How scenes end", "outcome", facts["outcomes"], n)
    lines += _statement_lines(facts, n)
    lines += _plausible_lines(facts)
    if facts["levels"]:
        lines += _rate_table("By difficulty", "level", facts["levels"], "scenes", "verified")
    if facts["rules"]:
        lines += _rate_table("By rule", "rule", facts["rules"], "scenes", "verified")
    if facts["events"]:
        lines += _rate_table("Events", "event", facts["events"], "stated", "completed")
    if facts["constraints"]:
        lines += ["## Stated numbers", "", "| quantity | stated | mean score (PPA) |"]
        lines += ["| --- | ---: | ---: |"]
        for q, c in facts["constraints"].items():
            lines.append(f"| {q} | {c['stated']} | {c['mean_score']:.3f} |")
        lines.append("")
    if facts["pairs"]["pairs"]:
        p = facts["pairs"]
        changes = ", ".join(f"{k}: {v}" for k, v in p["changed"].items())
        lines += ["## Counterfactual pairs", ""]
        lines += [
            f"{p['pairs']} pairs, {p['both_verified']} verified on both sides. {changes}.",
            "",
        ]
    return "\n".join([*lines, *_failure_lines(facts["failures"]), ""])


def _title(spec: DatasetSpec) -> str:
    what = "sampled dynamic scenes" if spec.source == "sample" else "dynamic scenes from prompts"
    return f"{spec.n} {what}, seed {spec.seed}"


def _about(spec: DatasetSpec, n: int, good: int) -> str:
    share = f"{100 * good / n:.1f}%" if n else "none"
    proof = {
        "physx": "the emitted class, compiled and run in PhysX 5 at 240 Hz",
        "rapier": "the control program, run in Rapier at 240 Hz",
        "newton": "the control program, run in Newton at 240 Hz",
    }[spec.engine]
    return (
        f"{n} scenes, {good} of them ({share}) *verified*: solved, all that the prompt says shown, "
        f"a valid layout, and every expected event happens in the replay ({proof}). Scenes that "
        "are not verified are kept and say why "
        "(`verified`, `outcome`, `reason`): filter them as you need. Of sampled scenes, the "
        "expectation is what their sentence says (`expectation`), not what was read into it."
    )


def command(spec: DatasetSpec) -> str:
    """The command that makes this dataset, without what is default."""
    usual = DatasetSpec(source=spec.source, n=spec.n)
    if spec.source == "sample":
        parts = [f"esg dataset --sample {spec.n}"]
        if spec.distribution is not None and spec.distribution != Distribution():
            parts.append("--distribution distribution.yaml")
    else:
        parts = ["esg dataset --prompts meta/prompts.jsonl"]
    for name in ("seed", "drafter", "strategy", "engine", "device", "mcap", "previews", "batch"):
        if (value := getattr(spec, name)) != getattr(usual, name):
            parts.append(f"--{name} {value}")
    if spec.counterfactual:
        parts.append("--counterfactual")
    if spec.strict:
        parts.append("--strict")
    if not spec.meshes:
        parts.append("--no-meshes")
    if spec.render is not None:
        parts += spec.render.options()
    return " ".join([*parts, "--out FOLDER"])


def _made(spec: DatasetSpec, facts: Mapping[str, Any]) -> str:
    from esg import __version__

    text = f"with esg-scenes {__version__}"
    if "--distribution" in command(spec):
        text += "; `distribution` in `meta/plan.json` holds the shares (JSON is YAML)"
    proofs = ", ".join(f"{n} by the {kind}" for kind, n in facts["proofs"].items())
    return (
        f"{text}. Replayed: {proofs or 'none'}. {facts['distinct_prompts']} distinct prompts in "
        f"{facts['families']} families."
    )


def _example_lines(examples: Sequence[Mapping[str, Any]]) -> list[str]:
    lines = ["## Examples", "", "| level | prompt | outcome | verified |"]
    lines.append("| --- | --- | --- | --- |")
    for row in examples:
        text = " ".join(str(row["prompt"]).split()).replace("|", "\\|")
        shown = text if len(text) <= 160 else f"{text[:159]}…"
        good = "yes" if row["verified"] else "no"
        lines.append(f"| {row['level'] or ''} | {shown} | {row['outcome']} | {good} |")
    return [*lines, ""]


def _size_lines(sizes: Mapping[str, Mapping[str, float]]) -> list[str]:
    lines = ["## How large scenes are", "", "| in a scene | least | median | mean | most |"]
    lines.append("| --- | ---: | ---: | ---: | ---: |")
    for name, row in sizes.items():
        numbers = " | ".join(f"{row[k]:g}" for k in ("min", "median", "mean", "max"))
        lines.append(f"| {name} | {numbers} |")
    return [*lines, ""]


def _share_table(title: str, name: str, counts: Mapping[str, int], n: int) -> list[str]:
    lines = [f"## {title}", "", f"| {name} | scenes | share |", "| --- | ---: | ---: |"]
    ordered = sorted(counts.items(), key=lambda item: (-item[1], item[0]))
    return [*lines, *(f"| {k} | {v} | {100 * v / max(1, n):.1f}% |" for k, v in ordered), ""]


def _statement_lines(facts: Mapping[str, Any], n: int) -> list[str]:
    """What prompts state and what became of it; the words that no scene shows."""
    said = facts["statements"]
    told = ", ".join(f"{k.replace('_', ' ')} {v}" for k, v in said.items()) or "none"
    lines = ["## What prompts say", ""]
    lines += [
        f"{facts['fully_understood']} of {n} prompts are fully understood; {facts['partial']} "
        "scenes are `partial`: usable, but not all that their prompt says is shown. Statements: "
        f"{told}.",
        "",
    ]
    if not facts["not_represented"]:
        return lines
    lines += ["| words that are not shown | why | scenes |", "| --- | --- | ---: |"]
    for row in facts["not_represented"]:
        words = row["words"].replace("|", "\\|")
        lines.append(f"| {words} | {row['status'].replace('_', ' ')} | {row['scenes']} |")
    return [*lines, ""]


def _plausible_lines(facts: Mapping[str, Any]) -> list[str]:
    """How many replays are plausible, and which checks the others fail."""
    lines = ["## Plausibility", ""]
    lines += [
        f"{facts['plausible']} of {facts['replayed']} replays are `plausible`: every check of "
        "table `plausibility_checks` stays within its limit.",
        "",
    ]
    if not facts["implausible"]:
        return lines
    lines += ["| check | replays that fail it |", "| --- | ---: |"]
    ordered = sorted(facts["implausible"].items(), key=lambda item: (-item[1], item[0]))
    return [*lines, *(f"| {name.replace('_', ' ')} | {n} |" for name, n in ordered), ""]


def _rate_table(
    title: str, name: str, rows: Mapping[str, Mapping[str, int]], whole: str, part: str
) -> list[str]:
    lines = [f"## {title}", "", f"| {name} | {whole} | {part} | share |"]
    lines.append("| --- | ---: | ---: | ---: |")
    for key, row in rows.items():
        share = 100 * row[part] / max(1, row[whole])
        lines.append(f"| {key} | {row[whole]} | {row[part]} | {share:.1f}% |")
    return [*lines, ""]


def _failure_lines(table: Sequence[Mapping[str, Any]]) -> list[str]:
    if not table:
        return ["## Failures", "", "None."]
    lines = ["## Failures", "", "One line a cause; every scene is in `failures.jsonl`.", ""]
    lines += ["| scenes | outcome | stage | cause | example |", "| ---: | --- | --- | --- | --- |"]
    for row in table[:_MAX_FAILURES]:
        why = row["cause"].replace("|", "\\|")
        lines.append(
            f"| {row['scenes']} | {row['outcome']} | {row['stage']} | {why} | {row['example']} |"
        )
    if len(table) > _MAX_FAILURES:
        rest = sum(r["scenes"] for r in table[_MAX_FAILURES:])
        lines.append(f"| {rest} | other | | {len(table) - _MAX_FAILURES} further causes | |")
    return lines
