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
        device: Warp device of the search.
    """

    starts: int = 16
    candidates: int = 48
    iterations: int = 120
    rounds: int = 3
    collision: Literal["proxy", "aabb", "sdf", "hybrid"] = "proxy"
    refine: bool = True
    sample_init: bool = True
    preference: bool = True
    preference_weight: float = 0.05
    alignment_weight: float = 1.0
    device: str = "cpu"

    def to_json(self) -> dict[str, Any]:
        """Returns the settings as plain values for provenance, without the device."""
        data = asdict(self)
        del data["device"]
        return data
