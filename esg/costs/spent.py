"""What a run spent, by stage: seconds that a scene waited, and seconds that cores worked for it."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Mapping, Sequence
import contextlib
from dataclasses import dataclass
import os
import time
from typing import Any

HOUR_S = 3600.0
_SHOWN_S = 0.005
"""Stages below this are not worth a word [s]."""


def core_time() -> float:
    """Processor time of this process and of those it has waited for: compilers, forks [s]."""
    others = os.times()
    return time.process_time() + others.children_user + others.children_system


class Meter:
    """Seconds and processor seconds by what they were spent on, while it goes on."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self.core_seconds: dict[str, float] = {}

    def add(self, name: str, seconds: float, core_seconds: float) -> None:
        """Adds what was measured elsewhere [s]."""
        self.seconds[name] = self.seconds.get(name, 0.0) + seconds
        self.core_seconds[name] = self.core_seconds.get(name, 0.0) + core_seconds

    @contextlib.contextmanager
    def on(self, name: str) -> Generator[None]:
        """Measures the block."""
        start, core_start = time.perf_counter(), core_time()
        yield
        self.add(name, time.perf_counter() - start, core_time() - core_start)


@dataclass(frozen=True)
class Spent:
    """What the scenes of a run took; stages that came from the cache took nothing.

    Args:
        scenes: Number of them.
        seconds: By stage, all scenes together [s].
        core_seconds: Processor time by stage, all scenes together [s].
    """

    scenes: int
    seconds: Mapping[str, float]
    core_seconds: Mapping[str, float]

    def to_json(self) -> dict[str, Any]:
        """Seconds and core-hours a scene, in all and by stage, and core-hours of the run."""
        per = max(1, self.scenes)
        cores = sum(self.core_seconds.values())
        return {
            "scenes": self.scenes,
            "seconds_a_scene": round(sum(self.seconds.values()) / per, 4),
            "core_hours_a_scene": round(cores / per / HOUR_S, 8),
            "core_hours": round(cores / HOUR_S, 6),
            "stages": {
                stage: {
                    "seconds_a_scene": round(seconds / per, 4),
                    "core_hours_a_scene": round(
                        self.core_seconds.get(stage, 0.0) / per / HOUR_S, 8
                    ),
                }
                for stage, seconds in self.seconds.items()
            },
        }


def spent(logs: Iterable[Sequence[Mapping[str, Any]]]) -> Spent:
    """What the scenes with these logs took.

    Args:
        logs: One a scene: entries with `stage`, `cached`, `seconds` and `core_seconds`.
    """
    count, seconds, cores = 0, dict[str, float](), dict[str, float]()
    for log in logs:
        count += 1
        for entry in log:
            if "stage" not in entry or entry.get("cached"):
                continue
            stage = str(entry["stage"])
            seconds[stage] = seconds.get(stage, 0.0) + float(entry.get("seconds", 0.0))
            cores[stage] = cores.get(stage, 0.0) + float(entry.get("core_seconds", 0.0))
    return Spent(count, seconds, cores)


def line(told: Mapping[str, Any]) -> str:
    """The same in one line.

    Args:
        told: As of `Spent.to_json`.
    """
    stages = [
        f"{stage} {row['seconds_a_scene']:.2f}"
        for stage, row in told["stages"].items()
        if row["seconds_a_scene"] >= _SHOWN_S
    ]
    by_stage = f" ({', '.join(stages)})" if stages else ""
    return (
        f"cost a scene: {told['seconds_a_scene']:.2f} s{by_stage}, "
        f"{told['core_hours_a_scene']:.6f} core-hours; {told['core_hours']:.4f} core-hours in all"
    )
