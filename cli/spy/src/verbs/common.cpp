// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>
#include <ostream>

#include "../silence.hpp"
#include "skein/foundation/exit_code.hpp"
#include "verbs.hpp"

namespace skein::spy_tool {

Duration end_of(const SpyOptions& options, double fallback) {
  const double seconds = options.duration > 0 ? options.duration : fallback;
  return node::Waker::steady_now() + Duration::seconds(seconds);
}

int nothing_heard(const SpyOptions& options, const Listener& listener, std::uint64_t passed_over,
                  std::ostream& err) {
  const Silence silence = silence_of(options, listener.graph(), passed_over + listener.of_others());
  err << "nothing heard: " << name_of(silence.cause) << ": " << silence.why << '\n';
  for (const std::string& refused : listener.refused()) err << refused << '\n';
  return kExitTimeout;
}

void listen_and_show(const SpyOptions& options, Listener& listener, Duration end,
                     const Listener::Use& use, const std::function<void()>& show) {
  if (options.every > 0) {
    Duration next = node::Waker::steady_now() + Duration::seconds(options.every);
    while (next < end && !listener.interrupted()) {
      if (!listener.listen(next, use)) break;
      show();
      next = next + Duration::seconds(options.every);
    }
  }
  listener.listen(end, use);
  show();
}

void print_line(const nlohmann::ordered_json& object, std::ostream& out) {
  out << object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n'
      << std::flush;
}

std::string destination_name(const Graph& graph, std::uint32_t destination) {
  return destination == 0 ? "*" : graph.name_of(destination);
}

std::string_view name_of(wire::SlotClass slot_class) {
  switch (slot_class) {
    case wire::SlotClass::kState:
      return "state";
    case wire::SlotClass::kEvent:
      return "event";
    case wire::SlotClass::kStream:
      break;
  }
  return "stream";
}

}  // namespace skein::spy_tool
