"""Billiards and other pockets: a shot is planned backwards from where it shall end."""

from __future__ import annotations

from esg.dynamics.kinematics import Frame
from esg.dynamics.stage import Stage, speed_is_fixed
from esg.dynamics.stagecraft import pocket_shot
from esg.graph.models import NodeEvent, TimelineNode


def pocket_event(stage: Stage) -> TimelineNode | None:
    """The event that something enters a pocket of the table it all takes place on, or None."""
    for node in stage.story.nodes.values():
        owner = (node.region or "").split("/")[0]
        inside = node.event is NodeEvent.ENTER_REGION and owner == stage.anchor
        if inside and owner and stage.concerns(node):
            return node
    return None


def play_pocket(stage: Stage, event: TimelineNode) -> None:
    """A shot planned backwards from the pocket: ball, ghost ball, cue ball."""
    assert stage.anchor is not None and event.region is not None
    chain = _chain_to(stage, event)
    spots = pocket_shot(stage.doc, stage.anchor, event.region, chain, stage.rng)
    time = 0.0
    for name, (x, y, yaw) in spots.items():
        stage.places[name] = (x, y, yaw)
        if name in stage.tracks:
            stage.frames[name] = Frame(x, y, yaw)
    for node in stage.story.nodes.values():
        for actor, phase in stage.incoming(node):
            speed = min(stage.speed(actor, phase), 2.5)
            if speed_is_fixed(phase):
                speed = stage.speed(actor, phase)
            stage.nominal[f"{phase.edge.id}/speed"] = speed
        if node.event is not NodeEvent.SCENE_START and set(node.participants) & stage.names:
            time += 0.5
        stage.time[node.id] = time


def _chain_to(stage: Stage, event: TimelineNode) -> list[str]:
    """Bodies from the one that enters back to the active one that starts it."""
    chain = [event.participants[0]]
    hits = [n for n in stage.story.nodes.values() if n.event is NodeEvent.COLLISION]
    while not stage.story.is_active(chain[-1]):
        source = next(
            (
                p
                for n in hits
                if chain[-1] in n.participants
                for p in n.participants
                if p not in chain
            ),
            None,
        )
        if source is None:
            break
        chain.append(source)
    return chain
