"""Ctrl-C and SIGTERM at random moments of every command: an answer at once, with a message."""

from __future__ import annotations

import contextlib
from pathlib import Path
import random
import signal
import subprocess
import time

from benchmarks.faults.ground import begin, finish
from benchmarks.faults.kills import Facts, arguments, difference, facts, prepared_copy, undisturbed

HEADS = ("command", "signals", "exit codes", "slowest answer s", "all gone s", "wrong")
_CODES = {signal.SIGINT: 130, signal.SIGTERM: 143}
ANSWER_S = 2.0
"""How long an answer may take on a machine that has nothing else to do [s]."""


def interrupted(
    seed: int, count: int, ground: Path, place: Path, name: str
) -> list[tuple[tuple[object, ...], str]]:
    """A command that is asked to end, some times with each signal, and then runs to its end.

    Args:
        seed: Chooses moments.
        count: Of interruptions by each signal.
        ground: A prepared folder.
        place: Where it happens.
        name: Of `kills.COMMANDS`.

    Returns:
        A row for `HEADS`, with what is wrong.
    """
    # A job that a shell began in the background ignores Ctrl-C, and what it starts would as well.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    sound = undisturbed(name, 1, ground, place)
    rng = random.Random(f"{seed} {name}")
    codes, wrong = list[str](), list[str]()
    slowest = gone = 0.0
    for number, code in list(_CODES.items()) * count:
        prepared_copy(ground, place, name)
        command = begin(arguments(name, place), place, place / "cache")
        time.sleep(rng.uniform(min(0.5, sound[1] / 2), sound[1]))
        if command.poll() is None:
            command.send_signal(number)
        asked = time.monotonic()
        with contextlib.suppress(subprocess.TimeoutExpired):
            command.wait(60.0)
        answer = time.monotonic() - asked
        # Its output ends with the last of the processes that it started.
        ended = finish(command, 60.0, asked)
        codes.append(str(ended.code))
        slowest, gone = max(slowest, answer), max(gone, ended.seconds)
        # One that had not loaded its handlers yet dies of the signal itself, without a word.
        if ended.code not in (0, 3, -number):
            wrong += [fault] if (fault := ended.wrong((code,))) else []
        if answer > ANSWER_S:
            wrong.append(f"an answer after {answer:.1f} s")
        wrong += _again(name, place, sound[0])
    told = " ".join(sorted(set(codes)))
    cells = (name, 2 * count, told, f"{slowest:.2f}", f"{gone:.1f}", len(wrong))
    return [(cells, "; ".join(wrong[:3]))]


def _again(name: str, place: Path, sound: Facts) -> list[str]:
    """What is wrong with the command's next run, if anything is."""
    command = begin(arguments(name, place), place, place / "cache")
    ended = finish(command, 600.0, time.monotonic())
    end = ended.wrong((0, 3)) or difference(sound, facts(place), name)
    return [] if end == "same" else [end]
