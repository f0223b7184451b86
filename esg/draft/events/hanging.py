"""What hangs on a joint and is let go: it starts drawn back."""

from __future__ import annotations

from esg.draft.discourse.core import entity_of, mark_used
from esg.draft.discourse.jointed import articulation_of
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.tracks import Motion
from esg.draft.events.timing import moved_by_others
from esg.draft.events.told import amount
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import ForceDirection
from esg.lexicon.articulations import Articulation


def row_of(d: Discourse, node: str) -> Articulation | None:
    """How a thing of the scene is jointed."""
    return (
        articulation_of(d.scene, d.text, entity_of(d, node)) if node in d.world.entities else None
    )


def hanging(d: Discourse, bodies: list[str]) -> list[str]:
    """Those that hang and can be drawn back."""
    return [b for b in bodies if (row := row_of(d, b)) is not None and row.drawn is not None]


def let_go(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """What hangs and nothing has moved yet starts drawn back: by a stated angle or a usual one."""
    angle = amount(d, f, "angle")
    for body in bodies:
        row = row_of(d, body)
        if row is None or moved_by_others(d, body) or body in d.timeline.tracks:
            continue
        d.scene.openings[body] = (row.drawn or 0.0) if angle is None else angle.high
        if angle is not None:
            mark_used(d, angle, "where it is let go")
        d.timeline.move(body, Motion("release"), ForceDirection.ANY_3D)
