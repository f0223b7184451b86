"""What a verdict says, as rows and words for people."""

from __future__ import annotations

from typing import Any


def event_rows(verdict: dict[str, Any]) -> list[list[str]]:
    """Events of a verdict: whether each happened, its id, type, bodies, time and reason.

    Args:
        verdict: As `SceneVerdict.to_json` gives it.
    """
    return [
        [
            "done" if event["completed"] else "NOT DONE",
            event["id"],
            event["type"],
            ", ".join(event["bodies"]),
            "" if event["time_s"] is None else f"{event['time_s']:.3f} s",
            event["reason"],
        ]
        for event in verdict["events"]
    ]


def completed(verdict: dict[str, Any]) -> str:
    """Whether the layout is valid, and how many events happened.

    Args:
        verdict: As `SceneVerdict.to_json` gives it.
    """
    layout = "valid" if verdict["slr"] else "INVALID"
    return f"layout {layout}, {verdict['completed']} of {verdict['n_events']} events"
