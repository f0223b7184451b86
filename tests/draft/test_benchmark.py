"""The drafting benchmark scores the blind prompts and keeps held-out misses closed."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from benchmarks import drafting
from benchmarks.drafting import __main__ as command
from benchmarks.drafting import corpus
from benchmarks.drafting.score import run
from esg.graph.models import EsgDocument
from esg.outcomes import UserError

FIELDS = {
    "collision": {"a", "b"},
    "turns": {"object", "direction"},
    "enters": {"object", "target"},
    "reaches": {"object", "target"},
    "misses": {"object", "target"},
} | {name: {"object"} for name in ("falls", "topples", "stops", "moves", "brakes")}
UNITS = {"mass": "kg", "speed": "m/s", "speed_before": "m/s", "speed_after": "m/s"}
UNITS |= {"acceleration": "m/s2", "angle": "degrees"}
UNITS |= dict.fromkeys(("size", "height", "distance"), "m")
UNITS |= dict.fromkeys(("time", "time_since", "time_to_stop"), "s")


@pytest.mark.parametrize(
    ("split", "ids", "bands"),
    [
        ("blind", [f"blind-{n:03d}" for n in range(1, 151)], (40, 30, 40, 40)),
        ("blind2", [f"held-{n:03d}" for n in range(1, 151, 2)], (15, 15, 23, 22)),
    ],
)
def test_blind_labels_are_well_formed(split: str, ids: list[str], bands: tuple[int, ...]) -> None:
    """Known types and fields; whatever an event or a quantity is of is among the objects."""
    rows = drafting.load(split)
    assert [r["id"] for r in rows] == ids
    assert tuple(sum(r["band"] == b for r in rows) for b in drafting.BANDS) == bands
    for row in rows:
        assert row["split"] == split
        known = {o["phrase"] for o in row["objects"]}
        # A table's pocket is part of the table; the corpus does not list it.
        assert known and all(o.get("count", 2) >= 2 for o in row["objects"]), row["id"]
        for event in row["events"]:
            fields = set(event) - {"type", "each"}
            assert fields == FIELDS[event["type"]], (row["id"], event)
            assert event.get("direction", "any") in ("left", "right", "any")
            named = {event[f] for f in fields - {"direction"}}
            assert named <= known | {"pocket"}, (row["id"], event)
        types = {e["type"] for e in row["events"]}
        for want in row["constraints"]:
            assert want["unit"] == UNITS[want["quantity"]], (row["id"], want)
            assert ("value" in want) != ("range" in want)
            assert want["event"] in types if "event" in want else want["object"] in known


@pytest.mark.parametrize("split", drafting.BLIND)
def test_blind_prompts_are_new_and_no_part_of_all(split: str) -> None:
    """No blind prompt is in the rest of the corpus, and `all` stays what it was."""
    old = {r["prompt"].lower() for r in drafting.load("all")}
    blind = [r["prompt"].lower() for r in drafting.load(split)]
    assert len(set(blind)) == len(blind) and not old & set(blind)
    assert {r["split"] for r in drafting.load("all")} == {"dev", "test"}


@pytest.mark.parametrize("option", [["--show"], ["--unsaid", "3"]])
@pytest.mark.parametrize("split", [*corpus.HELD_OUT, "all", None])
def test_misses_of_held_out_prompts_stay_closed(
    split: str | None, option: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    """Exit code 2 and one line, before anything is drafted; the default split is held out too."""
    with pytest.raises(SystemExit) as end:
        command.main([*option, "--no-ablation", *(["--split", split] if split else [])])
    assert end.value.code == 2
    printed = capsys.readouterr()
    assert "--open-held-out" in printed.err and not printed.out


@pytest.fixture
def refusing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A corpus of one blind prompt, and a drafter that refuses it."""
    row = {"id": "blind-001", "band": "single", "split": "blind", "prompt": "A pear hits a jug."}
    row |= {"objects": [{"phrase": "pear"}], "events": [], "constraints": []}
    (tmp_path / "blind.jsonl").write_text(json.dumps(row) + "\n", encoding="utf-8")

    def refuse(prompt: str, **_: object) -> EsgDocument:
        raise UserError(f"no {prompt}")

    monkeypatch.setattr(corpus, "PROMPTS", tmp_path)
    monkeypatch.setattr(command, "run", lambda split, _, files: run(split, refuse, files))


@pytest.mark.usefixtures("refusing")
def test_totals_show_no_miss_and_the_explicit_word_opens_them(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Without --show only numbers are printed; --open-held-out lists the misses."""
    blind = ["--split", "blind", "--no-ablation"]
    assert command.main(blind) == 0
    closed = capsys.readouterr().out
    assert "split blind" in closed and "pear" not in closed
    assert command.main([*blind, "--show", "--open-held-out"]) == 0
    assert "blind-001 refused" in capsys.readouterr().out


def test_the_wide_prompts_are_labelled_for_development_alone() -> None:
    rows = drafting.load("dev", ["wide"])
    assert len(rows) == 160 and not drafting.load("test", ["wide"])
    assert {r["id"] for r in rows} < {r["id"] for r in drafting.load("dev")}
    assert [r["id"] for r in rows] == [f"wide-{i:03d}" for i in range(1, 161)]
    for row in rows:
        assert row["band"] in drafting.BANDS and row["objects"] and row["events"], row["id"]
        for event in row["events"]:
            assert set(event) - {"type", "each"} == FIELDS[event["type"]], row["id"]
        for want in row["constraints"]:
            assert UNITS[want["quantity"]] == want["unit"], row["id"]
            assert ("value" in want) != ("range" in want), row["id"]


@pytest.mark.parametrize(("name", "count"), [("prose", 122), ("prose2", 40)])
def test_the_prose_prompts_are_labelled_for_development_alone(name: str, count: int) -> None:
    rows = drafting.load("dev", [name])
    assert not drafting.load("test", [name])
    assert [r["id"] for r in rows] == [f"{name}-{i:03d}" for i in range(1, count + 1)]
    for row in rows:
        assert row["band"] in drafting.BANDS and row["objects"], row["id"]
        for event in row["events"]:
            assert set(event) - {"type", "each"} == FIELDS[event["type"]], row["id"]
        for want in row["constraints"]:
            assert UNITS[want["quantity"]] == want["unit"], row["id"]
            assert ("value" in want) != ("range" in want), row["id"]
