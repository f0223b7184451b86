"""The workflows: steps that parse, and commands of ours that are there with what they are given."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
import os
from pathlib import Path
import re
import shlex
import subprocess
import sys
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).parents[2]
FILES = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
EXPRESSION = re.compile(r"\$\{\{.*?\}\}")
"""What the service fills in."""
NAMED = ("tests/", "data/", "constraints.txt", "pyproject.toml")
"""Files of the checkout, by how their names begin."""


def scripts() -> Iterator[tuple[str, str]]:
    """Every step's commands, with the name of its file and job."""
    for path in FILES:
        for name, job in yaml.safe_load(path.read_text("utf-8"))["jobs"].items():
            for step in job["steps"]:
                if "run" in step:
                    yield f"{path.stem}/{name}", EXPRESSION.sub("1", step["run"])


def commands() -> Iterator[list[str]]:
    """Every command's words."""
    for _, script in scripts():
        for line in re.split(r"\n|&&|\|\|", script.replace("\\\n", " ")):
            yield shlex.split(line.strip("() "), comments=True)


def ours() -> dict[tuple[str, ...], set[str]]:
    """Our commands, as arguments of Python, and all words and options that they are given."""
    asked: dict[tuple[str, ...], set[str]] = {}
    for words in commands():
        names: list[str] = []
        if words[:1] == ["esg"]:
            names, rest = ["-m", "esg.cli"], words[1:]
        elif "-m" in words and words[words.index("-m") + 1].startswith("benchmarks."):
            at = words.index("-m")
            names, rest = words[at : at + 2], words[at + 2 :]
        if names:
            # What follows an option is its value.
            plain = [
                w for b, w in pairwise(["", *rest])
                if re.fullmatch("[a-z]+", w) and not b.startswith("--")
            ]  # fmt: skip
            told = {w for w in rest if w.startswith("--")}
            if names[1] == "esg.cli":
                names += plain
            else:
                told.update(plain)
            asked.setdefault(tuple(names), set()).update(told)
    return asked


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.name)
def test_every_job_has_a_limit_and_steps_that_do_something(path: Path) -> None:
    workflow: dict[Any, Any] = yaml.safe_load(path.read_text("utf-8"))
    assert workflow["permissions"], "all that the account may do"
    assert workflow[True], "never runs"  # YAML reads the key `on` as true
    for name, job in workflow["jobs"].items():
        assert job["timeout-minutes"] > 0, name
        assert all(("run" in step) != ("uses" in step) for step in job["steps"]), name


def test_scripts_are_sound_shell() -> None:
    for name, script in scripts():
        done = subprocess.run(
            ["bash", "-n"], input=script, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, f"{name}: {done.stderr}"


def test_files_that_commands_name_are_there() -> None:
    named = {w for words in commands() for w in words if w.startswith(NAMED)}
    assert {"constraints.txt", "pyproject.toml"} < named
    assert not sorted(name for name in named if not (ROOT / name).exists())


def test_our_commands_know_what_they_are_given() -> None:
    asked = ours()
    assert {("-m", "esg.cli", "serve"), ("-m", "benchmarks.faults")} < asked.keys()
    for line, told in asked.items():
        done = subprocess.run(
            [sys.executable, *line, "--help"], cwd=ROOT, capture_output=True, text=True,
            env={**os.environ, "COLUMNS": "200"}, check=False,
        )  # fmt: skip
        assert done.returncode == 0, f"{line}: {done.stderr[-500:]}"
        known = set(re.findall(r"--[a-z][a-z-]*|[a-z]+", done.stdout))
        assert told <= known, f"{line}: no {sorted(told - known)}"
