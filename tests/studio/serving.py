"""A studio for browsers: in this process, or in one of its own that can be killed.

python -m tests.studio.serving FOLDER PORT
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
import contextlib
from pathlib import Path
import socket
import sys
import threading
import time

import uvicorn

from esg.api.warming import load_usd
from esg.studio.jobs import Jobs
from esg.studio.server import HOST, build
from tests.studio.fakes import Pool


@contextlib.contextmanager
def served(jobs: Jobs) -> Iterator[str]:
    """The address of a studio that ends with the block."""
    load_usd()  # before any thread
    listener = socket.socket()
    listener.bind((HOST, 0))
    server = uvicorn.Server(
        uvicorn.Config(
            build(jobs), log_level="critical", access_log=False, timeout_graceful_shutdown=1
        )
    )
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
    thread.start()
    deadline = time.monotonic() + 30
    while not server.started and time.monotonic() < deadline:
        time.sleep(0.01)
    try:
        yield f"http://{HOST}:{listener.getsockname()[1]}/"
    finally:
        server.should_exit = True
        thread.join(15)
        listener.close()


def pools() -> Callable[[], Pool]:
    """Pools whose scenes take until they are cancelled if their prompt says "wait"."""
    return lambda: Pool(slow="wait")


def main(folder: Path, port: int) -> None:
    load_usd()
    jobs = Jobs(folder, pools())  # type: ignore[arg-type]  # stands for a WorkerPool
    uvicorn.run(build(jobs), host=HOST, port=port, log_level="critical", access_log=False)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]))
