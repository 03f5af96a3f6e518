// Drives report.html in Chromium: node report_page.mjs PAGE DESIGNS NAME, with PLAYWRIGHT_DIR and CHROMIUM. Prints a line for each check; ends with 1 when one fails.
import path from "node:path";
import { createRequire } from "node:module";
import { createHash } from "node:crypto";

const require = createRequire(path.join(path.dirname(process.env.PLAYWRIGHT_DIR), "x.js"));
const { chromium } = require(process.env.PLAYWRIGHT_DIR);
const [file, designs, name] = process.argv.slice(2);
let failed = 0;
function check(what, holds, detail = "") {
  console.log(`${holds ? "ok  " : "FAIL"} ${what}${detail === "" ? "" : `: ${detail}`}`);
  if (!holds) failed += 1;
}

/** How many times longer work takes than its processor time: what other programs on this machine take away. Times are held against it. */
function crowding() {
  const [began, used] = [performance.now(), process.cpuUsage()];
  for (let sum = 0; performance.now() - began < 400;) sum += Math.sqrt(sum + 1);
  const spent = process.cpuUsage(used);
  return Math.max(1, (performance.now() - began) / ((spent.user + spent.system) / 1000));
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM,
  args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
const page = await context.newPage();
page.setDefaultTimeout(120000);
const troubles = [], requests = [];
page.on("console", (m) => ["error", "warning"].includes(m.type()) && !/GL Driver Message|GPU stall/.test(m.text()) && troubles.push(m.text()));
page.on("pageerror", (e) => troubles.push(e.message));
page.on("dialog", (d) => (troubles.push(`dialog ${d.message()}`), d.dismiss()));
page.on("request", (r) => !/^(data|blob|about):/.test(r.url()) && requests.push(r.url()));

const before = crowding();
await page.goto(`file://${file}`, { waitUntil: "load", timeout: 300000 });
await page.waitForFunction(() => performance.getEntriesByName("first-contentful-paint").length > 0);
const crowded = Math.max(before, crowding(), 1);
const paint = await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime);
const limit = (milliseconds) => milliseconds * crowded;
check("first paint in 3 s", paint < limit(3000), `${paint.toFixed(0)} ms, others take the machine ${crowded.toFixed(1)} times over`);
check("the name is text", (await page.textContent("#title")) === name);

// Every design is drawn, the front in colour.
const words = await page.textContent("#count");
check("all designs are counted", words.replaceAll("\u202f", "").includes(`${designs} of ${designs}`), words);
const inked = (id) => page.evaluate((canvas) => {
  const c = document.getElementById(canvas), { data } = c.getContext("2d", { willReadFrequently: true }).getImageData(0, 0, c.width, c.height);
  let hash = 0, inks = new Set();
  for (let i = 0; i < data.length; i += 4) {
    const ink = (data[i] << 24) | (data[i + 1] << 16) | (data[i + 2] << 8) | data[i + 3];
    inks.add(ink);
    hash = (hash * 31 + ink) | 0;
  }
  return { hash, inks: inks.size };
}, id);
await page.waitForTimeout(500);
const clean = { scatter: await inked("scatter"), parallel: await inked("parallel") };
check("the plots are drawn", clean.scatter.inks > 50 && clean.parallel.inks > 50, `${clean.scatter.inks} and ${clean.parallel.inks} inks`);

// Brushing with the pointer: the lower half of the first axis, then a second axis.
const shown = () => page.locator("#grid > li").count();
const all = await shown();
await page.locator("#parallel-box").scrollIntoViewIfNeeded();
const drag = async (nth, from, to, shift) => {
  const box = await page.locator("#parallel").boundingBox();
  const axis = await page.locator("#handles .limits").nth(nth).evaluate((g) => parseFloat(g.style.left));
  if (shift) await page.keyboard.down("Shift");
  await page.mouse.move(box.x + axis, box.y + 62 + (box.height - 84) * from);
  await page.mouse.down();
  await page.mouse.move(box.x + axis, box.y + 62 + (box.height - 84) * (from + to) / 2, { steps: 3 });
  await page.mouse.move(box.x + axis, box.y + 62 + (box.height - 84) * to);
  await page.mouse.up();
  if (shift) await page.keyboard.up("Shift");
  await page.waitForTimeout(300);
};
await drag(2, 0.02, 0.5);
const half = await shown();
const answer = await page.evaluate(() => window.houscaperReport.brushMilliseconds());
check("a brush answers in 100 ms", answer < limit(100), `${answer.toFixed(0)} ms`);
check("a brush filters the pictures", half > 0 && half < all, `${half} of ${all}`);
check("a brush filters the plots", (await inked("scatter")).hash !== clean.scatter.hash && (await inked("parallel")).hash !== clean.parallel.hash);
check("a brush counts the designs", !(await page.textContent("#count")).replaceAll("\u202f", "").includes(`${designs} of ${designs}`));
await drag(2, 0.6, 0.98, true);
check("a second brush on an axis adds to it", (await shown()) >= half);
await drag(0, 0.7, 0.99);
const both = await shown();
check("a brush on another axis takes away", both <= all);
await page.click("#reset");
check("the brushes are cleared", (await shown()) === all && await page.isDisabled("#reset"));

// Choosing, shortlisting, comparing.
const heading = () => page.textContent("#chosen-h");
await page.locator("#grid .card").nth(1).click();
const second = await heading();
await page.locator("#grid .card").nth(2).click();
check("a picture chooses its house", (await heading()) !== second, await heading());
for (const n of [0, 1, 2, 3]) await page.locator("#grid .star").nth(n).click();
check("the shortlist holds four", (await page.locator("#tray li").count()) === 4);
if (all > 4) {
  await page.locator("#grid .star").nth(4).click();
  check("and no fifth", (await page.locator("#tray li").count()) === 4);
}
await page.waitForSelector("table.compare");
const table = await page.locator("table.compare thead th").count();
const rows = await page.locator("table.compare tbody tr").allTextContents();
check("four stand side by side", table === 4);
check("with differences, structure and materials", rows.length > 40 && rows.some((r) => /[+\u2212]\d/.test(r)) && rows.some((r) => r.startsWith("Verdict")) && rows.some((r) => r.startsWith("wall")), `${rows.length} rows`);
await page.locator("#tray .off").first().click();
check("a house leaves the shortlist", (await page.locator("#tray li").count()) === 3);

// The house in 3D: something is drawn, turning changes it, the frame is another.
const other = await context.newPage();
const seen = async () => {
  await page.waitForTimeout(600);
  const shot = await page.locator("#model").screenshot();
  const colours = await other.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const c = new OffscreenCanvas(image.width, image.height).getContext("2d", { willReadFrequently: true });
    c.drawImage(image, 0, 0);
    const counts = new Map(), { data: d } = c.getImageData(0, 0, image.width, image.height);
    for (let i = 0; i < d.length; i += 4) counts.set((d[i] << 16) | (d[i + 1] << 8) | d[i + 2], (counts.get((d[i] << 16) | (d[i + 1] << 8) | d[i + 2]) || 0) + 1);
    return { kinds: counts.size, most: Math.max(...counts.values()) / (d.length / 4) };
  }, shot.toString("base64"));
  return { hash: createHash("sha256").update(shot).digest("hex"), ...colours };
};
await page.locator("#view").scrollIntoViewIfNeeded();
await page.waitForFunction(() => document.querySelector("#model-tools button"));
const house = await seen();
check("the house is drawn", house.kinds > 200 && house.most < 0.9, `${house.kinds} colours`);
const view = await page.locator("#model").boundingBox();
await page.mouse.move(view.x + 200, view.y + 150);
await page.mouse.down();
await page.mouse.move(view.x + 300, view.y + 170, { steps: 4 });
await page.mouse.up();
const turned = await seen();
check("dragging turns it", turned.hash !== house.hash);
await page.locator("#model").focus();
await page.keyboard.press("ArrowLeft");
await page.keyboard.press("+");
const keyed = await seen();
check("keys turn and zoom it", keyed.hash !== turned.hash);
await page.keyboard.press("f");
const shows = (what) => page.waitForFunction((w) => document.querySelector("#model").ariaLabel.endsWith(w), what);
await shows("its frame");
const frame = await seen();
check("the frame is shown, in views", frame.hash !== keyed.hash && frame.kinds > 200);
await page.mouse.click(view.x + view.width / 2, view.y + view.height * 0.55);
await page.keyboard.press("h");
await shows("outside");
const built = await seen();
await page.locator("#model-tools select").selectOption({ label: "carbon" });
const coloured = await seen();
check("the house has views", coloured.hash !== built.hash);
await page.locator("#model-tools input[type=range]").last().fill("0.4");
check("a cut opens it", (await seen()).hash !== coloured.hash);

// Tabs with the pages of the house; sandboxed, and as high as they are.
for (const tab of ["quote", "structure", "carbon"]) {
  await page.click(`#tab-${tab}`);
  const inside = page.frameLocator("iframe.page");
  await inside.locator("h1").waitFor();
  await page.waitForFunction(() => document.querySelector("iframe.page").clientHeight > 600);
  const sandbox = await page.getAttribute("iframe.page", "sandbox");
  check(`${tab} is behind its tab`, !sandbox.includes("scripts"), await inside.locator("h1").first().textContent());
}
await page.click("#tab-drawings");
await page.waitForFunction(() => [...document.querySelectorAll(".drawings img")].some((i) => i.naturalWidth > 0));
check("drawings are shown", true);
await page.fill("#search", "snow");
check("texts are searched", (await page.locator("#texts-body mark").count()) > 3, await page.textContent("#texts-body .count"));

// The keyboard alone.
await page.reload({ waitUntil: "load" });
await page.keyboard.press("Tab");
check("the first stop skips to the houses", (await page.evaluate(() => document.activeElement.className)) === "skip");
await page.keyboard.press("Enter");
const tabTo = async (selector) => {
  for (let n = 0; n < 90; n++) {
    if (await page.evaluate((s) => document.activeElement.matches(s), selector)) return true;
    await page.keyboard.press("Tab");
  }
  return false;
};
check("the plot is reached by Tab", await tabTo("#scatter"));
const focus = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
check("focus is seen", focus !== "none", focus);
const was = await heading();
for (const key of ["ArrowRight", "ArrowRight", "ArrowUp"]) await page.keyboard.press(key);
check("arrows tell the house", /House \d+/.test(await page.textContent("#live")), await page.textContent("#live"));
await page.keyboard.press("Enter");
const now = await heading();
await page.keyboard.press("End");
check("Enter chooses it", now !== was, now);
await page.keyboard.press("s");
check("S shortlists it", (await page.locator("#tray li").count()) === 1);
check("a limit is reached by Tab", await tabTo("#handles [role=slider]"));
for (let n = 0; n < 12; n++) await page.keyboard.press("ArrowUp");
await page.waitForTimeout(600);
check("arrows move a limit", (await shown()) < all, `${await shown()} of ${all}`);
await page.keyboard.press("Delete");
// The grid follows when the page is next drawn.
for (let n = 0; n < 100 && (await shown()) !== all; n++) await page.waitForTimeout(100);
check("Delete clears it", (await shown()) === all);
check("the pictures are reached by Tab", await tabTo("#grid .card"));
await page.keyboard.press("ArrowRight");
await page.keyboard.press("s");
check("arrows and S work in the pictures", (await page.locator("#tray li").count()) === 2);
check("the comparison is reached by Tab", await tabTo("table.compare button"));

// What a checker of accessibility asks first.
const faults = await page.evaluate(() => {
  const out = [], named = (e) => (e.getAttribute("aria-label") || e.textContent || e.title || (e.labels?.[0]?.textContent ?? "")).trim();
  const visible = (e) => e.checkVisibility();
  document.querySelectorAll("button, a, select, input, [role=slider], [role=tab], canvas[tabindex], iframe").forEach((e) => visible(e) && !named(e) && out.push(`no name: ${e.outerHTML.slice(0, 90)}`));
  document.querySelectorAll("img").forEach((e) => !e.hasAttribute("alt") && out.push(`no alt: ${e.outerHTML.slice(0, 90)}`));
  const ids = [...document.querySelectorAll("[id]")].map((e) => e.id);
  ids.filter((id, at) => ids.indexOf(id) !== at).forEach((id) => out.push(`id twice: ${id}`));
  document.querySelectorAll("[aria-labelledby], [aria-describedby], [aria-controls]").forEach((e) => ["aria-labelledby", "aria-describedby", "aria-controls"].forEach((a) => (e.getAttribute(a) || "").split(" ").filter(Boolean).forEach((id) => !document.getElementById(id) && out.push(`${a} of nothing: ${id}`))));
  let level = 0;
  document.querySelectorAll("h1, h2, h3, h4").forEach((e) => {
    const next = Number(e.tagName[1]);
    if (visible(e) && next > level + 1) out.push(`heading jumps: ${e.textContent}`);
    if (visible(e)) level = next;
  });
  document.querySelectorAll("button button, button a, a button").forEach((e) => out.push(`nested: ${e.outerHTML.slice(0, 80)}`));
  if (!document.documentElement.lang || !document.title || document.querySelectorAll("main").length !== 1) out.push("lang, title or main");
  return out;
});
check("names, alternatives, ids, headings", faults.length === 0, faults.slice(0, 5).join(" | "));
for (const colorScheme of ["light", "dark"]) {
  await page.emulateMedia({ colorScheme });
  const least = await page.evaluate(() => {
    const style = getComputedStyle(document.documentElement);
    const light = (name) => {
      const hex = style.getPropertyValue(name).trim();
      const [r, g, b] = [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    // WCAG 2.1, 1.4.3.
    const ratio = (a, b) => (Math.max(light(a), light(b)) + 0.05) / (Math.min(light(a), light(b)) + 0.05);
    return Math.min(...["--ink", "--quiet", "--accent", "--good"].flatMap((ink) => ["--paper", "--sheet"].map((paper) => ratio(ink, paper))));
  });
  check(`text stands out, ${colorScheme}`, least >= 4.5, `${least.toFixed(1)} to 1`);
}
await page.emulateMedia({ colorScheme: "light" });

// A phone: nothing wider than the screen.
await page.setViewportSize({ width: 390, height: 844 });
await page.waitForFunction(() => document.documentElement.scrollWidth <= 390, null, { timeout: 20000 }).catch(() => {});
const wide = await page.evaluate(() => document.documentElement.scrollWidth);
check("a phone needs no scrolling aside", wide <= 390, `${wide} px`);
await page.setViewportSize({ width: 1280, height: 720 });

// Print: no tools, every picture, some sheets.
await page.waitForFunction(() => !document.querySelector("img[data-house]:not([src])"));
await page.emulateMedia({ media: "print" });
check("print hides what cannot be pressed", !(await page.isVisible("nav")) && !(await page.isVisible("#tray")) && await page.isVisible("#grid"));
const sheets = (await page.pdf({ preferCSSPageSize: true })).toString("latin1").match(/\/Type\s*\/Page[^s]/g)?.length ?? 0;
check("print gives sheets", sheets >= 3, `${sheets}`);
check("no request leaves the page", requests.every((url) => url.startsWith(`file://${file}`)), requests.slice(0, 3).join(" "));
check("no errors and no warnings", troubles.length === 0, troubles.slice(0, 4).join(" | "));
await browser.close();
process.exit(failed ? 1 : 0);
