"""The place around the action: which one, what stands in it, and its meshes.

Nothing here is a body. `dress` fills one field of the document, `Dressing`, from the finished
document and its replay; `esg.view.surroundings` draws it (docs/layout/dressing.md).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from esg.engines.scene import Rollout, SimScene
    from esg.graph.models import EsgDocument


def dress(doc: EsgDocument, scene: SimScene, rollout: Rollout, *, seed: int = 0) -> EsgDocument:
    """Fills `dressing` (esg.dressing.stage)."""
    from esg.dressing.stage import dress as run

    return run(doc, scene, rollout, seed=seed)
