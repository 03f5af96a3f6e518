// Light and dark: as the system has it, until the reader says otherwise.

const THEMES = [["auto", "as the system"], ["light", "light"], ["dark", "dark"]];
let theme = "auto";
let inks = {};

function readInks() {
  const style = getComputedStyle(document.documentElement);
  const names = ["paper", "sheet", "ink", "quiet", "line", "grid", "accent", "cloud", "faint", "miss"];
  inks = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  inks.isDark = theme === "dark" || (theme === "auto" && matchMedia("(prefers-color-scheme: dark)").matches);
}

function startTheme() {
  const toggle = $("theme");
  const show = () => {
    const [, words] = THEMES.find(([name]) => name === theme);
    toggle.textContent = `Colours: ${words}`;
    if (theme === "auto") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    readInks();
    emit("theme");
  };
  toggle.addEventListener("click", () => {
    theme = THEMES[(THEMES.findIndex(([name]) => name === theme) + 1) % THEMES.length][0];
    show();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", show);
  // Paper is white: plots of a dark page are drawn again for it, at once.
  window.addEventListener("beforeprint", () => {
    if (!inks.isDark) return;
    const shown = theme;
    theme = document.documentElement.dataset.theme = "light";
    readInks();
    if (scatter.frame) [drawBase, drawScatter, drawParallelBase, drawParallel].forEach((draw) => draw());
    drawView();
    window.addEventListener("afterprint", () => {
      theme = shown;
      show();
    }, { once: true });
  });
  show();
}

// Samples of viridis (Smith and van der Walt, matplotlib 2015); the last tenth is too pale for white paper, the first too dark for black.
const VIRIDIS = [0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725];
function viridis(t) {
  const [low, high] = inks.isDark ? [0.22, 1] : [0, 0.92];
  const at = (low + (high - low) * Math.min(1, Math.max(0, Number.isFinite(t) ? t : 0))) * 8;
  const i = Math.min(7, Math.floor(at)), f = at - i;
  const channel = (s) => Math.round(((VIRIDIS[i] >> s) & 255) * (1 - f) + ((VIRIDIS[i + 1] >> s) & 255) * f);
  return `rgb(${channel(16)},${channel(8)},${channel(0)})`;
}

// Okabe and Ito (2008), which colour-blind readers tell apart; letters and shapes say the same.
const SERIES = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
const LETTERS = ["A", "B", "C", "D"];
