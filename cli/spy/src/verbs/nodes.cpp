// SPDX-License-Identifier: Apache-2.0
// skein spy ps: who takes part.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "../text/table.hpp"
#include "skein/blackboard/program_description.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/joined.hpp"
#include "verbs.hpp"

namespace skein::spy_tool {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kLook = 2;  ///< [s]

struct Row {
  std::string guid, name, role, version;
  const Taking* taking = nullptr;
  const wire::DirectoryEntry* entry = nullptr;
  std::ptrdiff_t writers = 0, readers = 0;
};

std::vector<Row> rows_of(const Graph& graph) {
  std::vector<Row> rows;
  for (const auto& [guid, taking] : graph.participants()) {
    Row row{guid, graph.owner_of(guid), "", "", &taking, nullptr};
    const auto node = taking.node ? graph.directory().find(*taking.node) : graph.directory().end();
    if (node != graph.directory().end()) row.entry = &node->second;
    if (row.entry != nullptr) row.role = wire::name_of(row.entry->role);
    const auto said = blackboard::parse_program_description(taking.participant.description);
    if (said) row.version = said->version;
    for (const auto& [name, endpoint] : graph.endpoints())
      if (endpoint.participant == guid) ++(endpoint.writer ? row.writers : row.readers);
    rows.push_back(std::move(row));
  }
  std::ranges::sort(rows, {}, [](const Row& row) {
    return std::pair(row.entry == nullptr ? UINT32_MAX : row.entry->header.origin, row.name);
  });
  return rows;
}

void print_json(const Row& row, Duration now, std::ostream& out) {
  const Taking& taking = *row.taking;
  const auto age = [&](Duration since) { return (now - since).to_seconds(); };
  print_line({{"node", row.name},
              {"number", row.entry == nullptr ? Json() : Json(row.entry->header.origin)},
              {"role", row.role.empty() ? Json() : Json(row.role)},
              {"ready", row.entry == nullptr ? Json() : Json(row.entry->ready)},
              {"process", row.entry == nullptr ? Json() : Json(row.entry->process)},
              {"vendor", taking.participant.vendor},
              {"version", row.version.empty() ? Json() : Json(row.version)},
              {"addresses", taking.participant.addresses},
              {"writers", row.writers},
              {"readers", row.readers},
              {"known", age(taking.since)},
              {"heard", taking.heard ? Json(age(*taking.heard)) : Json()},
              {"guid", row.guid}},
             out);
}

void add_row(const Row& row, Duration now, Table& table) {
  const Taking& taking = *row.taking;
  table.add({row.name, row.role.empty() ? "-" : row.role,
             row.entry == nullptr ? "-"
             : row.entry->ready   ? "yes"
                                  : "no",
             row.entry == nullptr ? "-" : std::to_string(row.entry->process),
             taking.participant.vendor, row.version.empty() ? "-" : row.version,
             std::to_string(row.writers), std::to_string(row.readers),
             taking.heard ? fixed((now - *taking.heard).to_seconds(), 1) : "never",
             joined(taking.participant.addresses, " ")});
}

}  // namespace

int show_nodes(const SpyOptions& options, Listener& listener, std::ostream& out,
               std::ostream& err) {
  listener.read_only({wire::Slot::kDirectoryEntry, wire::Slot::kHeartbeat, wire::Slot::kClock});
  listener.listen(end_of(options, kLook), [](const Heard&) { return true; });
  if (listener.graph().participants().empty()) return nothing_heard(options, listener, 0, err);
  const Duration now = node::Waker::steady_now();
  Table table({"NODE", "ROLE", "READY", "PROCESS", "VENDOR", "SKEIN", "WRITERS", "READERS",
               "HEARD s AGO", "ADDRESSES"});
  for (const Row& row : rows_of(listener.graph())) {
    if (options.json) {
      print_json(row, now, out);
    } else {
      add_row(row, now, table);
    }
  }
  if (!options.json) table.print(out);
  return kExitOk;
}

}  // namespace skein::spy_tool
