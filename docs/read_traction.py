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
        self.tips = set()

    def look(self, dt, body_of):
        """Before the primitives: what fell freely, nothing carries; what a blow met, tips over."""
        self.falling = set()
        for name, old in self.before.items():
            x, y, z = (a - v for v, a in zip(body_of(name).linvel, old, strict=True))
            if z > -0.5 * self.gravity_z * dt:
                self.falling.add(name)
            b = self.bodies[name]
            if "tyre_friction" in b and "tyre_drop" in b and math.hypot(x, y) > 1.0:
                self.tips.add(name)

    def adjust(self, p):
        """An AdjustProperties fires."""
        if p.get("braking") is not None and p["body"] in self.braking:
            self.braking[p["body"]] = p["braking"]

    def act(self, dt, lasting, body_of):
        """After the primitives, of which `lasting` have set velocities in this step."""
        driven = {p["body"] for p in lasting if p["kind"] in ("HoldVelocity", "GuideAlong")}
        for name, b in self.bodies.items():
            body = body_of(name)
            self.before[name] = tuple(body.linvel)
            if name in driven:
                self.tips.discard(name)
            elif name not in self.falling:
                taken = brake(b, body, self.braking[name] * dt)
                grip = -b.get("tyre_friction", 0.0) * self.gravity_z * dt
                if grip > taken:
                    tyres(b, body, math.sqrt(grip**2 - taken**2))
                if name in self.tips:
                    self.tips.discard(name)
                    tip(b, body)
                self.before[name] = tuple(body.linvel)


def brake(b, body, loss):
    """Takes up to `loss` of the horizontal velocity; returns how much."""
    vx, vy, vz = body.linvel
    along = wheels_ahead(body) if b.get("tyre_drop", 0.0) > 0 else None
    x, y = (vx, vy) if along is None else ((vx * along[0] + vy * along[1]) * c for c in along)
    taken = min(loss, math.hypot(x, y))
    if taken > 0:
        k = 1.0 - taken / math.hypot(x, y)
        body.linvel = (vx - (1 - k) * x, vy - (1 - k) * y, vz)
        if b["roll_radius"] > 0:
            x, y, z = body.angvel
            body.angvel = (x * k, y * k, z)
    return taken


def wheels_ahead(body):
    """Where the wheels of a body point to, None if it does not stand on them."""
    x, y, z, w = body.rotation.quaternion
    if 1 - 2 * (x * x + y * y) <= math.sqrt(0.5):
        return None
    fx, fy = 1 - 2 * (y * y + z * z), 2 * (x * y + z * w)
    return fx / math.hypot(fx, fy), fy / math.hypot(fx, fy)


def tyres(b, body, limit):
    """Two axles, each with half the grip, against sliding to the side."""
    x, y, z, w = body.rotation.quaternion
    if (ahead := wheels_ahead(body)) is None:
        return
    fx, fy = ahead
    (vx, vy, vz), (wx, wy, wz) = body.linvel, body.angvel
    axle, tilt = (
        math.sqrt(b["inertia"][2][2] / b["mass"]),
        abs(fy * 2 * (x * z + y * w) - fx * 2 * (y * z - x * w)),
    )
    height = b.get("tyre_drop", 0.0) * (1 - 2 * (x * x + y * y)) + b.get("tyre_foot", 0.0) * tilt
    lean = b["mass"] * height / b["inertia"][0][0]
    slip = (fx * vy - fy * vx + height * (fx * wx + fy * wy)) / (1 + height * lean)
    front, rear = (max(-limit, min(limit, slip + s * axle * wz)) for s in (1, -1))
    a, yaw = (front + rear) / 2, (front - rear) / 2 / axle
    body.linvel = (vx + fy * a, vy - fx * a, vz)
    body.angvel = (wx - fx * lean * a, wy - fy * lean * a, wz - yaw)


def tip(b, body):
    """Turns over the edge of its foot, to the side that it leans to."""
    x, y, z, w = body.rotation.quaternion
    if (ahead := wheels_ahead(body)) is None:
        return
    fx, fy = ahead
    (vx, vy, vz), (wx, wy, wz) = body.linvel, body.angvel
    lean, right = fx * wx + fy * wy, fy * 2 * (x * z + y * w) - fx * 2 * (y * z - x * w)
    mass, drop, foot = b["mass"], b["tyre_drop"], b.get("tyre_foot", 0.0)
    reach = math.hypot(drop, foot)
    uphill = 2 * mass * 9.81 * (reach - drop) / (b["inertia"][0][0] + mass * reach**2)
    rate = math.sqrt(4 + uphill)
    if abs(lean) < rate:
        left = lean < 0 if abs(lean) > 0.05 else right < -0.001
        more, foot = (-rate if left else rate) - lean, -foot if left else foot
        # From the edge to the centre of mass: (0, foot, drop) in body axes.
        ax, ay = (
            foot * 2 * (x * y - z * w) + drop * 2 * (x * z + y * w),
            (foot * (1 - 2 * (x * x + z * z)) + drop * 2 * (y * z - x * w)),
        )
        az = foot * 2 * (y * z + x * w) + drop * (1 - 2 * (x * x + y * y))
        body.linvel = (vx + fy * more * az, vy - fx * more * az, vz + more * (fx * ay - fy * ax))
        body.angvel = (wx + fx * more, wy + fy * more, wz)


def moving(p, v, speed, heading, dt):
    """Horizontal velocity of a HoldVelocity: its own, or nearer to it where it takes its time."""
    c, n = math.cos(heading), math.sin(heading)
    if "gains" not in p:
        return speed * c, speed * n
    gains, loses, was = p["gains"] * dt, p["loses"] * dt, heading - p["turn_rate"] * dt
    along = math.cos(was) * v[0] + math.sin(was) * v[1]
    across = math.cos(was) * v[1] - math.sin(was) * v[0]
    along += max(-loses, min(gains, speed - along))
    across -= max(-loses, min(loses, across))
    return c * along - n * across, n * along + c * across
