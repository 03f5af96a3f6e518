// Draws models: a shadow map, the ground, what is solid, then what is clear. Only when something changed.

const SHADOW = 2048;
const SUN = unit([0.55, 0.78, 0.5]);

class Renderer {
  constructor(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "low-power" });
    if (!gl) throw new Error("this browser offers no WebGL 2");
    this.canvas = canvas;
    this.gl = gl;
    this.models = new Map();
    this.model = program(gl, MODEL_VERTEX, MODEL_FRAGMENT);
    this.depth = program(gl, MODEL_VERTEX, DEPTH_FRAGMENT);
    this.ground = program(gl, GROUND_VERTEX, GROUND_FRAGMENT);
    this.shadow = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.shadow);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, SHADOW, SHADOW);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    this.target = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.shadow, 0);
    gl.drawBuffers([gl.NONE]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.floor = gl.createBuffer();
    gl.enable(gl.DEPTH_TEST);
  }

  /** Takes a model to the card; an earlier one of that name goes. */
  put(name, model) {
    const gl = this.gl, triangles = trianglesOf(model);
    this.drop(name);
    const vao = gl.createVertexArray();
    gl.bindVertexArray(vao);
    const attribute = (at, data, width) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, width, gl.FLOAT, false, 0, 0);
      return buffer;
    };
    const buffers = [attribute(0, triangles.positions, 3), attribute(1, triangles.normals, 3), attribute(2, triangles.moves, 3)];
    const colours = attribute(3, new Float32Array(triangles.count * 4), 4), gloss = attribute(4, new Float32Array(triangles.count), 1);
    const elements = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, elements);
    const entry = { model, triangles, vao, colours, gloss, elements, all: [...buffers, colours, gloss, elements], solid: 0, clear: 0 };
    this.models.set(name, entry);
    this.paint(name, 0);
    return triangles;
  }

  drop(name) {
    const entry = this.models.get(name);
    if (!entry) return;
    entry.all.forEach((buffer) => this.gl.deleteBuffer(buffer));
    this.gl.deleteVertexArray(entry.vao);
    this.models.delete(name);
  }

  /** Colours a model as one of its views; solid triangles come first. */
  paint(name, view) {
    const entry = this.models.get(name);
    if (!entry) return;
    const { gl } = this, { model, triangles, vao } = entry;
    const looks = model.pieces.map((piece) => model.materials[piece.material(view)]);
    const colours = new Float32Array(triangles.count * 4), gloss = new Float32Array(triangles.count);
    const [solid, clear] = [[], []];
    for (let i = 0; i < triangles.count; i++) {
      const look = looks[triangles.pieces[i]];
      colours.set(look.colour, i * 4);
      if (!look.isClear) colours[i * 4 + 3] = 1;
      gloss[i] = look.isClear ? 0.9 : look.gloss * 0.4;
      (look.isClear ? clear : solid).push(i);
    }
    gl.bindVertexArray(vao);
    gl.bindBuffer(gl.ARRAY_BUFFER, entry.colours);
    gl.bufferData(gl.ARRAY_BUFFER, colours, gl.DYNAMIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, entry.gloss);
    gl.bufferData(gl.ARRAY_BUFFER, gloss, gl.DYNAMIC_DRAW);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, entry.elements);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint32Array.from([...solid, ...clear]), gl.DYNAMIC_DRAW);
    [entry.solid, entry.clear] = [solid.length, clear.length];
    gl.bindVertexArray(null);
  }

  /** Draws the models of `shown`; `scene` has camera, eye, box, cut, deformed, plot, colours. */
  draw(shown, scene) {
    const gl = this.gl, entries = shown.map((name) => this.models.get(name)).filter(Boolean);
    const middle = scene.centre, half = scene.radius * 1.15;
    const sun = times(orthographic(half, 0.1, half * 4), lookingAt(add(middle, SUN, half * 2), middle, [0, 1, 0]));
    const set = (p) => {
      gl.useProgram(p);
      gl.uniformMatrix4fv(p.at("sun"), false, sun);
      gl.uniform1f(p.at("deformed"), scene.deformed);
      gl.uniform1f(p.at("cut"), scene.cut);
      gl.uniform3fv(p.at("sunward"), SUN);
      gl.uniform1i(p.at("shadow"), 0);
    };
    gl.bindTexture(gl.TEXTURE_2D, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.viewport(0, 0, SHADOW, SHADOW);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    set(this.depth);
    gl.uniformMatrix4fv(this.depth.at("camera"), false, sun);
    gl.disable(gl.CULL_FACE);
    entries.forEach((entry) => this.elements(entry, 0, entry.solid));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(...scene.horizon.map(toSrgb), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.shadow);
    this.drawGround(scene, set);
    set(this.model);
    gl.uniformMatrix4fv(this.model.at("camera"), false, scene.camera);
    gl.uniform3fv(this.model.at("eye"), scene.eye);
    gl.uniform3f(this.model.at("highlight"), 0, 0, 0);
    if (scene.cut > 1e5) gl.enable(gl.CULL_FACE);
    entries.forEach((entry) => this.elements(entry, 0, entry.solid));
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    entries.forEach((entry) => this.elements(entry, entry.solid, entry.clear));
    gl.depthMask(true);
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
  }

  elements(entry, from, count) {
    if (!count) return;
    this.gl.bindVertexArray(entry.vao);
    this.gl.drawElements(this.gl.TRIANGLES, count, this.gl.UNSIGNED_INT, from * 4);
    this.gl.bindVertexArray(null);
  }

  drawGround(scene, set) {
    const gl = this.gl, [x, , z] = scene.centre, r = scene.radius * 7, y = scene.groundY;
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.floor);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([x - r, y, z - r, x - r, y, z + r, x + r, y, z - r, x + r, y, z + r]), gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    set(this.ground);
    gl.uniformMatrix4fv(this.ground.at("camera"), false, scene.camera);
    gl.uniform3fv(this.ground.at("centre"), scene.centre);
    gl.uniform1f(this.ground.at("radius"), r);
    gl.uniform3fv(this.ground.at("ground"), scene.ground.map(toSrgb));
    gl.uniform3fv(this.ground.at("horizon"), scene.horizon.map(toSrgb));
    gl.uniform4fv(this.ground.at("plot"), scene.plot || [0, 0, 0, 0]);
    gl.uniform1f(this.ground.at("module"), scene.module);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }
}

/** A byte of sRGB as a fraction; ground and sky are mixed as they are shown. */
const toSrgb = (byte) => byte / 255;
