// SPDX-License-Identifier: Apache-2.0
// The facet-graph search and what follows it against a plain A* on the same graph, in one run.
//
//   skein_refiners_path_bench                 both, and the ratios
//   skein_refiners_path_bench --only ours     without the plain one: what memory ours takes
//   skein_refiners_path_bench --only seeds    ours in ten worlds, by their seeds
//   skein_refiners_path_bench --seed N        ours in one of them, each query
//
// World and queries: box_world.hpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <queue>
#include <string>
#include <unordered_map>
#include <vector>

#include "box_world.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {
namespace {

using bench::cpu_ms;
using bench::Ends;
using bench::median;
using bench::total;
using world::Airspace;
using world::Vector3;
using world::Voxel;

double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  return 0;
}

/// The baseline: nodes in a hash map, a binary heap that keeps outdated entries, straight distance
/// as heuristic, ten neighbours a node, floating-point costs.
class PlainSearch {
 public:
  PlainSearch(const Airspace& airspace, const Ends& ends) : airspace_(airspace), ends_(ends) {}

  double run() {
    for (int facet = 0; facet < 6; ++facet) improve(node_of(ends_.from, facet), 0.5);
    while (!open_.empty()) {
      const auto [estimate, node] = open_.top();
      open_.pop();
      if (node == kGoal) return estimate;
      Record& record = records_[node];
      if (record.closed) continue;
      record.closed = true;
      const double cost = record.cost;
      expand(node, cost);
    }
    return -1;
  }

 private:
  using Node = std::uint64_t;
  static constexpr Node kGoal = ~Node{0};
  struct Record {
    double cost = 1e300;
    bool closed = false;
  };

  /// The lower facet of a voxel along an axis.
  static Node node_of(Voxel voxel, int facet) {
    voxel[static_cast<std::size_t>(facet / 2)] += facet % 2;
    return ((static_cast<Node>(voxel[2]) * 512 + static_cast<Node>(voxel[1])) * 512 +
            static_cast<Node>(voxel[0])) *
               3 +
           static_cast<Node>(facet / 2);
  }
  static Voxel voxel_of(Node node) {
    const Node at = node / 3;
    return {static_cast<std::int32_t>(at % 512), static_cast<std::int32_t>(at / 512 % 512),
            static_cast<std::int32_t>(at / 512 / 512)};
  }

  void expand(Node node, double cost) {
    const int axis = static_cast<int>(node % 3);
    Voxel voxel = voxel_of(node);
    for (int side = 0; side < 2; ++side) {
      if (airspace_.is_free(voxel)) {
        const int own = 2 * axis + side;
        if (voxel == ends_.to) open_.emplace(cost + 0.5, kGoal);
        for (int facet = 0; facet < 6; ++facet)
          if (facet != own)
            improve(node_of(voxel, facet), cost + (facet / 2 == axis ? 1 : std::sqrt(0.5)));
      }
      --voxel[static_cast<std::size_t>(axis)];
    }
  }

  void improve(Node node, double cost) {
    Record& record = records_[node];
    if (cost >= record.cost) return;
    record.cost = cost;
    Vector3 at = airspace_.centre(voxel_of(node));
    at[static_cast<Eigen::Index>(node % 3)] -= 0.5;
    open_.emplace(cost + (at - airspace_.centre(ends_.to)).norm(), node);
  }

  const Airspace& airspace_;
  Ends ends_;
  std::unordered_map<Node, Record> records_;
  using Entry = std::pair<double, Node>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

void print(const char* name, const std::vector<double>& ms) {
  std::printf("%-30s median %9.1f ms   max %9.1f ms   total %9.1f ms CPU\n", name, median(ms),
              *std::max_element(ms.begin(), ms.end()), total(ms));
}

struct Figures {
  std::vector<double> search, whole, plain;  // CPU ms
  std::vector<double> expansions, costs;
  std::vector<double> both;               // nodes expanded by both searches
  double raw = 0, pulled = 0, found = 0;  // lengths
  double worst_difference = 0;            // of costs, relative
};

void measure_ours(const Airspace& airspace, const Ends& ends, Figures& figures) {
  const double start = cpu_ms();
  const GraphWay graph = search_graph(airspace, ends.from, ends.to, Budget());
  const double searched = cpu_ms();
  const VoxelWay way =
      find_way(airspace, airspace.centre(ends.from), airspace.centre(ends.to), Budget());
  const double done = cpu_ms();
  figures.search.push_back(searched - start);
  figures.whole.push_back(done - searched);
  figures.expansions.push_back(static_cast<double>(graph.expanded));
  figures.both.push_back(static_cast<double>(way.effort.steps));
  figures.costs.push_back(graph.cost);
  figures.raw += graph.cost;
  figures.pulled += length_of(way.graph_way);
  figures.found += length_of(way.way);
}

/// After all of ours: freeing its millions of nodes leaves work to the next allocation.
void measure_plain(const Airspace& airspace, const Ends& ends, Figures& figures) {
  const double expected = figures.costs[figures.plain.size()];
  const double before = cpu_ms();
  const double cost = PlainSearch(airspace, ends).run();
  figures.plain.push_back(cpu_ms() - before);
  figures.worst_difference = std::max(figures.worst_difference, std::abs(cost - expected) / cost);
}

int run(bool with_plain) {
  const Airspace airspace = bench::box_world();
  std::printf("world 256^3, %.1f %% occupied\n", bench::percent_occupied(airspace));
  Figures figures;
  const std::vector<Ends> queries = bench::long_queries(airspace);
  for (const Ends& ends : queries) measure_ours(airspace, ends, figures);
  if (with_plain)
    for (const Ends& ends : queries) measure_plain(airspace, ends, figures);
  std::printf("nodes expanded on the graph: median %.0f\n", median(figures.expansions));
  print("graph search", figures.search);
  print("all: graph, any angle, pulling", figures.whole);
  std::printf("lengths: graph %.1f, pulled %.1f, found %.1f voxels\n", figures.raw, figures.pulled,
              figures.found);
  if (with_plain) {
    print("plain A*", figures.plain);
    std::printf("plain A* / graph search: median %.1f, total %.1f\n",
                median(figures.plain) / median(figures.search),
                total(figures.plain) / total(figures.search));
    std::printf("plain A* / all of ours:  median %.1f, total %.1f\n",
                median(figures.plain) / median(figures.whole),
                total(figures.plain) / total(figures.whole));
    std::printf("greatest relative difference of costs %.1e\n", figures.worst_difference);
  } else {
    std::printf("peak memory of the process %.0f MB\n", peak_megabytes());
  }
  return 0;
}

/// Each query of one world.
int run_seed(std::uint64_t seed) {
  const Airspace airspace = bench::box_world(seed);
  Figures figures;
  for (const Ends& ends : bench::long_queries(airspace)) {
    measure_ours(airspace, ends, figures);
    std::printf("graph %8.1f ms, %9.0f nodes; all %8.1f ms, %9.0f nodes\n", figures.search.back(),
                figures.expansions.back(), figures.whole.back(), figures.both.back());
  }
  std::printf("lengths: graph %.1f, pulled %.1f, found %.1f voxels\n", figures.raw, figures.pulled,
              figures.found);
  print(("seed " + std::to_string(seed)).c_str(), figures.whole);
  return 0;
}

/// One world may be kind: ours in ten of them.
int run_seeds() {
  std::vector<double> medians, all;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Airspace airspace = bench::box_world(seed);
    Figures figures;
    for (const Ends& ends : bench::long_queries(airspace)) measure_ours(airspace, ends, figures);
    print(("seed " + std::to_string(seed)).c_str(), figures.whole);
    std::fflush(stdout);
    medians.push_back(median(figures.whole));
    all.insert(all.end(), figures.whole.begin(), figures.whole.end());
  }
  print("all seeds", all);
  std::printf("greatest median %.1f ms\n", *std::max_element(medians.begin(), medians.end()));
  return 0;
}

}  // namespace
}  // namespace skein::refiners

int main(int argc, char** argv) {
  const auto only = [&](const char* what) {
    return argc == 3 && std::strcmp(argv[1], "--only") == 0 && std::strcmp(argv[2], what) == 0;
  };
  const bool only_ours = only("ours");
  if (argc == 3 && std::strcmp(argv[1], "--seed") == 0)
    return skein::refiners::run_seed(std::strtoull(argv[2], nullptr, 10));
  if (only("seeds")) return skein::refiners::run_seeds();
  if (argc != 1 && !only_ours) {
    std::fprintf(stderr, "usage: skein_refiners_path_bench [--only ours|seeds] [--seed N]\n");
    return 2;
  }
  return skein::refiners::run(!only_ours);
}
