// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/section_prints.hpp"

#include <charconv>
#include <cstdio>
#include <system_error>

namespace skein {

namespace {

constexpr char kForm = '1';
constexpr std::size_t kDigits = 8;  ///< of a section

std::string digits_of(std::uint32_t print) {
  char digits[kDigits + 1];
  std::snprintf(digits, sizeof digits, "%08x", print);
  return digits;
}

}  // namespace

void SectionPrints::add(std::string section, std::uint64_t print) {
  const auto folded = static_cast<std::uint32_t>(print ^ (print >> 32U));
  sections_.emplace_back(std::move(section), folded);
}

std::vector<std::string> SectionPrints::sections() const {
  std::vector<std::string> names;
  for (const auto& [section, print] : sections_) names.push_back(section);
  return names;
}

std::string SectionPrints::text() const {
  std::string text(1, kForm);
  for (const auto& [section, print] : sections_) text += digits_of(print);
  return text;
}

std::optional<SectionPrints> SectionPrints::read(const std::vector<std::string>& sections,
                                                 std::string_view text) {
  if (text.size() != 1 + kDigits * sections.size() || text.front() != kForm) return std::nullopt;
  text.remove_prefix(1);
  SectionPrints read;
  for (const std::string& section : sections) {
    std::uint32_t print = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + kDigits, print, 16);
    if (error != std::errc() || end != text.data() + kDigits) return std::nullopt;
    read.sections_.emplace_back(section, print);
    text.remove_prefix(kDigits);
  }
  return read;
}

std::optional<std::vector<std::string>> SectionPrints::differing(std::string_view text) const {
  const std::vector<std::string> names = sections();
  const auto other = read(names, text);
  if (!other) return std::nullopt;
  std::vector<std::string> differing;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (sections_[i] != other->sections_[i]) differing.push_back(names[i]);
  return differing;
}

}  // namespace skein
