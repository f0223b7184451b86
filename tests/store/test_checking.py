"""Data that knows when it is damaged: single flipped bits in tables, recordings and rollouts."""

from __future__ import annotations

import json
from pathlib import Path
import random

import pytest

from esg.commands.db import verify as command
from esg.files import TEMPORARY
from esg.outcomes import UserError
from esg.store import ingest, query, read_table, write_mcap, write_tables
from esg.store.checking import check_recording
from esg.store.tables import part_files
from esg.store.verifying import verify
from tests.store.samples import record, records, run_info, world

FLIPS = 120


@pytest.fixture
def runs(tmp_path: Path) -> Path:
    """A folder of runs as a command leaves it: parts, database, a recording and a rollout."""
    from esg.engines.rollout_file import save_rollout

    folder = tmp_path / "runs"
    write_tables(folder / "parts", records(run_info()), name="p")
    ingest(folder / "esg.duckdb", [folder / "parts"])
    made = world()
    scene = folder / "scene"
    scene.mkdir()
    save_rollout(made.rollout(), scene / "rollout.npz")
    write_mcap(scene / "rollout.mcap", made.scene, made.program, made.rollout())
    return folder


def flipped(data: bytes, rng: random.Random) -> bytes:
    out = bytearray(data)
    out[rng.randrange(len(out))] ^= 1 << rng.randrange(8)
    return bytes(out)


@pytest.mark.parametrize("table", ["scenes", "metrics", "trajectories"])
def test_no_flipped_bit_changes_what_a_table_says_unseen(table: str, runs: Path) -> None:
    """Of thirty in `scenes`, five changed results without a word."""
    (part,) = part_files(runs / "parts", table)
    whole, sound = part.read_bytes(), read_table(part)
    rng, seen = random.Random(table), 0
    for _ in range(FLIPS):
        part.write_bytes(flipped(whole, rng))
        try:
            assert read_table(part).equals(sound)
        except UserError as error:
            assert str(part) in str(error)
            seen += 1
    assert seen > FLIPS // 2


def test_a_damaged_part_is_not_ingested(runs: Path, tmp_path: Path) -> None:
    """DuckDB reads pages without looking at their checksums."""
    (part,) = part_files(runs / "parts", "scenes")
    whole, rng = part.read_bytes(), random.Random(7)
    sound = query(runs / "esg.duckdb", "SELECT * EXCLUDE artifacts FROM scenes ORDER BY ALL").rows
    for number in range(40):
        part.write_bytes(flipped(whole, rng))
        db = tmp_path / f"{number}.duckdb"
        try:
            ingest(db, [part])
        except UserError as error:
            assert "nothing was ingested" in str(error)
        else:
            rows = query(db, "SELECT * EXCLUDE artifacts FROM scenes ORDER BY ALL").rows
            assert rows == sound


def test_no_flipped_bit_changes_a_recording_unseen(runs: Path) -> None:
    from mcap.reader import make_reader

    path = runs / "scene" / "rollout.mcap"
    check_recording(path)
    whole, rng = path.read_bytes(), random.Random(1)

    def said() -> list[object]:
        with path.open("rb") as file:
            reader = make_reader(file)
            out: list[object] = [
                (c.topic, m.log_time, m.data) for _, c, m in reader.iter_messages()
            ]
            return out + [(a.name, a.data) for a in reader.iter_attachments()]

    sound = said()
    for _ in range(FLIPS):
        path.write_bytes(flipped(whole, rng))
        try:
            check_recording(path)
        except UserError:
            continue
        assert said() == sound


def test_verification_names_what_is_damaged_and_clears_what_killed_writers_left(
    runs: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    import os

    left = runs / "parts" / "scenes" / f".p.parquet.1-00000000{TEMPORARY}"
    left.write_bytes(b"x")
    os.utime(left, (0, 0))
    db = runs / "esg.duckdb"
    assert command(db=db, json=True) == 0
    told = json.loads(capsys.readouterr().out)
    assert (told["damaged"], told["leftovers"], left.exists()) == ([], 1, False)
    for path, at in ((runs / "scene" / "rollout.npz", 200), (runs / "scene" / "rollout.mcap", 400),
                     (part_files(runs / "parts", "scenes")[0], 100)):  # fmt: skip
        data = bytearray(path.read_bytes())
        data[at : at + 8] = bytes(b ^ 0xFF for b in data[at : at + 8])
        path.write_bytes(data)
    assert command(db=db) == 3
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].endswith("3 damaged")
    assert all("is damaged" in line for line in lines[1:])
    assert len(lines) == 4
    with pytest.raises(UserError, match="check the path"):
        verify(None, [runs / "nowhere"])


@pytest.mark.slow
def test_a_damaged_block_of_the_database_is_found(runs: Path) -> None:
    db = runs / "esg.duckdb"
    ingest(db, write_tables(runs / "more", [record(run_info("r2"), "S9", 0)], name="m").values())
    data, found = bytearray(db.read_bytes()), 0
    rng = random.Random(3)
    for _ in range(20):
        at = rng.randrange(len(data))
        data[at] ^= 16
        db.write_bytes(data)
        found += bool(verify(db, []).problems)
        data[at] ^= 16
    assert found > 0
