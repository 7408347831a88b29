// SPDX-License-Identifier: Apache-2.0
#include "path/any_angle_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "path/blocked_words.hpp"
#include "path/bucket_queue.hpp"
#include "path/free_voxels.hpp"

namespace skein::refiners {
namespace {

using world::Airspace;
using world::Voxel;

/// Priorities are held to so many steps a voxel; the order need not be exact here.
constexpr double kStepsPerVoxel = 32;
constexpr std::int64_t kSpan = (1 << 15) - 1;

/// By how much ways along the graph are longer than straight ones, nearly everywhere: up to 1.22.
constexpr double kGrain = 1.15;

/// After so many nodes it begins to hurry; after twice as many it is in full haste.
constexpr double kPatient = 150'000;
constexpr double kHaste = 0.1;

/// The steps to the neighbours, and what must be free around a voxel to make them: every voxel of
/// the box between, as bits of the 27 around, the lowest first.
struct Step {
  Voxel by{};
  std::uint32_t needs = 0;
};
constexpr std::uint32_t bit_of(std::int32_t x, std::int32_t y, std::int32_t z) {
  return std::uint32_t{1} << static_cast<unsigned>((z + 1) * 9 + (y + 1) * 3 + x + 1);
}
constexpr std::array<Step, 26> all_steps() {
  std::array<Step, 26> steps{};
  std::size_t count = 0;
  for (std::int32_t z = -1; z <= 1; ++z)
    for (std::int32_t y = -1; y <= 1; ++y)
      for (std::int32_t x = -1; x <= 1; ++x) {
        if (x == 0 && y == 0 && z == 0) continue;
        steps[count].by = {x, y, z};
        for (std::int32_t some = 0; some < 8; ++some)
          steps[count].needs |= bit_of((some & 1) * x, (some >> 1 & 1) * y, (some >> 2) * z);
        ++count;
      }
  return steps;
}
constexpr std::array<Step, 26> kSteps = all_steps();

/// What is known of a voxel, in one word: cost so far [voxels × cost], where it hangs, and whether
/// it was expanded.
struct Record {
  float cost = 0;
  std::uint32_t parent = 0;  // index in the grid, plus one; 0: never reached
  bool expanded = false;

  static Record of(std::uint64_t word) {
    return {std::bit_cast<float>(static_cast<std::uint32_t>(word >> 32U)),
            static_cast<std::uint32_t>(word & 0x7FFFFFFFU), (word & 0x80000000U) != 0};
  }
  std::uint64_t word() const {
    return std::uint64_t{std::bit_cast<std::uint32_t>(cost)} << 32U | parent |
           (expanded ? 0x80000000U : 0U);
  }
};

class AnyAngleSearch {
 public:
  AnyAngleSearch(const Airspace& airspace, const Voxel& from, const Voxel& to, double bound,
                 const Budget& budget, const AnyAngleHelp& help)
      : airspace_(airspace),
        free_(airspace),
        from_(from),
        to_(to),
        rate_(airspace.least_cost() * Airspace::kCostStep),
        even_(airspace.least_cost() == airspace.greatest_cost()),
        records_(airspace.grid()),
        queue_(kSpan),
        bound_(bound / airspace.grid().voxel),
        countdown_(budget, 256),
        help_(help) {}

  AnyAngleWay run() {
    AnyAngleWay answer;
    if (records_.usable()) search(answer);
    answer.expanded = countdown_.steps();
    answer.cut_short = countdown_.cut_short();
    return answer;
  }

 private:
  void search(AnyAngleWay& answer) {
    reach(from_, index_of(from_), 0);
    while (!queue_.empty()) {
      const Voxel at = voxel_of(queue_.pop());
      Record record = Record::of(records_.at(at));
      if (record.expanded) continue;
      if (!countdown_.step()) return;
      const std::uint32_t around = free_.around(at);
      if (!settle(at, around, record)) continue;
      if (at == to_) {
        trace(answer.way);
        return;
      }
      expand(at, around, record);
    }
  }

  std::uint32_t index_of(const Voxel& voxel) const {
    return static_cast<std::uint32_t>(airspace_.grid().index(voxel[0], voxel[1], voxel[2]));
  }
  Voxel voxel_of(std::uint64_t word) const {
    const auto index = static_cast<std::uint32_t>(word);
    const auto width = static_cast<std::uint32_t>(airspace_.grid().size[0]);
    const auto depth = static_cast<std::uint32_t>(airspace_.grid().size[1]);
    return {static_cast<std::int32_t>(index % width),
            static_cast<std::int32_t>(index / width % depth),
            static_cast<std::int32_t>(index / width / depth)};
  }
  static double distance(const Voxel& a, const Voxel& b) {
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return std::sqrt(x * x + y * y + z * z);
  }
  static Voxel moved(Voxel voxel, const Voxel& by) {
    for (std::size_t i = 0; i < 3; ++i) voxel[i] += by[i];
    return voxel;
  }

  /// [voxels × cost]; nothing when it is not free.
  std::optional<double> leg(const Voxel& a, const Voxel& b) const {
    if (even_) return sees(a, b) ? std::optional(rate_ * distance(a, b)) : std::nullopt;
    const auto cost = airspace_.cost(airspace_.centre(a), airspace_.centre(b));
    return cost ? std::optional(*cost / airspace_.grid().voxel) : std::nullopt;
  }

  /// Airspace::is_free from centre to centre, in whole numbers: along an axis with n voxels to go
  /// the k-th face is crossed at the fraction (2 k + 1) / 2 n, here times twice all n.
  bool sees(const Voxel& a, const Voxel& b) const {
    constexpr auto kNever = std::numeric_limits<std::int64_t>::max();
    const world::AirspaceGrid& grid = airspace_.grid();
    const std::uint8_t* voxels = airspace_.voxels().data();
    const std::array<std::int64_t, 3> strides = {1, grid.size[0],
                                                 std::int64_t{grid.size[0]} * grid.size[1]};
    std::array<std::int64_t, 3> many{}, steps{}, next{}, faces{};
    for (std::size_t i = 0; i < 3; ++i) {
      many[i] = std::abs(b[i] - a[i]);
      steps[i] = b[i] > a[i] ? strides[i] : -strides[i];
    }
    const auto others = [&](std::size_t i) { return std::max<std::int64_t>(many[i], 1); };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t first = others((i + 1) % 3) * others((i + 2) % 3);
      next[i] = many[i] > 0 ? first : kNever;
      faces[i] = 2 * first;
    }
    auto at = static_cast<std::int64_t>(index_of(a));
    for (const auto last = static_cast<std::int64_t>(index_of(b)); at != last;) {
      const std::int64_t now = std::min({next[0], next[1], next[2]});
      unsigned crossed = 0;
      for (std::size_t i = 0; i < 3; ++i)
        if (next[i] == now) {
          crossed |= 1U << i;
          next[i] += faces[i];
        }
      if (!are_free(voxels + at, steps, crossed)) return false;
      for (std::size_t i = 0; i < 3; ++i) at += (crossed >> i & 1U) != 0 ? steps[i] : 0;
    }
    return true;
  }

  /// Those entered together: more than one where an edge or a corner is crossed.
  static bool are_free(const std::uint8_t* at, const std::array<std::int64_t, 3>& steps,
                       unsigned crossed) {
    for (unsigned some = crossed; some != 0; some = (some - 1) & crossed) {
      std::int64_t beside = 0;
      for (std::size_t i = 0; i < 3; ++i) beside += (some >> i & 1U) != 0 ? steps[i] : 0;
      if (at[beside] == Airspace::kBlocked) return false;
    }
    return true;
  }

  /// What is left of the way, about [voxels × cost].
  double left_from(const Voxel& voxel) const {
    const double straight = rate_ * distance(voxel, to_);
    if (help_.known == nullptr) return help_.greed * straight;
    return std::max(straight, rate_ * help_.known->from_start(voxel) / kGrain);
  }

  /// What the way so far counts: less and less once the search is long, so that it makes for the
  /// goal and does not look at all that is nearly as good.
  double patience() const {
    const auto expanded = static_cast<double>(countdown_.steps());
    return std::clamp(1 - (expanded - kPatient) / kPatient * kHaste, 1 - kHaste, 1.0);
  }

  void reach(const Voxel& voxel, std::uint32_t parent, double cost) {
    const Record record{static_cast<float>(cost), parent + 1, false};
    records_.at(voxel) = record.word();
    const double estimate = (patience() * cost + left_from(voxel)) * kStepsPerVoxel;
    queue_.push(std::clamp(static_cast<std::int64_t>(estimate), queue_.priority(),
                           queue_.priority() + kSpan),
                index_of(voxel));
  }

  /// Makes the cost a real one: that of the leg from its parent when that is free, or else over the
  /// best neighbour expanded. False when it has to queue again since it came out dearer.
  bool settle(const Voxel& at, std::uint32_t around, Record& record) {
    if (at != from_) {
      const Voxel parent = voxel_of(record.parent - 1);
      const auto direct = leg(parent, at);
      const float assumed = record.cost;
      const float free_cost =
          direct ? Record::of(records_.at(parent)).cost + static_cast<float>(*direct) : 0;
      if (!direct || free_cost > assumed * 1.0001F) {
        record.cost = direct ? free_cost : std::numeric_limits<float>::infinity();
        take_best_neighbour(at, around, record);
        if (record.cost > assumed + 0.5F) {
          reach(at, record.parent - 1, record.cost);
          return false;
        }
      }
    }
    record.expanded = true;
    records_.at(at) = record.word();
    return true;
  }

  void take_best_neighbour(const Voxel& at, std::uint32_t around, Record& record) const {
    for (const Step& step : kSteps) {
      if ((around & step.needs) != step.needs) continue;
      const Voxel beside = moved(at, step.by);
      const Record other = Record::of(records_.at(beside));
      if (!other.expanded) continue;
      const double step_cost =
          even_ ? rate_ * distance(beside, at) : leg(beside, at).value_or(1e30);
      const auto cost = other.cost + static_cast<float>(step_cost);
      if (cost >= record.cost) continue;
      record.cost = cost;
      record.parent = index_of(beside) + 1;
    }
  }

  void expand(const Voxel& at, std::uint32_t around, const Record& record) {
    const std::uint32_t parent = record.parent - 1;
    const Voxel corner = voxel_of(parent);
    const double cost = Record::of(records_.at(corner)).cost;
    for (const Step& step : kSteps) {
      if ((around & step.needs) != step.needs) continue;
      const Voxel beside = moved(at, step.by);
      const Record other = Record::of(records_.at(beside));
      if (other.expanded) continue;
      const double sum = cost + rate_ * distance(corner, beside);
      if (other.parent != 0 && other.cost <= static_cast<float>(sum)) continue;
      if (sum + rate_ * distance(beside, to_) >= bound_) continue;
      reach(beside, parent, sum);
    }
  }

  void trace(Way& way) const {
    for (Voxel at = to_; at != from_; at = voxel_of(Record::of(records_.at(at)).parent - 1))
      way.push_back(airspace_.centre(at));
    way.push_back(airspace_.centre(from_));
    std::reverse(way.begin(), way.end());
  }

  const Airspace& airspace_;
  FreeVoxels free_;
  Voxel from_, to_;
  double rate_;
  bool even_;  // one crossing cost everywhere
  BlockedWords records_;
  BucketQueue queue_;
  double bound_;  // [voxels × cost]
  Countdown countdown_;
  AnyAngleHelp help_;
};

}  // namespace

AnyAngleWay search_any_angle(const Airspace& airspace, const Voxel& from, const Voxel& to,
                             double bound, const Budget& budget, const AnyAngleHelp& help) {
  if (help.known == nullptr) return AnyAngleSearch(airspace, from, to, bound, budget, help).run();
  AnyAngleWay found = AnyAngleSearch(airspace, to, from, bound, budget, help).run();
  std::reverse(found.way.begin(), found.way.end());
  return found;
}

}  // namespace skein::refiners
