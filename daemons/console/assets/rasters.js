// SPDX-License-Identifier: Apache-2.0
// Rasters over the ground: what is believed of each cell by the looks of all sensors, and view-sheds.
import {model, now, placeOf} from "./feed.js";
import {heightAt} from "./relief.js";
import {shadow, viewshed} from "./viewshed.js";

const kAgain = 1;     // [s] between two view-sheds of a UAV that flies
const kUsual = 40;    // [m] over the ground, of a UAV that is not chosen

// ---- belief: '.' never looked at, then from 0 (nothing burns there) to 9 (something does) ----

const tints = [[0, 90, 140, 100], [0, 100, 150, 82], [20, 110, 160, 66], [40, 120, 170, 50], [250, 225, 90, 60],
  [250, 200, 70, 85], [250, 165, 50, 105], [245, 125, 40, 125], [235, 85, 30, 145], [215, 45, 20, 165]];
let painted = {version: -1, picture: null};

function beliefPicture() {
  const {columns, rows} = model.world.terrain;
  if (!model.belief.size) return null;
  if (painted.version === model.beliefVersion) return painted.picture;
  const picture = new ImageData(columns, rows);
  for (const [row, cells] of model.belief) for (let i = 0; i < columns; i += 1) {
    const tint = tints[cells.charCodeAt(i) - 48];
    if (tint) picture.data.set(tint, ((rows - 1 - row) * columns + i) * 4);
  }
  const out = painted.picture ?? document.createElement("canvas");
  if (out.width !== columns || out.height !== rows) { out.width = columns; out.height = rows; }
  out.getContext("2d").putImageData(picture, 0, 0);
  painted = {version: model.beliefVersion, picture: out};
  return out;
}

// ---- view-sheds ----

let shed = {key: "", at: -Infinity, picture: null};

/** From where, how high over the ground, and what that says. Null: of nothing. */
function wanted({viewshed: kind, chosen}) {
  const one = model.uavs.get(chosen), at = one && placeOf(one);
  if (kind === "ground") {
    const [x, y, z] = model.world.ground, height = at && one.board?.airborne ? Math.max(2, Math.round((at.z - heightAt(at.x, at.y)) / 5) * 5) : kUsual;
    return {from: [x, y, z ?? heightAt(x, y) + 5], height, caption: `dark: not heard by the ground ${height} m over it, for want of a line of sight`};
  }
  if (kind === "uav" && at) return {from: [at.x, at.y, at.z], height: 1, caption: `dark: not seen by ${chosen}`};
  return null;
}

function shedPicture(view) {
  const query = wanted(view);
  if (!query) { shed = {key: "", at: -Infinity, picture: null}; return null; }
  const key = JSON.stringify([query.from.map((v) => Math.round(v)), query.height, query.caption]);
  const late = view.viewshed === "ground" || Math.abs(now() - shed.at) >= kAgain || !shed.picture;
  if (key !== shed.key && late) shed = {key, at: now(), picture: shadow(model.world.terrain, viewshed(model.world.terrain, query.from, query.height)), caption: query.caption};
  return shed.picture && {picture: shed.picture, version: shed.key, caption: shed.caption};
}

/** What lies over the relief now, lowest first: [{picture, version, caption}]; a picture of another version is another picture. */
export function pictures(view) {
  const out = [], belief = view.layers.belief && beliefPicture(), hidden = shedPicture(view);
  if (hidden) out.push(hidden);
  if (belief) out.push({picture: belief, version: `belief ${painted.version}`, caption: "blue: looked at, nothing found; yellow to red: belief of fire"});
  return out;
}
