"""The command line: light to start, one message and the right code for every mistake."""

from __future__ import annotations

import json
from pathlib import Path
import subprocess
import sys

import pytest

ROOT = Path(__file__).parents[2]


def esg(*arguments: str, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Runs the command in a process of its own."""
    return subprocess.run(
        [sys.executable, "-c", "import sys; sys.path.insert(0, sys.argv.pop(1)); "
         "from esg.cli import main; main()", str(ROOT), *arguments],
        capture_output=True, text=True, cwd=cwd, timeout=300, check=False,
    )  # fmt: skip


def test_help_imports_nothing_heavy() -> None:
    code = (
        "import sys, contextlib\n"
        "from esg.cli import build_app\n"
        "build_app()(['--help'], result_action='return_value')\n"
        "heavy = ('numpy', 'pydantic', 'warp', 'newton', 'prefect', 'spacy', 'duckdb', 'pyarrow',"
        " 'trimesh', 'sapien')\n"
        "print([m for m in heavy if m in sys.modules], file=sys.stderr)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=True
    )
    assert "generate" in done.stdout
    assert done.stderr.strip() == "[]"


def test_completion_knows_commands_and_options(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "esg", "--install-completion"],
        capture_output=True, text=True, check=False,
        env={"HOME": str(tmp_path), "SHELL": "/bin/bash", "PYTHONPATH": str(ROOT), "PATH": "/bin"},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    script = next(p for p in tmp_path.rglob("esg") if p.is_file()).read_text()
    assert all(word in script for word in ("generate", "--close-loop", "batched", "rapier"))


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["generate", ""], "prompt is empty"),
        (["generate", "   "], "prompt is empty"),
        (["generate", "a\x07ball"], "control character"),
        (["generate", "a ball", "--strategy", "magic"], "magic"),
        (["generate", "a ball", "--out", "/dev/null/x"], "is not a folder"),
        (["generate", "a ball", "--device", "gpu"], "choose cpu or cuda:N"),
        (["generate", "a ball", "--seed", "-1"], "--seed -1"),
        (["draft", "a ball hits a box", "--seed", "-1"], "--seed -1"),
        (["bench", "missing.yaml"], "missing.yaml"),
        (["bench", "missing.yaml", "--runs", "0"], "--runs 0"),
        (["sql", "select 1", "--db", "missing.duckdb"], "missing.duckdb"),
        (["replay", "no-such-scene"], "no-such-scene"),
        (["paint"], "paint"),
    ],
)
def test_mistakes_are_told_in_one_message(arguments: list[str], words: str, tmp_path: Path) -> None:
    done = esg(*arguments, cwd=tmp_path)
    assert done.returncode == 2, done.stderr
    assert words in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""
    assert list(tmp_path.iterdir()) == []


def test_json_errors_are_one_document(tmp_path: Path) -> None:
    done = esg("generate", "", "--json", cwd=tmp_path)
    assert done.returncode == 2
    document = json.loads(done.stdout)
    assert document["exit_code"] == 2
    assert "empty" in document["error"]


def test_malformed_suite_lists_its_problems(tmp_path: Path) -> None:
    suite = tmp_path / "bad.yaml"
    suite.write_text("suite: x\nscenes:\n  - id: A\n    events: [{type: explodes}]\n")
    done = esg("bench", str(suite), cwd=tmp_path)
    assert done.returncode == 2
    assert "prompt" in done.stderr
    assert "explodes" in done.stderr
    assert "Traceback" not in done.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["bad.yaml"]


def test_check_tells_what_is_wrong_with_a_file(tmp_path: Path) -> None:
    path = tmp_path / "bad.json"
    path.write_text('{"scene_definition": {}}')
    done = esg("check", str(path), "--json", cwd=tmp_path)
    assert done.returncode == 2
    report = json.loads(done.stdout)
    assert report["ok"] is False
    assert any("scene_id" in v["pointer"] for v in report["violations"])


def test_draft_of_a_static_scene_has_no_timeline(tmp_path: Path) -> None:
    done = esg("draft", "A table with a vase.", "--json", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    document = json.loads(done.stdout)
    assert document["esg"].get("timeline_system") is None
    assert document["violations"] == []
    assert list(tmp_path.iterdir()) == []


def test_generate_says_what_it_did_not_understand() -> None:
    """A word outside the lexicon is a visible warning, never silence."""
    from esg.commands.generate import describe

    summary = {
        "outcome": "solved",
        "folder": "runs/x",
        "reason": "",
        "advice": "",
        "metrics": None,
        "coverage": {"warnings": ['"zorple" is not in the lexicon'], "not_understood": ["zorple"]},
        "relations_not_met": ["lamp_1 adjacent book_1"],
        "statements": [],
        "not_kept": [],
        "stages": [],
        "cached_stages": 0,
        "finishing": [],
    }
    assert "warning: not met: lamp_1 adjacent book_1" in describe(summary)
    assert 'warning: "zorple" is not in the lexicon' in describe(summary)


LOST = [
    {"words": "straight up", "start": 9, "end": 20, "status": "not_represented",
     "reason": "no path that rises"},
    {"words": "wags", "start": 25, "end": 29, "status": "not_understood", "reason": ""},
]  # fmt: skip


def test_words_that_are_not_shown_cannot_be_overlooked() -> None:
    """A block right below the outcome, and every statement with what was measured."""
    from esg.commands.generate import describe
    from esg.fidelity import block

    said = {"id": "s1", "says": "supported_by", "words": "on it", "start": 0, "end": 5}
    rows = [
        {**said, "status": "kept", "kept": True, "measured": {"share": 0.987654}, "reason": ""},
        {**said, "status": "broken", "kept": False, "measured": {}, "reason": "in the air"},
    ]
    event = {"id": "e1", "type": "moves", "completed": True, "time_s": 1.0, "bodies": ["a"],
             "reason": ""}  # fmt: skip
    summary = {
        "outcome": "partial", "folder": "runs/x", "reason": "the same again", "advice": "say more",
        "metrics": {"events": [event], "constraints": [], "slr": True, "dt_s": 1 / 240},
        "proof": "class", "coverage": {"warnings": [], "not_understood": []}, "stages": [],
        "relations_not_met": [], "cached_stages": 0, "statements": rows, "not_kept": LOST,
        "finishing": [],
        "plausibility": {"plausible": False, "worst": "a: braking 20 m/s2, limit 7.8", "checks": []},
    }  # fmt: skip
    lines = describe(summary).splitlines()
    assert lines[:5] == [
        "partial: runs/x",
        "  !! NOT ALL OF THE PROMPT IS IN THIS SCENE:",
        '  !!   "straight up"  not represented: no path that rises',
        '  !!   "wags"         not understood',
        "  say more",
    ]
    assert '  kept     "on it" (supported by): share 0.988' in lines
    assert '  BROKEN   "on it" (supported by)' in lines
    assert "  implausible: a: braking 20 m/s2, limit 7.8" in lines
    assert block([], "draft") == []


def test_a_draft_says_what_it_does_not_hold(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from esg.commands.draft import draft
    from esg.draft import draft as made
    from esg.graph.models import Statement

    prompt = "A ball rolls straight up and hits a box."
    place = {"text": "straight up", "start": 13, "end": 24}
    said = {"id": "s1", "predicate": "not_represented", "note": "no path", **place}
    doc = made(prompt).model_copy(update={"statements": (Statement.model_validate(said),)})
    monkeypatch.setattr("esg.draft.draft", lambda *_, **__: doc)
    assert draft(prompt) == 0
    assert '  !!   "straight up"  not represented: no path' in capsys.readouterr().out
    assert draft(prompt, json=True) == 0
    told = json.loads(capsys.readouterr().out)
    assert [r["status"] for r in told["statements"]] == ["not_represented"]
    assert [r["words"] for r in told["not_kept"]] == ["straight up"]


def test_a_draft_shows_colours_and_who_a_statement_is_about(
    capsys: pytest.CaptureFixture[str],
) -> None:
    from esg.commands.draft import draft

    assert draft("A red ball of steel rolls to the left. Five cups stand behind a white tent.") == 0
    lines = capsys.readouterr().out.splitlines()
    assert 'object:    red_ball_1  "red ball of steel", red, steel' in lines
    assert any(line.startswith("object:    cup_1 ... cup_5 (5)  ") for line in lines)
    assert 'statement: s2  moves(red_ball_1) left  "to the left"' in lines
    assert not any("ground_1" in line for line in lines if line.startswith("object:"))


def test_strict_counts_partial_scenes_as_failed(tmp_path: Path) -> None:
    from esg.failures import FILE, report_failures
    from esg.outcomes import Outcome
    from esg.pipeline import SceneRequest, SceneState
    from esg.runs import exit_code

    partial = [SceneState(SceneRequest("x"), outcome=Outcome.PARTIAL, reason='broken: "y"')]
    assert (exit_code(partial, True), exit_code(partial, True, strict=True)) == (0, 3)
    solved = [SceneState(SceneRequest("x"), outcome=Outcome.SOLVED)]
    assert exit_code(solved, True, strict=True) == 0
    assert (exit_code(solved, False), exit_code(partial, False, strict=True)) == (1, 1)
    report_failures(partial, [tmp_path / "x"], tmp_path)
    assert not (tmp_path / FILE).exists()
    report_failures(partial, [tmp_path / "x"], tmp_path, strict=True)
    assert json.loads((tmp_path / FILE).read_text())["outcome"] == "partial"


def test_a_default_heading_is_no_wish_that_was_not_met(tmp_path: Path) -> None:
    """What nothing turns is drafted to face the front; who asked for none is told of none."""
    from esg.commands.generate import summarize
    from esg.outcomes import Outcome
    from esg.pipeline import SceneRequest, SceneState

    def edge(subject: str, target: str, confidence: float) -> dict[str, object]:
        wish = {"from": subject, "to": target, "relation_type": "face"}
        return wish | {"confidence": confidence}

    edges = [edge("car_1", "ground_1", 0.5), edge("dog_1", "car_1", 0.8)]
    names = [f"{e['from']} face {e['to']}" for e in edges]
    document = {
        "spatial_relation_graph": {"edges": {"binary_relations": edges}},
        "layout_result": {"relations": [{"edge": n, "satisfied": False} for n in names]},
    }
    (tmp_path / "esg.json").write_text(json.dumps(document))
    state = SceneState(SceneRequest("x"), outcome=Outcome.SOLVED)
    assert summarize(state, tmp_path)["relations_not_met"] == ["dog_1 face car_1"]


def test_a_cache_that_cannot_be_written_is_told_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path / "file" / "cache"))
    suite = str(ROOT / "data" / "suites" / "paper.yaml")
    lines = (["generate", "A ball."], ["bench", suite], ["setup"], ["serve", "--once"])
    for line in (*lines, ["dataset", "--sample", "2", "--out", "d"]):
        done = esg(*line, cwd=tmp_path)
        assert done.returncode == 1, done.stderr
        assert "the cache folder (ESG_CACHE_DIR)" in done.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["file"]
