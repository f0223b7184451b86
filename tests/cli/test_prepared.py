"""A set-up that was done is found, for as long as all that it made is there."""

from __future__ import annotations

from pathlib import Path

import pytest

from esg import prepared as module
from esg.commands import setup
from esg.paths import kernel_cache_dir
from esg.prepared import NOTE, note_prepared, prepared


@pytest.fixture
def kernels(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path))
    monkeypatch.delenv("WARP_CACHE_PATH", raising=False)
    folder = kernel_cache_dir() / "wp_some_kernels_1234567"
    folder.mkdir(parents=True)
    for name in ("code.o", "code.meta"):
        (folder / name).write_text("compiled")
    unfinished = kernel_cache_dir() / "wp_other_1234567_p12_t34"
    unfinished.mkdir()
    (unfinished / "code.o").write_text("half of it")
    for name in ("prefect/template-1.db", "classes/include-1/player.o"):
        (tmp_path / name).parent.mkdir(parents=True)
        (tmp_path / name).write_text("made")
    return folder


def test_nothing_is_prepared_before_the_first_set_up(kernels: Path) -> None:
    assert not prepared(None)


def test_what_is_there_is_found(kernels: Path, tmp_path: Path) -> None:
    note_prepared(None)
    assert prepared(None)
    assert not prepared("cuda:0")  # whose kernels nobody has compiled
    told = (tmp_path / NOTE).read_text()
    assert all(name in told for name in ("code.o", "template-1.db", "player.o"))
    assert "wp_other" not in told  # which a process is still writing


@pytest.mark.parametrize(
    "name",
    ["code.o", "../../../prefect/template-1.db", "../../../classes/include-1/player.o"],
)
def test_what_is_missing_or_cut_off_is_made_again(kernels: Path, name: str) -> None:
    note_prepared(None)
    (kernels / name).write_text("cut")
    assert not prepared(None)
    (kernels / name).unlink()
    assert not prepared(None)


def test_other_code_and_a_damaged_note_are_no_set_up(
    kernels: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    note_prepared(None)
    with monkeypatch.context() as other:
        other.setattr(module, "sources_hash", lambda: "other code")
        assert not prepared(None)
    assert prepared(None)
    (tmp_path / NOTE).write_text("{")
    assert not prepared(None)


def test_a_second_set_up_does_nothing_unless_it_is_asked_to(
    kernels: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    done: list[str | None] = []
    monkeypatch.setattr(setup, "_gpu", lambda device: device)
    monkeypatch.setattr(setup, "_prepare", done.append)
    monkeypatch.setattr(setup, "PACKAGES", ())
    for again in (False, False, True):
        assert setup.setup(again=again) == 0
    assert done == [None, None]
    assert capsys.readouterr().out.count("all of it is there already") == 1
