// SPDX-License-Identifier: Apache-2.0
// The page: starts what is there and draws it.
import {$, clockText, el, fill, slide} from "./dom.js";
import {model, now, playback, start} from "./feed.js";
import * as act from "./actions.js";
import * as cards from "./cards.js";
import * as map from "./map.js";
import * as timeline from "./timeline.js";

const choose = (name) => {
  map.view.chosen = map.view.chosen === name ? null : name;
  if (!map.view.chosen) map.view.follow = false;
  document.querySelector(`[data-uav="${CSS.escape(name)}"]`)?.scrollIntoView({block: "nearest"});
};

// ---- the bar ----

let clockHeard = 0, clockAt = -1;

function bar() {
  $("clock").textContent = clockText(now());
  $("scenario").textContent = model.world.scenario;
  $("phase").textContent = [model.ground?.phase, model.clock.phase === "running" ? (model.clock.rate === 1 ? "" : `× ${model.clock.rate}`) : model.clock.phase].filter(Boolean).join("  ");
  if (model.clock.at !== clockAt) { clockAt = model.clock.at; clockHeard = performance.now(); }
  const silent = (performance.now() - clockHeard) / 1000;
  const news = $("news");
  const over = model.clock.phase === "finished" || model.ground?.finished;
  if (model.world.replay) { news.className = "chip"; news.textContent = model.connected ? "replay" : "the replay has ended"; return; }
  news.className = "chip " + (over ? "" : !model.clock.heard ? "" : !model.connected ? "bad" : silent > 3 ? "warn" : "good");
  news.textContent = over ? "mission over" : !model.clock.heard ? "connecting" : !model.connected ? "ground station lost" : silent > 3 ? `no news for ${silent.toFixed(0)} s` : "live";
  const answers = model.ground?.answers ?? [];
  const raised = (model.ground?.alarms ?? []).filter((alarm) => alarm.state === "raised");
  const air = model.ground?.air ?? [];
  fill($("answers"), JSON.stringify([answers, raised.map((alarm) => alarm.id), air.map((one) => one.name)]), () => [
    ...answers.map((text) => el("button", {title: "the script waits for this", onclick: () => act.answer(text)}, `answer: ${text}`)),
    ...raised.flatMap((alarm) => [el("button", {onclick: () => act.judge(alarm.id, "confirmed")}, `confirm alarm ${alarm.id}`), el("button", {onclick: () => act.judge(alarm.id, "infirmed")}, "infirm")]),
    ...air.map((one) => el("button", {onclick: () => act.openAir(one.name)}, `open ${one.name}`)),
  ]);
}

/** Which view-shed is shown. */
function viewsheds() {
  const choice = el("select", {id: "viewshed", title: "view-shed: what has no line of sight is dark", "aria-label": "view-shed"},
    ...[["", "no view-shed"], ["ground", "heard by the ground"], ["uav", "seen by the chosen UAV"]].map(([value, label]) => el("option", {value}, label)));
  choice.addEventListener("change", () => { map.view.viewshed = choice.value; });
  return choice;
}

function tools() {
  const toggle = (name, label) => {
    const button = el("button", {"aria-pressed": "true"}, label);
    button.addEventListener("click", () => { map.view.layers[name] = !map.view.layers[name]; button.setAttribute("aria-pressed", map.view.layers[name]); });
    return button;
  };
  const follow = el("button", {"aria-pressed": "false", title: "keep the chosen UAV in the middle"}, "follow");
  follow.addEventListener("click", () => { map.view.follow = !map.view.follow; });
  setInterval(() => follow.setAttribute("aria-pressed", map.view.follow), 300);
  $("tools").append(el("button", {onclick: map.fit, title: "all of it (0)"}, "fit"), follow,
    viewsheds(), ...[["belief", "belief"], ["plans", "plans"], ["trails", "trails"], ["looks", "looks"], ["links", "links"], ["joint", "joint tasks"]].map(([name, label]) => toggle(name, label)),
    el("button", {onclick: act.closeAir, className: "acts"}, "close air…"));
}

// ---- the bar of a replay ----

let goingTo = null;  // while the thumb is held

function playbackBar() {
  const {until} = model.world.replay;
  document.body.classList.add("replay");
  const play = el("button", {id: "play", title: "space"}, "halt");
  const speed = el("select", {id: "speed", title: "mission seconds a second"}, ...[0.5, 1, 2, 5, 10, 20, 60].map((one) => el("option", {value: one}, `× ${one}`)));
  const at = el("input", {id: "at", type: "range", min: "0", max: String(Math.ceil(until)), step: "1", value: "0"});
  at.setAttribute("aria-label", "mission time");
  const playing = () => model.clock.phase === "running";
  play.addEventListener("click", () => playback(playing() || now() < until ? {playing: !playing()} : {at: 0, playing: true}));
  speed.addEventListener("change", () => playback({speed: Number(speed.value)}));
  at.addEventListener("input", () => { goingTo = Number(at.value); });
  at.addEventListener("change", () => { playback({at: Number(at.value)}); goingTo = null; });
  document.addEventListener("keydown", (event) => {
    if (event.key === " " && !event.target.closest("input, select, button, textarea")) { play.click(); event.preventDefault(); }
  });
  $("playback").append(play, speed, at, el("span", {}, clockText(until)));
  $("playback").hidden = false;
  document.querySelector("nav [data-tab=log]").click();  // nothing can be asked for
  setInterval(() => {
    play.textContent = playing() ? "halt" : "play";
    if (goingTo === null && document.activeElement !== speed) {
      at.value = String(now());
      if ([...speed.options].some((one) => Number(one.value) === model.clock.rate)) speed.value = String(model.clock.rate);
    }
  }, 200);
}

// ---- below ----

let shownLog = -1;

function logLine(record) {
  const {at, node, kind, ...rest} = record;
  const tone = ["notice", "dropped", "unsent", "expired", "lost"].includes(kind) || rest.state === "expired" ? "warn" : rest.state === "refused" || rest.state === "failed" || rest.state === "aborted" ? "bad" : ["alarm", "phase", "hand", "asked"].includes(kind) ? "mark" : "";
  const words = Object.entries(rest).map(([key, value]) => (typeof value === "string" && ["text", "why"].includes(key) ? value : `${key} ${Array.isArray(value) ? value.map((v) => Math.round(v)).join(" ") : value}`)).join("  ");
  return el("li", {className: tone}, el("span", {}, clockText(at)), el("span", {}, node), el("span", {}, kind), el("span", {}, words));
}

function log() {
  const key = model.log.length + $("filter").value;
  if (shownLog === key || $("log").hidden) return;
  shownLog = key;
  const wanted = $("filter").value.toLowerCase();
  const lines = model.log.filter((record) => !wanted || JSON.stringify(record).toLowerCase().includes(wanted)).slice(-300).reverse();
  $("log").replaceChildren(...lines.map(logLine));
}

function tabs() {
  for (const button of document.querySelectorAll("nav [data-tab]")) {
    button.addEventListener("click", () => {
      for (const one of document.querySelectorAll("nav [data-tab]")) {
        one.setAttribute("aria-pressed", String(one === button));
        $(one.dataset.tab).hidden = one !== button;
      }
      $("filter").hidden = button.dataset.tab !== "log";
    });
  }
}

// ---- drawing: the map with the screen, the rest a few times a second ----

let last = 0;

function frame(time) {
  map.draw();
  if (time - last > 200) {
    last = time;
    bar();
    cards.draw(choose);
    timeline.draw(map.view.chosen);
    act.requests($("requests"));
    log();
  }
  requestAnimationFrame(frame);
}

try {
  const who = $("who");
  who.value = localStorage.getItem("operator") ?? "operator";
  who.addEventListener("change", () => localStorage.setItem("operator", who.value));
  await start();
  document.title = "Skein: " + model.world.scenario;
  tools();
  tabs();
  if (model.world.replay) playbackBar();
  map.wire(choose);
  timeline.wire();
  $("mission-button").addEventListener("click", act.missionForm);
  $("finish").append(slide("end mission", act.finish));
  $("designer").hidden = !model.world.designer;
  requestAnimationFrame(frame);
} catch (error) {
  $("news").className = "chip bad";
  $("news").textContent = error.message;
}
