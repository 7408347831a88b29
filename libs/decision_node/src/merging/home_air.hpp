// SPDX-License-Identifier: Apache-2.0
// The air of the way home, for when nobody can be asked for it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "merging/airways.hpp"

namespace skein::decision_node {

class Core;

/// Of a UAV whose contact-loss policy is to return: the flight home from where it comes to rest
/// next, as its policy would fly it, and the landing there. Source:
/// docs/decisions/0058-the-way-home-is-kept-free.md.
class HomeAir {
 public:
  explicit HomeAir(Core& core) : core_(core) {}

  /// Once nobody hears it any more, what it would fly home through stays as it is.
  void contact(bool with_ground) { reaches_ground_ = with_ground; }
  /// It will rest there in the air; nothing: on the ground. True: look() finds something else than
  /// before. Cost: constant.
  bool is_new(const std::optional<world::Vector3>& rest) const;
  /// Cost: that of planning a way.
  void look(const std::optional<world::Vector3>& rest, const AirwaySituation& situation);
  /// All of it, as its policy would fly and then higher; empty: it would not fly home, or cannot.
  const std::vector<merging::Volumes>& choices() const { return choices_; }
  /// The same in the place of a flight home by its policy that begins where it rests.
  Airways flights(const functional::Request& request,
                  const std::optional<world::Vector3>& rest) const;

 private:
  bool returns() const;
  Airways ways_to(const world::Vector3& home, const AirwaySituation& there) const;

  Core& core_;
  bool reaches_ground_ = true;
  std::optional<world::Vector3> from_;
  std::shared_ptr<const world::World> world_;  ///< for which it was planned
  Airways flights_;
  std::vector<merging::Volumes> choices_;
};

}  // namespace skein::decision_node
