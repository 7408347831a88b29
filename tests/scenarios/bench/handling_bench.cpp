// SPDX-License-Identifier: Apache-2.0
// How long nodes are busy with one input: processor time of each handle() of each node, over whole
// missions in virtual time. What a job does is not counted. Arguments: how many seeds (5), and
// scenarios by name (mref/nominal area-sharing/negotiated team/five).
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "skein/assembly/assembly.hpp"
#include "skein/scenario_setup/setup.hpp"
#include "testing/mission.hpp"

namespace skein::testing {
namespace {

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Handled {
  double ms;
  std::uint64_t seed;
  double at;  ///< [s of the mission]
  std::string input;
};
using ByNode = std::map<std::string, std::vector<Handled>>;

std::string what(const node::Input& input) {
  if (const auto* received = std::get_if<node::Received>(&input)) {
    return "sample of slot " + std::to_string(static_cast<int>(wire::slot_of(received->sample)));
  }
  return "input " + std::to_string(input.index());
}

/// The node, by the clock.
class Timed final : public node::Node {
 public:
  Timed(std::unique_ptr<node::Node> node, std::uint64_t seed, std::vector<Handled>& handled)
      : node_(std::move(node)), seed_(seed), handled_(handled) {}

  node::Effects handle(const node::Input& input, MissionTime now) override {
    const double begin = processor_ms();
    node::Effects effects = node_->handle(input, now);
    handled_.push_back({processor_ms() - begin, seed_, now.to_seconds(), what(input)});
    return effects;
  }
  std::optional<MissionTime> next_wakeup() const override { return node_->next_wakeup(); }

 private:
  std::unique_ptr<node::Node> node_;
  std::uint64_t seed_;
  std::vector<Handled>& handled_;
};

void measure(const std::string& name, std::uint64_t seeds) {
  ByNode all;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const scenario::Scenario scenario = scenario_at(name, with(seed));
    node::run_virtual(
        scenario_setup::roster_of(scenario),
        [&](const std::string& node) -> std::unique_ptr<node::Node> {
          return std::make_unique<Timed>(assembly::make_node(scenario, node), seed, all[node]);
        },
        assembly::virtual_config(scenario), [](const journal::Record&) {});
  }
  for (auto& [node, handled] : all) {
    std::sort(handled.begin(), handled.end(),
              [](const Handled& a, const Handled& b) { return a.ms > b.ms; });
    const Handled& worst = handled.front();
    const auto over = std::count_if(handled.begin(), handled.end(),
                                    [](const Handled& one) { return one.ms > 50; });
    std::printf("| %s | %s | %zu | %.1f | %.1f | %ld | %s at %.0f s, seed %lu |\n", name.c_str(),
                node.c_str(), handled.size(), handled[handled.size() / 1000].ms, worst.ms,
                static_cast<long>(over), worst.input.c_str(), worst.at,
                static_cast<unsigned long>(worst.seed));
  }
}

}  // namespace
}  // namespace skein::testing

int main(int argc, char** argv) {
  const std::uint64_t seeds = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 5;
  std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
  if (names.empty()) names = {"mref/nominal", "area-sharing/negotiated", "team/five"};
  std::puts("| scenario | node | inputs | 99.9 % [ms] | longest [ms] | over 50 ms | which |");
  std::puts("|---|---|---|---|---|---|---|");
  for (const std::string& name : names) skein::testing::measure(name, seeds);
}
