// SPDX-License-Identifier: Apache-2.0
#include "skein/state_tool/state.hpp"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/store/state_file.hpp"

namespace skein::state_tool {

namespace {

using Json = nlohmann::ordered_json;
using store::StateFile;

constexpr int kNotSound = 1;

constexpr const char* kAnew = "; a daemon sets it aside and begins anew";

/// Why a daemon would not go on from it, and what it does; empty if it would.
std::string objection(const StateFile& file) {
  if (file.over) return "its mission is over; the next one sets it aside and begins its own";
  if (!file.of_this_wire)
    return std::string("of a program with other messages: only that goes on from it") + kAnew;
  if (!file.complete)
    return std::string("incomplete: not all that was handled could be kept") + kAnew;
  return {};
}

void show(const StateFile& file, std::ostream& out) {
  const std::string why_not = objection(file);
  out << file.identity.node << " in mission " << file.identity.mission << '\n'
      << "  " << file.inputs << " inputs in " << file.lives
      << (file.lives == 1 ? " life" : " lives") << ", mission time " << file.from.to_seconds()
      << " s to " << file.until.to_seconds() << " s\n"
      << "  " << file.lines << " lines of the event log, " << file.bytes << " bytes on disk\n"
      << "  " << (why_not.empty() ? "a daemon would go on from it" : "not gone on from: " + why_not)
      << '\n';
  for (const auto& [kind, count] : file.by_kind)
    out << "  " << std::setw(8) << count << "  " << kind << '\n';
}

Json to_json(const StateFile& file) {
  Json kinds = Json::object();
  for (const auto& [kind, count] : file.by_kind) kinds[kind] = count;
  return {{"node", file.identity.node},
          {"mission", file.identity.mission},
          {"version", file.version},
          {"over", file.over},
          {"complete", file.complete},
          {"inputs", file.inputs},
          {"lives", file.lives},
          {"lines", file.lines},
          {"bytes", file.bytes},
          {"from_s", file.from.to_seconds()},
          {"until_s", file.until.to_seconds()},
          {"kinds", kinds}};
}

void add(Json& line, const node::LoggedInput& input) {
  std::visit(Overloaded{[&](const node::Started& one) {
                          line["kind"] = "started";
                          line["incarnation"] = one.incarnation;
                        },
                        [&](const node::Received& one) {
                          line["kind"] = "received";
                          line["from"] = one.from.value();
                          line["slot"] = wire::slot_name(wire::slot_of(one.sample));
                          line["sample"] = Json::parse(wire::to_json(one.sample));
                        },
                        [&](const node::Reachability& one) {
                          line["kind"] = "reachability";
                          line["peer"] = one.peer.value();
                          line["reachable"] = one.reachable;
                          line["restarted"] = one.restarted;
                        },
                        [&](const node::Undelivered& one) {
                          line["kind"] = "undelivered";
                          line["to"] = one.to.value();
                          line["slot"] = wire::slot_name(one.slot);
                          line["sequence"] = one.sequence;
                          line["receipt"] = one.receipt;
                          line["may_have_arrived"] = one.may_have_arrived;
                        },
                        [&](const node::Delivered& one) {
                          line["kind"] = "delivered";
                          line["to"] = one.to.value();
                          line["receipt"] = one.receipt;
                        },
                        [&](const node::Wakeup&) { line["kind"] = "wakeup"; },
                        [&](const node::JobEnded& one) {
                          line["kind"] = "job";
                          line["job"] = one.id;
                          line["cut_short"] = one.clock.ran_out;
                        },
                        [&](const node::Resumed&) { line["kind"] = "resumed"; },
                        [&](const node::Restarted&) { line["kind"] = "restarted"; },
                        [&](const node::Unsent& one) {
                          line["kind"] = "unsent";
                          line["send"] = one.send;
                        },
                        [&](const node::Skipped& one) {
                          line["kind"] = "skipped";
                          line["from"] = one.header.origin;
                          line["sequence"] = one.header.sequence_number;
                        },
                        [&](const node::Acknowledged& one) {
                          line["kind"] = "acknowledged";
                          line["peer"] = one.peer.value();
                          line["sequence"] = one.sequence;
                        }},
             input);
}

int refuse(const Failure& failure, int code, std::ostream& err) {
  err << "skein state: " << failure.why << '\n';
  return code;
}

int export_all(const StateOptions& options, std::ostream& out, std::ostream& err) {
  const auto read =
      store::for_each_input(options.file, [&](std::uint64_t number, const node::LogEntry& entry) {
        Json line{{"number", number}, {"at", entry.at.to_seconds()}};
        add(line, entry.input);
        out << line.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
      });
  return read ? kExitOk : refuse(read.error(), kExitBadInput, err);
}

}  // namespace

int state(const StateOptions& options, std::ostream& out, std::ostream& err) {
  if (options.what == StateOptions::What::kExport) return export_all(options, out, err);
  const bool checks = options.what == StateOptions::What::kCheck;
  if (const std::string why = store::unreadable(options.file); !why.empty())
    return refuse({options.file + ": " + why}, kExitBadInput, err);
  const auto file = store::examine(options.file);
  if (!file && checks) return refuse({file.error().why + kAnew}, kNotSound, err);
  if (!file) return refuse(file.error(), kExitBadInput, err);
  if (checks) {
    const std::string why_not = objection(*file);
    if (!why_not.empty()) return refuse({options.file + ": " + why_not}, kNotSound, err);
    out << options.file << ": sound, " << file->inputs << " inputs\n";
  } else if (options.json) {
    out << to_json(*file).dump(2) << '\n';
  } else {
    show(*file, out);
  }
  return kExitOk;
}

}  // namespace skein::state_tool
