// SPDX-License-Identifier: Apache-2.0
// Messages and mission time from the first beginning to the last agreement, of role allocations
// among 2, 4 and 8 UAVs at several losses: links of 50 to 150 ms, offers that take a second to
// evaluate, sessions of 20 s, all invited by one. A table, in virtual time: the same on every
// machine.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "skein/foundation/random.hpp"
#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using Kind = NegotiationOutcome::Kind;

struct Row {
  std::vector<double> seconds, messages;  ///< of those that agreed
  int agreed = 0, failed = 0, undecided = 0;
};

void play(std::size_t members, double loss, std::uint64_t seed, Row& row) {
  Random random(seed);
  testing::Team team(members,
                     [&](std::size_t, std::size_t, MissionTime) -> std::optional<Duration> {
                       if (random.chance(loss)) return std::nullopt;
                       return Duration::seconds(random.uniform(0.05, 0.15));
                     });
  const BeginNegotiation begin = testing::begin_roles(members, Duration::seconds(20));
  for (std::size_t i = 0; i < members; ++i) team.begin_when_invited(i, begin);
  team.set_job_time(Duration::seconds(1));
  team.begin(random.below(members), begin);
  team.run_until(MissionTime::seconds(21));
  std::size_t agreed = 0, undecided = 0;
  for (const auto& [member, end] : team.ends()) {
    agreed += end.kind == Kind::kAgreed ? 1 : 0;
    undecided += end.kind == Kind::kUndecided ? 1 : 0;
  }
  row.agreed += agreed == members ? 1 : 0;
  row.undecided += undecided > 0 ? 1 : 0;
  row.failed += agreed == 0 && undecided == 0 ? 1 : 0;
  if (agreed < members) return;
  row.seconds.push_back(team.last_end()->to_seconds());
  row.messages.push_back(static_cast<double>(team.sent()));
}

double part(std::vector<double> all, std::size_t percent) {
  std::sort(all.begin(), all.end());
  return all.empty() ? 0 : all[(all.size() - 1) * percent / 100];
}

void print_table(std::uint64_t sessions) {
  std::puts(
      "| UAVs | loss | messages, median (95 %) | seconds, median (95 %) | agreed | failed | "
      "undecided |");
  std::puts("|---|---|---|---|---|---|---|");
  for (const std::size_t members : {2U, 4U, 8U}) {
    for (const double loss : {0.0, 0.1, 0.3}) {
      Row row;
      for (std::uint64_t seed = 1; seed <= sessions; ++seed) play(members, loss, seed, row);
      std::printf("| %zu | %.0f %% | %.0f (%.0f) | %.2f (%.2f) | %d | %d | %d |\n", members,
                  100 * loss, part(row.messages, 50), part(row.messages, 95), part(row.seconds, 50),
                  part(row.seconds, 95), row.agreed, row.failed, row.undecided);
    }
  }
}

}  // namespace
}  // namespace skein::interaction

int main() {
  skein::interaction::print_table(1000);
  return 0;
}
