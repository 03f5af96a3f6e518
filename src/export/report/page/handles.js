// Pointer and keyboard of the scatter plot, and the limits of brushes that the keyboard moves.

function listenScatter(canvas) {
  const at = (e) => {
    const box = canvas.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  };
  canvas.addEventListener("pointerdown", (e) => {
    if (e.button !== 0) return;
    scatter.drag = { from: at(e), to: at(e), moved: false, touch: e.pointerType === "touch" };
    if (e.pointerType !== "touch") canvas.setPointerCapture(e.pointerId);
  });
  canvas.addEventListener("pointermove", (e) => {
    const here = at(e), drag = scatter.drag;
    if (drag && !drag.touch) {
      drag.to = here;
      drag.moved ||= Math.hypot(here[0] - drag.from[0], here[1] - drag.from[1]) > 5;
      if (drag.moved) return drawScatter();
    }
    showTip(here);
  });
  canvas.addEventListener("pointerup", (e) => {
    const drag = scatter.drag;
    scatter.drag = null;
    if (drag?.moved) return brushRectangle(drag.from, drag.to);
    const house = nearestHouse(at(e), 16);
    if (house) choose(house, "scatter");
  });
  canvas.addEventListener("pointercancel", () => (scatter.drag = null));
  canvas.addEventListener("pointerleave", () => {
    $("tip").hidden = true;
    point(null);
  });
  canvas.addEventListener("blur", () => point(null));
  canvas.addEventListener("keydown", (e) => {
    const f = scatter.frame;
    const steps = { ArrowRight: [f.dx, 1], ArrowLeft: [f.dx, -1], ArrowUp: [f.dy, 1], ArrowDown: [f.dy, -1] };
    if (steps[e.key]) step(...steps[e.key]);
    else if ((e.key === "Enter" || e.key === " ") && state.hover) choose(state.hover, "scatter");
    else if (e.key.toLowerCase() === "s" && (state.hover || state.chosen)) shortlist(state.hover || state.chosen);
    else if (e.key === "Escape") clearBrushes();
    else return;
    e.preventDefault();
  });
  canvas.setAttribute("aria-label", `Scatter plot of ${fixed(houses.length, 0)} houses of the front and ${fixed(cloud.count, 0)} evaluated designs`);
}

/** Goes to the next house along a dimension. */
function step(dim, way) {
  const order = houses.filter((house) => passing.has(house)).sort((a, b) => valueOf(a, dim) - valueOf(b, dim) || a.id - b.id);
  if (!order.length) return;
  const now = order.indexOf(state.hover || state.chosen);
  const next = order[now < 0 ? 0 : Math.min(order.length - 1, Math.max(0, now + way))];
  point(next);
  announce(summaryOf(next));
}

function brushRectangle(from, to) {
  const f = scatter.frame;
  const span = (scale, a, b) => [scale.invert(a), scale.invert(b)].sort((p, q) => p - q);
  brushes.set(scatter.x, [span(f.x, from[0], to[0])]);
  brushes.set(scatter.y, [span(f.y, from[1], to[1])]);
  for (const key of [scatter.x, scatter.y]) if (!state.axes.includes(key)) state.axes.push(key);
  emit("axes");
  sift();
}

function nearestHouse([x, y], within) {
  const f = scatter.frame;
  let best = null, least = within;
  for (const house of houses) {
    const far = Math.hypot(f.x(valueOf(house, f.dx)) - x, f.y(valueOf(house, f.dy)) - y);
    if (far < least && passing.has(house)) [best, least] = [house, far];
  }
  return best;
}

function showTip([x, y]) {
  const tip = $("tip"), f = scatter.frame, house = nearestHouse([x, y], 12);
  point(house);
  let lines = [];
  if (house) {
    const name = namedOf.get(house.id);
    lines = [`${titleOf(house)}${name ? ` · ${name.name}` : ""}`, ...objectives.map((dim) => `${dim.title}: ${told(dim, valueOf(house, dim))}`)];
  } else {
    const row = nearestDesign([x, y], 5);
    if (row >= 0) {
      const value = (dim) => cloud.columns.get(dim.key)?.[row];
      lines = [`Evaluation ${cloud.columns.get("id")[row]}`, cloud.columns.get("feasible")[row] ? "feasible, not on the front" : `infeasible, by ${plain(cloud.columns.get("violation")[row])}`,
        ...objectives.map((dim) => `${dim.title}: ${told(dim, value(dim))}`)];
    }
  }
  tip.hidden = !lines.length;
  fill(tip, lines.map((text, at) => h(at ? "span" : "strong", { text })));
  const right = x > f.size[0] * 0.6;
  tip.style.left = right ? "auto" : `${x + 16}px`;
  tip.style.right = right ? `${f.size[0] - x + 16}px` : "auto";
  tip.style.top = `${Math.max(4, Math.min(y - 20, f.size[1] - 110))}px`;
}

function nearestDesign([x, y], within) {
  const f = scatter.frame, X = cloud.columns.get(scatter.x), Y = cloud.columns.get(scatter.y), feasible = cloud.columns.get("feasible");
  if (!X || !Y) return -1;
  let best = -1, least = within;
  for (let i = 0; i < cloud.count; i++) {
    if (!scatter.infeasible && !feasible[i]) continue;
    const far = Math.hypot(f.x(X[i]) - x, f.y(Y[i]) - y);
    if (far < least) [best, least] = [i, far];
  }
  return best;
}

/** A limit of a brush as a slider, at the end of the axis while nothing is brushed. */
function limitSlider(dim, end) {
  const [low, high] = extentOf(dim);
  const now = () => {
    const list = brushes.get(dim.key);
    return list ? list[list.length - 1] : [low, high];
  };
  const amount = dim.words.length || isWhole(dim) ? 1 : (high - low) / 50 || 1;
  const slider = h("span", { class: `limit ${end ? "top" : "bottom"}`, role: "slider", tabindex: 0, "aria-orientation": "vertical",
    "aria-label": `${labelOf(dim)}, ${end ? "at most" : "at least"}` });
  slider.show = () => {
    const value = now()[end];
    const inRange = Math.min(high, Math.max(low, value));
    slider.setAttribute("aria-valuemin", low);
    slider.setAttribute("aria-valuemax", high);
    slider.setAttribute("aria-valuenow", inRange);
    slider.setAttribute("aria-valuetext", told(dim, dim.words.length ? Math.round(inRange) : inRange));
    slider.style.top = `${parallel.scales.get(dim.key)(inRange)}px`;
  };
  slider.addEventListener("keydown", (e) => {
    const moves = { ArrowUp: amount, ArrowDown: -amount, PageUp: amount * 5, PageDown: -amount * 5 };
    const pair = [...now()];
    if (e.key in moves) pair[end] += moves[e.key];
    else if (e.key === "Home") pair[end] = low;
    else if (e.key === "End") pair[end] = high;
    else if (e.key === "Delete" || e.key === "Backspace" || e.key === "Escape") return setBrush(dim.key, []), e.preventDefault();
    else return;
    e.preventDefault();
    pair[end] = Math.min(high, Math.max(low, pair[end]));
    if (pair[0] > pair[1]) pair[1 - end] = pair[end];
    const others = (brushes.get(dim.key) || []).slice(0, -1);
    const isAll = pair[0] <= low && pair[1] >= high && !others.length;
    setBrush(dim.key, isAll ? [] : [...others, pair]);
  });
  return slider;
}
