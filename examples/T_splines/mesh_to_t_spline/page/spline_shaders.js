// GLSL for the T-spline surface.

// A function that interpolates colours at equal steps from 0 to 1.
function colorMap(name, colors) {
  const n = colors.length, last = n - 1;
  return `vec3 ${name}(float t) {
  vec3 stops[${n}] = vec3[${n}](${colors.map(glslColor).join(", ")});
  float x = clamp(t, 0.0, 1.0) * ${last.toFixed(1)};
  int i = min(int(x), ${last - 1});
  return mix(stops[i], stops[i + 1], x - float(i));
}`;
}

const splineVertexShader = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 values; // curvature and whether it is known, deviation
uniform mat4 view, projection;
out vec3 vPosition, vNormal;
out vec3 vValues;
void main() {
  vec4 p = view * vec4(position, 1.0);
  vPosition = p.xyz;
  vNormal = mat3(view) * normal;
  vValues = values;
  gl_Position = projection * p;
}`;

const splineFragmentShader = `#version 300 es
precision highp float;
precision highp int;
in vec3 vPosition, vNormal;
in vec3 vValues;
uniform int mode, lights;
uniform float lineCount, curvatureRange, deviationRange;
out vec4 color;
${shading}
${material}
// Stripes of period 1, averaged over the pixel, in [0, 1].
float stripes(float x, float width) {
  float w = max(width, 1e-6);
  return 0.5 + 0.5 * (abs(fract(x - 0.5 * w) - 0.5) - abs(fract(x + 0.5 * w) - 0.5)) / w;
}
// The surface is a mirror, and round it are light lines, so far away that only the direction counts. They are parallel,
// horizontal (lights = 0) or vertical (1), at equal angles about their common direction: then p turns by these angles,
// and the width of a pixel is taken from the angle's differential, which has no jump. Or they are horizontal rings (2), at
// equal angles of elevation.
float lightLines(vec3 normal, vec3 toViewer) {
  const float fullTurn = 6.28318530718;
  vec3 mirrored = reflect(-toViewer, normal);
  vec2 p = lights == 0 ? mirrored.zy : lights == 1 ? mirrored.zx : vec2(length(mirrored.xz), mirrored.y);
  vec2 px = dFdx(p), py = dFdy(p);
  vec2 slope = vec2(p.x * px.y - p.y * px.x, p.x * py.y - p.y * py.x) / (fullTurn * max(dot(p, p), 1e-9));
  return stripes(lineCount * atan(p.y, p.x) / fullTurn + 0.25, 1.2 * lineCount * length(slope));
}
${colorMap("curvatureColor", curvatureColors)}
${colorMap("deviationColor", deviationColors)}
// A colour that tells a value: light changes it little.
vec4 lit(vec3 albedo, vec3 normal, vec3 toViewer) {
  return encode(pow(albedo, vec3(2.2)) * (0.74 + 0.26 * max(dot(normal, toViewer), 0.0)));
}
void main() {
  vec3 toViewer = normalize(-vPosition), normal = normalize(vNormal);
  // At the contour interpolated normals look a little away.
  bool isBack = !gl_FrontFacing && dot(normal, toViewer) < -0.05;
  if (isBack)
    normal = -normal;
  normal = normalize(normal - min(dot(normal, toViewer), 0.0) * toViewer);
  if (mode == 0)
    color = encode(material(isBack ? backColor : frontColor, normal, toViewer));
  else if (mode == 1) {
    vec3 mirrored = mix(vec3(0.012, 0.015, 0.02), vec3(0.93, 0.94, 0.95), lightLines(normal, toViewer));
    color = encode(mirrored * (0.50 + 0.50 * max(dot(normal, toViewer), 0.0)));
  }
  else if (mode == 3)
    color = lit(deviationColor(vValues.z / deviationRange), normal, toViewer);
  else {
    float known = vValues.y, sharpness = max(fwidth(known), 1e-4);
    vec3 albedo = curvatureColor(0.5 + 0.5 * vValues.x / max(known, 1e-3) / curvatureRange);
    albedo = mix(${glslColor(undefinedColor)}, albedo, clamp((known - 0.5) / sharpness + 0.5, 0.0, 1.0));
    color = lit(albedo, normal, toViewer);
  }
}`;
