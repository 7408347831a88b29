// SPDX-License-Identifier: Apache-2.0
// Spatial constraints: places laid out on a map, figures picked on it, and where all of it holds.
import {$, el} from "./dom.js";
import {currentTexts, edit, post, state} from "./designer-state.js";
import {all, entries, flow, freshId, isScalar, list, one, scmsOf, text} from "./designer-model.js";

const view = {instance: null, armed: null, altitude: 40, reach: 150, where: new Map(), rows: null, asked: "", refused: ""};
let dragging = null;

const isNumber = (scm, name) => text(scm?.value?.parameters?.[name]) === "Number";
const places = (scm) => entries(scm?.value?.parameters).filter(([, kind]) => text(kind) === "Place").map(([name]) => name);
const numbers = (scm) => entries(scm?.value?.parameters).filter(([, kind]) => text(kind) === "Number").map(([name]) => name);

/** Until it is dragged elsewhere: what comes first in the middle, the others around. */
function spot(instance, name, i) {
  const key = instance.id + " " + name;
  if (!view.where.has(key)) view.where.set(key, i === 0 ? [0, 0, 0] : [70 * Math.cos(Math.PI - i * 0.9), 70 * Math.sin(Math.PI - i * 0.9), 0]);
  return view.where.get(key);
}

const scale = (canvas) => Math.min(canvas.clientWidth, canvas.clientHeight) / (2 * view.reach);
const toScreen = (canvas, [x, y]) => [canvas.clientWidth / 2 + x * scale(canvas), canvas.clientHeight / 2 - y * scale(canvas)];
const toWorld = (canvas, x, y) => [(x - canvas.clientWidth / 2) / scale(canvas), (canvas.clientHeight / 2 - y) / scale(canvas)];
const round = (value, digits) => String(Number(value.toFixed(digits)));

/** What a figure would be if the UAV held it just at this place: as the constraint that uses it measures. */
function measured(instance, scm, name, [x, y]) {
  const constraint = list(scm.value?.constraints).find((it) => text(it?.than) === name);
  if (!constraint) return null;
  const at = (place) => spot(instance, place, places(scm).indexOf(place));
  if ("distance-to" in constraint) {
    const p = at(text(constraint["distance-to"]));
    return round(Math.hypot(x - p[0], y - p[1], view.altitude - p[2]), 1);
  }
  const [origin, toward] = list(constraint.azimuth ?? constraint.altitude).map((place) => at(text(place)));
  if (!origin || !toward) return null;
  if ("azimuth" in constraint) {
    const angle = Math.atan2(y - origin[1], x - origin[0]) - Math.atan2(toward[1] - origin[1], toward[0] - origin[0]);
    return round((angle + 4 * Math.PI) % (2 * Math.PI), 3);
  }
  return round(Math.atan2(view.altitude - origin[2], Math.hypot(x - origin[0], y - origin[1])), 3);
}

function paint() {
  const canvas = document.querySelector("#scms canvas");
  if (!canvas || !canvas.clientWidth) return;
  canvas.width = canvas.clientWidth; canvas.height = canvas.clientHeight;
  const g = canvas.getContext("2d");
  g.fillStyle = "#20272f"; g.fillRect(0, 0, canvas.width, canvas.height);
  const instance = view.instance, scm = instance && one("scms", instance.scm);
  if (!scm) return;
  if (view.rows) {
    const step = (2 * view.reach) / view.rows.length, size = step * scale(canvas);
    g.fillStyle = "rgba(86, 180, 233, .45)";
    view.rows.forEach((row, y) => [...row].forEach((cell, x) => {
      if (cell !== "1") return;
      const [sx, sy] = toScreen(canvas, [-view.reach + x * step, -view.reach + (y + 1) * step]);
      g.fillRect(sx, sy, Math.ceil(size), Math.ceil(size));
    }));
  }
  g.font = "12px DejaVu Sans, sans-serif"; g.textAlign = "left";
  places(scm).forEach((name, i) => {
    const at = spot(instance, name, i), [x, y] = toScreen(canvas, at);
    for (const constraint of list(scm.value?.constraints)) {
      if (text(constraint?.["distance-to"]) !== name || !isNumber(scm, text(constraint.than))) continue;
      const height = view.altitude - at[2], radius = Math.sqrt(Math.max(0, Number(text(instance.value[text(constraint.than)])) ** 2 - height ** 2));
      g.setLineDash(["<", "<="].includes(text(constraint.is)) ? [] : [5, 4]); g.strokeStyle = "#f0e442"; g.lineWidth = 1.5;
      g.beginPath(); g.arc(x, y, radius * scale(canvas), 0, 2 * Math.PI); g.stroke(); g.setLineDash([]);
    }
    g.fillStyle = "#e69f00"; g.beginPath(); g.arc(x, y, 6, 0, 2 * Math.PI); g.fill();
    g.strokeStyle = "#14171c"; g.lineWidth = 3; g.strokeText(`${name} = ${text(instance.value[name])}`, x + 10, y + 4);
    g.fillStyle = "#fff"; g.fillText(`${name} = ${text(instance.value[name])}`, x + 10, y + 4);
  });
  g.fillStyle = "#98a3b3";
  g.fillText(view.refused || (view.armed ? `a click picks ${view.armed}` : `blue: where it holds ${view.altitude} m high; the whole is ${2 * view.reach} m wide; places can be dragged`), 8, canvas.height - 8);
}

/** Reckoned by the server, with the code that watches it in flight. */
async function reckon() {
  const instance = view.instance, scm = instance && one("scms", instance.scm);
  if (!scm) { view.rows = null; return paint(); }
  const cells = 72;
  const body = {
    scm: instance.scm, west: -view.reach, south: -view.reach, step: (2 * view.reach) / cells, columns: cells, rows: cells, altitude: view.altitude,
    places: Object.fromEntries(places(scm).map((name, i) => [name, [spot(instance, name, i)]])),
    numbers: Object.fromEntries(numbers(scm).map((name) => [name, Number(text(instance.value[name]))])),
  };
  const key = JSON.stringify(body) + state.version;
  if (key === view.asked) return paint();
  view.asked = key;
  try {
    const said = await post("scm", {...body, texts: currentTexts()});
    if (view.asked !== key) return;
    view.rows = said.rows; view.refused = "";
  } catch (error) {
    view.rows = null; view.refused = error.message;
  }
  paint();
}

function wire(canvas) {
  const nearest = (event) => {
    const scm = view.instance && one("scms", view.instance.scm);
    return places(scm).find((name, i) => { const [x, y] = toScreen(canvas, spot(view.instance, name, i)); return Math.hypot(x - event.offsetX, y - event.offsetY) < 14; });
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (!view.instance) return;
    const scm = one("scms", view.instance.scm), at = toWorld(canvas, event.offsetX, event.offsetY);
    if (view.armed) {
      const value = measured(view.instance, scm, view.armed, at);
      const name = view.armed;
      view.armed = null;
      if (value !== null) edit([{file: view.instance.file, set: [...view.instance.path, name], value}]);
      return;
    }
    dragging = nearest(event);
    if (dragging) canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!dragging) return;
    const [x, y] = toWorld(canvas, event.offsetX, event.offsetY);
    view.where.set(view.instance.id + " " + dragging, [Math.round(x), Math.round(y), 0]);
    paint();
  });
  canvas.addEventListener("pointerup", () => { if (dragging) { dragging = null; reckon(); } });
  canvas.addEventListener("wheel", (event) => { event.preventDefault(); view.reach = Math.min(2000, Math.max(20, view.reach * Math.exp(event.deltaY * 0.001))); reckon(); }, {passive: false});
}

function choose(value, options, onchange, label) {
  return el("select", {"aria-label": label, onchange: (event) => onchange(event.target.value)}, ...[...new Set([...options, value])].filter(Boolean).map((option) => el("option", {value: option, selected: option === value}, option)));
}

function instanceRow(variant, instance) {
  const scm = one("scms", instance.scm), is = view.instance?.id === instance.id;
  const whereabouts = [...Object.keys(variant.value?.parameters ?? {}), ...list(variant.value?.roles).map(text), "R*"];
  const set = (name, value) => edit([{file: instance.file, set: [...instance.path, name], value}]);
  return el("div", {className: "instance" + (is ? " chosen" : ""), "data-instance": instance.id, onclick: () => { if (!is) { view.instance = instance; draw(variant); } }},
    el("b", {}, instance.id), " ", el("span", {className: "who"}, instance.scm), " ",
    ...places(scm).map((name) => el("label", {}, ` ${name} `, choose(text(instance.value[name]), whereabouts, (value) => set(name, value), name))),
    ...numbers(scm).map((name) => el("label", {}, ` ${name} `, el("input", {className: "number", value: text(instance.value[name]), "aria-label": name, onchange: (event) => set(name, event.target.value)}),
      el("button", {className: "arms", title: `pick ${name} on the map`, "aria-pressed": String(is && view.armed === name), onclick: (event) => { event.stopPropagation(); view.instance = instance; view.armed = view.armed === name ? null : name; draw(variant); }}, "◎"))),
    el("button", {title: "remove", onclick: (event) => { event.stopPropagation(); remove(variant, instance); }}, "×"));
}

function remove(variant, instance) {
  const edits = [{file: instance.file, remove: instance.path}];
  if (instance.id in (variant.value?.coordination?.blocks ?? {})) edits.push({file: variant.file, remove: [...variant.path, "coordination", "blocks", instance.id]});
  view.instance = null;
  edit(edits);
}

function add(variant, name) {
  const scm = one("scms", name);
  if (!scm) return;
  const id = freshId("mcs", scmsOf(variant).map((it) => it.id)), table = variant.value?.coordination ?? {};
  const first = Object.keys(variant.value?.parameters ?? {})[0] ?? "R*";
  const value = {scm: name};
  for (const place of places(scm)) value[place] = place === "from" ? "R*" : first;
  for (const number of numbers(scm)) value[number] = "50";
  const at = [...variant.path, "coordination"];
  edit([table.scms ? {file: variant.file, insert: [...at, "scms"], key: id, value} : {file: variant.file, insert: at, key: "scms", value: {[id]: value}}]);
}

/** The constraints of a definition, which may lie in another file. */
function definition(scm) {
  const set = (i, key, value) => edit([{file: scm.file, set: [...scm.path, "constraints", i, key], value}]);
  const row = (constraint, i) => {
    const kind = ["distance-to", "azimuth", "altitude"].find((key) => constraint && key in constraint);
    const scalar = isScalar(constraint?.than);
    return el("div", {className: "literal", "data-constraint": i},
      choose(kind, ["distance-to", "azimuth", "altitude"], (to) => {
        const first = kind === "distance-to" ? text(constraint[kind]) : text(list(constraint[kind])[0]);
        const rest = Object.fromEntries(Object.entries(constraint).filter(([key]) => key !== kind));
        const two = [first, places(scm).find((name) => name !== first) ?? first];
        edit([{file: scm.file, set: [...scm.path, "constraints", i], value: {[to]: to === "distance-to" ? first : kind === "distance-to" ? two : constraint[kind], ...rest}}]);
      }, "quantity"),
      kind === "distance-to" ? choose(text(constraint[kind]), places(scm), (value) => set(i, kind, value), "place")
        : el("span", {}, ...[0, 1].map((k) => choose(text(list(constraint[kind])[k]), places(scm), (value) => edit([{file: scm.file, set: [...scm.path, "constraints", i, kind, k], value}]), k ? "azimuth 0" : "origin"))),
      choose(text(constraint?.is), ["<", "<=", "=", ">=", ">"], (value) => set(i, "is", {'"': value}), "relation"),
      el("input", {className: "number", value: flow(constraint?.than), "aria-label": "than", readOnly: !scalar, title: scalar ? "a number or a parameter" : "edit the text", onchange: (event) => set(i, "than", event.target.value)}),
      el("button", {title: "remove", onclick: () => edit([{file: scm.file, remove: [...scm.path, "constraints", i]}])}, "×"));
  };
  return el("details", {open: false}, el("summary", {}, `what ${scm.name} says (${scm.file})`), ...list(scm.value?.constraints).map(row),
    el("button", {onclick: () => edit([{file: scm.file, insert: [...scm.path, "constraints"], value: {"distance-to": places(scm)[0] ?? "R*", is: {'"': ">"}, than: numbers(scm)[0] ?? "10"}}])}, "another constraint"));
}

export function draw(variant) {
  const room = $("scms");
  if (room.hidden) return;
  const instances = scmsOf(variant);
  view.instance = instances.find((it) => it.id === view.instance?.id) ?? instances[0] ?? null;
  if (!room.querySelector("canvas")) {
    const canvas = el("canvas", {"aria-label": "where the SCM holds"});
    wire(canvas);
    room.replaceChildren(el("div", {className: "list"}), canvas);
  }
  const altitude = el("input", {className: "number", type: "number", value: String(view.altitude), onchange: (event) => { view.altitude = Number(event.target.value); reckon(); }});
  const kinds = el("select", {"aria-label": "SCM to add"}, ...all("scms").map((scm) => el("option", {value: scm.name}, scm.name)));
  room.querySelector(".list").replaceChildren(
    ...(variant ? instances.map((instance) => instanceRow(variant, instance)) : [el("p", {}, "no variant is chosen")]),
    variant ? el("div", {className: "rows"}, kinds, el("button", {onclick: () => add(variant, kinds.value)}, "add"), el("label", {}, " height on the map [m] ", altitude)) : "",
    ...(view.instance && one("scms", view.instance.scm) ? [definition(one("scms", view.instance.scm))] : []));
  reckon();
}
