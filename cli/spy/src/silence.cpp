// SPDX-License-Identifier: Apache-2.0
#include "silence.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <set>

#include "listener.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::spy_tool {

namespace {

using blackboard::Endpoint;

bool fits(const std::vector<std::string>& patterns, const std::string& name) {
  return std::ranges::any_of(patterns, [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
  });
}

/// What writers there are of what was asked for.
struct Writers {
  std::vector<const Endpoint*> matched;
  std::vector<std::string> refused;  ///< sentences
  std::set<std::string> elsewhere;   ///< partitions
};

void sort_in(const Endpoint& writer, const SpyOptions& options, const Graph& graph, Writers& into) {
  const auto slot = wire::slot_from_name(writer.topic);
  const bool any = options.slots.empty() && options.topics.empty();
  if (!slot || fits(options.topics, writer.topic)) {
    if (fits(options.topics, writer.topic)) into.matched.push_back(&writer);
    return;
  }
  if (!any && !fits(options.slots, writer.topic)) return;
  if (!blackboard::partitions_meet(writer.partitions, options.partitions)) {
    into.elsewhere.insert(writer.partitions.empty() ? "(none)" : writer.partitions.front());
    return;
  }
  const auto causes = refusals(writer, reader_of(*slot, options.partitions));
  if (causes.empty()) {
    into.matched.push_back(&writer);
  } else {
    into.refused.push_back(writer.topic + " of " + graph.owner_of(writer.participant) + ": " +
                           joined(causes, "; "));
  }
}

std::string asked_for(const SpyOptions& options) {
  std::vector<std::string> all = options.slots;
  all.insert(all.end(), options.topics.begin(), options.topics.end());
  std::string text = all.empty() ? "anything of ours" : joined(all, ", ");
  if (!options.topics.empty()) return text;
  return text + " in " + joined(options.partitions, ", ");
}

std::string at_most_four(const std::set<std::string>& names) {
  std::vector<std::string> some(names.begin(), names.end());
  const std::size_t more = some.size() > 4 ? some.size() - 4 : 0;
  some.resize(some.size() - more);
  return joined(some, ", ") + (more > 0 ? " and " + std::to_string(more) + " more" : "");
}

Silence silent(const Writers& writers, const SpyOptions& options, const Graph& graph) {
  std::set<std::string> names;
  for (const Endpoint* writer : writers.matched) names.insert(graph.owner_of(writer->participant));
  return {Silence::Cause::kSilent, std::to_string(writers.matched.size()) + " writers of " +
                                       asked_for(options) + " (" + at_most_four(names) +
                                       ") wrote nothing meanwhile"};
}

/// A sentence on the node asked for, if it is no number and nobody there has that name.
std::string nobody_called(const std::string& from, const Graph& graph) {
  const bool number = std::ranges::all_of(from, [](char c) { return c >= '0' && c <= '9'; });
  if (number) return "";
  std::vector<std::string> names;
  for (const auto& [guid, participant] : graph.participants())
    names.push_back(graph.owner_of(guid));
  if (std::ranges::find(names, from) != names.end()) return "";
  return "; nobody there is called '" + from + "'" + did_you_mean(nearest_name(from, names));
}

Silence cause_of_silence(const SpyOptions& options, const Graph& graph, std::uint64_t passed_over) {
  using Cause = Silence::Cause;
  const std::string domain = "domain " + std::to_string(options.domain);
  if (passed_over > 0)
    return {Cause::kFiltered, std::to_string(passed_over) + " samples came, none as asked for"};
  if (graph.participants().empty())
    return {Cause::kNobody,
            "nobody is on " + domain + ": is anything running there, on these interfaces?"};
  Writers writers;
  for (const auto& [guid, endpoint] : graph.endpoints())
    if (endpoint.writer) sort_in(endpoint, options, graph, writers);
  if (!writers.matched.empty()) return silent(writers, options, graph);
  if (!writers.refused.empty()) return {Cause::kRefused, joined(writers.refused, "; ")};
  std::string why = "nobody writes " + asked_for(options) + "; " +
                    std::to_string(graph.participants().size()) + " participants on " + domain;
  if (!writers.elsewhere.empty()) why += ", writers of it in " + at_most_four(writers.elsewhere);
  return {Cause::kNoWriter, why};
}

}  // namespace

Silence silence_of(const SpyOptions& options, const Graph& graph, std::uint64_t passed_over) {
  Silence silence = cause_of_silence(options, graph, passed_over);
  if (!graph.participants().empty()) silence.why += nobody_called(options.from, graph);
  return silence;
}

std::string_view name_of(Silence::Cause cause) {
  switch (cause) {
    case Silence::Cause::kNobody:
      return "nobody there";
    case Silence::Cause::kNoWriter:
      return "no writer";
    case Silence::Cause::kRefused:
      return "QoS refused";
    case Silence::Cause::kSilent:
      return "silent writer";
    case Silence::Cause::kFiltered:
      break;
  }
  return "nothing fits";
}

}  // namespace skein::spy_tool
