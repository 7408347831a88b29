// SPDX-License-Identifier: Apache-2.0
#include "parts.hpp"

#include <cmath>
#include <vector>

namespace skein::random_missions {

std::string whole(double number) { return std::to_string(std::lround(number)); }

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
std::string draw_refusals(Random& random, const std::string& uav) {
  const std::vector<std::string> types{"takeoff", "goto", "land", "wait", "takeshot", "perceive"};
  const double lasts = random.chance(0.3) ? 5000 : random.uniform(5, 200);
  const double at = random.uniform(5, 500);
  return "{at: " + whole(at) + ", abort: {uav: " + uav +
         ", type: " + types[random.below(types.size())] + ", for: " + whole(lasts) + "}}";
}

std::string tenths(double number) {
  const std::string text = std::to_string(std::round(number * 10) / 10);
  return text.substr(0, text.find('.') + 2);
}

std::string draw_death(Random& random, const std::vector<std::string>& daemons) {
  const double at = random.uniform(3, 600);
  const std::string& who = daemons[random.below(daemons.size())];
  const double away = random.uniform(0, 15);
  return "{at: " + tenths(at) + ", kill: " + who + ", restart_after: " + tenths(away) + "}";
}

}  // namespace skein::random_missions
