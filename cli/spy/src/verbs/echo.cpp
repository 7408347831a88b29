// SPDX-License-Identifier: Apache-2.0
// skein spy echo: samples as they come.
#include <nlohmann/json.hpp>
#include <ostream>

#include "../text/condition.hpp"
#include "../text/hexadecimal.hpp"
#include "../text/path.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/joined.hpp"
#include "verbs.hpp"

namespace skein::spy_tool {

namespace {

using Json = nlohmann::ordered_json;

std::vector<wire::Slot> wanted_slots(const Listener& listener) {
  std::vector<wire::Slot> slots;
  for (std::size_t i = 0; i < wire::kSlotCount; ++i)
    if (listener.wanted(static_cast<wire::Slot>(i))) slots.push_back(static_cast<wire::Slot>(i));
  return slots;
}

/// Prints what passes the condition.
class Printer {
 public:
  /// Precondition: the options were checked.
  Printer(const SpyOptions& options, const Listener& listener, std::ostream& out)
      : options_(options), graph_(listener.graph()), out_(out) {
    if (!options.where.empty()) where_ = std::move(*Condition::parse(options.where));
    for (const std::string& field : options.fields) fields_.push_back(*parse_path(field));
  }

  /// False if it was not what was asked for.
  bool print(const Heard& heard) {
    if (heard.gone()) return false;
    if (!heard.slot()) return print_foreign(heard);
    if (heard.sample() == nullptr) return print_malformed(heard);
    const wire::Sample& sample = *heard.sample();
    if (!where_ && fields_.empty()) return print_whole(sample);
    const Json json = Json::parse(wire::to_json(sample));
    if (where_ && !where_->holds(json)) return false;
    return fields_.empty() ? print_whole(sample) : print_fields(json, heard);
  }

 private:
  bool print_whole(const wire::Sample& sample) {
    const wire::SampleHeader& header = wire::header_of(sample);
    if (!options_.json)
      out_ << to_clock_text(MissionTime::nanoseconds(header.mission_time)) << "  "
           << wire::slot_name(wire::slot_of(sample)) << "  " << graph_.name_of(header.origin)
           << " > " << destination_name(graph_, header.destination) << "  #"
           << header.sequence_number << '\n';
    out_ << (options_.json ? wire::to_json(sample) : wire::to_text(sample)) << '\n' << std::flush;
    return true;
  }

  bool print_fields(const Json& sample, const Heard& heard) {
    Json found = Json::object();
    std::vector<std::string> texts;
    bool any = false;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const auto values = values_at(sample, fields_[i]);
      Json value = values.size() == 1 ? *values.front() : Json::array();
      if (values.size() > 1)
        for (const Json* one : values) value.push_back(*one);
      any = any || !values.empty();
      found[options_.fields[i]] = values.empty() ? Json() : value;
      texts.push_back(value.is_string() ? value.get<std::string>() : value.dump());
    }
    if (!any) return false;
    if (options_.json) {
      print_line({{"slot", wire::slot_name(*heard.slot())},
                  {"origin", heard.header().origin},
                  {"fields", found}},
                 out_);
    } else {
      out_ << joined(texts, "\t") << '\n' << std::flush;
    }
    return true;
  }

  bool print_malformed(const Heard& heard) {
    if (where_) return false;
    const auto& malformed = std::get<blackboard::Malformed>(heard.content());
    print_line({{"slot", wire::slot_name(malformed.slot)},
                {"origin", malformed.header.origin},
                {"malformed", malformed.violation.field},
                {"why", malformed.violation.why}},
               out_);
    return true;
  }

  bool print_foreign(const Heard& heard) {
    if (where_ || !fields_.empty()) return false;
    const blackboard::SampleSeen& raw = heard.raw();
    const std::string type = heard.writer() == nullptr ? "" : heard.writer()->type;
    const std::string from = graph_.owner_of(raw.writer.substr(0, raw.writer.find('.')));
    if (options_.json) {
      print_line({{"topic", raw.topic},
                  {"type", type},
                  {"from", from},
                  {"partition", raw.partition},
                  {"size", raw.bytes.size()},
                  {"bytes", hexadecimal(raw.bytes)}},
                 out_);
      return true;
    }
    out_ << raw.topic << "  " << type << "  from " << from << ", " << raw.bytes.size() << " bytes\n"
         << hexadecimal_lines(raw.bytes) << std::flush;
    return true;
  }

  const SpyOptions& options_;
  const Graph& graph_;
  std::ostream& out_;
  std::optional<Condition> where_;
  std::vector<Path> fields_;
};

void check_one(const std::string& option, const std::string& text, const SpyOptions& options,
               const Listener& listener, Diagnostics& diagnostics) {
  const auto path = parse_path(text);
  if (!path) {
    diagnostics.add({"", 0, 0, option, path.error().why, "names with dots: task.id", ""});
  } else if (options.topics.empty()) {
    const Diagnostics unknown = check_path(*path, text, wanted_slots(listener));
    for (Diagnostic one : unknown.all()) {
      one.path = option;
      diagnostics.add(std::move(one));
    }
  }
}

}  // namespace

Diagnostics check_echo(const SpyOptions& options, const Listener& listener) {
  Diagnostics diagnostics;
  for (const std::string& field : options.fields)
    check_one("--field", field, options, listener, diagnostics);
  if (options.where.empty()) return diagnostics;
  const auto where = Condition::parse(options.where);
  if (!where) {
    diagnostics.add({"", 0, 0, "--where", where.error().why,
                     "a condition: task.id > 3 && uav == 'marvin'", ""});
    return diagnostics;
  }
  for (const std::string& path : where->paths())
    check_one("--where", path, options, listener, diagnostics);
  return diagnostics;
}

int echo(const SpyOptions& options, Listener& listener, std::ostream& out, std::ostream& err) {
  Printer printer(options, listener, out);
  std::uint64_t printed = 0, passed_over = 0;
  const auto use = [&](const Heard& heard) {
    if (heard.gone()) return true;
    ++(printer.print(heard) ? printed : passed_over);
    return printed == 0 || printed != options.count;
  };
  std::optional<Duration> end;
  if (options.duration > 0) end = end_of(options, 0);
  bool more = true;
  if (options.timeout > 0) {  // until the first one
    Duration first = node::Waker::steady_now() + Duration::seconds(options.timeout);
    if (end && *end < first) first = *end;
    more = listener.listen(first, [&](const Heard& heard) { return use(heard) && printed == 0; }) ||
           (printed > 0 && printed != options.count);
    if (printed == 0 && !listener.interrupted())
      return nothing_heard(options, listener, passed_over, err);
  }
  if (more) listener.listen(end, use);
  if (printed == 0 && !listener.interrupted())
    return nothing_heard(options, listener, passed_over, err);
  return kExitOk;
}

}  // namespace skein::spy_tool
