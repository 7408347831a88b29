// SPDX-License-Identifier: Apache-2.0
#include "domain.hpp"

#include <algorithm>
#include <cmath>

#include "../text/table.hpp"
#include "skein/blackboard/program_description.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/scenario/scenario_print.hpp"

namespace skein::spy_tool {

namespace {

using Grade = Finding::Grade;

constexpr double kClocksApart = 1.0;  ///< [s] more than any network takes

std::string joined(const std::set<std::string>& names) {
  return skein::joined({names.begin(), names.end()}, ", ");
}

}  // namespace

void Consultation::hear(const Heard& heard, const Graph& graph) {
  if (!heard.slot() || heard.gone()) return;
  const blackboard::SampleSeen& raw = heard.raw();
  const std::string participant = raw.writer.substr(0, raw.writer.find('.'));
  if (heard.sample() == nullptr) {
    const auto& malformed = std::get<blackboard::Malformed>(heard.content());
    ++malformed_[raw.topic + " of " + graph.owner_of(participant) + ": " +
                 malformed.violation.field + ": " + malformed.violation.why];
    return;
  }
  if (const auto* entry = std::get_if<wire::DirectoryEntry>(heard.sample())) {
    who_[entry->name].insert(participant);
    processes_[participant] = entry->process;
  } else if (const auto* beat = std::get_if<wire::Heartbeat>(heard.sample())) {
    const wire::SampleHeader& header = beat->header;  // others pass on what has come past them
    if (header.via.empty()) speakers_[header.origin].insert(participant);
  }
  if (wire::slot_class(*heard.slot()) != wire::SlotClass::kStream || raw.sent == 0) return;
  const double delay = static_cast<double>(raw.heard - raw.sent) * 1e-9;
  const auto [place, fresh] = least_delay_.try_emplace(participant, delay);
  if (!fresh) place->second = std::min(place->second, delay);
}

Findings Consultation::judge(const Graph& graph, std::uint32_t domain) const {
  Findings findings;
  const std::string name = "domain " + std::to_string(domain);
  if (graph.participants().empty()) {
    findings.push_back({Grade::kNote, "domain", "nobody is on " + name});
    return findings;
  }
  findings.push_back({Grade::kGood, "domain",
                      std::to_string(graph.participants().size()) + " participants with " +
                          std::to_string(graph.endpoints().size()) + " endpoints on " + name});
  judge_programs(graph, findings);
  judge_scenarios(graph, findings);
  judge_nodes(graph, findings);
  judge_types(graph, findings);
  for (const auto& [what, times] : malformed_)
    findings.push_back(
        {Grade::kBad, "samples", std::to_string(times) + " times malformed: " + what});
  judge_clocks(findings);
  return findings;
}

void Consultation::judge_programs(const Graph& graph, Findings& findings) const {
  const auto own = blackboard::program_description();
  std::map<std::string, std::set<std::string>> versions;
  std::set<std::string> others, foreign;
  for (const auto& [guid, taking] : graph.participants()) {
    const auto said = blackboard::parse_program_description(taking.participant.description);
    const std::string name = graph.owner_of(guid);
    if (!said) {
      foreign.insert(name);
      continue;
    }
    versions[said->version].insert(name);
    if (said->layout != own.layout) others.insert(name);
  }
  if (!others.empty())
    findings.push_back({Grade::kBad, "schemas",
                        "other layouts of samples than this program's (" + own.layout + ") have " +
                            joined(others)});
  if (others.empty() && !versions.empty())
    findings.push_back(
        {Grade::kGood, "schemas", "all programs of ours have the layout of samples " + own.layout});
  std::vector<std::string> words;
  for (const auto& [version, names] : versions) words.push_back(version + ": " + joined(names));
  if (!words.empty())
    findings.push_back({versions.size() > 1 ? Grade::kNote : Grade::kGood, "versions",
                        skein::joined(words, "; ")});
  if (!foreign.empty())
    findings.push_back(
        {Grade::kNote, "versions", "do not say which program they are: " + joined(foreign)});
}

// Those that most fly are what the others are compared with.
void Consultation::judge_scenarios(const Graph& graph, Findings& findings) const {
  std::map<std::string, std::set<std::string>> flown;
  for (const auto& [guid, taking] : graph.participants()) {
    const auto said = blackboard::parse_program_description(taking.participant.description);
    if (said && !said->scenario.empty()) flown[said->scenario].insert(graph.owner_of(guid));
  }
  if (flown.empty()) return;
  const auto most =
      std::ranges::max_element(flown, {}, [](const auto& one) { return one.second.size(); });
  if (flown.size() == 1)
    findings.push_back({Grade::kGood, "scenario", "all fly the same: " + joined(most->second)});
  for (const auto& [scenario, names] : flown) {
    if (scenario == most->first) continue;
    const auto sections = scenario::differing_sections(most->first, scenario);
    findings.push_back({Grade::kBad, "scenario",
                        joined(names) + " not the same as " + joined(most->second) + ": " +
                            (sections ? "differs in " + skein::joined(*sections, ", ")
                                      : "of another version of skein")});
  }
}

void Consultation::judge_nodes(const Graph& graph, Findings& findings) const {
  judge_names(graph, findings);
  std::set<std::string> waiting;
  for (const auto& [guid, taking] : graph.participants()) {
    const auto entry = taking.node ? graph.directory().find(*taking.node) : graph.directory().end();
    if (entry != graph.directory().end() && !entry->second.ready)
      waiting.insert(entry->second.name);
  }
  if (!waiting.empty())
    findings.push_back(
        {Grade::kNote, "nodes", "wait for somebody whom they have not heard: " + joined(waiting)});
}

void Consultation::judge_names(const Graph& graph, Findings& findings) const {
  auto who = who_;
  for (const auto& [number, participants] : speakers_)
    who[graph.name_of(number)].insert(participants.begin(), participants.end());
  for (const auto& [name, participants] : who) {
    std::vector<std::string> there;
    for (const std::string& one : participants)
      if (const auto taking = graph.participants().find(one); taking != graph.participants().end())
        there.push_back(describe(taking->second.participant));
    if (there.size() < 2) continue;
    findings.push_back({Grade::kBad, "nodes",
                        std::to_string(there.size()) + " programs say that they are " + name +
                            ": " + skein::joined(there, ", ")});
  }
}

std::string Consultation::describe(const blackboard::Participant& participant) const {
  const auto process = processes_.find(participant.guid);
  std::string text = process == processes_.end() ? "participant " + participant.guid
                                                 : "process " + std::to_string(process->second);
  if (participant.addresses.empty()) return text;
  return text + " at " + skein::joined(participant.addresses, " ");
}

void Consultation::judge_types(const Graph& graph, Findings& findings) const {
  std::set<std::string> wrong;
  for (const auto& [guid, endpoint] : graph.endpoints()) {
    const auto slot = wire::slot_from_name(endpoint.topic);
    if (!slot) continue;
    blackboard::Endpoint ours = reader_of(*slot, {});
    ours.qos = endpoint.qos;
    const std::string who = graph.owner_of(endpoint.participant);
    if (endpoint.type != ours.type || !endpoint.keyed)
      wrong.insert(endpoint.topic + " of " + who + " has the type " + endpoint.type +
                   (endpoint.keyed ? "" : ", without a key"));
    const auto causes =
        endpoint.writer ? refusals(endpoint, reader_of(*slot, {})) : std::vector<std::string>{};
    if (endpoint.type == ours.type && endpoint.keyed && !causes.empty())
      wrong.insert(endpoint.topic + " of " + who + ": " + skein::joined(causes, "; "));
  }
  for (const std::string& one : wrong) findings.push_back({Grade::kBad, "types", one});
  if (wrong.empty())
    findings.push_back({Grade::kGood, "types", "every topic of ours has its type and QoS"});
}

void Consultation::judge_clocks(Findings& findings) const {
  double least = 0, greatest = 0;
  for (const auto& [participant, delay] : least_delay_) {
    least = std::min(least, delay);
    greatest = std::max(greatest, delay);
  }
  if (greatest - least < kClocksApart) return;
  findings.push_back({Grade::kNote, "clocks",
                      "the machines' times of day differ, by " + fixed(greatest - least, 1) +
                          " s at least; mission time does not care, lifespans of DDS do"});
}

}  // namespace skein::spy_tool
