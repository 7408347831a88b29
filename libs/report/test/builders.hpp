// SPDX-License-Identifier: Apache-2.0
// Short ways to write records, and what the tests ask of documents.
#pragma once

#include <sstream>
#include <string>
#include <string_view>

#include "skein/report/journal.hpp"
#include "story/chronology.hpp"

namespace skein::report::testing {

inline Stamp stamp(double at, std::string node = "n") {
  Stamp s;
  s.at = MissionTime::seconds(at);
  s.node = std::move(node);
  return s;
}

inline TaskRecord task(double at, std::string uav, std::uint64_t id, TaskState state,
                       std::string reason = {}) {
  return {stamp(at, uav), uav, id, "goto", state, std::move(reason)};
}

inline TelemetryRecord telemetry(double at, std::string uav, Position p, bool airborne = true,
                                 double energy = 1.0) {
  return {stamp(at, "sim"), std::move(uav), p, {3, 4, 0}, 0.0, energy, airborne};
}

inline MessageRecord message(double at, std::string from, std::string to, std::uint64_t sequence,
                             Direction direction, std::string slot = "Alarm") {
  const std::string node = direction == Direction::kSent ? from : to;
  return {stamp(at, node), std::move(slot), std::move(from), std::move(to), sequence, direction};
}

inline ExpectationRecord expectation(std::string name, bool passed, std::string seen) {
  return {stamp(9, "runner"), std::move(name), passed, std::move(seen)};
}

inline SalvagedJournal salvage(const std::string& text) {
  std::istringstream in(text);
  return salvage_journal(in, "e.jsonl");
}

inline std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t i = text.find(part); i != std::string_view::npos; i = text.find(part, i + 1)) {
    ++found;
  }
  return found;
}

}  // namespace skein::report::testing
