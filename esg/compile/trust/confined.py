"""Running a class in a child that can do nothing but compute, and telling how that ended.

A class that equals its document's emission runs in a fork of this process, which costs
milliseconds; anybody else's in a fresh interpreter with an empty environment. Each child runs one
class.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from dataclasses import asdict, dataclass
import gc
import json
import os
import selectors
import signal
import subprocess
import sys
import threading
import time

from esg.compile.records import ReplayError
from esg.compile.trust import child, wire
from esg.compile.trust.playing import Job, Played
from esg.engines.base import MOST_STATES, VERIFY_DT_S

MEMORY_BYTES = 2 * 2**30
"""What a class may take beside what Python and the engine have."""
START_S, SECONDS_A_STEP = 30.0, 0.05
"""Time that a replay may take: to start, and a step of 1/240 s. A step of a hundred bodies takes
0.01 s."""
MOST_SECONDS = 3600.0

_MOST_SAID = 65536
_BOOT = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[1]); "
    "from esg.compile.trust.child import main; main(sys.argv[2:])"
)


class ClassStopped(ReplayError):
    """A class ran too long, wanted too much memory, or crashed."""


@dataclass(frozen=True)
class _Child:
    pid: int
    answer: int
    said: int


def play_confined(job: Job, *, fresh: bool) -> Played:
    """Runs a class in a child.

    Args:
        job: What to play.
        fresh: Whether the child shares nothing with this process, not even memory that was read.

    Raises:
        ReplayError: If the class does what Unreal would refuse.
        ClassStopped: If it had to be stopped, or crashed.
    """
    if job.duration / job.dt / job.record_every * max(1, job.bodies) > MOST_STATES:
        raise ClassStopped(f"the class asks for {job.duration:g} s of play, more than is recorded")
    limit = time_limit(job)
    if fresh or threading.active_count() > 1 or not hasattr(os, "fork"):
        # A fork of a process with threads may inherit a lock that nobody will ever release.
        starting = _fresh(job, limit)
    else:
        child.warm(job.engine)
        starting = _forked(job, limit)
    with starting as running:
        try:
            data, said, late = _collect(running, limit, wire.most_bytes(job))
        except BaseException:  # an interrupt: nobody waits for the child any more
            _end(running, True)
            raise
        status = _end(running, late)
    return _told(job, data, said, None if late else status, limit)


def time_limit(job: Job) -> float:
    """Seconds after which a replay is stopped."""
    steps = job.frames.n_steps * max(1.0, job.dt / VERIFY_DT_S)
    return min(MOST_SECONDS, START_S + SECONDS_A_STEP * steps)


@contextlib.contextmanager
def _forked(job: Job, limit: float) -> Generator[_Child]:
    answer, tell = os.pipe()
    said, complain = os.pipe()
    pid = os.fork()
    if pid == 0:
        _in_fork(lambda: child.answer(job, MEMORY_BYTES, int(limit) + 1, tell), tell, complain)
    os.close(tell)
    os.close(complain)
    try:
        yield _Child(pid, answer, said)
    finally:
        os.close(answer)
        os.close(said)


def _in_fork(work: Callable[[], None], tell: int, complain: int) -> None:
    """In the child: nothing of the parent's is open any more, and it never returns."""
    code = 1
    gc.disable()  # it would touch, and so copy, all that the parent has
    try:
        silence = os.open(os.devnull, os.O_RDWR)
        os.set_blocking(complain, False)
        os.dup2(silence, 0)
        os.dup2(silence, 1)
        os.dup2(complain, 2)
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        os.closerange(3, tell)
        os.closerange(tell + 1, os.sysconf("SC_OPEN_MAX"))
        work()
        code = 0
    finally:
        os._exit(code)


@contextlib.contextmanager
def _fresh(job: Job, limit: float) -> Generator[_Child]:
    command = [sys.executable, "-I", "-c", _BOOT, json.dumps(sys.path)]
    command += [str(MEMORY_BYTES), str(int(limit) + 1)]
    environment = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    with subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment,
        cwd="/",
        start_new_session=True,
    ) as process:
        assert process.stdin and process.stdout and process.stderr
        try:
            with contextlib.suppress(BrokenPipeError):
                process.stdin.write(json.dumps(asdict(job)).encode())
                process.stdin.close()
            yield _Child(process.pid, process.stdout.fileno(), process.stderr.fileno())
        finally:
            process.kill()


def _collect(running: _Child, limit: float, most: int) -> tuple[bytes, bytes, bool]:
    """The child's answer, what it complained of, and whether it is still at it after the limit."""
    found = {running.answer: bytearray(), running.said: bytearray()}
    room = {running.answer: most, running.said: _MOST_SAID}
    deadline = time.monotonic() + limit
    with selectors.DefaultSelector() as waiting:
        for source in found:
            waiting.register(source, selectors.EVENT_READ)
        while waiting.get_map():
            ready = waiting.select(max(0.0, deadline - time.monotonic()))
            if not ready:
                return bytes(found[running.answer]), bytes(found[running.said]), True
            for key, _ in ready:
                data = os.read(key.fd, 2**20)
                if not data:
                    waiting.unregister(key.fd)
                # What is more than any answer is read, so that the child can end, and dropped.
                found[key.fd] += data[: max(0, room[key.fd] - len(found[key.fd]))]
    return bytes(found[running.answer]), bytes(found[running.said]), False


def _end(running: _Child, late: bool) -> int:
    """Reaps the child; its exit status, negative for a signal."""
    if late:
        with contextlib.suppress(ProcessLookupError):
            os.kill(running.pid, signal.SIGKILL)
    with contextlib.suppress(ChildProcessError):
        return os.waitstatus_to_exitcode(os.waitpid(running.pid, 0)[1])
    return 0


def _told(job: Job, data: bytes, said: bytes, status: int | None, limit: float) -> Played:
    """The answer, or why there is none in one sentence."""
    if status is None or status == -signal.SIGXCPU:
        raise ClassStopped(f"the class ran longer than {limit:.0f} s and was stopped")
    try:
        answer = wire.unpacked(data, job)
    except wire.WireError as error:
        if b"bad_alloc" in said:
            raise _too_large() from None
        if status < 0:
            raise ClassStopped(f"the class crashed ({signal.Signals(-status).name})") from None
        raise ClassStopped(f"the class ended the replay without a result ({error})") from None
    if isinstance(answer, Played):
        return answer
    if answer.kind == "memory" or b"bad_alloc" in said:
        raise _too_large()
    words = "".join(c if c.isprintable() else " " for c in answer.message)
    if answer.kind == "refused":
        raise ReplayError(words)
    raise ClassStopped(f"the replay of the class failed: {words}")


def _too_large() -> ClassStopped:
    return ClassStopped(
        f"the class wanted more than {MEMORY_BYTES / 2**30:g} GiB of memory and was stopped"
    )
