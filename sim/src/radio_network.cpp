// SPDX-License-Identifier: Apache-2.0
#include "radio_network.hpp"

#include <algorithm>
#include <utility>

namespace skein::sim {

RadioNetwork::RadioNetwork(const SimulatorConfig& config, std::vector<std::string> nodes)
    : model_(config.radio),
      cuts_(config.cuts),
      period_(config.radio_period),
      nodes_(std::move(nodes)),
      next_(config.start),
      next_look_(config.start) {
  for (std::size_t a = 0; a < nodes_.size(); ++a)
    for (std::size_t b = a + 1; b < nodes_.size(); ++b) pairs_.push_back({a, b});
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
    const bool up = pair.in_contact && !is_cut(pair, now);
    const world::RadioLink link =
        up ? world::RadioLink{true, model_.latency, model_.loss} : world::RadioLink{false, {}, 1};
    if (!first_ && link == pair.link) continue;
    pair.link = link;
    const std::string &a = nodes_[pair.a], &b = nodes_[pair.b];
    effects.push_back(LinkChange{a, b, link.up, link.latency, link.loss, now});
    effects.push_back(LinkChange{b, a, link.up, link.latency, link.loss, now});
  }
  first_ = false;
  next_ = next_after(now);
}

bool RadioNetwork::is_cut(const Pair& pair, MissionTime now) const {
  const std::string &a = nodes_[pair.a], &b = nodes_[pair.b];
  return std::any_of(cuts_.begin(), cuts_.end(), [&](const RadioCut& cut) {
    const bool names = (cut.a == a && cut.b == b) || (cut.a == b && cut.b == a);
    return names && now >= cut.from && now < cut.until;
  });
}

MissionTime RadioNetwork::next_after(MissionTime now) const {
  MissionTime next = next_look_;
  for (const RadioCut& cut : cuts_)
    for (const MissionTime at : {cut.from, cut.until})
      if (at > now) next = std::min(next, at);
  return next;
}

}  // namespace skein::sim
