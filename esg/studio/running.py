"""Starting and stopping the studio's server."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
import socket
import threading
from typing import TYPE_CHECKING

from esg.api.warming import load_usd, warm_up
from esg.outcomes import UserError
from esg.studio.server import HOST, build
from esg.workers import WorkerPool

if TYPE_CHECKING:
    from esg.studio.jobs import Jobs

GRACE_S = 1


def run(folder: Path, port: int, ready: Callable[[str], None], *, once: bool = False) -> None:
    """Serves the studio until interrupted.

    Args:
        folder: Of its scenes and its history.
        port: 0 takes a free one.
        ready: Called with the address once it answers.
        once: Stop after one answer.

    Raises:
        UserError: If the port is taken or forbidden.
    """
    import uvicorn

    from esg.studio.jobs import Jobs

    listener = _bound(port)
    load_usd()  # before any thread
    jobs = Jobs(folder, _warm_pool)
    config = uvicorn.Config(
        build(jobs), log_level="critical", access_log=False, timeout_graceful_shutdown=GRACE_S
    )
    server = uvicorn.Server(config)
    address = f"http://{HOST}:{listener.getsockname()[1]}/"
    threading.Thread(target=_warm, args=(jobs,), daemon=True).start()
    try:
        if once:
            threading.Thread(target=_stop_after_answer, args=(server, address), daemon=True).start()
        ready(address)
        server.run(sockets=[listener])
    except KeyboardInterrupt:
        pass
    finally:
        listener.close()


def _bound(port: int) -> socket.socket:
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((HOST, port))
    except OSError as error:
        listener.close()
        raise UserError(f"--port {port}: {error.strerror}; choose another, or 0") from None
    return listener


def _warm_pool() -> WorkerPool:
    """A process that imports what scenes need while nobody waits for it."""
    pool = WorkerPool(1)
    pool.warm(warm_up)
    return pool


def _warm(jobs: Jobs) -> None:
    """Loads the language model and the player: what is typed or looked at first does not wait."""
    from esg.studio.playing import warm
    from esg.studio.reading import read

    read("A ball rolls.", 0)
    warm(jobs.folder, jobs.all())


def _stop_after_answer(server: object, address: str) -> None:
    import time
    import urllib.request

    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    for _ in range(200):
        try:
            with opener.open(address, timeout=5) as answer:
                answer.read()
            break
        except OSError:
            time.sleep(0.05)
    server.should_exit = True  # type: ignore[attr-defined]  # uvicorn's own
