// SPDX-License-Identifier: Apache-2.0
// Problems that nobody wants: of a file of ten, reading the other nine would be most of the work.
#include <algorithm>
#include <array>

#include "language/characters.hpp"
#include "language/scanner.hpp"
#include "skein/htn/utf8.hpp"

namespace skein::htn {

namespace {

// Bytes that may mean something to who only counts parentheses.
constexpr std::array<bool, 256> kStops = [] {
  std::array<bool, 256> stops{};
  for (const char byte : {'(', ')', '"', ';', '|', '#', '\\'})
    stops[static_cast<std::uint8_t>(byte)] = true;
  return stops;
}();

// Behind the closing quote or bar; npos if there is none.
std::size_t end_of_quoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (++at; at < text.size(); ++at) {
    if (text[at] == quote) return at + 1;
    if (text[at] == '\\' && quote == '"') ++at;
  }
  return std::string_view::npos;
}

// Behind a comment |# that may hold others.
std::size_t end_of_comment(std::string_view text, std::size_t at) {
  std::size_t open = 0;
  for (; at + 1 < text.size(); ++at) {
    const std::string_view two = text.substr(at, 2);
    if (two == "#|") {
      ++open;
      ++at;
    } else if (two == "|#") {
      ++at;
      if (--open == 0) return at + 1;
    }
  }
  return std::string_view::npos;
}

std::string_view token_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && (traits_of(text[end]) & kTokenByte) != 0) ++end;
  return text.substr(at, end - at);
}

// A name that means what its letters say.
bool plain_name(std::string_view token) {
  const auto letter = [](char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
  };
  return !token.empty() && letter(token.front()) &&
         std::all_of(token.begin(), token.end(),
                     [](char byte) { return traits_of(byte) == kTokenByte; });
}

// Behind the parenthesis that closes the list which begins here; npos if none does.
std::size_t end_of_list(std::string_view text, std::size_t at) {
  std::size_t depth = 0;
  while (at < text.size()) {
    const char byte = text[at];
    if (!kStops[static_cast<std::uint8_t>(byte)]) {
      ++at;
      continue;
    }
    switch (byte) {
      case '(':
        ++depth;
        ++at;
        break;
      case ')':
        ++at;
        if (--depth == 0) return at;
        break;
      case ';':
        at = std::min(text.find('\n', at), text.size());
        break;
      case '\\':
        at += 2;
        break;
      case '#':
        if (text.substr(at, 2) == "#|") {
          at = end_of_comment(text, at);
        } else {
          at += text.substr(at, 2) == "#\\" ? 3 : 1;
        }
        break;
      default:
        at = end_of_quoted(text, at);
    }
  }
  return std::string_view::npos;
}

}  // namespace

// True if (defproblem NAME …) begins here, is not wanted and was left behind. What is not plain is
// read as everything else.
bool Scanner::pass_over_problem() {
  if (in_.text[in_.at] != '(') return false;
  const std::string_view word = token_at(in_.text, in_.at + 1);
  if (lowered(word) != "defproblem") return false;
  std::size_t begin = in_.at + 1 + word.size();
  while (begin < in_.text.size() && (traits_of(in_.text[begin]) & kSpaceByte) != 0) ++begin;
  const std::string_view token = token_at(in_.text, begin);
  if (!plain_name(token)) return false;
  const std::string name = lowered(token);
  const auto is_it = [&name](const std::string& wanted) { return lowered(wanted) == name; };
  if (std::any_of(wanted_.begin(), wanted_.end(), is_it)) return false;
  const std::size_t end = end_of_list(in_.text, in_.at);
  if (end == std::string_view::npos) return false;
  passed_over_.push_back(name);
  in_.at = end;
  return true;
}

}  // namespace skein::htn
