"""Stage 3: poses for every node of a resolved document."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from esg.assets.postures import with_room_to_lie
from esg.graph.casting import effective
from esg.graph.models import EsgDocument, Provenance
from esg.layout.clock import Clock
from esg.layout.config import LayoutConfig
from esg.layout.farm import solve_in_processes
from esg.layout.problem.hints import StartHints
from esg.layout.problem.joined import facing_as_one
from esg.layout.search import answer
from esg.layout.steps import solve_steps
from esg.outcomes import UserError

VERSION = "1"


def solve(
    doc: EsgDocument,
    *,
    seed: int = 0,
    hints: StartHints | None = None,
    config: LayoutConfig | None = None,
) -> EsgDocument:
    """Fills `layout_result` with a pose per node.

    Args:
        doc: A resolved document (every node has an asset configuration).
        seed: Seed of the search; equal input gives equal output.
        hints: Planned starts of dynamic scenes.
        config: Search settings.

    Returns:
        The document with `layout_result` and a provenance entry.

    Raises:
        UserError: A node has no asset configuration.
    """
    return solve_batch([doc], [seed], [hints], config=config)[0]


def solve_batch(
    docs: Sequence[EsgDocument],
    seeds: Sequence[int] | None = None,
    hints: Sequence[StartHints | None] | None = None,
    *,
    config: LayoutConfig | None = None,
    clock: Clock | None = None,
) -> list[EsgDocument]:
    """Lays out many scenes together; see `solve`.

    Args:
        docs: Resolved documents.
        seeds: One per document; None takes 0 for all.
        hints: Planned starts per document.
        config: Search settings; with `processes` above 1, processes share what surrounds the
            search, and results stay the same.
        clock: Is told the processor seconds of every stage.

    Returns:
        The documents with their layouts, in order.

    Raises:
        UserError: A node has no asset configuration.
    """
    config = config or LayoutConfig()
    clock = clock or Clock()
    seeds = list(seeds) if seeds is not None else [0] * len(docs)
    plans = list(hints) if hints is not None else [None] * len(docs)
    for doc in docs:
        missing = {n.asset_id for n in doc.spatial_relation_graph.nodes.values()}.difference(
            doc.asset_configurations
        )
        if missing:
            raise UserError(
                f"{doc.scene_definition.scene_id}: no asset configuration for {sorted(missing)}; "
                "resolve the assets before the layout"
            )
    if not docs:
        return []
    played = [facing_as_one(with_room_to_lie(effective(doc))) for doc in docs]
    if config.processes > 1 and len(docs) > 1:
        results = solve_in_processes(played, seeds, plans, config, clock)
    else:
        steps = solve_steps(played, seeds, plans, config, clock)
        reply: Any = None
        try:
            while True:
                request = steps.send(reply)
                clock.start()
                reply = answer([request])[0]
                clock.lap("search")
        except StopIteration as end:
            results = end.value
    settings = config.to_json()
    return [
        doc.model_copy(
            update={
                "layout_result": result,
                "provenance": (
                    *doc.provenance,
                    Provenance(stage="layout", version=VERSION, seed=seed, config=settings),
                ),
            }
        )
        for doc, seed, result in zip(docs, seeds, results, strict=True)
    ]
