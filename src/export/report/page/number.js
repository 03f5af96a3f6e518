// Numbers as our other pages print them: thin spaces between thousands, a point before decimals, a true minus.

function fixed(value, digits) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const text = Math.abs(value).toFixed(digits);
  const [whole, part] = text.split(".");
  const grouped = whole.replace(/\B(?=(\d{3})+$)/g, "\u202f");
  const sign = value < 0 && /[1-9]/.test(text) ? "\u2212" : "";
  return sign + grouped + (part ? `.${part}` : "");
}

function digitsOf(value) {
  const size = Math.abs(value);
  if (Number.isInteger(value) || size >= 1000) return 0;
  return size >= 10 ? 1 : 2;
}

/** A number with the digits its size asks for. */
function plain(value) {
  return typeof value === "number" ? fixed(value, digitsOf(value)) : "–";
}

/** A difference, always with its sign. */
function signed(value, digits = digitsOf(value)) {
  if (!Number.isFinite(value)) return "–";
  const text = fixed(Math.abs(value), digits);
  if (!/[1-9]/.test(text)) return "0";
  return (value < 0 ? "\u2212" : "+") + text;
}

/** Short for ticks: 120k. */
function short(value, step) {
  const size = Math.max(Math.abs(value), Math.abs(step));
  const [unit, letter] = size >= 1e7 ? [1e6, "M"] : size >= 1e4 ? [1e3, "k"] : [1, ""];
  const part = step / unit;
  let digits = part >= 0.999 ? 0 : Math.min(6, Math.ceil(-Math.log10(part)));
  if (Math.abs((part * 10 ** digits) % 1) > 1e-6 && Math.abs((part * 10 ** digits) % 1) < 1 - 1e-6) digits += 1;
  const text = fixed(value / unit, digits);
  return /[1-9]/.test(text) ? text + letter : "0";
}

/** Round ticks inside a range, about `count` of them, and their step. */
function ticks(low, high, count) {
  const raw = (high - low) / Math.max(1, count);
  if (!(raw > 0) || !Number.isFinite(raw)) return [[low], 1];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((m) => m * power).find((s) => s >= raw * 0.999);
  const out = [];
  for (let i = Math.ceil(low / step - 1e-9); i <= Math.floor(high / step + 1e-9); i++) out.push(i * step);
  return [out, step];
}

// Beside a value the unit alone: life-cycle stages stand on axes and in tables.
const unitOf = (dim) => (dim.unit ? `\u00a0${dim.unit.split(" ")[0]}` : "");

/** A value of a dimension in words, with its unit. */
function told(dim, value) {
  if (dim.words.length) return dim.words[value] ?? "–";
  return Number.isFinite(value) ? plain(value) + unitOf(dim) : "–";
}

const many = (count, one, more = `${one}s`) => `${fixed(count, 0)} ${count === 1 ? one : more}`;
