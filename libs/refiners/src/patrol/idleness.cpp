// SPDX-License-Identifier: Apache-2.0
#include "patrol/idleness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace skein::refiners {
namespace {

/// Of a cell, in cells, and a little more.
constexpr double kHalfDiagonal = 0.7072;

}  // namespace

using world::Vector2;

IdlenessLog::IdlenessLog(const PatrolField& field, const PatrolSight& sight, double from)
    : field_(field),
      sight_(sight),
      from_(from),
      last_(field.cells.size(), 0),
      worst_(field.cells.size(), 0),
      seen_(field.cells.size(), false) {}

void IdlenessLog::fly(const Vector2& from, const Vector2& to, double until) {
  const double took = until - now_;
  sight_.for_each_near(from, to, sight_.footprint(),
                       [&](std::size_t cell, double enter, double leave) {
                         const std::uint32_t slot = field_.slot[cell];
                         if (slot == PatrolField::kNone) return;
                         const Vector2 nearest = from + (enter + leave) / 2 * (to - from);
                         if (!sight_.is_unhidden(nearest, cell)) return;
                         see(slot, now_ + enter * took, now_ + leave * took);
                       });
  now_ = until;
}

void IdlenessLog::see(std::uint32_t cell, double enter, double leave) {
  close(cell, enter, worst_, weighted_);
  last_[cell] = leave;
  seen_[cell] = true;
}

void IdlenessLog::close(std::uint32_t cell, double until, std::vector<double>& worst,
                        double& weighted) const {
  if (until <= from_ || until <= last_[cell]) return;
  const double longest = until - last_[cell], at_first = std::max(0.0, from_ - last_[cell]);
  worst[cell] = std::max(worst[cell], longest);
  weighted += field_.risk[cell] * (longest * longest - at_first * at_first) / 2;
}

PatrolFigures IdlenessLog::figures() const {
  PatrolFigures figures;
  std::vector<double> worst = worst_;
  double weighted = weighted_;
  for (std::uint32_t cell = 0; cell < last_.size(); ++cell) {
    close(cell, now_, worst, weighted);
    figures.worst_idleness = std::max(figures.worst_idleness, worst[cell]);
    figures.worst_risk_idleness =
        std::max(figures.worst_risk_idleness, field_.risk[cell] * worst[cell]);
    if (!seen_[cell]) ++figures.unseen;
  }
  if (now_ > from_ && field_.total_risk > 0)
    figures.mean_idleness = weighted / ((now_ - from_) * field_.total_risk);
  figures.cells = field_.cells.size();
  figures.hidden = field_.hidden;
  return figures;
}

PatrolFigures make_bounds(const PatrolField& field, const PatrolSight& sight, double speed,
                          double total, double window) {
  const double sigma = sight.footprint() / sight.grid().cell;
  const double rate = (2 * sigma + 1) * speed / sight.grid().cell;
  const double in_view = std::numbers::pi * (sigma + kHalfDiagonal) * (sigma + kHalfDiagonal);
  const auto cells = static_cast<double>(field.cells.size());
  double roots = 0, top = 0;
  for (const double risk : field.risk) {
    roots += std::sqrt(risk);
    top = std::max(top, risk);
  }
  PatrolFigures bounds;
  bounds.cells = field.cells.size();
  bounds.hidden = field.hidden;
  if (!(total > 0 && window > 0 && field.total_risk > 0)) return bounds;
  const double intervals = rate + cells / window;
  const double out = std::max(0.0, roots - in_view * std::sqrt(top));
  bounds.worst_idleness_bound = std::clamp((cells - in_view) / rate, 0.0, total);
  bounds.worst_risk_idleness_bound = std::max(0.0, field.total_risk - in_view * top) / intervals;
  bounds.mean_idleness_bound = out * out / (2 * intervals * field.total_risk);
  return bounds;
}

}  // namespace skein::refiners
