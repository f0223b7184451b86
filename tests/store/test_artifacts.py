"""Stage artifacts: whole or absent, never half, never damaged."""

from __future__ import annotations

from collections import OrderedDict
import errno
import multiprocessing
import os
from pathlib import Path

import pytest

from esg.pipeline import artifact_store, scratch_store
from esg.store import artifacts as module
from esg.store.artifacts import MARK, ArtifactStore, artifact_key


def key(name: str = "a", **more: object) -> str:
    values = {"inputs": {"draft": name}, "config": {"seed": 1}, "code_version": "v1"}
    return artifact_key("layout", **{**values, **more})  # type: ignore[arg-type]


def fill(text: str):
    def write(folder: Path) -> None:
        (folder / "sub").mkdir()
        (folder / "sub" / "b.bin").write_bytes(bytes(100))
        (folder / "a.txt").write_text(text)

    return write


@pytest.fixture
def store(tmp_path) -> ArtifactStore:
    return ArtifactStore(tmp_path / "artifacts")


def test_key_depends_on_everything_and_on_nothing_else():
    base = key()
    assert base == key()
    assert base.startswith("layout-")
    assert len({base, key("b"), key(config={"seed": 2}), key(code_version="v2")}) == 4
    assert artifact_key("draft", inputs={}, config={"a": 1, "b": 2}, code_version="x") == (
        artifact_key("draft", inputs={}, config={"b": 2, "a": 1}, code_version="x")
    )
    with pytest.raises(ValueError, match=r"[Oo]ut of range"):
        key(config={"x": float("nan")})


def test_create_then_find(store):
    assert store.find(key()) is None
    made = store.create(key(), fill("hello"))
    assert store.find(key()) == made
    assert (made / "a.txt").read_text() == "hello"
    # Only what the stage wrote lies in the result.
    assert sorted(p.name for p in made.rglob("*")) == ["a.txt", "b.bin", "sub"]
    assert not any((store.root / "tmp").iterdir())


def test_a_key_that_is_no_key_is_refused(store):
    with pytest.raises(ValueError, match="no artifact key"):
        store.find("../../etc/passwd")


def test_failure_of_the_stage_leaves_nothing(store):
    def fail(folder: Path) -> None:
        (folder / "half.txt").write_text("half")
        raise RuntimeError("boom")

    with pytest.raises(RuntimeError, match="boom"):
        store.create(key(), fail)
    assert store.find(key()) is None
    assert not any((store.root / "tmp").iterdir())


def damage_content(home: Path) -> None:
    # Same size, same times: only the hash tells.
    path = home / "data" / "a.txt"
    facts = path.stat()
    path.write_text("hellO")
    os.utime(path, ns=(facts.st_atime_ns, facts.st_mtime_ns))


def damage_truncate(home: Path) -> None:
    (home / "data" / "sub" / "b.bin").write_bytes(b"")


def damage_missing(home: Path) -> None:
    (home / "data" / "a.txt").unlink()


def damage_extra(home: Path) -> None:
    (home / "data" / "extra.txt").write_text("stray")


def damage_mark(home: Path) -> None:
    (home / MARK).write_text("{")


def damage_mark_value(home: Path) -> None:
    text = (home / MARK).read_text()
    (home / MARK).write_text(text.replace('"size": 100', '"size": 101'))


@pytest.mark.parametrize(
    "damage",
    [
        damage_content,
        damage_truncate,
        damage_missing,
        damage_extra,
        damage_mark,
        damage_mark_value,
    ],
)
def test_a_damaged_artifact_is_noticed_dropped_and_computed_again(store, damage):
    made = store.create(key(), fill("hello"))
    module._verified.clear()  # another process has not seen it yet
    damage(made.parent)
    assert store.find(key()) is None
    assert not made.parent.exists()
    again = store.create(key(), fill("hello"))
    assert (again / "a.txt").read_text() == "hello"


def test_of_a_batchs_store_nothing_is_known_when_it_is_gone(tmp_path):
    """Ten thousand scenes are eighty thousand artifacts, of which no folder is left."""
    before = set(module._verified)
    with scratch_store(tmp_path / "artifacts"):
        artifact_store().create(key(), fill("hello"))
        assert set(module._verified) - before
    assert set(module._verified) == before


def test_as_many_artifacts_are_remembered_as_a_large_batch_has(store, monkeypatch):
    monkeypatch.setattr(module, "_MOST_VERIFIED", 3)
    monkeypatch.setattr(module, "_verified", OrderedDict())
    keys = [key(str(k)) for k in range(5)]
    for k in keys:
        store.create(k, fill("hello"))
    assert len(module._verified) == 3
    assert all(store.find(k) is not None for k in keys)


def test_damage_after_the_first_use_is_noticed_by_size_or_time(store):
    made = store.create(key(), fill("hello"))
    assert store.find(key()) is not None
    (made / "a.txt").write_text("hello!")
    assert store.find(key()) is None


def test_a_folder_without_its_mark_is_not_an_artifact(store):
    made = store.create(key(), fill("hello"))
    (made.parent / MARK).unlink()
    assert store.find(key()) is None
    assert (store.create(key(), fill("new")) / "a.txt").read_text() == "new"


def test_of_two_writers_the_first_wins_and_the_other_adopts(store):
    def slow(folder: Path) -> None:
        fill("second")(folder)
        store.create(key(), fill("first"))

    made = store.create(key(), slow)
    assert (made / "a.txt").read_text() == "first"


def _race(root: str, name: str, barrier) -> None:
    barrier.wait(120)
    for n in range(10):
        found = ArtifactStore(Path(root)).create(key(str(n)), fill("same"))
        assert (found / "a.txt").read_text() == "same", name


def test_many_processes_may_write_the_same_keys(store):
    context = multiprocessing.get_context("spawn")
    barrier = context.Barrier(4)
    workers = [
        context.Process(target=_race, args=(str(store.root), str(i), barrier)) for i in range(4)
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join(180)
    assert [w.exitcode for w in workers] == [0, 0, 0, 0]
    assert all(store.find(key(str(n))) for n in range(10))
    assert not any((store.root / "tmp").iterdir())


def _die(root: str) -> None:
    def kill(folder: Path) -> None:
        (folder / "half.txt").write_text("half")
        os.kill(os.getpid(), 9)

    ArtifactStore(Path(root)).create(key(), kill)


def test_a_killed_writer_leaves_only_what_sweep_removes(store):
    worker = multiprocessing.get_context("spawn").Process(target=_die, args=(str(store.root),))
    worker.start()
    worker.join(30)
    assert worker.exitcode == -9
    assert store.find(key()) is None
    assert len(list((store.root / "tmp").iterdir())) == 1
    assert store.sweep(older_than_s=3600) == 0
    assert store.sweep(older_than_s=-1) == 1
    assert store.create(key(), fill("hello")).is_dir()


def test_full_disk_names_the_remedy_and_leaves_nothing(store, monkeypatch):
    def full(path: Path) -> None:
        raise OSError(errno.ENOSPC, "No space left on device", str(path))

    monkeypatch.setattr("esg.files.sync_file", full)
    with pytest.raises(OSError, match="free some space") as caught:
        store.create(key(), fill("hello"))
    assert caught.value.errno == errno.ENOSPC
    monkeypatch.undo()
    assert store.find(key()) is None
    assert not any((store.root / "tmp").iterdir())


def test_prune_drops_old_artifacts(store):
    store.create(key(), fill("hello"))
    assert store.prune(older_than_s=3600) == 0
    assert store.prune(older_than_s=3600, now=9e9) == 1
    assert store.find(key()) is None
