// What the search found beside its houses: groups by look, what binds, what one change does.

function startFindings() {
  showLooks();
  showWhyNot();
  if (report.findings.changes) {
    $("changes").hidden = false;
    const ids = [...new Set(records(report.findings.changes).map((r) => r.house))];
    showChanges(ids[0], ids);
  }
}

function records(table) {
  return table.rows.map((row) => Object.fromEntries(table.header.map((name, at) => [name, row[at]])));
}

function showLooks() {
  if (!lookOf.size) return;
  $("looks").hidden = false;
  const groups = new Map();
  for (const house of houses) {
    const look = lookOf.get(house.id);
    if (look) groups.set(look.group, [...(groups.get(look.group) || []), house]);
  }
  const one = ([number, members]) => {
    const middle = members.find((house) => lookOf.get(house.id).isMedoid) || members[0];
    const shown = [middle, ...members.filter((house) => house !== middle)].slice(0, 8);
    return h("article", {}, h("h3", {}, h("i", { class: "mark dot", style: `background:${SERIES[(number - 1) % SERIES.length]}` }), `Group ${number}: ${many(members.length, "house")}`),
      h("p", { text: `${lookOf.get(middle.id).shared ? `${lookOf.get(middle.id).shared}. ` : ""}In the middle: ${middle.id}.` }),
      h("ul", { class: "strip" }, shown.map((house) => {
        const press = button("", { class: "card", "aria-label": summaryOf(house) }, () => {
          choose(house, "looks");
          goTo("explore");
        });
        press.append(picture(house, ""), h("span", { class: "name" }, h("strong", { text: String(house.id) })));
        return h("li", {}, press);
      })));
  };
  fill($("looks-body"), [...groups].sort((a, b) => a[0] - b[0]).map(one));
}

const constraintWords = (r) => `${String(r.constraint).replace(/^(programme|constraints|structure)\./, "").replace(/\[\d\]/, "").replaceAll("_", " ")}`;

function showWhyNot() {
  const table = report.findings.why_not;
  if (!table) return;
  $("whynot").hidden = false;
  const rows = records(table);
  const active = rows.filter((r) => r.front_within_2_percent > 0 || r.near_broken > 0 || r.sampled_broken > 0);
  const gain = (r) => (r.relaxed_10_percent_gains_percent === null ? { n: "–" } : n(r.relaxed_10_percent_gains_percent, 2));
  fill($("whynot-body"),
    report.findings.why_not_words.length ? h("ul", { class: "prose" }, report.findings.why_not_words.map((text) => h("li", { text: wordsOf(text) }))) : null,
    tableOf(["Constraint", "Asked by", "Limit", { n: "At its limit in the front" }, { n: "Kept near houses out" }, { n: "Alone" }, { n: "Broken in the sample" }, { n: "10 % looser adds [% hypervolume]" }],
      active.map((r) => [constraintWords(r), r.asked_by, `${r.side} ${plain(r.limit)}`, { n: `${r.front_within_2_percent} of ${r.front}` }, { n: `${r.near_broken} of ${r.near}` }, n(r.near_broken_alone), { n: `${r.sampled_broken} of ${r.sampled}` }, gain(r)])),
    h("p", { class: "help", text: "Near houses would stand in the front but for a constraint that they miss by at most 10 %; the sample is taken evenly from all infeasible designs." }));
}

/** How far each kind of change moves each objective, as bars around the house. */
function showChanges(id, ids) {
  const rows = records(report.findings.changes).filter((r) => r.house === id);
  const kinds = [...new Set(rows.map((r) => r.change))];
  const goals = objectives.filter((dim) => rows.some((r) => r.objective === dim.key));
  const most = new Map(goals.map((dim) => [dim.key, Math.max(1, ...rows.filter((r) => r.objective === dim.key).flatMap((r) => [Math.abs(r.least_percent ?? 0), Math.abs(r.greatest_percent ?? 0)]))]));
  const bar = (r, dim) => {
    if (!r || r.least_percent === null) return h("td", { class: "n", text: "none is feasible" });
    const k = 50 / most.get(dim.key), [low, high] = [Math.min(0, r.least_percent), Math.max(0, r.greatest_percent)];
    const span = h("i", { class: "span", style: `left:${50 + low * k}%;width:${Math.max(0.6, (high - low) * k)}%` });
    const words = r.least_percent === r.greatest_percent ? `${signed(r.least_percent, 1)} %` : `${signed(r.least_percent, 1)} to ${signed(r.greatest_percent, 1)} %`;
    const by = [r.least_by, r.greatest_by].filter(Boolean).join(" … ");
    return h("td", { title: by || null }, h("span", { class: "bar" }, span), h("small", { text: words }));
  };
  const find = (kind, dim) => rows.find((r) => r.change === kind && r.objective === dim.key);
  const body = kinds.map((kind) => {
    const first = rows.find((r) => r.change === kind);
    return h("tr", {}, h("th", { scope: "row" }, kind, h("small", { text: `${first.feasible} of ${first.neighbours} keep every constraint` })), goals.map((dim) => bar(find(kind, dim), dim)));
  });
  const name = (house) => `${house}${namedOf.has(house) ? ` · ${namedOf.get(house).name}` : ""}`;
  fill($("changes-body"), h("p", { class: "tools" }, select("House", ids.map((one) => [one, name(one)]), id, (v) => showChanges(Number(v), ids))),
    h("div", { class: "wide" }, h("table", { class: "changes" }, h("caption", { text: "What single changes do to each objective, those that keep every constraint; longest bar of a column: its largest change" }),
      h("thead", {}, h("tr", {}, h("th", { scope: "col", text: "Change" }), goals.map((dim) => h("th", { scope: "col", text: dim.title })))), h("tbody", {}, body))));
}
