// SPDX-License-Identifier: Apache-2.0
// skein spy doctor: what is wrong here.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "../doctor/domain.hpp"
#include "../doctor/machine.hpp"
#include "skein/foundation/exit_code.hpp"
#include "verbs.hpp"

namespace skein::spy_tool {

namespace {

using Grade = Finding::Grade;

constexpr double kLook = 3;  ///< [s]

const char* name_of(Grade grade) {
  switch (grade) {
    case Grade::kGood:
      return "good";
    case Grade::kNote:
      return "note";
    case Grade::kBad:
      break;
  }
  return "BAD ";
}

void judge_multicast(const SpyOptions& options, const MachineFacts& machine, Findings& findings) {
  const blackboard::NetworkConfig& network = options.network;
  if (!network.multicast || !network.discovery_servers.empty()) return;
  for (const std::string& address : network.interfaces) {
    const auto on = std::ranges::find(machine.interfaces, address, &Interface::address);
    if (on == machine.interfaces.end() || on->loopback) continue;  // needs none
    const auto tried = try_multicast(address);
    findings.push_back(
        {tried ? Grade::kGood : Grade::kBad, "multicast",
         tried ? address + " hears what it sends" : address + ": " + tried.error().why});
  }
}

}  // namespace

int examine(const SpyOptions& options, Listener& listener, std::ostream& out,
            std::ostream& /*err*/) {
  const MachineFacts before = look_at_machine();
  std::set<wire::Slot> slots{wire::Slot::kDirectoryEntry, wire::Slot::kHeartbeat,
                             wire::Slot::kClock, wire::Slot::kTelemetry, wire::Slot::kTruth};
  listener.read_only(slots);
  Consultation consultation;
  listener.listen(end_of(options, kLook), [&](const Heard& heard) {
    consultation.hear(heard, listener.graph());
    return true;
  });
  const MachineFacts after = look_at_machine();
  Findings findings = judge_machine(before, after, options.network);
  judge_multicast(options, after, findings);
  for (const std::string& refused : listener.refused())
    findings.push_back({Grade::kBad, "DDS", refused});
  for (Finding& one : consultation.judge(listener.graph(), options.domain))
    findings.push_back(std::move(one));
  bool bad = false;
  for (const Finding& one : findings) {
    bad = bad || one.grade == Grade::kBad;
    const std::string grade = name_of(one.grade);
    if (options.json) {
      print_line({{"grade", one.grade == Grade::kBad ? "bad" : grade},
                  {"check", one.check},
                  {"text", one.text}},
                 out);
    } else {
      out << grade << "  " << one.check << ": " << one.text << '\n';
    }
  }
  return bad ? kExitNegative : kExitOk;
}

}  // namespace skein::spy_tool
