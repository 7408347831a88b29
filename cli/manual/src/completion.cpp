// SPDX-License-Identifier: Apache-2.0
// Scripts for shells: which command a line is at, then what may stand there.
#include <algorithm>

#include "skein/foundation/joined.hpp"
#include "skein/manual/pages.hpp"

namespace skein::manual {
namespace {

/// The command and all below it.
void collect(const Command& command, std::vector<const Command*>& all) {
  all.push_back(&command);
  for (const Command& one : command.commands) collect(one, all);
}

std::vector<const Command*> all_of(const Command& program) {
  std::vector<const Command*> all;
  collect(program, all);
  return all;
}

std::string command_names(const Command& command) {
  std::vector<std::string> names;
  for (const Command& one : command.commands) names.push_back(one.name);
  return joined(names, " ");
}

/// "skein spy" to "skein_spy".
std::string function_name(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '-' || c == ' '; }, '_');
  return text;
}

/// In single quotes, for shells.
std::string quoted(const std::string& text) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return all + "'";
}

/// One pattern of every command below the program: "skein spy echo".
std::string paths(const std::vector<const Command*>& all) {
  std::string text;
  for (const Command* one : all)
    if (one != all.front()) text += (text.empty() ? "" : " | ") + ("\"" + one->path + "\"");
  return text;
}

std::string named_options(const Command& command) {
  std::vector<std::string> names;
  for (const Option& option : command.options)
    if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names, " ");
}

/// Lines of a case for the values of options: choices, or files.
std::string bash_values(const Command& command) {
  std::string choices, any;
  for (const Option& option : command.options) {
    if (option.positional || option.value.empty()) continue;
    for (const std::string& name : option.names) {
      const std::string pattern = "\"" + command.path + " " + name + "\"";
      if (option.choices.empty())
        any += (any.empty() ? "" : " | ") + pattern;
      else
        choices += "    " + pattern + ") COMPREPLY=($(compgen -W \"" + joined(option.choices, " ") +
                   "\" -- \"$word\")); return ;;\n";
    }
  }
  if (!any.empty()) choices += "    " + any + ") compopt -o default; COMPREPLY=(); return ;;\n";
  return choices;
}

std::string positional_choices(const Command& command) {
  std::vector<std::string> words;
  for (const Option& option : command.options)
    if (option.positional) words.insert(words.end(), option.choices.begin(), option.choices.end());
  return joined(words, " ");
}

/// Of texts in brackets and between colons.
std::string zsh_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

std::string zsh_argument(const Option& option, const std::string& name) {
  std::string text = name + "[" + zsh_text(option.help) + "]";
  if (option.value.empty()) return quoted(text);
  text += ":" + zsh_text(option.value) + ":";
  return quoted(option.choices.empty() ? text + "_files"
                                       : text + "(" + joined(option.choices, " ") + ")");
}

std::string zsh_case(const Command& command) {
  std::string text = "    (\"" + command.path + "\")\n      _arguments -S";
  for (const Option& option : command.options)
    if (!option.positional)
      for (const std::string& name : option.names)
        text += " \\\n        " + ("'*'" + zsh_argument(option, name));
  std::string words = command_names(command);
  if (words.empty()) words = positional_choices(command);
  text += " \\\n        " + quoted(words.empty() ? "*:file:_files" : "*:command:(" + words + ")");
  return text + " ;;\n";
}

}  // namespace

std::string bash_completion(const Command& program) {
  const auto all = all_of(program);
  const std::string function = "_" + function_name(program.name);
  std::string text = "# bash completion for " + program.name + ", made from its command line\n" +
                     function +
                     "() {\n"
                     "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
                     "  local at=\"" +
                     program.name +
                     "\" one options='' words=''\n"
                     "  COMPREPLY=()\n";
  if (all.size() > 1)
    text +=
        "  for one in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n    case \"$at $one\" in\n      " +
        paths(all) + ") at=\"$at $one\" ;;\n    esac\n  done\n";
  std::string values, cases;
  for (const Command* one : all) {
    values += bash_values(*one);
    std::string words = command_names(*one);
    if (words.empty()) words = positional_choices(*one);
    cases += "    \"" + one->path + "\") options=\"" + named_options(*one) + "\" words=\"" + words +
             "\" ;;\n";
  }
  text += "  case \"$at $before\" in\n" + values + "  esac\n  case \"$at\" in\n" + cases +
          "  esac\n"
          "  if [[ $word == -* ]]; then\n"
          "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
          "  else\n"
          "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
          "    [[ -n $words ]] || compopt -o default\n"
          "  fi\n}\n";
  return text + "complete -F " + function + " " + program.name + "\n";
}

std::string zsh_completion(const Command& program) {
  const auto all = all_of(program);
  std::string text = "#compdef " + program.name + "\n# made from its command line\n_" +
                     function_name(program.name) + "() {\n  local at=\"" + program.name + "\" i\n";
  if (all.size() > 1)
    text += "  for ((i = 2; i < CURRENT; i++)); do\n    case \"$at ${words[i]}\" in\n      (" +
            paths(all) + ") at=\"$at ${words[i]}\" ;;\n    esac\n  done\n";
  text += "  case \"$at\" in\n";
  for (const Command* one : all) text += zsh_case(*one);
  return text + "  esac\n}\n_" + function_name(program.name) + " \"$@\"\n";
}

std::string fish_completion(const Command& program) {
  const auto all = all_of(program);
  const std::string at = "__" + function_name(program.name) + "_at";
  std::string text = "# fish completion for " + program.name + ", made from its command line\n" +
                     "function " + at + "\n  set -l at \"" + program.name +
                     "\"\n  for one in (commandline -opc)[2..-1]\n    switch \"$at $one\"\n";
  for (const Command* one : all)
    if (one != all.front())
      text += "      case \"" + one->path + "\"\n        set at \"" + one->path + "\"\n";
  text += "    end\n  end\n  test \"$at\" = \"$argv\"\nend\n";
  for (const Command* one : all) {
    const std::string begin = "complete -c " + program.name + " -n " + quoted(at + " " + one->path);
    for (const Command& command : one->commands)
      text += begin + " -f -a " + quoted(command.name) + " -d " + quoted(command.help) + "\n";
    for (const Option& option : one->options) {
      if (option.positional) {
        if (!option.choices.empty())
          text += begin + " -f -a " + quoted(joined(option.choices, " ")) + "\n";
        continue;
      }
      text += begin;
      for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.choices.empty())
        text += " -x -a " + quoted(joined(option.choices, " "));
      else if (!option.value.empty())
        text += " -r";
      text += " -d " + quoted(option.help) + "\n";
    }
  }
  return text;
}

std::string completion(const Command& program, const std::string& shell) {
  if (shell == "bash") return bash_completion(program);
  if (shell == "zsh") return zsh_completion(program);
  return shell == "fish" ? fish_completion(program) : "";
}

}  // namespace skein::manual
