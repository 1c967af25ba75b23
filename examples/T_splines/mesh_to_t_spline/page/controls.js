// The buttons, boxes and sliders over the picture, the legend, and the address that presets them.

const allViews = [
  { key: "shaded", name: "Shaded", ofSpline: true, mode: 0 },
  { key: "reflection", name: "Reflection lines", ofSpline: true, mode: 1 },
  { key: "curvature", name: "Mean curvature", ofSpline: true, mode: 2 },
  ...["Checker", "Isolines", "Area", "Angles", "Shape"].map((name, mode) => ({ key: name.toLowerCase(), name, ofSpline: false, mode }))
];

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

function splineLegend(mode, curvature, range) {
  if (mode === 1)
    return ["light lines as the surface mirrors them: they break where the normal jumps, and have a corner where the "
            + "curvature jumps"];
  return mode === 2 ? curvatureLegend(curvature, range) : [];
}

// scaleRange: of the area view; curvature: its distribution and the diagonal of the mesh, if there is a T-spline.
function showLegend(options, scaleRange, curvature) {
  const legend = document.getElementById("scale_legend"), { ofSpline, mode } = options.view;
  const range = options.curvatureRange * 2 ** options.rangeOctaves;
  const content = ofSpline ? splineLegend(mode, curvature, range) : mapLegend(mode, scaleRange);
  legend.hidden = content.length === 0;
  legend.replaceChildren(...content);
}

// Radio buttons for what is drawn of the T-mesh. \return what marks the chosen one.
function makeLayerControls(options, layers, refresh) {
  const group = document.getElementById("layers");
  const buttons = ["none", ...layers.map(layer => layer.name)].map((name, i) => {
    const button = element("button", { role: "radio", type: "button" }, name);
    button.addEventListener("click", () => { options.tMesh = i; refresh(); });
    return button;
  });
  group.append(element("span", {}, "T-mesh"), ...buttons);
  return () => {
    group.hidden = layers.length === 0 || options.view.ofSpline;
    document.getElementById("layer_help").hidden = layers.length < 2 || options.view.ofSpline;
    document.getElementById("spline_help").hidden = !options.view.ofSpline;
    buttons.forEach((button, i) => button.setAttribute("aria-checked", String(i === options.tMesh)));
  };
}

// Keys that change what is drawn on top.
function listenForLayerKeys(options, layers, refresh) {
  document.getElementById("canvas").addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey)
      return;
    if (options.view.ofSpline && (event.key === "n" || event.key === "e")) {
      const key = event.key === "n" ? "net" : "edges";
      options[key] = !options[key];
    }
    else if (!options.view.ofSpline && event.key === "t" && layers.length > 1)
      options.tMesh = options.tMesh === 1 ? 2 : 1;
    else
      return;
    refresh();
  });
}

// Check boxes, lists and sliders, each with what tells whether a view has it. \return what brings all up to date.
function makeToggles(options, layers, refresh) {
  const toggles = document.getElementById("toggles"), updates = [];
  const add = (control, label, property, isShown) => {
    control.addEventListener("input", () => {
      options[property] = control.type === "checkbox" ? control.checked : +control.value;
      refresh();
    });
    toggles.append(label);
    updates.push(() => {
      control[control.type === "checkbox" ? "checked" : "value"] = options[property];
      label.hidden = !isShown(options.view);
    });
  };
  const check = (name, property, isShown) => {
    const box = element("input", { type: "checkbox" });
    add(box, element("label", {}, box, name), property, isShown);
  };
  const list = (names, title, property, isShown) => {
    const select = element("select", { "aria-label": title }, ...names.map((name, i) => element("option", { value: i }, name)));
    add(select, element("label", {}, select), property, isShown);
  };
  const slider = (name, bound, property, isShown) => {
    const range = element("input", { type: "range", min: -bound, max: bound, step: 0.05 });
    add(range, element("label", {}, name, range), property, isShown);
  };
  const ofMap = view => !view.ofSpline, isView = key => view => view.key === key;
  check("control net", "net", view => view.ofSpline);
  check("patch edges", "edges", view => view.ofSpline);
  check("extraordinary points", "points", view => view.ofSpline);
  list(["horizontal lines", "vertical lines", "rings"], "light lines", "lights", isView("reflection"));
  slider("density", 2, "lineOctaves", isView("reflection"));
  slider("range", 4, "rangeOctaves", isView("curvature"));
  check("cones", "cones", ofMap);
  check("T-joints", "joints", view => ofMap(view) && layers.length > 0);
  check("cut", "cut", ofMap);
  list(["no mesh", "input mesh", "refined mesh"], "mesh", "wire", ofMap);
  slider("cells", 3, "cellOctaves", view => ofMap(view) && view.mode <= 1);
  return () => updates.forEach(update => update());
}

// Radio buttons for the views, check boxes for what is drawn on top; `changed` is called after each change.
function makeControls(options, views, layers, changed) {
  const group = document.getElementById("views");
  const buttons = views.map(view => {
    const button = element("button", { role: "radio", type: "button" }, view.name);
    button.addEventListener("click", () => { options.view = view; refresh(); });
    return button;
  });
  const refresh = () => {
    buttons.forEach((button, i) => button.setAttribute("aria-checked", String(views[i] === options.view)));
    markLayer();
    updateToggles();
    changed();
  };
  const markLayer = makeLayerControls(options, layers, () => refresh());
  const updateToggles = makeToggles(options, layers, () => refresh());
  listenForLayerKeys(options, layers, () => refresh());
  const titles = views.some(view => view.ofSpline) ? [["T-spline", true], ["Map", false]] : [["", false]];
  for (const [title, ofSpline] of titles)
    group.append(element("div", {}, ...(title ? [element("span", {}, title)] : []),
      ...buttons.filter((_, i) => views[i].ofSpline === ofSpline)));
  refresh();
}

// The part after # in the address presets the view, e.g. #view=reflection&edges=1&turn=30,10: `view` is a key of
// `allViews`, or the number of a view of the map; `t_mesh` is the number of a layer; `turn` (degrees to the right, down)
// and `zoom` (larger is nearer) move the camera; every other name is that of an option, with a number or 0 or 1.
// Returns whether the camera was moved.
function presetFromAddress(options, views, camera) {
  let isMoved = false;
  for (const [key, value] of new URLSearchParams(location.hash.slice(1)))
    if (key === "view")
      options.view = views.find(view => view.key === value || (!view.ofSpline && String(view.mode) === value)) || options.view;
    else if (key === "t_mesh")
      options.tMesh = +value || 0;
    else if (key === "turn") {
      const [right, down] = value.split(",").map(angle => (+angle || 0) * Math.PI / 180);
      camera.turn(right, down || 0);
      isMoved = true;
    }
    else if (key === "zoom") {
      camera.zoom(1 / Math.max(0.01, +value || 1));
      isMoved = true;
    }
    else if (key in options)
      options[key] = typeof options[key] === "boolean" ? value !== "0" : +value || 0;
  return isMoved;
}
