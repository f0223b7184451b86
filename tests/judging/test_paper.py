"""The paper's ten scenes: what we export is judged as the run that made it."""

from __future__ import annotations

import json
from pathlib import Path
import subprocess
import sys

import pytest

import esg
from esg.judging.verdict import judge_file, scene_for
from esg.metrics import SceneVerdict, load_suite

ROOT = Path(__file__).parents[2]


@pytest.mark.slow
def test_our_own_exports_get_the_verdict_of_the_run_that_made_them(tmp_path: Path) -> None:
    runs = tmp_path / "runs"
    command = ["bench", "paper", "--runs", "1", "--out", str(runs)]
    subprocess.run([sys.executable, "-m", "esg", *command], cwd=ROOT, check=True)
    suite = load_suite("paper")
    off: list[str] = []
    for folder in sorted(runs.glob("S*-run0")):
        truth = SceneVerdict.from_json(json.loads((folder / "metrics.json").read_text())["verdict"])
        out = tmp_path / folder.name
        scene = esg.Scene.load(folder)
        scene.export("glb", out)
        scene.export("usd", out)
        for path in (out / "scene.glb", out / "scene_animation.usda", folder / "rollout.mcap"):
            found = judge_file(path, scene_for(path, suite)).verdict
            same = (
                [e.completed for e in found.events] == [e.completed for e in truth.events]
                and found.slr == truth.slr
                and [c.score for c in found.constraints] == [c.score for c in truth.constraints]
                and [s.kept for s in found.statements] == [s.kept for s in truth.statements]
            )
            if not same:
                off.append(f"{folder.name} {path.name}: {found.to_json()}")
    assert len(list(runs.glob("S*-run0"))) == 10 and not off, "\n".join(off)
