// SPDX-License-Identifier: Apache-2.0
// The chronology: a row for each UAV, what its tasks did and what it means to do.
import {$, clockText, isOver, seconds} from "./dom.js";
import {model, now, roleIn} from "./feed.js";

const canvas = $("chronology");
const g = canvas.getContext("2d");
export const window_ = {span: 240, end: null};   // [s]; end null: goes with the time
const kName = 74, kTop = 18;
const kTogether = 2;   // [s] between the ends of two tasks that synchronise with each other
let boxes = [];

const looks = {
  scheduled: {fill: "rgba(255,255,255,.06)", edge: "#77828f"},
  started: {fill: null, alpha: 0.55}, running: {fill: null, alpha: 0.95},
  aborting: {fill: "#b3541e"}, ended: {fill: null, alpha: 0.42}, aborted: {fill: "#7c3417"},
};

function frame() {
  const to = window_.end ?? now() + window_.span * 0.35;
  return {from: to - window_.span, to};
}

/** What a row shows: each task's stretches, and what is planned ahead. */
function stretches(uav) {
  const out = [];
  for (const task of uav.marks.values()) {
    const last = task.states[task.states.length - 1];
    task.states.forEach(({state, at}, i) => {
      if (isOver(state) || state === "scheduled") return;
      const next = task.states[i + 1];
      const ended = i === task.states.length - 2 && isOver(last.state) ? last.state : state;
      const shown = state === "running" || state === "started" ? (isOver(ended) ? ended : state) : state;
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

/** The window that the plan leaves: from the earliest start to the latest, from the earliest end to the latest. */
function windows({planned}, colour, x, top, high, edge) {
  const line = (from, to, y) => {
    const a = seconds(from), b = seconds(to);
    if (a === null || b === null || b - a < 0.5) return;
    const left = x(a), right = Number.isFinite(b) ? x(b) : edge;
    g.beginPath(); g.moveTo(left, y); g.lineTo(right, y); g.moveTo(left, y - 2); g.lineTo(left, y + 2);
    if (Number.isFinite(b)) { g.moveTo(right, y - 2); g.lineTo(right, y + 2); } else { g.moveTo(right - 5, y - 3); g.lineTo(right, y); g.lineTo(right - 5, y + 3); }
    g.globalAlpha = 0.8; g.lineWidth = 1; g.strokeStyle = colour; g.stroke(); g.globalAlpha = 1;
  };
  line(planned.earliest_start, planned.latest_start, top + 1.5);
  line(planned.earliest_end, planned.latest_end, top + high - 1.5);
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
    g.setLineDash([4, 3]); g.lineWidth = 1; g.strokeStyle = colour; g.strokeRect(x + 0.5, y + 0.5, w - 1, h - 1); g.setLineDash([]);
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
  const ratio = window.devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
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
    g.fillStyle = "#98a3b3"; g.fillText(clockText(s), x(s), 12);
  }
  boxes = [];
  const uavs = [...model.uavs.values()], row = Math.min(64, (h - kTop) / Math.max(1, uavs.length));
  uavs.forEach((uav, i) => {
    const y = kTop + i * row;
    if (uav.name === chosen) { g.fillStyle = "rgba(255,255,255,.05)"; g.fillRect(0, y, w, row); }
    const list = stretches(uav).filter((one) => one.to >= from && one.from <= to);
    const high = (row - 5) / Math.max(2, lanes(list));
    g.save(); g.beginPath(); g.rect(kName, kTop, w - kName, h); g.clip();
    for (const one of list) {
      const left = x(Math.max(one.from, from - 1)), right = Math.max(left + 2, x(Math.min(one.to, to + 1)));
      const top = y + 2 + one.lane * high;
      one.role = roleOf(uav, one.task.id);
      if (one.planned) windows(one, uav.colour, x, top, Math.max(3, high - 1.5), w);
      box(one, uav.colour, left, top, right - left, Math.max(3, high - 1.5));
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
  g.strokeStyle = "#fff"; g.lineWidth = 1.5; g.beginPath(); g.moveTo(at, kTop - 3); g.lineTo(at, h); g.stroke();
}

export function wire() {
  let from = null;
  const perPixel = () => window_.span / Math.max(1, canvas.clientWidth - kName);
  canvas.addEventListener("wheel", (event) => {
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
      const span = (from, to) => `${clockText(seconds(from))} to ${seconds(to) === Infinity ? "any time" : clockText(seconds(to))}`;
      lines.push(one.planned.methods, `starts ${span(one.planned.earliest_start, one.planned.latest_start)}, ends ${span(one.planned.earliest_end, one.planned.latest_end)}`);
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
