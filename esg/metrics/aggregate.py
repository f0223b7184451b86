"""K seeds per scene to the benchmark report, and the paper's columns beside ours."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
import json
from pathlib import Path
import statistics
from typing import Any

from esg.metrics.models import SceneVerdict, Suite, SuiteScene, SuiteStatement

NONE_LISTED = "none listed"
"""Instead of a rate of events where a suite asks for none."""
PAPER_RESULTS = Path(__file__).parent / "data" / "paper_results.json"


@dataclass(frozen=True)
class SceneRun:
    """One run (one seed) of one suite scene.

    Args:
        seed: The seed.
        verdict: What the judge said; None if there was nothing to judge (invalid draft, crash).
        outcome: Value of the Outcome enum.
        seconds: Wall time of the scene [s].
        checks: Of its plausibility, as JSON; empty if there was nothing to judge.
    """

    seed: int
    verdict: SceneVerdict | None
    outcome: str
    seconds: float
    checks: Sequence[Mapping[str, Any]] = ()

    @property
    def plausible(self) -> bool | None:
        """Whether every check holds; None without a replay."""
        return all(check["ok"] for check in self.checks) if self.checks else None


def bench_json(
    suite: Suite,
    runs: Mapping[str, Sequence[SceneRun]],
    *,
    strategy: str,
    engine: str,
    dt: float,
) -> dict[str, Any]:
    """The document that `esg bench --json` writes.

    A run without a verdict completes nothing, fails SLR and scores 0. `ecr_std` is the (population)
    standard deviation over the per-run sums of completed events; SLR, PPA, SKR are percentages; a
    suite without constraints has null PPA, one without statements null SKR. `plausible` is the
    percentage of the runs that came to a replay.

    Args:
        suite: The suite.
        runs: Runs by suite scene id, the same number for every scene, in order of seed.
        strategy: Optimization strategy.
        engine: The engine that replayed.
        dt: Its physics step [s].

    Raises:
        ValueError: If a scene is missing or scenes have different numbers of runs.
    """
    counts = {scene.id: len(runs.get(scene.id, ())) for scene in suite.scenes}
    k = max(counts.values())
    if k == 0 or any(n != k for n in counts.values()):
        raise ValueError(f"every scene needs the same number of runs, got {counts}")
    scenes = [_scene_json(scene, runs[scene.id]) for scene in suite.scenes]
    sums = [sum(s["completed"][r] for s in scenes) for r in range(k)]
    every = [run for scene in suite.scenes for run in runs[scene.id]]
    return {
        "suite": suite.suite,
        "runs": k,
        "strategy": strategy,
        "engine": engine,
        "dt": dt,
        "scenes": scenes,
        "totals": {
            "events": suite.n_events,
            "ecr_mean": statistics.fmean(sums),
            "ecr_std": statistics.pstdev(sums),
            "slr": 100.0 * statistics.fmean(x for s in scenes for x in s["slr"]),
            "ppa": _ppa(suite, runs, "score"),
            "ppa_strict": _ppa(suite, runs, "score_strict"),
            "ppa_lenient": _ppa(suite, runs, "score_lenient"),
            "skr": _skr(scenes),
            "plausible": _plausible(every),
            "seconds_per_scene": statistics.fmean(run.seconds for run in every),
        },
    }


def _scene_json(scene: SuiteScene, runs: Sequence[SceneRun]) -> dict[str, Any]:
    ppa: list[dict[str, Any]] = []
    for i, constraint in enumerate(scene.constraints):
        verdicts = [r.verdict.constraints[i] if r.verdict else None for r in runs]
        ppa.append(
            {
                "constraint": constraint.label,
                "scores": [v.score if v else 0.0 for v in verdicts],
                "measured": [v.measured if v else None for v in verdicts],
            }
        )
    return {
        "id": scene.id,
        "n_events": len(scene.events),
        "completed": [r.verdict.completed if r.verdict else 0 for r in runs],
        "slr": [int(r.verdict.slr) if r.verdict else 0 for r in runs],
        "ppa": ppa,
        "statements": [_statement_json(s, i, runs) for i, s in enumerate(scene.statements)],
        "plausible": [r.plausible for r in runs],
        "plausibility": [list(r.checks) for r in runs],
        "outcome": [r.outcome for r in runs],
        "seconds": [r.seconds for r in runs],
    }


def _statement_json(statement: SuiteStatement, i: int, runs: Sequence[SceneRun]) -> dict[str, Any]:
    verdicts = [r.verdict.statements[i] if r.verdict else None for r in runs]
    return {
        "id": statement.id,
        "says": statement.says.value,
        "kept": [v.kept if v else False for v in verdicts],
        "measured": [v.measured if v else {} for v in verdicts],
    }


def _skr(scenes: Sequence[Mapping[str, Any]]) -> float | None:
    """Share of statements kept over all scenes and runs, in percent (suite format)."""
    kept = [k is True for scene in scenes for s in scene["statements"] for k in s["kept"]]
    return 100.0 * statistics.fmean(kept) if kept else None


def _plausible(runs: Sequence[SceneRun]) -> float | None:
    """Share of plausible runs among those that came to a replay, in percent."""
    known = [run.plausible for run in runs if run.plausible is not None]
    return 100.0 * statistics.fmean(known) if known else None


def _ppa(suite: Suite, runs: Mapping[str, Sequence[SceneRun]], name: str) -> float | None:
    """Mean score over all parameter instances and runs, in percent (paper, PPA aggregation)."""
    scores = [
        getattr(run.verdict.constraints[i], name) if run.verdict else 0.0
        for scene in suite.scenes
        for run in runs[scene.id]
        for i in range(len(scene.constraints))
    ]
    return 100.0 * statistics.fmean(scores) if scores else None


@lru_cache(maxsize=1)
def load_paper_results() -> dict[str, Any]:
    """The paper's published numbers, with their source."""
    return json.loads(PAPER_RESULTS.read_text(encoding="utf-8"))


def comparison_rows(bench: Mapping[str, Any]) -> list[dict[str, str]]:
    """One row per scene and a total: completed events of ours, and the paper's columns.

    The paper's columns are filled only for the suite called `paper`; for others they are empty.
    """
    paper = load_paper_results() if bench["suite"] == "paper" else None
    rows: list[dict[str, str]] = []
    for scene in bench["scenes"]:
        completed = scene["completed"]
        row = {
            "scene": scene["id"],
            "events": str(scene["n_events"]),
            "ours": _pm(statistics.fmean(completed), statistics.pstdev(completed))
            if scene["n_events"]
            else NONE_LISTED,
            "slr": f"{100 * statistics.fmean(scene['slr']):.0f}%",
            "ppa": _percent([x for c in scene["ppa"] for x in c["scores"]]),
            "skr": _percent([k is True for s in scene["statements"] for k in s["kept"]]),
            "plausible": _percent([p for p in scene["plausible"] if p is not None]),
            "outcome": _tally(scene["outcome"]),
            "seconds": f"{statistics.fmean(scene['seconds']):.1f}",
        }
        for method in load_paper_results()["methods"]:
            cell = paper["completion"].get(scene["id"], {}).get(method) if paper else None
            row[method] = _pm(*cell) if cell else ""
        rows.append(row)
    totals = bench["totals"]
    total = {
        "scene": "Total",
        "events": str(totals["events"]),
        "ours": _pm(totals["ecr_mean"], totals["ecr_std"]) if totals["events"] else NONE_LISTED,
        "slr": f"{totals['slr']:.0f}%",
        "ppa": "" if totals["ppa"] is None else f"{totals['ppa']:.1f}%",
        "skr": "" if totals["skr"] is None else f"{totals['skr']:.1f}%",
        "plausible": "" if totals["plausible"] is None else f"{totals['plausible']:.0f}%",
        "outcome": "",
        "seconds": f"{totals['seconds_per_scene']:.1f}",
    }
    for method in load_paper_results()["methods"]:
        cell = paper["totals"]["ecr"].get(method) if paper else None
        total[method] = _pm(*cell) if cell else ""
    return [*rows, total]


def comparison_table(bench: Mapping[str, Any], *, ours: str = "Ours") -> str:
    """The comparison as a Markdown table, with SLR and PPA of all methods below.

    Args:
        bench: What `bench_json` made.
        ours: What the column of its results is called.
    """
    paper = load_paper_results()
    columns = {
        "scene": "Scene", "events": "N", "ours": ours, "slr": "SLR", "ppa": "PPA",
        "skr": "SKR", "plausible": "Plausible", "outcome": "Outcome", "seconds": "s/scene",
    }  # fmt: skip
    if bench["totals"]["skr"] is None:
        del columns["skr"]
    if bench["suite"] == "paper":
        columns |= {m: paper["method_names"][m] for m in paper["methods"]}
    rows = comparison_rows(bench)
    widths = {c: max(len(t), *(len(r[c]) for r in rows)) for c, t in columns.items()}
    lines = [
        "| " + " | ".join(t.ljust(widths[c]) for c, t in columns.items()) + " |",
        "| " + " | ".join("-" * widths[c] for c in columns) + " |",
    ]
    lines += ["| " + " | ".join(r[c].ljust(widths[c]) for c in columns) + " |" for r in rows]
    t = bench["totals"]
    if t["ppa"] is not None:
        lines += [
            "",
            f"PPA standard {t['ppa']:.1f}%, strict {t['ppa_strict']:.1f}%, "
            f"lenient {t['ppa_lenient']:.1f}%",
        ]
    if bench["suite"] == "paper":
        for name, key in (("SLR", "slr"), ("PPA", "ppa")):
            values = [
                f"{paper['method_names'][m]} {v[0] if isinstance(v, list) else v:g}%"
                for m, v in paper["totals"][key].items()
            ]
            lines.append(f"Paper, {name}: " + ", ".join(values))
        lines.append(f"Paper's numbers: {paper['source']}.")
    return "\n".join(lines) + "\n"


def _pm(mean: float, std: float) -> str:
    return f"{mean:.1f} ± {std:.1f}"


def _percent(scores: Sequence[float]) -> str:
    return f"{100 * statistics.fmean(scores):.0f}%" if scores else ""


def _tally(outcomes: Sequence[str]) -> str:
    parts = [(o, outcomes.count(o)) for o in dict.fromkeys(outcomes)]
    if len(parts) == 1:
        return parts[0][0]
    return ", ".join(f"{n} {o}" for o, n in parts)
