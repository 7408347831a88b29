// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/team_history.hpp"

#include <algorithm>

namespace skein::laws {

namespace {

std::string text(const journal::Record& record, const char* key) {
  return std::string(record.text(key));
}

void see_work(const journal::Record& record, TeamTask& task) {
  const double at = record.at().to_seconds();
  const auto sale = static_cast<std::int64_t>(record.number("sale"));
  const std::string uav = text(record, "uav"), state = text(record, "state");
  if (state == "begun") {
    TeamWork work;
    work.uav = uav;
    work.sale = sale;
    work.begun = at;
    task.works.push_back(work);
    return;
  }
  if (state == "kept") return;
  for (auto work = task.works.rbegin(); work != task.works.rend(); ++work) {
    if (work->uav != uav || work->sale != sale || !work->end.empty()) continue;
    work->over = at;
    work->end = state;
    work->why = text(record, "why");
    return;
  }
}

}  // namespace

void TeamHistory::see(const journal::Record& record) {
  const double at = record.at().to_seconds();
  const auto number = static_cast<std::int64_t>(record.number("task"));
  if (record.kind() == "team-task") {
    see_work(record, tasks[number]);
  } else if (record.kind() == "owner") {
    tasks[number].standings.push_back({at, text(record, "stage"), text(record, "owners"),
                                       static_cast<std::int64_t>(record.number("sale")),
                                       text(record, "why")});
  } else if (record.kind() == "global-mission") {
    if (record.text("state") == "given" && record.text("why").empty()) given.push_back(at);
    if (record.text("state") == "done") done.push_back(at);
  }
}

}  // namespace skein::laws
