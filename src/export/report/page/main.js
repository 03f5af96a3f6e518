// Starts the page: what shows first comes first.

function startTop() {
  const run = report.run, counts = run.counts || {};
  $("title").textContent = report.name;
  document.title = isBuild ? `${report.name}: a house` : `${report.name}: ${many(houses.length, "house")}`;
  const facts = isBuild ? ["one house, built as given", run.violations ? `${many(run.violations, "rule")} broken` : "keeps every rule"] : [
    counts.evaluations ? `${many(counts.evaluations, "house")} evaluated` : "", counts.feasible ? `${fixed(counts.feasible, 0)} feasible` : "",
    `${fixed(houses.length, 0)} on the front`, run.status === "complete" ? "" : `the run is ${run.status}`, `seed ${run.seed}`, `houscaper ${run.version} (${run.commit})`,
    cloud.count < cloud.total ? `plots show ${fixed(cloud.count, 0)} of ${fixed(cloud.total, 0)} designs, taken evenly, and all of the front` : "",
  ];
  $("lead").textContent = `${facts.filter(Boolean).join(" · ")}. Prices and carbon are indicative, not an offer.`;
  const links = [["named", "Named"], ["explore", "Explore"], ["house", "In full"], ["compare", "Compare"], ["looks", "Groups"], ["whynot", "Why not"], ["changes", "Changes"], ["texts", "Assumptions"]];
  fill($("sections"), links.filter(([id]) => !$(id).hidden).map(([id, words]) => h("li", {}, h("a", { href: `#${id}`, text: words }))));
}

/** The 3D view compiles its shaders, which holds up the painter on machines without a graphics card: the page is painted first. */
function afterPaint(work) {
  let begun = false;
  const begin = () => {
    if (begun) return;
    begun = true;
    setTimeout(work);
  };
  new PerformanceObserver(begin).observe({ type: "paint", buffered: true });
  setTimeout(begin, 4000);
}

function start() {
  startTheme();
  const hasPlots = houses.length > 1 && objectives.length > 0;
  startNamed();
  startFindings();
  if (hasPlots) {
    startScatter();
    startParallel();
    startGrid();
  } else {
    ["scatter-box", "parallel-box", "grid-box"].forEach((id) => ($(id).hidden = true));
    $("explore-h").textContent = houses.length ? "The house" : "No house is feasible";
    $("explore").classList.add("single");
  }
  startChosen();
  startDossier();
  startCompare();
  startTexts();
  startTop();
  const first = report.named.find((one) => /balance|knee/.test(one.name)) || report.named[0];
  const house = (first && houseOf.get(first.id)) || houses[0];
  if (house) choose(house);
  else ["house", "chosen"].forEach((id) => ($(id).hidden = true));
  afterPaint(startViewer);
  window.houscaperReport = { started: performance.now(), brushMilliseconds: () => sift.milliseconds };
}

start();
