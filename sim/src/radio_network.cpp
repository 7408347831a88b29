// SPDX-License-Identifier: Apache-2.0
#include "radio_network.hpp"

#include <algorithm>
#include <utility>

namespace skein::sim {

namespace {

/// Whether it says something of this direction now.
template <class Scripted>
bool holds(const Scripted& one, const std::string& from, const std::string& to, MissionTime now) {
  const bool there = one.a == from && one.b == to;
  const bool back = one.a == to && one.b == from;
  return (there || (back && !one.one_way)) && now >= one.from && now < one.until;
}

}  // namespace

RadioNetwork::RadioNetwork(const SimulatorConfig& config, std::vector<std::string> nodes)
    : model_(config.radio),
      cuts_(config.cuts),
      scripts_(config.links),
      period_(config.radio_period),
      nodes_(std::move(nodes)),
      next_(config.start),
      next_look_(config.start) {
  const auto is_scripted = [&](const std::string& a, const std::string& b) {
    const auto names = [&](const auto& one) {
      return (one.a == a && one.b == b) || (one.a == b && one.b == a);
    };
    return std::ranges::any_of(cuts_, names) || std::ranges::any_of(scripts_, names);
  };
  for (std::size_t a = 0; a < nodes_.size(); ++a)
    for (std::size_t b = a + 1; b < nodes_.size(); ++b)
      pairs_.push_back({a, b, true, {}, is_scripted(nodes_[a], nodes_[b])});
}

void RadioNetwork::update(const std::vector<world::Vector3>& positions,
                          const world::Terrain& terrain, MissionTime now,
                          std::vector<Effect>& effects) {
  const bool look = now >= next_look_;
  if (look) next_look_ = now + period_;
  for (Pair& pair : pairs_) {
    if (look)
      pair.in_contact =
          model_.link(positions[pair.a], positions[pair.b], terrain, pair.in_contact && !first_).up;
    for (const std::size_t way : {0U, 1U}) {
      const std::size_t from = way == 0 ? pair.a : pair.b, to = way == 0 ? pair.b : pair.a;
      const world::RadioLink is = link(pair, from, to, now);
      if (!first_ && is == pair.links[way]) continue;
      pair.links[way] = is;
      effects.push_back(
          LinkChange{nodes_[from], nodes_[to], is.up, is.latency, is.loss, now, is.capacity});
    }
  }
  first_ = false;
  next_ = next_after(now);
}

world::RadioLink RadioNetwork::link(const Pair& pair, std::size_t from, std::size_t to,
                                    MissionTime now) const {
  constexpr world::RadioLink kDown{false, {}, 1, 0};
  if (!pair.in_contact) return kDown;
  world::RadioLink link{true, model_.latency, model_.loss, model_.capacity};
  if (!pair.scripted) return link;
  const std::string &a = nodes_[from], &b = nodes_[to];
  if (std::ranges::any_of(cuts_, [&](const RadioCut& cut) { return holds(cut, a, b, now); }))
    return kDown;
  for (const RadioScript& script : scripts_) {
    if (!holds(script, a, b, now)) continue;
    link.latency = script.latency.value_or(link.latency);
    link.loss = script.loss.value_or(link.loss);
    link.capacity = script.capacity.value_or(link.capacity);
  }
  return link;
}

MissionTime RadioNetwork::next_after(MissionTime now) const {
  MissionTime next = next_look_;
  const auto consider = [&](const auto& scripted) {
    for (const auto& one : scripted)
      for (const MissionTime at : {one.from, one.until})
        if (at > now) next = std::min(next, at);
  };
  consider(cuts_);
  consider(scripts_);
  return next;
}

}  // namespace skein::sim
