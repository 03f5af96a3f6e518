// Elements. Whatever comes from the run is written as text, never as markup.

const $ = (id) => document.getElementById(id);

/** An element with properties (`class`, `text`, attributes, `onclick`...) and children. */
function h(tag, props = {}, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(props)) {
    if (value === null || value === undefined || (value === false && !key.startsWith("aria-"))) continue;
    if (key === "text") element.textContent = value;
    else if (key === "class") element.className = value;
    else if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else element.setAttribute(key, value === true && !key.startsWith("aria-") ? "" : String(value));
  }
  element.append(...children.flat().filter((c) => c !== null && c !== undefined && c !== false));
  return element;
}

/** Puts new children in place of the old ones. */
function fill(element, ...children) {
  element.replaceChildren(...children.flat().filter((c) => c !== null && c !== undefined && c !== false));
}

/** A labelled select; `options` are [value, text]. */
function select(label, options, value, change) {
  const list = h("select", { onchange: (e) => change(e.target.value) },
    options.map(([v, t]) => h("option", { value: v, text: t, selected: v === value })));
  return h("label", { class: "field" }, h("span", { text: label }), list);
}

function button(text, props, press) {
  return h("button", { type: "button", text, onclick: press, ...props });
}

function checkbox(label, on, change) {
  const box = h("input", { type: "checkbox", checked: on, onchange: (e) => change(e.target.checked) });
  return h("label", { class: "check" }, box, h("span", { text: label }));
}

/** Says something to screen readers. */
function announce(text) {
  $("live").textContent = text;
}

/** A canvas as large as its box, in device pixels; its context works in CSS pixels. */
function sized(canvas, width, height) {
  const ratio = Math.min(window.devicePixelRatio || 1, 3);
  const [w, hgt] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== hgt) {
    canvas.width = w;
    canvas.height = hgt;
    if (canvas.style) {
      canvas.style.width = `${width}px`;
      canvas.style.height = `${height}px`;
    }
  }
  // Thousands of small marks are drawn sooner by the processor than by a graphics card, and far sooner where there is none.
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return context;
}

/** Runs `work` once in the next frame, however often it is asked for. */
function once(work) {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      work();
    });
  };
}
