// SPDX-License-Identifier: Apache-2.0
// The commands that play one mission: run, report.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

class Actions;

/// Adds the commands. `action` and `actions` must outlive the parsing and the action.
void add_runs(CLI::App& app, std::function<int()>& action, const Actions& actions);

}  // namespace skein::cli
