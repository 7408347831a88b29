// SPDX-License-Identifier: Apache-2.0
#include "skein/mission/duration_range.hpp"

#include <charconv>
#include <string>

namespace skein::mission {

namespace {

std::optional<double> number_from(std::string_view text) {
  if (text.empty() || text.front() < '0' || text.front() > '9') return std::nullopt;
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

}  // namespace

std::optional<DurationRange> duration_range_from(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  const auto least = number_from(text.substr(0, dots)), most = number_from(text.substr(dots + 2));
  if (!least || !most) return std::nullopt;
  return DurationRange{*least, *most};
}

std::optional<DurationRange> duration_range_of(const Argument& argument) {
  const auto* text = std::get_if<std::string>(&argument);
  return text == nullptr ? std::nullopt : duration_range_from(*text);
}

}  // namespace skein::mission
