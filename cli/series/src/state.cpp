// SPDX-License-Identifier: Apache-2.0
#include "state.hpp"

#include <algorithm>
#include <cmath>

namespace skein::series_tool {

namespace {

using journal::Record;

void take_triple(const Record& record, std::string_view key, std::array<double, 3>& to) {
  const std::vector<double> numbers = record.numbers(key);
  if (numbers.size() == 3) std::copy(numbers.begin(), numbers.end(), to.begin());
}

std::int64_t id_of(const Record& record, std::string_view key) {
  return static_cast<std::int64_t>(record.number(key));
}

void keep_if(bool in, std::int64_t id, std::set<std::int64_t>& set) {
  if (in) {
    set.insert(id);
  } else {
    set.erase(id);
  }
}

}  // namespace

void State::see(const Record& record) {
  const std::string& kind = record.kind();
  if (kind == "link") {
    links_[{std::string(record.text("from")), std::string(record.text("to"))}] =
        record.truth("up") ? 1 : 0;
  } else if (kind == "reach" && record.node() == "ground") {
    uavs_[std::string(record.text("peer"))].reachable = record.truth("reachable") ? 1 : 0;
  } else if (kind == "alarm") {
    keep_if(record.text("state") != "infirmed", id_of(record, "alarm"), alarms_);
  } else if (kind == "message") {
    messages_ += record.text("direction") == "sent" ? 1 : 0;
  } else if (!record.text("uav").empty()) {
    see_uav(record, uavs_[std::string(record.text("uav"))]);
  }
}

void State::see_uav(const Record& record, UavState& uav) {
  const std::string& kind = record.kind();
  const std::string_view state = record.text("state");
  if (kind == "telemetry") {
    take_triple(record, "position", uav.position);
    take_triple(record, "velocity", uav.velocity);
    uav.heading = record.number("heading", kUnknown);
    uav.energy = record.number("energy", kUnknown);
    uav.airborne = record.truth("airborne") ? 1 : 0;
  } else if (kind == "degree") {
    uav.degree = record.number("degree", kUnknown);
  } else if (kind == "plan") {
    uav.revision = record.number("revision", kUnknown);
  } else if (kind == "decision") {
    uav.decisions += 1;
  } else if (kind == "task") {
    keep_if(state == "started" || state == "running" || state == "aborting", id_of(record, "task"),
            uav.running);
  } else if (kind == "goal") {
    keep_if(state == "received" || state == "planned" || state == "under-way",
            id_of(record, "goal"), uav.open);
  }
}

const UavState& State::uav(const std::string& name) const {
  static const UavState nothing;
  const auto found = uavs_.find(name);
  return found == uavs_.end() ? nothing : found->second;
}

double State::link(const std::string& from, const std::string& to) const {
  auto found = links_.find({from, to});
  if (found == links_.end()) found = links_.find({"*", "*"});
  return found == links_.end() ? kUnknown : found->second;
}

double distance(const UavState& a, const UavState& b) {
  return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1],
                    a.position[2] - b.position[2]);
}

}  // namespace skein::series_tool
