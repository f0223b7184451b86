"""A run with two variants, and answers that no person gave: every number here is made up."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

VARIANTS = ("full", "no_dynamic")
PROMPTS = {"S1-run0": "A ball hits a box.", "S2-run0": "A <b>car</b> {{script}} stops.</script>"}


def write_run(folder: Path, variants: tuple[str, ...] = VARIANTS) -> Path:
    """Folders of a scene a prompt and variant, each with a film of a few bytes."""
    for variant in variants:
        for name, prompt in PROMPTS.items():
            scene = folder / variant / name
            scene.mkdir(parents=True)
            (scene / "prompt.txt").write_text(prompt)
            (scene / "log.jsonl").write_text('{"outcome": "solved"}\n')
            (scene / "preview.mp4").write_bytes(f"{variant} {name}".encode())
    return folder


def synthetic_answers(key: dict[str, Any], participant: int, shift: int = 0) -> dict[str, Any]:
    """Answers of a made-up participant: full 5 and 4, anything else 2 and 1, moved by `shift`."""
    ratings = []
    for clip, about in key["clips"].items():
        quality, alignment = (5, 4) if about["variant"] == "full" else (2, 1)
        ratings.append(
            {"clip": clip, "quality": quality - shift, "alignment": alignment + shift, "seconds": 1}
        )
    pairs = [
        {"first": a, "second": b, "seconds": 1, "alignment": None,
         "quality": a if key["clips"][a]["variant"] == "full" else b}
        for a, b in key["pairs"]
    ]  # fmt: skip
    return {
        "format": "esg-study-answers", "version": 1, "study": key["study"], "consent": True,
        "participant": participant, "ratings": ratings, "pairs": pairs,
    }  # fmt: skip


def write_answers(folder: Path, key: dict[str, Any], count: int) -> list[Path]:
    out = []
    for k in range(count):
        path = folder / f"answers-{k}.json"
        path.write_text(json.dumps(synthetic_answers(key, 100 + k, shift=k % 2)))
        out.append(path)
    return out
