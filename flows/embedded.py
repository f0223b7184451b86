"""Prefect without a server to look after: a private API process that lives as long as the command.

Prefect's own ephemeral mode starts its API inside the first flow call and makes the command wait
for it: 11 s warm, 20 s on first use. Here the API process starts first, with database migrations
already done and without the background services a single command never needs, and the caller
imports its numerical libraries meanwhile; the first flow then waits about 6 s in all.

Each command works on a private copy of a migrated template database: two commands never contend for
one SQLite file, nothing grows, and the user's own Prefect profile and home stay untouched. A user
who sets `PREFECT_API_URL` gets that server instead and sees every run in its UI.

Import this module before `prefect`: it sets the environment prefect reads at import.
"""

from __future__ import annotations

import atexit
from collections.abc import Generator
import contextlib
import http.client
from importlib import metadata
import os
from pathlib import Path
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

from esg.files import atomic_write
from esg.leftovers import owned_folder, sweep_leftovers
from esg.outcomes import UserError
from esg.paths import cache_dir

STARTUP_TIMEOUT_S = 300.0
"""Six commands that start at once on two cores need 100 s; an API that ends is noticed at once."""
ANSWER_S = 10.0
"""A server of the user's that says nothing for so long does not answer [s]."""
TEMPLATE_WAIT_S = 120.0
"""So long a command waits for the one that makes the template, then makes its own."""
ROOM_BYTES = 64 * 2**20
"""Free space that the API's database and the engines' scratch files need."""
PREFIX = "esg-prefect-"
"""Of the folders of private APIs."""

_QUIET = {
    "DO_NOT_TRACK": "1",
    "PREFECT_SERVER_ANALYTICS_ENABLED": "false",
    "PREFECT_LOGGING_LEVEL": "CRITICAL",
    "PREFECT_LOGGING_TO_API_ENABLED": "false",
    "PREFECT_RESULTS_PERSIST_BY_DEFAULT": "false",
    "PREFECT_SERVER_API_MAX_PARAMETER_SIZE": "0",  # thousands of prompts are parameters of a flow
}
_UNUSED_SERVICES = (
    "CANCELLATION_CLEANUP",
    "CLEANUP_RECONCILER",
    "EVENT_LOGGER",
    "FOREMAN",
    "LATE_RUNS",
    "PAUSE_EXPIRATIONS",
    "REPOSSESSOR",
    "SCHEDULER",
    "TRIGGERS",
)

_SERVE = (
    "import gc, socket, sys\n"
    "gc.set_threshold(100_000, 20, 20)\n"
    "import uvicorn\n"
    "app = 'prefect.server.api.server:create_app'\n"
    "config = uvicorn.Config(app, factory=True, log_level='critical', timeout_keep_alive=30)\n"
    "uvicorn.Server(config).run(sockets=[socket.socket(fileno=int(sys.argv[1]))])\n"
)
"""Uvicorn, which searches for garbage less often: a seventh of its start goes into that.

It is handed a socket that is bound already: between finding a free port and binding it another
command could take it, and this one would talk to an API that ends with the other command.
"""


def configure() -> None:
    """Sets what prefect reads at import; values the user has set win."""
    for key, value in _QUIET.items():
        os.environ.setdefault(key, value)
    os.environ.setdefault("PREFECT_LOCAL_STORAGE_PATH", str(_home() / "results"))
    if "PREFECT_API_URL" not in os.environ:
        os.environ.setdefault("PREFECT_HOME", str(_home() / "home"))


class EmbeddedServer:
    """The private API process of one command."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._folder: Path | None = None
        self._port = 0

    def start(self) -> None:
        """Starts the process and points prefect at it; returns at once (see `wait`)."""
        configure()
        if os.environ.get("PREFECT_API_URL") or self._process is not None:
            return
        sweep_leftovers(PREFIX)
        check_room()
        self._folder = owned_folder(PREFIX)
        database = self._folder / "prefect.db"
        with contextlib.suppress(OSError):  # an unwritable cache: migrate the private copy instead
            copy_whole(prepare_template(), database)
        with socket.socket() as bound, (self._folder / "server.log").open("wb") as log:
            bound.bind(("127.0.0.1", 0))
            self._port = int(bound.getsockname()[1])
            self._process = subprocess.Popen(
                [sys.executable, "-c", _SERVE, str(bound.fileno())],
                env=_server_environment(database, migrate=not database.exists()),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=log,
                pass_fds=(bound.fileno(),),
                # Ctrl-C in a terminal reaches the whole process group: the API has to outlive the
                # command's last words to it, or the command waits for a server that is gone.
                start_new_session=True,
                preexec_fn=_die_with_parent if sys.platform == "linux" else None,
            )
        os.environ["PREFECT_API_URL"] = f"http://127.0.0.1:{self._port}/api"
        atexit.register(self.stop)

    def wait(self) -> None:
        """Blocks until the API answers.

        Raises:
            UserError: With exit code 1 if the process ends or does not answer in time, or a server
                of the user's says nothing.
        """
        if self._process is None:
            _check_answer(os.environ.get("PREFECT_API_URL", ""))
            return
        deadline = time.monotonic() + STARTUP_TIMEOUT_S
        while time.monotonic() < deadline:
            if self._process.poll() is not None:
                break
            if self._healthy():
                return
            time.sleep(0.05)
        log = self._log_tail()
        self.stop()
        raise UserError(
            "the embedded Prefect API did not start; set PREFECT_API_URL to use a running server, "
            f"or run `esg doctor`. Its last words: {log or 'none'}",
            exit_code=1,
        )

    def stop(self) -> None:
        """Ends the process and removes its database."""
        process, self._process = self._process, None
        if process is None:
            return
        os.environ.pop("PREFECT_API_URL", None)
        _drain_events()
        process.terminate()
        try:
            process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)

    def _healthy(self) -> bool:
        connection = http.client.HTTPConnection("127.0.0.1", self._port, timeout=2)
        try:
            connection.request("GET", "/api/health")
            return connection.getresponse().status == 200
        except (OSError, http.client.HTTPException):
            return False
        finally:
            connection.close()

    def _log_tail(self) -> str:
        if self._folder is None:
            return ""
        with contextlib.suppress(OSError):
            lines = (self._folder / "server.log").read_text(errors="replace").strip().splitlines()
            return lines[-1] if lines else ""
        return ""


def _check_answer(url: str) -> None:
    """Whether a server of the user's says anything at all; Prefect itself would wait for minutes.

    Raises:
        UserError: With exit code 1 if it does not.
    """
    try:
        with urllib.request.urlopen(f"{url.rstrip('/')}/health", timeout=ANSWER_S):
            return
    except urllib.error.HTTPError:  # it wants a key, which Prefect has
        return
    except (OSError, ValueError, http.client.HTTPException) as error:
        raise UserError(
            f"PREFECT_API_URL={url}: no answer ({getattr(error, 'reason', error)}); start that "
            "server, or unset the variable for a private one",
            exit_code=1,
        ) from None


@contextlib.contextmanager
def prefect_api() -> Generator[EmbeddedServer]:
    """A running or starting API for the body; call `wait()` before the first flow."""
    server = EmbeddedServer()
    server.start()
    try:
        yield server
    finally:
        server.stop()


def _drain_events() -> None:
    """Sends what Prefect still has to say while there is somebody to listen.

    Otherwise its threads try to reach an API that is gone, and the command waits for them.
    """
    worker = sys.modules.get("prefect.events.worker")
    if worker is not None:
        with contextlib.suppress(Exception):
            worker.EventsWorker.drain_all(timeout=5.0)


def prepare_template() -> Path:
    """Creates the migrated template database (about 10 s); `esg setup` calls it.

    Returns:
        Its path.
    """
    template = template_path()
    if template.exists():
        return template
    configure()
    template.parent.mkdir(parents=True, exist_ok=True)
    with _alone(template.with_suffix(".lock")):
        if not template.exists():  # another command may have made it meanwhile
            _migrate(template)
    return template


@contextlib.contextmanager
def _alone(path: Path) -> Generator[None]:
    """Lets one command at a time into the body; the system lets go of a command that dies."""
    from filelock import FileLock

    lock = FileLock(path, timeout=TEMPLATE_WAIT_S, poll_interval=0.2)
    # A file system without locks must not hang a command: each makes its own, the last one stays.
    with contextlib.suppress(OSError):  # Timeout is one
        lock.acquire()
    try:
        yield
    finally:
        lock.release()


def _migrate(template: Path) -> None:
    with tempfile.TemporaryDirectory(prefix="esg-prefect-") as folder:
        database = Path(folder) / "prefect.db"
        env = _server_environment(database, migrate=True)
        code = (
            "import asyncio\n"
            "from prefect.server.database import provide_database_interface\n"
            "asyncio.run(provide_database_interface().create_db())\n"
        )
        done = subprocess.run(
            [sys.executable, "-c", code], env=env, capture_output=True, text=True, check=False
        )
        if done.returncode != 0 or not database.exists():
            last = done.stderr.strip().splitlines()[-1:] or ["no message"]
            raise UserError(f"Prefect could not create its database: {last[0]}", exit_code=1)
        _fold_wal(database)
        copy_whole(database, template)


def copy_whole(source: Path, target: Path) -> None:
    """Copies a file; a disk that cannot hold all of it is left without any of it.

    Raises:
        OSError: With the remedy in its text.
    """

    def fill(partial: Path) -> None:
        shutil.copyfile(source, partial)

    atomic_write(target, fill)


def check_room() -> None:
    """Finds out early whether the API's database has room to grow in the temporary folder.

    Raises:
        UserError: With exit code 1 if it has not.
    """
    folder = tempfile.gettempdir()
    free = shutil.disk_usage(folder).free
    if free < ROOM_BYTES:
        raise UserError(
            f"the temporary folder {folder} has {free / 2**20:.1f} MiB left and "
            f"{ROOM_BYTES // 2**20} are needed; free some space, or set TMPDIR to a folder on "
            "another disk",
            exit_code=1,
        )


def _server_environment(database: Path, migrate: bool, services: bool = False) -> dict[str, str]:
    env = dict(os.environ)
    env.update(
        PREFECT_HOME=str(database.parent),
        PREFECT_API_DATABASE_CONNECTION_URL=f"sqlite+aiosqlite:///{database}",
        PREFECT_API_DATABASE_MIGRATE_ON_START="true" if migrate else "false",
        PREFECT_API_BLOCKS_REGISTER_ON_START="false",
        PREFECT_UI_ENABLED="0",
        PREFECT__SERVER_EPHEMERAL="1",
        PREFECT__SERVER_FINAL="1",
        OMP_NUM_THREADS="1",
    )
    env.pop("PREFECT_API_URL", None)
    for service in _UNUSED_SERVICES:
        env[f"PREFECT_SERVER_SERVICES_{service}_ENABLED"] = "false"
    return env


def _fold_wal(database: Path) -> None:
    """Writes SQLite's log back into the file, so that copying the file copies everything."""
    import sqlite3

    connection = sqlite3.connect(database)
    try:
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.execute("PRAGMA journal_mode=DELETE")
    finally:
        connection.close()


def _home() -> Path:
    return cache_dir() / "prefect"


def template_path() -> Path:
    """The migrated database that private APIs start from, one a version of Prefect."""
    return _home() / f"template-{metadata.version('prefect')}.db"


def _die_with_parent() -> None:
    """Linux: the API process gets SIGTERM when the command dies, even by SIGKILL."""
    import ctypes

    ctypes.CDLL(None).prctl(1, signal.SIGTERM)
