"""Everything that can be seen of a replayed scene, for any renderer."""

from __future__ import annotations

from esg.engines.scene import Rollout, SimScene
from esg.graph.models import EsgDocument
from esg.view.parts import scene_parts
from esg.view.renderers.records import Scenery


def scenery_of(
    scene: SimScene, rollout: Rollout, doc: EsgDocument, sun: float | None = None
) -> Scenery:
    """Meshes of the bodies and what surrounds them.

    Args:
        scene: The bodies.
        rollout: Their motion.
        doc: Asset configurations (meshes) and dressing.
        sun: Azimuth of a viewer [rad]: the sun of a plain sky stands behind him.
    """
    parts = tuple(scene_parts(scene, rollout, doc))
    return Scenery(parts, len(scene.bodies), None)
