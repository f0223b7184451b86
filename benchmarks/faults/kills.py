"""Commands killed by SIGKILL at random moments, one or two at once: run again, they end as ever."""

from __future__ import annotations

from collections.abc import Sequence
import contextlib
import os
from pathlib import Path
import random
import shutil
import signal
import time

from benchmarks.faults.ground import PROMPT, begin, copied, esg, finish

Facts = dict[str, bytes]

COMMANDS: dict[str, tuple[Sequence[str], tuple[float, float]]] = {
    "generate": (["generate", PROMPT, "--out", "k"], (1.0, 30.0)),
    "generate from cache": (["generate", PROMPT, "--out", "k"], (0.3, 5.0)),
    "bench": (["bench", "faults.yaml", "--runs", "1", "--out", "k"], (1.0, 30.0)),
    "dataset": (
        ["dataset", "--sample", "4", "--out", "k", "--workers", "1", "--resume"],
        (2.0, 40.0),
    ),
    "db rebuild": (["db", "rebuild"], (0.3, 2.5)),
    "db ingest": (["db", "ingest", "data", "--db", "k.duckdb"], (0.3, 2.5)),
    "export": (["export", "SCENE", "--to", "usd", "--out", "k"], (0.3, 4.0)),
    "report": (["report", "runs/bench-faults-batched-physx", "--out", "k.html"], (0.5, 4.0)),
}
"""Command lines, and the earliest and latest moment of the kill [s]."""
WARM = ("generate from cache", "db rebuild", "db ingest", "export", "report")
_TIMES = (
    "log.jsonl", "SHA256SUMS", "timings", "runs/", "run.json", ".lock", "card", "README",
)  # fmt: skip
"""Parts of names of files that hold times."""


def facts(place: Path) -> Facts:
    """What a command left: its files, times aside; of a database its rows."""
    out: Facts = {}
    for root in (place / "k", place / "k.html"):
        files = [root] if root.is_file() else sorted(p for p in root.rglob("*") if p.is_file())
        for path in files:
            name = path.relative_to(place).as_posix()
            if not any(t in name for t in _TIMES):
                out[name] = b"" if path.suffix in (".html", ".parquet") else path.read_bytes()
    for name in ("k.duckdb", "runs/esg.duckdb"):
        if (place / name).is_file():
            out[name] = _rows(place / name)
    return out


def _rows(path: Path) -> bytes:
    import duckdb

    sql = "SELECT count(*), bit_xor(hash(prompt, seed, outcome, reason, verified)) FROM scenes"
    with duckdb.connect(str(path), read_only=True) as connection:
        return repr(connection.execute(sql).fetchall()).encode()


def leftovers(place: Path) -> list[str]:
    """Temporary files in the folders of results; those of a killed command may stay a day."""
    return [
        p.name for p in place.rglob("*.tmp*") if "cache" not in p.parts and "tmp" not in p.parts
    ]


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
    from benchmarks.faults.ground import scene_of

    return [str(scene_of(place)) if a == "SCENE" else a for a in COMMANDS[name][0]]


def kill(
    name: str, rng: random.Random, ground: Path, place: Path, times: int, together: int
) -> str:
    """Kills a command some times, runs it to its end and compares with an undisturbed run.

    Args:
        name: Of `COMMANDS`.
        rng: Chooses moments.
        ground: A prepared folder.
        place: Where it happens.
        times: Kills before the run that may end.
        together: Commands of the kind that run at once in the place.

    Returns:
        `same`, or what differs.
    """
    undisturbed = prepared_copy(ground, place.with_name(place.name + "-sound"), name)
    for _ in range(together):
        first = esg(arguments(name, undisturbed), undisturbed, undisturbed / "cache")
        if first.wrong((0, 3)):
            return f"undisturbed: {first.wrong((0, 3))}"
    prepared_copy(ground, place, name)
    line, (early, late) = arguments(name, place), COMMANDS[name][1]
    for _ in range(times):
        started = [begin(line, place, place / "cache") for _ in range(together)]
        time.sleep(rng.uniform(early, late))
        for command in started:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(command.pid, signal.SIGKILL)
        for command in started:
            ended = finish(command, 60.0, time.monotonic())
            if ended.code not in (-9, 0, 3):
                return f"while killed: {ended.wrong((0, 3))}"
    now = time.monotonic()
    ended_all = [finish(c, 600.0, now) for c in [begin(line, place, place / "cache")
                                                 for _ in range(together)]]  # fmt: skip
    for ended in ended_all:
        if ended.wrong((0, 3)):
            return f"after {times} kills: {ended.wrong((0, 3))}"
    return _difference(facts(undisturbed), facts(place), name)


def _difference(sound: Facts, found: Facts, name: str) -> str:
    if name in ("generate", "generate from cache", "bench"):
        # A killed run may have recorded its row before it was killed, or not.
        sound, found = (
            {k: v for k, v in f.items() if k != "runs/esg.duckdb"} for f in (sound, found)
        )
    wrong = sorted({k for k in sound.keys() | found.keys() if sound.get(k) != found.get(k)})
    return "same" if not wrong else f"differs: {', '.join(wrong[:5])}"
