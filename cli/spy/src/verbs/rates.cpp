// SPDX-License-Identifier: Apache-2.0
// skein spy hz, bw, delay: of each flow, how often, how much and how late.
#include <nlohmann/json.hpp>
#include <ostream>
#include <tuple>

#include "../pulse.hpp"
#include "../text/table.hpp"
#include "skein/foundation/exit_code.hpp"
#include "verbs.hpp"

namespace skein::spy_tool {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kLook = 5;  ///< [s]
/// A reader that joins gets the histories of its writers in one burst, which has no rate and is
/// late.
constexpr Duration kHistory = Duration::milliseconds(500);

/// By numbers: names may come later than samples.
struct Key {
  std::string topic;
  std::uint32_t from = 0, to = 0;
  std::string participant;  ///< of whom, where the topic is none of ours
  auto operator<=>(const Key&) const = default;
};

class Pulses {
 public:
  Pulses(const SpyOptions& options, const Graph& graph) : options_(options), graph_(graph) {}

  void feel(const Heard& heard) {
    if (heard.gone()) return;
    const blackboard::SampleSeen& raw = heard.raw();
    const auto found = graph_.found(raw.writer);
    const bool keeps = heard.writer() != nullptr &&
                       heard.writer()->qos.durability != blackboard::Durability::kVolatile;
    if (keeps && found && raw.at - *found < kHistory) return;
    const double delay = raw.sent == 0 ? 0 : static_cast<double>(raw.heard - raw.sent) * 1e-9;
    place_of(heard)->second.beat(raw.at, raw.bytes.size(), delay);
  }

  bool empty() const { return pulses_.empty(); }

  void print(std::ostream& out) const {
    Table table(headings());
    for (const auto& [key, pulse] : pulses_) {
      const Row row = row_of(pulse);
      if (options_.json) {
        Json line{{"topic", key.topic},
                  {"from", from(key)},
                  {"to", destination_name(graph_, key.to)},
                  {"samples", pulse.samples()}};
        for (const auto& [name, value] : row) line[name] = value;
        print_line(line, out);
        continue;
      }
      std::vector<std::string> cells{key.topic, from(key), destination_name(graph_, key.to),
                                     std::to_string(pulse.samples())};
      for (const auto& [name, value] : row)
        cells.push_back(value.is_null() ? "-" : fixed(value.get<double>(), digits()));
      table.add(std::move(cells));
    }
    if (!options_.json) {
      table.print(out);
      out << std::flush;
    }
  }

 private:
  using Row = std::vector<std::pair<std::string, Json>>;

  std::map<Key, Pulse>::iterator place_of(const Heard& heard) {
    const std::string& writer = heard.raw().writer;
    const wire::SampleHeader header = heard.header();
    Key key{heard.raw().topic, header.origin, header.destination,
            heard.slot() ? "" : writer.substr(0, writer.find('.'))};
    return pulses_.try_emplace(std::move(key), options_.window).first;
  }

  std::string from(const Key& key) const {
    return key.participant.empty() ? graph_.name_of(key.from) : graph_.owner_of(key.participant);
  }

  int digits() const { return options_.verb == Verb::kBandwidth ? 0 : 4; }

  std::vector<std::string> headings() const {
    std::vector<std::string> all{"TOPIC", "FROM", "TO", "SAMPLES"};
    const auto add = [&](std::initializer_list<const char*> names) {
      all.insert(all.end(), names.begin(), names.end());
    };
    if (options_.verb == Verb::kRate) add({"RATE/s", "LEAST s", "GREATEST s", "DEVIATION s"});
    if (options_.verb == Verb::kBandwidth) add({"BYTE/s", "MEAN BYTE", "LEAST", "GREATEST"});
    if (options_.verb == Verb::kDelay) add({"MEAN s", "LEAST s", "GREATEST s", "99 OF 100 s"});
    return all;
  }

  Row row_of(const Pulse& pulse) const {
    switch (options_.verb) {
      case Verb::kBandwidth:
        return bandwidth_of(pulse);
      case Verb::kDelay:
        return delay_of(pulse);
      default:
        return rate_of(pulse);
    }
  }
  static Row rate_of(const Pulse& pulse) {
    const auto between = pulse.intervals();
    if (!between || between->mean <= 0)
      return {{"rate", {}}, {"least", {}}, {"greatest", {}}, {"deviation", {}}};
    return {{"rate", 1 / between->mean},
            {"least", between->least},
            {"greatest", between->greatest},
            {"deviation", between->deviation}};
  }
  static Row bandwidth_of(const Pulse& pulse) {
    const auto sizes = pulse.sizes();
    return {{"bytes_per_second", pulse.span() > 0 ? Json(pulse.bytes_per_second()) : Json()},
            {"mean", sizes->mean},
            {"least", sizes->least},
            {"greatest", sizes->greatest}};
  }
  static Row delay_of(const Pulse& pulse) {
    const auto delays = pulse.delays();
    return {{"mean", delays->mean},
            {"least", delays->least},
            {"greatest", delays->greatest},
            {"p99", delays->late}};
  }

  const SpyOptions& options_;
  const Graph& graph_;
  std::map<Key, Pulse> pulses_;
};

}  // namespace

int show_rates(const SpyOptions& options, Listener& listener, std::ostream& out,
               std::ostream& err) {
  Pulses pulses(options, listener.graph());
  const auto use = [&](const Heard& heard) {
    pulses.feel(heard);
    return true;
  };
  listen_and_show(options, listener, end_of(options, kLook), use, [&] { pulses.print(out); });
  if (pulses.empty() && !listener.interrupted()) return nothing_heard(options, listener, 0, err);
  return kExitOk;
}

}  // namespace skein::spy_tool
