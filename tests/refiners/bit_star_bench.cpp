// SPDX-License-Identifier: Apache-2.0
// Lengths of the voxels' ways against those of OMPL's planners, in one run.
//
//   skein_bit_star_bench                 BIT* and Informed RRT* with 1 s of CPU a query
//   skein_bit_star_bench --seconds 10    with 10 s
//
// World and queries are those of skein_refiners_path_bench. OMPL asks Airspace::is_free of points
// and of whole segments. "pulled" is what refiners::pull_straight makes of a way. The best of a
// query is the shortest that any of the methods found, by A* over 26 neighbours too.
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "box_world.hpp"
#include "skein/refiners/flight.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::sampling {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using refiners::Way;
using refiners::bench::cpu_ms;
using refiners::bench::Ends;
using world::Airspace;
using world::Vector3;
using world::Voxel;

constexpr double kNone = std::numeric_limits<double>::infinity();

using State = ob::RealVectorStateSpace::StateType;
Vector3 point_of(const ob::State* state) {
  const double* values = state->as<State>()->values;
  return {values[0], values[1], values[2]};
}

class Segments final : public ob::MotionValidator {
 public:
  Segments(const ob::SpaceInformationPtr& info, const Airspace& airspace)
      : MotionValidator(info), airspace_(airspace) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return airspace_.is_free(point_of(from), point_of(to));
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    if (last_valid.first) si_->copyState(last_valid.first, from);
    last_valid.second = 0;
    return false;
  }

 private:
  const Airspace& airspace_;
};

ob::SpaceInformationPtr info_of(const Airspace& airspace) {
  const auto space = std::make_shared<ob::RealVectorStateSpace>(3);
  space->setBounds(0, refiners::bench::kSide);
  const auto info = std::make_shared<ob::SpaceInformation>(space);
  info->setStateValidityChecker(
      [&airspace](const ob::State* state) { return airspace.is_free(point_of(state)); });
  info->setMotionValidator(std::make_shared<Segments>(info, airspace));
  info->setup();
  return info;
}

/// By OMPL until that much CPU time is used; empty when nothing was found.
template <class Planner>
Way by_ompl(const Airspace& airspace, const Vector3& from, const Vector3& to, double milliseconds,
            bool simplify) {
  const auto info = info_of(airspace);
  const auto problem = std::make_shared<ob::ProblemDefinition>(info);
  ob::ScopedState<> first(info), last(info);
  for (unsigned i = 0; i < 3; ++i) {
    first->as<State>()->values[i] = from[i];
    last->as<State>()->values[i] = to[i];
  }
  problem->setStartAndGoalStates(first, last);
  const auto shortest = std::make_shared<ob::PathLengthOptimizationObjective>(info);
  shortest->setCostThreshold(ob::Cost(0));
  problem->setOptimizationObjective(shortest);
  Planner planner(info);
  planner.setProblemDefinition(problem);
  planner.setup();
  const double end = cpu_ms() + milliseconds;
  const ob::PlannerTerminationCondition over([end] { return cpu_ms() >= end; });
  if (planner.solve(over) != ob::PlannerStatus::EXACT_SOLUTION) return {};
  auto path = *problem->getSolutionPath()->template as<og::PathGeometric>();
  if (simplify) og::PathSimplifier(info).simplify(path, over);
  Way way;
  for (const ob::State* state : path.getStates()) way.push_back(point_of(state));
  return way;
}

/// A* from centre to centre of voxels, in 26 directions, wherever all voxels about a step are free.
class CentreSearch {
 public:
  CentreSearch(const Airspace& airspace, const Ends& ends)
      : airspace_(airspace),
        grid_(airspace.grid()),
        ends_(ends),
        costs_(grid_.count(), 1e30F),
        came_by_(grid_.count(), kUnreached) {}

  Way run() {
    reach(ends_.from, 0, 0);
    while (!open_.empty()) {
      const auto [estimate, voxel] = open_.top();
      open_.pop();
      if (voxel == ends_.to) return way();
      const float cost = costs_[index(voxel)];
      if (estimate > cost + left(voxel) + 1e-3F) continue;
      for (int move = 0; move < 27; ++move) {
        const Voxel next = moved(voxel, move, 1);
        if (move != kStay && is_free(voxel, next))
          reach(next, cost + std::sqrt(static_cast<float>(steps(move))), move);
      }
    }
    return {};
  }

 private:
  static constexpr int kStay = 13;
  static constexpr std::uint8_t kUnreached = 255;

  static Voxel moved(Voxel voxel, int move, int sign) {
    voxel[0] += sign * (move % 3 - 1);
    voxel[1] += sign * (move / 3 % 3 - 1);
    voxel[2] += sign * (move / 9 - 1);
    return voxel;
  }
  static int steps(int move) { return (move % 3 != 1) + (move / 3 % 3 != 1) + (move / 9 != 1); }
  std::size_t index(const Voxel& voxel) const { return grid_.index(voxel[0], voxel[1], voxel[2]); }

  bool is_free(const Voxel& a, const Voxel& b) const {
    for (const std::int32_t z : {a[2], b[2]})
      for (const std::int32_t y : {a[1], b[1]})
        for (const std::int32_t x : {a[0], b[0]})
          if (!airspace_.is_free(x, y, z)) return false;
    return true;
  }

  float left(const Voxel& voxel) const {
    std::array<int, 3> apart{};
    for (std::size_t i = 0; i < 3; ++i) apart[i] = std::abs(voxel[i] - ends_.to[i]);
    std::sort(apart.begin(), apart.end());
    return static_cast<float>(apart[0] * std::sqrt(3.0) + (apart[1] - apart[0]) * std::sqrt(2.0) +
                              (apart[2] - apart[1]));
  }

  void reach(const Voxel& voxel, float cost, int move) {
    if (cost >= costs_[index(voxel)]) return;
    costs_[index(voxel)] = cost;
    came_by_[index(voxel)] = static_cast<std::uint8_t>(move);
    open_.emplace(cost + left(voxel), voxel);
  }

  Way way() const {
    Way way = {airspace_.centre(ends_.to)};
    for (Voxel voxel = ends_.to; voxel != ends_.from;) {
      voxel = moved(voxel, came_by_[index(voxel)], -1);
      way.push_back(airspace_.centre(voxel));
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  const Airspace& airspace_;
  const world::AirspaceGrid& grid_;
  Ends ends_;
  std::vector<float> costs_;
  std::vector<std::uint8_t> came_by_;
  using Entry = std::pair<float, Voxel>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

/// What a method made of the queries, one figure each.
struct Column {
  std::string name;
  std::vector<double> lengths, ms;
};

class Comparison {
 public:
  Comparison(const Airspace& airspace, double milliseconds)
      : airspace_(airspace), milliseconds_(milliseconds) {}

  void add(const Ends& ends) {
    const Vector3 from = airspace_.centre(ends.from), to = airspace_.centre(ends.to);
    at_ = 0;
    note("ours", [&] { return refiners::find_way(airspace_, from, to, refiners::Budget()).way; });
    note("BIT*", [&] { return by_ompl<og::BITstar>(airspace_, from, to, milliseconds_, false); });
    note_pulled("BIT*, pulled");
    note("Informed RRT*",
         [&] { return by_ompl<og::InformedRRTstar>(airspace_, from, to, milliseconds_, false); });
    note_pulled("Informed RRT*, pulled");
    note("RRT-Connect, simplified",
         [&] { return by_ompl<og::RRTConnect>(airspace_, from, to, milliseconds_, true); });
    note_pulled("RRT-Connect, simplified, pulled");
    note("A* 26", [&] { return CentreSearch(airspace_, ends).run(); });
    note_pulled("A* 26, pulled");
    double best = kNone;
    for (const Column& column : columns_) best = std::min(best, column.lengths.back());
    best_.push_back(best);
    print_last(ends);
  }

  void print_summary() const {
    std::printf("\n%-32s %6s %12s %12s %11s %9s\n", "", "solved", "mean / best", "worst / best",
                "median ms", "max ms");
    for (const Column& column : columns_) print(column);
    const std::vector<double>& ours = columns_[0].lengths;
    for (std::size_t c : {std::size_t{1}, std::size_t{2}}) {
      std::size_t not_longer = 0;
      for (std::size_t i = 0; i < ours.size(); ++i)
        not_longer += ours[i] <= columns_[c].lengths[i] * (1 + 1e-9) ? 1 : 0;
      std::printf("ours is no longer than %s: %zu of %zu queries (%.0f %%)\n",
                  columns_[c].name.c_str(), not_longer, ours.size(),
                  100.0 * static_cast<double>(not_longer) / static_cast<double>(ours.size()));
    }
  }

 private:
  template <class Find>
  void note(const char* name, const Find& find) {
    if (at_ == columns_.size()) columns_.push_back({name, {}, {}});
    const double start = cpu_ms();
    last_ = find();
    columns_[at_].ms.push_back(cpu_ms() - start);
    columns_[at_].lengths.push_back(last_.empty() ? kNone : refiners::length_of(last_));
    ++at_;
  }
  /// The way before, pulled; the time is that of both.
  void note_pulled(const char* name) {
    const double before = columns_[at_ - 1].ms.back();
    note(name, [&] { return last_.empty() ? Way() : refiners::pull_straight(airspace_, last_); });
    columns_[at_ - 1].ms.back() += before;
  }

  void print_last(const Ends& ends) const {
    if (best_.size() == 1) {
      std::printf("%5s %8s", "query", "straight");
      for (const Column& column : columns_) std::printf(" | %s", column.name.c_str());
      std::printf("\n");
    }
    std::printf("%5zu %8.1f", best_.size(),
                (airspace_.centre(ends.to) - airspace_.centre(ends.from)).norm());
    for (const Column& column : columns_) std::printf(" %8.2f", column.lengths.back());
    std::printf("\n");
    std::fflush(stdout);
  }

  void print(const Column& column) const {
    double sum = 0, worst = 0;
    int solved = 0;
    for (std::size_t i = 0; i < best_.size(); ++i) {
      if (column.lengths[i] == kNone) continue;
      ++solved;
      const double ratio = column.lengths[i] / best_[i];
      sum += ratio;
      worst = std::max(worst, ratio);
    }
    std::printf("%-32s %3d/%zu %12.4f %12.4f %11.1f %9.1f\n", column.name.c_str(), solved,
                best_.size(), solved ? sum / solved : kNone, worst,
                refiners::bench::median(column.ms),
                *std::max_element(column.ms.begin(), column.ms.end()));
  }

  const Airspace& airspace_;
  double milliseconds_;
  std::vector<Column> columns_;
  std::vector<double> best_;
  std::size_t at_ = 0;
  Way last_;
};

int run(double seconds) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(1);
  const Airspace airspace = refiners::bench::box_world();
  std::printf("world 256^3, %.1f %% occupied; lengths in voxels, CPU times\n",
              refiners::bench::percent_occupied(airspace));
  Comparison comparison(airspace, 1e3 * seconds);
  for (const Ends& ends : refiners::bench::long_queries(airspace)) comparison.add(ends);
  comparison.print_summary();
  return 0;
}

}  // namespace
}  // namespace skein::sampling

int main(int argc, char** argv) {
  const bool with_seconds = argc == 3 && std::strcmp(argv[1], "--seconds") == 0;
  const double seconds = with_seconds ? std::strtod(argv[2], nullptr) : 1;
  if ((argc != 1 && !with_seconds) || !(seconds > 0)) {
    std::fprintf(stderr, "usage: skein_bit_star_bench [--seconds S]\n");
    return 2;
  }
  return skein::sampling::run(seconds);
}
