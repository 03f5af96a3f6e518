// What the run assumes, in full, with a search; and the run itself.

function startTexts() {
  const groups = [runTexts(), briefTexts(), { title: "Not in this page", items: report.missing.map((text) => ({ text, source: "", houses: 0 })) }, ...report.texts].filter((g) => g.items.length);
  const field = h("input", { type: "search", id: "search", placeholder: "wind, OSB, VAT, sha256 …", autocomplete: "off" });
  const count = h("span", { class: "count", role: "status" });
  const list = h("div", { class: "texts" });
  const show = () => {
    const words = field.value.trim().toLowerCase().split(/\s+/).filter(Boolean);
    let found = 0;
    const made = groups.map((group) => {
      const items = group.items.filter((item) => words.every((w) => `${group.title} ${item.text} ${item.source}`.toLowerCase().includes(w)));
      found += items.length;
      if (!items.length) return null;
      const part = h("details", { open: words.length > 0 || group.isOpen }, h("summary", {}, h("strong", { text: group.title }), h("span", { class: "count", text: String(items.length) })),
        h("ul", {}, items.map((item) => h("li", {}, marked(item.text, words), item.source ? h("small", {}, marked(item.source, words)) : null,
          item.houses && item.houses < packedHouses ? h("small", { text: `in ${item.houses} of ${packedHouses} houses` }) : null))));
      if (!words.length) part.addEventListener("toggle", () => (group.isOpen = part.open));
      return part;
    });
    count.textContent = words.length ? `${many(found, "text")} found` : `${many(found, "text")}`;
    fill(list, made);
  };
  const packedHouses = Math.max(1, ...report.texts.flatMap((g) => g.items.map((i) => i.houses)));
  field.addEventListener("input", show);
  fill($("texts-body"), h("p", { class: "tools" }, h("label", { class: "field grow" }, h("span", { text: "Search" }), field), count), list);
  show();
}

/** Text with the words that were searched for marked. */
function marked(text, words) {
  const span = h("span");
  let rest = text;
  while (rest) {
    const low = rest.toLowerCase();
    const hits = words.map((w) => [low.indexOf(w), w.length]).filter(([at]) => at >= 0).sort((a, b) => a[0] - b[0] || b[1] - a[1]);
    if (!hits.length) break;
    const [at, size] = hits[0];
    span.append(rest.slice(0, at), h("mark", { text: rest.slice(at, at + size) }));
    rest = rest.slice(at + size);
  }
  span.append(rest);
  return span;
}

const item = (text) => ({ text, source: "", houses: 0 });

function flatTexts(value, path = "") {
  if (value === null || value === undefined) return [];
  if (Array.isArray(value) && value.every((v) => typeof v !== "object" || v === null)) return [item(`${path}: ${value.join(", ")}`)];
  if (typeof value === "object") return Object.entries(value).flatMap(([key, v]) => flatTexts(v, path ? `${path} · ${key.replaceAll("_", " ")}` : key.replaceAll("_", " ")));
  return [item(`${path}: ${value}`)];
}

function runTexts() {
  const { brief, ...run } = report.run;
  return { title: "The run: version, seed, counts, hashes of books and tilesets", isOpen: true, items: flatTexts(run) };
}

const briefTexts = () => ({ title: "The brief", items: flatTexts(report.run.brief) });
