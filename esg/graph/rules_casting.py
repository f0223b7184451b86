"""Rules on what the stage cast writes: its choices and the choreography name what is there."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from esg.graph.casting import effective
from esg.graph.context import Context
from esg.graph.models import Casting, Choreography, PlannedConstellation
from esg.graph.rules_segments import check_parameters
from esg.graph.rules_stages import check_configuration
from esg.graph.violations import listing, pointer

GROUP = "group:"
"""Prefix by which a choreography names a whole group."""


def check(ctx: Context) -> None:
    """Adds violations of casting and choreography."""
    if ctx.doc.casting is not None:
        _references(ctx, ctx.doc.casting)
        _choices(ctx, ctx.doc.casting)
    if ctx.doc.choreography is not None:
        _choreography(ctx, ctx.doc.choreography)


def _references(ctx: Context, casting: Casting) -> None:
    segments = ctx.parsed.declared_ids("timeline_system", "sequence_graph", "edges")
    for part, names, known, kind in (
        ("assets", casting.assets, ctx.parsed.declared("asset_configurations"), "asset"),
        ("nodes", casting.nodes, ctx.node_names, "node"),
        ("actors", casting.actors, ctx.actor_names, "actor"),
        ("segments", casting.segments, segments, "motion segment"),
    ):
        for name in names:
            _known(ctx, pointer("casting", part, name), name, known, kind)


def _choices(ctx: Context, casting: Casting) -> None:
    """What is chosen is as plausible as what is given has to be."""
    structural = {n.asset_id for n in ctx.nodes.values() if n.is_structural}
    for name, choice in casting.assets.items():
        where = pointer("casting", "assets", name, "configuration")
        check_configuration(ctx, where, name, choice.configuration, structural=name in structural)
    played = effective(ctx.doc).timeline_system
    if played is None:
        return
    events = {n.id: n for n in reversed(played.sequence_graph.nodes)}
    for edge in played.sequence_graph.edges:
        if edge.id in casting.segments:
            where = pointer("casting", "segments", edge.id)
            check_parameters(ctx, played, where, edge, events)


def _choreography(ctx: Context, told: Choreography) -> None:
    if ctx.doc.timeline_system is None and ctx.parsed.intact("timeline_system"):
        ctx.add(
            "STAGE_ORDER",
            "/choreography",
            None,
            "The document has choreography but no timeline_system.",
            "Remove the choreography, or add the timeline that it tells.",
        )
    groups = {GROUP + n.group for n in ctx.nodes.values() if n.group}
    readable = ctx.parsed.intact("spatial_relation_graph", "nodes")
    for i, constellation in enumerate(told.constellations):
        for where, name in _named(constellation):
            if name not in groups and (readable or not name.startswith(GROUP)):
                here = pointer("choreography", "constellations", i) + where
                _known(ctx, here, name, ctx.node_names, "node or group")


def _known(ctx: Context, where: str, name: str, known: Collection[str], kind: str) -> None:
    if name not in known:
        ctx.add(
            "CASTING_UNKNOWN",
            where,
            name,
            f"{name!r} is no {kind} of the document.",
            f"Use one of {listing(known)}, or cast the scene again.",
        )


def _named(constellation: PlannedConstellation) -> Iterator[tuple[str, str]]:
    """Pointers within a constellation and the nodes they name."""
    for k, start in enumerate(constellation.placements):
        yield pointer("placements", k, "node"), start.node
    for k, path in enumerate(constellation.corridors):
        for j, name in enumerate(path.participants):
            yield pointer("corridors", k, "participants", j), name
    if constellation.anchor is not None:
        yield "/anchor", constellation.anchor
