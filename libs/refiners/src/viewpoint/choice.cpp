// SPDX-License-Identifier: Apache-2.0
#include "viewpoint/choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace skein::refiners {
namespace {

/// Azimuths that are looked at when they are chosen together: a multiple of most small numbers.
constexpr std::int32_t kSlots = 240;
constexpr double kNever = -std::numeric_limits<double>::infinity();

double angle_between(const Bearing& a, const Bearing& b) {
  const std::int32_t turn = std::abs(a.azimuth - b.azimuth);
  return Bearing::radians(std::min(turn, Bearing::kTurn - turn));
}

bool are_apart(const ViewpointField& field, const Bearing& bearing, const world::Vector3& position,
               const Found& other) {
  const double least = field.query().least_angle;
  if (least > 0 && angle_between(bearing, other.bearing) < least - 1e-12) return false;
  return (position - other.position).norm() >= kLeastApart * field.whole().range_end;
}

bool is_apart_from_all(const ViewpointField& field, const Bearing& bearing,
                       const world::Vector3& position, const std::vector<Found>& others) {
  return std::all_of(others.begin(), others.end(), [&](const Found& other) {
    return are_apart(field, bearing, position, other);
  });
}

std::vector<Found> choose_one_by_one(ViewpointSearch& search, const ViewpointField& field,
                                     const Countdown& countdown) {
  std::vector<Found> chosen;
  const auto is_apart = [&](const Bearing& bearing, const world::Vector3& position) {
    return is_apart_from_all(field, bearing, position, chosen);
  };
  while (chosen.size() < field.query().count && !countdown.over()) {
    const auto found = search.best(chosen.empty() ? ViewpointSearch::IsApart{} : is_apart);
    if (!found) break;
    chosen.push_back(*found);
  }
  return chosen;
}

std::vector<Found> choose_together(ViewpointSearch& search, const ViewpointField& field) {
  std::vector<std::optional<Found>> along(kSlots);
  std::vector<std::optional<double>> utilities(kSlots);
  for (std::int32_t slot = 0; slot < kSlots; ++slot) {
    const auto index = static_cast<std::size_t>(slot);
    along[index] = search.best_along(Bearing::kTurn / kSlots * slot);
    if (along[index]) utilities[index] = along[index]->utility;
  }
  const auto gap = static_cast<std::size_t>(
      std::ceil(field.query().least_angle / (2 * std::numbers::pi) * kSlots - 1e-9));
  std::vector<Found> chosen;
  for (const std::size_t slot : choose_around(utilities, gap, field.query().count)) {
    const Found& found = *along[slot];
    if (is_apart_from_all(field, found.bearing, found.position, chosen)) chosen.push_back(found);
  }
  return chosen;
}

}  // namespace

std::vector<Found> choose(ViewpointSearch& search, const ViewpointField& field,
                          const Countdown& countdown) {
  std::vector<Found> chosen = choose_one_by_one(search, field, countdown);
  const double least = field.query().least_angle;
  if (least > 0 && !chosen.empty() && !countdown.over()) {
    const auto room = static_cast<std::size_t>(2 * std::numbers::pi / least + 1e-9);
    if (chosen.size() < std::min(field.query().count, room))
      if (auto together = choose_together(search, field); together.size() > chosen.size())
        chosen = std::move(together);
  }
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const Found& a, const Found& b) { return a.utility > b.utility; });
  return chosen;
}

namespace {

/// The best choice of which `start` is the first slot.
class Row {
 public:
  Row(const std::vector<std::optional<double>>& utilities, std::size_t gap, std::size_t start)
      : utilities_(utilities), gap_(gap), start_(start) {}

  /// Sums of the best choices of 1, 2, … slots that begin with `start`.
  std::vector<double> sums(std::size_t count);
  std::vector<std::size_t> slots(std::size_t count) const;

 private:
  std::size_t last() const {  // beyond it the first slot is too near, going on around
    const std::size_t n = utilities_.size();
    return std::min(n - 1, start_ + n - std::max<std::size_t>(gap_, 1));
  }

  const std::vector<std::optional<double>>& utilities_;
  std::size_t gap_, start_;
  std::vector<std::vector<double>> best_;  // [chosen - 1][slot]: that slot is the last chosen
  std::vector<std::vector<std::size_t>> before_;  // the slot chosen before it
};

std::vector<double> Row::sums(std::size_t count) {
  const std::size_t n = utilities_.size(), step = std::max<std::size_t>(gap_, 1);
  std::vector<double> sums;
  best_.assign(1, std::vector<double>(n, kNever));
  before_.assign(1, std::vector<std::size_t>(n, start_));
  best_[0][start_] = *utilities_[start_];
  sums.push_back(best_[0][start_]);
  while (sums.size() < count) {
    std::vector<double> next(n, kNever);
    std::vector<std::size_t> from(n, start_);
    double top = kNever;
    std::size_t at = start_;  // the best last slot that is far enough back
    for (std::size_t slot = start_ + step; slot <= last(); ++slot) {
      if (best_.back()[slot - step] > best_.back()[at]) at = slot - step;
      if (!utilities_[slot] || best_.back()[at] == kNever) continue;
      next[slot] = best_.back()[at] + *utilities_[slot];
      from[slot] = at;
      top = std::max(top, next[slot]);
    }
    if (top == kNever) break;
    best_.push_back(std::move(next));
    before_.push_back(std::move(from));
    sums.push_back(top);
  }
  return sums;
}

std::vector<std::size_t> Row::slots(std::size_t count) const {
  const std::vector<double>& final = best_[count - 1];
  auto slot =
      static_cast<std::size_t>(std::max_element(final.begin(), final.end()) - final.begin());
  std::vector<std::size_t> slots;
  for (std::size_t left = count; left-- > 0; slot = before_[left][slot]) slots.push_back(slot);
  return slots;
}

}  // namespace

std::vector<std::size_t> choose_around(const std::vector<std::optional<double>>& utilities,
                                       std::size_t gap, std::size_t count) {
  std::vector<std::size_t> best;
  double best_sum = kNever;
  for (std::size_t start = 0; start < utilities.size(); ++start) {
    if (!utilities[start]) continue;
    Row row(utilities, gap, start);
    const std::vector<double> sums = row.sums(count);
    if (sums.size() < best.size()) continue;
    if (sums.size() == best.size() && sums.back() <= best_sum) continue;
    best = row.slots(sums.size());
    best_sum = sums.back();
  }
  return best;
}

}  // namespace skein::refiners
