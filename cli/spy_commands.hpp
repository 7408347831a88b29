// SPDX-License-Identifier: Apache-2.0
// `skein spy` and its verbs, as CLI11 knows them.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

struct LiveActions;

/// Adds the command. `action` and `live` must outlive the parsing and the action.
void add_spy(CLI::App& app, std::function<int()>& action, const LiveActions& live);

}  // namespace skein::cli
