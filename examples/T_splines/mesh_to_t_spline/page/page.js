// Puts the page together and listens to the user.

const viewNames = ["Checker", "Isolines", "Area", "Angles", "Shape"];

function scaleLegend(mode, range) {
  const legend = document.getElementById("scale_legend");
  legend.hidden = mode !== 2 && mode !== 3;
  if (legend.hidden)
    return;
  const factor = x => 2 ** x < 1e4 ? String(+(2 ** x).toPrecision(2)) : `1e${Math.round(x * Math.log10(2))}`;
  const power = x => x < 0 ? `1/${factor(-x)}` : factor(x);
  const colors = mode === 2 ? "rgb(33,89,168), rgb(242,240,232), rgb(189,46,33)" : "rgb(245,242,230), rgb(237,153,77), rgb(115,15,64)";
  const ticks = mode === 2 ? [-range, -range / 2, 0, range / 2, range].map(power) : ["1", "1.41", "2"];
  legend.replaceChildren(
    element("div", {}, mode === 2 ? "area in the plane over area on the surface, relative to the median"
                                  : "larger over smaller stretch in each triangle (1: conformal)"),
    element("div", { class: "bar", style: `background: linear-gradient(90deg, ${colors})` }),
    element("div", { class: "ticks" }, ...ticks.map(tick => element("span", {}, tick))));
}

// Radio buttons for what is drawn of the T-mesh. \return what marks the chosen one.
function makeLayerControls(options, layers, refresh) {
  const group = document.getElementById("layers");
  group.hidden = layers.length === 0;
  document.getElementById("layer_help").hidden = layers.length < 2;
  const buttons = ["none", ...layers.map(layer => layer.name)].map((name, i) => {
    const button = element("button", { role: "radio", type: "button" }, name);
    button.addEventListener("click", () => { options.tMesh = i; refresh(); });
    return button;
  });
  group.append(element("span", {}, "T-mesh"), ...buttons);
  if (layers.length > 1)
    document.getElementById("canvas").addEventListener("keydown", event => {
      if (event.key === "t") {
        options.tMesh = options.tMesh === 1 ? 2 : 1;
        refresh();
      }
    });
  return () => buttons.forEach((button, i) => button.setAttribute("aria-checked", String(i === options.tMesh)));
}

// Radio buttons for the views, check boxes for what is drawn on top; `changed` is called after each change.
function makeControls(options, layers, changed) {
  const views = document.getElementById("views"), toggles = document.getElementById("toggles");
  const buttons = viewNames.map((name, mode) => {
    const button = element("button", { role: "radio", type: "button" }, name);
    button.addEventListener("click", () => { options.mode = mode; refresh(); });
    return button;
  });
  const refresh = () => {
    buttons.forEach((button, mode) => button.setAttribute("aria-checked", String(mode === options.mode)));
    size.parentElement.hidden = options.mode > 1;
    markLayer();
    changed();
  };
  const check = (name, key) => {
    const box = element("input", { type: "checkbox" });
    box.checked = options[key];
    box.addEventListener("change", () => { options[key] = box.checked; refresh(); });
    return element("label", {}, box, name);
  };
  const wire = element("select", {}, ...["no mesh", "input mesh", "refined mesh"].map((name, i) => element("option", { value: i }, name)));
  wire.value = options.wire;
  wire.addEventListener("change", () => { options.wire = +wire.value; refresh(); });
  const size = element("input", { type: "range", min: -3, max: 3, step: 0.05, value: options.cellOctaves });
  size.addEventListener("input", () => { options.cellOctaves = +size.value; refresh(); });
  const markLayer = makeLayerControls(options, layers, () => refresh());
  views.append(...buttons);
  toggles.append(check("cones", "cones"), ...(layers.length > 0 ? [check("T-joints", "joints")] : []),
    check("cut", "cut"), wire, element("label", {}, "cells", size));
  refresh();
}

// Turning, moving and zooming by mouse, touch and keys.
function listen(canvas, camera, aspect, redraw) {
  const pointers = new Map();
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  });
  for (const name of ["pointerup", "pointercancel"])
    canvas.addEventListener(name, event => pointers.delete(event.pointerId));
  canvas.addEventListener("pointermove", event => {
    const before = pointers.get(event.pointerId);
    if (!before)
      return;
    const height = canvas.clientHeight, dx = (event.clientX - before.clientX) / height, dy = (event.clientY - before.clientY) / height;
    if (pointers.size === 2) {
      const other = [...pointers.values()].find(pointer => pointer.pointerId !== event.pointerId);
      const gap = pointer => Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY) + 1;
      camera.zoom(gap(before) / gap(event));
      camera.move(dx / 2, dy / 2);
    }
    else if (event.shiftKey || event.buttons & 6)
      camera.move(dx, dy);
    else
      camera.turn(Math.PI * dx, Math.PI * dy);
    pointers.set(event.pointerId, event);
    redraw();
  });
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    camera.zoom(Math.exp((event.deltaMode ? 30 : 1) * event.deltaY * 0.0012));
    redraw();
  }, { passive: false });
  canvas.addEventListener("keydown", event => {
    const step = 0.12, keys = {
      ArrowLeft: () => camera.turn(-step, 0), ArrowRight: () => camera.turn(step, 0), ArrowUp: () => camera.turn(0, -step),
      ArrowDown: () => camera.turn(0, step), "+": () => camera.zoom(0.9), "-": () => camera.zoom(1.1), r: () => camera.reset(aspect())
    };
    if (keys[event.key]) {
      keys[event.key]();
      event.preventDefault();
      redraw();
    }
  });
}

// Calls `found` with the point of the mesh nearest to a double click, on the side that faces the viewer.
function pick(mesh, camera, aspect, place) {
  let best = null, bestValue = Infinity;
  for (let i = 0; i < mesh.positions.length; i += 3) {
    const point = mesh.positions.subarray(i, i + 3), [x, y, z] = camera.project(point, aspect);
    const value = 60 * Math.hypot((x - place[0]) * aspect, y - place[1]) + z;
    if (value < bestValue)
      [best, bestValue] = [[...point], value];
  }
  return best;
}

function showTooltips(canvas, camera, aspect, cones, options) {
  const tooltip = document.getElementById("tooltip");
  canvas.addEventListener("pointermove", event => {
    const box = canvas.getBoundingClientRect(), scale = box.height / 2;
    const place = [event.clientX - box.left - box.width / 2, box.height / 2 - (event.clientY - box.top)];
    let best = null, nearest = Infinity;
    for (const cone of options.cones && event.buttons === 0 ? cones : []) {
      const [x, y, z] = camera.project(cone.center, aspect());
      if (Math.hypot(x * aspect() * scale - place[0], y * scale - place[1]) < 9 && z < nearest)
        [best, nearest] = [cone, z];
    }
    tooltip.hidden = !best;
    if (best) {
      tooltip.textContent = `vertex ${best.vertex}: k = ${best.quarter_turns}`;
      tooltip.style.left = `${event.clientX - box.left + 14}px`;
      tooltip.style.top = `${event.clientY - box.top + 12}px`;
    }
  });
}

// The part after # in the address presets the view, e.g. #view=2&wire=1&t_mesh=1.
function optionsFromAddress(options) {
  for (const [key, value] of new URLSearchParams(location.hash.slice(1)))
    if (key === "view")
      options.mode = Math.min(viewNames.length - 1, Math.max(0, +value || 0));
    else if (key === "t_mesh")
      options.tMesh = +value || 0;
    else if (key in options)
      options[key] = typeof options[key] === "boolean" ? value !== "0" : +value;
  return options;
}

function start() {
  const report = JSON.parse(document.getElementById("report").textContent);
  const canvas = document.getElementById("canvas");
  let mesh = null, tMeshes = null, measure = null, renderer = null, problem = null;
  try {
    mesh = readMesh();
    tMeshes = [["as traced", readTMesh("traced")], ["regularized", readTMesh("regular")]]
      .filter(([name, tMesh]) => tMesh).map(([name, tMesh]) => ({ name, ...tMesh }));
    measure = measureTriangles(mesh);
    renderer = new Renderer(canvas);
  }
  catch (error) {
    problem = error.message;
  }
  showFigures(report, measure);
  if (problem) {
    const message = document.getElementById("message");
    message.textContent = problem;
    message.hidden = false;
    document.getElementById("help").hidden = true;
    return;
  }
  const area = measure.area.reduce((sum, a) => sum + a, 0);
  const buffers = surfaceBuffers(mesh, measure, Math.sqrt(area / (measure.area.length > 40000 ? 5000 : 2800)));
  const cones = report.signature.cones.map(cone => ({ ...cone, center: [...mesh.positions.subarray(3 * cone.vertex, 3 * cone.vertex + 3)] }));
  renderer.setSurface(buffers);
  renderer.setCut(cutSegments(mesh));
  renderer.setTMeshes(tMeshes);
  renderer.setCones(new Float32Array(cones.flatMap(cone => cone.center)),
    new Float32Array(cones.flatMap(cone => colorComponents(coneColor(cone.quarter_turns)))));

  const coneRadius = Math.min(0.016, 0.09 * Math.sqrt(area / Math.max(40, cones.length)));
  const mostJoints = Math.max(40, ...tMeshes.map(tMesh => tMesh.joints.length / 3));
  const options = optionsFromAddress({ mode: tMeshes.length > 0 ? 4 : 0, wire: 0, tMesh: tMeshes.length,
    cut: tMeshes.length === 0, cones: true, joints: true, cellOctaves: 0, coneRadius,
    jointRadius: Math.min(0.7 * coneRadius, 0.07 * Math.sqrt(area / mostJoints)) });
  const camera = new Camera(mesh), aspect = () => canvas.clientWidth / Math.max(1, canvas.clientHeight);
  camera.reset(aspect());
  let requested = false, touched = false;
  const redraw = () => {
    if (!requested)
      requestAnimationFrame(() => { requested = false; renderer.draw(camera, options); });
    requested = true;
  };
  makeControls(options, tMeshes, () => { scaleLegend(options.mode, buffers.scaleRange); redraw(); });
  listen(canvas, camera, aspect, redraw);
  showTooltips(canvas, camera, aspect, cones, options);
  canvas.addEventListener("dblclick", event => {
    const box = canvas.getBoundingClientRect();
    const place = [2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height];
    camera.pivot = pick(mesh, camera, aspect(), place);
    redraw();
  });
  canvas.addEventListener("webglcontextlost", event => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => location.reload());
  for (const name of ["pointerdown", "wheel", "keydown"])
    canvas.addEventListener(name, () => { touched = true; });
  new ResizeObserver(() => {
    if (!touched)
      camera.reset(aspect());
    renderer.draw(camera, options); // at once: until the next frame the old picture would be stretched
  }).observe(canvas);
}

start();
