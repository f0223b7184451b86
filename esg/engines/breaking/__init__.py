"""Bodies that break into fragments, and how the two are swapped (docs/breaking.md)."""

from esg.engines.breaking.problems import breaking_problems
from esg.engines.breaking.swap import (
    Brittle,
    brittle,
    hidden,
    ride,
    rigid,
    shown,
    unbroken,
    whole_of_fragments,
)

__all__ = [
    "Brittle",
    "breaking_problems",
    "brittle",
    "hidden",
    "ride",
    "rigid",
    "shown",
    "unbroken",
    "whole_of_fragments",
]
