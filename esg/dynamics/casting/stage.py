"""Stage cast: which of several plausible bodies an action needs, and the story told with them.

A prompt that has a football knock over a crate means a crate that a football can knock over. Where
the prompt leaves a mass open, the lightest plausible body is still that kind of thing (an empty
crate); where an event sets a thing in motion, it is not screwed to the floor. What was chosen is
written beside what draft and resolve wrote, each with its reason; nothing of theirs is touched.
"""

from __future__ import annotations

from collections.abc import Mapping
import enum
from typing import Any

from esg.dynamics.casting.changes import with_assets
from esg.dynamics.casting.roads import fit_roads
from esg.dynamics.casting.rules import RULES, STANDING
from esg.dynamics.choreography.telling import record
from esg.dynamics.story.story import read_story
from esg.graph.models import AssetConfiguration, Casting, Choreography, EsgDocument, Provenance

VERSION = "1"
Reasons = dict[tuple[str, str], tuple[str, ...]]
"""Why something was chosen, by part of `Casting` and name."""

_FIELDS = {
    "assets": "configuration",
    "nodes": "is_static",
    "actors": "force_direction",
    "segments": "params",
}
"""What is chosen of every part of a casting."""
_TOLD = ("category", "dimensions_cm", "mass_kg", "friction", "restitution", "is_movable")
"""Fields of a configuration whose change a reason tells; all others are its shape."""


def cast(doc: EsgDocument, *, seed: int = 0) -> EsgDocument:
    """Fills `casting` and `choreography`.

    Args:
        doc: A document with assets resolved. What was cast before is cast anew.
        seed: Of the choreography: varies approach distances, lateral offsets and times.

    Returns:
        The document; without a timeline, and with nothing to choose, as it was.
    """
    given = doc.model_copy(
        update={
            "casting": None,
            "choreography": None,
            "provenance": tuple(p for p in doc.provenance if p.stage != "cast"),
        }
    )
    played, reasons = _choose(given)
    told: Choreography | None = None
    if given.timeline_system is not None:
        told = record(played, seed=seed)
        played = _on_roads(played, told, reasons)
    casting = _casting(given, played, reasons)
    if casting is None and told is None:
        return given
    provenance = (*given.provenance, Provenance(stage="cast", version=VERSION, seed=seed))
    return given.model_copy(
        update={"casting": casting, "choreography": told, "provenance": provenance}
    )


def fitted(doc: EsgDocument) -> EsgDocument:
    """The effective document of a resolved one: every choice made, none told apart."""
    return _choose(doc)[0]


def _choose(doc: EsgDocument) -> tuple[EsgDocument, Reasons]:
    """Applies the rules one after the other; each sees what the ones before it chose."""
    story = read_story(doc)
    reasons: Reasons = {}
    for rule in RULES if doc.timeline_system is not None else STANDING:
        before, doc = doc, rule.choose(doc, story)
        for place, what in _changes(before, doc).items():
            reasons[place] = (*reasons.get(place, ()), f"{what}: {rule.why}")
        if doc.timeline_system is not before.timeline_system:
            story = read_story(doc)
    return doc, reasons


def _casting(given: EsgDocument, played: EsgDocument, reasons: Reasons) -> Casting | None:
    """What differs between two documents as choices; None if nothing does."""
    before, after = _parts(given), _parts(played)
    chosen = {
        part: {
            name: {_FIELDS[part]: value, "reasons": reasons[part, name]}
            for name, value in values.items()
            if value != before[part][name]
        }
        for part, values in after.items()
    }
    return Casting.model_validate(chosen) if any(chosen.values()) else None


def _parts(doc: EsgDocument) -> dict[str, Mapping[str, Any]]:
    """What casting may choose, by part and name."""
    timeline = doc.timeline_system
    nodes = doc.spatial_relation_graph.nodes
    actors = {} if timeline is None else timeline.actors
    edges = () if timeline is None else timeline.sequence_graph.edges
    return {
        "assets": doc.asset_configurations,
        "nodes": {name: node.is_static for name, node in nodes.items()},
        "actors": {name: actor.force_direction for name, actor in actors.items()},
        "segments": {edge.id: edge.params for edge in edges},
    }


def _on_roads(played: EsgDocument, told: Choreography, reasons: Reasons) -> EsgDocument:
    """The document with its street and ground as long as what was told needs."""
    longer = with_assets(played, fit_roads(played, told))
    for place, what in _changes(played, longer).items():
        reasons[place] = (*reasons.get(place, ()), f"{what}: it is longer than the way")
    return longer


def _changes(before: EsgDocument, after: EsgDocument) -> dict[tuple[str, str], str]:
    """What one rule changed, in words, by part and name."""
    if after is before:
        return {}
    old, new = _parts(before), _parts(after)
    return {
        (part, name): _told(part, old[part][name], value)
        for part, values in new.items()
        for name, value in values.items()
        if value is not old[part][name] and value != old[part][name]
    }


def _told(part: str, old: Any, new: Any) -> str:
    """A change in words, such as `mass_kg 12 -> 3.6`."""
    if isinstance(old, AssetConfiguration):
        pairs = [(f, getattr(old, f), getattr(new, f)) for f in _TOLD]
        texts = [f"{f} {_shown(a)} -> {_shown(b)}" for f, a, b in pairs if a != b]
        return ", ".join(texts) or "shape"
    if part == "segments":
        return "speed and elevation opened"
    return f"{_FIELDS[part]} {_shown(old)} -> {_shown(new)}"


def _shown(value: Any) -> str:
    if isinstance(value, tuple):
        return " x ".join(map(_shown, value))
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, enum.Enum):
        return str(value.value)
    return str(value).lower() if isinstance(value, bool) else str(value)
