// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <span>
#include <string_view>

#include "actions.hpp"
#include "allocate_commands.hpp"
#include "argument_checks.hpp"
#include "import_commands.hpp"
#include "live_commands.hpp"
#include "manual_commands.hpp"
#include "mastn_commands.hpp"
#include "mle_commands.hpp"
#include "model_commands.hpp"
#include "plan_commands.hpp"
#include "refine_commands.hpp"
#include "run_commands.hpp"
#include "series_commands.hpp"
#include "skein/foundation/exit_code.hpp"
#include "stn_commands.hpp"
#include "wrong_words.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;

// `skein plan` with what its arguments name: describing all commands and options to CLI11 costs
// more than a small plan. No action if something is wrong, or help is asked for.
Action quick_plan(int argc, char** argv, const Actions& actions) {
  Action action;
  if (argc < 3 || std::string_view(argv[1]) != "plan") return action;
  CLI::App app{"Skein", "skein"};
  add_plan(app, action, actions, std::span(argv, static_cast<std::size_t>(argc)).subspan(2));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError&) {
    return {};
  }
  return action;
}

void add_commands(CLI::App& app, Action& action, const Actions& actions) {
  add_allocate(app, action, actions);
  add_runs(app, action, actions);
  add_live(app, action, actions);
  add_import(app, action, actions);
  add_series(app, action, actions);
  add_mle(app, action, actions);
  add_plan(app, action, actions);
  add_mastn(app, action, actions);
  add_model(app, action, actions);
  add_stn(app, action, actions);
  add_refine(app, action, actions);
  add_terrain(app, action, actions);
  add_manual(app, action);
}

}  // namespace

int start_skein_instead() {
  std::cerr
      << "this program does not carry out that command: start `skein`, which knows who does\n";
  return kExitBadInput;
}

int run_command_line(int argc, char** argv, const Actions& actions) try {
  if (const Action plan = quick_plan(argc, argv, actions)) return plan();
  CLI::App app{"Skein: decisional autonomy for teams of UAVs", "skein"};
  app.set_version_flag("--version", std::string("skein ") + SKEIN_VERSION);
  app.require_subcommand(1);
  Action action;
  add_commands(app, action, actions);
  refuse_below_zero(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const std::span<const char* const> words(argv + 1, argv + std::max(argc, 1));
    const bool is_help = error.get_exit_code() == 0;
    const std::string wrong = is_help ? "" : wrong_word(app, words);
    if (!wrong.empty()) std::cerr << wrong << '\n';
    return app.exit(error) == 0 ? kExitOk : kExitBadInput;
  }
  return action();
} catch (const std::exception& error) {
  std::cerr << "skein: " << error.what() << '\n';
  return kExitInternal;
}

}  // namespace skein::cli
