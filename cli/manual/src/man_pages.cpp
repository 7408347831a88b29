// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>

#include "skein/foundation/joined.hpp"
#include "skein/manual/pages.hpp"

namespace skein::manual {
namespace {

/// Text that man(7) takes as it is: no line of it is a request, hyphens are those of options.
std::string plain(const std::string& text) {
  std::string escaped;
  bool at_start = true;
  for (const char c : text) {
    if (at_start && (c == '.' || c == '\'')) escaped += "\\&";
    at_start = c == '\n';
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
  }
  return escaped;
}

std::string dashed(std::string path) {
  std::replace(path.begin(), path.end(), ' ', '-');
  return path;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string synopsis(const Command& command) {
  std::string text = "\\fB" + plain(command.path) + "\\fR";
  const auto named = [](const Option& one) { return !one.positional; };
  if (std::any_of(command.options.begin(), command.options.end(), named))
    text += " [\\fIoptions\\fR]";
  for (const Option& one : command.options) {
    if (!one.positional) continue;
    const std::string name = "\\fI" + plain(one.names.front()) + "\\fR";
    text += one.required ? " " + name : " [" + name + "]";
  }
  if (!command.commands.empty()) text += " \\fIcommand\\fR";
  return text + "\n";
}

std::string option_text(const Option& option) {
  std::string heads;
  for (const std::string& name : option.names)
    heads += (heads.empty() ? "" : ", ") + ("\\fB" + plain(name) + "\\fR");
  if (!option.positional && !option.value.empty()) heads += " \\fI" + plain(option.value) + "\\fR";
  std::string text = ".TP\n" + heads + "\n" + plain(option.help);
  if (!option.choices.empty()) text += " (one of " + plain(joined(option.choices, ", ")) + ")";
  if (!option.usual.empty()) text += " [default: " + plain(option.usual) + "]";
  return text + "\n";
}

std::string options_text(const Command& command) {
  std::string text;
  for (const Option& option : command.options) text += option_text(option);
  return text;
}

std::string footer_text(const Command& command) {
  const std::size_t begin = command.footer.find_first_not_of('\n');
  if (begin == std::string::npos) return "";
  return ".PP\n.nf\n" + plain(command.footer.substr(begin)) + "\n.fi\n";
}

/// What stands below a command on its page, and below that.
std::string below(const Command& command) {
  std::string text;
  for (const Command& one : command.commands) {
    text += ".SS " + plain(one.path) + "\n" + synopsis(one) + ".PP\n" + plain(one.help) + "\n" +
            options_text(one) + footer_text(one) + below(one);
  }
  return text;
}

std::string head(const Command& command, const std::string& version, int section) {
  return ".TH \"" + upper(dashed(command.path)) + "\" " + std::to_string(section) + " \"\" \"" +
         plain(version) + "\" \"Skein\"\n.SH NAME\n" + plain(dashed(command.path)) + " \\- " +
         plain(command.help) + "\n.SH SYNOPSIS\n" + synopsis(command);
}

std::string page(const Command& command, const std::string& version, int section) {
  std::string text = head(command, version, section) + ".SH OPTIONS\n" + options_text(command);
  if (!command.commands.empty()) text += ".SH COMMANDS\n" + below(command);
  if (const std::string footer = footer_text(command); !footer.empty())
    text += ".SH EXAMPLES AND NOTES\n" + footer;
  return text;
}

std::string overview(const Command& program, const std::string& version, int section) {
  std::string text =
      head(program, version, section) + ".SH OPTIONS\n" + options_text(program) + ".SH COMMANDS\n";
  for (const Command& one : program.commands)
    text += ".TP\n\\fB" + plain(dashed(one.path)) + "\\fR(" + std::to_string(section) + ")\n" +
            plain(one.help) + "\n";
  return text + footer_text(program);
}

}  // namespace

std::vector<Page> man_pages(const Command& program, const std::string& version, int section) {
  const std::string ending = "." + std::to_string(section);
  if (program.commands.empty()) return {{program.name + ending, page(program, version, section)}};
  std::vector<Page> pages{{program.name + ending, overview(program, version, section)}};
  for (const Command& one : program.commands)
    pages.push_back({dashed(one.path) + ending, page(one, version, section)});
  return pages;
}

}  // namespace skein::manual
