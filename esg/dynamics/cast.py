"""Who takes part in a timeline and how: the questions that planning asks of scene and story."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.aim import aim_point, region_center
from esg.dynamics.story import Phase, Story, read_story
from esg.engines.scene import SimScene
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, TimelineNode


class Cast:
    """Scene, story and nominal parameters of one document, and what follows from them.

    Args:
        doc: A document with layout.
        scene: Its physical scene.
        nominal: Parameters the choreography chose, by name (SI).
        look_ahead: Aim with what comes after the first hit in mind.
    """

    def __init__(
        self, doc: EsgDocument, scene: SimScene, nominal: dict[str, float], look_ahead: bool
    ) -> None:
        self.doc, self.scene, self.look_ahead = doc, scene, look_ahead
        self.story: Story = read_story(doc)
        self.nominal = nominal

    def drives(self, actor: str) -> bool:
        """Under its own power on the ground: its body points where it goes."""
        first = self.story.phases[actor][0].edge.event
        return first is not EdgeEvent.TOWARD and self.scene.body(actor).roll_radius == 0.0

    def target(self, phase: Phase) -> str | None:
        """The body a phase is directed at."""
        names = [p for p in phase.end.participants if p != phase.edge.actor]
        if phase.end.region:
            names.append(phase.end.region.split("/")[0])
        if phase.edge.target:
            names.append(phase.edge.target)
        return next((n for n in names if n in self.scene.names), None)

    def throw_goal(self, actor: str, phase: Phase) -> NDArray[np.float64] | None:
        """The point a throw is aimed at: the region to enter, or the target's broadest part."""
        if phase.end.region:
            center = region_center(self.scene, phase.end.region)
            if center is not None:
                return center
        target = self.target(phase)
        body = self.scene.body(actor)
        return aim_point(body, self.scene.body(target)) if target else None

    def coasts(self, phase: Phase) -> bool:
        """A launched body that is already on its way: nothing new is done to it."""
        nothing = phase.edge.params.speed is None and phase.edge.params.elevation_deg is None
        first = self.story.phases[phase.edge.actor][0]
        return phase.edge.event is EdgeEvent.TOWARD and nothing and phase is not first

    def tips(self, phase: Phase) -> bool:
        """Whether a phase tips its own actor over where it stands."""
        return (
            phase.end.event is NodeEvent.TOPPLE
            and phase.edge.actor in phase.end.participants
            and phase.edge.event is EdgeEvent.TOWARD
            and not self.story.flies(phase.edge.actor)
        )

    def shall_topple(self, name: str | None) -> bool:
        """Whether the story tips a body over: it is then hit above its middle."""
        return name is not None and self.story.topples(name)

    def pushes_off(self, actor: str, phase: Phase) -> TimelineNode | None:
        """The fall of what a driven body pushes over an edge: it keeps pushing until then."""
        if phase.end.event is not NodeEvent.COLLISION or not self.drives(actor):
            return None
        target = self.target(phase)
        after = self.story.after(phase.end.id)
        falls = (n for n in after if n.event is NodeEvent.FALL and target in n.participants)
        return next(falls, None)

    def leaves_to_others(self, actor: str, phase: Phase) -> bool:
        """A driven body whose part ends with a hit that others carry on brakes there.

        Otherwise it would run into the back of what it has just sent on its way, and crush it
        against the next target.
        """
        if phase.end.event is not NodeEvent.COLLISION or self.scene.body(actor).roll_radius:
            return False
        after = self.story.after(phase.end.id)
        return bool(after) and not any(actor in n.participants for n in after)

    def contacts(self, phase: Phase) -> tuple[str, ...]:
        """A hold ends at the touch of the target, or of any other member of its group."""
        names: list[str] = []
        for p in phase.end.participants:
            if p != phase.edge.actor and phase.end.event is not NodeEvent.SCENE_START:
                names += self.story.expand(p)
        if phase.edge.target and phase.edge.target in self.scene.names:
            names += self.story.expand(phase.edge.target)
        seen = dict.fromkeys(
            n for n in names if n != phase.edge.actor and self.scene.body(n).shapes
        )
        return tuple(seen)
