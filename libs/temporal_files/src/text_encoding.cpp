// SPDX-License-Identifier: Apache-2.0
#include "text_encoding.hpp"

#include <cstdint>

namespace skein::temporal {

namespace {

constexpr std::string_view kBigMark = "\xFE\xFF";
constexpr std::string_view kLittleMark = "\xFF\xFE";

bool is_big_endian(std::string_view text) {
  return text.starts_with(kBigMark) || (text[0] == '\0' && text[1] != '\0');
}

void append_utf8(std::string& out, std::uint32_t code) {
  const auto tail = [&](unsigned shift) {
    out += static_cast<char>(0x80U | ((code >> shift) & 0x3FU));
  };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0U | (code >> 6U));
    tail(0);
  } else if (code < 0x10000) {
    out += static_cast<char>(0xE0U | (code >> 12U));
    tail(6);
    tail(0);
  } else {
    out += static_cast<char>(0xF0U | (code >> 18U));
    tail(12);
    tail(6);
    tail(0);
  }
}

/// The units of a text one after the other.
class Units {
 public:
  Units(std::string_view text, bool big) : text_(text), big_(big) {}

  bool left() const { return text_.size() >= 2; }
  std::uint32_t take() {
    const auto first = static_cast<unsigned char>(text_[0]);
    const auto second = static_cast<unsigned char>(text_[1]);
    text_.remove_prefix(2);
    return big_ ? (first << 8U) | second : (second << 8U) | first;
  }
  std::size_t bytes_left() const { return text_.size(); }

 private:
  std::string_view text_;
  bool big_;
};

bool is_high(std::uint32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool is_low(std::uint32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

}  // namespace

bool is_utf16(std::string_view text) {
  if (text.size() < 2) return false;
  if (text.starts_with(kBigMark) || text.starts_with(kLittleMark)) return true;
  return (text[0] == '\0') != (text[1] == '\0');
}

std::optional<std::string> utf8_from_utf16(std::string_view text, Problems& problems) {
  const bool big = is_big_endian(text);
  if (text.starts_with(kBigMark) || text.starts_with(kLittleMark)) text.remove_prefix(2);
  std::string out;
  out.reserve(text.size() / 2);
  Units units(text, big);
  bool whole = true;
  while (whole && units.left()) {
    std::uint32_t code = units.take();
    if (is_high(code) && units.left()) {
      const std::uint32_t low = units.take();
      whole = is_low(low);
      code = 0x10000 + ((code - 0xD800) << 10U) + (low - 0xDC00);
    } else {
      whole = !is_high(code) && !is_low(code);
    }
    if (whole) append_utf8(out, code);
  }
  if (whole && units.bytes_left() == 0) return out;
  problems.add({}, "not UTF-16, though it begins like that");
  return std::nullopt;
}

}  // namespace skein::temporal
