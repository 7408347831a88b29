// SPDX-License-Identifier: Apache-2.0
// `skein stn` on the command line.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

class Actions;

/// Adds the command; when it is chosen, parsing sets `action` to what it does.
void add_stn(CLI::App& app, std::function<int()>& action, const Actions& actions);

}  // namespace skein::cli
