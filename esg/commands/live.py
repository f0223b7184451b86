"""The live table of a run: stages with counts, rates and time left, failures as they happen."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Generator
import contextlib
import sys
import threading
import time
from typing import Any, TextIO

from esg.pipeline import STAGES
from esg.progress import StageEvent, listening

GOOD = ("solved", "nearest_feasible")


class Board:
    """What a run has done so far; knows nothing of screens.

    Args:
        scenes: Scene runs in all.
        clock: Seconds that never go back.
    """

    def __init__(self, scenes: int, clock: Callable[[], float] = time.monotonic) -> None:
        self.scenes = scenes
        self._clock = clock
        self._start = clock()
        self._lock = threading.Lock()
        self._running: dict[tuple[str, int], str] = {}
        self._seen: set[tuple[str, int, str]] = set()
        self._ended: dict[tuple[str, int], tuple[str, str]] = {}
        self._done: Counter[str] = Counter()
        self._cached: Counter[str] = Counter()
        self._computed_s: defaultdict[str, float] = defaultdict(float)

    def on(self, event: StageEvent) -> str:
        """Takes in an event; returns a line to keep if it ended a scene badly, else nothing."""
        scene = (event.scene, event.seed)
        with self._lock:
            if event.status == "started":
                self._running[scene] = event.stage
                return ""
            self._running.pop(scene, None)
            if (*scene, event.stage) in self._seen:
                return ""  # looked up first, then asked again
            self._seen.add((*scene, event.stage))
            self._done[event.stage] += 1
            if event.cached:
                self._cached[event.stage] += 1
            else:
                self._computed_s[event.stage] += event.seconds
            last = event.stage == STAGES[-1]
            early = event.outcome in ("invalid_draft", "infeasible", "crashed")
            if scene in self._ended or not (event.outcome and (last or early)):
                return ""
            self._ended[scene] = (event.outcome, event.reason)
        if event.outcome in GOOD:
            return ""
        reason = " ".join(event.reason.split())
        return f"{event.scene}  {event.outcome.replace('_', ' ')}  {reason}".rstrip()

    @property
    def elapsed_s(self) -> float:
        """Since the board was made [s]."""
        return self._clock() - self._start

    @property
    def ended(self) -> int:
        """Scenes that have ended, well or badly."""
        return len(self._ended)

    def rows(self) -> list[list[str]]:
        """One row a stage: name, done, running, from cache, mean seconds, a minute."""
        with self._lock:
            running = Counter(self._running.values())
            out: list[list[str]] = []
            for stage in STAGES:
                done, cached = self._done[stage], self._cached[stage]
                computed = done - cached
                mean = f"{self._computed_s[stage] / computed:.2f}" if computed else ""
                rate = f"{60 * done / self.elapsed_s:.0f}" if done and self.elapsed_s > 0 else ""
                out.append(
                    [
                        stage,
                        f"{done}/{self.scenes}",
                        str(running[stage]) if running[stage] else "",
                        str(cached) if cached else "",
                        mean,
                        rate,
                    ]
                )
            return out

    def left_s(self) -> float | None:
        """Estimated time left [s]: the work that remains at the speed so far; None if unknown.

        Work is counted in seconds of each stage's mean, so that a stage that takes longer than
        the others counts for more.
        """
        with self._lock:
            work = done_work = 0.0
            early = sum(o in ("invalid_draft", "infeasible", "crashed")
                        for o, _ in self._ended.values())  # fmt: skip
            for stage in STAGES:
                done = self._done[stage]
                remaining = max(0, self.scenes - done - early)
                if not done:
                    if remaining:
                        return None
                    continue
                mean = self._computed_s[stage] / done
                work += remaining * mean
                done_work += self._computed_s[stage]
            if done_work <= 0:
                return None
            return work * self.elapsed_s / done_work

    def summary(self) -> str:
        """One line about the run as a whole."""
        with self._lock:
            outcomes = Counter(o for o, _ in self._ended.values())
            done, cached = sum(self._done.values()), sum(self._cached.values())
        parts = [f"{n} {o.replace('_', ' ')}" for o, n in sorted(outcomes.items())]
        line = f"{self.ended} of {self.scenes} scenes in {duration(self.elapsed_s)}"
        if parts:
            line += ": " + ", ".join(parts)
        return f"{line}; {cached} of {done} stages from cache"


def duration(seconds: float) -> str:
    """12 s, 3 min 20 s, 2 h 05 min."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"


LOG_EVERY_S = 30.0
"""Between the lines of a run whose stderr is a file or a pipe: seldom enough to read the log."""


class Live:
    """Shows a board on stderr while a run goes on.

    A terminal gets a table that redraws itself; a file or a pipe gets a line now and then, so that
    a log tells a long run from one that hangs. What is over before the first line leaves none.

    Args:
        board: The board.
        console: A rich console, None for plain lines.
        log: Where plain lines go; None for no display at all.
        every_s: Seconds between plain lines.
    """

    def __init__(
        self, board: Board, console: Any, log: TextIO | None = None, every_s: float = LOG_EVERY_S
    ) -> None:
        self._board, self._console = board, console
        self._log, self._every_s = (log if console is None else None), every_s
        self._word = "starting"
        self._live: Any = None
        self._over = threading.Event()
        self._logger: threading.Thread | None = None

    def __enter__(self) -> Live:
        if self._console is not None:
            from rich.live import Live as RichLive

            self._live = RichLive(
                console=self._console,
                get_renderable=self._table,
                refresh_per_second=4,
                transient=True,
                redirect_stdout=False,
                redirect_stderr=False,
            )
            self._live.start()
        elif self._log is not None:
            self._logger = threading.Thread(target=self._tell, name="esg-live", daemon=True)
            self._logger.start()
        return self

    def __exit__(self, *_: object) -> None:
        if self._logger is not None:
            self._over.set()
            self._logger.join()
            self._logger = None
        if self._live is not None:
            self._live.stop()
            self._live = None
            self._print(self._board.summary())

    def event(self, event: StageEvent) -> None:
        """A listener of `esg.progress`."""
        line = self._board.on(event)
        self._word = ""
        if line:
            self._print(line)

    def show(self, word: str) -> None:
        """What happens beside the stages: starting, writing, ingesting."""
        self._word = word

    def _print(self, line: str) -> None:
        if self._console is not None:
            # Scenes are named by people: no markup, no colours guessed.
            self._console.print(line, markup=False, highlight=False, soft_wrap=True)

    def _tell(self) -> None:
        while not self._over.wait(self._every_s):
            running = ", ".join(f"{row[0]} {row[1]}" for row in self._board.rows() if row[2])
            # A closed pipe or a full disk is no reason to fail a run.
            with contextlib.suppress(OSError, ValueError):
                print(
                    "  ".join(p for p in (self._title(), running) if p), file=self._log, flush=True
                )

    def _title(self) -> str:
        left = self._board.left_s()
        title = f"{self._board.ended}/{self._board.scenes} scenes"
        title += f"  {duration(self._board.elapsed_s)}"
        title += f"  about {duration(left)} left" if left is not None and left >= 1 else ""
        return title + (f"  {self._word}" if self._word else "")

    def _table(self) -> Any:
        from rich.table import Table

        table = Table(title=self._title(), title_justify="left", box=None, pad_edge=False)
        for name in ("stage", "done", "running", "cached", "s each", "a minute"):
            table.add_column(name, justify="left" if name == "stage" else "right")
        for row in self._board.rows():
            table.add_row(*row)
        return table


@contextlib.contextmanager
def live(scenes: int) -> Generator[Live]:
    """The live table of a run for the body.

    Args:
        scenes: Scene runs in all.
    """
    console = None
    if sys.stderr.isatty():
        from rich.console import Console

        console = Console(file=sys.stderr)
    with Live(Board(scenes), console, sys.stderr) as shown, listening(shown.event):
        yield shown
