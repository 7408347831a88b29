// SPDX-License-Identifier: Apache-2.0
// `skein plan` on the command line.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

/// Adds the sub-command; when it is given, `action` becomes what is to be done.
void add_plan(CLI::App& app, std::function<int()>& action);

}  // namespace skein::cli
