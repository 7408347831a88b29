// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/team_history.hpp"

#include <algorithm>

#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/team.hpp"

namespace skein::laws {

bool TeamHistory::see(const journal::Record& record) {
  namespace lines = journal::lines;
  return journal::hand_on<lines::TeamTask, lines::Owner, lines::Bid, lines::GlobalMission>(record,
                                                                                           *this);
}

void TeamHistory::hear(const journal::lines::TeamTask& line, const journal::Written& when) {
  const auto sale = static_cast<std::int64_t>(line.sale);
  std::vector<TeamWork>& works = tasks[static_cast<std::int64_t>(line.task)].works;
  if (line.state == "begun") {
    TeamWork work;
    work.uav = line.uav;
    work.sale = sale;
    work.goal = static_cast<std::int64_t>(line.goal);
    work.begun = when.at.to_seconds();
    works.push_back(std::move(work));
    return;
  }
  if (line.state == "kept") return;
  const auto open = std::find_if(works.rbegin(), works.rend(), [&](const TeamWork& work) {
    return work.uav == line.uav && work.sale == sale && work.end.empty();
  });
  if (open == works.rend()) return;
  open->over = when.at.to_seconds();
  open->end = line.state;
  open->why = line.why;
}

void TeamHistory::hear(const journal::lines::Owner& line, const journal::Written& when) {
  tasks[static_cast<std::int64_t>(line.task)].standings.push_back(
      {when.at.to_seconds(), line.stage, line.owners, static_cast<std::int64_t>(line.sale),
       line.why});
}

void TeamHistory::hear(const journal::lines::Bid& line, const journal::Written& when) {
  tasks[static_cast<std::int64_t>(line.task)].bids[static_cast<std::int64_t>(line.sale)].emplace(
      line.uav, when.at.to_seconds());
}

void TeamHistory::hear(const journal::lines::GlobalMission& line, const journal::Written& when) {
  if (line.state == "given" && line.why.empty()) given.push_back(when.at.to_seconds());
  if (line.state == "done") done.push_back(when.at.to_seconds());
}

}  // namespace skein::laws
