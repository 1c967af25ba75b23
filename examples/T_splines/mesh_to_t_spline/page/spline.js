// The T-spline surface of the page and what is computed from it once.

// null if there is none. points: 3 coordinates per point, in the frame of the mesh; normals: 3 multiples of 1/32767 per
// point; curvature: 1 per point, in the units of the model, NaN where undefined; deviation: 1 per point, the distance from the
// mesh by the longest side; triangles: 3 points each; those on both sides of a crease share none; net, edges, border, creases:
// segments; extraordinary, corners: 3 coordinates per point;
// cornerTurns: 1 per corner, its angle in quarter turns.
function readSpline() {
  const floats = id => new Float32Array(decode(id)), integers = id => new Uint32Array(decode(id));
  const spline = {
    points: floats("spline_points"), normals: new Int16Array(decode("spline_normals")),
    curvature: floats("spline_curvature"), deviation: floats("spline_deviation"), triangles: integers("spline_triangles"),
    net: polylineSegments(floats("net_points"), integers("net_sizes")),
    edges: polylineSegments(floats("edge_points"), integers("edge_sizes")),
    border: polylineSegments(floats("border_points"), integers("border_sizes")),
    creases: polylineSegments(floats("crease_points"), integers("crease_sizes")),
    extraordinary: floats("extraordinary_points"), corners: floats("corner_points"), cornerTurns: integers("corner_turns")
  };
  return spline.triangles.length > 0 ? spline : null;
}

// The normal of the triangle that begins at index t, twice as long as the area.
function splineTriangleNormal({ points, triangles }, t) {
  const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2];
  const px = points[b] - points[a], py = points[b + 1] - points[a + 1], pz = points[b + 2] - points[a + 2];
  const qx = points[c] - points[a], qy = points[c + 1] - points[a + 1], qz = points[c + 2] - points[a + 2];
  return [py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx];
}

// Per point, a third of the areas of its triangles.
function pointAreas(spline) {
  const areas = new Float64Array(spline.points.length / 3);
  for (let t = 0; t < spline.triangles.length; t += 3) {
    const area = Math.hypot(...splineTriangleNormal(spline, t)) / 6;
    for (let i = t; i < t + 3; ++i)
      areas[spline.triangles[i]] += area;
  }
  return areas;
}

// The triangles, turned over where the normals want it: then the front is the side that the normals point to.
function orientedTriangles(spline) {
  const { normals, triangles } = spline, result = triangles.slice();
  for (let t = 0; t < triangles.length; t += 3) {
    const normal = splineTriangleNormal(spline, t);
    let sum = 0;
    for (let i = t; i < t + 3; ++i)
      for (let d = 0; d < 3; ++d)
        sum += normal[d] * normals[3 * triangles[i] + d];
    if (sum < 0)
      [result[t + 1], result[t + 2]] = [triangles[t + 2], triangles[t + 1]];
  }
  return result;
}

// How the mean curvature is distributed over the area. bound(q): the share q of the area has no larger absolute value;
// share(x): of which share of the area this x is the bound.
function curvatureDistribution(spline) {
  const areas = pointAreas(spline), order = [];
  let low = Infinity, high = -Infinity, sum = 0;
  spline.curvature.forEach((value, i) => {
    if (Number.isFinite(value)) {
      order.push(i);
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  });
  const sizes = spline.curvature.map(Math.abs);
  order.sort((i, j) => sizes[i] - sizes[j]);
  const sums = order.map(i => sum += areas[i]);
  const firstWhere = holds => {
    let begin = 0, end = order.length;
    while (begin < end) {
      const middle = (begin + end) >> 1;
      [begin, end] = holds(middle) ? [begin, middle] : [middle + 1, end];
    }
    return begin;
  };
  return {
    low, high, isKnown: order.length > 0,
    bound: q => sizes[order[Math.min(order.length - 1, firstWhere(i => sums[i] >= q * sum))]],
    share: x => {
      const end = firstWhere(i => sizes[order[i]] > x);
      return end > 0 ? sums[end - 1] / sum : 0;
    }
  };
}

// The largest curvature of the colour map, with two digits: 95 % of the area have less. (Of a plane one would see only
// round-off.)
function curvatureRange(distribution, diagonal) {
  const least = 1e-6 / diagonal;
  if (!distribution.isKnown)
    return least;
  return roundedUp(Math.max(distribution.bound(0.95), least));
}

// The smallest number with two digits that is not below x > 0.
function roundedUp(x) {
  const unit = 10 ** (Math.floor(Math.log10(x)) - 1);
  return +(Math.ceil(x / unit - 1e-9) * unit).toPrecision(2);
}

// The largest deviation of the colour map. (Without any one would see only round-off.)
function deviationRange(deviation) {
  return roundedUp(deviation.reduce((x, y) => Math.max(x, y), 1e-9));
}

// What the surface is drawn from; values: per point the curvature and 1, or 0 and 0 where it is undefined, and the
// deviation.
function splineBuffers(spline) {
  const values = new Float32Array(spline.points.length);
  spline.curvature.forEach((value, i) => values.set(Number.isFinite(value) ? [value, 1] : [0, 0], 3 * i));
  spline.deviation.forEach((value, i) => { values[3 * i + 2] = value; });
  return { position: spline.points, normal: spline.normals, values, triangles: orientedTriangles(spline) };
}
