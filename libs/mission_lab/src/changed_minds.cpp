// SPDX-License-Identifier: Apache-2.0
// People who change their minds: missions are cancelled and given again, UAVs taken in hand and
// given back in every order, and places turn out to lie elsewhere.
#include <algorithm>
#include <array>
#include <cstdio>

#include "parts.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kFirst = 60, kLast = 1200;  // [s] of what begins by itself

class ChangedMinds {
 public:
  explicit ChangedMinds(Mission& mission)
      : random_(mission.seed, "changed minds"), mission_(mission) {}

  void draw() {
    const std::size_t given = mission_.steps.size();
    for (std::size_t i = 0; i < given; ++i)
      if (!mission_.steps[i].tasks.empty() && random_.chance(0.4)) give_again(i);
    for (const Member& one : mission_.team)
      if (random_.chance(0.5)) take_in_hand(one);
    for (const std::string& place : std::vector<std::string>(mission_.places))
      if (random_.chance(0.25)) move(place);
  }

 private:
  std::string act(double after, std::string action) {
    const std::string name = "minds-" + std::to_string(++acts_);
    add_action(mission_, name, when_, after, std::move(action));
    when_ = "{step: " + name + "}";
    return name;
  }
  void at_any_time() { when_ = "{time: " + whole_between(random_, kFirst, kLast) + "}"; }

  // Once or twice; with ids of their own, since those that are cancelled are not free.
  void give_again(std::size_t index) {
    at_any_time();
    for (std::size_t n = 1 + random_.below(2); n > 0; --n) {
      Step again = mission_.steps[index];
      const std::string uav = "uav: " + again.uav;
      const std::string what =
          random_.chance(0.5) ? "goals: all" : "mission: " + std::to_string(again.mission);
      act(0, "cancel: {" + uav + ", " + what + (random_.chance(0.5) ? ", interrupt: true}" : "}"));
      again.name = "again-" + std::to_string(++acts_);
      again.when = when_;
      again.after = random_.uniform(0, 60);
      again.mission = 9000 + acts_;
      again.evaluate = false;
      for (Task& task : again.tasks) {
        task.id = 90'000 + ++goals_;
        task.times.clear();
      }
      when_ = "{step: " + again.name + "}";
      mission_.steps.push_back(std::move(again));
    }
  }

  void take_in_hand(const Member& one) {
    static constexpr std::array kActions{"give_back: {", "resume_plan: {", "drop_plan: {",
                                         "abort: {tasks: all, ", "cancel: {goals: all, "};
    const std::string uav = "uav: " + one.name;
    const std::string interrupt = random_.chance(0.5) ? ", interrupt: true}" : "}";
    at_any_time();
    act(0, "take_in_hand: {" + uav + interrupt);
    for (std::size_t n = 1 + random_.below(5); n > 0; --n) {
      const std::size_t drawn = random_.below(kActions.size() + 1);
      act(random_.uniform(0, 90), drawn < kActions.size()
                                      ? kActions[drawn] + uav + "}"
                                      : draw_degree(uav, std::max(one.degree, 4)));
    }
    act(random_.uniform(5, 120), "give_back: {" + uav + "}");
    act(random_.uniform(5, 120),
        "degree: {" + uav + ", to: " + std::to_string(std::max(one.degree, 2)) + "}");
  }

  std::string draw_degree(const std::string& uav, int most) {
    const std::string to = std::to_string(1 + random_.below(static_cast<std::size_t>(most)));
    return "degree: {" + uav + ", to: " + to + (random_.chance(0.5) ? ", interrupt: true" : "") +
           (random_.chance(0.3) ? ", resume: false}" : "}");
  }

  // Not homes: who lives there knows where it is.
  void move(const std::string& place) {
    double x = 0, y = 0;
    const std::size_t colon = place.find(':');
    const bool is_place = place.starts_with('P') && colon != std::string::npos &&
                          std::sscanf(place.c_str() + colon, ": [%lf, %lf", &x, &y) == 2;
    if (!is_place) return;
    at_any_time();
    act(0, "know_place: {name: " + place.substr(0, colon) + ", at: [" +
               whole(x + random_.uniform(-120, 120)) + ", " +
               whole(y + random_.uniform(-120, 120)) + ", 0]}");
  }

  Random random_;
  Mission& mission_;
  std::string when_;  ///< of what is done next
  int acts_ = 0, goals_ = 0;
};

}  // namespace

void change_minds(Mission& mission) { ChangedMinds(mission).draw(); }

}  // namespace skein::mission_lab
