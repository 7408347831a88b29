// SPDX-License-Identifier: Apache-2.0
#include "choices.hpp"

#include <cmath>
#include <set>

namespace skein::interaction {

std::optional<std::string> problem_of_choices(const Rows& offer, const std::string& name,
                                              std::size_t choices) {
  std::set<double> seen;
  for (const Row& row : offer) {
    if (row.name != name || row.numbers.size() != 2) return "'" + row.name + "' is no " + name;
    const double which = row.numbers[0];
    const bool there = which >= 0 && which < static_cast<double>(choices);
    if (!there || which != std::floor(which)) {
      return "there is no such " + name + ", only 0 to " + std::to_string(choices - 1);
    }
    if (!seen.insert(which).second) return "two costs of one " + name;
    if (!(row.numbers[1] >= 0)) return "a " + name + " costs less than nothing";
  }
  return std::nullopt;
}

std::vector<std::optional<double>> costs_of_choices(const Rows& offer, std::size_t choices) {
  std::vector<std::optional<double>> costs(choices);
  for (const Row& row : offer) costs[static_cast<std::size_t>(row.numbers[0])] = row.numbers[1];
  return costs;
}

}  // namespace skein::interaction
