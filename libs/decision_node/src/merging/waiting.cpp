// SPDX-License-Identifier: Apache-2.0
#include "merging/waiting.hpp"

#include <utility>

#include "role_ids.hpp"

namespace skein::decision_node {

namespace {

constexpr Duration kAside = Duration::milliseconds(3'000);  ///< a place aside is had in
/// A role's way is flown higher than it asked for once it has waited so long.
constexpr Duration kRises = Duration::milliseconds(10'000);

}  // namespace

Waiting waiting_since(MissionTime now, functional::Request request) {
  Waiting waiting;
  waiting.request = std::move(request);
  waiting.since = waiting.said = now;
  waiting.looks_around = now + kLooksAround;
  return waiting;
}

bool Waiting::is_long(MissionTime now) const { return now >= since + kRises; }

std::optional<MissionTime> Waiting::rises_from() const {
  const bool asks = !airways.empty() && !aside_since && !comes_back && !asked_long;
  return asks && is_of_role(request.id) ? std::optional(since + kRises) : std::nullopt;
}

std::optional<MissionTime> Waiting::looks_around_from() const {
  const bool asks = !airways.empty() && !aside_since && !comes_back;
  return asks ? std::optional(looks_around) : std::nullopt;
}

std::optional<MissionTime> Waiting::aside_until() const {
  return aside_since ? std::optional(*aside_since + kAside) : std::nullopt;
}

void Waiting::cannot(const std::string& why) {
  why_not = why;
  ask_later();
}

void Waiting::ask_later() {
  airways.clear();
  aside_since.reset();
}

void Waiting::wait_for(const merging::Waits& waits) {
  if (makes_room) return;
  const std::vector<merging::Waits::Why>& whys = aside_since ? waits.afterwards : waits.whys;
  waits_for.clear();
  for (const merging::Waits::Why& one : whys)
    waits_for.push_back(one.peer + " " + std::string(to_text(one.what)));
  in_its_way = merging::Waits{whys, {}}.in_its_way();
}

void Waiting::note(Bus& bus, const std::string& state, const Airway* airway) const {
  AirNoted noted_now{request.id, request.type, state, {}, 0, {}, {}};
  noted_now.waited = bus.now() - since;
  if (airway == nullptr) {
    noted_now.waits_for = waits_for;
    if (!in_its_way.empty() && looks_around_from()) noted_now.air = airways.front().air;
  } else {
    noted_now.raised = airway->raised;
    noted_now.air = airway->air;
  }
  bus.emit(std::move(noted_now));
}

void Waiting::note_waits(Bus& bus) {
  if (waits_for == noted_for) return;
  const bool soon = bus.now() < noted + kSaidAgain;
  if (!noted_for.empty() && in_its_way == noted_way && soon) return;
  noted = bus.now();
  noted_for = waits_for;
  noted_way = in_its_way;
  note(bus, "waits", nullptr);
}

}  // namespace skein::decision_node
