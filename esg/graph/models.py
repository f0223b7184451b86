"""The Evolutive Scene Graph (ESG) document: one frozen tree that every stage reads and extends.

Units are cm, kg, s and degrees; the frame is right-handed, Z up, left = +X, front = +Y; headings
are 0 along +X, counter-clockwise positive seen from above (docs/graph.md). A stage fills its
own fields and never rewrites another stage's. Source: the paper's schema appendix.

An asset's local frame has its origin at the bottom centre of its bounding box, Z up, front = +X, so
that an object's yaw is its heading.
"""

from __future__ import annotations

import enum
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from esg.lexicon.parts import Part

SCHEMA_VERSION = "1.0.0"

Vec3 = tuple[float, float, float]
Quat = tuple[float, float, float, float]
Interval = tuple[float, float]
Quantity = float | Interval
"""A fixed value (hard constraint) or a closed interval (optimization variable)."""


class Model(BaseModel):
    """Base of all document parts: frozen, no unknown fields, no NaN or infinity."""

    model_config = ConfigDict(
        frozen=True, extra="forbid", allow_inf_nan=False, populate_by_name=True
    )


class RegionType(str, enum.Enum):
    SUPPORT_SURFACE = "SUPPORT_SURFACE"
    STORAGE = "STORAGE"
    ATTACHED_VERTICAL = "ATTACHED_VERTICAL"
    ATTACHED_HORIZONTAL = "ATTACHED_HORIZONTAL"


class RelationType(str, enum.Enum):
    """Binary relations; every edge reads "`from` is <relation> `to`"."""

    ON = "on"
    UNDER = "under"
    IN_FRONT_OF = "in_front_of"
    BEHIND = "behind"
    LEFT_OF = "left_of"
    RIGHT_OF = "right_of"
    NEAR = "near"
    ADJACENT = "adjacent"
    FAR_FROM = "far_from"
    ABOVE = "above"
    HIGHER_THAN = "higher_than"
    LOWER_THAN = "lower_than"
    SAME_LEVEL_AS = "same_level_as"
    FACE = "face"
    INSIDE_OF = "inside_of"
    CENTER_OF = "center_of"
    ATTACHED_VERTICAL = "attached_vertical"
    ATTACHED_HORIZONTAL = "attached_horizontal"


class MultiRelationType(str, enum.Enum):
    """Relations of a group: `subjects` are arranged with respect to `targets`."""

    BETWEEN = "between"
    SURROUND = "surround"
    ALIGN = "align"
    SCATTER_BY = "scatter_by"


class Role(str, enum.Enum):
    ACTIVE = "active"
    PASSIVE = "passive"


class ForceDirection(str, enum.Enum):
    ANY_3D = "ANY_3D"
    HORIZONTAL_PLANE = "HORIZONTAL_PLANE"
    ALONG_FORWARD_OR_BACKWARD = "ALONG_FORWARD_OR_BACKWARD"
    ALONG_FORWARD_ONLY = "ALONG_FORWARD_ONLY"


class NodeEvent(str, enum.Enum):
    """Point events. Fall, Reach, Miss and what follows extend the paper's list (docs/graph.md)."""

    SCENE_START = "SceneStart"
    COLLISION = "Collision"
    POSITION_AT = "PositionAt"
    TRIGGER = "Trigger"
    ENTER_REGION = "EnterRegion"
    STOP = "Stop"
    TOPPLE = "Topple"
    HEADING_REACHED = "HeadingReached"
    FALL = "Fall"
    REACH = "Reach"
    MISS = "Miss"
    PICKED_UP = "PickedUp"
    PLACED = "Placed"
    BOUNCE = "Bounce"
    JUMP = "Jump"
    SPIN = "Spin"
    OPEN = "Open"
    CLOSE = "Close"
    SWING = "Swing"
    BREAK = "Break"


class EdgeEvent(str, enum.Enum):
    """Motion segments of one actor between two point events.

    UniformMotion, AcceleratedMotion and Turn are motion under own power (HoldVelocity); Toward is a
    launch: a throw, kick, strike or roll that sets the velocity once and then leaves the body to
    physics; Brake slows down evenly; InertialConnector links a passive body's two collisions. Guide
    moves a body that something outside of the scene holds (GuideAlong), Spin keeps it turning about
    its vertical where it is (HoldSpin). Drive moves a jointed body along its joint (DriveJoint),
    Release holds one at its joint's start position until then and lets it go.
    """

    UNIFORM_MOTION = "UniformMotion"
    TOWARD = "Toward"
    ACCELERATED_MOTION = "AcceleratedMotion"
    BRAKE = "Brake"
    TURN = "Turn"
    INERTIAL_CONNECTOR = "InertialConnector"
    GUIDE = "Guide"
    SPIN = "Spin"
    DRIVE = "Drive"
    RELEASE = "Release"


class CoordinateSystem(Model):
    units: Literal["cm"] = "cm"
    handedness: Literal["right"] = "right"
    up_axis: Literal["Z"] = "Z"
    left_axis: Literal["+X"] = "+X"
    front_axis: Literal["+Y"] = "+Y"
    world_bounds_cm: tuple[Vec3, Vec3] = ((-6000.0, -6000.0, -500.0), (6000.0, 6000.0, 3000.0))


class SceneParameters(Model):
    is_dynamic: bool
    scene_type: Literal["indoor", "outdoor"]
    environment: str = "generic"
    """Named environment preset, e.g. street, bowling_alley, billiard_hall, office, park."""
    allow_supplementary: bool = True
    """False when the prompt says "only" or "no other objects"."""


class Wording(Model):
    """What the prompt's words say of its physics beside objects, relations and events.

    Recorded by whoever reads the prompt (`esg.draft.said`), so that no later stage reads it again.
    """

    surface: Literal["ice", "snow", "wet", "mud", "sand", "gravel"] | None = None
    """What the scene's ground is said to be: a row of `esg/lexicon/grounds.csv`."""
    keeps_to_ground: Literal[True] | None = None
    """Something is said to roll, slide, or be pushed: what moves on the ground is not thrown."""


class SceneDefinition(Model):
    scene_id: str
    coordinate_system: CoordinateSystem = CoordinateSystem()
    original_description: str
    expanded_description: str = ""
    scene_parameters: SceneParameters
    wording: Wording | None = None
    """None where the words say nothing of the kind."""
    traffic: Literal["right", "left"] | None = None
    """The side of the road that vehicles keep to; None is the right one."""


class Contents(Model):
    """What a vessel is filled with, and to which share of its depth."""

    name: str
    """Of a row of `esg/lexicon/contents.csv`."""
    share: float
    color: str | None = None
    """As the prompt has it ("blue paint")."""


class AssetRequirement(Model):
    """What is needed (stage 1). Dimensions are (length along front, width, height)."""

    asset_category: str
    asset_description: str
    expected_dimensions_cm: Vec3
    expected_mass_kg: float
    is_movable: bool = True
    mass_is_prescribed: bool = False
    dimensions_are_prescribed: bool = False
    material: str | None = None
    color: str | None = None
    shape: Literal["sphere", "box", "cylinder", "capsule", "compound"] | None = None
    linear_damping: float = 0.1
    contents: Contents | None = None
    lies: str | None = None
    """How it lies or stands where that is not as it is drawn (`esg/lexicon/lying.csv`), or
    "tipped up": on the edge of its foot."""


class ProxyKind(str, enum.Enum):
    SPHERE = "sphere"
    BOX = "box"
    CAPSULE = "capsule"
    CYLINDER = "cylinder"
    CONVEX = "convex"


class Proxy(Model):
    """One collision shape in the asset's local frame [cm].

    `size_cm`: sphere (r, r, r); box half extents; capsule and cylinder (r, r, half height along
    local Z, caps excluded); convex: half extents of its bounding box, with `vertices_cm` given.
    """

    kind: ProxyKind
    size_cm: Vec3
    position_cm: Vec3 = (0.0, 0.0, 0.0)
    orientation_xyzw: Quat = (0.0, 0.0, 0.0, 1.0)
    vertices_cm: tuple[Vec3, ...] = ()


class SupportSurface(Model):
    """A horizontal rectangle in the local frame on which things can stand (z is its height)."""

    name: str
    center_cm: Vec3
    half_extents_cm: tuple[float, float]


class NamedRegion(Model):
    """A volume of an asset that things can enter: a pocket, a goal mouth, a bin's inside.

    An axis-aligned box in the asset's local frame [cm].
    """

    name: str
    center_cm: Vec3
    half_extents_cm: Vec3
    kind: Literal["pocket", "goal", "hole", "inside", "lane", "area", "content"] = "area"
    """`content`: what fills a vessel, by its name, up to its level (`esg/lexicon/contents.csv`)."""


class RetrievalCandidate(Model):
    asset_name: str
    score: float
    semantic: float = 0.0
    category: float = 0.0
    physical: float = 0.0


class Wheel(Model):
    """A wheel of an asset: it turns about a line along Y of the local frame."""

    name: str
    """Of its node in the mesh; unique in the asset, e.g. `wheel_front_left`."""
    axle_cm: Vec3
    """A point of its axis, in the local frame [cm]."""
    radius_cm: float


class Mount(Model):
    """Where a joint takes hold of an asset, in its local frame."""

    name: str
    """Unique in the asset, e.g. `hinge`."""
    position_cm: Vec3
    axis: Vec3 = (0.0, 0.0, 1.0)
    """Of any length but 0: a hinge turns about it, a slider moves along it."""


class Lying(Model):
    """How an asset is turned that lies or stands otherwise than it is drawn (docs/lying.md)."""

    pose: str
    """Row of `esg/lexicon/lying.csv`."""
    turned_xyzw: Quat
    """From its local frame as it is drawn to that as it lies."""
    moved_cm: Vec3
    """After the turn: the origin is its bottom centre again."""
    drawn_cm: Vec3
    """Its extents as it is drawn."""
    dimensions_cm: Vec3
    """Its extents as it lies."""

    def __hash__(self) -> int:
        return hash((self.pose, self.turned_xyzw, self.moved_cm, self.drawn_cm, self.dimensions_cm))


class AssetConfiguration(Model):
    """What is used (stage 2): geometry, proxies and physics of one requirement."""

    asset_name: str
    source: Literal["parametric", "library", "generated", "fallback"]
    category: str
    mesh_path: str
    """Path of the GLB inside the scene folder, e.g. `meshes/sedan.glb` (cm, Z up, front +X)."""
    mesh_sha256: str = ""
    dimensions_cm: Vec3
    scale: Vec3 = (1.0, 1.0, 1.0)
    front_axis: Literal["+X"] = "+X"
    proxies: tuple[Proxy, ...] = ()
    """Empty: the asset is a decal without collision (a road marking, a lane)."""
    support_surfaces: tuple[SupportSurface, ...] = ()
    regions: tuple[NamedRegion, ...] = ()
    mass_kg: float
    is_movable: bool
    center_of_mass_cm: Vec3 = (0.0, 0.0, 0.0)
    inertia_kg_cm2: tuple[float, float, float, float, float, float] = (0, 0, 0, 0, 0, 0)
    """Ixx, Iyy, Izz, Ixy, Ixz, Iyz about the centre of mass, axes of the local frame."""
    friction: float
    restitution: float
    linear_damping: float = 0.0
    angular_damping: float = 0.0
    is_wheeled: bool = False
    """Rolls on wheels: coasts on the low-friction vehicle ground (docs/engines.md)."""
    rolls: bool = False
    """A round body that rolls about its centre (ball, wheel)."""
    wheels: tuple[Wheel, ...] | None = None
    """What turns as the asset travels (docs/assets.md); None if nothing does."""
    contents: Contents | None = None
    """What it is filled with; the region of that kind says up to where."""
    lying: Lying | None = None
    """How it is turned; None: it lies or stands as it is drawn."""
    mounts: tuple[Mount, ...] | None = None
    """Where joints take hold of it (docs/joints.md); None if none can."""
    color_rgb: tuple[float, float, float] = (0.6, 0.6, 0.6)
    license: str = "Apache-2.0"
    attribution: str = ""
    confidence: float = 1.0
    runners_up: tuple[RetrievalCandidate, ...] = ()
    reason: str | None = None
    """Why this asset stands in for a noun that the library does not hold."""


class SemanticRegion(Model):
    region_description: str
    region_type: RegionType
    parent_object: str
    bounds_cm: tuple[Vec3, Vec3] | None = None
    """Bounds in the parent's local frame; None takes the parent's whole surface."""
    part: Part | None = None
    """The part of the parent's surface that is meant, where the bounds follow from its size."""


class LayoutPreference(Model):
    """Soft cue used at initialization only (Supp. Mat., preference strategy)."""

    anchor: Literal["center", "left", "right", "front", "back", "boundary", "none"] = "none"
    weight: float = 1.0


class Breaking(Model):
    """How a node breaks where its prompt says so (docs/breaking.md)."""

    speed: float
    """The change of its own speed that breaks it [cm/s]: its break impulse over its mass."""
    pieces: int
    """Number of Voronoi cells that it is cut into."""


class Node(Model):
    """One object instance. Node ids are logical names: car_1, picnic_table_1."""

    asset_id: str
    semantic_region: str | None = None
    is_structural: bool = False
    label: str = ""
    """How the prompt names it: "ball A", "front car", "black ball"."""
    mentioned: bool = True
    """False for objects that expansion added."""
    group: str | None = None
    """Shared by members of one plural ("bowling pins"); their arrangement is in `group_pattern`."""
    group_pattern: Literal["pins", "rack", "row", "column", "stack", "queue", "scatter"] | None = (
        None
    )
    is_static: bool = False
    """Fixed in the world although its asset is movable (a nailed-down table)."""
    size_is_stated: Literal[True] | None = None
    """Its words state a size without a number (a tall lamp): it is not made smaller."""
    breaking: Breaking | None = None
    """It breaks; None: whatever hits it, it does not."""
    layout_preference: LayoutPreference = LayoutPreference()


class BinaryRelation(Model):
    from_: Annotated[str, Field(alias="from")]
    to: str
    relation_type: RelationType
    confidence: float = 1.0
    semantic_description: str = ""
    distance_cm: Quantity | None = None
    """Prescribed surface distance, where the prompt states one."""
    cardinal: Literal["+X", "-X", "+Y", "-Y"] | None = None
    """For `face` towards a direction instead of an object (`to` is then the ground node)."""


class MultiRelation(Model):
    subjects: tuple[str, ...]
    targets: tuple[str, ...] = ()
    relation_type: MultiRelationType
    confidence: float = 1.0
    semantic_description: str = ""
    spacing_cm: Quantity | None = None


class RelationEdges(Model):
    binary_relations: tuple[BinaryRelation, ...] = ()
    multi_relations: tuple[MultiRelation, ...] = ()


class JointMotor(Model):
    """What drives a hinge or slider: towards a speed, or, if `position` is given, a position."""

    speed: float = 0.0
    """[deg/s or cm/s]; with a position, the greatest on the way there"""
    position: float | None = None
    """[deg or cm]"""
    limit: float | None = None
    """Greatest torque or force [N m or N]; None: as much as it takes"""


class Joint(Model):
    """A connection of two nodes, or of one and the world (docs/joints.md).

    At position 0 the child stands as the parent does, turned the least so that the axes of their
    mounts agree. A hinge turns about the axis, a slider moves along it, a ball joint turns every
    way; a rope and a spring join the two mounts. Forces are in N, N m and N s.
    """

    id: str
    kind: Literal["hinge", "slider", "ball", "fixed", "rope", "spring"]
    child: str
    child_mount: str
    parent: str | None = None
    """None: the world."""
    parent_mount: str | None = None
    """Puts the child where the two mounts meet. None: holds it where it is placed."""
    lower: float | None = None
    upper: float | None = None
    """Limits of its position, hinge [deg], slider [cm]; of a ball joint the largest angle between
    the axes [deg], of a rope its length [cm], of a spring its rest length [cm]."""
    position: float = 0.0
    """At the start: hinge [deg], slider [cm]; ball, rope and spring: the angle by which the child
    is turned about the axis of the parent's mount [deg]"""
    stiffness: float | None = None
    """Of a spring [N/m]; of a hinge or slider that is drawn back to 0 [N m/rad, N/m]"""
    damping: float | None = None
    """Hinge and ball [N m s/rad], slider and spring [N s/m]"""
    friction: float | None = None
    """Torque or force that holds it at rest and brakes it [N m or N]"""
    motor: JointMotor | None = None
    break_impulse: float | None = None
    """It is gone after a step in which it took more [N s]"""
    collide: Literal[True] | None = None
    """The two touch each other, too"""


class SpatialRelationGraph(Model):
    semantic_regions: dict[str, SemanticRegion] = {}
    nodes: dict[str, Node] = {}
    edges: RelationEdges = RelationEdges()
    joints: tuple[Joint, ...] | None = None
    """What nodes are connected by; None where nothing is."""


class Actor(Model):
    role: Role
    force_direction: ForceDirection | None = None
    """Required for active actors, absent for passive ones."""


class EventConstraint(Model):
    """A measurable outcome the prompt prescribes for a point event.

    Quantities and their meaning are the suite's (`data/suites`): speed_after, speed_before,
    time_since, time_to_stop, distance, height, angle. Units: cm/s, s, cm, degrees.
    """

    quantity: Literal[
        "speed_after", "speed_before", "time_since", "time_to_stop", "distance", "height", "angle"
    ]
    object: str
    value: Quantity
    since: str | None = None
    """For time_since: id of the earlier point event."""
    to: str | None = None
    """For distance: the object from whose surface the gap is measured when the event happens
    ("stops 1 m in front of the gate"); None: the way travelled."""


class TimelineNode(Model):
    """A point event: a milestone at a fixed `timestamp` or within a `window` [s]."""

    id: str
    event: NodeEvent
    participants: tuple[str, ...] = ()
    """Object ids. Collision, Reach, Miss, Placed and Bounce name two: (mover, target)."""
    timestamp: float | None = None
    window: Interval | None = None
    time_is_prescribed: bool = False
    """True when the prompt states the time: a constraint, not a plausible guess."""
    constraints: tuple[EventConstraint, ...] = ()
    position_cm: Vec3 | None = None
    """PositionAt: target position of the participant's centre."""
    region: str | None = None
    """EnterRegion: "node_id/region name" of a NamedRegion, e.g. "pool_table_1/bottom pocket"."""
    turn_direction: Literal["left", "right"] | None = None
    turn_degrees: float | None = None
    """HeadingReached: change of heading; left is counter-clockwise seen from above. Spin: how far
    it turns, 360 where it states nothing. Open, Close: how far, 30 where it states nothing."""
    times: int | None = None
    """Bounce, Jump, Swing: how often; once where it states nothing."""
    description: str = ""


class MotionParams(Model):
    """Parameters of a motion segment; a number is fixed, a pair is optimized, None is unused."""

    speed: Quantity | None = None
    """[cm/s]"""
    acceleration: Quantity | None = None
    """[cm/s^2], positive speeds up; Brake: how fast it slows down, where the prompt says so"""
    damping: Quantity | None = None
    """Brake: a number is a linear damping [1/s], a pair leaves open how hard it brakes"""
    heading_deg: Quantity | None = None
    elevation_deg: Quantity | None = None
    """With ANY_3D: Toward: launch angle above the horizon; UniformMotion: how steeply it climbs"""
    turn_degrees: Quantity | None = None
    turn_direction: Literal["left", "right"] | None = None
    turn_rate_deg_s: Quantity | None = None
    duration: Quantity | None = None
    """[s]"""
    spin: Literal["roll", "slide", "none"] | None = None
    backward: Literal[True] | None = None
    """Moves with its back in front; `heading_deg` is the way it goes."""
    lift_cm: Quantity | None = None
    """Guide: gap left under the body while it is carried [cm]"""
    clearance_cm: Quantity | None = None
    """Guide that ends at a Trigger: gap between the target's top and the body above it [cm]"""
    release: bool | None = None
    """Guide: False holds the body on at the end; otherwise it is let go there"""
    height_cm: Quantity | None = None
    """Toward that ends in a Jump, Guide that climbs: how far the body rises [cm]"""
    climbs: Literal["up", "down", "onto", "over"] | None = None
    """Guide that ends at a Trigger: leads the body along the surface of its target"""
    posture: Literal["stands", "sits", "lies", "kneels", "crouches", "bends"] | None = None
    """Guide that ends at a Trigger: the posture that its actor takes, on its target if any"""
    opening: Quantity | None = None
    """Drive: the joint's position at its end, hinge [deg], slider [cm]"""


class TimelineEdge(Model):
    """A motion segment of one actor from one point event to another."""

    id: str
    from_: Annotated[str, Field(alias="from")]
    to: str
    event: EdgeEvent
    actor: str
    target: str | None = None
    params: MotionParams = MotionParams()
    speed_is_prescribed: bool = False


class SequenceGraph(Model):
    nodes: tuple[TimelineNode, ...] = ()
    edges: tuple[TimelineEdge, ...] = ()


class TimelineSystem(Model):
    actors: dict[str, Actor] = {}
    sequence_graph: SequenceGraph = SequenceGraph()


class CoverageItem(Model):
    """Where one noun, event or quantity of the prompt went."""

    text: str
    start: int
    end: int
    kind: Literal["object", "event", "quantity", "relation", "modifier"]
    status: Literal["used", "ignored", "not_understood"]
    pointer: str = ""
    """JSON pointer of the field it became."""
    note: str = ""


class Coverage(Model):
    items: tuple[CoverageItem, ...] = ()
    warnings: tuple[str, ...] = ()


class Predicate(str, enum.Enum):
    """What a statement says of its participants; docs/metrics/statements.md says when each is kept.

    All but the last are measured on a replay (`esg.metrics.statements`).
    """

    SUPPORTED_BY = "supported_by"
    INSIDE = "inside"
    ABOVE = "above"
    UNDER = "under"
    LEFT_OF = "left_of"
    RIGHT_OF = "right_of"
    IN_FRONT_OF = "in_front_of"
    BEHIND = "behind"
    HANGS_FROM = "hangs_from"
    ATTACHED_TO = "attached_to"
    LEANS_ON = "leans_on"
    MOVES = "moves"
    CLIMBS = "climbs"
    ROLLS = "rolls"
    SLIDES = "slides"
    SPINS = "spins"
    TUMBLES = "tumbles"
    AIRBORNE = "airborne"
    CARRIED_BY = "carried_by"
    STAYS_UPRIGHT = "stays_upright"
    STAYS_STILL = "stays_still"
    TOUCHES = "touches"
    NEVER_TOUCHES = "never_touches"
    STRUCK_ON = "struck_on"
    ENDS_ON = "ends_on"
    ENDS_IN = "ends_in"
    ENDS_NEAR = "ends_near"
    AT_PART = "at_part"
    """It is at an end, an edge or a corner of the first target's top (`noun`), or at the other end
    than the second target."""
    AT_REST = "at_rest"
    SAME_TIME = "same_time"
    BEFORE = "before"
    SLOWER_THAN = "slower_than"
    FASTER_THAN = "faster_than"
    FILLED_WITH = "filled_with"
    FLOATS = "floats"
    SINKS = "sinks"
    SIZE = "size"
    COUNT = "count"
    ABSENT = "absent"
    FILMED = "filmed"
    """How the scene is shown (`Filming`): measured on the way of the camera (`esg.filming`)."""
    WEARS = "wears"
    LOOKS = "looks"
    LIT = "lit"
    WEATHER = "weather"
    SWAYS = "sways"
    LIES = "lies"
    """How a thing lies or stands (`noun`: a row of `esg/lexicon/lying.csv`)."""
    WOBBLES = "wobbles"
    """It tilts to and fro and does not fall."""
    POSTURE = "posture"
    """How somebody holds his body (`noun`: stands, sits, lies, kneels, crouches, bends)."""
    GESTURES = "gestures"
    """What somebody does with arms, head or tail (`noun`: a row of `esg.lexicon.gestures`)."""
    FACES = "faces"
    GIVES_OFF = "gives_off"
    """Smoke, steam, dust or sparks (`noun`: a row of `esg.lexicon.plumes`)."""
    NOT_REPRESENTED = "not_represented"
    """Its words are understood as a statement that the document cannot hold (`note` says why)."""


Direction = Literal[
    "left",
    "right",
    "front",
    "back",
    "up",
    "down",
    "forward",
    "backward",
    "toward",
    "away_from",
    "along",
    "past",
    "across",
    "through",
    "around",
    "between",
]
"""Left is +X and front +Y (the viewer stands at +Y); forward is an object's own heading at the
start; from `toward` on a direction has a target."""


Filming = Literal[
    "overhead",
    "aerial",
    "high_angle",
    "low_angle",
    "eye_level",
    "from_front",
    "from_behind",
    "from_side",
    "first_person",
    "over_shoulder",
    "extreme_close_up",
    "close_up",
    "medium",
    "wide",
    "in_view",
    "follows",
    "zooms_in",
    "zooms_out",
    "moves_forward",
    "moves_backward",
    "moves_left",
    "moves_right",
    "moves_up",
    "moves_down",
    "pans_left",
    "pans_right",
    "tilts_up",
    "tilts_down",
    "orbits",
    "static",
    "handheld",
    "slow_motion",
    "time_lapse",
]
"""How a scene is filmed: from where, how large its objects are, how the camera moves, how fast the
scene passes. What follows, closes in or stands beside is of the objects of the statement."""


Side = Literal["front", "rear", "left", "right", "side", "any_side"]
"""Of a thing, by its own front axis: `side` is its left or right, `any_side` all but top and bottom
(of a box nobody says which of its sides is its front)."""


class Statement(Model):
    """One thing that the prompt states beyond its objects, relations, quantities and events.

    The drafter writes it, the judge measures it on the replay, and no stage drops it.
    """

    id: str
    predicate: Predicate
    text: str
    """The words that state it; `start` and `end` are their place in the prompt."""
    start: int
    end: int
    object: tuple[str, ...] = ()
    """Node ids of what it is said of (each of them); of `same_time` and `before`, two events."""
    target: tuple[str, ...] = ()
    """Node ids of the other participant (any of them)."""
    direction: Direction | None = None
    side: Side | None = None
    """Of `struck_on`: where the target first touches the object."""
    filming: Filming | None = None
    """Of `filmed`: what the camera does."""
    quantity: (
        Literal["speed", "deceleration", "distance", "height", "length", "width", "angle", "count"]
        | None
    ) = None
    value: Quantity | None = None
    """In the document's units [cm/s, cm/s^2, cm, degrees, 1]."""
    noun: str | None = None
    """Of `absent` and `count`; of `filled_with`, what it is filled with; of `wears` and `looks`
    what is worn, and how the hair is; of `lit` which light and how ("headlights flashing", "lamp
    turned off"), of `weather` which ("heavy rain"), of `sways` how strong the wind is; of
    `posture`, which; of `at_part` a row of `esg.lexicon.parts`."""
    when: str = "throughout"
    """start, end, throughout, the id of a point event, or two of these as "from..to"."""
    note: str = ""
    """Of `not_represented`: what is missing, in words for the reader of a report."""


class AssetChoice(Model):
    """The configuration that takes the place of an asset's own, and why."""

    configuration: AssetConfiguration
    reasons: tuple[str, ...] = ()


class NodeChoice(Model):
    """Whether a node stands fixed in the world, in place of what the draft says, and why."""

    is_static: bool
    reasons: tuple[str, ...] = ()


class ActorChoice(Model):
    """How an actor may be set going (thrown instead of rolled), and why."""

    force_direction: ForceDirection
    reasons: tuple[str, ...] = ()


class SegmentChoice(Model):
    """The parameters that take the place of a motion segment's own, and why."""

    params: MotionParams
    reasons: tuple[str, ...] = ()


class Casting(Model):
    """Stage cast: what the prompt leaves open, chosen so that its events are possible.

    Draft and resolve stay as they were written; `esg.graph.effective` applies these choices.
    """

    assets: dict[str, AssetChoice] = {}
    nodes: dict[str, NodeChoice] = {}
    actors: dict[str, ActorChoice] = {}
    segments: dict[str, SegmentChoice] = {}
    """By id of the timeline's edge."""


class PlannedStart(Model):
    """Where one node, or "group:NAME", starts in its constellation's frame."""

    node: str
    x_cm: float
    y_cm: float
    yaw_deg: float | None = None
    """None leaves the heading to the layout."""
    z_cm: float | None = None
    """Height above the ground of what starts in the air; None rests it on its support."""


class PlannedPath(Model):
    """A swept path that only its participants may touch at the start."""

    points_cm: tuple[tuple[float, float], ...]
    half_width_cm: float
    participants: tuple[str, ...]


class PlannedConstellation(Model):
    """Bodies whose relative start a motion asks for (`esg.layout.problem.hints`)."""

    placements: tuple[PlannedStart, ...]
    corridors: tuple[PlannedPath, ...] = ()
    anchor: str | None = None
    yaw_deg: float | None = None


class Choreography(Model):
    """The story as told in closed form before anything is simulated."""

    constellations: tuple[PlannedConstellation, ...] = ()
    nominal: dict[str, float] = {}
    """Nominal parameters, SI: "edge id/speed", "event id/event_time"."""


class Pose(Model):
    """Pose of an asset's local frame: R = Rz(yaw) Ry(pitch) Rx(roll)."""

    position_cm: Vec3
    yaw_deg: float = 0.0
    pitch_deg: float = 0.0
    roll_deg: float = 0.0


class RelationReport(Model):
    edge: str
    relation_type: str
    satisfied: bool
    violation: float
    note: str = ""


class LayoutResult(Model):
    """Stage 3: poses xi and how well they satisfy the graph."""

    poses: dict[str, Pose]
    energy: float
    energy_terms: dict[str, float] = {}
    relations: tuple[RelationReport, ...] = ()
    patterns: tuple[RelationReport, ...] | None = None
    """Groups that do not stand in their pattern; None if all do."""
    max_penetration_cm: float = 0.0
    feasible: bool = True
    reason: str = ""


class Parameter(Model):
    """One entry of theta, in SI units as simulated; `unit` says which."""

    name: str
    """`edge id/param`, e.g. `car_drive/speed`."""
    value: float
    lower: float
    upper: float
    initial: float
    fixed: bool = False
    unit: str = ""


class RelaxedConstraint(Model):
    event: str
    quantity: str
    requested: Quantity
    achieved: float
    unit: str


class SearchStep(Model):
    """One batch of candidates of a search.

    `phase`: start, explore, confirm, polish, coarse, descend or sample; `engine`: who played them;
    `best`: the best loss known after it.
    """

    phase: str
    engine: str
    candidates: int
    best: float


class ClosedLoop(Model):
    """What feeding back the verify engine's outcome changed (only on request).

    `open` and `closed` hold, for theta before and after, the share of completed events and the
    largest error of a prescribed quantity in units of its tolerance, in the verify engine.
    """

    engine: str
    dt_s: float
    rounds: int
    open: dict[str, float]
    closed: dict[str, float]


class DynamicsResult(Model):
    """Stage 4: theta, the control program it compiles to (SI), and why the search stopped."""

    strategy: str
    parameters: tuple[Parameter, ...] = ()
    start_poses: dict[str, Pose] = {}
    """Start poses of active actors that the search re-aimed; they take precedence over xi."""
    program: dict[str, Any] = {}
    """Serialized control program (esg.engines.program.program_to_json), SI units."""
    duration_s: float
    outcome: str
    reason: str = ""
    loss: float = 0.0
    margins: dict[str, float] = {}
    """Signed margin per event or constraint, worst case over the ensemble; positive holds."""
    relaxed: tuple[RelaxedConstraint, ...] = ()
    evaluations: int = 0
    history: tuple[float, ...] = ()
    """Best loss after each batch of candidates."""
    steps: tuple[SearchStep, ...] = ()
    stopped: str = ""
    """Why the search ended: robust, no progress, rounds spent, converged, budget spent."""
    explored: int = 0
    """Rollouts of the surrogate; `evaluations` counts those of the reference engine."""
    closed_loop: ClosedLoop | None = None
    engine: str = ""
    dt_s: float = 0.0


class Marking(Model):
    """Something flat that is drawn on the ground of a place: a lane, a line, a pavement, water."""

    surface: str
    """Row of the table of surfaces (`esg/lexicon/surfaces.csv`)."""
    center_cm: tuple[float, float]
    half_cm: tuple[float, float]
    """Along its own X and Y; both radii of an ellipse."""
    yaw_deg: float = 0.0
    shape: Literal["rectangle", "ellipse"] = "rectangle"
    line_cm: float | None = None
    """Width of the line, where only its outline is drawn."""
    layer: int = 0
    """Of two that overlap the one with the greater layer is seen."""


class DressingItem(Model):
    """Something that stands in a place and takes no part in its physics."""

    id: str
    kind: str
    """An entry of the parametric library, or a builder of `esg.dressing`."""
    position_cm: Vec3
    """Of the middle of its bottom."""
    yaw_deg: float = 0.0
    size_cm: Vec3
    surface: str | None = None
    """Row of the table of surfaces; None: as its kind is made."""
    color_rgb: tuple[float, float, float] | None = None
    """sRGB in [0, 1]; None: the usual one of its kind or surface."""
    wall: str | None = None
    """Id of the wall at which it stands or hangs: who looks through the one sees neither."""
    variant: int = 0
    """Seed of what else may differ: proportions, wear, which windows are lit."""


class Dressing(Model):
    """Stage dress: the place around the action. Nothing of it is a body; no engine knows of it."""

    place: str
    """Row of the table of places (`esg/lexicon/places.csv`)."""
    reasons: tuple[str, ...] = ()
    """Why this place and this sky: what the document says of them."""
    sky: str
    """Row of the table of skies (`esg/lexicon/skies.csv`)."""
    sun_azimuth_deg: float
    """Direction toward the sun, or toward the main lamp of a room, counter-clockwise from +X."""
    sun_elevation_deg: float
    ground: str
    """Row of the table of surfaces."""
    markings: tuple[Marking, ...] = ()
    items: tuple[DressingItem, ...] = ()


class Provenance(Model):
    """Which stage, version and seed wrote which part."""

    stage: Literal["draft", "resolve", "cast", "layout", "optimize", "compile", "dress"]
    version: str
    seed: int
    config: dict[str, Any] = {}
    input_hash: str = ""


class EsgDocument(Model):
    """The carrier of the whole pipeline."""

    schema_version: Literal["1.0.0"] = SCHEMA_VERSION
    scene_definition: SceneDefinition
    asset_requirement: dict[str, AssetRequirement] = {}
    asset_configurations: dict[str, AssetConfiguration] = {}
    spatial_relation_graph: SpatialRelationGraph = SpatialRelationGraph()
    timeline_system: TimelineSystem | None = None
    coverage: Coverage = Coverage()
    statements: tuple[Statement, ...] | None = None
    """What the prompt states beyond the rest; None where it states nothing more."""
    casting: Casting | None = None
    """None where nothing had to be chosen."""
    choreography: Choreography | None = None
    """None for what has no timeline."""
    layout_result: LayoutResult | None = None
    dynamics_result: DynamicsResult | None = None
    dressing: Dressing | None = None
    """What surrounds the action; None where nothing may be added, or nothing was."""
    provenance: tuple[Provenance, ...] = ()
