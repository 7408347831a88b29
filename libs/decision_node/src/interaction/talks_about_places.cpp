// SPDX-License-Identifier: Apache-2.0
// Members agree on where each of them goes.
#include "interaction/agreed_places.hpp"
#include "interaction/interaction.hpp"
#include "interaction/role_talks.hpp"

namespace skein::decision_node {

namespace {

using Kind = interaction::NegotiationOutcome::Kind;
using Word = interaction::Status::Word;

constexpr Duration kSession = Duration::milliseconds(10'000);
constexpr const char* kPlace = "place";  // of an action's `out`

}  // namespace

void RoleTalks::negotiate_places(const std::string& action) {
  const RolePlay& play = course_.play();
  const interaction::Automaton& automaton = play.automaton();
  const interaction::CoordinationAction& what = *automaton[*automaton.find(action)].action();
  interaction::BeginNegotiation begin = session(action, what.modality, kSession);
  auto terms = place_terms(what, play.scope(), begin.members.size(), course_.outlook());
  if (!terms) {
    note(action + ": " + terms.error().why);
    places_.stop();
    actions_.erase(action);
    return course_.tell_status(action, Word::kAborted);
  }
  begin.parameters = std::move(*terms);
  actions_[action] = begin.subject;
  if (begin.members.size() == 1 || !places_.asks(action)) places_.stop();
  if (begin.members.size() == 1) return take_place_alone(begin);
  places_.ask(action, now());  // it may fail at once
  if (interaction_.begin(my_.joint, std::move(begin))) return;
  places_.stop();
  actions_.erase(action);
  course_.tell_status(action, Word::kAborted);
}

// Of what it can do itself the best.
void RoleTalks::take_place_alone(const interaction::BeginNegotiation& begin) {
  interaction::Terms terms;
  terms.subject = begin.subject;
  terms.modality = begin.modality;
  terms.members = begin.members;
  terms.parameters = begin.parameters;
  interaction::NegotiationOutcome outcome;
  const auto offer = task_.offer_for(terms);
  const auto result = offer ? interaction::reckon(terms, {{self_, *offer}}) : offer;
  outcome.kind = result ? Kind::kAgreed : Kind::kFailed;
  if (result) outcome.result = *result;
  if (!result) outcome.why = result.error().why;
  places_agreed(terms, outcome);
}

void RoleTalks::places_agreed(const interaction::Terms& terms,
                              const interaction::NegotiationOutcome& outcome) {
  const std::optional<std::string> asked = action_about(terms.subject);
  if (!asked) return;
  const std::string& action = *asked;
  const bool is_agreed = outcome.kind == Kind::kAgreed;
  if (!is_agreed) note(action + ": " + outcome.why);
  const bool asks = places_.asks(action);
  if (!is_agreed && asks && places_.lasts(now() + AskingAgain::kPause))
    return places_.not_agreed(outcome.why, now());
  places_.stop(action);
  actions_.erase(action);
  if (!is_agreed) return course_.tell_status(action, Word::kAborted);
  take_place(action, terms, outcome.result);
}

void RoleTalks::take_place(const std::string& action, const interaction::Terms& terms,
                           const interaction::Rows& result) {
  RolePlay& play = course_.play();
  const interaction::Automaton& automaton = play.automaton();
  const config::Value* out = automaton[*automaton.find(action)].action()->out.find(kPlace);
  const auto place = place_of_member(self_, terms, result, *host_.world());
  PlaceComputed computed{my_.joint.subject,
                         play.role(),
                         out == nullptr ? action : out->scalar,
                         terms.modality,
                         place,
                         place ? "" : "it is not needed",
                         {}};
  if (out != nullptr && place) play.know(out->scalar, *place);
  if (out != nullptr && !place) play.forget(out->scalar, computed.why);
  host_.bus().emit(std::move(computed));
  if (!place) course_.tell(interaction::Message{terms.modality + ": not needed"});
  course_.tell_status(action, Word::kEnded);
}

}  // namespace skein::decision_node
