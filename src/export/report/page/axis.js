// Scales and axes of the plots.

/** Maps a dimension's values to pixels; `pad` widens its range by that share. */
function scaleOf(dim, from, to, pad) {
  let [low, high] = extentOf(dim);
  if (high === low) [low, high] = [low - 0.5, high + 0.5];
  const more = (high - low) * pad;
  [low, high] = [low - more, high + more];
  const k = (to - from) / (high - low);
  const at = (value) => from + (value - low) * k;
  at.invert = (pixel) => low + (pixel - from) / k;
  at.low = low;
  at.high = high;
  return at;
}

/** Values and texts of an axis's ticks. */
function marksOf(dim, low, high, count) {
  if (dim.words.length) {
    const step = Math.max(1, Math.ceil(dim.words.length / 14));
    return dim.words.map((text, at) => [at, text]).filter(([at]) => at % step === 0);
  }
  const [values, step] = ticks(low, high, count);
  if (!isWhole(dim)) return values.map((v) => [v, short(v, step)]);
  return values.filter(Number.isInteger).map((v) => [v, fixed(v, 0)]);
}

/** Whether a dimension counts things. */
const isWhole = (dim) => !dim.words.length && dim.maximise === null && houses.every((house) => {
  const value = valueOf(house, dim);
  return Number.isNaN(value) || Number.isInteger(value);
});

const FONT = '"Inter","Helvetica Neue","Segoe UI",Helvetica,Arial,sans-serif';
const font = (size, weight = 400) => `${weight} ${size}px ${FONT}`;
const labelOf = (dim) => (dim.unit ? `${dim.title} [${dim.unit}]` : dim.title);

/** A small arrow towards better, its shaft from (x, y) along (dx, dy). */
function arrow(c, x, y, dx, dy, length) {
  const [tx, ty] = [x + dx * length, y + dy * length];
  c.beginPath();
  c.moveTo(x, y);
  c.lineTo(tx - dx * 4, ty - dy * 4);
  c.stroke();
  c.beginPath();
  c.moveTo(tx, ty);
  c.lineTo(tx - dx * 7 - dy * 3, ty - dy * 7 - dx * 3);
  c.lineTo(tx - dx * 7 + dy * 3, ty - dy * 7 + dx * 3);
  c.fill();
}

/** Text cut to a width, with an ellipsis. */
function cut(c, text, width) {
  if (c.measureText(text).width <= width) return text;
  let end = text.length;
  while (end > 1 && c.measureText(`${text.slice(0, end)}…`).width > width) end -= 1;
  return `${text.slice(0, end).trimEnd()}…`;
}
