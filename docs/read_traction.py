"""What the ground does to the bodies of a manifest.json beyond contacts, before every step.

read_manifest.py beside this file calls it, with bodies as described there.
"""

import math


class Traction:
    def __init__(self, manifest):
        bodies = [b for b in manifest["bodies"] if b["shapes"] and not b["static"]]
        primitives = manifest["program"]["primitives"]
        braked = {p["body"] for p in primitives if p.get("braking") is not None}
        self.bodies = {b["name"]: b for b in bodies if b["name"] in braked or "tyre_friction" in b}
        self.braking = dict.fromkeys(self.bodies, 0.0)
        self.gravity_z, self.before, self.falling = manifest["gravity"][2], {}, set()
        self.tips = {}

    def look(self, dt, body_of):
        """Before the primitives: what fell freely, nothing carries; what a blow met, tips over."""
        self.falling = set()
        for name, old in self.before.items():
            x, y, z = (a - v for v, a in zip(body_of(name).linvel, old, strict=True))
            if z > -0.5 * self.gravity_z * dt:
                self.falling.add(name)
            b = self.bodies[name]
            if "tyre_friction" in b and "tyre_drop" in b and math.hypot(x, y) > 1.0:
                self.tips[name] = 0.5

    def adjust(self, p):
        """An AdjustProperties fires."""
        if p.get("braking") is not None and p["body"] in self.braking:
            self.braking[p["body"]] = p["braking"]

    def act(self, dt, lasting, body_of):
        """After the primitives, of which `lasting` have set velocities in this step."""
        driven = {p["body"] for p in lasting if p["kind"] != "HoldSpin"}
        for name, b in self.bodies.items():
            body = body_of(name)
            self.before[name] = tuple(body.linvel)
            if name in driven:
                self.tips[name] = 0.0
            elif name not in self.falling:
                taken = brake(b, body, self.braking[name] * dt)
                grip = -b.get("tyre_friction", 0.0) * self.gravity_z * dt
                if grip > taken:
                    tyres(b, body, math.sqrt(grip**2 - taken**2))
                self.before[name] = tuple(body.linvel)
                if self.tips.get(name, 0.0) > 0:
                    self.tips[name] -= dt
                    tip(body)


def brake(b, body, loss):
    """Takes up to `loss` of the horizontal velocity; returns how much."""
    x, y, z = body.linvel
    taken = min(loss, math.hypot(x, y))
    if taken > 0:
        k = 1.0 - taken / math.hypot(x, y)
        body.linvel = (x * k, y * k, z)
        if b["roll_radius"] > 0:
            x, y, z = body.angvel
            body.angvel = (x * k, y * k, z)
    return taken


def tyres(b, body, limit):
    """Two axles, each with half the grip, against sliding to the side."""
    x, y, z, w = body.rotation.quaternion
    if 1 - 2 * (x * x + y * y) <= math.sqrt(0.5):
        return
    fx, fy = 1 - 2 * (y * y + z * z), 2 * (x * y + z * w)
    fx, fy = fx / math.hypot(fx, fy), fy / math.hypot(fx, fy)
    (vx, vy, vz), (wx, wy, wz) = body.linvel, body.angvel
    axle, drop = math.sqrt(b["inertia"][2][2] / b["mass"]), b.get("tyre_drop", 0.0)
    lean = b["mass"] * drop / b["inertia"][0][0]
    slip = (fx * vy - fy * vx + drop * (fx * wx + fy * wy)) / (1 + drop * lean)
    front, rear = (max(-limit, min(limit, slip + s * axle * wz)) for s in (1, -1))
    a, yaw = (front + rear) / 2, (front - rear) / 2 / axle
    body.linvel = (vx + fy * a, vy - fx * a, vz)
    body.angvel = (wx - fx * lean * a, wy - fy * lean * a, wz - yaw)


def tip(body):
    """Leans at 2.5 rad/s at least, on to the side it leans to, until it does not stand any more."""
    x, y, z, w = body.rotation.quaternion
    if 1 - 2 * (x * x + y * y) <= math.sqrt(0.5):
        return
    fx, fy = 1 - 2 * (y * y + z * z), 2 * (x * y + z * w)
    fx, fy = fx / math.hypot(fx, fy), fy / math.hypot(fx, fy)
    wx, wy, wz = body.angvel
    lean, right = fx * wx + fy * wy, fy * 2 * (x * z + y * w) - fx * 2 * (y * z - x * w)
    if abs(lean) < 2.5:
        left = lean < 0 if abs(lean) > 0.05 else right < -0.001
        more = (-2.5 if left else 2.5) - lean
        body.angvel = (wx + fx * more, wy + fy * more, wz)
