"""What is thrown because it could not roll to what it shall hit: a snowball at a snowman's hat."""

from __future__ import annotations

from esg.dynamics.casting.changes import thrown
from esg.dynamics.story.stagecraft import climb_height, prop, support_of, top_surface
from esg.dynamics.story.story import Phase, Story
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent


def fit_reach(doc: EsgDocument, story: Story) -> EsgDocument:
    """Has thrown what would have to roll to a target that is out of its reach.

    How high a hat sits is known only once the snowman is: a snowball on the ground passes under it.
    """
    for actor, phases in story.phases.items():
        first = phases[0]
        targets = [p for p in first.end.participants if p != actor]
        hit = first.edge.event is EdgeEvent.TOWARD and first.end.event is NodeEvent.COLLISION
        if not (hit and targets and prop(doc, actor).rolls) or story.flies(actor):
            continue
        if _enters_too_high(doc, actor, phases) or _stands_too_high(doc, actor, targets[0]):
            doc = thrown(doc, actor)
    return doc


def _stands_too_high(doc: EsgDocument, actor: str, target: str) -> bool:
    """Whether a target stands on something above an actor that does not get up there."""
    support, body = support_of(doc, target), prop(doc, actor)
    if support is None or support in (actor, support_of(doc, actor)):
        return False
    height = top_surface(doc, support).center_cm[2] / 100.0
    return height > body.height and climb_height(doc, body, support) is None


def _enters_too_high(doc: EsgDocument, actor: str, phases: tuple[Phase, ...]) -> bool:
    """Whether something shall enter a region that begins above its own height: a hoop."""
    nodes, height = doc.spatial_relation_graph.nodes, prop(doc, actor).height
    for phase in phases:
        owner, _, name = (phase.end.region or "").partition("/")
        if phase.end.event is not NodeEvent.ENTER_REGION or owner not in nodes:
            continue
        for region in doc.asset_configurations[nodes[owner].asset_id].regions:
            lowest = (region.center_cm[2] - region.half_extents_cm[2]) / 100.0
            if region.name == name and lowest > 2.0 * height:
                return True
    return False
