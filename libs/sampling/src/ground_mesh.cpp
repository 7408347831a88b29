// SPDX-License-Identifier: Apache-2.0
#include "ground_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace skein::sampling {
namespace {

using world::Vector3;

/// More cuts than that along the side of a cell are a wall, not ground.
constexpr double kMostCuts = 16;
/// Cells along the side of a tile, and triangles after which another is begun all the same.
constexpr std::size_t kTile = 32, kManyTriangles = 4096;

/// The ends of the region, and the lines between the terrain's cells within it.
std::vector<double> lines_of(double from, double until, double low, double high, double cell) {
  std::vector<double> lines = {from};
  const auto add = [&](double line) {
    if (line > lines.back() + 1e-6 && line < until - 1e-6) lines.push_back(line);
  };
  const double first = std::max(0.0, std::floor((from - low) / cell));
  const double last = std::floor((std::min(until, high) - low) / cell);
  for (double i = first; i <= last; ++i) add(low + i * cell);
  add(high);
  lines.push_back(until);
  return lines;
}

/// Every so manyeth, and the last.
std::vector<double> thinned(const std::vector<double>& lines, std::size_t every) {
  std::vector<double> kept;
  for (std::size_t i = 0; i + 1 < lines.size(); i += every) kept.push_back(lines[i]);
  kept.push_back(lines.back());
  return kept;
}

std::size_t index_in(const std::vector<double>& lines, double at) {
  const auto above = std::upper_bound(lines.begin(), lines.end(), at);
  const auto index = std::max<std::ptrdiff_t>(0, above - lines.begin() - 1);
  return std::min(static_cast<std::size_t>(index), lines.size() - 2);
}

}  // namespace

double GroundMesh::Cell::at(double u, double v) const {
  return (corners[0] * (1 - u) + corners[1] * u) * (1 - v) +
         (corners[2] * (1 - u) + corners[3] * u) * v;
}

GroundMesh::GroundMesh(const world::Terrain& terrain, const Region& region, double accuracy,
                       std::size_t most_triangles, const std::function<bool()>& is_late) {
  for (std::size_t merged = 1;; merged *= 2) {
    set_lines(terrain, region, merged);
    const bool fits = 2 * (xs_.size() - 1) * (ys_.size() - 1) <= most_triangles;
    if (!fits && (xs_.size() > 2 || ys_.size() > 2)) continue;
    set_cells(terrain, merged > 1, is_late);
    break;
  }
  if (!whole_) return;
  double allowed = accuracy;
  while (cut(allowed) > most_triangles && allowed < 1e6) allowed *= 2;
  emit(is_late);
}

void GroundMesh::set_lines(const world::Terrain& terrain, const Region& region,
                           std::size_t merged) {
  const world::TerrainSpec& spec = terrain.spec();
  xs_ = thinned(lines_of(region.west, region.east, spec.west, spec.east, spec.cell), merged);
  ys_ = thinned(lines_of(region.south, region.north, spec.south, spec.north, spec.cell), merged);
}

/// Between the terrain's own lines the corners give the surface. Merged cells get, at each corner,
/// the highest that any cell around it holds: level enough to be above them all.
void GroundMesh::set_cells(const world::Terrain& terrain, bool merged,
                           const std::function<bool()>& is_late) {
  const std::size_t columns = xs_.size(), rows = ys_.size();
  std::vector<double> heights(columns * rows);
  const double cell = terrain.spec().cell;
  const auto highest_around = [&](std::size_t i, std::size_t j) {
    const double west = xs_[i > 0 ? i - 1 : 0], east = xs_[std::min(i + 1, columns - 1)];
    const double south = ys_[j > 0 ? j - 1 : 0], north = ys_[std::min(j + 1, rows - 1)];
    double highest = terrain.elevation(west, south);
    // Heights at the terrain's own lines, and at the ends: no surface in between is higher.
    for (const double x : lines_of(west, east, terrain.spec().west, terrain.spec().east, cell))
      for (const double y :
           lines_of(south, north, terrain.spec().south, terrain.spec().north, cell))
        highest = std::max(highest, terrain.elevation(x, y));
    return highest;
  };
  for (std::size_t j = 0; j < rows; ++j) {
    if (is_late && is_late()) whole_ = false;
    if (!whole_) return;
    for (std::size_t i = 0; i < columns; ++i)
      heights[j * columns + i] = merged ? highest_around(i, j) : terrain.elevation(xs_[i], ys_[j]);
  }
  highest_ = *std::max_element(heights.begin(), heights.end());
  cells_.resize((columns - 1) * (rows - 1));
  for (std::size_t j = 0; j + 1 < rows; ++j)
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const double* south = &heights[j * columns + i];
      cells_[j * (columns - 1) + i].corners = {south[0], south[1], south[columns],
                                               south[columns + 1]};
    }
}

std::size_t GroundMesh::cut(double accuracy) {
  std::size_t count = 0;
  for (Cell& cell : cells_) {
    const double cuts = std::ceil(std::sqrt(std::abs(cell.twist()) / 4 / accuracy));
    cell.cuts = static_cast<std::uint32_t>(std::clamp(cuts, 1.0, kMostCuts));
    count += 2U * cell.cuts * cell.cuts;
  }
  return count;
}

void GroundMesh::emit(const std::function<bool()>& is_late) {
  for (std::size_t row = 0; row + 1 < ys_.size(); row += kTile)
    for (std::size_t column = 0; column + 1 < xs_.size(); column += kTile) {
      if (is_late && is_late()) whole_ = false;
      if (!whole_) return;
      emit_tile(column, row);
    }
}

void GroundMesh::emit_tile(std::size_t column, std::size_t row) {
  const std::size_t east = std::min(column + kTile, xs_.size() - 1);
  const std::size_t north = std::min(row + kTile, ys_.size() - 1);
  for (std::size_t y = row; y < north; ++y)
    for (std::size_t x = column; x < east; ++x) {
      const Cell& here = cell(x, y);
      for (std::uint32_t j = 0; j < here.cuts; ++j)
        for (std::uint32_t i = 0; i < here.cuts; ++i) emit_patch(here, x, y, i, j);
      const std::size_t begun = tiles_.empty() ? 0 : tiles_.back().end;
      if (triangles_.size() - begun >= kManyTriangles) end_tile();
    }
  end_tile();
}

void GroundMesh::end_tile() {
  const std::size_t begun = tiles_.empty() ? 0 : tiles_.back().end;
  if (begun == triangles_.size()) return;
  const std::size_t first_vertex = tiles_.empty() ? 0 : tiles_.back().end_vertex;
  tiles_.push_back({begun, triangles_.size(), first_vertex, vertices_.size()});
}

void GroundMesh::emit_patch(const Cell& here, std::size_t column, std::size_t row, std::uint32_t i,
                            std::uint32_t j) {
  const auto first = static_cast<std::uint32_t>(vertices_.size());
  for (const std::uint32_t dj : {0U, 1U})
    for (const std::uint32_t di : {0U, 1U}) {
      const double u = static_cast<double>(i + di) / here.cuts;
      const double v = static_cast<double>(j + dj) / here.cuts;
      vertices_.emplace_back(xs_[column] + u * (xs_[column + 1] - xs_[column]),
                             ys_[row] + v * (ys_[row + 1] - ys_[row]), here.at(u, v));
    }
  if (here.twist() > 0) {
    triangles_.push_back({first, first + 1, first + 3});
    triangles_.push_back({first, first + 3, first + 2});
  } else {
    triangles_.push_back({first, first + 1, first + 2});
    triangles_.push_back({first + 1, first + 3, first + 2});
  }
}

double GroundMesh::height(double x, double y) const {
  const double px = std::clamp(x, xs_.front(), xs_.back());
  const double py = std::clamp(y, ys_.front(), ys_.back());
  const std::size_t column = index_in(xs_, px), row = index_in(ys_, py);
  const Cell& here = cell(column, row);
  const double cuts = here.cuts;
  const double u = (px - xs_[column]) / (xs_[column + 1] - xs_[column]) * cuts;
  const double v = (py - ys_[row]) / (ys_[row + 1] - ys_[row]) * cuts;
  const double i = std::min(std::floor(u), cuts - 1), j = std::min(std::floor(v), cuts - 1);
  const double fu = u - i, fv = v - j;
  const double sw = here.at(i / cuts, j / cuts), se = here.at((i + 1) / cuts, j / cuts);
  const double nw = here.at(i / cuts, (j + 1) / cuts);
  const double ne = here.at((i + 1) / cuts, (j + 1) / cuts);
  if (here.twist() > 0)
    return fu >= fv ? sw + (se - sw) * fu + (ne - se) * fv : sw + (ne - nw) * fu + (nw - sw) * fv;
  if (fu + fv <= 1) return sw + (se - sw) * fu + (nw - sw) * fv;
  return ne + (nw - ne) * (1 - fu) + (se - ne) * (1 - fv);
}

}  // namespace skein::sampling
