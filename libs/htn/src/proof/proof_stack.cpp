// SPDX-License-Identifier: Apache-2.0
#include "proof/proof_stack.hpp"

namespace skein::htn {

void ProofStack::pop_frames(std::size_t count) {
  while (frames.size() > count) {
    const Frame& frame = frames.back();
    if (frame.once) --once_frames;
    const bool owns_rows = frame.kind == FrameKind::kRows || frame.kind == FrameKind::kForall ||
                           frame.kind == FrameKind::kExists;
    if (owns_rows) sets_open = frame.set;
    frames.pop_back();
  }
}

std::uint32_t ProofStack::open_set() {
  if (sets_open == sets.size()) sets.emplace_back();
  sets[sets_open].clear();
  return sets_open++;
}

void ProofStack::keep_support(Frame& frame, const std::vector<CausalLink>& links) {
  support.insert(support.end(), links.begin(), links.end());
  frame.support = static_cast<std::uint32_t>(support.size());
}

void ProofStack::clear() {
  frames.clear();
  queries.clear();
  continuations.clear();
  support.clear();
  sets_open = 0;
  once_frames = 0;
}

std::size_t ProofStack::memory_bytes() const {
  std::size_t bytes = continuations.capacity() * sizeof(Continuation) +
                      frames.capacity() * sizeof(Frame) + support.capacity() * sizeof(CausalLink);
  for (const Answers& answers : sets) bytes += answers.memory_bytes();
  return bytes;
}

}  // namespace skein::htn
