"""What a user of a dataset should know that its tables do not say."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from esg.dataset.plan import DatasetSpec


@dataclass(frozen=True)
class Limit:
    """One limit.

    Args:
        says: In a sentence.
        applies: Whether it is one of this dataset.
    """

    says: str
    applies: Callable[[DatasetSpec, Mapping[str, Any]], bool] = lambda _, __: True


def _seen(*channels: str) -> Callable[[DatasetSpec, Mapping[str, Any]], bool]:
    return lambda _, facts: bool(
        set(channels) & set((facts.get("clips") or {}).get("channels", ()))
    )


LIMITS = (
    Limit("Bodies are rigid; what breaks comes apart into rigid pieces. Nothing is soft or wet."),
    Limit("Who stands around are bodies without a will of their own: people do not step aside."),
    Limit(
        "Motion is what an engine makes of a control program that was searched so that the events "
        "happen; it is checked for plausibility, not measured in the world.",
    ),
    Limit(
        "Sampled prompts follow a grammar of a few dozen sentences: words and syntax vary little.",
        lambda spec, _: spec.source == "sample",
    ),
    Limit(
        "Splits go by prompt family: a small dataset can miss 80/10/10 by far, or lack a split.",
        lambda _, facts: facts["families"] < 100,
    ),
    Limit("Colours come from a fast renderer, not from light that was traced.",
          lambda _, facts: any(k.startswith("raster")
                               for k in (facts.get("clips") or {}).get("renderers", {}))),
    Limit("Flow tells where a surface goes, whether or not something hides it by then; beyond two "
          "picture widths it is not told.", _seen("flow", "backward_flow")),
    Limit("Wheels turn on their bodies but have their bodies' ids, and no tracked points.",
          _seen("segmentation", "tracks")),
    Limit("Scenery (houses, trees, furniture of a place) has no ids of its own: it counts as "
          "ground.", _seen("segmentation")),
)  # fmt: skip
"""All of them, in the order in which they are told."""
