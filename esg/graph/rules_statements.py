"""Rules on statements: what they are said of exists, and says enough to be measured."""

from __future__ import annotations

from esg.graph.context import Context
from esg.graph.models import Predicate, Statement
from esg.graph.violations import listing, pointer
from esg.lexicon.gestures import gestures
from esg.lexicon.lying import poses
from esg.lexicon.parts import PARTS
from esg.lexicon.plumes import plumes
from esg.lexicon.postures import postures

_MOMENTS = ("start", "end", "throughout")
_OF_EVENTS = (Predicate.SAME_TIME, Predicate.BEFORE)
_OF_NOUNS = (Predicate.ABSENT, Predicate.COUNT, Predicate.WEATHER)
_NAMING = (
    Predicate.FILLED_WITH,
    Predicate.WEARS,
    Predicate.LOOKS,
    Predicate.LIT,
    Predicate.LIES,
    Predicate.POSTURE,
    Predicate.GESTURES,
    Predicate.GIVES_OFF,
    Predicate.AT_PART,
)
"""Said of an object by a word: what it is filled with, what somebody wears, his posture."""
_OF_NOTHING = (*_OF_NOUNS, Predicate.FILMED, Predicate.NOT_REPRESENTED)
"""Said of the scene as a whole, or of what else they name."""
_WITH_TARGET = frozenset(
    {
        Predicate.SUPPORTED_BY,
        Predicate.INSIDE,
        Predicate.ABOVE,
        Predicate.UNDER,
        Predicate.LEFT_OF,
        Predicate.RIGHT_OF,
        Predicate.IN_FRONT_OF,
        Predicate.BEHIND,
        Predicate.HANGS_FROM,
        Predicate.ATTACHED_TO,
        Predicate.LEANS_ON,
        Predicate.CARRIED_BY,
        Predicate.TOUCHES,
        Predicate.NEVER_TOUCHES,
        Predicate.STRUCK_ON,
        Predicate.ENDS_ON,
        Predicate.ENDS_IN,
        Predicate.ENDS_NEAR,
        Predicate.AT_PART,
        Predicate.FLOATS,
        Predicate.SINKS,
        Predicate.CLIMBS,
        Predicate.FACES,
    }
)
_TARGETED_DIRECTIONS = frozenset(
    {"toward", "away_from", "along", "past", "across", "through", "around", "between"}
)
"""Directions that are of something."""


def check(ctx: Context) -> None:
    """Adds violations of statements."""
    seen: set[str] = set()
    for i, statement in enumerate(ctx.doc.statements or ()):
        here = pointer("statements", i)
        if statement.id in seen:
            ctx.add(
                "STATEMENT_TWICE",
                here + "/id",
                statement.id,
                f"{statement.id!r} is the id of an earlier statement.",
                "Give every statement its own id.",
            )
        seen.add(statement.id)
        _participants(ctx, here, statement)
        _needs(ctx, here, statement)
        _when(ctx, here, statement)


def _participants(ctx: Context, here: str, statement: Statement) -> None:
    known = ctx.event_names if statement.predicate in _OF_EVENTS else ctx.node_names
    kind = "event" if statement.predicate in _OF_EVENTS else "node"
    for part in ("object", "target"):
        for name in getattr(statement, part):
            if name not in known:
                ctx.add(
                    "STATEMENT_UNKNOWN",
                    f"{here}/{part}",
                    name,
                    f"{name!r} is no {kind} of the document.",
                    f"Use one of {listing(known)}.",
                )


def _needs(ctx: Context, here: str, statement: Statement) -> None:
    """What a predicate cannot be measured without."""
    says = statement.predicate
    needed: dict[str, bool] = {
        "noun": says in (*_OF_NOUNS, *_NAMING),
        "object": says not in _OF_NOTHING,
        "target": says in _WITH_TARGET or statement.direction in _TARGETED_DIRECTIONS,
        "direction": says in (Predicate.MOVES, Predicate.CLIMBS),
        "side": says is Predicate.STRUCK_ON,
        "filming": says is Predicate.FILMED,
        "value": says in (Predicate.SLOWER_THAN, Predicate.FASTER_THAN, Predicate.COUNT),
        "note": says is Predicate.NOT_REPRESENTED,
    }
    for name, wanted in needed.items():
        if wanted and not getattr(statement, name) and getattr(statement, name) != 0:
            ctx.add(
                "STATEMENT_INCOMPLETE",
                f"{here}/{name}",
                None,
                f"A statement of {says.value!r} says nothing without its {name}.",
                f"Give its {name}, or leave the statement out.",
            )
    tables = {
        Predicate.LIES: [*poses()],
        Predicate.POSTURE: [r.posture for r in postures()],
        Predicate.GESTURES: [name for name, _ in gestures()],
        Predicate.GIVES_OFF: [*plumes()],
        Predicate.AT_PART: [*PARTS],
    }
    known = dict.fromkeys(tables.get(says, ()))
    named = says in tables and statement.noun
    if named and statement.noun not in known:
        ctx.add(
            "STATEMENT_UNKNOWN",
            f"{here}/noun",
            statement.noun,
            f"{statement.noun!r} is no {says.value.removesuffix('s')}.",
            f"Use one of {listing(known)}.",
        )
    if says in _OF_EVENTS and len(statement.object) != 2:
        ctx.add(
            "STATEMENT_INCOMPLETE",
            f"{here}/object",
            list(statement.object),
            f"A statement of {says.value!r} is about two events.",
            "Name two point events.",
        )


def _when(ctx: Context, here: str, statement: Statement) -> None:
    known = (*_MOMENTS, *ctx.event_names)
    for moment in statement.when.split(".."):
        if moment not in known:
            ctx.add(
                "STATEMENT_UNKNOWN",
                f"{here}/when",
                statement.when,
                f"{moment!r} is neither a moment nor an event of the timeline.",
                f"Use one of {listing(known)}, or two of them as from..to.",
            )
