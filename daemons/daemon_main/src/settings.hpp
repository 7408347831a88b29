// SPDX-License-Identifier: Apache-2.0
// Option values of a program from command line, environment, file, or default.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/config/value.hpp"
#include "skein/foundation/diagnostics.hpp"

namespace skein::daemon_main {

/// The value of a variable of the environment; null if it is not set.
using Environment = std::function<const char*(const char* name)>;

/// Completes the options of a program after its command line was parsed: an option that was not
/// given is taken from the environment (`--log-level` from SKEIN_LOG_LEVEL; an empty variable
/// counts as unset), then from a YAML file (`log-level: info`; lists as lists), else keeps its
/// default. Options that only the command line has (`--help`) are exempted.
class Settings {
 public:
  /// The app must outlive this object. `own`: long names of options that only the command line has.
  Settings(CLI::App& app, std::vector<std::string> own);

  /// Completes the options. Returns invalid values and unknown keys, each with the variable or the
  /// position in the file. An empty path: no file.
  Diagnostics complete(const Environment& environment, const std::string& file);

  /// Every option with its value and where that came from; itself a file that complete() reads.
  std::string shown() const;

 private:
  void take_environment(const Environment& environment, Diagnostics& problems);
  void take_file(const std::string& file, Diagnostics& problems);
  void take(CLI::Option& option, const std::vector<std::string>& values, const std::string& origin,
            Diagnostic place, Diagnostics& problems);

  std::vector<CLI::Option*> options_;                  ///< in the order declared
  std::map<const CLI::Option*, std::string> origins_;  ///< of those that are not defaults
};

}  // namespace skein::daemon_main
