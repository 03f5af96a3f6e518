// Everything about the chosen house, behind tabs. Pages of other programs of ours are shown in sandboxed frames that run no scripts.

const TABS = [
  ["figures", "Figures", () => true, figuresPanel],
  ["drawings", "Drawings", (house) => house.files.some((f) => f.endsWith(".svg")), drawingsPanel],
  ["quote", "Quote", (house) => hasFile(house, "quote.html"), (house) => pagePanel(house, "quote.html", "Quote")],
  ["structure", "Structure", (house) => hasFile(house, "structure.html"), (house) => pagePanel(house, "structure.html", "Structure")],
  ["carbon", "Carbon", (house) => hasFile(house, "carbon.html"), (house) => pagePanel(house, "carbon.html", "Carbon, energy and heat loss")],
];
const dossier = { tab: "figures", token: 0 };

function startDossier() {
  on("chosen", showDossier);
  $("tabs").addEventListener("keydown", (e) => {
    const tabs = [...$("tabs").children], at = tabs.indexOf(document.activeElement);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: tabs.length - 1 }[e.key];
    if (at < 0 || to === undefined) return;
    e.preventDefault();
    const next = tabs[(to + tabs.length) % tabs.length];
    next.click();
    $(next.id).focus();
  });
}

function showDossier() {
  const house = state.chosen, tabs = TABS.filter(([, , has]) => has(house));
  if (!tabs.some(([id]) => id === dossier.tab)) dossier.tab = "figures";
  const name = namedOf.get(house.id);
  $("house-h").textContent = `${titleOf(house)}${name ? `, ${name.name}` : ""}: in full`;
  fill($("tabs"), tabs.map(([id, words]) => button(words, {
    id: `tab-${id}`, role: "tab", "aria-selected": id === dossier.tab, "aria-controls": "panel", tabindex: id === dossier.tab ? 0 : -1,
  }, () => {
    dossier.tab = id;
    showDossier();
    $(`tab-${id}`).focus();
  })));
  $("panel").setAttribute("aria-labelledby", `tab-${dossier.tab}`);
  showPanel(house, tabs.find(([id]) => id === dossier.tab)[3]);
}

async function showPanel(house, make) {
  const token = ++dossier.token;
  try {
    const content = await make(house);
    if (token === dossier.token) fill($("panel"), content);
  } catch (error) {
    if (token === dossier.token) fill($("panel"), h("p", { class: "note", text: `It could not be read: ${error.message}` }));
  }
}

function tableOf(head, rows, caption) {
  const cell = (tag) => (value) => h(tag, { class: typeof value === "object" && value?.n !== undefined ? "n" : null, text: value?.n ?? value });
  return h("div", { class: "wide" }, h("table", {}, caption ? h("caption", { text: caption }) : null,
    h("thead", {}, h("tr", {}, head.map((v) => { const th = cell("th")(v); th.scope = "col"; return th; }))),
    h("tbody", {}, rows.map((row) => h("tr", {}, row.map(cell("td")))))));
}

const n = (value, digits) => ({ n: digits === undefined ? plain(value) : fixed(value, digits) });

async function figuresPanel(house) {
  const figures = report.figures.map((dim) => [labelOf(dim), n(house.figures?.[dim.key] ?? NaN)]);
  const variables = report.variables.map((dim) => [labelOf(dim), { n: told(dim, valueOf(house, dim)).replace(unitOf(dim), "") }]);
  const parts = [];
  if (figures.length) parts.push(tableOf(["Figure", { n: "Value" }], figures, "Figures"));
  else parts.push(tableOf(["Objective", { n: "Value" }], objectives.map((dim) => [labelOf(dim), n(valueOf(house, dim))]), "Objectives"));
  if (variables.length) parts.push(tableOf(["Variable", { n: "Value" }], variables, "Design variables"));
  const structure = house.structure || {};
  if (structure.sections) {
    parts.push(tableOf(["Members", "Section", { n: "Length [m]" }, { n: "Mass [kg]" }],
      structure.sections.map((s) => [s.group.replaceAll("_", " ").replace("section", "members"), s.section, n(s.length_m, 1), n(s.mass_kg, 0)]), "Sections"));
  }
  if (house.bill.length) {
    const sum = (key) => house.bill.reduce((all, g) => all + key(g), 0);
    const row = (name, g) => [name, n(g.amount[1], 0), { n: `${fixed(g.amount[0], 0)} – ${fixed(g.amount[2], 0)}` }, n(g.mass_kg, 0), n(g.gwp_kgco2e, 0), n(g.biogenic_kgco2e, 0)];
    const whole = { amount: [0, 1, 2].map((k) => sum((g) => g.amount[k])), mass_kg: sum((g) => g.mass_kg), gwp_kgco2e: sum((g) => g.gwp_kgco2e), biogenic_kgco2e: sum((g) => g.biogenic_kgco2e) };
    const currency = house.quote?.currency || "EUR";
    parts.push(h("div", { class: "across" }, tableOf(["Bill by group", { n: `Amount [${currency}]` }, { n: "Low – high" }, { n: "Mass [kg]" }, { n: "Fossil A1-A3 [kgCO2e]" }, { n: "Stored [kgCO2e]" }],
      [...house.bill.map((g) => row(g.group, g)), row("whole, net of overhead and VAT", whole)], "Bill and carbon by group")));
  }
  const lines = [];
  if (structure.load_path) lines.push(`Load path: ${structure.load_path}.`);
  if (structure.reason) lines.push(`Structure ${structure.verdict}: ${structure.reason}.`);
  const glass = house.model?.windows_m2_east_north_west_south;
  if (glass) lines.push(`Glass to the east ${fixed(glass[0], 1)}, north ${fixed(glass[1], 1)}, west ${fixed(glass[2], 1)}, south ${fixed(glass[3], 1)} m².`);
  if (house.parts) lines.push(`${many(house.parts.count, "factory part")} of ${many(house.parts.types, "type")}; the heaviest weighs ${fixed(house.parts.heaviest_kg, 0)} kg.`);
  return [h("div", { class: "columns" }, parts), ...lines.map((text) => h("p", { text }))];
}

async function drawingsPanel(house) {
  const files = house.files.filter((f) => f.endsWith(".svg"));
  const made = await Promise.all(files.map(async (file) => {
    const words = file.replace(/\.svg$/, "").replace(/^plan-(\d+)$/, (_, storey) => `plan of storey ${Number(storey) + 1}`).replaceAll(/[-_]/g, " ");
    const url = URL.createObjectURL(new Blob([await fileOf(house, file)], { type: "image/svg+xml" }));
    const image = h("img", { src: url, alt: `${titleOf(house)}: ${words}` });
    image.addEventListener("load", () => URL.revokeObjectURL(url));
    return h("figure", {}, image, h("figcaption", { text: words }));
  }));
  return h("div", { class: "drawings" }, made);
}

async function pagePanel(house, file, title) {
  const frame = h("iframe", { title: `${title} of ${titleOf(house)}`, sandbox: "allow-same-origin", class: "page" });
  frame.srcdoc = await textOf(house, file);
  const fit = () => {
    const root = frame.contentDocument?.documentElement;
    if (root) frame.style.height = `${Math.max(300, root.scrollHeight + 24)}px`;
  };
  frame.addEventListener("load", () => {
    fit();
    if (frame.contentDocument) new ResizeObserver(fit).observe(frame.contentDocument.body);
  });
  return frame;
}
