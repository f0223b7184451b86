"""Worker processes that stay warm: engines, models and compiled kernels live across scenes.

Each slot owns one process, so a worker that dies (a segmentation fault in an engine, the kernel's
memory killer) takes down exactly one call. The call is tried once more in a fresh process; if that
dies as well, the call is at fault and raises `WorkerDied`.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
import contextlib
from dataclasses import dataclass
import heapq
from itertools import count
import multiprocessing
from multiprocessing.context import BaseContext
import os
from pathlib import Path
from queue import SimpleQueue
import signal
import threading
from typing import Any, TypeVar

from esg.progress import forward_to, relay
from esg.settings import WORKER_GIB

T = TypeVar("T")

RECYCLE_AFTER = 400
"""Calls after which a worker process is replaced, so that memory stays flat."""

MAX_MEMORY_BYTES = 3 * 2**30
"""Resident memory beyond which a worker process is replaced after its call."""


STOP_AFTER_S = 3.0
"""From asking a worker to stop to killing it."""


OUT_OF_TIME = 70
"""Exit code of a worker that ended itself because its call took longer than it may."""

LEAST_MEMORY_BYTES = 4 * 2**30
"""What a worker may allocate at least, however small its share of the machine is."""


class WorkerDied(RuntimeError):
    """The process that ran a call ended without an answer, twice."""


class OutOfTime(WorkerDied):
    """The process that ran a call ended because the call took too long: it is not tried again."""


class WorkerPool:
    """A fixed number of warm worker processes, usable from any thread.

    Args:
        processes: Number of processes; 0 runs every call in this process, one at a time.
        recycle_after: Calls after which a process is replaced.
        max_memory_bytes: A process that has grown beyond this after a call is replaced too.
        bound_bytes: What each may allocate; None: its share of the machine, 0: no bound.
        niceness: Added to that of this process: others come first.
        context: How they start (`esg.machine.forked`); default spawned.
    """

    def __init__(
        self,
        processes: int,
        recycle_after: int = RECYCLE_AFTER,
        max_memory_bytes: int = MAX_MEMORY_BYTES,
        *,
        bound_bytes: int | None = None,
        niceness: int = 0,
        context: Callable[[], BaseContext] | None = None,
    ) -> None:
        self.processes = processes
        self._recycle_after = recycle_after
        # Processes share the cores: one engine thread each, unless there is but one process.
        bound = memory_bound(processes) if bound_bytes is None else bound_bytes
        how = _Worker(max_memory_bytes, bound, processes > 1, niceness)
        self._all = [_Slot(how, context or _spawned) for _ in range(processes)]
        self._free = list(self._all)
        self._change = threading.Lock()
        self._calls = count()
        self._waiting: list[tuple[tuple[int, ...], int, SimpleQueue[_Slot]]] = []
        self._local = threading.Lock()
        self._stopped = threading.Event()

    def run(self, function: Callable[..., T], *args: Any, rank: tuple[int, ...] = ()) -> T:
        """Calls `function(*args)` in a free worker and waits for its result.

        Args:
            function: A module-level function; exceptions it raises pass through.
            *args: Picklable arguments.
            rank: Of the calls that wait for a worker, the one with the lowest rank comes first, and
                of equals whoever has waited longest.

        Raises:
            WorkerDied: If two processes in a row ended during the call.
            KeyboardInterrupt: If the pool was stopped before the call ended.
        """
        if self.processes == 0:
            with self._local:
                self._go_on()
                return function(*args)
        slot = self._take(rank)
        try:
            self._go_on()
            return slot.run(function, args, self._recycle_after, self._go_on)
        finally:
            self._hand_on(slot)

    def _take(self, rank: tuple[int, ...]) -> _Slot:
        """Waits for a free worker."""
        with self._change:
            if self._free:
                return self._free.pop(0)
            given: SimpleQueue[_Slot] = SimpleQueue()
            heapq.heappush(self._waiting, (rank, next(self._calls), given))
        return given.get()

    def _hand_on(self, slot: _Slot) -> None:
        """Gives a worker to whoever comes first: nobody else need wake up for it."""
        with self._change:
            if self._waiting:
                heapq.heappop(self._waiting)[-1].put(slot)
            else:
                self._free.append(slot)

    def _go_on(self) -> None:
        if self._stopped.is_set():
            raise KeyboardInterrupt

    def stop(self) -> None:
        """Interrupts running calls and refuses further ones, from any thread or signal handler."""
        self._stopped.set()
        for slot in self._all:
            slot.stop()

    def warm(self, function: Callable[..., Any], *args: Any) -> None:
        """Starts `function(*args)` in every worker without waiting for it."""
        for slot in self._all:
            slot.submit(function, args)

    def close(self) -> None:
        """Ends all workers; running calls finish first."""
        for slot in self._all:
            slot.close()

    def __enter__(self) -> WorkerPool:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@dataclass(frozen=True)
class _Worker:
    """What a worker process is told, and when it is replaced."""

    max_memory_bytes: int
    bound_bytes: int
    sharing: bool
    niceness: int


def _spawned() -> BaseContext:
    return multiprocessing.get_context("spawn")


class _Slot:
    def __init__(self, how: _Worker, context: Callable[[], BaseContext]) -> None:
        self._how = how
        self._context = context
        self._executor: ProcessPoolExecutor | None = None
        self._calls = 0

    def submit(self, function: Callable[..., T], args: tuple[Any, ...]) -> Any:
        if self._executor is None:
            # A spawned worker inherits the environment before it imports numpy: one thread each,
            # because the processes already share the cores.
            os.environ.setdefault("OMP_NUM_THREADS", "1")
            context = self._context()
            events, tell = context.Pipe(duplex=False)
            self._executor = ProcessPoolExecutor(
                1,
                mp_context=context,
                initializer=_begin,
                initargs=(os.getpid(), dict(os.environ), tell, self._how),
            )
            self._calls = 0
            with _with_children():
                future = self._executor.submit(function, *args)
            # The process has its own copy: with ours closed, its death ends the pipe.
            tell.close()
            relay(events)
            return future
        return self._executor.submit(function, *args)

    def run(
        self,
        function: Callable[..., T],
        args: tuple[Any, ...],
        recycle_after: int,
        go_on: Callable[[], None],
    ) -> T:
        if self._calls >= recycle_after or self._memory() > self._how.max_memory_bytes:
            self.close()
        for _ in range(2):
            processes: tuple[Any, ...] = ()
            try:
                future = self.submit(function, args)
                self._calls += 1
                processes = tuple((getattr(self._executor, "_processes", None) or {}).values())
                return future.result()
            except BrokenProcessPool:
                self.close()
                go_on()
                if any(process.exitcode == OUT_OF_TIME for process in processes):
                    raise OutOfTime("it ran longer than its limit (ESG_STAGE_SECONDS)") from None
        bound = self._how.bound_bytes
        limit = f"its limit of {bound / 2**30:.3g} GiB (ESG_WORKER_GIB)" if bound else "there is"
        raise WorkerDied(
            f"the worker process ended twice during {function.__name__}; a crash in native code, "
            f"or more memory than {limit}"
        )

    def _memory(self) -> int:
        """Resident memory of the process [bytes]; 0 where the system does not tell."""
        if self._executor is None:
            return 0
        total = 0
        for process in tuple((self._executor._processes or {}).values()):
            with contextlib.suppress(OSError, ValueError, IndexError):
                pages = Path(f"/proc/{process.pid}/statm").read_text().split()[1]
                total += int(pages) * os.sysconf("SC_PAGE_SIZE")
        return total

    def stop(self) -> None:
        """Interrupts the process, and ends it where native code does not listen."""
        for process in tuple((getattr(self._executor, "_processes", None) or {}).values()):
            process.terminate()
            killer = threading.Timer(STOP_AFTER_S, process.kill)
            killer.daemon = True
            killer.start()

    def close(self) -> None:
        if self._executor is not None:
            self._executor.shutdown(wait=True, cancel_futures=True)
            self._executor = None


@contextlib.contextmanager
def _with_children() -> Generator[None]:
    """Lets this process start others even if it is a daemon, as the workers of Dask are.

    Daemons may not, so that they leave none behind; ours end with their parent
    (`_end_with_command`).
    """
    config: dict[str, Any] = vars(multiprocessing.current_process())["_config"]
    before = config.get("daemon")
    config["daemon"] = False
    try:
        yield
    finally:
        config["daemon"] = before


def memory_bound(processes: int) -> int:
    """What each of so many workers may allocate [bytes]: the setting, else a share of the machine.

    Args:
        processes: Number of workers.
    """
    if asked := asked_bound():
        return asked
    return max(LEAST_MEMORY_BYTES, machine_memory() // max(1, processes))


def asked_bound() -> int:
    """What a worker may allocate if it is set, whatever it does [bytes]; else 0."""
    return int(WORKER_GIB.value * 2**30)


def machine_memory() -> int:
    """Memory that this process can have [bytes]: the machine's, or its control group's."""
    if not hasattr(os, "sysconf"):  # Windows, where workers have no bound
        return LEAST_MEMORY_BYTES
    total = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    with contextlib.suppress(OSError, ValueError):
        total = min(total, int(Path("/sys/fs/cgroup/memory.max").read_text()))
    return total


def _begin(command: int, environment: dict[str, str], tell: Any, how: _Worker) -> None:
    if os.getppid() != command:  # forked off a process with an environment of its own
        os.environ.clear()
        os.environ.update(environment)
    if how.sharing:
        os.environ.setdefault("ESG_THREADS", "1")
    if how.niceness and hasattr(os, "nice"):
        os.nice(how.niceness)
    if how.bound_bytes:
        _limit_memory(how.bound_bytes)
    # A terminal's Ctrl-C reaches workers too: the command decides what becomes of them, and lets
    # them leave no temporary folder behind.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    forward_to(tell)
    _end_with_command()


def _limit_memory(bound_bytes: int) -> None:
    """Bounds what this process allocates; CUDA only reserves terabytes."""
    try:
        import resource
    except ImportError:  # Windows
        return
    _, most = resource.getrlimit(resource.RLIMIT_DATA)
    bound = bound_bytes if most == resource.RLIM_INFINITY else min(bound_bytes, most)
    with contextlib.suppress(OSError, ValueError):
        resource.setrlimit(resource.RLIMIT_DATA, (bound, most))


def _end_with_command() -> None:
    """In a worker: ends the process as soon as the command is gone, even if it was killed.

    Linux's parent-death signal would not do: it follows the thread that started the worker.
    """
    command = multiprocessing.parent_process()
    assert command is not None, "a worker has been started"

    def watch() -> None:
        command.join()
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def default_processes(n_scenes: int) -> int:
    """Worker processes for `n_scenes`: none for a few, else one a core, at most eight."""
    if n_scenes < 3:
        return 0
    return max(1, min(8, usable_cores(), n_scenes))


def usable_cores() -> int:
    """Cores that this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:
        return os.cpu_count() or 1
