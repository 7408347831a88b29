// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <tuple>

#include "row_words.hpp"
#include "standard_modalities.hpp"

namespace skein::interaction {

namespace {

/// What all can do that begins at one instant.
struct Slot {
  double ranks = 0, worst = 0;
  double from = 0, until = 0;

  bool operator<(const Slot& other) const {
    return std::tie(ranks, worst, from) < std::tie(other.ranks, other.worst, other.from);
  }
};

/// The best-ranked interval of an offer that has room for so long from there.
std::optional<std::size_t> rank_at(const Rows& offer, double from, double duration) {
  for (std::size_t i = 0; i < offer.size(); ++i) {
    const auto& interval = offer[i].numbers;
    if (interval[0] <= from && from + duration <= interval[1]) return i;
  }
  return std::nullopt;
}

std::optional<Slot> slot_at(const Offers& offers, double from, double duration) {
  Slot slot{0, 0, from, from};
  bool first = true;
  for (const auto& [uav, offer] : offers) {
    const auto rank = rank_at(offer, from, duration);
    if (!rank) return std::nullopt;
    slot.ranks += static_cast<double>(*rank);
    slot.worst = std::max(slot.worst, static_cast<double>(*rank));
    const auto& interval = offer[*rank].numbers;
    slot.until = first ? interval[1] : std::min(slot.until, interval[1]);
    first = false;
  }
  return slot;
}

class TimeInterval : public NegotiationModality {
 public:
  std::string_view name() const override { return "time-interval"; }

 private:
  std::optional<std::string> do_check(const Terms& terms) const override {
    if (auto missing = missing_row(terms.parameters, "duration", 1)) return missing;
    if (!(only_row(terms.parameters, "duration")->numbers[0] > 0)) return "it lasts no time";
    return std::nullopt;
  }

  std::optional<std::string> do_check_offer(const Terms&, const Rows& offer) const override {
    for (const Row& row : offer) {
      if (row.name != "interval" || row.numbers.size() != 2)
        return "'" + row.name + "' is no interval";
      if (!(row.numbers[0] < row.numbers[1])) return "an interval ends before it begins";
    }
    return std::nullopt;
  }

  // Where a slot begins to be possible, or is ranked better, some interval begins.
  Result<Rows, Failure> do_settle(const Terms& terms, const Offers& offers) const override {
    const double duration = only_row(terms.parameters, "duration")->numbers[0];
    std::optional<Slot> best;
    for (const auto& [uav, offer] : offers) {
      for (const Row& row : offer) {
        const auto slot = slot_at(offers, row.numbers[0], duration);
        if (slot && (!best || *slot < *best)) best = slot;
      }
    }
    if (!best) return failure("no interval suits all");
    return Rows{{"interval", "", {best->from, best->until}}};
  }
};

}  // namespace

std::unique_ptr<NegotiationModality> time_interval() { return std::make_unique<TimeInterval>(); }

}  // namespace skein::interaction
