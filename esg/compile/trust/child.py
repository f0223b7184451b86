"""The child that runs one class: it loads what it needs, locks itself in, plays and tells."""

from __future__ import annotations

from collections.abc import Sequence
import json
import os
from pathlib import Path
import sys
import sysconfig

from esg.compile.records import ReplayError
from esg.compile.trust import locks, wire
from esg.compile.trust.playing import Job, play


def warm(engine: str) -> None:
    """Imports an engine, which a process that has locked itself in cannot do."""
    from esg.engines import executor, physx_engine, rapier_engine, worlds

    assert executor and rapier_engine and worlds
    if engine == "physx":
        import sapien

        assert sapien and physx_engine.physx_module()
    else:
        import rapier3d

        assert rapier3d


def answer(job: Job, memory_bytes: int, seconds: int, out: int) -> None:
    """Locks this process in, runs the class and writes what it did to a file descriptor."""
    try:
        warm(job.engine)
        locks.lock(memory_bytes, seconds, [*code_folders(), Path(job.library)])
        data = wire.packed(play(job))
    except ReplayError as error:
        data = wire.packed_failure(wire.Failed("refused", str(error)))
    except MemoryError:
        data = wire.packed_failure(wire.Failed("memory", ""))
    except Exception as error:  # whatever it is, the parent has to hear of it
        data = wire.packed_failure(wire.Failed("broken", f"{type(error).__name__}: {error}"))
    view = memoryview(data)
    while view:
        view = view[os.write(out, view) :]


def code_folders() -> list[Path]:
    """Where Python, its packages, this project and the system's libraries lie."""
    import esg

    paths = sysconfig.get_paths()
    folders = {paths[k] for k in ("stdlib", "platstdlib", "purelib", "platlib")}
    own = Path(esg.__file__).parent
    return [Path(p) for p in sorted(folders)] + [own, *map(Path, ("/lib", "/lib64", "/usr/lib"))]


def main(arguments: Sequence[str]) -> None:
    """A fresh interpreter: the job comes as JSON on standard input, the answer goes out on it."""
    out = os.dup(1)
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    job = json.load(sys.stdin)
    memory_bytes, seconds = (int(argument) for argument in arguments)
    answer(Job(**job), memory_bytes, seconds, out)
    os._exit(0)
