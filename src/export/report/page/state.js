// What is chosen, pointed at and shortlisted; every part of the page listens.

const state = { chosen: null, hover: null, shortlist: [], colour: null, axes: [] };
const listeners = {};

function on(topics, listener) {
  topics.split(" ").forEach((topic) => (listeners[topic] ||= []).push(listener));
}

function emit(topic) {
  (listeners[topic] || []).forEach((listener) => listener());
}

function choose(house, from) {
  if (!house) return;
  state.chosen = house;
  emit("chosen");
  if (from) announce(`${summaryOf(house)}: chosen`);
}

function point(house) {
  if (state.hover === house) return;
  state.hover = house;
  emit("hover");
}

const isShort = (house) => state.shortlist.includes(house);

/** Puts a house on the shortlist, at most four, or takes it off. */
function shortlist(house) {
  if (isShort(house)) state.shortlist = state.shortlist.filter((one) => one !== house);
  else if (state.shortlist.length === LETTERS.length) {
    announce("The shortlist holds four houses: take one off first");
    emit("full");
    return;
  } else state.shortlist = [...state.shortlist, house];
  announce(`${titleOf(house)} is ${isShort(house) ? "on" : "off"} the shortlist, which has ${state.shortlist.length}`);
  emit("shortlist");
}

/** A house in a sentence. */
function summaryOf(house) {
  const name = namedOf.get(house.id);
  const values = objectives.map((dim) => `${dim.title} ${told(dim, valueOf(house, dim))}`);
  return `${titleOf(house)}${name ? `, ${name.name}` : ""}, ${values.join(", ")}`;
}

/** Colour of a house of the front in the plots. */
function colourOf(house) {
  if (state.colour === "group") return SERIES[((lookOf.get(house.id)?.group ?? 1) - 1) % SERIES.length];
  const dim = dimOf.get(state.colour);
  if (!dim) return viridis(0.25);
  const values = houses.map((one) => valueOf(one, dim));
  const [low, high] = (colourOf.range ||= new Map()).get(dim.key)
    ?? colourOf.range.set(dim.key, [Math.min(...values.filter(Number.isFinite)), Math.max(...values.filter(Number.isFinite))]).get(dim.key);
  return viridis(high > low ? (valueOf(house, dim) - low) / (high - low) : 0.5);
}
