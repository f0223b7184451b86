"""The live table: counts, rates, time left, failures; silent where nobody looks."""

from __future__ import annotations

import io
import threading
import time

import pytest
from rich.console import Console

from esg.commands.live import Board, Live, duration, live
from esg.pipeline import STAGES
from esg.progress import StageEvent, emit


class Clock:
    """Time that goes on when told."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


def finished(scene: str, stage: str, **more: object) -> StageEvent:
    return StageEvent(scene, stage, "finished", **{"seconds": 1.0, **more})  # type: ignore[arg-type]


def whole(board: Board, scene: str, outcome: str = "solved", reason: str = "") -> list[str]:
    """All stages of a scene; what the board said."""
    said = []
    for stage in STAGES:
        board.on(StageEvent(scene, stage, "started"))
        end = {"outcome": outcome, "reason": reason} if stage in ("judge", "record") else {}
        said.append(board.on(finished(scene, stage, **end)))
    return [line for line in said if line]


def test_stages_are_counted_with_their_rates() -> None:
    """Done of all, running now, from cache, seconds each without the cached, a minute."""
    clock = Clock()
    board = Board(4, clock)
    board.on(finished("a", "draft", seconds=2.0))
    board.on(finished("b", "draft", seconds=0.01, cached=True))
    board.on(StageEvent("c", "draft", "started"))
    clock.now += 30.0
    assert board.rows()[0] == ["draft", "2/4", "1", "1", "2.00", "4"]
    assert board.rows()[1] == ["resolve", "0/4", "", "", "", ""]


def test_time_left_is_work_left_at_the_speed_so_far() -> None:
    """Half of the work took 40 s, so the other half takes 40 s; before that nobody knows."""
    clock = Clock()
    board = Board(2, clock)
    board.on(finished("a", "draft"))
    assert board.left_s() is None
    whole(board, "a")
    clock.now += 40.0
    assert board.left_s() == pytest.approx(40.0)
    whole(board, "b")
    assert board.left_s() == 0.0


def test_scenes_that_end_early_leave_no_work() -> None:
    """A draft that is invalid never reaches the other stages."""
    clock = Clock()
    board = Board(2, clock)
    whole(board, "a")
    clock.now += 10.0
    board.on(finished("b", "draft", outcome="invalid_draft", reason="E_EMPTY"))
    assert board.left_s() == 0.0
    assert board.ended == 2


def test_one_line_for_every_scene_that_fails_and_none_for_others() -> None:
    """Its name, how it ended and why, once, on one line."""
    board = Board(4, Clock())
    assert whole(board, "good") == []
    told = whole(board, "part", "partial", 'broken: "on the table"')
    assert told == ['part  partial  broken: "on the table"']
    assert whole(board, "near", "nearest_feasible", "gave way") == []
    said = whole(board, "bad", "not_converged", "the replay\ndisagrees")
    assert said == ["bad  not converged  the replay disagrees"]
    assert "1 nearest feasible, 1 not converged, 1 partial, 1 solved" in board.summary()


def test_what_is_reported_twice_counts_once() -> None:
    """Scenes are first looked up in the store and then asked for again."""
    board = Board(1, Clock())
    whole(board, "a")
    whole(board, "a")
    assert board.rows()[0][1] == "1/1"
    assert board.ended == 1


def test_runs_of_one_scene_with_other_seeds_are_others() -> None:
    """The seed tells them apart."""
    board = Board(2, Clock())
    board.on(finished("a", "draft", seed=0))
    board.on(finished("a", "draft", seed=1))
    assert board.rows()[0][1] == "2/2"


def test_the_table_is_drawn_on_a_terminal() -> None:
    """Names of scenes are no markup; the summary stays at the end."""
    out = io.StringIO()
    console = Console(file=out, force_terminal=True, width=100, color_system=None)
    board = Board(1, Clock())
    with Live(board, console) as shown:
        for stage in STAGES:
            end = {"outcome": "crashed", "reason": "[red]boom[/red]"}
            shown.event(finished("[b]x[/b]", stage, **(end if stage == "record" else {})))
    text = out.getvalue()
    assert "[b]x[/b]  crashed  [red]boom[/red]" in text
    assert "optimize" in text
    assert "1 of 1 scenes" in text.splitlines()[-1]


class Pipe(io.StringIO):
    """A file that says when its first line is complete."""

    def __init__(self) -> None:
        super().__init__()
        self.told = threading.Event()

    def flush(self) -> None:
        self.told.set()


def test_a_log_gets_a_line_now_and_then() -> None:
    """A run that nobody watches can be told from one that hangs."""
    board, out = Board(2, Clock()), Pipe()
    whole(board, "a")
    board.on(StageEvent("b", "optimize", "started"))
    with Live(board, None, out, every_s=0.01) as shown:
        shown.show("")
        assert out.told.wait(10.0)
    first = out.getvalue().splitlines()[0]
    assert first.startswith("1/2 scenes")
    assert first.endswith("optimize 1/2")


def test_a_log_that_is_gone_fails_no_run() -> None:
    """A closed pipe raises when written to; the body goes on."""
    out = io.StringIO()
    out.close()
    with Live(Board(1, Clock()), None, out, every_s=0.001) as shown:
        time.sleep(0.05)
        shown.event(finished("a", "draft"))


def test_nothing_is_said_where_nobody_looks(capsys: pytest.CaptureFixture[str]) -> None:
    """Without a terminal neither table nor summary appears; events are still taken."""
    with live(1) as shown:
        emit(finished("a", "draft"))
        shown.show("writing")
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("seconds", "text"), [(0.4, "0 s"), (59.2, "59 s"), (200, "3 min 20 s"), (7500, "2 h 05 min")]
)
def test_durations_read_like_speech(seconds: float, text: str) -> None:
    """No decimals, two units at most."""
    assert duration(seconds) == text
