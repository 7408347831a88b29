// SPDX-License-Identifier: Apache-2.0
#include "skein/spy_tool/spy.hpp"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

#include "listener.hpp"
#include "skein/foundation/exit_code.hpp"
#include "traffic.hpp"

namespace skein::spy_tool {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kTableSeconds = 3;

const char* name_of(wire::Role role) {
  switch (role) {
    case wire::Role::kGround:
      return "ground";
    case wire::Role::kDdn:
      return "ddn";
    case wire::Role::kSim:
      return "sim";
    case wire::Role::kRunner:
      return "runner";
    case wire::Role::kOperator:
      return "operator";
    default:
      break;
  }
  return "spy";
}

const char* name_of(wire::SlotClass slot_class) {
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

std::string destination_name(const Listener& listener, std::uint32_t destination) {
  return destination == 0 ? "*" : listener.name_of(destination);
}

int open_or_say(Listener& listener, std::ostream& err) {
  const Diagnostics wrong = listener.check();
  if (!wrong.empty()) {
    err << to_text(wrong);
    return kExitBadInput;
  }
  const auto opened = listener.open();
  if (opened) return kExitOk;
  err << opened.error().why << '\n';
  return kExitSystem;
}

int nothing_heard(const SpyOptions& options, std::ostream& err) {
  err << "nothing heard on domain " << options.domain << " in";
  for (const std::string& partition : options.partitions) err << " '" << partition << "'";
  err << ": is anything running there, on these interfaces?\n";
  return kExitTimeout;
}

void print_tables(const Listener& listener, const std::vector<Flow>& flows, Duration now,
                  std::ostream& out) {
  out << "NODE        NUMBER  ROLE    VENDOR    PROCESS  READY\n";
  for (const auto& [number, entry] : listener.directory()) {
    out << std::left << std::setw(12) << entry.name << std::setw(8) << number << std::setw(8)
        << name_of(entry.role) << std::setw(10) << entry.vendor << std::setw(9) << entry.process
        << (entry.ready ? "yes" : "no") << '\n';
  }
  out << "\nSLOT              CLASS   FROM        TO          SAMPLES  RATE/s   LAST s AGO\n";
  for (const Flow& flow : flows) {
    out << std::left << std::setw(18) << wire::slot_name(flow.slot) << std::setw(8)
        << name_of(wire::slot_class(flow.slot)) << std::setw(12) << listener.name_of(flow.origin)
        << std::setw(12) << destination_name(listener, flow.destination) << std::setw(9)
        << flow.samples << std::fixed << std::setprecision(1) << std::setw(9) << flow.rate()
        << (now - flow.last).to_seconds();
    if (flow.malformed > 0) out << "   " << flow.malformed << " MALFORMED";
    out << '\n';
  }
}

void print_json(const Listener& listener, const std::vector<Flow>& flows, Duration now,
                std::ostream& out) {
  Json nodes = Json::array();
  for (const auto& [number, entry] : listener.directory()) {
    nodes.push_back({{"name", entry.name},
                     {"number", number},
                     {"role", name_of(entry.role)},
                     {"vendor", entry.vendor},
                     {"process", entry.process},
                     {"ready", entry.ready}});
  }
  Json slots = Json::array();
  for (const Flow& flow : flows) {
    slots.push_back({{"slot", wire::slot_name(flow.slot)},
                     {"class", name_of(wire::slot_class(flow.slot))},
                     {"from", listener.name_of(flow.origin)},
                     {"to", destination_name(listener, flow.destination)},
                     {"samples", flow.samples},
                     {"malformed", flow.malformed},
                     {"rate", flow.rate()},
                     {"age", (now - flow.last).to_seconds()}});
  }
  out << Json{{"nodes", nodes}, {"slots", slots}}.dump(2, ' ', false,
                                                       Json::error_handler_t::replace)
      << '\n';
}

// One sample on one line: as JSON, or for people.
void print_sample(const Heard& heard, const Listener& listener, bool json, std::ostream& out) {
  if (const auto* malformed = std::get_if<blackboard::Malformed>(&heard.content)) {
    const Json line{{"slot", wire::slot_name(malformed->slot)},
                    {"origin", malformed->header.origin},
                    {"malformed", malformed->violation.field},
                    {"why", malformed->violation.why}};
    out << line.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n' << std::flush;
    return;
  }
  const wire::Sample& sample = std::get<wire::Sample>(heard.content);
  const wire::SampleHeader& header = wire::header_of(sample);
  const std::string slot(wire::slot_name(wire::slot_of(sample)));
  if (json) {
    out << wire::to_json(sample) << '\n' << std::flush;
    return;
  }
  out << to_clock_text(MissionTime::nanoseconds(header.mission_time)) << "  " << slot << "  "
      << listener.name_of(header.origin) << " > " << destination_name(listener, header.destination)
      << "  #" << header.sequence_number << '\n'
      << wire::to_text(sample) << '\n'
      << std::flush;
}

}  // namespace

int list(const SpyOptions& options, std::ostream& out, std::ostream& err) {
  Listener listener(options);
  if (const int code = open_or_say(listener, err); code != kExitOk) return code;
  Traffic traffic;
  const double seconds = options.duration > 0 ? options.duration : kTableSeconds;
  const Duration until = node::Waker::steady_now() + Duration::seconds(seconds);
  listener.listen(until, [&](const Heard& heard) {
    if (const auto* sample = std::get_if<wire::Sample>(&heard.content)) {
      const wire::SampleHeader& header = wire::header_of(*sample);
      traffic.count(wire::slot_of(*sample), header.origin, header.destination, false, heard.at);
    } else {
      const auto& malformed = std::get<blackboard::Malformed>(heard.content);
      traffic.count(malformed.slot, malformed.header.origin, 0, true, heard.at);
    }
    return true;
  });
  const std::vector<Flow> flows = traffic.flows();
  const Duration now = node::Waker::steady_now();
  if (options.json) {
    print_json(listener, flows, now, out);
  } else if (!flows.empty()) {
    print_tables(listener, flows, now, out);
  }
  return flows.empty() ? nothing_heard(options, err) : kExitOk;
}

int echo(const SpyOptions& options, std::ostream& out, std::ostream& err) {
  Listener listener(options);
  if (const int code = open_or_say(listener, err); code != kExitOk) return code;
  std::uint64_t printed = 0;
  std::optional<Duration> until;
  if (options.duration > 0) {
    until = node::Waker::steady_now() + Duration::seconds(options.duration);
  }
  listener.listen(until, [&](const Heard& heard) {
    print_sample(heard, listener, options.json, out);
    return ++printed != options.count;
  });
  if (printed == 0 && !listener.interrupted()) return nothing_heard(options, err);
  return kExitOk;
}

}  // namespace skein::spy_tool
