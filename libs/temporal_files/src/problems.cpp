// SPDX-License-Identifier: Apache-2.0
#include "problems.hpp"

#include <cstdint>

#include "skein/foundation/nearest.hpp"

namespace skein::temporal {

namespace {

constexpr std::size_t kLongestQuote = 64;  // [bytes]
constexpr std::size_t kLongestName = 256;  // [bytes]
constexpr std::size_t kMostSearches = 20;
constexpr std::size_t kMostCandidates = 2000;

// One character of UTF-8.
struct Character {
  std::uint32_t code = 0;
  std::size_t length = 0;  ///< 0: not UTF-8
};

// The length a first byte announces and the bits of the code it carries.
Character first_byte(unsigned char byte) {
  if (byte < 0x80) return {byte, 1};
  if (byte >= 0xC2 && byte < 0xE0) return {byte & 0x1FU, 2};
  if (byte >= 0xE0 && byte < 0xF0) return {byte & 0x0FU, 3};
  if (byte >= 0xF0 && byte < 0xF5) return {byte & 0x07U, 4};
  return {};
}

Character next_character(std::string_view text) {
  Character c = first_byte(static_cast<unsigned char>(text.front()));
  if (c.length > text.size()) return {};
  for (std::size_t i = 1; i < c.length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0U) != 0x80U) return {};
    c.code = (c.code << 6U) | (byte & 0x3FU);
  }
  const bool overlong = (c.length == 3 && c.code < 0x800) || (c.length == 4 && c.code < 0x10000);
  const bool surrogate = c.code >= 0xD800 && c.code < 0xE000;
  return overlong || surrogate || c.code > 0x10FFFF ? Character{} : c;
}

bool is_harmless(const Character& c) {
  const bool control = c.code < 0x20 || (c.code >= 0x7F && c.code < 0xA0);
  return c.length > 0 && !control && (c.code & 0xFFFEU) != 0xFFFE;
}

}  // namespace

void Problems::add(const Place& place, std::string message, std::string expected,
                   std::string nearest) {
  if (full_) return;
  full_ = found_.size() >= kMost;
  if (full_) {
    message = "more errors, not shown";
    expected.clear();
    nearest.clear();
  }
  found_.add({file_, place.line, place.column, place.path, std::move(message), std::move(expected),
              std::move(nearest)});
}

void Problems::warn(const Place& place, std::string message) {
  if (warnings_.size() > kMost) return;
  if (warnings_.size() == kMost) message = "more warnings, not shown";
  warnings_.add(
      {file_, place.line, place.column, place.path, "warning: " + std::move(message), "", ""});
}

void Problems::add_unknown(const Place& place, std::string_view kind, std::string_view name,
                           const std::vector<std::string>& candidates) {
  std::string nearest;
  if (candidates.size() <= kMostCandidates && name.size() <= kLongestQuote &&
      ++searches_ <= kMostSearches) {
    nearest = nearest_name(name, candidates);
  }
  add(place, "unknown " + std::string(kind) + " " + in_quotes(name), "", nearest);
}

std::string in_quotes(std::string_view text) {
  std::string quoted = "'";
  while (!text.empty()) {
    const Character c = next_character(text);
    if (quoted.size() + c.length > kLongestQuote) {
      quoted += "…";
      break;
    }
    quoted += is_harmless(c) ? text.substr(0, c.length) : "?";
    text.remove_prefix(c.length == 0 ? 1 : c.length);
  }
  return quoted + "'";
}

std::string name_problem(std::string_view text) {
  if (text.empty()) return "an empty name";
  if (text.size() > kLongestName) {
    return "the name " + in_quotes(text) + " is longer than " + std::to_string(kLongestName) +
           " bytes";
  }
  for (std::string_view rest = text; !rest.empty();) {
    const Character c = next_character(rest);
    if (!is_harmless(c)) {
      return "the name " + in_quotes(text) + " has control characters or is not UTF-8";
    }
    rest.remove_prefix(c.length);
  }
  return "";
}

}  // namespace skein::temporal
