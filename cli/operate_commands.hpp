// SPDX-License-Identifier: Apache-2.0
// The commands of operators: operate, status.
#pragma once

#include <functional>

namespace CLI {
class App;
}
namespace skein::cli {

class Actions;

/// `action` and `actions` must outlive the parsing and the action.
void add_operate(CLI::App& app, std::function<int()>& action, const Actions& actions);
void add_status(CLI::App& app, std::function<int()>& action, const Actions& actions);

}  // namespace skein::cli
