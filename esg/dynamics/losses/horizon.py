"""How long a rollout has to be until it has told all that losses ask of it.

A scene plays on after its last event: a recording needs that, a search does not. A world is told by
the time at which every event has happened and what is looked at after it (whether two bodies have
parted 0.2 s after a hit) has been seen.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses.assessment import Assessment
from esg.dynamics.losses.kinds import kind_of
from esg.dynamics.plan import Plan
from esg.dynamics.story.story import Story
from esg.graph.models import TimelineNode


def looked_at_for(node: TimelineNode) -> float:
    """How long after an event something is measured with it [s]."""
    return kind_of(node).after_s


def expected_end(plan: Plan) -> float:
    """By when the choreography expects everything to have been seen [s]."""
    return plan.latest + max(looked_at_for(node) for node in plan.story.nodes.values())


def told_by(story: Story, assessed: Assessment) -> NDArray[np.float64]:
    """When each world has told everything [s], infinite where an event is missing, shape [W]."""
    out = np.zeros(len(assessed.total))
    for node in story.nodes.values():
        time = np.nan_to_num(assessed.time[node.id], nan=np.inf)
        out = np.maximum(out, time + looked_at_for(node))
    return np.where(assessed.all_completed(), out, np.inf)
