// SPDX-License-Identifier: Apache-2.0
#include "book/entry.hpp"

#include <algorithm>
#include <array>

#include "skein/foundation/contract.hpp"

namespace skein::supervisor {

namespace {

struct Transition {
  Stage from;
  Step step;
  Stage to;
};

constexpr std::array kTransitions{
    Transition{Stage::kPlanned, Step::kGive, Stage::kGiven},
    Transition{Stage::kPlanned, Step::kWithdraw, Stage::kDropped},
    Transition{Stage::kPlanned, Step::kAbort, Stage::kLost},
    Transition{Stage::kGiven, Step::kOrder, Stage::kOrdered},
    Transition{Stage::kGiven, Step::kWithdraw, Stage::kWithdrawn},
    Transition{Stage::kGiven, Step::kEnd, Stage::kDone},
    Transition{Stage::kGiven, Step::kAbort, Stage::kLost},
    Transition{Stage::kOrdered, Step::kWithdraw, Stage::kWithdrawn},
    Transition{Stage::kOrdered, Step::kEnd, Stage::kDone},
    Transition{Stage::kOrdered, Step::kAbort, Stage::kLost},
    Transition{Stage::kDone, Step::kWithdraw, Stage::kPastDone},
    Transition{Stage::kLost, Step::kWithdraw, Stage::kPastLost},
    Transition{Stage::kLost, Step::kExcuse, Stage::kDone},
    // Somebody else may give it though it was dropped here.
    Transition{Stage::kDropped, Step::kGive, Stage::kWithdrawn},
    Transition{Stage::kDropped, Step::kAbort, Stage::kPastLost},
    Transition{Stage::kWithdrawn, Step::kStop, Stage::kStopping},
    Transition{Stage::kWithdrawn, Step::kEnd, Stage::kPastDone},
    Transition{Stage::kWithdrawn, Step::kAbort, Stage::kPastLost},
    Transition{Stage::kStopping, Step::kEnd, Stage::kPastDone},
    Transition{Stage::kStopping, Step::kAbort, Stage::kPastLost},
};

constexpr std::array<std::string_view, 10> kStages{
    "planned",   "given",    "ordered",         "done",           "lost", "dropped",
    "withdrawn", "stopping", "done, withdrawn", "lost, withdrawn"};
constexpr std::array<std::string_view, 7> kSteps{"give", "order", "withdraw", "stop",
                                                 "end",  "abort", "excuse"};

}  // namespace

std::string_view to_text(Stage stage) { return kStages.at(static_cast<std::size_t>(stage)); }
std::string_view to_text(Step step) { return kSteps.at(static_cast<std::size_t>(step)); }

std::optional<Stage> after(Stage stage, Step step) {
  const auto found =
      std::find_if(kTransitions.begin(), kTransitions.end(),
                   [&](const Transition& one) { return one.from == stage && one.step == step; });
  return found == kTransitions.end() ? std::nullopt : std::optional(found->to);
}

void Entry::advance(Step step) {
  const std::optional<Stage> next = after(stage_, step);
  SKEIN_EXPECTS(next.has_value());
  stage_ = *next;
}

}  // namespace skein::supervisor
