// A camera that turns about a point: orientation as a rotation matrix in rows, matrices for the shaders in columns.

function axisRotation(axis, angle) {
  const [x, y, z] = axis, c = Math.cos(angle), s = Math.sin(angle), t = 1 - c;
  return [[t * x * x + c, t * x * y - s * z, t * x * z + s * y],
          [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
          [t * x * z - s * y, t * y * z + s * x, t * z * z + c]];
}

function multiply(a, b) {
  return a.map(row => [0, 1, 2].map(j => row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j]));
}

class Camera {
  // positions: 3 per point of what is to be seen at first; radius: all that is drawn is that near to 0.
  constructor(positions, radius) {
    this.fieldOfView = 28 * Math.PI / 180;
    this.home = Camera.firstRotation(positions);
    this.positions = positions;
    this.radius = radius;
    this.reset(1);
  }

  // Looks along the axis of the least extent, y up unless that is the axis, a little from the left and from above.
  static firstRotation(positions) {
    const low = [0, 0, 0], high = [0, 0, 0];
    for (let i = 0; i < positions.length; ++i) {
      low[i % 3] = Math.min(low[i % 3], positions[i]);
      high[i % 3] = Math.max(high[i % 3], positions[i]);
    }
    const extent = high.map((x, d) => x - low[d]), least = Math.min(...extent);
    const frames = {
      z: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
      x: [[0, 0, -1], [0, 1, 0], [1, 0, 0]],
      y: [[1, 0, 0], [0, 0, 1], [0, -1, 0]]
    };
    const frame = extent[2] <= 1.2 * least ? frames.z : extent[0] <= 1.2 * least ? frames.x : frames.y;
    const turn = axisRotation([0, 1, 0], -0.55), nod = axisRotation([1, 0, 0], 0.35);
    return multiply(nod, multiply(turn, frame));
  }

  // The first view: the whole model, as large as it goes.
  reset(aspect) {
    this.rotation = this.home;
    const half = Math.tan(this.fieldOfView / 2);
    const p = this.positions;
    const bound = (row, scale) => {
      let low = Infinity, high = -Infinity;
      for (let i = 0; i < p.length; i += 3) {
        const x = row[0] * p[i] + row[1] * p[i + 1] + row[2] * p[i + 2];
        low = Math.min(low, x);
        high = Math.max(high, x);
      }
      return { middle: (low + high) / 2, size: (high - low) / scale };
    };
    const r = this.rotation, x = bound(r[0], half * aspect), y = bound(r[1], half), z = bound(r[2], 1);
    this.pivot = [0, 1, 2].map(d => r[0][d] * x.middle + r[1][d] * y.middle + r[2][d] * z.middle);
    this.distance = 1.12 * Math.max(x.size, y.size) / 2 + 0.5 * z.size;
  }

  turn(dx, dy) {
    const angle = Math.hypot(dx, dy);
    if (angle > 0)
      this.rotation = multiply(axisRotation([dy / angle, dx / angle, 0], angle), this.rotation);
    // Round-off would shear the model in time.
    const unit = v => v.map(a => a / Math.hypot(...v));
    const x = unit(this.rotation[0]), b = this.rotation[1], d = b[0] * x[0] + b[1] * x[1] + b[2] * x[2];
    const y = unit(b.map((v, i) => v - d * x[i]));
    this.rotation = [x, y, [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]];
  }

  // Looks at a point from the side that a normal points to.
  lookAt(point, normal, distance) {
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const unit = v => v.map(a => a / Math.hypot(...v));
    const z = unit(normal), up = [this.home[1], this.home[0]].find(v => Math.hypot(...cross(v, z)) > 0.3);
    const x = unit(cross(up, z));
    this.rotation = [x, cross(z, x), z];
    this.pivot = [...point];
    this.distance = distance;
  }

  // By fractions of the height of the view.
  move(dx, dy) {
    const size = 2 * this.distance * Math.tan(this.fieldOfView / 2);
    this.pivot = this.pivot.map((p, d) => p - size * (dx * this.rotation[0][d] - dy * this.rotation[1][d]));
  }

  zoom(factor) { this.distance = Math.min(40, Math.max(0.01, this.distance * factor)); }

  view() {
    const r = this.rotation, p = this.pivot;
    const t = r.map(row => -(row[0] * p[0] + row[1] * p[1] + row[2] * p[2]));
    return [r[0][0], r[1][0], r[2][0], 0, r[0][1], r[1][1], r[2][1], 0, r[0][2], r[1][2], r[2][2], 0,
            t[0], t[1], t[2] - this.distance, 1];
  }

  projection(aspect) {
    const f = 1 / Math.tan(this.fieldOfView / 2), reach = 1.05 * this.radius + Math.hypot(...this.pivot);
    const near = Math.max(this.distance - reach, 0.02 * this.distance), far = this.distance + reach;
    return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0];
  }

  // The place of a point on the canvas in [-1, 1]^2, and its distance from the viewer.
  project(point, aspect) {
    const m = this.view(), f = 1 / Math.tan(this.fieldOfView / 2);
    const [x, y, z] = [0, 1, 2].map(i => m[i] * point[0] + m[4 + i] * point[1] + m[8 + i] * point[2] + m[12 + i]);
    return [f / aspect * x / -z, f * y / -z, -z];
  }
}
