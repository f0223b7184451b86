"""What a machine has not done before is told ahead, and leaves nothing behind where it fails."""

from __future__ import annotations

from importlib import metadata
import os
from pathlib import Path
import shutil
import subprocess
import sys
from types import SimpleNamespace

import pytest

from esg.commands.console import note_first_use
from esg.outcomes import UserError
from flows import embedded

ROOT = Path(__file__).parents[2]


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


WHERE = """
import sys
class Loud:  # a notebook's: not the file that is redirected
    flush = lambda self: None
    def write(self, text):
        sys.exit(f"warp said {text!r}")
sys.stderr = Loud()
from esg.engines.newton import quiet_warp
from esg.paths import kernel_cache_dir
found = quiet_warp().config.kernel_cache_dir
assert found == str(kernel_cache_dir()), (found, kernel_cache_dir())
print(found)
"""


def test_kernels_are_kept_in_the_cache_folder(tmp_path: Path) -> None:
    """`ESG_CACHE_DIR` moves all that is compiled; `WARP_CACHE_PATH` wins; else all share one."""
    plain = {k: v for k, v in os.environ.items() if k not in ("ESG_CACHE_DIR", "WARP_CACHE_PATH")}
    plain["XDG_CACHE_HOME"] = str(tmp_path / "user")
    own = {"ESG_CACHE_DIR": str(tmp_path / "own")}
    both = {**own, "WARP_CACHE_PATH": str(tmp_path / "warps")}
    version = metadata.version("warp-lang")
    for folder in ("own/warp", "warps", "user/warp"):  # of an older version
        (tmp_path / folder / "wp_old").mkdir(parents=True)
    for more, place in ((own, "own/warp"), (both, "warps"), ({}, "user/warp")):
        done = subprocess.run(
            [sys.executable, "-c", WHERE], env={**plain, **more}, cwd=ROOT, text=True,
            capture_output=True, timeout=120, check=True,
        )  # fmt: skip
        assert Path(done.stdout.strip()) == tmp_path / place / version


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
