"""Shares a batch between processes: they build and judge, this one searches.

Python turns documents into arrays and judges what comes back; on many scenes that takes longer than
the search on a GPU. So processes do both for a share of the scenes each, in several portions, and
the calling process serves their searches, as many as have arrived in one launch. Only it touches
the device. A scene's result does not depend on who handles it or on what is launched with it.
"""

from __future__ import annotations

from collections.abc import Sequence
import gc
import multiprocessing
import pickle
import queue
import sys
import threading
from typing import Any

from esg.graph.models import EsgDocument, LayoutResult
from esg.layout.clock import Clock
from esg.layout.config import LayoutConfig
from esg.layout.problem.hints import StartHints
from esg.layout.search import answer
from esg.layout.steps import solve_steps

PORTION = 256
"""Most scenes that a process builds before it asks for their search."""
PORTIONS = 4
"""Portions that a process cuts its share into, so that search and Python overlap."""
LEAST = 16
"""Scenes below which a portion is not worth a launch."""


def solve_in_processes(
    docs: Sequence[EsgDocument],
    seeds: Sequence[int],
    plans: Sequence[StartHints | None],
    config: LayoutConfig,
    clock: Clock,
) -> list[LayoutResult]:
    """Lays out documents with `config.processes` processes beside this one.

    Processes are forked where that is the custom (Linux): they inherit the documents and never use
    the device. Elsewhere they are spawned and the documents are sent.

    Raises:
        RuntimeError: A process ended early; its traceback is on standard error.
    """
    method = "fork" if sys.platform == "linux" else None
    context = multiprocessing.get_context(method)
    count = min(config.processes, max(1, len(docs) // LEAST))
    inbox: queue.SimpleQueue[tuple[int, Any]] = queue.SimpleQueue()
    outbox: list[queue.SimpleQueue[Any]] = [queue.SimpleQueue() for _ in range(count)]
    pipes: list[Any] = []
    jobs: list[Any] = []
    # reference counting frees all that is made here; a collection would only walk every document
    collects = gc.isenabled()
    gc.disable()
    try:
        for k in range(count):
            near, far = context.Pipe()
            share = (docs[k::count], seeds[k::count], plans[k::count])
            job = context.Process(target=_work, args=(*share, config, far), daemon=True)
            job.start()
            far.close()
            pipes.append(near)
            jobs.append(job)
        # threads read and write, so that neither side waits for the other to listen
        for k, pipe in enumerate(pipes):
            threading.Thread(target=_read, args=(k, pipe, inbox), daemon=True).start()
            threading.Thread(target=_write, args=(pipe, outbox[k]), daemon=True).start()
        return _serve(inbox, outbox, len(docs), clock)
    finally:
        for letters_out in outbox:
            letters_out.put(None)
        for job in jobs:
            job.join(1.0)
            if job.is_alive():
                job.terminate()
        for pipe in pipes:
            pipe.close()
        if collects:
            gc.enable()


def _serve(
    inbox: queue.SimpleQueue[tuple[int, Any]],
    outbox: list[queue.SimpleQueue[Any]],
    scenes: int,
    clock: Clock,
) -> list[LayoutResult]:
    """Searches for all processes until each has said that it is done; one result per scene."""
    count = len(outbox)
    results: list[Any] = [None] * scenes
    backlog: list[tuple[int, int, list[bytes]]] = []
    working = set(range(count))

    def unpack() -> None:
        k, first, part = backlog.pop()
        for i, data in enumerate(part):
            results[k + (first + i) * count] = _unpack(data)

    while working:
        requests: list[tuple[int, int, Any]] = []
        for k, letter in _letters(inbox):
            if letter is None:
                if k in working:
                    raise RuntimeError(f"layout process {k} of {count} ended early")
            elif letter[0] == "results":
                backlog.append((k, letter[1], letter[2]))
            elif letter[0] == "end":
                for stage, seconds in letter[1].items():
                    clock.add(stage, seconds)
                working.discard(k)
            else:
                requests.append((k, letter[1], letter[2]))
        if requests:
            clock.start()
            found = answer([r for _, _, r in requests])
            for (k, portion, _), reply in zip(requests, found, strict=True):
                outbox[k].put((portion, reply))
            clock.lap("search")
        while backlog and inbox.empty():  # nobody waits for a search
            unpack()
    while backlog:
        unpack()
    return results


def _letters(inbox: queue.SimpleQueue[tuple[int, Any]]) -> list[tuple[int, Any]]:
    """All that has arrived, at least one."""
    letters = [inbox.get()]
    while not inbox.empty():
        letters.append(inbox.get())
    return letters


def _read(k: int, pipe: Any, inbox: queue.SimpleQueue[tuple[int, Any]]) -> None:
    """Empties one pipe, so that no process waits to be heard."""
    try:
        while True:
            inbox.put((k, pipe.recv()))
    except (EOFError, OSError):
        inbox.put((k, None))


def _write(pipe: Any, outbox: queue.SimpleQueue[Any]) -> None:
    """Sends what is put into a queue until None."""
    while (letter := outbox.get()) is not None:
        try:
            pipe.send(letter)
        except OSError:  # the reader reports that the other side is gone
            return


def _pack(result: LayoutResult) -> bytes:
    """JSON reads back faster than a pickle; it has no infinity and no NaN."""
    data = result.model_dump_json().encode()
    return pickle.dumps(result) if b"null" in data else data


def _unpack(data: bytes) -> LayoutResult:
    return LayoutResult.model_validate_json(data) if data[:1] == b"{" else pickle.loads(data)


def _work(
    docs: Sequence[EsgDocument],
    seeds: Sequence[int],
    plans: Sequence[StartHints | None],
    config: LayoutConfig,
    pipe: Any,
) -> None:
    """One process: starts its portions one after the other, continues each when it was searched."""
    gc.disable()
    clock = Clock()
    size = min(PORTION, max(LEAST, -(-len(docs) // PORTIONS)))
    portions: dict[int, Any] = {}

    def advance(first: int, reply: Any) -> None:
        try:
            request = portions[first].send(reply)
            pipe.send(("search", first, request))
        except StopIteration as end:
            del portions[first]
            clock.start()
            pipe.send(("results", first, [_pack(r) for r in end.value]))
            clock.lap("write")

    for first in range(0, len(docs), size):
        part = slice(first, first + size)
        portions[first] = solve_steps(docs[part], seeds[part], plans[part], config, clock)
        advance(first, None)
        while pipe.poll():
            advance(*pipe.recv())
    while portions:
        advance(*pipe.recv())
    pipe.send(("end", clock.seconds))
    pipe.close()
