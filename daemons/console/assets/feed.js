// SPDX-License-Identifier: Apache-2.0
// What the server tells, as it was told last.
import {seconds} from "./dom.js";

/** Okabe and Ito's colours: apart for colour-blind people too. More UAVs begin again, with labels. */
const colours = ["#e69f00", "#56b4e9", "#cc79a7", "#f0e442", "#009e73", "#d55e00", "#0072b2"];

export const model = {
  world: null,
  uavs: new Map(),   // name -> {name, number, colour, board, tasks, telemetry, trail, marks}
  ground: null,
  links: new Map(),
  looks: new Map(),
  objects: new Map(), // name -> where sensors saw it last
  belief: new Map(),  // row of the ground's grid -> a character for each of its points (rasters.js)
  beliefVersion: 0,
  places: new Map(),  // name -> [x, y, z] that the ground station told since the start
  clock: {at: 0, rate: 1, phase: "holding", heard: 0},
  log: [],
  replies: new Map(),
  connected: false,
  version: 0,        // of everything but the clock
  plansVersion: 0,
};

const kLog = 2000;

export function now() {
  const {at, rate, phase, heard} = model.clock;
  return phase === "running" ? at + Math.min(1, (performance.now() - heard) / 1000) * rate : at;
}

/** [s] of the mission after which what is known of a UAV is old: the page itself is behind a little. */
export const patience = () => 2.5 + 0.6 * model.clock.rate;

function uav(name) {
  let one = model.uavs.get(name);
  if (!one) {
    one = {name, number: 0, colour: colours[model.uavs.size % colours.length], marks: new Map(), joint: new Map(), trail: []};
    model.uavs.set(name, one);
  }
  return one;
}

function mark({uav: name, id, type, state, at}) {
  const marks = uav(name).marks;
  let task = marks.get(id);
  if (!task || (state === "scheduled" && task.states.length)) {
    task = {id, type, states: []};
    marks.set(id, task);
  }
  task.states.push({state, at: seconds(at)});
}

const take = {
  Clock(s) { model.clock = {at: seconds(s.time), rate: s.rate, phase: s.phase, heard: performance.now()}; },
  UavBoard(s) { uav(s.uav).board = s; },
  UavTasks(s) { uav(s.uav).tasks = s; model.plansVersion += 1; },
  Telemetry(s) { const one = uav(s.uav); one.telemetry = s; one.at = seconds(s.header.mission_time); },
  GroundBoard(s) { model.ground = s; },
  LinkState(s) { model.links.set(s.header.instance, s); },
  JointTaskState(s) { uav(s.uav).joint.set(s.header.instance, s); },
  Sighting(s) { take.PerceptionReport(s); },
  PerceptionReport(s) { model.looks.set(s.uav + " " + s.device, {...s, at: seconds(s.header.mission_time)}); },
  OperatorReply(s) { model.replies.set(s.who + " " + s.number, s); },
  SeenObject(s) { model.objects.set(s.name, s); },
  MissionState() {},
};

/** What is told of a place counts more than what was seen of an object of that name before. */
function place({name, removed, at}) {
  model.objects.delete(name);
  if (removed) model.places.delete(name); else model.places.set(name, at);
}

function message(event) {
  const said = JSON.parse(event.data);
  if (said.slot) take[said.slot]?.(said);
  else if (said.mark) mark(said.mark);
  else if (said.trail) uav(said.trail.uav).trail = said.trail.points;
  else if (said.place) place(said.place);
  else if (said.belief) { model.belief.set(said.belief.row, said.belief.cells); model.beliefVersion += 1; }
  else if (said.again) forget();
  else if (said.record) { model.log.push(said.record); if (model.log.length > kLog) model.log.splice(0, 200); }
  if (said.slot !== "Clock") model.version += 1;
  model.connected = true;
}

function forget() {
  model.plansVersion += 1;
  model.log = []; model.replies.clear(); model.looks.clear(); model.links.clear(); model.objects.clear(); model.places.clear(); model.belief.clear();
  model.ground = null;
  for (const one of model.uavs.values()) Object.assign(one, {marks: new Map(), joint: new Map(), trail: [], board: undefined, tasks: undefined, telemetry: undefined});
}

let source = null;

function open() {
  source = new EventSource("/api/events");
  source.onmessage = message;
  source.addEventListener("hello", () => {   // all is told anew
    model.log = []; model.replies.clear(); model.looks.clear();
    for (const one of model.uavs.values()) one.marks = new Map();
  });
  source.addEventListener("gap", () => model.log.push({at: now(), node: "page", kind: "notice", text: "some events were missed here"}));
  source.onerror = () => { model.connected = false; model.version += 1; };
}

async function session() {
  const token = new URLSearchParams(location.hash.slice(1)).get("token");
  if (!token) return;
  await fetch("/api/session", {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify({token})});
  history.replaceState(null, "", location.pathname);
}

export async function start() {
  await session();
  const answer = await fetch("/api/world");
  if (!answer.ok) throw new Error((await answer.json()).problems.join("; "));
  model.world = await answer.json();
  for (const one of model.world.uavs) Object.assign(uav(one.name), {number: one.number, model: one.model, sensors: one.sensors, start: one.start, energy: one.energy});
  open();
  // A browser has six connections to a host: a page that is not seen gives its own back.
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) { source.close(); model.connected = false; } else open();
  });
}

/** The joint tasks that it takes part in now. */
export const jointOf = (one) => [...one.joint.values()].filter((state) => !["ended", "aborted", "not-loaded"].includes(state.phase));
export const roleIn = (state) => state.holders.find((one) => one.uav === state.uav)?.role ?? "";

export const nameOf = (number) => number === 1 ? "ground" : [...model.uavs.values()].find((one) => one.number === number)?.name ?? "node " + number;

/** Where a UAV is known to be: by its last telemetry, or by the board. Null: unknown. */
export function placeOf(one) {
  if (one.telemetry) return {...one.telemetry.position, heading: one.telemetry.heading, v: one.telemetry.velocity, energy: one.telemetry.energy, at: one.at};
  const board = one.board;
  if (!board || seconds(board.located_at) === null) return null;
  return {...board.position, heading: board.heading, v: board.velocity, energy: board.energy, at: seconds(board.located_at)};
}

// ---- requests ----

let last = 0;
export const mine = [];   // newest first: {number, who, what, state, problems}

export const operator = () => document.getElementById("who").value.trim() || "operator";

const nextNumber = () => (last = Math.max(last + 1, Date.now() * 1000));

const post = (who, number, actions) => fetch("/api/request", {
  method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify({who, number, actions}),
});

/** Of a replay: {playing, speed, at}; what is absent stays. */
export async function playback(wish) {
  const answer = await post("viewer", nextNumber(), [{playback: wish}]);
  if (!answer.ok) throw new Error((await answer.json()).problems.join("; "));
}

export async function ask(actions, what) {
  const request = {who: operator(), number: nextNumber(), what, state: "sending", problems: [], at: now()};
  mine.unshift(request);
  model.version += 1;
  try {
    const answer = await post(request.who, request.number, actions);
    const said = await answer.json();
    request.state = answer.ok ? "sent" : "refused";
    request.problems = said.problems ?? [];
  } catch {
    request.state = "not sent";
    request.problems = ["the ground station does not answer"];
  }
  model.version += 1;
  return request;
}
