// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include "row_words.hpp"
#include "skein/refiners/checks.hpp"
#include "skein/refiners/partition.hpp"
#include "standard_modalities.hpp"

namespace skein::interaction {

namespace {

using world::Polygon;
using world::Vector2;

Polygon polygon_of(const Row& row) {
  Polygon polygon;
  for (std::size_t i = 0; i + 1 < row.numbers.size(); i += 2) {
    polygon.emplace_back(row.numbers[i], row.numbers[i + 1]);
  }
  return polygon;
}

bool is_convex(const Polygon& polygon) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 one = polygon[(i + 1) % polygon.size()] - polygon[i];
    const Vector2 next = polygon[(i + 2) % polygon.size()] - polygon[(i + 1) % polygon.size()];
    const double turn = one.x() * next.y() - one.y() * next.x();
    const double flat = 1e-9 * one.norm() * next.norm();
    left = left || turn > flat;
    right = right || turn < -flat;
  }
  return !(left && right);
}

double distance_to(const Polygon& polygon, const Vector2& point) {
  if (world::contains(polygon, point)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2 side = polygon[(i + 1) % polygon.size()] - a;
    const double along = std::clamp((point - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (point - a - along * side).norm());
  }
  return least;
}

/// Who sweeps, how fast, from when on.
struct Sweeper {
  Vector2 start = Vector2::Zero();
  double rate = 0, arrival = 0;
};

/// When together they have swept so much: what each sweeps until then adds up to it.
double common_end(std::vector<Sweeper> sweepers, double area) {
  std::sort(sweepers.begin(), sweepers.end(),
            [](const Sweeper& a, const Sweeper& b) { return a.arrival < b.arrival; });
  double rates = 0, before = 0, end = 0;
  for (std::size_t i = 0; i < sweepers.size(); ++i) {
    rates += sweepers[i].rate;
    before += sweepers[i].rate * sweepers[i].arrival;
    end = (area + before) / rates;
    if (i + 1 < sweepers.size() && end <= sweepers[i + 1].arrival) return end;
  }
  return end;
}

class AreaSharing : public NegotiationModality {
 public:
  std::string_view name() const override { return "area-sharing"; }

 private:
  std::optional<std::string> do_check(const Terms& terms) const override {
    const Row* row = only_row(terms.parameters, "area");
    if (row == nullptr || row->numbers.size() % 2 != 0) return "not one 'area' of corners x, y";
    const Polygon polygon = polygon_of(*row);
    if (auto refusal = refiners::check_polygon(polygon, "area")) return refusal->why;
    if (!is_convex(polygon)) return "the area is not convex";
    return std::nullopt;
  }

  std::optional<std::string> do_check_offer(const Terms&, const Rows& offer) const override {
    if (auto missing = missing_row(offer, "start", 2)) return missing;
    for (const char* name : {"rate", "speed"}) {
      if (auto missing = missing_row(offer, name, 1)) return missing;
      if (!(only_row(offer, name)->numbers[0] > 0)) return std::string(name) + " is not above 0";
    }
    return std::nullopt;
  }

  Result<Rows, Failure> do_settle(const Terms& terms, const Offers& offers) const override {
    const Polygon area = polygon_of(*only_row(terms.parameters, "area"));
    std::vector<Sweeper> sweepers;
    for (const std::string& uav : terms.members) sweepers.push_back(sweeper(area, offers.at(uav)));
    const double end = common_end(sweepers, world::area(area));
    std::vector<Vector2> anchors;
    std::vector<double> shares;
    Rows result;
    std::vector<std::size_t> takers;
    for (std::size_t i = 0; i < sweepers.size(); ++i) {
      result.push_back({terms.members[i], "", {}});
      const double share = sweepers[i].rate * (end - sweepers[i].arrival);
      if (share <= 0) continue;
      takers.push_back(i);
      anchors.push_back(sweepers[i].start);
      shares.push_back(share);
    }
    const std::vector<Polygon> parts = refiners::divide(area, anchors, shares);
    for (std::size_t i = 0; i < takers.size(); ++i) {
      for (const Vector2& corner : parts[i]) {
        auto& numbers = result[takers[i]].numbers;
        numbers.insert(numbers.end(), {corner.x(), corner.y()});
      }
    }
    return result;
  }

  static Sweeper sweeper(const Polygon& area, const Rows& offer) {
    const auto& start = only_row(offer, "start")->numbers;
    Sweeper one{{start[0], start[1]}, only_row(offer, "rate")->numbers[0], 0};
    one.arrival = distance_to(area, one.start) / only_row(offer, "speed")->numbers[0];
    return one;
  }
};

}  // namespace

std::unique_ptr<NegotiationModality> area_sharing() { return std::make_unique<AreaSharing>(); }

}  // namespace skein::interaction
