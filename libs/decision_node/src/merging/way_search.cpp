// SPDX-License-Identifier: Apache-2.0
#include "skein/decision_node/way_search.hpp"

#include <utility>

namespace skein::decision_node {

namespace {

constexpr std::uint64_t kStepsOfASearch = 200'000;

}  // namespace

std::optional<refiners::Path> search_way(const WaySearch& search,
                                         const std::function<bool()>& is_unwanted) {
  refiners::Setting setting{*search.world, {is_unwanted, kStepsOfASearch}};
  auto found = refine(search.query, setting);
  return found ? std::optional(std::move(found->task)) : std::nullopt;
}

}  // namespace skein::decision_node
