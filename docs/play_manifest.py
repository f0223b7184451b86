"""Plays a manifest.json in Rapier with nothing of this project: python play_manifest.py FILE"""

import json
import sys

import numpy as np
import rapier3d as r
from read_manifest import Program

GROUND, ROAD, BODY, WHEELED = 1, 2, 4, 8  # collision groups: wheels touch a ground of their own


def frame(data):
    turn = r.Rotation3.from_ndarray(np.array(data["quaternion"]))
    return r.Isometry3(tuple(data["position"]), turn)


def shape(s):
    (x, y, z), circle = s["size"], np.exp(2j * np.pi * np.arange(32) / 32)
    prism = [(x * c.real, x * c.imag, h) for c in circle for h in (-z, z)]  # stands for a cylinder
    makers = {"sphere": ("ball", x), "box": ("cuboid", x, y, z), "capsule": ("capsule_z", z, x)}
    name, *size = makers.get(s["kind"], ("convex_hull", np.float32(s["vertices"] or prism)))
    return getattr(r.Collider, name)(*size).position(frame(s))


def surface(builder, friction, restitution, group, touches):
    groups = r.InteractionGroups(r.Group(group), r.Group(touches))
    return builder.friction(friction).restitution(restitution).density(0).collision_groups(groups)


def rigid(b):
    """Rapier damps by v /= 1 + c dt, which is the manifest's v *= 1 - c dt for small c dt."""
    if b["static"]:
        return r.RigidBody.fixed().position(frame(b))
    moments, axes = np.linalg.eigh(b["inertia"])
    axes = r.Rotation3.face_toward(tuple(axes[:, 2]), tuple(axes[:, 1]))
    mass = r.MassProperties((0, 0, 0), b["mass"], tuple(moments), axes)
    body = r.RigidBody.dynamic().can_sleep(False).position(frame(b)).soft_ccd_prediction(0.25)
    body = body.linear_damping(b["linear_damping"]).angular_damping(b["angular_damping"])
    return body.additional_mass_properties(mass)


def build(m):
    world, ground, handles, owner = r.PhysicsWorld(gravity=m["gravity"]), m["ground"], {}, {}
    world.integration_parameters.dt = m["dt"]
    for mu, group, on in (("friction", GROUND, BODY), ("vehicle_friction", ROAD, WHEELED)):
        plane = r.Collider.halfspace((0, 0, 1))
        world.add_collider(surface(plane, ground[mu], ground["restitution"], group, on))
    for b in m["bodies"]:
        handles[b["name"]] = world.add_body(rigid(b))
        group, near = (WHEELED, ROAD) if b["wheeled"] else (BODY, GROUND)
        for s in b["shapes"]:
            own = surface(shape(s), b["friction"], b["restitution"], group, near | BODY | WHEELED)
            owner[world.add_collider(own, handles[b["name"]])] = b["name"]
    return world, handles, owner


def play(m):
    """Prints the first touch of every pair of bodies."""
    (world, handles, owner), program, touching, seen = build(m), Program(m), [], []

    def set_friction(name, value):
        for collider in (c for c, body in owner.items() if body == name):
            world.colliders[collider].friction = value

    for step in range(round(m["program"]["duration"] / m["dt"])):
        t = step * m["dt"]
        program.before_step(
            t, m["dt"], lambda n: world.rigid_bodies[handles[n]], touching, set_friction
        )
        world.step()
        touching = []
        for contact in world.narrow_phase.contact_pairs():
            impulse = sum(p.impulse for manifold in contact.manifolds for p in manifold.points)
            pair = {owner.get(contact.collider1), owner.get(contact.collider2)}
            if impulse > 0 and None not in pair:
                touching.append(pair)
                if pair not in seen:
                    seen.append(pair)
                    print(f"{t + m['dt']:.4f} s  {' hits '.join(sorted(pair))}  {impulse:.2f} N s")


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        play(json.load(file))
