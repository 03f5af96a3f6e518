// Shaders: daylight of a clear sky above and the ground below, a sun with a soft shadow, a cut through the house.

const MODEL_VERTEX = `#version 300 es
in vec3 position; in vec3 normal; in vec3 move; in vec4 colour; in float gloss;
uniform mat4 camera; uniform mat4 sun; uniform float deformed;
out vec3 place; out vec3 facing; out vec4 base; out vec4 lit; out float shine;
void main() {
  place = position + move * deformed;
  facing = normal; base = colour; shine = gloss;
  lit = sun * vec4(place + normal * 0.03, 1.0);
  gl_Position = camera * vec4(place, 1.0);
}`;

const LIGHT = `
uniform highp sampler2DShadow shadow; uniform vec3 sunward; uniform float dark;
float sunshine(vec4 at) {
  vec3 p = at.xyz / at.w * 0.5 + 0.5;
  if (p.x < 0.0 || p.y < 0.0 || p.x > 1.0 || p.y > 1.0) return 1.0;
  float sum = 0.0;
  for (int x = -2; x <= 2; x++) for (int y = -2; y <= 2; y++)
    sum += texture(shadow, vec3(p.xy + vec2(x, y) * 1.1 / 2048.0, p.z - 0.0012));
  return sum / 25.0;
}
vec3 toScreen(vec3 c) {
  c = c * (1.0 + c * 0.12) / (1.0 + c * 0.35);
  return mix(12.92 * c, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}`;

const MODEL_FRAGMENT = `#version 300 es
precision highp float;
in vec3 place; in vec3 facing; in vec4 base; in vec4 lit; in float shine;
uniform vec3 eye; uniform float cut; uniform vec3 highlight;
out vec4 ink;${LIGHT}
void main() {
  if (place.y > cut) discard;
  vec3 n = normalize(facing);
  if (!gl_FrontFacing && cut < 1e5) { ink = vec4(toScreen(vec3(0.035, 0.037, 0.04)), 1.0); return; }
  vec3 sky = mix(vec3(0.36, 0.33, 0.29), vec3(0.62, 0.68, 0.76), n.y * 0.5 + 0.5);
  float sunlight = max(dot(n, sunward), 0.0);
  if (sunlight > 0.0) sunlight *= sunshine(lit);
  vec3 c = base.rgb * (sky + vec3(1.25, 1.17, 1.04) * sunlight);
  vec3 toEye = normalize(eye - place);
  float mirror = pow(max(dot(n, normalize(toEye + sunward)), 0.0), 60.0) * shine * sunlight;
  float rim = pow(1.0 - max(dot(n, toEye), 0.0), 4.0) * shine;
  c += vec3(mirror) + vec3(0.5, 0.56, 0.64) * rim * 0.6;
  ink = vec4(toScreen(c + highlight), base.a < 1.0 ? min(1.0, base.a + rim * 0.5) : 1.0);
}`;

const DEPTH_FRAGMENT = `#version 300 es
precision highp float;
in vec3 place; in vec4 base; uniform float cut;
void main() { if (place.y > cut || base.a < 0.9) discard; }`;

const GROUND_VERTEX = `#version 300 es
in vec3 position; uniform mat4 camera; uniform mat4 sun; out vec3 place; out vec4 lit;
void main() { place = position; lit = sun * vec4(position, 1.0); gl_Position = camera * vec4(position, 1.0); }`;

const GROUND_FRAGMENT = `#version 300 es
precision highp float;
in vec3 place; in vec4 lit;
uniform vec3 centre; uniform float radius; uniform vec3 ground; uniform vec3 horizon; uniform vec4 plot; uniform float module;
out vec4 ink;${LIGHT}
float ruled(vec2 p) {
  vec2 d = abs(fract(p - 0.5) - 0.5) / max(fwidth(p), vec2(1e-5));
  return 1.0 - min(min(d.x, d.y), 1.0);
}
void main() {
  float far = length(place.xz - centre.xz) / radius;
  vec3 c = ground * mix(0.74, 1.0, sunshine(lit));
  vec2 inside = step(plot.xy, place.xz) * step(place.xz, plot.zw);
  if (plot.z > plot.x) c *= 1.0 - 0.075 * inside.x * inside.y * (1.0 + ruled((place.xz - plot.xy) / module));
  ink = vec4(mix(c, horizon, smoothstep(0.35, 1.0, far)), 1.0);
}`;

function program(gl, vertex, fragment) {
  const made = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(made, shader);
  }
  ["position", "normal", "move", "colour", "gloss"].forEach((name, at) => gl.bindAttribLocation(made, at, name));
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  const places = new Map();
  made.at = (name) => places.get(name) ?? places.set(name, gl.getUniformLocation(made, name)).get(name);
  return made;
}
