"""Places on a top: its ends, edges and corners, and its sides as the viewer has them.

A part is a word for what it is and, before it, which one: "end" is either end, "left end" the one
towards the viewer's left, "back left corner" that one. "Other end" is the one that is left.
"""

from __future__ import annotations

from typing import Literal, get_args

END, OTHER_END, EDGE, CORNER, SIDE = "end", "other end", "edge", "corner", "side"
Part = Literal[
    "end", "other end", "edge", "corner",
    "left end", "right end", "front end", "back end",
    "left edge", "right edge", "front edge", "back edge",
    "left side", "right side", "front side", "back side",
    "front left corner", "front right corner", "back left corner", "back right corner",
]  # fmt: skip
PARTS: tuple[Part, ...] = get_args(Part)
"""What a statement that something is at a part of a top may say (`Predicate.AT_PART`)."""
TOWARDS = {"left": (1.0, 0.0), "right": (-1.0, 0.0), "front": (0.0, 1.0), "back": (0.0, -1.0)}
"""The way to each side in the world (left = +X, front = +Y)."""


def sides_of(part: str) -> tuple[str, ...]:
    """Which of several parts of its kind it is: ("back", "left") of "back left corner"."""
    return tuple(w for w in part.split()[:-1] if w in TOWARDS)


def kind_of(part: str) -> str:
    """What it is: "corner" of "back left corner"."""
    return part.split()[-1]


def known(part: str) -> Part | None:
    """The part that words name, None if nothing has such a one."""
    return next((p for p in PARTS if p == part), None)
