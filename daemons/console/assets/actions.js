// SPDX-License-Identifier: Apache-2.0
// What operators ask, and the forms in which they say it.
import {$, el, fill, slide} from "./dom.js";
import {ask, mine, model, operator} from "./feed.js";
import {pick, view} from "./map.js";
import {heightAt} from "./relief.js";

export const take = (uav) => ask([{take_in_hand: {uav}}], `take ${uav} in hand`);
export const giveBack = (uav) => ask([{give_back: {uav}}], `give ${uav} back`);
export const letGo = (uav) => ask([{let_go: {uav}}], `let go of ${uav}`);
export const askFor = (uav) => ask([{ask: {uav}}], `ask for ${uav}`);
export const keep = (uav) => ask([{keep: {uav}}], `keep ${uav}`);
export const degree = (uav, to) => ask([{degree: {uav, to}}], `${uav} to degree ${to}`);
export const abortAll = (uav) => ask([{abort: {uav}}], `abort all of ${uav}`);
export const resume = (uav) => ask([{resume_plan: {uav}}], `resume the plan of ${uav}`);
export const cancelGoal = (uav, id) => ask([{cancel: {uav, goals: [id]}}], `cancel ${id} of ${uav}`);
export const answer = (text) => ask([{answer: text}], text);
export const judge = (alarm, as) => ask([{judge_alarm: {alarm, as}}], `alarm ${alarm} is ${as}`);
export const openAir = (name) => ask([{open_air: {name}}], `open air ${name}`);
export const finish = () => ask([{finish: true}], "end the mission");

/** Way-points on the map, flown at the height over the ground that it has now. */
export function steer(uav) {
  pick({
    hint: `way of ${uav}`,
    done(points) {
      if (!points.length) return;
      const at = model.uavs.get(uav).board.position;
      const altitude = Math.max(15, Math.round(at.z - heightAt(at.x, at.y)));
      ask([{go: {uav, to: points, altitude}}], `${uav} flies ${points.length} way-point${points.length > 1 ? "s" : ""}`);
    },
  });
}

export function closeAir() {
  pick({
    hint: "corners of the air to close", closed: true,
    done(points) {
      if (points.length < 3) return;
      const dialog = $("air");
      const name = el("input", {value: `closed-${1 + (model.ground?.air.length ?? 0)}`, required: true, maxLength: 40});
      const send = () => { ask([{close_air: {name: name.value, polygon: points}}], `close air ${name.value}`); dialog.close(); };
      dialog.replaceChildren(el("form", {method: "dialog"},
        el("b", {}, "Close air"), el("label", {}, "name ", name),
        el("div", {className: "row"}, slide("close it", send), " ", el("button", {value: "no"}, "leave"))));
      dialog.showModal();
    },
  });
}

// ---- a mission ----

function isInside(polygon, [x, y]) {
  let inside = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i, i += 1) {
    const [ax, ay] = polygon[i], [bx, by] = polygon[j];
    if (ay > y !== by > y && x < ax + ((bx - ax) * (y - ay)) / (by - ay)) inside = !inside;
  }
  return inside;
}

/** An input for one argument of a high-level task; `read` gives what it says. */
function argument(kind, uav) {
  const choose = (names) => el("select", {}, ...names.map((name) => el("option", {value: name}, name)));
  /** A button beside a choice: a click on the map makes it. */
  const onMap = (hint, done) => {
    const button = el("button", {type: "button", title: hint + " on the map"}, "map");
    button.addEventListener("click", () => {
      $("mission").close();
      pick({hint, one: true, left: () => $("mission").show(), done([at]) { done(at); $("mission").show(); }});
    });
    return button;
  };
  if (kind === "zone") {
    const s = choose(model.world.zones.map((z) => z.name));
    const take = (at) => { s.value = model.world.zones.findLast((z) => isInside(z.polygon, at))?.name ?? s.value; };
    return {node: el("span", {}, s, onMap("a zone", take)), read: () => s.value};
  }
  if (kind === "device") { const s = choose(model.uavs.get(uav)?.sensors ?? []); return {node: s, read: () => s.value}; }
  if (kind === "uav") { const s = choose([...model.uavs.keys()]); return {node: s, read: () => s.value}; }
  if (kind === "uavs" || kind === "places") {
    const s = choose(kind === "uavs" ? [...model.uavs.keys()] : model.world.places.map((p) => p.name));
    s.multiple = true; s.size = 3;
    return {node: s, read: () => [...s.selectedOptions].map((o) => o.value)};
  }
  if (kind === "place") {
    const names = [...model.world.places.map((p) => p.name), ...(model.ground?.alarms ?? []).map((a) => `alarm:${a.id}`)];
    const s = choose(names);
    let point = null;
    const picked = el("option", {value: "point"});
    const take = ([x, y]) => {
      point = [x, y, Math.round(heightAt(x, y))];
      picked.textContent = `${x}, ${y}`;
      s.append(picked);
      s.value = "point";
    };
    return {node: el("span", {}, s, onMap("a place", take)), read: () => (s.value === "point" ? point : s.value)};
  }
  const number = ["duration", "number", "sync-id"].includes(kind);
  const input = el("input", {type: number ? "number" : "text", step: "any", value: kind === "duration" ? "60" : number ? "1" : "", size: 8});
  return {node: input, read: () => (number ? Number(input.value) : input.value)};
}

const nextId = (list, floor) => Math.max(floor, ...list) + 1;

export function missionForm() {
  const dialog = $("mission");
  dialog.className = "aside";
  const deliberate = [...model.uavs.values()].filter((one) => one.board?.degree >= 4).map((one) => one.name);
  if (!model.world.tasks.length || !deliberate.length) {
    dialog.replaceChildren(el("form", {method: "dialog"}, el("b", {}, "Mission"),
      el("p", {}, model.world.tasks.length ? "Missions are planned at degree 4: no UAV is there now." : "This scenario says nothing of planning on board."),
      el("button", {}, "close")));
    return dialog.showModal();
  }
  const uav = el("select", {}, ...deliberate.map((name) => el("option", {value: name, selected: name === view.chosen}, name)));
  const placement = el("select", {}, ...["best", "first", "last", "in-time", "tour"].map((one) => el("option", {value: one}, one)));
  const evaluate = el("input", {type: "checkbox"});
  const list = el("div", {});
  const problems = el("div", {className: "problems", role: "alert"});
  const tasks = [];
  const add = () => {
    const kind = el("select", {}, ...model.world.tasks.map((task) => el("option", {value: task.name}, task.name)));
    const row = el("fieldset", {});
    const one = {name: () => kind.value, arguments: []};
    const show = () => {
      const signature = model.world.tasks.find((task) => task.name === kind.value);
      one.arguments = signature.parameters.map((parameter) => argument(parameter, uav.value));
      row.replaceChildren(kind, ...signature.parameters.map((parameter, i) => el("label", {title: parameter}, parameter + " ", one.arguments[i].node)),
        el("button", {type: "button", onclick: () => { tasks.splice(tasks.indexOf(one), 1); row.remove(); }}, "×"));
    };
    kind.addEventListener("change", show);
    show();
    tasks.push(one);
    list.append(row);
  };
  add();
  const send = async () => {
    const goals = [...model.uavs.values()].flatMap((one) => one.tasks?.goals ?? []);
    const first = nextId(goals.map((goal) => goal.id), 9000);
    const mission = {
      uav: uav.value, id: nextId(goals.map((goal) => goal.mission), 900), placement: placement.value, evaluate: evaluate.checked,
      tasks: tasks.map((one, i) => ({id: first + i, task: [one.name(), ...one.arguments.map((a) => a.read())]})),
    };
    const request = await ask([{mission}], `mission ${mission.id} of ${mission.uav}`);
    problems.textContent = request.problems.join("\n");
    if (request.state === "sent") dialog.close();
  };
  dialog.replaceChildren(el("form", {method: "dialog"}, el("b", {}, "Mission"),
    el("div", {className: "row"}, el("label", {}, "UAV ", uav), " ", el("label", {}, "placement ", placement), " ", el("label", {}, evaluate, " only what it would cost")),
    list, el("div", {className: "row"}, el("button", {type: "button", onclick: add}, "another task")), problems,
    el("div", {className: "row"}, el("button", {type: "button", id: "mission-send", onclick: send}, "send"), " ", el("button", {value: "no"}, "leave"))));
  dialog.showModal();
}

// ---- what came of requests ----

const tone = {acknowledged: "good", accepted: "good", done: "good", refused: "bad", expired: "bad", "not sent": "bad", issued: "warn", delivered: "warn", sent: "", sending: ""};

function commandText(command) {
  if (command.state === "delivered") return "delivered, not answered yet";
  if (command.state !== "issued") return command.state;
  const board = model.uavs.get(command.uav)?.board;
  return board && !board.reachable ? "issued, waits for contact" : "issued";
}

/** How far it came, in shapes: issued, delivered, at its end. */
function steps(command) {
  const came = {issued: 1, delivered: 2, acknowledged: 3}[command.state];
  if (came) return "●".repeat(came) + "○".repeat(3 - came);
  return command.state === "refused" ? "●●×" : "●××";
}

function commandChip(command, text) {
  return el("span", {className: "chip " + (tone[command.state] ?? ""), title: `issued → delivered → acknowledged; ${command.why}`},
    `${command.uav}: ${command.what}: ${text}${command.why ? ": " + command.why : ""} `, el("span", {className: "steps", "aria-hidden": "true"}, steps(command)));
}

export function requests(list) {
  const key = `${model.version}`;
  fill(list, key, () => {
    const rows = mine.slice(0, 60).map((request) => {
      const reply = model.replies.get(request.who + " " + request.number);
      const state = !reply ? request.state : !reply.accepted ? "refused" : reply.complete && !reply.commands.length ? "done" : "accepted";
      const chips = (reply?.commands ?? []).map((command) => commandChip(command, commandText(command)));
      const problems = [...request.problems, ...(reply?.problems ?? [])];
      return el("li", {}, el("b", {}, request.what), el("span", {className: "chip " + (tone[state] ?? "")}, state), ...chips,
        problems.length ? el("span", {className: "chip bad"}, problems.join("; ")) : null);
    });
    const others = [...model.replies.values()].filter((reply) => !mine.some((one) => one.number === reply.number && one.who === reply.who));
    for (const reply of others.slice(-20).reverse()) {
      rows.push(el("li", {}, el("span", {className: "chip"}, reply.who), ...reply.commands.map((command) => commandChip(command, command.state)),
        !reply.accepted && el("span", {className: "chip bad"}, reply.problems.join("; "))));
    }
    return rows.length ? rows : [el("li", {className: "empty"}, `What you ask as ${operator()} is followed here from sending to its end.`)];
  });
}
