// SPDX-License-Identifier: Apache-2.0
// Heights at which neighbours do not meet over their common border.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "common/deadline.hpp"
#include "common/shared_checks.hpp"
#include "partition/planner.hpp"

namespace skein::refiners::partition {
namespace {

using world::Vector2;
using world::Vector3;

constexpr std::uint32_t kPiece = 300;  ///< about what one is compared for [ns]

struct Piece {
  Vector3 from, to;
};

/// From the first lane to the last, in pieces no longer than `most` on the level.
std::vector<Piece> pieces_of(const Coverage& coverage, double most) {
  const auto is_at = [](const Vector2& place) {
    return [&place](const Vector3& point) { return (point.head<2>() - place).norm() < 1e-6; };
  };
  const Way& way = coverage.way;
  const auto first = std::find_if(way.begin(), way.end(), is_at(coverage.lanes.front().from));
  const auto last = std::find_if(way.rbegin(), way.rend(), is_at(coverage.lanes.back().to)).base();
  std::vector<Piece> pieces;
  for (auto at = first; at != last && at + 1 != last; ++at) {
    const Vector3 leg = *(at + 1) - *at;
    const double count = std::max(1.0, std::ceil(leg.head<2>().norm() / most));
    for (double k = 0; k < count; ++k)
      pieces.push_back({*at + k / count * leg, *at + (k + 1) / count * leg});
  }
  return pieces;
}

double distance(const Vector2& point, const Vector2& a, const Vector2& b) {
  const double length2 = (b - a).squaredNorm();
  const double part = length2 > 0 ? std::clamp((point - a).dot(b - a) / length2, 0.0, 1.0) : 0;
  return (point - a - part * (b - a)).norm();
}

bool cross(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const auto side = [](const Vector2& p, const Vector2& q, const Vector2& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool too_near(const Piece& one, const Piece& other, double apart) {
  const auto [low, high] = std::minmax(one.from.z(), one.to.z());
  const auto [other_low, other_high] = std::minmax(other.from.z(), other.to.z());
  if (low - other_high >= apart || other_low - high >= apart) return false;
  const Vector2 a = one.from.head<2>(), b = one.to.head<2>();
  const Vector2 c = other.from.head<2>(), d = other.to.head<2>();
  return cross(a, b, c, d) || std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b),
                                        distance(d, a, b)}) < apart;
}

/// The pieces of sweeps whose heights are settled, by the squares on the ground they begin in.
class Settled {
 public:
  /// Pieces are no longer than `apart`, so those near each other are at most two squares apart.
  Settled(double apart, Deadline& deadline) : apart_(apart), deadline_(deadline) {}

  void add(std::size_t member, const Coverage& coverage) {
    for (const Piece& piece : pieces_of(coverage, apart_))
      squares_[key(square(piece.from, 0), square(piece.from, 1))].push_back({member, piece});
  }

  /// A member that the sweep comes too near to, if any.
  std::optional<std::size_t> met_by(const Coverage& coverage) const {
    for (const Piece& piece : pieces_of(coverage, apart_)) {
      if (deadline_.passed_after(kPiece)) return std::nullopt;
      const std::int64_t x = square(piece.from, 0), y = square(piece.from, 1);
      for (std::int64_t i = x - 1; i <= x + 1; ++i)
        for (std::int64_t k = y - 1; k <= y + 1; ++k)
          if (const auto met = met_in(key(i, k), piece)) return met;
    }
    return std::nullopt;
  }

 private:
  struct Owned {
    std::size_t member;
    Piece piece;
  };

  /// Three times as wide as they may be apart: of two pieces as long as that, the beginnings.
  std::int64_t square(const Vector3& at, Eigen::Index axis) const {
    return static_cast<std::int64_t>(std::floor(at[axis] / (3 * apart_)));
  }
  static std::int64_t key(std::int64_t x, std::int64_t y) { return x * 0x100000001 + y; }

  std::optional<std::size_t> met_in(std::int64_t square, const Piece& piece) const {
    const auto found = squares_.find(square);
    if (found == squares_.end()) return std::nullopt;
    for (const Owned& other : found->second)
      if (too_near(piece, other.piece, apart_)) return other.member;
    return std::nullopt;
  }

  double apart_;
  Deadline& deadline_;
  std::unordered_map<std::int64_t, std::vector<Owned>> squares_;
};

/// Those that have least room to be raised first.
std::vector<std::size_t> order_of(const std::vector<Member>& members) {
  std::vector<std::size_t> order(members.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto room = [&](std::size_t i) { return members[i].vehicle.ceiling - members[i].altitude; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return room(a) < room(b); });
  return order;
}

Refusal no_height(const PartitionQuery& query, std::size_t member, std::size_t met) {
  return {RefusalKind::kBeyondVehicle, "members." + std::to_string(member) + ".altitude",
          query.members[member].uav + " sweeps within " + figure(query.apart) + " m of " +
              query.members[met].uav +
              " at about the same height, and cannot be raised; give other altitudes, or a lesser "
              "`apart`"};
}

/// Raises the sweep of one member until it meets none of those settled.
std::optional<Refusal> settle(Planner& planner, Trial& trial, std::size_t member,
                              const Settled& settled) {
  const PartitionQuery& query = planner.query();
  double altitude = query.members[member].altitude;
  while (const auto met = settled.met_by(trial.sweeps[member].task)) {
    altitude += query.apart;
    if (planner.setting().budget.expired()) break;
    if (altitude > query.members[member].vehicle.ceiling ||
        !planner.fly_at(trial, member, altitude) || !planner.has_energy(trial))
      return no_height(query, member, *met);
  }
  return std::nullopt;
}

}  // namespace

Result<bool, Refusal> keep_apart(Planner& planner, Trial& trial) {
  const double apart = planner.query().apart;
  if (apart <= 0 || trial.sweeps.size() < 2) return true;
  Deadline deadline(planner.setting().budget);
  Settled settled(apart, deadline);
  for (const std::size_t member : order_of(planner.query().members)) {
    if (deadline.passed()) return false;
    if (auto problem = settle(planner, trial, member, settled))
      return tl::unexpected<Refusal>(*problem);
    settled.add(member, trial.sweeps[member].task);
  }
  return !deadline.passed();
}

}  // namespace skein::refiners::partition
