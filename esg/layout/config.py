"""Settings of the layout stage, including the switches of the ablations."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any, Literal


@dataclass(frozen=True)
class LayoutConfig:
    """How the layout is searched.

    Args:
        starts: Independent initializations per scene (K in the paper).
        candidates: Sampled poses per unit and start.
        iterations: Upper bound of Adam steps.
        tolerance: Relative energy decrease over 20 steps at which a start stops.
        rounds: Further batches with fresh seeds while no start is feasible.
        collision: Collision energy: `proxy` uses the exact separation of the collision proxies,
            `aabb` the paper's overlap of world bounding boxes, `sdf` the paper's sampled signed
            distances, `hybrid` SDF samples with the box of every large object.
        refine: False stops after initialization (w/o global refinement).
        sample_init: False starts from random poses (w/o sampling initialization).
        preference: False drops the preference energy (w/o preference).
        preference_weight: Weight of the preference energy against the constraint energy.
        alignment_weight: Weight of what makes a directional relation tidy (cleared footprints,
            lateral alignment, upper range) against what makes it true.
        threads: CPU threads that share the starts; the result does not depend on it.
        device: Warp device of the search.
        processes: Processes that build and judge the scenes of a batch beside the search; the
            result does not depend on it.
    """

    starts: int = 16
    candidates: int = 48
    iterations: int = 80
    tolerance: float = 1e-3
    rounds: int = 3
    collision: Literal["proxy", "aabb", "sdf", "hybrid"] = "proxy"
    refine: bool = True
    sample_init: bool = True
    preference: bool = True
    preference_weight: float = 0.05
    alignment_weight: float = 1.0
    threads: int = 2
    device: str = "cpu"
    processes: int = 1

    def to_json(self) -> dict[str, Any]:
        """Returns the settings that can change a result, as plain values for provenance."""
        data = asdict(self)
        del data["device"], data["threads"], data["processes"]
        return data
