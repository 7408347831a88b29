// SPDX-License-Identifier: Apache-2.0
#include "facts.hpp"

#include <algorithm>
#include <cmath>

namespace skein::interaction {

namespace {

using Vow = Entry::Vow;

std::optional<std::string> problem_of(const Entry& one) {
  if (one.vow == Vow::kPromised && !one.offered) return one.uav + " promised without an offer";
  for (const Row& row : one.offer) {
    for (const double number : row.numbers) {
      if (!std::isfinite(number)) return "a figure of the offer of " + one.uav + " is not finite";
    }
  }
  return std::nullopt;
}

std::optional<std::string> problem_between(const Entry& mine, const Entry& theirs) {
  if (mine.uav != theirs.uav) return "it speaks of '" + theirs.uav + "', not of " + mine.uav;
  if (mine.offered && theirs.offered && mine.offer != theirs.offer) {
    return mine.uav + " offered something else";
  }
  const bool both = mine.vow != Vow::kNone && theirs.vow != Vow::kNone;
  if (both && (mine.vow != theirs.vow || mine.result != theirs.result)) {
    return mine.uav + " vowed something else";
  }
  return std::nullopt;
}

}  // namespace

Facts::Facts(const Terms& terms) {
  for (const std::string& uav : terms.members) {
    Entry entry;
    entry.uav = uav;
    entries_.push_back(std::move(entry));
  }
}

std::optional<std::string> Facts::contradiction_in(const std::vector<Entry>& others) const {
  if (others.size() != entries_.size()) return "it has not one entry for each member";
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (auto problem = problem_of(others[i])) return problem;
    if (auto problem = problem_between(entries_[i], others[i])) return problem;
  }
  const bool decided = others.front().vow == Vow::kPromised;
  const bool promised = std::all_of(others.begin(), others.end(),
                                    [](const Entry& one) { return one.vow == Vow::kPromised; });
  if (decided && !promised) return others.front().uav + " promised before the others";
  return std::nullopt;
}

void Facts::merge(const std::vector<Entry>& others) {
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& mine = entries_[i];
    const Entry& theirs = others[i];
    if (theirs.offered && !mine.offered) {
      mine.offered = true;
      mine.offer = theirs.offer;
    }
    if (theirs.vow != Vow::kNone && mine.vow == Vow::kNone) {
      mine.vow = theirs.vow;
      mine.result = theirs.result;
      mine.why = theirs.why;
    }
    mine.lost = mine.lost || theirs.lost;
  }
}

FactBits Facts::bits_of(const std::vector<Entry>& entries) {
  static_assert(3 * kMostMembers <= 64);
  FactBits bits = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& one = entries[i];
    const FactBits three =
        FactBits{one.offered} | FactBits{one.vow != Vow::kNone} << 1U | FactBits{one.lost} << 2U;
    bits |= three << (3 * i);
  }
  return bits;
}

int Facts::stage_of(FactBits bits) const {
  FactBits offers = 0;
  for (std::size_t i = 0; i < size(); ++i) offers |= FactBits{1} << (3 * i);
  constexpr FactBits kDecision = 2;
  if ((bits & kDecision) != 0) return 3;
  if (const Entry* refused = refusal()) {
    const auto who = static_cast<std::size_t>(refused - entries_.data());
    if ((bits & (FactBits{2} << (3 * who))) != 0) return 3;
  }
  return (bits & offers) == offers ? 2 : 1;
}

bool Facts::all_offered() const {
  return std::all_of(entries_.begin(), entries_.end(),
                     [](const Entry& one) { return one.offered; });
}

bool Facts::all_promised() const {
  return std::all_of(entries_.begin(), entries_.end(),
                     [](const Entry& one) { return one.vow == Vow::kPromised; });
}

const Entry* Facts::refusal() const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [](const Entry& one) { return one.vow == Vow::kRefused; });
  return found == entries_.end() ? nullptr : &*found;
}

const Entry* Facts::loss() const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [](const Entry& one) {
    return one.lost && one.vow == Vow::kNone;
  });
  return found == entries_.end() ? nullptr : &*found;
}

}  // namespace skein::interaction
