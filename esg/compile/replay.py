"""Runs a compiled class in PhysX 5: the artifact itself is executed, not a parallel description.

The physical world is built from what the class says through the shim (poses, masses, mass frames,
damping, materials, collision types) and from the collision of the assets it names; the scene's
manifest contributes nothing but the order of the bodies. This is PhysX under a stand-in for
Unreal's API, not Unreal: Chaos, its solver and its asset import are not exercised.
"""

from __future__ import annotations

from collections.abc import Callable
import ctypes as C
from dataclasses import dataclass
import json
import math
from pathlib import Path
from typing import Any, Literal

import numpy as np

from esg.compile import build, frames
from esg.compile.emit import IMPORTS_FORMAT, IMPORTS_VERSION
from esg.compile.penetration import PenetrationProbe
from esg.engines.base import VERIFY_DT_S
from esg.engines.executor import BodyAccess, play
from esg.engines.scene import GROUND, Body, Rollout, Shape, SimScene
from esg.engines.worlds import ContactRecorder, Frames, Values, rest_states, world_values
from esg.outcomes import UserError
from esg.units import quat_rotate

CUBE_ASSET = "/Engine/BasicShapes/Cube.Cube"
CUBE_HALF_CM = 50.0
GROUND_HALF_MIN_CM = 10000.0
"""A static cube at least this wide with its top at height 0 is played as the half-space z <= 0,
whose contacts do not suffer from the size of the cube in single precision."""

RECOVERED_DIGITS = 12
"""Decimals [m] kept of values that come back from Unreal's units: the text has 15 significant
digits, so anything below is rounding, which would turn an exact 0 into 1e-17."""

_ECC_WORLD_STATIC, _ECC_PHYSICS_BODY, _ECC_VEHICLE = 0, 5, 6
_BOX, _SPHERE, _CAPSULE = 0, 1, 2


class ReplayError(RuntimeError):
    """The class asks for something that Unreal would refuse or that the replay cannot play."""


@dataclass(frozen=True)
class ClassReplay:
    """What a class did when it was run.

    Args:
        rollout: Same structure as an engine's, bodies in the order of the scene.
        log: What the class wrote with UE_LOG, `Verbosity: text`.
        compile_seconds: Time spent compiling, 0 from the cache.
        scene: The physical scene the class described.
        proof: Always `class`: the emitted class was executed.
    """

    rollout: Rollout
    log: list[str]
    compile_seconds: float
    scene: SimScene
    proof: Literal["class"] = "class"

    def events(self) -> list[dict[str, str]]:
        """The log's EVENT lines as dictionaries; `event` holds EVENT_HIT or EVENT_CHECK."""
        out: list[dict[str, str]] = []
        for line in self.log:
            text = line.split(": ", 1)[1]
            if text.startswith("EVENT_"):
                head, *pairs = text.split(" ")
                out.append({"event": head, **dict(p.split("=", 1) for p in pairs if "=" in p)})
        return out


def replay_class(
    folder: str | Path,
    *,
    dt: float = VERIFY_DT_S,
    duration: float | None = None,
    record_every: int = 1,
    ground_contacts: bool = False,
    engine: Literal["physx", "rapier"] = "physx",
) -> ClassReplay:
    """Compiles (or finds) the class of a scene folder and runs it in PhysX.

    Args:
        folder: Scene folder with `unreal/` in it.
        dt: Physics step [s].
        duration: [s]; default the scene's own.
        record_every: Steps per recorded frame.
        ground_contacts: Whether the contact log includes the ground.
        engine: Which physics runs under the shim.

    Raises:
        CompilerMissing: Without g++: replay the program instead.
        ClassError: If the class breaks a rule or does not compile.
        ReplayError: If the running class does what Unreal would refuse.
        UserError: If the folder holds no class or a broken import manifest.
    """
    folder = Path(folder)
    try:
        files = build.ClassFiles.read(folder)
    except OSError as error:
        raise UserError(f"{folder}: no compiled scene: {error}") from None
    library = build.compile_class(files)
    imports = load_imports(folder / "unreal" / "imports.json")
    if duration is None:
        duration = scene_duration(files.header)
    run = _Run(library, imports)
    try:
        rollout = run.play(engine, Frames.of(duration, dt, record_every), ground_contacts)
    finally:
        run.close()
    return ClassReplay(rollout, run.log, library.seconds, run.scene)


def load_imports(path: Path) -> dict[str, Any]:
    """Reads an import manifest.

    Raises:
        UserError: If it is missing, no JSON or of another format.
    """
    try:
        data = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError) as error:
        raise UserError(f"{path}: cannot read the import manifest: {error}") from None
    if data.get("format") != IMPORTS_FORMAT or data.get("version") != IMPORTS_VERSION:
        raise UserError(f"{path}: /format is not {IMPORTS_FORMAT!r} version {IMPORTS_VERSION}")
    return data


def scene_duration(header: str) -> float:
    """The default of the class's SceneDuration property [s]."""
    import re

    found = re.search(r"double SceneDuration = ([0-9.e+-]+);", header)
    if not found:
        raise ReplayError("the class has no SceneDuration")
    return float(found.group(1))


class _BodyRecord(C.Structure):
    _fields_ = [
        ("name", C.c_char_p),
        ("asset", C.c_char_p),
        ("location", C.c_double * 3),
        ("rotation", C.c_double * 4),
        ("scale", C.c_double * 3),
        ("center_of_mass", C.c_double * 3),
        ("mass_rotation", C.c_double * 4),
        ("inertia", C.c_double * 3),
        ("mass", C.c_double),
        ("linear_damping", C.c_double),
        ("angular_damping", C.c_double),
        ("friction", C.c_double),
        ("restitution", C.c_double),
        ("max_spin", C.c_double),
        ("collides", C.c_int),
        ("simulates", C.c_int),
        ("object_type", C.c_int),
        ("blocks", C.c_uint32),
        ("notifies", C.c_int),
        ("ccd", C.c_int),
        ("has_mass_frame", C.c_int),
        ("has_material", C.c_int),
        ("movable", C.c_int),
    ]


_D = C.POINTER(C.c_double)
_CALLBACKS = {
    "asset": C.CFUNCTYPE(C.c_int, C.c_char_p, _D),
    "log": C.CFUNCTYPE(None, C.c_char_p, C.c_char_p, C.c_char_p),
    "get_pose": C.CFUNCTYPE(None, C.c_int, _D, _D),
    "get_velocity": C.CFUNCTYPE(None, C.c_int, _D, _D),
    "set_velocity": C.CFUNCTYPE(None, C.c_int, _D),
    "set_spin": C.CFUNCTYPE(None, C.c_int, _D),
    "impulse": C.CFUNCTYPE(None, C.c_int, _D),
    "set_damping": C.CFUNCTYPE(None, C.c_int, C.c_double, C.c_double),
    "set_material": C.CFUNCTYPE(None, C.c_int, C.c_double, C.c_double),
    "penetration": C.CFUNCTYPE(C.c_double, C.c_int, C.c_int, _D, _D, _D),
}


class _Backend(C.Structure):
    _fields_ = list(_CALLBACKS.items())


class _Run:
    """One life of one class: construct, begin play, tick, destroy."""

    def __init__(self, library: build.Library, imports: dict[str, Any]) -> None:
        self._name = str(imports["class"])
        self._dll = C.CDLL(str(library.path))
        self._library = library
        self._assets = {a["path"]: a for a in imports["assets"]}
        self._components = imports["components"]
        self.log: list[str] = []
        self.scene: SimScene
        self._error: BaseException | None = None
        self._world: Any = None
        self._probe = PenetrationProbe()
        self._records: list[_BodyRecord] = []
        self._shapes: dict[int, tuple[Shape, ...]] = {}
        self._offset: dict[int, np.ndarray] = {}
        self._body_of: dict[int, int] = {}
        self._component_of: dict[int, int] = {}
        self._plane: dict[bool, int] = {}
        self._backend = _Backend()
        self._keep: list[Any] = []
        for name, kind in _CALLBACKS.items():
            callback = kind(self._guarded(getattr(self, f"_{name}"), name))
            self._keep.append(callback)
            setattr(self._backend, name, callback)

    # Host functions --------------------------------------------------------------------------

    def _guarded(self, function: Callable[..., Any], name: str) -> Callable[..., Any]:
        """An exception must not cross the C frames below: keep it and raise it after the call."""
        returns = _CALLBACKS[name]._restype_ is not None  # type: ignore[attr-defined]

        def call(*args: Any) -> Any:
            try:
                result = function(*args)
            except Exception as error:
                self._error = self._error or error
                return 0 if returns else None
            return result if returns else None

        return call

    def _asset(self, path: bytes, bounds: Any) -> int:
        name = path.decode()
        if name == CUBE_ASSET:
            half, center = (CUBE_HALF_CM,) * 3, (0.0, 0.0, 0.0)
        elif name in self._assets:
            half = tuple(self._assets[name]["half_extents_cm"])
            center = (0.0, 0.0, half[2])
            for shape in self._assets[name]["collision"]:
                half, center = _grow(half, center, shape)
        else:
            return 0
        _fill(bounds, [*half, *center])
        return 1

    def _log(self, category: bytes, verbosity: bytes, text: bytes) -> None:
        self.log.append(f"{verbosity.decode()}: {text.decode(errors='replace')}")

    def _get_pose(self, component: int, location: Any, rotation: Any) -> None:
        position, quaternion = self._origin_pose(component)
        _fill(location, frames.vector_to_unreal(position))
        _fill(rotation, frames.quaternion_to_unreal(quaternion))

    def _origin_pose(self, component: int) -> tuple[np.ndarray, np.ndarray]:
        position, rotation, _, _ = self._world.read(self._body_of[component])
        quaternion = np.array([float(v) for v in rotation])
        return np.array(position, float) + quat_rotate(
            quaternion, self._offset[component]
        ), quaternion

    def _get_velocity(self, component: int, linear: Any, angular: Any) -> None:
        _, _, velocity, spin = self._world.read(self._body_of[component])
        _fill(linear, frames.vector_to_unreal(velocity))
        _fill(angular, frames.angular_to_unreal(spin))

    def _set_velocity(self, component: int, linear: Any) -> None:
        v = frames.vector_from_unreal(linear[0:3])
        self._world.set_linear(self._body_of[component], tuple(v.tolist()))

    def _set_spin(self, component: int, angular: Any) -> None:
        w = frames.angular_from_unreal(angular[0:3])
        self._world.set_angular(self._body_of[component], tuple(w.tolist()))

    def _impulse(self, component: int, impulse: Any) -> None:
        body = self._body_of[component]
        j = frames.vector_from_unreal(impulse[0:3]) / self._world.mass(body)
        v = np.array(self._world.linear(body)) + j
        self._world.set_linear(body, tuple(v.tolist()))

    def _set_damping(self, component: int, linear: float, angular: float) -> None:
        self._world.set_linear_damping(self._body_of[component], linear)
        self._world.set_angular_damping(self._body_of[component], angular)

    def _set_material(self, component: int, friction: float, restitution: float) -> None:
        body = self._body_of.get(component)
        if body is None:
            raise ReplayError("the ground's material changes during play, which is not replayed")
        if abs(restitution - self.scene.bodies[body].restitution) > 1e-6:
            raise ReplayError("a restitution changes during play, which is not replayed")
        self._world.set_friction(body, friction)

    def _penetration(
        self, component: int, kind: int, size: Any, location: Any, rotation: Any
    ) -> float:
        if component not in self._shapes:
            return 0.0
        scale = 1.0 / frames.CM_PER_M
        probe = Shape(
            kind={_BOX: "box", _SPHERE: "sphere", _CAPSULE: "capsule"}[kind],  # type: ignore[arg-type]
            size=(size[0] * scale, size[1] * scale, size[2] * scale),
        )
        where = (
            frames.vector_from_unreal(location[0:3]),
            frames.quaternion_to_unreal(rotation[0:4]),
        )
        record = self._records[component]
        if self._world is not None and record.simulates:
            pose = self._origin_pose(component)
        else:
            pose = _record_pose(record)
        depth = self._probe.depth(component, self._shapes[component], pose, probe, where)
        return depth * frames.CM_PER_M

    # Life of the class -----------------------------------------------------------------------

    def _entry(self, name: str, restype: Any = C.c_int, *argtypes: Any) -> Any:
        function = getattr(self._dll, f"esg_{name}")
        function.restype, function.argtypes = restype, list(argtypes)
        return function

    def _check(self, failed: int) -> None:
        if self._error is not None:
            raise self._error
        if failed:
            raise ReplayError(self._entry("error", C.c_char_p)().decode())

    def play(self, engine: str, grid: Frames, ground: bool) -> Rollout:
        """Runs the class from construction to the end of the scene."""
        construct = self._entry("construct", C.c_int, C.POINTER(_Backend), C.c_void_p)
        create = C.cast(getattr(self._dll, self._library.create), C.c_void_p)
        self._check(construct(C.byref(self._backend), create))
        self._describe()
        self._load_shapes()
        self._check(self._entry("begin_play")())
        self._describe()
        self.scene = self._described_scene()
        values = world_values(self.scene, None, 1)
        if engine == "physx":
            from esg.engines import physx_engine

            with physx_engine._scene_config(physx_engine.physx_module(), self.scene):
                self._world = physx_engine.PhysxWorld(self.scene, values, 0, grid.dt)
                return self._simulate(engine, values, grid, ground)
        import rapier3d

        from esg.engines.rapier_engine import RapierWorld

        self._world = RapierWorld(rapier3d, self.scene, values, 0, grid.dt)
        return self._simulate(engine, values, grid, ground)

    def _describe(self) -> None:
        describe = self._entry("describe", C.c_int, C.c_int, C.POINTER(_BodyRecord))
        self._records = []
        for i in range(self._entry("body_count")()):
            record = _BodyRecord()
            self._check(describe(i, C.byref(record)))
            self._records.append(record)

    def _load_shapes(self) -> None:
        for i, record in enumerate(self._records):
            asset = self._assets.get(record.asset.decode())
            if asset is not None and record.collides:
                self._shapes[i] = tuple(_shape(p) for p in asset["collision"])

    def _described_scene(self) -> SimScene:
        bodies: dict[int, Body] = {}
        grounds: dict[bool, _BodyRecord] = {}
        for i, record in enumerate(self._records):
            name = record.name.decode()
            if record.asset.decode() == CUBE_ASSET:
                for_wheels = _ground_kind(record)
                if for_wheels in grounds:
                    raise ReplayError(f"{name} is a second ground of the same kind")
                grounds[for_wheels], self._plane[for_wheels] = record, i
                continue
            if name not in self._components:
                raise ReplayError(f"component {name} is not in the import manifest")
            entry = self._components[name]
            self._body_of[i], self._component_of[entry["index"]] = entry["index"], i
            bodies[entry["index"]] = self._body(i, record, entry)
        missing = sorted(set(range(len(self._components))) - set(bodies))
        if missing or set(grounds) != {False, True}:
            raise ReplayError(f"the class lacks bodies {missing} or one of its two grounds")
        normal, wheels = grounds[False], grounds[True]
        if normal.restitution != wheels.restitution:
            raise ReplayError("the two grounds differ in restitution")
        gravity = self._entry("gravity", C.c_double)()
        return SimScene(
            scene_id=self._name,
            bodies=tuple(bodies[i] for i in range(len(bodies))),
            gravity=(0.0, 0.0, gravity / frames.CM_PER_M),
            ground_friction=normal.friction,
            ground_restitution=normal.restitution,
            vehicle_ground_friction=wheels.friction,
        )

    def _body(self, component: int, record: _BodyRecord, entry: dict[str, Any]) -> Body:
        name = entry["body"]
        # Only moving bodies state a centre of mass; the others keep the point their poses refer to.
        followed = record.center_of_mass if record.simulates else entry["center_of_mass_cm"]
        offset = -frames.vector_from_unreal(followed[0:3])
        self._offset[component] = offset
        origin, quaternion = _record_pose(record)
        position = origin - quat_rotate(quaternion, offset)
        if tuple(record.scale) != (1.0, 1.0, 1.0):
            raise ReplayError(f"{name} is scaled, which its mass properties do not follow")
        shapes = tuple(
            Shape(s.kind, s.size, _snapped(np.array(s.position) + offset), s.quaternion,
                  s.vertices)  # type: ignore[arg-type]
            for s in self._shapes.get(component, ())
        )  # fmt: skip
        if record.collides and not shapes:
            raise ReplayError(f"{name} should collide, but its asset has no collision shapes")
        wheeled = _wheeled(record, name)
        return Body(
            name=name,
            static=not record.simulates,
            mass=record.mass if record.simulates else 0.0,
            inertia=_inertia(record),
            shapes=shapes,
            position=_snapped(position),
            quaternion=tuple(quaternion.tolist()),  # type: ignore[arg-type]
            friction=record.friction,
            restitution=record.restitution,
            linear_damping=record.linear_damping if record.simulates else 0.0,
            angular_damping=record.angular_damping if record.simulates else 0.0,
            wheeled=wheeled,
            origin_offset=tuple(offset.tolist()),  # type: ignore[arg-type]
        )

    def _simulate(self, engine: str, values: Values, grid: Frames, ground: bool) -> Rollout:
        states = rest_states(values, grid)
        self._entry("live", None)()
        recorder = ContactRecorder(0, grid)
        driver: Any = _Driver(self)
        valid = play(self._world, driver, grid, states, recorder, ground)
        self._check(0)
        return Rollout(
            engine=engine,
            dt=grid.dt,
            time=grid.time,
            position=states[0],
            quaternion=states[1],
            linear_velocity=states[2],
            angular_velocity=states[3],
            contacts=recorder.log(),
            valid=np.array([valid]),
            extra={"proof": "class", "log": list(self.log)},
        )

    def close(self) -> None:
        """Destroys the actor; the library stays loaded."""
        self._entry("destroy", None)()


class _Driver:
    """Stands where an engine has its program: ticks the class, reports its hits."""

    def __init__(self, run: _Run) -> None:
        self._run = run
        self._tick = run._entry("tick", C.c_int, C.c_double)
        self._hit = run._entry("hit", C.c_int, C.c_int, C.c_int, _D, _D, _D, C.c_double)

    def before_step(self, t: float, dt: float, touched: Any, world: BodyAccess) -> None:
        """Reports the hits of the last step, then ticks (see `Executor.before_step`)."""
        if t > 0.0:
            self._report(world)
        self._run._check(self._tick(dt))

    def _report(self, world: Any) -> None:
        notifies = self._run._records
        for a, b, impulse, depth, point, normal in world.contacts(True):
            first, second = self._component(a, b), self._component(b, a)
            if not (notifies[first].notifies or notifies[second].notifies):
                continue
            push = frames.vector_to_unreal(np.asarray(normal, float) * impulse)
            self._run._check(
                self._hit(
                    first,
                    second,
                    _doubles(push),
                    _doubles(frames.vector_to_unreal(point)),
                    _doubles(frames.vector_to_unreal(normal) / frames.CM_PER_M),
                    depth * frames.CM_PER_M,
                )
            )

    def _component(self, body: int, other: int) -> int:
        if body >= 0:
            return self._run._component_of[body]
        return self._run._plane[self._run.scene.bodies[other].wheeled]


def _snapped(values: Any) -> tuple[float, float, float]:
    x, y, z = np.round(values, RECOVERED_DIGITS).tolist()
    return x + 0.0, y + 0.0, z + 0.0


def _fill(pointer: Any, values: Any) -> None:
    """Writes numbers behind a C pointer."""
    for i, value in enumerate(values):
        pointer[i] = float(value)


def _doubles(values: Any) -> Any:
    return (C.c_double * 3)(*(float(v) for v in values))


def _shape(data: dict[str, Any]) -> Shape:
    vertices = frames.vector_from_unreal(np.reshape(data.get("vertices_cm", []), (-1, 3)))
    x, y, z = (v / frames.CM_PER_M for v in data["size_cm"])
    return Shape(
        kind=data["kind"],
        size=(x, y, z),
        position=tuple(frames.vector_from_unreal(data["position_cm"]).tolist()),  # type: ignore[arg-type]
        quaternion=tuple(frames.quaternion_to_unreal(data["quaternion"]).tolist()),  # type: ignore[arg-type]
        vertices=tuple(tuple(v) for v in vertices.tolist()),
    )


def _grow(half: Any, center: Any, shape: dict[str, Any]) -> tuple[Any, Any]:
    """The box that also holds a collision shape (by its bounding sphere)."""
    x, _, z = shape["size_cm"]
    if shape["kind"] == "convex":
        points = np.array(shape["vertices_cm"])
        radius = float(np.linalg.norm(points, axis=1).max())
    elif shape["kind"] == "sphere":
        radius = x
    elif shape["kind"] == "capsule":
        radius = x + z
    elif shape["kind"] == "cylinder":
        radius = math.hypot(x, z)
    else:
        radius = float(np.linalg.norm(shape["size_cm"]))
    at = np.array(shape["position_cm"])
    low = np.minimum(np.array(center) - half, at - radius)
    high = np.maximum(np.array(center) + half, at + radius)
    return ((high - low) / 2).tolist(), ((high + low) / 2).tolist()


def _record_pose(record: _BodyRecord) -> tuple[np.ndarray, np.ndarray]:
    return (
        frames.vector_from_unreal(record.location[0:3]),
        frames.quaternion_to_unreal(record.rotation[0:4]),
    )


def _inertia(record: _BodyRecord) -> Any:
    if not record.simulates:
        return ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    axes = frames.quaternion_to_unreal(record.mass_rotation[0:4])
    columns = quat_rotate(np.tile(axes, (3, 1)), np.eye(3)).T
    moments = np.array(record.inertia[0:3]) / frames.CM2_PER_M2
    if np.array_equal(axes, [0.0, 0.0, 0.0, 1.0]):
        tensor = np.diag(moments)
    else:
        tensor = columns @ np.diag(moments) @ columns.T
    return tuple(tuple(row) for row in tensor.tolist())


def _blocks(record: _BodyRecord, channel: int) -> bool:
    return bool(record.blocks & (1 << channel))


def _ground_kind(record: _BodyRecord) -> bool:
    """Whether a ground is the one for wheels.

    Raises:
        ReplayError: If it is not a static, level, wide block with its top at height 0 that blocks
            either ordinary bodies or vehicles.
    """
    name = record.name.decode()
    half = np.array(record.scale[0:3]) * CUBE_HALF_CM
    top = record.location[2] + half[2]
    level = list(record.rotation) == [0.0, 0.0, 0.0, 1.0]
    if record.simulates or not level or abs(top) > 1e-6 or min(half[:2]) < GROUND_HALF_MIN_CM:
        raise ReplayError(f"{name} is not a static, level, wide block with its top at height 0")
    normal, wheels = _blocks(record, _ECC_PHYSICS_BODY), _blocks(record, _ECC_VEHICLE)
    if not record.collides or normal == wheels:
        raise ReplayError(f"{name} must block either ordinary bodies or vehicles")
    return wheels


def _wheeled(record: _BodyRecord, name: str) -> bool:
    if not record.collides:
        return False
    expected = (_ECC_PHYSICS_BODY, _ECC_VEHICLE) if record.simulates else (_ECC_WORLD_STATIC,)
    if record.object_type not in expected:
        raise ReplayError(f"{name} has collision object type {record.object_type}")
    deaf = [c for c in (_ECC_WORLD_STATIC, _ECC_PHYSICS_BODY, _ECC_VEHICLE)
            if not _blocks(record, c)]  # fmt: skip
    if deaf:
        raise ReplayError(f"{name} does not block collision channels {deaf}")
    return record.object_type == _ECC_VEHICLE


__all__ = ["GROUND", "ClassReplay", "ReplayError", "replay_class"]
