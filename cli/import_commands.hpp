// SPDX-License-Identifier: Apache-2.0
// `skein import`.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

class Actions;

/// Adds the command. `action` and `actions` must outlive the parsing and the action.
void add_import(CLI::App& app, std::function<int()>& action, const Actions& actions);

}  // namespace skein::cli
