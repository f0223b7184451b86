"""Commands killed by SIGKILL at random moments, one or two at once: run again, they end as ever."""

from __future__ import annotations

from collections.abc import Sequence
import contextlib
import hashlib
import os
from pathlib import Path
import random
import shutil
import signal
import time

from benchmarks.faults.ground import PROMPT, Ended, Started, copied, scene_of, start

Facts = dict[str, str]
Sound = tuple[Facts, float]
"""What an undisturbed command left, and how long it took [s]."""

COMMANDS: dict[str, Sequence[str]] = {
    "generate": ["generate", PROMPT, "--out", "k"],
    "generate from cache": ["generate", PROMPT, "--out", "k"],
    "bench": ["bench", "faults.yaml", "--runs", "1", "--out", "k"],
    "dataset": ["dataset", "--sample", "4", "--out", "k", "--workers", "1", "--resume"],
    "db rebuild": ["db", "rebuild"],
    "db ingest": ["db", "ingest", "data", "--db", "k.duckdb"],
    "export": ["export", "SCENE", "--to", "usd", "--out", "k"],
    "report": ["report", "runs/bench-faults-batched-physx", "--out", "k.html"],
    "replay": ["replay", "SCENE", "--json"],
}
"""Command lines; what they make is `k`."""
WARM = ("generate from cache", "db rebuild", "db ingest", "export", "report", "replay")
SERVED = ("bench", "dataset")
"""They start servers and workers, which a fork of a large process may not."""
ALONE = ("dataset",)
"""A folder takes one writer: the second is told so."""
_TIMES = (
    "log.jsonl", "SHA256SUMS", "timings", "run.json", "card", "README",
)  # fmt: skip
"""Parts of names of files that hold times: they are there and whole, no more is asked."""


def facts(place: Path, roots: Sequence[Path] = ()) -> Facts:
    """What a command left: digests of its files, times aside; of tables and databases the rows.

    Args:
        place: Where it ran.
        roots: Files and folders that it made; default those that `COMMANDS` name.
    """
    out: Facts = {}
    for root in roots or (place / "k", place / "k.html"):
        files = [root] if root.is_file() else sorted(p for p in root.rglob("*") if p.is_file())
        for path in files:
            name = path.relative_to(place).as_posix()
            if not any(part.startswith(".") for part in path.relative_to(place).parts):
                out[name] = _said(path)
    for name in ("k.duckdb", "runs/esg.duckdb"):
        if (place / name).is_file():
            out[name] = _rows(place / name)
    return out


def _said(path: Path) -> str:
    data = path.read_bytes()
    if path.suffix == ".parquet":
        return _count(path)
    if path.suffix == ".html":
        return "a page" if data.rstrip().endswith(b"</html>") and b"\0" not in data else "damaged"
    if any(part in path.name for part in _TIMES):
        return "there" if data and b"\0" not in data else "damaged"
    return hashlib.sha256(data).hexdigest()


def _count(path: Path) -> str:
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        return f"{pq.read_table(path, page_checksum_verification=True).num_rows} rows"
    except (OSError, pa.ArrowException) as error:
        return f"damaged: {error}"


def _rows(path: Path) -> str:
    import duckdb

    sql = "SELECT count(*), bit_xor(hash(prompt, seed, outcome, reason, verified)) FROM scenes"
    try:
        with duckdb.connect(str(path), read_only=True) as connection:
            return repr(connection.execute(sql).fetchall())
    except duckdb.Error as error:
        return f"damaged: {error}"


def prepared_copy(ground: Path, place: Path, name: str) -> Path:
    """A copy of the ground with the cache that a kind of command begins with."""
    copied(ground, place)
    if name in WARM:
        shutil.copytree(ground / "cache", place / "cache")
    else:
        (place / "cache").mkdir()
        shutil.copytree(ground / "cache" / "prefect", place / "cache" / "prefect")
    return place


def arguments(name: str, place: Path) -> list[str]:
    """The command line of a kind of command in a place."""
    return [str(scene_of(place)) if a == "SCENE" else a for a in COMMANDS[name]]


def run(name: str, place: Path) -> Ended:
    """Runs a kind of command to its end."""
    return started(name, place).finish(600.0)


def started(name: str, place: Path) -> Started:
    """Starts a kind of command."""
    return start(arguments(name, place), place, place / "cache", fork=name not in SERVED)


def undisturbed(name: str, together: int, ground: Path, place: Path) -> Sound:
    """What commands leave that nothing disturbs, one after the other.

    Raises:
        RuntimeError: If one of them fails.
    """
    prepared_copy(ground, place, name)
    seconds = 0.0
    for _ in range(together):
        ended = run(name, place)
        if ended.wrong((0, 3)):
            raise RuntimeError(f"{name}, undisturbed: {ended.wrong((0, 3))}")
        seconds = max(seconds, ended.seconds)
    return facts(place), seconds


def kill(
    name: str,
    rng: random.Random,
    ground: Path,
    place: Path,
    times: int,
    together: int,
    sound: Sound,
) -> tuple[int, str]:
    """Kills a command some times, runs it to its end and compares with an undisturbed run.

    Args:
        name: Of `COMMANDS`.
        rng: Chooses moments.
        ground: A prepared folder.
        place: Where it happens.
        times: Kills before the run that may end.
        together: Commands of the kind that run at once in the place.
        sound: Of an undisturbed run.

    Returns:
        How many processes died of it, and `same`, or what differs.
    """
    prepared_copy(ground, place, name)
    died = 0
    for _ in range(times):
        running = [started(name, place) for _ in range(together)]
        time.sleep(rng.uniform(0.02, sound[1]))
        for command in running:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(command.pid, signal.SIGKILL)
        for command in running:
            ended = command.finish(60.0)
            died += ended.code == -signal.SIGKILL
            if ended.code != -signal.SIGKILL and ended.wrong((0, 3)):
                return died, f"while killed: {ended.wrong((0, 3))}"
    last = [started(name, place) for _ in range(together)]
    for ended in [command.finish(600.0) for command in last]:
        if ended.wrong((0, 3)):
            return died, f"after {died} kills: {ended.wrong((0, 3))}"
    return died, difference(sound[0], facts(place), name)


def difference(sound: Facts, found: Facts, name: str) -> str:
    """`same`, or the first files that differ.

    Args:
        sound: Of an undisturbed run.
        found: To be compared.
        name: Of the command; one that adds rows to the database of all runs may have added them
            before it was killed, or not.
    """
    if name in ("generate", "generate from cache", "bench"):
        sound, found = (
            {k: v for k, v in f.items() if k != "runs/esg.duckdb"} for f in (sound, found)
        )
    wrong = sorted({k for k in sound.keys() | found.keys() if sound.get(k) != found.get(k)})
    told = [
        f"{k} ({sound.get(k, 'absent')[:24]}, now {found.get(k, 'absent')[:60]})" for k in wrong
    ]
    return "same" if not wrong else f"{len(wrong)} differ: {', '.join(told[:3])}"
