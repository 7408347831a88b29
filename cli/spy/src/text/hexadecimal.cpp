// SPDX-License-Identifier: Apache-2.0
#include "hexadecimal.hpp"

#include <algorithm>

namespace skein::spy_tool {

namespace {

constexpr std::size_t kAtMost = 256;
constexpr std::size_t kInLine = 16;

char digit(unsigned value) { return "0123456789abcdef"[value & 15U]; }

std::string line(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::string text = "  ";
  for (const unsigned shift : {12U, 8U, 4U, 0U}) text += digit(static_cast<unsigned>(at) >> shift);
  std::string letters;
  text += ' ';
  for (std::size_t i = 0; i < kInLine; ++i) {
    if (i >= bytes.size()) {
      text += "   ";
      continue;
    }
    text += ' ';
    text += digit(bytes[i] >> 4U);
    text += digit(bytes[i]);
    letters += bytes[i] >= 0x20 && bytes[i] < 0x7f ? static_cast<char>(bytes[i]) : '.';
  }
  return text + "  " + letters + '\n';
}

}  // namespace

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += digit(byte >> 4U);
    text += digit(byte);
  }
  return text;
}

std::string hexadecimal_lines(std::span<const std::uint8_t> bytes) {
  std::string text;
  const auto shown = bytes.first(std::min(bytes.size(), kAtMost));
  for (std::size_t at = 0; at < shown.size(); at += kInLine)
    text += line(shown.subspan(at, std::min(kInLine, shown.size() - at)), at);
  if (bytes.size() > kAtMost) text += "  … " + std::to_string(bytes.size() - kAtMost) + " more\n";
  return text;
}

}  // namespace skein::spy_tool
