// SPDX-License-Identifier: Apache-2.0
// Spatial constraints of running joint tasks: what each says, and where it lets a UAV be, at the height that it has.
import {jointOf, model, placeOf, roleIn} from "./feed.js";

/** Where a name of a joint task is: a UAV, what sensors saw, an alarm, a place that was told, one of the scenario, or "x,y,z". Null: unknown. */
export function whereIs(name) {
  const uav = model.uavs.get(name), at = uav && placeOf(uav);
  if (at) return [at.x, at.y, at.z];
  const seen = model.objects.get(name);
  if (seen) return [seen.at.x, seen.at.y, seen.at.z];
  const alarm = (model.ground?.alarms ?? []).find((one) => "alarm:" + one.id === name);
  if (alarm) return [alarm.position.x, alarm.position.y, alarm.position.z];
  const told = model.places.get(name) ?? model.world.places.find((place) => place.name === name)?.at;
  if (told) return told;
  const numbers = name.split(",").map(Number);
  return numbers.length === 3 && numbers.every(Number.isFinite) ? numbers : null;
}

/** What the words of a variant stand for in a joint task: names, or a number. A subject is MODEL(ARGUMENTS) of MEMBERS. */
function wordsOf(state, variant) {
  const given = (/^[^(]*\((.*)\) of /.exec(state.subject)?.[1] ?? "").split(" ");
  const values = new Map(variant.arguments.map((name, i) => [name, given[i]]));
  return (word) => {
    if (typeof word === "number") return word;
    if (word === "R*") return state.holders.filter((one) => one.uav !== state.uav).map((one) => one.uav);
    if (variant.roles.includes(word)) return state.holders.filter((one) => one.role === word).map((one) => one.uav);
    return [values.get(word) ?? word];
  };
}

const gap = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const direction = (a, b) => Math.atan2(b[1] - a[1], b[0] - a[0]);

/** A bound in numbers: of a number, of a parameter, of the distance of two places, of the angle of a place in the frame. */
function boundOf(than, words, quantity, origin, toward) {
  if (typeof than === "number") return than;
  if (Array.isArray(than)) {
    const at = than.map((word) => whereIs(words(word)[0] ?? ""));
    if (at.some((one) => !one)) return null;
    if (quantity === "distance") return gap(at[0], at[1]);
    return quantity === "azimuth" ? direction(origin, at[0]) - direction(origin, toward) : Math.atan2(at[0][2] - origin[2], Math.hypot(at[0][0] - origin[0], at[0][1] - origin[1]));
  }
  const number = Number(words(than)[0]);
  return Number.isFinite(number) ? number : null;
}

/** One constraint, placed, for each of the names of its first place: {quantity, relation, origin, zero, bound, tolerance}. */
function placed(constraint, words) {
  const out = [];
  for (const name of words(constraint.of[0])) {
    const origin = whereIs(name), toward = constraint.of[1] ? whereIs(words(constraint.of[1])[0] ?? "") : null;
    if (!origin || (constraint.quantity === "azimuth" && !toward)) return null;
    const bound = boundOf(constraint.than, words, constraint.quantity, origin, toward);
    if (bound === null) return null;
    out.push({quantity: constraint.quantity, relation: constraint.relation, origin, zero: toward ? direction(origin, toward) : 0, bound, tolerance: constraint.tolerance ?? 0});
  }
  return out;
}

/** The spatial constraints that a UAV has now: [{scm, violated, figures}], `figures` null where some place is not known. */
export function constraintsOf(uav) {
  const out = [];
  for (const state of jointOf(uav)) {
    const variant = model.world.joint?.[state.model]?.[state.variant], role = roleIn(state);
    if (!variant || state.phase !== "running") continue;
    const words = wordsOf(state, variant);
    for (const one of variant.constraints) {
      if (one.role !== role || !one.blocks.some((block) => state.active_blocks.includes(block))) continue;
      const all = one.all.map((constraint) => placed(constraint, words));
      out.push({scm: one.scm, violated: state.violated.includes(one.scm), figures: all.includes(null) ? null : all.flat()});
    }
  }
  return out;
}

// ---- in a plane, at a height ----

const turn = 2 * Math.PI;
const kFar = 1e5;   // [m] beyond what a map shows

/**
 * Where a figure lets something be at that height: {rings: [{centre, from, to}], wedges: [{centre, from, to}]}, of which one has to hold it.
 * Radii [m]; angles [rad], counter-clockwise. A ring of an infinite radius ends nowhere.
 */
export function regionOf({quantity, relation, origin, zero, bound, tolerance}, height) {
  const less = relation === "<" || relation === "≤", more = relation === ">" || relation === "≥";
  const up = height - origin[2], centre = [origin[0], origin[1]];
  if (quantity === "distance") {
    const radius = (distance) => Math.sqrt(Math.max(0, distance ** 2 - up ** 2));
    if (less) return {rings: Math.abs(up) < bound ? [{centre, from: 0, to: radius(bound)}] : [], wedges: []};
    if (more) return {rings: [{centre, from: radius(bound), to: Infinity}], wedges: []};
    return {rings: [{centre, from: radius(bound - tolerance), to: radius(bound + tolerance)}], wedges: []};
  }
  if (quantity === "altitude") {
    // The angle falls from π/2 above the origin to 0 far away, or rises from -π/2 below it.
    const radius = (angle) => { const r = up / Math.tan(angle); return angle * up <= 0 ? Infinity : Math.max(0, Math.abs(angle) >= Math.PI / 2 ? 0 : r); };
    const least = less ? -Infinity : more ? bound : bound - tolerance, most = more ? Infinity : less ? bound : bound + tolerance;
    const near = up >= 0 ? most : least, far = up >= 0 ? least : most;   // the angle near by and far away
    if (up === 0) return {rings: least <= 0 && most >= 0 ? [{centre, from: 0, to: Infinity}] : [], wedges: []};
    if (up > 0 ? most <= 0 : least >= 0) return {rings: [], wedges: []};
    return {rings: [{centre, from: Number.isFinite(near) ? radius(near) : 0, to: Number.isFinite(far) ? radius(far) : Infinity}], wedges: []};
  }
  const from = less ? 0 : more ? bound : bound - tolerance, to = less ? bound : more ? turn : bound + tolerance;
  return {rings: [], wedges: [{centre, from: zero + from, to: zero + to}]};
}

/** Whether a place is in a region. */
export function isIn({rings, wedges}, [x, y]) {
  const within = (from, to, angle) => to - from >= turn || (((angle - from) % turn) + turn) % turn <= to - from;
  return rings.some(({centre, from, to}) => { const d = Math.hypot(x - centre[0], y - centre[1]); return d >= from && d <= to; })
    || wedges.some(({centre, from, to}) => within(from, to, Math.atan2(y - centre[1], x - centre[0])));
}

// ---- on the map ----

function outline(g, screen, scale, {rings, wedges}) {
  g.beginPath();
  for (const {centre, from, to} of rings) {
    const [px, py] = screen(...centre);
    for (const radius of [from, to]) if (radius > 0 && radius < kFar) { g.moveTo(px + radius * scale, py); g.arc(px, py, radius * scale, 0, turn); }
  }
  for (const {centre, from, to} of wedges) {
    const [px, py] = screen(...centre);
    for (const angle of [from, to]) { g.moveTo(px, py); g.lineTo(px + Math.cos(angle) * 160 * scale, py - Math.sin(angle) * 160 * scale); }
  }
}

/** What is outside of the region is cut away from all that is drawn next. */
function clip(g, screen, scale, {rings, wedges}) {
  g.beginPath();
  for (const {centre, from, to} of rings) {
    const [px, py] = screen(...centre);
    if (to < kFar) { g.moveTo(px + to * scale, py); g.arc(px, py, to * scale, 0, turn); } else g.rect(-1e5, -1e5, 2e5, 2e5);
    if (from > 0) { g.moveTo(px + from * scale, py); g.arc(px, py, from * scale, 0, turn); }
  }
  for (const {centre, from, to} of wedges) {
    const [px, py] = screen(...centre);
    g.moveTo(px, py); g.arc(px, py, kFar, -from, -to, true); g.closePath();
  }
  g.clip("evenodd");
}

const isBounded = (region) => region.rings.some((ring) => ring.to < kFar);

/** The shape of each constraint of a UAV, and filled where all of them hold at its height. */
export function draw(g, screen, scale, uav, write) {
  const at = placeOf(uav);
  if (!at) return;
  const all = constraintsOf(uav), known = all.filter((one) => one.figures);
  const regions = known.map((one) => one.figures.map((figure) => regionOf(figure, at.z)));
  if (regions.flat().some(isBounded)) {
    g.save();
    regions.flat().forEach((region) => clip(g, screen, scale, region));
    g.globalAlpha = 0.3; g.fillStyle = uav.colour; g.fillRect(0, 0, g.canvas.width, g.canvas.height);
    g.restore();
  }
  const stroke = (width, colour) => { g.lineWidth = width; g.strokeStyle = colour; g.stroke(); };
  known.forEach((one, i) => {
    const colour = one.violated ? "#e8672c" : uav.colour;
    for (const region of regions[i]) {
      outline(g, screen, scale, region);
      stroke(3.5, "rgba(15,18,22,.35)");
      g.setLineDash([2, 4]); stroke(one.violated ? 2.5 : 1.6, colour); g.setLineDash([]);
    }
    label(one, regions[i], at, screen, write, colour);
  });
}

/** Its name, on its outermost bound, on the side of the UAV. */
function label({scm, violated}, regions, at, screen, write, colour) {
  const bounds = regions.flatMap((region) => region.rings).map(({centre, from, to}) => ({centre, radius: to < kFar ? to : from})).filter(({radius}) => radius > 0 && radius < kFar);
  if (!bounds.length) return;
  const {centre, radius} = bounds.reduce((a, b) => (b.radius > a.radius ? b : a)), angle = Math.atan2(at.y - centre[1], at.x - centre[0]) - 0.35;
  const [px, py] = screen(centre[0] + Math.cos(angle) * radius, centre[1] + Math.sin(angle) * radius);
  write(scm, px + 4, py + 3, {size: 10, colour: violated ? "#ff9a6b" : colour});
}
