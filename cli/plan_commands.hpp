// SPDX-License-Identifier: Apache-2.0
// `skein plan` on the command line.
#pragma once

#include <functional>
#include <span>

namespace CLI {
class App;
}

namespace skein::cli {

class Actions;

/// Adds the sub-command; when it is given, `action` becomes what is to be done. Groups of options
/// of which none is among `words` are left out; without words there are all.
void add_plan(CLI::App& app, std::function<int()>& action, const Actions& actions,
              std::span<char* const> words = {});

}  // namespace skein::cli
