// The buttons, boxes and sliders over the picture, and the address that presets them.

const allViews = [
  { key: "shaded", name: "Shaded", ofSpline: true, mode: 0 },
  { key: "reflection", name: "Reflection lines", ofSpline: true, mode: 1 },
  { key: "curvature", name: "Mean curvature", ofSpline: true, mode: 2 },
  { key: "deviation", name: "Deviation", ofSpline: true, mode: 3 },
  ...["Checker", "Isolines", "Area", "Angles", "Shape"].map((name, mode) => ({ key: name.toLowerCase(), name, ofSpline: false, mode }))
];

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
    const toggled = { n: "net", e: "edges", c: "compared" }[event.key];
    if (event.key === "b")
      options.border = !options.border;
    else if (options.view.ofSpline && toggled)
      options[toggled] = !options[toggled];
    else if (!options.view.ofSpline && event.key === "t" && layers.length > 1)
      options.tMesh = options.tMesh === 1 ? 2 : 1;
    else
      return;
    refresh();
  });
}

// Check boxes, lists and sliders, each with what tells whether a view has it. \return what brings all up to date.
function makeToggles(options, layers, { hasBorder, hasCreases }, refresh) {
  const toggles = document.getElementById("toggles"), updates = [];
  const add = (control, label, property, isShown) => {
    control.addEventListener("input", () => {
      options[property] = control.type === "checkbox" ? control.checked : +control.value;
      refresh();
    });
    toggles.append(label);
    updates.push(() => {
      control[control.type === "checkbox" ? "checked" : "value"] = options[property];
      label.hidden = !isShown(options.view, options);
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
  const slider = (name, low, high, property, isShown) => {
    const range = element("input", { type: "range", min: low, max: high, step: 0.05 });
    add(range, element("label", {}, name, range), property, isShown);
  };
  const ofMap = view => !view.ofSpline, isView = key => view => view.key === key;
  check("control net", "net", view => view.ofSpline);
  check("patch edges", "edges", view => view.ofSpline);
  check("extraordinary points", "points", view => view.ofSpline);
  check("border", "border", () => hasBorder);
  check("creases", "creases", view => view.ofSpline && hasCreases);
  check("compare with the input", "compared", view => view.ofSpline);
  list(["horizontal lines", "vertical lines", "rings"], "light lines", "lights", isView("reflection"));
  slider("density", -2, 2, "lineOctaves", isView("reflection"));
  slider("range", -4, 4, "rangeOctaves", isView("curvature"));
  slider("range", -5, 0, "deviationOctaves", isView("deviation"));
  check("cones", "cones", ofMap);
  check("T-joints", "joints", view => ofMap(view) && layers.length > 0);
  check("cut", "cut", ofMap);
  list(["no mesh", "input mesh", "refined mesh"], "mesh", "wire", (view, { compared }) => ofMap(view) || compared);
  slider("cells", -3, 3, "cellOctaves", view => ofMap(view) && view.mode <= 1);
  return () => updates.forEach(update => update());
}

// Radio buttons for the views, check boxes for what is drawn on top; `has` tells whether there are a border and creases;
// `changed` is called after each change. Returns what brings all of them up to date after the options were changed elsewhere.
function makeControls(options, views, layers, has, changed) {
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
  const updateToggles = makeToggles(options, layers, has, () => refresh());
  document.getElementById("border_help").hidden = !has.hasBorder;
  listenForLayerKeys(options, layers, () => refresh());
  const titles = views.some(view => view.ofSpline) ? [["T-spline", true], ["Map", false]] : [["", false]];
  for (const [title, ofSpline] of titles)
    group.append(element("div", {}, ...(title ? [element("span", {}, title)] : []),
      ...buttons.filter((_, i) => views[i].ofSpline === ofSpline)));
  refresh();
  return refresh;
}

// The part after # in the address presets the view, e.g. #view=reflection&edges=1&turn=30,10: `view` is a key of
// `allViews`, or the number of a view of the map; `t_mesh` is the number of a layer; `turn` (degrees to the right, down)
// and `zoom` (larger is nearer) move the camera; `place` goes to a place of
// the deviation: worst, angle, intersection or border; `compare` is the divider's place, from 0 on the left to 1; every other name is that of an option, with a number or 0 or 1.
// Returns whether the camera was moved.
function presetFromAddress(options, views, camera, goTo) {
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
    else if (key === "place")
      isMoved = goTo(value) || isMoved;
    else if (key === "compare") {
      options.compared = +value > 0;
      options.compare = dividerPlace(+value || 0.5);
    }
    else if (key in options)
      options[key] = typeof options[key] === "boolean" ? value !== "0" : +value || 0;
  return isMoved;
}
