// SPDX-License-Identifier: Apache-2.0
// An operator with much to do: flies UAVs by hand in the middle of their tasks and gives them back,
// stops them to think, gives tasks to those who plan for themselves, closes and opens air.
#include <algorithm>
#include <array>

#include "parts.hpp"
#include "skein/foundation/joined.hpp"

namespace skein::mission_lab {

namespace {

constexpr double kBusyFrom = 60, kBusyUntil = 1100;  // [s] of what begins by itself
constexpr int kFirstByHand = 500;                    // number of elementary tasks

class BusyOperator {
 public:
  explicit BusyOperator(Mission& mission)
      : random_(mission.seed, "busy operator"), mission_(mission) {}

  void draw() {
    const std::vector<Step> given = mission_.steps;
    for (const Member& one : std::vector<Member>(mission_.team)) {
      if (random_.chance(0.35)) continue;
      draw_moment(one, given);
      draw_story(one);
    }
    for (std::size_t n = random_.below(3); n > 0; --n) draw_air();
    if (random_.chance(0.3)) move_a_place();
    if (random_.chance(0.25) && mission_.radio.empty()) mission_.radio.push_back("capacity: 9600");
  }

 private:
  // Half of it by the script, half by a person.
  void act(double after, std::string action) {
    const std::string name = "busy-" + std::to_string(++acts_);
    add_action(mission_, name, when_, after, std::move(action));
    mission_.steps.back().by_operator = random_.chance(0.5);
    when_ = (mission_.steps.back().by_operator ? "{operator: " : "{step: ") + name + "}";
  }

  // In the middle of one of its goals, or at any time.
  void draw_moment(const Member& one, const std::vector<Step>& given) {
    const std::string by_clock = "{time: " + whole_between(random_, kBusyFrom, kBusyUntil) + "}";
    when_ = by_clock;
    if (random_.chance(0.4)) return;
    for (const Step& step : given) {
      if (step.uav != one.name || step.tasks.empty()) continue;
      const int goal = step.tasks[random_.below(step.tasks.size())].id;
      when_ = "{any: [{goal: {uav: " + one.name + ", id: " + std::to_string(goal) +
              ", state: under-way}}, " + by_clock + "]}";
    }
  }

  void draw_story(const Member& one) {
    switch (random_.below(5)) {
      case 0:
        return look_aside(one);
      case 1:
        return think(one);
      case 2:
        return call_off(one);
      case 3:
        return hand_over_unheard(one);
      default:
        return fly_beside(one);
    }
  }

  // ---- single UAVs ----

  void look_aside(const Member& one) {
    const std::string uav = "uav: " + one.name;
    act(random_.uniform(0, 30), "take_in_hand: {" + uav + maybe_interrupt() + "}");
    act(random_.uniform(1, 15), by_hand(one, "VUT"));
    const std::string done =
        "{task: {" + uav + ", id: " + std::to_string(last_) + ", state: ended}}";
    when_ = "{any: [" + done + ", {all: [" + when_ + ", {time: " + whole(kBusyUntil) + "}]}]}";
    act(random_.uniform(0, 10), random_.chance(0.5) ? "give_back: {" + uav + "}" : back(one));
  }

  // It waits until it is told to go on.
  void think(const Member& one) {
    const std::string uav = "uav: " + one.name, word = "on-" + std::to_string(++words_);
    act(0, lower(one));
    act(random_.uniform(2, 20), "plan: {" + uav + ", tasks: [{id: " + next_id() +
                                    ", type: wait, mode: VUT, exit: [[{message: " + word +
                                    "}]]}]}");
    act(random_.uniform(20, 200), random_.chance(0.6) ? "message: {" + uav + ", text: " + word + "}"
                                                      : "abort: {" + uav + ", tasks: all}");
    act(random_.uniform(1, 60), back(one));
  }

  void call_off(const Member& one) {
    act(0, lower(one));
    act(random_.uniform(3, 15), "abort: {uav: " + one.name + "}");
    if (random_.chance(0.6)) act(random_.uniform(3, 30), by_hand(one, "VUT"));
    act(random_.uniform(5, 120), back(one));
  }

  // What it hands over does not come through.
  void hand_over_unheard(const Member& one) {
    const double at = random_.uniform(kBusyFrom, kBusyUntil);
    when_ = "{time: " + whole(at) + "}";
    mission_.cuts.push_back("{one_way: [" + one.name + ", ground], from: " + whole(at + 1) +
                            ", until: " + whole(at + random_.uniform(30, 200)) + "}");
    act(0, "take_in_hand: {uav: " + one.name + maybe_interrupt() + "}");
    if (random_.chance(0.4)) act(random_.uniform(2, 20), by_hand(one, "VUT"));
    act(random_.uniform(10, 90), back(one));
    act(random_.uniform(60, 200), back(one));
  }

  // Without being taken in hand.
  void fly_beside(const Member& one) {
    static constexpr std::array kModes{"VUT", "DEP", "NUT"};
    act(random_.uniform(0, 40), by_hand(one, kModes[random_.below(kModes.size())]));
    if (random_.chance(0.5))
      act(random_.uniform(3, 90),
          "abort: {uav: " + one.name + ", tasks: [" + std::to_string(last_) + "]}");
  }

  std::string maybe_interrupt() { return random_.chance(0.5) ? ", interrupt: true" : ""; }

  std::string lower(const Member& one) {
    const std::string to = std::to_string(1 + random_.below(3));
    return "degree: {uav: " + one.name + ", to: " + to + ", interrupt: true}";
  }

  static std::string back(const Member& one) {
    return "degree: {uav: " + one.name +
           ", to: " + std::to_string(one.degree == 0 ? 4 : one.degree) + "}";
  }

  std::string next_id() {
    last_ = kFirstByHand + tasks_++;
    return std::to_string(last_);
  }

  // Way-points, waits and looks, one after the other.
  std::string by_hand(const Member& one, const std::string& first) {
    std::vector<std::string> tasks;
    for (std::size_t n = 1 + random_.below(3); n > 0; --n) {
      const std::string mode = tasks.empty() ? first : random_.chance(0.5) ? "DEP" : "NUT";
      const std::string what = a_task_by_hand(one, mode);
      tasks.push_back("{id: " + next_id() + ", " + what + "}");
    }
    return "plan: {uav: " + one.name + ", tasks: [" + joined(tasks, ", ") + "]}";
  }

  std::string a_task_by_hand(const Member& one, const std::string& mode) {
    switch (random_.below(one.device.empty() ? 2 : 4)) {
      case 0:
        return "type: wait, mode: " + mode +
               ", params: {duration: " + whole_between(random_, 5, 90) + "}";
      case 1: {
        std::vector<std::string> ways;
        for (std::size_t n = 1 + random_.below(3); n > 0; --n)
          ways.push_back("[" + whole_between(random_, -200, 700) + ", " +
                         whole_between(random_, -200, 500) + ", " + whole(one.altitude + 60) + "]");
        return "type: goto, mode: " + mode + ", params: {to: [" + joined(ways, ", ") + "]}";
      }
      default: {
        const auto [x, y] = draw_place_of(random_, mission_);
        return "type: perceive, mode: " + mode + ", params: {device: " + one.device +
               ", target: [" + whole(x) + ", " + whole(y) +
               ", 0], duration: " + whole_between(random_, 10, 60) + "}";
      }
    }
  }

  // ---- what all are told ----

  void draw_air() {
    const auto [x, y] = draw_place_of(random_, mission_);
    const std::string air = "{name: tfr-" + std::to_string(++closings_);
    when_ = "{time: " + whole_between(random_, kBusyFrom, kBusyUntil) + "}";
    act(0, "close_air: " + air + ", " + draw_box(random_, x, y) + "}");
    act(random_.uniform(20, 400), "open_air: " + air + "}");
    if (random_.chance(0.3)) act(random_.uniform(20, 200), "open_air: " + air + "}");
  }

  void move_a_place() {
    for (const std::string& place : std::vector<std::string>(mission_.places)) {
      const std::size_t colon = place.find(':');
      if (!place.starts_with('P') || colon == std::string::npos) continue;
      const auto [x, y] = point_in(place);
      when_ = "{time: " + whole_between(random_, kBusyFrom, kBusyUntil) + "}";
      return act(0, "know_place: {name: " + place.substr(0, colon) + ", at: [" +
                        whole(x + random_.uniform(-100, 100)) + ", " +
                        whole(y + random_.uniform(-100, 100)) + ", 0]}");
    }
  }

  Random random_;
  Mission& mission_;
  std::string when_;  ///< of what is done next
  int acts_ = 0, words_ = 0, tasks_ = 0, last_ = 0, closings_ = 0;
};

}  // namespace

void keep_an_operator_busy(Mission& mission) { BusyOperator(mission).draw(); }

}  // namespace skein::mission_lab
