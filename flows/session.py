"""Running flows from a command: API process, worker processes and warm-up, started together."""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
import inspect
import os
import signal
import sys
import threading
from typing import Any, TypeVar

from esg.api.warming import load_usd, warm_up
from esg.limits import stage_limits
from esg.machine.forked import RENEWED_AFTER, SHARES_BEFORE_RENEWAL, begin, context
from esg.settings import check_limits
from esg.workers import RECYCLE_AFTER, WorkerPool, asked_bound
from flows.embedded import prefect_api
from flows.naming import run_tags
from tasks.context import Watcher, run_context

T = TypeVar("T")

BEHIND_SEARCHES = 10
"""Niceness of workers beside searches: a device waits for plans, and nobody waits for a proof."""


@contextlib.contextmanager
def session(
    processes: int, watch: Watcher | None = None, searchers: int = 0, *, forked: str = ""
) -> Generator[Callable[..., Any]]:
    """Everything a flow needs, for the body.

    The API process, the workers and this process all need seconds to import their libraries; they
    do so at the same time.

    Args:
        processes: Worker processes, 0 for none.
        watch: Called after every stage of every scene.
        searchers: Processes beside them that only search; the others let them have the cores first.
        forked: How workers search that use no GPU and are forked off a process that has loaded
            everything (`esg.machine.forked.begin`); default: each loads it.

    Yields:
        A function that calls a flow once the API answers: `call(flow, *args, **kwargs)`.
    """
    stage_limits()  # a mistake in them is told before anything starts
    check_limits()
    forks = bool(forked) and processes > 1
    if forks:
        begin(forked)
    niceness, how = BEHIND_SEARCHES if searchers else 0, context if forks else None
    in_shares = SHARES_BEFORE_RENEWAL if searchers else RENEWED_AFTER
    renewed = in_shares if forks else RECYCLE_AFTER
    with (
        prefect_api() as api,
        WorkerPool(processes, renewed, niceness=niceness, context=how) as pool,
        # Their memory is the device's and what they share with processes that plan beside them.
        WorkerPool(searchers, max_memory_bytes=sys.maxsize, bound_bytes=asked_bound()) as apart,
        stopping(pool, apart),
        run_context(pool, watch, searchers=apart),
    ):
        if processes:
            apart.warm(warm_up, True)
            if not forks:
                pool.warm(warm_up)
        # Batches import the engines in threads of this process, with workers too.
        load_usd()
        if not processes:
            threading.Thread(target=warm_up, daemon=True).start()
        # Prefect reads its environment when first imported: after `prefect_api` has set it.
        from prefect.settings import (
            PREFECT_API_URL,
            PREFECT_FLOWS_HEARTBEAT_FREQUENCY,
            temporary_settings,
        )

        # Prefect keeps what it read at import: an earlier session's API, if there was one.
        url = {PREFECT_API_URL: os.environ["PREFECT_API_URL"]}

        def call(flow: Callable[..., T], *args: Any, **kwargs: Any) -> T:
            from prefect import tags

            api.wait()
            # The heartbeat thread costs a second at the end of every flow run.
            quiet = temporary_settings({PREFECT_FLOWS_HEARTBEAT_FREQUENCY: None, **url})
            with quiet, tags(*_tags(flow, args, kwargs)):
                return flow(*args, **kwargs)

        yield call


def _tags(flow: Callable[..., Any], args: Any, kwargs: Any) -> list[str]:
    """Tags of a run; none for what is no flow."""
    if not (name := getattr(flow, "name", "")):
        return []
    bound = inspect.signature(flow).bind(*args, **kwargs)
    bound.apply_defaults()
    return run_tags(name, bound.arguments)


@contextlib.contextmanager
def stopping(*pools: WorkerPool) -> Generator[None]:
    """Lets Ctrl-C and SIGTERM stop the workers in the body: Prefect would wait for all batches.

    Args:
        pools: Of the workers.
    """
    before = {n: signal.getsignal(n) for n in (signal.SIGINT, signal.SIGTERM)}
    answered = {n: handler for n, handler in before.items() if callable(handler)}
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(number: int, frame: Any) -> None:
        for pool in pools:
            pool.stop()
        answered[signal.Signals(number)](number, frame)

    for number in answered:
        signal.signal(number, stop)
    try:
        yield
    finally:
        for number in answered:
            signal.signal(number, before[number])
