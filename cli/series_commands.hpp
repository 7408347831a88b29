// SPDX-License-Identifier: Apache-2.0
// The commands about many runs and about what runs left: batch, compare, series, export.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

class Actions;

/// Adds the commands. `action` and `actions` must outlive the parsing and the action.
void add_series(CLI::App& app, std::function<int()>& action, const Actions& actions);

}  // namespace skein::cli
