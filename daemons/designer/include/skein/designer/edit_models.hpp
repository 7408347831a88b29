// SPDX-License-Identifier: Apache-2.0
// `skein model edit`: the designer on this machine, without a team.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace skein::designer {

struct EditOptions {
  std::vector<std::string> files;
  std::uint16_t port = 0;  ///< of the loopback interface; 0: any that is free
};

/// Serves the page until interrupted, and prints its address. Exit codes: 0 interrupted, 2 an
/// existing file cannot be read, 3 the port is taken.
int edit_models(const EditOptions& options, std::ostream& out, std::ostream& err);

}  // namespace skein::designer
