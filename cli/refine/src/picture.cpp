// SPDX-License-Identifier: Apache-2.0
#include "picture.hpp"

#include <utility>

#include "skein/cartography/pictures.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::refine_tool {
namespace {

template <class Question>
using OutcomeOf = decltype(refiners::refine(std::declval<const Question&>(),
                                            std::declval<const refiners::Setting&>()));

template <class Question>
std::string draw(const world::World& world, const Question& question, const Answer& answer) {
  using Outcome = OutcomeOf<Question>;
  if (!answer) return cartography::picture(world, question, tl::make_unexpected(answer.error()));
  return cartography::picture(world, question,
                              Outcome(std::get<typename Outcome::value_type>(*answer)));
}

}  // namespace

std::string picture_of(const Query& query, const Answer& answer) {
  return std::visit(
      Overloaded{[&](const TourWithAreas& tour) { return draw(query.world, tour.tour, answer); },
                 [&](const auto& question) { return draw(query.world, question, answer); }},
      query.question);
}

}  // namespace skein::refine_tool
