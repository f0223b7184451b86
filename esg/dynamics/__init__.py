"""Stage 4: control program, theta, event losses and the search that makes events happen."""

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


def fit_assets(doc: EsgDocument) -> EsgDocument:
    """Assets adapted to what the timeline needs, as far as the prompt leaves them open.

    Part of stage 2 (esg.dynamics.casting.casting).
    """
    from esg.dynamics.casting.casting import fit_assets as run

    return run(doc)


def start_hints(doc: EsgDocument, *, seed: int = 0) -> StartHints:
    """Start constellations of the timeline's participants (esg.dynamics.choreography)."""
    from esg.dynamics.choreography import start_hints as run

    return run(doc, seed=seed)


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
