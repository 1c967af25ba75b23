// The figures of the T-spline surface and of its fit.

// A share as a percentage with some digits.
function percentText(x, digits = 3) {
  return x === null || x === undefined ? shortNumber(null) : `${+(100 * x).toPrecision(digits)} %`;
}

// Round numbers from low to high: the most that are not too many.
function logarithmicTicks(low, high) {
  const most = 6, begin = Math.floor(Math.log10(low)), end = Math.ceil(Math.log10(high));
  let best = [];
  for (const digits of [[1], [1, 3], [1, 2, 5], [1, 1.5, 2, 3, 4, 5, 7]]) {
    const ticks = Array.from({ length: end - begin + 1 }, (_, k) => digits.map(x => x * 10 ** (begin + k))).flat()
      .filter(tick => tick >= low && tick <= high);
    if (ticks.length <= most || best.length === 0)
      best = ticks;
  }
  return best;
}

// A logarithmic axis from pixel `from` to pixel `to` that contains the values.
class LogarithmicAxis {
  constructor(values, from, to) {
    const margin = 1.15;
    this.low = Math.min(...values) / margin;
    this.high = Math.max(...values) * margin;
    while (this.ticks().length < 2) {
      this.low /= margin;
      this.high *= margin;
    }
    this.place = x => from + (to - from) * Math.log(x / this.low) / Math.log(this.high / this.low);
  }

  ticks() { return logarithmicTicks(this.low, this.high); }
}

// The errors of the levels against their numbers of control points; both axes are logarithmic.
function levelPlot({ levels, tolerance, best_level }) {
  const width = 336, height = 220, left = 50, right = 22, top = 10, bottom = 42;
  const series = [["max", "maximum"], ["rms", "rms"]]
    .map(([name, key]) => ({ name, key, levels: levels.filter(level => level[key] > 0) }));
  const x = new LogarithmicAxis(levels.map(level => level.control_points), left, width - right);
  const y = new LogarithmicAxis([tolerance, ...series.flatMap(({ key, levels }) => levels.map(level => level[key]))]
    .map(error => 100 * error), height - bottom, top);
  const svg = element("svg", {
    viewBox: `0 0 ${width} ${height}`, width: "100%", role: "img", "aria-label": "Errors against the number of control points"
  });
  const line = (name, x1, y1, x2, y2) => svg.append(element("line", { class: name, x1, y1, x2, y2 }));
  const text = (content, attributes) => svg.append(element("text", attributes, content));
  for (const tick of x.ticks()) {
    line("axis", x.place(tick), top, x.place(tick), height - bottom);
    text(countText(Math.round(tick)), { x: x.place(tick), y: height - bottom + 14, "text-anchor": "middle" });
  }
  for (const tick of y.ticks()) {
    line("axis", left, y.place(tick), width - right, y.place(tick));
    text(`${+tick.toPrecision(2)}`, { x: left - 6, y: y.place(tick) + 4, "text-anchor": "end" });
  }
  text("control points", { x: (left + width - right) / 2, y: height - 8, "text-anchor": "middle" });
  const middle = (top + height - bottom) / 2;
  text("error / longest side, %", { x: 12, y: middle, "text-anchor": "middle", transform: `rotate(-90 12 ${middle})` });
  line("goal", left, y.place(100 * tolerance), width - right, y.place(100 * tolerance));
  for (const { key, levels: known } of series) {
    const points = known.map(level => [x.place(level.control_points), y.place(100 * level[key])]);
    if (points.length > 1)
      svg.append(element("path", { class: `curve ${key}`, d: `M${points.map(p => p.map(c => c.toFixed(1)).join(" ")).join("L")}` }));
    points.forEach(([cx, cy], i) => svg.append(element("circle", {
      class: `dot ${key}`, cx, cy, r: known[i] === levels[best_level] ? 4.2 : 2.6
    })));
  }
  return svg;
}

function levelTable({ levels, best_level }) {
  const head = element("thead", {}, element("tr", {}, ...["level", "control points", "in rings", "rms, %", "max, %"]
    .map(name => element("th", {}, name))));
  const rows = levels.map((level, i) => element("tr", i === best_level ? { class: "best" } : {},
    element("th", { scope: "row" }, String(i)), element("td", {}, countText(level.control_points)),
    element("td", {}, countText(level.control_points_in_rings)),
    ...[level.rms, level.maximum].map(error => element("td", {}, (100 * error).toPrecision(3)))));
  return element("div", { class: "levels" },
    element("table", { class: "columns narrow" }, head, element("tbody", {}, ...rows)));
}

// What is to be said of the surface first, as measured.
function verdictOf(spline) {
  return element("span", { class: spline.is_faultless ? "good" : "bad" }, `the surface is ${spline.verdict}`);
}

function fitSection(spline) {
  const key = element("p", { class: "note" }, element("span", { class: "stroke maximum" }), "max",
    element("span", { class: "stroke rms" }), "rms, at the samples", element("span", { class: "stroke goal" }), "tolerance");
  const ending = spline.fit_is_within_tolerance ? spline.status : `ended beyond the tolerance: ${spline.status}`;
  return section("Fit", levelPlot(spline), key, levelTable(spline),
    note(`Errors by the longest side of the bounding box; the surface is level ${spline.best_level}. At the samples: ${ending}.`),
    table([["fairness", spline.fairness], ["samples", spline.samples],
      ["faces of the T-mesh before the fit", spline.faces_before_fit]]));
}

function placeText({ t_mesh_face, u, v, mesh_face, mesh_edge, point }) {
  const numbers = values => values.map(x => String(+x.toPrecision(5))).join(", ");
  const ofMesh = mesh_edge ? `edge from vertex ${mesh_edge[0]} to ${mesh_edge[1]}` : `face ${mesh_face}`;
  return `(${numbers(point)}): face ${t_mesh_face} of the T-mesh at (${numbers([u, v])}), ${ofMesh} of the mesh`;
}

// Rounded down: 100 % only if it is all.
function shareText(x) { return `${Math.floor(1e4 * x) / 100} %`; }

function placeButton(key, name) {
  return element("button", { type: "button", class: "place", "data-place": key }, name);
}

// How far surface and mesh, or their borders, are apart, both ways.
function distanceTable({ surface_to_mesh: toMesh, mesh_to_surface: toSurface }, tolerance, measure = "area") {
  const head = element("thead", {}, element("tr", {}, ...["", "surface to mesh", "mesh to surface"]
    .map(name => element("th", {}, name))));
  const row = (name, text) => element("tr", {}, element("th", { scope: "row" }, name),
    ...[toMesh, toSurface].map(way => element("td", {}, text(way))));
  const maximum = way => element("span", { class: way.maximum <= tolerance ? "good" : "bad" }, percentText(way.maximum));
  const rows = [row("max", maximum), row("at most (proven)", way => percentText(way.upper_bound)), row("rms", way => percentText(way.rms)),
    row(`${measure} within tolerance`, way => shareText(way.share_within_tolerance)),
    row("within half of it", way => shareText(way.share_within_half))];
  return element("table", { class: "columns narrow" }, head, element("tbody", {}, ...rows));
}

// The panel of the measured deviation: what a user would find with a tool of his own.
function deviationSection(spline) {
  const { deviation, tolerance } = spline;
  const judged = (number, text) => element("span", { class: number === 0 ? "good" : "bad" }, text);
  const turned = `${+deviation.largest_angle.toPrecision(3)}°`;
  const intersections = deviation.self_intersections_beyond_mesh;
  return section("Deviation", element("p", { class: "ending" }, verdictOf(spline)), distanceTable(deviation, tolerance),
    table([["tolerance", percentText(tolerance)],
      ["folded Bezier patches", judged(deviation.folded_patches, `${countText(deviation.folded_patches)} of ${countText(spline.patches)}`)],
      ["where the mesh itself turns over within the tolerance", countText(deviation.doubtful_patches)],
      ["certified without a fold", countText(deviation.certified_patches)],
      ["largest angle of normals", judged(deviation.folded_patches, turned)],
      ["self-intersections", judged(intersections, countText(intersections))],
      ["of the mesh itself", countText(deviation.self_intersections_of_mesh)],
      ["control points", spline.levels[spline.best_level].control_points]]),
    note(`Distances by the longest side of the bounding box, ${shortNumber(spline.longest_side)}. The largest is at ${placeText(deviation.worst)}.`),
    element("p", { class: "places" }, "Go to: ", placeButton("worst", "worst place"), placeButton("angle", "largest angle"),
      ...(intersections > 0 ? [placeButton("intersection", "self-intersection")] : [])));
}

// counts: how many corners of the border have each number of quarter turns.
function cornerRows(counts) {
  return Object.entries(counts).map(([k, count]) => {
    const swatch = element("span", { class: "swatch", style: `background: ${cornerColor(+k)}` });
    return [element("span", {}, swatch, `corners, k = ${k}, angle ${90 * k}°`), countText(count)];
  });
}

// The panel of the measured distances of the creases from the features of the mesh.
function creaseSection({ deviation: { crease }, tolerance }) {
  const offBy = crease.corners > 0 ? [["corners off by at most", percentText(crease.largest_corner_distance, 2)]] : [];
  return section("Creases", distanceTable(crease, tolerance, "length"), table(offBy),
    note(`The largest distance from the features of the mesh is at ${placeText(crease.worst)}.`),
    element("p", { class: "places" }, "Go to: ", placeButton("crease", "worst place of the creases")));
}

// The panel of the measured distances between the borders.
function freeEdgeSection({ deviation: { free_edge: freeEdge }, tolerance, corners }) {
  const offBy = freeEdge.corners > 0 ? [["corners off by at most", percentText(freeEdge.largest_corner_distance, 2)]] : [];
  const key = element("p", { class: "note" }, element("span", { class: "stroke", style: `background: ${borderColor}` }),
    "the border; in the view of the deviation ", element("span", { class: "stroke thin", style: `background: ${edgeColor}` }), "that of the mesh. "
    + `The largest distance between the two is at ${placeText(freeEdge.worst)}.`);
  return section("Free edge", distanceTable(freeEdge, tolerance, "length"), table([...cornerRows(corners), ...offBy]), key,
    element("p", { class: "places" }, "Go to: ", placeButton("border", "worst place of the border")));
}

// The places that the page can go to, in the units of the model.
function knownPlaces(spline) {
  if (!spline || !spline.deviation)
    return {};
  const { worst, worst_angle, self_intersection, free_edge, crease } = spline.deviation;
  return {
    worst: worst.point, angle: worst_angle.point, ...(self_intersection ? { intersection: self_intersection } : {}),
    ...(free_edge ? { border: free_edge.worst.point } : {}), ...(crease ? { crease: crease.worst.point } : {})
  };
}

function splineSection(spline) {
  const valences = Object.entries(spline.valences).sort((a, b) => a[0] - b[0])
    .map(([valence, count]) => [`of valence ${valence}`, count]);
  const point = element("p", { class: "note" }, element("span", { class: "swatch", style: `background: ${extraordinaryColor}` }),
    "extraordinary points ", element("span", { class: "stroke", style: `background: ${netColor}; margin-left: 10px` }), "control net");
  const crease = element("p", { class: "note" }, element("span", { class: "stroke", style: `background: ${creaseColor}` }),
    "creases: edges along which the surface is sharp");
  return section("T-spline surface", table([
    ["control points", spline.levels[spline.best_level].control_points],
    ["in rings round extraordinary vertices", spline.levels[spline.best_level].control_points_in_rings],
    ["faces", spline.t_mesh.faces], ["T-joints", spline.t_mesh.t_joints],
    ...(spline.creases > 0 ? [["creases (edges)", spline.creases]] : []),
    ["extraordinary vertices", spline.extraordinary_vertices], ...valences, ["Bezier patches", spline.patches],
    ["deviation of the caps", percentText(spline.cap_deviation)],
    ["triangles of the tessellation", spline.tessellation_triangles]]), point, ...(spline.creases > 0 ? [crease] : []));
}
