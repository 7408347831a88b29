// SPDX-License-Identifier: Apache-2.0
#include "skein/allocate_tool/allocate.hpp"

#include <istream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "instance.hpp"
#include "skein/auction_lab/sale_simulation.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/trace_lines/read_lines.hpp"

namespace skein::allocate_tool {

namespace {

using namespace auction;
using Json = nlohmann::ordered_json;

SaleOutcome sell(const Instance& instance, const AllocateOptions& options) {
  SaleSetup setup;
  setup.lot = std::make_shared<const Catalogue>(instance.lot);
  setup.aim.equity = options.longest || !instance.tours ? 1 : 0;
  setup.seed = options.seed;
  std::vector<FlatCraft> crafts;
  for (const FlatVehicle& vehicle : instance.vehicles) {
    setup.holdings.push_back({MemberNumber(static_cast<std::uint32_t>(crafts.size())), {}, 0});
    crafts.emplace_back(vehicle, setup.lot);
  }
  std::vector<const Craft*> all;
  for (const FlatCraft& craft : crafts) all.push_back(&craft);
  SaleTransport transport;
  transport.seed = options.seed;
  return play_sale(std::move(setup), all, transport);
}

Json tours_of(const SaleOutcome& outcome) {
  Json tours = Json::array();
  for (const Auctioneer::Route& route : outcome.routes) {
    Json tour = Json::array();
    for (const TaskNumber task : route.tasks) tour.push_back(task.value());
    tours.push_back(std::move(tour));
  }
  return tours;
}

Json schedule_of(const SaleOutcome& outcome) {
  Json schedule = Json::object();
  for (const Auctioneer::Route& route : outcome.routes) {
    Json& own = schedule[std::to_string(route.member.value())] = Json::array();
    for (std::size_t i = 0; i < route.tasks.size(); ++i) {
      own.push_back({route.tasks[i].value(), route.starts[i]});
    }
  }
  return schedule;
}

// Why tasks were not sold, and what contradicts itself.
Json troubles_of(const SaleOutcome& outcome) {
  Json troubles = Json::array();
  for (const SaleEffect& told : outcome.told) {
    if (const auto* unsold = std::get_if<Unsold>(&told)) {
      Json reasons = Json::object();
      for (const auto& [member, why] : unsold->reasons) reasons[to_text(member)] = why;
      Json one{{"task", unsold->task.value()}, {"reasons", reasons}};
      if (!unsold->together.empty()) one["together"] = unsold->together;
      troubles.push_back(std::move(one));
    } else if (const auto* rejected = std::get_if<Rejected>(&told)) {
      for (const Contradiction& wrong : rejected->contradictions) {
        Json chain = Json::array();
        for (const TaskNumber task : wrong.chain) chain.push_back(task.value());
        troubles.push_back({{"tasks", chain}, {"contradiction", wrong.why}});
      }
    }
  }
  return troubles;
}

// Whether everything is sold.
bool write(const Instance& instance, const AllocateOptions& options, std::ostream& out) {
  const SaleOutcome outcome = sell(instance, options);
  const char* aim = !instance.tours ? "makespan" : options.longest ? "longest" : "sum";
  Json line{{"aim", aim}, {"value", outcome.value.first}};
  if (instance.tours)
    line["tours"] = tours_of(outcome);
  else
    line["schedule"] = schedule_of(outcome);
  line["messages"] = outcome.messages;
  line["rounds"] = outcome.rounds;
  const Json troubles = troubles_of(outcome);
  if (!troubles.empty()) line["unsold"] = troubles;
  out << line.dump() << '\n';
  return troubles.empty();
}

}  // namespace

int allocate(const AllocateOptions& options, std::istream& in, std::ostream& out,
             std::ostream& err) {
  Diagnostics problems;
  std::vector<Instance> instances;
  const auto problem = [&](std::size_t number, const std::string& why) {
    problems.add({options.file, static_cast<int>(number), 0, "", why, "", ""});
  };
  const bool read = trace_lines::read_lines(
      in, out,
      [&](std::size_t number, const std::string& text) {
        auto instance = read_instance(text, options.file, static_cast<int>(number), problems);
        if (instance) instances.push_back(std::move(*instance));
      },
      problem);
  if (!read) problem(0, "cannot be read to its end");
  if (!problems.empty()) {
    err << to_text(problems);
    return kExitBadInput;
  }
  bool all = true;
  for (const Instance& instance : instances) all = write(instance, options, out) && all;
  return all ? kExitOk : kExitNegative;
}

}  // namespace skein::allocate_tool
