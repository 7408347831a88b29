// SPDX-License-Identifier: Apache-2.0
// Options that take one of a few words. CLI11's transformer would show the numbers behind the
// words, as raw characters when they are bytes, and take them too.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace skein::cli {

/// An option that sets `value` to what its word stands for. `value` is alive when the line is read.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Value& value,
                        const std::map<std::string, Value>& choices, const std::string& help) {
  std::vector<std::string> words;
  for (const auto& [word, meant] : choices) words.push_back(word);
  return command
      .add_option_function<std::string>(
          name, [&value, choices](const std::string& word) { value = choices.at(word); }, help)
      ->check(CLI::IsMember(words))
      ->type_name("WORD");
}

}  // namespace skein::cli
