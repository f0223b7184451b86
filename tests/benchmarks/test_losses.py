"""Simulated power losses: what was forced to the disk survives them, what was not may not."""

from __future__ import annotations

import os
from pathlib import Path
import random
import shutil
import subprocess
import sys

import pytest

from benchmarks.faults import diary, losses
from benchmarks.faults.shims import compiled

ROOT = Path(__file__).parents[2]
SAFE = """
from pathlib import Path
from esg.files import atomic_file
for number in range(3):
    with atomic_file(Path("a/b/result.txt")) as file:
        file.write(str(number).encode() * 10000)
"""
UNSAFE = """
from pathlib import Path
Path("a/b").mkdir(parents=True)
for number in range(3):
    Path("a/b/aside").write_bytes(str(number).encode() * 10000)
    Path("a/b/aside").replace("a/b/result.txt")
"""
FINISHED = """
from pathlib import Path
from esg.dataset.finish import clean
clean(Path("data"))
"""
OLD = ("data/meta/info.json", "data/parts/scenes/0.parquet", "data/marks/0.json", "data/locks/0")
WHOLE = {b"", *(str(number).encode() * 10000 for number in range(3))}

pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or shutil.which("cc") is None, reason="needs Linux and a C compiler"
)


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return compiled("losses", tmp_path_factory.mktemp("library"))


def failed(code: str, at: int, seed: int, folder: Path, library: Path) -> int:
    """Does to `folder / "place"` what a loss at an operation does; how many there were.

    Before, the place holds `OLD` alone.
    """
    place, journal = folder / "place", folder / "journal"
    for path in (place, journal):
        shutil.rmtree(path, ignore_errors=True)
    for name in OLD:
        (place / name).parent.mkdir(parents=True, exist_ok=True)
        (place / name).write_text("old")
    shutil.copytree(place, folder / "pristine", dirs_exist_ok=True)
    before = losses.scanned(place)
    losses.open_journal(journal)
    variables = losses.variables(place, library, journal, at)
    done = subprocess.run([sys.executable, "-c", code], cwd=place, check=False,
                          env={**os.environ, "PYTHONPATH": str(ROOT), **variables})  # fmt: skip
    assert done.returncode == (-9 if at else 0)
    losses.lose(place, before, journal, folder / "pristine", random.Random(seed))
    return losses.operations(journal)


def lost(code: str, at: int, seed: int, folder: Path, library: Path) -> tuple[bytes, int]:
    """What is left of the result after a loss at an operation, and how many there were."""
    operations = failed(code, at, seed, folder, library)
    assert all((folder / "place" / name).read_text() == "old" for name in OLD)
    path = folder / "place" / "a" / "b" / "result.txt"
    return path.read_bytes() if path.exists() else b"", operations


def test_what_was_done_is_there(tmp_path: Path, library: Path) -> None:
    for seed in range(5):
        assert lost(SAFE, 0, seed, tmp_path, library)[0] == b"2" * 10000


def test_what_was_being_done_is_whole_or_as_before(tmp_path: Path, library: Path) -> None:
    _, count = lost(SAFE, 0, 0, tmp_path, library)
    assert count > 15
    for at in range(1, count, 3):
        assert lost(SAFE, at, at, tmp_path, library)[0] in WHOLE


def test_what_was_not_forced_is_lost_or_torn(tmp_path: Path, library: Path) -> None:
    """Otherwise the simulation would find nothing."""
    found = {lost(UNSAFE, 0, seed, tmp_path, library)[0] for seed in range(30)}
    assert b"" in found
    assert found - WHOLE


def test_what_a_finished_dataset_removes_stays_away(tmp_path: Path, library: Path) -> None:
    for seed in range(5):
        failed(FINISHED, 0, seed, tmp_path, library)
        assert [p.name for p in (tmp_path / "place" / "data").iterdir()] == ["meta"]


def entry(number: int, wrong: str = "", operations: int = 8) -> diary.Entry:
    return diary.Entry("report", 1, number, operations, losses.Loss(number > 1, 3 * number, wrong))


def test_losses_are_kept_as_they_end(tmp_path: Path) -> None:
    """A run that is stopped leaves what it has."""
    log = tmp_path / "runs" / "losses.jsonl"
    assert diary.entries(log) == []
    diary.append(log, entry(0))
    diary.append(log, entry(1, "k.html is gone"))
    assert diary.entries(log) == [entry(0), entry(1, "k.html is gone")]


def test_losses_of_several_runs_add_up() -> None:
    found = [entry(0), entry(1, "k.html is gone", 9), entry(2)]
    ((cells, bad),) = diary.rows(found, ("db ingest", "report"))
    assert cells == ("report", "8 to 9", 3, 1, 2, 2)
    assert bad == ["report:1 of seed 1: k.html is gone"]
