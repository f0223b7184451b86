"""Faults, done to everything that reads or writes; exits with 1 if something does not hold.

    python -m benchmarks.faults malformed --count 100 [--only suite:17]
    python -m benchmarks.faults flips --count 30
    python -m benchmarks.faults kills --count 3 [--only "db rebuild"]

What must hold: malformed input ends with the right exit code, a message and no traceback within
30 s and 2 GiB; a flipped bit is noticed or changes nothing; a killed command, run again, leaves
what an undisturbed one leaves, also when two of them are killed at once. Prints a Markdown table.
"""

from __future__ import annotations

import argparse
from collections import Counter
from pathlib import Path
import random
import tempfile

from benchmarks.faults import flips, kills, malformed
from benchmarks.faults.ground import prepared


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("what", choices=("malformed", "flips", "kills"))
    parser.add_argument("--count", type=int, default=10, help="faults of every kind")
    parser.add_argument("--only", default="", help="one kind, or one fault of it (KIND:NUMBER)")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--ground", type=Path, help="folder of the undisturbed work; kept")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="esg-faults-") as folder:
        ground = prepared(args.ground or Path(folder) / "ground")
        run = {"malformed": _malformed, "flips": _flips, "kills": _kills}[args.what]
        return run(ground, Path(folder) / "place", args)


def _chosen(names: list[str], only: str) -> tuple[list[str], int | None]:
    kind, _, number = only.partition(":")
    return [n for n in names if kind in ("", n)], int(number) if number else None


def _malformed(ground: Path, place: Path, args: argparse.Namespace) -> int:
    malformed.load_libraries()
    names, number = _chosen(list(malformed.KINDS), args.only)
    wrong = total = 0
    print("| input | inputs | exit codes | slowest s | wrong |\n| --- | ---: | --- | ---: | ---: |")
    for name in names:
        count = max(1, round(args.count * malformed.KINDS[name][1]))
        codes: Counter[str] = Counter()
        slowest, bad = 0.0, []
        for k in range(count) if number is None else [number]:
            made, ended, fault = malformed.case(name, k, ground, place)
            codes[str(ended.code)] += 1
            slowest = max(slowest, ended.seconds)
            if fault:
                bad.append(f"    {name}:{k} {made[0]}: {fault}")
        told = ", ".join(f"{n} x {code}" for code, n in sorted(codes.items()))
        print(
            f"| {name} | {sum(codes.values())} | {told} | {slowest:.1f} | {len(bad)} |", flush=True
        )
        print("".join(f"{line}\n" for line in bad), end="", flush=True)
        wrong, total = wrong + len(bad), total + sum(codes.values())
    print(f"\n{total} inputs, {wrong} wrong")
    return int(wrong > 0)


def _flips(ground: Path, place: Path, args: argparse.Namespace) -> int:
    malformed.load_libraries()
    names, number = _chosen(list(flips.KINDS), args.only)
    wrong = 0
    print("| file | flips | noticed | no effect | another number | wrong |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    for name in names:
        found = [
            flips.flip(flips.KINDS[name], random.Random(f"{args.seed} {name} {k}"), ground, place)
            for k in (range(args.count) if number is None else [number])
        ]
        ends = ("noticed", "no effect", "another number")
        bad = [f for f in found if f not in ends]
        told = " | ".join(str(n) for n in (*(found.count(end) for end in ends), len(bad)))
        print(f"| {name} | {len(found)} | {told} |", flush=True)
        print("".join(f"    {line}\n" for line in bad), end="", flush=True)
        wrong += len(bad)
    return int(wrong > 0)


def _kills(ground: Path, place: Path, args: argparse.Namespace) -> int:
    names, _ = _chosen(list(kills.COMMANDS), args.only)
    wrong = 0
    print("| command | at once | kills | after them |\n| --- | ---: | ---: | --- |")
    for name in names:
        for together in (1, 2):
            rng = random.Random(f"{args.seed} {name} {together}")
            if name == "dataset" and together == 2:
                continue  # a folder takes one writer: the second is told so
            end = kills.kill(name, rng, ground, place, args.count, together)
            print(f"| {name} | {together} | {args.count * together} | {end} |", flush=True)
            wrong += end != "same"
    return int(wrong > 0)


if __name__ == "__main__":
    raise SystemExit(main())
