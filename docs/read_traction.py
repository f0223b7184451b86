"""What the ground does to the bodies of a manifest.json beyond contacts, before every step.

read_manifest.py beside this file calls it, with bodies as described there.
"""

import math


class Traction:
    def __init__(self, manifest):
        bodies = [b for b in manifest["bodies"] if b["shapes"] and not b["static"]]
        primitives = manifest["program"]["primitives"]
        braked = {p["body"] for p in primitives if p.get("braking") is not None}
        self.braking = {b["name"]: 0.0 for b in bodies if b["name"] in braked}
        self.round = {b["name"] for b in bodies if b["roll_radius"] > 0}
        self.gravity_z, self.rise = manifest["gravity"][2], {}

    def adjust(self, p):
        """An AdjustProperties fires."""
        if p.get("braking") is not None and p["body"] in self.braking:
            self.braking[p["body"]] = p["braking"]

    def act(self, dt, lasting, body_of):
        """After the primitives, of which `lasting` have set velocities in this step."""
        driven = {p["body"] for p in lasting if p["kind"] != "HoldSpin"}
        for name, braking in self.braking.items():
            body = body_of(name)
            z = tuple(body.linvel)[2]
            falls = self.rise.get(name, -math.inf) - z > -0.5 * self.gravity_z * dt
            self.rise[name] = z
            if name not in driven and not falls:
                self.brake(body, braking * dt, name in self.round)

    def brake(self, body, loss, rolls):
        x, y, z = body.linvel
        k = max(0.0, 1.0 - loss / (math.hypot(x, y) or math.inf))
        body.linvel = (x * k, y * k, z)
        if rolls:
            x, y, z = body.angvel
            body.angvel = (x * k, y * k, z)
