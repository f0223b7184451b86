"""Options of `esg dataset` that ask for texts, other engines and what-ifs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from esg.dataset.whatifs.amounts import ENGINES, VARIABLES
from esg.outcomes import UserError


@dataclass(frozen=True)
class TruthOptions:
    """What is written beside trajectories and verdicts.

    Args:
        annotations: Captions and questions of every scene, or none.
        what_if: Replay solved scenes with one thing changed, with commas between: mass, friction,
            speed, gravity, remove, direction.
        engines: Replay every scene in these engines at two steps, with commas between: physx,
            rapier, newton.
    """

    annotations: Literal["all", "none"] = "all"
    what_if: str = ""
    engines: str = ""


TEXTS = TruthOptions()
"""What every dataset gets: texts, and no other replays."""


def spec_fields(options: TruthOptions) -> dict[str, Any]:
    """Fields of a dataset's specification.

    Raises:
        UserError: Naming every variable or engine that is none.
    """
    return {
        "annotations": options.annotations,
        "what_if": listed(options.what_if, VARIABLES, "--what-if"),
        "engines": listed(options.engines, ENGINES, "--engines"),
    }


def listed(text: str, known: Sequence[str], option: str) -> tuple[str, ...]:
    """The names of a list with commas, each once, in the order of `known`.

    Raises:
        UserError: Naming those that are not known.
    """
    asked = [name for part in text.split(",") if (name := part.strip())]
    unknown = sorted({name for name in asked if name not in known})
    if unknown:
        raise UserError(f"{option} {','.join(unknown)}: choose from {', '.join(known)}")
    return tuple(name for name in known if name in asked)
