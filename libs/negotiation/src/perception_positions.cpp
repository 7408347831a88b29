// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "choices.hpp"
#include "row_words.hpp"
#include "standard_modalities.hpp"

namespace skein::interaction {

namespace {

constexpr std::size_t kMostPlaced = 8;
constexpr std::size_t kMostDirections = 72;

using Costs = std::vector<std::vector<std::optional<double>>>;

/// Least-cost directions for all members with at least so many steps between any two, around the
/// circle. A table over the directions in order and the set of members that have theirs.
class Spread {
 public:
  Spread(const Costs& costs, std::size_t directions, std::size_t gap)
      : costs_(costs), directions_(directions), gap_(gap), sets_(std::size_t{1} << costs.size()) {
    for (std::size_t first = 0; first < directions_; ++first) place_from(first);
  }

  /// Of each member its direction; empty: impossible.
  const std::vector<std::size_t>& best() const { return best_; }

 private:
  struct Cell {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t member = kMostPlaced;  ///< who stands in this direction; kMostPlaced: nobody
  };
  Cell& at(std::size_t direction, std::size_t set) { return table_[direction * sets_ + set]; }

  // The first of all stands in direction `first`, the last no nearer to it than the gap.
  void place_from(std::size_t first) {
    table_.assign((directions_ + 1) * sets_, Cell{});
    const std::size_t last = costs_.size() == 1 ? first : directions_ + first - gap_;
    for (std::size_t d = first; d < directions_ && d <= last; ++d) fill(first, d);
    const std::size_t end = std::min(directions_ - 1, last);
    const double cost = at(end, sets_ - 1).cost;
    if (cost < cost_) {
      cost_ = cost;
      best_ = trace(end);
    }
  }

  void fill(std::size_t first, std::size_t d) {
    for (std::size_t set = 1; set < sets_; ++set) {
      Cell best;
      if (d > first) best = {at(d - 1, set).cost, kMostPlaced};
      for (std::size_t member = 0; member < costs_.size(); ++member) {
        const std::size_t rest = set & ~(std::size_t{1} << member);
        if (rest == set || !costs_[member][d]) continue;
        double before = std::numeric_limits<double>::infinity();
        if (rest == 0 && d == first) before = 0;
        if (rest != 0 && d >= first + gap_) before = at(d - gap_, rest).cost;
        const double cost = before + *costs_[member][d];
        if (cost < best.cost) best = {cost, member};
      }
      at(d, set) = best;
    }
  }

  std::vector<std::size_t> trace(std::size_t d) {
    std::vector<std::size_t> found(costs_.size());
    for (std::size_t set = sets_ - 1; set != 0;) {
      const std::size_t member = at(d, set).member;
      if (member == kMostPlaced) {
        --d;
        continue;
      }
      found[member] = d;
      set &= ~(std::size_t{1} << member);
      if (set != 0) d -= gap_;
    }
    return found;
  }

  const Costs& costs_;
  std::size_t directions_, gap_, sets_;
  std::vector<Cell> table_;
  double cost_ = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> best_;
};

class PerceptionPositions : public NegotiationModality {
 public:
  std::string_view name() const override { return "perception-positions"; }

 private:
  std::optional<std::string> do_check(const Terms& terms) const override {
    if (terms.members.size() > kMostPlaced) {
      return "more than " + std::to_string(kMostPlaced) + " members";
    }
    if (auto missing = missing_row(terms.parameters, "directions", 1)) return missing;
    const double number = only_row(terms.parameters, "directions")->numbers[0];
    const auto least = static_cast<double>(terms.members.size());
    if (number < least || number > kMostDirections || number != std::floor(number)) {
      return "not from as many directions as members to " + std::to_string(kMostDirections);
    }
    return std::nullopt;
  }

  std::optional<std::string> do_check_offer(const Terms& terms, const Rows& offer) const override {
    return problem_of_choices(offer, "direction", directions_of(terms));
  }

  // What is possible with one gap is with any lesser.
  Result<Rows, Failure> do_settle(const Terms& terms, const Offers& offers) const override {
    const std::size_t directions = directions_of(terms);
    Costs costs;
    for (const std::string& uav : terms.members) {
      costs.push_back(costs_of_choices(offers.at(uav), directions));
    }
    std::size_t low = 0, high = directions / terms.members.size();
    std::vector<std::size_t> best;
    while (low < high) {
      const std::size_t gap = (low + high + 1) / 2;
      std::vector<std::size_t> found = Spread(costs, directions, gap).best();
      if (found.empty()) {
        high = gap - 1;
      } else {
        low = gap;
        best = std::move(found);
      }
    }
    if (best.empty()) return failure("there are not enough directions that suit");
    Rows result;
    for (std::size_t i = 0; i < best.size(); ++i) {
      result.push_back({terms.members[i], "", {static_cast<double>(best[i])}});
    }
    return result;
  }

  static std::size_t directions_of(const Terms& terms) {
    return static_cast<std::size_t>(only_row(terms.parameters, "directions")->numbers[0]);
  }
};

}  // namespace

std::unique_ptr<NegotiationModality> perception_positions() {
  return std::make_unique<PerceptionPositions>();
}

}  // namespace skein::interaction
