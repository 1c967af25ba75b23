// Puts the page together and listens to the user.

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

// The point nearest to a double click, on the side that faces the viewer.
function pick(positions, camera, aspect, place) {
  let best = null, bestValue = Infinity;
  for (let i = 0; i < positions.length; i += 3) {
    const point = positions.subarray(i, i + 3), [x, y, z] = camera.project(point, aspect);
    const value = 60 * Math.hypot((x - place[0]) * aspect, y - place[1]) + z;
    if (value < bestValue)
      [best, bestValue] = [[...point], value];
  }
  return best;
}

// places(): what has a tooltip, each with its center and text.
function showTooltips(canvas, camera, aspect, places) {
  const tooltip = document.getElementById("tooltip");
  canvas.addEventListener("pointermove", event => {
    const box = canvas.getBoundingClientRect(), scale = box.height / 2;
    const place = [event.clientX - box.left - box.width / 2, box.height / 2 - (event.clientY - box.top)];
    let best = null, nearest = Infinity;
    for (const marked of event.buttons === 0 ? places() : []) {
      const [x, y, z] = camera.project(marked.center, aspect());
      if (Math.hypot(x * aspect() * scale - place[0], y * scale - place[1]) < 9 && z < nearest)
        [best, nearest] = [marked, z];
    }
    tooltip.hidden = !best;
    if (best) {
      tooltip.textContent = best.text;
      tooltip.style.left = `${event.clientX - box.left + 14}px`;
      tooltip.style.top = `${event.clientY - box.top + 12}px`;
    }
  });
}

// The points of an array with 3 coordinates for each.
function pointList(array) {
  return Array.from({ length: array.length / 3 }, (_, i) => [...array.subarray(3 * i, 3 * i + 3)]);
}

// How far from 0 the points of the arrays reach.
function radiusOf(...arrays) {
  let largest = 0;
  for (const array of arrays)
    for (let i = 0; i < array.length; i += 3)
      largest = Math.max(largest, array[i] ** 2 + array[i + 1] ** 2 + array[i + 2] ** 2);
  return Math.sqrt(largest);
}

function readData() {
  const mesh = readMesh(), spline = readSpline();
  const tMeshes = [["as traced", readTMesh("traced")], ["regularized", readTMesh("regular")]]
    .filter(([name, tMesh]) => tMesh).map(([name, tMesh]) => ({ name, ...tMesh }));
  const { middle, diagonal } = JSON.parse(document.getElementById("frame").textContent);
  return { mesh, spline, tMeshes, measure: measureTriangles(mesh), middle, diagonal };
}

// What the legend tells of the deviation.
function deviationFacts(spline, { deviation, tolerance }) {
  const largest = spline.deviation.reduce((x, y) => Math.max(x, y), 0);
  return { largest, error: deviation && deviation.surface_to_mesh, tolerance };
}

// The places that the page can go to, in its frame, each with the normal of the surface next to it.
function framedPlaces(tSpline, { spline, middle, diagonal }) {
  const framed = {};
  for (const [key, place] of Object.entries(spline ? knownPlaces(tSpline) : {})) {
    const point = place.map((x, d) => 2 * (x - middle[d]) / diagonal), { points, normals } = spline;
    let nearest = 0, least = Infinity;
    for (let i = 0; i < points.length; i += 3) {
      const distance = Math.hypot(points[i] - point[0], points[i + 1] - point[1], points[i + 2] - point[2]);
      if (distance < least)
        [nearest, least] = [i, distance];
    }
    const normal = [...normals.subarray(nearest, nearest + 3)];
    framed[key] = { point, normal: normal.some(x => x !== 0) ? normal : [0, 0, 1] };
  }
  return framed;
}

// Goes to a place and marks it; where the mark is on the canvas, `follow()` brings up to date.
function makePlaceMark(places, options, camera, aspect) {
  const mark = document.getElementById("place_mark");
  let current = null;
  return {
    go: key => {
      if (!places[key])
        return false;
      current = places[key];
      camera.lookAt(current.point, current.normal, 0.5);
      return true;
    },
    follow: () => {
      mark.hidden = !current || !options.view.ofSpline;
      if (mark.hidden)
        return;
      const [x, y] = camera.project(current.point, aspect());
      mark.style.left = `${50 * (1 + x)}%`;
      mark.style.top = `${50 * (1 - y)}%`;
    }
  };
}

function showProblem(text) {
  const message = document.getElementById("message");
  message.textContent = text;
  message.hidden = false;
  document.getElementById("help").hidden = true;
}

function firstOptions({ spline, tMeshes, diagonal }, views, area, { cones, corners }, ofSpline) {
  const numberOfCones = cones.length, numberOfCorners = corners.length;
  const coneRadius = Math.min(0.016, 0.09 * Math.sqrt(area / Math.max(40, numberOfCones)));
  const mostJoints = Math.max(40, ...tMeshes.map(tMesh => tMesh.joints.length / 3));
  return {
    view: views.find(view => view.key === (spline ? "shaded" : tMeshes.length > 0 ? "shape" : "checker")),
    wire: 0, tMesh: tMeshes.length, cut: tMeshes.length === 0, cones: true, joints: true, cellOctaves: 0, coneRadius,
    jointRadius: Math.min(0.7 * coneRadius, 0.07 * Math.sqrt(area / mostJoints)),
    net: false, edges: false, points: true, border: true, creases: true, cornerRadius: 0.014 * Math.min(1, Math.sqrt(40 / Math.max(1, numberOfCorners))), compared: false, compare: 0.5, lights: 0, lineOctaves: 0, rangeOctaves: 0,
    deviationOctaves: 0, curvatureRange: ofSpline ? curvatureRange(ofSpline.curvature.distribution, diagonal) : 1,
    deviationRange: spline ? deviationRange(spline.deviation) : 1
  };
}

// The corners of the border of the mesh, as balls and with texts.
function cornersOf(signature, { positions }) {
  return signature.corners.map(({ vertex, quarter_turns: k }) => ({
    center: [...positions.subarray(3 * vertex, 3 * vertex + 3)], color: colorComponents(cornerColor(k)),
    text: `vertex ${vertex}, corner of the border: k = ${k}`
  }));
}

function start() {
  const report = JSON.parse(document.getElementById("report").textContent);
  const canvas = document.getElementById("canvas");
  let data = null, renderer = null, problem = null;
  try {
    data = readData();
    renderer = new Renderer(canvas);
  }
  catch (error) {
    problem = error.message;
  }
  showFigures(report, data && data.measure);
  if (problem) {
    showProblem(problem);
    return;
  }
  const { mesh, spline, tMeshes, measure, diagonal } = data;
  const area = measure.area.reduce((sum, a) => sum + a, 0);
  const buffers = surfaceBuffers(mesh, measure, Math.sqrt(area / (measure.area.length > 40000 ? 5000 : 2800)));
  const cones = report.signature.cones.map(({ vertex, quarter_turns: k }) => ({
    center: [...mesh.positions.subarray(3 * vertex, 3 * vertex + 3)], color: colorComponents(coneColor(k)),
    text: `vertex ${vertex}: k = ${k}`
  }));
  renderer.setSurface(buffers);
  renderer.setCut(cutSegments(mesh));
  const border = borderSegments(mesh), corners = cornersOf(report.signature, mesh);
  renderer.setBorder(border, new Float32Array(corners.flatMap(corner => corner.center)),
    new Float32Array(corners.flatMap(corner => corner.color)));
  renderer.setTMeshes(tMeshes);
  renderer.setCones(new Float32Array(cones.flatMap(cone => cone.center)), new Float32Array(cones.flatMap(cone => cone.color)));
  if (spline)
    renderer.setSpline(splineBuffers(spline), spline);
  const extraordinary = spline ? pointList(spline.extraordinary).map(center => ({ center, text: "extraordinary point" })) : [];
  const splineCorners = spline
    ? pointList(spline.corners).map((center, i) => ({ center, text: `corner of the border: k = ${spline.cornerTurns[i]}` })) : [];
  const ofSpline = spline && {
    curvature: { distribution: curvatureDistribution(spline), diagonal }, deviation: deviationFacts(spline, report.t_spline)
  };

  const views = allViews.filter(view => spline || !view.ofSpline);
  const options = firstOptions(data, views, area, report.signature, ofSpline);
  const camera = spline ? new Camera(spline.points, radiusOf(mesh.positions, spline.points, spline.net))
                        : new Camera(mesh.positions, 1);
  const aspect = () => canvas.clientWidth / Math.max(1, canvas.clientHeight);
  camera.reset(aspect());
  const placeMark = makePlaceMark(framedPlaces(report.t_spline, data), options, camera, aspect);
  let requested = false, touched = presetFromAddress(options, views, camera, placeMark.go);
  const draw = () => {
    renderer.draw(camera, options);
    placeMark.follow();
  };
  const redraw = () => {
    if (!requested)
      requestAnimationFrame(() => { requested = false; draw(); });
    requested = true;
  };
  const has = { hasBorder: border.length > 0, hasCreases: Boolean(spline) && spline.creases.length > 0 };
  const refresh = makeControls(options, views, tMeshes, has, () => {
    showLegend(options, buffers.scaleRange, ofSpline);
    showDivider(options);
    redraw();
  });
  for (const button of document.querySelectorAll("button.place"))
    button.addEventListener("click", () => {
      options.view = views.find(view => view.key === "deviation");
      touched = placeMark.go(button.dataset.place) || touched;
      refresh();
    });
  listenToDivider(options, redraw);
  listen(canvas, camera, aspect, redraw);
  const marked = () => [...(options.view.ofSpline ? (options.points ? extraordinary : []) : (options.cones ? cones : [])),
    ...(options.border ? (options.view.ofSpline ? splineCorners : corners) : [])];
  showTooltips(canvas, camera, aspect, marked);
  canvas.addEventListener("dblclick", event => {
    const box = canvas.getBoundingClientRect();
    const place = [2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height];
    camera.pivot = pick(options.view.ofSpline ? spline.points : mesh.positions, camera, aspect(), place);
    redraw();
  });
  canvas.addEventListener("webglcontextlost", event => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => location.reload());
  for (const name of ["pointerdown", "wheel", "keydown"])
    canvas.addEventListener(name, () => { touched = true; });
  new ResizeObserver(() => {
    if (!touched)
      camera.reset(aspect());
    draw(); // at once: until the next frame the old picture would be stretched
  }).observe(canvas);
}

start();
