"""The choreography in the document: told once, when the scene is cast, and read from then on."""

from __future__ import annotations

from esg.dynamics.choreography.telling import Choreography, choreograph
from esg.graph import effective, models
from esg.graph.models import EsgDocument
from esg.layout.problem.hints import stored_hints


def record(doc: EsgDocument, *, seed: int = 0) -> models.Choreography:
    """Tells the story of an effective document, as the document keeps it.

    Args:
        doc: A document with assets, its casting applied.
        seed: Of the choreography.
    """
    told = choreograph(doc, seed=seed)
    return models.Choreography.model_validate(
        {
            "constellations": told.hints.constellations,
            "nominal": dict(sorted(told.nominal.items())),
        },
        from_attributes=True,
    )


def choreography_of(doc: EsgDocument, *, seed: int = 0) -> Choreography:
    """The choreography that a document holds; told with `seed` where it holds none.

    Nothing in it depends on the layout: it is the same before and after.
    """
    if doc.choreography is None:
        return choreograph(effective(doc), seed=seed)
    return Choreography(stored_hints(doc.choreography), dict(doc.choreography.nominal))
