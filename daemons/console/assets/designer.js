// SPDX-License-Identifier: Apache-2.0
// The designer of interaction models: what is chosen, and how it is changed.
import {$, el, fill} from "./dom.js";
import {canRedo, canUndo, edit, file, isUnsaved, onChange, redo, save, setText, settle, start, state, undo, unsaved} from "./designer-state.js";
import {all, componels, entries, flow, freshId, list, one, put, renameComponel, renameRole, roles, scmsOf, text, variants} from "./designer-model.js";
import {editor} from "./designer-conditions.js";
import * as blocks from "./designer-blocks.js";
import * as scm from "./designer-scm.js";

const modalities = ["role-allocation", "time-interval", "area-sharing", "perception-positions", "relay-chain", "plan-merging", "task-auction"];
const types = ["Obj", "Point", "Time", "UAVlist", "Number", "Text"];
let variantKey = null, chosen = null;   // {role, id}; id empty: the role itself

const variant = () => variants().find((it) => it.key === variantKey) ?? null;
const choose = (what) => { chosen = what; draw(); };

// ---- fields ----

const field = (label, control, extra = "") => el("label", {className: "field"}, el("span", {}, label), control, extra);
const select = (value, options, onchange) => el("select", {onchange: (event) => onchange(event.target.value)}, ...[...new Set([...options, value])].map((option) => el("option", {value: option, selected: option === value}, option || "–")));
const input = (value, onchange, extra = {}) => el("input", {value, ...extra, onchange: (event) => onchange(event.target.value)});
const remover = (onclick) => el("button", {type: "button", title: "remove", onclick}, "×");

/** Names with values that are said as YAML in one line. */
function map(label, file, around, path, key, {fresh = "name", value = "", options} = {}) {
  const at = [...path, key], all = entries(around?.[key]);
  const rows = all.map(([name, one]) => field("", el("span", {}, input(name, (to) => edit([{file, rename: [...at, name], key: to}]), {size: 10, "aria-label": `${label}: name`}), " "),
    el("span", {}, options ? select(text(one), options, (to) => edit([{file, set: [...at, name], value: to}])) : input(flow(one), (to) => edit([{file, set: [...at, name], yaml: to}]), {size: 16, "aria-label": `${label}: ${name}`}),
      remover(() => edit(all.length > 1 ? [{file, remove: [...at, name]}] : [{file, remove: at}])))));
  const name = freshId(fresh, all.map(([it]) => it));
  return [el("h4", {}, label), ...rows, el("button", {type: "button", "data-add": key, onclick: () => edit(all.length ? [{file, insert: at, key: name, value}] : put(file, around, path, key, {[name]: value}))}, `add to ${label}`)];
}

// ---- a componel ----

function messagesOf(role, v) {
  const named = [...scmsOf(v).map((it) => it.id)].flatMap((id) => [`${id} violated`, `${id} satisfied`]);
  return [...new Set(["interruption", "member lost", ...named, ...modalities.map((it) => `${it} invitation`)])];
}

function conditions(componel, key, ids, messages) {
  const {value, path, role} = componel;
  return [el("h4", {}, key === "pre" ? "begins when" : "ends when"), editor(value[key], {
    name: key, isExit: key === "exit", isLoop: text(value.type) === "loop", ids: ids.filter((id) => id !== componel.id), messages,
    change: (formula) => edit(put(role.file, value, path, key, formula)),
  })];
}

function add(componel, kind) {
  const ids = roles(null).flatMap(componels).map((it) => it.id);
  const task = {task: freshId("t", ids), type: all("tasks")[0]?.name ?? "goto"};
  const parameters = entries(all("tasks")[0]?.value).filter(([name]) => !name.endsWith("?"));
  const known = Object.keys(componel.role.value?.parameters ?? {});
  if (parameters.length) task.params = Object.fromEntries(parameters.map(([name]) => [name, known[0] ?? name]));
  const value = kind === "task" ? task : kind === "action" ? {action: freshId("ac", ids), modality: modalities[0]} : {block: freshId("b", ids), content: [task]};
  edit([{file: componel.role.file, insert: [...componel.path, "content"], value}]);
  chosen = {role: componel.role.name, id: kind === "task" ? task.task : text(value[kind])};
}

function placing(componel, everything) {
  const {path, role, parent} = componel;
  if (!parent) return [];
  const index = path[path.length - 1], siblings = list(parent.value.content).length, list_ = path.slice(0, -1);
  const inside = everything.filter((it) => it.kind === "block" && it !== componel && it !== parent && !it.path.slice(0, path.length).every((step, i) => step === path[i]));
  const go = (into, at) => edit([{file: role.file, move: path, into, index: at}]);
  return [el("h4", {}, "place"), el("div", {className: "rows"},
    el("button", {title: "Alt-↑", disabled: index === 0, onclick: () => go(list_, index - 1)}, "up"),
    el("button", {title: "Alt-↓", disabled: index + 1 >= siblings, onclick: () => go(list_, index + 1)}, "down"),
    inside.length > 0 && select("into…", ["into…", ...inside.map((it) => it.id)], (id) => { const to = inside.find((it) => it.id === id); if (to) go([...to.path, "content"], list(to.value.content).length); }),
    el("button", {id: "remove", onclick: () => { edit([{file: role.file, remove: path}]); chosen = {role: role.name, id: parent.id}; }}, "remove"))];
}

function held(componel, v) {
  if (!v) return [];
  const table = v.value?.coordination ?? {}, at = [...v.path, "coordination"];
  const boxes = scmsOf(v).map(({id}) => {
    const there = list(table.blocks?.[id]?.[componel.role.name]).map(text), index = there.indexOf(componel.id);
    const toggle = () => {
      const next = index < 0 ? [...there, componel.id] : there.filter((it) => it !== componel.id), name = componel.role.name;
      if (!table.blocks) return edit([{file: v.file, insert: at, key: "blocks", value: {[id]: {[name]: next}}}]);
      if (!table.blocks[id]) return edit([{file: v.file, insert: [...at, "blocks"], key: id, value: {[name]: next}}]);
      return edit(put(v.file, table.blocks[id], [...at, "blocks", id], name, next));
    };
    return el("label", {}, el("input", {type: "checkbox", checked: index >= 0, onchange: toggle, "data-scm": id}), ` ${id} `);
  });
  return boxes.length ? [el("h4", {}, "constraints that hold"), el("div", {className: "rows"}, ...boxes)] : [];
}

function correspondences(componel, v) {
  if (!v) return [];
  const at = [...v.path, "coordination", "actions"], all = list(v.value?.coordination?.actions);
  const actions = roles(v).flatMap(componels).filter((it) => it.kind === "action");
  const mine = all.map((entry, i) => ({entry, i})).filter(({entry}) => text(entry?.role) === componel.role.name && text(entry?.action) === componel.id);
  const label = (role, id) => `${role}: ${id}`;
  const rows = mine.map(({entry, i}) => el("div", {className: "literal"}, "with ",
    select(label(text(entry.with), text(entry.target)), actions.map((it) => label(it.role.name, it.id)), (to) => { const it = actions.find((other) => label(other.role.name, other.id) === to); if (it) edit([{file: v.file, set: [...at, i, "with"], value: it.role.name}, {file: v.file, set: [...at, i, "target"], value: it.id}]); }),
    " who ", input(text(entry.who), (to) => edit([{file: v.file, set: [...at, i, "who"], value: to}]), {size: 8, "aria-label": "who"}),
    remover(() => edit([{file: v.file, remove: [...at, i]}]))));
  const connect = (to) => {
    const it = actions.find((other) => label(other.role.name, other.id) === to);
    if (!it) return;
    const there = {role: componel.role.name, action: componel.id, with: it.role.name, target: it.id, who: "everyone"};
    const back = {role: it.role.name, action: it.id, with: componel.role.name, target: componel.id, who: "everyone"};
    const wanted = [there, back].filter((entry, i, both) => !all.some((other) => ["role", "action", "with", "target"].every((key) => text(other?.[key]) === entry[key])) && (i === 0 || JSON.stringify(both[0]) !== JSON.stringify(entry)));
    if (!wanted.length) return;
    edit(all.length ? wanted.map((value) => ({file: v.file, insert: at, value})) : put(v.file, v.value?.coordination, [...v.path, "coordination"], "actions", wanted));
  };
  return [el("h4", {}, "corresponds to"), ...rows, select("connect with…", ["connect with…", ...actions.map((it) => label(it.role.name, it.id))], connect)];
}

function componelInspector(componel, v) {
  const {kind, value, path, role} = componel, everything = componels(role), ids = everything.map((it) => it.id);
  const set = (key, to) => edit(put(role.file, value, path, key, to));
  const rename = (to) => { if (!to || to === componel.id) return; edit(renameComponel(role, componel, to)); chosen = {role: role.name, id: to}; };
  const parts = [el("h3", {}, `${kind} ${componel.id}`), field("id", input(componel.id, rename, {id: "id"}))];
  if (kind === "block") {
    parts.push(field("type", select(text(value.type) || "plan", ["plan", "loop"], (to) => set("type", to === "plan" ? null : to))),
      field("its end", select(text(value.end) || "wait", ["wait", "immediate"], (to) => set("end", to === "wait" ? null : to))),
      el("div", {className: "rows"}, ...["block", "task", "action"].map((it) => el("button", {"data-insert": it, onclick: () => add(componel, it)}, `add ${it}`))),
      ...placing(componel, everything), ...conditions(componel, "pre", ids, messagesOf(role, v)), ...conditions(componel, "exit", ids, messagesOf(role, v)),
      ...held(componel, v), ...map("local parameters", role.file, value, path, "local", {fresh: "pl", value: "valid-position()"}));
  } else if (kind === "task") {
    const signature = (type) => Object.fromEntries(entries(one("tasks", type)?.value).filter(([name]) => !name.endsWith("?")).map(([name]) => [name, value.params?.[name] ?? Object.keys(role.value?.parameters ?? {})[0] ?? name]));
    parts.push(field("type", select(text(value.type), all("tasks").map((it) => it.name), (to) => edit([...put(role.file, value, path, "type", to), ...put(role.file, value, path, "params", signature(to))]))),
      ...placing(componel, everything), ...map("parameters", role.file, value, path, "params", {fresh: "p"}));
  } else {
    parts.push(field("modality", select(text(value.modality), modalities, (to) => set("modality", to))), ...placing(componel, everything), ...correspondences(componel, v),
      ...map("in", role.file, value, path, "in", {fresh: "p", value: "0"}), ...map("out", role.file, value, path, "out", {fresh: "place", value: "place"}));
  }
  return parts;
}

// ---- a role, a variant ----

function roleInspector(role, v) {
  const needs = list(role.value?.needs), at = [...role.path, "needs"];
  const rename = (to) => { if (!to || to === role.name) return; edit(renameRole(role, to)); chosen = {role: to, id: ""}; };
  return [el("h3", {}, `role ${role.name}`), field("name", input(role.name, rename, {id: "id", disabled: !role.path.length})),
    el("h4", {}, "needs"), ...needs.map((need, i) => field("", input(flow(need), (to) => edit([{file: role.file, set: [...at, i], yaml: to}])), remover(() => edit([{file: role.file, remove: [...at, i]}])))),
    el("button", {onclick: () => edit(needs.length ? [{file: role.file, insert: at, value: "hovering"}] : put(role.file, role.value, role.path, "needs", ["hovering"]))}, "add to needs"),
    ...map("parameters", role.file, role.value, role.path, "parameters", {fresh: "p", value: "Point", options: types}), ...variantInspector(v),
    role.path.length > 0 && el("div", {className: "rows"}, el("button", {onclick: () => edit([{file: role.file, remove: role.path}])}, `remove role ${role.name}`))];
}

const arityText = (value) => (value && typeof value === "object" ? flow(value) : text(value));

function variantInspector(v) {
  if (!v) return [];
  const names = list(v.value?.roles).map(text), table = v.value?.coordination ?? {}, at = [...v.path, "coordination"];
  const others = all("roles").map((it) => it.name).filter((name) => !names.includes(name));
  const bindings = names.flatMap((name) => {
    const given = entries(table.parameters?.[name]), wanted = Object.keys(one("roles", name)?.value?.parameters ?? {});
    const options = Object.keys(v.value?.parameters ?? {});
    return wanted.map((parameter) => field(`${name}.${parameter}`, select(text(given.find(([key]) => key === parameter)?.[1]), ["", ...options], (to) => edit(bind(v, table, at, name, parameter, to)))));
  });
  return [el("h3", {}, `variant ${v.key}`),
    el("h4", {}, "roles and how many hold them"), ...names.map((name, i) => field(name, input(arityText(table.arity?.[name]), (to) => edit([table.arity && name in table.arity ? {file: v.file, set: [...at, "arity", name], yaml: to} : {file: v.file, insert: [...at, "arity"], key: name, yaml: to}]), {title: "1, {at-least: 1}, {at-most: 3}, {between: [1, 3]}"}),
      remover(() => edit(withoutRole(v, table, at, name, i))))),
    others.length > 0 && select("add a role…", ["add a role…", ...others], (name) => { if (others.includes(name)) edit([{file: v.file, insert: [...v.path, "roles"], value: name}, table.arity ? {file: v.file, insert: [...at, "arity"], key: name, value: "1"} : {file: v.file, insert: at, key: "arity", value: {[name]: "1"}}]); }),
    ...map("parameters of the variant", v.file, v.value, v.path, "parameters", {fresh: "p", value: "Point", options: types}),
    el("h4", {}, "parameters of roles"), ...bindings];
}

function bind(v, table, at, role, parameter, to) {
  if (!table.parameters) return [{file: v.file, insert: at, key: "parameters", value: {[role]: {[parameter]: to}}}];
  if (!table.parameters[role]) return [{file: v.file, insert: [...at, "parameters"], key: role, value: {[parameter]: to}}];
  return put(v.file, table.parameters[role], [...at, "parameters", role], parameter, to);
}

/** With all that the table says of it. */
function withoutRole(v, table, at, name, i) {
  const edits = [];
  list(table.actions).map((entry, k) => ({entry, k})).reverse().forEach(({entry, k}) => { if ([text(entry?.role), text(entry?.with)].includes(name)) edits.push({file: v.file, remove: [...at, "actions", k]}); });
  for (const kind of ["arity", "parameters"]) if (name in (table[kind] ?? {})) edits.push({file: v.file, remove: [...at, kind, name]});
  for (const [id, where] of entries(table.blocks)) if (where && name in where) edits.push({file: v.file, remove: Object.keys(where).length > 1 ? [...at, "blocks", id, name] : [...at, "blocks", id]});
  return [...edits, {file: v.file, remove: [...v.path, "roles", i]}];
}

function newRole() {
  const v = variant(), home = roles(v)[0]?.file ?? state.files[0].name, tree = file(home)?.tree ?? {};
  const name = freshId("role", all("roles").map((it) => it.name)), ids = roles(null).flatMap(componels).map((it) => it.id);
  const value = {needs: ["hovering"], parameters: {place: "Point"}, automaton: {block: freshId("b", ids), content: [{task: freshId("t", ids), type: "goto", params: {to: "place"}}]}};
  edit([tree.roles ? {file: home, insert: ["roles"], key: name, value} : {file: home, insert: [], key: "roles", value: {[name]: value}}]);
  chosen = {role: name, id: ""};
  variantKey = null;
}

function inspect() {
  const v = variant(), role = chosen && roles(v).find((it) => it.name === chosen.role);
  const componel = role && chosen.id && componels(role).find((it) => it.id === chosen.id);
  const parts = componel ? componelInspector(componel, v) : role ? roleInspector(role, v) : [...variantInspector(v), el("p", {className: "who"}, "Choose a role, a block, a task or an action.")];
  const focus = document.activeElement?.id;
  $("inspector").replaceChildren(...parts.filter(Boolean), el("hr"), el("div", {className: "rows"}, el("button", {id: "new-role", onclick: newRole}, "new role")));
  if (focus && $("inspector").querySelector("#" + CSS.escape(focus))) $(focus).focus();
}

// ---- below ----

function check() {
  fill($("check"), JSON.stringify(state.check), () => (state.check.right ? [el("li", {className: "right"}, `✓ right: ${state.check.roles.length} roles, ${state.check.scms.length} SCMs, ${Object.keys(state.check.models).length} models`)]
    : state.check.errors.map((error) => el("li", {tabIndex: 0, className: "wrong", onclick: () => show(error)}, el("span", {className: "where"}, `${error.file}:${error.line}`),
      el("span", {}, `${error.path ? error.path + ": " : ""}${error.message}${error.expected ? "; expected " + error.expected : ""}${error.nearest ? "; did you mean '" + error.nearest + "'?" : ""}`)))));
}

/** Where an error is: its line in the text. */
function show(error) {
  tab("text");
  const source = $("source");
  if (file(error.file)) { $("file").value = error.file; texts(true); }
  const lines = source.value.split("\n"), from = lines.slice(0, error.line - 1).join("\n").length + (error.line > 1 ? 1 : 0);
  source.focus();
  source.setSelectionRange(from, from + (lines[error.line - 1]?.length ?? 0));
  source.scrollTop = Math.max(0, (error.line - 4) * 16);
}

function texts(anew) {
  const select = $("file"), was = select.value;
  fill(select, state.files.map((one) => one.name).join("\n"), () => state.files.map((one) => el("option", {value: one.name}, one.name)));
  if (file(was)) select.value = was;   // the list may have changed: a broken text uses nothing
  const now = file(select.value);
  if (!now) return;
  const source = $("source");
  if (anew || document.activeElement !== source || source.dataset.file !== now.name) {
    if (source.value !== now.text) source.value = now.text;
    source.dataset.file = now.name;
  }
  const last = now.text.split("\n").length;   // what ends too soon is wrong behind its end
  const wrong = new Set(state.check.errors.filter((one) => one.file === now.name).map((one) => Math.min(one.line, last)));
  fill($("lines"), now.text.split("\n").length + " " + [...wrong].join(), () => now.text.split("\n").map((_, i) => el(wrong.has(i + 1) ? "b" : "span", {}, `${i + 1}\n`)));
  $("lines").scrollTop = source.scrollTop;
}

let typing = null;
function wireText() {
  const source = $("source");
  source.addEventListener("input", () => { clearTimeout(typing); typing = setTimeout(() => setText(source.dataset.file, source.value), 300); });
  source.addEventListener("scroll", () => { $("lines").scrollTop = source.scrollTop; });
  $("file").addEventListener("change", () => texts(true));
}

function tab(name) {
  for (const button of document.querySelectorAll("#lower nav [data-tab]")) {
    button.setAttribute("aria-pressed", String(button.dataset.tab === name));
    $(button.dataset.tab).hidden = button.dataset.tab !== name;
  }
  if (name === "scms") scm.draw(variant());
  if (name === "text") texts(true);
}

function bar() {
  const names = variants().map((it) => it.key);
  if (variantKey === null && names.length && !chosen) variantKey = names[0];
  if (variantKey !== null && !names.includes(variantKey)) variantKey = names[0] ?? null;
  fill($("variant"), names.join("\n") + "|" + variantKey, () => [...names, ""].map((key) => el("option", {value: key, selected: key === (variantKey ?? "")}, key || "all roles")));
  const open = unsaved(), chip = $("state");
  chip.className = "chip " + (!state.connected ? "bad" : open.length ? "warn" : "good");
  chip.textContent = !state.connected ? "no answer" : open.length ? `● not saved: ${open.map((name) => name.split("/").pop()).join(", ")}` : "saved";
  document.title = (open.length ? "● " : "") + "Skein designer";
  $("refused").hidden = !state.refused;
  $("refused").textContent = state.refused;
  $("undo").disabled = !canUndo(); $("redo").disabled = !canRedo(); $("save").disabled = !open.length;
  const conflict = $("conflict");
  conflict.hidden = !state.conflicts.length;
  if (state.conflicts.length) fill(conflict, state.conflicts.join(), () => [`Somebody else has changed ${state.conflicts.join(", ")} on the disk; nothing was overwritten.`,
    el("button", {id: "theirs", onclick: () => settle(false)}, "take theirs, drop mine"), el("button", {id: "mine", onclick: () => settle(true)}, "keep mine, to be saved over theirs")]);
}

function draw() {
  bar();
  blocks.draw(variant(), chosen && blocks.keyOf(chosen.role, chosen.id), choose);
  inspect();
  check();
  texts(false);
  scm.draw(variant());
}

// ---- the page ----

onChange(draw);
for (const button of document.querySelectorAll("#lower nav [data-tab]")) button.addEventListener("click", () => tab(button.dataset.tab));
$("variant").addEventListener("change", (event) => { variantKey = event.target.value || null; chosen = variantKey ? null : {role: "", id: ""}; draw(); });
$("undo").addEventListener("click", undo); $("redo").addEventListener("click", redo); $("save").addEventListener("click", save);
document.addEventListener("keydown", (event) => {
  if (!event.ctrlKey && !event.metaKey) return;
  const typed = event.target.matches("input, textarea");
  if (event.key === "s") { event.preventDefault(); document.activeElement?.blur(); setTimeout(save, 350); }
  if (event.key === "z" && !typed) { event.preventDefault(); undo(); }
  if (event.key === "Z" && !typed) { event.preventDefault(); redo(); }
});
addEventListener("resize", draw);
wireText();
blocks.keys(variant, choose);
await start();
