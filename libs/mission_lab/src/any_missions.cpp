// SPDX-License-Identifier: Apache-2.0
// Missions as somebody writes them who knows docs/scenario-format.md alone: vehicles of all kinds
// at degrees 2 to 5 from several homes, with whatever the format offers, in one mission.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatestEvent = 500;  // of what happens and of what goes wrong [s]
constexpr int kFirstSynchro = 500;
constexpr int kFirstShared = 11;  // number of the first task of the global mission

struct Kind {
  const char *model, *folder, *device;
  bool flies = true, hovers = true, maps = false;
};
constexpr Kind kKindsOfVehicles[]{
    {"marvin", "comets", "fire-sensor"},
    {"heliv", "comets", "ir"},
    {"karma", "comets", "mapping", true, false, true},
    {"karma", "iros2005", "fire-sensor", true, false},
    {"plane", "../tests/random_missions", "mapping", true, false, true},
    {"ressac", "action", "visible"},
    {"heron", "area-sharing", "mapping", true, true, true},
    {"crow", "mref", "visible"},
    {"mana", "action", "visible", false},
    {"effibot", "action", "visible", false}};

double any_x(Random& random) { return random.uniform(-250, 900); }
double any_y(Random& random) { return random.uniform(-250, 700); }

class AnyDrawing {
 public:
  AnyDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random mission of anything"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 2400;
    mission_.finish_after = std::round(random_.uniform(10, 60));
    draw_world();
    draw_vehicles();
    draw_exchange();
    if (kinds_.radio) draw_radio();
    for (std::size_t who = 0; who < mission_.team.size(); ++who) draw_work(who);
    draw_meetings();
    if (kinds_.joint && random_.chance(0.3)) draw_joint();
    for (std::size_t n = random_.below(4); n > 0; --n) draw_later();
    if (kinds_.alarms && random_.chance(0.4)) draw_alarm();
    draw_operators();
    if (kinds_.air) draw_air();
    if (kinds_.radio) mission_.cuts = draw_cuts(random_, mission_.team, 5, kLatestEvent);
    if (kinds_.faults && random_.chance(0.5)) draw_faults();
    if (kinds_.deaths) add_deaths(mission_, kLatestEvent);
    return std::move(mission_);
  }

 private:
  const std::string& name_of(std::size_t who) const { return mission_.team[who].name; }
  std::size_t anyone() { return random_.below(mission_.team.size()); }
  bool flies(std::size_t who) const { return crafts_[who]->flies; }
  bool plans(std::size_t who) const { return mission_.team[who].degree >= 4; }
  bool bids(std::size_t who) const { return mission_.team[who].degree == 5; }
  std::string at_any_time() { return "{time: " + whole(random_.uniform(15, kLatestEvent)) + "}"; }

  // ---- where ----

  void draw_world() {
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 5)) +
                    ", gusts: " + tenths(random_.uniform(0, 1));
    if (kinds_.air && random_.chance(0.4))
      mission_.hills = "{at: " + point(random_.uniform(150, 600), random_.uniform(200, 600)) +
                       ", height: " + whole(random_.uniform(10, 90)) +
                       ", radius: " + whole(random_.uniform(120, 300)) + "}";
    for (std::size_t n = 1 + random_.below(3); n > 0; --n) {
      const double x = any_x(random_) / 2, y = any_y(random_) / 2;
      homes_.emplace_back(x, y);
    }
  }

  std::string location(const std::string& z) {
    const double x = any_x(random_), y = any_y(random_);
    return "[" + whole(x) + ", " + whole(y) + ", " + z + "]";
  }

  std::string on_ground() {
    const std::string name = "P" + std::to_string(mission_.places.size() + 1);
    mission_.places.push_back(name + ": " + location("0"));
    return name;
  }

  std::string a_place() {
    return random_.chance(0.75) ? on_ground() : location(whole_between(random_, 100, 170));
  }

  std::string a_zone() {
    const std::string name = "Z" + std::to_string(mission_.zones.size() + 1);
    mission_.zones.push_back(name + ": " + draw_zone(random_));
    return name;
  }

  // ---- who ----

  void draw_vehicles() {
    const std::size_t count = 2 + random_.below(5);
    const bool at_one_height = random_.chance(0.3);
    for (std::size_t i = 0; i < count; ++i) {
      crafts_.push_back(&kKindsOfVehicles[random_.below(std::size(kKindsOfVehicles))]);
      const auto& [x, y] = homes_[i % homes_.size()];
      Member one;
      one.model = crafts_[i]->model;
      one.name = one.model + std::to_string(i + 1);
      one.folder = crafts_[i]->folder;
      one.device = crafts_[i]->device;
      const std::string home = whole(x + 45 * static_cast<double>(i)) + ", " + whole(y);
      one.more = "start: [" + home + "]";
      mission_.places.push_back("H" + std::to_string(i + 1) + ": [" + home + ", 0]");
      if (kinds_.energy && random_.chance(0.35))
        one.more += ", energy: " + hundredths(random_.uniform(0.14, 0.4));
      if (kinds_.radio && random_.chance(0.4)) one.more += a_policy();
      one.altitude = 40 + (at_one_height ? 0 : 18 * static_cast<double>(i));
      one.first_id = 1000 * static_cast<int>(i + 1);
      one.degree = random_.chance(0.25) ? 2 + static_cast<int>(random_.below(2)) : 4;
      mission_.team.push_back(std::move(one));
    }
    if (kinds_.merged && random_.chance(0.6)) mission_.separation = "{merge: true}";
    static const std::vector<std::string> kConsistency{"dip-m", "dip-m", "dip-l", "dip-g", "cip"};
    mission_.consistency = kConsistency[random_.below(kConsistency.size())];
    if (random_.chance(0.2)) mission_.partner_lease = random_.uniform(60, 300);
  }

  std::string a_policy() {
    static const std::vector<std::string> kPolicies{"hold", "return", "continue"};
    const std::string& policy = kPolicies[random_.below(kPolicies.size())];
    return contact_loss(policy, random_.uniform(20, 90));
  }

  // Of those who plan for themselves some share out a global mission, unasked by the others.
  void draw_exchange() {
    if (random_.chance(0.4)) return;
    for (Member& one : mission_.team) {
      if (one.degree < 4 || random_.chance(0.3)) continue;
      one.degree = 5;
      mission_.bidders.push_back(one.name);
    }
    if (mission_.bidders.empty()) return;
    for (std::size_t n = 1 + random_.below(6); n > 0; --n) draw_team_task();
    mission_.sharing = "equity: " + tenths(random_.uniform(0, 1)) +
                       ", ahead: " + std::to_string(1 + random_.below(3));
  }

  // One of them can do it; somebody else may be told not to.
  void draw_team_task() {
    const std::size_t can = a_bidder(), another = a_bidder();
    const std::string id = std::to_string(kFirstShared + mission_.global.size());
    std::string task = "{id: " + id + ", task: " + a_task(can);
    if (!mission_.global.empty() && random_.chance(0.2))
      task += ", after: [" + std::to_string(kFirstShared - 1 + mission_.global.size()) + "]";
    if (random_.chance(0.15)) {
      task += ", by: " + name_of(can);
    } else if (can != another && random_.chance(0.3)) {
      task += ", not_by: [" + name_of(another) + "]";
    }
    if (random_.chance(0.15)) task += ", repeatable: true";
    if (kinds_.deadlines && random_.chance(0.15))
      task += ", end_before: " + whole_between(random_, 300, 1500);
    mission_.global.push_back(task + "}");
  }

  std::size_t a_bidder() {
    std::vector<std::size_t> all;
    for (std::size_t who = 0; who < mission_.team.size(); ++who)
      if (bids(who)) all.push_back(who);
    return all[random_.below(all.size())];
  }

  void draw_radio() {
    mission_.latency = random_.uniform(0.01, 0.3);
    if (random_.chance(0.5)) mission_.loss = std::round(random_.uniform(1, 25)) / 100;
    if (random_.chance(0.4)) mission_.range = std::round(random_.uniform(350, 900));
    for (const Member& one : mission_.team)
      if (random_.chance(0.4)) mission_.relays.push_back(one.name);
    const char* const capacities[]{"9600", "19200", "57600", "115200"};
    if (random_.chance(0.4))
      mission_.radio.push_back(std::string("capacity: ") + capacities[random_.below(4)]);
    if (random_.chance(0.2)) mission_.radio.push_back("silent: true");
    if (random_.chance(0.2)) mission_.radio.push_back("heartbeat: 2");
    if (random_.chance(0.7)) return;
    // One link is unlike the others, for a while.
    const double from = random_.uniform(0, kLatestEvent);
    mission_.links.push_back("{between: [" + name_of(anyone()) +
                             ", ground], latency: " + tenths(random_.uniform(0.1, 1)) +
                             ", capacity: 19200, from: " + whole(from) +
                             ", until: " + whole(from + random_.uniform(60, 400)) + "}");
  }

  // ---- what is to be done ----

  std::string a_task(std::size_t who) {
    switch (random_.below(crafts_[who]->maps ? 10 : flies(who) ? 9 : 8)) {
      case 0:
        return "[general-gotoxyz, " + a_place() + "]";
      case 1:
        return "[perform-tour, [" + on_ground() + ", " + on_ground() + ", " + on_ground() + "]]";
      case 2:
        return "[perform-monitoring, " + on_ground() + ", " + whole_between(random_, 30, 150) + "]";
      case 3:
        return "[general-wait, " + draw_length(random_) + "]";
      case 4:
        return "[general-combined-goto-and-takeshot, " + a_place() + ", " + draw_length(random_) +
               "]";
      case 5:
        return "[takeshot-while-waiting, " + draw_length(random_) + "]";
      case 8:
        return "[perform-detection, " + a_zone() + ", " + on_ground() + ", " +
               whole_between(random_, 60, 300) + "]";
      case 9:
        return "[perform-mapping, " + a_zone() + "]";
      default:
        return "[perceive, " + on_ground() + ", " + draw_length(random_) + "]";
    }
  }

  void add(Step& step, std::string words) {
    const int goal = 700 + 1000 * static_cast<int>(member_of(mission_, step)) + given_++;
    Task task{goal, std::move(words), ""};
    if (kinds_.deadlines && random_.chance(0.15)) task.times = draw_times(random_);
    step.tasks.push_back(std::move(task));
  }

  Step& begin_mission(std::size_t who, const std::string& name, const std::string& when) {
    Step step;
    step.name = name;
    step.when = when;
    step.uav = name_of(who);
    step.mission = 10 + static_cast<int>(mission_.steps.size());
    mission_.steps.push_back(std::move(step));
    return mission_.steps.back();
  }

  void act(const std::string& name, const std::string& when, double after, std::string action) {
    add_action(mission_, name, when, after, std::move(action));
  }

  // Who bids has something of its own now and then; whoever does not plan is given tasks.
  void draw_work(std::size_t who) {
    if (!plans(who)) return draw_flight(who, "fly-" + name_of(who), random_.uniform(3, 60));
    if (bids(who) && random_.chance(0.6)) return;
    const std::string when = "{time: " + whole_between(random_, 3, 60) + "}";
    Step& step = begin_mission(who, "first-" + name_of(who), when);
    for (std::size_t n = 1 + random_.below(4); n > 0; --n) add(step, a_task(who));
    if (random_.chance(0.3)) step.placement = "last, achieve: any";
  }

  void draw_flight(std::size_t who, const std::string& name, double at) {
    std::vector<std::string> tasks;
    const std::string altitude = whole(mission_.team[who].altitude);
    const auto add = [&](const std::string& words) {
      tasks.push_back("{id: " + std::to_string(++elementary_) + ", " + words + "}");
    };
    if (flies(who)) add("type: takeoff, mode: VUT, params: {altitude: " + altitude + "}");
    for (std::size_t n = 1 + random_.below(3); n > 0; --n) {
      add("type: goto, mode: DEP, params: {to: " + on_ground() + ", altitude: " + altitude + "}");
      if (random_.chance(0.6))
        add("type: perceive, mode: DEP, params: {device: " + std::string(crafts_[who]->device) +
            ", duration: " + whole_between(random_, 5, 60) + "}");
    }
    if (random_.chance(0.7)) {
      add("type: goto, mode: DEP, params: {to: H" + std::to_string(who + 1) +
          ", altitude: " + altitude + "}");
      if (flies(who)) add("type: land, mode: DEP");
    }
    act(name, "{time: " + whole(at) + "}", 0,
        "plan: {uav: " + name_of(who) + ", tasks: [" + joined(tasks, ", ") + "]}");
  }

  // ---- together ----

  // Of those who plan by themselves and do not bid, in one order, last of all that they do first.
  void draw_meetings() {
    for (int number = 1; number < 3; ++number) {
      if (random_.chance(0.6)) continue;
      std::vector<std::string> names;
      for (const Step& step : mission_.steps) {
        const std::size_t who = member_of(mission_, step);
        if (step.tasks.empty() || bids(who) || (!kinds_.energy && !flies(who))) continue;
        if (random_.chance(0.7)) names.push_back(step.uav);
      }
      if (names.size() >= 2) draw_meeting(names, kFirstSynchro + number);
    }
  }

  void draw_meeting(const std::vector<std::string>& names, int id) {
    const std::string all = "[" + joined(names, ", ") + "]";
    const std::string place = on_ground();
    const bool there = random_.chance(0.3);
    for (Step& step : mission_.steps) {
      if (std::find(names.begin(), names.end(), step.uav) == names.end()) continue;
      const std::string them = std::to_string(id) + ", " + all + ", " + all;
      add(step, there ? "[general-combined-goto-and-synchro-and-takeshot, " + them + ", " + place +
                            ", " + draw_length(random_) + "]"
                      : "[synchro, " + them + "]");
      if (random_.chance(0.4)) add(step, a_task(member_of(mission_, step)));
    }
  }

  void draw_joint() {
    std::vector<Step*> able;
    std::vector<std::string> names;
    for (Step& step : mission_.steps) {
      if (step.tasks.empty() || able.size() == 2) continue;
      const std::size_t who = member_of(mission_, step);
      if (bids(who) || !crafts_[who]->flies || !crafts_[who]->hovers) continue;
      able.push_back(&step);
      names.push_back(step.uav);
    }
    if (able.size() < 2) return;
    const JointTask drawn = draw_joint_task(random_, names);
    mission_.joint = true;
    mission_.places.insert(mission_.places.end(), drawn.places.begin(), drawn.places.end());
    for (Step* step : able) add(*step, drawn.words);
  }

  // ---- later ----

  void draw_later() {
    const std::size_t who = anyone();
    const std::string number = std::to_string(++later_);
    if (!plans(who)) return draw_flight(who, "later-" + number, random_.uniform(60, kLatestEvent));
    static const std::vector<std::string> kPlacements{"",     "first",   "last",
                                                      "best", "in-time", "tour"};
    const std::string when = at_any_time();
    Step& step = begin_mission(who, "later-" + number, when);
    step.placement = kPlacements[random_.below(kPlacements.size())];
    if (kinds_.changes && random_.chance(0.3)) step.placement = "first, interrupt: true";
    add(step, random_.chance(0.3) ? "[general-land]" : a_task(who));
  }

  // A fire or an engine in a zone that one looks over; another looks closer at what is told.
  void draw_alarm() {
    const std::size_t looks = anyone(), goes = anyone();
    if (!plans(looks) || !plans(goes) || !flies(looks)) return;
    const double x = random_.uniform(0, 400), y = random_.uniform(0, 300);
    const char* kind = random_.chance(0.7) ? "fire" : "hot-vehicle";
    mission_.objects.push_back(std::string("hot: {kind: ") + kind + ", position: " + point(x, y) +
                               ", radius: 4}");
    const std::string zone = "Z" + std::to_string(mission_.zones.size() + 1);
    mission_.zones.push_back(zone + ": " + rectangle(x, y, 90, 70));
    const std::string place = on_ground(), when = at_any_time();
    add(begin_mission(looks, "search", when), "[perform-detection, " + zone + ", " + place + ", " +
                                                  whole_between(random_, 100, 300) + "]");
    // Nobody may ever see it: the mission's end does not wait for what is done about it.
    act("look-closer", "{alarm: {state: raised, id: 1}}", 1,
        "mission: {uav: " + name_of(goes) +
            ", id: 400, tasks: [{id: 690, task: [perceive, alarm:1, " +
            whole_between(random_, 10, 60) + "]}]}");
  }

  // ---- who acts meanwhile ----

  void draw_operators() {
    if (kinds_.changes && random_.chance(0.4)) draw_cancellation();
    if (kinds_.degrees && random_.chance(0.3)) draw_degree();
    if (kinds_.degrees && random_.chance(0.5)) draw_hand();
    if (!kinds_.radio) return;
    for (std::size_t who = 0; who < mission_.team.size(); ++who)
      if (random_.chance(0.2)) give_again(who);
  }

  void draw_cancellation() {
    std::vector<std::size_t> missions;
    for (std::size_t i = 0; i < mission_.steps.size(); ++i)
      if (!mission_.steps[i].tasks.empty()) missions.push_back(i);
    if (missions.empty()) return;
    const Step& step = mission_.steps[missions[random_.below(missions.size())]];
    const Task& task = step.tasks[random_.below(step.tasks.size())];
    const std::string interrupt = random_.chance(0.5) ? ", interrupt: true" : "";
    const std::string action = "cancel: {uav: " + step.uav + ", goals: [" +
                               std::to_string(task.id) + "]" + interrupt + "}";
    act("cancel", at_any_time(), 0, action);
  }

  void draw_degree() {
    const std::size_t who = anyone();
    const std::string uav = "uav: " + name_of(who);
    const int before = mission_.team[who].degree;
    const std::string to = std::to_string(1 + random_.below(static_cast<std::size_t>(before) - 1));
    const std::string interrupt = random_.chance(0.5) ? ", interrupt: true" : "";
    act("down", at_any_time(), 0, "degree: {" + uav + ", to: " + to + interrupt + "}");
    act("up", "{step: down}", random_.uniform(10, 150),
        "degree: {" + uav + ", to: " + std::to_string(before) + ", resume: true}");
  }

  // An operator takes a vehicle in hand, may fly it somewhere, and gives it back.
  void draw_hand() {
    const std::size_t who = anyone();
    const std::string uav = "uav: " + name_of(who);
    const std::string interrupt = random_.chance(0.6) ? ", interrupt: true" : "";
    act("mine", at_any_time(), 0, "take_in_hand: {" + uav + interrupt + "}");
    if (random_.chance(0.5))
      act("by-hand", "{step: mine}", random_.uniform(2, 20),
          "plan: {" + uav + ", tasks: [{id: " + std::to_string(++elementary_) +
              ", type: goto, mode: VUT, params: {to: " + on_ground() +
              ", altitude: " + whole(mission_.team[who].altitude) + "}}]}");
    act("yours", "{step: mine}", random_.uniform(30, 200), "give_back: {" + uav + "}");
  }

  // What its contact-loss policy interrupted.
  void give_again(std::size_t who) {
    const std::string uav = "uav: " + name_of(who);
    act("again-" + name_of(who), "{held: " + name_of(who) + "}", 2,
        plans(who) ? "degree: {" + uav + ", to: " + std::to_string(mission_.team[who].degree) + "}"
                   : "resume_plan: {" + uav + "}");
    mission_.steps.back().repeats = true;
  }

  // ---- what goes wrong ----

  // Half of it where something is to be done; closed from the start, for a time, or in flight.
  void draw_air() {
    for (std::size_t n = random_.below(4); n > 0; --n) {
      double x = any_x(random_), y = any_y(random_);
      if (random_.chance(0.5)) std::tie(x, y) = draw_place_of(random_, mission_);
      close(std::to_string(n), draw_box(random_, x, y));
    }
  }

  void close(const std::string& number, std::string volume) {
    const double from = random_.uniform(40, kLatestEvent);
    if (random_.chance(0.5)) {
      if (random_.chance(0.6))
        volume += ", from: " + whole(from) + ", until: " + whole(from + random_.uniform(60, 400));
      return mission_.volumes.push_back("V" + number + ": {" + volume + "}");
    }
    const std::string closes = "close-" + number, smoke = "{name: smoke-" + number;
    act(closes, "{time: " + whole(from) + "}", 0, "close_air: " + smoke + ", " + volume + "}");
    if (random_.chance(0.5))
      act("open-" + number, "{step: " + closes + "}", random_.uniform(60, 400),
          "open_air: " + smoke + "}");
  }

  void draw_faults() {
    for (std::size_t n = 1 + random_.below(3); n > 0; --n) {
      const std::size_t who = anyone();
      const double drawn = random_.uniform();
      const auto device = [&](Random&) { return std::string(crafts_[who]->device); };
      mission_.faults.push_back(drawn < 0.1 ? "{at: " + whole_between(random_, 60, kLatestEvent) +
                                                  ", engine: " + name_of(who) + "}"
                                : drawn < 0.3
                                    ? draw_refusals(random_, name_of(who), kLatestEvent)
                                    : draw_fault(random_, name_of(who), device, kLatestEvent));
    }
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  std::vector<std::pair<double, double>> homes_;  ///< x, y [m]
  std::vector<const Kind*> crafts_;               ///< of each of the team
  int given_ = 0, later_ = 0, elementary_ = 0;    ///< goals, steps, elementary tasks
};

}  // namespace

Mission generate_anything(std::uint64_t seed, const Kinds& kinds) {
  Mission mission = AnyDrawing(seed, kinds).draw();
  if (kinds.minds) change_minds(mission);
  if (kinds.busy) keep_an_operator_busy(mission);
  return mission;
}

}  // namespace skein::mission_lab
