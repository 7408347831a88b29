// SPDX-License-Identifier: Apache-2.0
// Roles as nested blocks, and correspondences as arrows between them.
import {$, el} from "./dom.js";
import {edit, state} from "./designer-state.js";
import {componels, entries, flow, idOf, kindOf, list, roles, scmsOf, text} from "./designer-model.js";
import {formulaText} from "./designer-conditions.js";

export const keyOf = (role, id) => `${role}/${id}`;
let dragged = null;   // {role, path}

/** Lines of what is wrong, by file, so that what stands there can be marked. */
const wrongPaths = () => new Set(state.check.errors.map((one) => one.file + " " + one.path));
const pathText = (path) => path.map((step, i) => (typeof step === "number" ? `[${step}]` : (i ? "." : "") + step)).join("");
function isWrong(wrong, file, path, deep) {
  const at = file + " " + pathText(path);
  for (const one of wrong) if (one === at || (deep && (one.startsWith(at + ".") || one.startsWith(at + "["))) ) return true;
  return false;
}

function words(value, kind) {
  const parts = [];
  if (kind === "task") { parts.push(text(value.type)); entries(value.params).forEach(([key, one]) => parts.push(`${key}: ${flow(one)}`)); }
  if (kind === "action") { parts.push(text(value.modality)); entries(value.out).forEach(([key, one]) => parts.push(`→ ${key}: ${flow(one)}`)); }
  return parts.join("  ");
}

function sheet(role, variant, chosen, choose) {
  const wrong = wrongPaths();
  const held = new Map();   // block -> SCMs that hold there
  for (const [scm, where] of entries(variant?.value?.coordination?.blocks)) for (const id of list(where?.[role.name])) held.set(text(id), [...(held.get(text(id)) ?? []), scm]);

  const drop = (node, into, index) => {
    node.addEventListener("dragover", (event) => { if (dragged?.role === role.name) { event.preventDefault(); event.stopPropagation(); node.classList.add("drop"); } });
    node.addEventListener("dragleave", () => node.classList.remove("drop"));
    node.addEventListener("drop", (event) => {
      event.preventDefault(); event.stopPropagation(); node.classList.remove("drop");
      const from = dragged; dragged = null;
      if (from) edit([moveTo(role, from.path, into, index)]);
    });
  };

  const item = (value, path, depth) => {
    const kind = kindOf(value);
    if (!kind) return el("div", {className: "task wrong"}, flow(value));
    const id = idOf(value), key = keyOf(role.name, id);
    const node = el("div", {className: `${kind}${text(value.type) === "loop" && kind === "block" ? " loop" : ""}${key === chosen ? " chosen" : ""}`, tabIndex: 0, draggable: path.length > role.blockPath.length,
      role: "treeitem", "data-key": key, "aria-selected": String(key === chosen), "aria-label": `${kind} ${id}`, "aria-level": String(depth)});
    if (isWrong(wrong, role.file, path, kind !== "block") || (kind === "block" && ["pre", "exit", "local", "scms", "type", "end", "block"].some((one) => isWrong(wrong, role.file, [...path, one], true)))) node.classList.add("wrong");
    node.addEventListener("click", (event) => { event.stopPropagation(); choose({role: role.name, id}); });
    node.addEventListener("dragstart", (event) => { event.stopPropagation(); dragged = {role: role.name, path}; node.classList.add("dragging"); event.dataTransfer.setData("text/plain", id); });
    node.addEventListener("dragend", () => node.classList.remove("dragging"));
    if (path.length > role.blockPath.length) drop(node, path.slice(0, -1), path[path.length - 1]);
    if (kind !== "block") {
      node.append(el("b", {}, id), el("small", {}, words(value, kind)));
      return node;
    }
    const end = text(value.end) === "immediate" ? ", ends all around" : "";
    node.append(el("div", {className: "head"}, el("span", {className: "id"}, id), el("span", {className: "kind"}, (text(value.type) || "plan") + end)));
    if (list(value.pre).length) node.append(el("div", {className: "condition pre"}, formulaText(value.pre)));
    if (list(value.exit).length) node.append(el("div", {className: "condition exit"}, formulaText(value.exit)));
    for (const [name, call] of entries(value.local)) node.append(el("div", {className: "condition local"}, `${name} = ${text(call)}`));
    const scms = [...list(value.scms).map(text), ...(held.get(id) ?? [])];
    if (scms.length) node.append(el("div", {className: "condition scm"}, scms.join(", ")));
    const content = el("div", {role: "group"}, ...list(value.content).map((one, i) => item(one, [...path, "content", i], depth + 1)));
    const last = el("div", {className: "tail"}, "\u00a0");
    drop(last, [...path, "content"], list(value.content).length);
    node.append(content, last);
    return node;
  };

  const header = el("header", {tabIndex: 0, className: (chosen === keyOf(role.name, "") ? "chosen" : "") + (["needs", "parameters"].some((one) => isWrong(wrong, role.file, [...role.path, one], true)) ? " wrong" : ""), "data-key": keyOf(role.name, ""), role: "treeitem", "aria-label": "role " + role.name},
    el("b", {}, role.name), el("small", {}, list(role.value?.needs).map(flow).join(", ")));
  header.addEventListener("click", () => choose({role: role.name, id: ""}));
  return el("div", {className: "role", "data-role": role.name}, header, role.block ? item(role.block, role.blockPath, 1) : el("p", {}, "no automaton"));
}

/** Index as the list is without the item. */
export function moveTo(role, path, into, index) {
  const from = path[path.length - 1];
  const same = pathText(path.slice(0, -1)) === pathText(into);
  return {file: role.file, move: path, into, index: same && index > from ? index - 1 : index};
}

export function draw(variant, chosen, choose) {
  const focus = document.activeElement?.dataset?.key;
  $("roles").replaceChildren(...roles(variant).map((role) => sheet(role, variant, chosen, choose)));
  if (focus) document.querySelector(`#roles [data-key="${CSS.escape(focus)}"]`)?.focus({preventScroll: true});
  arrows(variant, chosen);
}

const svg = (tag, attributes) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  return node;
};

/** One for each correspondence, from the action that asks to the one that answers. */
export function arrows(variant, chosen) {
  const canvas = $("arrows"), around = $("roles").getBoundingClientRect();
  canvas.setAttribute("width", around.width); canvas.setAttribute("height", around.height);
  const head = svg("marker", {id: "head", viewBox: "0 0 10 10", refX: 9, refY: 5, markerWidth: 7, markerHeight: 7, orient: "auto-start-reverse"});
  head.append(svg("path", {d: "M0 0 L10 5 L0 10 z", style: ""}));
  const marks = svg("defs", {});
  marks.append(head);
  canvas.replaceChildren(marks);
  const box = (role, id) => document.querySelector(`#roles [data-key="${CSS.escape(keyOf(role, id))}"]`)?.getBoundingClientRect();
  list(variant?.value?.coordination?.actions).forEach((entry, i) => {
    const from = box(text(entry?.role), text(entry?.action)), to = box(text(entry?.with), text(entry?.target));
    if (!from || !to) return;
    const inside = text(entry.role) === text(entry.with);
    const right = inside || from.left < to.left;
    const x1 = (right ? from.right : from.left) - around.left, y1 = from.top + from.height * (right ? 0.35 : 0.65) - around.top;
    const x2 = (inside ? to.right : right ? to.left : to.right) - around.left, y2 = to.top + to.height * (inside ? 0.8 : right ? 0.35 : 0.65) - around.top;
    const bend = inside ? 42 : Math.max(30, Math.abs(x2 - x1) / 2), away = inside ? 1 : right ? 1 : -1;
    const mine = [keyOf(text(entry.role), text(entry.action)), keyOf(text(entry.with), text(entry.target))].includes(chosen);
    canvas.append(svg("path", {d: `M${x1} ${y1} C${x1 + away * bend} ${y1} ${x2 + (inside ? 1 : -away) * bend} ${y2} ${x2} ${y2}`, "marker-end": "url(#head)", "data-correspondence": i, class: mine ? "mine" : ""}));
    const label = svg("text", {x: x1 + away * 16, y: y1 + (right ? -5 : 13), "text-anchor": right ? "start" : "end"});
    label.textContent = text(entry.who);
    canvas.append(label);
  });
}

/** Keys on what has the focus: up and down go on, with Alt they move it, Delete removes it. */
export function keys(variantNow, choose) {
  $("roles").addEventListener("keydown", (event) => {
    const at = event.target.closest("[data-key]");
    if (!at || event.target.matches("input, select, textarea")) return;
    const [name, id] = [at.dataset.key.slice(0, at.dataset.key.lastIndexOf("/")), at.dataset.key.slice(at.dataset.key.lastIndexOf("/") + 1)];
    const role = roles(variantNow()).find((one) => one.name === name);
    if (["Enter", " "].includes(event.key)) { choose({role: name, id}); event.preventDefault(); }
    const found = role && componels(role).find((one) => one.id === id);
    if (["ArrowDown", "ArrowUp"].includes(event.key)) {
      event.preventDefault();
      const step = event.key === "ArrowDown" ? 1 : -1;
      if (event.altKey && found?.parent) {
        const index = found.path[found.path.length - 1] + step, siblings = list(found.parent.value.content).length;
        if (index >= 0 && index < siblings) edit([{file: role.file, move: found.path, into: found.path.slice(0, -1), index}]);
        return;
      }
      const allOfThem = [...document.querySelectorAll("#roles [data-key]")];
      allOfThem[allOfThem.indexOf(at) + step]?.focus();
    }
    if (event.key === "Delete" && found?.parent) edit([{file: role.file, remove: found.path}]);
  });
}
