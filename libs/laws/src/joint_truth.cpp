// SPDX-License-Identifier: Apache-2.0
// A joint task that is reported achieved was done by its members: all roles were held at one time,
// and what is to be perceived was perceived, from where the model allows it.
#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>

#include "checks.hpp"
#include "following.hpp"
#include "joint_places.hpp"

namespace skein::laws {

namespace {

constexpr double kTruthStep = 1;  // [s] how finely truth is looked at

/// What this UAV told last of the joint task of a goal.
const JointTold* told_of(const History& history, const Uav& uav, const Goal& goal) {
  const auto& all = history.joint.joints;
  const auto found = std::find_if(all.rbegin(), all.rend(), [&](const JointTold& one) {
    return one.uav == uav.name() && uav.goal_of_task(one.task) == goal.id;
  });
  return found == all.rend() ? nullptr : &*found;
}

// ---- all roles at one time ----

int most_at_once(const std::vector<Held>& held, const std::string& joint, const std::string& role) {
  int most = 0;
  for (const Held& begins : held) {
    if (begins.joint != joint || begins.role != role) continue;
    const auto there = [&](const Held& one) {
      return one.joint == joint && one.role == role && one.from <= begins.from &&
             begins.from < one.until;
    };
    most = std::max(most, static_cast<int>(std::count_if(held.begin(), held.end(), there)));
  }
  return most;
}

bool at_one_time(const std::vector<Held>& held, const std::string& joint) {
  double last_begin = 0, first_end = kNever;
  std::map<std::string, std::pair<double, double>> by_uav;
  for (const Held& one : held) {
    if (one.joint != joint) continue;
    auto [span, is_new] = by_uav.try_emplace(one.uav, one.from, one.until);
    if (!is_new) span->second.second = std::max(span->second.second, one.until);
  }
  for (const auto& [uav, span] : by_uav) {
    last_begin = std::max(last_begin, span.first);
    first_end = std::min(first_end, span.second);
  }
  return last_begin < first_end;
}

/// UAVs with that role that died when it was to begin, before they could tell that it did. The
/// others go on without them as without one that dies later.
int died_before_it_began(const History& history, const std::string& joint,
                         const std::string& role) {
  const auto died = [&](const JointTold& told) {
    for (std::size_t i = 0; i < told.phases.size(); ++i) {
      const JointTold::Phase& phase = told.phases[i];
      const bool is_last = i + 1 == told.phases.size();
      if (phase.phase != "loaded" || phase.role != role) continue;
      if (!is_last && told.phases[i + 1].phase == "running") continue;
      if (history.was_away(told.uav, phase.at, is_last ? kNever : told.phases[i + 1].at))
        return true;
    }
    return false;
  };
  const auto& all = history.joint.joints;
  return static_cast<int>(std::ranges::count_if(
      all, [&](const JointTold& told) { return told.joint == joint && died(told); }));
}

/// UAVs that had agreed on that role and had not begun it when they were out of reach of one who
/// had, for long enough to be lost there.
int cut_off_before_it_began(const History& history, const std::vector<Held>& held,
                            const std::string& joint, const std::string& role) {
  constexpr double kLost = 55;  // [s] after what was heard last
  const auto lost = [&](const JointTold& told, const Held& one) {
    return std::ranges::any_of(history.joint.links, [&](const LinkTold& link) {
      return !link.up && link.at + kLost < one.until && one.from < link.at + kLost &&
             history.joint.cut_off(told.uav, one.uav, link.at, link.at + kLost);
    });
  };
  return static_cast<int>(std::ranges::count_if(history.joint.joints, [&](const JointTold& told) {
    const auto had = std::ranges::find(told.phases, role, &JointTold::Phase::role);
    const auto ran = std::ranges::find(told.phases, "running", &JointTold::Phase::phase);
    if (told.joint != joint || had == told.phases.end() || ran != told.phases.end()) return false;
    return std::ranges::any_of(held, [&](const Held& one) {
      return one.joint == joint && one.uav != told.uav && had->at < one.until && lost(told, one);
    });
  }));
}

std::string roles_missing(const History& history, const std::string& joint,
                          const interaction::Variant& variant) {
  const std::vector<Held> held = roles_held(history.joint);
  for (const auto& [role, arity] : variant.table.arities) {
    const int most = most_at_once(held, joint, role) + died_before_it_began(history, joint, role) +
                     cut_off_before_it_began(history, held, joint, role);
    if (most < arity.least) {
      return "role " + role + " was held by " + std::to_string(most) + " at once, of " +
             std::to_string(arity.least);
    }
  }
  return at_one_time(held, joint) ? "" : "its members never took part at one time";
}

// ---- what was perceived ----

/// A perception of a role.
struct Watch {
  std::string role, componel;
  double seconds = 0;             ///< asked
  std::vector<std::string> scms;  ///< about places, that hold meanwhile
};

bool is_about_places(const interaction::Variant& variant,
                     const interaction::ScmInstance& instance) {
  return std::none_of(instance.arguments.begin(), instance.arguments.end(), [&](const auto& one) {
    const auto* word = std::get_if<std::string>(&one.second);
    const auto& roles = variant.roles;
    return word != nullptr &&
           (*word == "R*" || std::find(roles.begin(), roles.end(), *word) != roles.end());
  });
}

std::vector<std::string> scms_around(const interaction::Variant& variant, const std::string& role,
                                     const interaction::Automaton& automaton,
                                     const interaction::Componel& inner) {
  std::set<std::string> around;
  for (const interaction::Componel* one = &inner;; one = &automaton[one->parent]) {
    around.insert(one->id);
    if (&automaton[one->parent] == one) break;
  }
  std::vector<std::string> scms;
  for (const interaction::ScmPlace& place : variant.table.places) {
    const bool holds = place.role == role &&
                       std::any_of(place.blocks.begin(), place.blocks.end(),
                                   [&](const auto& block) { return around.contains(block); });
    const auto instance = std::find_if(variant.table.scms.begin(), variant.table.scms.end(),
                                       [&](const auto& one) { return one.id == place.id; });
    if (holds && is_about_places(variant, *instance)) scms.push_back(place.id);
  }
  return scms;
}

/// Perceptions of the variant for as long as a parameter of the joint task says.
std::vector<Watch> watches_of(const History& history, const std::string& joint,
                              const interaction::Variant& variant) {
  std::vector<Watch> all;
  const auto arguments = arguments_of(joint, variant);
  for (const std::string& name : variant.roles) {
    const interaction::Role& role = history.scenario->interaction->roles.at(name);
    const auto table = variant.table.parameters.find(name);
    for (const interaction::Componel& one : role.automaton.componels()) {
      if (one.task() == nullptr || one.task()->type != "takeshot-while-waiting") continue;
      const config::Value* duration = one.task()->parameters.find("duration");
      if (duration == nullptr || table == variant.table.parameters.end()) continue;
      const auto parameter = table->second.find(duration->scalar);
      if (parameter == table->second.end()) continue;
      all.push_back({name, one.id, std::stod(arguments.at(parameter->second)),
                     scms_around(variant, name, role.automaton, one)});
    }
  }
  return all;
}

bool allowed(const History& history, const PlaceTold& there, const interaction::Variant& variant) {
  const Uav& uav = history.uavs.at(there.uav);
  return distances_broken(history, there, variant, wander(history, uav)).empty();
}

/// By all members together.
double seconds_watched(const History& history, const std::string& joint, const Watch& watch,
                       const interaction::Variant& variant) {
  double seconds = 0;
  for (const RoleTaskTold& task : history.joint.tasks) {
    if (task.joint != joint || task.role != watch.role || task.componel != watch.componel) continue;
    const Uav& uav = history.uavs.at(task.uav);
    for (const Activity& look : uav.activities) {
      if (look.task != task.task || !look.looks()) continue;
      const double until = std::min(look.until, history.end);
      for (double t = look.from; t < until; t += kTruthStep) {
        const auto sample = uav.at(t);
        if (!sample) continue;
        const PlaceTold there{t, task.uav, joint, watch.role, watch.scms, sample->position};
        if (allowed(history, there, variant)) seconds += std::min(kTruthStep, until - t);
      }
    }
  }
  return seconds;
}

/// How often a point came to lie elsewhere: those that are told, and objects that have moved so
/// far.
std::size_t moves(const History& history) {
  constexpr double kFar = 10;  // [m]
  std::map<std::string, world::Vector3> places;
  std::size_t count = history.joint.points.size();
  for (const ObjectTold& told : history.objects_told) {
    const auto [known, added] = places.try_emplace(told.name, told.position);
    if (!added && (known->second - told.position).norm() < kFar) continue;
    known->second = told.position;
    ++count;
  }
  return count;
}

/// How much of what is asked for may be missing: what moves is told, agreed on, interrupted [s].
double reaction(const History& history) {
  constexpr double kReaction = 25;  // [s] to each move
  return kReaction * static_cast<double>(moves(history));
}

/// Whether a holder of the role left it since it heard nobody, as `uav` could not hear of.
bool left_unheard(const History& history, const std::string& joint, const std::string& role,
                  const std::string& uav) {
  return std::ranges::any_of(history.joint.joints, [&](const JointTold& told) {
    const auto left = std::ranges::find_if(told.phases, [&](const JointTold::Phase& phase) {
      return phase.role == role && phase.why.starts_with("no contact with '");
    });
    return told.joint == joint && left != told.phases.end() &&
           history.joint.cut_off(told.uav, uav, left->at, left->at);
  });
}

std::string not_watched(const History& history, const std::string& joint,
                        const interaction::Variant& variant, const std::string& uav) {
  constexpr double kPart = 0.95, kSlack = 5;  // [s]
  const double moved = reaction(history);
  for (const Watch& watch : watches_of(history, joint, variant)) {
    const double seconds = seconds_watched(history, joint, watch, variant);
    if (seconds >= kPart * watch.seconds - kSlack - moved) continue;
    if (left_unheard(history, joint, watch.role, uav)) continue;
    return "role " + watch.role + " perceived from where it may for " + figure(seconds) + " of " +
           figure(watch.seconds) + " s";
  }
  return "";
}

// ---- what was mapped ----

/// By all members together.
std::string not_mapped(const History& history, const std::string& joint,
                       const interaction::Variant& variant) {
  const std::set<std::string> areas = shared_areas(history, variant);
  if (areas.empty()) return "";
  const std::vector<Look> looks = looks_for(history, joint);
  const auto arguments = arguments_of(joint, variant);
  for (const std::string& area : areas) {
    const world::Zone* zone = history.zone(arguments.at(area));
    if (zone == nullptr) continue;
    const double part = part_in_view(history, looks, zone->polygon);
    if (part < kMapPart) return figure(100 * part) + " % of " + zone->name + " was in view";
  }
  return "";
}

}  // namespace

std::vector<Violation> joint_tasks_not_done(const History& history) {
  std::vector<Violation> result;
  for_achieved(history, [&](const Uav& uav, const Goal& goal, double at) {
    if (model_of(history, goal.task.name) == nullptr) return;
    const auto broken = [&](const std::string& why) {
      result.push_back(
          {"", at, uav.name(), goal.id, mission::to_text(goal.task) + " is achieved: " + why});
    };
    const JointTold* told = told_of(history, uav, goal);
    if (told == nullptr || told->phases.back().phase != "ended") {
      return broken("no joint task of it has ended");
    }
    const interaction::Variant* variant = variant_of(history, *told);
    if (variant == nullptr) return broken("it names no variant of its model");
    if (const auto why = roles_missing(history, told->joint, *variant); !why.empty()) broken(why);
    if (const auto why = not_mapped(history, told->joint, *variant); !why.empty()) broken(why);
    if (const auto why = not_watched(history, told->joint, *variant, uav.name()); !why.empty())
      broken(why);
    if (const auto why = not_followed(history, told->joint, *variant, reaction(history));
        !why.empty())
      broken(why);
  });
  return result;
}

namespace {

/// A time in which two members hear each other again, and share the joint task.
struct Again {
  double from = 0, until = kNever;
};

/// Of two that hold roles of one joint task: from when the link between them is up again, until it
/// is down or one of them is through.
std::vector<Again> hear_each_other_again(const History& history, const Held& one,
                                         const Held& other) {
  constexpr double kMoment = 0.01;  // [s] before the link was up again
  const JointHistory& joint = history.joint;
  const double begin = std::max(one.from, other.from);
  const double end = std::min({one.until, other.until, history.end});
  std::vector<Again> all;
  for (const LinkTold& back : joint.links) {
    if (!back.up || back.at <= begin || back.at >= end) continue;
    if (!all.empty() && all.back().from == back.at) continue;  // the other direction
    const double before = back.at - kMoment;
    if (!joint.cut_off(one.uav, other.uav, before, before)) continue;
    double until = end;
    for (const LinkTold& cut : joint.links) {
      if (cut.up || cut.at <= back.at || !joint.cut_off(one.uav, other.uav, cut.at, cut.at))
        continue;
      until = std::min(until, cut.at);
    }
    const double after = back.at + kMoment;
    if (!joint.cut_off(one.uav, other.uav, after, after)) all.push_back({back.at, until});
  }
  return all;
}

/// Those of one UAV within that time, in `kept`.
std::vector<Look> within(const std::vector<Look>& looks, const std::string& uav, const Again& time,
                         std::deque<Activity>& kept) {
  std::vector<Look> result;
  for (const Look& one : looks) {
    if (one.uav->name() != uav) continue;
    Activity part = *one.look;
    part.from = std::max(part.from, time.from);
    part.until = std::min(part.until, time.until);
    if (part.from < part.until) result.push_back({one.uav, &kept.emplace_back(std::move(part))});
  }
  return result;
}

/// The greatest part of an area that both had in view in that time.
std::pair<double, std::string> mapped_by_both(const History& history, const Held& one,
                                              const Held& other, const Again& time,
                                              const interaction::Variant& variant) {
  const std::vector<Look> looks = looks_for(history, one.joint);
  std::deque<Activity> kept;
  const auto mine = within(looks, one.uav, time, kept),
             theirs = within(looks, other.uav, time, kept);
  const auto arguments = arguments_of(one.joint, variant);
  std::pair<double, std::string> most;
  for (const std::string& area : shared_areas(history, variant)) {
    const world::Zone* zone = history.zone(arguments.at(area));
    if (zone == nullptr) continue;
    most = std::max(most, {part_mapped_twice(history, mine, theirs, zone->polygon), zone->name});
  }
  return most;
}

}  // namespace

// Two parts that border on each other are both in view along that.
std::vector<Violation> areas_mapped_twice(const History& history) {
  constexpr double kLeavesIt = 25;  // [s] until who came back has told what it has left, and turned
  constexpr double kBorders = 0.1;  // of the area
  std::vector<Violation> result;
  const std::vector<Held> all = roles_held(history.joint);
  for (auto one = all.begin(); one != all.end(); ++one) {
    for (auto other = std::next(one); other != all.end(); ++other) {
      if (one->joint != other->joint || one->uav == other->uav) continue;
      const auto told = std::find_if(history.joint.joints.begin(), history.joint.joints.end(),
                                     [&](const auto& it) { return it.joint == one->joint; });
      const interaction::Variant* variant = variant_of(history, *told);
      if (variant == nullptr) continue;
      for (Again time : hear_each_other_again(history, *one, *other)) {
        time.from += kLeavesIt;
        const auto [part, area] = mapped_by_both(history, *one, *other, time, *variant);
        if (part <= kBorders) continue;
        result.push_back({"", time.from, one->uav, 0,
                          "it and " + other->uav + " hear each other again, and both map " +
                              figure(100 * part) + " % of " + area});
      }
    }
  }
  return result;
}

}  // namespace skein::laws
