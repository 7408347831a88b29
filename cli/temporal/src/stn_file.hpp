// SPDX-License-Identifier: Apache-2.0
// Networks from files and standard input, results to files and standard output.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "skein/temporal_files/network_text.hpp"
#include "skein/temporal_tool/stn.hpp"

namespace skein::temporal_tool {

/// What messages call the input.
std::string input_name(const StnOptions& options);

/// Nothing, and messages on `err`, when it cannot be read.
std::optional<temporal::ReadNetwork> load_network(const StnOptions& options, std::istream& in,
                                                  std::ostream& err);

/// Nothing when it cannot be read.
std::optional<std::string> text_of_file(const std::string& file);

/// The format of that name; nothing, and a message about `--to` on `err`, when there is none.
std::optional<temporal::Format> format_option(const std::string& name, std::ostream& err);

/// To the file, or to `out` without one. An exit code.
int save_text(const std::string& file, const std::string& text, std::ostream& out,
              std::ostream& err);

}  // namespace skein::temporal_tool
