"""A worker whose commands are a few lines, and which loads nothing: what it passes on is tested."""

from __future__ import annotations

import json
import os
from pathlib import Path
import signal
import sys
import time

from esg.machine.answering import afterwards
from esg.up import server

ACTS = {
    "echo": lambda: print(json.dumps({
        "arguments": sys.argv[1:], "cwd": os.getcwd(), "name": os.environ.get("NAME"),
        "umask": os.umask(0), "input": sys.stdin.read(), "alone": os.getsid(0) == os.getpid(),
    })),
    "fail": lambda: sys.exit(3),
    "crash": lambda: os.kill(os.getpid(), signal.SIGSEGV),
}  # fmt: skip


def _until_gone(mark: Path) -> None:
    while mark.exists():
        time.sleep(0.02)
    mark.with_suffix(".facts").write_text(json.dumps({
        "nice": os.nice(0), "streams": [os.readlink(f"/proc/self/fd/{n}") for n in range(3)],
    }))  # fmt: skip


def main() -> None:
    """The command line of the stub: `generate ACT`."""
    act = sys.argv[2]
    if act == "wait":
        Path(sys.argv[3]).write_text(str(os.getpid()))
        try:
            time.sleep(60.0)
        except KeyboardInterrupt:
            print("interrupted", flush=True)
            sys.exit(130)
    if act == "answer":  # and go on until the file is taken away
        mark = Path(sys.argv[3])
        mark.write_text(str(os.getpid()))
        afterwards(lambda: _until_gone(mark))
        print("answered", flush=True)
        sys.exit(3)
    ACTS[act]()
    sys.exit(0)


if __name__ == "__main__":
    server.warm = lambda: None
    sys.exit(server.serve(main, Path(sys.argv[1]), float(sys.argv[2])))
