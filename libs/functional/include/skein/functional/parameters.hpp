// SPDX-License-Identifier: Apache-2.0
// The parameters of an elementary task, from its planner to its performer.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace skein::functional {

/// A named value: a text, or numbers. Way-points are flat: x, y, z, x, y, z, …
struct Parameter {
  std::string name;
  std::string text;             ///< empty if the value is numbers
  std::vector<double> numbers;  ///< empty if the value is a text
  bool operator==(const Parameter&) const = default;
};

/// Parameters in the order given. Duplicate names are not rejected here, but by the functional
/// layer.
class Parameters {
 public:
  Parameters() = default;
  Parameters(std::initializer_list<Parameter> all) : all_(all) {}
  explicit Parameters(std::vector<Parameter> all) : all_(std::move(all)) {}

  void add(Parameter parameter) { all_.push_back(std::move(parameter)); }
  Parameters& add(std::string name, std::string text);
  Parameters& add(std::string name, std::vector<double> numbers);
  Parameters& add(std::string name, std::initializer_list<double> numbers);
  Parameters& add(std::string name, double number);

  /// The first parameter with this name, or null. Valid until the next change. Cost: linear.
  const Parameter* find(std::string_view name) const;
  const std::vector<Parameter>& all() const { return all_; }
  bool operator==(const Parameters&) const = default;

 private:
  std::vector<Parameter> all_;
};

}  // namespace skein::functional
