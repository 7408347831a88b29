// SPDX-License-Identifier: Apache-2.0
// A card for each UAV: what an operator wants to know of it, and what he can do with it.
import {$, clockText, el, fill, isOver, seconds, slide} from "./dom.js";
import {jointOf, model, now, operator, patience, placeOf, roleIn} from "./feed.js";
import * as act from "./actions.js";
import {view} from "./map.js";
import {heightAt} from "./relief.js";

const cards = new Map();

function make(uav, choose) {
  const parts = Object.fromEntries(["degree", "hand", "contact", "energy", "flight", "task", "plan", "joint", "goals", "decisions", "buttons", "gist"].map((name) => [name, el("span", {})]));
  parts.degree.className = "degree";
  parts.gist.className = "gist";
  const row = (name, node) => [el("dt", {}, name), el("dd", {}, node)];
  const card = el("article", {className: "card", style: {"--own": uav.colour}},
    el("header", {onclick: () => choose(uav.name), tabIndex: 0, role: "button", "aria-label": `choose ${uav.name}`, onkeydown: (event) => { if (event.key === "Enter" || event.key === " ") { choose(uav.name); event.preventDefault(); } }}, el("b", {}, uav.name), parts.degree, parts.hand, parts.gist, el("span", {className: "fill"}), parts.contact),
    el("dl", {}, ...row("energy", parts.energy), ...row("flight", parts.flight), ...row("does", parts.task), ...row("plan", parts.plan)), parts.joint,
    parts.goals, parts.buttons, el("details", {}, el("summary", {}, "decisions, and why"), parts.decisions));
  card.dataset.uav = uav.name;
  return {card, parts};
}

function contact(uav, parts) {
  const at = placeOf(uav), age = at ? Math.max(0, now() - at.at) : null;
  const lost = uav.board?.reachable === false;
  parts.contact.className = "chip " + (age === null || lost || age > 2 * patience() ? "bad" : age > patience() ? "warn" : "good");
  parts.contact.textContent = age === null ? (lost ? "not heard" : "…") : `${lost ? "no contact, " : ""}${age.toFixed(age < 10 ? 1 : 0)} s`;
  parts.contact.title = "age of what is known of it";
  return lost || age === null || age > 2 * patience();
}

/** What is left, what the straight way to its start would take, and what no way may use. */
function energy(uav, parts, left, home) {
  const share = Math.round(left * 100);
  const back = home === null || !uav.energy ? null : home * uav.energy.metre, reserve = uav.energy?.reserve ?? 0;
  const level = back !== null && left < back + reserve ? "bad" : left < 1.5 * ((back ?? 0.1) + reserve) ? "warn" : "";
  const needed = back === null ? "" : `, ${(back * 100).toFixed(back < 0.1 ? 1 : 0)} % to home`;
  fill(parts.energy, `${share} ${needed} ${level}`, () => [
    el("span", {className: "bar " + level, title: `${Math.round(reserve * 100)} % are kept in reserve`}, el("i", {style: {width: share + "%"}}),
      back !== null && el("b", {style: {left: Math.min(99, 100 * (back + reserve)) + "%"}})),
    `${share} %${needed}${level === "bad" ? ": not enough with the reserve" : ""}`]);
}

/** Joint tasks: its role, who has the others, which constraints between them do not hold. */
function joint(uav, parts) {
  const all = jointOf(uav);
  fill(parts.joint, JSON.stringify(all), () => (all.length ? el("ul", {className: "joint"}, ...all.map((state) => el("li", {title: state.why},
    el("b", {}, `${state.model}: ${roleIn(state) || "no role yet"}`), ` ${state.phase}`,
    state.active_blocks.length > 0 && el("small", {}, " in " + state.active_blocks.join(", ")),
    state.holders.length > 1 && el("small", {}, " with " + state.holders.filter((one) => one.uav !== state.uav).map((one) => `${one.uav} (${one.role})`).join(", ")),
    ...state.violated.map((name) => el("span", {className: "chip warn", title: "a spatial constraint does not hold"}, name + " does not hold"))))) : []));
}

function numbers(uav, parts) {
  const at = placeOf(uav);
  if (!at) { parts.flight.textContent = "–"; return; }
  const climb = at.v.z, home = uav.start ? Math.hypot(at.x - uav.start[0], at.y - uav.start[1]) : null;
  energy(uav, parts, at.energy, home);
  parts.flight.textContent = uav.board?.airborne
    ? `${(at.z - heightAt(at.x, at.y)).toFixed(0)} m over ground, ${Math.hypot(at.v.x, at.v.y).toFixed(1)} m/s${Math.abs(climb) > 0.5 ? (climb > 0 ? " ↑" : " ↓") : ""}${home === null ? "" : `, ${home.toFixed(0)} m from start`}`
    : "on the ground";
}

function work(uav, parts) {
  const tasks = uav.tasks?.tasks ?? [];
  const open = tasks.filter((task) => !task.lost && !isOver(task.state));
  const busy = open.filter((task) => task.state !== "scheduled");
  parts.task.textContent = busy.map((task) => `${task.id} ${task.type}${task.state === "running" ? "" : " (" + task.state + ")"}${task.at_ground ? ", run by the ground" : ""}`).join(" · ") || (open.length ? `waits: ${open[0].id} ${open[0].type}` : "nothing");
  const plan = uav.tasks?.plan ?? [];
  const end = plan.length ? Math.max(...plan.map((entry) => seconds(entry.earliest_end) ?? 0)) : null;
  const bits = [];
  if (uav.tasks?.revision) bits.push(`revision ${uav.tasks.revision}, ${plan.length} task${plan.length === 1 ? "" : "s"}${end ? `, until ${clockText(end)} at the earliest` : ""}`);
  else if (open.length) bits.push(`${open.length} task${open.length === 1 ? "" : "s"} open`);
  if (uav.board?.waiting) bits.push(`${uav.board.waiting} commands not answered`);
  if (uav.board?.held) bits.push(`${uav.board.held} tasks held here`);
  parts.plan.textContent = bits.join(", ") || "–";
}

const signs = {achieved: "✓", failed: "✗", cancelled: "–", "under-way": "▶", planned: "○", received: "…", "handed-over": "⇩"};

function thoughts(uav, parts) {
  const goals = uav.tasks?.goals ?? [], decisions = uav.tasks?.decisions ?? [];
  const key = JSON.stringify(goals.map((goal) => [goal.id, goal.state, goal.done]));
  fill(parts.goals, key, () => goals.length ? el("ul", {className: "goals"}, ...goals.slice(-6).map((goal) =>
    el("li", {title: goal.why || goal.done}, el("span", {className: "state"}, `${signs[goal.state] ?? ""} ${goal.state}`), el("span", {}, `${goal.id} ${goal.statement}`)))) : []);
  fill(parts.decisions, `${decisions.length ? decisions[decisions.length - 1].number : 0}`, () => decisions.length
    ? el("ul", {className: "decisions"}, ...[...decisions].reverse().map((one) => el("li", {}, `${clockText(seconds(one.began))}  ${one.applied}: ${one.outcome}`, el("br"), el("small", {}, "because: " + one.cause))))
    : el("small", {}, "none: it does not deliberate"));
}

/** Only what makes sense now can be pressed. */
function buttons(uav, parts) {
  const board = uav.board, me = operator(), name = uav.name;
  if (!board) return;
  parts.degree.textContent = board.degree;
  if (model.world.replay) return;
  const mineNow = board.holder === me, free = board.holder === "";
  const passes = seconds(board.passes_at);
  fill(parts.hand, `${board.holder} ${board.asker}`, () => free ? [] : el("span", {className: "chip in-hand"}, mineNow ? "in your hand" : "in hand of " + board.holder));
  const key = JSON.stringify([me, board.holder, board.asker, board.degree, board.airborne, board.held > 0, model.world.tasks.length > 0]);
  fill(parts.buttons, key, () => {
    const button = (text, run, props = {}) => el("button", {onclick: run, ...props}, text);
    const row = [];
    if (!mineNow && free) row.push(button("take in hand", () => act.take(name)));
    if (mineNow) row.push(button("steer on map", () => act.steer(name), {disabled: !board.airborne}), button("give back", () => act.giveBack(name)), button("let go", () => act.letGo(name)));
    if (!mineNow && !free) row.push(board.asker === me ? el("span", {className: "chip warn"}, "asked for") : button("ask for it", () => act.askFor(name)));
    if (mineNow && board.asker) row.push(button(`keep it: ${board.asker} asks`, () => act.keep(name)));
    const degrees = el("select", {title: "degree of autonomy", disabled: !free && !mineNow}, ...[1, 2, 3, 4, 5].map((one) => el("option", {value: one, selected: one === board.degree, disabled: (one === 4 && !model.world.tasks.length) || (one === 5 && !model.world.team?.includes(name))}, `degree ${one}`)));
    degrees.addEventListener("change", () => act.degree(name, Number(degrees.value)));
    const abort = slide("abort all", () => act.abortAll(name));
    if (!free && !mineNow) abort.classList.add("off");
    return [el("div", {className: "row"}, ...row), el("div", {className: "row"}, degrees, abort, board.held > 0 && button("resume plan", () => act.resume(name)))];
  });
  parts.hand.title = passes === null ? "" : `passes to ${board.asker} at ${clockText(passes)}`;
  parts.degree.title = ["", "1: the ground executes", "2: it executes, the ground relays", "3: it executes and synchronises", "4: it plans", "5: its team shares out the work"][board.degree] ?? "";
}

const kWhole = 5;   // more cards than these show their heads only, but for the chosen one

/** One line of a card that shows no more. */
function gist(uav, parts) {
  const at = placeOf(uav);
  parts.gist.textContent = `${at ? Math.round(at.energy * 100) + " %" : ""}  ${parts.task.textContent}`;
  parts.gist.title = parts.task.textContent;
}

export function draw(choose) {
  $("cards").classList.toggle("compact", model.uavs.size > kWhole);
  for (const uav of model.uavs.values()) {
    if (!cards.has(uav.name)) { const one = make(uav, choose); cards.set(uav.name, one); $("cards").append(one.card); }
    const {card, parts} = cards.get(uav.name);
    card.classList.toggle("chosen", uav.name === view.chosen);
    card.classList.toggle("lost", contact(uav, parts));
    numbers(uav, parts);
    work(uav, parts);
    gist(uav, parts);
    joint(uav, parts);
    thoughts(uav, parts);
    buttons(uav, parts);
  }
}
