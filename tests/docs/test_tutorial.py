"""Every command that README and tutorial show is one, and runs, in their order."""

from __future__ import annotations

import os
from pathlib import Path
import re
import shlex
import shutil
import signal
import subprocess
import sys

import pytest

from esg.cli import build_app
from esg.commands.parsing import parse

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", ROOT / "docs" / "tutorial.md"]
BLOCK = re.compile(r"```sh\n(.*?)```", re.DOTALL)


def commands(page: Path) -> list[list[str]]:
    """Arguments of every `esg` command in the shell blocks of a page."""
    lines = "\n".join(BLOCK.findall(page.read_text("utf-8"))).splitlines()
    found = [part.strip() for line in lines for part in line.split("&&")]
    split = [shlex.split(part, comments=True) for part in found if part]
    return [words[1:] for words in split if Path(words[0]).name == "esg"]


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.stem)
def test_commands_are_read(page: Path) -> None:
    """Read by the parser of the command line, with all their options."""
    shown = commands(page)
    assert len(shown) >= 7
    for arguments in shown:
        parse(build_app(), arguments)


SMALLER = {"--sample": "2", "--runs": "1"}
"""What the README makes many of."""
STANDING = {"serve": "next run at", "studio": "http://", "view": "http://"}
"""Commands that stay until they are interrupted, and what they say first."""


def smaller(arguments: list[str], scene: Path) -> list[str]:
    """A command of the README, on little, and on the scene of its first command."""
    out = [str(scene) if a == "SCENE" else a for a in arguments]
    out = [str(scene / "esg.json") if a == "FILE.json" else a for a in out]
    for option, value in SMALLER.items():
        if option in out:
            out[out.index(option) + 1] = value
    return [*out, "--port", "0"] if out[0] in ("studio", "view") else out


@pytest.mark.slow
def test_the_readme_runs(tmp_path: Path) -> None:
    place = {
        "cwd": tmp_path, "text": True,
        "env": {**os.environ, "PYTHONPATH": str(ROOT), "ESG_DB": str(tmp_path / "runs.duckdb")},
    }  # fmt: skip
    scene = tmp_path
    for shown in commands(ROOT / "README.md"):
        arguments = smaller(shown, scene)
        if arguments[0] == "judge":
            made = next(tmp_path.glob("runs/bench-*/S6-run0/scene.glb"))
            shutil.copy(made, tmp_path / "S6.glb")
        call = [sys.executable, "-m", "esg", *arguments]
        if arguments[0] in STANDING:
            with subprocess.Popen(call, stdout=subprocess.PIPE, **place) as standing:
                assert standing.stdout is not None
                assert STANDING[arguments[0]] in standing.stdout.readline(), arguments
                standing.send_signal(signal.SIGINT)
                assert standing.wait(60) in (0, 130), arguments
            continue
        done = subprocess.run(call, capture_output=True, timeout=1800, check=False, **place)
        failed_some = arguments[0] in ("bench", "dataset", "judge", "replay")
        assert done.returncode in ((0, 3) if failed_some else (0,)), (arguments, done.stderr)
        if arguments[0] == "generate":
            scene = next((tmp_path / "runs").glob("*/esg.json")).parent
    subprocess.run([sys.executable, "-m", "esg", "up", "--stop"], check=True, **place)


@pytest.mark.slow
def test_the_tutorial_runs(tmp_path: Path) -> None:
    scene = ""
    for arguments in commands(ROOT / "docs" / "tutorial.md"):
        done = subprocess.run(
            [sys.executable, "-m", "esg", *(scene if a == "SCENE" else a for a in arguments)],
            cwd=tmp_path, capture_output=True, text=True, timeout=900, check=False,
            env={**os.environ, "PYTHONPATH": str(ROOT), "ESG_DB": str(tmp_path / "runs.duckdb")},
        )  # fmt: skip
        assert done.returncode in (0, 3 if arguments[0] == "dataset" else 0), done.stderr
        if arguments[0] == "generate":
            scene = str(next((tmp_path / "runs" / "tutorial").glob("*/esg.json")).parent)
    assert list((tmp_path / "tutorial-glb").rglob("*.glb"))
    assert list((tmp_path / "tutorial-unreal").rglob("*.cpp"))
    text = (ROOT / "docs" / "tutorial.md").read_text("utf-8")
    (loop,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    done = subprocess.run(
        [sys.executable, "-c", loop], cwd=tmp_path, capture_output=True, text=True, timeout=300,
        check=False, env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stdout.count(", 64, 64, 3)") == 4
