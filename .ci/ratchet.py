#!/usr/bin/env python3
"""What may only shrink: faults of the house by kind and room, held by `.ci/ratchet.json`.

    python .ci/ratchet.py            # exit code 1 if a number grew, or shrank and was not written
    python .ci/ratchet.py --update   # writes the lower numbers; higher ones stay refused
    python .ci/ratchet.py --no-types # without the type checker, which takes a minute or two

A room that is not in the file has no faults. Who must raise a number writes it there by hand, where
a reader of the change sees it.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from dataclasses import dataclass
import json
from pathlib import Path
import subprocess
import sys
import tomllib

ROOT = Path(__file__).resolve().parents[1]
FILE = ROOT / ".ci" / "ratchet.json"
LAYERS = ROOT / ".ci" / "layers.toml"
MOST_BRANCHES = 15
"""Cyclomatic complexity above which a function is hard to follow (ruff's C901)."""
SHOWN = 12

sys.path.insert(0, str(ROOT))
from benchmarks.house import PACKAGES, Place, measure, room_of, too_long  # noqa: E402

Counts = dict[str, dict[str, int]]


@dataclass(frozen=True)
class Kind:
    """A kind of fault: what it is called, and what to do about one."""

    title: str
    remedy: str


KINDS = {
    "type_errors": Kind("type errors", "give the types; see `pyright PATH`"),
    "complex_functions": Kind(
        f"functions with more than {MOST_BRANCHES} branches",
        "name the cases: a table, a record, a function for each idea",
    ),
    "functions_over_80_lines": Kind(
        "functions over 80 lines", "split by idea and name the parts; data belongs in a table"
    ),
    "functions_over_100_lines": Kind(
        "functions over 100 lines", "split by idea and name the parts; data belongs in a table"
    ),
    "classes_over_2_deep": Kind(
        "classes more than two deep", "pass a record to plain functions in place of inheriting"
    ),
    "folders_over_25_modules": Kind(
        "folders with more than 25 modules", "give each idea a folder of its own"
    ),
    "import_circles": Kind(
        "import circles at run time",
        "move what both need below them, or pass it as an argument",
    ),
    "layer_exceptions": Kind(
        "exceptions from the layers (.ci/layers.toml)", "move what is needed to a lower room"
    ),
}


def faults(types: bool) -> dict[str, list[Place]]:
    """All faults of the checkout by kind."""
    house = measure(ROOT)
    found = {
        "complex_functions": complex_functions(),
        "functions_over_80_lines": house.functions,
        "functions_over_100_lines": too_long(house.functions),
        "classes_over_2_deep": house.chains,
        "folders_over_25_modules": house.folders,
        "import_circles": house.circles,
        "layer_exceptions": layer_exceptions(),
    }
    return ({"type_errors": type_errors()} if types else {}) | found


def type_errors() -> list[Place]:
    """What pyright, as pyproject.toml configures it, has to say."""
    # Told where Python is, or it reads the libraries of the first one on the path.
    command = [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, "--outputjson"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"pyright failed ({done.returncode}): {done.stderr or done.stdout}")
    return [
        _place(d["file"], d["range"]["start"]["line"] + 1, d["message"].splitlines()[0][:200])
        for d in json.loads(done.stdout)["generalDiagnostics"]
        if d["severity"] == "error"
    ]


def complex_functions() -> list[Place]:
    """Functions that ruff finds too complex."""
    limit = f"lint.mccabe.max-complexity={MOST_BRANCHES}"
    command = [sys.executable, "-m", "ruff", "check", *PACKAGES, "--select", "C901", "--config",
               limit, "--output-format", "json", "--exit-zero"]  # fmt: skip
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return [
        _place(d["filename"], d["location"]["row"], d["message"]) for d in json.loads(done.stdout)
    ]


def layer_exceptions() -> list[Place]:
    """Imports that the layers let pass although they point upwards."""
    contracts = tomllib.loads(LAYERS.read_text())["tool"]["importlinter"]["contracts"]
    lines = [line for c in contracts for line in c.get("ignore_imports", ())]
    return [Place("all", LAYERS.relative_to(ROOT).as_posix(), line, 1) for line in lines]


def _place(file: str, line: int, text: str) -> Place:
    path = Path(file).resolve().relative_to(ROOT)
    return Place(room_of(path), f"{path.as_posix()}:{line}", text, 1)


def count(found: dict[str, list[Place]]) -> Counts:
    """Numbers by kind and room."""
    out: Counts = {}
    for kind, places in found.items():
        rooms = out.setdefault(kind, {})
        for place in places:
            rooms[place.room] = rooms.get(place.room, 0) + 1
    return out


def grown(allowed: Counts, found: dict[str, list[Place]]) -> Iterable[str]:
    """A message for every number that is higher than the file allows."""
    for kind, rooms in count(found).items():
        for room, now in sorted(rooms.items()):
            before = allowed.get(kind, {}).get(room, 0)
            if now <= before:
                continue
            yield f"{room}: {KINDS[kind].title}: {now}, at most {before} allowed"
            places = [p for p in found[kind] if p.room == room]
            for place in places[:SHOWN]:
                yield f"    {place.where}  {place.text}"
            if len(places) > SHOWN:
                yield f"    and {len(places) - SHOWN} more"
            yield f"  remedy: {KINDS[kind].remedy}"


def lowered(allowed: Counts, now: Counts) -> Counts:
    """The file with every number that shrank; what was not counted stays."""
    out: Counts = {}
    for kind, rooms in allowed.items():
        counted = now.get(kind)
        less = {r: n if counted is None else min(n, counted.get(r, 0)) for r, n in rooms.items()}
        out[kind] = {room: n for room, n in sorted(less.items()) if n}
    return out


def main(argv: list[str] | None = None) -> int:
    """Prints every violation with its place and remedy; returns the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--update", action="store_true", help="write the numbers that shrank")
    parser.add_argument("--no-types", action="store_true", help="leave the type checker out")
    args = parser.parse_args(argv)
    allowed: Counts = json.loads(FILE.read_text())
    found = faults(types=not args.no_types)
    worse = list(grown(allowed, found))
    better = lowered(allowed, count(found))
    shrank = [
        f"{room}: {KINDS[kind].title}: {better[kind].get(room, 0)}, no longer {before}"
        for kind, rooms in allowed.items()
        for room, before in rooms.items()
        if better[kind].get(room, 0) < before
    ]
    for line in [*worse, *shrank]:
        print(line)
    if args.update:
        FILE.write_text(json.dumps(better, indent=2) + "\n")
    elif shrank:
        print("Fewer than written down: run `python .ci/ratchet.py --update` and commit the file.")
    left = {k: sum(v.values()) for k, v in better.items()}
    print("allowed from here on: " + ", ".join(f"{n} {KINDS[k].title}" for k, n in left.items()))
    return int(bool(worse) or (bool(shrank) and not args.update))


if __name__ == "__main__":
    sys.exit(main())
