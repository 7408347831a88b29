// SPDX-License-Identifier: Apache-2.0
// A search for a way past the air of others.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "skein/refiners/path.hpp"
#include "skein/world/world.hpp"

namespace skein::decision_node {

/// What is searched: `query.reserved` is the air of others. A value type.
struct WaySearch {
  refiners::PathQuery query;
  std::shared_ptr<const world::World> world;
};

/// The way; nothing: none is known after 200,000 steps of the path refiner, or nobody wants it any
/// more, which `is_unwanted` is asked in between. Any thread. Cost: that of
/// refiners::refine(PathQuery), up to about a second.
std::optional<refiners::Path> search_way(const WaySearch& search,
                                         const std::function<bool()>& is_unwanted = {});

}  // namespace skein::decision_node
