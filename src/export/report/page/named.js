// The named houses with their reasons.

function startNamed() {
  if (!report.named.length) return;
  $("named").hidden = false;
  const cards = report.named.filter((one) => houseOf.has(one.id)).map((one) => {
    const house = houseOf.get(one.id);
    const press = button("", { class: "card", "aria-label": `${one.name}: ${summaryOf(house)}` }, () => {
      choose(house, "named");
      if (innerWidth < 900) $("chosen").scrollIntoView({ block: "start" });
    });
    press.append(picture(house, ""), h("span", { class: "name" }, h("strong", { text: one.name })),
      h("span", { class: "value", text: objectives.slice(0, 3).map((dim) => told(dim, valueOf(house, dim))).join(" · ") }));
    const item = h("li", {}, press, h("p", { class: "why", text: wordsOf(one.reason) }));
    item.house = house;
    item.press = press;
    return item;
  });
  fill($("named-list"), cards);
  on("chosen", () => cards.forEach((item) => {
    item.classList.toggle("chosen", item.house === state.chosen);
    item.press.setAttribute("aria-pressed", item.house === state.chosen);
  }));
}

/** A reason with its numbers grouped, and objectives called by their titles. */
function wordsOf(reason) {
  let text = reason.replace(/\d{4,}(?=\D|$)/g, (digits) => fixed(Number(digits), 0));
  for (const dim of objectives) text = text.replaceAll(`${dim.key} `, `${dim.title} `);
  return text.charAt(0).toUpperCase() + text.slice(1);
}
