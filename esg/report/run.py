"""What a run left on disk: its scenes, its totals, and the run before it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
import re
import statistics
from typing import Any

from esg.fidelity import judged, lost_in, statement_rows
from esg.outcomes import UserError
from esg.scenefolder import is_scene_folder
from esg.scenefolder.unfinished import all_settled
from esg.scenereading import (
    collected,
    damaged,
    log_entries,
    read_document,
    read_metrics,
    read_object,
    read_text,
)
from esg.strangers.folders import file_in, lies_in, oddity
from esg.strangers.sums import altered

RUN_FILE = "run.json"
"""The results document that a benchmark leaves beside its scene folders."""
_TOTALS = ("ecr_mean", "ecr_std", "slr", "ppa", "ppa_strict", "ppa_lenient", "seconds_per_scene")
_FACTS = ("suite", "strategy", "engine")
_WRITTEN = (("draft", "esg.json"), ("compile", "manifest.json"), ("judge", "metrics.json"))
"""Stages and the file of the scene folder that each leaves."""
_MOST_PROMPT_CHARS = 100_000
_MADE = ("solved", "partial", "nearest_feasible", "infeasible", "not_converged")


@dataclass(frozen=True)
class SceneEntry:
    """One scene folder, read as far as the scene came.

    Args:
        folder: Its path.
        document: The ESG document as JSON; empty if no draft was written.
        metrics: `metrics.json`; empty if there was nothing to judge.
        log: Entries of `log.jsonl`, the last one with the outcome.
        problems: Files that could not be used, each with the reason and the remedy.
        refused: Whether nothing of it is read because of what is in it (esg.strangers.folders).
    """

    folder: Path
    document: dict[str, Any]
    metrics: dict[str, Any]
    log: tuple[dict[str, Any], ...]
    problems: tuple[str, ...] = ()
    refused: bool = False

    @property
    def name(self) -> str:
        """Of its folder."""
        return self.folder.name

    @property
    def group(self) -> str:
        """The suite scene that this is a run of, or its own name."""
        return re.sub(r"-run\d+$", "", self.name)

    @property
    def prompt(self) -> str:
        """What was asked for."""
        if self.refused:
            return ""
        with (self.folder / "prompt.txt").open(encoding="utf-8", errors="replace") as file:
            return file.read(_MOST_PROMPT_CHARS).removesuffix("\n")

    @property
    def outcome(self) -> str:
        """How it ended; unfinished if its log does not say."""
        return str((self.log[-1] if self.log else {}).get("outcome") or "unfinished")

    @property
    def reason(self) -> str:
        """Why it ended like that; often empty."""
        return str((self.log[-1] if self.log else {}).get("reason") or "")

    @property
    def verdict(self) -> dict[str, Any]:
        """The judge's verdict as JSON; empty if there is none."""
        return self.metrics.get("verdict", {})

    @property
    def statements(self) -> list[dict[str, Any]]:
        """What became of the statements of the prompt (esg.fidelity)."""
        return self.metrics["statements"] if self.metrics else statement_rows(self.document)

    @property
    def asked(self) -> list[dict[str, Any]]:
        """What became of the statements of the suite that it was judged by."""
        if self.metrics.get("judged_against") != "suite":
            return []
        return [judged(statement) for statement in self.verdict["statements"]]

    @property
    def not_kept(self) -> list[dict[str, Any]]:
        """What of the prompt is not shown."""
        return lost_in(self.document, self.metrics or None)

    @property
    def plausible(self) -> bool | None:
        """Whether its replay is plausible; None if that was never judged."""
        found = self.metrics.get("plausibility")
        return None if not found else bool(found["plausible"])

    @property
    def seconds(self) -> float:
        """Time spent in stages [s]."""
        return sum(float(e.get("seconds", 0.0)) for e in self.log)

    @property
    def seed(self) -> int | None:
        """Of its run; None if no stage recorded it."""
        seeds = [p["seed"] for p in self.document.get("provenance", []) if "seed" in p]
        return int(seeds[0]) if seeds else None


@dataclass(frozen=True)
class Run:
    """A folder of scenes with its figures.

    Args:
        folder: Where the scene folders are.
        scenes: In natural order of their names (S2 before S10).
        facts: Suite, strategy, engine, number of runs, where known.
        totals: Keys of the benchmark document's totals, `events` included.
        rows: Per suite scene: id, events, completed per run, outcomes, seconds.
        before: Totals of the run it is set beside, with `name`; empty if none is known.
        paper: The published results if this is their suite, else empty.
        problems: Files of the run itself that could not be used.
    """

    folder: Path
    scenes: tuple[SceneEntry, ...]
    facts: dict[str, Any]
    totals: dict[str, Any]
    rows: tuple[dict[str, Any], ...]
    before: dict[str, Any] = field(default_factory=dict)
    paper: dict[str, Any] = field(default_factory=dict)
    problems: tuple[str, ...] = ()

    @property
    def single(self) -> bool:
        """Whether the folder is that of one scene."""
        return len(self.scenes) == 1 and self.scenes[0].folder == self.folder


def load_run(folder: Path, *, against: Path | None = None, database: Path | None = None) -> Run:
    """Reads a folder of scene folders, or one scene folder.

    A damaged file is no reason to show nothing of the others: it is told in `problems`. Pictures
    that are still being drawn are waited for.

    Args:
        folder: Output folder of a benchmark or of `esg generate`, or a scene folder.
        against: An earlier run to set beside it: its folder or its results document.
        database: The run database, asked for the run before if `against` is not given.

    Raises:
        UserError: If there is no scene in it, or `against` holds no results.
    """
    if not folder.is_dir():
        raise UserError(f"{folder} is not a folder; give the output folder of a run")
    paths = [folder] if is_scene_folder(folder) else find_scenes(folder)
    if not paths:
        raise UserError(f"{folder} holds no scene folders; give the --out of a bench or generate")
    problems = all_settled(paths)
    scenes = tuple(read_scene(path) for path in paths)
    document: dict[str, Any] = {}
    if (folder / RUN_FILE).exists() and file_in(folder, RUN_FILE) is None:
        problems.append(str(damaged(folder / RUN_FILE, "no file of this folder")))
    elif (folder / RUN_FILE).exists():
        document = collected(problems, lambda: _results(folder / RUN_FILE), document)
    rows = tuple(document.get("scenes") or _rows(scenes))
    facts = {k: document[k] for k in ("suite", "strategy", "engine", "runs", "dt") if k in document}
    before: dict[str, Any] = {}
    if against is not None:
        before = _against(against)
    elif database is not None and document.get("suite"):
        before = _last_run(database, document)
    return Run(
        folder=folder,
        scenes=scenes,
        facts=facts,
        totals=document.get("totals") or totals_of(scenes),
        rows=rows,
        before=before,
        paper=_paper() if document.get("suite") == "paper" else {},
        problems=tuple(problems),
    )


def find_scenes(folder: Path) -> list[Path]:
    """Scene folders directly below `folder`, or one level deeper, in natural order."""
    near = [p for p in folder.iterdir() if is_scene_folder(p)]
    if not near:
        near = [p for p in folder.glob("*/*") if is_scene_folder(p)]
    # A link in a stranger's run may lead to anything that looks like a scene.
    near = [p for p in near if lies_in(p, folder)]
    return sorted(near, key=lambda p: natural(str(p.relative_to(folder))))


def natural(text: str) -> list[tuple[int, int, str]]:
    """A sort key that counts: S2 before S10."""
    parts = re.split(r"(\d+)", text)
    return [(0, int(p), "") if p.isdigit() else (1, 0, p) for p in parts]


def read_scene(folder: Path) -> SceneEntry:
    """Reads a scene folder; what is missing or damaged is left empty, and damage is told."""
    odd = oddity(folder)
    if odd:
        return SceneEntry(folder, {}, {}, (), (odd,), refused=True)
    problems: list[str] = []
    # What can be read of a log that was cut off still says what the scene did until then.
    text = collected(problems, lambda: read_text(folder / "log.jsonl"), "")
    log, wrong = log_entries(text)
    if text and wrong:
        problems.append(str(damaged(folder / "log.jsonl", wrong)))
    collected(problems, lambda: read_text(folder / "prompt.txt"), "")
    document = collected(problems, lambda: read_document(folder / "esg.json"), {})
    metrics = collected(problems, lambda: read_metrics(folder / "metrics.json"), {})
    finished = {entry.get("stage") for entry in log}
    for stage, name in _WRITTEN:
        if stage in finished and not (folder / name).exists() and log[-1].get("outcome") in _MADE:
            problems.append(str(damaged(folder / name, "missing")))
    problems = problems or altered(folder)
    return SceneEntry(folder, document, metrics, log, tuple(problems))


def totals_of(scenes: Sequence[SceneEntry]) -> dict[str, Any]:
    """Totals over scenes, as a benchmark counts them: a scene without a verdict scores 0."""
    groups: dict[str, list[SceneEntry]] = {}
    for scene in scenes:
        groups.setdefault(scene.group, []).append(scene)
    events = 0
    scores: dict[str, list[float]] = {"score": [], "score_strict": [], "score_lenient": []}
    for members in groups.values():
        events += max(int(m.verdict.get("n_events", 0)) for m in members)
        constraints = max(len(m.verdict.get("constraints", ())) for m in members)
        for member in members:
            found = member.verdict.get("constraints", ())
            for key, values in scores.items():
                values += [float(c[key]) for c in found] or [0.0] * constraints
    runs = max(len(m) for m in groups.values())
    sums = [
        sum(int(m[k].verdict.get("completed", 0)) for m in groups.values() if k < len(m))
        for k in range(runs)
    ]
    valid = [bool(s.verdict.get("slr", False)) for s in scenes]

    def percent(values: Iterable[float]) -> float | None:
        found = list(values)
        return 100.0 * statistics.fmean(found) if found else None

    return {
        "events": events,
        "ecr_mean": statistics.fmean(sums),
        "ecr_std": statistics.pstdev(sums),
        "slr": percent(map(float, valid)),
        "ppa": percent(scores["score"]),
        "ppa_strict": percent(scores["score_strict"]),
        "ppa_lenient": percent(scores["score_lenient"]),
        "plausible": percent(float(s.plausible) for s in scenes if s.plausible is not None),
        "seconds_per_scene": statistics.fmean(s.seconds for s in scenes),
    }


def _rows(scenes: Sequence[SceneEntry]) -> list[dict[str, Any]]:
    rows: dict[str, dict[str, Any]] = {}
    for scene in scenes:
        row = rows.setdefault(
            scene.group,
            {"id": scene.group, "n_events": 0, "completed": [], "outcome": [], "seconds": []},
        )
        row["n_events"] = max(row["n_events"], int(scene.verdict.get("n_events", 0)))
        row["completed"].append(int(scene.verdict.get("completed", 0)))
        row["outcome"].append(scene.outcome)
        row["seconds"].append(round(scene.seconds, 3))
    return list(rows.values())


def _results(path: Path) -> dict[str, Any]:
    document = read_object(path)
    totals, rows = document.get("totals"), document.get("scenes", [])
    if not isinstance(totals, dict):
        raise damaged(path, "no results document: it lacks totals")
    wrong = [f"/totals/{k}" for k in ("events", *_TOTALS) if not _is_number(totals.get(k))]
    wrong += [f"/{k}" for k in _FACTS if not isinstance(document.get(k, ""), str)]
    if isinstance(rows, list):
        wrong += [f"/scenes/{i}" for i, row in enumerate(rows) if not _is_row(row)]
    else:
        wrong.append("/scenes")
    if wrong:
        raise damaged(path, f"{wrong[0]} has the wrong type")
    return document


def _is_number(value: Any) -> bool:
    return value is None or (isinstance(value, int | float) and not isinstance(value, bool))


def _is_row(row: Any) -> bool:
    return (
        isinstance(row, dict)
        and isinstance(row.get("id"), str)
        and _is_number(row.get("n_events"))
        and isinstance(row.get("completed"), list)
        and all(_is_number(n) for n in row["completed"])
    )


def _against(path: Path) -> dict[str, Any]:
    if path.is_dir() and (path / RUN_FILE).is_file():
        path = path / RUN_FILE
    if path.is_dir():
        found = find_scenes(path)
        if not found:
            raise UserError(f"--against {path}: no scene folders and no {RUN_FILE} in it")
        scenes = [read_scene(p) for p in found]
        wrong = [problem for scene in scenes for problem in scene.problems]
        if wrong:  # its figures would be too low, and this run's look better for it
            raise UserError("--against: " + wrong[0])
        return {**totals_of(scenes), "name": path.name}
    if not path.is_file():
        raise UserError(f"--against {path} does not exist")
    return {**_results(path)["totals"], "name": path.name}


def _last_run(database: Path, document: dict[str, Any]) -> dict[str, Any]:
    """The run of the same suite, strategy and engine before this one, from the run database."""
    if not database.is_file():
        return {}
    from esg.store import query

    def quoted(text: Any) -> str:
        return "'" + str(text).replace("'", "''") + "'"

    this = quoted(document.get("run_id") or "")
    sql = (
        f"SELECT run_id AS name, events, {', '.join(_TOTALS)} FROM bench_summary "
        f"WHERE suite = {quoted(document['suite'])} AND strategy = {quoted(document['strategy'])} "
        f"AND engine = {quoted(document['engine'])} AND run_id <> {this} "
        f"AND started_at < coalesce((SELECT started_at FROM runs WHERE run_id = {this}), now()) "
        "ORDER BY started_at DESC LIMIT 1"
    )
    try:
        rows = query(database, sql).dicts()
    except (UserError, OSError):
        return {}  # a database of another version is no reason to write no report
    return rows[0] if rows else {}


def _paper() -> dict[str, Any]:
    from esg.metrics.aggregate import load_paper_results

    return load_paper_results()
