// SPDX-License-Identifier: Apache-2.0
#include "synthetic_mission.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "skein/foundation/random.hpp"

namespace skein::report::testing {

namespace {

using Json = nlohmann::ordered_json;

// Collects lines, then gives them in the order of time.
class Log {
 public:
  void add(double at, const std::string& node, const std::string& kind, Json rest) {
    Json line{{"at", std::round(at * 1000.0) / 1000.0}, {"node", node}, {"kind", kind}};
    line.update(rest);
    lines_.emplace_back(at, line.dump());
  }
  std::string text() {
    std::stable_sort(lines_.begin(), lines_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string all;
    for (const auto& [at, line] : lines_) all += line + "\n";
    return all;
  }
  std::size_t size() const { return lines_.size(); }

 private:
  std::vector<std::pair<double, std::string>> lines_;
};

struct Waypoint {
  double t, x, y, z;
};

// Straight between way points, corners rounded by averaging over a few seconds.
Position place_at(const std::vector<Waypoint>& way, double t) {
  const auto raw = [&](double time) {
    const auto next =
        std::find_if(way.begin(), way.end(), [&](const Waypoint& w) { return w.t > time; });
    if (next == way.begin()) return Position{next->x, next->y, next->z};
    const Waypoint& a = *(next - 1);
    if (next == way.end()) return Position{a.x, a.y, a.z};
    const double part = (time - a.t) / (next->t - a.t);
    return Position{a.x + (next->x - a.x) * part, a.y + (next->y - a.y) * part,
                    a.z + (next->z - a.z) * part};
  };
  Position sum;
  for (int k = -4; k <= 4; ++k) {
    const Position p = raw(t + k);
    sum = {sum.x + p.x / 9, sum.y + p.y / 9, sum.z + p.z / 9};
  }
  return sum;
}

/// When a UAV flies, and how unsteadily [m].
struct Flight {
  double takeoff;
  double landing;
  double wobble;
};

void add_track(Log& log, const std::string& uav, const std::vector<Waypoint>& way,
               const Flight& flight, Random random) {
  double energy = 1.0, heading = 0.6;
  for (int second = 0; second <= 1500; ++second) {
    const double t = second;
    const bool airborne = t >= flight.takeoff && t < flight.landing;
    Position p = place_at(way, t);
    const Position q = place_at(way, t + 1);
    if (airborne) {
      energy -= 0.00042 + 0.0001 * random.uniform();
      p.x += flight.wobble * std::sin(t / 9.0);
      p.y += flight.wobble * std::cos(t / 7.0);
      p.z += 0.3 * flight.wobble * std::sin(t / 5.0);
    }
    if (std::hypot(q.x - p.x, q.y - p.y) > 1.0) heading = std::atan2(q.y - p.y, q.x - p.x);
    log.add(
        t, "sim", "telemetry",
        {{"uav", uav},
         {"position",
          {std::round(p.x * 100) / 100, std::round(p.y * 100) / 100, std::round(p.z * 100) / 100}},
         {"velocity", {q.x - p.x, q.y - p.y, q.z - p.z}},
         {"heading", heading},
         {"energy", energy},
         {"airborne", airborne}});
  }
}

class Messages {
 public:
  explicit Messages(Log& log) : log_(log) {}
  void send(double t, const std::string& slot, const std::string& from, const std::string& to) {
    const int sequence = ++sequence_[slot + from + to];
    log_.add(t, from, "message",
             {{"slot", slot},
              {"from", from},
              {"to", to},
              {"sequence", sequence},
              {"direction", "sent"}});
    if (cut(t, from, to)) {
      const bool expired = slot != "TaskEvent";
      log_.add(
          t + 12, from, expired ? "expired" : "lost",
          {{"slot", slot}, {"to", to}, {"sequence", sequence}, {"last", sequence}, {"from", from}});
      return;
    }
    const double latency = 0.02 + 0.01 * random_.uniform() + (random_.chance(0.05) ? 0.4 : 0.0);
    log_.add(t + latency, to, "message",
             {{"slot", slot},
              {"from", from},
              {"to", to},
              {"sequence", sequence},
              {"direction", "received"}});
  }

 private:
  static bool cut(double t, const std::string& from, const std::string& to) {
    return t > 860 && t < 935 && (from == "heliv" || to == "heliv") &&
           (from == "ground" || to == "ground");
  }
  Log& log_;
  std::map<std::string, int> sequence_;
  Random random_{5, "messages"};
};

struct Life {
  int id;
  const char* type;
  double scheduled, started, running, aborting, end;  // negative: skipped
  const char* outcome;
  const char* reason = "";
};

void add_tasks(Log& log, Messages& messages, const std::string& uav,
               const std::vector<Life>& lives) {
  for (const Life& life : lives) {
    const std::pair<const char*, double> steps[] = {{"scheduled", life.scheduled},
                                                    {"started", life.started},
                                                    {"running", life.running},
                                                    {"aborting", life.aborting},
                                                    {life.outcome, life.end}};
    messages.send(life.scheduled - 0.1, "TaskRequest", "ground", uav);
    messages.send(life.scheduled, "RequestReply", uav, "ground");
    log.add(life.scheduled, uav, "request",
            {{"uav", uav},
             {"request", "START"},
             {"mode", "SEQ"},
             {"task", life.id},
             {"accepted", true}});
    for (const auto& [state, t] : steps) {
      if (t < 0) continue;
      Json rest{{"uav", uav}, {"task", life.id}, {"type", life.type}, {"state", state}};
      if (*life.reason != 0 && t == life.end) rest["reason"] = life.reason;
      log.add(t, uav, "task", rest);
      messages.send(t + 0.05, "TaskEvent", uav, "ground");
    }
  }
}

void add_marvin(Log& log, Messages& messages) {
  add_track(log, "marvin",
            {{0, 0, 0, 0},
             {14, 0, 0, 0},
             {36, 0, 0, 30},
             {130, 420, 230, 45},
             {190, 860, 240, 48},
             {205, 860, 300, 48},
             {265, 430, 310, 46},
             {280, 430, 370, 50},
             {340, 850, 380, 52},
             {352, 850, 440, 52},
             {396, 590, 446, 52},
             {470, 350, 100, 60},
             {662, 350, 100, 60},
             {760, 560, 330, 62},
             {1160, 562, 332, 62},
             {1300, 0, 10, 40},
             {1345, 0, 0, 0},
             {1346, 0, 0, 0}},
            {14, 1345, 0.6}, Random(1, "marvin"));
  add_tasks(log, messages, "marvin",
            {{1, "takeoff", 8, 8.2, 9, -1, 36, "ended"},
             {2, "goto", 8.4, 36.2, 37, -1, 130, "ended"},
             {3, "goto-list", 8.6, 130.2, 131, 396, 399, "aborted", "interrupted by the ground"},
             {4, "takeshot", 8.8, 131.2, 132, 396, 397, "aborted", "interrupted by the ground"},
             {5, "goto", 9, -1, -1, -1, 396, "aborted", "precondition false for ever"},
             {6, "land", 9.2, -1, -1, -1, 396.1, "aborted", "precondition false for ever"},
             {7, "goto", 396.5, 399.2, 400, -1, 470, "ended"},
             {8, "wait", 396.7, 470.2, 471, 660, 662, "aborted", "exit condition"},
             {9, "goto", 658, 662.2, 663, -1, 760, "ended"},
             {10, "synchronise", 658.2, 760.2, 760.2, -1, 812, "ended"},
             {11, "wait", 658.4, 760.3, 761, 812, 813, "aborted", "exit condition"},
             {12, "wait", 658.6, 813.2, 814, 1152, 1154, "aborted", "exit condition"},
             {13, "takeshot", 658.8, 814.2, 815, 1152, 1153, "aborted", "exit condition"},
             {14, "goto", 1152.5, 1154.2, 1155, -1, 1300, "ended"},
             {15, "land", 1152.7, 1300.2, 1301, -1, 1346, "ended"}});
}

void add_heliv(Log& log, Messages& messages) {
  add_track(log, "heliv",
            {{0, -18, 22, 0},
             {412, -18, 22, 0},
             {440, -18, 22, 25},
             {560, 600, 360, 80},
             {645, 612, 372, 80},
             {662, 612, 372, 80},
             {716, 740, 430, 84},
             {742, 735, 505, 84},
             {812, 728, 500, 84},
             {1160, 730, 498, 84},
             {1330, -18, 24, 40},
             {1378, -18, 22, 0},
             {1379, -18, 22, 0}},
            {412, 1378, 3.5}, Random(2, "heliv"));
  add_tasks(log, messages, "heliv",
            {{1, "takeoff", 405, 405.3, 412, -1, 440, "ended"},
             {2, "goto", 405.4, 440.2, 442, -1, 560, "ended"},
             {3, "takeshot", 405.6, 560.2, 562, -1, 645, "ended"},
             {4, "wait", 405.8, 645.2, 646, 659, 662, "aborted", "exit condition"},
             {5, "goto", 658, 662.3, 664, -1, 811, "ended"},
             {6, "synchronise", 658.2, 811.2, 811.2, -1, 812, "ended"},
             {7, "wait", 658.4, 812.2, 813, 1156, 1158, "aborted", "exit condition"},
             {8, "takeshot", 658.6, 813.3, 815, 1156, 1157, "aborted", "exit condition"},
             {9, "goto", 1155.5, 1158.2, 1160, -1, 1330, "ended"},
             {10, "land", 1155.7, 1330.2, 1332, -1, 1379, "ended"}});
}

void add_karma(Log& log, Messages& messages) {
  std::vector<Waypoint> way{
      {0, 30, -25, 0}, {662, 30, -25, 0}, {722, 60, 20, 120}, {850, 520, 180, 170}};
  for (int lap = 0; lap < 4; ++lap) {
    for (int k = 0; k < 12; ++k) {
      const double angle = -2.2 + 2 * M_PI * k / 12, radius = 210 - 22 * lap;
      way.push_back({856.0 + 75.0 * lap + 6.2 * k, 660 + radius * std::cos(angle),
                     425 + 0.8 * radius * std::sin(angle), 175.0 + 4 * lap});
    }
  }
  way.insert(way.end(),
             {{1165, 500, 250, 180}, {1405, 60, -10, 90}, {1462, 30, -25, 0}, {1463, 30, -25, 0}});
  add_track(log, "karma", way, {662, 1462, 1.5}, Random(3, "karma"));
  add_tasks(log, messages, "karma",
            {{1, "takeoff", 658, 658.3, 662, -1, 722, "ended"},
             {2, "goto", 658.3, 722.2, 723, -1, 850, "ended"},
             {3, "map", 658.6, 850.2, 852, 1154, 1162, "aborted", "exit condition"},
             {4, "takeshot", 658.9, 852.2, 853, 1154, 1155, "aborted", "exit condition"},
             {5, "goto", 1154.5, 1162.3, 1163, -1, 1405, "ended"},
             {6, "land", 1154.7, 1405.2, 1406, -1, 1463, "ended"}});
}

void add_ground(Log& log) {
  log.add(0, "ground", "mission", {{"state", "started"}});
  log.add(0.1, "ground", "phase", {{"name", "Detection"}});
  log.add(400, "ground", "phase", {{"name", "Confirmation"}});
  log.add(657, "ground", "phase", {{"name", "Monitoring"}});
  log.add(1150.2, "ground", "phase", {{"name", "Return"}});
  log.add(1150, "ground", "operator", {{"does", "stop"}});
  log.add(238, "ground", "alarm",
          {{"alarm", 1}, {"state", "raised"}, {"position", {566, 262, 12}}, {"belief", 0.41}});
  log.add(318, "ground", "alarm",
          {{"alarm", 1}, {"state", "infirmed"}, {"position", {566, 262, 12}}, {"belief", 0.07}});
  log.add(395, "ground", "alarm",
          {{"alarm", 2}, {"state", "raised"}, {"position", {652.4, 408.9, 20}}, {"belief", 0.72}});
  log.add(
      632, "ground", "alarm",
      {{"alarm", 2}, {"state", "confirmed"}, {"position", {646.2, 414.5, 20}}, {"belief", 0.97}});
  log.add(500, "ground", "command",
          {{"uav", "heliv"}, {"command", 1}, {"what", "goto"}, {"state", "issued"}});
  log.add(500.3, "ground", "command",
          {{"uav", "heliv"}, {"command", 1}, {"what", "goto"}, {"state", "acknowledged"}});
  log.add(870, "ground", "request",
          {{"uav", "heliv"},
           {"request", "ABORT"},
           {"task", 99},
           {"accepted", false},
           {"why", "unknown task"}});
  log.add(540, "ground", "dropped",
          {{"slot", "Alarm"},
           {"origin", "unknown-node"},
           {"field", "belief"},
           {"why", "not in [0, 1]"}});
  log.add(1500, "ground", "mission", {{"state", "finished"}});
  for (int k = 0; k < 70; ++k) {
    const double t = 815 + 5 * k;
    log.add(t, "ground", "perception",
            {{"uav", k % 2 == 0 ? "marvin" : "heliv"}, {"device", "camera"}, {"detections", 1}});
  }
}

void add_radio(Log& log) {
  const char* names[] = {"ground", "heliv", "karma", "marvin"};
  for (const char* a : names) {
    for (const char* b : names) {
      if (a == b) continue;
      log.add(0, "sim", "link", {{"from", a}, {"to", b}, {"up", true}});
      log.add(2.1, a, "reach", {{"peer", b}, {"reachable", true}});
    }
  }
  for (const auto& [from, to] : {std::pair{"heliv", "ground"}, std::pair{"ground", "heliv"}}) {
    log.add(860, "sim", "link", {{"from", from}, {"to", to}, {"up", false}});
    log.add(863.2, from, "reach", {{"peer", to}, {"reachable", false}});
    log.add(935, "sim", "link", {{"from", from}, {"to", to}, {"up", true}});
    log.add(936.5, from, "reach", {{"peer", to}, {"reachable", true}});
  }
  log.add(1050, "sim", "link", {{"from", "karma"}, {"to", "marvin"}, {"up", false}});
  log.add(1053, "karma", "reach", {{"peer", "marvin"}, {"reachable", false}});
  log.add(1090, "sim", "link", {{"from", "karma"}, {"to", "marvin"}, {"up", true}});
  log.add(1092, "karma", "reach", {{"peer", "marvin"}, {"reachable", true}});
}

void add_syncs(Log& log) {
  const auto sync = [&log](double t, const char* from, const char* to) {
    log.add(t, from, "sync", {{"id", "551"}, {"from", from}, {"to", to}, {"direction", "sent"}});
    log.add(t + 0.03, to, "sync",
            {{"id", "551"}, {"from", from}, {"to", to}, {"direction", "received"}});
  };
  sync(760.3, "marvin", "heliv");
  sync(811.3, "heliv", "marvin");
}

void add_troubles(Log& log) {
  log.add(860, "sim", "fault", {{"what", "cut"}, {"target", "heliv – ground"}});
  log.add(1020, "runner", "fault", {{"what", "kill"}, {"target", "karma"}});
  log.add(0, "runner", "process", {{"name", "ddn-karma"}, {"state", "started"}});
  log.add(1020, "runner", "process",
          {{"name", "ddn-karma"}, {"state", "crashed"}, {"why", "signal 9"}});
  log.add(1030, "runner", "process", {{"name", "ddn-karma"}, {"state", "restarted"}});
  log.add(700, "ground", "degree", {{"uav", "heliv"}, {"degree", 2}});
}

void add_expectations(Log& log) {
  const auto expect = [&log](const char* name, bool passed, const char* seen) {
    log.add(1500, "runner", "expectation", {{"name", name}, {"passed", passed}, {"seen", seen}});
  };
  expect("the alarm at the fire is confirmed", true, "alarm 2 confirmed at 10:32");
  expect("marvin and heliv synchronise before monitoring", true,
         "sync 551 received by both at 13:31");
  expect("heliv is home before 22 min", false, "heliv landed at 22:58, 58 s late");
  expect("every UAV lands", true, "heliv 22:58, karma 24:22, marvin 22:25");
  expect("least separation above 15 m", true, "33.8 m between marvin and karma");
  expect("no task is aborted without a reason", true, "17 aborted, each with its reason");
}

}  // namespace

RunInfo comets_info() {
  RunInfo info;
  info.scenario = "comets-confirmed";
  info.epoch = "2005-05-19T09:00:00Z";
  info.runtime = RuntimeKind::kDds;
  info.rate = 20;
  info.seed = 1;
  info.wall_seconds = 75.4;
  info.version = "0.1.0";
  info.extents = Extents{-400, -400, 1200, 1000};
  TerrainGrid t{-400, -400, 20, 81, 71, {}};
  for (std::size_t row = 0; row < t.height; ++row) {
    for (std::size_t column = 0; column < t.width; ++column) {
      const double x = t.west + 20.0 * static_cast<double>(column),
                   y = t.south + 20.0 * static_cast<double>(row);
      const auto hill = [&](double cx, double cy, double h, double r) {
        return h * std::exp(-((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (r * r));
      };
      t.values.push_back(hill(300, 700, 60, 180) + hill(860, 120, 45, 220) +
                         hill(-150, 250, 35, 260) + hill(700, 480, 22, 120) +
                         4 * std::sin(x / 90) * std::cos(y / 130));
    }
  }
  info.terrain = std::move(t);
  info.zones = {{"Z", {{400, 200}, {900, 200}, {900, 600}, {400, 600}}}};
  info.places = {{"base", {0, 0, 0}}, {"aside", {350, 100, 60}}};
  info.uavs = {{"marvin", "helicopter", 3}, {"heliv", "helicopter", 3}, {"karma", "blimp", 3}};
  return info;
}

std::string comets_journal() {
  Log log;
  Messages messages(log);
  add_ground(log);
  add_marvin(log, messages);
  add_heliv(log, messages);
  add_karma(log, messages);
  add_radio(log);
  add_syncs(log);
  add_troubles(log);
  for (int k = 0; k <= 50; ++k) {
    log.add(30 * k, "sim", "object",
            {{"name", "fire"},
             {"type", "fire"},
             {"position", {640, 420, 18}},
             {"radius", 6 + 0.3 * k},
             {"active", true}});
  }
  messages.send(395.2, "Alarm", "ground", "heliv");
  messages.send(870, "TaskRequest", "ground", "heliv");
  messages.send(900, "TaskEvent", "heliv", "ground");
  add_expectations(log);
  return log.text();
}

RunInfo swarm_info(std::size_t uavs) {
  RunInfo info;
  info.scenario = "swarm";
  for (std::size_t i = 0; i < uavs; ++i)
    info.uavs.push_back({"uav-" + std::to_string(i), "quad", 4});
  return info;
}

std::string swarm_journal(std::size_t uavs, std::size_t lines, std::uint64_t seed) {
  Log log;
  Messages messages(log);
  Random random(seed);
  const std::vector<UavInfo> team = swarm_info(uavs).uavs;
  const std::size_t seconds = std::max<std::size_t>(lines * 3 / 5 / uavs, 1);
  for (std::size_t i = 0; i < uavs; ++i) {
    double x = 60.0 * static_cast<double>(i), y = 0, heading = 0;
    for (std::size_t t = 0; t < seconds; ++t) {
      heading += 0.3 * random.normal();
      x += 6 * std::cos(heading);
      y += 6 * std::sin(heading);
      log.add(static_cast<double>(t), "sim", "telemetry",
              {{"uav", team[i].name},
               {"position", {x, y, 40 + 10 * std::sin(static_cast<double>(t) / 50)}},
               {"velocity", {6, 0, 0}},
               {"heading", heading},
               {"energy", 0.9},
               {"airborne", true}});
    }
  }
  int task = 0;
  while (log.size() < lines) {
    const std::string& uav = team[random.below(uavs)].name;
    const double t = random.uniform(1, static_cast<double>(seconds));
    ++task;
    for (const auto& [state, delay] :
         {std::pair{"scheduled", 0.0}, {"started", 5.0}, {"running", 6.0}, {"ended", 40.0}}) {
      log.add(t + delay, uav, "task",
              {{"uav", uav}, {"task", task}, {"type", "goto"}, {"state", state}});
    }
    for (int k = 0; k < 12; ++k)
      messages.send(t + k, "TaskEvent", uav, team[random.below(uavs)].name);
  }
  return log.text();
}

}  // namespace skein::report::testing
