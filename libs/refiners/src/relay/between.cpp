// SPDX-License-Identifier: Apache-2.0
// The best place for one relay.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <queue>
#include <tuple>

#include "relay/space.hpp"

namespace skein::refiners::relay {
namespace {

/// What is known of the sight from one place to the voxels of each column: the ground hides
/// everything below a level and nothing above it. All that is never asked about takes no memory:
/// the system gives the pages of a large allocation only when they are first written.
class Sight {
 public:
  Sight(const Space& space, const Vector3& from)
      : space_(space), from_(from), columns_(zeroed(space.grid())) {}

  /// Nothing when there is no budget to look.
  std::optional<bool> sees(const Voxel& voxel, Meter& meter) {
    Column& column = columns_.get()[space_.grid().index(voxel[0], voxel[1], 0)];
    if (voxel[2] < column.hidden) return false;
    if (space_.grid().size[2] - voxel[2] <= column.seen) return true;
    if (!meter.link()) return std::nullopt;
    const bool seen = space_.is_in_sight(from_, space_.centre(voxel));
    if (seen)
      column.seen = space_.grid().size[2] - voxel[2];
    else
      column.hidden = voxel[2] + 1;
    return seen;
  }

 private:
  /// So many voxels from the bottom, and from the top.
  struct Column {
    std::int32_t hidden = 0, seen = 0;
  };
  struct Free {
    void operator()(Column* columns) const { std::free(columns); }
  };

  static Column* zeroed(const world::AirspaceGrid& grid) {
    const auto count =
        static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
    void* memory = std::calloc(count, sizeof(Column));
    if (memory == nullptr) throw std::bad_alloc();
    return static_cast<Column*>(memory);
  }

  const Space& space_;
  Vector3 from_;
  std::unique_ptr<Column, Free> columns_;
};

/// Voxels low … high, and how near to both ends the nearest of their centres is at best.
struct Box {
  double distance = 0;
  Voxel low{}, high{};
};

struct Farther {
  bool operator()(const Box& a, const Box& b) const {
    return std::tie(a.distance, a.low, a.high) > std::tie(b.distance, b.low, b.high);
  }
};

class Finder {
 public:
  Finder(const Space& space, const Vector3& a, const Vector3& b, Meter& meter)
      : space_(space), a_(a), b_(b), meter_(meter), from_a_(space, a), from_b_(space, b) {}

  std::optional<Place> run() {
    const auto& size = space_.grid().size;
    push({0, 0, 0}, {size[0] - 1, size[1] - 1, size[2] - 1});
    while (!boxes_.empty() && meter_.work()) {
      const Box box = boxes_.top();
      boxes_.pop();
      if (box.low != box.high) {
        halve(box);
        continue;
      }
      if (!space_.is_open(box.low)) continue;
      const auto seen = sees_both(box.low);
      if (!seen) break;
      if (*seen) return Place{space_.centre(box.low), space_.margin(box.distance)};
    }
    return std::nullopt;
  }

 private:
  std::optional<bool> sees_both(const Voxel& voxel) {
    const auto a = from_a_.sees(voxel, meter_);
    if (!a || !*a) return a;
    return from_b_.sees(voxel, meter_);
  }

  void push(const Voxel& low, const Voxel& high) {
    const Vector3 least = space_.centre(low), most = space_.centre(high);
    const auto distance = [&](const Vector3& to) {
      return (to.cwiseMax(least).cwiseMin(most) - to).norm();
    };
    const double farther = std::max(distance(a_), distance(b_));
    if (space_.margin(farther) >= space_.least_margin()) boxes_.push({farther, low, high});
  }

  void halve(const Box& box) {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (box.high[i] - box.low[i] > box.high[axis] - box.low[axis]) axis = i;
    Voxel end = box.high, begin = box.low;
    end[axis] = box.low[axis] + (box.high[axis] - box.low[axis]) / 2;
    begin[axis] = end[axis] + 1;
    push(box.low, end);
    push(begin, box.high);
  }

  const Space& space_;
  Vector3 a_, b_;
  Meter& meter_;
  Sight from_a_, from_b_;
  std::priority_queue<Box, std::vector<Box>, Farther> boxes_;
};

}  // namespace

std::optional<Place> best_between(const Space& space, const Vector3& a, const Vector3& b,
                                  Meter& meter) {
  return Finder(space, a, b, meter).run();
}

}  // namespace skein::refiners::relay
