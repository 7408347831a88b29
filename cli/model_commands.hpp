// SPDX-License-Identifier: Apache-2.0
// `skein model` on the command line.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace skein::cli {

class Actions;

/// Adds the command; when one of its own is chosen, parsing sets `action` to what it does; it and
/// `actions` must outlive that.
void add_model(CLI::App& app, std::function<int()>& action, const Actions& actions);

}  // namespace skein::cli
