"""Plays a manifest.json in PhysX with nothing of this project: python read_manifest.py FILE"""

import json
import math
import sys

import numpy as np
import sapien
import sapien.physx as px

X_TO_Z = [0.5**0.5, 0, -(0.5**0.5), 0]  # SAPIEN writes quaternions (w, x, y, z)


def pose(p, q=(0, 0, 0, 1)):
    return sapien.Pose(list(p), [q[3], q[0], q[1], q[2]])


def collider(shape, material):
    kind, size, one = shape["kind"], np.array(shape["size"], np.float32), np.ones(3, np.float32)
    at = pose(shape["position"], shape["quaternion"])
    if kind == "sphere":
        out = px.PhysxCollisionShapeSphere(size[0], material)
    elif kind == "box":
        out = px.PhysxCollisionShapeBox(size, material)
    elif kind == "capsule":
        out, at = (
            px.PhysxCollisionShapeCapsule(size[0], size[2], material),
            at * sapien.Pose(q=X_TO_Z),
        )
    else:
        turns = np.arange(32) * math.tau / 32
        ring = np.stack([size[0] * np.cos(turns), size[0] * np.sin(turns), 0 * turns], 1)
        points = shape["vertices"] or np.concatenate(
            [ring + np.array([0, 0, z]) for z in (-size[2], size[2])]
        )
        out = px.PhysxCollisionShapeConvexMesh(np.array(points, np.float32), one, material)
    out.local_pose = at
    return out


def add(scene, component, shapes, where):
    for shape, groups in shapes:
        shape.set_collision_groups([*groups, 0, 0])
        component.attach(shape)
    entity = sapien.Entity()
    entity.add_component(component)
    entity.set_pose(where)
    scene.add_entity(entity)
    return component


def play(m):
    config = px.PhysxSceneConfig()
    config.gravity, config.bounce_threshold = m["gravity"], 0.2
    px.set_scene_config(config)
    system, dt, bodies = px.PhysxCpuSystem(), m["dt"], {}
    seen, driving, touching = set(), set(), []
    scene = sapien.Scene([system])
    scene.set_timestep(dt)
    for mu, groups in (
        (m["ground"]["friction"], (1, 4)),
        (m["ground"]["vehicle_friction"], (2, 8)),
    ):
        plane = px.PhysxCollisionShapePlane(px.PhysxMaterial(mu, mu, m["ground"]["restitution"]))
        plane.local_pose = sapien.Pose(q=X_TO_Z)
        add(scene, px.PhysxRigidStaticComponent(), [(plane, groups)], sapien.Pose())
    for b in m["bodies"]:
        if not b["shapes"]:
            continue
        fixed = b["static"]
        component = px.PhysxRigidStaticComponent() if fixed else px.PhysxRigidDynamicComponent()
        material = px.PhysxMaterial(b["friction"], b["friction"], b["restitution"])
        groups = (8 if b["wheeled"] else 4, 12)
        shapes = [(collider(s, material), groups) for s in b["shapes"]]
        bodies[b["name"]] = add(scene, component, shapes, pose(b["position"], b["quaternion"]))
        if not fixed:
            component.mass, component.cmass_local_pose = b["mass"], sapien.Pose()
            component.inertia = np.diag(b["inertia"]).astype(np.float32)  # principal axes dropped
            component.linear_damping = b["linear_damping"]
            component.angular_damping = b["angular_damping"]
    program, names = list(m["program"]["primitives"]), {id(c): n for n, c in bodies.items()}
    for step in range(round(m["program"]["duration"] / dt)):
        t, due = step * dt, (step + 0.5) * dt
        for p in list(program):
            body, start = bodies[p["body"]], p.get("time", p.get("start"))
            if start > due:
                continue
            if p["kind"] == "HoldVelocity":
                touched = any({p["body"], o} in touching for o in p["until_contact"])
                if (touched and id(p) in driving) or (p["end"] is not None and due > p["end"]):
                    program.remove(p)
                    continue
                driving.add(id(p))
                speed = max(0.0, p["speed"] + p["acceleration"] * (t - start))
                if p["acceleration"] > 0 and p["max_speed"] is not None:
                    speed = min(speed, p["max_speed"])
                angle = p["heading"] + p["turn_rate"] * (t - start)
                vx, vy, r = speed * math.cos(angle), speed * math.sin(angle), p["roll_radius"]
                body.linear_velocity = [vx, vy, body.linear_velocity[2]]
                body.angular_velocity = [-vy / r, vx / r, 0] if r else [0, 0, p["turn_rate"]]
                continue
            program.remove(p)
            if p["kind"] == "SetVelocity":
                body.linear_velocity = p["linear"]
                if p["angular"] is not None:
                    body.angular_velocity = p["angular"]
            elif p["kind"] == "ApplyImpulse":
                body.linear_velocity = body.linear_velocity + np.array(p["impulse"]) / body.mass
            else:
                for key in ("linear_damping", "angular_damping"):
                    if p[key] is not None:
                        setattr(body, key, p[key])
                if p["friction"] is not None:
                    material = body.collision_shapes[0].physical_material
                    material.static_friction = material.dynamic_friction = p["friction"]
        system.step()
        touching = []
        for contact in system.get_contacts():
            pair = tuple(names.get(id(c)) for c in contact.bodies)
            impulse = sum(float(np.dot(q.impulse, q.normal)) for q in contact.points)
            if None not in pair and impulse > 0:
                touching.append(set(pair))
                if pair not in seen:
                    seen.add(pair)
                    print(f"{t + dt:.4f} s  {pair[0]} hits {pair[1]}  {impulse:.2f} N s")


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        play(json.load(file))
