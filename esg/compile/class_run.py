"""One life of a compiled class: its library is loaded, the shim is given a physics world, it plays.

The shim calls back through C function pointers for poses, velocities, impulses and overlaps; this
module answers them from an engine's world, and builds that world from what the class described.
"""

from __future__ import annotations

from collections.abc import Callable
import ctypes as C
from dataclasses import replace
import math
from typing import Any

import numpy as np

from esg.compile import build, frames
from esg.compile.joint_records import ConstraintRecord, joints_of, motor_of
from esg.compile.penetration import PenetrationProbe
from esg.compile.records import (
    CUBE_ASSET,
    CUBE_HALF_CM,
    BodyRecord,
    ReplayError,
    body_of,
    ground_for_wheels,
    grown,
    moves,
    of_single,
    record_pose,
    shape_of,
)
from esg.engines.breaking.stances import own_names, ride_along, stances
from esg.engines.breaking.swap import brittle, settle
from esg.engines.executor import Touch, play, touch_order
from esg.engines.scene import Body, ContactLog, Rollout, Shape, SimScene
from esg.engines.worlds import ContactRecorder, Frames, Principal, Values, rest_states, world_values
from esg.units import quat_rotate, quat_rotated

_BOX, _SPHERE, _CAPSULE = 0, 1, 2

_D = C.POINTER(C.c_double)
_Three = C.c_double * 3
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
    "drive": C.CFUNCTYPE(None, C.c_int, C.c_int, C.c_double, C.c_double),
    "present": C.CFUNCTYPE(None, C.c_int, C.c_int, _D, _D),
}


class _Backend(C.Structure):
    _fields_ = list(_CALLBACKS.items())


class ClassRun:
    """One life of one class: construct, begin play, tick, destroy.

    Only one may live at a time in a process: classes of a library share the shim's state.

    Args:
        library: The compiled class.
        imports: Its import manifest.
    """

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
        self._records: list[BodyRecord] = []
        self._shapes: dict[int, tuple[Shape, ...]] = {}
        self._offset: dict[int, np.ndarray] = {}
        self._followed: dict[int, list[float]] = {}
        self._body_of: dict[int, int] = {}
        self._component_of: dict[int, int] = {}
        self._plane: dict[bool, int] = {}
        self._pairs: dict[tuple[int, int], tuple[int, int] | None] = {}
        self._joint_of: dict[int, int] = {}
        self._gone: dict[int, tuple[float, Any]] = {}
        self._came: list[tuple[float, int]] = []
        self._now = 0.0
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
                half, center = grown(half, center, shape)
        else:
            return 0
        _fill(bounds, [*half, *center])
        return 1

    def _log(self, category: bytes, verbosity: bytes, text: bytes) -> None:
        self.log.append(f"{verbosity.decode()}: {text.decode(errors='replace')}")

    def _get_pose(self, component: int, location: Any, rotation: Any) -> None:
        position, quaternion = self._origin_pose(component)
        location[0], location[1], location[2] = frames.vector_numbers(position)
        rotation[0], rotation[1], rotation[2], rotation[3] = frames.quaternion_numbers(quaternion)

    def _origin_pose(
        self, component: int
    ) -> tuple[tuple[float, float, float], tuple[float, float, float, float]]:
        x, y, z, i, j, k, w = self._world.placed(self._body_of[component])
        a, b, c = quat_rotated((i, j, k, w), self._followed[component])
        return (x + a, y + b, z + c), (i, j, k, w)

    def _get_velocity(self, component: int, linear: Any, angular: Any) -> None:
        motion = self._world.motion(self._body_of[component])
        linear[0], linear[1], linear[2] = frames.vector_numbers(motion[:3])
        angular[0], angular[1], angular[2] = frames.angular_numbers(motion[3:])

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
        self._world.set_linear_damping(self._body_of[component], of_single(linear))
        self._world.set_angular_damping(self._body_of[component], of_single(angular))

    def _set_material(self, component: int, friction: float, restitution: float) -> None:
        body = self._body_of.get(component)
        if body is None:
            raise ReplayError("the ground's material changes during play, which is not replayed")
        if abs(restitution - self.scene.bodies[body].restitution) > 1e-6:
            raise ReplayError("a restitution changes during play, which is not replayed")
        self._world.set_friction(body, of_single(friction))

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
            pose = record_pose(record)
        depth = self._probe.depth(component, self._shapes[component], pose, probe, where)
        return depth * frames.CM_PER_M

    def _drive(self, constraint: int, acts: int, speed: float, limit: float) -> None:
        if constraint not in self._joint_of:
            raise ReplayError("what draws a joint back changes during play, which is not replayed")
        k = self._joint_of[constraint]
        motor = motor_of(self.scene.joints[k].kind, bool(acts), speed, limit)
        self._world.set_motor(k, motor)

    def _present(self, component: int, there: int, location: Any, rotation: Any) -> None:
        body = self._body_of[component]
        if not there:
            still = self.scene.bodies[body].static
            self._gone[body] = self._now, None if still else self._world.read(body)[:2]
            self._world.retire(body)
            return
        turn = frames.quaternion_to_unreal(rotation[0:4])
        at = frames.vector_from_unreal(location[0:3]) - quat_rotate(turn, self._offset[component])
        self._world.release(body, at, turn, np.zeros(3), np.zeros(3))
        self._came.append((self._now, body))

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

            with physx_engine.scene_config(physx_engine.physx_module(), self.scene):
                self._world = physx_engine.PhysxWorld(
                    self.scene, values, 0, grid.dt, self._mass_frames()
                )
                if not ground:
                    self._world.leave_out(self._silent())
                return self._simulate(engine, values, grid, ground)
        import rapier3d

        from esg.engines.rapier_engine import RapierWorld

        self._world = RapierWorld(rapier3d, self.scene, values, 0, grid.dt, self._mass_frames())
        return self._simulate(engine, values, grid, ground)

    def _describe(self) -> None:
        describe = self._entry("describe", C.c_int, C.c_int, C.POINTER(BodyRecord))
        self._records = []
        for i in range(self._entry("body_count")()):
            record = BodyRecord()
            self._check(describe(i, C.byref(record)))
            self._records.append(record)

    def _load_shapes(self) -> None:
        for i, record in enumerate(self._records):
            asset = self._assets.get(record.asset.decode())
            if asset is not None and (record.collides or record.dormant):
                self._shapes[i] = tuple(shape_of(p) for p in asset["collision"])

    def _described_scene(self) -> SimScene:
        bodies: dict[int, Body] = {}
        grounds: dict[bool, BodyRecord] = {}
        for i, record in enumerate(self._records):
            name = record.name.decode()
            if record.asset.decode() == CUBE_ASSET:
                for_wheels = ground_for_wheels(record)
                if for_wheels in grounds:
                    raise ReplayError(f"{name} is a second ground of the same kind")
                grounds[for_wheels], self._plane[for_wheels] = record, i
                continue
            if "node" in self._assets.get(record.asset.decode(), {}):
                continue  # a wheel is a picture
            if name not in self._components:
                raise ReplayError(f"component {name} is not in the import manifest")
            entry = self._components[name]
            self._body_of[i], self._component_of[entry["index"]] = entry["index"], i
            bodies[entry["index"]] = self._describe_body(i, record, entry)
        missing = sorted(set(range(len(self._components))) - set(bodies))
        if missing or set(grounds) != {False, True}:
            raise ReplayError(f"the class lacks bodies {missing} or one of its two grounds")
        normal, wheels = grounds[False], grounds[True]
        if normal.restitution != wheels.restitution:
            raise ReplayError("the two grounds differ in restitution")
        gravity = self._entry("gravity", C.c_double)()
        joints, self._joint_of = joints_of(
            self._constraints(),
            {i: (bodies[k].name, self._offset[i]) for i, k in self._body_of.items()},
        )
        return SimScene(
            scene_id=self._name,
            bodies=tuple(bodies[i] for i in range(len(bodies))),
            gravity=(0.0, 0.0, gravity / frames.CM_PER_M),
            ground_friction=of_single(normal.friction),
            ground_restitution=of_single(normal.restitution),
            vehicle_ground_friction=of_single(wheels.friction),
            joints=joints,
        )

    def _constraints(self) -> list[ConstraintRecord]:
        """What joins the bodies, as the class has left it."""
        describe = self._entry("describe_constraint", C.c_int, C.c_int, C.POINTER(ConstraintRecord))
        out = [ConstraintRecord() for _ in range(self._entry("constraint_count")())]
        for i, record in enumerate(out):
            self._check(describe(i, C.byref(record)))
        return out

    def _mass_frames(self) -> Principal:
        """The very principal axes that the class states, by body.

        An engine would diagonalize the tensor again and round otherwise, which is no other physics
        but enough to part two chaotic motions.
        """
        out: Principal = {}
        for component, index in self._body_of.items():
            record = self._records[component]
            if moves(record):
                axes = frames.quaternion_to_unreal(record.mass_rotation[0:4])
                out[index] = np.array(record.inertia[0:3]) / frames.CM2_PER_M2, axes
        return out

    def _describe_body(self, i: int, record: BodyRecord, entry: dict[str, Any]) -> Body:
        # Only moving bodies state a centre of mass; the others keep the point their poses follow.
        followed = record.center_of_mass if moves(record) else entry["center_of_mass_cm"]
        self._offset[i] = -frames.vector_from_unreal(followed[0:3])
        self._followed[i] = self._offset[i].tolist()
        return body_of(record, entry["body"], self._shapes.get(i, ()), self._offset[i])

    def _simulate(self, engine: str, values: Values, grid: Frames, ground: bool) -> Rollout:
        states = rest_states(values, grid)
        for component, body in self._body_of.items():
            if self._records[component].dormant:
                self._world.retire(body)
        self._entry("live", None)()
        recorder = ContactRecorder(0, grid)
        driver: Any = _Driver(self, states)
        valid = play(self._world, driver, grid, states, recorder, ground)
        self._check(0)
        self._fill_in(states, grid)
        log = self._in_postures(states, grid, recorder.log())
        return Rollout(
            engine=engine,
            dt=grid.dt,
            time=grid.time,
            position=states[0],
            quaternion=states[1],
            linear_velocity=states[2],
            angular_velocity=states[3],
            contacts=log,
            valid=np.array([valid]),
            extra={"proof": "class", "log": list(self.log)},
        )

    def heard_by(self, a: int, b: int) -> tuple[int, int] | None:
        """Components of two bodies that touch, -1 the ground; None if neither is told of hits."""
        if (a, b) not in self._pairs:
            pair = self._component(a, b), self._component(b, a)
            told = any(self._records[one].notifies for one in pair)
            self._pairs[a, b] = pair if told else None
        return self._pairs[a, b]

    def _silent(self) -> list[int]:
        """Bodies of which nobody is told that they touch the ground."""
        return [body for body in self._body_of.values() if self.heard_by(body, -1) is None]

    def _component(self, body: int, other: int) -> int:
        if body >= 0:
            return self._component_of[body]
        return self._plane[self.scene.bodies[other].wheeled]

    def _fill_in(self, states: tuple[Any, Any, Any, Any], grid: Frames) -> None:
        """Writes where fragments are that have not come in yet, and what is broken."""
        fragments = {
            e["index"]: tuple(e["fragments"]) for e in self._components.values() if "fragments" in e
        }
        if not fragments:
            return
        bodies = [
            replace(
                b, fragments=fragments.get(i, ()), break_impulse=1.0 if i in fragments else None
            )
            for i, b in enumerate(self.scene.bodies)
        ]
        for b in brittle(self.scene.with_bodies(tuple(bodies))):
            when, pose = self._gone.get(b.whole, (math.inf, None))
            gone = grid.time > when + 0.5 * grid.dt
            if gone.any() and pose is not None:
                states[0][0, gone.argmax(), b.whole], states[1][0, gone.argmax(), b.whole] = pose
            settle(b, states, gone[None])

    def _in_postures(
        self, states: tuple[Any, Any, Any, Any], grid: Frames, log: ContactLog
    ) -> ContactLog:
        """Writes where the postures are that are not there; the log names those who take them."""
        own = {e["index"]: tuple(e.get("postures", ())) for e in self._components.values()}
        if not any(own.values()):
            return log
        bodies = (replace(b, postures=own.get(i, ())) for i, b in enumerate(self.scene.bodies))
        scene = self.scene.with_bodies(tuple(bodies))
        for s in stances(scene):
            there = np.zeros(len(grid.time), np.int64)
            for when, body in self._came:
                if body in s.bodies:
                    there[(grid.time > when + 0.5 * grid.dt) | (when <= 0.0)] = s.bodies.index(body)
            ride_along(s, 0, there, states)
        return own_names(scene, log)

    def close(self) -> None:
        """Destroys the actor and unloads the library: batches must not grow with every class."""
        import _ctypes

        self._entry("destroy", None)()
        self._world = None
        _ctypes.dlclose(self._dll._handle)


class _Driver:
    """Stands where an engine has its program: ticks the class, reports its hits."""

    def __init__(self, run: ClassRun, states: tuple[Any, Any, Any, Any]) -> None:
        self._run, self._states = run, states
        self._tick = run._entry("tick", C.c_int, C.c_double)
        self._hit = run._entry("hit", C.c_int, C.c_int, C.c_int, _D, _D, _D, C.c_double)

    def before_step(self, t: float, dt: float, touched: Any, world: Any) -> None:
        """Reports the hits of the last step, then ticks (see `Executor.before_step`)."""
        self._run._now = t
        if t > 0.0:
            self._report(world)
        self._run._check(self._tick(dt))
        if t == 0.0:
            # What the first tick has given is what is under way when the scene begins.
            for i in world.moving:
                _, _, self._states[2][0, 0, i], self._states[3][0, 0, i] = world.read(i)

    def _report(self, world: Any) -> None:
        heard: list[tuple[tuple[int, int], Touch]] = []
        for touch in world.contacts(True):
            pair = self._run.heard_by(touch[0], touch[1])
            if pair is not None:
                heard.append((pair, touch))
        # The class logs the first that passes its threshold.
        if len(heard) > 1:
            heard.sort(key=lambda one: touch_order(one[1]))
        for (first, second), (_, _, impulse, depth, point, normal) in heard:
            x, y, z = map(float, normal)
            a, b, c = frames.vector_numbers((x, y, z))
            self._run._check(
                self._hit(
                    first,
                    second,
                    _Three(*frames.vector_numbers((x * impulse, y * impulse, z * impulse))),
                    _Three(*frames.vector_numbers([*map(float, point)])),
                    _Three(a / frames.CM_PER_M, b / frames.CM_PER_M, c / frames.CM_PER_M),
                    depth * frames.CM_PER_M,
                )
            )


def _fill(pointer: Any, values: Any) -> None:
    """Writes numbers behind a C pointer."""
    for i, value in enumerate(values):
        pointer[i] = float(value)
