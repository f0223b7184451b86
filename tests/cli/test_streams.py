"""Standard streams that are closed or full: the exit code stays, nothing strays."""

from __future__ import annotations

import json
import os
from pathlib import Path
import subprocess
import sys

import pytest

ROOT = Path(__file__).parents[2]
ESG = f"PYTHONPATH={ROOT} {sys.executable} -m esg"


def shell(line: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["bash", "-c", line], capture_output=True, text=True, timeout=120)


@pytest.mark.parametrize("stderr", ["2>&-", "2>/dev/full"])
def test_nobody_listens_to_messages(stderr: str) -> None:
    done = shell(f"{ESG} draft '' {stderr}")
    assert (done.returncode, done.stdout) == (2, "")
    done = shell(f"{ESG} draft '' --json {stderr}")
    assert done.returncode == 2
    assert json.loads(done.stdout)["exit_code"] == 2


@pytest.mark.parametrize(("stdout", "code"), [(">&-", 0), (">/dev/full", 1), ("| true", 0)])
def test_nobody_takes_what_is_printed(stdout: str, code: int) -> None:
    done = shell(f"{ESG} assets list --json {stdout}")
    assert done.returncode == code
    assert done.stdout == "" and "Traceback" not in done.stderr


def test_a_file_never_gets_the_number_of_a_closed_stream(tmp_path: Path) -> None:
    """What libraries print would go into the first file that is opened."""
    code = (
        "import sys; from esg.commands.console import quiet_native_output\nfrom esg.notices import warn\n"
        "quiet_native_output()\n"
        "print('nobody'); warn(['nobody']); assert not sys.stderr.isatty()\n"
        f"file = open({str(tmp_path / 'file')!r}, 'w')\n"
        "assert file.fileno() > 2, file.fileno()\n"
        "open('/proc/self/fd/1', 'w').write('stray'); file.write('own')\n"
    )
    done = shell(f'PYTHONPATH={ROOT} {sys.executable} -c "{code}" <&- >&- 2>&-')
    assert done.returncode == 0
    assert (tmp_path / "file").read_text() == "own"


def test_what_strangers_write_moves_no_terminal(tmp_path: Path) -> None:
    """Names of a document are printed as text: no colours, titles, cursor or directions."""
    document = tmp_path / "x.json"
    document.write_text(json.dumps({"\x1b]0;title\x07\x1b[31m\x9b\u202e": 1}))
    for arguments in (["check", str(document)], ["check", "\x1b[31m.json"], ["sql", "\x1b[31m"],
                      ["check", str(document), "--json"]):  # fmt: skip
        done = subprocess.run(
            [sys.executable, "-m", "esg.cli", *arguments], capture_output=True, text=True,
            check=False, cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(ROOT)},
        )  # fmt: skip
        said = done.stdout + done.stderr
        assert said
        assert not [c for c in said if c in "\x1b\x07\x9b\u202e\r"], arguments
    places = [v["pointer"] for v in json.loads(done.stdout)["violations"]]
    assert any(place.startswith("/\x1b]0;title") for place in places)
