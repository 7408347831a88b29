// SPDX-License-Identifier: Apache-2.0
#include "entries.hpp"

#include <set>
#include <tuple>

#include "skein/blackboard/cdr.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::store::testing {

namespace {

namespace fs = std::filesystem;
using node::NodeNumber;

template <std::size_t... I>
std::vector<wire::Sample> every_sample(std::index_sequence<I...>) {
  return {wire::Sample(std::in_place_index<I>)...};
}

std::string words_of(const node::LoggedInput& input) {
  const auto numbers = [](auto... all) {
    std::string text;
    ((text += std::to_string(all) + " "), ...);
    return text;
  };
  return std::visit(
      Overloaded{
          [&](const node::Started& one) { return numbers(one.incarnation, int{one.first_life}); },
          [&](const node::Received& one) {
            std::vector<std::uint8_t> bytes(blackboard::encoded_size(one.sample));
            blackboard::encode(one.sample, bytes);
            return numbers(one.from.value(), one.sample.index()) +
                   std::string(bytes.begin(), bytes.end());
          },
          [&](const node::Reachability& one) {
            return numbers(one.peer.value(), int{one.reachable}, int{one.restarted});
          },
          [&](const node::Undelivered& one) {
            return numbers(one.to.value(), static_cast<int>(one.slot), one.sequence, one.receipt,
                           int{one.may_have_arrived});
          },
          [&](const node::Delivered& one) { return numbers(one.to.value(), one.receipt); },
          [&](const node::JobEnded& one) {
            return numbers(one.id, int{one.clock.given}, int{one.clock.ran_out},
                           one.clock.questions);
          },
          [&](const node::Unsent& one) { return numbers(one.send); },
          [&](const node::Skipped& one) {
            return numbers(static_cast<int>(one.slot), one.header.origin, one.header.incarnation,
                           one.header.sequence_number);
          },
          [&](const node::Acknowledged& one) { return numbers(one.peer.value(), one.sequence); },
          [&](const auto&) { return std::string(); }},
      input);
}

}  // namespace

std::vector<node::LogEntry> one_of_each() {
  std::vector<node::LoggedInput> inputs{node::Started{77, true}};
  for (wire::Sample& sample : every_sample(std::make_index_sequence<wire::kSlotCount>())) {
    wire::SampleHeader& header = wire::header_of(sample);
    header.origin = 11;
    header.incarnation = 1'790'000'000'000'000'001;
    header.sequence_number = 5;
    inputs.emplace_back(node::Received{NodeNumber(11), std::move(sample)});
  }
  node::Skipped skipped{wire::Slot::kTaskEvent, {}};
  skipped.header.origin = 12;
  skipped.header.incarnation = 3;
  skipped.header.sequence_number = 9;
  for (node::LoggedInput& input : std::vector<node::LoggedInput>{
           node::Reachability{NodeNumber(1), true, false},
           node::Reachability{NodeNumber(2), false, true},
           node::Undelivered{NodeNumber(12), wire::Slot::kSyncMessage, 41},
           node::Undelivered{NodeNumber(12), wire::Slot::kTaskRequest, 42, 1ULL << 40, false},
           node::Delivered{NodeNumber(12), 1ULL << 40}, node::Wakeup{}, node::JobEnded{8, {}},
           node::JobEnded{9, {true, false, 12}}, node::JobEnded{10, {true, true, 1ULL << 40}},
           node::Resumed{}, node::Unsent{6}, skipped, node::Acknowledged{NodeNumber(3), 640},
           node::Restarted{}})
    inputs.push_back(std::move(input));
  std::vector<node::LogEntry> entries;
  for (node::LoggedInput& input : inputs)
    entries.push_back(
        {MissionTime() + Duration::milliseconds(100 * static_cast<std::int64_t>(entries.size())),
         std::move(input)});
  return entries;
}

std::string to_text(const node::LogEntry& entry) {
  return std::to_string(entry.at.count()) + " " + std::to_string(entry.input.index()) + " " +
         words_of(entry.input);
}

std::string Folder::names() const {
  std::set<std::string> sorted;
  for (const auto& entry : fs::directory_iterator(path())) sorted.insert(entry.path().filename());
  std::string names;
  for (const std::string& name : sorted) names += name + " ";
  return names;
}

}  // namespace skein::store::testing
