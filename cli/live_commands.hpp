// SPDX-License-Identifier: Apache-2.0
// The commands that meet daemons, DDS and what they leave: replay, operate, status, spy,
// functional, state.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

class Actions;

/// Adds the commands. `action` and `actions` must outlive the parsing and the action.
void add_live(CLI::App& app, std::function<int()>& action, const Actions& actions);

}  // namespace skein::cli
