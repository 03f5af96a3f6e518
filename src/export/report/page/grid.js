// Pictures of the front's houses, those that pass the brushes, in any order.

const grid = { sort: null, down: false, cards: new Map() };

function startGrid() {
  const sorts = [...dims.map((dim) => [dim.key, labelOf(dim)]), ...(lookOf.size ? [["group", "group by look"], ["tradeOff", "sharpness as a knee"]] : []), ["id", "number"]];
  grid.sort = objectives[0]?.key ?? "id";
  const turn = button("", { class: "quiet", id: "turn" }, () => {
    grid.down = !grid.down;
    order();
  });
  fill($("grid-tools"), h("h3", { text: "The front" }), select("Sort by", sorts, grid.sort, (v) => ((grid.sort = v), order())), turn,
    h("span", { class: "count", id: "grid-count" }));
  houses.forEach((house) => grid.cards.set(house, card(house)));
  $("grid").addEventListener("keydown", gridKeys);
  on("brush", order);
  on("chosen shortlist hover", once(markCards));
  order();
}

function card(house) {
  const name = namedOf.get(house.id);
  const main = button("", { class: "card", tabindex: -1, "aria-label": summaryOf(house), "aria-keyshortcuts": "S" }, () => choose(house, "grid"));
  main.append(picture(house, ""), h("span", { class: "name" }, h("strong", { text: titleOf(house) }), name ? h("em", { text: name.name }) : null),
    ...objectives.slice(0, 4).map((dim) => h("span", { class: "value", text: told(dim, valueOf(house, dim)) })));
  main.addEventListener("mouseenter", () => point(house));
  main.addEventListener("mouseleave", () => point(null));
  const star = button("", { class: "star", tabindex: -1 }, () => shortlist(house));
  const item = h("li", {}, main, star);
  item.main = main;
  item.star = star;
  return item;
}

function gridValue(house) {
  if (grid.sort === "id") return house.id;
  if (grid.sort === "group") return lookOf.get(house.id)?.group ?? 0;
  if (grid.sort === "tradeOff") return lookOf.get(house.id)?.tradeOff ?? 0;
  return valueOf(house, dimOf.get(grid.sort));
}

function order() {
  const way = grid.down ? -1 : 1;
  grid.shown = houses.filter((house) => passing.has(house)).sort((a, b) => way * (gridValue(a) - gridValue(b)) || a.id - b.id);
  fill($("grid"), grid.shown.map((house) => grid.cards.get(house)));
  $("turn").textContent = grid.down ? "↓ greatest first" : "↑ least first";
  $("grid-count").textContent = grid.shown.length === houses.length ? many(houses.length, "house") : `${grid.shown.length} of ${many(houses.length, "house")}`;
  markCards();
}

function markCards() {
  const reachable = passing.has(state.chosen) ? state.chosen : grid.shown[0];
  for (const [house, item] of grid.cards) {
    const isChosen = house === state.chosen, at = state.shortlist.indexOf(house);
    item.classList.toggle("chosen", isChosen);
    item.classList.toggle("pointed", house === state.hover);
    item.main.setAttribute("aria-pressed", isChosen);
    item.main.tabIndex = house === reachable ? 0 : -1;
    item.star.textContent = at < 0 ? "+" : LETTERS[at];
    item.star.classList.toggle("on", at >= 0);
    item.star.setAttribute("aria-pressed", at >= 0);
    item.star.setAttribute("aria-label", `${at < 0 ? "Add to" : "Take off"} the shortlist: ${titleOf(house)}`);
  }
}

function gridKeys(e) {
  const at = grid.shown.findIndex((house) => grid.cards.get(house).contains(document.activeElement));
  if (at < 0) return;
  const tops = grid.shown.map((house) => grid.cards.get(house).offsetTop);
  const columns = Math.max(1, tops.findIndex((top) => top > tops[0]) < 0 ? tops.length : tops.findIndex((top) => top > tops[0]));
  const moves = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns, ArrowUp: -columns, Home: -at, End: grid.shown.length - 1 - at };
  if (e.key in moves) {
    const next = grid.shown[Math.min(grid.shown.length - 1, Math.max(0, at + moves[e.key]))];
    grid.cards.get(next).main.tabIndex = 0;
    grid.cards.get(next).main.focus();
    point(next);
  } else if (e.key.toLowerCase() === "s") shortlist(grid.shown[at]);
  else return;
  e.preventDefault();
}
