// SPDX-License-Identifier: Apache-2.0
// Commands bound to the streams of the process.
#pragma once

#include <unistd.h>

#include <iostream>

namespace skein::cli {

/// A command that writes its data to stdout and its messages to stderr.
template <class Options>
auto on_streams(int (*command)(const Options&, std::ostream&, std::ostream&)) {
  return [command](const Options& options) { return command(options, std::cout, std::cerr); };
}

/// One that also shows how far it is, to people.
template <class Options>
auto with_progress(int (*command)(const Options&, std::ostream&, std::ostream&)) {
  return [command](Options options) {
    options.on_terminal = isatty(STDERR_FILENO) != 0;
    return command(options, std::cout, std::cerr);
  };
}

}  // namespace skein::cli
