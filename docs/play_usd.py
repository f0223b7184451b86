"""Plays scene.usda with its control program in NVIDIA's PhysX, with nothing of this project.

    pip install ovphysx physx-usd-schemas usd-core numpy
    python play_usd.py scene.usda [--no-program] [--hz 240] [--record FILE.npz]

Prints the first touch of every pair of bodies. --no-program simulates what stands in the file
alone: poses, materials, velocities at time 0. --record keeps every step: centres of mass [m],
quaternions (x, y, z, w), velocities [m/s, rad/s], contacts. read_manifest.py beside this file says
what the commands of a program do.
"""

import argparse
import json
import math
from types import SimpleNamespace
import warnings

import numpy as np
from read_manifest import Program

ABSENT = ("angular", "end", "max_speed", "linear_damping", "angular_damping", "friction")


def read_scene(stage):
    """What read_manifest.py has to know of a stage: {gravity, dt, bodies, program}."""
    from pxr import UsdPhysics

    root = stage.GetPrimAtPath("/World/Program")
    head = {a.GetBaseName(): a.Get() for a in root.GetAttributes()}
    commands = [dict.fromkeys(ABSENT) | read_fields(p) for p in root.GetChildren()]
    gravity = UsdPhysics.Scene(stage.GetPrimAtPath("/World/PhysicsScene"))
    strength = gravity.GetGravityMagnitudeAttr().Get()
    return {
        "gravity": [strength * g for g in gravity.GetGravityDirectionAttr().Get()],
        "dt": head["step"],
        "bodies": [read_body(p) for p in stage.Traverse() if is_body(p)],
        "program": {"duration": head["duration"], "primitives": commands},
    }


def is_body(prim):
    return prim.HasAPI("PhysicsMassAPI")


def name_of(prim):
    return json.loads(prim.GetCustomDataByKey("esg:name"))


def read_body(prim):
    from pxr import UsdPhysics

    moves = prim.HasAPI(UsdPhysics.RigidBodyAPI)
    shapes = [c for c in prim.GetChildren() if c.HasAPI(UsdPhysics.CollisionAPI)]
    mass = UsdPhysics.MassAPI(prim)
    axes = mass.GetPrincipalAxesAttr().Get()
    turn = np.array([turned((*axes.GetImaginary(), axes.GetReal()), e) for e in np.eye(3)]).T
    return {
        "roll_radius": 0.0,
        **prim.GetCustomDataByKey("esg"),
        "name": name_of(prim),
        "static": not moves,
        "shapes": shapes,
        "mass": mass.GetMassAttr().Get(),
        "inertia": turn @ np.diag(mass.GetDiagonalInertiaAttr().Get()) @ turn.T,
    }


def turned(quaternion, vector):
    """A vector turned by a quaternion (x, y, z, w)."""
    axis, w = np.array(quaternion[:3]), quaternion[3]
    twice = 2 * np.cross(axis, vector)
    return np.array(vector) + w * twice + np.cross(axis, twice)


def read_fields(prim):
    """The esg: attributes of a command; bodies are named by relationships."""
    fields = {"until_contact": []}
    for item in prim.GetAuthoredPropertiesInNamespace("esg"):
        field = item.GetBaseName()
        if field in ("body", "into", "until_contact"):
            named = [name_of(prim.GetStage().GetPrimAtPath(t)) for t in item.GetTargets()]
            fields[field] = named if field == "until_contact" else named[0]
        else:
            fields[field] = plain(item.Get())
    return fields


def plain(value):
    if isinstance(value, str | float):
        return value
    return [v if isinstance(v, float) else list(v) for v in value]


class Body:
    """A body of the stage: its state before the step, and what the program makes of it."""

    def __init__(self, world, prim, number):
        from pxr import Usd, UsdGeom, UsdPhysics

        self.world, self.number = world, number
        self.name, self.path = name_of(prim), str(prim.GetPath())
        self.moves = prim.HasAPI(UsdPhysics.RigidBodyAPI)
        mass = UsdPhysics.MassAPI(prim)
        self.mass, self.centre = mass.GetMassAttr().Get(), mass.GetCenterOfMassAttr().Get()
        self._damping = {}
        for kind in ("linear", "angular"):
            authored = prim.GetAttribute(f"physxRigidBody:{kind}Damping")
            self._damping[kind] = authored.Get() if authored else 0.0
        pose = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
        q = pose.ExtractRotationQuat()
        self.see(pose.ExtractTranslation(), (*q.GetImaginary(), q.GetReal()), (0, 0, 0), (0, 0, 0))

    def see(self, origin, quaternion, linear, angular):
        self.rotation = SimpleNamespace(quaternion=np.array(quaternion, float))
        self.translation = np.array(origin) + turned(quaternion, self.centre)
        self.linvel, self.angvel = tuple(map(float, linear)), tuple(map(float, angular))

    def set_friction(self, value):
        for attribute in ("staticFriction", "dynamicFriction"):
            self.world.write(attribute, {self.path: value})

    def _damp(self, kind, value):
        if value != self._damping[kind]:
            self._damping[kind] = value
            self.world.edit(f"physxRigidBody:{kind}Damping", self.path, value)

    linear_damping = property(
        lambda self: self._damping["linear"], lambda self, value: self._damp("linear", value)
    )
    angular_damping = property(
        lambda self: self._damping["angular"], lambda self, value: self._damp("angular", value)
    )


class World:
    """A stage in NVIDIA's PhysX, on the CPU."""

    def __init__(self, path, stage):
        import ovphysx
        import ovstage
        import physx_usd_schemas
        import warp

        warp.config.log_level = warp.LOG_ERROR
        self.stage_of, self.kinds = ovstage, ovphysx.types.SimObjectType
        schemas = [str(p) for p in physx_usd_schemas.schema_paths()]
        ovstage.population.register_usd_schemas(schemas)
        ovphysx.PhysX.set_cpu_mode(True)
        self.physx, self.stage, self.ordinal = ovphysx.PhysX(), ovstage.Stage("scene"), 1
        every = ovstage.PopulationDomain.ALL
        ovstage.population.open_usd(self.stage, path, ordinal=1, domains=every)
        self.stage.advance_write_floor(ordinal=1).wait()
        self.physx.wait_task(self.physx.attach_ovstage(self.stage, read_ordinal=1))
        self.physx.wait_all()
        self.paths = ovstage.PathDictionary(self.stage)
        prims = [p for p in stage.Traverse() if is_body(p)]
        self.bodies = [Body(self, prim, i) for i, prim in enumerate(prims)]
        self.moving = {b.path: b for b in self.bodies if b.moves}
        self.look()

    def read(self, kind, attributes):
        """Arrays by path and attribute."""
        found = {}
        with self.physx.read_sync(kind, attributes) as result:
            for group in result.groups:
                name = self.paths.token_to_string(group.attribute)
                paths = self.paths.get_path_strings(group.prim_list)
                rows = group.tensors if group.is_array else group.tensors[0].numpy()
                for path, row in zip(paths, rows, strict=True):
                    found.setdefault(path, {})[name] = np.array(
                        row.numpy() if group.is_array else row
                    )
        return found

    def look(self):
        state = ["position", "orientation", "linearVelocity", "angularVelocity"]
        for path, row in self.read(self.kinds.RIGID_BODY, state).items():
            self.moving[path].see(*(row[name] for name in state))

    def write(self, attribute, values):
        """Sets an attribute of some bodies by path, of all their shapes where it is of shapes."""
        handles = [self.paths.intern_path(p) for p in values]
        with self.physx.write_sync(self.kinds.RIGID_BODY, attribute, prim_paths=handles) as session:
            for group in session.groups:
                rows = group.tensors[0].numpy()
                for i, path in enumerate(self.paths.get_path_strings(group.prim_list)):
                    rows[i] = values[path]
                group.tensors[0].assign(rows)
                session.commit_sync(group)

    def edit(self, attribute, path, value):
        """Changes what PhysX has no setter for as an edit of the stage."""
        self.ordinal += 1
        query = self.stage.query_from_path_list(self.paths.create_path_list_from_strings([path]))
        tensor = self.stage_of.make_dltensor(np.array([value], np.float32))
        self.stage.write_attribute(query, attribute, self.ordinal, tensor, is_array=False).wait()
        self.stage.release_query(query).wait()
        self.stage.advance_write_floor(ordinal=self.ordinal).wait()
        self.physx.wait_task(self.physx.update_from_ovstage(self.ordinal, self.ordinal))

    def command(self, before):
        """Gives PhysX the velocities that the program has changed since they were `before`."""
        after = {b.path: (b.linvel, b.angvel, *before[b.name]) for b in self.moving.values()}
        for i, name in enumerate(("linearVelocity", "angularVelocity")):
            if new := {p: v[i] for p, v in after.items() if tuple(v[i]) != v[i + 2]}:
                self.write(name, new)

    def step(self, dt):
        self.physx.step_sync(dt)
        self.look()

    def contacts(self):
        """Touches of the last step: (a, b, impulse [N s], depth [m], point, normal from b to a)."""
        event = "contactEvent"
        every = ["OtherBody", "SensorSide", "PointCount"]
        points = ["PointPosition", "PointNormal", "PointImpulse", "PointSeparation"]
        rows = self.read(self.kinds.CONTACT_SENSOR, [event + name for name in every + points])
        for path, row in rows.items():
            if event + "PointPosition" not in row:
                continue
            me, start = self.moving[path], 0
            sides = zip(*(row[event + name] for name in every), strict=True)
            for other, side, count in sides:
                at = slice(start, start := start + int(count))
                you = self.owner(self.paths.path_to_string(int(other)))
                if you is None or (you.moves and you.number < me.number) or not count:
                    continue
                where, normal, impulse, apart = (row[event + name][at] for name in points)
                along = np.einsum("ij,ij->i", impulse, normal)
                k = int(np.argmax(along))
                normal = normal[k] if (side == 0) == (me.number < you.number) else -normal[k]
                pair = sorted((me.number, you.number))
                yield (*pair, float(along.sum()), max(0.0, -float(apart.min())), where[k], normal)

    def owner(self, path):
        """The body that a prim belongs to; None for the ground."""
        inside = (b for b in self.bodies if path == b.path or path.startswith(b.path + "/"))
        return next(inside, None)

    def close(self):
        self.physx.wait_task(self.physx.detach_ovstage())
        self.stage.destroy()
        self.physx.destroy()


def play(path, hz, with_program):
    """Simulates the file; returns names, step, frames and touches."""
    from pxr import Usd

    stage = Usd.Stage.Open(path)
    scene = read_scene(stage)
    dt, steps = (1 / hz if hz else scene["dt"]), scene["program"]["duration"]
    steps = math.ceil(steps / dt - 1e-6)
    program, world = Program(scene) if with_program else None, World(path, stage)
    bodies = {b.name: b for b in world.bodies}
    frames, touches, touching = [snapshot(world)], {}, []

    def set_friction(name, value):
        bodies[name].set_friction(value)

    for step in range(steps):
        if program:
            before = {n: (b.linvel, b.angvel) for n, b in bodies.items()}
            program.before_step(step * dt, dt, bodies.__getitem__, touching, set_friction)
            world.command(before)
        world.step(dt)
        touching = []
        for a, b, impulse, depth, point, normal in world.contacts():
            if impulse > 0:
                row = touches.setdefault((step + 1, a, b), [0.0, 0.0, point, normal])
                row[0], row[1] = row[0] + impulse, max(row[1], depth)
                touching.append({world.bodies[a].name, world.bodies[b].name})
        frames.append(snapshot(world))
    world.close()
    return list(bodies), dt, frames, touches


def snapshot(world):
    return [
        np.concatenate([b.translation, b.rotation.quaternion, b.linvel, b.angvel])
        for b in world.bodies
    ]


def record(path, dt, frames, touches):
    states = np.array(frames, np.float32)[None]
    parts = dict(
        position=(0, 3), quaternion=(3, 7), linear_velocity=(7, 10), angular_velocity=(10, 13)
    )
    arrays = {name: states[..., a:b] for name, (a, b) in parts.items()}
    keys = sorted(touches)
    index = np.array(keys, np.int32).reshape(-1, 3)
    rows = [touches[k] for k in keys]
    contacts = dict(
        world=np.zeros(len(keys), np.int32), frame=index[:, 0], a=index[:, 1], b=index[:, 2]
    )
    contacts |= dict(time=index[:, 0] * dt)
    for i, name in enumerate(("impulse", "depth", "point", "normal")):
        wide = (len(rows), 3) if name in ("point", "normal") else (len(rows),)
        contacts[name] = np.array([r[i] for r in rows], float).reshape(wide)
    np.savez_compressed(
        path,
        engine="ovphysx",
        dt=dt,
        time=np.arange(len(frames)) * dt,
        valid=[bool(np.isfinite(states).all() and np.abs(states[..., 7:10]).max(initial=0) < 500)],
        **arrays,
        **{f"contacts.{name}": array for name, array in contacts.items()},
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file")
    parser.add_argument("--no-program", action="store_true")
    parser.add_argument("--hz", type=float, help="steps a second; default as the file was proven")
    parser.add_argument("--record")
    options = parser.parse_args()
    warnings.simplefilter("ignore", RuntimeWarning)  # about schemas and devices that are not used
    names, dt, frames, touches = play(options.file, options.hz, not options.no_program)
    seen = set()
    for (frame, a, b), (impulse, *_) in sorted(touches.items()):
        if (a, b) not in seen:
            seen.add((a, b))
            print(f"{frame * dt:.4f} s  {names[a]} hits {names[b]}  {impulse:.2f} N s")
    if options.record:
        record(options.record, dt, frames, touches)


if __name__ == "__main__":
    main()
