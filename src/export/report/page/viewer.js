// The 3D view of the chosen house: turn, move, zoom, house or frame, its views, deformed shape and a cut.

const ANGLE = 0.5;
const viewer = { renderer: null, show: "house", view: 0, cut: 1, deformed: 0, turn: -0.7, tilt: 0.38, far: 1, target: [0, 0, 0], model: null, box: null, house: null, token: 0 };

function startViewer() {
  const canvas = $("model");
  try {
    viewer.renderer = new Renderer(canvas);
  } catch (error) {
    viewer.trouble = error.message;
    canvas.hidden = true;
  }
  const again = once(drawView);
  on("theme", again);
  on("chosen", () => loadModel());
  new ResizeObserver(again).observe($("view"));
  listenView(canvas, again);
  viewer.again = again;
  if (state.chosen) loadModel();
}

/** Shows the model of the chosen house, or its picture and why not. */
async function loadModel() {
  const house = state.chosen, token = ++viewer.token;
  const wanted = viewer.show === "frame" && hasFile(house, "frame.glb") ? "frame.glb" : "house.glb";
  const still = (words) => {
    $("model-note").hidden = !words;
    $("model-note").textContent = words;
    $("still").hidden = !words || !house.has_picture;
    $("model").hidden = !!words;
    if (words && house.has_picture) stored(`${house.id}/thumb.png`).then((text) => ($("still").src = `data:image/png;base64,${text}`));
  };
  if (!viewer.renderer) return showTools(null), still(`No 3D view: ${viewer.trouble}`);
  if (!hasFile(house, wanted)) return showTools(null), still("The model of this house is not in the page");
  try {
    const model = readGlb(await fileOf(house, wanted));
    if (token !== viewer.token) return;
    const isNew = viewer.house !== house;
    [viewer.model, viewer.house, viewer.view, viewer.deformed, viewer.picked] = [model, house, 0, 0, null];
    viewer.triangles = viewer.renderer.put("model", model);
    viewer.box = boxOf(viewer.triangles.positions);
    if (isNew || !viewer.placed) resetView();
    still("");
    showTools(wanted);
    $("model").setAttribute("aria-label", `3D view of ${titleOf(house)}, ${wanted === "frame.glb" ? "its frame" : "outside"}`);
    viewer.again();
  } catch (error) {
    if (token === viewer.token) still(`The model could not be read: ${error.message}`);
  }
}

function boxOf(positions) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const k = i % 3;
    if (positions[i] < low[k]) low[k] = positions[i];
    if (positions[i] > high[k]) high[k] = positions[i];
  }
  return { low, high, centre: low.map((v, k) => (v + high[k]) / 2), radius: Math.hypot(...sub(high, low)) / 2 };
}

function resetView() {
  const [w, hgt] = [$("view").clientWidth, $("view").clientHeight];
  Object.assign(viewer, { placed: true, turn: -0.7, tilt: 0.38, cut: 1, target: [...viewer.box.centre] });
  viewer.far = (viewer.box.radius / Math.sin(ANGLE / 2)) * 0.98 * Math.max(1, (hgt / w) * 1.25);
}

/** The plot on the ground, x and z from and to, as the brief has it. */
function plotOf() {
  const plot = report.run.brief?.plot;
  if (!Array.isArray(plot?.modules)) return [null, 1];
  const [nx, ny] = plot.modules, [sx, sy] = plot.module_m || [0.9, 0.9];
  return [[-sx / 2, -(ny - 0.5) * sy, (nx - 0.5) * sx, sy / 2], sx];
}

const eyeOf = () => add(viewer.target, [Math.sin(viewer.turn) * Math.cos(viewer.tilt), Math.sin(viewer.tilt), Math.cos(viewer.turn) * Math.cos(viewer.tilt)], viewer.far);

function drawView() {
  const box = $("view"), canvas = $("model");
  if (!viewer.model || canvas.hidden) return;
  const ratio = Math.min(devicePixelRatio || 1, 2);
  const [w, hgt] = [box.clientWidth, box.clientHeight].map((v) => Math.max(1, Math.round(v * ratio)));
  if (canvas.width !== w || canvas.height !== hgt) [canvas.width, canvas.height] = [w, hgt];
  const { low, high, centre, radius } = viewer.box, eye = eyeOf();
  const near = Math.max(0.1, viewer.far - radius * 8);
  const [plot, module] = plotOf();
  viewer.camera = times(perspective(ANGLE, w / hgt, near, viewer.far + radius * 16), lookingAt(eye, viewer.target, [0, 1, 0]));
  viewer.renderer.draw(["model"], {
    camera: viewer.camera, eye, centre, radius, plot, module, deformed: viewer.deformed, groundY: Math.max(low[1], -0.17),
    cut: viewer.cut >= 1 ? 1e6 : low[1] + (high[1] - low[1]) * viewer.cut,
    ground: inks.isDark ? [58, 60, 58] : [226, 224, 216], horizon: inks.isDark ? [33, 36, 40] : [238, 241, 244],
  });
}

function showTools(file) {
  const tools = $("model-tools"), house = state.chosen;
  if (!file) return fill(tools);
  const choice = (name, words) => button(words, { class: "segment", "aria-pressed": viewer.show === name }, () => {
    viewer.show = name;
    loadModel();
  });
  const slide = (label, value, change) => h("label", { class: "field" }, h("span", { text: label }),
    h("input", { type: "range", min: 0, max: 1, step: 0.01, value, oninput: (e) => (change(Number(e.target.value)), viewer.again()) }));
  fill(tools,
    hasFile(house, "frame.glb") ? h("span", { class: "segments", role: "group", "aria-label": "Shown" }, choice("house", "House"), choice("frame", "Frame")) : null,
    viewer.model.views.length ? select("View", viewer.model.views.map((name, n) => [n, name]), viewer.view, (v) => {
      viewer.view = Number(v);
      viewer.renderer.paint("model", viewer.view);
      showViewKey();
      viewer.again();
    }) : null,
    viewer.model.shape ? slide("Deformed", 0, (v) => (viewer.deformed = v)) : null,
    slide("Cut", viewer.cut, (v) => (viewer.cut = v)),
    button("Reset view", { class: "quiet" }, () => {
      resetView();
      showTools(file);
      viewer.again();
    }),
    h("ul", { class: "key", id: "model-key" }),
    h("output", { class: "picked", id: "picked", text: viewer.model.shape ? viewer.model.shape : "" }));
  showViewKey();
}

/** What the colours of a view mean: the materials that it shows. */
function showViewKey() {
  const { views, pieces, materials } = viewer.model;
  const used = views.length ? [...new Set(pieces.map((piece) => piece.material(viewer.view)))].sort((a, b) => a - b) : [];
  const screen = (c) => Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055));
  fill($("model-key"), used.slice(0, 14).map((at) => h("li", {}, h("i", { class: "mark dot", style: `background:rgb(${materials[at].colour.slice(0, 3).map(screen)})` }),
    h("span", { text: materials[at].name.replaceAll("_", " ") }))));
}

function turnBy(turn, tilt) {
  viewer.turn += turn;
  viewer.tilt = Math.min(1.5, Math.max(0.03, viewer.tilt + tilt));
  viewer.again();
}

function moveBy(right, up) {
  const k = viewer.far * 0.0016, side = [Math.cos(viewer.turn), 0, -Math.sin(viewer.turn)];
  viewer.target = add(add(viewer.target, side, right * k), [0, 1, 0], up * k);
  viewer.again();
}

function zoomBy(factor) {
  viewer.far = Math.min(viewer.box.radius * 7, Math.max(viewer.box.radius * 0.35, viewer.far * factor));
  viewer.again();
}

function listenView(canvas, again) {
  const fingers = new Map();
  let travelled = 0, apart = 0;
  canvas.addEventListener("pointerdown", (e) => {
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    canvas.setPointerCapture(e.pointerId);
    travelled = apart = 0;
  });
  canvas.addEventListener("pointermove", (e) => {
    const before = fingers.get(e.pointerId);
    if (!before || !viewer.model) return;
    const [dx, dy] = [e.clientX - before[0], e.clientY - before[1]];
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    travelled += Math.abs(dx) + Math.abs(dy);
    if (fingers.size === 2) {
      const [a, b] = [...fingers.values()], now = Math.hypot(a[0] - b[0], a[1] - b[1]);
      if (apart) zoomBy(apart / now);
      apart = now;
    } else if (e.shiftKey || e.buttons === 2) moveBy(-dx, dy);
    else turnBy(-dx * 0.008, e.pointerType === "touch" ? 0 : dy * 0.006);
  });
  const up = (e) => {
    fingers.delete(e.pointerId);
    if (e.type === "pointerup" && travelled < 5 && viewer.model) pick(e);
  };
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("contextmenu", (e) => e.preventDefault());
  canvas.addEventListener("wheel", (e) => {
    if (document.activeElement !== canvas && !e.ctrlKey) return;
    e.preventDefault();
    if (viewer.model) zoomBy(Math.exp(Math.sign(e.deltaY) * 0.1));
  }, { passive: false });
  canvas.addEventListener("keydown", (e) => {
    if (!viewer.model) return;
    const keys = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const key = e.key.toLowerCase();
    if (e.key in keys && e.shiftKey) moveBy(keys[e.key][0] * 20, keys[e.key][1] * 20);
    else if (e.key in keys) turnBy(keys[e.key][0] * 0.12, keys[e.key][1] * 0.08);
    else if (e.key === "+" || e.key === "=") zoomBy(0.88);
    else if (e.key === "-") zoomBy(1.14);
    else if (key === "h" || key === "f") {
      viewer.show = key === "h" ? "house" : "frame";
      loadModel();
    } else if (e.key === "Home") {
      resetView();
      again();
    } else return;
    e.preventDefault();
  });
}

/** Names what is under the pointer: a member with its section and check, or a layer. */
function pick(e) {
  const box = $("model").getBoundingClientRect(), eye = eyeOf();
  const u = ((e.clientX - box.left) / box.width) * 2 - 1, v = 1 - ((e.clientY - box.top) / box.height) * 2;
  const back = unit(sub(eye, viewer.target)), right = unit(cross([0, 1, 0], back)), up = cross(back, right);
  const k = Math.tan(ANGLE / 2);
  const ray = unit(add(add(back.map((c) => -c), right, u * k * (box.width / box.height)), up, v * k));
  const { positions, moves, pieces, count } = viewer.triangles;
  const height = viewer.cut >= 1 ? Infinity : viewer.box.low[1] + (viewer.box.high[1] - viewer.box.low[1]) * viewer.cut;
  const corner = (i) => [0, 1, 2].map((c) => positions[i * 3 + c] + moves[i * 3 + c] * viewer.deformed);
  let best = -1, least = Infinity;
  for (let i = 0; i < count; i += 3) {
    const a = corner(i), p = sub(corner(i + 1), a), q = sub(corner(i + 2), a), n = cross(ray, q), d = dot(p, n);
    if (Math.abs(d) < 1e-9) continue;
    const s = sub(eye, a), f = dot(s, n) / d, w = cross(s, p), g = dot(ray, w) / d, t = dot(q, w) / d;
    if (f < 0 || g < 0 || f + g > 1 || t <= 0 || t >= least || eye[1] + ray[1] * t > height) continue;
    [best, least] = [i, t];
  }
  const node = best < 0 ? null : viewer.model.pieces[pieces[best]].node;
  $("picked").textContent = node ? wordsOfNode(node) : viewer.model.shape;
}

function wordsOfNode({ name, extras }) {
  const words = [name.replaceAll("_", " ")];
  const has = (key, say) => extras[key] !== undefined && extras[key] !== null && words.push(say(extras[key]));
  has("material", (v) => (typeof v === "string" ? `${v} ${extras.section ?? ""}` : ""));
  has("length_m", (v) => `${fixed(v, 2)} m`);
  has("utilisation", (v) => `utilisation ${fixed(v, 2)}`);
  has("check", (v) => v);
  has("volume_m3", (v) => `${fixed(v, 2)} m³`);
  has("area_m2", (v) => `${fixed(v, 1)} m²`);
  has("mass_kg", (v) => `${plain(v)} kg`);
  return words.filter(Boolean).join(" · ");
}
