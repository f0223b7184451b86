"""Single flipped bits in every kind of file: noticed or without effect, never another result."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import json
from pathlib import Path
import random
import shutil

from benchmarks.faults import kills
from benchmarks.faults.ground import HALF, PROMPT, Ended, copied, esg, forked, scene_of

ROWS = "SELECT * EXCLUDE (artifacts, seconds, cached_stages) FROM scenes ORDER BY ALL"


@dataclass(frozen=True)
class Kind:
    """A kind of file, and the command that reads it.

    Args:
        pattern: Of its files, below the folder.
        arguments: Of the command.
        result: What the command made of it, to be compared; None if nothing can be said.
        codes: Exit codes of a command that noticed.
        sealed: Whether the file has checksums; a text that people edit has none, and a digit of it
            that flips is another number.
        alone: Whether the command needs a process of its own, since it starts others.
        share: Of the flips of others that it gets; less for what takes long.
        told: What the command prints where it noticed and went on without the file.
    """

    pattern: str
    arguments: Callable[[Path, Path], list[str]]
    result: Callable[[Path, Ended], object]
    codes: tuple[int, ...] = (1, 2, 3)
    sealed: bool = True
    told: str = "\0"
    alone: bool = False
    share: float = 1.0


def _out(place: Path, ended: Ended) -> object:
    return ended.out


def _rows(place: Path, ended: Ended) -> object:
    asked = forked(["sql", "--json", "--db", "new.duckdb", ROWS], place, place / "cache")
    return json.loads(asked.out)["rows"] if asked.code == 0 else None


def _exported(place: Path, ended: Ended) -> object:
    return {p.name: p.read_bytes() for p in sorted((place / "o").rglob("*")) if p.is_file()}


def _ingest(place: Path, path: Path) -> list[str]:
    return ["db", "ingest", str(path), "--db", "new.duckdb"]


def _export(to: str) -> Callable[[Path, Path], list[str]]:
    return lambda place, path: ["export", str(scene_of(place)), "--to", to, "--out", "o"]


def _verify(place: Path, path: Path) -> list[str]:
    return ["db", "verify", str(path), "--db", "none.duckdb"]


def _sql(place: Path, path: Path) -> list[str]:
    return ["sql", "--json", "--db", str(path), ROWS]


def _again(place: Path, path: Path) -> list[str]:
    return ["generate", PROMPT, "--out", "o"]


def _replay(place: Path, path: Path) -> list[str]:
    return ["replay", str(scene_of(place)), "--json"]


def _resume(place: Path, path: Path) -> list[str]:
    return [*HALF, "--resume"]


def _half_made(place: Path, ended: Ended) -> object:
    """The marks of batches but for their times, and the rows of their tables."""
    marks = [json.loads(p.read_bytes()) for p in sorted((place / "half").glob("marks/*.json"))]
    rows = kills.facts(place, [place / "half" / "parts"])
    return [
        [m[k] for k in ("number", "scenes", "verified", "outcomes", "failures")] for m in marks
    ], rows


def _scene_made(place: Path, ended: Ended) -> object:
    skipped = ("log.jsonl", "SHA256SUMS")  # times, and the sum of them
    return {
        p.name: p.read_bytes()
        for p in sorted((place / "o").rglob("*"))
        if p.is_file() and p.name not in skipped and "failures" not in p.name
    }


KINDS = {
    "Parquet, scenes": Kind("runs/parts/scenes/*.parquet", _ingest, _rows),
    "Parquet, trajectories": Kind(
        "runs/parts/trajectories/*.parquet", _verify, lambda place, ended: "whole"
    ),
    "database": Kind("runs/esg.duckdb", _sql, _out),
    "recording (MCAP)": Kind("runs/*/rollout.mcap", _export("mcap"), _exported),
    "rollout (NPZ)": Kind("runs/*/rollout.npz", _verify, lambda place, ended: "whole"),
    "manifest": Kind("runs/*/manifest.json", _export("mjcf"), _exported, sealed=False),
    "document": Kind(
        "runs/*/esg.json", lambda place, path: ["check", str(path)], _out, sealed=False
    ),
    "stage results": Kind("cache/artifacts/*/*/data/**/*", _again, _scene_made),
    "compiled classes": Kind("cache/classes/**/*", _replay, _out),
    "emitted classes": Kind("runs/a*/unreal/*", _replay, _out, told='"proof": "program"'),
    "marks of batches": Kind("half/marks/*.json", _resume, _half_made, alone=True, share=0.1),
    "parts of batches": Kind("half/parts/*/*.parquet", _verify, lambda place, ended: "whole"),
    "marks of stage results": Kind("cache/artifacts/*/*/artifact.json", _again, _scene_made),
}


def flip(kind: Kind, rng: random.Random, ground: Path, place: Path) -> str:
    """Flips a bit of one file; returns `noticed`, `no effect` or what else happened.

    Args:
        kind: Of the file.
        rng: Chooses file and bit.
        ground: A prepared folder.
        place: Where the fault is done; anew every time.
    """
    copied(ground, place)
    shutil.copytree(ground / "cache", place / "cache")
    files = [p for p in sorted(place.glob(kind.pattern)) if p.is_file() and p.stat().st_size]
    path = rng.choice(files)
    where = path.relative_to(place)
    if (kind, str(where)) not in _sound:
        _sound[kind, str(where)] = kind.result(place, _done(kind, place, path))
        copied(ground, place)
        shutil.copytree(ground / "cache", place / "cache")
    data = bytearray(path.read_bytes())
    at = rng.randrange(len(data))
    data[at] ^= 1 << rng.randrange(8)
    path.write_bytes(data)
    ended = _done(kind, place, path)
    wrong = ended.wrong((0, *kind.codes))
    if wrong:
        return f"{where} byte {at}: {wrong}"
    if ended.code != 0 or kind.told in ended.out:
        return "noticed"
    if kind.result(place, ended) == _sound[kind, str(where)]:
        return "no effect"
    return f"{where} byte {at}: another result" if kind.sealed else "another number"


_sound: dict[tuple[Kind, str], object] = {}
"""What commands made of files before a bit flipped, by kind and file."""


def _done(kind: Kind, place: Path, path: Path) -> Ended:
    if kind.alone:
        return esg(kind.arguments(place, path), place, place / "cache")
    return forked(kind.arguments(place, path), place, place / "cache")
