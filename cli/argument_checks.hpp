// SPDX-License-Identifier: Apache-2.0
// Checks of numbers given on the command line: what is wrong with the text, empty if nothing is.
// CLI11's ranges let "nan" pass and print their bounds in full.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace skein::cli {

inline std::string finite_problem(const std::string& text) {
  double value = 0;
  const bool number = CLI::detail::lexical_cast(text, value);
  return number && std::isfinite(value) ? "" : "'" + text + "' is not a finite number";
}

inline std::string positive_problem(const std::string& text) {
  const std::string problem = finite_problem(text);
  return problem.empty() && std::stod(text) <= 0 ? "'" + text + "' is not positive" : problem;
}

/// A count: digits only, so that "-1" and "1e3" are refused.
inline std::string count_problem(const std::string& text) {
  const bool digits = !text.empty() && text.size() <= 18 &&
                      text.find_first_not_of("0123456789") == std::string::npos;
  return digits && std::stoull(text) > 0 ? "" : "'" + text + "' is not a positive whole number";
}

}  // namespace skein::cli
