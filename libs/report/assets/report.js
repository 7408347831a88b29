// SPDX-License-Identifier: Apache-2.0
// Interaction only: the drawings are complete without it. A time cursor shared by the timeline, the
// map and the table; replay; zoom of the time axis; layers.
"use strict";
(() => {
  const svg = document.getElementById("timeline");
  const data = JSON.parse(document.getElementById("data").textContent);
  const $ = (id) => document.getElementById(id);
  const number = (name) => Number(svg.dataset[name]);
  const left = number("left"), right = number("right"), from = number("from"), to = number("to");
  const view = { from, to };
  let now = to, playing = false;
  document.documentElement.classList.add("scripted");

  const clamp = (v, low, high) => Math.min(high, Math.max(low, v));
  const clock = (s) => {
    const t = Math.floor(Math.abs(s)), h = Math.floor(t / 3600), two = (n) => String(n).padStart(2, "0");
    return (s <= -1 ? "-" : "") + (h ? h + ":" + two(Math.floor(t / 60) % 60) : Math.floor(t / 60)) + ":" + two(t % 60);
  };

  // ---- the state of a track at an instant -------------------------------------------------------
  const indexAt = (times, t) => {
    let low = 0, high = times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= t) low = middle; else high = middle - 1;
    }
    return low;
  };
  const stateAt = (uav, t) => {
    if (!uav.t.length) return null;
    const i = indexAt(uav.t, t), k = Math.min(i + 1, uav.t.length - 1);
    const part = k > i ? clamp((t - uav.t[i]) / (uav.t[k] - uav.t[i]), 0, 1) : 0;
    const mix = (column) => column[i] + (column[k] - column[i]) * part;
    return { x: mix(uav.x), y: mix(uav.y), z: mix(uav.z), v: mix(uav.v), e: mix(uav.e), h: uav.h[i] };
  };
  const tasksAt = (index, t) =>
    data.tasks.filter((task) => task[0] === index && task[1] <= t && t < task[2]).map((task) => task[3]);

  // ---- the cursor -------------------------------------------------------------------------------
  const scale = () => (right - left) / (view.to - view.from);
  const cursor = $("cursor");
  const markers = [...document.querySelectorAll("#map .live")];
  const reserved = [...document.querySelectorAll("#map .reserved")].map((e) => [e, Number(e.dataset.from), Number(e.dataset.to)]);
  const rows = [...document.querySelectorAll("#live-table tr")];

  const showMarkers = () => {
    for (const marker of markers) {
      const s = stateAt(data.uavs[marker.dataset.uav], now);
      marker.setAttribute("transform", `translate(${s.x.toFixed(1)} ${s.y.toFixed(1)}) rotate(${s.h})`);
    }
  };
  const showAir = () => {
    for (const [e, begin, end] of reserved) e.classList.toggle("now", begin <= now && now < end);
  };
  const showTable = () => {
    for (const row of rows) {
      const index = Number(row.dataset.uav), s = stateAt(data.uavs[index], now);
      const set = (name, text) => { row.querySelector("." + name).textContent = text; };
      set("task", tasksAt(index, now).join(", ") || "–");
      set("altitude", s ? s.z.toFixed(0) + " m" : "");
      set("speed", s ? s.v.toFixed(1) + " m/s" : "");
      set("energy", s ? (s.e * 100).toFixed(0) + " %" : "");
    }
    const phase = data.phases.filter((p) => p[0] <= now).pop();
    $("live-phase").textContent = phase ? phase[1] : "";
  };
  const showNow = () => {
    const x = left + (now - view.from) * scale(), visible = x >= left - 0.5 && x <= right + 0.5;
    for (const end of ["x1", "x2"]) cursor.setAttribute(end, visible ? x : -9);
    $("clock").textContent = $("live-time").textContent = clock(now);
    $("seek").value = ((now - from) / (to - from)) * 1000;
    showMarkers();
    showAir();
    showTable();
  };
  const setNow = (t) => { now = clamp(t, from, to); showNow(); };

  // ---- zoom: every x of the plot is rewritten ---------------------------------------------------
  const attribute = (element, name) => Number(element.getAttribute(name));
  const plot = svg.querySelector(".plot");
  const originals = [];
  for (const e of plot.querySelectorAll("rect, line, text, g.at")) {
    if (e.matches("line.tick, text.tick, line.grid, line.rail") || e.closest("g.at") !== (e.matches("g.at") ? e : null)) continue;
    if (e.tagName === "rect") originals.push([e, "rect", attribute(e, "x"), attribute(e, "width")]);
    else if (e.tagName === "line") originals.push([e, "line", attribute(e, "x1"), attribute(e, "x2")]);
    else if (e.tagName === "g") {
      const [x, y] = e.getAttribute("transform").match(/-?[\d.]+/g).map(Number);
      originals.push([e, "at", x, y]);
    } else if (e.dataset.need) originals.push([e, "label", attribute(e, "x"), e.classList.contains("outside")]);
    else originals.push([e, "text", attribute(e, "x"), 0]);
  }
  const stretches = [...plot.querySelectorAll("g.stretch")];

  // A label goes into its bar as soon as the visible part of the bar has room for it.
  const placeLabel = (e, x, outside, map) => {
    const begin = clamp(map(Number(e.dataset.from)), left, right);
    const end = clamp(map(Number(e.dataset.to)), left, right);
    const fits = end - begin >= Number(e.dataset.need);
    e.setAttribute("class", fits ? "inside" : outside ? "outside" : "inside off");
    e.setAttribute("x", fits ? begin : map(x));
    if (!outside) return;
    e.dataset.anchor ??= e.getAttribute("text-anchor");
    e.dataset.dx ??= e.getAttribute("dx");
    e.setAttribute("text-anchor", fits ? "start" : e.dataset.anchor);
    e.setAttribute("dx", fits ? 4 : e.dataset.dx);
  };
  const steps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200, 86400];
  const drawTicks = () => {
    plot.querySelectorAll("line.tick, text.tick").forEach((e) => e.remove());
    const step = steps.find((s) => s >= (view.to - view.from) / 14) ?? 172800;
    const make = (name, attributes) => {
      const e = document.createElementNS("http://www.w3.org/2000/svg", name);
      for (const key in attributes) e.setAttribute(key, attributes[key]);
      plot.append(e);
      return e;
    };
    for (let t = Math.ceil(view.from / step) * step; t <= view.to; t += step) {
      const x = left + (t - view.from) * scale();
      make("line", { class: "tick", x1: x, x2: x, y1: number("tickTop"), y2: number("bottom") });
      for (const y of [number("ruler"), number("bottom") + 13]) {
        if (x < right - 10) make("text", { class: "tick", x, y, "text-anchor": x < left + 14 ? "start" : "middle" }).textContent = clock(t);
      }
    }
  };
  const zoomTo = (a, b) => {
    const span = clamp(b - a, Math.min(5, to - from), to - from);
    view.from = clamp(a, from, to - span);
    view.to = view.from + span;
    const k = (to - from) / span, shift = left - ((view.from - from) * (right - left)) / span;
    const map = (x) => (x - left) * k + shift;
    for (const [e, kind, first, second] of originals) {
      if (kind === "rect") { e.setAttribute("x", map(first)); e.setAttribute("width", Math.max(second * k, 0.6)); }
      else if (kind === "line") { e.setAttribute("x1", map(first)); e.setAttribute("x2", map(second)); }
      else if (kind === "at") e.setAttribute("transform", `translate(${map(first)} ${second})`);
      else if (kind === "label") placeLabel(e, first, second, map);
      else e.setAttribute("x", map(first));
    }
    for (const g of stretches) g.setAttribute("transform", `matrix(${k} 0 0 1 ${map(0)} 0)`);
    drawTicks();
    showNow();
  };
  const zoomBy = (factor, centre = (view.from + view.to) / 2) =>
    zoomTo(centre - (centre - view.from) * factor, centre + (view.to - centre) * factor);

  // ---- mouse: move the cursor, drag to zoom, control and wheel to zoom, twice to see all ---------
  const xOf = (event) => {
    const box = svg.getBoundingClientRect();
    return ((event.clientX - box.left) / box.width) * svg.viewBox.baseVal.width;
  };
  const timeOf = (x) => view.from + (clamp(x, left, right) - left) / scale();
  let dragged = null, selection = null;
  svg.addEventListener("pointermove", (event) => {
    const x = xOf(event);
    if (!playing && x >= left && x <= right) setNow(timeOf(x));
    if (dragged === null || Math.abs(x - dragged) < 4) return;
    if (!selection) {
      selection = document.createElementNS("http://www.w3.org/2000/svg", "rect");
      selection.id = "selection";
      selection.setAttribute("height", number("bottom"));
      svg.append(selection);
    }
    selection.setAttribute("x", clamp(Math.min(x, dragged), left, right));
    selection.setAttribute("width", Math.abs(clamp(x, left, right) - dragged));
  });
  svg.addEventListener("pointerdown", (event) => {
    const x = xOf(event);
    if (event.button === 0 && x >= left && x <= right) dragged = x;
  });
  addEventListener("pointerup", (event) => {
    if (selection) {
      const ends = [timeOf(dragged), timeOf(xOf(event))].sort((a, b) => a - b);
      selection.remove();
      zoomTo(ends[0], ends[1]);
    } else if (dragged !== null) setNow(timeOf(dragged));
    dragged = selection = null;
  });
  svg.addEventListener("dblclick", () => zoomTo(from, to));
  svg.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && !event.shiftKey) return;
    event.preventDefault();
    zoomBy((event.deltaY || event.deltaX) > 0 ? 1.25 : 0.8, timeOf(xOf(event)));
  }, { passive: false });

  // ---- controls ---------------------------------------------------------------------------------
  let last = 0;
  const frame = (stamp) => {
    if (!playing) return;
    setNow(now + ((stamp - last) / 1000) * Number($("speed").value));
    last = stamp;
    if (now >= to) setPlaying(false);
    if (now > view.to || now < view.from) zoomTo(now, now + view.to - view.from);
    requestAnimationFrame(frame);
  };
  const setPlaying = (on) => {
    playing = on;
    $("play").textContent = on ? "⏸" : "▶";
    if (!on) return;
    if (now >= to) setNow(from);
    last = performance.now();
    requestAnimationFrame(frame);
  };
  $("play").addEventListener("click", () => setPlaying(!playing));
  $("seek").addEventListener("input", (event) => setNow(from + (event.target.value / 1000) * (to - from)));
  $("zoom-in").addEventListener("click", () => zoomBy(0.5, clamp(now, view.from, view.to)));
  $("zoom-out").addEventListener("click", () => zoomBy(2));
  $("zoom-all").addEventListener("click", () => zoomTo(from, to));
  for (const box of document.querySelectorAll("[data-layer]")) {
    box.checked = !svg.classList.contains("no-" + box.dataset.layer);
    box.addEventListener("change", () => svg.classList.toggle("no-" + box.dataset.layer, !box.checked));
  }
  for (const row of document.querySelectorAll(".chronicle tr")) {
    row.addEventListener("click", () => setNow(Number(row.dataset.t)));
  }
  addEventListener("keydown", (event) => {
    if (event.target.closest("input, select, button, summary")) return;
    const step = (view.to - view.from) / 100;
    if (event.key === " ") { event.preventDefault(); setPlaying(!playing); }
    if (event.key === "ArrowLeft") setNow(now - step);
    if (event.key === "ArrowRight") setNow(now + step);
  });
  setNow(from);
})();
