// SPDX-License-Identifier: Apache-2.0
// What the trees of the files say, and which changes a change of a name asks for. A scalar is a text or {'"': text}.
import {state} from "./designer-state.js";

export const text = (value) => (value === null || value === undefined ? "" : typeof value === "object" && '"' in value ? value['"'] : String(value));
export const isScalar = (value) => value === null || typeof value !== "object" || (!Array.isArray(value) && Object.keys(value).length === 1 && '"' in value);
const list = (value) => (Array.isArray(value) ? value : []);
const entries = (value) => (value && typeof value === "object" && !Array.isArray(value) && !('"' in value) ? Object.entries(value) : []);
export {list, entries};

/** As YAML in one line, for fields. */
export function flow(value) {
  if (value === null || value === undefined) return "";
  if (Array.isArray(value)) return "[" + value.map(flow).join(", ") + "]";
  if (isScalar(value)) return typeof value === "object" ? JSON.stringify(value['"']) : /[,[\]{}#:?"'\\]|^[-?&*!|>%@`= ]|^$/.test(value) && !/^-?[\d.]+$/.test(value) ? JSON.stringify(value) : value;
  return "{" + entries(value).map(([key, one]) => `${key}: ${flow(one)}`).join(", ") + "}";
}

/** All of one kind over all files: [{name, file, path, value}]. */
export const all = (kind) => state.files.flatMap((file) => entries(file.tree?.[kind]).map(([name, value]) => ({name, file: file.name, path: [kind, name], value})));
export const one = (kind, name) => all(kind).find((it) => it.name === name);

export const variants = () => all("models").flatMap((model) => entries(model.value?.variants).map(([name, value]) => ({model: model.name, name, key: `${model.name} / ${name}`, file: model.file, path: [...model.path, "variants", name], value})));

/** Roles, and files that are one automaton. */
export function roles(variant) {
  const names = variant ? list(variant.value?.roles).map(text) : null;
  const found = all("roles").filter((role) => !names || names.includes(role.name)).map((role) => ({...role, block: role.value?.automaton, blockPath: [...role.path, "automaton"]}));
  const alone = names ? [] : state.files.filter((file) => file.tree && typeof file.tree === "object" && "block" in file.tree).map((file) => ({name: file.name, file: file.name, path: [], value: {}, block: file.tree, blockPath: []}));
  return [...found, ...alone];
}

export const kindOf = (componel) => (componel && typeof componel === "object" ? ["block", "task", "action"].find((kind) => kind in componel) : undefined);
export const idOf = (componel) => text(componel?.[kindOf(componel)]);

/** Every componel below and with a block: [{kind, id, value, path, parent}], parents first. */
export function componels(role) {
  const out = [];
  const visit = (value, path, parent) => {
    const kind = kindOf(value);
    if (!kind) return;
    const entry = {kind, id: idOf(value), value, path, parent, role};
    out.push(entry);
    list(value.content).forEach((item, i) => visit(item, [...path, "content", i], entry));
  };
  visit(role.block, role.blockPath, null);
  return out;
}

export function freshId(prefix, taken) {
  for (let n = 1; ; ++n) if (!taken.includes(prefix + n)) return prefix + n;
}

export const scmsOf = (variant) => entries(variant?.value?.coordination?.scms).map(([id, value]) => ({id, value, scm: text(value?.scm), path: [...variant.path, "coordination", "scms", id], file: variant.file}));

const spots = (value, path, visit) => {
  visit(value, path);
  if (Array.isArray(value)) value.forEach((item, i) => spots(item, [...path, i], visit));
  else entries(value).forEach(([key, item]) => spots(item, [...path, key], visit));
};

/** Every place in coordination tables where `is(value, path)` holds of a scalar, as edits that set it. */
const setWhere = (root, is, to) => {
  const edits = [];
  spots(root.value, root.path, (value, path) => { if (value !== null && isScalar(value) && is(text(value), path)) edits.push({file: root.file, set: path, value: to}); });
  return edits;
};

/** A componel of a role gets another id: in its conditions, in correspondences, where SCMs hold. */
export function renameComponel(role, componel, to) {
  const edits = [{file: role.file, set: [...componel.path, componel.kind], value: to}];
  spots(role.block, role.blockPath, (value, path) => {
    const key = path[path.length - 1];
    if (value === null || !isScalar(value)) return;
    if (key === "componel" && text(value) === componel.id) edits.push({file: role.file, set: path, value: to});
    if (key === "since" && text(value).startsWith(componel.id + ":")) edits.push({file: role.file, set: path, value: {'"': to + text(value).slice(componel.id.length)}});
  });
  for (const variant of variants()) {
    const table = variant.value?.coordination;
    list(table?.actions).forEach((entry, i) => {
      const at = [...variant.path, "coordination", "actions", i];
      if (text(entry?.role) === role.name && text(entry?.action) === componel.id) edits.push({file: variant.file, set: [...at, "action"], value: to});
      if (text(entry?.with) === role.name && text(entry?.target) === componel.id) edits.push({file: variant.file, set: [...at, "target"], value: to});
    });
    for (const [scm, where] of entries(table?.blocks)) list(where?.[role.name]).forEach((id, i) => { if (text(id) === componel.id) edits.push({file: variant.file, set: [...variant.path, "coordination", "blocks", scm, role.name, i], value: to}); });
  }
  return edits;
}

/** A role gets another name: in the variants that have it. */
export function renameRole(role, to) {
  const edits = [];
  for (const variant of variants().filter((one) => list(one.value?.roles).map(text).includes(role.name))) {
    const table = variant.value?.coordination ?? {};
    edits.push(...setWhere({file: variant.file, path: [...variant.path, "roles"], value: variant.value.roles}, (value) => value === role.name, to));
    edits.push(...setWhere({file: variant.file, path: [...variant.path, "by-ground"], value: variant.value["by-ground"] ?? []}, (value) => value === role.name, to));
    edits.push(...setWhere({file: variant.file, path: [...variant.path, "coordination", "actions"], value: table.actions ?? []}, (value, path) => value === role.name && ["role", "with"].includes(path[path.length - 1]), to));
    edits.push(...setWhere({file: variant.file, path: [...variant.path, "coordination", "scms"], value: table.scms ?? {}}, (value, path) => value === role.name && path[path.length - 1] !== "scm", to));
    for (const kind of ["arity", "parameters"]) if (role.name in (table[kind] ?? {})) edits.push({file: variant.file, rename: [...variant.path, "coordination", kind, role.name], key: to});
    for (const [scm, where] of entries(table.blocks)) if (where && role.name in where) edits.push({file: variant.file, rename: [...variant.path, "coordination", "blocks", scm, role.name], key: to});
  }
  edits.push({file: role.file, rename: role.path, key: to});
  return edits;
}

/** A value that may be there or not: set, inserted, or, when it says nothing, removed. */
export function put(file, around, path, key, value) {
  const is = around && typeof around === "object" && key in around;
  const nothing = value === null || value === undefined || value === "" || (Array.isArray(value) && !value.length) || (typeof value === "object" && !Array.isArray(value) && !Object.keys(value).length);
  if (nothing) return is ? [{file, remove: [...path, key]}] : [];
  return [is ? {file, set: [...path, key], value} : {file, insert: path, key, index: indexOf(key, around), value}];
}

const order = ["block", "task", "action", "type", "modality", "end", "pre", "exit", "local", "scms", "in", "out", "params", "content"];
function indexOf(key, around) {
  const rank = order.indexOf(key), keys = Object.keys(around ?? {});
  if (rank < 0) return keys.length;
  const after = keys.findIndex((other) => order.indexOf(other) > rank);
  return after < 0 ? keys.length : after;
}
