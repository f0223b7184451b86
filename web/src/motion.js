// One replay: poses, speeds and contacts at any time.

export class Motion {
  constructor(replay, arrays, k) {
    Object.assign(this, replay);
    this.time = arrays[`time${k}`];
    this.positions = arrays[`position${k}`];
    this.turns = arrays[`turn${k}`];
    this.speeds = arrays[`speed${k}`];
    this.wheels = arrays[`wheels${k}`];
    this.end = this.time[this.time.length - 1];
    this.column = new Map(this.moving.map((body, c) => [body, c]));
  }

  // Index of the frame at or before t, and how far t is on the way to the next.
  at(t) {
    let low = 0;
    let high = this.time.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.time[middle] <= t) low = middle;
      else high = middle;
    }
    const span = this.time[high] - this.time[low];
    return [low, span > 0 ? Math.min(1, Math.max(0, (t - this.time[low]) / span)) : 0];
  }

  // Writes x, y, z, qx, qy, qz, qw of a body's centre of mass into out.
  pose(body, t, out) {
    const c = this.column.get(body);
    if (c === undefined) {
      for (let i = 0; i < 7; i++) out[i] = this.start[body][i];
      return out;
    }
    const n = this.moving.length;
    const [f, u] = this.at(t);
    const g = Math.min(f + 1, this.time.length - 1);
    for (let i = 0; i < 3; i++) {
      out[i] = this.positions[(f * n + c) * 3 + i] * (1 - u) + this.positions[(g * n + c) * 3 + i] * u;
    }
    let length = 0;
    for (let i = 0; i < 4; i++) {
      out[3 + i] = this.turns[(f * n + c) * 4 + i] * (1 - u) + this.turns[(g * n + c) * 4 + i] * u;
      length += out[3 + i] ** 2;
    }
    length = Math.sqrt(length) || 1;
    for (let i = 3; i < 7; i++) out[i] /= length;
    return out;
  }

  // Angle [rad] of a wheel, counted over all bodies.
  angle(wheel, t) {
    if (!this.wheels) return 0;
    const n = this.wheels.length / this.time.length;
    const [f, u] = this.at(t);
    const g = Math.min(f + 1, this.time.length - 1);
    return this.wheels[f * n + wheel] * (1 - u) + this.wheels[g * n + wheel] * u;
  }

  speed(body, frame) {
    const c = this.column.get(body);
    return c === undefined ? 0 : this.speeds[frame * this.moving.length + c];
  }

  center(body, frame) {
    const c = this.column.get(body);
    if (c === undefined) return this.start[body].slice(0, 3);
    const at = (frame * this.moving.length + c) * 3;
    return [this.positions[at], this.positions[at + 1], this.positions[at + 2]];
  }
}
