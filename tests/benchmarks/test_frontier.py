"""The driver that scores a model through request files."""

from __future__ import annotations

import asyncio
from collections import Counter
import json
from pathlib import Path
import re

import pytest

from benchmarks import frontier
from benchmarks.answers import KeptAnswers
from esg.draft.llm.client import Call, ModelFailure
from esg.draft.llm.scripted import ScriptedModel


def answered(folder: Path) -> None:
    """Answers the open requests as the rules drafter would."""
    model, out = ScriptedModel(0.0, 0.0), list[str]()
    for text in (folder / "requests.jsonl").read_text().splitlines():
        request = json.loads(text)
        talk = [(m["role"], m["content"]) for m in request["body"]["messages"][1:]]
        answer = model.answer(request["custom_id"].partition("-")[0], talk)
        message = {"choices": [{"message": {"content": answer}}], "model": "scripted"}
        row = {"custom_id": request["custom_id"], "response": {"body": message}}
        out.append(json.dumps(row) + "\n")
    (folder / f"answers-{len(list(folder.iterdir()))}.jsonl").write_text("".join(out))


def test_the_picked_prompts_are_those_of_the_file() -> None:
    """Pick the same prompts anywhere, so many of each set, and evenly for a part of them."""
    picked = frontier.pick()
    assert picked == json.loads(frontier.IDS.read_text())
    rows = frontier.rows_of()
    assert Counter(r["split"] for r in rows) == frontier.WANTED and len(rows) == 200
    assert len({r["id"] for r in rows}) == 200
    part = frontier.rows_of(60)
    assert Counter(r["split"] for r in part) == {
        "test": 18, "blind2": 18, "public": 12, "public_blind": 12
    }  # fmt: skip
    assert all(any(r["id"] == p["id"] for r in rows) for p in part)


def test_answers_become_a_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Wait with exit code 3, write texts for people, then print the model beside the rules."""
    line = [str(tmp_path), "--variants", "no_validation", "--of", "10"]
    assert frontier.main([*line, "--handout", "2"]) == 3
    folder = tmp_path / "no_validation"
    asked = re.findall(r'"custom_id": "([^"]+)"', (folder / "requests.jsonl").read_text())
    texts = [p.read_text() for p in sorted((folder / "handout").iterdir())]
    assert len(texts) == 2 and sum(t.count("## scene-r0-") for t in texts) == len(asked) == 10
    assert all(t.count("Conventions that hold everywhere") == 1 for t in texts)
    answered(folder)
    assert frontier.main(line) == 3
    answered(folder)
    target = tmp_path / "table.json"
    assert frontier.main([*line, "--json", str(target)]) == 0
    told = json.loads(target.read_text())
    assert told["prompts"] == 10
    ours = told["drafters"]["no_validation"]
    assert ours["all"]["models"] == ["scripted"] and ours["public"]["prompts"] == 4
    assert 1.0 <= ours["all"]["replies"] <= 2.0 and ours["all"]["rounds"] == 0.0
    # The scripted model says what the rules say, so it scores as they do.
    rules = told["drafters"]["rules"]["all"]
    assert ours["all"]["event_recall"] == rules["event_recall"]
    assert "paper, no_validation: usability 88.5" in capsys.readouterr().out


def test_what_repairs_is_counted() -> None:
    """Count a code as gone when neither the next complaint nor the final draft has it."""
    from esg.draft.llm.records import LlmDraft
    from esg.outcomes import Outcome

    made = LlmDraft("x", Outcome.SOLVED, "", None, told=(("A", "B"), ("B",)))
    assert frontier.mended([made]) == {
        "B": {"told": 2, "gone": 1},
        "A": {"told": 1, "gone": 1},
    }


class Words:
    """Stands for a tokenizer: a token a word."""

    def __call__(self, text: str) -> int:
        return len(text.split())


def test_kept_answers_outlive_a_change_of_the_instructions(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Find answers by their messages, say to how many other instructions belong, count tokens."""
    kept = Path("benchmarks/results/frontier/full.jsonl")
    monkeypatch.setattr(frontier, "counter", Words)
    target = tmp_path / "table.json"
    line = [str(tmp_path), "--answers", str(kept), "--of", "10", "--json", str(target)]
    assert frontier.main([*line, "--tokens"]) == 0
    told = json.loads(target.read_text())["drafters"]["full"]["all"]
    wrong = told["causes"].get("any", {"drafts": 0, "silent": 0})
    public = json.loads(target.read_text())["drafters"]["full"]["public"]["prompts"]
    assert wrong["drafts"] == round(public * (100.0 - told["fully_right"]) / 100.0)
    assert wrong["silent"] == round(public * told["silent_wrong"] / 100.0)
    assert told["usability"] == 100.0 and told["tokens_in"] > 10 * told["tokens_out"] > 0
    exact, other = map(
        int, re.findall(r"full: (\d+) requests .*, (\d+) with", capsys.readouterr().out)[0]
    )
    assert exact + other >= 15
    record = json.loads(kept.read_text(encoding="utf-8").splitlines()[0])
    answers = KeptAnswers(kept)
    asked = Call(record["stage"], "", "told otherwise", tuple(map(tuple, record["messages"])))
    assert asyncio.run(answers.complete(asked)).text == record["reply"]["text"]
    assert (answers.exact, answers.other) == (0, 1)
    with pytest.raises(ModelFailure, match="holds no answer"):
        asyncio.run(answers.complete(Call("scene", "", "", (("user", "Something else."),))))
