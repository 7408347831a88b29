// SPDX-License-Identifier: Apache-2.0
// View-shed: from where on the ground, or at a height over it, there is a line of sight to a place. Reckoned here, over the heights that the page has
// (at most 160 x 160 of them): it costs the ground station nothing, and is as fine as what is drawn.

/** Height of the ground, bilinear between the points of the grid, which ends where the ground does. */
function level({columns, rows, heights}, x, y) {
  const cx = Math.min(Math.max(x, 0), columns - 1), cy = Math.min(Math.max(y, 0), rows - 1);
  const i = Math.min(Math.floor(cx), columns - 2), j = Math.min(Math.floor(cy), rows - 2), u = cx - i, v = cy - j;
  const k = j * columns + i;
  return (heights[k] * (1 - u) + heights[k + 1] * u) * (1 - v) + (heights[k + columns] * (1 - u) + heights[k + columns + 1] * u) * v;
}

/**
 * For each point of the grid 1 where something `height` over the ground is seen from `from` [x, y, z], else 0; rows from the south.
 * Rays go from the place to each point of the border and keep the steepest ground so far: O(border × half the width).
 */
export function viewshed(grid, from, height) {
  const {columns, rows, west, south, step} = grid, seen = new Uint8Array(columns * rows);
  const x0 = (from[0] - west) / step, y0 = (from[1] - south) / step, z0 = Math.max(from[2], level(grid, x0, y0) + 0.1);
  const ray = (x1, y1) => {
    const length = Math.hypot(x1 - x0, y1 - y0), steps = Math.max(1, Math.ceil(length * 2));
    let steepest = -Infinity;
    for (let k = 1; k <= steps; k += 1) {
      const t = k / steps, x = x0 + (x1 - x0) * t, y = y0 + (y1 - y0) * t;
      if (x < -0.5 || y < -0.5 || x > columns - 0.5 || y > rows - 0.5) continue;
      const z = level(grid, x, y), distance = length * t * step;
      if ((z + height - z0) / distance >= steepest) seen[Math.min(rows - 1, Math.max(0, Math.round(y))) * columns + Math.min(columns - 1, Math.max(0, Math.round(x)))] = 1;
      steepest = Math.max(steepest, (z - z0) / distance);
    }
  };
  for (let i = 0; i < columns; i += 1) { ray(i, 0); ray(i, rows - 1); }
  for (let j = 0; j < rows; j += 1) { ray(0, j); ray(columns - 1, j); }
  const i = Math.round(x0), j = Math.round(y0);
  if (i >= 0 && j >= 0 && i < columns && j < rows) seen[j * columns + i] = 1;
  return seen;
}

/** What is not seen, as a picture with a pixel for each point of the grid, north up. */
export function shadow({columns, rows}, seen) {
  const picture = new ImageData(columns, rows);
  for (let j = 0; j < rows; j += 1) for (let i = 0; i < columns; i += 1) {
    const k = ((rows - 1 - j) * columns + i) * 4;
    picture.data.set(seen[j * columns + i] ? [0, 0, 0, 0] : [20, 8, 46, 150], k);
  }
  const out = document.createElement("canvas");
  out.width = columns; out.height = rows;
  out.getContext("2d").putImageData(picture, 0, 0);
  return out;
}
