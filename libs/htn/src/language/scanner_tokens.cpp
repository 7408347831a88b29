// SPDX-License-Identifier: Apache-2.0
// Atoms and comments.
#include <charconv>
#include <cstring>

#include "language/characters.hpp"
#include "language/scanner.hpp"
#include "skein/htn/number.hpp"
#include "skein/htn/utf8.hpp"

namespace skein::htn {

namespace {

bool is_digit(char byte) { return byte >= '0' && byte <= '9'; }

// Worth asking parse_number: a digit, or one after a sign or a dot.
bool may_be_number(std::string_view token) {
  if (is_digit(token[0])) return true;
  if (token[0] != '+' && token[0] != '-' && token[0] != '.') return false;
  return token.size() > 1 && (is_digit(token[1]) || token[1] == '.');
}

constexpr std::size_t kSafeDigits = 18;

}  // namespace

// Comments

void Scanner::skip_line() {
  const std::size_t end = in_.text.find('\n', in_.at);
  in_.at = end == std::string_view::npos ? in_.text.size() : end + 1;
}

void Scanner::skip_block_comment() {
  const std::uint32_t begin = in_.offset();
  std::size_t open = 0;
  while (in_.at + 1 < in_.text.size()) {
    const char byte = in_.text[in_.at];
    if (byte == '#' && in_.text[in_.at + 1] == '|') {
      ++open;
      in_.at += 2;
    } else if (byte == '|' && in_.text[in_.at + 1] == '#') {
      in_.at += 2;
      if (--open == 0) return;
    } else {
      ++in_.at;
    }
  }
  in_.at = in_.text.size();
  error(begin, "comment without end", "'|#'");
  cut_ = true;
}

// Strings

void Scanner::read_string() {
  const std::uint32_t begin = in_.offset();
  const std::size_t body = ++in_.at;
  std::size_t end = in_.text.find_first_of("\"\\", in_.at);
  if (end == std::string_view::npos || in_.text[end] == '"') {
    in_.at = end == std::string_view::npos ? in_.text.size() : end + 1;
    if (end != std::string_view::npos) {
      check_utf8(begin, in_.offset());
      return add_atom(store_.string(in_.text.substr(body, end - body)), begin);
    }
  }
  std::string value;
  while (!in_.at_end() && in_.text[in_.at] != '"') {
    if (in_.text[in_.at] == '\\' && in_.at + 1 < in_.text.size()) ++in_.at;
    value += in_.text[in_.at++];
  }
  if (in_.at_end()) {
    error(begin, "string without end", "'\"'");
    cut_ = true;
  } else {
    ++in_.at;
  }
  check_utf8(begin, in_.offset());
  add_atom(store_.string(value), begin);
}

void Scanner::check_utf8(std::uint32_t begin, std::uint32_t end) {
  if (valid_utf8(in_.text.substr(begin, end - begin))) return;
  error(begin, "bytes that are no UTF-8 text");
}

// What begins with #

void Scanner::read_hash() {
  switch (in_.peek(1)) {
    case '|':
      return skip_block_comment();
    case '\'':
      return open_prefix(function_, 2);
    case '+':
    case '-':
      return open_frame(Kind::kFeature, 2, in_.peek(1) == '+');
    case '.':
      return open_frame(Kind::kForm, 2);
    case '(':
      ++in_.at;
      return open_list();
    case ':':
      in_.at += 2;
      if (!in_.at_end() && (traits_of(in_.peek()) & kTokenByte) != 0) return read_token();
      return error(in_.offset() - 2, "nothing follows #:", "a name");
    case '\\':
      return read_character();
    case 'x':
    case 'X':
      return read_radix(16);
    case 'o':
    case 'O':
      return read_radix(8);
    case 'b':
    case 'B':
      return read_radix(2);
    case 'p':
    case 'P':
      if (in_.peek(2) == '"') {
        in_.at += 2;
        return read_string();
      }
      [[fallthrough]];
    default:
      error(in_.offset(), "'#' with an unknown meaning",
            "one of #' #: #. #+ #- #| #\\ #( #x #o #b #p");
      ++in_.at;
      while (!in_.at_end() && (traits_of(in_.peek()) & kTokenByte) != 0) ++in_.at;
  }
}

void Scanner::read_radix(int radix) {
  const std::uint32_t begin = in_.offset();
  in_.at += 2;
  const std::size_t first = in_.at;
  while (!in_.at_end() && (traits_of(in_.peek()) & kTokenByte) != 0) ++in_.at;
  const std::string_view digits = in_.since(first);
  std::int64_t value = 0;
  const auto [end, failed] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, radix);
  if (failed != std::errc{} || end != digits.data() + digits.size()) {
    error(begin, "bad number '" + std::string(in_.since(begin)) + "'",
          "an integer of base " + std::to_string(radix));
  }
  add_atom(store_.integer(value), begin);
}

// #\a, #\( or #\space: a symbol that is written like that.
void Scanner::read_character() {
  const std::uint32_t begin = in_.offset();
  in_.at += 2;
  if (in_.at_end()) return error(begin, "nothing follows #\\", "a character");
  do {
    ++in_.at;
  } while (!in_.at_end() && (traits_of(in_.peek()) & kTokenByte) != 0 && in_.peek() != '\\');
  check_utf8(begin, in_.offset());
  add_atom(store_.symbol(bounded_name(in_.since(begin), begin)), begin);
}

// Symbols and numbers

void Scanner::read_token() {
  const std::size_t begin = in_.at;
  std::uint8_t seen = 0;
  const char* const data = in_.text.data();
  std::size_t end = begin;
  for (; end < in_.text.size(); ++end) {
    const std::uint8_t traits = traits_of(data[end]);
    if ((traits & kTokenByte) == 0) break;
    seen |= traits;
  }
  const auto start = static_cast<std::uint32_t>(begin);
  if ((seen & kEscapeByte) != 0) return read_escaped(start);
  in_.at = end;
  const std::string_view token = bounded_name(in_.text.substr(begin, end - begin), start);
  if ((seen & kHighByte) != 0) check_utf8(start, in_.offset());
  if ((seen & kColonByte) != 0) return add_atom(symbol_of(token, start), start);
  take_plain(token, start);
}

std::string_view Scanner::cut_name(std::string_view name, std::uint32_t begin) {
  error(begin, "a name of " + std::to_string(name.size()) + " bytes",
        std::to_string(kLongestName) + " at most");
  std::size_t length = kLongestName;
  while (continues_character(name[length])) --length;
  return name.substr(0, length);
}

void Scanner::take_plain(std::string_view token, std::uint32_t begin) {
  const char first = token[0];
  if (is_digit(first) || first == '+' || first == '-' || first == '.') {
    if (token.find_first_not_of('.') == std::string_view::npos) return take_dots(token, begin);
    if (may_be_number(token) && take_number(token, begin)) return;
  }
  add_atom(store_.symbol(token), begin);
}

void Scanner::take_dots(std::string_view token, std::uint32_t begin) {
  if (token.size() > 1) return error(begin, "a name of dots only", "a name, or one '.'");
  const bool in_list = !frames_.empty() && frames_.back().kind == Kind::kList;
  if (!in_list || frames_.back().last == kNoNode || frames_.back().dot != Dot::kNone) {
    return error(begin, "'.' out of place", "'.' before the last expression of a list");
  }
  frames_.back().dot = Dot::kSeen;
}

bool Scanner::take_number(std::string_view token, std::uint32_t begin) {
  const std::string_view digits = token.substr(token[0] == '-' ? 1 : 0);
  if (digits.size() <= kSafeDigits &&
      digits.find_first_not_of("0123456789") == std::string_view::npos) {
    std::int64_t value = 0;
    for (const char digit : digits) value = value * 10 + (digit - '0');
    add_atom(store_.integer(digits.size() == token.size() ? value : -value), begin);
    return true;
  }
  const auto number = parse_number(token);
  if (!number) return false;
  if (!*number) error(begin, "bad number '" + std::string(token) + "': " + number->error().why);
  add_atom(*number ? store_.number(**number) : store_.integer(0), begin);
  return true;
}

// A package prefix is left out; a keyword keeps its colon.
Term Scanner::symbol_of(std::string_view token, std::uint32_t begin) {
  const std::size_t colon = token.rfind(':');
  if (colon == std::string_view::npos || colon == 0) {
    if (token == ":") error(begin, "a lone ':'", "a name behind it");
    return store_.symbol(token);
  }
  if (colon + 1 == token.size()) {
    error(begin, "'" + std::string(token) + "' names a package only", "a name behind the ':'");
    return store_.symbol(token);
  }
  const std::string_view package = token.substr(0, token.find(':'));
  const bool keyword = package.empty() || package == "keyword" || package == "KEYWORD";
  return store_.symbol(token.substr(keyword ? colon : colon + 1));
}

// \x takes one character as it is, |x y| several: such a token is always a symbol.
void Scanner::read_escaped(std::uint32_t begin) {
  std::string name;
  std::size_t package = 0;  // length of what stands before the last bare colon
  bool bars = false;
  while (!in_.at_end() && (bars || (traits_of(in_.peek()) & kTokenByte) != 0)) {
    const char byte = in_.text[in_.at++];
    if (byte == '|') {
      bars = !bars;
    } else if (byte == '\\' && !in_.at_end()) {
      name += in_.text[in_.at++];
    } else {
      if (byte == ':' && !bars && !name.empty()) package = name.size() + 1;
      name += byte;
    }
  }
  if (bars) {
    error(begin, "'|' without end", "a second '|'");
    cut_ = true;
  }
  check_utf8(begin, in_.offset());
  name.erase(0, package);
  add_atom(store_.symbol(bounded_name(name, begin)), begin);
}

}  // namespace skein::htn
