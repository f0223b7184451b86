"""Options of what a dataset draws and keeps."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter


@Parameter(name="*")
@dataclass(frozen=True)
class DrawOptions:
    """What scenes are drawn, and which are kept.

    Args:
        distribution: YAML file with the shares of what is sampled (docs/dataset/variety.md).
        counterfactual: Sample pairs of scenes that differ in one parameter.
        thin: Leave near-duplicates out of the splits; without it they are marked.
    """

    distribution: Path | None = None
    counterfactual: Annotated[bool, Parameter(negative="")] = False
    thin: Annotated[bool, Parameter(negative="")] = False
