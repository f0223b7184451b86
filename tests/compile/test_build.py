from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
import shutil
import subprocess
from typing import Any

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
    bad.write_text(bad.read_text().replace("SceneDuration = ", "SceneDuration = Stop + "))
    results = compile_many(read_classes(folders), jobs=1)
    assert [isinstance(r, Library) for r in results] == [True, True, False, True]
    error = results[2]
    assert isinstance(error, ClassError)
    assert "Stop" in str(error) and str(folders[2]) in str(error)


def test_a_linker_that_fails_is_no_fault_of_a_class(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(build, "_linker", lambda: ("-fuse-ld=bfd", "-Wl,--no-such-option"))
    library = compile_class(read_classes([written(tmp_path / "a", *ball_scene("linked", 0.41))])[0])
    assert library.path.is_file() and library.seconds > 0


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


def _truncated(path: Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def _bit_flipped(path: Path) -> None:
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 0x10
    path.write_bytes(data)


def _emptied(path: Path) -> None:
    path.write_bytes(b"")


@pytest.fixture(scope="module")
def compiled_shim(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class cache that holds the compiled shim and nothing else."""
    root = tmp_path_factory.mktemp("shim")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ESG_CACHE_DIR", str(root))
        build._include_dir(build.compiler())
    return root


@pytest.fixture
def fresh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, compiled_shim: Path) -> Path:
    """A class cache of the test's own."""
    shutil.copytree(compiled_shim, tmp_path / "fresh")
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path / "fresh"))
    return tmp_path / "fresh" / "classes"


@pytest.mark.parametrize("damage", [_truncated, _bit_flipped, _emptied])
def test_a_damaged_library_is_compiled_again(
    tmp_path: Path, fresh: Path, damage: Callable[[Path], None]
) -> None:
    """Loading it would end the process (SIGBUS) or run what nobody wrote."""
    folder = written(tmp_path / "scene", *ball_scene("worn", 11.0))
    damage(compile_class(read_classes([folder])[0]).path)
    healed = compile_class(read_classes([folder])[0])
    assert healed.seconds > 0.0
    assert replay_class(folder, duration=0.1).compile_seconds == 0.0


@pytest.mark.parametrize(
    "name",
    [
        "runtime.o",
        pytest.param("EsgScene.o", marks=pytest.mark.slow),
        pytest.param("EsgScene.cpp", marks=pytest.mark.slow),
        "Common.h.gch",
        pytest.param("UEShim.h", marks=pytest.mark.slow),
    ],
)
def test_a_damaged_shim_is_compiled_again(tmp_path: Path, fresh: Path, name: str) -> None:
    """A class compiled after it runs; the damage is not blamed on the class."""
    first = written(tmp_path / "first", *ball_scene("before", 12.0))
    compile_class(read_classes([first])[0])
    (include,) = fresh.glob("include-*")
    _truncated(include / name)
    second = written(tmp_path / "second", *ball_scene("after", 13.0))
    assert replay_class(second, duration=0.1).rollout.valid.all()
    assert build._is_sound(include)


def test_a_shim_that_spoils_under_a_compiler_is_no_fault_of_the_class(
    tmp_path: Path, fresh: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The compiler complains, the shim is made anew, the class compiles."""
    folder = written(tmp_path / "scene", *ball_scene("spoilt", 14.0))
    run, failures = subprocess.run, []

    def spoiled(command: list[str], **options: Any) -> Any:
        if "-shared" in command and not failures:
            (include,) = fresh.glob("include-*")
            _truncated(include / "runtime.o")
            failures.append(command)
        return run(command, **options)

    monkeypatch.setattr(build.subprocess, "run", spoiled)
    assert isinstance(compile_many([folder], jobs=1)[0], Library)
    assert failures


@pytest.mark.parametrize("text", ["", "unit-", "../../x.so " + 64 * "0", "unit-0.so", "\xff\xfe"])
def test_a_damaged_reference_is_written_anew(tmp_path: Path, fresh: Path, text: str) -> None:
    """A reference that is cut off, of an older version, or leads elsewhere is none."""
    folder = written(tmp_path / "scene", *ball_scene("referred", 15.0))
    library = compile_class(read_classes([folder])[0])
    (reference,) = fresh.glob("*.ref")
    reference.write_text(text, "latin-1")
    again = compile_class(read_classes([folder])[0])
    assert again.path == library.path and again.seconds > 0.0
    assert reference.read_text("ascii").split()[0] == library.path.name


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
