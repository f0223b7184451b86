"""The table of plausibility over runs: per check how many replays fail it, and the worst.

python -m benchmarks.plausibility RUN [RUN ...] [--again] [--json FILE]

RUN is a document of `esg bench --json`, or an output folder of `esg bench` (its `run.json`) or of
`esg generate` (every scene's `metrics.json`). With `--again` the scene folders of RUN are checked
anew by today's limits, whatever their own files say.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
import json
from pathlib import Path
from typing import Any

from esg.metrics.plausibility import CHECKS, Check


@dataclass(frozen=True)
class Played:
    """One replay: its suite or folder, its name and its checks."""

    suite: str
    scene: str
    checks: tuple[Check, ...]

    @property
    def plausible(self) -> bool:
        """Whether every check holds."""
        return all(check.ok for check in self.checks)


def read(path: Path, again: bool = False) -> list[Played]:
    """The replays of a run.

    Args:
        path: A results document or an output folder.
        again: Whether scene folders are checked anew.

    Raises:
        SystemExit: If there is nothing to read.
    """
    if path.is_dir() and again:
        return [_anew(folder) for folder in sorted(path.glob("*")) if _whole(folder)]
    if path.is_dir() and not (path / "run.json").exists():
        return [
            Played(path.name, found.parent.name, _checks(json.loads(found.read_bytes())))
            for found in sorted(path.glob("*/metrics.json"))
        ]
    document = json.loads((path / "run.json" if path.is_dir() else path).read_bytes())
    if not any("plausibility" in scene for scene in document["scenes"]):
        raise SystemExit(f"{path} knows nothing of plausibility; give its folder and --again")
    return list(_of_document(document))


def _of_document(document: dict[str, Any]) -> Iterator[Played]:
    for scene in document["scenes"]:
        for run, checks in enumerate(scene["plausibility"]):
            if checks:
                found = tuple(Check.model_validate(c) for c in checks)
                yield Played(document["suite"], f"{scene['id']}-run{run}", found)


def _checks(metrics: dict[str, Any]) -> tuple[Check, ...]:
    return tuple(Check.model_validate(c) for c in metrics["plausibility"]["checks"])


def _whole(folder: Path) -> bool:
    return all((folder / name).exists() for name in ("manifest.json", "rollout.npz", "esg.json"))


def _anew(folder: Path) -> Played:
    from esg.engines.manifest import load_manifest
    from esg.engines.rollout_file import load_rollout
    from esg.graph import load_document
    from esg.metrics.plausibility import assess, told_of

    manifest, rollout = (
        load_manifest(folder / "manifest.json"),
        load_rollout(folder / "rollout.npz"),
    )
    told = told_of(load_document(folder / "esg.json"))
    found = assess(manifest.scene, manifest.program, rollout, told)
    return Played(folder.parent.name, folder.name, found.checks)


def rows(played: Sequence[Played]) -> list[dict[str, Any]]:
    """A row a check: replays, those that fail, the worst value with its limit and scene."""
    out: list[dict[str, Any]] = []
    for name in CHECKS:
        found = [(p, c) for p in played for c in p.checks if c.name == name]
        measured = [(p, c) for p, c in found if c.measured is not None and c.limit is not None]
        row: dict[str, Any] = {
            "check": name,
            "replays": len(found),
            "measured": len(measured),
            "failed": sum(not c.ok for _, c in found),
        }
        if measured:
            worst, check = max(measured, key=lambda pair: _ratio(pair[1]))
            row |= {
                "worst": check.measured, "limit": check.limit, "unit": check.unit,
                "scene": f"{worst.suite} {worst.scene}", "body": check.body,
            }  # fmt: skip
        out.append(row)
    return out


def _ratio(check: Check) -> tuple[float, float]:
    measured, limit = check.measured or 0.0, check.limit or 0.0
    return (measured / limit if limit else float(measured > 0.0) * 1e9, measured)


def table(played: Sequence[Played]) -> str:
    """The rows as Markdown, with the plausible share of every suite above them."""
    lines: list[str] = []
    for suite in dict.fromkeys(p.suite for p in played):
        own = [p for p in played if p.suite == suite]
        good = sum(p.plausible for p in own)
        lines.append(f"{suite}: {good} of {len(own)} plausible ({100 * good / len(own):.0f}%)  ")
    lines += ["", "| check | replays | measured | failed | worst | limit | where |"]
    lines += ["| --- | ---: | ---: | ---: | ---: | ---: | --- |"]
    for row in rows(played):
        name = row["check"].replace("_", " ")
        cells = [name, *(str(row[k]) for k in ("replays", "measured", "failed"))]
        if row["measured"]:
            cells += [f"{row[k]:.3g} {row['unit']}" for k in ("worst", "limit")]
            cells.append(f"{row['scene']}, {row['body']}")
        else:
            cells += ["", "", ""]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", nargs="+", type=Path)
    parser.add_argument("--again", action="store_true", help="check scene folders anew")
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    played = [p for run in arguments.runs for p in read(run, arguments.again)]
    if not played:
        raise SystemExit("no replays there")
    print(table(played))
    if arguments.json:
        plausible = sum(p.plausible for p in played)
        document = {"replays": len(played), "plausible": plausible, "checks": rows(played)}
        arguments.json.write_text(json.dumps(document, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
