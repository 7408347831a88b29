// SPDX-License-Identifier: Apache-2.0
// `skein refine` and `skein terrain` on the command line.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

class Actions;

/// Adds the command; when it is chosen, parsing sets `action` to what it does. `actions` must
/// outlive the action.
void add_refine(CLI::App& app, std::function<int()>& action, const Actions& actions);
/// Likewise.
void add_terrain(CLI::App& app, std::function<int()>& action, const Actions& actions);

}  // namespace skein::cli
