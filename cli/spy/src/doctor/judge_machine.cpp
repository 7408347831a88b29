// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "../text/table.hpp"
#include "machine.hpp"

namespace skein::spy_tool {

namespace {

using Grade = Finding::Grade;

constexpr std::uint64_t kWantedBuffer = 2 * 1024 * 1024;  ///< what our transports ask for
constexpr double kStep = 0.05;                            ///< [s] of the clock that is one
constexpr std::int64_t kYear2020 = 1'577'836'800'000'000'000;

void judge_interfaces(const MachineFacts& facts, const blackboard::NetworkConfig& network,
                      Findings& findings) {
  bool only_here = true;
  for (const std::string& address : network.interfaces) {
    const auto found = std::ranges::find(facts.interfaces, address, &Interface::address);
    if (found == facts.interfaces.end()) {
      findings.push_back({Grade::kBad, "interface", "no interface has address " + address});
      continue;
    }
    only_here = only_here && found->loopback;
    const std::string name = address + " (" + found->name + ")";
    if (!found->up) {
      findings.push_back({Grade::kBad, "interface", name + " is down"});
    } else if (!found->multicast && !found->loopback && network.multicast) {
      findings.push_back(
          {Grade::kBad, "interface",
           name + " takes no multicast: name the others with --peer, or use a discovery server"});
    } else {
      findings.push_back({Grade::kGood, "interface", name + " is up"});
    }
  }
  if (only_here)
    findings.push_back({Grade::kNote, "interface",
                        "only programs of this machine are seen: --interface for others"});
}

void judge_buffers(const MachineFacts& before, const MachineFacts& after, Findings& findings) {
  if (after.receive_buffer < kWantedBuffer) {
    findings.push_back(
        {Grade::kNote, "buffers",
         "sockets get " + std::to_string(after.receive_buffer) + " bytes, not the " +
             std::to_string(kWantedBuffer) +
             " they ask for: sysctl -w net.core.rmem_max=" + std::to_string(kWantedBuffer)});
  } else {
    findings.push_back({Grade::kGood, "buffers", "sockets get the buffers they ask for"});
  }
  const std::uint64_t lost = after.overflows - std::min(before.overflows, after.overflows);
  if (lost > 0)
    findings.push_back(
        {Grade::kNote, "buffers",
         std::to_string(lost) + " UDP packets were lost meanwhile for full buffers"});
}

void judge_clock(const MachineFacts& before, const MachineFacts& after, Findings& findings) {
  const auto step =
      static_cast<double>((after.wall - before.wall) - (after.steady - before.steady)) * 1e-9;
  if (after.wall < kYear2020)
    findings.push_back({Grade::kNote, "clock",
                        "the time of day is before 2020: certificates of --security do not hold"});
  if (std::abs(step) >= kStep) {
    findings.push_back(
        {Grade::kNote, "clock", "the time of day was set by " + fixed(step, 3) + " s meanwhile"});
  } else {
    findings.push_back({Grade::kGood, "clock", "the time of day went on as it should"});
  }
}

void judge_leftovers(const Leftovers& left, Findings& findings) {
  if (left.names.empty()) {
    findings.push_back({Grade::kGood, "shared memory", "nothing is left over from dead programs"});
    return;
  }
  findings.push_back({Grade::kNote, "shared memory",
                      std::to_string(left.names.size()) + " files of dead programs (" +
                          std::to_string(left.bytes) + " bytes), " + left.names.front() +
                          " for one: fastdds shm clean"});
}

}  // namespace

Findings judge_machine(const MachineFacts& before, const MachineFacts& after,
                       const blackboard::NetworkConfig& network) {
  Findings findings;
  for (const std::string& problem : problems_of(network))
    findings.push_back({Grade::kBad, "options", problem});
  judge_interfaces(after, network, findings);
  judge_buffers(before, after, findings);
  judge_clock(before, after, findings);
  judge_leftovers(after.leftovers, findings);
  return findings;
}

}  // namespace skein::spy_tool
