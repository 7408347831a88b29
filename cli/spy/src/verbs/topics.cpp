// SPDX-License-Identifier: Apache-2.0
// skein spy ls: topics, from discovery alone.
#include <fnmatch.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "../text/table.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/joined.hpp"
#include "verbs.hpp"

namespace skein::spy_tool {

namespace {

using blackboard::Endpoint;
using Json = nlohmann::ordered_json;

constexpr double kLook = 2;  ///< [s]

struct Topic {
  std::string name;
  std::set<std::string> types;
  std::vector<const Endpoint*> writers, readers;
  std::vector<std::string> mismatches;  ///< sentences
  std::size_t unmatched = 0;            ///< endpoints without a partner
};

/// Whether DDS brings the two together.
bool match(const Endpoint& writer, const Endpoint& reader) {
  return blackboard::partitions_meet(writer.partitions, reader.partitions) &&
         refusals(writer, reader).empty();
}

void judge(Topic& topic, const Graph& graph) {
  const auto alone = [&](const Endpoint* one, const auto& others) {
    return std::ranges::none_of(others, [&](const Endpoint* other) {
      return one->writer ? match(*one, *other) : match(*other, *one);
    });
  };
  std::set<std::string> sentences;
  for (const Endpoint* writer : topic.writers) {
    topic.unmatched += alone(writer, topic.readers) ? 1 : 0;
    for (const Endpoint* reader : topic.readers) {
      if (!blackboard::partitions_meet(writer->partitions, reader->partitions)) continue;
      for (const std::string& cause : refusals(*writer, *reader))
        sentences.insert(graph.owner_of(writer->participant) + " > " +
                         graph.owner_of(reader->participant) + ": " + cause);
    }
  }
  for (const Endpoint* reader : topic.readers)
    topic.unmatched += alone(reader, topic.writers) ? 1 : 0;
  topic.mismatches.assign(sentences.begin(), sentences.end());
}

bool asked_for(const std::string& name, const SpyOptions& options) {
  if (options.slots.empty() && options.topics.empty()) return true;
  for (const auto* patterns : {&options.slots, &options.topics})
    for (const std::string& pattern : *patterns)
      if (fnmatch(pattern.c_str(), name.c_str(), 0) == 0) return true;
  return false;
}

std::vector<Topic> topics_of(const Graph& graph, const SpyOptions& options) {
  std::map<std::string, Topic> by_name;
  for (const auto& [guid, endpoint] : graph.endpoints()) {
    if (!asked_for(endpoint.topic, options)) continue;
    Topic& topic = by_name[endpoint.topic];
    topic.name = endpoint.topic;
    topic.types.insert(endpoint.type);
    (endpoint.writer ? topic.writers : topic.readers).push_back(&endpoint);
  }
  std::vector<Topic> topics;
  for (auto& [name, topic] : by_name) {
    judge(topic, graph);
    const bool hidden = (options.unmatched && topic.unmatched == 0) ||
                        (options.mismatch && topic.mismatches.empty() && topic.types.size() < 2);
    if (!hidden) topics.push_back(std::move(topic));
  }
  return topics;
}

std::string text_of(const blackboard::EndpointQos& qos) {
  constexpr std::array<const char*, 4> kDurabilities{"volatile", "transient-local", "transient",
                                                     "persistent"};
  std::string text = qos.reliable ? "reliable" : "best-effort";
  text += std::string(" ") + kDurabilities[static_cast<std::size_t>(qos.durability)];
  if (qos.exclusive) text += " exclusive";
  if (qos.deadline != Duration::max()) text += " deadline " + fixed(qos.deadline.to_seconds(), 3);
  if (qos.lifespan != Duration::max()) text += " lifespan " + fixed(qos.lifespan.to_seconds(), 3);
  return text;
}

/// Of all writers, or readers if there are none; "various" where they differ.
std::string qos_of(const Topic& topic) {
  std::set<std::string> texts;
  for (const Endpoint* one : topic.writers.empty() ? topic.readers : topic.writers)
    texts.insert(text_of(one->qos));
  return texts.size() == 1 ? *texts.begin() : "various";
}

Json json_of(const Endpoint& endpoint, const Graph& graph) {
  return {{"kind", endpoint.writer ? "writer" : "reader"},
          {"node", graph.owner_of(endpoint.participant)},
          {"type", endpoint.type},
          {"partitions", endpoint.partitions},
          {"qos", text_of(endpoint.qos)},
          {"guid", endpoint.guid}};
}

void print_json(const Topic& topic, const SpyOptions& options, const Graph& graph,
                std::ostream& out) {
  const auto slot = wire::slot_from_name(topic.name);
  Json line{{"topic", topic.name},
            {"types", topic.types},
            {"class", slot ? Json(name_of(wire::slot_class(*slot))) : Json()},
            {"writers", topic.writers.size()},
            {"readers", topic.readers.size()},
            {"qos", qos_of(topic)},
            {"unmatched", topic.unmatched},
            {"mismatches", topic.mismatches}};
  if (options.endpoints) {
    line["endpoints"] = Json::array();
    for (const auto* side : {&topic.writers, &topic.readers})
      for (const Endpoint* one : *side) line["endpoints"].push_back(json_of(*one, graph));
  }
  print_line(line, out);
}

void print_text(const std::vector<Topic>& topics, const SpyOptions& options, const Graph& graph,
                std::ostream& out) {
  Table table({"TOPIC", "TYPE", "WRITERS", "READERS", "ALONE", "QOS"});
  for (const Topic& topic : topics) {
    table.add({topic.name, joined({topic.types.begin(), topic.types.end()}, " | "),
               std::to_string(topic.writers.size()), std::to_string(topic.readers.size()),
               std::to_string(topic.unmatched), qos_of(topic)});
    if (!options.endpoints) continue;
    for (const auto* side : {&topic.writers, &topic.readers})
      for (const Endpoint* one : *side)
        table.add({one->writer ? "  writer" : "  reader", graph.owner_of(one->participant), "", "",
                   "", text_of(one->qos) + " in " + joined(one->partitions, ", ")});
  }
  table.print(out);
  for (const Topic& topic : topics)
    for (const std::string& mismatch : topic.mismatches)
      out << topic.name << ": " << mismatch << '\n';
}

/// What none was found of.
const char* none_of(const SpyOptions& options) {
  if (options.mismatch) return "no topic with types or QoS that do not fit";
  return options.unmatched ? "no topic with an endpoint that is alone" : "no such topic";
}

}  // namespace

int show_topics(const SpyOptions& options, Listener& listener, std::ostream& out,
                std::ostream& err) {
  listener.read_only({});
  listener.listen(end_of(options, kLook), [](const Heard&) { return true; });
  const std::vector<Topic> topics = topics_of(listener.graph(), options);
  if (listener.graph().endpoints().empty()) return nothing_heard(options, listener, 0, err);
  if (options.json) {
    for (const Topic& topic : topics) print_json(topic, options, listener.graph(), out);
  } else if (!topics.empty()) {
    print_text(topics, options, listener.graph(), out);
  }
  if (topics.empty())
    err << none_of(options) << " among " << listener.graph().endpoints().size() << " endpoints\n";
  return kExitOk;
}

}  // namespace skein::spy_tool
