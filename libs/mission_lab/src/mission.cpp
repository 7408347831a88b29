// SPDX-License-Identifier: Apache-2.0
#include "skein/mission_lab/mission.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "skein/foundation/joined.hpp"

namespace skein::mission_lab {

namespace {

void list(std::ostream& out, const std::string& key, const std::vector<std::string>& items,
          const std::string& indent, const std::string& bullet) {
  if (items.empty()) return;
  out << indent << key << ":\n";
  for (const std::string& item : items) out << indent << "  " << bullet << item << '\n';
}

void world(std::ostream& out, const Mission& m) {
  out << "world:\n"
         "  origin: {latitude: 40.1094, longitude: -8.2361, altitude: 200}\n"
         "  terrain:\n    west: -300\n    south: -300\n    east: 1200\n    north: 900\n    cell: "
         "20\n";
  if (!m.hills.empty()) out << "    hills: [" << m.hills << "]\n";
  out << "  wind: {" << m.wind << "}\n";
  list(out, "zones", m.zones, "  ", "");
  list(out, "places", m.places, "  ", "");
  list(out, "volumes", m.volumes, "  ", "");
  list(out, "objects", m.objects, "  ", "");
}

int degree_of(const Member& one, const Mission& m) {
  if (one.degree > 0) return one.degree;
  return m.global.empty() ? 4 : 5;
}

void team(std::ostream& out, const Mission& m, const std::string& scenarios) {
  out << "\nuavs:\n";
  std::string altitudes, ids;
  for (const Member& one : m.team) {
    out << "  " << one.name << ": {model: " << scenarios << '/' << one.folder << "/models/"
        << one.model << ".yaml, " << one.more << ", degree: " << degree_of(one, m) << "}\n";
    const std::string comma = altitudes.empty() ? "" : ", ";
    std::ostringstream altitude;
    altitude << one.altitude;
    altitudes += comma + one.name + ": " + altitude.str();
    ids += comma + one.name + ": " + std::to_string(one.first_id);
  }
  out << "\nplanning:\n  domain: " << scenarios << "/domains/comets.lisp\n"
      << "  altitude: 40\n  voxel: 20\n  risk: 0.2\n  altitudes: {" << altitudes
      << "}\n  first_ids: {" << ids << "}\n";
  if (m.consistency != "dip-m") out << "  consistency: " << m.consistency << "\n";
  if (m.partner_lease > 0) out << "  partner_lease: " << std::lround(m.partner_lease) << "\n";
  if (m.planning_takes > 0) out << "  takes: [0.05, " << m.planning_takes << "]\n";
  if (m.joint) {
    out << "\ninteraction: " << scenarios << "/models/interaction/" << m.interaction << ".yaml\n";
  }
}

const char* const kTeamHasDone = "{global_mission: {id: 1, state: done}}";

void global_mission(std::ostream& out, const Mission& m) {
  if (m.global.empty()) return;
  out << "    - step: give\n      when: {time: 10}\n      do:\n        - global_mission:\n"
         "            id: 1\n";
  list(out, "tasks", m.global, "            ", "- ");
}

void sharing(std::ostream& out, const Mission& m) {
  if (m.global.empty()) return;
  out << "\nteam: {lease: 10";
  if (!m.bidders.empty()) out << ", members: [" << joined(m.bidders, ", ") << ']';
  if (!m.sharing.empty()) out << ", " << m.sharing;
  out << "}\n";
}

void radio(std::ostream& out, const Mission& m) {
  out << "\nradio:\n  range: " << m.range << "\n  line_of_sight: true\n  latency: " << m.latency
      << "\n  loss: " << m.loss << '\n';
  if (!m.relays.empty()) out << "  relays: [" << joined(m.relays, ", ") << "]\n";
  for (const std::string& one : m.radio) out << "  " << one << '\n';
  list(out, "cuts", m.cuts, "  ", "- ");
  list(out, "links", m.links, "  ", "- ");
}

void step(std::ostream& out, const Step& s) {
  out << (s.by_operator ? "    - does: " : "    - step: ") << s.name << "\n      when: " << s.when
      << '\n';
  if (s.after > 0) out << "      after: " << s.after << '\n';
  if (s.repeats) out << "      repeats: true\n";
  if (s.tasks.empty()) {
    out << "      do: [{" << s.action << "}]\n";
    return;
  }
  out << "      do:\n        - mission:\n            uav: " << s.uav
      << "\n            id: " << s.mission << '\n';
  if (!s.placement.empty()) {
    const std::size_t comma = s.placement.find(", ");
    out << "            placement: " << s.placement.substr(0, comma) << '\n';
    if (comma != std::string::npos) out << "            " << s.placement.substr(comma + 2) << '\n';
  }
  if (s.evaluate) out << "            evaluate: true\n";
  out << "            tasks:\n";
  for (const Task& task : s.tasks) {
    out << "              - {id: " << task.id << ", task: " << task.words
        << (task.times.empty() ? "" : ", " + task.times) << "}\n";
  }
}

// Of the script, or those of its operators with their heading.
void steps(std::ostream& out, const Mission& m, bool by_operator) {
  const auto is_one = [&](const Step& one) { return one.by_operator == by_operator; };
  if (by_operator && std::ranges::any_of(m.steps, is_one)) out << "  operator:\n";
  for (const Step& one : m.steps)
    if (is_one(one)) step(out, one);
}

// Once every goal has come to an end, one way or another, and the team has done all of it.
void finish(std::ostream& out, const Mission& m) {
  std::string all;
  for (const Step& one : m.steps) {
    if (one.evaluate) continue;
    for (const Task& task : one.tasks) {
      std::string any;
      for (const char* state : {"achieved", "failed", "cancelled"}) {
        any += std::string(any.empty() ? "" : ", ") + "{goal: {uav: " + one.uav +
               ", id: " + std::to_string(task.id) + ", state: " + state + "}}";
      }
      all += "          - {any: [" + any + "]}\n";
    }
  }
  const bool shared = !m.global.empty();
  if ((all.empty() && !shared) || m.finish_after < 0) return;
  out << "    - step: end\n      when:";
  if (all.empty()) {
    out << ' ' << kTeamHasDone << '\n';
  } else {
    out << "\n        all:\n" << all;
    if (shared) out << "          - " << kTeamHasDone << '\n';
  }
  out << "      after: " << m.finish_after << "\n      do: [{finish: true}]\n";
}

template <class Part>
void without_each(const Mission& whole, std::vector<Part> Mission::*parts,
                  std::vector<Mission>& result) {
  for (std::size_t i = 0; i < (whole.*parts).size(); ++i) {
    Mission less = whole;
    (less.*parts).erase((less.*parts).begin() + static_cast<std::ptrdiff_t>(i));
    result.push_back(std::move(less));
  }
}

}  // namespace

std::string to_yaml(const Mission& m, const std::string& scenarios) {
  std::ostringstream out;
  out << "# Metres, seconds, radians; x east, y north, z up.\nscenario: random-" << m.seed
      << "\nepoch: 2005-05-19T09:00:00Z\nduration_limit: " << m.limit << "\nseed: " << m.seed
      << "\n\n";
  world(out, m);
  team(out, m, scenarios);
  sharing(out, m);
  if (!m.separation.empty()) out << "\nseparation: " << m.separation << '\n';
  radio(out, m);
  out << "\nground:\n  position: [-20, -20, 8]\n";
  list(out, "objects", m.followed, "  ", "");
  out << "  script:\n";
  steps(out, m, false);
  global_mission(out, m);
  finish(out, m);
  steps(out, m, true);
  if (!m.faults.empty()) out << '\n';
  list(out, "faults", m.faults, "", "- ");
  return out.str();
}

std::vector<Mission> smaller(const Mission& whole) {
  std::vector<Mission> result;
  without_each(whole, &Mission::team, result);
  without_each(whole, &Mission::steps, result);
  without_each(whole, &Mission::faults, result);
  without_each(whole, &Mission::cuts, result);
  without_each(whole, &Mission::links, result);
  without_each(whole, &Mission::radio, result);
  if (whole.global.size() > 1) without_each(whole, &Mission::global, result);
  without_each(whole, &Mission::volumes, result);
  without_each(whole, &Mission::objects, result);
  without_each(whole, &Mission::followed, result);
  for (std::size_t s = 0; s < whole.steps.size(); ++s) {
    for (std::size_t t = 0; whole.steps[s].tasks.size() > 1 && t < whole.steps[s].tasks.size();
         ++t) {
      Mission less = whole;
      auto& tasks = less.steps[s].tasks;
      tasks.erase(tasks.begin() + static_cast<std::ptrdiff_t>(t));
      result.push_back(std::move(less));
    }
    if (!whole.steps[s].placement.empty()) {
      Mission less = whole;
      less.steps[s].placement.clear();
      result.push_back(std::move(less));
    }
    for (std::size_t t = 0; t < whole.steps[s].tasks.size(); ++t) {
      if (whole.steps[s].tasks[t].times.empty()) continue;
      Mission less = whole;
      less.steps[s].tasks[t].times.clear();
      result.push_back(std::move(less));
    }
  }
  without_each(whole, &Mission::zones, result);
  without_each(whole, &Mission::places, result);
  if (whole.planning_takes > 0) {
    result.push_back(whole);
    result.back().planning_takes = 0;
  }
  if (!whole.hills.empty()) {
    result.push_back(whole);
    result.back().hills.clear();
  }
  return result;
}

}  // namespace skein::mission_lab
