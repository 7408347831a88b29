// SPDX-License-Identifier: Apache-2.0
#include "compiled.hpp"

#include "skein/foundation/overloaded.hpp"

namespace skein::interaction {

Compiled::Compiled(const Automaton& automaton) : of_(automaton.size()) {
  for (ComponelIndex i = 0; i < automaton.size(); ++i) {
    const Block* block = automaton[i].block();
    if (block == nullptr) continue;
    compile({i, Side::kPrecondition}, block->precondition);
    compile({i, Side::kExit}, block->exit);
    for (const std::string& scm : block->scms) scm_blocks_[scm].push_back(i);
  }
}

void Compiled::compile(Watch watch, const Formula& formula) {
  const auto compile_literal = Overloaded{
      [&](const ComponelIs& is) { of_[is.componel].states.push_back(watch); },
      [&](const MessagePending& is) {
        std::vector<ComponelIndex>& blocks = listeners_[is.message];
        if (blocks.empty() || blocks.back() != watch.block) blocks.push_back(watch.block);
      },
      [&](const TimeIs& is) {
        of_[watch.block].timers[static_cast<std::size_t>(watch.side)].push_back(timers_.size());
        if (const auto* event = std::get_if<TimeIs::Event>(&is.since)) {
          of_[event->componel].event_timers.push_back(timers_.size());
        }
        timers_.push_back({watch, is});
      }};
  for (const Clause& clause : formula) {
    for (const Literal& literal : clause) std::visit(compile_literal, literal.condition);
  }
}

const std::vector<ComponelIndex>& Compiled::blocks_in(const ByName& by, const std::string& name) {
  static const std::vector<ComponelIndex> none;
  const auto found = by.find(name);
  return found == by.end() ? none : found->second;
}

}  // namespace skein::interaction
