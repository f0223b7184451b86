# pyright: basic, reportMissingImports=false, reportAttributeAccessIssue=false
"""Plays scene.usda with its control program in NVIDIA's PhysX, with nothing of who wrote it.

    pip install ovphysx physx-usd-schemas usd-core numpy
    python play_usd.py scene.usda [--no-program] [--hz 240] [--record FILE.npz]

Prints the first touch of every pair of bodies. --no-program simulates what stands in the file alone:
poses, velocities at time 0, materials. --record keeps every step: centres of mass [m], quaternions
(x, y, z, w), velocities [m/s, rad/s] and contacts.
"""

import argparse
import json
import math

import numpy as np

# What a command does if the file does not say otherwise.
UNSAID = {"until_contact": (), "end": math.inf, "max_speed": math.inf}


def read_program(stage):
    """The commands of /World/Program as dictionaries with names of bodies: (commands, root)."""
    names = {p.GetPath(): json.loads(n) for p in stage.Traverse() if (n := named(p))}
    root = stage.GetPrimAtPath("/World/Program")
    commands = []
    for prim in root.GetChildren():
        command = {}
        for item in prim.GetAuthoredPropertiesInNamespace("esg"):
            field = item.GetBaseName()
            if field in ("body", "until_contact"):
                targets = [names[t] for t in item.GetTargets()]
                command[field] = targets[0] if field == "body" else targets
            else:
                command[field] = plain(item.Get())
        commands.append(command)
    return commands, {a.GetBaseName(): a.Get() for a in root.GetAttributes()}


def named(prim):
    return prim.GetCustomDataByKey("esg:name")


def plain(value):
    if isinstance(value, str | float):
        return value
    return [v if isinstance(v, float) else list(v) for v in value]


class Program:
    """Acts on bodies that have position, linear, angular, mass and set_friction, set_damping."""

    def __init__(self, commands, gravity_z):
        self.waiting = [UNSAID | c for c in commands]
        self.driving, self.gravity_z = [], gravity_z

    def before_step(self, t, dt, bodies, touching):
        """Acts before the step from t to t + dt; touching: pairs of names in the step before."""
        for p in [p for p in self.waiting if p.get("start", p.get("time")) <= t + dt / 2]:
            body = bodies[p["body"]]
            if p["kind"] in LASTING:
                hit = any({p["body"], other} in touching for other in p["until_contact"])
                end = p["start"] + p["times"][-1] if "times" in p else p["end"]
                if t + dt / 2 <= end and not (hit and p in self.driving):
                    self.driving.append(p)
                    LASTING[p["kind"]](p, body, t - p["start"], dt, self.gravity_z * dt)
                    continue
            else:
                ONCE[p["kind"]](p, body)
            self.waiting.remove(p)


def set_velocity(p, body):
    body.linear, body.angular = p["linear"], p.get("angular", body.angular)


def push(p, body):
    body.linear = [v + j / body.mass for v, j in zip(body.linear, p["impulse"], strict=True)]


def adjust(p, body):
    for kind in ("linear", "angular"):
        if f"{kind}_damping" in p:
            body.set_damping(kind, p[f"{kind}_damping"])
    if "friction" in p:
        body.set_friction(p["friction"])


def drive(p, body, s, dt, pull):
    """Motion s seconds after its start: rolling, or flying against the step's pull of gravity."""
    speed = max(0.0, p["speed"] + p["acceleration"] * s)
    if p["acceleration"] > 0:
        speed = min(speed, p["max_speed"])
    heading, r = p["heading"] + p["turn_rate"] * s, 0.0 if "climb" in p else p["roll_radius"]
    vx, vy = speed * math.cos(heading), speed * math.sin(heading)
    body.linear = [vx, vy, p["climb"] - pull if "climb" in p else body.linear[2]]
    body.angular = [-vy / r, vx / r, 0.0] if r else [0.0, 0.0, p["turn_rate"]]


def guide(p, body, s, dt, pull):
    """Along its path, returning to it where it has left it (10 m/s for a metre)."""
    x, y = place(p, s), place(p, s + dt)
    v = [(y[i] - x[i]) / dt + 10 * (x[i] - body.position[i]) for i in range(3)]
    body.linear, body.angular = [v[0], v[1], v[2] - pull], [0.0, 0.0, p["turn_rate"]]


def place(p, s):
    """The cubic through the two points around s, with their velocities; straight outside."""
    t, knots = p["times"], list(zip(p["points"], p["velocities"], strict=True))
    k = max([i for i, time in enumerate(t) if time < s], default=0)
    (x, v), h = knots[k], s - t[k]
    if k + 1 == len(t) or s < t[0]:
        return [x[i] + v[i] * h for i in range(3)]
    (y, w), d = knots[k + 1], t[k + 1] - t[k]
    u = h / d
    a, b = u * u * (3 - 2 * u), d * u * (1 - u)
    return [x[i] + a * (y[i] - x[i]) + b * ((1 - u) * v[i] - u * w[i]) for i in range(3)]


def spin(p, body, s, dt, pull):
    """About its axis; where it goes is physics."""
    body.angular = [p["rate"] * a / math.hypot(*p["axis"]) for a in p["axis"]]


ONCE = {"SetVelocity": set_velocity, "ApplyImpulse": push, "AdjustProperties": adjust}
LASTING = {"HoldVelocity": drive, "GuideAlong": guide, "HoldSpin": spin}


class Body:
    """A body of the stage: its state before the step, and what the program makes of it."""

    def __init__(self, world, prim, number):
        from pxr import Usd, UsdGeom, UsdPhysics

        self.world, self.number = world, number
        self.name, self.path = json.loads(named(prim)), str(prim.GetPath())
        self.moves = prim.HasAPI(UsdPhysics.RigidBodyAPI)
        mass = UsdPhysics.MassAPI(prim)
        self.mass = mass.GetMassAttr().Get() if self.moves else 0.0
        self.centre = np.array(mass.GetCenterOfMassAttr().Get(), float)
        pose = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
        q = pose.ExtractRotationQuat()
        self.see(pose.ExtractTranslation(), (*q.GetImaginary(), q.GetReal()), (0, 0, 0), (0, 0, 0))

    def see(self, origin, quaternion, linear, angular):
        self.quaternion = np.array(quaternion, float)
        axis, w = self.quaternion[:3], self.quaternion[3]
        twice = 2 * np.cross(axis, self.centre)
        self.position = np.array(origin) + self.centre + w * twice + np.cross(axis, twice)
        self.linear, self.angular = list(map(float, linear)), list(map(float, angular))

    def set_friction(self, value):
        for attribute in ("staticFriction", "dynamicFriction"):
            self.world.write(attribute, {self.path: value})

    def set_damping(self, kind, value):
        self.world.edit(f"physxRigidBody:{kind}Damping", self.path, value)


class World:
    """A stage in NVIDIA's PhysX, on the CPU."""

    def __init__(self, path, stage):
        import ovphysx
        import ovstage
        import physx_usd_schemas
        import warp

        warp.config.quiet = True
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
        prims = [p for p in stage.Traverse() if named(p)]
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
        with self.physx.write_sync(
            self.kinds.RIGID_BODY, attribute, prim_paths=handles
        ) as session:
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

    def step(self, dt, act):
        """Lets `act` change velocities, then steps."""
        before = {p: (b.linear, b.angular) for p, b in self.moving.items()}
        act()
        for i, name in enumerate(("linear", "angular")):
            new = {p: getattr(b, name) for p, b in self.moving.items()}
            if changed := {p: v for p, v in new.items() if v is not before[p][i]}:
                self.write(f"{name}Velocity", changed)
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
    """Simulates the file; returns time, frames and touches."""
    from pxr import Usd, UsdPhysics

    stage = Usd.Stage.Open(path)
    commands, head = read_program(stage)
    dt = 1 / hz if hz else head["step"]
    gravity = UsdPhysics.Scene(stage.GetPrimAtPath("/World/PhysicsScene"))
    down = gravity.GetGravityDirectionAttr().Get()[2] * gravity.GetGravityMagnitudeAttr().Get()
    program = Program(commands if with_program else [], down)
    world = World(path, stage)
    bodies = {b.name: b for b in world.bodies}
    frames, touches, touching = [snapshot(world)], {}, []
    steps = math.ceil(head["duration"] / dt - 1e-6)
    for step in range(steps):
        t = step * dt
        world.step(dt, lambda t=t, near=touching: program.before_step(t, dt, bodies, near))
        touching = []
        for a, b, impulse, depth, point, normal in world.contacts():
            if impulse > 0:
                row = touches.setdefault((step + 1, a, b), [0.0, 0.0, point, normal])
                row[0], row[1] = row[0] + impulse, max(row[1], depth)
                touching.append({world.bodies[a].name, world.bodies[b].name})
        frames.append(snapshot(world))
    names = [b.name for b in world.bodies]
    world.close()
    return names, dt, frames, touches


def snapshot(world):
    return [np.concatenate([b.position, b.quaternion, b.linear, b.angular]) for b in world.bodies]


def record(path, dt, frames, touches):
    states = np.array(frames, np.float32)[None]
    parts = dict(position=(0, 3), quaternion=(3, 7), linear_velocity=(7, 10), angular_velocity=(10, 13))
    arrays = {name: states[..., a:b] for name, (a, b) in parts.items()}
    keys = sorted(touches)
    index = np.array(keys, np.int32).reshape(-1, 3)
    rows = [touches[k] for k in keys]
    contacts = dict(world=np.zeros(len(keys), np.int32), frame=index[:, 0], a=index[:, 1], b=index[:, 2])
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
