"""`manifest.json`: a whole physical scene with its control program, for any engine to replay.

The file is self-contained: SI units, right-handed frame with Z up, quaternions (x, y, z, w), every
value explicit. `conventions` states in words what numbers alone cannot: how materials combine, how
damping is applied, which ground a body touches and how the program is executed. The schema is
`schemas/manifest.schema.json`, generated from the models below.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
import json
import math
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from esg.engines.program import PROGRAM_VERSION, Program, program_from_json, program_to_json
from esg.engines.scene import GROUND, Body, Region, Shape, ShapeKind, SimScene
from esg.outcomes import UserError

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


class RegionModel(_Model):
    """A box-shaped volume in its parent's body frame [m]."""

    name: Name
    parent: Name
    center: Vec
    half_extents: Vec
    kind: str = "area"


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
    """Changes damping [1/s] and friction; null leaves a property as it is."""

    kind: Literal["AdjustProperties"]
    body: Name
    time: Number
    linear_damping: NonNegative | None = None
    angular_damping: NonNegative | None = None
    friction: NonNegative | None = None


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


class ProgramModel(_Model):
    """The control program, primitives in order of execution."""

    version: Literal[1]
    duration: Positive
    primitives: tuple[
        Annotated[
            SetVelocityModel | ApplyImpulseModel | AdjustPropertiesModel | HoldVelocityModel,
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
    program: ProgramModel
    watch: tuple[tuple[Name, Name], ...] = Field(description="Pairs whose contacts matter")
    effective_pairs: tuple[PairModel, ...]
    extra: dict[str, Any] = {}


@dataclass(frozen=True)
class Manifest:
    """A loaded manifest.

    Args:
        scene: Bodies, regions, materials.
        program: Control program.
        watch: Pairs of body names whose contacts matter.
        dt: Physics step of the reference replay [s].
        extra: Whatever the writer added.
    """

    scene: SimScene
    program: Program
    watch: tuple[tuple[str, str], ...]
    dt: float
    extra: dict[str, Any] = field(default_factory=dict)


def manifest_to_json(
    scene: SimScene,
    program: Program,
    *,
    watch: Iterable[tuple[str, str]] = (),
    dt: float,
    extra: dict[str, Any] | None = None,
) -> dict[str, Any]:
    """The manifest as plain JSON values.

    Args:
        scene: Physical scene.
        program: Control program.
        watch: Pairs of body names (or "ground") whose contacts matter.
        dt: Physics step of the reference replay [s].
        extra: JSON values to carry along.

    Raises:
        ValueError: If the scene cannot be written, with every reason.
    """
    pairs = tuple((a, b) for a, b in watch)
    data = {
        "format": MANIFEST_FORMAT,
        "version": MANIFEST_VERSION,
        "scene_id": scene.scene_id,
        "conventions": CONVENTIONS,
        "dt": dt,
        "gravity": list(scene.gravity),
        "ground": {
            "friction": scene.ground_friction,
            "vehicle_friction": scene.vehicle_ground_friction,
            "restitution": scene.ground_restitution,
        },
        "bodies": [_plain(b) for b in scene.bodies],
        "regions": [_plain(r) for r in scene.regions],
        "program": program_to_json(program),
        "watch": [list(p) for p in pairs],
        "effective_pairs": _effective_pairs(scene, pairs),
        "extra": extra or {},
    }
    try:
        # Dumping the model makes every number of a kind the same type: 0 and 0.0 give equal bytes.
        data = ManifestModel.model_validate(data).model_dump(mode="json")
    except ValidationError as error:
        raise ValueError("; ".join(_complaints(error))) from None
    problems = _dangling(data)
    if problems:
        raise ValueError("; ".join(problems))
    return data


def manifest_from_json(data: Any) -> Manifest:
    """Reads what `manifest_to_json` wrote.

    Raises:
        UserError: Listing everything that is wrong, each with its JSON pointer.
    """
    if isinstance(data, dict) and data.get("format") != MANIFEST_FORMAT:
        raise UserError(f"/format is {data.get('format')!r}, expected {MANIFEST_FORMAT!r}")
    if isinstance(data, dict) and data.get("version") != MANIFEST_VERSION:
        raise UserError(
            f"/version is {data.get('version')!r}; this software reads version {MANIFEST_VERSION}"
        )
    try:
        model = ManifestModel.model_validate(data)
    except ValidationError as error:
        raise UserError("not a valid manifest:\n" + "\n".join(_complaints(error))) from None
    problems = _dangling(data)
    if problems:
        raise UserError("not a valid manifest:\n" + "\n".join(problems))
    scene = SimScene(
        scene_id=model.scene_id,
        bodies=tuple(_body(b) for b in model.bodies),
        regions=tuple(Region(**_fields(r)) for r in model.regions),
        gravity=model.gravity,
        ground_friction=model.ground.friction,
        ground_restitution=model.ground.restitution,
        vehicle_ground_friction=model.ground.vehicle_friction,
    )
    primitives = []
    for p in model.program.primitives:
        item = _fields(p)
        if isinstance(p, HoldVelocityModel) and p.max_speed is None:
            item["max_speed"] = math.inf
        primitives.append(item)
    program = program_from_json(
        {"version": PROGRAM_VERSION, "duration": model.program.duration, "primitives": primitives}
    )
    return Manifest(scene, program, model.watch, model.dt, dict(model.extra))


def manifest_bytes(data: dict[str, Any]) -> bytes:
    """Canonical bytes: sorted keys, two spaces, shortest round-trip floats, final newline."""
    text = json.dumps(data, sort_keys=True, indent=2, ensure_ascii=False, allow_nan=False)
    return (text + "\n").encode()


def load_manifest(path: str | Path) -> Manifest:
    """Reads a manifest file.

    Raises:
        UserError: If the file cannot be read, is not JSON or breaks the schema.
    """
    path = Path(path)
    try:
        data = json.loads(path.read_bytes())
    except OSError as error:
        raise UserError(f"cannot read {path}: {error.strerror or error}") from None
    except ValueError as error:
        raise UserError(f"{path} is not JSON: {error}") from None
    try:
        return manifest_from_json(data)
    except UserError as error:
        raise UserError(f"{path}: {error}") from None


def manifest_schema() -> dict[str, Any]:
    """JSON Schema of the manifest (the content of schemas/manifest.schema.json)."""
    schema = ManifestModel.model_json_schema(mode="validation")
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


def _effective_pairs(
    scene: SimScene, watch: tuple[tuple[str, str], ...]
) -> list[dict[str, str | float]]:
    known = {b.name: b for b in scene.bodies}
    pairs = [(b.name, GROUND) for b in scene.bodies if b.collides and not b.static]
    pairs += [p for p in watch if p not in pairs]
    out: list[dict[str, str | float]] = []
    for a, b in pairs:
        materials = []
        for name, other in ((a, b), (b, a)):
            if name == GROUND:
                wheeled = other in known and known[other].wheeled
                mu = scene.vehicle_ground_friction if wheeled else scene.ground_friction
                materials.append((mu, scene.ground_restitution))
            elif name in known:
                materials.append((known[name].friction, known[name].restitution))
        if len(materials) == 2:
            (mu_a, e_a), (mu_b, e_b) = materials
            friction, restitution = 0.5 * (mu_a + mu_b), 0.5 * (e_a + e_b)
            out.append({"a": a, "b": b, "friction": friction, "restitution": restitution})
    return out


def _dangling(data: dict[str, Any]) -> list[str]:
    """Names that refer to no body, with their JSON pointers."""
    names = [b["name"] for b in data["bodies"]]
    known = set(names)
    out = [
        f"/bodies/{i}/name: {n!r} is reserved or used twice"
        for i, n in enumerate(names)
        if n == GROUND or n in names[:i]
    ]
    uses = [(f"/regions/{i}/parent", r["parent"]) for i, r in enumerate(data["regions"])]
    for i, p in enumerate(data["program"]["primitives"]):
        uses.append((f"/program/primitives/{i}/body", p["body"]))
        until = p.get("until_contact", ())
        uses += [(f"/program/primitives/{i}/until_contact/{k}", n) for k, n in enumerate(until)]
    for i, pair in enumerate(data["watch"]):
        uses += [(f"/watch/{i}/{k}", n) for k, n in enumerate(pair) if n != GROUND]
    return out + [
        f"{pointer}: no body {name!r}; bodies are {sorted(known)}"
        for pointer, name in uses
        if name not in known
    ]


def _body(model: BodyModel) -> Body:
    values = _fields(model)
    values["shapes"] = tuple(Shape(**_fields(s)) for s in model.shapes)
    return Body(**values)


def _fields(model: BaseModel) -> dict[str, Any]:
    return {name: getattr(model, name) for name in type(model).model_fields}


def _plain(value: Any) -> Any:
    if isinstance(value, (tuple, list)):
        return [_plain(v) for v in value]
    if hasattr(value, "__dataclass_fields__"):
        return {name: _plain(getattr(value, name)) for name in value.__dataclass_fields__}
    return value


def _complaints(error: ValidationError) -> list[str]:
    out = []
    for item in error.errors(include_url=False):
        pointer = "".join(f"/{part}" for part in item["loc"]) or "/"
        value = item["input"]
        shown = "" if isinstance(value, (dict, list)) else f", got {value!r}"
        out.append(f"{pointer}: {item['msg']}{shown}")
    return out
