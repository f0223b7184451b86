"""A companion loads ahead and does what it is handed; without one, work is done here."""

from __future__ import annotations

from functools import partial
import importlib
import os
from pathlib import Path
import signal
import sys
import time
from types import ModuleType

import pytest

from esg.alone import guarded
from esg.alone.ahead import _spared
from esg.limits import StageTimeout, limited
from esg.machine import beside as module
from esg.machine.beside import forking
from esg.machine.companion import companion, done_elsewhere, handed, load_rest, spent_s
from esg.pipeline import SceneRequest, SceneState


@pytest.fixture(autouse=True)
def cores(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "usable_cores", lambda: 2)


def _who() -> int:
    return os.getpid()


def _loaded(folder: Path, name: str) -> None:
    (folder / name).write_text(str(os.getpid()))


def _what_is_loaded(folder: Path) -> list[str]:
    return sorted(p.name for p in folder.iterdir())


def _dies(owner: int) -> str:
    if os.getpid() != owner:
        os.kill(os.getpid(), signal.SIGKILL)
    return "here"


def _fails(owner: int) -> str:
    if os.getpid() != owner:
        raise ValueError("only there")
    return "here"


def _burns(seconds: float) -> None:
    end = time.process_time() + seconds
    while time.process_time() < end:
        pass


def test_without_a_companion_work_is_done_here() -> None:
    assert done_elsewhere(_who) == os.getpid()
    with handed(_who) as result:
        assert result is None


def test_one_core_has_no_companion(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "usable_cores", lambda: 1)
    with forking(), companion(()):
        assert done_elsewhere(_who) == os.getpid()


def test_one_process_does_all_that_is_handed_over() -> None:
    with forking(), companion(()):
        first, second = done_elsewhere(_who), done_elsewhere(_who)
    assert first == second != os.getpid()
    with pytest.raises(ProcessLookupError):
        os.kill(first, 0)


def test_it_loads_one_thing_before_each_work(tmp_path: Path) -> None:
    """What loads late must not keep the first work waiting."""
    idle = [partial(_loaded, tmp_path, name) for name in ("first", "second")]
    with forking(), companion(idle):
        assert done_elsewhere(partial(_what_is_loaded, tmp_path)) == ["first"]
        assert done_elsewhere(partial(_what_is_loaded, tmp_path)) == ["first", "second"]
        assert (tmp_path / "first").read_text() != str(os.getpid())


def test_this_process_loads_its_own_while_it_waits_first(tmp_path: Path) -> None:
    with forking(), companion((), (partial(_loaded, tmp_path, "own"),)):
        assert not list(tmp_path.iterdir())
        done_elsewhere(_who)
        assert (tmp_path / "own").read_text() == str(os.getpid())
        (tmp_path / "own").unlink()
        done_elsewhere(_who)
        assert not list(tmp_path.iterdir())


def test_this_process_loads_the_rest_when_it_has_nothing_to_do(tmp_path: Path) -> None:
    """More than one thing is loaded in one wait only as long as there is no answer."""
    own = [partial(_loaded, tmp_path, name) for name in ("first", "second", "third")]
    with forking(), companion((), own):
        with handed(_who) as result:
            assert result is not None
            time.sleep(0.5)  # the answer is there
            result()
        assert _what_is_loaded(tmp_path) == ["first"]
        load_rest(lambda: True)  # what it would do meanwhile is done
        assert _what_is_loaded(tmp_path) == ["first"]
        load_rest(lambda: False)
        assert _what_is_loaded(tmp_path) == ["first", "second", "third"]
    load_rest(lambda: False)  # nor does anything go wrong without a companion


def test_what_is_spared_is_executed_at_its_first_use(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "spared_package"
    folder.mkdir()
    (folder / "__init__.py").write_text(
        "from spared_package.heavy import weight\nown = weight + 1\n"
    )
    (folder / "heavy.py").write_text("weight = 41\n")
    (folder / "light.py").write_text("name = 'light'\n")
    (tmp_path / "spared_user.py").write_text(
        "import spared_package\nfrom spared_package.light import name\n"
        "try:\n    import spared_absent\nexcept ImportError:\n    spared_absent = None\n"
    )
    (tmp_path / "spared_absent.py").write_text("")
    monkeypatch.syspath_prepend(tmp_path)
    try:
        with _spared(frozenset({"spared_package"}), frozenset({"spared_absent"})):
            user = vars(importlib.import_module("spared_user"))
        assert user["name"] == "light"
        assert user["spared_absent"] is None
        assert "spared_package.heavy" not in sys.modules
        assert user["spared_package"].own == 42
        assert type(user["spared_package"]) is ModuleType
        with pytest.raises(AttributeError, match=r"spared_package.*nothing"):
            _ = user["spared_package"].nothing
        assert importlib.import_module("spared_absent")  # where nobody leaves it out
    finally:
        for name in [n for n in sys.modules if n.startswith("spared_")]:
            del sys.modules[name]


@pytest.mark.parametrize("work", [_dies, _fails])
def test_what_it_does_not_do_is_done_here(work: object) -> None:
    with forking(), companion(()):
        assert callable(work)
        assert done_elsewhere(partial(work, os.getpid())) == "here"
        assert done_elsewhere(partial(work, os.getpid())) == "here"


def test_what_cannot_be_loaded_ahead_stops_nothing() -> None:
    with forking(), companion((partial(int, "no number"),), (partial(int, "none"),)):
        assert done_elsewhere(_who) != os.getpid()


def test_its_processor_time_counts() -> None:
    with forking(), companion(()):
        assert spent_s() == 0.0
        done_elsewhere(partial(_burns, 0.2))
        assert spent_s() > 0.19


def test_a_stage_that_waits_for_it_has_its_limit() -> None:
    with forking(), companion(()), pytest.raises(StageTimeout), limited("optimize", 0.3):
        done_elsewhere(partial(time.sleep, 30.0))


def test_only_what_is_cold_and_searches_here_has_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """A warm worker has all loaded, and a GPU does not survive a fork."""
    found: list[int] = []

    def run(stage: str, state: SceneState) -> SceneState:
        found.append(done_elsewhere(_who) if stage == "cast" else os.getpid())
        return state

    def others(request: SceneRequest) -> bool:
        found.clear()
        guarded.run_guarded(request)
        return set(found) != {os.getpid()}

    monkeypatch.setattr(guarded, "run_stage", run)
    monkeypatch.setattr(guarded, "AHEAD", ())
    monkeypatch.setattr(guarded, "MEANWHILE", ())
    monkeypatch.delitem(sys.modules, "newton", raising=False)
    assert others(SceneRequest("a ball"))
    assert not others(SceneRequest("a ball", device="cuda:0"))
    assert not others(SceneRequest("a ball", strategy="none"))
    monkeypatch.setitem(sys.modules, "newton", sys)
    assert not others(SceneRequest("a ball"))


def test_what_draws_loads_no_engine_of_the_search() -> None:
    """The command itself imports neither Newton nor its kernels before the search: it has no time."""
    code = (
        "import sys, esg.alone.guarded, esg.alone.ahead as ahead; ahead.load_pictures();"
        "ahead.load_records();"
        "print(sorted({'newton', 'mujoco', 'pandas', 'prefect', 'torch'} & set(sys.modules)))"
    )
    import subprocess

    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert told.stdout.strip().endswith("[]")
