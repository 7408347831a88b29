// SPDX-License-Identifier: Apache-2.0
// Teams at degree 5 with a global mission.
#include <cmath>
#include <map>

#include "parts.hpp"
#include "skein/mission_lab/generate.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kLatest = 250;  ///< of troubles [s]

class TeamDrawing {
 public:
  TeamDrawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random team mission"),
        policies_(seed, "contact-loss policies of a team"),
        delays_(seed, "delays of a team"),
        lasting_(seed, "lasting cuts of a team"),
        bounds_(seed, "times between tasks of a team"),
        abilities_(seed, "what tasks of a team need"),
        losses_(seed, "who of a team is declared lost"),
        kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    mission_.limit = 1500;
    mission_.finish_after = 60;
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + tenths(random_.uniform(0, 3)) + ", gusts: 0.3";
    draw_uavs();
    for (std::size_t n = 2 + random_.below(4); n > 0; --n) draw_task();
    if (kinds_.radio) mission_.cuts = draw_cuts(random_, mission_.team, 4, kLatest);
    if (kinds_.radio && lasting_.chance(0.25)) draw_lasting_cuts();
    if (kinds_.degrees && random_.chance(0.4)) draw_degree();
    if (kinds_.faults && random_.chance(0.3)) {
      mission_.faults.push_back(draw_refusals(random_, any().name, kLatest));
    }
    if (kinds_.faults) draw_delays();
    if (kinds_.deaths) draw_deaths();
    if (kinds_.faults && losses_.chance(0.3)) draw_loss();
    return std::move(mission_);
  }

 private:
  const Member& any() { return mission_.team[random_.below(mission_.team.size())]; }

  void draw_uavs() {
    const std::size_t count = 2 + random_.below(3);
    for (std::size_t i = 0; i < count; ++i) {
      Member one;
      one.name = "uav" + std::to_string(i + 1);
      one.model = random_.chance(0.7) ? "marvin" : "heliv";
      one.more = "start: " + point(60.0 * static_cast<double>(i), -60 * random_.uniform(0, 2));
      one.altitude = 35 + 20.0 * static_cast<double>(i);
      one.first_id = 100 * static_cast<int>(i + 1);
      draw_policy(one);
      payloads_[one.name] = static_cast<int>(abilities_.below(5));
      one.more += ", abilities: {payload: " + std::to_string(payloads_.at(one.name)) + "}";
      mission_.team.push_back(std::move(one));
    }
  }

  // From a sequence of its own, so that missions of old seeds stay what they were but for it.
  void draw_policy(Member& one) {
    if (!kinds_.radio || !policies_.chance(0.25)) return;
    one.more += contact_loss(policies_.chance(0.5) ? "hold" : "return", 15);
  }

  // One is cut off from another, or from everybody, to the end. From a sequence of its own.
  void draw_lasting_cuts() {
    const std::string one = mission_.team[lasting_.below(mission_.team.size())].name;
    std::vector<std::string> others{"ground"};
    for (const Member& member : mission_.team)
      if (member.name != one) others.push_back(member.name);
    if (lasting_.chance(0.5)) others = {others[lasting_.below(others.size())]};
    const std::string times =
        ", from: " + whole(lasting_.uniform(10, kLatest)) + ", until: " + whole(mission_.limit);
    for (const std::string& other : others)
      mission_.cuts.push_back("{between: [" + one + ", " + other + "]" + times + "}");
  }

  void draw_task() {
    const std::string number = std::to_string(mission_.global.size() + 1);
    const std::string id = std::to_string(10 + mission_.global.size() + 1);
    mission_.places.push_back("P" + number + ": [" + whole(random_.uniform(-100, 400)) + ", " +
                              whole(random_.uniform(-100, 400)) + ", 0]");
    std::string task = "{id: " + id + ", task: ";
    if (random_.chance(0.7)) {
      task += "[perceive, P" + number + ", " + whole(random_.uniform(5, 40)) + "]";
    } else {
      task += "[general-gotoxyz, P" + number + "]";
    }
    if (!mission_.global.empty() && random_.chance(0.2)) {
      task += ", after: [" + draw_before(std::to_string(10 + mission_.global.size())) + "]";
    }
    const std::string by = random_.chance(0.15) ? any().name : "";
    if (!by.empty()) task += ", by: " + by;
    mission_.global.push_back(task + draw_needs(by) + "}");
  }

  // Half of them with bounds, wide enough for most ways. From a sequence of its own.
  std::string draw_before(const std::string& first) {
    if (!bounds_.chance(0.5)) return first;
    const double least = bounds_.chance(0.7) ? std::round(bounds_.uniform(0, 60)) : 0;
    std::string bounds = "{task: " + first + ", least: " + whole(least);
    if (bounds_.chance(0.7)) bounds += ", most: " + whole(least + bounds_.uniform(60, 300));
    return bounds + "}";
  }

  // What one of them has, at least: who it is pinned to, if there is one.
  std::string draw_needs(const std::string& by) {
    if (!abilities_.chance(0.3)) return "";
    const std::string& uav = mission_.team[abilities_.below(mission_.team.size())].name;
    const int payload = payloads_.at(by.empty() ? uav : by);
    const bool hovers = abilities_.chance(0.3);
    return ", needs: [" + std::string(hovers ? "hovering, " : "") +
           "\"payload >= " + std::to_string(payload) + "\"]";
  }

  // Down, and after a while up again.
  void draw_degree() {
    const std::string uav = any().name;
    const std::string to = std::to_string(2 + random_.below(3));
    Step down;
    down.name = "down";
    down.when = "{time: " + whole(random_.uniform(15, 120)) + "}";
    down.action = "degree: {uav: " + uav + ", to: " + to + "}";
    Step back;
    back.name = "back";
    back.when = "{degree: {uav: " + uav + ", is: " + to + "}}";
    back.after = std::round(random_.uniform(20, 120));
    back.action = "degree: {uav: " + uav + ", to: 5, resume: true}";
    mission_.steps = {down, back};
  }

  // Some fly slowly for a while, some against a wind that is felt. From a sequence of its own.
  void draw_delays() {
    if (delays_.chance(0.2)) {
      mission_.wind = "toward: " + tenths(delays_.uniform(0, 6.2)) +
                      ", speed: " + tenths(delays_.uniform(3, 6)) + ", gusts: 1";
    }
    for (std::size_t n = delays_.below(3); n > 0; --n) {
      const std::string& uav = mission_.team[delays_.below(mission_.team.size())].name;
      mission_.faults.push_back("{at: " + whole(delays_.uniform(15, 120)) + ", slow: {uav: " + uav +
                                ", factor: " + tenths(delays_.uniform(2, 8)) +
                                ", for: " + whole(delays_.uniform(60, 250)) + "}}");
    }
  }

  void draw_deaths() {
    std::vector<std::string> daemons{"ground"};
    for (const Member& one : mission_.team) daemons.push_back(one.name);
    for (std::size_t n = random_.below(3); n > 0; --n) {
      mission_.faults.push_back(draw_death(random_, daemons, kLatest));
    }
  }

  // The operator says that one is lost, by mistake or while it is cut off, and mostly takes it
  // back: then there is more to do. From a sequence of its own.
  void draw_loss() {
    const std::string& uav = mission_.team[losses_.below(mission_.team.size())].name;
    const double lost = losses_.uniform(15, 150), found = lost + losses_.uniform(10, 150);
    if (kinds_.radio && losses_.chance(0.5)) {
      std::vector<std::string> others{"ground"};
      for (const Member& member : mission_.team)
        if (member.name != uav) others.push_back(member.name);
      const std::string times = ", from: " + whole(std::max(5.0, lost - 30)) +
                                ", until: " + whole(lost + losses_.uniform(5, 200));
      for (const std::string& other : others)
        mission_.cuts.push_back("{between: [" + uav + ", " + other + "]" + times + "}");
    }
    add_action(mission_, "lost", "{time: " + whole(lost) + "}", 0,
               "declare_lost: {uav: " + uav + "}");
    if (losses_.chance(0.15)) return;
    add_action(mission_, "found", "{time: " + whole(found) + "}", 0,
               "declare_found: {uav: " + uav + "}");
    add_action(mission_, "more", "{time: " + whole(found + losses_.uniform(5, 90)) + "}", 0,
               "global_mission: {id: 2, tasks: [{id: 61, task: [perceive, P1, 10]" +
                   (losses_.chance(0.5) ? ", by: " + uav : std::string()) + "}]}");
  }

  Random random_;
  Random policies_;
  Random delays_;
  Random lasting_;
  Random bounds_;
  Random abilities_;
  Random losses_;
  std::map<std::string, int> payloads_;  ///< [kg]
  Kinds kinds_;
  Mission mission_;
};

}  // namespace

Mission generate_team(std::uint64_t seed, const Kinds& kinds) {
  return TeamDrawing(seed, kinds).draw();
}

}  // namespace skein::mission_lab
