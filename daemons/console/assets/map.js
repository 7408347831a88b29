// SPDX-License-Identifier: Apache-2.0
// The map: relief, areas, what is believed of fires, ways and looks of UAVs, links, UAVs.
import {$, el, seconds} from "./dom.js";
import * as constraints from "./constraints.js";
import {jointOf, model, nameOf, now, patience, placeOf, roleIn} from "./feed.js";
import * as rasters from "./rasters.js";
import {drawRelief, heightAt} from "./relief.js";

const canvas = $("map");
let g = canvas.getContext("2d");   // what is drawn on: this, or the backdrop
export const view = {x: 0, y: 0, scale: 1, fitted: false, chosen: null, follow: false, layers: {belief: true, plans: true, trails: true, looks: true, links: true, joint: true}};
let relief = null;
let tool = null;   // {hint, points, closed, done, one}
let mouse = null;
let taken = [];   // [left, top, right, bottom] of what is written in this picture

const screen = (x, y) => [(x - view.x) * view.scale + canvas.clientWidth / 2, canvas.clientHeight / 2 - (y - view.y) * view.scale];
const ground = (px, py) => [(px - canvas.clientWidth / 2) / view.scale + view.x, view.y - (py - canvas.clientHeight / 2) / view.scale];

// ---- marks ----

function path(points, closed = false) {
  g.beginPath();
  points.forEach(([x, y], i) => { const [px, py] = screen(x, y); i ? g.lineTo(px, py) : g.moveTo(px, py); });
  if (closed) g.closePath();
}

function text(words, px, py, {colour = "#fff", align = "left", size = 11, bold = false} = {}) {
  g.font = `${bold ? "600 " : ""}${size}px "DejaVu Sans", sans-serif`;
  g.textAlign = align;
  g.lineWidth = 3;
  g.lineJoin = "round";
  g.strokeStyle = "rgba(12,15,19,.85)";
  g.strokeText(words, px, py);
  g.fillStyle = colour;
  g.fillText(words, px, py);
}

const pairs = (flat, step) => { const out = []; for (let i = 0; i + step - 1 < flat.length; i += step) out.push([flat[i], flat[i + 1]]); return out; };
const centre = (points) => [points.reduce((s, p) => s + p[0], 0) / points.length, points.reduce((s, p) => s + p[1], 0) / points.length];

let hatch = null;
function hatching() {
  if (hatch) return hatch;
  const tile = el("canvas", {width: 10, height: 10});
  const t = tile.getContext("2d");
  t.strokeStyle = "rgba(214,69,32,.75)";
  t.lineWidth = 2;
  t.beginPath(); t.moveTo(-2, 12); t.lineTo(12, -2); t.moveTo(-2, 2); t.lineTo(2, -2); t.moveTo(8, 12); t.lineTo(12, 8); t.stroke();
  hatch = g.createPattern(tile, "repeat");
  return hatch;
}

function areas() {
  for (const zone of model.world.zones) {
    path(zone.polygon, true);
    g.fillStyle = "rgba(255,255,255,.07)"; g.fill();
    g.setLineDash([7, 5]); g.lineWidth = 1.5; g.strokeStyle = "rgba(255,255,255,.8)"; g.stroke(); g.setLineDash([]);
    const [px, py] = screen(...centre(zone.polygon));
    text(zone.name, px, py, {align: "center", size: 12, colour: "rgba(255,255,255,.9)"});
  }
  const live = (model.ground?.air ?? []).filter((air) => (seconds(air.until) ?? Infinity) > now());
  const names = new Set(live.map((air) => air.name));
  const all = [...model.world.air.filter((air) => !names.has(air.name)), ...live.map((air) => ({...air, polygon: pairs(air.corners, 2)}))];
  for (const air of all) {
    path(air.polygon, true);
    g.fillStyle = hatching(); g.fill();
    g.lineWidth = 2; g.strokeStyle = "#d64520"; g.stroke();
    const [px, py] = screen(...centre(air.polygon));
    text("closed: " + air.name, px, py, {align: "center", colour: "#ffd3c4"});
  }
  for (const place of model.world.places) {
    const [px, py] = screen(place.at[0], place.at[1]);
    g.fillStyle = "rgba(255,255,255,.9)"; g.fillRect(px - 2.5, py - 2.5, 5, 5);
    g.lineWidth = 1; g.strokeStyle = "#222"; g.strokeRect(px - 2.5, py - 2.5, 5, 5);
  }
}

const alarmLooks = {raised: ["#f0a030", "?"], confirmed: ["#e8451c", "!"], infirmed: ["#8d96a3", "×"]};

function alarms() {
  for (const alarm of model.ground?.alarms ?? []) {
    const [px, py] = screen(alarm.position.x, alarm.position.y);
    const [colour, sign] = alarmLooks[alarm.state] ?? ["#fff", "?"];
    const spread = Math.max(alarm.radius * view.scale, 11);
    const gradient = g.createRadialGradient(px, py, 2, px, py, spread * 2.2);
    gradient.addColorStop(0, colour + "b0"); gradient.addColorStop(1, colour + "00");
    if (alarm.state !== "infirmed") { g.fillStyle = gradient; g.beginPath(); g.arc(px, py, spread * 2.2, 0, 7); g.fill(); }
    g.beginPath(); g.moveTo(px, py - 13); g.lineTo(px + 12, py + 8); g.lineTo(px - 12, py + 8); g.closePath();
    g.fillStyle = colour; g.fill(); g.lineWidth = 2; g.strokeStyle = "#1b0f0a"; g.stroke();
    g.font = "700 13px DejaVu Sans, sans-serif"; g.textAlign = "center"; g.fillStyle = "#140a06"; g.fillText(sign, px, py + 6);
    g.beginPath(); g.arc(px, py, 18, -Math.PI / 2, -Math.PI / 2 + 2 * Math.PI * alarm.belief); g.lineWidth = 3; g.strokeStyle = colour; g.stroke();
    const right = px > canvas.clientWidth - 230;
    text(`alarm ${alarm.id} ${alarm.state}, belief ${(alarm.belief * 100).toFixed(0)} %`, px + (right ? -23 : 23), py + 4, {align: right ? "right" : "left"});
    taken.push(right ? [px - 210, py - 14, px + 15, py + 14] : [px - 15, py - 14, px + 210, py + 14]);
  }
}

// ---- UAVs ----

function links() {
  const places = new Map([["ground", {x: model.world.ground[0], y: model.world.ground[1]}]]);
  for (const one of model.uavs.values()) { const at = placeOf(one); if (at) places.set(one.name, at); }
  const drawn = new Map();
  for (const link of model.links.values()) {
    const ends = [nameOf(link.from), nameOf(link.to)].sort();
    const key = ends.join("|");
    const known = drawn.get(key) ?? {ends, up: true, loss: 0};
    known.up = known.up && link.up; known.loss = Math.max(known.loss, link.loss);
    drawn.set(key, known);
  }
  for (const {ends, up, loss} of drawn.values()) {
    const a = places.get(ends[0]), b = places.get(ends[1]);
    if (!a || !b) continue;
    const [ax, ay] = screen(a.x, a.y), [bx, by] = screen(b.x, b.y);
    g.beginPath(); g.moveTo(ax, ay); g.lineTo(bx, by);
    g.setLineDash(up ? [] : [3, 6]);
    g.lineWidth = up ? Math.max(0.7, 1.6 - 3 * loss) : 1.6;
    g.strokeStyle = up ? "rgba(235,245,255,.38)" : "rgba(240,90,50,.9)";
    g.stroke(); g.setLineDash([]);
    if (!up) { const mx = (ax + bx) / 2, my = (ay + by) / 2; text("✕", mx, my + 5, {align: "center", size: 14, colour: "#ff8a5c", bold: true}); }
  }
  const [px, py] = screen(...model.world.ground);
  g.fillStyle = "#f4f6f8"; g.strokeStyle = "#111"; g.lineWidth = 1.5;
  g.beginPath(); g.moveTo(px, py - 9); g.lineTo(px + 7, py + 6); g.lineTo(px - 7, py + 6); g.closePath(); g.fill(); g.stroke();
  text("ground", px + 9, py + 5, {size: 10});
}

function plans(one) {
  const tasks = one.tasks;
  if (!tasks) return;
  const states = new Map(tasks.tasks.map((task) => [task.id, task.state]));
  for (const entry of tasks.plan) {
    const state = states.get(entry.id);
    if (!entry.way.length || state === "ended" || state === "aborted") continue;
    const points = pairs(entry.way, 3);
    path(points);
    g.lineJoin = "round";
    g.lineWidth = entry.committed ? 3 : 1.8; g.strokeStyle = "rgba(15,18,22,.55)"; g.setLineDash([]); g.lineWidth += 2; g.stroke();
    path(points);
    g.lineWidth = entry.committed ? 2.4 : 1.4; g.setLineDash(entry.committed ? [] : [6, 5]); g.strokeStyle = one.colour; g.globalAlpha = state === "running" ? 1 : 0.75; g.stroke();
    g.setLineDash([]); g.globalAlpha = 1;
    const [ex, ey] = screen(...points[points.length - 1]);
    g.beginPath(); g.arc(ex, ey, 3, 0, 7); g.fillStyle = one.colour; g.fill();
  }
}

const kBands = 8;   // of a trail, each paler than the next

function trail(one) {
  const points = pairs(one.trail, 2).slice(-500), at = placeOf(one);
  if (at) points.push([at.x, at.y]);
  const each = Math.ceil(points.length / kBands);
  for (let from = 0; from + 1 < points.length; from += each) {
    path(points.slice(from, from + each + 1));
    g.lineWidth = 1.8; g.globalAlpha = 0.15 + 0.6 * (Math.min(points.length, from + each) / points.length) ** 2; g.strokeStyle = one.colour; g.lineJoin = "round"; g.stroke();
  }
  g.globalAlpha = 1;
}

/** Where the cone of a look meets the ground below, taken as level there. */
function footprint(look) {
  const d = look.view_direction, p = look.viewpoint, ground = heightAt(p.x + d.x * 30, p.y + d.y * 30);
  const height = Math.max(1, p.z - ground);
  const side = Math.hypot(d.x, d.y) > 1e-6 ? [-d.y / Math.hypot(d.x, d.y), d.x / Math.hypot(d.x, d.y), 0] : [1, 0, 0];
  const up = [d.y * side[2] - d.z * side[1], d.z * side[0] - d.x * side[2], d.x * side[1] - d.y * side[0]];
  const t = Math.tan(Math.min(look.aperture, 1.4)), out = [];
  for (let k = 0; k < 28; k += 1) {
    const a = (k / 28) * 2 * Math.PI, c = Math.cos(a) * t, s = Math.sin(a) * t;
    const ray = [d.x + side[0] * c + up[0] * s, d.y + side[1] * c + up[1] * s, d.z + side[2] * c + up[2] * s];
    const n = Math.hypot(...ray), reach = ray[2] < -1e-3 ? Math.min(look.range, (height / -ray[2]) * n) : look.range;
    out.push([p.x + (ray[0] / n) * reach, p.y + (ray[1] / n) * reach]);
  }
  return out;
}

function looks() {
  for (const look of model.looks.values()) {
    const age = now() - look.at;
    if (age > 3 || age < -1) continue;
    const colour = model.uavs.get(look.uav)?.colour ?? "#fff";
    path(footprint(look), true);
    g.globalAlpha = 0.28 * (1 - Math.max(0, age) / 3); g.fillStyle = colour; g.fill();
    g.globalAlpha *= 2; g.lineWidth = 1; g.strokeStyle = "#fff"; g.stroke();
    g.globalAlpha = 1;
  }
}

function uav(one) {
  const at = placeOf(one);
  if (!at) return;
  const [px, py] = screen(at.x, at.y);
  const stale = now() - at.at > patience() || one.board?.reachable === false;
  if (one.name === view.chosen) { g.beginPath(); g.arc(px, py, 21, 0, 7); g.lineWidth = 2; g.strokeStyle = "#fff"; g.stroke(); }
  if (one.board?.holder) { g.beginPath(); g.arc(px, py, 17, 0, 7); g.lineWidth = 3; g.setLineDash([5, 4]); g.strokeStyle = "#56b4e9"; g.stroke(); g.setLineDash([]); }
  g.save();
  g.translate(px, py);
  g.rotate(-at.heading);
  g.beginPath(); g.moveTo(14, 0); g.lineTo(-9, 9); g.lineTo(-4, 0); g.lineTo(-9, -9); g.closePath();
  g.lineWidth = 4; g.strokeStyle = "rgba(10,12,15,.9)"; g.lineJoin = "round"; g.stroke();
  g.fillStyle = stale ? "#6d7681" : one.colour; g.fill();
  g.lineWidth = 1.3; g.strokeStyle = stale ? one.colour : "#fff"; g.stroke();
  g.restore();
}

// ---- what stands beside UAVs: on no other, as far as there is room ----


const isFree = ([left, top, right, bottom]) => !taken.some((one) => left < one[2] && right > one[0] && top < one[3] && bottom > one[1]);

function linesOf(one, at) {
  const stale = now() - at.at > patience() || one.board?.reachable === false, speed = Math.hypot(at.v.x, at.v.y, at.v.z);
  const lines = [{words: one.name, bold: true, size: 12, colour: stale ? "#c4cad2" : "#fff"}];
  lines.push(stale ? {words: `last heard ${(now() - at.at).toFixed(0)} s ago`, size: 10, colour: "#ffb08a"}
    : {words: `${(at.z - heightAt(at.x, at.y)).toFixed(0)} m  ${speed.toFixed(0)} m/s`, size: 10, colour: "#e8edf3"});
  if (view.layers.joint) for (const state of jointOf(one)) if (roleIn(state)) lines.push({words: roleIn(state), size: 10, colour: "#f0e442"});
  return lines;
}

/** At the right, the left, below or above; where there is no room only its name is there. */
function name(one) {
  const at = placeOf(one);
  if (!at) return;
  const [px, py] = screen(at.x, at.y);
  for (let lines = linesOf(one, at); ; lines = lines.slice(0, 1)) {
    const width = Math.max(...lines.map(({words, size}) => words.length * size * 0.62)), high = lines.length * 13, last = lines.length === 1 && one.name !== view.chosen;
    const box = [[px + 18, py - 15], [px - 18 - width, py - 15], [px - width / 2, py + 17], [px - width / 2, py - 19 - high]]
      .map(([x, y]) => [x, y, x + width, y + high]).find(isFree) ?? (last ? [px + 14, py - 15, px + 14 + width, py - 2] : null);
    if (!box && lines.length > 1 && one.name !== view.chosen) continue;
    const [left, top] = box ?? [px + 18, py - 15];
    taken.push([left, top, left + width, top + high]);
    lines.forEach(({words, ...looks}, i) => text(words, left, top + 10 + 13 * i, looks));
    return;
  }
}

function names(all) {
  taken.push(...all.map(placeOf).filter(Boolean).map((at) => { const [px, py] = screen(at.x, at.y); return [px - 12, py - 12, px + 12, py + 12]; }));
  const chosen = all.filter((one) => one.name === view.chosen);
  [...chosen, ...all.filter((one) => one.name !== view.chosen)].forEach(name);
  for (const {name: words, at} of view.scale > 0.35 ? model.world.places : []) {
    const [px, py] = screen(at[0], at[1]), box = [px + 6, py - 6, px + 6 + words.length * 6.2, py + 6];
    if (!isFree(box)) continue;
    taken.push(box);
    text(words, px + 6, py + 4, {size: 10, colour: "rgba(255,255,255,.85)"});
  }
}

/** Who does something together is tied together; a spatial constraint that does not hold is named between them. */
function jointTasks(all) {
  const groups = new Map();   // subject -> {members: [[x, y]], violated}
  for (const one of all) {
    const at = placeOf(one);
    if (!at) continue;
    for (const state of jointOf(one)) {
      const group = groups.get(state.subject) ?? groups.set(state.subject, {members: [], violated: new Set()}).get(state.subject);
      group.members.push(screen(at.x, at.y));
      state.violated.forEach((name) => group.violated.add(name));
    }
  }
  for (const {members, violated} of groups.values()) {
    if (members.length < 2) continue;
    const bad = violated.size > 0;
    for (let i = 0; i < members.length; i += 1) {
      for (let j = i + 1; j < members.length; j += 1) {
        g.beginPath(); g.moveTo(...members[i]); g.lineTo(...members[j]);
        g.setLineDash(bad ? [2, 4] : [9, 5]); g.lineWidth = bad ? 3 : 2; g.strokeStyle = bad ? "#e8672c" : "rgba(240,228,66,.75)"; g.stroke(); g.setLineDash([]);
      }
    }
    const [mx, my] = centre(members);
    if (bad) text(`${[...violated].join(", ")}: does not hold`, mx, my - 6, {align: "center", colour: "#ff9a6b", bold: true});
  }
}

function scale() {
  const length = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000].find((one) => one * view.scale > 60) ?? 10000;
  const bar = $("scale");
  bar.style.width = length * view.scale + "px";
  bar.textContent = length < 1000 ? length + " m" : length / 1000 + " km";
}

export function fit() {
  const t = model.world.terrain;
  const xs = [], ys = [];
  const add = (x, y) => { xs.push(x); ys.push(y); };
  for (const zone of model.world.zones) zone.polygon.forEach((p) => add(...p));
  for (const place of model.world.places) add(place.at[0], place.at[1]);
  for (const one of model.uavs.values()) { const at = placeOf(one); at ? add(at.x, at.y) : one.start && add(...one.start); }
  for (const alarm of model.ground?.alarms ?? []) add(alarm.position.x, alarm.position.y);
  add(model.world.ground[0], model.world.ground[1]);
  if (xs.length < 2) { add(t.west, t.south); add(t.east, t.north); }
  const least = [Math.min(...xs), Math.min(...ys)], most = [Math.max(...xs), Math.max(...ys)];
  view.x = (least[0] + most[0]) / 2; view.y = (least[1] + most[1]) / 2;
  view.scale = 0.82 * Math.min(canvas.clientWidth / Math.max(100, most[0] - least[0]), canvas.clientHeight / Math.max(100, most[1] - least[1]));
  view.fitted = true;
}

function drawTool() {
  if (!tool) return;
  if (document.activeElement === canvas) {   // where the space bar puts a point
    const x = canvas.clientWidth / 2, y = canvas.clientHeight / 2;
    g.lineWidth = 1.5; g.strokeStyle = "#fff"; g.beginPath(); g.moveTo(x - 9, y); g.lineTo(x + 9, y); g.moveTo(x, y - 9); g.lineTo(x, y + 9); g.stroke();
  }
  const points = mouse && !tool.one ? [...tool.points, mouse] : tool.points;
  if (points.length) {
    path(points, tool.closed);
    g.lineWidth = 2; g.setLineDash([6, 4]); g.strokeStyle = "#fff"; g.stroke(); g.setLineDash([]);
    for (const p of tool.points) { const [px, py] = screen(...p); g.fillStyle = "#fff"; g.beginPath(); g.arc(px, py, 4, 0, 7); g.fill(); }
  }
}

/** A picture of the ground's grid, whose points are the middles of its pixels, or reach from border point to border point (`margin` 0). */
function overGround(b, picture, margin) {
  const t = model.world.terrain, [px, py] = screen(t.west - margin, t.south + (t.rows - 1) * t.step + margin);
  b.drawImage(picture, px, py, ((t.columns - 1) * t.step + 2 * margin) * view.scale, ((t.rows - 1) * t.step + 2 * margin) * view.scale);
}

/** The ground as it is seen, and planned ways: drawn again only when they or the view have changed, since they are most of the work. */
const backdrop = {canvas: el("canvas"), key: ""};

function paintBackdrop(over) {
  const b = backdrop.canvas.getContext("2d"), front = g, ratio = window.devicePixelRatio || 1;
  backdrop.canvas.width = canvas.width; backdrop.canvas.height = canvas.height;   // which clears it
  b.setTransform(ratio, 0, 0, ratio, 0, 0);
  b.fillStyle = "#2a3036"; b.fillRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  b.imageSmoothingQuality = "high";
  overGround(b, relief.picture, 0);
  for (const {picture} of over) overGround(b, picture, model.world.terrain.step / 2);
  if (!view.layers.plans) return;
  g = b;
  [...model.uavs.values()].forEach(plans);
  g = front;
}

function terrain() {
  relief ??= drawRelief(model.world.terrain);
  const over = rasters.pictures(view);
  const key = [view.x, view.y, view.scale, canvas.width, canvas.height, view.layers.plans, model.plansVersion, ...over.map((one) => one.version)].join();
  if (key !== backdrop.key) { backdrop.key = key; paintBackdrop(over); }
  g.setTransform(1, 0, 0, 1, 0, 0);
  g.drawImage(backdrop.canvas, 0, 0);
  const words = [relief.caption, ...over.map((one) => one.caption)].join("; ");
  if ($("legend").textContent !== words) $("legend").textContent = words;
}

export function draw() {
  const ratio = window.devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  if (!w || !h || !model.world) return;
  if (canvas.width !== Math.round(w * ratio) || canvas.height !== Math.round(h * ratio)) { canvas.width = Math.round(w * ratio); canvas.height = Math.round(h * ratio); }
  if (!view.fitted) fit();
  const chosen = model.uavs.get(view.chosen), at = chosen && placeOf(chosen);
  if (view.follow && at) { view.x = at.x; view.y = at.y; }
  taken = [];
  terrain();
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  areas();
  if (view.layers.looks) looks();
  if (view.layers.links) links();
  const all = [...model.uavs.values()];
  if (view.layers.trails) all.forEach(trail);
  if (view.layers.joint) { all.forEach((one) => constraints.draw(g, screen, view.scale, one, text)); jointTasks(all); }
  alarms();
  all.forEach(uav);
  names(all);
  drawTool();
  scale();
}

// ---- pointing ----

/** Lets points be picked: `done` gets them [[x, y], …]; Escape ends it without, and `left` is called. */
export function pick({hint, closed = false, one = false, done, left = () => {}}) {
  tool = {points: [], closed, one, done, left, hint};
  canvas.classList.add("picking");
  $("hint").hidden = false;
  $("hint").textContent = hint + (one ? " — click, or arrow keys and space; Esc: leave" : " — click, or arrow keys and space; double click or Enter: done, Esc: leave");
  canvas.focus();
}

function leave() {
  tool = null;
  canvas.classList.remove("picking");
  $("hint").hidden = true;
}

function finish() {
  const {done, points} = tool;
  leave();
  done(points);
}

export function nearest(px, py) {
  let best = null, least = 22;
  for (const one of model.uavs.values()) {
    const at = placeOf(one);
    if (!at) continue;
    const [x, y] = screen(at.x, at.y), d = Math.hypot(x - px, y - py);
    if (d < least) { least = d; best = one.name; }
  }
  return best;
}

export function wire(choose) {
  let from = null, moved = false;
  const here = (event) => [event.offsetX, event.offsetY];
  canvas.addEventListener("pointerdown", (event) => { from = here(event); moved = false; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointermove", (event) => {
    const p = here(event);
    mouse = ground(...p);
    if (!from || event.buttons === 0) return;
    if (!moved && Math.hypot(p[0] - from[0], p[1] - from[1]) < 4) return;
    moved = true;
    view.follow = false;
    view.x -= (p[0] - from[0]) / view.scale; view.y += (p[1] - from[1]) / view.scale;
    from = p;
  });
  canvas.addEventListener("pointerup", (event) => {
    from = null;
    if (moved) return;
    const p = here(event);
    if (!tool) { const name = nearest(...p); if (name) choose(name); return; }
    tool.points.push(ground(...p).map((v) => Math.round(v * 10) / 10));
    if (tool.one) finish();
  });
  canvas.addEventListener("dblclick", () => { if (tool && !tool.one) { tool.points.pop(); finish(); } });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const before = ground(...here(event));
    view.scale = Math.min(20, Math.max(0.02, view.scale * Math.exp(-event.deltaY * 0.0015)));
    const after = ground(...here(event));
    view.x += before[0] - after[0]; view.y += before[1] - after[1];
  }, {passive: false});
  window.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && tool) { const {left} = tool; leave(); left(); }
    if (event.key === "Enter" && tool && !tool.one && document.activeElement === canvas) {
      event.preventDefault();   // else the same key presses what `done` opens
      return finish();
    }
    if (document.activeElement !== canvas) return;
    if (event.key === " " && tool) {   // a point in the middle, where the cross is
      tool.points.push(ground(canvas.clientWidth / 2, canvas.clientHeight / 2).map((v) => Math.round(v * 10) / 10));
      event.preventDefault();
      if (tool.one) return finish();
    }
    const step = 60 / view.scale, keys = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step]};
    if (keys[event.key]) { view.x += keys[event.key][0]; view.y += keys[event.key][1]; view.follow = false; event.preventDefault(); }
    if (event.key === "+") view.scale *= 1.2;
    if (event.key === "-") view.scale /= 1.2;
    if (event.key === "0") fit();
  });
}
