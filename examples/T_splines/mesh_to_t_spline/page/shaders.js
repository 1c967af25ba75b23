// GLSL. Light comes from above the left shoulder of the viewer.

const shading = `
vec3 shade(vec3 albedo, vec3 normal, vec3 toViewer) {
  if (dot(normal, toViewer) < 0.0)
    normal = -normal;
  vec3 key = normalize(vec3(-0.35, 0.55, 0.75)), fill = normalize(vec3(0.8, -0.15, 0.4));
  float sky = 0.5 + 0.5 * normal.y;
  vec3 light = mix(vec3(0.25, 0.24, 0.24), vec3(0.36, 0.38, 0.42), sky)
    + 0.66 * max(dot(normal, key), 0.0) * vec3(1.0, 0.985, 0.95) + 0.16 * max(dot(normal, fill), 0.0) * vec3(0.85, 0.92, 1.0);
  float gloss = pow(max(dot(normal, normalize(key + toViewer)), 0.0), 48.0);
  float rim = pow(1.0 - max(dot(normal, toViewer), 0.0), 3.0);
  return pow(albedo, vec3(2.2)) * light * (1.0 - 0.25 * rim) + 0.10 * gloss;
}
vec4 encode(vec3 color) { return vec4(pow(clamp(color, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0); }
`;

// What the T-spline surface is made of, and the mesh that it is compared with.
const material = `
const vec3 frontColor = vec3(0.67, 0.73, 0.79), backColor = vec3(0.74, 0.66, 0.58);
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
`;

const surfaceVertexShader = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in float level;
layout(location = 4) in float scale;
layout(location = 5) in float dilatation;
layout(location = 6) in uint flags;
uniform mat4 view, projection;
out vec3 vPosition, vNormal, vSides;
out vec2 vUv;
out float vLevel, vScale;
flat out float vDilatation;
flat out uint vFlags;
void main() {
  vec4 p = view * vec4(position, 1.0);
  vPosition = p.xyz;
  vNormal = mat3(view) * normal;
  vUv = uv;
  vLevel = level;
  vScale = scale;
  vDilatation = dilatation;
  vFlags = flags;
  int corner = gl_VertexID % 3;
  vSides = vec3(corner == 0, corner == 1, corner == 2);
  gl_Position = projection * p;
}`;

const surfaceFragmentShader = `#version 300 es
precision highp float;
precision highp int;
in vec3 vPosition, vNormal, vSides;
in vec2 vUv;
in float vLevel, vScale;
flat in float vDilatation;
flat in uint vFlags;
uniform int mode, wire;
uniform float cellOctaves, scaleRange, pixels;
out vec4 color;
${shading}
${material}
// A checkerboard with cells of size 1, averaged over the pixel, in [0, 1].
float checker(vec2 p, vec2 width) {
  vec2 w = max(width, 1e-6);
  vec2 i = 2.0 * (abs(fract((p - 0.5 * w) * 0.5) - 0.5) - abs(fract((p + 0.5 * w) * 0.5) - 0.5)) / w;
  return 0.5 - 0.5 * i.x * i.y;
}
// How much of the pixel the lines of the unit grid cover, for lines of the given width in pixels.
float grid(vec2 p, vec2 width, float thickness) {
  vec2 w = max(width, 1e-6);
  vec2 d = abs(fract(p - 0.5) - 0.5) / w;
  vec2 cover = clamp(0.5 * thickness + 0.5 - d, 0.0, 1.0) * smoothstep(0.6, 0.2, w * thickness);
  return max(cover.x, cover.y);
}
vec3 diverging(float t) {
  vec3 low = vec3(0.13, 0.35, 0.66), middle = vec3(0.95, 0.94, 0.91), high = vec3(0.74, 0.18, 0.13);
  return t < 0.0 ? mix(middle, low, pow(min(-t, 1.0), 0.8)) : mix(middle, high, pow(min(t, 1.0), 0.8));
}
vec3 sequential(float t) {
  t = clamp(t, 0.0, 1.0);
  return t < 0.5 ? mix(vec3(0.96, 0.95, 0.90), vec3(0.93, 0.60, 0.30), 2.0 * t)
                 : mix(vec3(0.93, 0.60, 0.30), vec3(0.45, 0.06, 0.25), 2.0 * t - 1.0);
}
void main() {
  vec2 width = max(abs(dFdx(vUv)), abs(dFdy(vUv)));
  vec3 sideWidth = fwidth(vSides);
  // The cells have a size of 2^k, the power of two at which they look most alike on the surface; between two powers the
  // pattern fades.
  float level = vLevel + cellOctaves, k = floor(level), fade = smoothstep(0.40, 0.60, level - k);
  float fine = exp2(-k), coarse = 0.5 * fine;
  vec3 albedo = vec3(0.90, 0.88, 0.84);
  if (mode == 0) {
    float value = mix(checker(vUv * fine, width * fine), checker(vUv * coarse, width * coarse), fade);
    albedo = mix(vec3(0.965, 0.945, 0.90), vec3(0.33, 0.47, 0.63), value);
  }
  else if (mode == 1) {
    float lines = max(grid(vUv * fine, width * fine, 1.0 * pixels) * (1.0 - fade) * 0.75,
                      grid(vUv * coarse, width * coarse, (1.4 - 0.4 * fade) * pixels) * 0.75);
    lines = max(lines, grid(0.5 * vUv * coarse, 0.5 * width * coarse, (1.4 * fade) * pixels) * 0.75 * fade);
    albedo = mix(vec3(0.95, 0.935, 0.90), vec3(0.12, 0.24, 0.42), lines);
  }
  else if (mode == 2)
    albedo = diverging(vScale / scaleRange);
  else if (mode == 3)
    albedo = sequential(vDilatation);
  else if (mode == 5)
    albedo = gl_FrontFacing ? frontColor : backColor;
  if (wire > 0) {
    vec3 distance = vSides / max(sideWidth, 1e-9);
    for (int i = 0; i < 3; ++i)
      if (wire == 2 || (vFlags & (1u << i)) != 0u)
        albedo = mix(albedo, vec3(0.10, 0.12, 0.15), 0.62 * clamp(0.5 * pixels + 0.35 - distance[i], 0.0, 1.0));
  }
  vec3 normal = normalize(vNormal), toViewer = normalize(-vPosition);
  if (mode == 5) {
    normal = gl_FrontFacing ? normal : -normal;
    normal = normalize(normal - min(dot(normal, toViewer), 0.0) * toViewer);
    color = encode(material(albedo, normal, toViewer));
  }
  else
    color = encode(shade(albedo, normal, toViewer));
}`;

// Lines as quadrilaterals of constant width, drawn a little nearer than they are.
const lineVertexShader = `#version 300 es
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
uniform mat4 view, projection;
uniform vec2 viewport;
uniform float thickness, depth; // the latter less than 1: nearer than what the line lies on
void main() {
  vec4 p = view * vec4(from, 1.0), q = view * vec4(to, 1.0);
  p.xyz *= depth;
  q.xyz *= depth;
  vec4 a = projection * p, b = projection * q;
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
  along = length(along) > 1e-6 ? normalize(along) : vec2(1.0, 0.0);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec4 c = corner.y < 0.0 ? a : b;
  c.xy += (corner.x * vec2(-along.y, along.x) + 0.7 * corner.y * along) * thickness / viewport * c.w;
  gl_Position = c;
}`;

const lineFragmentShader = `#version 300 es
precision highp float;
uniform vec3 lineColor;
out vec4 color;
void main() { color = vec4(lineColor, 1.0); }`;

const coneVertexShader = `#version 300 es
layout(location = 0) in vec3 direction;
layout(location = 1) in vec3 center;
layout(location = 2) in vec3 coneColor;
uniform mat4 view, projection;
uniform float radius, leastRadius; // the latter as a share of half the height of the view
out vec3 vPosition, vNormal, vColor;
void main() {
  float distance = -(view * vec4(center, 1.0)).z;
  float r = max(radius, leastRadius * distance / projection[1][1]);
  vec4 p = view * vec4(center + r * direction, 1.0);
  vPosition = p.xyz;
  vNormal = mat3(view) * direction;
  vColor = coneColor;
  p.xyz *= 0.9975; // nearer than the lines
  gl_Position = projection * p;
}`;

const coneFragmentShader = `#version 300 es
precision highp float;
in vec3 vPosition, vNormal, vColor;
out vec4 color;
${shading}
void main() { color = encode(shade(vColor, normalize(vNormal), normalize(-vPosition)) + 0.06 * vColor); }`;
