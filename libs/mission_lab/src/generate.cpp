// SPDX-License-Identifier: Apache-2.0
#include "skein/mission_lab/generate.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "parts.hpp"
#include "skein/foundation/random.hpp"

namespace skein::mission_lab {

namespace {

/// Draws one mission, part by part, always in the same order.
class Drawing {
 public:
  Drawing(std::uint64_t seed, const Kinds& kinds)
      : random_(seed, "random mission"),
        more_(seed, "random mission: alarms, bounds"),
        last_(seed, "random mission: questions, refusals"),
        joint_(seed, "random mission: joint tasks"),
        amid_(seed, "random mission: amid a mapping"),
        kinds_(kinds) {
    mission_.seed = seed;
  }

  Mission draw() {
    draw_ground();
    draw_team();
    for (const Member& one : mission_.team) {
      const bool at_start = random_.chance(0.7);
      begin_mission("first-" + one.name, one, "{time: " + whole(random_.uniform(2, 12)) + "}",
                    at_start ? 0 : random_.uniform(0, 60));
      draw_tasks(1 + random_.below(4));
    }
    if (mission_.team.size() > 1 && random_.chance(0.6)) draw_meeting();
    finish_first_missions();
    draw_insertions();
    draw_trouble();
    const bool stays = random_.chance(0.15);
    mission_.finish_after = stays ? -1 : random_.uniform(5, 60);
    mission_.limit = stays ? 5000 : 2400;
    if (kinds_.deadlines && more_.chance(0.25)) draw_goal_bound();
    if (kinds_.alarms && more_.chance(0.12)) draw_alarm();
    if (kinds_.questions && last_.chance(0.25)) draw_question();
    if (kinds_.faults && last_.chance(0.08))
      mission_.faults.push_back(
          draw_refusals(last_, mission_.team[last_.below(mission_.team.size())].name, 500));
    if (kinds_.joint && joint_.chance(0.2)) draw_joint();
    if (kinds_.deadlines && amid_.chance(0.4)) draw_amid();
    if (kinds_.deaths) add_deaths(mission_, 600);
    return std::move(mission_);
  }

 private:
  // ---- the world ----

  void draw_ground() {
    const double gusts = random_.chance(0.5) ? 0 : random_.uniform(0, 0.8);
    mission_.wind = "toward: " + tenths(random_.uniform(0, 6.2)) +
                    ", speed: " + (random_.chance(0.4) ? "0" : tenths(random_.uniform(0, 4))) +
                    ", gusts: " + tenths(gusts);
    if (random_.chance(0.3)) {
      mission_.hills =
          "{at: [250, 720], height: 70, radius: 260}, {at: [700, 520], height: 18, radius: 250}";
    }
    for (int i = 1; i <= 3; ++i)
      mission_.zones.push_back("Z" + std::to_string(i) + ": " + draw_zone(random_));
    for (int i = 1; i <= 4; ++i) {
      mission_.places.push_back("P" + std::to_string(i) + ": [" + whole(random_.uniform(30, 550)) +
                                ", " + whole(random_.uniform(-100, 450)) + ", 0]");
    }
    for (int i = 1; i <= 3; ++i) {
      mission_.places.push_back("A" + std::to_string(i) + ": [" + whole(random_.uniform(30, 550)) +
                                ", " + whole(random_.uniform(-100, 450)) + ", " +
                                whole(random_.uniform(75, 130)) + "]");
    }
  }

  void draw_team() {
    const std::vector<Member> all{{"marvin", "marvin", "start: [0, 0]", 40, 100},
                                  {"heliv", "heliv", "start: [-40, 40]", 60, 1100},
                                  {"karma", "karma", "start: [0, -100]", 90, 2100},
                                  {"marvin2", "marvin", "start: [-60, -40]", 75, 3100}};
    const std::size_t count = 1 + random_.below(4);
    std::vector<Member> left = all;
    while (mission_.team.size() < count) {
      const std::size_t i = random_.below(left.size());
      Member one = left[i];
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
      if (kinds_.energy && random_.chance(0.12))
        one.more += ", energy: " + hundredths(random_.uniform(0.12, 0.5));
      if (kinds_.radio && random_.chance(0.3)) {
        one.more += contact_loss(random_.chance(0.5) ? "hold" : "return", 60);
      }
      next_goal_.push_back(700 + 1000 * static_cast<int>(mission_.team.size()));
      mission_.team.push_back(std::move(one));
    }
  }

  // ---- high-level tasks ----

  const Member& member() const { return mission_.team[who_]; }

  void begin_mission(const std::string& name, const Member& one, const std::string& when,
                     double after) {
    who_ = static_cast<std::size_t>(&one - mission_.team.data());
    Step step;
    step.name = name;
    step.when = when;
    step.after = std::round(after);
    step.uav = one.name;
    step.mission = ++missions_[who_];
    mission_.steps.push_back(std::move(step));
  }

  void add(const std::string& words) { add_to(mission_.steps.back(), who_, words); }
  void add_to(Step& step, std::size_t who, const std::string& words) {
    Task task{next_goal_[who]++, words, ""};
    if (kinds_.deadlines && random_.chance(0.18)) task.times = draw_times(random_);
    step.tasks.push_back(std::move(task));
  }

  std::string on_ground() { return "P" + std::to_string(1 + random_.below(4)); }
  std::string in_air() { return "A" + std::to_string(1 + random_.below(3)); }
  std::string any_place() { return random_.chance(0.65) ? on_ground() : in_air(); }
  std::string zone() { return "Z" + std::to_string(1 + random_.below(3)); }
  // Every fourth may be shorter.
  std::string seconds() {
    const double most = std::round(random_.uniform(5, 120));
    return std::lround(most) % 4 == 0 ? whole(most / 2) + ".." + whole(most) : whole(most);
  }
  std::string places() {
    std::string list;
    for (std::size_t left = 2 + random_.below(3); left > 0; --left)
      list += (list.empty() ? "" : ", ") + any_place();
    return "[" + list + "]";
  }

  void draw_tasks(std::size_t count) {
    if (random_.chance(0.4)) add("[general-takeoff]");
    for (; count > 0; --count) draw_task();
    if (random_.chance(0.5)) add("[general-land]");
  }

  void draw_task() {
    const bool maps = member().model == "karma";
    switch (random_.below(maps ? 11 : 10)) {
      case 0:
        return add("[general-gotoxyz, " + any_place() + "]");
      case 1:
        return add("[general-combined-goto-and-takeshot, " + any_place() + ", " + seconds() + "]");
      case 2:
      case 3:
        return add("[perceive, " + any_place() + ", " + seconds() + "]");
      case 4:
        return add("[perform-detection, " + zone() + ", " + any_place() + ", " +
                   whole(random_.uniform(60, 300)) + "]");
      case 5:
        return add("[perform-tour, " + places() + "]");
      case 6:
        return add("[perform-monitoring, " + on_ground() + ", " + whole(random_.uniform(30, 200)) +
                   "]");
      case 7:
        return add("[takeshot-while-waiting, " + seconds() + "]");
      case 8:
        return add("[general-wait, " + seconds() + "]");
      case 9:
        return random_.chance(0.4) ? add("[general-land]")
                                   : add("[general-gotoxyz, " + in_air() + "]");
      default:
        return add("[perform-mapping, " + zone() + "]");
    }
  }

  // ---- together ----

  // All of some team have it in their first missions, in one order, so that nobody waits for ever.
  void draw_meeting() {
    std::vector<std::size_t> team(mission_.team.size());
    for (std::size_t i = 0; i < team.size(); ++i) team[i] = i;
    while (team.size() > 2 && random_.chance(0.5))
      team.erase(team.begin() + static_cast<std::ptrdiff_t>(random_.below(team.size())));
    std::string names;
    for (const std::size_t i : team) names += (names.empty() ? "" : ", ") + mission_.team[i].name;
    names = "[" + names + "]";
    const bool absent = kinds_.changes && random_.chance(0.1);  // one never comes
    switch (random_.below(team.size() > 2 ? 4 : 3)) {
      case 0:
        return for_each(team, absent, [&](std::size_t) {
          return "[wait-until-synchro, 500, " + names + ", " + names + "]";
        });
      case 1:
        return for_each(team, absent, [&](std::size_t) {
          return "[synchro, 500, " + names + ", " + names + "]";
        });
      case 2: {
        const std::string place = any_place(), time = seconds();
        return for_each(team, absent, [&](std::size_t) {
          return "[general-combined-goto-and-synchro-and-takeshot, 500, " + names + ", " + names +
                 ", " + place + ", " + time + "]";
        });
      }
      default:
        return monitor_until(team, absent);
    }
  }

  template <class Words>
  void for_each(const std::vector<std::size_t>& team, bool absent, const Words& words) {
    for (const std::size_t i : team) {
      if (absent && i == team.back()) continue;
      add_to(mission_.steps[i], i, words(i));
    }
  }

  // The last of the team signals the end to the others.
  void monitor_until(std::vector<std::size_t> team, bool absent) {
    const std::size_t signaller = team.back();
    team.pop_back();
    const std::string place = on_ground();
    std::string names;
    for (const std::size_t i : team) names += (names.empty() ? "" : ", ") + mission_.team[i].name;
    for (const std::size_t i : team) {
      std::string others;
      for (const std::size_t j : team) {
        if (j != i) others += (others.empty() ? "" : ", ") + mission_.team[j].name;
      }
      add_to(mission_.steps[i], i,
             "[monitor-until, " + place + ", 501, [" + others + "], 502, " +
                 mission_.team[signaller].name + "]");
    }
    if (!absent)
      add_to(mission_.steps[signaller], signaller, "[send-signal, 502, [" + names + "]]");
  }

  void finish_first_missions() {
    for (std::size_t i = 0; i < mission_.team.size(); ++i) {
      who_ = i;
      Step& step = mission_.steps[i];
      if (random_.chance(0.5))
        add_to(step, i, "[general-land]");
      else if (random_.chance(0.15))
        add_to(step, i, "[wait-for-orders]");
    }
  }

  // ---- later ----

  std::string draw_trigger(std::size_t who) {
    if (random_.chance(0.5)) return "{time: " + whole(random_.uniform(15, 500)) + "}";
    const Step& first = mission_.steps[who];
    const Task& task = first.tasks[random_.below(first.tasks.size())];
    const char* state = random_.chance(0.5) ? "under-way" : "achieved";
    return "{goal: {uav: " + first.uav + ", id: " + std::to_string(task.id) + ", state: " + state +
           "}}";
  }

  void draw_insertions() {
    for (std::size_t left = random_.below(4), n = 0; n < left; ++n) {
      const std::size_t who = random_.below(mission_.team.size());
      const std::string when = draw_trigger(who);
      begin_mission("later-" + std::to_string(n + 1), mission_.team[who], when,
                    random_.uniform(0, 90));
      const std::vector<std::string> placements{"best", "last", "in-time", "tour", "first"};
      std::string placement = placements[random_.below(placements.size())];
      if (placement == "first" && kinds_.changes && random_.chance(0.5))
        placement += ", interrupt: true";
      mission_.steps.back().placement = placement;
      draw_tasks(1 + random_.below(2));
    }
  }

  // ---- drawn by themselves, so that all the rest of a seed's mission is as it is without ----

  // A task of a mission is bounded by one before it in the same mission.
  void draw_goal_bound() {
    Step& step = mission_.steps[more_.below(mission_.steps.size())];
    if (step.tasks.size() < 2) return;
    const std::size_t later = 1 + more_.below(step.tasks.size() - 1);
    const Task& earlier = step.tasks[more_.below(later)];
    const double least = more_.uniform(0, 120);
    std::string figures = ", least: " + whole(least);
    if (more_.chance(0.6)) figures += ", most: " + whole(least + more_.uniform(30, 600));
    std::string& times = step.tasks[later].times;
    times += std::string(times.empty() ? "" : ", ") +
             (more_.chance(0.5) ? "start_after_goal" : "end_after_goal") +
             ": {goal: " + std::to_string(earlier.id) + figures + "}";
  }

  // Something burns in a zone that somebody looks over; somebody is to look at the alarm.
  void draw_alarm() {
    double x = 0, y = 0;
    const std::size_t zone = more_.below(mission_.zones.size());
    const std::string& corners = mission_.zones[zone];
    for (std::size_t at = corners.find("[[") + 1; at != std::string::npos;
         at = corners.find('[', at + 1)) {
      x += std::stod(corners.substr(at + 1)) / 4;
      y += std::stod(corners.substr(corners.find(',', at) + 1)) / 4;
    }
    mission_.objects.push_back("hot: {kind: fire, position: " + point(x, y) + ", radius: 5}");
    const std::size_t looks = more_.below(mission_.team.size());
    auto& first = mission_.steps[looks].tasks;
    const bool takes_off = first.front().words == "[general-takeoff]";
    first.insert(first.begin() + (takes_off ? 1 : 0),
                 {next_goal_[looks]++,
                  "[perform-detection, Z" + std::to_string(zone + 1) + ", P1, " +
                      whole(more_.uniform(100, 300)) + "]",
                  ""});
    const std::size_t goes = more_.below(mission_.team.size());
    const char* placement = more_.chance(0.3) ? "first" : "best";
    begin_mission("alarm-1", mission_.team[goes], "{alarm: {state: raised, id: 1}}", 1);
    mission_.steps.back().placement = placement;
    mission_.steps.back().tasks.push_back(
        {next_goal_[goes]++, "[perceive, alarm:1, " + whole(more_.uniform(10, 90)) + "]", ""});
  }

  // What would a mission take? Then it is given, whatever the answer.
  void draw_question() {
    const std::size_t who = last_.below(mission_.team.size());
    const Member& one = mission_.team[who];
    const std::string when = "{time: " + whole(last_.uniform(15, 500)) + "}";
    const std::vector<std::string> placements{"best", "last", "last", "first"};
    const std::string placement = placements[last_.below(placements.size())];
    begin_mission("ask", one, when, 0);
    std::vector<Task> tasks;
    for (std::size_t left = 1 + last_.below(2); left > 0; --left)
      tasks.push_back({next_goal_[who]++, draw_question_task(last_), ""});
    Step& asks = mission_.steps.back();
    asks.placement = placement;
    asks.tasks = tasks;
    asks.evaluate = true;
    const std::string answered =
        "{mission: {uav: " + one.name + ", id: " + std::to_string(asks.mission) + ", state: ";
    begin_mission("take", one, "{any: [" + answered + "evaluated}}, " + answered + "refused}}]}",
                  0);
    for (Task& task : tasks) task.id = next_goal_[who]++;
    mission_.steps.back().placement = placement;
    mission_.steps.back().tasks = std::move(tasks);
  }

  // At the end of the first missions of two, so that nobody waits for ever.
  void draw_joint() {
    std::vector<std::size_t> able;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < mission_.team.size() && able.size() < 2; ++i) {
      if (mission_.team[i].model == "karma") continue;  // it does not hover
      able.push_back(i);
      names.push_back(mission_.team[i].name);
    }
    if (able.size() < 2) return;
    const JointTask drawn = draw_joint_task(joint_, names);
    mission_.joint = true;
    mission_.places.insert(mission_.places.end(), drawn.places.begin(), drawn.places.end());
    for (const std::size_t i : able) {
      auto& tasks = mission_.steps[i].tasks;
      const std::string& last = tasks.back().words;
      const bool stays = last != "[general-land]" && last != "[wait-for-orders]";
      tasks.insert(stays ? tasks.end() : tasks.end() - 1, {next_goal_[i]++, drawn.words, ""});
    }
  }

  // A mapping and a look that must be over about when its middle would be, asked for together.
  void draw_amid() {
    for (const Member& one : mission_.team) {
      if (one.model != "karma") continue;
      const double at = amid_.uniform(4, 60);
      begin_mission("amid", one, "{time: " + whole(at) + "}", 0);
      for (const auto& [words, times] : draw_look_amid_mapping(amid_, at))
        mission_.steps.back().tasks.push_back({next_goal_[who_]++, words, times});
    }
  }

  // ---- what goes wrong ----

  Step plain_step(const std::string& name, const std::string& when, const std::string& action) {
    Step step;
    step.name = name;
    step.when = when;
    step.after = std::round(random_.uniform(0, 60));
    step.action = action;
    return step;
  }

  void draw_trouble() {
    if (kinds_.changes && random_.chance(0.25)) draw_cancellation();
    if (kinds_.air && random_.chance(0.25)) draw_closings();
    if (kinds_.air && random_.chance(0.15))
      mission_.volumes.push_back(
          "tower: {" + draw_volume(random_.uniform(100, 450), random_.uniform(100, 350)) + "}");
    if (kinds_.faults && random_.chance(0.3)) draw_fault();
    if (kinds_.degrees && random_.chance(0.15)) draw_degree();
    if (kinds_.radio && random_.chance(0.15)) draw_cut();
  }

  void draw_cancellation() {
    const std::size_t who = random_.below(mission_.team.size());
    const Step& first = mission_.steps[who];
    const Task& task = first.tasks[random_.below(first.tasks.size())];
    const std::string what =
        random_.chance(0.3) ? "mission: 1" : "goals: [" + std::to_string(task.id) + "]";
    const std::string interrupt = random_.chance(0.5) ? ", interrupt: true" : "";
    const std::string action = "cancel: {uav: " + first.uav + ", " + what + interrupt + "}";
    mission_.steps.push_back(plain_step("cancel", draw_trigger(who), action));
  }

  std::string draw_volume(double x, double y) {
    const double a = random_.uniform(30, 90), b = random_.uniform(30, 90);
    std::string text = "polygon: " + rectangle(x, y, a, b);
    if (random_.chance(0.4)) text += ", ceiling: " + whole(random_.uniform(50, 150));
    return text;
  }

  // Half of them where something is to be done.
  void draw_closings() {
    for (std::size_t n = 1 + random_.below(2); n > 0; --n) {
      double x = random_.uniform(80, 500), y = random_.uniform(-50, 400);
      if (random_.chance(0.5)) std::tie(x, y) = draw_place_of(random_, mission_);
      const std::string name = "smoke-" + std::to_string(n);
      const std::size_t who = random_.below(mission_.team.size());
      const std::string volume = draw_volume(x, y);
      mission_.steps.push_back(plain_step("close-" + std::to_string(n), draw_trigger(who),
                                          "close_air: {name: " + name + ", " + volume + "}"));
      if (random_.chance(0.3)) {
        mission_.steps.push_back(plain_step("open-" + std::to_string(n),
                                            "{step: close-" + std::to_string(n) + "}",
                                            "open_air: {name: " + name + "}"));
        mission_.steps.back().after = 100;
      }
    }
  }

  void draw_fault() {
    const Member& one = mission_.team[random_.below(mission_.team.size())];
    mission_.faults.push_back(mission_lab::draw_fault(random_, one, 500));
  }

  void draw_degree() {
    const std::size_t who = random_.below(mission_.team.size());
    const std::string uav = "uav: " + mission_.team[who].name;
    const std::string to = std::to_string(1 + random_.below(3));
    const std::string interrupt = random_.chance(0.5) ? ", interrupt: true" : "";
    mission_.steps.push_back(
        plain_step("down", draw_trigger(who), "degree: {" + uav + ", to: " + to + interrupt + "}"));
    mission_.steps.push_back(plain_step("back", "{degree: {" + uav + ", is: " + to + "}}",
                                        "degree: {" + uav + ", to: 4, resume: true}"));
  }

  void draw_cut() {
    const std::string& one = mission_.team[random_.below(mission_.team.size())].name;
    const std::string other = mission_.team.size() > 1 && random_.chance(0.4)
                                  ? mission_.team[one == mission_.team[0].name ? 1 : 0].name
                                  : "ground";
    mission_.cuts.push_back(mission_lab::draw_cut(random_, one, other, 500));
  }

  Random random_, more_, last_, joint_, amid_;
  Kinds kinds_;
  Mission mission_;
  std::size_t who_ = 0;
  std::vector<int> next_goal_;
  int missions_[4] = {0, 0, 0, 0};
};

}  // namespace

Mission generate(std::uint64_t seed, const Kinds& kinds) { return Drawing(seed, kinds).draw(); }

}  // namespace skein::mission_lab
