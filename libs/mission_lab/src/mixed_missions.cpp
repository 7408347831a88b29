// SPDX-License-Identifier: Apache-2.0
// All of it in one mission: a team that shares out a global mission, others with missions of their
// own, some of them on the ground, over fires and past relays, while operators act.
#include <algorithm>
#include <cmath>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatest = 400;  // of troubles and of what is asked for besides [s]
constexpr int kFirstMeeting = 500;
constexpr int kFirstOfTeam = 11;  // number of the first task of the global mission

struct Model {
  std::string name, folder;
  bool flies = true, hovers = true, maps = false;
  std::string device;  ///< one that may break
};

const Model& draw_model(Random& random) {
  static const std::vector<Model> kModels{{"marvin", "comets", true, true, false, "fire-sensor"},
                                          {"heliv", "comets", true, true, false, "ir"},
                                          {"karma", "comets", true, false, true, "mapping"},
                                          {"ressac", "action", true, true, false, "visible"},
                                          {"mana", "action", false, true, false, "visible"},
                                          {"effibot", "action", false, true, false, "visible"}};
  static const std::vector<std::size_t> kShares{0, 0, 0, 0, 1, 1, 1, 2, 2, 3, 4, 5};
  return kModels[kShares[random.below(kShares.size())]];
}

class MixedDrawing {
 public:
  MixedDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random mixed mission"), kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 3000;
    mission_.finish_after = std::round(random_.uniform(10, 60));
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 4)) + ", gusts: 0.1";
    if (kinds_.air && random_.chance(0.3)) mission_.hills = draw_hills();
    draw_vehicles();
    draw_exchange();
    if (kinds_.radio) draw_radio();
    if (random_.chance(0.4)) draw_fire();
    draw_work();
    if (kinds_.joint && random_.chance(0.3)) draw_joint();
    for (Step& step : mission_.steps) finish(step);
    for (std::size_t n = random_.below(4); n > 0; --n) draw_later();
    draw_operators();
    if (kinds_.air) draw_air();
    if (kinds_.radio) mission_.cuts = draw_cuts(random_, mission_.team, 4, kLatest);
    if (kinds_.faults && random_.chance(0.4)) draw_faults();
    if (kinds_.deaths) add_deaths(mission_, kLatest);
    return std::move(mission_);
  }

 private:
  // ---- who, and what they hear ----

  std::string draw_hills() {
    return "{at: " + point(random_.uniform(150, 450), random_.uniform(200, 500)) +
           ", height: " + whole(random_.uniform(15, 70)) +
           ", radius: " + whole(random_.uniform(120, 260)) + "}";
  }

  void draw_vehicles() {
    const std::size_t count = 3 + random_.below(5);
    for (std::size_t i = 0; i < count; ++i) {
      const Model& model = draw_model(random_);
      Member one;
      one.name = model.name + std::to_string(i + 1);
      one.model = model.name;
      one.folder = model.folder;
      one.more = "start: " + point(50 * static_cast<double>(i) - 100, -80 * random_.uniform(0, 2));
      if (kinds_.energy && random_.chance(0.1))
        one.more += ", energy: " + hundredths(random_.uniform(0.15, 0.5));
      if (kinds_.radio && random_.chance(0.25))
        one.more += contact_loss(random_.chance(0.5) ? "hold" : "return", 60);
      one.altitude = 35 + 18 * static_cast<double>(i);
      one.first_id = 1000 * static_cast<int>(i + 1);
      one.degree = 4;
      models_.push_back(model);
      mission_.team.push_back(std::move(one));
    }
    if (random_.chance(0.4)) mission_.separation = "{merge: true}";
    static const std::vector<std::string> kConsistency{"dip-m", "dip-m", "dip-l", "dip-g", "cip"};
    mission_.consistency = kConsistency[random_.below(kConsistency.size())];
  }

  std::size_t any() { return random_.below(mission_.team.size()); }

  // Two or more share out a global mission.
  void draw_exchange() {
    if (random_.chance(0.35)) return;
    const std::size_t count = 2 + random_.below(mission_.team.size() - 1);
    for (std::size_t i = 0; i < count; ++i) {
      mission_.team[i].degree = 5;
      mission_.bidders.push_back(mission_.team[i].name);
    }
    for (std::size_t n = 2 + random_.below(4); n > 0; --n) draw_team_task();
  }

  bool bids(std::size_t who) const { return mission_.team[who].degree == 5; }

  void draw_team_task() {
    const std::string id = std::to_string(kFirstOfTeam + mission_.global.size());
    std::string task = "{id: " + id + ", task: ";
    task += random_.chance(0.7)
                ? "[perceive, " + new_place() + ", " + whole(random_.uniform(5, 60)) + "]"
                : "[general-gotoxyz, " + new_place() + "]";
    if (!mission_.global.empty() && random_.chance(0.2))
      task += ", after: [" + std::to_string(kFirstOfTeam - 1 + mission_.global.size()) + "]";
    if (random_.chance(0.15))
      task += ", by: " + mission_.bidders[random_.below(mission_.bidders.size())];
    if (kinds_.deadlines && random_.chance(0.15))
      task += ", end_before: " + whole(random_.uniform(300, 1200));
    mission_.global.push_back(task + "}");
  }

  // Half of them are far from the ground station at times, and are heard past others if anybody is.
  void draw_radio() {
    mission_.latency = random_.uniform(0.01, 0.2);
    mission_.loss = random_.chance(0.5) ? 0 : std::round(random_.uniform(1, 20)) / 100;
    if (random_.chance(0.5)) mission_.range = std::round(random_.uniform(250, 700));
    for (const Member& one : mission_.team)
      if (random_.chance(0.5)) mission_.relays.push_back(one.name);
  }

  // ---- what is to be done ----

  std::string new_place() { return add_place(random_, mission_); }

  std::string new_zone() {
    const std::string name = "Z" + std::to_string(mission_.zones.size() + 1);
    mission_.zones.push_back(name + ": " + draw_zone(random_));
    return name;
  }

  void draw_fire() {
    const double x = random_.uniform(100, 400), y = random_.uniform(0, 350);
    const double radius = std::round(random_.uniform(5, 40));
    mission_.objects.push_back("fire: {kind: fire, position: " + point(x, y) +
                               ", radius: " + whole(radius) +
                               ", spread: {rate: " + hundredths(random_.uniform(0.01, 0.06)) +
                               ", gain: " + hundredths(random_.uniform(0, 0.4)) + "}}");
    mission_.places.push_back("F: [" + whole(x + radius) + ", " + whole(y) + ", 0]");
    mission_.followed.push_back(
        "F: {kind: fire, reach: 60, drift: " + tenths(random_.uniform(0.3, 1)) + "}");
    mission_.zones.push_back("ZF: " + rectangle(x, y, 80, 60));
  }

  bool burns() const { return !mission_.followed.empty(); }

  std::string a_zone() { return burns() && random_.chance(0.5) ? "ZF" : new_zone(); }
  std::string a_place() { return burns() && random_.chance(0.4) ? "F" : new_place(); }

  std::string a_task(std::size_t who) {
    const Model& model = models_[who];
    switch (random_.below(model.maps ? 8 : model.flies ? 7 : 6)) {
      case 0:
        return "[general-gotoxyz, " + new_place() + "]";
      case 1:
        return "[perform-tour, [" + new_place() + ", " + new_place() + "]]";
      case 2:
        return "[perform-monitoring, " + a_place() + ", " + whole(random_.uniform(30, 150)) + "]";
      case 3:
        return "[general-wait, " + whole(random_.uniform(5, 60)) + "]";
      case 6:
        return "[perform-detection, " + a_zone() + ", " + a_place() + ", " +
               whole(random_.uniform(60, 240)) + "]";
      case 7:
        return "[perform-mapping, " + a_zone() + "]";
      default:
        return "[perceive, " + a_place() + ", " + whole(random_.uniform(10, 90)) + "]";
    }
  }

  void add(Step& step, std::string words) {
    Task task{700 + 1000 * static_cast<int>(member_of(mission_, step)) + given_++, std::move(words),
              ""};
    if (kinds_.deadlines && random_.chance(0.1)) task.times = draw_times(random_);
    step.tasks.push_back(std::move(task));
  }

  Step& begin_mission(std::size_t who, const std::string& name, double at) {
    Step step;
    step.name = name;
    step.when = "{time: " + whole(at) + "}";
    step.uav = mission_.team[who].name;
    step.mission = 10 + static_cast<int>(mission_.steps.size());
    mission_.steps.push_back(std::move(step));
    return mission_.steps.back();
  }

  // Who bids is asked for something of its own now and then; meetings are of those who do not bid,
  // in one order, so that nobody waits for ever. Who hovers until one who drives is there may run
  // short: they do not meet where nothing is to go wrong.
  void draw_work() {
    std::vector<std::size_t> firsts;
    for (std::size_t who = 0; who < mission_.team.size(); ++who) {
      if (bids(who) && random_.chance(0.7)) continue;
      firsts.push_back(who);
      Step& step = begin_mission(who, "first-" + mission_.team[who].name, random_.uniform(3, 40));
      for (std::size_t n = 1 + random_.below(3); n > 0; --n) add(step, a_task(who));
    }
    for (int n = static_cast<int>(random_.below(3)); n > 0; --n) draw_meeting(firsts, n);
  }

  void draw_meeting(const std::vector<std::size_t>& firsts, int number) {
    std::vector<std::string> names;
    for (const std::size_t who : firsts) {
      if (bids(who) || (!kinds_.energy && !models_[who].flies)) continue;
      if (random_.chance(0.7)) names.push_back(mission_.team[who].name);
    }
    if (names.size() < 2) return;
    const std::string all = "[" + joined(names, ", ") + "]";
    for (Step& step : mission_.steps) {
      if (std::find(names.begin(), names.end(), step.uav) == names.end()) continue;
      add(step,
          "[synchro, " + std::to_string(kFirstMeeting + number) + ", " + all + ", " + all + "]");
      if (random_.chance(0.4)) add(step, a_task(member_of(mission_, step)));
    }
  }

  // Of the first two who do not bid and hover, last of all they have to do.
  void draw_joint() {
    std::vector<Step*> able;
    std::vector<std::string> names;
    for (Step& step : mission_.steps) {
      const std::size_t who = member_of(mission_, step);
      const Model& model = models_[who];
      if (bids(who) || !model.hovers || !model.flies || model.folder != "comets" ||
          able.size() == 2)
        continue;
      able.push_back(&step);
      names.push_back(step.uav);
    }
    if (able.size() < 2) return;
    const JointTask drawn = draw_joint_task(random_, names);
    mission_.joint = true;
    mission_.places.insert(mission_.places.end(), drawn.places.begin(), drawn.places.end());
    for (Step* step : able) add(*step, drawn.words);
  }

  void finish(Step& step) {
    if (random_.chance(0.75)) add(step, "[general-land]");
  }

  void draw_later() {
    static const std::vector<std::string> kPlacements{"",     "first",   "last",
                                                      "best", "in-time", "tour"};
    const std::size_t who = any();
    Step& step =
        begin_mission(who, "later-" + std::to_string(++later_), random_.uniform(45, kLatest));
    step.placement = kPlacements[random_.below(kPlacements.size())];
    if (kinds_.changes && random_.chance(0.3)) step.placement = "first, interrupt: true";
    add(step, a_task(who));
  }

  // ---- who acts meanwhile ----

  void act(const std::string& name, const std::string& when, double after,
           const std::string& action) {
    add_action(mission_, name, when, after, action);
  }

  std::string at_any_time() { return "{time: " + whole(random_.uniform(15, kLatest)) + "}"; }

  void draw_operators() {
    if (kinds_.changes && random_.chance(0.3)) draw_cancellation();
    if (kinds_.degrees && random_.chance(0.3)) draw_degree();
    if (kinds_.degrees && random_.chance(0.3)) draw_hand();
  }

  void draw_cancellation() {
    const auto asked = std::count_if(mission_.steps.begin(), mission_.steps.end(),
                                     [](const Step& one) { return !one.tasks.empty(); });
    if (asked == 0) return;
    const Step& step = mission_.steps[random_.below(static_cast<std::size_t>(asked))];
    const Task& task = step.tasks[random_.below(step.tasks.size())];
    const std::string interrupt = random_.chance(0.5) ? ", interrupt: true" : "";
    act("cancel", at_any_time(), 0,
        "cancel: {uav: " + step.uav + ", goals: [" + std::to_string(task.id) + "]" + interrupt +
            "}");
  }

  void draw_degree() {
    const std::size_t who = any();
    const std::string uav = "uav: " + mission_.team[who].name;
    const std::string to = std::to_string(1 + random_.below(3));
    const std::string interrupt = random_.chance(0.5) ? ", interrupt: true" : "";
    act("down", at_any_time(), 0, "degree: {" + uav + ", to: " + to + interrupt + "}");
    act("up", "{degree: {" + uav + ", is: " + to + "}}", random_.uniform(5, 120),
        "degree: {" + uav + ", to: " + std::to_string(mission_.team[who].degree) +
            ", resume: true}");
  }

  // An operator takes a vehicle in hand, and gives it back.
  void draw_hand() {
    const std::string uav = "uav: " + mission_.team[any()].name;
    const std::string interrupt = random_.chance(0.6) ? ", interrupt: true" : "";
    act("mine", at_any_time(), 0, "take_in_hand: {" + uav + interrupt + "}");
    act("yours", "{step: mine}", random_.uniform(10, 120), "give_back: {" + uav + "}");
  }

  // ---- what goes wrong ----

  void draw_air() {
    for (std::size_t n = random_.below(3); n > 0; --n) {
      const double x = random_.uniform(50, 400), y = random_.uniform(0, 400);
      const double half = random_.uniform(15, 60);
      const std::string volume = "polygon: " + rectangle(x, y, half, half) +
                                 ", floor: 0, ceiling: " + whole(random_.uniform(40, 150));
      if (random_.chance(0.5)) {
        mission_.volumes.push_back("V" + std::to_string(n) + ": {" + volume + "}");
      } else {
        act("close-" + std::to_string(n), at_any_time(), 0,
            "close_air: {name: smoke-" + std::to_string(n) + ", " + volume + "}");
      }
    }
  }

  void draw_faults() {
    for (std::size_t n = 1 + random_.below(2); n > 0; --n) {
      const std::size_t who = any();
      const std::string& name = mission_.team[who].name;
      mission_.faults.push_back(
          random_.chance(0.2)
              ? draw_refusals(random_, name, kLatest)
              : draw_fault(
                    random_, name, [&](Random&) { return models_[who].device; }, kLatest));
    }
  }

  Random random_;
  Kinds kinds_;
  Mission mission_;
  std::vector<Model> models_;  ///< of each of the team
  int given_ = 0, later_ = 0;
};

}  // namespace

Mission generate_mixed(std::uint64_t seed, const Kinds& kinds) {
  return MixedDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
