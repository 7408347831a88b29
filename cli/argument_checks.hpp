// SPDX-License-Identifier: Apache-2.0
// Checks of numbers given on the command line: what is wrong with the text, empty if nothing is.
// CLI11's ranges let "nan" pass and print their bounds in full.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>
#include <string>

namespace skein::cli {

inline std::string finite_problem(const std::string& text) {
  double value = 0;
  const bool number = CLI::detail::lexical_cast(text, value);
  return number && std::isfinite(value) ? "" : "'" + text + "' is not a finite number";
}

inline std::string positive_problem(const std::string& text) {
  const std::string problem = finite_problem(text);
  double value = 0;
  const bool positive = CLI::detail::lexical_cast(text, value) && value > 0;
  return problem.empty() && !positive ? "'" + text + "' is not positive" : problem;
}

/// A whole number from 0: digits only, so that "-1" and "1e3" are refused.
inline std::string whole_problem(const std::string& text) {
  const bool digits = !text.empty() && text.size() <= 18 &&
                      text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? "" : "'" + text + "' is not a whole number";
}

/// A count: a whole number from 1.
inline std::string count_problem(const std::string& text) {
  const bool positive = whole_problem(text).empty() && std::stoull(text) > 0;
  return positive ? "" : "'" + text + "' is not a positive whole number";
}

/// Of ADDRESS:PORT, ADDRESS or PORT the port: what is wrong with the address is found out by who
/// opens it. In time: who starts daemons would hear of it when one of them has ended.
inline std::string port_problem(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos && text.find('.') != std::string::npos) return "";
  const std::string port = colon == std::string::npos ? text : text.substr(colon + 1);
  const bool good = port.empty() || (whole_problem(port).empty() && std::stoull(port) <= 65535);
  return good ? "" : "'" + text + "': expected ADDRESS:PORT, with a port from 0 to 65535";
}

/// Megabytes: no machine has more than a million million.
inline std::string megabytes_problem(const std::string& text) {
  const std::string problem = positive_problem(text);
  if (!problem.empty()) return problem;
  double value = 0;
  const bool fits = CLI::detail::lexical_cast(text, value) && value <= 1e12;
  return fits ? "" : "'" + text + "' is more than 1e12 MB";
}

/// NAME=S, with a finite number.
inline std::string named_number_problem(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) return "'" + text + "': expected NAME=S";
  return finite_problem(text.substr(equals + 1));
}

/// Of all options of whole numbers from 0, of whatever command: CLI11 reads "-3" as 2^64 - 3.
inline void refuse_below_zero(CLI::App& app) {
  const auto problem = [](const std::string& text) {
    return text.starts_with('-') ? "'" + text + "' is not a whole number" : std::string();
  };
  for (CLI::Option* option : app.get_options())
    if (option->get_type_name().starts_with("UINT")) option->check(problem);
  for (CLI::App* command : app.get_subcommands({})) refuse_below_zero(*command);
}

/// An option in seconds, MissionTime or Duration. `value` is alive when the line is read.
template <class Time>
CLI::Option* add_seconds(CLI::App& command, const std::string& name, std::optional<Time>& value,
                         const std::string& help) {
  return command.add_option_function<double>(
      name, [&value](double seconds) { value = Time::seconds(seconds); }, help);
}

}  // namespace skein::cli
