// What colours mean.

function colorBar(colors, ticks) {
  return [element("div", { class: "bar", style: `background: linear-gradient(90deg, ${colors.join(", ")})` }),
          element("div", { class: "ticks" }, ...ticks.map(tick => element("span", {}, tick)))];
}

function mapLegend(mode, range) {
  const factor = x => 2 ** x < 1e4 ? String(+(2 ** x).toPrecision(2)) : `1e${Math.round(x * Math.log10(2))}`;
  const power = x => x < 0 ? `1/${factor(-x)}` : factor(x);
  if (mode === 2)
    return ["area in the plane over area on the surface, relative to the median",
            ...colorBar(["rgb(33,89,168)", "rgb(242,240,232)", "rgb(189,46,33)"],
              [-range, -range / 2, 0, range / 2, range].map(power))];
  if (mode === 3)
    return ["larger over smaller stretch in each triangle (1: conformal)",
            ...colorBar(["rgb(245,242,230)", "rgb(237,153,77)", "rgb(115,15,64)"], ["1", "1.41", "2"])];
  return [];
}

function curvatureLegend({ distribution, diagonal }, range) {
  const text = x => shortNumber(+x.toPrecision(3)).replace("-", "−");
  if (!distribution.isKnown)
    return ["mean curvature: defined nowhere"];
  const percent = 100 * distribution.share(range);
  return [
    `mean curvature in 1/length (diagonal of the mesh: ${text(diagonal)}); positive where convex`,
    ...colorBar(curvatureColors, [`≤ ${text(-range)}`, text(-range / 2), "0", text(range / 2), `≥ ${text(range)}`]),
    element("p", {}, `${percent.toFixed(percent > 99.5 && percent < 100 ? 2 : 0)} % of the area within ±${text(range)}, `
      + `all from ${text(distribution.low)} to ${text(distribution.high)}`),
    element("p", {}, element("span", { class: "swatch", style: `background: ${undefinedColor}` }), "undefined (extraordinary points)")];
}

// range: where the colours end; error: the rms and the maximum of the surface, if they are known.
function deviationLegend({ largest, error, tolerance }, range) {
  const isClipped = range < largest;
  const ticks = [0, 0.5, 1].map(x => (x === 1 && isClipped ? "≥ " : "") + percentText(x * range));
  const lines = colorBar(deviationColors, ticks);
  if (tolerance < range)
    lines[0].append(element("span", { class: "mark", style: `left: ${100 * tolerance / range}%`, title: "tolerance" }));
  return ["distance from the mesh, by the longest side of its bounding box", ...lines,
    ...(error ? [element("p", {}, `rms ${percentText(error.rms)}, at most ${percentText(error.maximum)}`)] : []),
    ...(tolerance < range ? [element("p", {}, element("span", { class: "mark still" }), ` tolerance: ${percentText(tolerance)}`)] : [])];
}

function splineLegend(options, { curvature, deviation }) {
  const { mode } = options.view;
  if (mode === 3)
    return deviationLegend(deviation, options.deviationRange * 2 ** options.deviationOctaves);
  if (mode === 1)
    return ["light lines as the surface mirrors them: they break where the normal jumps, and have a corner where the "
            + "curvature jumps"];
  return mode === 2 ? curvatureLegend(curvature, options.curvatureRange * 2 ** options.rangeOctaves) : [];
}

// scaleRange: of the area view; ofSpline: what is known of the values on the T-spline, if there is one: curvature: its
// distribution and the diagonal of the mesh; deviation: the largest of the drawing, the error, the tolerance.
function showLegend(options, scaleRange, ofSpline) {
  const legend = document.getElementById("scale_legend");
  const content = options.view.ofSpline ? splineLegend(options, ofSpline) : mapLegend(options.view.mode, scaleRange);
  legend.hidden = content.length === 0;
  legend.replaceChildren(...content);
}
