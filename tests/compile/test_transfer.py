"""Replays of stored scenes in other engines and at other steps, and the commands around them."""

from __future__ import annotations

import datetime
import json
from pathlib import Path
import shutil

import pytest
import yaml

from esg.commands.export import export as export_command
from esg.commands.replay import matrix_table, replay, step_of
from esg.commands.stored import is_stored, open_scene, stored_rollout
from esg.compile import compile_scene, replay_class
from esg.compile.transfer import replay_scene, transfer_matrix
from esg.engines.manifest import load_manifest
from esg.graph import EsgDocument, canonical_json
from esg.metrics import expectations_from_timeline, judge
from esg.outcomes import UserError

PROMPT = "A bowling ball rolls into a pin."


@pytest.fixture(scope="module")
def doc() -> EsgDocument:
    """A scene with its first guess of the physics."""
    from esg.assets import resolve
    from esg.draft import draft
    from esg.dynamics import optimize, start_hints
    from esg.layout import solve

    resolved = resolve(draft(PROMPT))
    laid = solve(resolved, hints=start_hints(resolved, seed=0))
    solved = optimize(laid, seed=0, strategy="none")
    # As every stage reads it: from its canonical text, whose order of names is the bodies' order.
    return EsgDocument.model_validate_json(canonical_json(solved))


@pytest.fixture(scope="module")
def folder(doc: EsgDocument, tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("scenes") / "rolls"
    root.mkdir()
    (root / "prompt.txt").write_text(PROMPT)
    (root / "log.jsonl").write_text("")
    (root / "esg.json").write_bytes(canonical_json(doc))
    compile_scene(doc, root)
    return root


@pytest.fixture
def database(
    doc: EsgDocument, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Path:
    """A run database with the scene under two seeds and one that was never solved."""
    from esg.store import RunInfo, ingest, write_tables
    from esg.store.records import make_record

    now = datetime.datetime(2026, 1, 1, tzinfo=datetime.UTC)
    run = RunInfo(run_id="run", kind="bench", started_at=now, suite="s", strategy="none",
                  engine="physx", dt_s=1 / 240, seeds=2, version="1", code_version="x",
                  machine="m")  # fmt: skip
    rollout = replay_class(folder).rollout
    names = load_manifest(folder / "manifest.json").scene.names
    records = [
        make_record(
            run, scene_id=name, seed=seed, prompt=PROMPT, outcome=outcome,
            documents={"optimize": canonical_json(doc)} if outcome == "solved" else {},
            rollouts={"physx": rollout} if outcome == "solved" else {}, bodies=names,
        )
        for name, seed, outcome in (
            ("two seeds", 0, "solved"), ("two seeds", 1, "solved"), ("it's lost", 0, "crashed"),
        )
    ]  # fmt: skip
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ESG_DB", str(tmp_path / "esg.duckdb"))
    ingest(tmp_path / "esg.duckdb", write_tables(tmp_path / "parts", records, name="run").values())
    return tmp_path


def test_matrix_measures_against_the_reference(doc: EsgDocument, folder: Path) -> None:
    expected = expectations_from_timeline(doc)
    runs = transfer_matrix(folder, expected, engines=("rapier", "physx"), rates_hz=(120, 240))
    assert [(r.engine, r.rate_hz) for r in runs] == [
        ("rapier", 120), ("rapier", 240), ("physx", 120), ("physx", 240),
    ]  # fmt: skip
    assert [r.proof for r in runs] == ["program", "program", "class", "class"]
    reference = runs[-1]
    assert reference.apart_m == 0.0 and set(reference.late_s.values()) == {0.0}
    assert all(r.verdict.n_events == len(expected.events) > 0 for r in runs)
    collision = next(e.id for e in expected.events if e.type == "collision")
    when = {(r.engine, r.rate_hz): e.time_s for r in runs for e in r.verdict.events
            if e.id == collision}  # fmt: skip
    for r in runs:
        late = when[r.engine, r.rate_hz] - when["physx", 240]  # type: ignore[operator]
        assert r.late_s[collision] == pytest.approx(late)
        assert abs(late) <= 2 / 120
    assert runs[0].apart_m > 0.0


def test_matrix_equals_single_replays(doc: EsgDocument, folder: Path) -> None:
    expected = expectations_from_timeline(doc)
    [run] = transfer_matrix(folder, expected, engines=["physx"], rates_hz=[480])
    manifest = load_manifest(folder / "manifest.json")
    rollout = replay_class(folder, dt=1 / 480).rollout
    assert run.verdict == judge(manifest.scene, manifest.program, rollout, expected)
    # Without the reference among them, the first run is what the others are compared with.
    assert run.apart_m == 0.0


def test_unknown_engines_are_refused(doc: EsgDocument, folder: Path) -> None:
    with pytest.raises(UserError, match="bullet"):
        transfer_matrix(folder, expectations_from_timeline(doc), engines=["bullet"])


@pytest.mark.parametrize(
    ("hz", "dt", "step"),
    [(None, None, 1 / 240), (480, None, 1 / 480), (None, 0.005, 0.005), (200, 0.005, 0.005)],
)
def test_rate_and_step_say_the_same(hz: int | None, dt: float | None, step: float) -> None:
    assert step_of(hz, dt) == pytest.approx(step)


@pytest.mark.parametrize(
    ("hz", "dt", "message"),
    [
        (240, 0.005, "contradict"),
        (10, None, "--hz 10"),
        (None, 1.0, r"--dt 1\.0"),
        (None, 0.0, "--dt 0"),
        (None, float("nan"), "--dt nan"),
    ],
)
def test_impossible_steps_are_refused(hz: int | None, dt: float | None, message: str) -> None:
    with pytest.raises(UserError, match=message):
        step_of(hz, dt)


def test_compare_leaves_no_choice_of_engine_or_step(folder: Path) -> None:
    for more in ({"engine": "rapier"}, {"hz": 240}, {"dt": 0.01}):
        with pytest.raises(UserError, match="--compare"):
            replay(str(folder), compare=True, **more)  # type: ignore[arg-type]


def test_replay_prints_the_verdict(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code = replay(str(folder), engine="rapier", dt=1 / 480, json=True)
    result = json.loads(capsys.readouterr().out)
    assert result["engine"] == "rapier" and result["proof"] == "program"
    assert result["dt"] == pytest.approx(1 / 480)
    assert code == (0 if result["verdict"]["verified"] else 3)
    assert replay(str(folder)) == (0 if "NOT DONE" not in capsys.readouterr().out else 3)


def test_a_missed_event_is_exit_code_three(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A suite that asks for what does not happen."""
    event = {"id": "e1", "type": "misses", "a": "ball", "b": "pin"}
    suite = {"suite": "wrong", "scenes": [{"id": "W1", "prompt": PROMPT, "events": [event]}]}
    (tmp_path / "wrong.yaml").write_text(yaml.safe_dump(suite))
    assert replay(str(folder), suite=tmp_path / "wrong.yaml") == 3
    out = capsys.readouterr().out
    assert "NOT DONE" in out and "wrong W1" in out
    suite["scenes"][0]["prompt"] = "Something else."  # type: ignore[index]
    (tmp_path / "wrong.yaml").write_text(yaml.safe_dump(suite))
    with pytest.raises(UserError, match="no scene with the prompt"):
        replay(str(folder), suite=tmp_path / "wrong.yaml")


def test_the_table_has_a_line_per_run(doc: EsgDocument, folder: Path) -> None:
    expected = expectations_from_timeline(doc)
    runs = transfer_matrix(folder, expected, engines=["physx", "rapier"], rates_hz=[240])
    result = {
        "scene": "x",
        "judged_against": "timeline",
        "reference": {"engine": "physx", "hz": 240},
        "runs": [r.to_json() for r in runs],
    }
    lines = matrix_table(result).splitlines()
    assert len(lines) == 5
    assert lines[3].startswith("physx") and lines[4].startswith("rapier")
    assert all(e.id in lines[1] for e in expected.events)


def test_stored_scenes_come_back_byte_for_byte(folder: Path, database: Path) -> None:
    with open_scene("run/s/two seeds/1") as again:
        assert is_stored(again) and not is_stored(folder)
        for name in ("manifest.json", "esg.json", *(f"unreal/{p.name}" for p in
                     (folder / "unreal").iterdir())):  # fmt: skip
            assert (again / name).read_bytes() == (folder / name).read_bytes()
    assert not again.exists()


@pytest.mark.parametrize(
    ("scene", "message"),
    [
        ("two seeds", "names 2 stored scenes"),
        ("it's lost", "ended crashed"),
        ("run/s/none/0", "no scene folder"),
        ("x' OR 'a'='a", "no scene folder"),
    ],
)
def test_stored_scenes_that_cannot_be_opened(database: Path, scene: str, message: str) -> None:
    with pytest.raises(UserError, match=message), open_scene(scene):
        pass


def test_mcap_of_a_stored_scene_is_its_stored_trajectory(folder: Path, database: Path) -> None:
    from mcap.reader import make_reader

    key = "run/s/two seeds/0"
    stored, fresh = stored_rollout(key), replay_class(folder).rollout
    assert (stored.position == fresh.position).all()
    assert stored.contacts.time == pytest.approx(fresh.contacts.time, abs=1e-6)
    assert export_command(key, to="mcap", out=database / "out") == 0
    with (database / "out" / "rollout.mcap").open("rb") as file:
        summary = make_reader(file).get_summary()
    counts = {c.topic: summary.statistics.channel_message_counts[i]
              for i, c in summary.channels.items()}  # fmt: skip
    assert counts["/tf"] > 30 and counts["/events"] > 0
    with pytest.raises(UserError, match="give --out"):
        export_command(key, to="mcap")


def test_mcap_of_a_folder_without_a_whole_one_is_replayed(folder: Path, tmp_path: Path) -> None:
    """A log that was cut off is made again, not handed on."""
    copy = tmp_path / "rolls"
    shutil.copytree(folder, copy)
    log = copy / "rollout.mcap"
    assert export_command(str(copy), to="mcap") == 0
    whole = log.read_bytes()
    assert len(whole) > 10_000
    log.write_bytes(whole[: len(whole) // 2])
    assert export_command(str(copy), to="mcap") == 0
    assert log.read_bytes() == whole
    log.unlink()
    log.mkdir()
    with pytest.raises(UserError, match=r"rollout\.mcap is damaged \(a folder\)"):
        export_command(str(copy), to="mcap")


def test_a_damaged_class_is_named(folder: Path, tmp_path: Path) -> None:
    """Cut off, binary, or without its import manifest: one message, no traceback.

    Nobody has to trust it for that: whatever can be read of it is not ours, and its program is
    replayed instead.
    """
    manifest = load_manifest(folder / "manifest.json")
    header = next((folder / "unreal").glob("*.h")).name
    for number, (name, data) in enumerate(
        [
            (header, b""),
            (header, bytes(range(256))),
            ("imports.json", b"[]"),
            ("imports.json", b"[" * 100_000),
            ("imports.json", b'{"format": 3}'),
        ]
    ):
        copy = tmp_path / str(number)
        shutil.copytree(folder, copy)
        (copy / "unreal" / name).write_bytes(data)
        with pytest.raises(UserError, match="unreal"):
            replay_scene(copy, manifest, "physx", manifest.dt, trust="anything")
        if data != bytes(range(256)):
            rollout, proof = replay_scene(copy, manifest, "physx", manifest.dt)
            assert proof == "program" and name in str(rollout.extra["note"])


@pytest.mark.slow
def test_compare_runs_every_engine(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    replay(str(folder), compare=True, json=True)
    runs = json.loads(capsys.readouterr().out)["runs"]
    assert [(r["engine"], r["hz"]) for r in runs] == [
        (e, hz) for e in ("physx", "rapier", "newton") for hz in (120, 240, 480)
    ]
