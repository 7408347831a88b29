// SPDX-License-Identifier: Apache-2.0
// Who asks for a joint task that others are at, mapping an area or watching from agreed places,
// takes part in it.
#include <algorithm>
#include <map>
#include <optional>

#include "checks.hpp"
#include "joint_places.hpp"

namespace skein::laws {

namespace {

/// Until it has asked once more, and all have agreed with it.
constexpr double kAgreed = 90;  // [s]

/// A time in which a UAV had nothing to do but a joint task that had not begun.
struct Wait {
  std::string uav, joint;
  double from = 0, until = kNever;
};

std::optional<Wait> wait_for(const History& history, const JointTold& told) {
  const Uav& uav = history.uavs.at(told.uav);
  const auto due = uav.executions.find(told.task);
  if (due == uav.executions.end() || due->second.started == kNever) return std::nullopt;
  Wait wait{told.uav, told.joint, due->second.started, std::min(due->second.over, history.end)};
  for (const JointTold::Phase& phase : told.phases) {
    const bool waits = phase.phase == "loading" || phase.phase == "loaded";
    if (!waits && phase.at >= wait.from) wait.until = std::min(wait.until, phase.at);
  }
  return wait;
}

bool is_call(const interaction::Literal& literal) {
  const auto* message = std::get_if<interaction::MessagePending>(&literal.condition);
  return message != nullptr && message->message.ends_with(" invitation");
}

/// Whether some role of it is called to agree anew with who comes.
bool takes_in(const interaction::Library& library, const interaction::Variant& variant) {
  const auto calls = [](const interaction::Componel& one) {
    const interaction::Block* block = one.block();
    if (block == nullptr) return false;
    return std::ranges::any_of(block->precondition, [](const interaction::Clause& clause) {
      return std::ranges::any_of(clause, is_call);
    });
  };
  return std::ranges::any_of(variant.roles, [&](const std::string& role) {
    return std::ranges::any_of(library.roles.at(role).automaton.componels(), calls);
  });
}

/// Until when a UAV looks for a joint task at what it is about.
double looks_until(const History& history, const Held& held) {
  double until = 0;
  for (const Look& one : looks_for(history, held.joint))
    if (one.uav->name() == held.uav) until = std::max(until, one.look->until);
  return std::min(until, held.until);
}

struct Span {
  double from = 0, until = 0;
};

/// In which another one looks there while it waits.
Span longest_beside(const History& history, const std::vector<Held>& all, const Wait& wait) {
  Span longest;
  for (const Held& held : all) {
    if (held.joint != wait.joint || held.uav == wait.uav) continue;
    const Span span{std::max(held.from, wait.from),
                    std::min(looks_until(history, held), wait.until)};
    if (span.until - span.from > longest.until - longest.from) longest = span;
  }
  return longest;
}

/// Both decide and hear each other, and neither dies, in all of that time.
bool could_agree(const History& history, const std::string& one, const std::string& other,
                 const Span& span) {
  const auto [from, until] = span;
  for (const std::string& uav : {one, other}) {
    if (!history.uavs.at(uav).deliberates(from, until)) return false;
    if (history.was_away(uav, from, until) || history.was_killed(uav)) return false;
  }
  return history.joint.up(one, other, from, until) && history.joint.up(other, one, from, until);
}

}  // namespace

// Others who hold a role are to agree, too: it is judged only while it hears them all.
std::vector<Violation> newcomers_left_out(const History& history) {
  std::vector<Violation> result;
  const std::vector<Held> all = roles_held(history.joint);
  for (const JointTold& told : history.joint.joints) {
    const auto wait = wait_for(history, told);
    const interaction::Variant* variant = variant_of(history, told);
    if (!wait || variant == nullptr) continue;
    const bool are_taken_in = !shared_areas(history, *variant).empty() ||
                              takes_in(*history.scenario->interaction, *variant);
    if (!are_taken_in) continue;
    const Span span = longest_beside(history, all, *wait);
    if (span.until - span.from <= kAgreed) continue;
    const bool hears_all = std::ranges::all_of(all, [&](const Held& held) {
      const bool is_there = held.joint == wait->joint && held.uav != wait->uav &&
                            held.from < span.until && held.until > span.from;
      return !is_there || could_agree(history, held.uav, wait->uav, span);
    });
    if (!hears_all) continue;
    result.push_back({"", span.until, wait->uav, 0,
                      told.joint + " goes on without it for " + figure(span.until - span.from) +
                          " s, though it waits for it and hears all who are at it"});
  }
  return result;
}

}  // namespace skein::laws
