// Everything that talks to WebGL2.

// The light lines round the surface in the view of reflection lines.
const lightLineCount = 16;

// How the mesh is drawn when it is compared with the surface.
const meshMode = 5;

function icosphere() {
  const g = (1 + Math.sqrt(5)) / 2;
  const corners = [[-1, g, 0], [1, g, 0], [-1, -g, 0], [1, -g, 0], [0, -1, g], [0, 1, g],
                   [0, -1, -g], [0, 1, -g], [g, 0, -1], [g, 0, 1], [-g, 0, -1], [-g, 0, 1]];
  const faces = [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4],
                 [11, 10, 2], [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8],
                 [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]];
  const unit = p => { const n = Math.hypot(...p); return p.map(x => x / n); };
  const middle = (p, q) => unit(p.map((x, d) => x + q[d]));
  let triangles = faces.map(face => face.map(i => unit(corners[i])));
  for (let level = 0; level < 2; ++level)
    triangles = triangles.flatMap(([a, b, c]) => {
      const [d, e, f] = [middle(a, b), middle(b, c), middle(c, a)];
      return [[a, d, f], [d, b, e], [f, e, c], [d, e, f]];
    });
  return new Float32Array(triangles.flat(2));
}

class Renderer {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", { antialias: true, alpha: true, premultipliedAlpha: true });
    if (!this.gl)
      throw new Error("This browser offers no WebGL2, which the picture needs. The figures beside it are complete.");
    this.programs = {
      surface: this.program(surfaceVertexShader, surfaceFragmentShader),
      spline: this.program(splineVertexShader, splineFragmentShader),
      line: this.program(lineVertexShader, lineFragmentShader),
      cone: this.program(coneVertexShader, coneFragmentShader)
    };
  }

  program(vertexSource, fragmentSource) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertexSource], [gl.FRAGMENT_SHADER, fragmentSource]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
        throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(gl.getProgramInfoLog(program));
    const uniforms = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
      const name = gl.getActiveUniform(program, i).name;
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms };
  }

  // Attributes by location: { data, size, integer, normalized, stride, offset, perInstance }.
  vertexArray(attributes) {
    const gl = this.gl, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    attributes.forEach((attribute, location) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, attribute.data, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(location);
      const types = { Float32Array: gl.FLOAT, Int8Array: gl.BYTE, Uint8Array: gl.UNSIGNED_BYTE, Int16Array: gl.SHORT };
      const type = types[attribute.data.constructor.name];
      const stride = attribute.stride || 0, offset = attribute.offset || 0;
      if (attribute.integer)
        gl.vertexAttribIPointer(location, attribute.size, type, stride, offset);
      else
        gl.vertexAttribPointer(location, attribute.size, type, type === gl.BYTE || type === gl.SHORT, stride, offset);
      if (attribute.perInstance)
        gl.vertexAttribDivisor(location, 1);
    });
    gl.bindVertexArray(null);
    return array;
  }

  setSurface(buffers) {
    this.surface = {
      corners: buffers.corners, scaleRange: buffers.scaleRange,
      array: this.vertexArray([
        { data: buffers.position, size: 3 }, { data: buffers.normal, size: 3, stride: 4 }, { data: buffers.uv, size: 2 },
        { data: buffers.level, size: 1 }, { data: buffers.scale, size: 1 }, { data: buffers.dilatation, size: 1 },
        { data: buffers.flags, size: 1, integer: true }])
    };
  }

  setSpline(buffers, { net, edges, border, creases, extraordinary, corners, cornerTurns }) {
    const gl = this.gl, array = this.vertexArray([
      { data: buffers.position, size: 3 }, { data: buffers.normal, size: 3 }, { data: buffers.values, size: 3 }]);
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, buffers.triangles, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
    const color = colorComponents(extraordinaryColor);
    this.spline = {
      array, size: buffers.triangles.length, net: this.lines(net), edges: this.lines(edges),
      border: this.lines(border), creases: this.lines(creases),
      corners: this.balls(corners, new Float32Array([...cornerTurns].flatMap(k => colorComponents(cornerColor(k))))),
      extraordinary: this.balls(extraordinary, extraordinary.map((_, i) => color[i % 3]))
    };
  }

  lines(segments) {
    const ends = { data: segments, size: 3, stride: 24, perInstance: true };
    return { count: segments.length / 6, array: this.vertexArray([ends, { ...ends, offset: 12 }]) };
  }

  setCut(segments) { this.cut = this.lines(segments); }

  // Of the mesh.
  setBorder(segments, centers, colors) {
    this.border = this.lines(segments);
    this.corners = this.balls(centers, colors);
  }

  // Layers of lines with balls on them, of which one is drawn or none.
  setTMeshes(tMeshes) {
    this.tMeshes = tMeshes.map(({ segments, joints }) => ({
      lines: this.lines(segments),
      joints: this.balls(joints, new Float32Array(joints.length).map((_, i) => jointColor[i % 3]))
    }));
  }

  setCones(centers, colors) { this.cones = this.balls(centers, colors); }

  balls(centers, colors) {
    const sphere = icosphere();
    return {
      count: centers.length / 3, corners: sphere.length / 3,
      array: this.vertexArray([
        { data: sphere, size: 3 }, { data: centers, size: 3, perInstance: true }, { data: colors, size: 3, perInstance: true }])
    };
  }

  use({ program, uniforms }, camera, aspect) {
    this.gl.useProgram(program);
    this.gl.uniformMatrix4fv(uniforms.view, false, camera.view());
    this.gl.uniformMatrix4fv(uniforms.projection, false, camera.projection(aspect));
    return uniforms;
  }

  draw(camera, options) {
    const gl = this.gl, ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height)
      [this.canvas.width, this.canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    const frame = { camera, ratio, width, height, aspect: width / height };
    if (options.view.ofSpline && options.compared)
      this.drawComparison(frame, options);
    else if (options.view.ofSpline)
      this.drawSpline(frame, options);
    else
      this.drawMap(frame, options);
    gl.bindVertexArray(null);
  }

  // The mesh on the left of the divider, the surface on its right.
  drawComparison(frame, options) {
    const gl = this.gl, left = Math.round(options.compare * frame.width);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, 0, left, frame.height);
    this.drawSurface(frame, options, meshMode);
    this.drawBorder(frame, options, this);
    gl.scissor(left, 0, frame.width - left, frame.height);
    this.drawSpline(frame, options);
    gl.disable(gl.SCISSOR_TEST);
  }

  drawSurface({ camera, ratio, aspect }, options, mode) {
    const gl = this.gl, surface = this.use(this.programs.surface, camera, aspect);
    gl.uniform1i(surface.mode, mode);
    gl.uniform1i(surface.wire, options.wire);
    gl.uniform1f(surface.cellOctaves, options.cellOctaves);
    gl.uniform1f(surface.scaleRange, this.surface.scaleRange);
    gl.uniform1f(surface.pixels, ratio);
    gl.bindVertexArray(this.surface.array);
    gl.drawArrays(gl.TRIANGLES, 0, this.surface.corners);
  }

  drawLines({ camera, ratio, width, height, aspect }, lines, thickness, color, depth = 0.9985) {
    const gl = this.gl, line = this.use(this.programs.line, camera, aspect);
    gl.uniform2f(line.viewport, width, height);
    gl.uniform1f(line.thickness, thickness * ratio);
    gl.uniform1f(line.depth, depth);
    gl.uniform3f(line.lineColor, ...color);
    gl.bindVertexArray(lines.array);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.count);
  }

  drawBalls({ camera, ratio, height, aspect }, balls, radius, leastPixels) {
    const gl = this.gl, cone = this.use(this.programs.cone, camera, aspect);
    gl.uniform1f(cone.radius, radius * Math.min(1, Math.pow(camera.distance / 4, 0.6)));
    gl.uniform1f(cone.leastRadius, 2 * leastPixels * ratio / height);
    gl.bindVertexArray(balls.array);
    gl.drawArraysInstanced(gl.TRIANGLES, 0, balls.corners, balls.count);
  }

  // Of the mesh or of the surface.
  drawBorder(frame, options, { border, corners }) {
    if (!options.border || border.count === 0)
      return;
    this.drawLines(frame, border, 3, colorComponents(borderColor), 0.998); // over other lines
    if (corners.count > 0)
      this.drawBalls(frame, corners, options.cornerRadius, Math.min(4, 26 / Math.sqrt(corners.count)));
  }

  drawMap(frame, options) {
    this.drawSurface(frame, options, options.view.mode);
    const tMesh = this.tMeshes[options.tMesh - 1];
    if (options.cut && this.cut.count > 0)
      this.drawLines(frame, this.cut, 2.2, [0.84, 0.36, 0.05]);
    if (tMesh)
      this.drawLines(frame, tMesh.lines, 1.7, [0.09, 0.13, 0.22]);
    this.drawBorder(frame, options, this);
    if (tMesh && options.joints && tMesh.joints.count > 0)
      this.drawBalls(frame, tMesh.joints, options.jointRadius, Math.min(2.6, Math.max(1.3, 80 / Math.sqrt(tMesh.joints.count))));
    if (options.cones && this.cones.count > 0)
      this.drawBalls(frame, this.cones, options.coneRadius, 0);
  }

  drawSpline(frame, options) {
    const gl = this.gl, spline = this.use(this.programs.spline, frame.camera, frame.aspect);
    gl.uniform1i(spline.mode, options.view.mode);
    gl.uniform1f(spline.lineCount, Math.round(lightLineCount * 2 ** options.lineOctaves));
    gl.uniform1i(spline.lights, options.lights);
    gl.uniform1f(spline.curvatureRange, options.curvatureRange * 2 ** options.rangeOctaves);
    gl.uniform1f(spline.deviationRange, options.deviationRange * 2 ** options.deviationOctaves);
    gl.bindVertexArray(this.spline.array);
    gl.drawElements(gl.TRIANGLES, this.spline.size, gl.UNSIGNED_INT, 0);
    if (options.edges && this.spline.edges.count > 0)
      this.drawLines(frame, this.spline.edges, 1.4, colorComponents(edgeColor));
    if (options.net && this.spline.net.count > 0)
      this.drawLines(frame, this.spline.net, 1.3, colorComponents(netColor));
    if (options.border && options.view.key === "deviation" && this.border.count > 0)
      this.drawLines(frame, this.border, 1.3, colorComponents(edgeColor));
    if (options.creases && this.spline.creases.count > 0)
      this.drawLines(frame, this.spline.creases, 1.8, colorComponents(creaseColor), 0.998); // over other lines
    this.drawBorder(frame, options, this.spline);
    if (options.points && this.spline.extraordinary.count > 0)
      this.drawBalls(frame, this.spline.extraordinary, options.coneRadius, 0);
  }
}
