"""Text to physically consistent dynamic 3D scenes, at dataset scale.

    import esg

    scene = esg.generate("A car collides with a trashbin, knocking it into a picnic table.")
    print(scene.outcome.value, [event.time_s for event in scene.verdict.events])
    scene.trajectories.of("car_1").position[-1]

Everything the command line does is here by the same words (docs/api.md). Importing this costs
nothing: physics, language and pictures are loaded by what first needs them.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.api.costs import cost
    from esg.api.datasets import Dataset, load_dataset
    from esg.api.judging import judge_trajectories
    from esg.api.making import generate, generate_many
    from esg.api.scene import Replay, Scene, judge
    from esg.api.trajectories import Contact, Track, Trajectories
    from esg.outcomes import Outcome, UserError

__version__ = "0.2.0"

_HOME = {
    "Dataset": "esg.api.datasets",
    "cost": "esg.api.costs",
    "load_dataset": "esg.api.datasets",
    "judge_trajectories": "esg.api.judging",
    "generate": "esg.api.making",
    "generate_many": "esg.api.making",
    "Replay": "esg.api.scene",
    "Scene": "esg.api.scene",
    "judge": "esg.api.scene",
    "Contact": "esg.api.trajectories",
    "Track": "esg.api.trajectories",
    "Trajectories": "esg.api.trajectories",
    "Outcome": "esg.outcomes",
    "UserError": "esg.outcomes",
}

__all__ = [
    "Contact",
    "Dataset",
    "Outcome",
    "Replay",
    "Scene",
    "Track",
    "Trajectories",
    "UserError",
    "__version__",
    "cost",
    "generate",
    "generate_many",
    "judge",
    "judge_trajectories",
    "load_dataset",
]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(_HOME[name]), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
