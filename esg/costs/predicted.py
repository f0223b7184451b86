"""What a run to come costs, from what runs on machines of its kind took (measured.csv)."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal

from esg.costs.spent import HOUR_S
from esg.outcomes import UserError

TABLE = Path(__file__).parent / "measured.csv"
SCENES = ""
"""What is rendered in a run that renders nothing."""


@dataclass(frozen=True)
class Measured:
    """A run that was made; a row of the table.

    Args:
        kind: Of the machine.
        render: What was rendered of each scene; empty for nothing.
        use: Whether predictions are made from it, or checked on it.
        scenes: Number of them.
        cores: That it had.
        seconds: From its start to its end; 0 where the machine had other work, so that only
            processor time says anything [s].
        core_seconds: Of its batches, as `esg dataset` tells it; what starts a run (some 15 s) is
            not in it [s].
        commit, date: Of the code and the run.
        about: The machine, the scenes and the command.
    """

    kind: str
    render: str
    use: Literal["fit", "check"]
    scenes: int
    cores: int
    seconds: float
    core_seconds: float
    commit: str
    date: str
    about: str


@dataclass(frozen=True)
class Predicted:
    """What a run will take.

    Args:
        scenes: Number of them.
        kind, cores, render: As of `Measured`.
        core_seconds: A scene [s].
        busy: Share of its cores' time that a run uses.
        errors: Of predictions of runs that were held out: their core-seconds against the
            prediction's, less 1.
        sources: Runs that this follows from.
    """

    scenes: int
    kind: str
    cores: int
    render: str
    core_seconds: float
    busy: float
    errors: tuple[float, ...]
    sources: tuple[Measured, ...]

    @property
    def core_hours(self) -> float:
        """Of the run."""
        return self.scenes * self.core_seconds / HOUR_S

    @property
    def hours(self) -> float:
        """From start to end."""
        return self.core_hours / (self.cores * self.busy)

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {
            "scenes": self.scenes,
            "on": self.kind,
            "cores": self.cores,
            "render": self.render,
            "core_seconds_a_scene": round(self.core_seconds, 4),
            "core_hours": round(self.core_hours, 4),
            "hours": round(self.hours, 4),
            "scenes_an_hour": round(self.scenes / self.hours, 1),
            "error_on_held_out_runs": [round(e, 4) for e in self.errors],
            "measured": [vars(row) for row in self.sources],
        }


@cache
def table(path: Path = TABLE) -> tuple[Measured, ...]:
    """All runs that were measured."""
    with path.open(encoding="utf-8", newline="") as file:
        return tuple(
            Measured(
                row["kind"], row["render"], "check" if row["use"] == "check" else "fit",
                int(row["scenes"]), int(row["cores"]), float(row["seconds"]),
                float(row["core_seconds"]), row["commit"], row["date"], row["about"],
            )
            for row in csv.DictReader(line for line in file if not line.startswith("#"))
        )  # fmt: skip


def kinds(rows: tuple[Measured, ...] | None = None) -> list[str]:
    """Kinds of machines with measured runs."""
    return list(dict.fromkeys(r.kind for r in (table() if rows is None else rows)))


def predict(
    scenes: int, kind: str, render: str = SCENES, rows: tuple[Measured, ...] | None = None
) -> Predicted:
    """What a run of so many scenes will take.

    Args:
        scenes: Number of them.
        kind: Of the machine.
        render: What is rendered of each scene; empty for nothing.
        rows: Measured runs; default the table.

    Raises:
        UserError: If no such run was measured.
    """
    rows = table() if rows is None else rows
    own = [r for r in rows if r.kind == kind]
    if not own:
        raise UserError(f"--on {kind}: measured are {', '.join(kinds(rows)) or 'none'}")
    known_fits = [r for r in own if r.render == render and r.use == "fit"]
    latest = max((r.date for r in known_fits), default="")
    fit = [r for r in known_fits if r.date == latest]
    if not fit:
        known = ", ".join(dict.fromkeys(r.render for r in own if r.render)) or "none"
        raise UserError(f"--render {render}: measured on {kind}: {known}")
    core_s = sum(r.core_seconds for r in fit) / sum(r.scenes for r in fit)
    timed = [r for r in known_fits if r.seconds > 0.0]
    room = sum(r.seconds * r.cores for r in timed)
    busy = min(1.0, sum(r.core_seconds for r in timed) / room) if room else 1.0
    held_out = [r for r in own if r.render == render and r.use == "check" and r.date >= latest]
    errors = tuple(r.core_seconds / r.scenes / core_s - 1.0 for r in held_out)
    return Predicted(scenes, kind, fit[-1].cores, render, core_s, busy, errors, tuple(fit))
