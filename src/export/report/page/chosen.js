// The chosen house in short, and the tray of the shortlist.

function startChosen() {
  on("chosen shortlist", showChosen);
  on("shortlist full", showTray);
}

function showChosen() {
  const house = state.chosen, name = namedOf.get(house.id), look = lookOf.get(house.id);
  $("chosen-h").textContent = name ? `${titleOf(house)} · ${name.name}` : titleOf(house);
  const reasons = [name ? wordsOf(name.reason) : "", !name && look?.isKnee ? "A knee of the front: every step to a neighbour loses more than it gains." : "",
    look ? `Group ${look.group} by look${look.isMedoid ? ", the one in its middle" : ""}.` : ""];
  $("chosen-reason").textContent = reasons.filter(Boolean).map((text) => (/[.!?]$/.test(text) ? text : `${text}.`)).join(" ");
  const rows = objectives.map((dim) => [dim.title, told(dim, valueOf(house, dim)), rankOf(house, dim)]);
  if (house.structure?.verdict) rows.push(["Structure", house.structure.verdict, house.structure.governing ? `utilisation ${fixed(house.structure.governing.utilisation, 2)}` : ""]);
  fill($("chosen-figures"), rows.map(([title, value, note]) => h("div", {}, h("dt", { text: title }), h("dd", {}, h("strong", { text: value }), note ? h("small", { text: note }) : null))));
  const at = state.shortlist.indexOf(house);
  fill($("chosen-actions"),
    isBuild ? null : button(at < 0 ? "Add to shortlist" : `On the shortlist as ${LETTERS[at]}: take off`, { class: "main" }, () => shortlist(house)),
    button("All about it", { class: "quiet" }, () => goTo("house")));
}

/** The place of a house in an objective. */
function rankOf(house, dim) {
  if (houses.length < 3) return "";
  const value = valueOf(house, dim);
  const better = houses.filter((one) => (dim.maximise ? valueOf(one, dim) > value : valueOf(one, dim) < value)).length;
  return better === 0 ? `best of ${houses.length}` : `place ${better + 1} of ${houses.length}`;
}

function goTo(id) {
  const section = $(id);
  section.scrollIntoView({ block: "start" });
  section.setAttribute("tabindex", "-1");
  section.focus({ preventScroll: true });
}

function showTray() {
  const tray = $("tray");
  tray.hidden = !state.shortlist.length;
  document.body.classList.toggle("traying", !tray.hidden);
  const chip = (house, at) => {
    const show = button("", { class: "chip", "aria-label": `Choose ${titleOf(house)}` }, () => choose(house, "tray"));
    show.append(picture(house, ""), h("span", { text: `${LETTERS[at]} · ${house.id}` }));
    return h("li", {}, show, button("×", { class: "off", "aria-label": `Take ${titleOf(house)} off the shortlist` }, () => shortlist(house)));
  };
  fill(tray, h("ul", {}, state.shortlist.map(chip)),
    state.shortlist.length === LETTERS.length ? h("span", { class: "count", text: "four at most" }) : null,
    button(state.shortlist.length > 1 ? `Compare ${state.shortlist.length}` : "Add another to compare", { class: "main", disabled: state.shortlist.length < 2 }, () => goTo("compare")));
}
