// SPDX-License-Identifier: Apache-2.0
#include "skein/manual/command.hpp"

#include <CLI/CLI.hpp>

namespace skein::manual {
namespace {

/// Of what CLI11 says of a set of words: "TEXT:{error,warn}".
std::vector<std::string> choices_in(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  std::vector<std::string> words;
  if (open == std::string::npos || close == std::string::npos || close < open) return words;
  std::string word;
  for (std::size_t i = open + 1; i <= close; ++i) {
    if (type[i] != ',' && i != close) {
      word += type[i];
      continue;
    }
    if (!word.empty()) words.push_back(word);
    word.clear();
  }
  return words;
}

Option option_of(const CLI::Option& given) {
  Option option;
  for (const std::string& name : given.get_lnames()) option.names.push_back("--" + name);
  for (const std::string& name : given.get_snames()) option.names.push_back("-" + name);
  option.positional = option.names.empty();
  if (option.positional) option.names.push_back(given.get_name(true));
  option.help = given.get_description();
  option.required = given.get_required();
  if (given.get_items_expected_max() == 0) return option;
  const std::string type = given.get_type_name();
  option.choices = choices_in(type);
  option.value = type.substr(0, type.find(':'));
  if (option.value.empty()) option.value = "VALUE";
  option.usual = given.get_default_str();
  if (option.usual == "[]") option.usual.clear();
  return option;
}

Command described(const CLI::App& app, const std::string& above) {
  Command command;
  command.name = app.get_name();
  command.path = above.empty() ? command.name : above + " " + command.name;
  command.help = app.get_description();
  command.footer = app.get_footer();
  for (const CLI::Option* option :
       app.get_options([](const CLI::Option* one) { return !one->get_group().empty(); }))
    command.options.push_back(option_of(*option));
  for (const CLI::App* one :
       app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); }))
    command.commands.push_back(described(*one, command.path));
  for (Command& one : command.commands)
    if (one.footer == command.footer) one.footer.clear();  // CLI11 gives it to all below
  return command;
}

}  // namespace

Command command_of(const CLI::App& app) { return described(app, ""); }

}  // namespace skein::manual
