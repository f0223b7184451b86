"""Standard streams that are closed or full: the exit code stays, nothing strays."""

from __future__ import annotations

import json
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
