// SPDX-License-Identifier: Apache-2.0
// Elements from values. Text is always text: nothing that comes from outside becomes markup.

/** @param {string} tag  @param {object} [props]  @param {...(Node|string|null|false)} children */
export function el(tag, props = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else if (name === "style") for (const [k, v] of Object.entries(value)) node.style.setProperty(k, v);
    else if (name in node && name !== "list") node[name] = value;
    else node.setAttribute(name, value);
  }
  node.append(...children.filter((child) => child !== null && child !== false && child !== undefined));
  return node;
}

export const $ = (id) => document.getElementById(id);

/** Replaces what is in a node if its description changed: what has the focus is left in peace. */
export function fill(node, key, make) {
  if (node.dataset.key === key) return false;
  node.dataset.key = key;
  node.replaceChildren(...[make()].flat());
  return true;
}

/** A dangerous action: the thumb is slid to the end, by pointer or by keys. */
export function slide(label, fire) {
  const input = el("input", {type: "range", min: "0", max: "100", value: "0", title: label});
  input.setAttribute("aria-label", "slide to " + label);
  let done = false;
  const back = () => { input.value = "0"; done = false; };
  input.addEventListener("input", () => {
    if (Number(input.value) < 97 || done) return;
    done = true;
    fire();
    setTimeout(back, 500);
  });
  input.addEventListener("change", () => { if (!done) back(); });
  input.addEventListener("keydown", (event) => {
    if (event.key === "ArrowRight") { input.value = String(Number(input.value) + 12); input.dispatchEvent(new Event("input")); event.preventDefault(); }
  });
  return el("span", {className: "slide"}, el("span", {}, label + " »"), input);
}

export const seconds = (ns) => (ns === null || ns === undefined || ns < -9e17 ? null : ns > 9e17 ? Infinity : ns / 1e9);

export function clockText(s) {
  if (s === null || !Number.isFinite(s)) return "–";
  const whole = Math.max(0, Math.floor(s));
  const two = (n) => String(n).padStart(2, "0");
  const h = Math.floor(whole / 3600);
  return (h ? h + ":" : "") + two(Math.floor(whole / 60) % 60) + ":" + two(whole % 60);
}

export const isOver = (state) => state === "ended" || state === "aborted";
