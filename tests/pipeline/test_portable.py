"""What only POSIX systems have is used where others do without it (docs/install.md)."""

from __future__ import annotations

import ast
import os
from pathlib import Path
import subprocess
import sys

ROOT = Path(__file__).parents[2]
MODULES = {"fcntl", "grp", "pty", "pwd", "resource", "termios", "tty"}
NAMES = {
    "os": {
        "O_CLOEXEC", "O_DIRECTORY", "O_NOFOLLOW", "chown", "fork", "geteuid", "getgid", "getpgid",
        "getuid", "killpg", "mkfifo", "nice", "sched_getaffinity", "set_blocking", "setsid",
        "sysconf", "uname", "wait4", "waitstatus_to_exitcode",
    },
    "signal": {"SIGALRM", "SIGCHLD", "SIGHUP", "SIGKILL", "SIGPIPE", "SIGUSR1", "SIGXCPU", "alarm",
               "setitimer"},
    "socket": {"AF_UNIX", "SO_PEERCRED"},
}  # fmt: skip
LINUX_ONLY = (
    "esg/up/", "esg/compile/trust/", "esg/machine/answering.py", "esg/machine/beside.py",
    "esg/machine/companion.py",
)  # fmt: skip
"""Warm workers, locks on classes, forks: each asks for the system first and does without it."""
GUARDED = {
    "esg/commands/stopping.py": {"os.set_blocking"},
    "esg/leftovers.py": {"os.getuid"},
    "esg/workers.py": {"os.nice", "os.sched_getaffinity", "os.sysconf", "resource"},
}
"""Names that a file asks for before it uses them."""


def posix_names(path: Path) -> set[str]:
    found = set[str]()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        match node:
            case ast.Attribute(value=ast.Name(id=module), attr=name):
                if name in NAMES.get(module, ()):
                    found.add(f"{module}.{name}")
            case ast.Import(names=names):
                found |= {n.name for n in names} & MODULES
            case ast.ImportFrom(module=module) if module in MODULES:
                found.add(module)
            case _:
                pass
    return found


def test_only_guarded_places_use_what_other_systems_lack() -> None:
    found = {
        name: names
        for room in ("esg", "tasks", "flows")
        for path in sorted((ROOT / room).rglob("*.py"))
        if not (name := path.relative_to(ROOT).as_posix()).startswith(LINUX_ONLY)
        and (names := posix_names(path) - GUARDED.get(name, set()))
    }
    assert found == {}


WITHOUT = """
import builtins, sys
own = builtins.__import__
def without(name, globals=None, *more, **named):
    asker = (globals or {}).get("__name__", "")
    if name in ("fcntl", "resource", "pwd", "grp") and asker.split(".")[0] in ("esg", "tasks", "flows"):
        raise ImportError(name)
    return own(name, globals, *more, **named)
builtins.__import__ = without
import os
class Os:
    def __getattr__(self, name):
        if name in ("fork", "getuid", "sched_getaffinity", "sysconf"):
            raise AttributeError(name)
        return getattr(os, name)
import esg.leftovers, esg.workers, esg.commands.stopping, esg.machine.beside
for module in (esg.leftovers, esg.workers, esg.commands.stopping, esg.machine.beside):
    module.os = Os()
esg.machine.beside.sys = type("S", (), {"platform": "win32"})
from esg.workers import WorkerPool, memory_bound, usable_cores
from esg.cli import main
if __name__ == "__main__":
    assert usable_cores() >= 1 and memory_bound(2) > 0
    sys.argv = ["esg", "draft", "A ball rolls off a table."]
    main()
"""


def test_a_command_works_without_them(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", WITHOUT], cwd=tmp_path, capture_output=True, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)}, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "ball" in done.stdout
