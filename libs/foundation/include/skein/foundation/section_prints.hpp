// SPDX-License-Identifier: Apache-2.0
// Fingerprints of the sections of a document, to find which of them differ elsewhere.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace skein {

/// Sections in an order that both sides know. As text: a digit for this form, then eight
/// hexadecimal digits for each section, in order, without their names, since it is said over narrow
/// radios. For accidental differences, of which it misses one in four thousand million.
class SectionPrints {
 public:
  /// `print`: Fingerprint::value() of what the section says.
  void add(std::string section, std::uint64_t print);
  /// What was written by text() for these sections; nothing: it was not.
  static std::optional<SectionPrints> read(const std::vector<std::string>& sections,
                                           std::string_view text);
  bool empty() const { return sections_.empty(); }
  std::vector<std::string> sections() const;
  std::string text() const;
  /// The sections that differ in the document with that text, in order; none: it says the same.
  /// Nothing: the text has another form or other sections, and cannot be compared.
  std::optional<std::vector<std::string>> differing(std::string_view text) const;
  bool operator==(const SectionPrints&) const = default;

 private:
  std::vector<std::pair<std::string, std::uint32_t>> sections_;
};

}  // namespace skein
