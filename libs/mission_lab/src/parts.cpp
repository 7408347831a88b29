// SPDX-License-Identifier: Apache-2.0
#include "parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace skein::mission_lab {

std::string whole(double number) { return std::to_string(std::lround(number)); }

std::string point(double x, double y) { return "[" + whole(x) + ", " + whole(y) + "]"; }

std::string rectangle(double x, double y, double a, double b) {
  return "[" + point(x - a, y - b) + ", " + point(x + a, y - b) + ", " + point(x + a, y + b) +
         ", " + point(x - a, y + b) + "]";
}

std::string whole_between(Random& random, double least, double most) {
  return whole(random.uniform(least, most));
}

std::string draw_length(Random& random) {
  const double least = random.uniform(5, 90);
  return random.chance(0.8) ? whole(least) : whole(least) + ".." + whole(least + 60);
}

std::string contact_loss(const std::string& policy, double after) {
  return ", contact_loss: {policy: " + policy + ", after: " + whole(after) + "}";
}

std::pair<double, double> point_in(const std::string& text) {
  const std::size_t x = text.find('['), y = text.find(',', x);
  return {std::stod(text.substr(x + 1)), std::stod(text.substr(y + 1))};
}

std::pair<double, double> draw_place_of(Random& random, const Mission& mission) {
  return point_in(mission.places[random.below(mission.places.size())]);
}

void add_action(Mission& mission, const std::string& name, const std::string& when, double after,
                std::string action) {
  Step step;
  step.name = name;
  step.when = when;
  step.after = std::round(after);
  step.action = std::move(action);
  mission.steps.push_back(std::move(step));
}

std::string draw_box(Random& random, double x, double y) {
  const double a = random.uniform(20, 90), b = random.uniform(20, 90);
  std::string volume = "polygon: " + rectangle(x, y, a, b);
  if (random.chance(0.3)) volume += ", floor: " + whole_between(random, 20, 80);
  if (random.chance(0.5)) volume += ", ceiling: " + whole_between(random, 90, 180);
  return volume;
}

std::string add_place(Random& random, Mission& mission) {
  const std::string name = "P" + std::to_string(mission.places.size() + 1);
  mission.places.push_back(name + ": [" + whole(random.uniform(-50, 450)) + ", " +
                           whole(random.uniform(-50, 450)) + ", 0]");
  return name;
}

std::size_t member_of(const Mission& mission, const Step& step) {
  const auto one = std::find_if(mission.team.begin(), mission.team.end(),
                                [&](const Member& member) { return member.name == step.uav; });
  return static_cast<std::size_t>(one - mission.team.begin());
}

std::string draw_zone(Random& random) {
  const double x = random.uniform(60, 400), y = random.uniform(-50, 300);
  const double a = random.uniform(70, 220), b = random.uniform(60, 180);
  const double turn = random.uniform(0, 0.5);
  const auto corner = [&](double u, double v) {
    return point(x + u * std::cos(turn) - v * std::sin(turn),
                 y + u * std::sin(turn) + v * std::cos(turn));
  };
  return "[" + corner(0, 0) + ", " + corner(a, 0) + ", " + corner(a, b) + ", " + corner(0, b) + "]";
}

// A fire, the inside of it, and the control centre that is told, as far away as a relay reaches.
JointTask draw_joint_task(Random& random, const std::vector<std::string>& uavs) {
  const double x = random.uniform(40, 450), y = random.uniform(-50, 350);
  JointTask result;
  const auto place = [&](double distance) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    result.places.push_back("J" + std::to_string(result.places.size() + 1) + ": [" +
                            whole(x + distance * std::cos(angle)) + ", " +
                            whole(y + distance * std::sin(angle)) + ", 0]");
  };
  place(0);
  place(random.uniform(20, 40));
  place(random.uniform(60, 110));
  std::string members;
  for (const std::string& one : uavs) members += (members.empty() ? "" : ", ") + one;
  result.words = "[monitoring-with-relay, J1, J2, J3, " + whole(random.uniform(20, 150)) + ", [" +
                 members + "]]";
  return result;
}

std::string draw_times(Random& random) {
  const double from = random.uniform(30, 400);
  switch (random.below(6)) {
    case 0:
      return "start_after: " + whole(from);
    case 1:
      return "end_after: " + whole(from);
    case 2:
      return "start_before: " + whole(from + random.uniform(50, 700));
    case 3:
      return "end_before: " + whole(from + random.uniform(100, 900));
    case 4:
      return "start_after: " + whole(from) +
             ", end_before: " + whole(from + random.uniform(150, 900));
    default:
      return "start_after: " + whole(from) +
             ", start_before: " + whole(from + random.uniform(20, 300));
  }
}

std::vector<std::pair<std::string, std::string>> draw_look_amid_mapping(Random& random, double at) {
  const std::string zone = "Z" + std::to_string(1 + random.below(3));
  const std::string place = "P" + std::to_string(1 + random.below(4));
  const double from = at + random.uniform(80, 250);
  std::string times = "end_before: " + whole(from + random.uniform(60, 250));
  if (random.chance(0.4)) times = "start_after: " + whole(from) + ", " + times;
  const bool hurried = random.chance(0.5);
  return {{"[perform-mapping, " + zone + "]",
           hurried ? "end_before: " + whole(at + random.uniform(350, 900)) : ""},
          {"[perceive, " + place + ", " + whole(random.uniform(5, 40)) + "]", times}};
}

std::string draw_question_task(Random& random) {
  const std::string ground = "P" + std::to_string(1 + random.below(4));
  const std::string air = "A" + std::to_string(1 + random.below(3));
  const std::string zone = "Z" + std::to_string(1 + random.below(3));
  switch (random.below(4)) {
    case 0:
      return "[general-gotoxyz, " + air + "]";
    case 1:
      return "[perceive, " + ground + ", " + whole(random.uniform(5, 120)) + "]";
    case 2:
      return "[perform-detection, " + zone + ", " + ground + ", " + whole(random.uniform(60, 300)) +
             "]";
    default:
      return "[perform-tour, [" + ground + ", " + air + "]]";
  }
}

// The vehicle takes no task of a type, for a while or for good.
std::string draw_refusals(Random& random, const std::string& uav, double latest) {
  const std::vector<std::string> types{"takeoff", "goto", "land", "wait", "takeshot", "perceive"};
  const double lasts = random.chance(0.3) ? 5000 : random.uniform(5, 200);
  const double at = random.uniform(5, latest);
  return "{at: " + whole(at) + ", abort: {uav: " + uav +
         ", type: " + types[random.below(types.size())] + ", for: " + whole(lasts) + "}}";
}

std::string tenths(double number) {
  const std::string text = std::to_string(std::round(number * 10) / 10);
  return text.substr(0, text.find('.') + 2);
}

std::string hundredths(double number) {
  const std::string text = std::to_string(std::round(number * 100) / 100);
  return text.substr(0, text.find('.') + 3);
}

std::string draw_death(Random& random, const std::vector<std::string>& daemons, double latest) {
  const double at = random.uniform(3, latest);
  const std::string& who = daemons[random.below(daemons.size())];
  const double away = random.uniform(0, 15);
  return "{at: " + tenths(at) + ", kill: " + who + ", restart_after: " + tenths(away) + "}";
}

std::string forgetting(std::string death) {
  death.insert(death.rfind('}'), ", forgets: true");
  return death;
}

void add_deaths(Mission& mission, double latest) {
  Random random(mission.seed, "random mission: deaths");
  Random forgets(mission.seed, "random mission: what is forgotten");
  std::vector<std::string> daemons{"ground", "sim"};
  for (const Member& one : mission.team) daemons.push_back(one.name);
  for (std::uint64_t i = 1 + random.below(3); i > 0; --i)
    mission.faults.push_back(draw_death(random, daemons, latest));
  for (std::string& fault : mission.faults) {
    if (fault.find("kill: sim") != std::string::npos && forgets.chance(0.5))
      fault = forgetting(std::move(fault));
  }
}

std::string draw_fault(Random& random, const std::string& uav, const DrawDevice& device,
                       double latest) {
  const std::string at = "at: " + whole(random.uniform(10, latest)) + ", ";
  const std::vector<std::string> types{"takeoff", "goto", "land", "wait", "takeshot"};
  const std::string breaks = device(random);
  switch (random.below(4)) {
    case 0:
      return "{" + at + "slow: {uav: " + uav + ", factor: " + tenths(random.uniform(1.2, 4)) +
             ", for: " + whole(random.uniform(20, 200)) + "}}";
    case 1:
      return "{" + at + "abort: {uav: " + uav + ", type: " + types[random.below(types.size())] +
             "}}";
    case 2:
      return "{" + at + "sensor: {uav: " + uav + ", device: " + breaks + "}}";
    default:
      return "{" + at + "energy: {uav: " + uav +
             ", left: " + hundredths(random.uniform(0.12, 0.6)) + "}}";
  }
}

std::string draw_fault(Random& random, const Member& uav, double latest) {
  const auto device = [&](Random& drawn) -> std::string {
    return uav.model == "karma"   ? "mapping"
           : drawn.chance(0.5)    ? "visible"
           : uav.model == "heliv" ? "ir"
                                  : "fire-sensor";
  };
  return draw_fault(random, uav.name, device, latest);
}

void add_cut_off(Mission& mission, const std::string& who, double from, double until,
                 bool from_ground) {
  const auto cut = [&](const std::string& other) {
    mission.cuts.push_back("{between: [" + who + ", " + other + "], from: " + whole(from) +
                           ", until: " + whole(until) + "}");
  };
  for (const Member& one : mission.team)
    if (one.name != who) cut(one.name);
  if (from_ground) cut("ground");
}

std::string draw_cut(Random& random, const std::string& one, const std::string& other,
                     double latest) {
  const double from = random.uniform(10, latest);
  return "{between: [" + one + ", " + other + "], from: " + whole(from) +
         ", until: " + whole(from + random.uniform(5, 150)) + "}";
}

std::vector<std::string> draw_cuts(Random& random, const std::vector<Member>& team,
                                   std::size_t limit, double latest) {
  const auto any = [&] { return team[random.below(team.size())].name; };
  std::vector<std::string> cuts;
  for (std::size_t n = random.below(limit); n > 0; --n) {
    const std::string one = any(), other = any();
    cuts.push_back(draw_cut(random, one, one == other ? "ground" : other, latest));
  }
  return cuts;
}

const Member& any_of(Random& random, const Mission& mission) {
  return mission.team[random.below(mission.team.size())];
}

void add_radio_troubles(Random& random, Mission& mission, double latest) {
  if (random.chance(0.2))
    mission.radio.push_back("capacity: " + std::string(random.chance(0.5) ? "9600" : "19200"));
  if (random.chance(0.2)) mission.loss = random.uniform(0.01, 0.15);
  if (random.chance(0.6)) mission.cuts = draw_cuts(random, mission.team, 4, latest);
  if (!random.chance(0.25)) return;
  const std::string who = any_of(random, mission).name;
  const double from = random.uniform(20, latest), until = from + random.uniform(20, 400);
  add_cut_off(mission, who, from, until, random.chance(0.5));
}

// For a moment, or for minutes.
void add_hands(Random& random, Mission& mission, const std::string& who, double latest) {
  const std::string interrupt = random.chance(0.5) ? ", interrupt: true" : "";
  add_action(mission, "mine", "{time: " + whole(random.uniform(20, latest)) + "}", 0,
             "take_in_hand: {uav: " + who + interrupt + "}");
  add_action(mission, "yours", "{step: mine}",
             random.chance(0.5) ? random.uniform(1, 5) : random.uniform(5, 200),
             "give_back: {uav: " + who + "}");
}

void add_closing_air(Random& random, Mission& mission, double east, double north, double latest) {
  const double from = random.uniform(60, latest);
  const double y = north + random.uniform(-150, 150), x = east + random.uniform(-200, 200);
  mission.volumes.push_back("V1: {" + draw_box(random, x, y) + ", from: " + whole(from) +
                            ", until: " + whole(from + random.uniform(30, 300)) + "}");
}

void add_death_of_one(Random& random, Mission& mission, double latest) {
  std::string dies =
      "{at: " + tenths(random.uniform(5, latest)) + ", kill: " + any_of(random, mission).name;
  if (random.chance(0.6)) dies += ", restart_after: " + tenths(random.uniform(2, 300));
  mission.faults.push_back(dies + "}");
}

}  // namespace skein::mission_lab
