"""From a prompt to a proven scene folder, through the command line as people use it."""

from __future__ import annotations

import json
import os
from pathlib import Path
import subprocess
import sys
from typing import Any

import pytest

from esg.pipeline import STAGES

ROOT = Path(__file__).parents[2]
PROMPT = "A toy truck rolls forward at 3 m/s and hits a wooden crate."


def esg(cache: Path, cwd: Path, *arguments: str, **env: str) -> subprocess.CompletedProcess[str]:
    variables = {**os.environ, "ESG_CACHE_DIR": str(cache), "PYTHONPATH": str(ROOT), **env}
    variables.pop("ESG_DB", None)
    return subprocess.run(
        [sys.executable, "-m", "esg.cli", *arguments],
        capture_output=True, text=True, cwd=cwd, env=variables, timeout=580, check=False,
    )  # fmt: skip


def tree(folder: Path, *skip: str) -> dict[str, bytes]:
    return {
        p.relative_to(folder).as_posix(): p.read_bytes()
        for p in sorted(folder.rglob("*"))
        if p.is_file() and p.name not in skip
    }


def test_generate_proves_a_scene_once_and_remembers_it(tmp_path: Path) -> None:
    done = esg(tmp_path / "cache", tmp_path, "generate", PROMPT, "--json")
    assert done.returncode == 0, done.stdout + done.stderr
    first: dict[str, Any] = json.loads(done.stdout)
    assert first["outcome"] == "solved"
    assert first["verified"]
    assert first["cached_stages"] == 0
    folder = tmp_path / first["folder"]
    names = set(tree(folder))
    assert {"prompt.txt", "esg.json", "manifest.json", "metrics.json", "log.jsonl"} <= names
    assert {"preview.png", "rollout.mcap", "stages/1-draft.json", "stages/9-dress.json"} <= names
    assert any(n.startswith("unreal/") and n.endswith(".cpp") for n in names)
    assert any(n.startswith("meshes/") and n.endswith(".glb") for n in names)
    assert not [p for p in (tmp_path / "runs").rglob("*.tmp")]

    again = json.loads(esg(tmp_path / "cache", tmp_path, "generate", PROMPT, "--json").stdout)
    assert again["cached_stages"] == len(STAGES)
    assert tree(folder, "log.jsonl") == tree(tmp_path / again["folder"], "log.jsonl")

    rows = json.loads(
        esg(tmp_path / "cache", tmp_path, "sql", "--json",
            "SELECT outcome, cached_stages FROM scenes ORDER BY cached_stages").stdout
    )  # fmt: skip
    assert rows["rows"] == [["solved", 0], ["solved", len(STAGES)]]

    done = esg(tmp_path / "cache", tmp_path, "generate", PROMPT, "--render", "depth", "--json")
    assert done.returncode == 0, done.stdout + done.stderr
    assert list((folder / "render").rglob("*.png")), json.loads(done.stdout)["render"]

    replay = esg(
        tmp_path / "cache", tmp_path, "replay", folder.name, "--engine", "rapier", "--json"
    )
    verdict = json.loads(replay.stdout)
    assert verdict["engine"] == "rapier"
    assert verdict["proof"] == "program"
    assert verdict["verdict"]["n_events"] == first["metrics"]["n_events"]


@pytest.mark.slow
def test_same_prompt_and_seed_give_the_same_bytes(tmp_path: Path) -> None:
    """Two machines' worth of empty caches: documents, manifest, class and metrics agree."""
    folders: list[Path] = []
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        done = esg(tmp_path / name / "cache", tmp_path / name, "generate", PROMPT, "--json")
        folders.append(tmp_path / name / json.loads(done.stdout)["folder"])
    assert tree(folders[0], "log.jsonl") == tree(folders[1], "log.jsonl")


@pytest.mark.slow
def test_without_a_compiler_the_program_is_replayed_and_said_so(tmp_path: Path) -> None:
    done = esg(tmp_path / "cache", tmp_path, "generate", PROMPT, "--json", CXX="no-such-compiler")
    assert done.returncode == 0, done.stdout + done.stderr
    document = json.loads(done.stdout)
    assert document["proof"] == "program"
    assert document["verified"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("prompt", "outcome", "status"),
    [
        ("A ball rolls on a table.", "solved", {"rolls": "kept", "a table": "kept"}),
        ("A car reverses slowly into a wall.", "solved", {"reverses": "kept", "slowly": "kept"}),
        ("A boy fetches a ball.", "partial", {"fetches": "not_represented"}),
        ("A woman picks up a mug.", "solved", {}),
        (
            "A drone flies to the right of a tower.",
            "solved",
            {"flies": "kept", "right of a tower": "kept"},
        ),
    ],
)
def test_words_are_kept_or_owned_up_to(
    tmp_path: Path, prompt: str, outcome: str, status: dict[str, str]
) -> None:
    """From the words of a prompt to what is measured of them in PhysX."""
    done = esg(tmp_path / "cache", tmp_path, "generate", prompt, "--json")
    assert done.returncode == 0, done.stdout + done.stderr
    scene: dict[str, Any] = json.loads(done.stdout)
    assert scene["outcome"] == outcome
    assert {s["words"]: s["status"] for s in scene["statements"]} == status
    assert all(prompt[s["start"] : s["end"]] == s["words"] for s in scene["statements"])
    assert [s["words"] for s in scene["not_kept"]] == [w for w, s in status.items() if s != "kept"]
    assert scene["metrics"]["engine"] == "physx"
    assert scene["metrics"]["completed"] == scene["metrics"]["n_events"]
