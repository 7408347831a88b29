// SPDX-License-Identifier: Apache-2.0
#include "skein/elementary/parameter_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "skein/foundation/nearest.hpp"

namespace skein::elementary {

void ParameterReader::names(const std::vector<std::string>& known) {
  std::set<std::string> seen;
  for (const functional::Parameter& parameter : parameters_.all()) {
    const std::string& name = parameter.name;
    if (!seen.insert(name).second) refuse("parameter '" + name + "' is given twice");
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    refuse("unknown parameter '" + name + "'" + did_you_mean(nearest_name(name, known)));
  }
}

std::optional<double> ParameterReader::number(const std::string& name) {
  const functional::Parameter* found = parameters_.find(name);
  if (found == nullptr) return std::nullopt;
  if (found->numbers.size() == 1 && std::isfinite(found->numbers[0])) return found->numbers[0];
  refuse(name + " must be one number");
  return std::nullopt;
}

std::optional<std::string> ParameterReader::text(const std::string& name) {
  const functional::Parameter* found = parameters_.find(name);
  if (found == nullptr) return std::nullopt;
  if (found->numbers.empty() && !found->text.empty()) return found->text;
  refuse(name + " must be a text");
  return std::nullopt;
}

std::vector<world::Vector3> ParameterReader::points(const std::string& name) {
  const functional::Parameter* found = parameters_.find(name);
  if (found == nullptr) return {};
  const std::vector<double>& numbers = found->numbers;
  const bool finite =
      std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  if (numbers.empty() || numbers.size() % 3 != 0 || !finite) {
    refuse(name + " must be points of three finite numbers each");
    return {};
  }
  std::vector<world::Vector3> points;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return points;
}

std::string ParameterReader::reasons() const {
  std::string all;
  for (const std::string& reason : reasons_) all += (all.empty() ? "" : "; ") + reason;
  return all;
}

functional::Parameter points_parameter(std::string name,
                                       const std::vector<world::Vector3>& points) {
  std::vector<double> flat;
  for (const world::Vector3& point : points)
    flat.insert(flat.end(), {point.x(), point.y(), point.z()});
  return {std::move(name), "", std::move(flat)};
}

std::string figure(double value) {
  std::array<char, 64> text{};
  if (std::abs(value) >= 1e15) {
    std::snprintf(text.data(), text.size(), "%g", value);
    return text.data();
  }
  std::snprintf(text.data(), text.size(), "%.2f", value);
  std::string figure = text.data();
  figure.erase(figure.find_last_not_of('0') + 1);
  if (figure.back() == '.') figure.pop_back();
  return figure == "-0" ? "0" : figure;
}

}  // namespace skein::elementary
