"""`manifest.json`: a whole physical scene with its control program, for any engine to replay.

The file is self-contained: SI units, right-handed frame with Z up, quaternions (x, y, z, w), every
value explicit. `conventions` states in words what numbers alone cannot: how materials combine, how
damping is applied, which ground a body touches and how the program is executed. The schema is
`schemas/manifest.schema.json`, generated from `esg.engines.manifest_model`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
import json
import math
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ValidationError

from esg.engines.breaking import breaking_problems
from esg.engines.breaking.stances import stance_problems
from esg.engines.joints import Joint, Motor, joint_problems
from esg.engines.manifest_model import (
    BRAKING_CONVENTION,
    BREAKING_CONVENTION,
    BUOY_CONVENTION,
    CLIMB_CONVENTION,
    CONVENTIONS,
    DRIVE_CONVENTION,
    GAINS_CONVENTION,
    GUIDE_CONVENTION,
    JOINTS_CONVENTION,
    MANIFEST_FORMAT,
    MANIFEST_VERSION,
    POSTURES_CONVENTION,
    SPIN_CONVENTION,
    TYRES_CONVENTION,
    WHEELS_CONVENTION,
    BodyModel,
    HoldVelocityModel,
    JointModel,
    ManifestModel,
    complaints,
    dangling,
)
from esg.engines.program import (
    PROGRAM_VERSION,
    AdjustProperties,
    BuoyUp,
    DriveJoint,
    GuideAlong,
    HoldSpin,
    HoldVelocity,
    Program,
    program_from_json,
    program_to_json,
)
from esg.engines.scene import GROUND, Body, Gesture, GivesOff, Region, Shape, Shine, SimScene, Wheel
from esg.lexicon.shown import Sway
from esg.outcomes import UserError


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
        "conventions": CONVENTIONS | _special_conventions(scene, program),
        "dt": dt,
        "gravity": list(scene.gravity),
        "ground": {
            "friction": scene.ground_friction,
            "vehicle_friction": scene.vehicle_ground_friction,
            "restitution": scene.ground_restitution,
        },
        "bodies": [_plain(b) for b in scene.bodies],
        "regions": [_plain(r) for r in scene.regions],
        "joints": [_joint_json(j) for j in scene.joints],
        "weather": list(scene.weather),
        "program": program_to_json(program),
        "watch": [list(p) for p in pairs],
        "effective_pairs": _effective_pairs(scene, pairs),
        "extra": extra or {},
    }
    try:
        # Dumping the model makes every number of a kind the same type: 0 and 0.0 give equal bytes.
        data = ManifestModel.model_validate(data).model_dump(mode="json")
    except ValidationError as error:
        raise ValueError("; ".join(complaints(error))) from None
    problems = (
        dangling(data) + joint_problems(scene) + breaking_problems(scene) + stance_problems(scene)
    )
    if problems:
        raise ValueError("; ".join(problems))
    return data


def carried_json(manifest: Manifest) -> dict[str, Any]:
    """The manifest for a file that carries it along: without what others added to it."""
    return manifest_to_json(manifest.scene, manifest.program, watch=manifest.watch, dt=manifest.dt)


def _special_conventions(scene: SimScene, program: Program) -> dict[str, str]:
    """What has to be said beyond the usual; other manifests read as they always did."""
    out: dict[str, str] = {}
    if any(b.tyre_friction > 0.0 for b in scene.bodies):
        out["tyres"] = TYRES_CONVENTION
    if any(b.wheels for b in scene.bodies):
        out["wheels"] = WHEELS_CONVENTION
    if scene.joints:
        out["joints"] = JOINTS_CONVENTION
    if any(b.fragments for b in scene.bodies):
        out["breaking"] = BREAKING_CONVENTION
    if any(b.postures for b in scene.bodies):
        out["postures"] = POSTURES_CONVENTION
    for p in program.primitives:
        if isinstance(p, HoldVelocity) and p.climb is not None:
            out["climb"] = CLIMB_CONVENTION
        if isinstance(p, HoldVelocity) and p.gains is not None:
            out["gains"] = GAINS_CONVENTION
        elif isinstance(p, GuideAlong):
            out["guide"] = GUIDE_CONVENTION
        elif isinstance(p, HoldSpin):
            out["spin"] = SPIN_CONVENTION
        elif isinstance(p, BuoyUp):
            out["buoy"] = BUOY_CONVENTION
        elif isinstance(p, DriveJoint):
            out["drive"] = DRIVE_CONVENTION
        elif isinstance(p, AdjustProperties) and p.braking is not None:
            out["braking"] = BRAKING_CONVENTION
    return out


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
        raise UserError("not a valid manifest:\n" + "\n".join(complaints(error))) from None
    problems = dangling(data)
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
        weather=model.weather,
        joints=tuple(_joint(j) for j in model.joints),
    )
    if problems := joint_problems(scene) + breaking_problems(scene) + stance_problems(scene):
        raise UserError("not a valid manifest:\n" + "\n".join(problems))
    primitives = []
    for p in model.program.primitives:
        item = _fields(p)
        if isinstance(p, HoldVelocityModel) and p.max_speed is None:
            item["max_speed"] = math.inf
        primitives.append(item)
    plain = {"version": PROGRAM_VERSION, "duration": model.program.duration}
    try:
        program = program_from_json(plain | {"primitives": primitives})
    except ValueError as error:
        raise UserError(f"not a valid manifest:\n/program: {error}") from None
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
    except (ValueError, RecursionError) as error:
        raise UserError(f"{path} is not JSON: {error}") from None
    try:
        return manifest_from_json(data)
    except UserError as error:
        raise UserError(f"{path}: {error}") from None


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


def _body(model: BodyModel) -> Body:
    values = _fields(model)
    values["shapes"] = tuple(Shape(**_fields(s)) for s in model.shapes)
    values["wheels"] = tuple(Wheel(**_fields(w)) for w in model.wheels)
    values["shines"] = tuple(Shine(**_fields(s)) for s in model.shines)
    values["gives_off"] = tuple(GivesOff(**_fields(g)) for g in model.gives_off)
    values["gestures"] = tuple(Gesture(**_fields(g)) for g in model.gestures)
    values["sways"] = None if model.sways is None else Sway(**_fields(model.sways))
    return Body(**values)


def _joint(model: JointModel) -> Joint:
    values = _fields(model)
    if model.motor is not None:
        motor = _fields(model.motor)
        if motor["limit"] is None:
            motor["limit"] = math.inf
        values["motor"] = Motor(**motor)
    return Joint(**values)


def _joint_json(joint: Joint) -> dict[str, Any]:
    data = _plain(joint)
    if data["motor"] and math.isinf(data["motor"]["limit"]):
        data["motor"]["limit"] = None
    return data


def _fields(model: BaseModel) -> dict[str, Any]:
    return {name: getattr(model, name) for name in type(model).model_fields}


def _plain(value: Any) -> Any:
    if isinstance(value, (tuple, list)):
        return [_plain(v) for v in value]
    if hasattr(value, "__dataclass_fields__"):
        return {name: _plain(getattr(value, name)) for name in value.__dataclass_fields__}
    return value
