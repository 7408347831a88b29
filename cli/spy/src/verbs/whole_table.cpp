// SPDX-License-Identifier: Apache-2.0
// skein spy without a verb: nodes, slots and rates.
#include <nlohmann/json.hpp>
#include <ostream>

#include "../text/table.hpp"
#include "../traffic.hpp"
#include "skein/foundation/exit_code.hpp"
#include "verbs.hpp"

namespace skein::spy_tool {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kTableSeconds = 3;

void print_tables(const Graph& graph, const std::vector<Flow>& flows, Duration now,
                  std::ostream& out) {
  Table nodes({"NODE", "NUMBER", "ROLE", "VENDOR", "PROCESS", "READY"});
  for (const auto& [number, entry] : graph.directory())
    nodes.add({entry.name, std::to_string(number), std::string(wire::name_of(entry.role)),
               entry.vendor, std::to_string(entry.process), entry.ready ? "yes" : "no"});
  nodes.print(out);
  out << '\n';
  Table slots({"SLOT", "CLASS", "FROM", "TO", "SAMPLES", "RATE/s", "LAST s AGO", ""});
  for (const Flow& flow : flows)
    slots.add({std::string(wire::slot_name(flow.slot)),
               std::string(name_of(wire::slot_class(flow.slot))), graph.name_of(flow.origin),
               destination_name(graph, flow.destination), std::to_string(flow.samples),
               fixed(flow.rate(), 1), fixed((now - flow.last).to_seconds(), 1),
               flow.malformed > 0 ? std::to_string(flow.malformed) + " MALFORMED" : ""});
  slots.print(out);
}

void print_json(const Graph& graph, const std::vector<Flow>& flows, Duration now,
                std::ostream& out) {
  Json nodes = Json::array();
  for (const auto& [number, entry] : graph.directory()) {
    nodes.push_back({{"name", entry.name},
                     {"number", number},
                     {"role", wire::name_of(entry.role)},
                     {"vendor", entry.vendor},
                     {"process", entry.process},
                     {"ready", entry.ready}});
  }
  Json slots = Json::array();
  for (const Flow& flow : flows) {
    slots.push_back({{"slot", wire::slot_name(flow.slot)},
                     {"class", name_of(wire::slot_class(flow.slot))},
                     {"from", graph.name_of(flow.origin)},
                     {"to", destination_name(graph, flow.destination)},
                     {"samples", flow.samples},
                     {"malformed", flow.malformed},
                     {"rate", flow.rate()},
                     {"age", (now - flow.last).to_seconds()}});
  }
  out << Json{{"nodes", nodes}, {"slots", slots}}.dump(2, ' ', false,
                                                       Json::error_handler_t::replace)
      << '\n';
}

}  // namespace

int show_table(const SpyOptions& options, Listener& listener, std::ostream& out,
               std::ostream& err) {
  Traffic traffic;
  listener.listen(end_of(options, kTableSeconds), [&](const Heard& heard) {
    if (!heard.slot() || heard.gone()) return true;
    const wire::SampleHeader header = heard.header();
    const bool malformed = heard.sample() == nullptr;
    traffic.count(*heard.slot(), header.origin, malformed ? 0 : header.destination, malformed,
                  heard.raw().at);
    return true;
  });
  const std::vector<Flow> flows = traffic.flows();
  const Duration now = node::Waker::steady_now();
  if (options.json) {
    print_json(listener.graph(), flows, now, out);
  } else if (!flows.empty()) {
    print_tables(listener.graph(), flows, now, out);
  }
  return flows.empty() ? nothing_heard(options, listener, 0, err) : kExitOk;
}

}  // namespace skein::spy_tool
