// The scatter plot: every evaluated design and the front, two dimensions at a time.

const scatter = { x: null, y: null, infeasible: true, base: document.createElement("canvas"), drag: null, rule: null, milliseconds: 0 };

function startScatter() {
  const keys = dims.map((dim) => [dim.key, labelOf(dim)]);
  scatter.x = objectives[0]?.key ?? dims[0]?.key;
  // What is to be large against what is to be small shows the trade; two of a kind often go together.
  const across = objectives.slice(1), up = across.find((dim) => dim.maximise !== objectives[0].maximise) ?? across[0];
  scatter.y = up?.key ?? dims[1]?.key ?? scatter.x;
  state.colour = across.find((dim) => dim !== up)?.key ?? objectives[0]?.key ?? null;
  const colours = [...(lookOf.size ? [["group", "group by look"]] : []), ...keys];
  const redraw = () => {
    drawBase();
    drawScatter();
  };
  const asked = once(redraw);
  fill($("scatter-tools"),
    select("Across", keys, scatter.x, (v) => ((scatter.x = v), redraw())),
    select("Up", keys, scatter.y, (v) => ((scatter.y = v), redraw())),
    select("Colour", colours, state.colour, (v) => ((state.colour = v), emit("colour"))),
    cloud.count ? checkbox("infeasible", true, (v) => ((scatter.infeasible = v), redraw())) : null);
  on("brush theme colour", asked);
  on("chosen hover shortlist", once(drawScatter));
  new ResizeObserver(asked).observe($("scatter-frame"));
  listenScatter($("scatter"));
  redraw();
}

function frameOf(box) {
  const [dx, dy] = [dimOf.get(scatter.x), dimOf.get(scatter.y)];
  const size = [box.clientWidth, box.clientHeight];
  const left = dy.words.length ? Math.min(150, size[0] * 0.3) : 66;
  const bottom = dx.words.length ? 96 : 50;
  const at = [left, 14, size[0] - 16, size[1] - bottom];
  return { size, at, dx, dy, x: scaleOf(dx, at[0], at[2], 0.05), y: scaleOf(dy, at[3], at[1], 0.05) };
}

/** Everything that does not follow the pointer. */
function drawBase() {
  const f = (scatter.frame = frameOf($("scatter-frame")));
  const c = sized(scatter.base, ...f.size);
  c.clearRect(0, 0, ...f.size);
  drawAxes(c, f);
  c.save();
  c.beginPath();
  c.rect(f.at[0], f.at[1], f.at[2] - f.at[0], f.at[3] - f.at[1]);
  c.clip();
  const X = cloud.columns.get(scatter.x), Y = cloud.columns.get(scatter.y), feasible = cloud.columns.get("feasible");
  const isBrushed = brushes.size > 0;
  const layer = (wanted, passes, draw, alpha) => {
    c.globalAlpha = alpha;
    c.beginPath();
    for (let i = 0; i < cloud.count; i++) {
      if (feasible[i] === wanted && passMask[i] === passes && !cloud.isFront[i]) draw(f.x(X[i]), f.y(Y[i]));
    }
  };
  const cross = (x, y) => {
    c.moveTo(x - 2, y - 2);
    c.lineTo(x + 2, y + 2);
    c.moveTo(x - 2, y + 2);
    c.lineTo(x + 2, y - 2);
  };
  const dot = (x, y) => {
    c.moveTo(x + 2.4, y);
    c.arc(x, y, 2.4, 0, 7);
  };
  if (X && Y) {
    c.lineWidth = 1;
    for (const passes of isBrushed ? [0, 1] : [1]) {
      const fade = passes ? 1 : 0.22;
      if (scatter.infeasible) {
        c.strokeStyle = inks.miss;
        layer(0, passes, cross, 0.6 * fade);
        c.stroke();
      }
      c.fillStyle = inks.cloud;
      layer(1, passes, dot, 0.75 * fade);
      c.fill();
    }
  }
  c.restore();
  drawKey();
}

function drawAxes(c, f) {
  const [l, t, r, b] = f.at;
  c.font = font(12);
  c.lineWidth = 1;
  c.textBaseline = "middle";
  for (const [value, text] of marksOf(f.dx, f.x.low, f.x.high, Math.max(3, (r - l) / 90))) {
    const x = Math.round(f.x(value)) + 0.5;
    c.strokeStyle = inks.grid;
    line(c, x, t, x, b);
    c.fillStyle = inks.quiet;
    if (f.dx.words.length) {
      c.save();
      c.translate(x, b + 8);
      c.rotate(-0.6);
      c.textAlign = "right";
      c.fillText(cut(c, text, 100), 0, 0);
      c.restore();
    } else {
      c.textAlign = "center";
      c.fillText(text, x, b + 14);
    }
  }
  c.textAlign = "right";
  for (const [value, text] of marksOf(f.dy, f.y.low, f.y.high, Math.max(3, (b - t) / 60))) {
    const y = Math.round(f.y(value)) + 0.5;
    c.strokeStyle = inks.grid;
    line(c, l, y, r, y);
    c.fillStyle = inks.quiet;
    c.fillText(cut(c, text, l - 26), l - 8, y);
  }
  c.strokeStyle = inks.line;
  line(c, l, b + 0.5, r, b + 0.5);
  line(c, l + 0.5, t, l + 0.5, b);
  c.fillStyle = c.strokeStyle = inks.ink;
  c.font = font(13, 500);
  c.textAlign = "center";
  const foot = f.size[1] - 12;
  c.fillText(labelOf(f.dx), (l + r) / 2, foot);
  c.save();
  c.translate(12, (t + b) / 2);
  c.rotate(-Math.PI / 2);
  c.fillText(labelOf(f.dy), 0, 0);
  c.restore();
  c.font = font(11);
  c.fillStyle = c.strokeStyle = inks.quiet;
  if (f.dx.maximise !== null) {
    const half = 30 + c.measureText("better").width;
    c.textAlign = "left";
    const x = f.dx.maximise ? r - half : l + 30;
    // On a phone the title needs the room: the arrow says it alone.
    if (r - l > 420) c.fillText("better", x, foot);
    if (f.dx.maximise) arrow(c, r - 24, foot, 1, 0, 24);
    else arrow(c, l + 24, foot, -1, 0, 24);
  }
  if (f.dy.maximise !== null) {
    const y = f.dy.maximise ? t : b;
    arrow(c, 12, f.dy.maximise ? t + 24 : b - 24, 0, f.dy.maximise ? -1 : 1, 24);
    c.save();
    c.translate(12, f.dy.maximise ? y + 30 : y - 30);
    c.rotate(-Math.PI / 2);
    c.textAlign = f.dy.maximise ? "right" : "left";
    c.fillText("better", 0, 0);
    c.restore();
  }
}

function line(c, x0, y0, x1, y1) {
  c.beginPath();
  c.moveTo(x0, y0);
  c.lineTo(x1, y1);
  c.stroke();
}

/** The front, what is pointed at, names and the rectangle of a drag. */
function drawScatter() {
  const f = scatter.frame;
  if (!f) return;
  const c = sized($("scatter"), ...f.size);
  c.clearRect(0, 0, ...f.size);
  c.drawImage(scatter.base, 0, 0, ...f.size);
  const place = (house) => [f.x(valueOf(house, f.dx)), f.y(valueOf(house, f.dy))];
  for (const house of houses) {
    const [x, y] = place(house);
    c.globalAlpha = passing.has(house) ? 1 : 0.25;
    c.beginPath();
    c.arc(x, y, 5.2, 0, 7);
    c.fillStyle = passing.has(house) ? colourOf(house) : inks.cloud;
    c.fill();
    c.lineWidth = 1.2;
    c.strokeStyle = inks.sheet;
    c.stroke();
  }
  c.globalAlpha = 1;
  drawNames(c, f, place);
  state.shortlist.forEach((house, at) => badge(c, ...place(house), LETTERS[at]));
  if (state.chosen) ring(c, ...place(state.chosen), 8.5, 3, inks.accent);
  if (state.hover) ring(c, ...place(state.hover), 8, 2, inks.ink);
  if (scatter.drag?.moved) {
    const { from, to } = scatter.drag;
    c.strokeStyle = inks.accent;
    c.lineWidth = 1.5;
    c.setLineDash([4, 3]);
    c.strokeRect(from[0], from[1], to[0] - from[0], to[1] - from[1]);
    c.setLineDash([]);
  }
}

function ring(c, x, y, radius, width, ink) {
  c.beginPath();
  c.arc(x, y, radius, 0, 7);
  c.lineWidth = width;
  c.strokeStyle = ink;
  c.stroke();
}

function badge(c, x, y, letter) {
  c.font = font(11, 700);
  c.textAlign = "center";
  c.textBaseline = "middle";
  c.fillStyle = inks.ink;
  c.fillRect(x + 6, y - 19, 15, 15);
  c.fillStyle = inks.sheet;
  c.fillText(letter, x + 13.5, y - 11);
}

/** Names beside their houses, where they cover neither each other nor the edge. */
function drawNames(c, f, place) {
  c.font = font(12, 600);
  c.textBaseline = "middle";
  const taken = [];
  for (const { id, name } of report.named) {
    const house = houseOf.get(id);
    if (!house || !passing.has(house)) continue;
    const [x, y] = place(house);
    const w = c.measureText(name).width;
    const places = [[x + 12, y - 13], [x + 12, y + 13], [x - 12 - w, y - 13], [x - 12 - w, y + 13], [x - w / 2, y - 20], [x - w / 2, y + 20]];
    const box = places.map(([u, v]) => [u - 3, v - 8, u + w + 3, v + 8]).find((b) =>
      b[0] > f.at[0] && b[2] < f.at[2] && b[1] > f.at[1] && b[3] < f.at[3]
      && taken.every((o) => b[2] < o[0] || b[0] > o[2] || b[3] < o[1] || b[1] > o[3]));
    ring(c, x, y, 6.4, 1.4, inks.ink);
    if (!box) continue;
    taken.push(box);
    c.globalAlpha = 0.85;
    c.fillStyle = inks.sheet;
    c.fillRect(box[0], box[1], box[2] - box[0], box[3] - box[1]);
    c.globalAlpha = 1;
    c.fillStyle = inks.ink;
    c.textAlign = "left";
    c.fillText(name, box[0] + 3, (box[1] + box[3]) / 2 + 0.5);
  }
}

/** What dots and colours mean. */
function drawKey() {
  const dim = dimOf.get(state.colour);
  const mark = (kind, style) => h("i", { class: `mark ${kind}`, style });
  const rows = [];
  if (state.colour === "group") {
    const groups = [...new Set([...lookOf.values()].map((l) => l.group))].sort();
    groups.forEach((g) => rows.push([mark("dot", `background:${SERIES[(g - 1) % SERIES.length]}`), `group ${g}`]));
  } else if (dim) {
    const values = houses.map((house) => valueOf(house, dim)).filter(Number.isFinite);
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const stops = [0, 0.25, 0.5, 0.75, 1].map(viridis).join(",");
    rows.push([mark("ramp", `background:linear-gradient(90deg,${stops})`), `front, by ${dim.title.toLowerCase()}: ${told(dim, low)} to ${told(dim, high)}`]);
  }
  if (cloud.count) {
    rows.push([mark("dot small", `background:${inks.cloud}`), "evaluated, feasible"]);
    if (scatter.infeasible) rows.push([mark("cross", `color:${inks.miss}`), "infeasible"]);
  }
  rows.push([mark("ring", `border-color:${inks.accent}`), "chosen"]);
  fill($("scatter-key"), rows.map(([sign, words]) => h("li", {}, sign, h("span", { text: words }))));
}
