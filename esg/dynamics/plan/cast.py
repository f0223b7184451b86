"""Who takes part in a timeline and how: the questions that planning asks of scene and story."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.choreography.flights import flown_to
from esg.dynamics.choreography.handling import goes_straight_up
from esg.dynamics.choreography.slopes import slope_of
from esg.dynamics.plan.aim import aim_point, region_center, rim_point
from esg.dynamics.story.stagecraft import lies_on, support_of, top_surface
from esg.dynamics.story.story import ON_THE_SPOT, Phase, Story, read_story, rebounds, stranded
from esg.engines.scene import Body, Region, SimScene
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, TimelineNode
from esg.units import quat_rotate

NOT_DRIVEN = (EdgeEvent.TOWARD, *ON_THE_SPOT)
"""What begins so does not turn to where it goes."""


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
        self.story: Story = self._who_can_move(read_story(doc))
        self.nominal = nominal

    def _who_can_move(self, story: Story) -> Story:
        """The story without the motions of what cannot move: decals, fixtures."""
        bodies = {a: self.scene.body(a) for a in story.phases}
        phases = {
            a: p for a, p in story.phases.items() if bodies[a].shapes and not bodies[a].static
        }
        return replace(story, phases=phases)

    def drives(self, actor: str) -> bool:
        """Under its own power on the ground: its body points where it goes."""
        first = self.story.phases[actor][0].edge.event
        held = any(j.child == actor for j in self.scene.joints)
        return first not in NOT_DRIVEN and not held and self.scene.body(actor).roll_radius == 0.0

    def target(self, phase: Phase) -> str | None:
        """The body a phase is directed at."""
        names = [p for p in phase.end.participants if p != phase.edge.actor]
        if phase.end.region:
            names.append(phase.end.region.split("/")[0])
        if phase.edge.target:
            names.append(phase.edge.target)
        return next((n for n in names if n in self.scene.names), None)

    def region(self, phase: Phase) -> Region | None:
        """The region a phase ends in."""
        return next((r for r in self.scene.regions if r.name == phase.end.region), None)

    def throw_goal(self, actor: str, phase: Phase) -> NDArray[np.float64] | None:
        """The point a throw is aimed at: the region to enter, or the target's broadest part."""
        if goes_straight_up(phase):
            return None
        banked = self._bank_point(actor, phase)
        if banked is not None:
            return banked
        phase = flown_to(self.story, phase)
        if phase.end.region:
            center = region_center(self.scene, phase.end.region)
            if center is not None:
                return center
        target = self.target(phase)
        if not target:
            return None
        body = self.scene.body(actor)
        if lies_on(self.doc, actor, target) and not self.story.soars(actor):
            return self._on_top(body, target)
        rim = rim_point(self.scene, body, target)
        return aim_point(body, self.scene.body(target)) if rim is None else rim

    def _on_top(self, body: Body, target: str) -> NDArray[np.float64]:
        """Where the middle of a body is that lies on the top of another [m], shape [3]."""
        host, surface = self.scene.body(target), top_surface(self.doc, target)
        center = np.array(surface.center_cm) / 100.0 + np.array(host.origin_offset)
        top = np.array(host.position) + quat_rotate(np.array(host.quaternion), center)
        return top + np.array([0.0, 0.0, body.half_extents[2]])

    def _bank_point(self, actor: str, phase: Phase) -> NDArray[np.float64] | None:
        """Where the choreography has a ball hit a board to come down in the hoop before it."""
        above = self.nominal.get(f"{phase.edge.id}/goal_above")
        if above is None:
            return None
        after = (p for p in self.story.phases[actor] if p.start.id == phase.end.id)
        region = next((p.end.region for p in after if p.end.region), None)
        center = region_center(self.scene, region) if region else None
        under = self.target(phase)
        if under is not None and (region is None or region.split("/")[0] != under):
            top = self.scene.body(under)  # it bounces off that, on to something else
            center = np.array(top.position)
            center[2] += top.origin_offset[2]
        if center is None:
            return None
        way = (center - np.array(self.scene.body(actor).position))[:2]
        beyond = self.nominal[f"{phase.edge.id}/goal_beyond"]
        flat = beyond * way / max(float(np.linalg.norm(way)), 1e-9)
        return center + np.array([flat[0], flat[1], above])

    def coasts(self, phase: Phase) -> bool:
        """A launched body that is already on its way: nothing new is done to it."""
        nothing = phase.edge.params.speed is None and phase.edge.params.elevation_deg is None
        first = self.story.phases[phase.edge.actor][0]
        if phase is first or self.story.tips(phase) or phase.end.event is NodeEvent.JUMP:
            return False
        if stranded(self.story, phase, lambda name: self.scene.body(name).static):
            return True
        actor = phase.edge.actor
        if phase.end.event is NodeEvent.FALL and self.story.soars(actor):
            # What flies under its own power falls when nothing carries it on any more.
            return True
        return (phase.edge.event is EdgeEvent.TOWARD and nothing) or self.rebounds(phase)

    def rebounds(self, phase: Phase) -> bool:
        """Whether a driver rolls back from what does not give way, before its brake sets in."""
        return rebounds(self.story, phase, lambda name: self.scene.body(name).static)

    def pushes_off(self, actor: str, phase: Phase) -> TimelineNode | None:
        """The fall of what a driven body pushes over an edge: it keeps pushing until then."""
        if phase.end.event is not NodeEvent.COLLISION or not self.drives(actor):
            return None
        target = self.target(phase)
        after = self.story.after(phase.end.id)
        falls = (n for n in after if n.event is NodeEvent.FALL and target in n.participants)
        return next(falls, None)

    def brakes_after(self, actor: str, phase: Phase) -> bool:
        """A driven body whose part ends with a hit brakes there.

        Otherwise it would roll on or back for seconds, run into the back of what it has just sent
        on its way, and crush it against the next target. On foot only the latter is prevented.
        """
        body = self.scene.body(actor)
        if phase.end.event is not NodeEvent.COLLISION or body.roll_radius:
            return False
        after = self.story.after(phase.end.id)
        return (bool(after) or body.wheeled) and not any(actor in n.participants for n in after)

    def leaves_support(self, actor: str, phase: Phase) -> bool:
        """Whether a body that stands on something meets what stands on the ground."""
        target, support = self.target(phase), support_of(self.doc, actor)
        if support is None or target is None or phase.end.event is not NodeEvent.COLLISION:
            return False
        return target != support and support_of(self.doc, target) is None

    def goes_down(self, actor: str, phase: Phase) -> bool:
        """Whether something stands at the top of a slope and goes on by itself, to nowhere."""
        support = support_of(self.doc, actor)
        if support is None or phase.end.event is not NodeEvent.TRIGGER or not self.drives(actor):
            return False
        return slope_of(self.doc, support) is not None

    def rolls_down(self, actor: str, phase: Phase) -> bool:
        """Whether it tilts with the slope: what is low and long does, who stands up would fall."""
        body = self.scene.body(actor)
        ridden = any(j.parent == actor for j in self.scene.joints)
        low = body.wheeled and body.half_extents[2] < body.half_extents[0] and not ridden
        return low and self.goes_down(actor, phase)

    def balls_after(self, phase: Phase) -> int:
        """How many hits of balls by balls follow from the first one, three at most."""
        target = self.target(phase)
        count, seen = 0, {phase.edge.actor}
        for node in self.story.after(phase.end.id):
            bodies = [p for p in node.participants if p in self.scene.names]
            if node.event is not NodeEvent.COLLISION or target not in bodies:
                continue
            others = [b for b in bodies if b != target and b not in seen]
            if not others or not self.scene.body(others[0]).roll_radius:
                continue
            if not self.scene.body(target).roll_radius:
                break
            seen.add(target)
            target, count = others[0], count + 1
        return min(count, 3)

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
