"""Rows of other engines and of what-ifs: what agrees, what no longer happens, what failed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from esg.dataset.plan import DatasetSpec
from esg.dataset.whatifs import outcomes, what_if_statistics
from esg.dataset.whatifs.amounts import amount_named
from esg.dataset.whatifs.options import TruthOptions, spec_fields
from esg.dataset.whatifs.outcomes import Asked, alternatives, failed_rows
from esg.dataset.whatifs.replaying import play
from esg.dataset.whatifs.worlds import Part, changed_by, unchanged
from esg.engines.manifest import Manifest
from esg.engines.program import AdjustProperties, HoldVelocity, Program, SetVelocity
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from esg.metrics import SuiteEvent, SuiteScene
from esg.metrics.models import EventVerdict
from esg.outcomes import UserError
from esg.store.tables import to_table, write_part
from tests.metrics.worlds import DT, ball, body

EXPECTED = SuiteScene(
    id="s", prompt="p", events=(SuiteEvent(id="e1", type="collision", a="=ball_1", b="=ball_2"),)
)
KEYS = {"run_id": "r", "suite": "", "scene_id": "s", "seed": 0}


@pytest.fixture(autouse=True)
def without_newton(monkeypatch: pytest.MonkeyPatch) -> None:
    """Newton compiles for half a minute; Rapier stands in for it."""

    def quick(name: str) -> object:
        return get_engine("rapier" if name == "newton" else name)

    monkeypatch.setattr("esg.dataset.whatifs.replaying.get_engine", quick)


def balls() -> Manifest:
    scene = SimScene(
        "s",
        (ball("ball_1", position=(0.0, 0.0, 0.1)), ball("ball_2", position=(0.6, 0.0, 0.1))),
    )
    roll = SetVelocity("ball_1", 0.0, (2.0, 0.0, 0.0), (0.0, 20.0, 0.0))
    return Manifest(scene, Program((roll,), 1.0), (), DT)


def rows(asked: Asked, manifest: Manifest | None = None, expected: SuiteScene = EXPECTED):
    taking_part = [b.name for b in (manifest or balls()).scene.bodies]
    return alternatives(manifest or balls(), expected, taking_part, asked, name="s", seed=0)


def test_every_engine_at_two_steps_is_a_row_an_event() -> None:
    found = rows(Asked(engines=("physx", "rapier")))
    table = [(r["engine"], round(1 / r["dt_s"]), r["completed"]) for r in found.engine_events]
    assert sorted(table) == [(e, hz, True) for e in ("physx", "rapier") for hz in (240, 480)]
    assert all(r["agrees"] is True and r["time_s"] == pytest.approx(0.2, abs=0.02)
               for r in found.engine_events)  # fmt: skip
    assert found.what_ifs == [] and found.seconds["engines"] > 0.0


def test_the_base_of_a_pair_is_the_engines_own_row() -> None:
    found = rows(Asked(("speed",), ("physx",)))
    base = next(r for r in found.what_ifs if r["variable"] == "none" and r["engine"] == "physx")
    event = next(r for r in found.engine_events if r["dt_s"] == DT)
    assert base["event_times_s"] == [event["time_s"]] and base["apart_m"] == 0.0
    assert base["outcome"] == "unchanged"


def test_a_removed_ball_is_hit_no_more_and_ends_nowhere() -> None:
    found = rows(Asked(("remove",)))
    mine = [r for r in found.what_ifs if r["variable"] == "remove"]
    assert [r["outcome"] for r in mine] == ["other_events"] * 3
    for row in mine:
        assert row["body"] == "ball_2" and row["completed"] == [False] and row["agrees"] is True
        ends = row["final_position_m"]
        assert len(ends) == 6 and ends[3:] == [None] * 3 and None not in ends[:3]
        assert row["apart_m"] > 0.1


def test_missing_what_was_taken_away_is_no_event() -> None:
    missed = SuiteScene(
        id="s", prompt="p", events=(SuiteEvent(id="e1", type="misses", a="=ball_1", b="=ball_2"),)
    )
    row = next(r for r in rows(Asked(("remove",)), None, missed).what_ifs
               if r["variable"] == "remove")  # fmt: skip
    assert row["completed"] == [False]


def test_a_car_whose_brakes_fail_hits_the_post_all_the_same() -> None:
    """An event that follows one that no longer happens may still happen."""
    scene = SimScene(
        "s",
        (ball("ball_1", position=(0.0, 0.0, 0.1)),
         body("wall_1", position=(3.0, 0.0, 0.1), static=True)),
    )  # fmt: skip
    program = Program(
        (HoldVelocity("ball_1", 0.0, 0.3, 4.0, 0.0, roll_radius=0.1),
         AdjustProperties("ball_1", 0.3, braking=6.0)), 2.0,
    )  # fmt: skip
    expected = SuiteScene(id="s", prompt="p", events=(
        SuiteEvent(id="e1", type="brakes", object="=ball_1"),
        SuiteEvent(id="e2", type="collision", a="=ball_1", b="=wall_1", after=("e1",)),
    ))  # fmt: skip
    found = rows(Asked(("friction",)), Manifest(scene, program, (), DT), expected)
    row = next(r for r in found.what_ifs if r["variable"] == "friction")
    assert row["completed"] == [False, True], row


def test_a_car_at_twice_the_speed_hits_the_post_before_it_brakes() -> None:
    scene = SimScene(
        "s",
        (ball("ball_1", position=(0.0, 0.0, 0.1)),
         body("wall_1", position=(2.4, 0.0, 0.1), static=True)),
    )  # fmt: skip
    program = Program(
        (HoldVelocity("ball_1", 0.0, 0.4, 4.0, 0.0, roll_radius=0.1),
         AdjustProperties("ball_1", 0.4, braking=11.0)), 2.0,
    )  # fmt: skip
    expected = SuiteScene(id="s", prompt="p", events=(
        SuiteEvent(id="e1", type="brakes", object="=ball_1"),
        SuiteEvent(id="e2", type="collision", a="=ball_1", b="=wall_1", after=("e1",)),
    ))  # fmt: skip
    double = amount_named("speed", "double")
    part = Part(scene, program, ("ball_1",), "s/0")
    base, fast = unchanged(scene, program), changed_by(part, double)
    played = play([base, fast], "physx", DT)
    judged = {id(p): outcomes._judged(p, expected) for p in played}
    assert [e.completed for e in judged[id(played[0])]] == [True, True]
    loose = outcomes._without_order(played[:1], judged, expected)
    found = outcomes._judged_freely(played[1], loose)
    assert found[1].completed and (found[1].time_s or 9.0) < 0.4


def test_a_second_hit_of_the_same_two_keeps_its_place() -> None:
    twice = SuiteScene(id="s", prompt="p", events=(
        SuiteEvent(id="e1", type="moves", object="=ball_1"),
        SuiteEvent(id="e2", type="stops", object="=ball_1", after=("e1",)),
    ))  # fmt: skip
    early = [EventVerdict(id="e1", type="moves", completed=True, time_s=1.0),
             EventVerdict(id="e2", type="stops", completed=True, time_s=9.0)]  # fmt: skip
    (base,) = play([unchanged(balls().scene, balls().program)], "physx", DT)
    loose = outcomes._without_order([base], {id(base): early}, twice)
    assert loose.events[1].after == ("e1",)


def test_what_cannot_be_changed_is_a_row_with_a_reason() -> None:
    still = balls()
    still = Manifest(still.scene, Program((), 0.5), (), DT)
    mine = [r for r in rows(Asked(("speed", "mass")), still).what_ifs if r["variable"] == "speed"]
    assert [r["outcome"] for r in mine] == ["not_applicable"] * 3
    assert all("nothing starts" in r["reason"] for r in mine)


def test_an_engine_that_fails_leaves_nulls_and_a_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(name: str) -> object:
        if name == "rapier":
            raise RuntimeError("no such library")
        return get_engine("physx")

    monkeypatch.setattr("esg.dataset.whatifs.replaying.get_engine", broken)
    found = rows(Asked(("mass",), ("physx", "rapier")))
    bad = [r for r in found.engine_events if r["engine"] == "rapier"]
    assert len(bad) == 2 and all(r["completed"] is None for r in bad)
    assert all(r["agrees"] is None and "no such library" in r["reason"] for r in bad)
    good = [r for r in found.engine_events if r["engine"] == "physx"]
    assert all(r["completed"] is True for r in good)
    failed = next(r for r in found.what_ifs if r["engine"] == "rapier" and r["variable"] == "mass")
    assert failed["outcome"] == "failed" and failed["completed"] is None


def test_a_scene_of_which_nothing_could_be_replayed_has_rows_too() -> None:
    found = failed_rows(Asked(("mass",), ("physx",)), "it ended the worker")
    assert {r["variable"] for r in found.what_ifs} == {"none", "mass"}
    assert {r["event_id"] for r in found.engine_events} == {""}
    assert all(r["reason"] for r in (*found.what_ifs, *found.engine_events))


def test_rows_fit_their_tables_and_add_up(tmp_path: Path) -> None:
    found = rows(Asked(("remove", "speed"), ("physx", "rapier", "newton")))

    def keyed(of: list[dict[str, Any]]) -> list[dict[str, Any]]:
        return [{**KEYS, "scene_key": f"r/-/s{k}/0", **r} for r in of for k in range(2)]

    for table, of in (("what_ifs", found.what_ifs), ("engine_events", found.engine_events)):
        write_part(to_table(table, keyed(of)), tmp_path / table / "train-00000-of-00001.parquet")
    facts = what_if_statistics(tmp_path)
    assert facts["what_ifs"]["remove"] == {
        "scenes": 2, "replayed": 2, "not_applicable": 0, "failed": 0, "agree": 2, "share": 1.0,
        "changed": 2,
    }  # fmt: skip
    assert facts["what_ifs_agree"] == 1.0 and facts["events_agree"] == 1.0
    assert {(e["engine"], e["events"], e["completed"]) for e in facts["engines"]} == {
        (e, 2, 2) for e in outcomes.ENGINES
    }
    assert what_if_statistics(tmp_path / "none") == {}


def test_options_name_what_they_do_not_know() -> None:
    fields = spec_fields(TruthOptions(what_if="speed, mass,speed", engines="newton,physx"))
    assert fields["what_if"] == ("mass", "speed") and fields["engines"] == ("physx", "newton")
    with pytest.raises(UserError, match="colour: choose from mass"):
        spec_fields(TruthOptions(what_if="mass,colour"))
    with pytest.raises(UserError, match="--engines bullet"):
        spec_fields(TruthOptions(engines="bullet"))


def test_a_dataset_without_them_keeps_its_name() -> None:
    plain = DatasetSpec(source="prompts", n=1)
    assert "what_if" not in plain.canonical() and "annotations" not in plain.canonical()
    asked = DatasetSpec(source="prompts", n=1, what_if=("mass",))
    assert asked.name() != plain.name() and '"what_if":["mass"]' in asked.canonical()
