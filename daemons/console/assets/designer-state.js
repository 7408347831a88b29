// SPDX-License-Identifier: Apache-2.0
// The texts under way, and what the server makes of them. The page changes values; the server changes the text.

export const state = {
  files: [],            // {name, text, disk, tree}; tree null: no YAML
  saved: new Map(),     // name -> text as it was read or saved last
  base: new Map(),      // name -> hash of that on the disk
  check: {right: true, errors: []},
  refused: "",          // why the last change could not be made
  conflicts: [],        // files that somebody else has changed
  connected: false,
  version: 0,           // of everything
};
const undone = [], done = [];   // texts, each a Map of those that are not saved
let texts = new Map();
let last = Promise.resolve();
const listeners = [];

export const onChange = (listener) => listeners.push(listener);
export const file = (name) => state.files.find((one) => one.name === name);
export const isUnsaved = (name) => texts.has(name);
export const unsaved = () => [...texts.keys()];
export const canUndo = () => done.length > 0;
export const canRedo = () => undone.length > 0;
export const currentTexts = () => Object.fromEntries(texts);

function changed() {
  state.version += 1;
  for (const listener of listeners) listener();
}

/** A question after the ones before it have been answered. */
function queue(work) {
  last = last.then(work).catch((error) => { state.refused = error.message; state.connected = false; changed(); });
  return last;
}

export async function post(path, body) {
  const response = await fetch("/api/designer/" + path, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body)});
  const said = await response.json();
  state.connected = true;
  if (!response.ok && response.status !== 409) throw new Error((said.problems ?? ["refused"]).join("; "));
  return {...said, status: response.status};
}

function take(said) {
  state.files = said.files;
  state.check = said.check;
  const now = new Map();
  for (const one of said.files) {
    if (!state.base.has(one.name)) {
      state.base.set(one.name, one.disk);
      state.saved.set(one.name, texts.has(one.name) ? (one.disk ? null : "") : one.text);
    }
    if (one.text !== state.saved.get(one.name)) now.set(one.name, one.text);
  }
  // What is no longer used keeps its text until it is saved or undone.
  for (const [name, text] of texts) if (!file(name)) now.set(name, text);
  texts = now;
}

const same = (a, b) => a.size === b.size && [...a].every(([name, text]) => b.get(name) === text);

/** Changes of values: [{file, set|insert|remove|rename|move: path, …}], one step for undo. */
export const edit = (edits) => queue(async () => {
  const before = new Map(texts);
  const said = await post("look", {texts: currentTexts(), edits});
  state.refused = said.refused ?? "";
  if (!said.refused) take(said);
  if (!same(before, texts)) { done.push(before); undone.length = 0; }
  changed();
  return !said.refused;
});

/** The text of a file, as it was typed. */
export const setText = (name, text) => queue(async () => {
  const before = new Map(texts);
  texts.set(name, text);
  state.refused = "";
  take(await post("look", {texts: currentTexts()}));
  if (!same(before, texts)) { done.push(before); undone.length = 0; }
  changed();
});

const goTo = (from, to) => queue(async () => {
  if (!from.length) return;
  to.push(new Map(texts));
  texts = from.pop();
  state.refused = "";
  take(await post("look", {texts: currentTexts()}));
  changed();
});
export const undo = () => goTo(done, undone);
export const redo = () => goTo(undone, done);

export const save = () => queue(async () => {
  const names = unsaved();
  if (!names.length) return;
  const said = await post("save", {files: names.map((name) => ({name, text: texts.get(name), base: state.base.get(name) ?? ""}))});
  if (said.status === 409) {
    state.conflicts = said.conflicts;
  } else {
    for (const [name, hash] of Object.entries(said.files)) { state.base.set(name, hash); state.saved.set(name, texts.get(name)); }
    texts = new Map();
    state.conflicts = [];
    take(await post("look", {texts: {}}));
  }
  changed();
});

/** After a conflict: what is on the disk counts, or what is here, which is saved over it only when it is asked for again. */
export const settle = (mine) => queue(async () => {
  const disk = await (await fetch("/api/designer/disk")).json();
  for (const name of state.conflicts) {
    state.base.set(name, disk.files[name] ?? "");
    if (!mine) { texts.delete(name); state.saved.delete(name); state.base.delete(name); } else state.saved.set(name, null);
  }
  if (!mine) done.length = undone.length = 0;
  state.conflicts = [];
  take(await post("look", {texts: currentTexts()}));
  changed();
});

/** Whether somebody else has saved meanwhile. */
async function watch() {
  try {
    const disk = await (await fetch("/api/designer/disk")).json();
    const were = state.connected;
    state.connected = true;
    const others = Object.entries(disk.files).filter(([name, hash]) => state.base.has(name) && state.base.get(name) !== hash).map(([name]) => name);
    const fresh = others.filter((name) => !isUnsaved(name));
    if (fresh.length) {   // nothing of ours is lost
      await queue(async () => {
        for (const name of fresh) { state.base.delete(name); state.saved.delete(name); }
        take(await post("look", {texts: currentTexts()}));
        changed();
      });
    }
    const clash = others.filter(isUnsaved);
    if (!were || clash.join() !== state.conflicts.join()) { state.conflicts = clash; changed(); }
  } catch {
    if (state.connected) { state.connected = false; changed(); }
  }
}

export async function start() {
  if (location.hash.startsWith("#token=")) {
    await fetch("/api/session", {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify({token: location.hash.slice(7)})});
    history.replaceState(null, "", location.pathname);
  }
  await queue(async () => { take(await post("look", {texts: {}})); changed(); });
  setInterval(watch, 2000);
  addEventListener("beforeunload", (event) => { if (texts.size) event.preventDefault(); });
}
