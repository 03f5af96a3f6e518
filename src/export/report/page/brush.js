// Brushes: for each dimension a list of intervals; a design passes when it lies in one of each.

const brushes = new Map();
let passing = new Set(houses);
let passingDesigns = cloud.count;

const inside = (value, intervals) => intervals.some(([low, high]) => value >= low && value <= high);

function setBrush(key, intervals) {
  const kept = intervals.filter(([low, high]) => high >= low);
  if (kept.length) brushes.set(key, kept);
  else brushes.delete(key);
  sift();
}

function clearBrushes() {
  brushes.clear();
  sift();
  announce("All brushes cleared");
}

/** Which row of the designs passes: 1 or 0. */
const passMask = new Uint8Array(cloud.count).fill(1);

function sift() {
  const started = performance.now();
  const asked = [...brushes];
  passing = new Set(houses.filter((house) => asked.every(([key, list]) => inside(valueOf(house, dimOf.get(key)), list))));
  passMask.fill(1);
  for (const [key, list] of asked) {
    const column = cloud.columns.get(key);
    if (column) for (let i = 0; i < cloud.count; i++) if (passMask[i] && !inside(column[i], list)) passMask[i] = 0;
  }
  passingDesigns = passMask.reduce((sum, one) => sum + one, 0);
  emit("brush");
  announceCount();
  // Listeners draw in the next frame, before this: the time until then is what a reader waits for.
  requestAnimationFrame(() => {
    sift.milliseconds = performance.now() - started;
  });
}

let countTimer = 0;
function announceCount() {
  clearTimeout(countTimer);
  countTimer = setTimeout(() => announce(countWords()), 400);
}

function countWords() {
  const front = `${fixed(passing.size, 0)} of ${many(houses.length, "house")} of the front`;
  return cloud.count ? `${front}, ${fixed(passingDesigns, 0)} of ${fixed(cloud.count, 0)} evaluated designs` : front;
}
