// SPDX-License-Identifier: Apache-2.0
#include "skein/world/radio_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace skein::world {
namespace {

constexpr double kFreeSpaceExponent = 2;
/// The log-distance law refers to the loss at this distance [m].
constexpr double kReferenceDistance = 1;

void check_budget(const LinkBudget& budget, std::vector<std::string>& problems) {
  if (!std::isfinite(budget.emission_power) || !std::isfinite(budget.sensitivity) ||
      !std::isfinite(budget.reference_loss))
    problems.emplace_back("radio: the powers and the loss of the budget must be finite");
  if (!(budget.path_loss_exponent > 0 && std::isfinite(budget.path_loss_exponent)))
    problems.emplace_back("radio: the path loss exponent must be greater than 0");
  if (!problems.empty()) return;
  if (budget.emission_power - budget.reference_loss <= budget.sensitivity)
    problems.emplace_back("radio: the budget leaves nothing to receive at 1 m");
  else if (!std::isfinite(budget.range()))
    problems.emplace_back("radio: the budget gives no finite range");
}

}  // namespace

double LinkBudget::range() const {
  const double decades =
      (emission_power - reference_loss - sensitivity) / (10 * path_loss_exponent);
  return kReferenceDistance * std::pow(10, decades);
}

double RadioModel::reach() const { return budget ? budget->range() : range; }

RadioLink RadioModel::link(const Vector3& a, const Vector3& b, const Terrain& terrain,
                           bool was_up) const {
  const double limit = was_up ? reach() * (1 + hysteresis) : reach();
  const bool heard =
      (a - b).norm() <= limit && (!needs_line_of_sight || terrain.line_of_sight(a, b));
  if (!heard) return {false, Duration(), 1};
  return {true, latency, loss, capacity};
}

double RadioModel::margin(double distance) const {
  const double far = reach();
  const double exponent = budget ? budget->path_loss_exponent : kFreeSpaceExponent;
  const double counted = std::max(distance, std::min(kReferenceDistance, far));
  const double above = 10 * exponent * std::log10(far / counted);
  // Rounding may not lift a place just beyond the reach to 0.
  return counted <= far ? above : std::min(above, -std::numeric_limits<double>::epsilon());
}

double RadioModel::margin(const Vector3& a, const Vector3& b, const Terrain& terrain) const {
  if (needs_line_of_sight && !terrain.line_of_sight(a, b))
    return -std::numeric_limits<double>::infinity();
  return margin((a - b).norm());
}

std::vector<double> RadioModel::coverage(const Vector3& point, const Grid& grid,
                                         const Terrain& terrain, double height) const {
  std::vector<double> margins(grid.size());
  for (std::size_t i = 0; i < margins.size(); ++i) {
    const Vector2 centre = grid.centre(i);
    const Vector3 receiver(centre.x(), centre.y(),
                           terrain.elevation(centre.x(), centre.y()) + height);
    const double by_distance = margin((receiver - point).norm());
    margins[i] = by_distance < 0 ? by_distance : margin(point, receiver, terrain);
  }
  return margins;
}

std::vector<std::string> problems_of(const RadioModel& radio) {
  std::vector<std::string> problems;
  if (radio.budget)
    check_budget(*radio.budget, problems);
  else if (!(radio.range > 0 && std::isfinite(radio.range)))
    problems.emplace_back("radio: the range must be finite and greater than 0");
  if (!(radio.loss >= 0 && radio.loss < 1))
    problems.emplace_back("radio: the loss must be at least 0 and less than 1");
  if (!(radio.capacity >= 0 && std::isfinite(radio.capacity)))
    problems.emplace_back("radio: the capacity must be finite and at least 0");
  if (radio.latency < Duration()) problems.emplace_back("radio: the latency is negative");
  if (!(radio.hysteresis >= 0 && std::isfinite(radio.hysteresis)))
    problems.emplace_back("radio: the hysteresis must be finite and at least 0");
  return problems;
}

}  // namespace skein::world
