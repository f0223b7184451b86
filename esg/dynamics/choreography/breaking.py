"""What breaks: by a blow that has been told, or where it comes down."""

from __future__ import annotations

import math

from esg.dynamics.choreography.stage import Stage
from esg.graph.models import NodeEvent, TimelineNode
from esg.units import GRAVITY_MPS2

AT_ONCE_S = 0.02
USUAL_DROP_M = 0.8


def shattered(stage: Stage, node: TimelineNode) -> None:
    """Break: at once after a hit, and after a fall or a topple when the ground is reached."""
    before = stage.story.before.get(node.id, ())
    last = max((stage.time.get(b, 0.0) for b in before), default=0.0)
    drops = (NodeEvent.FALL, NodeEvent.TOPPLE)
    down = any(stage.story.nodes[b].event in drops for b in before)
    wait = math.sqrt(2.0 * USUAL_DROP_M / GRAVITY_MPS2) if down else AT_ONCE_S
    for actor, _ in stage.incoming(node):
        stage.tracks[actor].straight(0.0, wait, 0.0)
    stage.time[node.id] = stage.prescribed_time(node) or last + wait
