"""One motion in every format gets the verdict of the replay that it was taken from."""

from __future__ import annotations

from pathlib import Path
import shutil
import subprocess
import sys

import numpy as np
import pytest

import esg
from esg.engines.scene import Rollout, SimScene
from esg.judging.verdict import judge_file, scene_for
from esg.metrics import judge, load_suite
from tests.judging import worlds

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def motion() -> tuple[SimScene, Rollout]:
    return worlds.played()


@pytest.mark.parametrize("form", worlds.WRITERS)
def test_every_format_gets_the_verdict_of_the_run(
    form: str, motion: tuple[SimScene, Rollout], tmp_path: Path
) -> None:
    scene, rollout = motion
    truth = judge(scene, worlds.PROGRAM, rollout, worlds.SCENE)
    found = judge_file(worlds.WRITERS[form](tmp_path, scene, rollout), worlds.SCENE)
    assert truth.verified and truth.completed == 2
    assert [e.completed for e in found.verdict.events] == [True, True]
    for ours, theirs in zip(found.verdict.events, truth.events, strict=True):
        assert ours.time_s == pytest.approx(theirs.time_s, abs=1 / 60 + 1e-6)
        assert ours.bodies and len(ours.bodies) == len(theirs.bodies)
    assert found.verdict.slr == truth.slr is True
    assert [c.score for c in found.verdict.constraints] == [c.score for c in truth.constraints]
    assert found.hz == pytest.approx(60.0, rel=1e-3)
    assert any("contacts are recomputed" in note for note in found.notes)
    blows = [
        r.contacts.impulse[r.contacts.time < r.contacts.time[0] + 0.05].sum()
        for r in (found.rollout, rollout)
    ]
    assert blows[0] == pytest.approx(blows[1], rel=0.2)


def test_a_scene_folder_s_replay_is_judged_as_it_was_recorded(
    motion: tuple[SimScene, Rollout], tmp_path: Path
) -> None:
    from esg.engines.manifest import manifest_bytes, manifest_to_json
    from esg.engines.rollout_file import save_rollout

    scene, rollout = motion
    manifest = manifest_to_json(scene, worlds.PROGRAM, dt=rollout.dt)
    (tmp_path / "manifest.json").write_bytes(manifest_bytes(manifest))
    save_rollout(rollout, tmp_path / "rollout.npz")
    found = judge_file(tmp_path / "rollout.npz", worlds.SCENE)
    assert found.verdict == judge(scene, worlds.PROGRAM, rollout, worlds.SCENE)
    assert found.notes == ()


def test_a_stranger_s_axes_and_units_are_turned(
    motion: tuple[SimScene, Rollout], tmp_path: Path
) -> None:
    scene, rollout = motion
    rows, facts = worlds.rows(scene, rollout), worlds.facts(scene)
    for row in rows:
        x, y, z = row["x"], row["y"], row["z"]
        row |= {"x": 100 * x, "y": -100 * y, "z": 100 * z}
        row |= {"qx": -row["qx"], "qz": -row["qz"]}
    for fact in facts:
        fact |= {key: 100 * fact[key] for key in ("size_x", "size_y", "size_z")}
    worlds.write_table(tmp_path / "S1.csv", rows)
    worlds.write_table(tmp_path / "S1.bodies.csv", facts)
    found = judge_file(tmp_path / "S1.csv", worlds.SCENE, frame="unreal")
    plain = judge_file(worlds.csv_file(tmp_path, scene, rollout), worlds.SCENE)
    assert found.verdict.model_dump() == plain.verdict.model_dump()
    assert found.verdict.completed == 2
    np.testing.assert_allclose(
        found.rollout.angular_velocity, plain.rollout.angular_velocity, atol=1e-4
    )


def test_what_goes_through_a_thing_unhindered_has_not_hit_it(tmp_path: Path) -> None:
    """The poses alone would let a ball tunnel through the crate: nothing slows it down."""
    scene, rollout = worlds.played()
    position = rollout.position.copy()
    position[0, :, 0] = (3.0 * rollout.time)[:, None] * [1, 0, 0] + position[0, 0, 0]
    position[0, :, 1:] = position[0, 0, 1:]
    ghost = Rollout(**{**vars(rollout), "position": position})
    found = judge_file(worlds.csv_file(tmp_path, scene, ghost), worlds.SCENE)
    assert [e.completed for e in found.verdict.events] == [True, False]


def test_a_mass_that_no_file_gives_is_no_measurement(
    motion: tuple[SimScene, Rollout], tmp_path: Path
) -> None:
    scene, rollout = motion
    path = worlds.csv_file(tmp_path, scene, rollout)
    facts = [fact | {"mass": ""} for fact in worlds.facts(scene)]
    worlds.write_table(tmp_path / "S1.bodies.csv", facts)
    mass = judge_file(path, worlds.SCENE).verdict.constraints[0]
    assert (mass.measured, mass.score) == (None, 0.0) and "no mass" in mass.reason


def test_contacts_of_the_file_count_where_it_has_some(
    motion: tuple[SimScene, Rollout], tmp_path: Path
) -> None:
    scene, rollout = motion
    path = worlds.csv_file(tmp_path, scene, rollout)
    row = {"time": 0.6, "a": "crate_1", "b": "ball_1", "impulse": 0.05, "depth": 0.0}
    worlds.write_table(tmp_path / "S1.contacts.csv", [row])
    weak = judge_file(path, worlds.SCENE)
    assert "0.1" in weak.verdict.events[1].reason and not weak.verdict.events[1].completed
    worlds.write_table(tmp_path / "S1.contacts.csv", [row | {"impulse": 5.0}])
    assert judge_file(path, worlds.SCENE).verdict.events[1].time_s == 0.6


def test_words_for_bodies_bind_what_a_file_calls_otherwise(
    motion: tuple[SimScene, Rollout], tmp_path: Path
) -> None:
    scene, rollout = motion
    rows = [row | {"body": f"Mesh.{row['body'][0]}"} for row in worlds.rows(scene, rollout)]
    facts = [
        fact | {"body": f"Mesh.{fact['body'][0]}", "label": ""} for fact in worlds.facts(scene)
    ]
    worlds.write_table(tmp_path / "S1.csv", rows)
    worlds.write_table(tmp_path / "S1.bodies.csv", facts)
    (tmp_path / "suite.yaml").write_text(worlds.SUITE)
    unnamed = esg.judge_trajectories(tmp_path / "S1.csv", tmp_path / "suite.yaml")
    assert not unnamed.verdict.slr and unnamed.verdict.completed == 0
    words = {"Mesh.b": "red ball", "Mesh.c": "crate"}
    named = esg.judge_trajectories(tmp_path / "S1.csv", tmp_path / "suite.yaml", names=words)
    assert named.verdict.slr and named.verdict.completed == 2
    with pytest.raises(esg.UserError, match="'Cube', which is no body of it; it has Mesh"):
        esg.judge_trajectories(tmp_path / "S1.csv", tmp_path / "suite.yaml", names={"Cube": "x"})


def test_a_file_s_name_or_its_folder_s_tells_the_scene() -> None:
    suite = load_suite("paper")
    for name in ("S6.glb", "s6-run2.csv", "x/S6-run0/scene.usda", "S6_3.parquet"):
        assert scene_for(Path(name), suite).id == "S6"
    assert scene_for(Path("motion.csv"), suite, "s10").id == "S10"
    with pytest.raises(esg.UserError, match="give --scene ID, one of S1, S2"):
        scene_for(Path("motion.csv"), suite)


def command(*arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "esg", "judge", *map(str, arguments)],
        capture_output=True, text=True, cwd=ROOT, check=False,
    )  # fmt: skip


def test_the_command_judges_one_file_and_tables_several(
    motion: tuple[SimScene, Rollout], tmp_path: Path
) -> None:
    path = worlds.csv_file(tmp_path, *motion)
    suite = tmp_path / "suite.yaml"
    suite.write_text(worlds.SUITE + worlds.SUITE.split("scenes:")[1].replace("S1", "S2"))
    one = command("--trajectories", path, "--suite", suite)
    assert one.returncode == 0 and "layout valid, 2 of 2 events" in one.stdout, one.stderr
    for end in (".csv", ".bodies.csv"):
        shutil.copy(tmp_path / f"S1{end}", tmp_path / f"S1-run1{end}")
    many = command("--trajectories", path, tmp_path / "S1-run1.csv", "--suite", suite)
    assert many.returncode == 3
    assert "| Judged" in many.stdout and "2.0 ± 0.0" in many.stdout
    assert "2 files; 2 runs have none and count as failed" in many.stdout
