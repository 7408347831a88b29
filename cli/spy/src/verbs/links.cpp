// SPDX-License-Identifier: Apache-2.0
// skein spy links: who hears whom.
#include "../links.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

#include "../text/table.hpp"
#include "skein/foundation/exit_code.hpp"
#include "verbs.hpp"

namespace skein::spy_tool {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kLook = 3;  ///< [s]

std::set<wire::Slot> slots_that_tell() {
  std::set<wire::Slot> slots{wire::Slot::kHeartbeat, wire::Slot::kLinkState,
                             wire::Slot::kDirectoryEntry, wire::Slot::kUavBoard,
                             wire::Slot::kJournalEntry};
  if (const auto neighbours = wire::slot_from_name("Neighbours")) slots.insert(*neighbours);
  return slots;
}

std::string yes_no(std::optional<bool> word) { return word ? (*word ? "yes" : "no") : "-"; }

void print(const std::vector<Link>& links, const SpyOptions& options, const Graph& graph,
           std::ostream& out) {
  const Duration now = node::Waker::steady_now();
  Table table({"FROM", "TO", "HEARD", "HEARTBEAT s AGO", "PERIOD s", "WAITING", "SIMULATOR"});
  for (const Link& link : links) {
    const auto ago =
        link.heartbeat ? std::optional((now - *link.heartbeat).to_seconds()) : std::nullopt;
    if (options.json) {
      print_line({{"from", graph.name_of(link.from)},
                  {"to", graph.name_of(link.to)},
                  {"heard", link.heard ? Json(*link.heard) : Json()},
                  {"heartbeat", ago ? Json(*ago) : Json()},
                  {"period", link.period ? Json(*link.period) : Json()},
                  {"waiting", link.waiting ? Json(*link.waiting) : Json()},
                  {"carried", link.carried ? Json(*link.carried) : Json()}},
                 out);
      continue;
    }
    table.add({graph.name_of(link.from), graph.name_of(link.to), yes_no(link.heard),
               ago ? fixed(*ago, 1) : "-", link.period ? fixed(*link.period, 2) : "-",
               link.waiting ? std::to_string(*link.waiting) : "-", yes_no(link.carried)});
  }
  if (!options.json && !table.empty()) table.print(out);
  out << std::flush;
}

}  // namespace

int show_links(const SpyOptions& options, Listener& listener, std::ostream& out,
               std::ostream& err) {
  listener.read_only(slots_that_tell());
  listener.without_history_of(wire::Slot::kJournalEntry);  // thousands of lines of each node
  Links links;
  const auto use = [&](const Heard& heard) {
    if (const wire::Sample* sample = heard.sample()) links.hear(*sample, heard.raw().at);
    return true;
  };
  listen_and_show(options, listener, end_of(options, kLook), use,
                  [&] { print(links.all(), options, listener.graph(), out); });
  if (links.all().empty() && !listener.interrupted())
    return nothing_heard(options, listener, 0, err);
  return kExitOk;
}

}  // namespace skein::spy_tool
