// SPDX-License-Identifier: Apache-2.0
#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace skein::compare_tool {

namespace {

bool near(const std::optional<double>& a, const std::optional<double>& b, double within) {
  if (a.has_value() != b.has_value()) return false;
  return !a || *a == *b || std::abs(*a - *b) <= within;
}

bool same(const Fact& a, const Fact& b, double within) {
  return a.text == b.text && near(a.at, b.at, within) &&
         near(a.value, b.value, a.text == "s" ? within : 0);
}

SectionDifference differences_of(const Section& first, const Section& second, double within) {
  SectionDifference result{first.name, 0, {}};
  for (const auto& [name, fact] : first.facts) {
    ++result.facts;
    const auto other = second.facts.find(name);
    if (other == second.facts.end()) {
      result.differences.push_back({name, fact, std::nullopt});
    } else if (!same(fact, other->second, within)) {
      result.differences.push_back({name, fact, other->second});
    }
  }
  for (const auto& [name, fact] : second.facts) {
    if (first.facts.contains(name)) continue;
    ++result.facts;
    result.differences.push_back({name, std::nullopt, fact});
  }
  std::stable_sort(result.differences.begin(), result.differences.end(),
                   [](const Difference& a, const Difference& b) {
                     constexpr double kNever = std::numeric_limits<double>::infinity();
                     return a.at().value_or(kNever) < b.at().value_or(kNever);
                   });
  return result;
}

/// The line that begins at `at`, without its end.
std::string_view line_at(std::string_view text, std::size_t at) {
  return text.substr(at, std::min(text.find('\n', at), text.size()) - at);
}

}  // namespace

std::optional<double> Difference::at() const {
  std::optional<double> earliest;
  for (const auto& fact : {first, second}) {
    if (fact && fact->at) earliest = std::min(earliest.value_or(*fact->at), *fact->at);
  }
  return earliest;
}

bool Comparison::same_facts() const {
  return std::all_of(sections.begin(), sections.end(),
                     [](const SectionDifference& one) { return one.differences.empty(); });
}

std::optional<Divergence> divergence_of(const std::string& first, const std::string& second) {
  const auto [a, b] = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
  if (a == first.end() && b == second.end()) return std::nullopt;
  const auto same = static_cast<std::size_t>(a - first.begin());
  const auto lines = std::count(first.begin(), a, '\n');
  const std::size_t newline = same == 0 ? std::string::npos : first.rfind('\n', same - 1);
  const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
  Divergence divergence{static_cast<std::size_t>(lines) + 1, {}, {}};
  if (begin < first.size()) divergence.first = line_at(first, begin);
  if (begin < second.size()) divergence.second = line_at(second, begin);
  return divergence;
}

Comparison compared(const recording::Run& first, const recording::Run& second, double within) {
  Comparison comparison;
  comparison.divergence = divergence_of(first.events, second.events);
  comparison.same_bytes = !comparison.divergence;
  const auto a = facts_of(first), b = facts_of(second);
  for (std::size_t i = 0; i < a.size(); ++i)
    comparison.sections.push_back(differences_of(a[i], b[i], within));
  return comparison;
}

}  // namespace skein::compare_tool
