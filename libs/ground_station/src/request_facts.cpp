// SPDX-License-Identifier: Apache-2.0
// One overload per kind of request.
#include "request_facts.hpp"

namespace skein::ground_station {
namespace {

using executive::TaskId;

std::string describe(const executive::Start& start) {
  return "START " + skein::to_text(start.task.id) + " " + start.task.type;
}
std::string describe(const executive::Abort& abort) { return "ABORT " + skein::to_text(abort.id); }
std::string describe(const executive::ProcessMessage& process) {
  return "PROCESS-MSG " + process.message;
}
std::string describe(const executive::UpdateConditions& update) {
  return "UPDATE-COND " + skein::to_text(update.id);
}
std::string describe(const executive::Suppress& suppress) {
  return "SUPPRESS " + skein::to_text(suppress.id);
}

std::optional<TaskId> named(const executive::Start&) { return std::nullopt; }
std::optional<TaskId> named(const executive::Abort& abort) { return abort.id; }
std::optional<TaskId> named(const executive::ProcessMessage&) { return std::nullopt; }
std::optional<TaskId> named(const executive::UpdateConditions& update) { return update.id; }
std::optional<TaskId> named(const executive::Suppress& suppress) { return suppress.id; }

}  // namespace

std::string what_of(const Request& request) {
  return std::visit([](const auto& it) { return describe(it); }, request);
}

std::optional<TaskId> started_by(const Request& request) {
  const auto* start = std::get_if<executive::Start>(&request);
  return start == nullptr ? std::nullopt : std::optional(start->task.id);
}

std::optional<TaskId> named_by(const Request& request) {
  return std::visit([](const auto& it) { return named(it); }, request);
}

}  // namespace skein::ground_station
