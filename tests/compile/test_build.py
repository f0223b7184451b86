from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
import subprocess

from helpers import written
import pytest
import scenes

from esg.compile import ClassError, CompilerMissing, build, compile_many, replay_class
from esg.compile.build import Library, cache_dir, compile_class, read_classes
from esg.engines.program import Program
from esg.engines.scene import SimScene


def ball_scene(scene_id: str, x: float) -> tuple[SimScene, Program]:
    body = scenes.ball("ball", (x, 0.0, 0.2), 0.1, 1.0)
    return SimScene(scene_id, (body,)), Program((), 0.1)


def test_batch_of_one_name_keeps_the_classes_apart(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ten seeds of one scene share units; each class still runs with its own numbers."""
    monkeypatch.setattr(build, "CLASSES_PER_UNIT", 8)
    folders = [written(tmp_path / str(i), *ball_scene("seeds", 0.1 * i)) for i in range(10)]
    libraries = compile_many(folders, jobs=1)
    assert all(isinstance(lib, Library) for lib in libraries)
    assert len({lib.path for lib in libraries if isinstance(lib, Library)}) == 2
    for i, folder in enumerate(folders):
        replayed = replay_class(folder)
        assert replayed.compile_seconds == 0.0
        assert replayed.rollout.position[0, 0, 0, 0] == pytest.approx(0.1 * i, abs=1e-6)


def test_one_bad_class_does_not_fail_its_neighbours(tmp_path: Path) -> None:
    folders = [written(tmp_path / str(i), *ball_scene(f"n{i}", 0.3 + i)) for i in range(4)]
    bad = next((folders[2] / "unreal").glob("*.cpp"))
    bad.write_text(bad.read_text().replace("SceneTime += Step;", "SceneTime += Stop;"))
    results = compile_many(read_classes(folders), jobs=1)
    assert [isinstance(r, Library) for r in results] == [True, True, False, True]
    error = results[2]
    assert isinstance(error, ClassError)
    assert "Stop" in str(error) and str(folders[2]) in str(error)


def test_a_folder_without_a_class_does_not_fail_its_neighbours(tmp_path: Path) -> None:
    good = written(tmp_path / "good", *ball_scene("good", 0.7))
    (tmp_path / "empty").mkdir()
    results = compile_many([tmp_path / "empty", good, tmp_path / "none"], jobs=1)
    assert [isinstance(r, Library) for r in results] == [False, True, False]
    for result, name in ((results[0], "empty"), (results[2], "none")):
        assert isinstance(result, ClassError)
        assert name in str(result) and "no compiled scene" in str(result)


def test_a_batch_serves_folders_that_move_afterwards(tmp_path: Path) -> None:
    """The cache goes by content: compiled in a work folder, replayed from the published one."""
    folders = [written(tmp_path / f"work{i}", *ball_scene(f"move{i}", 0.2 * i)) for i in range(3)]
    compile_many(folders, jobs=1)
    for i, folder in enumerate(folders):
        replayed = replay_class(folder.rename(tmp_path / f"published{i}"))
        assert replayed.compile_seconds == 0.0


def test_cache_follows_the_content(tmp_path: Path) -> None:
    folder = written(tmp_path, *ball_scene("cached", 7.0))
    first = compile_class(read_classes([folder])[0])
    again = compile_class(read_classes([folder])[0])
    assert first.seconds > 0.0 and again.seconds == 0.0 and first.path == again.path
    assert cache_dir() in first.path.parents
    source = next((folder / "unreal").glob("*.cpp"))
    source.write_text(source.read_text() + "\n")
    assert compile_class(read_classes([folder])[0]).seconds > 0.0


def test_lost_library_is_compiled_again(tmp_path: Path) -> None:
    folder = written(tmp_path, *ball_scene("lost", 8.0))
    first = compile_class(read_classes([folder])[0])
    first.path.unlink()
    assert compile_class(read_classes([folder])[0]).path.is_file()


def test_missing_compiler_is_said_plainly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = written(tmp_path, *ball_scene("none", 9.0))
    monkeypatch.setenv("CXX", "no-such-compiler")
    with pytest.raises(CompilerMissing, match=r"no g\+\+ found"):
        replay_class(folder)
    monkeypatch.delenv("CXX")
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(CompilerMissing):
        replay_class(folder)


def test_a_full_disk_is_no_fault_of_the_class(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A compiler that cannot write says so; every class compiles once there is room."""
    folder = written(tmp_path / "a", *ball_scene("full", 0.9))
    said = "unit.cpp: fatal error: cannot write: No space left on device"
    failed = subprocess.CompletedProcess([], 1, "", said)
    with monkeypatch.context() as patch:
        patch.setattr(build.subprocess, "run", lambda *a, **k: failed)
        with pytest.raises(OSError, match="No space left") as told:
            compile_many([folder], jobs=1)
    assert told.value.filename is not None
    assert isinstance(compile_many([folder], jobs=1)[0], Library)


def test_nothing_is_left_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path / "fresh"))
    folder = written(tmp_path / "scene", *ball_scene("tidy", 10.0))
    compile_class(read_classes([folder])[0])
    names = sorted(p.name.split("-")[0] for p in (tmp_path / "fresh" / "classes").iterdir())
    assert [n for n in names if "." not in n or n.endswith(".so")] == ["include", "unit"] or all(
        not n.startswith("build") and not n.endswith(".tmp") for n in names
    )


def test_replays_in_threads_do_not_disturb_each_other(tmp_path: Path) -> None:
    folders = [written(tmp_path / str(i), *ball_scene("threads", 0.2 * i)) for i in range(4)]
    compile_many(folders)
    with ThreadPoolExecutor(4) as pool:
        starts = list(pool.map(lambda f: replay_class(f).rollout.position[0, 0, 0, 0], folders * 3))
    assert starts == pytest.approx([0.2 * i for i in range(4)] * 3, abs=1e-6)
