// SPDX-License-Identifier: Apache-2.0
// Patrol against the lawn mower and the thesis's gradient, by the same vehicle on the same maps.
// Figures are those of a naive simulation of the ways, after a warm-up of a quarter of the time.
// "ratio": against the lawn mower; goals are 0.6 for worst risk × idleness and 0.92 for the mean on
// peaked maps, 1.5 lower bounds for the worst idleness on uniform ones.
//
//   skein_refiners_patrol_bench [--all]           generated maps
//   skein_refiners_patrol_bench --risk [F] FILE.asc…
//                     maps of risk from files (ESRI ASCII, 0 to 1), with a footprint of F cells or
//                     of 1, 2 and 3, beside the least means that flights along lanes can have
//   skein_refiners_patrol_bench --bounds [F] FILE.asc…
//                     those alone, without a patrol
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "../test/testing/builders.hpp"
#include "../test/testing/patrol_oracle.hpp"
#include "../test/testing/turning_bound.hpp"
#include "patrol/walk_graph.hpp"

namespace {

using namespace skein;
using namespace skein::refiners;
using namespace skein::refiners::testing;

struct Case {
  std::size_t side;
  double cell, footprint, speed;
  int peaks;
  std::uint64_t seed;
  double duration;                 ///< in cell lengths flown
  world::GroundState ground = {};  ///< of a file; empty: peaked_ground
};

struct Row {
  NaiveFigures figures;
  double seconds = 0;
};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

world::World world_of(const Case& c) {
  world::World world = level_world(2 * c.cell * static_cast<double>(c.side), 200);
  world.ground = c.ground.risk.empty() ? peaked_ground(c.side, c.cell, c.peaks, c.seed) : c.ground;
  return world;
}

PatrolQuery query_of(const Case& c) {
  PatrolQuery query;
  query.vehicle = helicopter();
  query.vehicle.max_speed = 100;
  query.vehicle.energy.capacity = 1e12;
  const double extent = c.cell * static_cast<double>(c.side);
  query.zone = {{0, 0}, {extent, 0}, {extent, extent}, {0, extent}};
  query.start = {0.5 * c.cell, 0.5 * c.cell, 50};
  query.altitude = 50;
  query.footprint = c.footprint;
  query.speed = c.speed;
  query.duration = Duration::seconds(c.duration * c.cell / c.speed);
  return query;
}

NaiveFigures simulate(const Case& c, const world::World& world, const PatrolQuery& query,
                      const Way& way) {
  const double seconds = query.duration.to_seconds();
  const NaiveFlight flight{.speed = c.speed,
                           .footprint = c.footprint,
                           .from = seconds / 4,
                           .step = 0.5 * c.cell / c.speed,
                           .least_risk = query.least_risk};
  return NaivePatrol(world.ground, cells_in(world.ground.grid, query.zone), flight).fly(way);
}

Row planned(const Case& c, const world::World& world, PatrolQuery query, PatrolMode mode) {
  query.mode = mode;
  const double before = now();
  const auto refined = refine(query, Setting{.world = world, .budget = {}});
  const double took = now() - before;
  if (!refined) {
    std::printf("refused: %s %s\n", refined.error().field.c_str(), refined.error().why.c_str());
    std::exit(1);
  }
  return {simulate(c, world, query, refined->task.way), took};
}

void print(const char* method, const Row& row, const NaiveFigures& mower, double bound) {
  std::printf(
      "    %-12s worst %7.0f (%5.2f LB)  max r*idle %6.0f (ratio %.2f)  mean %6.0f "
      "(ratio %.2f)  unseen %zu",
      method, row.figures.worst, row.figures.worst / bound, row.figures.worst_risk,
      row.figures.worst_risk / mower.worst_risk, row.figures.mean, row.figures.mean / mower.mean,
      row.figures.unseen);
  if (row.seconds > 0) std::printf("  planned in %.2f s", row.seconds);
  std::printf("\n");
}

/// Cells in view at once at most: centres in a disc around any point, tried a twentieth of a cell
/// apart.
std::size_t most_in_view(double footprint) {
  std::size_t most = 0;
  const auto reach = static_cast<int>(footprint) + 2;
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y) {
      std::size_t seen = 0;
      for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
          seen += std::hypot(i - x / 20.0, j - y / 20.0) <= footprint + 1e-9 ? 1 : 0;
      most = std::max(most, seen);
    }
  return most;
}

/// What the mean idleness by risk is not below in a flight of which each second brings at most
/// `rate` cells into view, with a footprint of so many cells. Proof:
/// docs/decisions/0008-refiners.md.
double least_mean(const world::GroundState& ground, double least_risk, double footprint,
                  double rate) {
  double roots = 0, sum = 0;
  for (const double risk : ground.risk) {
    roots += std::sqrt(std::max(risk, least_risk));
    sum += std::max(risk, least_risk);
  }
  roots -= static_cast<double>(most_in_view(footprint));
  return roots * roots / (2 * rate * sum);
}

/// What walks over a lattice cannot be below, as flown, in parts of a lawn mower's figures. Bounds
/// count from visit to visit, and flown no cell waits while it is in view, on a straight pass for
/// two footprints.
/// Of the bound with turns.
constexpr int kRounds = 3000;
struct LeastOfWalks {
  double mean = 0, worst = 0;
  double mean_turning = 0;       ///< with the turns that visits need
  double mean_turning_most = 0;  ///< what a bound of that kind cannot be above
  double mean_of_good =
      0;  ///< of those that meet the goal of the worst, 0.6; infinite: there are none
};
LeastOfWalks least_of_walks(const world::World& world, const PatrolQuery& query,
                            const NaiveFigures& mower) {
  Deadline deadline(Budget{});
  const PatrolSpace space(query.zone, {});
  const PatrolSight sight(world.terrain, world.ground.grid, query.altitude, query.footprint,
                          deadline);
  const PatrolField field =
      make_patrol_field(space, sight, query.zone, world.ground.risk, query.least_risk);
  const auto graph = make_walk_graph(field, space, sight);
  if (!graph) return {};
  const double in_view = 2 * query.footprint;
  const double top = *std::max_element(field.risk.begin(), field.risk.end());
  const double mean = mower.mean * query.speed, worst = mower.worst_risk * query.speed;
  const TurningBound turning = least_mean_with_turns(*graph, kRounds);
  return {(least_mean_of_walks(*graph) - in_view) / mean,
          (least_worst_of_walks(*graph) - top * in_view) / worst, (turning.proved - in_view) / mean,
          (turning.most - in_view) / mean,
          (least_mean_of_walks(*graph, 0.6 * worst + top * in_view) - in_view) / mean};
}

void print_least(const world::World& world, const PatrolQuery& query, const NaiveFigures& mower) {
  const LeastOfWalks least = least_of_walks(world, query, mower);
  std::printf("    walks not below mean ratio %.3f, with worst of 0.6 %.3f, worst ratio %.3f\n",
              least.mean, least.mean_of_good, least.worst);
}

/// What walks cannot be below, without planning any.
void print_bounds(const Case& c) {
  const world::World world = world_of(c);
  const PatrolQuery query = query_of(c);
  const double extent = c.cell * static_cast<double>(c.side);
  std::printf("%zux%zu cells, footprint %g cells, %d peaks, seed %d\n", c.side, c.side,
              c.footprint / c.cell, c.peaks, static_cast<int>(c.seed));
  print_least(world, query,
              simulate(c, world, query,
                       lawn_mower(extent, extent, c.footprint, c.cell, c.duration * c.cell)));
}

/// True when the goals are met.
bool run(const Case& c, bool with_gradient) {
  const world::World world = world_of(c);
  const PatrolQuery query = query_of(c);
  const double extent = c.cell * static_cast<double>(c.side);
  const double bound = extent * extent / (2 * c.footprint * c.speed);
  const Row mower{simulate(c, world, query,
                           lawn_mower(extent, extent, c.footprint, c.cell, c.duration * c.cell))};
  const Row committed = planned(c, world, query, PatrolMode::kCommitted);
  const bool good =
      committed.figures.unseen == 0 &&
      (c.peaks == 0 ? committed.figures.worst <= 1.5 * bound
                    : committed.figures.worst_risk <= 0.6 * mower.figures.worst_risk &&
                          committed.figures.mean <= 0.92 * mower.figures.mean);
  std::printf("%zux%zu cells of %g m, footprint %g m, %g m/s, %d peaks, seed %d: %s\n", c.side,
              c.side, c.cell, c.footprint, c.speed, c.peaks, static_cast<int>(c.seed),
              good ? "goals met" : "GOALS MISSED");
  print("lawn mower", mower, mower.figures, bound);
  print("committed", committed, mower.figures, bound);
  if (c.peaks > 0)
    std::printf("    lanes between rows not below mean ratio %.2f\n",
                least_mean(world.ground, query.least_risk, c.footprint / c.cell,
                           2 * c.footprint * c.speed / (c.cell * c.cell)) /
                    mower.figures.mean);
  if (c.peaks > 0) print_least(world, query, mower.figures);
  if (with_gradient)
    print("gradient", planned(c, world, query, PatrolMode::kGradient), mower.figures, bound);
  std::fflush(stdout);
  return good;
}

world::GroundState read_risk(const char* file) {
  std::ifstream in(file);
  std::string word;
  double columns = 0, rows = 0, skipped = 0;
  in >> word >> columns >> word >> rows >> word >> skipped >> word >> skipped >> word >> skipped;
  in >> word >> skipped;
  world::GroundState ground;
  ground.grid = {.west = 0,
                 .south = 0,
                 .cell = 1,
                 .columns = static_cast<std::size_t>(columns),
                 .rows = static_cast<std::size_t>(rows)};
  ground.risk.resize(ground.grid.size());
  for (std::size_t row = ground.grid.rows; row-- > 0;)
    for (std::size_t column = 0; column < ground.grid.columns; ++column)
      in >> ground.risk[ground.grid.index(column, row)];
  if (!in || ground.grid.columns != ground.grid.rows) {
    std::fprintf(stderr, "%s: not a square raster\n", file);
    std::exit(2);
  }
  return ground;
}

/// Ratios to the lawn mower, and the least that flights can have of which a metre brings 2 σ cells
/// into view, as that of every lane between rows, or 2 σ + 1, as that of one along the middle of a
/// row, which just touches the outermost.
void run_file(const char* file, const world::GroundState& ground, double footprint,
              bool bounds_alone) {
  const Case c{.side = ground.grid.columns,
               .cell = 1,
               .footprint = footprint,
               .speed = 1,
               .peaks = 1,
               .seed = 0,
               .duration = 80000 / footprint,
               .ground = ground};
  const world::World world = world_of(c);
  const PatrolQuery query = query_of(c);
  const auto extent = static_cast<double>(c.side);
  const NaiveFigures mower =
      simulate(c, world, query, lawn_mower(extent, extent, footprint, 1, c.duration));
  const Row ours = bounds_alone ? Row{} : planned(c, world, query, PatrolMode::kCommitted);
  const auto ratio = [&](double rate) {
    return least_mean(ground, query.least_risk, footprint, rate) / mower.mean;
  };
  const LeastOfWalks walks = least_of_walks(world, query, mower);
  std::printf(
      "%s, footprint %g: mean %.3f (lanes between rows not below %.3f, any lane %.3f, walks %.3f, "
      "with their turns %.4f to %.4f, with worst of 0.6 %.3f)  max r*idle %.3f (walks %.3f)  "
      "unseen %zu  %.2f s\n",
      file, footprint, ours.figures.mean / mower.mean, ratio(2 * footprint),
      ratio(2 * footprint + 1), walks.mean, walks.mean_turning, walks.mean_turning_most,
      walks.mean_of_good, ours.figures.worst_risk / mower.worst_risk, walks.worst,
      ours.figures.unseen, ours.seconds);
  std::fflush(stdout);
}

int run_files(int count, char** files, bool bounds_alone) {
  char* end = nullptr;
  const double asked = std::strtod(files[0], &end);
  const bool is_asked = *end == '\0';
  for (int i = is_asked ? 1 : 0; i < count; ++i)
    for (const double footprint : {1.0, 2.0, 3.0})
      if (!is_asked || footprint == asked)
        run_file(files[i], read_risk(files[i]), footprint, bounds_alone);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::strcmp(argv[1], "--risk") == 0) return run_files(argc - 2, argv + 2, false);
  if (argc > 2 && std::strcmp(argv[1], "--bounds") == 0) return run_files(argc - 2, argv + 2, true);
  const bool full = argc > 1 && std::strcmp(argv[1], "--all") == 0;
  std::vector<Case> cases = {{64, 1, 2, 1, 0, 1, 40000}};
  for (const int peaks : {1, 2, 3, 4, 6})
    for (std::uint64_t seed = 1; seed <= (full ? 6U : 2U); ++seed)
      cases.push_back({64, 1, 2, 1, peaks, seed, 40000});
  for (const int peaks : {0, 2, 3}) {
    cases.push_back({48, 10, 30, 12, peaks, 11, 30000});
    cases.push_back({64, 20, 30, 8, peaks, 12, 40000});
    cases.push_back({96, 1, 3.3, 2, peaks, 13, 60000});
    cases.push_back({40, 5, 5, 5, peaks, 14, 30000});
  }
  if (argc == 2 && std::strcmp(argv[1], "--bounds") == 0) {
    for (const Case& c : cases)
      if (c.peaks > 0) print_bounds(c);
    return 0;
  }
  std::size_t met = 0, done = 0;
  for (const Case& c : cases) {
    met += run(c, done < 2) ? 1 : 0;
    ++done;
  }
  std::printf("%zu of %zu cases meet the goals\n", met, cases.size());
  return met == cases.size() ? 0 : 1;
}
