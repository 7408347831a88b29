// SPDX-License-Identifier: Apache-2.0
// Any bytes as an automaton: errors, or an automaton that can be played to its end.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "skein/interaction/engine.hpp"
#include "skein/interaction/read_automaton.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace skein::interaction;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  auto automaton = read_automaton(text, "fuzz");
  if (!automaton) {
    if (automaton.error().empty()) std::abort();
    return 0;
  }
  Engine engine(std::make_shared<const Automaton>(std::move(*automaton)));
  const auto at = skein::MissionTime::seconds(1);
  (void)engine.handle(Start{}, at);
  for (const Componel& one : engine.automaton().componels()) {
    (void)engine.handle(Status{one.id, Status::Word::kEnded}, at);
  }
  (void)engine.handle(Abort{}, at);
  for (const Componel& one : engine.automaton().componels()) {
    (void)engine.handle(Status{one.id, Status::Word::kAborted}, at);
  }
  if (!engine.is_over()) std::abort();
  return 0;
}
