// SPDX-License-Identifier: Apache-2.0
// `skein manual`, `skein completion`.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

/// Adds the commands, which tell what `app` has when they are carried out. Both arguments must
/// outlive the parsing and the action.
void add_manual(CLI::App& app, std::function<int()>& action);

}  // namespace skein::cli
