// The tables and plots beside the picture.

// The residual after each iteration on a logarithmic axis.
function residualPlot(history, tolerance) {
  const width = 336, height = 170, left = 44, right = 8, top = 8, bottom = 24;
  const logs = history.map(r => Math.log10(Math.max(r || 1e-17, 1e-17)));
  const high = Math.ceil(Math.max(...logs, 0)), low = Math.floor(Math.min(...logs, Math.log10(tolerance)) - 0.3);
  const x = i => left + (width - left - right) * i / Math.max(1, logs.length - 1);
  const y = l => top + (height - top - bottom) * (high - l) / (high - low);
  const svg = element("svg", {
    viewBox: `0 0 ${width} ${height}`, width: "100%", role: "img", "aria-label": "Residual after each iteration"
  });
  const horizontal = (name, l) => element("line", { class: name, x1: left, x2: width - right, y1: y(l), y2: y(l) });
  const step = Math.max(1, Math.ceil((high - low) / 6));
  for (let l = high; l >= low; l -= step) {
    svg.append(horizontal("axis", l));
    svg.append(element("text", { x: left - 6, y: y(l) + 4, "text-anchor": "end" }, `1e${l}`));
  }
  const stride = Math.max(1, Math.ceil(logs.length / 10));
  for (let i = 0; i < logs.length; i += stride)
    svg.append(element("text", { x: x(i), y: height - 7, "text-anchor": "middle" }, String(i)));
  svg.append(horizontal("goal", Math.log10(tolerance)));
  const points = logs.map((l, i) => `${x(i).toFixed(1)} ${y(l).toFixed(1)}`);
  svg.append(element("path", { class: "curve", d: `M${points.join("L")}` }));
  if (logs.length < 60)
    logs.forEach((l, i) => svg.append(element("circle", { class: "dot", cx: x(i), cy: y(l), r: 2.6 })));
  return svg;
}

function stageBars(stages) {
  const longest = Math.max(...stages.map(stage => stage.seconds), 1e-9);
  const bars = element("div", { class: "bars four" });
  for (const stage of stages) {
    const bar = element("div", { class: "bar", style: `width: ${(100 * stage.seconds / longest).toFixed(1)}%` });
    const memory = stage.peak_memory_bytes ? `${(stage.peak_memory_bytes / 2 ** 20).toFixed(0)} MB` : "";
    bars.append(element("span", {}, stage.name), bar, element("span", {}, seconds(stage.seconds)), element("span", {}, memory));
  }
  return bars;
}

function coneLegend(cones) {
  const counts = new Map();
  for (const cone of cones)
    counts.set(cone.quarter_turns, (counts.get(cone.quarter_turns) || 0) + 1);
  if (counts.size === 0)
    return note("None: the surface is flat everywhere in the map's metric.");
  return table([...counts].sort((a, b) => a[0] - b[0]).map(([k, count]) => {
    const swatch = element("span", { class: "swatch", style: `background: ${coneColor(k)}` });
    return [element("span", {}, swatch, `k = ${k}, angle ${90 * k}°`), countText(count)];
  }));
}

// One row per scale factor, with the rotations that occur with it.
function scaleTable(transitions) {
  const longest = 24, groups = new Map();
  for (const { quarter_turns, scale, edges } of transitions) {
    const text = String(+scale.toPrecision(10)), group = groups.get(text) || { turns: [], edges: 0 };
    group.turns.push(quarter_turns);
    group.edges += edges;
    groups.set(text, group);
  }
  const right = { style: "text-align: right" };
  const head = element("thead", {}, element("tr", {}, element("th", {}, "scale factor s"),
    element("th", right, "quarter turns"), element("th", right, "cut edges")));
  const rows = [...groups].slice(0, longest).map(([scale, group]) => element("tr", {},
    element("th", { scope: "row" }, scale), element("td", {}, group.turns.sort().join(", ")),
    element("td", {}, countText(group.edges))));
  const result = element("div", {}, element("table", {}, head, element("tbody", {}, ...rows)));
  if (groups.size > longest)
    result.append(note(`and ${groups.size - longest} more, in report.json.`));
  return result;
}

// The figures of the map as it is on this page, measured from its triangles.
function mapQuality(measure) {
  let total = 0, weighted = 0, worst = 0, flipped = 0;
  for (let t = 0; t < measure.area.length; ++t) {
    if (!(measure.uvArea[t] > 0)) {
      ++flipped;
      continue;
    }
    total += measure.area[t];
    weighted += measure.area[t] * measure.dilatation[t];
    worst = Math.max(worst, measure.dilatation[t]);
  }
  return { mean: weighted / total, worst, flipped };
}

// Of an open mesh.
function borderFacts({ borders }, { corners }) {
  return borders > 0 ? [`${counted(borders, "border")}, ${counted(corners.length, "corner")}`] : [];
}

function showVerdict({ input, signature, map, exact_map, t_mesh, t_spline }) {
  document.title = `${input.name}: ${t_spline ? "T-spline surface" : t_mesh ? "T-mesh" : "seamless similarity map"}`;
  document.getElementById("title").textContent = input.name;
  const facts = [`genus ${input.genus}`, counted(signature.cones.length, "cone"), ...borderFacts(input, signature)];
  if (map)
    facts.unshift(`residual ${shortNumber(map.residual)}`, `${map.iterations} iterations`);
  if (t_mesh) {
    const final = t_mesh.regularized || t_mesh.traced;
    facts.push(`${countText(final.faces)} T-mesh faces`,
      `aspect ratio at worst ${ratioText(final.worst_aspect_ratio)}`);
  }
  const verdict = document.getElementById("verdict");
  if (t_spline) {
    const { deviation } = t_spline;
    const errors = [];
    if (deviation) {
      const ofBorder = deviation.free_edge ? `, free edge ${percentText(deviation.free_edge.maximum)}` : "";
      const ofCreases = deviation.crease ? `, creases ${percentText(deviation.crease.maximum)}` : "";
      errors.push(`max ${percentText(deviation.maximum)} both ways${ofBorder}${ofCreases}, tolerance ${percentText(t_spline.tolerance)}`);
    }
    errors.push(`${countText(t_spline.levels[t_spline.best_level].control_points)} control points`,
      `genus ${input.genus}`, counted(signature.cones.length, "cone"), ...borderFacts(input, signature));
    verdict.append(verdictOf(t_spline), ["", ...errors].join("  ·  "));
    return;
  }
  const status = exact_map ? exact_map.status : map.status;
  verdict.append(element("span", { class: "good" }, status), ["", ...facts].join("  ·  "));
}

function ratioText(x) {
  if (x === null)
    return "not finite";
  return `1 : ${x < 9.95 ? x.toFixed(1) : x < 9999.5 ? countText(Math.round(x)) : x.toExponential(1).replace("+", "")}`;
}

// How many faces have an aspect ratio between two powers of two, before and after regularization; the last row is open.
function aspectBars(stages) {
  const last = 10, sum = numbers => numbers.reduce((a, b) => a + b, 0);
  const histograms = stages.map(({ aspect_histogram: all }) => [...all.slice(0, last), sum(all.slice(last))]);
  const most = Math.max(1, ...histograms.flat());
  const bars = element("div", { class: "bars" });
  for (let i = 0; i <= last; ++i) {
    const counts = histograms.map(histogram => histogram[i] || 0);
    if (counts.every(count => count === 0))
      continue;
    const pair = element("div", { class: "pair" }, ...counts.map((count, j) => element("div", {
      class: `bar${j + 1 < counts.length ? " before" : ""}${count === 0 ? " none" : ""}`,
      style: `width: ${(100 * count / most).toFixed(1)}%`
    })));
    const range = i < last ? `${2 ** i} to ${2 ** (i + 1)}` : `from ${2 ** i}`;
    bars.append(element("span", {}, range), pair,
      element("span", {}, counts.map(countText).join(" → ")));
  }
  return bars;
}

function aspectNote(hasTwoStages) {
  const result = note("Faces by aspect ratio (longer over shorter side)");
  if (hasTwoStages)
    result.append(element("br"), element("span", { class: "key before" }), "as traced",
      element("span", { class: "key" }), "regularized");
  return result;
}

function tMeshSection({ traced, regularized }) {
  const stages = regularized ? [traced, regularized] : [traced];
  const head = element("thead", {}, element("tr", {}, element("th", {}, ""),
    ...["as traced", "regularized"].slice(0, stages.length).map(name => element("th", {}, name))));
  const row = (name, text) => element("tr", {}, element("th", { scope: "row" }, name),
    ...stages.map(stage => element("td", {}, text(stage))));
  const rows = [
    row("faces", stage => countText(stage.faces)), row("vertices", stage => countText(stage.vertices)),
    row("T-joints", stage => countText(stage.t_joints)),
    row("aspect ratio, worst", stage => ratioText(stage.worst_aspect_ratio)),
    row("aspect ratio, median", stage => ratioText(stage.median_aspect_ratio))];
  const joint = element("p", { class: "note" }, element("span", { class: "swatch joint" }),
    "T-joints: vertices where a face goes straight on");
  return section("T-mesh", element("table", { class: "columns" }, head, element("tbody", {}, ...rows)), joint,
    aspectNote(stages.length > 1), aspectBars(stages));
}

function tracingSection({ tracing }) {
  const { predicate_calls: calls, exact_predicate_calls: exact } = tracing;
  const share = calls > 0 ? 100 * (calls - exact) / calls : 100;
  return section("Motorcycles", table([
    ["motorcycles", tracing.motorcycles], ["seeds off the cones", tracing.seeds],
    ["triangles crossed", tracing.crossed_faces], ["predicate calls", countText(calls)],
    ["answered by the filter", `${share.toFixed(share > 99.9 && exact > 0 ? 4 : 2)} %`]]));
}

function exactMapSection(exact) {
  const scales = exact.is_isometric ? "all exactly 1" : `${exact.scale_bits} bits where not 1`;
  return section("Exact map", table([
    ["cut edges", exact.cut_edges], ["branches of the cut", exact.branches], ["cones", exact.cones],
    ["scale factors", scales], ["corners that are no doubles", exact.determined_corners],
    ["isolines joined", exact.joined_lines], ["isolines left apart", exact.lines_left_apart],
    ["largest displacement / side", exact.largest_displacement], ["deviation of the input", exact.deviation]]));
}

function conesSection(signature) {
  const cut = element("p", { class: "note" }, element("span", { class: "stroke" }),
    "the cut: directions continue across it, the positions of the cells need not");
  const { cone_reduction: reduction } = signature;
  const change = reduction && reduction.cones < reduction.cones_before ? "reduced" : "split";
  const changed = reduction && reduction.merges + reduction.splits > 0
    ? ` Its ${countText(reduction.cones_before)} cones were ${change} to ${countText(reduction.cones)}.` : "";
  const corners = {};
  for (const { quarter_turns: k } of signature.corners)
    corners[k] = (corners[k] || 0) + 1;
  const ofBorder = signature.corners.length > 0 ? [table(cornerRows(corners))] : [];
  return section("Cones", coneLegend(signature.cones), ...ofBorder, note(`Signature: ${signature.source}.${changed}`), cut);
}

function convergenceSection(map) {
  return section("Convergence", residualPlot(map.residual_history, map.tolerance), table([
    ["largest residual (radians)", map.residual], ["iterations", map.iterations], ["halved steps", map.halvings],
    ["factorizations", map.factorizations], ["linear solves", map.linear_iterations],
    ["flips to intrinsic Delaunay", map.delaunay_flips], ["flips on the way", map.flips], ["mantissa bits", map.mantissa_bits]]));
}

function meshSection({ input, signature, refined }, measure) {
  const rows = [
    ["input vertices", input.vertices], ["input faces", input.faces], ["genus", input.genus], ["components", input.components],
    ...(input.holes ? [["holes filled", input.holes.filled], ["holes left", input.holes.larger + input.holes.failed]] : []),
    ...(input.borders > 0 ? [["border curves", input.borders], ["corners", signature.corners.length]] : []),
    ["refined vertices", refined.vertices], ["refined faces", refined.faces], ["cut edges", refined.cut_edges],
    ["largest / smallest scale", refined.scale_range]];
  if (measure) {
    const quality = mapQuality(measure);
    rows.push(["flipped triangles", quality.flipped], ["dilatation, mean", +quality.mean.toPrecision(5)],
      ["dilatation, worst", +quality.worst.toPrecision(5)]);
  }
  return section("Mesh", table(rows), ...(input.note ? [note(input.note)] : []));
}

function showFigures(report, measure) {
  const { signature, map, refined, exact_map, t_mesh, t_spline } = report;
  const memory = report.peak_memory_bytes ? `, ${(report.peak_memory_bytes / 2 ** 20).toFixed(0)} MB at most` : "";
  const loops = signature.loops.length ? `Turning numbers of the ${signature.loops.length} loops: ${signature.loops.join(", ")}.`
              : report.input.genus > 0 ? "" : "No loops: every closed curve is contractible.";
  showVerdict(report);
  document.getElementById("figures").append(
    ...(t_spline ? [...(t_spline.deviation ? [deviationSection(t_spline)] : []),
      ...(t_spline.deviation && t_spline.deviation.free_edge ? [freeEdgeSection(t_spline)] : []),
      ...(t_spline.deviation && t_spline.deviation.crease ? [creaseSection(t_spline)] : []), fitSection(t_spline), splineSection(t_spline)] : []), ...(t_mesh ? [tMeshSection(t_mesh)] : []), conesSection(signature),
    ...(map ? [convergenceSection(map)] : []),
    section("Time", stageBars(report.stages), note(`${seconds(report.seconds)} in all${memory}. Memory: the most until the stage's end.`)),
    ...(exact_map ? [exactMapSection(exact_map)] : []), ...(t_mesh ? [tracingSection(t_mesh)] : []),
    meshSection(report, measure),
    section("Transitions across the cut", refined.transitions.length ? scaleTable(refined.transitions) : note("No cut."),
      ...(loops ? [note(loops)] : [])));
}
