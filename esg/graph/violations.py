"""What the verifier can find: one stable code a rule, with its meaning and its remedy.

The table in docs/graph/codes.md is tested against `RULES`. Codes are part of the public contract:
they are never renamed or reused; a rule that goes away leaves its code unused.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from esg.untyped import is_array, is_object

MAX_VALUE_CHARS = 200


@dataclass(frozen=True)
class Violation:
    """One broken rule at one place of a document.

    Args:
        code: Stable code, a key of `RULES`.
        pointer: JSON pointer (RFC 6901) of the offending field; "" is the document itself.
        value: The offending value, as plain JSON.
        remedy: What would satisfy the rule.
        message: What is wrong, as one sentence.
    """

    code: str
    pointer: str
    value: Any
    remedy: str
    message: str

    def to_json(self) -> dict[str, Any]:
        """Plain JSON of the violation."""
        return {
            "code": self.code,
            "pointer": self.pointer,
            "value": self.value,
            "remedy": self.remedy,
            "message": self.message,
        }

    def __str__(self) -> str:
        return f"{self.code} at {self.pointer or '/'}: {self.message} {self.remedy}"


def pointer(*parts: str | int) -> str:
    """JSON pointer of a path of keys and indices (RFC 6901 escapes)."""
    return "".join("/" + str(p).replace("~", "~0").replace("/", "~1") for p in parts)


def clip(value: Any) -> Any:
    """The value, shortened where it would drown a message: long texts, lists and objects."""
    if isinstance(value, str) and len(value) > MAX_VALUE_CHARS:
        return value[:MAX_VALUE_CHARS] + f"… ({len(value)} characters)"
    if is_array(value):
        items = [clip(v) for v in value[:20]]
        return items if len(value) <= 20 else [*items, f"… ({len(value)} items)"]
    if is_object(value):
        keys = list(value)[:20]
        shown = {str(k): clip(value[k]) for k in keys}
        return shown if len(value) <= 20 else {**shown, "…": f"({len(value)} keys)"}
    return value


RULES: dict[str, str] = {
    # Files and JSON.
    "FILE_UNREADABLE": "The file exists, is a regular file and can be read.",
    "FILE_TOO_LARGE": "The file is at most 64 MiB.",
    "DOCUMENT_TOO_LARGE": "A document has at most 200,000 values and 1,000 nodes.",
    "FILE_NOT_TEXT": "The file is UTF-8 text.",
    "FILE_NOT_JSON": "The file is one complete JSON value.",
    "FILE_NOT_OBJECT": "The JSON value is an object.",
    "JSON_DUPLICATE_KEY": "No key occurs twice in one JSON object.",
    "JSON_NOT_FINITE": "Every number is finite.",
    "JSON_NUMBER_RANGE": "Every number is smaller than 10^18.",
    # Schema.
    "SCHEMA_VERSION": "`schema_version` is a version this software knows.",
    "SCHEMA_MISSING": "Every required field is present.",
    "SCHEMA_UNKNOWN_FIELD": "No field is unknown.",
    "SCHEMA_TYPE": "Every field has its type.",
    "SCHEMA_VALUE": "Every choice is one of the allowed values.",
    # Names.
    "ID_MALFORMED": "Names are non-empty, without white space, '/' and ':'.",
    "ID_DUPLICATE": "Point events and segments have unique ids.",
    # Scene and assets.
    "SCENE_ID_MALFORMED": "`scene_id` can be a folder name.",
    "SCENE_EMPTY": "A scene has objects.",
    "SCENE_NO_BASE": "A scene has a structural base (ground, floor, road).",
    "SCENE_TWO_BASES": "Not more than one structural node is the ground or floor.",
    "ASSET_UNUSED": "Every asset requirement is used by a node.",
    "INTERVAL_REVERSED": "The lower bound of an interval is not above the upper.",
    "UNIT_SIZE": "Sizes lie in 0.1 cm to 100 m (structural parts to 1 km).",
    "UNIT_MASS": "Masses lie in 1 g to 100 t (immovable things: not negative).",
    "UNIT_DENSITY": "Mass over bounding box lies in 1 to 25,000 kg/m^3.",
    "UNIT_DAMPING": "Damping lies in 0 to 100 1/s.",
    # References.
    "REF_ASSET": "A node's asset is required.",
    "REF_REGION": "A node's region is defined.",
    "REF_REGION_PARENT": "A region's parent is a node.",
    "REF_RELATION": "Both ends of a relation are nodes.",
    "REF_GROUP": "Subjects and targets of a multi relation are nodes.",
    "REF_ACTOR": "An actor is a node.",
    "REF_PARTICIPANT": "A participant of a point event is a node.",
    "REF_EVENT": "Ends of a segment and `since` are point events.",
    "REF_EDGE_ACTOR": "A segment's actor is an actor.",
    "REF_EDGE_TARGET": "A segment's target is a node.",
    "REF_CONSTRAINT": "A constraint's object is a node.",
    "REF_NAMED_REGION": "`region` of EnterRegion names a node and a region of its asset.",
    # Regions.
    "REGION_MISSING": "A regular object belongs to exactly one region.",
    "REGION_CYCLE": "Regions and parents form no cycle.",
    "REGION_CONFLICT": "What an object stands on or in agrees with its region.",
    "GROUP_PATTERN": "A group pattern belongs to a group and is one per group.",
    # Relations.
    "RELATION_SELF": "Nothing is related to itself.",
    "RELATION_DUPLICATE": "No relation is stated twice.",
    "RELATION_CONTRADICTION": "Two relations of one pair can hold together.",
    "RELATION_CYCLE": "Directional, vertical and support relations form no cycle.",
    "RELATION_TWO_SUPPORTS": "An object stands on or in one object.",
    "RELATION_STRUCTURAL": "A structural part does not stand on or in a regular object.",
    "RELATION_TOO_SMALL": "What is inside fits into what holds it.",
    "RELATION_CONFIDENCE": "Confidence lies in 0 to 1.",
    "RELATION_DISTANCE": "Distances are not negative and within the world.",
    "RELATION_CARDINAL": "Only `face` towards a structural base has a cardinal.",
    "RELATION_ARITY": "A multi relation has as many subjects and targets as its type needs.",
    "FACE_DUPLICATE": "An object faces one way.",
    "FACE_MISSING": "A mentioned object with a long and a short side faces some way.",
    # Actors.
    "ACTOR_FORCE_MISSING": "An active actor has a force direction.",
    "ACTOR_FORCE_FORBIDDEN": "A passive actor has no force direction.",
    "ACTOR_IMMOVABLE": "An active actor can move; structure is no actor.",
    "ACTOR_IDLE": "An active actor has a segment.",
    # Timeline as a whole.
    "TIMELINE_MISSING": "A dynamic scene has a timeline.",
    "TIMELINE_UNEXPECTED": "A static scene has no timeline.",
    "TIMELINE_EMPTY": "A timeline has a point event after the start, and an actor.",
    "TIMELINE_START": "There is exactly one SceneStart.",
    "TIMELINE_START_TIME": "SceneStart is at timestamp 0.0.",
    "TIMELINE_CYCLE": "Segments form no cycle.",
    "TIMELINE_UNREACHABLE": "Every point event is reachable from the start.",
    "TIME_MISSING": "A point event has a timestamp or a window.",
    "TIME_BOTH": "A point event has not both a timestamp and a window.",
    "TIME_RANGE": "Times lie in 0 to 600 s.",
    "TIME_ORDER": "A point event does not begin before the one it follows can end.",
    # Point events.
    "EVENT_PARTICIPANTS": "A point event has as many different participants as its type needs.",
    "EVENT_NO_ACTOR": "Some participant of a point event is an actor.",
    "EVENT_MOVER": "The first participant of a collision is the one that a segment leads there.",
    "EVENT_FIELD_MISSING": "A point event has the fields its type needs.",
    "EVENT_FIELD_FORBIDDEN": "A point event has no field of another type.",
    "EVENT_RANGE": "Positions lie in the world, turns in 0 to 720 degrees.",
    "TRIGGER_PASSIVE": "Triggers belong to active actors.",
    "CONSTRAINT_OBJECT": "A constraint's object takes part in its event.",
    "CONSTRAINT_SINCE": "`time_since` names an event that does not come later.",
    "CONSTRAINT_RANGE": "A constraint's value is plausible.",
    "CONSTRAINT_CONTRADICTION": "Constraints can hold together, and within the windows.",
    # Segments.
    "EDGE_ACTOR_PASSIVE": "Only active actors move under their own power or are launched.",
    "EDGE_ACTOR_ABSENT": "A segment's actor takes part in the event the segment leads to.",
    "EDGE_TARGET_SELF": "A segment's target is not its actor.",
    "EDGE_PARAM_MISSING": "A segment has the parameters its type needs.",
    "EDGE_PARAM_FORBIDDEN": "A segment has no parameter of another type.",
    "EDGE_PARAM_RANGE": "A segment's parameters are plausible.",
    "UNIT_SPEED": "Speeds lie in 0 to 150 m/s; an open interval reaches 0.2 m/s.",
    "GUIDE_END": "A Guide ends where something is picked up, placed, let go or in a region.",
    "EVENT_NO_JOINT": "Open, Close and Swing are of what a joint holds, or of what jointed parts "
    "hang on.",
    "EVENT_UNBROKEN": "Break is of what the document says breaks.",
    "EDGE_NO_JOINT": "Drive moves the child of a hinge or slider, Release lets go the child of a "
    "joint that draws it back: a hinge, ball joint, rope, spring or sprung slider.",
    "EVENT_NOT_LED_TO": "A Guide leads to PickedUp and Placed, a Toward to a Jump.",
    "EDGE_FORCE_DIRECTION": "A segment agrees with its actor's force direction.",
    "CONNECTOR_ACTIVE": "Inertial connectors belong to passive actors.",
    "CONNECTOR_UPSTREAM": "A connector's body, support or plural was hit, or its support opened.",
    "CONNECTOR_DOWNSTREAM": "An inertial connector leads to a further event of its body.",
    # Later stages.
    "STAGE_ORDER": "No stage's result is present without the stage before it.",
    "CONFIG_MISSING": "Every asset requirement has a configuration.",
    "CONFIG_UNKNOWN": "Every configuration belongs to a requirement.",
    "CONFIG_MASS": "A prescribed mass is kept.",
    "CONFIG_MATERIAL": "Friction lies in 0 to 2, restitution in 0 to 1.",
    "CONFIG_GEOMETRY": "Proxies, scales, regions and surfaces have positive sizes.",
    "CONFIG_NO_PROXY": "A movable asset has a collision proxy.",
    "CONFIG_PATH": "Mesh paths are relative and stay inside the scene folder.",
    "STATEMENT_TWICE": "Every statement has its own id.",
    "STATEMENT_UNKNOWN": "Statements name only what the document has.",
    "STATEMENT_INCOMPLETE": "A statement says what its predicate needs to be measured.",
    "JOINT_TWICE": "Every joint has its own id.",
    "JOINT_UNKNOWN": "A joint connects nodes, or a node and the world.",
    "JOINT_CHILD": "The child of a joint can move and is not its parent.",
    "JOINT_CIRCLE": "Joints place nodes one after the other, never in a circle.",
    "JOINT_FIELD": "A joint has what its kind needs and nothing that it does not know.",
    "JOINT_VALUE": "What a joint resists with is not negative.",
    "JOINT_POSITION": "A joint starts within its limits.",
    "JOINT_MOUNT": "The mounts of a joint are those of its assets.",
    "BREAK_SPEED": "What breaks does so at a plausible blow.",
    "BREAK_PIECES": "What breaks has 2 to 64 pieces.",
    "BREAK_HELD": "What breaks is neither joined nor structure.",
    "CASTING_UNKNOWN": "Casting and choreography name only what the document has.",
    "QUATERNION": "Quaternions have unit length.",
    "POSE_MISSING": "Every node has a pose.",
    "POSE_UNKNOWN": "Every pose belongs to a node.",
    "POSE_RANGE": "Poses lie in the world.",
    "PARAMETER_RANGE": "A parameter lies within its bounds.",
    "PROGRAM_INVALID": "The control program can be read.",
    "PROGRAM_BODY": "Bodies of the control program are nodes.",
    "OUTCOME_UNKNOWN": "The outcome is one of the known outcomes.",
    "DRESSING_UNASKED": "A scene that allows no other objects has no dressing.",
    "DRESSING_UNKNOWN": "A dressing names only what the tables of places have.",
    "DRESSING_TWICE": "Every thing of a dressing has its own id.",
    "DRESSING_RANGE": "At most 500 things and markings have sizes of 1 mm to 1 km, within 2 km.",
    "DRESSING_NEAR": "Nothing of a dressing stands within 2 m of where a body starts.",
    "COVERAGE_SPAN": "A coverage span lies inside the prompt.",
    "COVERAGE_POINTER": "A coverage pointer names a field of the document.",
}
"""Code -> the rule that holds when the code is absent."""


@dataclass
class Findings:
    """Collects violations; the same code at the same place is kept once."""

    items: list[Violation] = field(default_factory=list[Violation])
    _seen: set[tuple[str, str, str]] = field(default_factory=set[tuple[str, str, str]])
    _codes: dict[str, set[str]] = field(default_factory=dict[str, set[str]])

    def add(self, code: str, where: str, value: Any, message: str, remedy: str) -> None:
        """Records a violation.

        Raises:
            KeyError: For a code that is not in `RULES`.
        """
        RULES[code]
        key = (code, where, message)
        if key not in self._seen:
            self._seen.add(key)
            self._codes.setdefault(where, set()).add(code)
            self.items.append(Violation(code, where, clip(value), remedy, message))

    def codes_at(self, where: str) -> set[str]:
        """Codes of the violations at a pointer."""
        return self._codes.get(where, set())


def listing(names: Iterable[str], limit: int = 8) -> str:
    """Names for a message: sorted, quoted, cut after `limit`."""
    ordered = sorted(names)
    if not ordered:
        return "none"
    text = ", ".join(repr(n) for n in ordered[:limit])
    return text if len(ordered) <= limit else f"{text}, … ({len(ordered)} in all)"
