// The mesh of the page and what is computed from it once.

function decode(id) {
  const element = document.getElementById(id);
  const text = atob(element.textContent);
  element.remove();
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

// positions: 3 per vertex, the bounding box is centred at 0 and has diagonal 2.
// uv: 2 per uv vertex, in double precision; uvVertices: the vertex of each; triangles: 3 uv vertices each.
// edgeFlags: per triangle, bit i: the side opposite to corner i lies on an edge of the input; bit 3 + i: it is cut.
function readMesh() {
  return {
    positions: new Float32Array(decode("positions")),
    uv: new Float64Array(decode("uv")),
    uvVertices: new Uint32Array(decode("uv_vertices")),
    triangles: new Uint32Array(decode("triangles")),
    edgeFlags: new Uint8Array(decode("edge_flags"))
  };
}

// The T-mesh before and after regularization; null if there is none. sizes: the number of points of each polyline, one
// per edge; joints: the T-joints, 3 coordinates each.
function readTMesh(name) {
  const points = new Float32Array(decode(`${name}_points`)), sizes = new Uint32Array(decode(`${name}_sizes`));
  const joints = new Float32Array(decode(`${name}_joints`));
  return sizes.length > 0 ? { segments: polylineSegments(points, sizes), joints } : null;
}

// 6 coordinates per segment of the polylines, of which the points are given one after the other.
function polylineSegments(points, sizes) {
  const segments = new Float32Array(6 * sizes.reduce((sum, size) => sum + size - 1, 0));
  let point = 0, end = 0;
  for (const size of sizes) {
    for (let i = 1; i < size; ++i, point += 3, end += 6)
      segments.set(points.subarray(point, point + 6), end);
    point += 3;
  }
  return segments;
}

// Per triangle: area in space, area in the plane, dilatation (larger over smaller singular value), normal.
function measureTriangles(mesh) {
  const { positions, uv, uvVertices, triangles } = mesh;
  const count = triangles.length / 3;
  const area = new Float64Array(count), uvArea = new Float64Array(count);
  const dilatation = new Float32Array(count), normals = new Float32Array(3 * count);
  for (let t = 0; t < count; ++t) {
    const i = triangles[3 * t], j = triangles[3 * t + 1], k = triangles[3 * t + 2];
    const a = 3 * uvVertices[i], b = 3 * uvVertices[j], c = 3 * uvVertices[k];
    const px = positions[b] - positions[a], py = positions[b + 1] - positions[a + 1], pz = positions[b + 2] - positions[a + 2];
    const qx = positions[c] - positions[a], qy = positions[c + 1] - positions[a + 1], qz = positions[c + 2] - positions[a + 2];
    const nx = py * qz - pz * qy, ny = pz * qx - px * qz, nz = px * qy - py * qx;
    const twice = Math.sqrt(nx * nx + ny * ny + nz * nz) || 1e-30, length = Math.sqrt(px * px + py * py + pz * pz) || 1e-30;
    // The sides are (length, 0) and (x, y) in the plane of the triangle; the map sends the unit vectors to r and s.
    const x = (px * qx + py * qy + pz * qz) / length, y = twice / length;
    const ru = (uv[2 * j] - uv[2 * i]) / length, rv = (uv[2 * j + 1] - uv[2 * i + 1]) / length;
    const su = (uv[2 * k] - uv[2 * i] - x * ru) / y, sv = (uv[2 * k + 1] - uv[2 * i + 1] - x * rv) / y;
    const det = ru * sv - rv * su, sum = ru * ru + rv * rv + su * su + sv * sv;
    const root = Math.sqrt(Math.max(0, sum * sum - 4 * det * det));
    area[t] = twice / 2;
    uvArea[t] = det * twice / 2;
    dilatation[t] = det > 0 ? (sum + root) / (2 * det) : Infinity; // = sqrt((sum + root) / (sum - root))
    normals[3 * t] = nx / twice;
    normals[3 * t + 1] = ny / twice;
    normals[3 * t + 2] = nz / twice;
  }
  return { area, uvArea, dilatation, normals };
}

// Per uv vertex: binary logarithm of the length of the map, plane over space, averaged over its triangles and smoothed.
function logScales(mesh, measure) {
  const { uvVertices, triangles } = mesh;
  let scale = new Float64Array(uvVertices.length);
  const ofTriangle = measure.area.map((a, t) => Math.log2(Math.max(measure.uvArea[t], 1e-300) / Math.max(a, 1e-300)) / 2);
  const ofCorners = (t, values) => (values[triangles[3 * t]] + values[triangles[3 * t + 1]] + values[triangles[3 * t + 2]]) / 3;
  for (let pass = 0; pass < 3; ++pass) {
    const next = new Float64Array(scale.length), weight = new Float64Array(scale.length);
    for (let t = 0; t < ofTriangle.length; ++t) {
      const w = measure.area[t] + 1e-14, value = pass === 0 ? ofTriangle[t] : ofCorners(t, scale);
      for (let i = 0; i < 3; ++i) {
        next[triangles[3 * t + i]] += w * value;
        weight[triangles[3 * t + i]] += w;
      }
    }
    scale = next.map((value, v) => value / weight[v]);
  }
  return scale;
}

// The triangles at each vertex: those of v are list[first[v]] ... list[first[v + 1] - 1].
function trianglesOfVertices(mesh) {
  const count = mesh.positions.length / 3;
  const first = new Uint32Array(count + 1), list = new Uint32Array(mesh.triangles.length);
  for (const i of mesh.triangles)
    ++first[mesh.uvVertices[i] + 1];
  for (let v = 0; v < count; ++v)
    first[v + 1] += first[v];
  const next = first.slice();
  for (let c = 0; c < mesh.triangles.length; ++c)
    list[next[mesh.uvVertices[mesh.triangles[c]]]++] = (c / 3) | 0;
  return { first, list };
}

// Per corner, three signed bytes and a filler: the mean normal of the triangles at the vertex that are within the
// crease angle.
function cornerNormals(mesh, measure) {
  const crease = Math.cos(50 * Math.PI / 180);
  const { first, list } = trianglesOfVertices(mesh);
  const { normals, area } = measure;
  const result = new Int8Array(4 * mesh.triangles.length);
  for (let c = 0; c < mesh.triangles.length; ++c) {
    const t = 3 * ((c / 3) | 0), v = mesh.uvVertices[mesh.triangles[c]];
    let x = 0, y = 0, z = 0;
    for (let i = first[v]; i < first[v + 1]; ++i) {
      const s = 3 * list[i];
      if (normals[t] * normals[s] + normals[t + 1] * normals[s + 1] + normals[t + 2] * normals[s + 2] > crease) {
        const w = area[list[i]] + 1e-14;
        x += w * normals[s];
        y += w * normals[s + 1];
        z += w * normals[s + 2];
      }
    }
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    result[4 * c] = 127 * x / length;
    result[4 * c + 1] = 127 * y / length;
    result[4 * c + 2] = 127 * z / length;
  }
  return result;
}

function median(values) {
  const sorted = Float64Array.from(values).sort();
  return sorted[sorted.length >> 1];
}

function quantile(values, q) {
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))];
}

// The logarithm of the cell size, near the given one, for which the least area lies where the pattern fades from one
// power
// of two to the next: half way between them.
function bestOffset(mesh, measure, scale, cell) {
  const bins = 64, width = 14, weight = new Float64Array(bins), offset = Math.log2(cell);
  for (let t = 0; t < measure.area.length; ++t) {
    const level = scale[mesh.triangles[3 * t]] + offset;
    weight[Math.floor((level - Math.floor(level)) * bins) % bins] += measure.area[t];
  }
  let best = 0, least = Infinity;
  for (let shift = -bins / 2; shift < bins / 2; ++shift) {
    let sum = 0;
    for (let i = 0; i < width; ++i)
      sum += weight[(((bins - width) / 2 + i - shift) % bins + bins) % bins];
    if (sum < least || (sum === least && Math.abs(shift) < Math.abs(best)))
      [best, least] = [shift, sum];
  }
  return offset + best / bins;
}

// What the surface is drawn from, per corner. The uv of a triangle is relative to an origin of its own, a multiple of
// 2^8
// of its cells, and in units of a power of two near its cell: so single precision does however far the sizes in
// the plane are apart, and neighbouring triangles still continue each other's pattern.
function surfaceBuffers(mesh, measure, cell) {
  const corners = mesh.triangles.length, { uv, triangles } = mesh;
  const scale = logScales(mesh, measure), offset = bestOffset(mesh, measure, scale, cell);
  const buffers = {
    position: new Float32Array(3 * corners), normal: cornerNormals(mesh, measure), uv: new Float32Array(2 * corners),
    level: new Float32Array(corners), scale: new Float32Array(corners), dilatation: new Float32Array(corners),
    flags: new Uint8Array(corners), corners
  };
  const middle = median(scale);
  for (let t = 0; 3 * t < corners; ++t) {
    const first = triangles[3 * t];
    const octave = Math.round((scale[first] + scale[triangles[3 * t + 1]] + scale[triangles[3 * t + 2]]) / 3 + offset);
    const unit = 2 ** octave, period = 256 * unit;
    const originU = Math.round(uv[2 * first] / period) * period, originV = Math.round(uv[2 * first + 1] / period) * period;
    for (let c = 3 * t; c < 3 * t + 3; ++c) {
      const i = triangles[c], v = 3 * mesh.uvVertices[i];
      for (let d = 0; d < 3; ++d)
        buffers.position[3 * c + d] = mesh.positions[v + d];
      buffers.uv[2 * c] = (uv[2 * i] - originU) / unit;
      buffers.uv[2 * c + 1] = (uv[2 * i + 1] - originV) / unit;
      buffers.level[c] = scale[i] + offset - octave;
      buffers.scale[c] = 2 * (scale[i] - middle);
      buffers.dilatation[c] = Math.min(Math.log2(measure.dilatation[t]), 64);
      buffers.flags[c] = mesh.edgeFlags[t];
    }
  }
  buffers.scaleRange = Math.max(1, quantile(scale.map(value => Math.abs(2 * (value - middle))), 0.99));
  return buffers;
}

// The sides of triangles that have no other triangle: 6 coordinates per edge.
function borderSegments({ positions, uvVertices, triangles }) {
  const count = positions.length / 3, sides = new Map();
  for (let c = 0; c < triangles.length; ++c) {
    const v = uvVertices[triangles[c]], w = uvVertices[triangles[c % 3 === 2 ? c - 2 : c + 1]];
    const key = Math.min(v, w) * count + Math.max(v, w);
    if (!sides.delete(key))
      sides.set(key, [v, w]);
  }
  const segments = new Float32Array(6 * sides.size);
  let end = 0;
  for (const [v, w] of sides.values()) {
    segments.set(positions.subarray(3 * v, 3 * v + 3), end);
    segments.set(positions.subarray(3 * w, 3 * w + 3), end + 3);
    end += 6;
  }
  return segments;
}

// The cut, each edge once: 6 coordinates per edge.
function cutSegments(mesh) {
  const segments = [];
  for (let t = 0; 3 * t < mesh.triangles.length; ++t)
    for (let i = 0; i < 3; ++i)
      if (mesh.edgeFlags[t] & (8 << i)) {
        const v = mesh.uvVertices[mesh.triangles[3 * t + (i + 1) % 3]], w = mesh.uvVertices[mesh.triangles[3 * t + (i + 2) % 3]];
        if (v < w)
          segments.push(...mesh.positions.subarray(3 * v, 3 * v + 3), ...mesh.positions.subarray(3 * w, 3 * w + 3));
      }
  return new Float32Array(segments);
}
