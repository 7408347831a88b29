// SPDX-License-Identifier: Apache-2.0
// The boards of the ground station as tables, or as JSON.
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "cells.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/joined.hpp"
#include "station.hpp"

namespace skein::operate_tool {

namespace {

using Json = nlohmann::ordered_json;
using wire::TaskState;

constexpr double kWatchPeriod = 1;  // [s]
constexpr double kNanosecond = 1e-9;

bool is_over(TaskState state) { return state == TaskState::kEnded || state == TaskState::kAborted; }

std::string current_task(const wire::UavTasks& tasks) {
  std::string scheduled;
  for (const wire::BoardTask& task : tasks.tasks) {
    if (task.lost || is_over(task.state)) continue;
    const std::string text = std::to_string(task.id) + " " + task.type;
    if (task.state != TaskState::kScheduled) return text;
    if (scheduled.empty()) scheduled = "(" + text + ")";
  }
  return scheduled.empty() ? "-" : scheduled;
}

std::string plan_text(const wire::UavTasks& tasks) {
  if (tasks.revision == 0) return "-";
  return "revision " + std::to_string(tasks.revision) + ", " + std::to_string(tasks.plan.size()) +
         (tasks.plan.size() == 1 ? " task" : " tasks");
}

std::string contact(const wire::UavBoard& board, MissionTime now) {
  if (board.located_at == wire::kNoInstant) return board.reachable ? "yes" : "never";
  std::ostringstream text;
  const double age = (now - MissionTime::nanoseconds(board.located_at)).to_seconds();
  text << (board.reachable ? "" : "LOST ") << std::fixed << std::setprecision(1)
       << std::max(0.0, age) << " s";
  return text.str();
}

std::string hand_text(const wire::UavBoard& board) {
  if (board.holder.empty()) return "-";
  return board.asker.empty() ? board.holder : board.holder + " < " + board.asker;
}

void print_uavs(const Boards& boards, MissionTime now, std::ostream& out) {
  out << "UAV         DEGREE  HAND              CONTACT       ENERGY  WAITING  HELD  TASK          "
         "  "
         "      PLAN\n";
  for (const std::string& name : boards.ground->uavs) {
    const wire::UavBoard& uav = boards.uavs.at(name);
    const wire::UavTasks& tasks = boards.tasks.at(name);
    std::ostringstream energy;
    energy << std::fixed << std::setprecision(0) << uav.energy * 100 << " %";
    out << cell(12, name) << cell(8, std::to_string(uav.degree)) << cell(18, hand_text(uav))
        << cell(14, contact(uav, now)) << cell(8, energy.str())
        << cell(9, std::to_string(uav.waiting)) << cell(6, std::to_string(uav.held))
        << cell(22, current_task(tasks)) << plan_text(tasks) << '\n';
  }
}

void print_goals(const Boards& boards, std::ostream& out) {
  bool any = false;
  for (const std::string& name : boards.ground->uavs) {
    for (const wire::GoalEntry& goal : boards.tasks.at(name).goals) {
      if (!any) out << "\nGOALS\n";
      any = true;
      out << "  " << cell(12, name) << cell(8, std::to_string(goal.id))
          << cell(14, name_of(goal.state)) << goal.statement
          << (goal.why.empty() ? "" : ": " + goal.why) << '\n';
    }
  }
}

std::string names_of(const std::vector<std::string>& names) {
  return names.empty() ? "-" : joined(names, ", ");
}

void print_team(const wire::GroundBoard& ground, std::ostream& out) {
  if (ground.team.empty()) return;
  out << "\nTASKS OF THE TEAM\n";
  for (const wire::BoardTeamTask& task : ground.team) {
    out << "  " << cell(8, std::to_string(task.id)) << cell(10, task.stage)
        << cell(20, names_of(task.owners)) << task.statement
        << (task.why.empty() ? "" : ": " + task.why) << '\n';
  }
}

void print_world(const wire::GroundBoard& ground, std::ostream& out) {
  if (!ground.alarms.empty()) out << "\nALARMS\n";
  for (const wire::BoardAlarm& alarm : ground.alarms) {
    out << "  " << cell(6, std::to_string(alarm.id)) << cell(12, name_of(alarm.state)) << "belief "
        << std::fixed << std::setprecision(2) << alarm.belief << " at " << std::setprecision(0)
        << alarm.position.x << ' ' << alarm.position.y << '\n';
  }
  if (!ground.air.empty()) out << "\nCLOSED AIR\n";
  for (const wire::BoardAir& air : ground.air) out << "  " << air.name << '\n';
  if (!ground.answers.empty()) out << "\nTHE SCRIPT WAITS FOR\n";
  for (const std::string& answer : ground.answers) out << "  " << answer << '\n';
}

void print_commands(const wire::GroundBoard& ground, std::ostream& out) {
  bool any = false;
  for (const wire::CommandEntry& one : ground.commands) {
    if (wire::is_settled(one.state)) continue;
    if (!any) out << "\nCOMMANDS UNDER WAY\n";
    any = true;
    out << "  " << cell(6, std::to_string(one.command)) << cell(12, one.uav) << cell(30, one.what)
        << cell(14, name_of(one.state)) << one.asked_by << '\n';
  }
}

std::string node_name(const Boards& boards, std::uint32_t number) {
  for (const auto& [name, board] : boards.uavs) {
    if (board.header.instance == number) return name;
  }
  return number == 1 ? "ground" : "node " + std::to_string(number);
}

void print_links(const Boards& boards, std::ostream& out) {
  bool any = false;
  for (const auto& [instance, link] : boards.links) {
    if (link.up) continue;
    if (!any) out << "\nLINKS DOWN\n";
    any = true;
    out << "  " << node_name(boards, link.from) << " > " << node_name(boards, link.to) << '\n';
  }
}

void print_tables(Station& station, std::ostream& out) {
  const Boards& boards = station.boards();
  const MissionTime now = station.mission_time();
  out << to_clock_text(now) << "  " << (boards.ground->phase.empty() ? "-" : boards.ground->phase)
      << (boards.ground->finished ? "  finished" : "") << "\n\n";
  print_uavs(boards, now, out);
  print_goals(boards, out);
  print_team(*boards.ground, out);
  print_world(*boards.ground, out);
  print_commands(*boards.ground, out);
  print_links(boards, out);
}

// An instant that is absent, or never comes, is null.
void put_nulls(Json& json) {
  if (json.is_structured()) {
    for (Json& element : json) put_nulls(element);
  } else if (json == wire::kNoInstant || json == wire::kNever) {
    json = nullptr;
  }
}

Json as_json(const wire::Sample& sample) {
  Json json = Json::parse(wire::to_json(sample));
  json.erase("slot");
  json.erase("header");
  put_nulls(json);
  return json;
}

Json document(Station& station) {
  const Boards& boards = station.boards();
  Json uavs = Json::array();
  for (const std::string& name : boards.ground->uavs) {
    Json uav = as_json(boards.uavs.at(name));
    uav.update(as_json(boards.tasks.at(name)));
    uavs.push_back(std::move(uav));
  }
  Json links = Json::array();
  for (const auto& [instance, link] : boards.links) {
    links.push_back({{"from", node_name(boards, link.from)},
                     {"to", node_name(boards, link.to)},
                     {"up", link.up},
                     {"latency", static_cast<double>(link.latency) * kNanosecond},
                     {"loss", link.loss}});
  }
  Json all{{"at", station.mission_time().to_seconds()}};
  all.update(as_json(*boards.ground));
  all["uavs"] = std::move(uavs);
  all["links"] = std::move(links);
  return all;
}

void print(Station& station, const StatusOptions& options, std::ostream& out) {
  if (options.json) {
    out << document(station).dump(options.watch ? -1 : 2, ' ', false,
                                  Json::error_handler_t::replace)
        << std::endl;
    return;
  }
  if (options.watch) out << "\x1b[H\x1b[2J";
  print_tables(station, out);
  out << std::flush;
}

}  // namespace

int status(const StatusOptions& options, std::ostream& out, std::ostream& err) {
  Station station(options.station);
  if (const auto opened = station.open(); !opened) {
    err << opened.error().why << '\n';
    return kExitSystem;
  }
  const auto heard = [&] { return station.boards().complete() && station.clock_heard(); };
  if (!station.listen(options.station.patience, heard)) {
    if (station.interrupted()) return kExitOk;
    err << "no ground station is heard on domain " << options.station.domain << kWhichDomain
        << '\n';
    return kExitTimeout;
  }
  print(station, options, out);
  const auto over = [&] { return station.phase() == wire::ClockPhase::kFinished; };
  while (options.watch && !over() && !station.interrupted()) {
    station.listen(kWatchPeriod, over);
    print(station, options, out);
  }
  return kExitOk;
}

}  // namespace skein::operate_tool
