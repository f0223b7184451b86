"""`esg replay` tells what became of the statements beside the events."""

from __future__ import annotations

from esg.commands.replay import verdict_table


def test_statements_stand_below_the_events() -> None:
    def said(name: str, kept: bool | None, reason: str = "") -> dict[str, object]:
        return {"id": name, "says": "supported_by", "words": f"words {name}", "kept": kept,
                "measured": {}, "reason": reason}  # fmt: skip

    verdict = {
        "events": [], "slr": True, "completed": 0, "n_events": 0, "ppa": {"standard": None},
        "statements": [said("s1", True), said("s2", False, "in the air"), said("s3", None, "note")],
    }  # fmt: skip
    result = {
        "scene": "x", "engine": "rapier", "dt": 1 / 240, "proof": "program",
        "judged_against": "timeline", "verdict": verdict,
        "plausibility": {"plausible": True, "worst": None},
    }  # fmt: skip
    text = verdict_table(result)
    assert "1 of 3 statements kept" in text and text.endswith(", plausible")
    rows = [" ".join(line.split()) for line in text.splitlines()]
    assert "kept s1 supported_by words s1" in rows
    assert "BROKEN s2 supported_by words s2 in the air" in rows
    assert "NOT REPRESENTED s3 supported_by words s3 note" in rows
