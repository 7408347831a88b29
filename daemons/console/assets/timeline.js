// SPDX-License-Identifier: Apache-2.0
// The chronology: a row for each UAV, what its tasks did and what it means to do.
import {$, clockText, isOver, seconds} from "./dom.js";
import {model, now, roleIn} from "./feed.js";

const canvas = $("chronology");
const g = canvas.getContext("2d");
export const window_ = {span: 240, end: null};   // [s]; end null: goes with the time
const kName = 74, kTop = 18;
const kLeastRow = 20, kMostRow = 64;   // [px]; what has no room is scrolled to
const kTogether = 2;   // [s] between the ends of two tasks that synchronise with each other
let boxes = [];

const looks = {
  scheduled: {fill: "rgba(255,255,255,.06)", edge: "#77828f"},
  started: {fill: null, alpha: 0.55}, running: {fill: null, alpha: 0.95},
  aborting: {fill: "#b3541e"}, ended: {fill: null, alpha: 0.42}, aborted: {fill: null, alpha: 0.42},
};

/** What goes with the time does not show what was before the mission. */
function frame() {
  const to = window_.end ?? Math.max(window_.span, now() + window_.span * 0.35);
  return {from: to - window_.span, to};
}

/** What a row shows: each task's stretches, and what is planned ahead. */
function stretches(uav) {
  const out = [];
  for (const task of uav.marks.values()) {
    const last = task.states[task.states.length - 1];
    task.states.forEach(({state, at}, i) => {
      if (isOver(state) || state === "scheduled") return;
      const next = task.states[i + 1], past = isOver(last.state) && state !== "aborting";
      const shown = past ? (next === last && last.state === "aborted" ? "aborted" : "ended") : state;
      out.push({from: at, to: next ? next.at : now(), state: shown, task, open: !next});
    });
  }
  // What waits for its turn stands in line behind now.
  const known = new Set((uav.tasks?.plan ?? []).map((entry) => entry.id));
  const width = window_.span * 0.07;
  (uav.tasks?.tasks ?? []).filter((task) => task.state === "scheduled" && !task.lost && !known.has(task.id)).forEach((task, i) => {
    out.push({from: now() + width * (i + 0.15), to: now() + width * (i + 1), state: "scheduled", task, open: false, waits: true});
  });
  const begun = new Set([...uav.marks.values()].filter((task) => task.states.some((s) => s.state !== "scheduled")).map((task) => task.id));
  for (const entry of uav.tasks?.plan ?? []) {
    if (begun.has(entry.id)) continue;
    const from = seconds(entry.earliest_start), to = seconds(entry.earliest_end);
    out.push({from, to: Number.isFinite(to) && to > from ? to : from + 5, state: "planned", task: entry, planned: entry});
  }
  return out;
}

/** So many lanes that nothing that overlaps lies on each other. */
function lanes(list) {
  const ends = [];
  for (const one of list.sort((a, b) => a.from - b.from)) {
    let lane = ends.findIndex((end) => end <= one.from + 0.01);
    if (lane < 0) lane = ends.length;
    ends[lane] = one.to;
    one.lane = lane;
  }
  return Math.max(1, ends.length);
}

const keyOf = (from, to) => `${Math.round(2 * (seconds(from) ?? -1))} ${Math.round(2 * (seconds(to) ?? -1))}`;

/**
 * What the plan leaves open, inside of the box: above from the earliest start to the latest, below from the earliest end to the latest. The end is left out
 * where something else of the same UAV starts in just that window (`starts`): it would lie over that one's box and say the same.
 */
function windows({planned}, starts, colour, x, top, high, edge) {
  const line = (from, to, y) => {
    const a = seconds(from), b = seconds(to);
    if (a === null || b === null || b - a < 0.5) return;
    if (x(a) >= edge) return;
    const left = x(a), right = Number.isFinite(b) ? Math.min(x(b), edge + 9) : edge, open = right >= edge;
    g.beginPath(); g.moveTo(left, y); g.lineTo(right, y); g.moveTo(left, y - 2.5); g.lineTo(left, y + 2.5);
    if (open) { g.moveTo(edge - 6, y - 3); g.lineTo(edge - 1, y); g.lineTo(edge - 6, y + 3); } else { g.moveTo(right, y - 2.5); g.lineTo(right, y + 2.5); }
    g.lineWidth = 3; g.strokeStyle = "rgba(20,23,28,.9)"; g.stroke();
    g.lineWidth = 1.5; g.strokeStyle = colour; g.stroke();
  };
  line(planned.earliest_start, planned.latest_start, top + high * 0.2);
  if (!starts.has(keyOf(planned.earliest_end, planned.latest_end))) line(planned.earliest_end, planned.latest_end, top + high * 0.82);
}

/** Synchronise tasks of several UAVs that ended together, as two ends of a line each. */
function meetings() {
  const ends = boxes.filter(({one}) => one.task.type === "synchronise" && one.state === "ended");
  const pairs = [];
  ends.forEach((a, i) => ends.slice(i + 1).forEach((b) => { if (a.uav !== b.uav && Math.abs(a.one.to - b.one.to) < kTogether) pairs.push([a, b]); }));
  return pairs;
}

const roleOf = (uav, id) => [...uav.joint.values()].filter((state) => state.task === id).map(roleIn)[0] ?? "";

function box(one, colour, x, y, w, h) {
  g.globalAlpha = 1;
  if (one.state === "planned") {
    g.globalAlpha = 0.12; g.fillStyle = colour; g.fillRect(x, y, w, h);
    g.globalAlpha = 0.7; g.setLineDash([4, 3]); g.lineWidth = 1; g.strokeStyle = colour; g.strokeRect(x + 0.5, y + 0.5, w - 1, h - 1); g.setLineDash([]); g.globalAlpha = 1;
  } else {
    const look = looks[one.state] ?? looks.ended;
    g.globalAlpha = look.alpha ?? 1; g.fillStyle = look.fill ?? colour; g.fillRect(x, y, w, h); g.globalAlpha = 1;
    if (look.edge) { g.lineWidth = 1; g.strokeStyle = look.edge; g.strokeRect(x + 0.5, y + 0.5, w - 1, h - 1); }
    if (one.state === "aborted") { g.strokeStyle = "#ff9a6b"; g.lineWidth = 2; g.beginPath(); g.moveTo(x + w, y); g.lineTo(x + w, y + h); g.stroke(); }
  }
  const shown = Math.max(x, kName);
  if (x + w - shown > 34 && h > 8) {
    g.save(); g.beginPath(); g.rect(x, y, w, h); g.clip();
    g.font = `${Math.min(11, h)}px DejaVu Sans, sans-serif`; g.textAlign = "left";
    g.lineWidth = 2.5; g.strokeStyle = "rgba(15,17,21,.7)"; g.lineJoin = "round";
    const words = one.role ? `${one.task.type}: ${one.role}` : one.task.type;
    g.strokeText(words, shown + 4, y + h - Math.max(2, (h - 9) / 2)); g.fillStyle = "#fff"; g.fillText(words, shown + 4, y + h - Math.max(2, (h - 9) / 2));
    g.restore();
  }
}

export function draw(chosen) {
  const uavs = [...model.uavs.values()], room = $("chronology-room");
  canvas.style.height = Math.max(room.clientHeight, kTop + uavs.length * kLeastRow) + "px";
  const ratio = window.devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight, head = room.scrollTop;
  if (!w || !h) return;
  if (canvas.width !== Math.round(w * ratio) || canvas.height !== Math.round(h * ratio)) { canvas.width = Math.round(w * ratio); canvas.height = Math.round(h * ratio); }
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.clearRect(0, 0, w, h);
  const {from, to} = frame();
  const x = (s) => kName + ((s - from) / (to - from)) * (w - kName);
  const tick = [5, 10, 20, 30, 60, 120, 300, 600, 1200, 3600].find((one) => (to - from) / one < 14) ?? 7200;
  g.font = "10px DejaVu Sans, sans-serif"; g.textAlign = "center";
  for (let s = Math.ceil(from / tick) * tick; s < to; s += tick) {
    if (s < 0) continue;
    g.strokeStyle = "#2c323c"; g.lineWidth = 1; g.beginPath(); g.moveTo(x(s), kTop); g.lineTo(x(s), h); g.stroke();
  }
  boxes = [];
  const row = Math.min(kMostRow, (h - kTop) / Math.max(1, uavs.length));
  uavs.forEach((uav, i) => {
    const y = kTop + i * row;
    if (uav.name === chosen) { g.fillStyle = "rgba(255,255,255,.05)"; g.fillRect(0, y, w, row); }
    const list = stretches(uav).filter((one) => one.to >= from && one.from <= to);
    const starts = new Set(list.filter((one) => one.planned).map(({planned}) => keyOf(planned.earliest_start, planned.latest_start)));
    const high = (row - 5) / Math.max(row < 40 ? 1 : 2, lanes(list));
    g.save(); g.beginPath(); g.rect(kName, kTop, w - kName, h); g.clip();
    for (const one of list) {
      const left = x(Math.max(one.from, from - 1)), right = Math.max(left + 2, x(Math.min(one.to, to + 1)));
      const top = y + 2 + one.lane * high;
      one.role = roleOf(uav, one.task.id);
      box(one, uav.colour, left, top, right - left, Math.max(3, high - 1.5));
      if (one.planned) windows(one, starts, uav.colour, x, top, Math.max(3, high - 1.5), w);
      boxes.push({one, uav, left, top, right, bottom: top + high});
    }
    g.restore();
    g.fillStyle = uav.colour; g.fillRect(0, y + 2, 4, row - 5);
    g.textAlign = "left"; g.font = "600 12px DejaVu Sans, sans-serif"; g.fillStyle = "#e4e8ee"; g.fillText(uav.name, 10, y + row / 2 + 4);
  });
  for (const [a, b] of meetings()) {
    const [high, low] = a.top < b.top ? [a, b] : [b, a], px = x(Math.max(a.one.to, b.one.to));
    g.beginPath(); g.moveTo(px, high.bottom); g.lineTo(px, low.top); g.setLineDash([2, 2]); g.lineWidth = 1.5; g.strokeStyle = "#f0e442"; g.stroke(); g.setLineDash([]);
    for (const py of [high.bottom - 2, low.top + 2]) { g.beginPath(); g.arc(px, py, 3, 0, 7); g.fillStyle = "#f0e442"; g.fill(); }
  }
  const at = x(now());
  if (at > kName) { g.strokeStyle = "#fff"; g.lineWidth = 1.5; g.beginPath(); g.moveTo(at, kTop - 3); g.lineTo(at, h); g.stroke(); }
  clocks(x, from, to, tick, head);
}

/** The hours, above the rows that are seen. */
function clocks(x, from, to, tick, head) {
  g.fillStyle = "#1b1f26"; g.fillRect(0, head, canvas.clientWidth, kTop - 2);
  g.font = "10px DejaVu Sans, sans-serif"; g.textAlign = "center"; g.fillStyle = "#98a3b3";
  for (let s = Math.ceil(from / tick) * tick; s < to; s += tick) if (s >= 0 && x(s) > kName) g.fillText(clockText(s), x(s), head + 12);
}

export function wire() {
  let from = null;
  const perPixel = () => window_.span / Math.max(1, canvas.clientWidth - kName);
  canvas.addEventListener("wheel", (event) => {
    if (event.offsetX < kName) return;   // over the names the rows are scrolled
    event.preventDefault();
    window_.span = Math.min(7200, Math.max(20, window_.span * Math.exp(event.deltaY * 0.001)));
  }, {passive: false});
  canvas.addEventListener("pointerdown", (event) => { from = event.offsetX; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointerup", () => { from = null; });
  canvas.addEventListener("dblclick", () => { window_.end = null; });
  canvas.addEventListener("pointermove", (event) => {
    if (from !== null && event.buttons) { window_.end = frame().to - (event.offsetX - from) * perPixel(); from = event.offsetX; }
    const hit = boxes.findLast?.((b) => event.offsetX >= b.left && event.offsetX <= b.right && event.offsetY >= b.top && event.offsetY <= b.bottom);
    const tip = $("tip");
    tip.hidden = !hit;
    if (!hit) return;
    const {one, uav} = hit;
    const lines = [`${uav.name} ${one.task.id} ${one.task.type}: ${one.state}`, one.waits ? "waits for its conditions" : `${clockText(one.from)} to ${one.open ? "now" : clockText(one.to)}`];
    if (one.role) lines.push(`role: ${one.role}`);
    if (one.planned) {
      const within = (from, to) => `${clockText(seconds(from))} to ${seconds(to) === Infinity ? "any time" : clockText(seconds(to))}`;
      lines.push(one.planned.methods, `starts ${within(one.planned.earliest_start, one.planned.latest_start)}, ends ${within(one.planned.earliest_end, one.planned.latest_end)}`);
    }
    const told = uav.tasks?.tasks.find((task) => task.id === one.task.id);
    if (told?.reason) lines.push(told.reason);
    tip.textContent = lines.filter(Boolean).join("\n");
    tip.style.left = Math.min(event.offsetX + 12, canvas.clientWidth - 240) + "px";
    tip.style.top = Math.max(0, event.offsetY - 60) + "px";
  });
  canvas.addEventListener("keydown", (event) => {
    const step = window_.span / 10;
    if (event.key === "ArrowLeft") window_.end = frame().to - step;
    else if (event.key === "ArrowRight") window_.end = frame().to + step;
    else if (event.key === "+") window_.span = Math.max(20, window_.span / 1.3);
    else if (event.key === "-") window_.span = Math.min(7200, window_.span * 1.3);
    else if (event.key === "0") window_.end = null;
    else return;
    event.preventDefault();
  });
  canvas.addEventListener("pointerleave", () => { $("tip").hidden = true; });
}
