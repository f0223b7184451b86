"""Folders removed while other work goes on."""

from __future__ import annotations

from pathlib import Path
import subprocess
import sys

from esg.machine.removing import remove_beside, wait_removed


def _filled(folder: Path) -> Path:
    for k in range(20):
        (folder / str(k)).mkdir(parents=True)
        (folder / str(k) / "file").write_text("x", encoding="utf-8")
    return folder


def test_the_name_is_free_at_once_and_all_is_gone_in_the_end(tmp_path: Path) -> None:
    for _ in range(3):
        remove_beside(_filled(tmp_path / "work"))
        assert not (tmp_path / "work").exists()
    remove_beside(tmp_path / "missing")
    wait_removed()
    assert not list(tmp_path.iterdir())


def test_a_process_ends_only_when_its_folders_are_gone(tmp_path: Path) -> None:
    _filled(tmp_path / "work")
    code = (
        "import sys, pathlib\nfrom esg.machine.removing import remove_beside\n"
        "remove_beside(pathlib.Path(sys.argv[1]))"
    )
    subprocess.run([sys.executable, "-c", code, str(tmp_path / "work")], check=True)
    assert not list(tmp_path.iterdir())
