// SPDX-License-Identifier: Apache-2.0
// The ground: how high it is, and its picture.
import {el} from "./dom.js";
import {model} from "./feed.js";

const ramp = [[0, [93, 124, 96]], [0.3, [139, 155, 106]], [0.6, [190, 178, 132]], [0.85, [205, 190, 165]], [1, [232, 226, 214]]];

function tint(share) {
  let i = 1;
  while (i < ramp.length - 1 && share > ramp[i][0]) i += 1;
  const [a, low] = ramp[i - 1], [b, high] = ramp[i];
  const t = Math.min(1, Math.max(0, (share - a) / (b - a)));
  return low.map((c, k) => c + (high[k] - c) * t);
}

const cubic = (a, b, c, d, t) => b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));

/** Between the points of the grid: Catmull and Rom's curve each way, so that slopes have no edges. */
function smooth(grid, x, y) {
  const {columns, rows, heights} = grid;
  const cx = Math.min(Math.max(x, 0), columns - 1.001), cy = Math.min(Math.max(y, 0), rows - 1.001);
  const i = Math.floor(cx), j = Math.floor(cy), u = cx - i, v = cy - j;
  const line = [0, 0, 0, 0];
  for (let b = -1; b < 3; b += 1) {
    const row = Math.min(Math.max(j + b, 0), rows - 1) * columns;
    const at = (a) => heights[row + Math.min(Math.max(i + a, 0), columns - 1)];
    line[b + 1] = cubic(at(-1), at(0), at(1), at(2), u);
  }
  return cubic(line[0], line[1], line[2], line[3], v);
}

export function heightAt(x, y) {
  const grid = model.world?.terrain;
  return grid ? smooth(grid, (x - grid.west) / grid.step, (y - grid.south) / grid.step) : 0;
}

/** Hill shading over tints of height, with contour lines. Light from the north-west. {picture, caption} */
export function drawRelief(grid) {
  const least = Math.min(...grid.heights), most = Math.max(...grid.heights);
  const fine = Math.max(1, Math.min(8, Math.floor(900 / Math.max(grid.columns, grid.rows))));
  const w = (grid.columns - 1) * fine + 1, h = (grid.rows - 1) * fine + 1;
  const picture = new ImageData(w, h);
  const range = Math.max(most - least, 20);
  const every = [1, 2, 5, 10, 20, 50, 100, 200].find((one) => range / one < 16) ?? 500;
  const z = new Float32Array(w * h);
  for (let j = 0; j < h; j += 1) for (let i = 0; i < w; i += 1) z[j * w + i] = Math.max(least, smooth(grid, i / fine, j / fine));   // no line where the curve swings below level ground
  const cell = grid.step / fine, steep = 2.2;
  for (let j = 0; j < h; j += 1) {
    for (let i = 0; i < w; i += 1) {
      const here = z[j * w + i];
      const e = z[j * w + Math.min(i + 1, w - 1)], n = z[Math.min(j + 1, h - 1) * w + i];
      const dx = ((e - z[j * w + Math.max(i - 1, 0)]) / (2 * cell)) * steep, dy = ((n - z[Math.max(j - 1, 0) * w + i]) / (2 * cell)) * steep;
      const light = (0.55 * dx - 0.55 * dy + 0.63) / Math.sqrt(dx * dx + dy * dy + 1);
      const shade = 0.52 + 0.55 * Math.max(0, light);
      const level = Math.floor(here / every);
      const contour = level !== Math.floor(e / every) || level !== Math.floor(n / every);
      const strong = contour && Math.max(level, Math.floor(e / every), Math.floor(n / every)) % 5 === 0;
      const colour = tint((here - least) / range);
      const k = ((h - 1 - j) * w + i) * 4;
      for (let c = 0; c < 3; c += 1) picture.data[k + c] = colour[c] * shade * (strong ? 0.74 : contour ? 0.88 : 1);
      picture.data[k + 3] = 255;
    }
  }
  const out = el("canvas", {width: w, height: h});
  out.getContext("2d").putImageData(picture, 0, 0);
  return {picture: out, caption: `ground ${least.toFixed(0)} to ${most.toFixed(0)} m, lines each ${every} m`};
}
