"""Faults, done to everything that reads or writes; exits with 1 if something does not hold.

    python -m benchmarks.faults malformed --count 100 [--only suite:17]
    python -m benchmarks.faults flips --count 30
    python -m benchmarks.faults bits --count 250
    python -m benchmarks.faults kills --count 4 --rounds 2 [--only "db rebuild"]
    python -m benchmarks.faults pairs
    python -m benchmarks.faults losses --count 25 [--log FILE]
    python -m benchmarks.faults disks --count 3
    python -m benchmarks.faults clocks
    python -m benchmarks.faults stalls
    python -m benchmarks.faults interrupts --count 3
    python -m benchmarks.faults limits
    python -m benchmarks.faults attacks [--before CHECKOUT]

What must hold: malformed input ends with the right exit code, a message and no traceback within
30 s and 2 GiB; a flipped bit is noticed or changes nothing; a killed command, run again, leaves
what an undisturbed one leaves, also when two of them are killed at once, or the power fails, the
disk is full or read-only; a clock that jumps changes nothing; a server that says nothing is left.
Prints Markdown tables. `--jobs` spreads the work over so many processes. `--log` keeps each power
loss as it ends: a run that is stopped goes on where it was, and other seeds add to the table.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import groupby
from pathlib import Path
import random
import tempfile
import time
from typing import TypeVar

from benchmarks.faults import (
    attacks,
    bits,
    clocks,
    diary,
    disks,
    flips,
    interrupts,
    kills,
    limits,
    losses,
    malformed,
    stalls,
)
from benchmarks.faults.ground import ROOT, prepared
from benchmarks.faults.spread import spread

T = TypeVar("T")
R = TypeVar("R")


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=tuple(_FAULTS), nargs="+")
    parser.add_argument("--count", type=int, default=10, help="faults of every kind")
    parser.add_argument("--rounds", type=int, default=1, help="of kills, with an end each")
    parser.add_argument("--only", default="", help="one kind, or one fault of it (KIND:NUMBER)")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=1, help="faults done at once")
    parser.add_argument("--ground", type=Path, help="folder of the undisturbed work; kept")
    parser.add_argument("--log", type=Path, help="losses: a line of JSON for each; added to")
    parser.add_argument("--before", type=Path, help="attacks: an earlier checkout, to compare")
    args = parser.parse_args()
    if "losses" in args.what:
        losses.preload_here(Path(tempfile.mkdtemp(prefix="esg-losses-")))
    malformed.load_libraries()
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="esg-faults-") as folder:
        ground = args.ground or Path(folder) / "ground"
        if args.what != ["attacks"]:  # they make scenes of their own
            ground = prepared(ground).resolve()
        for what in args.what:
            started = time.monotonic()
            place = Path(folder).resolve() / what
            wrong += _FAULTS[what](ground, place, args)
            print(f"\n{what}: {time.monotonic() - started:.0f} s\n", flush=True)
    return int(wrong > 0)


def _chosen(names: Iterable[str], only: str, count: int) -> list[tuple[str, int]]:
    """Kinds and numbers of the faults to be done."""
    kind, _, number = only.partition(":")
    numbers = [int(number)] if number else range(count)
    return [(name, k) for name in names if kind in ("", name) for k in numbers]


def _table(heads: Sequence[str]) -> None:
    print(f"| {' | '.join(heads)} |\n| --- |{' ---: |' * (len(heads) - 1)}", flush=True)


def _row(cells: Sequence[object], faults: Sequence[str]) -> int:
    """Prints a row and below it what is wrong; returns how much."""
    print(f"| {' | '.join(str(c) for c in cells)} |")
    print("".join(f"    {line}\n" for line in faults), end="", flush=True)
    return len(faults)


def _by_name(
    work: Callable[[Path, tuple[str, int]], R], items: list[tuple[str, int]],
    place: Path, args: argparse.Namespace,
) -> Iterator[tuple[str, list[tuple[int, R]]]]:  # fmt: skip
    """Results with their numbers, by kind."""
    found = zip(items, spread(work, items, place, args.jobs), strict=True)
    for name, of_name in groupby(found, key=lambda pair: pair[0][0]):
        yield name, [(number, result) for (_, number), result in of_name]


def _one_malformed(ground: Path, place: Path, item: tuple[str, int]) -> tuple[str, float, str]:
    made, ended, fault = malformed.case(*item, ground, place)
    said = f"{item[0]}:{item[1]} {made[0]}: {fault}" if fault else ""
    return str(ended.code), ended.seconds, said


def _malformed(ground: Path, place: Path, args: argparse.Namespace) -> int:
    items = [
        (name, k)
        for name, k in _chosen(malformed.KINDS, args.only, args.count)
        if args.only or k < max(1, round(args.count * malformed.KINDS[name][1]))
    ]
    _table(("input", "inputs", "exit codes", "slowest s", "wrong"))
    wrong = 0
    for name, found in _by_name(partial(_one_malformed, ground), items, place, args):
        codes = Counter(code for _, (code, _, _) in found)
        told = ", ".join(f"{n} x {code}" for code, n in sorted(codes.items()))
        slowest = max(seconds for _, (_, seconds, _) in found)
        bad = [fault for _, (_, _, fault) in found if fault]
        wrong += _row((name, len(found), told, f"{slowest:.1f}", len(bad)), bad)
    print(f"\n{len(items)} inputs, {wrong} wrong")
    return wrong


def _one_flip(ground: Path, seed: int, place: Path, item: tuple[str, int]) -> str:
    name, number = item
    return flips.flip(flips.KINDS[name], random.Random(f"{seed} {name} {number}"), ground, place)


def _flips(ground: Path, place: Path, args: argparse.Namespace) -> int:
    items = [
        (name, k)
        for name, k in _chosen(flips.KINDS, args.only, args.count)
        if args.only or k < max(1, round(args.count * flips.KINDS[name].share))
    ]
    ends = ("noticed", "no effect", "another number")
    _table(("file", "flips", *ends, "wrong"))
    wrong = 0
    for name, found in _by_name(partial(_one_flip, ground, args.seed), items, place, args):
        bad = [f"{name}:{k} {end}" for k, end in found if end not in ends]
        counts = Counter(end for _, end in found)
        wrong += _row((name, len(found), *(counts[end] for end in ends), len(bad)), bad)
    print(f"\n{len(items)} flips, {wrong} wrong")
    return wrong


Pair = tuple[str, int]
"""A command, and how many of it run at once."""


def _undisturbed(ground: Path, place: Path, pair: Pair) -> kills.Sound | str:
    try:
        return kills.undisturbed(*pair, ground, place)
    except RuntimeError as error:
        return str(error)


def _one_kill(
    ground: Path, sound: dict[Pair, kills.Sound], args: argparse.Namespace,
    place: Path, item: tuple[Pair, int],
) -> tuple[int, str]:  # fmt: skip
    (name, together), number = item
    rng = random.Random(f"{args.seed} {name} {together} {number}")
    return kills.kill(name, rng, ground, place, args.count, together, sound[name, together])


def _kills(ground: Path, place: Path, args: argparse.Namespace) -> int:
    names = [name for name, _ in _chosen(kills.COMMANDS, args.only, 1)]
    pairs = [(n, t) for n in names for t in (1, 2) if t == 1 or n not in kills.ALONE]
    return _killed(ground, place, args, pairs)


def _pairs(ground: Path, place: Path, args: argparse.Namespace) -> int:
    """Two of everything at once, and nobody killed."""
    names = [name for name, _ in _chosen(kills.COMMANDS, args.only, 1)]
    args = argparse.Namespace(**{**vars(args), "count": 0})
    return _killed(ground, place, args, [(n, 2) for n in names if n not in kills.ALONE])


def _killed(ground: Path, place: Path, args: argparse.Namespace, pairs: list[Pair]) -> int:
    found = zip(pairs, spread(partial(_undisturbed, ground), pairs, place, args.jobs), strict=True)
    sound, wrong = _sound_ones(found)
    items = [(pair, k) for pair in sound for k in range(args.rounds)]
    _table(("command", "at once", "killed", "reruns", "equal"))
    total = 0
    work = partial(_one_kill, ground, sound, args)
    ends = zip(items, spread(work, items, place, args.jobs), strict=True)
    for (name, together), group in groupby(ends, key=lambda pair: pair[0][0]):
        results = [result for _, result in group]
        bad = [end for _, end in results if end != "same"]
        died = sum(n for n, _ in results)
        total += died
        wrong += _row((name, together, died, len(results), len(results) - len(bad)), bad)
    print(f"\n{total} killed, {wrong} wrong")
    return wrong


def _sound_ones(found: Iterable[tuple[T, R | str]]) -> tuple[dict[T, R], int]:
    """Undisturbed runs that were sound, and how many were not; those are told."""
    sound: dict[T, R] = {}
    wrong = 0
    for what, result in found:
        if isinstance(result, str):
            print(f"undisturbed: {result}", flush=True)
            wrong += 1
        else:
            sound[what] = result
    return sound, wrong


def _before_loss(ground: Path, place: Path, name: str) -> tuple[kills.Facts, int] | str:
    try:
        return losses.sound(name, ground, place)
    except RuntimeError as error:
        return str(error)


def _one_loss(
    ground: Path, sound: dict[str, tuple[kills.Facts, int]], seed: int, log: Path,
    place: Path, item: tuple[str, int],
) -> None:  # fmt: skip
    name, number = item
    rng = random.Random(f"{seed} {name} {number}")
    found = losses.loss(name, rng, ground, place, sound[name])
    diary.append(log, diary.Entry(name, seed, number, sound[name][1], found))


def _losses(ground: Path, place: Path, args: argparse.Namespace) -> int:
    log = args.log or place.with_suffix(".jsonl")
    done = {(e.name, e.seed, e.number) for e in diary.entries(log)}
    chosen = _chosen(kills.COMMANDS, args.only, args.count)
    items = [item for item in chosen if (item[0], args.seed, item[1]) not in done]
    names = list(dict.fromkeys(name for name, _ in items))
    work = partial(_before_loss, ground)
    sound, wrong = _sound_ones(zip(names, spread(work, names, place, args.jobs), strict=True))
    for name in [name for name in sound if not sound[name][1]]:
        print(f"{name}: changes no files", flush=True)
        del sound[name]
    items = [item for item in items if item[0] in sound]
    run = partial(_one_loss, ground, sound, args.seed, log)
    for _ in spread(run, items, place, args.jobs):
        pass
    _table(diary.HEADS)
    found = diary.entries(log)
    wrong += sum(_row(cells, bad) for cells, bad in diary.rows(found, kills.COMMANDS))
    print(f"\n{len(found)} power losses, {wrong} wrong")
    return wrong


def _told(
    heads: Sequence[str], run: Callable[[Path, Path, str], Sequence[tuple[Sequence[object], str]]],
    names: Iterable[str], ground: Path, place: Path, args: argparse.Namespace,
) -> int:  # fmt: skip
    """A table whose rows faults of a kind give themselves, with what is wrong with each."""
    chosen = [name for name, _ in _chosen(names, args.only, 1)]
    _table(heads)
    wrong = 0
    for rows in spread(partial(run, ground), chosen, place, args.jobs):
        wrong += sum(_row(cells, [fault] if fault else []) for cells, fault in rows)
    return wrong


def _disks(ground: Path, place: Path, args: argparse.Namespace) -> int:
    run = partial(disks.filled, args.seed, args.count)
    return _told(disks.HEADS, run, kills.COMMANDS, ground, place, args)


def _clocks(ground: Path, place: Path, args: argparse.Namespace) -> int:
    return _told(clocks.HEADS, clocks.jumped, kills.COMMANDS, ground, place, args)


def _stalls(ground: Path, place: Path, args: argparse.Namespace) -> int:
    return _told(stalls.HEADS, stalls.stalled, stalls.SERVERS, ground, place, args)


def _bits(ground: Path, place: Path, args: argparse.Namespace) -> int:
    run = partial(bits.flipped, args.seed, args.count)
    return _told(bits.HEADS, run, bits.READERS, ground, place, args)


def _interrupts(ground: Path, place: Path, args: argparse.Namespace) -> int:
    run = partial(interrupts.interrupted, args.seed, args.count)
    return _told(interrupts.HEADS, run, kills.COMMANDS, ground, place, args)


def _limits(ground: Path, place: Path, args: argparse.Namespace) -> int:
    return _told(limits.HEADS, limits.exceeded, limits.LIMITS, ground, place, args)


def _one_attack(checkouts: dict[Path, Path], place: Path, name: str) -> list[list[str]]:
    return [attacks.attacked(name, made, place, of) for of, made in checkouts.items()]


def _attacks(ground: Path, place: Path, args: argparse.Namespace) -> int:
    checkouts = [args.before.resolve()] if args.before else []
    checkouts.append(ROOT)
    made = {c: attacks.made_by(c, place / f"made{k}") for k, c in enumerate(checkouts)}
    names = [name for name, _ in _chosen(attacks.ATTACKS, args.only, 1)]
    _table(("attack", *(["before"] if args.before else []), "now"))
    wrong = 0
    for name, ends in zip(
        names, spread(partial(_one_attack, made), names, place, args.jobs), strict=True
    ):
        _row((name, *("; ".join(end) or "nothing" for end in ends)), [])
        wrong += len(ends[-1])
    print(f"\n{len(names)} attacks, {wrong} wrong")
    return wrong


_FAULTS: dict[str, Callable[[Path, Path, argparse.Namespace], int]] = {
    "malformed": _malformed,
    "flips": _flips,
    "bits": _bits,
    "kills": _kills,
    "pairs": _pairs,
    "losses": _losses,
    "disks": _disks,
    "clocks": _clocks,
    "stalls": _stalls,
    "interrupts": _interrupts,
    "limits": _limits,
    "attacks": _attacks,
}


if __name__ == "__main__":
    raise SystemExit(main())
