// SPDX-License-Identifier: Apache-2.0
// skein spy events: who comes and goes, and what is said, a line each.
#include <nlohmann/json.hpp>
#include <ostream>

#include "../text/table.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/foundation/overloaded.hpp"
#include "verbs.hpp"

namespace skein::spy_tool {

namespace {

using Json = nlohmann::ordered_json;
using blackboard::Endpoint;

std::string participant_of(const std::string& endpoint) {
  return endpoint.substr(0, endpoint.find('.'));
}

/// Writes the lines and counts them.
class Chronicle {
 public:
  Chronicle(const SpyOptions& options, const Graph& graph, std::ostream& out)
      : options_(options), graph_(graph), out_(out), begun_(node::Waker::steady_now()) {}

  void tell(const blackboard::Sighting& sighting) {
    std::visit(Overloaded{[this](const blackboard::ParticipantSeen& seen) { tell_of(seen); },
                          [this](const blackboard::ParticipantGone& gone) {
                            line(gone.silent ? "silent" : "left", graph_.owner_of(gone.guid),
                                 {{"guid", gone.guid}});
                          },
                          [this](const blackboard::EndpointSeen& seen) { tell_of(seen); },
                          [this](const blackboard::EndpointGone& gone) { tell_of(gone); },
                          [](const blackboard::SampleSeen&) {}},
               sighting);
  }

  void tell(const Heard& heard) {
    const blackboard::SampleSeen& raw = heard.raw();
    const std::string owner = graph_.owner_of(participant_of(raw.writer));
    Json facts{{"topic", raw.topic}, {"partition", raw.partition}, {"size", raw.bytes.size()}};
    if (heard.gone()) return line("instance-gone", owner, facts);
    if (heard.slot()) {
      const wire::SampleHeader header = heard.header();
      facts["origin"] = graph_.name_of(header.origin);
      facts["to"] = destination_name(graph_, header.destination);
      facts["sequence"] = header.sequence_number;
    }
    line(heard.slot() && heard.sample() == nullptr ? "malformed" : "sample", owner, facts);
  }

  void sum_up(std::ostream& err) const {
    std::vector<std::string> sums;
    for (const auto& [what, times] : counts_) sums.push_back(std::to_string(times) + " " + what);
    err << (sums.empty() ? "nothing seen" : joined(sums, ", ")) << '\n';
  }
  bool empty() const { return counts_.empty(); }
  /// As many lines as were asked for.
  bool full() const { return options_.count > 0 && lines_ >= options_.count; }

 private:
  void tell_of(const blackboard::ParticipantSeen& seen) {
    // Sightings of the same content are told of again and again by some vendors.
    auto& known = participants_[seen.participant.guid];
    if (known == seen.participant) return;
    const bool fresh = known.guid.empty();
    known = seen.participant;
    line(fresh ? "joined" : "changed", graph_.owner_of(known.guid),
         {{"vendor", known.vendor}, {"addresses", known.addresses}, {"guid", known.guid}});
  }

  void tell_of(const blackboard::EndpointSeen& seen) {
    Endpoint& known = endpoints_[seen.endpoint.guid];
    if (known == seen.endpoint) return;
    const std::string what = seen.endpoint.writer ? "writer" : "reader";
    const bool fresh = known.guid.empty();
    known = seen.endpoint;
    line((fresh ? "new-" : "changed-") + what, graph_.owner_of(known.participant),
         {{"topic", known.topic}, {"type", known.type}, {"partitions", known.partitions}});
  }

  void tell_of(const blackboard::EndpointGone& gone) {
    const auto known = endpoints_.find(gone.guid);
    if (known == endpoints_.end()) return;
    line(known->second.writer ? "writer-gone" : "reader-gone",
         graph_.owner_of(known->second.participant),
         {{"topic", known->second.topic}, {"partitions", known->second.partitions}});
    endpoints_.erase(known);
  }

  void line(const std::string& what, const std::string& who, const Json& facts) {
    ++counts_[what];
    ++lines_;
    const double at = (node::Waker::steady_now() - begun_).to_seconds();
    if (options_.json) {
      Json whole{{"at", at}, {"event", what}, {"node", who}};
      whole.update(facts);
      return print_line(whole, out_);
    }
    out_ << fixed(at, 3) << "  " << what << "  " << who;
    for (const auto& [key, value] : facts.items())
      out_ << "  " << key << "="
           << (value.is_string() ? value.get<std::string>()
                                 : value.dump(-1, ' ', false, Json::error_handler_t::replace));
    out_ << '\n' << std::flush;
  }

  const SpyOptions& options_;
  const Graph& graph_;
  std::ostream& out_;
  Duration begun_;
  std::map<std::string, blackboard::Participant> participants_;
  std::map<std::string, Endpoint> endpoints_;
  std::map<std::string, std::uint64_t> counts_;
  std::uint64_t lines_ = 0;
};

}  // namespace

int show_events(const SpyOptions& options, Listener& listener, std::ostream& out,
                std::ostream& err) {
  Chronicle chronicle(options, listener.graph(), out);
  listener.on_sighting([&](const blackboard::Sighting& sighting) {
    chronicle.tell(sighting);
    return !chronicle.full();
  });
  std::optional<Duration> end;
  if (options.duration > 0) end = end_of(options, 0);
  listener.listen(end, [&](const Heard& heard) {
    chronicle.tell(heard);
    return !chronicle.full();
  });
  listener.on_sighting({});
  if (chronicle.empty() && !listener.interrupted()) return nothing_heard(options, listener, 0, err);
  chronicle.sum_up(err);
  return kExitOk;
}

}  // namespace skein::spy_tool
