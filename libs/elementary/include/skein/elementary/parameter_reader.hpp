// SPDX-License-Identifier: Apache-2.0
// Strict reading of task parameters: every reason for refusal, not the first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/functional/parameters.hpp"
#include "skein/world/geometry.hpp"

namespace skein::elementary {

/// Lifetime: the parameters must outlive it.
class ParameterReader {
 public:
  explicit ParameterReader(const functional::Parameters& parameters) : parameters_(parameters) {}

  /// Refuses unknown and repeated names.
  void names(const std::vector<std::string>& known);
  /// A finite number; absent in silence.
  std::optional<double> number(const std::string& name);
  /// A text that is not empty; absent in silence.
  std::optional<std::string> text(const std::string& name);
  /// Finite points, x y z each; none if absent, in silence.
  std::vector<world::Vector3> points(const std::string& name);

  void refuse(std::string reason) { reasons_.push_back(std::move(reason)); }
  bool has(const std::string& name) const { return parameters_.find(name) != nullptr; }
  bool refused() const { return !reasons_.empty(); }
  std::string reasons() const;

 private:
  const functional::Parameters& parameters_;
  std::vector<std::string> reasons_;
};

/// Points as a parameter has them: x y z each, flat. ParameterReader::points reads them.
functional::Parameter points_parameter(std::string name, const std::vector<world::Vector3>& points);

/// A figure for a sentence: at most two decimals, no trailing zeros.
std::string figure(double value);

}  // namespace skein::elementary
