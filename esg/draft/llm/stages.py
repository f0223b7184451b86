"""What the model is asked to answer in each stage: small flat shapes, not the document itself.

A reply is read tolerantly (code fences, text around the object, synonyms of the allowed words) and
then validated; what does not fit is said back to the model in words.
"""

from __future__ import annotations

import json
import re
from typing import Any, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from esg.graph.models import (
    Direction,
    EdgeEvent,
    Filming,
    ForceDirection,
    MultiRelationType,
    NodeEvent,
    Predicate,
    RegionType,
    RelationType,
    Role,
    Side,
)
from esg.untyped import is_list, is_object


class Part(BaseModel):
    """Base of all replies; unknown fields are ignored, numbers may be written as text."""

    model_config = ConfigDict(extra="ignore", allow_inf_nan=False, frozen=True)


class ExpansionReply(Part):
    """The scene in full."""

    expanded_description: str
    is_dynamic: bool
    scene_type: Literal["indoor", "outdoor"]
    environment: str = Field("generic", description="one or two words, such as street")
    allow_supplementary: bool = Field(
        True, description="false when the prompt forbids further objects"
    )


class AssetPart(Part):
    asset_id: str
    category: str
    description: str
    length_cm: float = Field(description="along its front")
    width_cm: float
    height_cm: float
    mass_kg: float
    movable: bool = True
    mass_is_prescribed: bool = Field(False, description="the prompt states the mass")
    size_is_prescribed: bool = False
    material: str | None = None
    color: str | None = None
    shape: Literal["sphere", "box", "cylinder", "capsule", "compound"] | None = None


class ObjectPart(Part):
    name: str = Field(description="logical name such as car_1")
    asset_id: str
    label: str = Field("", description="how the prompt names it")
    mentioned: bool = Field(True, description="false for objects that you added")
    structural: bool = Field(False, description="ground, road, floor, wall, ceiling")
    count: int = Field(1, ge=1, le=60, description="more than 1 for a group of equal objects")
    pattern: Literal["pins", "rack", "row", "column", "stack", "queue", "scatter"] | None = None


class AssetsReply(Part):
    """Assets and the objects made of them."""

    assets: list[AssetPart]
    objects: list[ObjectPart]


class RegionPart(Part):
    name: str
    type: RegionType
    parent: str = Field(description="name of the object that offers it")
    description: str = ""


class PlacementPart(Part):
    object: str
    region: str


class RelationPart(Part):
    subject: str
    relation: RelationType
    object: str
    confidence: float = 1.0
    description: str = ""
    distance_low_cm: float | None = None
    distance_high_cm: float | None = None
    direction: Literal["+X", "-X", "+Y", "-Y"] | None = Field(
        None, description="only for face towards a direction; the object is then the ground"
    )


class GroupRelationPart(Part):
    relation: MultiRelationType
    subjects: list[str]
    targets: list[str] = []
    confidence: float = 1.0
    description: str = ""


StatedQuantity = Literal["speed", "deceleration", "distance", "height", "length", "width", "angle"]


class StatementPart(Part):
    says: Predicate
    words: str = Field(description="exact words of the description")
    object: list[str] = []
    target: list[str] = []
    direction: Direction | None = None
    side: Side | None = None
    filming: Filming | None = None
    quantity: StatedQuantity | None = None
    low: float | None = None
    high: float | None = None
    noun: str | None = None
    when: str = Field("throughout", description="start, end, throughout, an event id, or from..to")
    missing: str | None = Field(None, description="not_represented: what the scene lacks")


class SpatialReply(Part):
    """Where things are: relations, and regions where relations do not tell them."""

    regions: list[RegionPart] = []
    placements: list[PlacementPart] = []
    relations: list[RelationPart] = []
    group_relations: list[GroupRelationPart] = []
    statements: list[StatementPart] = Field([], description="only of a scene that is not dynamic")


class SceneReply(Part):
    """The first request: everything but the timeline."""

    expansion: ExpansionReply
    assets: AssetsReply
    spatial: SpatialReply


class ActorPart(Part):
    object: str
    role: Role
    force_direction: ForceDirection | None = None


class ConstraintPart(Part):
    quantity: Literal[
        "speed_after", "speed_before", "time_since", "time_to_stop", "distance", "height", "angle"
    ]
    object: str
    low: float
    high: float
    since: str | None = None
    to: str | None = None


class EventPart(Part):
    id: str
    event: NodeEvent
    participants: list[str]
    earliest_s: float | None = Field(None, description="left out: in the order of the segments")
    latest_s: float | None = None
    time_is_prescribed: bool = False
    constraints: list[ConstraintPart] = []
    position_cm: list[float] | None = Field(None, min_length=3, max_length=3)
    region: str | None = Field(None, description="EnterRegion: object/region name")
    turn_direction: Literal["left", "right"] | None = None
    turn_degrees: float | None = None
    times: int | None = None
    description: str = ""


ParameterName = Literal[
    "speed",
    "acceleration",
    "damping",
    "heading_deg",
    "elevation_deg",
    "turn_rate_deg_s",
    "duration",
    "lift_cm",
    "clearance_cm",
    "height_cm",
    "opening",
]


class ParameterPart(Part):
    name: ParameterName
    low: float
    high: float


class SegmentPart(Part):
    id: str
    start: str = Field(description="id of the event it begins at")
    end: str = Field(description="id of the event it leads to")
    motion: EdgeEvent
    actor: str
    target: str | None = None
    parameters: list[ParameterPart] = []
    speed_is_prescribed: bool = False
    turn_direction: Literal["left", "right"] | None = None
    turn_degrees: float | None = None
    spin: Literal["roll", "slide", "none"] | None = None
    backward: bool = False
    holds_on: bool = Field(False, description="Guide: does not let go at its end")


class TimelineReply(Part):
    """Actors, point events, the motions between them, and what else is stated."""

    actors: list[ActorPart]
    events: list[EventPart]
    segments: list[SegmentPart]
    statements: list[StatementPart] = []


class WholeReply(Part):
    """Everything at once, for the single-shot variant."""

    expansion: ExpansionReply
    assets: AssetsReply
    spatial: SpatialReply
    timeline: TimelineReply | None = None


class SeenRelation(Part):
    subject: str
    relation: RelationType
    object: str
    confidence: float = Field(0.3, ge=0.0, le=1.0)


class SeenPlace(Part):
    object: str
    anchor: Literal["center", "left", "right", "front", "back", "boundary", "none"]
    confidence: float = Field(0.3, ge=0.0, le=1.0)


class VisualReply(Part):
    """What a reference image suggests."""

    relations: list[SeenRelation] = []
    places: list[SeenPlace] = []


REPLIES: dict[str, type[Part]] = {
    "scene": SceneReply,
    "timeline": TimelineReply,
    "single_shot": WholeReply,
    "visual": VisualReply,
}

_SYNONYMS: dict[str, dict[str, str]] = {
    "relation": {
        "next_to": "near",
        "beside": "near",
        "close_to": "near",
        "by": "near",
        "touching": "adjacent",
        "against": "adjacent",
        "on_top_of": "on",
        "standing_on": "on",
        "in": "inside_of",
        "inside": "inside_of",
        "within": "inside_of",
        "below": "under",
        "underneath": "under",
        "beneath": "under",
        "over": "above",
        "facing": "face",
        "faces": "face",
        "front_of": "in_front_of",
        "ahead_of": "in_front_of",
        "left": "left_of",
        "right": "right_of",
        "surrounded_by": "surround",
        "around": "surround",
        "aligned": "align",
        "scatter": "scatter_by",
        "center": "center_of",
    },
    "event": {
        "start": "SceneStart",
        "hit": "Collision",
        "collide": "Collision",
        "enter": "EnterRegion",
        "enters": "EnterRegion",
        "halt": "Stop",
        "turn": "HeadingReached",
        "fallover": "Topple",
        "drop": "Fall",
    },
    "motion": {
        "uniform": "UniformMotion",
        "move": "UniformMotion",
        "accelerate": "AcceleratedMotion",
        "accelerated": "AcceleratedMotion",
        "braking": "Brake",
        "throw": "Toward",
        "launch": "Toward",
        "inertial": "InertialConnector",
    },
    "type": {"surface": "SUPPORT_SURFACE", "container": "STORAGE"},
}
_CHOICES: dict[str, tuple[str, ...]] = {
    "relation": (*(r.value for r in RelationType), *(r.value for r in MultiRelationType)),
    "event": tuple(e.value for e in NodeEvent),
    "motion": tuple(e.value for e in EdgeEvent),
    "type": tuple(r.value for r in RegionType),
    "role": tuple(r.value for r in Role),
    "force_direction": tuple(f.value for f in ForceDirection),
    "scene_type": ("indoor", "outdoor"),
    "says": tuple(p.value for p in Predicate),
}

ReplyT = TypeVar("ReplyT", bound=Part)


class UnreadableReply(Exception):
    """A reply that does not fit its shape; the message is for the model."""


def read_reply(text: str, shape: type[ReplyT], *, cut_off: bool = False) -> ReplyT:
    """The reply as an object.

    Raises:
        UnreadableReply: Saying what does not fit.
    """
    tree = find_object(text)
    if tree is None:
        reason = "it was cut off; be briefer" if cut_off else "it holds no complete JSON object"
        raise UnreadableReply(f"Your reply cannot be read: {reason}.")
    try:
        return shape.model_validate(_words(tree))
    except ValidationError as error:
        problems = [
            f"- /{'/'.join(str(p) for p in e['loc'])}: {e['msg']}"
            for e in error.errors(include_url=False, include_input=False)[:20]
        ]
        raise UnreadableReply("Your reply does not fit:\n" + "\n".join(problems)) from None


def find_object(text: str) -> dict[str, Any] | None:
    """The first complete JSON object in a text that may hold more."""
    decoder = json.JSONDecoder()
    position = text.find("{")
    for _ in range(20):
        if position < 0:
            return None
        try:
            tree, _end = decoder.raw_decode(text, position)
        except json.JSONDecodeError as error:
            if error.pos >= len(text.rstrip()) or "Unterminated" in error.msg:
                return None  # Cut off: an inner object must not pass for the whole.
            position = text.find("{", position + 1)
            continue
        except (ValueError, RecursionError):
            return None
        return tree if is_object(tree) else None
    return None


def _words(tree: Any, key: str = "") -> Any:
    """The tree with synonyms of allowed words replaced."""
    if is_object(tree):
        return {k: _words(v, k) for k, v in tree.items()}
    if is_list(tree):
        return [_words(v) for v in tree]
    if isinstance(tree, str) and key in _CHOICES:
        word = re.sub(r"[^a-z0-9]+", "_", tree.strip().lower()).strip("_")
        for choice in _CHOICES[key]:
            if word.replace("_", "") == choice.lower().replace("_", ""):
                return choice
        return _SYNONYMS.get(key, {}).get(word, tree)
    return tree
