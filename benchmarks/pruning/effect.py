"""What a package does to every prompt with and without a unit: one build, a switch for each unit.

The package is imported from code with switches (`units.switched`); leaving a unit out flips one.
Functions that keep their results forget them before every change of a switch.
"""

from __future__ import annotations

import ast
import builtins
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
import functools
import gc
import importlib.abc
import importlib.machinery
import importlib.util
import io
import multiprocessing
import os
from pathlib import Path
import random
import signal
import sys
from types import CodeType, FrameType
from typing import Any

from benchmarks.pruning.rows import Row, find_rows, table_without, tree_without
from benchmarks.pruning.units import FIRST, OFF, ON, Package, Unit, switched

TIME_LIMIT_S = 5.0
"""A draft that takes longer counts as crashed."""


@dataclass(frozen=True)
class Case:
    """A prompt with what it stands for.

    Args:
        name: Its name, unique.
        prompt: Text.
        family: Cases of one family are of one origin and count once.
        corpus: Corpus whose total it enters.
        row: Its expectations, for who judges it; None if it only must not crash.
        decides: Whether it may be looked at by itself; others count in totals only.
    """

    name: str
    prompt: str
    family: str
    corpus: str
    row: Any = field(compare=False, default=None)
    decides: bool = True


@dataclass(frozen=True)
class Outcome:
    """What one case came to.

    Args:
        mark: Equal for equal results; its first part for those that differ in nothing that counts.
        points: Expectations met less what was invented.
        counts: Figures of the case that totals are made of.
        crashed: Name of an exception that is no refusal.
    """

    mark: tuple[str, str]
    points: float
    counts: tuple[float, ...] = ()
    crashed: str = ""


class Subject:
    """What is pruned, and how its results are judged; overridden for each package."""

    package = ""
    """Dotted name of the package."""

    def reader(self) -> Callable[[str], Any]:
        """The package's function of a prompt, imported now."""
        raise NotImplementedError

    def mark(self, result: Any) -> tuple[str, str]:
        """What two equal results share: what counts of them, and all."""
        return repr(result), ""

    def judge(self, case: Case, result: Any) -> tuple[float, tuple[float, ...]]:
        """Points and counts of a result; None is a refusal or a crash."""
        raise NotImplementedError

    def refused(self, error: Exception) -> bool:
        """Whether an exception is a refusal of the prompt."""
        return False

    def drops(
        self, before: dict[str, list[float]], after: dict[str, list[float]]
    ) -> dict[str, float]:
        """Largest drop of a figure of each corpus [points of percentage] from sums of counts."""
        return {}

    def prepare(self) -> None:
        """Runs after every import of the package."""


class _Recorder(list[bool]):
    """Switches that note which were asked."""

    def __init__(self, values: Iterable[bool]) -> None:
        super().__init__(values)
        self.asked: set[int] = set()

    def __getitem__(self, k: Any) -> Any:
        self.asked.add(k)
        return super().__getitem__(k)


class _First:
    """`FIRST[k]` gives a function that returns its k-th argument."""

    def __getitem__(self, k: int) -> Callable[..., Any]:
        return lambda *given, **named: given[k]


class _Loader(importlib.machinery.SourceFileLoader):
    codes: dict[str, CodeType]

    def get_code(self, fullname: str) -> CodeType:
        return self.codes[fullname]


class Build(importlib.abc.MetaPathFinder):
    """A package imported with switches.

    Args:
        package: Its modules.
        name: Its dotted name.
    """

    def __init__(self, package: Package, name: str) -> None:
        self.package, self.name = package, name
        self.units: list[Unit] = package.units()
        self.switches = len(self.units)
        self.rows = find_rows(package)
        self.units += [row.unit for row in self.rows]
        self.numbers = {u.key: k for k, u in enumerate(self.units)}
        self._codes: dict[str, CodeType] = {}
        self._files: dict[str, Path] = {}
        self._dotted: dict[str, str] = {}
        self.fresh: Callable[[], None] = lambda: None
        """Called after the package has been imported anew."""
        self._caches: list[Any] = []
        for file in package.trees:
            path = package.root / file
            parts = file.removeprefix(package.folder).removesuffix(".py").strip("/").split("/")
            dotted = ".".join([name, *(p for p in parts if p != "__init__")])
            tree = switched(package, file, self.numbers)
            self._codes[dotted] = compile(tree, str(path), "exec")
            self._files[dotted] = path
            self._dotted[file] = dotted
        self.reset()
        builtins.__dict__[FIRST] = _First()

    def reset(self) -> None:
        """Puts every unit back."""
        self.on, self.off = [True] * self.switches, [False] * self.switches
        builtins.__dict__[ON], builtins.__dict__[OFF] = self.on, self.off

    def find_spec(self, fullname: str, path: Any = None, target: Any = None) -> Any:
        """Finds the modules of the package."""
        if fullname not in self._codes:
            return None
        file = self._files[fullname]
        loader = _Loader(fullname, str(file))
        loader.codes = self._codes
        inside = [str(file.parent)] if file.name == "__init__.py" else None
        return importlib.util.spec_from_file_location(
            fullname, file, loader=loader, submodule_search_locations=inside
        )

    @contextmanager
    def installed(self) -> Iterator[None]:
        """Makes imports of the package give the code with switches, and notes what is cached."""
        for module in [m for m in sys.modules if m == self.name or m.startswith(self.name + ".")]:
            del sys.modules[module]
        if self not in sys.meta_path:
            sys.meta_path.insert(0, self)
        kept = functools.lru_cache, functools.cache

        def noted(wrapper: Any) -> Any:
            inner = wrapper.__wrapped__
            if inner.__module__.startswith(self.name) and inner.__code__.co_argcount:
                self._caches.append(wrapper)
            return wrapper

        def lru_cache(maxsize: Any = 128, typed: bool = False) -> Any:
            if callable(maxsize):
                return noted(kept[0](maxsize))
            return lambda function: noted(kept[0](maxsize, typed)(function))

        functools.lru_cache = lru_cache  # type: ignore[assignment]
        functools.cache = lambda function: noted(kept[0](None)(function))  # type: ignore[assignment]
        try:
            yield
        finally:
            functools.lru_cache, functools.cache = kept

    def forget(self) -> None:
        """Empties what functions of the package keep of their results."""
        for wrapper in self._caches:
            wrapper.cache_clear()

    def leave_out(self, numbers: Iterable[int], out: bool = True) -> None:
        """Leaves units out or puts them back."""
        for k in numbers:
            self.on[k], self.off[k] = not out, out
        self.forget()

    @contextmanager
    def without(self, numbers: Iterable[int]) -> Iterator[None]:
        """The package without some units."""
        numbers = list(numbers)
        switches = [k for k in numbers if k < self.switches]
        rows = [self.rows[k - self.switches] for k in numbers if k >= self.switches]
        self.leave_out(switches)
        try:
            if rows:
                with self._imported_without(rows):
                    yield
            else:
                yield
        finally:
            self.leave_out(switches, out=False)

    @contextmanager
    def _imported_without(self, rows: list[Row]) -> Iterator[None]:
        """The package imported anew without rows of data; then the one that was there."""
        saved = {m: sys.modules[m] for m in sys.modules if f"{m}.".startswith(f"{self.name}.")}
        caches, codes = self._caches, self._codes
        self._caches, self._codes = [], dict(codes)
        tables: dict[str, str] = {}
        for file in {r.unit.file for r in rows}:
            own = [r for r in rows if r.unit.file == file]
            path = self.package.root / file
            if file in self._dotted:
                tree = tree_without(ast.parse(self.package.sources[file]), own)
                tree = switched(self.package, file, self.numbers, tree)
                self._codes[self._dotted[file]] = compile(tree, str(path), "exec")
            else:
                tables[str(path)] = table_without(path.read_text(encoding="utf-8"), own)
        try:
            with _opened(tables), self.installed():
                self.fresh()
            yield
        finally:
            for module in [m for m in sys.modules if f"{m}.".startswith(f"{self.name}.")]:
                del sys.modules[module]
            sys.modules.update(saved)
            parent, _, last = self.name.rpartition(".")
            if parent and self.name in saved:
                setattr(sys.modules[parent], last, saved[self.name])
            self._caches, self._codes = caches, codes

    @contextmanager
    def recorded(self) -> Iterator[set[int]]:
        """Numbers of the units that count while it runs."""
        recorder = _Recorder(self.on), _Recorder(self.off)
        asked: set[int] = set()
        for r in recorder:
            r.asked = asked
        builtins.__dict__[ON], builtins.__dict__[OFF] = recorder
        try:
            yield asked
        finally:
            builtins.__dict__[ON], builtins.__dict__[OFF] = self.on, self.off


@contextmanager
def _opened(texts: dict[str, str]) -> Iterator[None]:
    """Files that are read have other texts, by path."""
    real = io.open

    def other(file: Any, mode: str = "r", *more: Any, **named: Any) -> Any:
        text = texts.get(str(file)) if mode.startswith("r") else None
        return real(file, mode, *more, **named) if text is None else io.StringIO(text)

    io.open = builtins.open = other  # type: ignore[assignment]
    try:
        yield
    finally:
        io.open = builtins.open = real


def _late(signum: int, frame: FrameType | None) -> None:
    raise TimeoutError("too long")


class Bench:
    """Cases, what each comes to with everything in, and which units each meets.

    Args:
        build: The package with switches, installed.
        subject: How it is called and judged.
        cases: All cases.
    """

    def __init__(self, build: Build, subject: Subject, cases: list[Case]) -> None:
        self.build, self.subject, self.cases = build, subject, cases
        self._renew()
        signal.signal(signal.SIGALRM, _late)
        self.before: list[Outcome] = []
        self.reached: dict[int, list[int]] = {}

    def _renew(self) -> None:
        """Takes the reader that is imported now."""
        self._read = self.subject.reader()
        self.subject.prepare()

    @contextmanager
    def without(self, numbers: Iterable[int]) -> Iterator[None]:
        """The package, and its reader, without some units."""
        read, self.build.fresh = self._read, self._renew
        try:
            with self.build.without(numbers):
                yield
        finally:
            self._read = read

    def reach_of_rows(self, rows: list[int]) -> dict[int, list[int] | None]:
        """Deciding cases whose result changes when these rows go together, by row.

        None for a row that the package cannot be imported without.
        """
        try:
            with self.without(rows):
                cases = [
                    k
                    for k, c in enumerate(self.cases)
                    if c.decides and self.outcome(k, self.before[k]).mark != self.before[k].mark
                ]
        except Exception:
            if len(rows) == 1:
                return {rows[0]: None}
            half = len(rows) // 2
            return self.reach_of_rows(rows[:half]) | self.reach_of_rows(rows[half:])
        return {row: cases for row in rows}

    def outcome(self, k: int, known: Outcome | None = None) -> Outcome:
        """Reads and judges a case; what has the mark of `known` is not judged again."""
        case, subject = self.cases[k], self.subject
        crashed = ""
        result = None
        signal.setitimer(signal.ITIMER_REAL, TIME_LIMIT_S)
        try:
            result = self._read(case.prompt)
            mark = subject.mark(result)
        except Exception as error:
            crashed = "" if subject.refused(error) else type(error).__name__
            mark = (f"refused: {type(error).__name__}", "")
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
        if known is not None and mark == known.mark:
            return known
        try:
            points, counts = subject.judge(case, result)
        except Exception as error:  # a document that cannot be judged is as bad as none
            crashed = type(error).__name__
            points, counts = subject.judge(case, None)
        return Outcome(mark, points, counts, crashed)

    def warm(self) -> None:
        """Reads every case once with everything in and notes which units count in it."""
        self._read(self.cases[0].prompt)
        for k in range(len(self.cases)):
            self.build.forget()
            with self.build.recorded() as asked:
                self.before.append(self.outcome(k))
            for number in asked:
                self.reached.setdefault(number, []).append(k)
        gc.collect()
        gc.freeze()
        gc.set_threshold(20_000, 20, 20)  # many small documents, no cycles worth looking for

    def effect(
        self, numbers: Iterable[int], most: int, enough: int, seed: int = 0, seen: bool = False
    ) -> Effect:
        """What leaving units out does to the deciding cases that meet them.

        Args:
            numbers: Units left out together.
            most: Cases read at most, a sample of those that meet one.
            enough: Families that lose after which no more are read.
            seed: Draws the sample.
            seen: Whether families whose results differ count like those that lose.
        """
        numbers = list(numbers)
        cases = sorted({k for n in numbers for k in self.reached.get(n, ())})
        cases = [k for k in cases if self.cases[k].decides]
        random.Random(seed).shuffle(cases)
        worse: set[str] = set()
        better: set[str] = set()
        other: set[str] = set()
        lost = read = crashed = 0.0
        with self.without(numbers):
            for k in cases[:most]:
                read += 1
                now, was = self.outcome(k, self.before[k]), self.before[k]
                if now.mark[0] != was.mark[0]:
                    other.add(self.cases[k].family)
                crashed += bool(now.crashed) and not was.crashed
                lost += was.points - now.points
                if now.points < was.points:
                    worse.add(self.cases[k].family)
                elif now.points > was.points:
                    better.add(self.cases[k].family)
                if len(other if seen else worse) >= enough:
                    break
        share = len(cases) / read if read else 1.0
        return Effect(
            len(cases), int(read), len(other), tuple(sorted(worse)), len(better),
            round(lost * share, 2), int(crashed),
        )  # fmt: skip


@dataclass(frozen=True)
class Effect:
    """What leaving a unit out does.

    Args:
        reach: Deciding cases in which it counts.
        read: Of these, read without it.
        changed: Families of those read with another result.
        worse: Families that lose points, at most as many as were enough.
        better: Families that gain.
        lost: Points lost, scaled from those read to all that meet it.
        crashed: Cases that crash without it and did not with it.
    """

    reach: int
    read: int
    changed: int
    worse: tuple[str, ...]
    better: int
    lost: float
    crashed: int = 0

    @property
    def helps(self) -> int:
        """Families of cases that lose without it."""
        return len(self.worse)


_work: Callable[[Any], Any] | None = None


def _call(item: Any) -> Any:
    assert _work is not None
    return _work(item)


def in_parallel(
    work: Callable[[Any], Any], items: list[Any], jobs: int, chunk: int = 1
) -> Iterator[Any]:
    """Results of `work` in order, by forked processes that inherit all that is loaded."""
    global _work
    if jobs <= 1 or len(items) <= 1:
        yield from map(work, items)
        return
    _work = work
    context = multiprocessing.get_context("fork")
    with context.Pool(min(jobs, len(items))) as pool:
        yield from pool.imap(_call, items, chunksize=chunk)
    _work = None


def cores() -> int:
    """Processor cores this process may use."""
    return len(os.sched_getaffinity(0))
