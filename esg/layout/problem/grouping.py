"""Makes the units of a layout: planned constellations, patterned groups, single objects."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
import itertools
import math

import numpy as np

from esg.graph.models import EsgDocument, RelationType
from esg.layout.judge.setting import set_on_supports, step_aside
from esg.layout.problem.decals import lay_decals
from esg.layout.problem.hints import Constellation, Corridor, StartHints, in_the_way
from esg.layout.problem.joined import joined
from esg.layout.problem.kerbs import lay_along, line_up
from esg.layout.problem.patterns import arrange, is_domino_like
from esg.layout.problem.poses import Pose2, compose, inverse
from esg.layout.problem.roles import falling_nodes, ground_nodes
from esg.layout.problem.streets import (
    Street,
    is_parked,
    lay_beside_parked,
    lay_street,
    street_in,
    street_of,
    streets_in,
    turned_into,
    users,
)
from esg.layout.problem.supports import Shape, SupportMap, stand_on
from esg.layout.problem.units import Unit, group_members

RIGID_PATTERNS = ("pins", "rack", "row", "column", "queue", "stack")


class UnitBuilder:
    """Collects units so that every node belongs to exactly one."""

    def __init__(
        self,
        doc: EsgDocument,
        shape: dict[str, Shape],
        supports: SupportMap,
        hints: StartHints | None,
        seed: int,
    ) -> None:
        self.doc = doc
        self.shape = shape
        self.supports = supports
        self.seed = seed
        self.hints = hints or StartHints()
        self.groups = group_members(doc)
        self.nodes = doc.spatial_relation_graph.nodes
        self.taken: dict[str, Unit] = {}
        self.units: list[Unit] = []
        self.notes: list[str] = []
        self.stacked: dict[str, str] = {}
        self.joined = joined(doc)

    @cached_property
    def rng(self) -> np.random.Generator:
        """Source of scatter patterns, which few scenes have."""
        return np.random.default_rng([self.seed, 77])

    def build(self) -> list[Unit]:
        """Returns all units; ground nodes are fixed at the origin."""
        for name in ground_nodes(self.doc):
            self._add(Unit({name: (0.0, 0.0, 0.0)}, free=(False, False, False)))
        for constellation in self.hints.constellations:
            self._constellation(constellation)
        for name, members in self.groups.items():
            rest = [m for m in members if m not in self.taken]
            if len(rest) == len(members):
                self._group(name, members)
            elif rest:
                self._complete(name, members, rest)
        planned = [u for u in self.units if u.is_planned]
        # without planned motion, a queue of vehicles stands along its road
        queues = [u for u in self.units if len(u.members) > 1 and self._is_queue(u)]
        for unit in planned or queues[:1]:
            self._lay_decals(unit)
        if not planned:
            self._line_street()
        for name in self.nodes:
            if name not in self.taken:
                self._add(Unit({name: (0.0, 0.0, 0.0)}, parent=self._base(name)))
        self._pile_up()
        falling = falling_nodes(self.doc) if planned else frozenset()
        for unit in planned:
            for name in set_on_supports(unit, self.supports, self.shape, falling):
                parent = self.supports.of[name].parent
                self.notes.append(f"{name} was planned beside or in {parent} and is set on it")
        for name, root in self.joined.root.items():
            members = self.taken[name].members
            if root in members:
                members[name] = compose(members[root], self.joined.rel[name])
        return self.units

    def _base(self, name: str) -> str | None:
        """What carries a node, or the jointed thing that it is a part of."""
        return self.supports.of[self.joined.root.get(name, name)].parent

    def _pile_up(self) -> None:
        """Stands the members of stacks on each other, clear of what stands up from them."""
        piled = {n: self.taken[n].members[n] for n in (*self.stacked, *self.stacked.values())}
        for above, below in self.stacked.items():
            if self.supports.of[above].parent != below:
                self.supports.of[above] = stand_on(self.shape[above], below, self.shape[below])
            unit = self.taken[above]
            if below in unit.members and piled[above] == piled[below]:
                aside = step_aside(self.supports.of[above], self.shape[below], self.shape[above])
                unit.members[above] = compose(unit.members[below], aside)

    def _is_queue(self, unit: Unit) -> bool:
        group = self.nodes[next(iter(unit.members))].group
        return (
            group is not None
            and self.pattern_of(group) in ("queue", "column")
            and all(self.shape[n].config.is_wheeled for n in unit.members)
        )

    def _add(self, unit: Unit) -> None:
        self.units.append(unit)
        for name, pose in list(unit.members.items()):
            self._put(unit, name, pose)

    def _size(self, name: str) -> tuple[float, float, float]:
        """Length, width and height of a node with what is joined to it [cm]."""
        mine = self.shape[name]
        hx, hy = mine.hx, mine.hy
        for mate, (x, y, yaw) in self.joined.mates(name).items():
            its, c, s = self.shape[mate], abs(math.cos(yaw)), abs(math.sin(yaw))
            hx = max(hx, abs(x) + its.hx * c + its.hy * s)
            hy = max(hy, abs(y) + its.hx * s + its.hy * c)
        return (2 * hx, 2 * hy, mine.height)

    def pattern_of(self, group: str) -> str:
        """The pattern that most precisely describes a group."""
        for name in self.groups[group]:
            if self.nodes[name].group_pattern is not None:
                return str(self.nodes[name].group_pattern)
        return "scatter"

    def _arrange(self, group: str, members: list[str]) -> dict[str, Pose2]:
        pattern = self.pattern_of(group)
        poses = arrange(pattern, [self._size(m) for m in members], self.rng)
        if pattern == "stack":
            for below, above in itertools.pairwise(members):
                self.stacked[above] = below
        return dict(zip(members, poses, strict=True))

    def _expand(self, constellation: Constellation) -> tuple[dict[str, Pose2], dict[str, float]]:
        poses: dict[str, Pose2] = {}
        heights: dict[str, float] = {}
        singles = {p.node for p in constellation.placements}
        for p in constellation.placements:
            frame = (p.x_cm, p.y_cm, math.radians(p.yaw_deg or 0.0))
            if p.node.startswith("group:"):
                name = p.node.removeprefix("group:")
                members = [m for m in self.groups.get(name, []) if m not in singles]
                local = self._arrange(name, members) if members else {}
            elif p.node in self.nodes:
                local = {p.node: (0.0, 0.0, 0.0)}
            else:
                self.notes.append(f"hint for unknown node {p.node!r} ignored")
                continue
            if not local:
                self.notes.append(f"hint for empty group {p.node!r} ignored")
            for node, pose in local.items():
                poses.setdefault(node, compose(frame, pose))
                if p.z_cm is not None and node not in self.joined.root:
                    heights[node] = p.z_cm
        faces = {
            e.from_: e.to
            for e in self.doc.spatial_relation_graph.edges.binary_relations
            if e.relation_type is RelationType.FACE and e.cardinal is None
        }
        for p in constellation.placements:
            target = faces.get(p.node)
            if p.yaw_deg is None and p.node in poses and target in poses:
                (x, y, _), (u, v, _) = poses[p.node], poses[target]
                poses[p.node] = (x, y, math.atan2(v - y, u - x))
        for node, pose in list(poses.items()):
            for mate, there in self.joined.mates(node).items():
                poses.setdefault(mate, compose(pose, there))
        return poses, heights

    def _constellation(self, c: Constellation) -> None:
        poses, heights = self._expand(c)
        if c.anchor is not None and c.anchor not in self.nodes:
            self.notes.append(f"hint anchor {c.anchor!r} unknown")
        anchor = c.anchor if c.anchor in self.nodes else None
        shared = [n for n in poses if n in self.taken]
        if shared:
            self._merge(c, poses, heights, shared)
            return
        if not poses:
            return
        parent: str | None = None
        free = (True, True, c.yaw_deg is None)
        pose: Pose2 = (0.0, 0.0, math.radians(c.yaw_deg or 0.0))
        outside = self._carriers_outside(poses, heights)
        if anchor is not None and anchor not in poses and anchor not in self.taken:
            # the anchor becomes the origin of the unit, so that one frame carries everything
            poses = {anchor: (0.0, 0.0, 0.0), **poses}
        elif anchor is not None and anchor not in poses:
            parent, free, pose = anchor, (False, False, False), (0.0, 0.0, 0.0)
        for p, at in outside.items():
            if p not in poses and p not in self.taken and p != parent:
                poses[p] = (poses[at][0], poses[at][1], 0.0)
        unit = Unit(
            poses, parent, pose, free, list(c.corridors), heights, is_planned=True, anchor=anchor
        )
        unit.parent = parent or self._sole_carrier(poses)
        self._add(unit)

    def _carriers_outside(
        self, poses: dict[str, Pose2], heights: dict[str, float]
    ) -> dict[str, str]:
        """What carries members without being one, with the first member on it.

        It stands with them, unless everything stands on the same object.
        """
        out: dict[str, str] = {}
        for n in poses:
            p = self.supports.of[n].parent if n not in heights else None
            if p is not None and p not in poses and not self.shape[p].is_decal:
                out.setdefault(p, n)
        return dict(sorted(out.items()))

    def _sole_carrier(self, poses: dict[str, Pose2]) -> str | None:
        """The one placed object that carries every member, if there is one."""
        parents = {self.supports.of[n].parent for n in poses}
        carried = parents - set(poses) - {None}
        if len(carried) != 1 or None in parents:
            return None
        only = next(iter(carried))
        return only if only in self.taken and not self.shape[str(only)].is_decal else None

    def _merge(
        self,
        c: Constellation,
        poses: dict[str, Pose2],
        heights: dict[str, float],
        shared: list[str],
    ) -> None:
        """Joins a second constellation to the unit that already owns some of its nodes."""
        unit = self.taken[shared[0]]
        frame = compose(unit.members[shared[0]], inverse(poses[shared[0]]))
        for node in shared[1:]:
            here = compose(frame, poses[node])
            other = self.taken[node]
            off = math.inf
            if other is unit:
                off = math.dist(here[:2], other.members[node][:2])
            if off > 1.0:
                self.notes.append(
                    f"two planned starts of {node!r} disagree by {off:.0f} cm; the first is kept"
                )
        for node, pose in poses.items():
            if node not in self.taken:
                unit.members[node] = compose(frame, pose)
                self.taken[node] = unit
                if node in heights:
                    unit.z_cm[node] = heights[node]
        for corridor in c.corridors:
            points = tuple(compose(frame, (x, y, 0.0))[:2] for x, y in corridor.points_cm)
            unit.corridors.append(
                Corridor(points, corridor.half_width_cm, corridor.participants)
            )  # fmt: skip
        unit.is_planned = True

    def _group(self, name: str, members: list[str]) -> None:
        pattern = self.pattern_of(name)
        if pattern not in RIGID_PATTERNS or len(members) < 2:
            return
        if street_in(self.doc) is not None and all(is_parked(self.doc, m) for m in members):
            return  # along the kerb, one by one
        bases = {self._base(m) for m in members} - set(members)
        if len(bases) > 1:
            return
        if pattern != "stack" and any(self.supports.of[m].parent in members for m in members):
            pattern = "stack"
        poses = self._arrange(name, members)
        # the unit's frame is the middle of the arrangement
        mid = np.mean([p[:2] for p in poses.values()], axis=0)
        poses = {n: (p[0] - float(mid[0]), p[1] - float(mid[1]), p[2]) for n, p in poses.items()}
        base = next(iter(bases)) if bases else None
        self._add(Unit(poses, parent=base))

    def _beside_the_way(self, c: Corridor, m: str, at: Pose2) -> bool:
        """Whether a path leads past a member; in a row it stands close to who is hit there."""
        mine = [self.shape[p] for p in c.participants if p in self.shape]
        width = max((max(s.hx, s.hy) for s in mine), default=c.half_width_cm)
        narrow = replace(c, half_width_cm=min(width, c.half_width_cm))
        return not in_the_way(narrow, *at[:2], max(self.shape[m].hx, self.shape[m].hy))

    def _complete(self, name: str, members: list[str], rest: list[str]) -> None:
        """Sets the members of a pattern that no motion plans beside the one that has a start.

        The first domino of a row is pushed, the others belong where the row continues. Not done
        where several starts say otherwise, where what carries them differs, or where a planned path
        would run into them, unless they are there to be run into, as dominoes are.
        """
        started = [m for m in members if m in self.taken]
        unit = self.taken[started[0]]
        pattern = self.pattern_of(name)
        if pattern not in RIGID_PATTERNS or started[0] in unit.z_cm:
            return
        if len({self.supports.of[m].parent for m in members} - set(members)) > 1:
            return
        if pattern == "stack" and any(self.taken[m] is not unit for m in started):
            return
        local = self._arrange(name, members)
        if pattern == "stack":
            self._pile(unit, started[0], rest)
            return
        topple = all(is_domino_like(*self._size(m)) for m in members)
        first = unit.members[started[0]]
        paths = [c for c in unit.corridors if not {f"group:{name}", *rest} & set(c.participants)]

        def is_clear(c: Corridor, m: str, at: Pose2) -> bool:
            return _met_later(c, first, at) if topple else self._beside_the_way(c, m, at)

        # a row may also continue to the other side; of balls and cones it may lie any way
        square = all(
            math.isclose(s.hx, s.hy, rel_tol=0.1) for s in map(self.shape.get, members) if s
        )
        across = ((0.0, 1.0), (0.0, -1.0)) if square else ()
        for c, s in ((1.0, 0.0), (-1.0, 0.0), *across):
            turned = {m: (c * x - s * y, s * x + c * y, yaw) for m, (x, y, yaw) in local.items()}
            frame = compose(first, inverse(turned[started[0]]))
            poses = {m: compose(frame, turned[m]) for m in members}
            agrees = all(
                self.taken[m] is unit and math.dist(poses[m][:2], unit.members[m][:2]) <= 1.0
                for m in started
            )
            if agrees and all(is_clear(path, m, poses[m]) for m in rest for path in paths):
                for m in rest:
                    self._put(unit, m, poses[m])
                return
        self.notes.append(f"the {pattern} of {name!r} is not kept: a planned path crosses it")

    def _pile(self, unit: Unit, started: str, rest: list[str]) -> None:
        """Sets the rest of a stack above and below the member that has a start."""
        for m in rest:
            unit.members[m] = unit.members[started]
            self.taken[m] = unit
        unit.corridors = [
            replace(c, participants=(*c.participants, *rest)) if started in c.participants else c
            for c in unit.corridors
        ]

    def _lay_decals(self, unit: Unit) -> None:
        self._lay_street(unit)
        free = [n for n in self.nodes if n not in self.taken and self.shape[n].is_decal]
        for name, pose in lay_decals(self.doc, unit, free, self.supports, self.shape).items():
            unit.members[name] = pose
            self.taken[name] = unit

    def _lay_street(self, unit: Unit) -> None:
        """Lays the scene's street under those who drive on it, and what belongs to it along it."""
        road = street_in(self.doc)
        street = street_of(self.doc, road) if road is not None else None
        if road is None or street is None or road in self.taken or not unit.is_planned:
            return
        who = users(self.doc, unit, road, self.supports, self.shape)
        if not who.drivers:
            pose = lay_beside_parked(street, who, unit)
            if pose is not None:
                self._put(unit, road, pose)
                self._line(unit, road, street)
            return
        if turned_into(unit, who) is not None:
            who = replace(who, beside={}, waiting={}, on_it={})  # most is along the other road
        ways = [p[:2] for p in unit.members.values()]
        ways += [p for c in unit.corridors for p in c.points_cm]
        self._put(unit, road, lay_street(street, who, ways))
        line_up(street, unit.members[road], who, unit)
        for other in streets_in(self.doc):
            if other not in self.taken:
                arrived = turned_into(unit, who) or who
                self._put(unit, other, lay_street(street, arrived, ways))
        self._line(unit, road, street)

    def _line_street(self) -> None:
        """Puts what belongs at its kerbs along a street on which nothing is planned."""
        road = street_in(self.doc)
        if road is None:
            return
        unit = self.taken.get(road)
        if unit is None:
            unit = Unit({road: (0.0, 0.0, 0.0)})
            self._add(unit)
        street = street_of(self.doc, road)
        assert street is not None
        self._line(unit, road, street)

    def _line(self, unit: Unit, road: str, street: Street) -> None:
        free = [n for n in self.nodes if n not in self.taken]
        poses = lay_along(self.doc, road, street, unit, free, self.supports, self.shape)
        for name, pose in poses.items():
            self._put(unit, name, pose)

    def _put(self, unit: Unit, name: str, pose: Pose2) -> None:
        """Adds a node to a unit, and with it what is joined to it."""
        unit.members[name] = pose
        self.taken[name] = unit
        for mate, there in self.joined.mates(name).items():
            if mate not in self.taken:
                unit.members.setdefault(mate, compose(pose, there))
                self.taken[mate] = unit


def _met_later(c: Corridor, first: Pose2, at: Pose2) -> bool:
    """Whether who comes along a path meets the member that has a start before another."""
    dx, dy = first[0] - c.points_cm[0][0], first[1] - c.points_cm[0][1]
    return (at[0] - first[0]) * dx + (at[1] - first[1]) * dy > -1.0
