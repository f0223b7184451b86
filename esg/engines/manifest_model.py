"""Format of `manifest.json`: its models, its conventions in words, its JSON Schema.

`schemas/manifest.schema.json` is generated from these models and tested to be in sync.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    SerializerFunctionWrapHandler,
    ValidationError,
    model_serializer,
)

from esg.engines.joints import JointKind
from esg.engines.program import GUIDE_RATE, MAX_KNOTS
from esg.engines.scene import GROUND, ShapeKind
from esg.engines.traction import BLOW_MPS, LEAST_LEAN_RAD_S, TIPPING_RAD_S
from esg.units import GRAVITY_MPS2

MANIFEST_FORMAT = "esg-manifest"
MANIFEST_VERSION = 1

CONVENTIONS = {
    "units": "SI: m, kg, s, rad, N s; restitution and friction have no unit",
    "frame": "right-handed, Z up; headings are counter-clockwise from +X",
    "quaternion": "(x, y, z, w)",
    "body_frame": "origin at the centre of mass; inertia about it in body axes; "
    "origin_offset leads to the origin of the mesh",
    "shape": "size: sphere (r, r, r); box half extents; capsule and cylinder (r, r, half height "
    "along local Z without caps); convex half extents of its bounding box",
    "materials": "friction (static = dynamic) and restitution of a pair are the arithmetic mean of "
    "the two bodies' values; effective_pairs lists the results",
    "ground": "half-space z <= 0; bodies with wheeled = true touch vehicle_ground_friction, all "
    "others ground_friction",
    "damping": "once per step v *= max(0, 1 - c dt), for linear and angular velocity alike",
    "decals": "bodies without shapes are not simulated",
    "program": "before the step from t to t + dt, in list order: SetVelocity, ApplyImpulse and "
    "AdjustProperties fire once when time <= t + dt/2; HoldVelocity is active from start <= t + "
    "dt/2 until t + dt/2 > end or until its body touched one of until_contact (normal impulse > 0 "
    "in an earlier step at or after start), then never again; with s = t - start it sets speed = "
    "max(0, speed + acceleration s), at most max_speed for positive acceleration, along heading + "
    "turn_rate s; the vertical velocity is kept; the angular velocity becomes (0, 0, turn_rate), "
    "or (-vy, vx, 0) / roll_radius for roll_radius > 0; end = null means never",
}

CLIMB_CONVENTION = (
    "a HoldVelocity with a climb sets the vertical velocity to climb - gravity_z dt, so that the "
    "body moves at climb [m/s] after the step's gravity, and does not roll; without one the "
    "vertical velocity is kept"
)
"""Stands under `climb` of the conventions of a manifest whose program has one."""
GAINS_CONVENTION = (
    "a HoldVelocity with gains and loses [m/s^2] does not set its horizontal velocity at once: the "
    "body's own is turned by turn_rate dt, its part along the heading changes towards speed by at "
    "most gains dt upwards and loses dt downwards, the part across it towards 0 by at most loses "
    "dt; the angular velocity of what rolls follows that"
)
"""Stands under `gains` of the conventions of a manifest whose program has them."""

GUIDE_CONVENTION = (
    "a GuideAlong is active as a HoldVelocity is, until start + its last time; its path P is the "
    "cubic Hermite curve through points [m] with velocities [m/s] at times [s since start], and "
    "goes straight on outside of them; with s = t - start and x the centre of mass it sets the "
    f"velocity to (P(s + dt) - P(s)) / dt + {GUIDE_RATE:g} (P(s) - x), its vertical part less "
    "gravity_z dt, and the angular velocity to (0, 0, turn_rate)"
)
SPIN_CONVENTION = (
    "a HoldSpin is active as a HoldVelocity is; it sets the angular velocity to rate [rad/s] along "
    "the unit vector of axis, and leaves the linear velocity"
)
BUOY_CONVENTION = (
    "a BuoyUp is active from start <= t + dt/2 until t + dt/2 > end, in list order with the rest; "
    "its liquid is a box that stays where it is: center is the middle of its level, basin half its "
    "length along heading, half its width and half its depth; of a body whose centre of mass x is "
    "between its sides and not below its bottom, with h = |R_z| . extents (R_z the vertical row of "
    "its rotation matrix) and u = (center_z - x_z + h) / (2 h) clipped to [0, 1], f = u, or "
    "u^2 (3 - 2 u) if round: the velocity v becomes v / (1 + f dt (linear_drag + quadratic_drag "
    "|v|)), its vertical part gains f lift dt, the angular velocity is divided by 1 + f dt "
    "turning_drag"
)
"""Stand under `guide`, `spin` and `buoy` of the conventions of manifests that have them."""

WHEELS_CONVENTION = (
    "no engine simulates wheels; a recording turns them: the node `name` of the mesh by +1 rad "
    "about Y of the body frame, through axle, for every radius [m] that the axle goes along +X of "
    "the body while the body is upright and carried; else they go on turning and run down"
)
"""Stands under `wheels` of the conventions of a manifest with bodies that have them."""
BRAKING_CONVENTION = (
    "an AdjustProperties with a braking [m/s^2] sets the body's brakes (0 lets go): from then on, "
    "before every step and after all primitives, its horizontal velocity loses min(|v_h|, braking "
    "dt), and the horizontal part of the angular velocity of a body with roll_radius > 0 the same "
    "share; not in a step in which a HoldVelocity or GuideAlong sets its velocity, nor while "
    "nothing carries it: in the last step, from after the program and the brakes to before the "
    "program acts again, it lost more than |gravity_z| dt / 2 of its vertical velocity (in the "
    "first step everything is carried)"
)
TYRES_CONVENTION = (
    "the tyres of a wheeled body with tyre_friction mu > 0 act before every step, after the "
    "program and the brakes, while the body's Z axis is within 45 degrees of the vertical; with "
    "k = sqrt(Izz / m), q = m h / Ixx (body axes), f the horizontal part of its X "
    "axis as a unit vector, s = z x f, u its Z axis, h = tyre_drop u.z + tyre_foot |u.s|, v and w "
    "its linear and angular velocity: limit = sqrt((mu |gravity_z| dt)^2 - l^2), l what the brakes "
    "have taken of |v_h| in this step (no tyres if that is more; if tyre_drop > 0 they take it of "
    "v.f); slip = (v.s + h w.f) / (1 + h q); front and rear = slip + k w_z and slip - k w_z, each "
    "clipped to [-limit, limit]; a = (front + rear) / 2, b = (front - rear) / 2; v loses a s, w "
    "loses q a f + b / k z. If tyre_drop > 0 and the horizontal velocity has changed by more than "
    f"{BLOW_MPS:g} m/s in the last step (from after all this to before the program acts again), it "
    "tips over in the next step in which the tyres act, unless driven before: |w.f| is raised "
    f"to the square root of {TIPPING_RAD_S**2:g} + 2 m {GRAVITY_MPS2:g} (r - c) / (Ixx + m r^2) "
    "[rad/s], c = tyre_drop, d = tyre_foot and r = |(c, d)|, keeping its sign, or if |w.f| <= "
    f"{LEAST_LEAN_RAD_S:g} with the sign that tilts it further (positive up to a tilt of 0.001 "
    "rad), and v gains what w.f gains times f x a, where a is (0, d, c) in body axes, or (0, -d, "
    "c) if w.f is negative. All "
    "this is not done in a step in which a HoldVelocity or GuideAlong sets its velocity nor while "
    "nothing carries it: in the last step, from after all "
    "this to before the program acts again, it lost more than |gravity_z| dt / 2 of its vertical "
    "velocity (in the first step everything is carried). So a body resists sliding sideways and "
    "spinning, and rolls on unhindered"
)
"""Stand under `braking` and `tyres` of the conventions of manifests with brakes and tyres."""

JOINTS_CONVENTION = (
    "a joint has a frame in its parent (the world if parent is empty) and one in its child: anchor "
    "[m] and rotation, of which X is the axis; its position is 0 where the frames coincide and "
    "grows as the child turns by the right hand about X (hinge, [rad]) or shifts along X (slider, "
    "[m]); lower and upper limit it, of a ball joint upper limits the angle between the X axes; a "
    "rope keeps the anchors within upper [m], a spring pulls along their line with stiffness "
    "(distance - upper) + damping times its rate; stiffness and damping of a hinge or slider act "
    "towards 0 and against its rate, friction is the torque or force that holds it; a motor drives "
    "it to speed, or with a position there, by no more than limit (null: none), and no friction "
    "acts meanwhile; a joint that took more than break_impulse [N s] within 1/60 s is gone; the "
    "two bodies touch each other only if collide is true"
)
"""Stands under `joints` of the conventions of a manifest that has them."""
DRIVE_CONVENTION = (
    "a DriveJoint fires once when time <= t + dt/2, in list order: from then on the joint has a "
    "motor of that speed, position and limit instead of the one it had, or none if speed and "
    "position are null; a null limit is infinite; the motor of a position drives there at 10 times "
    "the way that is left per second, by no more than |speed| (null or 0: any)"
)
"""Stands under `drive` of the conventions of a manifest whose program has one."""

BREAKING_CONVENTION = (
    "a body with a break_impulse [N s] breaks once the normal impulses of all its contact points "
    "within 1/60 s add up to more; until then its fragments, which are bodies of this list, are "
    "not there: they neither move nor touch, and their poses are those they have in it; after the "
    "step in which it breaks it is not there any more and they are, with the velocities of its "
    "parts (v + w x r); before that the share (sum - break_impulse) / (sum of that step) of what "
    "the step did to the velocities of the body and of all that touched it, gravity aside, is "
    "taken back"
)
"""Stands under `breaking` of the conventions of a manifest with bodies that break."""
POSTURES_CONVENTION = (
    "the postures of a body are bodies of this list, of which one at a time is there, at first "
    "the body itself; those that are not neither move nor touch; a ChangeBody fires once when "
    "time <= t + dt/2, in list order: into is there from then on, where its pose of this list lies "
    "in that of body, carried along with it, and with its velocities; with a position it rests "
    "where it is if body is there and faces heading [rad]; what later primitives ask of body "
    "is of the one that is there; recordings have body 0.4 mm above its place in the one that is "
    "there, the others in it, and name it in contacts"
)
"""Stands under `postures` of the conventions of a manifest whose bodies change theirs."""

Number = Annotated[float, Field(allow_inf_nan=False)]
Positive = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]
NonNegative = Annotated[float, Field(ge=0.0, allow_inf_nan=False)]
Fraction = Annotated[float, Field(ge=0.0, le=1.0, allow_inf_nan=False)]
Vec = tuple[Number, Number, Number]
Quat = tuple[Number, Number, Number, Number]
Name = Annotated[str, Field(min_length=1)]


class _Model(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class ShapeModel(_Model):
    """One collision shape in its body's frame [m]."""

    kind: ShapeKind
    size: tuple[NonNegative, NonNegative, NonNegative]
    position: Vec = (0.0, 0.0, 0.0)
    quaternion: Quat = (0.0, 0.0, 0.0, 1.0)
    vertices: tuple[Vec, ...] = Field((), description="Hull points of a convex shape")


class WheelModel(_Model):
    """A wheel of a body: a part of its mesh that turns about Y of the body frame."""

    name: Name
    axle: Vec
    radius: Positive


class ShineModel(_Model):
    """Parts of a body's mesh that shine, or flames on top of it (`part` is "flame")."""

    part: Name
    color: Vec
    before: bool = True
    after: bool = True
    event: str = Field("", description="At which it changes; empty: 0.6 s after the start")
    period_s: NonNegative = Field(0.0, description="Of its flashes [s]; 0: none")


class SwayModel(_Model):
    """Parts of a body's mesh that sway in the wind; all if none are named."""

    how: Literal["bends", "waves"]
    parts: tuple[str, ...] = ()
    degrees: NonNegative
    period_s: Positive


class GestureModel(_Model):
    """How arms, head or tail of a body's mesh move."""

    name: Name
    period_s: NonNegative = Field(description="To and fro [s]; 0: it is held")
    times: int = Field(ge=0, description="How often; 0: on and on")
    sweep_m: NonNegative
    rise_m: NonNegative
    begins: str = Field("", description="Event; empty: 0.6 s after the start")
    ends: str = Field("", description="Event; empty: never")


class GivesOffModel(_Model):
    """Smoke, steam, dust or sparks that leave a body."""

    name: Name
    begins: str = Field("", description="Event; empty: at the start")


class BodyModel(_Model):
    """One rigid body."""

    name: Name
    static: bool
    mass: NonNegative
    inertia: tuple[Vec, Vec, Vec]
    shapes: tuple[ShapeModel, ...]
    position: Vec
    quaternion: Quat = (0.0, 0.0, 0.0, 1.0)
    friction: NonNegative = 0.5
    restitution: Fraction = 0.2
    linear_damping: NonNegative = 0.0
    angular_damping: NonNegative = 0.0
    wheeled: bool = False
    tyre_friction: NonNegative = Field(
        0.0, description="Side friction of its tyres beyond that of its contacts; absent: 0"
    )
    tyre_drop: NonNegative = Field(
        0.0, description="How far below the centre of mass they push [m]; absent: 0"
    )
    tyre_foot: NonNegative = Field(
        0.0, description="From its middle to the edge that it falls over [m]; absent: 0"
    )
    roll_radius: NonNegative = 0.0
    origin_offset: Vec = (0.0, 0.0, 0.0)
    half_extents: tuple[NonNegative, NonNegative, NonNegative] = (0.5, 0.5, 0.5)
    mesh: str = ""
    category: str = ""
    label: str = ""
    description: str = ""
    color: Vec = (0.6, 0.6, 0.6)
    group: str = ""
    mentioned: bool = True
    active: bool = False
    wheels: tuple[WheelModel, ...] = Field((), description="Absent where there are none")
    break_impulse: Positive | None = Field(
        None, description="It breaks where it takes more [N s]; absent: never"
    )
    fragments: tuple[Name, ...] = Field((), description="What it breaks into; absent: it does not")
    postures: tuple[Name, ...] = Field(
        (), description="Bodies that it is in other postures; absent: it has one"
    )
    drawn: tuple[str, ...] = Field(
        (), description="Parts of its model, where it is stated what it wears; absent: it is not"
    )
    shines: tuple[ShineModel, ...] = Field((), description="Its lights; absent: it is not lit")
    sways: SwayModel | None = Field(None, description="In the wind; absent: it does not")
    gestures: tuple[GestureModel, ...] = Field((), description="That it makes; absent: none")
    gives_off: tuple[GivesOffModel, ...] = Field((), description="Plumes; absent: none")
    turned: Quat | None = Field(
        None, description="From its model as it is usually drawn to how it lies; absent: not at all"
    )

    @model_serializer(mode="wrap")
    def _without_what_it_lacks(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        # Bodies without wheels and tyres, and those that do not break, read as they always did.
        data = handler(self)
        for name in ("tyre_friction", "tyre_drop", "tyre_foot", "wheels", "break_impulse",
                     "fragments", "postures", "drawn", "shines", "sways", "gestures",
                     "gives_off", "turned"):  # fmt: skip
            if not data[name]:
                del data[name]
        return data


class RegionModel(_Model):
    """A box-shaped volume in its parent's body frame [m]."""

    name: Name
    parent: Name
    center: Vec
    half_extents: Vec
    kind: str = "area"


class MotorModel(_Model):
    """Drives a hinge or slider to a speed or, if given, a position; a null limit is infinite."""

    speed: Number = 0.0
    position: Number | None = None
    limit: NonNegative | None = None


class JointModel(_Model):
    """What holds two bodies together; see `joints` of the conventions."""

    name: Name
    kind: JointKind
    child: Name
    parent: str = Field("", description="Empty: the world")
    parent_anchor: Vec = (0.0, 0.0, 0.0)
    child_anchor: Vec = (0.0, 0.0, 0.0)
    parent_rotation: Quat = (0.0, 0.0, 0.0, 1.0)
    child_rotation: Quat = (0.0, 0.0, 0.0, 1.0)
    lower: Number | None = None
    upper: Number | None = None
    stiffness: NonNegative = 0.0
    damping: NonNegative = 0.0
    friction: NonNegative = 0.0
    motor: MotorModel | None = None
    break_impulse: Positive | None = None
    collide: bool = False


class SetVelocityModel(_Model):
    """Sets velocities at a time."""

    kind: Literal["SetVelocity"]
    body: Name
    time: Number
    linear: Vec
    angular: Vec | None = None


class ApplyImpulseModel(_Model):
    """Applies an impulse [N s] at the centre of mass."""

    kind: Literal["ApplyImpulse"]
    body: Name
    time: Number
    impulse: Vec


class AdjustPropertiesModel(_Model):
    """Changes damping [1/s], friction and brakes; null leaves a property as it is."""

    kind: Literal["AdjustProperties"]
    body: Name
    time: Number
    linear_damping: NonNegative | None = None
    angular_damping: NonNegative | None = None
    friction: NonNegative | None = None
    braking: NonNegative | None = Field(
        None, description="Deceleration by the brakes [m/s^2], 0 lets go; absent: it is kept"
    )

    @model_serializer(mode="wrap")
    def _without_none(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        # Programs without brakes read as they always did.
        data = handler(self)
        if data["braking"] is None:
            del data["braking"]
        return data


class DriveJointModel(_Model):
    """Gives a joint another motor, or none; a null limit is infinite."""

    kind: Literal["DriveJoint"]
    joint: Name
    time: Number
    speed: Number | None = None
    position: Number | None = None
    limit: NonNegative | None = None


class ChangeBodyModel(_Model):
    """Lets another body stand in for one; without a position where that is."""

    kind: Literal["ChangeBody"]
    body: Name
    time: Number
    into: Name
    position: Vec | None = None
    heading: Number = 0.0


class HoldVelocityModel(_Model):
    """Motion under own power; a null end is infinite."""

    kind: Literal["HoldVelocity"]
    body: Name
    start: Number
    end: Number | None
    speed: Number
    heading: Number
    acceleration: Number = 0.0
    max_speed: Number | None = 500.0
    turn_rate: Number = 0.0
    roll_radius: NonNegative = 0.0
    until_contact: tuple[Name, ...] = ()
    climb: Number | None = Field(
        None, description="Vertical velocity held against gravity [m/s]; absent: it is kept"
    )
    gains: NonNegative | None = Field(
        None, description="How fast it comes to a greater speed [m/s^2]; absent: at once"
    )
    loses: NonNegative | None = Field(
        None, description="How fast it comes to a lesser speed [m/s^2]; absent: at once"
    )

    @model_serializer(mode="wrap")
    def _without_none(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        # Programs without powered flight, and without what takes its time, read as they always did.
        data = handler(self)
        for name in ("climb", "gains", "loses"):
            if data[name] is None:
                del data[name]
        return data


class GuideAlongModel(_Model):
    """Motion along a path until it is let go."""

    kind: Literal["GuideAlong"]
    body: Name
    start: Number
    times: Annotated[tuple[NonNegative, ...], Field(min_length=2, max_length=MAX_KNOTS)]
    points: tuple[Vec, ...]
    velocities: tuple[Vec, ...]
    turn_rate: Number = 0.0
    until_contact: tuple[Name, ...] = ()


class HoldSpinModel(_Model):
    """A spin that is kept up; a null end is infinite."""

    kind: Literal["HoldSpin"]
    body: Name
    start: Number
    end: Number | None
    rate: Number
    axis: Vec = (0.0, 0.0, 1.0)
    until_contact: tuple[Name, ...] = ()


class BuoyUpModel(_Model):
    """A liquid that bears a body up; a null end is infinite."""

    kind: Literal["BuoyUp"]
    body: Name
    start: Number
    end: Number | None
    center: Vec
    basin: tuple[Positive, Positive, Positive]
    extents: tuple[Positive, Positive, Positive]
    lift: NonNegative
    linear_drag: NonNegative = 0.0
    quadratic_drag: NonNegative = 0.0
    turning_drag: NonNegative = 0.0
    heading: Number = 0.0
    round: bool = False


class ProgramModel(_Model):
    """The control program, primitives in order of execution."""

    version: Literal[1]
    duration: Positive
    primitives: tuple[
        Annotated[
            SetVelocityModel
            | ApplyImpulseModel
            | AdjustPropertiesModel
            | DriveJointModel
            | ChangeBodyModel
            | HoldVelocityModel
            | GuideAlongModel
            | HoldSpinModel
            | BuoyUpModel,
            Field(discriminator="kind"),
        ],
        ...,
    ]


class PairModel(_Model):
    """Effective material of a pair, after averaging."""

    a: Name
    b: Name
    friction: NonNegative
    restitution: Fraction


class GroundModel(_Model):
    """The half-space z <= 0 with its two materials."""

    friction: NonNegative
    vehicle_friction: NonNegative
    restitution: Fraction


class ManifestModel(_Model):
    """A physical scene with its control program, in SI units."""

    format: Literal["esg-manifest"]
    version: Literal[1]
    scene_id: str
    conventions: dict[str, str]
    dt: Positive = Field(description="Physics step of the reference replay [s]")
    gravity: Vec
    ground: GroundModel
    bodies: tuple[BodyModel, ...]
    regions: tuple[RegionModel, ...]
    joints: tuple[JointModel, ...] = Field((), description="Absent where there are none")
    weather: tuple[str, ...] = Field((), description="That is drawn; absent: none")
    program: ProgramModel
    watch: tuple[tuple[Name, Name], ...] = Field(description="Pairs whose contacts matter")
    effective_pairs: tuple[PairModel, ...]
    extra: dict[str, Any] = {}

    @model_serializer(mode="wrap")
    def _without_what_it_lacks(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        # Scenes without joints and weather read as they always did.
        data = handler(self)
        for name in ("joints", "weather"):
            if not data[name]:
                del data[name]
        return data


def manifest_schema() -> dict[str, Any]:
    """JSON Schema of the manifest (the content of schemas/manifest.schema.json)."""
    schema = ManifestModel.model_json_schema(mode="validation")
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


def dangling(data: dict[str, Any]) -> list[str]:
    """Names that refer to no body, with their JSON pointers."""
    names = [b["name"] for b in data["bodies"]]
    known = set(names)
    out = [
        f"/bodies/{i}/name: {n!r} is reserved or used twice"
        for i, n in enumerate(names)
        if n == GROUND or n in names[:i]
    ]
    for i, body in enumerate(data["bodies"]):
        wheels = [wheel["name"] for wheel in body.get("wheels", ())]
        out += [
            f"/bodies/{i}/wheels/{k}/name: {n!r} is used twice"
            for k, n in enumerate(wheels)
            if n in wheels[:k]
        ]
    uses = [(f"/regions/{i}/parent", r["parent"]) for i, r in enumerate(data["regions"])]
    for i, p in enumerate(data["program"]["primitives"]):
        if p["kind"] == "DriveJoint":
            continue
        uses.append((f"/program/primitives/{i}/body", p["body"]))
        if p["kind"] == "ChangeBody":
            uses.append((f"/program/primitives/{i}/into", p["into"]))
        until = p.get("until_contact", ())
        uses += [(f"/program/primitives/{i}/until_contact/{k}", n) for k, n in enumerate(until)]
    for i, pair in enumerate(data["watch"]):
        uses += [(f"/watch/{i}/{k}", n) for k, n in enumerate(pair) if n != GROUND]
    joints = [j["name"] for j in data.get("joints", ())]
    out += [
        f"/program/primitives/{i}/joint: no joint {p['joint']!r}; joints are {joints}"
        for i, p in enumerate(data["program"]["primitives"])
        if p["kind"] == "DriveJoint" and p["joint"] not in joints
    ]
    return out + [
        f"{pointer}: no body {name!r}; bodies are {sorted(known)}"
        for pointer, name in uses
        if name not in known
    ]


def complaints(error: ValidationError) -> list[str]:
    """Every mistake of a file, with its JSON pointer and the value found."""
    out = []
    for item in error.errors(include_url=False):
        pointer = "".join(f"/{part}" for part in item["loc"]) or "/"
        value = item["input"]
        shown = "" if isinstance(value, (dict, list)) else f", got {value!r}"
        out.append(f"{pointer}: {item['msg']}{shown}")
    return out
