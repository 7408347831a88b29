// SPDX-License-Identifier: Apache-2.0
// Commands bound to the streams of the process.
#pragma once

#include <unistd.h>

#include <fstream>
#include <iostream>
#include <string>

#include "actions.hpp"
#include "skein/foundation/exit_code.hpp"

namespace skein::cli {

/// A command that writes its data to stdout and its messages to stderr.
template <class Options>
Actions::Action<Options> on_streams(int (*command)(const Options&, std::ostream&, std::ostream&)) {
  return [command](const Options& options) { return command(options, std::cout, std::cerr); };
}

/// One that also reads stdin, where its options name no file or "-".
template <class Options>
Actions::Action<Options> on_streams(int (*command)(const Options&, std::istream&, std::ostream&,
                                                   std::ostream&)) {
  return [command](const Options& options) {
    return command(options, std::cin, std::cout, std::cerr);
  };
}

/// One whose input is the file named by `name`, a member of its options: stdin if that is empty or
/// "-".
template <class Options>
Actions::Action<Options> on_file(int (*command)(const Options&, std::istream&, std::ostream&,
                                                std::ostream&),
                                 std::string Options::*name) {
  return [command, name](Options options) {
    if (options.*name == "-") (options.*name).clear();
    if ((options.*name).empty()) return command(options, std::cin, std::cout, std::cerr);
    std::ifstream in(options.*name);
    if (in) return command(options, in, std::cout, std::cerr);
    std::cerr << options.*name << ": cannot be read\n";
    return static_cast<int>(kExitBadInput);
  };
}

/// One that also shows how far it is, to people.
template <class Options>
Actions::Action<Options> with_progress(int (*command)(const Options&, std::ostream&,
                                                      std::ostream&)) {
  return [command](Options options) {
    options.on_terminal = isatty(STDERR_FILENO) != 0;
    return command(options, std::cout, std::cerr);
  };
}

}  // namespace skein::cli
