// What the page holds: the report, the columns of the evaluated designs, the files of the houses.

const report = JSON.parse($("report").textContent);
const houses = report.houses;
const houseOf = new Map(houses.map((house) => [house.id, house]));
const namedOf = new Map(report.named.map((one) => [one.id, one]));
const objectives = report.objectives;
const dims = [...objectives, ...report.variables];
const dimOf = new Map(dims.map((dim) => [dim.key, dim]));
const isBuild = report.run.schema === "houscaper.build/1";

function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

const ARRAYS = { u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, f32: Float32Array };

/** The evaluated designs: `count` rows, a typed array for each column, and which rows are of the front. */
const cloud = (() => {
  if (!report.cloud) return { count: 0, total: 0, columns: new Map(), isFront: new Uint8Array(0) };
  const columns = new Map();
  for (const { key, kind, data } of report.cloud.columns) columns.set(key, new ARRAYS[kind](bytesOf(data).buffer));
  const isFront = Uint8Array.from(columns.get("id"), (id) => (houseOf.has(id) ? 1 : 0));
  return { count: report.cloud.shown, total: report.cloud.total, columns, isFront };
})();

/** A house's value in a dimension, a word as its code, NaN where there is none. */
function valueOf(house, dim) {
  const cell = house.cells[dim.key];
  if (dim.words.length) {
    const code = dim.words.indexOf(String(cell));
    return code < 0 ? NaN : code;
  }
  return typeof cell === "number" ? cell : NaN;
}

/** Least and greatest of a dimension over the front and the feasible designs. */
const extents = new Map();
function extentOf(dim) {
  if (extents.has(dim.key)) return extents.get(dim.key);
  let low = Infinity, high = -Infinity;
  const add = (v) => {
    if (v < low) low = v;
    if (v > high) high = v;
  };
  houses.forEach((house) => add(valueOf(house, dim)));
  const column = cloud.columns.get(dim.key), feasible = cloud.columns.get("feasible");
  if (column) for (let i = 0; i < cloud.count; i++) if (feasible[i]) add(column[i]);
  if (low > high) [low, high] = [0, 1];
  if (dim.words.length) [low, high] = [0, Math.max(1, dim.words.length - 1)];
  extents.set(dim.key, [low, high]);
  return [low, high];
}

/** The group of a house by look, from 1; null without groups. */
const lookOf = (() => {
  const table = report.findings.looks, out = new Map();
  if (!table) return out;
  const at = (name) => table.header.indexOf(name);
  for (const row of table.rows) {
    out.set(row[at("id")], {
      group: row[at("cluster")], isMedoid: row[at("is_medoid")] === true, isKnee: row[at("is_knee")] === true,
      tradeOff: row[at("trade_off")], shared: row[at("shared")],
    });
  }
  return out;
})();

const hasFile = (house, name) => house.files.includes(name);

/** The text of a stored file, once the page has been read as far as it. */
async function stored(key) {
  if (document.readyState === "loading") {
    await new Promise((done) => document.addEventListener("DOMContentLoaded", done, { once: true }));
  }
  const element = $(key);
  if (!element) throw new Error(`${key} is not in this page`);
  return element.textContent;
}

/** The bytes of a file of a house. */
async function fileOf(house, name) {
  const packed = bytesOf(await stored(`${house.id}/${name}`));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const textOf = async (house, name) => new TextDecoder().decode(await fileOf(house, name));

/** Shows the picture of a house in an image as soon as it comes into view. */
const seen = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    seen.unobserve(target);
    stored(`${target.dataset.house}/thumb.png`).then((text) => (target.src = `data:image/png;base64,${text}`));
  }
}, { rootMargin: "400px" });

/** Shows the pictures that were never scrolled to while nothing else is to be done, for printing. */
function showRest() {
  const waiting = [...document.querySelectorAll("img[data-house]:not([src])")].slice(0, 8);
  waiting.forEach((image) => {
    seen.unobserve(image);
    image.src = `data:image/png;base64,${$(`${image.dataset.house}/thumb.png`).textContent}`;
  });
  if (waiting.length) requestIdleCallback(showRest);
}
window.addEventListener("load", () => setTimeout(() => requestIdleCallback(showRest), 1500));
window.addEventListener("beforeprint", showRest);

function picture(house, alt) {
  if (!house.has_picture) return h("span", { class: "nopicture", text: "no picture in the folder" });
  const image = h("img", { alt, width: 480, height: 360, decoding: "async", "data-house": house.id });
  seen.observe(image);
  return image;
}

const titleOf = (house) => (isBuild ? report.name : `House ${house.id}`);
