// SPDX-License-Identifier: Apache-2.0
#include "text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace skein::report {

namespace {

constexpr double kLargest = 1e12;

}  // namespace

std::string short_number(double value, int decimals) {
  if (!std::isfinite(value)) return "0";
  std::string text = fmt::format("{:.{}f}", std::clamp(value, -kLargest, kLargest), decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string fixed_number(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  std::string text = fmt::format("{:.{}f}", std::clamp(value, -kLargest, kLargest), decimals);
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') text.erase(0, 1);
  return text;
}

std::string grouped(std::size_t value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += "\u202F";
    text += digits[i];
  }
  return text;
}

std::string clock_text(double seconds) {
  if (!std::isfinite(seconds)) return "–";
  const auto whole = static_cast<std::int64_t>(std::floor(std::min(std::abs(seconds), kLargest)));
  const char* sign = seconds < 0 && whole > 0 ? "-" : "";
  if (whole < 3600) return fmt::format("{}{}:{:02}", sign, whole / 60, whole % 60);
  return fmt::format("{}{}:{:02}:{:02}", sign, whole / 3600, whole / 60 % 60, whole % 60);
}

std::string length_text(double metres) {
  if (std::abs(metres) >= 10'000) return fixed_number(metres / 1000.0, 1) + " km";
  return fixed_number(metres, std::abs(metres) < 100 ? 1 : 0) + " m";
}

std::string span_text(double seconds) {
  if (!std::isfinite(seconds)) return "–";
  if (std::abs(seconds) < 1)
    return fixed_number(seconds * 1000.0, std::abs(seconds) < 0.01 ? 1 : 0) + " ms";
  if (std::abs(seconds) < 60) return fixed_number(seconds, 1) + " s";
  const auto whole = static_cast<std::int64_t>(std::min(std::abs(seconds) + 0.5, kLargest));
  return fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::string shortened(std::string_view text, std::size_t most) {
  if (character_count(text) <= most) return std::string(text);
  std::size_t end = 0, count = 0;
  while (end < text.size()) {
    const bool starts = (static_cast<unsigned char>(text[end]) & 0xC0U) != 0x80U;
    if (starts && ++count >= most) break;
    ++end;
  }
  return std::string(text.substr(0, end)) + "…";
}

std::string counted(std::size_t count, std::string_view noun) {
  return grouped(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace skein::report
