"""Leave-one-out of the rules reader: what each branch, operand and step is worth, and pruning.

    python -m benchmarks.pruning units                       # how many there are of each kind
    python -m benchmarks.pruning measure --out effects.json  # leaves each out in turn
    python -m benchmarks.pruning choose --effects effects.json --out chosen.json
    python -m benchmarks.pruning prune --chosen chosen.json  # writes the shorter source
    python -m benchmarks.pruning check --chosen chosen.json  # same documents as when chosen?
    python -m benchmarks.pruning table --chosen chosen.json --out docs/results/pruning.md

A unit is worth its place if at least `ENOUGH` development prompts of independent origin lose labels
without it. What is left goes in batches, cheapest for its lines first, until a budget is spent. The
held-out sets count in totals alone. Each `--jobs` is a forked process.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterable
from dataclasses import asdict
from functools import partial
import hashlib
import json
from pathlib import Path
import random
import sys
import time
from typing import Any

from benchmarks.drafting import FILES
from benchmarks.pruning import corpora, dead, rewrite
from benchmarks.pruning.choice import Choice
from benchmarks.pruning.effect import Bench, Build, Effect, Outcome, cores, in_parallel
from benchmarks.pruning.rows import ROW_KINDS, cut_rows, find_rows, table_without
from benchmarks.pruning.units import KINDS as SWITCH_KINDS
from benchmarks.pruning.units import Package, Unit

ROOT = Path(__file__).resolve().parents[2]
FOLDER = "esg/draft"
LEAVE = ("llm/*", "__init__.py", "screening.py", "registry.py")
"""Files without units: the language-model drafter, the doors, and what refuses bad input."""
KEEP_CALLS = ("mark_used",)
"""Steps that account for the prompt's words, which no label sees."""
OUTSIDE = ("esg", "tests", "benchmarks", "tasks", "flows")
KINDS = (*SWITCH_KINDS, *ROW_KINDS)
TOGETHER = 24
"""Rows that are first left out together, to see which prompts any of them changes."""
ENOUGH = 3
WITHIN = {"dev": 2.0, corpora.REWORDINGS: 0.5}
"""Largest drop of any figure [points] while units are chosen."""


def package(args: argparse.Namespace) -> Package:
    """The reader's modules, those of `--only` with units."""
    found = Package(ROOT, args.folder, [*LEAVE, *args.leave])
    if args.only:
        found.kept |= {n for n in found.trees if not any(n.endswith(o) for o in args.only)}
    return found


def _bench(args: argparse.Namespace, held_out: bool, soak: int = 0) -> Bench:
    build = Build(package(args), corpora.Reader.package)
    cases = corpora.cases(args.every, held_out, args.files, soak)
    with build.installed():
        bench = Bench(build, corpora.Reader(), cases)
        bench.warm()
    return bench


def _report_time(what: str, began: float) -> None:
    print(f"{what}: {time.perf_counter() - began:.0f} s", file=sys.stderr, flush=True)


def _sources(units: Iterable[Unit]) -> dict[str, str]:
    files = sorted({u.file for u in units})
    return {f: hashlib.sha256((ROOT / f).read_bytes()).hexdigest()[:16] for f in files}


def wanted(unit: Unit, kinds: Iterable[str]) -> bool:
    """Whether a unit may go at all."""
    name = unit.text.partition("(")[0].rpartition(".")[2]
    kept = unit.kind == "step" and name in KEEP_CALLS
    return unit.kind in kinds and not kept


def measure(args: argparse.Namespace) -> int:
    """Leaves every unit out in turn and writes what that does."""
    began = time.perf_counter()
    bench = _bench(args, held_out=False)
    _report_time(f"{len(bench.cases)} prompts read", began)
    units = [u for u in bench.build.units if wanted(u, args.kinds)]
    if args.sample:
        units = random.Random(0).sample(units, min(args.sample, len(units)))
    numbers = [bench.build.numbers[u.key] for u in units]
    began = time.perf_counter()
    stay = _reach_rows(bench, numbers, args.jobs)
    _report_time("reach of rows", began)
    heavy = sorted((n for n in numbers if n in bench.reached), key=lambda n: -len(bench.reached[n]))

    def work(number: int) -> Effect:
        return bench.effect([number], args.most, ENOUGH, seed=number, seen=args.seen)

    effects = _measured(args.out, bench) | stay
    heavy = [n for n in heavy if n not in effects]
    part = max(64, 16 * args.jobs)
    for at in range(0, len(heavy), part):
        if time.perf_counter() - began > 60.0 * args.minutes:
            break
        some = heavy[at : at + part]
        effects |= zip(some, in_parallel(work, some, args.jobs), strict=True)
        _report_time(f"{min(at + part, len(heavy))} of {len(heavy)} units left out", began)
    none = Effect(0, 0, 0, (), 0, 0.0)
    units = [u for u, n in zip(units, numbers, strict=True)
             if n in effects or n not in bench.reached]  # fmt: skip
    if len(units) < len(numbers):
        print(f"{len(numbers) - len(units)} units are left to measure: say it again")
    rows = [asdict(u) | asdict(effects.get(bench.build.numbers[u.key], none)) for u in units]
    data = {"sources": _sources(bench.build.units), "prompts": len(bench.cases), "units": rows}
    Path(args.out).write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
    print_classes(rows)
    return 0


def _reach_rows(bench: Bench, numbers: list[int], jobs: int) -> dict[int, Effect]:
    """Fills in which prompts the rows among some units may change; effects of those that must stay.

    The package cannot be imported without the latter.
    """
    rows = [n for n in numbers if n >= bench.build.switches]
    groups = [rows[k : k + TOGETHER] for k in range(0, len(rows), TOGETHER)]
    stay: dict[int, Effect] = {}
    for found in in_parallel(bench.reach_of_rows, groups, jobs):
        for number, cases in found.items():
            if cases is None:
                stay[number] = Effect(0, 0, 0, (), 0, 0.0, crashed=1)
            elif cases:
                bench.reached[number] = cases
    return stay


def _measured(path: str, bench: Bench) -> dict[int, Effect]:
    """Effects that an earlier run wrote for the same source and prompts."""
    if not Path(path).exists():
        return {}
    data = json.loads(Path(path).read_text(encoding="utf-8"))
    if data["sources"] != _sources(bench.build.units) or data["prompts"] != len(bench.cases):
        return {}
    return {bench.build.numbers[r["key"]]: _effect(r) for r in data["units"] if r["reach"]}


def _effect(row: dict[str, Any]) -> Effect:
    values = {name: row[name] for name in Effect.__dataclass_fields__}
    return Effect(**(values | {"worse": tuple(row["worse"])}))


def sort_of(row: dict[str, Any]) -> str:
    """How much a unit is worth, in words."""
    helps = len(row["worse"])
    if helps:
        return "helps 3 or more" if helps >= ENOUGH else f"helps {helps}"
    if row["crashed"]:
        return "keeps from crashing"
    if not row["reach"]:
        return "met by no prompt"
    if not row["changed"]:
        return "no other document"
    return "other documents, 1-2" if row["changed"] < ENOUGH else "other documents, 3 or more"


def print_classes(rows: list[dict[str, Any]]) -> None:
    """Prints how many units of each kind are worth how much."""
    sorts = sorted({sort_of(r) for r in rows})
    print(f"{'':<28}" + "".join(f"{k:>16}" for k in KINDS))
    for name in sorts:
        cells = ""
        for kind in KINDS:
            own = [r for r in rows if r["kind"] == kind and sort_of(r) == name]
            cells += f"{len(own):>7} {sum(r['lines'] for r in own):>5.0f} l."
        print(f"{name:<28}{cells}")
    outer = outermost([r for r in rows if goes(r, seen=False)])
    print(f"may go: {len(outer)} outermost units, {sum(r['lines'] for r in outer):.0f} lines; "
          "lines nested in others counted once only here")  # fmt: skip


def goes(row: dict[str, Any], seen: bool) -> bool:
    """Whether a unit helps too few to stay.

    Args:
        row: The unit and its effect.
        seen: Whether it stays, too, if it changes `ENOUGH` families' documents in what no label
            tells of (places, supports, sizes, paths).
    """
    if len(row["worse"]) >= ENOUGH or row["crashed"]:
        return False
    return not (seen and row["changed"] >= ENOUGH)


def outermost(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Units that lie in no branch or step of the others."""
    out: list[dict[str, Any]] = []
    covered: dict[str, list[tuple[int, int]]] = {}
    for row in sorted(rows, key=lambda r: (r["file"], r["line"], -r["end_line"])):
        spans = covered.setdefault(row["file"], [])
        if any(lo <= row["line"] and row["end_line"] <= hi for lo, hi in spans):
            continue
        out.append(row)
        if row["kind"] in ("branch", "step"):
            spans.append((row["line"], row["end_line"]))
    return out


def choose(args: argparse.Namespace) -> int:
    """Chooses what goes and writes it, with what it costs every corpus."""
    data = json.loads(Path(args.effects).read_text(encoding="utf-8"))
    began = time.perf_counter()
    bench = _bench(args, not args.no_held_out, args.soak)
    _report_time(f"{len(bench.cases)} prompts read", began)
    if _sources(bench.build.units) != data["sources"]:
        print("the source has changed since the effects were measured; measure again")
        return 2
    rows = [r for r in data["units"] if goes(r, args.seen) and r["kind"] in args.kinds]
    rows.sort(key=lambda r: (bool(r["changed"]), r["lost"] / max(r["lines"], 0.1), r["key"]))
    numbers = [bench.build.numbers[r["key"]] for r in rows]
    effects = {n: _effect(r) for n, r in zip(numbers, rows, strict=True)}
    _reach_rows(bench, numbers, args.jobs)
    began = time.perf_counter()
    within = {"dev": args.dev_points, corpora.REWORDINGS: args.rewording_points}
    choice = Choice(bench, effects, args.jobs, within)
    state = choice.run(numbers)
    back = choice.mend()
    _report_time("chosen", began)
    after = choice.outcomes(state.gone, list(range(len(bench.cases))))
    chosen = [r for r, n in zip(rows, numbers, strict=True) if n in state.gone]
    outer = outermost(chosen)
    result = {
        "sources": data["sources"],
        "prompts": len(bench.cases),
        "every": args.every,
        "held_out": not args.no_held_out,
        "before": _totals(bench, bench.before),
        "after": _totals(bench, [after[k] for k in range(len(bench.cases))]),
        "refused": len(state.refused) + len(back),
        "soak": args.soak,
        "lines": sum(r["lines"] for r in outer),
        "units": chosen,
        "marks": {bench.cases[k].name: list(o.mark) for k, o in sorted(after.items())},
    }
    Path(args.out).write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    print(
        f"{len(chosen)} of {len(rows)} units go, {len(outer)} outermost, {result['lines']:.0f} "
        f"lines; {result['refused']} stay as they cost more together"
    )
    print("\n".join(_compared(result["before"], result["after"])))
    return 0


def _totals(bench: Bench, outcomes: list[Outcome]) -> dict[str, dict[str, float]]:
    return corpora.totals((c.corpus, o.counts) for c, o in zip(bench.cases, outcomes, strict=True))


def _compared(before: dict[str, dict[str, float]], after: dict[str, dict[str, float]]) -> list[str]:
    names = list(next(iter(before.values())))[1:]
    out = ["| corpus | prompts | " + " | ".join(n.replace("_", " ") for n in names) + " |",
           "| --- " * (len(names) + 2) + "|"]  # fmt: skip
    for corpus, was in before.items():
        cells = [f"{was[n]:.1f} → {after[corpus][n]:.1f}" for n in names]
        out.append(f"| {corpus} | {was['prompts']:.0f} | " + " | ".join(cells) + " |")
    return out


def prune(args: argparse.Namespace) -> int:
    """Writes the source without what was chosen, then takes out what is dead."""
    chosen = json.loads(Path(args.chosen).read_text(encoding="utf-8"))
    found = package(args)
    if any(_digest(f) != d for f, d in chosen["sources"].items()):
        print("the source has changed since the units were chosen; measure again")
        return 2
    keys = {u["key"] for u in chosen["units"]}
    before = _lines(args.folder)
    rows = [r for r in find_rows(found) if r.unit.key in keys]
    for name, tree in found.trees.items():
        units = [f for f in found.find(name) if f.unit.key in keys]
        own = [r for r in rows if r.unit.file == name]
        if units or own:
            text = rewrite.without(found.sources[name], tree, units, partial(cut_rows, rows=own))
            (ROOT / name).write_text(text, encoding="utf-8")
    for name in {r.unit.file for r in rows} - found.trees.keys():
        text = (ROOT / name).read_text(encoding="utf-8")
        text = table_without(text, [r for r in rows if r.unit.file == name])
        (ROOT / name).write_text(text, encoding="utf-8")
    dead.lint(ROOT, args.folder)
    cut = _lines(args.folder)
    keep = [n for n in found.kept if not args.only]
    gone = dead.sweep(ROOT, args.folder, OUTSIDE, keep)
    print(f"lines: {before} → {cut} cut → {_lines(args.folder)} after dead code "
          f"({sum(gone.values())} definitions in {len(gone)} files)")  # fmt: skip
    return 0


def _digest(file: str) -> str:
    return hashlib.sha256((ROOT / file).read_bytes()).hexdigest()[:16]


def _lines(folder: str) -> int:
    return sum(
        len(p.read_text(encoding="utf-8").splitlines()) for p in (ROOT / folder).rglob("*.py")
    )


def check(args: argparse.Namespace) -> int:
    """Reads every prompt with the source as it is and compares with what was chosen."""
    chosen = json.loads(Path(args.chosen).read_text(encoding="utf-8"))
    subject = corpora.Reader()
    build = Build(Package(ROOT, args.folder, ["*"]), corpora.Reader.package)
    cases = corpora.cases(chosen["every"], chosen["held_out"], args.files, chosen["soak"])
    with build.installed():
        bench = Bench(build, subject, cases)
    found = in_parallel(bench.outcome, list(range(len(bench.cases))), args.jobs, chunk=50)
    outcomes: list[Outcome] = list(found)
    other: Counter[str] = Counter()
    account = 0
    for case, outcome in zip(bench.cases, outcomes, strict=True):
        mark = chosen["marks"][case.name]
        if outcome.mark[0] != mark[0]:
            other[case.corpus] += 1
            if case.decides and other[case.corpus] <= args.show:
                print(f"other document: {case.name} {outcome.crashed} | {case.prompt}")
        account += list(outcome.mark) != mark
    print(f"{sum(other.values())} of {len(outcomes)} documents differ from when the units were "
          f"chosen {dict(other)}, {account} with their accounts; "
          f"{sum(bool(o.crashed) for o in outcomes)} crash")  # fmt: skip
    print("\n".join(_compared(chosen["before"], _totals(bench, outcomes))))
    return int(bool(other))


def table(args: argparse.Namespace) -> int:
    """Writes what was pruned and what it cost as markdown."""
    chosen = json.loads(Path(args.chosen).read_text(encoding="utf-8"))
    units = outermost(chosen["units"])
    out = ["# What was pruned", "", *_compared(chosen["before"], chosen["after"]), ""]
    out += [f"{len(units)} units, {chosen['lines']:.0f} lines before dead code.", ""]
    out += ["| unit | where | lines | helps | other documents | points |", "| --- " * 6 + "|"]
    for r in sorted(units, key=lambda r: (r["file"], r["line"])):
        text = r["text"][:70].replace("|", "\\|")
        out.append(f"| {r['kind']} `{text}` | {r['file']}:{r['line']} | {r['lines']:g} | "
                   f"{len(r['worse'])} | {r['changed']} | {r['lost']:g} |")  # fmt: skip
    Path(args.out).write_text("\n".join(out) + "\n", encoding="utf-8")
    return 0


def count(args: argparse.Namespace) -> int:
    """Prints how many units there are of each kind."""
    found = package(args)
    units = [*found.units(), *(r.unit for r in find_rows(found))]
    units = [u for u in units if wanted(u, args.kinds)]
    for kind in args.kinds:
        own = [u for u in units if u.kind == kind]
        print(f"{kind:<8}{len(own):>7}{sum(u.lines for u in own):>9.0f} lines")
    return 0


_COMMANDS = {"units": count, "measure": measure, "choose": choose, "prune": prune, "check": check,
             "table": table}  # fmt: skip


def main(argv: list[str] | None = None) -> int:
    """Runs a command; returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", choices=_COMMANDS)
    parser.add_argument("--folder", default=FOLDER)
    parser.add_argument("--only", nargs="+", metavar="FILE", help="only units of these files")
    parser.add_argument("--leave", nargs="+", default=[], metavar="PATTERN", help="files to keep")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(SWITCH_KINDS))
    parser.add_argument("--files", nargs="+", choices=FILES, default=FILES)
    parser.add_argument("--every", type=int, default=1, help="every n-th deciding prompt only")
    parser.add_argument("--most", type=int, default=400, help="prompts read for a unit at most")
    parser.add_argument("--sample", type=int, metavar="N", help="measure N units, for an estimate")
    parser.add_argument("--jobs", type=int, default=cores())
    parser.add_argument("--minutes", type=float, default=1e9, help="measure no longer; go on later")
    parser.add_argument(
        "--soak", type=int, default=1000, metavar="N", help="further prompts that must not crash"
    )
    parser.add_argument(
        "--seen", action="store_true", help="keep what changes three families' unlabelled parts"
    )
    parser.add_argument("--no-held-out", action="store_true", help="for a trial: no such totals")
    parser.add_argument("--dev-points", type=float, default=WITHIN["dev"])
    parser.add_argument("--rewording-points", type=float, default=WITHIN[corpora.REWORDINGS])
    parser.add_argument("--show", type=int, default=5, help="prompts that differ, to list")
    parser.add_argument("--effects", metavar="FILE")
    parser.add_argument("--chosen", metavar="FILE")
    parser.add_argument("--out", metavar="FILE")
    args = parser.parse_args(argv)
    needs = {"measure": ["out"], "choose": ["effects", "out"], "prune": ["chosen"],
             "check": ["chosen"], "table": ["chosen", "out"]}  # fmt: skip
    missing = [n for n in needs.get(args.command, []) if not getattr(args, n)]
    if missing:
        parser.error(f"{args.command} needs --" + " and --".join(missing))
    return _COMMANDS[args.command](args)


if __name__ == "__main__":
    sys.exit(main())
