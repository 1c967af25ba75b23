// GLSL for the T-spline surface.

const splineVertexShader = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 curvature;
uniform mat4 view, projection;
out vec3 vPosition, vNormal;
out vec2 vCurvature;
void main() {
  vec4 p = view * vec4(position, 1.0);
  vPosition = p.xyz;
  vNormal = mat3(view) * normal;
  vCurvature = curvature;
  gl_Position = projection * p;
}`;

const splineFragmentShader = `#version 300 es
precision highp float;
precision highp int;
in vec3 vPosition, vNormal;
in vec2 vCurvature;
uniform int mode, lights;
uniform float lineCount, curvatureRange;
out vec4 color;
${shading}
// A material of a calm colour with a soft gloss.
vec3 material(vec3 albedo, vec3 normal, vec3 toViewer) {
  vec3 key = normalize(vec3(-0.45, 0.65, 0.62)), fill = normalize(vec3(0.85, 0.05, 0.5)), back = normalize(vec3(0.3, 0.5, -0.8));
  vec3 light = mix(vec3(0.17, 0.165, 0.16), vec3(0.31, 0.34, 0.38), 0.5 + 0.5 * normal.y)
    + 0.78 * max(dot(normal, key), 0.0) * vec3(1.0, 0.98, 0.94) + 0.17 * max(dot(normal, fill), 0.0) * vec3(0.80, 0.90, 1.0);
  float toward = max(dot(normal, toViewer), 0.0), fresnel = 0.04 + 0.5 * pow(1.0 - toward, 5.0);
  float sharp = pow(max(dot(normal, normalize(key + toViewer)), 0.0), 90.0);
  float broad = pow(max(dot(normal, normalize(key + toViewer)), 0.0), 14.0);
  float sky = smoothstep(-0.1, 0.9, reflect(-toViewer, normal).y);
  return pow(albedo, vec3(2.2)) * light + 0.16 * sharp + 0.045 * broad + fresnel * sky * vec3(0.45, 0.50, 0.56)
    + 0.05 * max(dot(normal, back), 0.0);
}
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
vec3 curvatureColor(float t) {
  vec3 stops[5] = vec3[5](${curvatureColors.map(glslColor).join(", ")});
  float x = clamp(2.0 + 2.0 * t, 0.0, 4.0);
  int i = min(int(x), 3);
  return mix(stops[i], stops[i + 1], x - float(i));
}
void main() {
  vec3 toViewer = normalize(-vPosition), normal = normalize(vNormal);
  // At the contour interpolated normals look a little away.
  bool isBack = !gl_FrontFacing && dot(normal, toViewer) < -0.05;
  if (isBack)
    normal = -normal;
  normal = normalize(normal - min(dot(normal, toViewer), 0.0) * toViewer);
  if (mode == 0)
    color = encode(material(isBack ? vec3(0.74, 0.66, 0.58) : vec3(0.67, 0.73, 0.79), normal, toViewer));
  else if (mode == 1) {
    vec3 mirrored = mix(vec3(0.012, 0.015, 0.02), vec3(0.93, 0.94, 0.95), lightLines(normal, toViewer));
    color = encode(mirrored * (0.50 + 0.50 * max(dot(normal, toViewer), 0.0)));
  }
  else {
    float known = vCurvature.y, sharpness = max(fwidth(known), 1e-4);
    vec3 albedo = curvatureColor(vCurvature.x / max(known, 1e-3) / curvatureRange);
    albedo = mix(${glslColor(undefinedColor)}, albedo, clamp((known - 0.5) / sharpness + 0.5, 0.0, 1.0));
    color = encode(pow(albedo, vec3(2.2)) * (0.74 + 0.26 * max(dot(normal, toViewer), 0.0)));
  }
}`;
