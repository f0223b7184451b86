"""Do finished scenes keep their events in other engines and at other steps?

    esg bench data/suites/paper.yaml --runs 1 --out runs/paper
    python -m benchmarks.transfer runs/paper --suite data/suites/paper.yaml \
        [--json benchmarks/results/transfer_paper.json]

Every scene folder below the run is replayed in PhysX (the emitted class), Rapier and Newton (its
control program) at 120, 240 and 480 Hz and judged against the suite, or against its own timeline
without one. Differences are to PhysX at 240 Hz, where the scene was verified.
"""

from __future__ import annotations

import argparse
from collections import defaultdict
import json
from pathlib import Path
import platform
import statistics
import time
from typing import Any

from esg.api.scene import document_of, expectation
from esg.commands.console import table
from esg.compile.transfer import MATRIX_ENGINES, MATRIX_RATES_HZ, REFERENCE, transfer_matrix
from esg.metrics import load_suite
from esg.scenefolder import is_scene_folder


def measure(
    run: Path, suite: Path | None, engines: list[str], rates_hz: list[int]
) -> dict[str, Any]:
    """The matrix of every compiled scene below a folder.

    Args:
        run: Folder of scene folders.
        suite: Suite to judge against; None for each scene's own timeline.
        engines: Engines.
        rates_hz: Physics steps a second.
    """
    loaded = load_suite(suite) if suite else None
    folders = sorted(p for p in run.iterdir() if is_scene_folder(p))
    compiled = [p for p in folders if (p / "manifest.json").exists()]
    scenes: dict[str, Any] = {}
    start = time.process_time()
    for folder in compiled:
        expected, against = expectation(folder, document_of(folder), loaded)
        runs = transfer_matrix(folder, expected, engines=engines, rates_hz=rates_hz)
        scenes[folder.name] = {"judged_against": against, "runs": [r.to_json() for r in runs]}
    return {
        "suite": suite.stem if suite else None,
        "scenes_found": len(folders),
        "never_compiled": [p.name for p in folders if p not in compiled],
        "reference": {"engine": REFERENCE[0], "hz": REFERENCE[1]},
        "totals": totals(scenes, engines, rates_hz),
        "cpu_seconds": round(time.process_time() - start, 1),
        "machine": platform.machine(),
        "scenes": scenes,
    }


def totals(scenes: dict[str, Any], engines: list[str], rates_hz: list[int]) -> list[dict[str, Any]]:
    """Sums over all scenes, one row per engine and rate.

    `lost` counts events that the reference completes and this run does not, `gained` the reverse;
    lateness is of the events that both complete.
    """
    rows: list[dict[str, Any]] = []
    cells: dict[tuple[str, int], list[tuple[dict[str, Any], dict[str, Any]]]] = defaultdict(list)
    for scene in scenes.values():
        reference = next(
            (r for r in scene["runs"] if (r["engine"], r["hz"]) == REFERENCE), scene["runs"][0]
        )
        for r in scene["runs"]:
            cells[r["engine"], r["hz"]].append((r, reference))
    for engine in engines:
        for rate in rates_hz:
            pairs = cells[engine, rate]
            ppa = [r["ppa"]["standard"] for r, _ in pairs if r["ppa"]["standard"] is not None]
            late, lost, gained = [], 0, 0
            for r, reference in pairs:
                for mine, theirs in zip(r["events"], reference["events"], strict=True):
                    lost += theirs["completed"] and not mine["completed"]
                    gained += mine["completed"] and not theirs["completed"]
                    if mine["completed"] and theirs["completed"] and mine["late_s"] is not None:
                        late.append(abs(mine["late_s"]))
            rows.append(
                {
                    "engine": engine,
                    "hz": rate,
                    "proof": pairs[0][0]["proof"] if pairs else None,
                    "scenes": len(pairs),
                    "scenes_verified": sum(r["verified"] for r, _ in pairs),
                    "slr": sum(r["slr"] for r, _ in pairs),
                    "events": sum(r["n_events"] for r, _ in pairs),
                    "completed": sum(r["completed"] for r, _ in pairs),
                    "lost": lost,
                    "gained": gained,
                    "ppa": statistics.fmean(ppa) if ppa else None,
                    "late_median_s": statistics.median(late) if late else None,
                    "late_max_s": max(late, default=None),
                }
            )
    return rows


def report(result: dict[str, Any]) -> str:
    """The totals as a table."""

    def milliseconds(value: float | None) -> str:
        return "" if value is None else f"{1000 * value:.0f}"

    columns = ["engine", "Hz", "proof", "scenes", "verified", "SLR", "events", "lost", "gained",
               "PPA", "|late| ms", "max"]  # fmt: skip
    rows = [
        [
            r["engine"], str(r["hz"]), r["proof"] or "", str(r["scenes"]),
            str(r["scenes_verified"]), str(r["slr"]), f"{r['completed']}/{r['events']}",
            str(r["lost"]), str(r["gained"]), "" if r["ppa"] is None else f"{100 * r['ppa']:.1f}%",
            milliseconds(r["late_median_s"]), milliseconds(r["late_max_s"]),
        ]
        for r in result["totals"]
    ]  # fmt: skip
    lines = [table(columns, rows)]
    for name, scene in result["scenes"].items():
        failed: dict[str, list[str]] = defaultdict(list)
        for r in scene["runs"]:
            for event in r["events"]:
                if not event["completed"]:
                    failed[event["id"]].append(f"{r['engine']} {r['hz']}")
        lines += [f"{name} {event}: not in {', '.join(where)}" for event, where in failed.items()]
    if result["never_compiled"]:
        lines.append(f"never compiled: {', '.join(result['never_compiled'])}")
    return "\n".join(lines)


def compact(result: dict[str, Any]) -> str:
    """JSON with one line per total and per run, numbers to a microsecond or micrometre."""

    def rounded(value: Any) -> Any:
        if isinstance(value, float):
            return round(value, 6)
        if isinstance(value, dict):
            return {k: rounded(v) for k, v in value.items()}
        return [rounded(v) for v in value] if isinstance(value, list) else value

    def lines(items: list[Any], indent: str) -> str:
        inner = ",\n".join(f"{indent} {json.dumps(rounded(i))}" for i in items)
        return f"[\n{inner}\n{indent}]"

    head = {k: v for k, v in result.items() if k not in ("totals", "scenes")}
    scenes = ",\n".join(
        f'  {json.dumps(name)}: {{"judged_against": {json.dumps(s["judged_against"])}, '
        f'"runs": {lines(s["runs"], "  ")}}}'
        for name, s in result["scenes"].items()
    )
    text = json.dumps(head, indent=1)[:-2]
    totals_text = lines(result["totals"], " ")
    return f'{text},\n "totals": {totals_text},\n "scenes": {{\n{scenes}\n }}\n}}\n'


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=Path, help="folder of scene folders")
    parser.add_argument("--suite", type=Path)
    parser.add_argument("--engines", nargs="+", default=list(MATRIX_ENGINES))
    parser.add_argument("--rates", nargs="+", type=int, default=list(MATRIX_RATES_HZ))
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    if not options.run.is_dir():
        parser.error(f"{options.run} is no folder")
    result = measure(options.run, options.suite, options.engines, options.rates)
    print(report(result))
    if options.json:
        options.json.write_text(compact(result), "utf-8")


if __name__ == "__main__":
    main()
