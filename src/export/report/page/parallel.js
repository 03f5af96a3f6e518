// Parallel coordinates: a line for each house of the front, brushes on every axis.

const parallel = { scales: new Map(), places: new Map(), base: document.createElement("canvas"), sliders: [], drag: null, size: [0, 0] };
const TOP = 62, BOTTOM = 22;

function startParallel() {
  const varies = report.variables.filter((dim) => new Set(houses.map((house) => house.cells[dim.key])).size > 1);
  const wide = $("parallel-frame").clientWidth;
  const first = ["storeys", "footprint_cells", "roof_rise", "windows", "wall_section", "floor_section"];
  const rank = (dim) => (first.indexOf(dim.key) + 1 || 99);
  const room = Math.max(3, Math.min(9, Math.floor(wide / 96))) - objectives.length;
  state.axes = [...objectives, ...varies.sort((a, b) => rank(a) - rank(b)).slice(0, Math.max(1, room))].map((dim) => dim.key);
  showAxesMenu();
  const all = once(() => {
    layParallel();
    drawParallelBase();
    drawParallel();
  });
  on("axes", () => (showAxesMenu(), all()));
  on("theme", all);
  on("brush", () => (showReset(), askDraw()));
  on("chosen hover colour", () => askDraw());
  new ResizeObserver(all).observe($("parallel-frame"));
  listenParallel($("parallel"));
  all();
}

const askDraw = once(() => {
  parallel.sliders.forEach((slider) => slider.show());
  drawParallel();
});

function showAxesMenu() {
  const tools = $("parallel-tools"), isOpen = tools.querySelector("details")?.open;
  const boxes = dims.map((dim) => checkbox(labelOf(dim), state.axes.includes(dim.key), (want) => {
    const order = dims.map((d) => d.key).filter((key) => (key === dim.key ? want : state.axes.includes(key)));
    if (order.length < 2) return;
    state.axes = order;
    if (!want) setBrush(dim.key, []);
    emit("axes");
  }));
  fill(tools, h("h3", { text: "Objectives and variables" }),
    h("details", { class: "menu", open: isOpen }, h("summary", { text: "Axes" }), h("div", { class: "boxes" }, boxes)),
    h("span", { class: "count", id: "count" }), button("Clear brushes", { id: "reset", class: "quiet" }, clearBrushes));
  showReset();
}

function showReset() {
  $("count").textContent = countWords();
  $("reset").disabled = brushes.size === 0;
}

function layParallel() {
  const box = $("parallel-frame");
  const width = Math.max(box.clientWidth, state.axes.length * 92);
  const height = box.clientHeight - (width > box.clientWidth ? 14 : 0);
  parallel.size = [width, height];
  $("parallel-sheet").style.width = `${width}px`;
  const edge = Math.min(64, width / state.axes.length / 2 + 6);
  const gap = (width - edge * 2 - 30) / Math.max(1, state.axes.length - 1);
  parallel.gap = gap;
  parallel.places = new Map(state.axes.map((key, n) => [key, edge + n * gap]));
  parallel.scales = new Map(state.axes.map((key) => [key, scaleOf(dimOf.get(key), height - BOTTOM, TOP, 0)]));
  parallel.sliders = [];
  fill($("handles"), state.axes.map((key) => {
    const dim = dimOf.get(key), pair = [limitSlider(dim, 0), limitSlider(dim, 1)];
    parallel.sliders.push(...pair);
    const group = h("div", { class: "limits" }, pair);
    group.style.left = `${parallel.places.get(key)}px`;
    return group;
  }));
  parallel.sliders.forEach((slider) => slider.show());
}

/** The feasible designs beside the front, faint; the same whatever is brushed. */
function drawParallelBase() {
  const c = sized(parallel.base, ...parallel.size);
  c.clearRect(0, 0, ...parallel.size);
  const feasible = cloud.columns.get("feasible");
  if (!feasible) return;
  c.strokeStyle = inks.cloud;
  c.globalAlpha = 0.13;
  c.lineWidth = 0.8;
  const axes = state.axes.map((key) => [cloud.columns.get(key), parallel.places.get(key), parallel.scales.get(key)]);
  const rows = [];
  for (let i = 0; i < cloud.count; i++) if (feasible[i] && !cloud.isFront[i]) rows.push(i);
  const every = Math.max(1, Math.ceil(rows.length / 1500));
  c.beginPath();
  for (let n = 0; n < rows.length; n += every) {
    axes.forEach(([column, x, y], at) => (at ? c.lineTo(x, y(column[rows[n]])) : c.moveTo(x, y(column[rows[n]]))));
  }
  c.stroke();
}

function drawParallel() {
  const [width, height] = parallel.size;
  if (!width) return;
  const c = sized($("parallel"), width, height);
  c.clearRect(0, 0, width, height);
  c.drawImage(parallel.base, 0, 0, width, height);
  const trace = (house) => {
    c.beginPath();
    state.axes.forEach((key, at) => {
      const [x, y] = [parallel.places.get(key), parallel.scales.get(key)(valueOf(house, dimOf.get(key)))];
      if (at) c.lineTo(x, y);
      else c.moveTo(x, y);
    });
    c.stroke();
  };
  c.lineJoin = "round";
  const draw = (house, ink, line, alpha) => {
    [c.strokeStyle, c.lineWidth, c.globalAlpha] = [ink, line, alpha];
    trace(house);
  };
  houses.filter((house) => !passing.has(house)).forEach((house) => draw(house, inks.cloud, 1, 0.14));
  houses.filter((house) => passing.has(house)).forEach((house) => draw(house, colourOf(house), 1.5, 0.85));
  if (state.chosen) draw(state.chosen, inks.accent, 3, 1);
  if (state.hover) draw(state.hover, inks.ink, 2.5, 1);
  c.globalAlpha = 1;
  state.axes.forEach((key) => drawAxis(c, dimOf.get(key), parallel.places.get(key), parallel.scales.get(key), height));
}

function drawAxis(c, dim, x, y, height) {
  c.strokeStyle = inks.ink;
  c.lineWidth = 1;
  line(c, Math.round(x) + 0.5, TOP, Math.round(x) + 0.5, height - BOTTOM);
  c.textAlign = "center";
  c.textBaseline = "middle";
  c.fillStyle = inks.ink;
  c.font = font(12, 600);
  const room = parallel.gap - 8;
  const [one, two] = inTwo(c, dim.title, room);
  c.fillText(cut(c, one, room), x, two ? 10 : 17);
  if (two) c.fillText(cut(c, two, room), x, 24);
  c.font = font(11);
  c.fillStyle = inks.quiet;
  const better = dim.maximise === null ? "" : dim.maximise ? "↑ better" : "↓ better";
  c.fillText(cut(c, dim.unit, room), x, 38);
  c.fillText(better, x, 51);
  const list = brushes.get(dim.key) || [];
  for (const [low, high] of list) {
    c.globalAlpha = 0.25;
    c.fillStyle = inks.accent;
    const [a, b] = [y(high), y(low)];
    c.fillRect(x - 8, a, 16, Math.max(3, b - a));
    c.globalAlpha = 1;
    c.strokeStyle = inks.accent;
    c.lineWidth = 1.5;
    c.strokeRect(x - 8, a, 16, Math.max(3, b - a));
  }
  c.font = font(11);
  c.textAlign = "left";
  for (const [value, text] of marksOf(dim, y.low, y.high, 5)) {
    const v = y(value), shown = cut(c, text, Math.max(30, parallel.gap - 16));
    c.globalAlpha = 0.78;
    c.fillStyle = inks.sheet;
    c.fillRect(x + 4, v - 7, c.measureText(shown).width + 5, 14);
    c.globalAlpha = 1;
    c.strokeStyle = inks.ink;
    c.lineWidth = 1;
    line(c, x - 3, v, x + 3, v);
    c.fillStyle = inks.quiet;
    c.fillText(shown, x + 6, v + 0.5);
  }
}

/** A title on one line or two. */
function inTwo(c, text, room) {
  if (c.measureText(text).width <= room) return [text, ""];
  const words = text.split(" ");
  let n = words.length - 1;
  while (n > 1 && c.measureText(words.slice(0, n).join(" ")).width > room) n -= 1;
  return [words.slice(0, n).join(" "), words.slice(n).join(" ")];
}

function listenParallel(canvas) {
  const at = (e) => {
    const box = canvas.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  };
  const axisAt = (x) => state.axes.find((key) => Math.abs(parallel.places.get(key) - x) < 14);
  const held = (key, y) => Math.min(parallel.size[1] - BOTTOM, Math.max(TOP, y));
  canvas.addEventListener("pointerdown", (e) => {
    const [x, y] = at(e), key = axisAt(x);
    if (!key) {
      const house = lineAt(x, y);
      if (house) choose(house, "parallel");
      return;
    }
    canvas.setPointerCapture(e.pointerId);
    const scale = parallel.scales.get(key), list = brushes.get(key) || [];
    const hit = list.findIndex(([low, high]) => y >= scale(high) - 5 && y <= scale(low) + 5);
    parallel.drag = { key, y, hit, start: list, more: e.shiftKey, moved: false };
  });
  canvas.addEventListener("pointermove", (e) => {
    const [x, y] = at(e), drag = parallel.drag;
    canvas.style.cursor = axisAt(x) ? "ns-resize" : "pointer";
    if (!drag) return point(axisAt(x) ? null : lineAt(x, y));
    drag.moved ||= Math.abs(y - drag.y) > 3;
    if (!drag.moved) return;
    const scale = parallel.scales.get(drag.key);
    const others = drag.hit >= 0 ? drag.start.filter((_, n) => n !== drag.hit) : drag.more ? drag.start : [];
    let pair;
    if (drag.hit >= 0) {
      const [low, high] = drag.start[drag.hit], by = scale.invert(y) - scale.invert(drag.y);
      if (Math.abs(drag.y - scale(high)) < 6) pair = [low, scale.invert(held(drag.key, y))];
      else if (Math.abs(drag.y - scale(low)) < 6) pair = [scale.invert(held(drag.key, y)), high];
      else pair = [low + by, high + by];
    } else pair = [scale.invert(held(drag.key, drag.y)), scale.invert(held(drag.key, y))];
    setBrush(drag.key, [...others, pair.sort((a, b) => a - b)]);
  });
  const end = () => {
    const drag = parallel.drag;
    parallel.drag = null;
    if (drag && !drag.moved) setBrush(drag.key, drag.start.filter((_, n) => n !== drag.hit && drag.hit >= 0));
  };
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", () => (parallel.drag = null));
  canvas.addEventListener("pointerleave", () => point(null));
}

/** The house whose line passes nearest. */
function lineAt(x, y) {
  const after = state.axes.findIndex((key) => parallel.places.get(key) > x);
  if (after < 1) return null;
  const [a, b] = [state.axes[after - 1], state.axes[after]];
  const t = (x - parallel.places.get(a)) / (parallel.places.get(b) - parallel.places.get(a));
  const place = (house, key) => parallel.scales.get(key)(valueOf(house, dimOf.get(key)));
  let best = null, least = 7;
  for (const house of passing) {
    const far = Math.abs(place(house, a) * (1 - t) + place(house, b) * t - y);
    if (far < least) [best, least] = [house, far];
  }
  return best;
}
