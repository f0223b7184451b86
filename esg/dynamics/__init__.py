"""Stages cast and optimize: the bodies of a story, and the search that makes its events happen."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from esg.engines.scene import SimScene
    from esg.graph.models import EsgDocument
    from esg.layout.problem.hints import StartHints


def build_scene(doc: EsgDocument) -> SimScene:
    """The physical scene of a laid-out document, in SI (esg.dynamics.plan.build)."""
    from esg.dynamics.plan import build_scene as run

    return run(doc)


def cast(doc: EsgDocument, *, seed: int = 0) -> EsgDocument:
    """Fills `casting` and `choreography`: bodies that the timeline needs (esg.dynamics.casting)."""
    from esg.dynamics.casting import cast as run

    return run(doc, seed=seed)


def start_hints(doc: EsgDocument, *, seed: int = 0) -> StartHints:
    """Start constellations of the timeline's participants; told with `seed` if not cast yet."""
    from esg.dynamics.choreography import choreography_of

    return choreography_of(doc, seed=seed).hints


def optimize(
    doc: EsgDocument,
    *,
    seed: int = 0,
    strategy: str = "batched",
    device: str = "cpu",
    rounds_closed: int = 0,
    collision: str = "exact",
) -> EsgDocument:
    """Fills `dynamics_result` (esg.dynamics.strategies)."""
    from esg.dynamics.strategies import optimize as run

    return run(
        doc,
        seed=seed,
        strategy=strategy,
        device=device,
        rounds_closed=rounds_closed,
        collision=collision,
    )
