// SPDX-License-Identifier: Apache-2.0
// A joint task whose members agree on where each of them goes.
#include <algorithm>

#include "interaction/agreed_places.hpp"
#include "interaction/interaction.hpp"

namespace skein::decision_node {

namespace {

using Kind = interaction::NegotiationOutcome::Kind;
using Word = interaction::Status::Word;

constexpr Duration kSession = Duration::milliseconds(10'000);
constexpr Duration kAskedAgain = Duration::milliseconds(1'000);
// Whoever does not answer, be it for a cut, is asked again; then the role goes on without a place.
constexpr Duration kAskedFor = Duration::milliseconds(30'000);
constexpr const char* kPlace = "place";  // of an action's `out`

}  // namespace

void JointPlay::negotiate_places(const std::string& action) {
  const interaction::Automaton& automaton = play_->automaton();
  const interaction::CoordinationAction& what = *automaton[*automaton.find(action)].action();
  const auto fails = [&](const std::string& why) {
    host_.bus().emit(Notice{my_.joint.subject + ": " + action + ": " + why});
    actions_.erase(action);
    tell_status(action, Word::kAborted);
  };
  const bool again = places_again_ && places_again_->action == action;
  const MissionTime until = again ? places_again_->until : now() + kAskedFor;
  places_again_.reset();
  interaction::BeginNegotiation begin;
  begin.subject = my_.joint.subject + "/" + what.modality;
  begin.modality = what.modality;
  begin.members = my_.parties_of(play_->role(), action, self_);
  auto terms = place_terms(what, play_->scope(), begin.members.size(), outlook());
  if (!terms) return fails(terms.error().why);
  begin.parameters = std::move(*terms);
  begin.within = kSession;
  actions_[action] = begin.subject;
  if (begin.members.size() == 1) return take_place_alone(begin);
  places_again_ = Again{action, std::nullopt, until};  // it may fail at once
  if (interaction_.begin(my_.joint, std::move(begin))) return;
  places_again_.reset();
  actions_.erase(action);
  tell_status(action, Word::kAborted);
}

// Of what it can do itself the best.
void JointPlay::take_place_alone(const interaction::BeginNegotiation& begin) {
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

void JointPlay::places_agreed(const interaction::Terms& terms,
                              const interaction::NegotiationOutcome& outcome) {
  const auto asked = std::find_if(actions_.begin(), actions_.end(),
                                  [&](const auto& one) { return one.second == terms.subject; });
  if (asked == actions_.end()) return;
  const std::string action = asked->first;
  if (outcome.kind != Kind::kAgreed)
    host_.bus().emit(Notice{my_.joint.subject + ": " + action + ": " + outcome.why});
  const bool asks = places_again_ && places_again_->action == action;
  if (outcome.kind != Kind::kAgreed && asks && now() + kAskedAgain < places_again_->until) {
    places_again_->at = now() + kAskedAgain;
    return;
  }
  if (asks) places_again_.reset();
  actions_.erase(asked);
  if (outcome.kind != Kind::kAgreed) return tell_status(action, Word::kAborted);
  const interaction::Automaton& automaton = play_->automaton();
  const config::Value* out = automaton[*automaton.find(action)].action()->out.find(kPlace);
  const auto place = place_of_member(self_, terms, outcome.result, *host_.world());
  PlaceComputed note{my_.joint.subject,
                     play_->role(),
                     out == nullptr ? action : out->scalar,
                     terms.modality,
                     place,
                     place ? "" : "it is not needed",
                     {}};
  if (out != nullptr && place) play_->know(out->scalar, *place);
  if (out != nullptr && !place) play_->forget(out->scalar);
  host_.bus().emit(std::move(note));
  if (!place) tell(interaction::Message{terms.modality + ": not needed"});
  tell_status(action, Word::kEnded);
}

}  // namespace skein::decision_node
