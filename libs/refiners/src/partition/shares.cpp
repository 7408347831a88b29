// SPDX-License-Identifier: Apache-2.0
#include "partition/shares.hpp"

#include <algorithm>

namespace skein::refiners::partition {
namespace {

double total_rate(const std::vector<Ability>& abilities) {
  double total = 0;
  for (const Ability& ability : abilities) total += ability.rate;
  return total;
}

class Sharing {
 public:
  Sharing(const std::vector<Ability>& abilities, double area)
      : abilities_(abilities), least_time_(kLeastPart * area / total_rate(abilities)) {}

  double swept(const Ability& ability, double end) const {
    return std::min(ability.limit, ability.rate * std::max(end - ability.ready, least_time_));
  }
  double swept(double end) const {
    double total = 0;
    for (const Ability& ability : abilities_) total += swept(ability, end);
    return total;
  }

 private:
  const std::vector<Ability>& abilities_;
  double least_time_;
};

}  // namespace

std::optional<std::vector<double>> fair_areas(const std::vector<Ability>& abilities, double area) {
  double limits = 0, latest = 0, slowest = abilities.front().rate;
  for (const Ability& ability : abilities) {
    limits += ability.limit;
    latest = std::max(latest, ability.ready);
    slowest = std::min(slowest, ability.rate);
  }
  if (!(limits >= area)) return std::nullopt;
  const Sharing sharing(abilities, area);
  double early = 0, late = latest + area / slowest;  // by then all are at their limits or done
  for (int i = 0; i < 200 && early < late; ++i) {
    const double middle = (early + late) / 2;
    if (middle == early || middle == late) break;
    (sharing.swept(middle) < area ? early : late) = middle;
  }
  std::vector<double> areas;
  for (const Ability& ability : abilities) areas.push_back(sharing.swept(ability, late));
  double total = 0;
  for (const double one : areas) total += one;
  for (double& one : areas) one *= area / total;  // the last rounding; the least parts, if too many
  return areas;
}

}  // namespace skein::refiners::partition
