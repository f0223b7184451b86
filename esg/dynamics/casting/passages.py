"""What something goes through has room for it: a truck needs a wider gateway than a man."""

from __future__ import annotations

from esg.dynamics.casting.changes import Configs, resized
from esg.dynamics.choreography.courses.passages import ways_through
from esg.dynamics.story.stagecraft import prop
from esg.dynamics.story.story import Story
from esg.graph.models import EsgDocument

WIDE, HIGH = 1.5, 1.25
"""Width and height of an opening over those of what goes through, at least."""


def fit_passages(doc: EsgDocument, story: Story) -> Configs:
    """Configurations of what is too narrow or too low for what goes through it."""
    out: Configs = {}
    nodes = doc.spatial_relation_graph.nodes
    jointed = {
        name for j in doc.spatial_relation_graph.joints or () for name in (j.child, j.parent)
    }
    for s, passage in ways_through(doc, story):
        key = nodes[passage.owner].asset_id
        if passage.owner in jointed or doc.asset_requirement[key].dimensions_are_prescribed:
            continue
        body, config = prop(doc, s.object[0]), out.get(key, doc.asset_configurations[key])
        length, width, height = config.dimensions_cm
        wider = max(WIDE * body.width / passage.wide, 1.0)
        higher = max(HIGH * body.height / passage.high, 1.0)
        if wider > 1.0 or higher > 1.0:
            size = (length, wider * width, higher * height)
            out[key] = resized(doc, key, config, max(wider, higher), dimensions=size)
    return out
