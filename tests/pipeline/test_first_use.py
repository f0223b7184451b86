"""What a machine has not done before is told ahead, and leaves nothing behind where it fails."""

from __future__ import annotations

from importlib import metadata
from pathlib import Path
import shutil
from types import SimpleNamespace

import pytest

from esg.commands.console import note_first_use
from esg.outcomes import UserError
from esg.paths import kernel_cache_dir
from flows import embedded


def test_kernels_that_are_still_to_be_compiled_are_announced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("WARP_CACHE_PATH", str(tmp_path))
    note_first_use()
    assert "esg setup" in capsys.readouterr().err
    (tmp_path / metadata.version("warp-lang") / "wp_esg.engines.surrogate.kernels_0").mkdir(
        parents=True
    )
    note_first_use()
    assert capsys.readouterr().err == ""


def test_the_kernel_cache_is_where_warp_keeps_it() -> None:
    from esg.engines.newton import quiet_warp

    wp = quiet_warp()
    assert Path(wp.config.kernel_cache_dir).resolve() == kernel_cache_dir().resolve()


def test_a_full_temporary_folder_is_told_before_the_api_starts(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    usage = SimpleNamespace(total=10**9, used=10**9, free=3 * 2**20)
    monkeypatch.setattr(shutil, "disk_usage", lambda path: usage)
    with pytest.raises(UserError, match=r"3\.0 MiB left.*TMPDIR") as told:
        embedded.check_room()
    assert told.value.exit_code == 1


def test_a_copy_that_fails_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a").write_bytes(b"whole")

    def full(source: Path, target: Path) -> None:
        Path(target).write_bytes(b"wh")
        raise OSError(28, "No space left on device", str(target))

    monkeypatch.setattr(shutil, "copyfile", full)
    with pytest.raises(OSError, match="free some space"):
        embedded.copy_whole(tmp_path / "a", tmp_path / "b")
    assert [p.name for p in tmp_path.iterdir()] == ["a"]
