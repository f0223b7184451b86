"""Rules on the timeline as a whole: presence, actors, start, order of events."""

from __future__ import annotations

from collections import defaultdict

from esg.graph.context import TIME_EPS_S, Context, components, reachable, time_span
from esg.graph.models import ForceDirection, NodeEvent, Role, TimelineSystem
from esg.graph.violations import listing, pointer

E = NodeEvent

_NODES = ("timeline_system", "sequence_graph", "nodes")
_EDGES = ("timeline_system", "sequence_graph", "edges")


def check(ctx: Context) -> None:
    """Adds violations of the timeline's presence, actors and order."""
    timeline = ctx.doc.timeline_system
    dynamic = ctx.doc.scene_definition.scene_parameters.is_dynamic
    if timeline is None:
        if dynamic and ctx.parsed.intact("timeline_system"):
            ctx.add(
                "TIMELINE_MISSING",
                "/timeline_system",
                None,
                "The scene is dynamic but has no timeline.",
                "Add a timeline, or set scene_parameters.is_dynamic to false.",
            )
        return
    if not dynamic:
        ctx.add(
            "TIMELINE_UNEXPECTED",
            "/timeline_system",
            None,
            "The scene is static but has a timeline.",
            "Remove the timeline, or set scene_parameters.is_dynamic to true.",
        )
    _actors(ctx, timeline)
    _ids(ctx, timeline)
    _start(ctx, timeline)
    if ctx.parsed.intact("timeline_system", "sequence_graph"):
        _order(ctx, timeline)


def _actors(ctx: Context, timeline: TimelineSystem) -> None:
    moving = {e.actor for e in timeline.sequence_graph.edges}
    for name, actor in timeline.actors.items():
        where = pointer("timeline_system", "actors", name)
        if name not in ctx.node_names:
            ctx.add(
                "REF_ACTOR",
                where,
                name,
                f"Actor {name!r} is not a node.",
                f"Use one of {listing(ctx.node_names)}.",
            )
        intact = ctx.parsed.intact("timeline_system", "actors", name)
        if ctx.is_structural(name):
            ctx.add(
                "ACTOR_IMMOVABLE",
                where,
                name,
                f"Actor {name!r} is structural and cannot move.",
                "Remove it from the actors; it may still take part in events.",
            )
        if actor.role is Role.PASSIVE:
            if actor.force_direction is not None:
                ctx.add(
                    "ACTOR_FORCE_FORBIDDEN",
                    where + "/force_direction",
                    actor.force_direction.value,
                    f"Passive actor {name!r} has a force direction.",
                    "Remove it, or make the actor active.",
                )
            continue
        if actor.force_direction is None and intact:
            ctx.add(
                "ACTOR_FORCE_MISSING",
                where + "/force_direction",
                None,
                f"Active actor {name!r} has no force direction.",
                f"Use one of {listing(d.value for d in ForceDirection)}.",
            )
        if name not in moving and ctx.parsed.intact(*_EDGES):
            ctx.add(
                "ACTOR_IDLE",
                where,
                name,
                f"Active actor {name!r} has no segment and so never moves.",
                "Add its motion, or make it passive.",
            )
        node = ctx.nodes.get(name)
        asset = ctx.requirement(node) if node else None
        if node and (node.is_static or (asset and not asset.is_movable)):
            ctx.add(
                "ACTOR_IMMOVABLE",
                where,
                name,
                f"Active actor {name!r} cannot move: its node or asset is fixed.",
                "Make the asset movable and the node neither structural nor static.",
            )


def _ids(ctx: Context, timeline: TimelineSystem) -> None:
    for kind, items in (
        (_NODES, timeline.sequence_graph.nodes),
        (_EDGES, timeline.sequence_graph.edges),
    ):
        seen: set[str] = set()
        for i, item in enumerate(items):
            where = pointer(*kind, i, "id")
            if not item.id or any(c.isspace() or c == "/" for c in item.id):
                ctx.add(
                    "ID_MALFORMED",
                    where,
                    item.id,
                    f"{item.id[:80]!r} is not usable as an id.",
                    "Use a name without white space and '/', such as car_drive.",
                )
            if item.id in seen:
                ctx.add(
                    "ID_DUPLICATE",
                    where,
                    item.id,
                    f"The id {item.id!r} is used twice among the {kind[-1]}.",
                    "Give each its own id.",
                )
            seen.add(item.id)


def _start(ctx: Context, timeline: TimelineSystem) -> None:
    nodes = timeline.sequence_graph.nodes
    starts = [i for i, n in enumerate(nodes) if n.event is E.SCENE_START]
    if len(starts) != 1 and ctx.parsed.intact(*_NODES):
        ctx.add(
            "TIMELINE_START",
            pointer(*_NODES, starts[1]) if starts else pointer(*_NODES),
            [nodes[i].id for i in starts],
            f"There are {len(starts)} SceneStart events.",
            "Have exactly one, at timestamp 0.0.",
        )
    for i in starts:
        node = nodes[i]
        if node.timestamp != 0.0 or node.window is not None:
            ctx.add(
                "TIMELINE_START_TIME",
                pointer(*_NODES, i),
                {"timestamp": node.timestamp, "window": node.window},
                f"SceneStart {node.id!r} is not at timestamp 0.0.",
                "Set timestamp to 0.0 and leave out the window.",
            )
    if ctx.parsed.intact("timeline_system") and (len(nodes) <= len(starts) or not timeline.actors):
        ctx.add(
            "TIMELINE_EMPTY",
            pointer("timeline_system"),
            {"nodes": len(nodes), "actors": len(timeline.actors)},
            "The timeline has no actor or no point event after the start.",
            "Say what moves and where it leads, or make the scene static.",
        )


def _order(ctx: Context, timeline: TimelineSystem) -> None:
    """Cycles, reachability from the start, and windows in order along every path."""
    graph = timeline.sequence_graph
    index = {n.id: i for i, n in reversed(list(enumerate(graph.nodes)))}
    edges = [(e.from_, e.to) for e in graph.edges if e.from_ in index and e.to in index]
    cycles = components(list(index), edges)
    for cycle in cycles:
        k = next(k for k, e in enumerate(graph.edges) if e.from_ in cycle and e.to in cycle)
        ctx.add(
            "TIMELINE_CYCLE",
            pointer(*_EDGES, k),
            cycle,
            f"Segments lead from {listing(cycle)} back to where they came from.",
            "Remove or turn round a segment: time runs one way.",
        )
    starts = [n.id for n in graph.nodes if n.event is E.SCENE_START]
    if starts:
        reached = {s for start in starts for s in reachable(start, edges)} | set(starts)
        for i, node in enumerate(graph.nodes):
            if node.id not in reached:
                ctx.add(
                    "TIMELINE_UNREACHABLE",
                    pointer(*_NODES, i),
                    node.id,
                    f"No path of segments leads from the start to {node.id!r}.",
                    "Add the segment whose motion brings it about.",
                )
    if not cycles:
        _windows(ctx, timeline, index, edges)


def _windows(
    ctx: Context, timeline: TimelineSystem, index: dict[str, int], edges: list[tuple[str, str]]
) -> None:
    """Compares every event with the latest time of all that comes before it on a path."""
    graph = timeline.sequence_graph
    before: dict[str, list[str]] = defaultdict(list)
    for a, b in edges:
        before[b].append(a)
    latest: dict[str, tuple[float, str] | None] = {}

    def visit(root: str) -> tuple[float, str] | None:
        stack = [root]
        while stack:
            name = stack[-1]
            todo = [p for p in before[name] if p not in latest]
            if todo:
                stack.extend(todo)
                continue
            stack.pop()
            if name in latest:
                continue
            spans = [v for v in (latest[p] for p in before[name]) if v is not None]
            span = time_span(graph.nodes[index[name]])
            own = [(span[1], name)] if span else []
            latest[name] = max(spans + own, default=None)
        return latest[root]

    for i, node in enumerate(graph.nodes):
        span = time_span(node)
        if span is None or index[node.id] != i:
            continue
        ends = [v for v in (visit(p) for p in dict.fromkeys(before[node.id])) if v is not None]
        last = max(ends, default=None)
        if last is not None and span[0] < last[0] - TIME_EPS_S:
            ctx.add(
                "TIME_ORDER",
                pointer(*_NODES, i, "window" if node.window else "timestamp"),
                list(span),
                f"{node.id!r} can happen at {span[0]:g} s, before {last[1]!r}, which it follows, "
                f"can end ({last[0]:g} s).",
                f"Begin at {last[0]:g} s or later, or let {last[1]!r} end by {span[0]:g} s.",
            )
