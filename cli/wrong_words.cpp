// SPDX-License-Identifier: Apache-2.0
#include "wrong_words.hpp"

#include <algorithm>
#include <vector>

#include "skein/foundation/nearest.hpp"

namespace skein::cli {

namespace {

const CLI::App* command_of(const CLI::App& app, const std::string& word) {
  for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (one->check_name(word)) return one;
  }
  return nullptr;
}

std::string no_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(one->get_name());
  return "there is no command '" + word + "'" + did_you_mean(nearest_name(word, names));
}

std::string no_option(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::Option* one : app.get_options()) {
    for (const std::string& name : one->get_lnames()) names.push_back("--" + name);
  }
  return "there is no option '" + word + "'" + did_you_mean(nearest_name(word, names));
}

// Of the command or of one around it, which may stand behind its commands, too.
const CLI::Option* option_of(const CLI::App* app, const std::string& name) {
  for (; app != nullptr; app = app->get_parent()) {
    if (const CLI::Option* option = app->get_option_no_throw(name)) return option;
    if (!app->get_fallthrough()) return nullptr;
  }
  return nullptr;
}

bool has_commands(const CLI::App& app) {
  return !app.get_subcommands([](const CLI::App*) { return true; }).empty();
}

bool takes_words(const CLI::App& app) {
  return !app.get_options([](const CLI::Option* one) { return one->get_positional(); }).empty();
}

using Line = std::span<const char* const>;

// How many of the words are values of the option.
std::size_t values_in(Line words, const CLI::Option& option, const CLI::App& app) {
  const auto most = static_cast<std::size_t>(std::max(option.get_items_expected_max(), 0));
  std::size_t count = 0;
  while (count < std::min(most, words.size()) && words[count][0] != '-' &&
         command_of(app, words[count]) == nullptr)
    ++count;
  return count;
}

}  // namespace

std::string wrong_word(const CLI::App& app, Line words) {
  const CLI::App* here = &app;
  while (!words.empty()) {
    const std::string word = words.front();
    words = words.subspan(1);
    if (word.rfind("--", 0) == 0 && word.size() > 2) {
      const std::string name = word.substr(0, word.find('='));
      const CLI::Option* option = option_of(here, name);
      if (option == nullptr) return no_option(*here, name);
      if (name == word) words = words.subspan(values_in(words, *option, *here));
    } else if (word.rfind('-', 0) != 0 && has_commands(*here)) {
      const CLI::App* next = command_of(*here, word);
      if (next == nullptr) return takes_words(*here) ? "" : no_command(*here, word);
      here = next;
    }
  }
  return "";
}

}  // namespace skein::cli
