// Up to four houses side by side: pictures, every figure with its difference to the first, what they are made of.

const comparison = { token: 0, base: 0 };

function startCompare() {
  on("shortlist", showCompare);
  showCompare();
}

async function showCompare() {
  const token = ++comparison.token, list = state.shortlist;
  const section = $("compare");
  section.hidden = isBuild || houses.length < 2;
  section.classList.toggle("empty", !list.length);
  if (!list.length) return fill($("compare-body"), h("p", { class: "help", text: "Put up to four houses on the shortlist, by the plus on their pictures or S on the keyboard, and they stand here side by side." }));
  comparison.base = Math.min(comparison.base, list.length - 1);
  const bills = await Promise.all(list.map(billOf));
  if (token !== comparison.token) return;
  const base = comparison.base;
  const head = list.map((house, at) => {
    const name = namedOf.get(house.id);
    const press = button("", { class: "card", "aria-label": `Choose ${titleOf(house)}` }, () => choose(house, "compare"));
    press.append(picture(house, `Picture of ${titleOf(house)}`), h("span", { class: "name" }, h("b", { class: "letter", text: LETTERS[at] }), h("strong", { text: titleOf(house) }), name ? h("em", { text: name.name }) : null));
    return h("th", { scope: "col" }, press, at === base ? h("span", { class: "count", text: "compared with" }) : button("compare with this", { class: "quiet small" }, () => ((comparison.base = at), showCompare())),
      button("take off", { class: "quiet small", "aria-label": `Take ${titleOf(house)} off the shortlist` }, () => shortlist(house)));
  });
  const sections = comparedRows(list, bills);
  const body = sections.flatMap(([title, rows]) => rows.length ? [h("tr", { class: "group" }, h("th", { scope: "colgroup", colspan: list.length + 1, text: title })), ...rows.map((row) => compareRow(row, base))] : []);
  fill($("compare-body"),
    h("p", { class: "tools" }, button("Save as CSV", { class: "quiet" }, () => saveTable(list, sections)), button("Clear the shortlist", { class: "quiet" }, () => ((state.shortlist = []), emit("shortlist")))),
    h("div", { class: "wide" }, h("table", { class: "compare" }, h("thead", {}, h("tr", {}, h("td", {}), head)), h("tbody", {}, body))));
}

/** A row of values: numbers get their difference to the one compared with, and the best one a mark where more or less is better. */
function compareRow({ title, values, digits, maximise }, base) {
  const numbers = values.map((v) => (typeof v === "number" ? v : NaN));
  const known = numbers.filter(Number.isFinite);
  const best = maximise === undefined || new Set(known).size < 2 ? NaN : maximise ? Math.max(...known) : Math.min(...known);
  const cells = values.map((value, at) => {
    if (typeof value !== "number") return h("td", { text: value ?? "–" });
    const cell = h("td", { class: "n" }, h("span", { class: value === best ? "best" : null, text: fixed(value, digits ?? digitsOf(value)) }));
    const by = value - numbers[base];
    if (at !== base && Number.isFinite(by)) {
      const percent = numbers[base] ? ` (${signed((100 * by) / Math.abs(numbers[base]), 1)} %)` : "";
      cell.append(h("small", { text: by === 0 ? "the same" : `${signed(by, digits ?? digitsOf(value))}${percent}` }));
    }
    return cell;
  });
  return h("tr", {}, h("th", { scope: "row", text: title }), cells);
}

function comparedRows(list, bills) {
  const of = (take) => list.map((house) => take(house) ?? NaN);
  const asked = new Set(objectives.map((dim) => dim.key));
  const known = (row) => row.values.some((v) => typeof v === "string" || Number.isFinite(v));
  const down = ["price_eur", "price_per_m2_eur", "gwp_kgco2e", "energy_mj", "heat_loss_w_per_k", "utilisation", "sway_ratio", "deflection_ratio", "envelope_ratio"];
  const figure = (dim) => ({ title: labelOf(dim), values: of((house) => house.figures?.[dim.key]), maximise: down.includes(dim.key) ? false : undefined });
  const goal = (dim) => ({ title: labelOf(dim), values: list.map((house) => valueOf(house, dim)), maximise: dim.maximise });
  const variable = (dim) => ({ title: labelOf(dim), values: list.map((house) => (dim.words.length ? told(dim, valueOf(house, dim)) : valueOf(house, dim))) });
  const structure = (title, take, more = {}) => ({ title, values: of((house) => take(house.structure || {})), ...more });
  const money = list[0].quote?.currency || "EUR";
  const groups = [...new Set(list.flatMap((house) => house.bill.map((g) => g.group)))];
  const inGroup = (name, take) => of((house) => { const g = house.bill.find((one) => one.group === name); return g ? take(g) : NaN; });
  const items = [...new Map(bills.flat().map((l) => [l.item + l.unit, l])).values()];
  const amount = (bill, line) => bill.filter((l) => l.item === line.item && l.unit === line.unit).reduce((sum, l) => sum + l.quantity, 0);
  return [
    ["Objectives", objectives.map(goal)],
    ["Figures", report.figures.filter((dim) => !asked.has(dim.key)).map(figure)],
    ["Quote", [
      { title: `With design and VAT [${money}]`, values: of((house) => house.quote?.total?.[1]), digits: 0, maximise: false },
      { title: `Complete house, net of VAT [${money}]`, values: of((house) => house.quote?.complete_house?.[1]), digits: 0, maximise: false },
      ...groups.map((name) => ({ title: `${name} [${money}]`, values: inGroup(name, (g) => g.amount[1]), digits: 0 })),
    ]],
    ["Carbon by group [kgCO2e, fossil A1-A3]", groups.map((name) => ({ title: name, values: inGroup(name, (g) => g.gwp_kgco2e), digits: 0 }))],
    ["Structure", [
      structure("Verdict", (s) => s.verdict ?? "–"), structure("Nearest to its limit", (s) => s.governing?.what ?? "–"), structure("Racking over its capacity", (s) => s.racking_ratio, { digits: 2 }),
      structure("Floor vibration over its limit", (s) => s.vibration?.ratio, { digits: 2 }), structure("Thesis rule", (s) => s.thesis?.passes ?? "–"), structure("Worst anchor [kN]", (s) => s.uplift_kn?.[1], { digits: 1 }),
    ]],
    ["Design", [...report.variables.map(variable), { title: "Factory parts", values: of((house) => house.parts?.count) }, { title: "Types of parts", values: of((house) => house.parts?.types) }]],
    ["Materials, by quantity of the bill", items.map((line) => ({ title: `${line.item.replaceAll("_", " ")} [${line.unit}]`, values: bills.map((bill) => (bill.length ? amount(bill, line) : NaN)) }))],
  ].map(([title, rows]) => [title, rows.filter(known)]);
}

/** The lines of a house's bill. */
async function billOf(house) {
  if (!hasFile(house, "bom.csv")) return [];
  const [head, ...rows] = csvRows(await textOf(house, "bom.csv"));
  const at = (name) => head.indexOf(name);
  return rows.map((row) => ({ item: row[at("item")], unit: row[at("unit")], quantity: Number(row[at("quantity")]) }));
}

/** RFC 4180. */
function csvRows(text) {
  const rows = [[]];
  let cell = "", quoted = false;
  for (let i = 0; i < text.length; i++) {
    const letter = text[i];
    if (quoted && letter === '"' && text[i + 1] === '"') cell += text[++i];
    else if (letter === '"') quoted = !quoted;
    else if (quoted || (letter !== "," && letter !== "\n")) cell += letter;
    else {
      rows[rows.length - 1].push(cell);
      cell = "";
      if (letter === "\n" && i + 1 < text.length) rows.push([]);
    }
  }
  if (cell) rows[rows.length - 1].push(cell);
  return rows;
}

function saveTable(list, sections) {
  // A cell that begins like a formula is kept from being one.
  const quoted = (v) => `"${String(Number.isNaN(v) ? "" : v ?? "").replace(/^([=+@])/, "'$1").replaceAll('"', '""')}"`;
  const lines = [["group", "figure", ...list.map((house) => titleOf(house))], ...sections.flatMap(([title, rows]) => rows.map((row) => [title, row.title, ...row.values]))];
  const url = URL.createObjectURL(new Blob([lines.map((l) => l.map(quoted).join(",")).join("\n") + "\n"], { type: "text/csv" }));
  h("a", { href: url, download: `${report.name}-compared.csv` }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}
