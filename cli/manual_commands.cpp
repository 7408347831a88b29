// SPDX-License-Identifier: Apache-2.0
#include "manual_commands.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

#include "skein/foundation/exit_code.hpp"
#include "skein/manual/pages.hpp"

namespace skein::cli {

namespace {

constexpr const char* kManualExamples = R"(
Examples:
  skein manual man1 && man -l man1/skein-run.1
Exit codes: 0, 3 the folder cannot be written.)";

constexpr const char* kCompletionExamples = R"(
Examples:
  source <(skein completion bash)
  skein completion zsh > ~/.zfunc/_skein
  skein completion fish > ~/.config/fish/completions/skein.fish
Packages install all three.)";

int write_pages(const CLI::App& app, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  for (const manual::Page& page : manual::man_pages(manual::command_of(app), app.version())) {
    std::ofstream file(std::filesystem::path(folder) / page.file, std::ios::binary);
    file << page.text;
    file.close();
    if (file) continue;
    std::cerr << folder << ": " << page.file << " cannot be written\n";
    return kExitSystem;
  }
  return kExitOk;
}

}  // namespace

void add_manual(CLI::App& app, std::function<int()>& action) {
  auto folder = std::make_shared<std::string>();
  CLI::App* pages = app.add_subcommand("manual", "Write the manual pages of all commands");
  pages->add_option("folder", *folder, "Where to")->required();
  pages->footer(kManualExamples);
  pages->callback(
      [&app, folder, &action] { action = [&app, folder] { return write_pages(app, *folder); }; });
  auto shell = std::make_shared<std::string>();
  CLI::App* completion = app.add_subcommand("completion", "Print a script that completes commands");
  completion->add_option("shell", *shell, "Of which shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  completion->footer(kCompletionExamples);
  completion->callback([&app, shell, &action] {
    action = [&app, shell] {
      std::cout << manual::completion(manual::command_of(app), *shell);
      return kExitOk;
    };
  });
}

}  // namespace skein::cli
