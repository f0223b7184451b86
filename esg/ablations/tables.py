"""The tables of ablations: what runs came to, beside what the paper prints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
import statistics
from typing import Any

from esg.ablations.variants import Ablation, Variant
from esg.metrics.models import SceneVerdict, Suite
from esg.pipeline import SceneState
from esg.runs import verdict_of

Runs = Mapping[Variant, Sequence[SceneState]]
NOT_RUN = "-"


@dataclass(frozen=True)
class Table:
    """One table.

    Args:
        key: Of the ablation.
        title: What it is about.
        columns: Heads.
        rows: Cells, a row a variant.
        note: What to know when reading it.
    """

    key: str
    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    note: str = ""

    def to_json(self) -> dict[str, Any]:
        """What `--json` tells of it."""
        return {
            "ablation": self.key,
            "title": self.title,
            "rows": [dict(zip(self.columns, row, strict=True)) for row in self.rows],
            "note": self.note,
        }


def table_of(ablation: Ablation, runs: Runs, suite: Suite) -> Table:
    """The table of an ablation.

    Args:
        ablation: Which; not `draft`, which has no runs.
        runs: Final states of every variant.
        suite: The suite that was run.
    """
    heads: list[str] = []
    rows: list[tuple[str, ...]] = []
    for variant in ablation.variants:
        states = [
            s
            for s in runs[variant]
            if not ablation.scenes or scene_id(s) in ablation.scenes
        ]  # fmt: skip
        cells: dict[str, str] = {}
        for measure in ablation.measures:
            cells |= MEASURES[measure](states, suite)
        heads = heads or list(cells)
        blank = (NOT_RUN,) * len(ablation.paper_columns)
        said = ablation.paper.get(variant.key, blank)
        rows.append((variant.title, *(cells.get(h, NOT_RUN) for h in heads), *said))
    columns = ("variant", *heads, *ablation.paper_columns)
    return Table(ablation.key, ablation.title, columns, tuple(rows), ablation.note)


def scene_id(state: SceneState) -> str:
    """Id of the suite's scene that a state is a run of."""
    return state.request.name.rpartition("-run")[0]


def _verdicts(states: Sequence[SceneState]) -> list[SceneVerdict | None]:
    return [verdict_of(state) for state in states]


def _sums(states: Sequence[SceneState]) -> list[int]:
    """Completed events by run, over all scenes."""
    sums: Counter[str] = Counter()
    for state, verdict in zip(states, _verdicts(states), strict=True):
        sums[state.request.name.rpartition("-run")[2]] += verdict.completed if verdict else 0
    return list(sums.values())


def _events(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    sums = _sums(states)
    ids = {scene_id(s) for s in states}
    count = sum(len(scene.events) for scene in suite.scenes if scene.id in ids)
    spread = statistics.pstdev(sums) if sums else 0.0
    return {f"events of {count}": f"{statistics.fmean(sums):.1f} ± {spread:.1f}"}


def _spread(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    """Whether events lie within what the paper's w/o Opt. spreads over."""
    from esg.metrics.aggregate import load_paper_results

    paper = load_paper_results()["totals"]
    if suite.suite != "paper" or suite.n_events != paper["events"]:
        return {}
    if any(s.request.strategy != "none" for s in states):
        return {"off the paper's w/o Opt.": NOT_RUN}
    mean, spread = paper["ecr"]["without_opt"]
    off = statistics.fmean(_sums(states)) - mean
    within = "within" if abs(off) <= spread else "outside"
    return {"off the paper's w/o Opt.": f"{off:+.1f} ({within} its ± {spread:g})"}


def _slr(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    valid = [bool(v and v.slr) for v in _verdicts(states)]
    return {"SLR": f"{100 * statistics.fmean(valid):.0f}%"}


def _ppa(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    asked = {scene.id: scene.constraints for scene in suite.scenes}
    scores: list[float] = []
    for state, verdict in zip(states, _verdicts(states), strict=True):
        constraints = asked[scene_id(state)]
        scores += [c.score for c in verdict.constraints] if verdict else [0.0] * len(constraints)
    return {"PPA": f"{100 * statistics.fmean(scores):.1f}%" if scores else NOT_RUN}


def _each_event(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    verdicts = _verdicts(states)
    (scene,) = {scene_id(s) for s in states}
    events = next(s for s in suite.scenes if s.id == scene).events
    return {
        f"event {k + 1}": f"{sum(bool(v and v.events[k].completed) for v in verdicts)}"
        f"/{len(verdicts)}"
        for k in range(len(events))
    }


def _completion(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    verdicts = _verdicts(states)
    (scene,) = {scene_id(s) for s in states}
    count = len(next(s for s in suite.scenes if s.id == scene).events)
    done = sum(v.completed if v else 0 for v in verdicts)
    return {"completion": f"{100 * done / (count * len(verdicts)):.1f}%"}


def _search_s(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    """Mean seconds of the search, of what was searched now and not found in the cache."""
    entries = [e for s in states for e in s.log if e["stage"] == "optimize"]
    fresh = [float(e["seconds"]) for e in entries if not e["cached"]]
    return {"search s": f"{statistics.fmean(fresh):.1f}" if fresh else "cached"}


def _relations(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    found = [layout_of(state) for state in states]
    reports = [r.satisfied for layout in found if layout is not None for r in layout.relations]
    return {"relations true": f"{100 * statistics.fmean(reports):.1f}%" if reports else NOT_RUN}


def _infeasible(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    found = [layout_of(state) for state in states]
    bad = sum(layout is None or not layout.feasible for layout in found)
    return {"layouts infeasible": f"{bad}/{len(found)}"}


def _assets(states: Sequence[SceneState], suite: Suite) -> dict[str, str]:
    from esg.stages import load_doc

    sources: Counter[str] = Counter()
    for state in states:
        if "resolve" in state.artifacts:
            made = (load_doc(state, "resolve").asset_configurations or {}).values()
            sources.update("stand-in" if c.reason else c.source for c in made)
    told = ", ".join(f"{n} {source}" for source, n in sorted(sources.items()))
    return {"assets": told or NOT_RUN}


def layout_of(state: SceneState) -> Any:
    """The layout of a scene; None if it did not come to that."""
    from esg.stages import load_doc

    return load_doc(state, "layout").layout_result if "layout" in state.artifacts else None


Measure = Callable[[Sequence[SceneState], Suite], dict[str, str]]
MEASURES: dict[str, Measure] = {
    "events": _events,
    "spread": _spread,
    "slr": _slr,
    "ppa": _ppa,
    "each_event": _each_event,
    "completion": _completion,
    "search_s": _search_s,
    "relations": _relations,
    "infeasible": _infeasible,
    "assets": _assets,
}
"""Columns by name."""
