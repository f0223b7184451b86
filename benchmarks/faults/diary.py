"""What power losses ended in, a line of JSON each, written as each ends: several runs add up."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
import json
import os
from pathlib import Path

from benchmarks.faults.losses import Loss

HEADS = ("command", "operations", "losses", "after its end", "lost something", "equal")


@dataclass(frozen=True)
class Entry:
    """A power loss that was simulated.

    Args:
        name: Of the command, as in `kills.COMMANDS`.
        seed: Of the run.
        number: Of the loss, among those of its command and seed.
        operations: On files, of the undisturbed command.
        loss: What it ended in.
    """

    name: str
    seed: int
    number: int
    operations: int
    loss: Loss


def append(log: Path, entry: Entry) -> None:
    """Adds an entry; processes may add to the same file at once."""
    log.parent.mkdir(parents=True, exist_ok=True)
    line = json.dumps(asdict(entry)) + "\n"
    handle = os.open(log, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o644)
    try:
        os.write(handle, line.encode())  # one call: lines of others do not come between
    finally:
        os.close(handle)


def entries(log: Path) -> list[Entry]:
    """All entries of a file; none if it is not there."""
    if not log.is_file():
        return []
    return [_read(line) for line in log.read_text("utf-8").splitlines()]


def _read(line: str) -> Entry:
    facts = json.loads(line)
    return Entry(**facts | {"loss": Loss(**facts["loss"])})


def rows(
    found: Iterable[Entry], names: Iterable[str]
) -> list[tuple[tuple[object, ...], Sequence[str]]]:
    """A row of `HEADS` for each command, with what is wrong.

    Args:
        found: Of all runs.
        names: Commands, in their order.
    """
    of = {name: list[Entry]() for name in names}
    for entry in found:
        of[entry.name].append(entry)
    out: list[tuple[tuple[object, ...], Sequence[str]]] = []
    for name, mine in of.items():
        if not mine:
            continue
        least, most = (end(e.operations for e in mine) for end in (min, max))
        bad = [f"{name}:{e.number} of seed {e.seed}: {e.loss.wrong}" for e in mine if e.loss.wrong]
        after = sum(e.loss.after_end for e in mine)
        lost = sum(e.loss.lost > 0 for e in mine)
        told = str(least) if least == most else f"{least} to {most}"
        out.append(((name, told, len(mine), after, lost, len(mine) - len(bad)), bad))
    return out
