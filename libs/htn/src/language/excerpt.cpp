// SPDX-License-Identifier: Apache-2.0
// Shows people the place of an error in the text.
#include <algorithm>

#include "language/characters.hpp"
#include "skein/foundation/printable.hpp"
#include "skein/htn/syntax.hpp"
#include "skein/htn/utf8.hpp"

namespace skein::htn {

namespace {

std::string_view line_of(std::string_view text, int line) {
  for (int at = 1; at < line; ++at) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  std::string_view out = text.substr(0, text.find('\n'));
  if (out.ends_with('\r')) out.remove_suffix(1);
  return out;
}

constexpr std::size_t kChunk = 4096;                  // bytes
constexpr std::size_t kBefore = kLongestExcerpt / 4;  // characters shown before the place

// The first byte of the character of this number, counted from 0; the size of the text if it has
// fewer.
std::size_t byte_of_character(std::string_view text, std::size_t number) {
  std::size_t at = 0;
  while (text.size() - at > kChunk) {
    const std::size_t here = count_characters(text.substr(at, kChunk));
    if (here > number) break;
    number -= here;
    at += kChunk;
  }
  for (; at < text.size(); ++at) {
    if (!continues_character(text[at]) && number-- == 0) break;
  }
  return at;
}

std::size_t before_by(std::string_view text, std::size_t at, std::size_t characters) {
  while (at > 0 && characters > 0) characters -= continues_character(text[--at]) ? 0 : 1;
  return at;
}

std::size_t string_end(std::string_view line, std::size_t at) {
  for (++at; at < line.size() && line[at] != '"'; ++at) {
    if (line[at] == '\\') ++at;
  }
  return std::min(at + 1, line.size());
}

// Behind the expression that begins at `at`, or the end of the line.
std::size_t expression_end(std::string_view line, std::size_t at) {
  int open = 0;
  while (at < line.size()) {
    const char byte = line[at];
    if (byte == ';') break;
    if (byte == '"') {
      at = string_end(line, at);
    } else if (byte == '(' || byte == ')') {
      open += byte == '(' ? 1 : -1;
      ++at;
    } else if ((traits_of(byte) & kTokenByte) != 0) {
      while (at < line.size() && (traits_of(line[at]) & kTokenByte) != 0) ++at;
    } else {
      const bool prefix = byte == '\'' || byte == '`' || byte == ',';
      ++at;
      if (prefix) continue;
    }
    if (open <= 0) return at;
  }
  while (at > 0 && (traits_of(line[at - 1]) & kSpaceByte) != 0) --at;
  return at;
}

}  // namespace

Excerpt excerpt(const Diagnostic& diagnostic, std::string_view text) {
  if (diagnostic.line < 1 || diagnostic.column < 1) return {};
  std::string_view line = line_of(text, diagnostic.line);
  if (line.empty()) return {};
  std::size_t begin = byte_of_character(line, static_cast<std::size_t>(diagnostic.column) - 1);
  const bool long_line = byte_of_character(line, kLongestExcerpt) < line.size();
  const std::size_t from = long_line ? before_by(line, begin, kBefore) : 0;
  line.remove_prefix(from);
  begin -= from;
  // Two characters less, for what is left out.
  const std::size_t shown = byte_of_character(line, kLongestExcerpt - 2);
  const bool cut = long_line && shown < line.size();
  if (cut) line = line.substr(0, shown);
  const std::size_t end = std::max(expression_end(line, begin), std::min(begin + 1, line.size()));
  Excerpt out;
  if (from > 0) out = {"…", " "};
  out.line += printable(line);
  if (cut) out.line += "…";
  for (const char byte : line.substr(0, begin)) {
    if (!continues_character(byte)) out.marks += byte == '\t' ? '\t' : ' ';
  }
  const std::size_t width = begin < end ? count_characters(line.substr(begin, end - begin)) : 1;
  out.marks += '^';
  if (width > 1) out.marks += std::string(width - 1, '~');
  return out;
}

Diagnostic clipped(Diagnostic diagnostic) {
  for (std::string* part : {&diagnostic.message, &diagnostic.expected, &diagnostic.nearest}) {
    *part = clipped(std::move(*part), kLongestExcerpt);
  }
  return diagnostic;
}

std::string underlined(const Diagnostic& diagnostic, std::string_view text) {
  const Excerpt shown = excerpt(diagnostic, text);
  std::string out = to_text(diagnostic) + "\n";
  if (!shown.line.empty()) out += shown.line + "\n" + shown.marks + "\n";
  return out;
}

}  // namespace skein::htn
