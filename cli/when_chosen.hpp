// SPDX-License-Identifier: Apache-2.0
// A command whose options are all that it needs.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>

#include "actions.hpp"

namespace skein::cli {

/// When the command is chosen, parsing sets `action` to carrying out its options. `action` and
/// `actions` must outlive the parsing and the action.
template <class Options>
void when_chosen(CLI::App* command, const std::shared_ptr<Options>& options,
                 std::function<int()>& action, const Actions& actions) {
  command->callback([options, &action, &actions] {
    action = [options, &actions] { return actions.carry_out(*options); };
  });
}

}  // namespace skein::cli
