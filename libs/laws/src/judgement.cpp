// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/judgement.hpp"

#include <algorithm>

#include "by_cause.hpp"
#include "radio_limits.hpp"
#include "skein/laws/contact.hpp"
#include "skein/laws/healing.hpp"
#include "skein/laws/laws.hpp"
#include "skein/laws/protocol.hpp"

namespace skein::laws {

namespace {

using journal::Record;

void add(std::vector<Violation>& all, const char* law, const std::vector<std::string>& breaches) {
  for (const std::string& breach : breaches) all.push_back({law, 0, "", 0, breach});
}

HealingLimits limits_of(const scenario::Scenario& scenario, Duration late) {
  HealingLimits limits = healing_limits(scenario);
  for (Duration* limit : {&limits.healing, &limits.noticed, &limits.rerouting})
    *limit = *limit + late;
  return limits;
}

/// What has been transmitted when a link goes down arrives. Of a silent radio nobody is told of it:
/// what is being transmitted on a narrow one arrives too. That is no more than the channel carries
/// in two periods of heartbeats; longer events go in parts.
Duration comes_after_a_cut(const scenario::Scenario& scenario) {
  const scenario::RadioSpec& radio = scenario.radio;
  const Duration latency = greatest_latency(scenario);
  if (!radio.silent || !scenario::narrowest(radio)) return latency;
  return latency + radio.heartbeat + radio.heartbeat;
}

std::vector<Violation> judge_told(const scenario::Scenario& scenario,
                                  const std::vector<Record>& records, const Judging& judging) {
  const Duration late = judging.over_dds.value_or(Duration());
  const auto wants = [&](const char* law) {
    return judging.only.empty() ||
           std::find(judging.only.begin(), judging.only.end(), law) != judging.only.end();
  };
  std::vector<Violation> all = broken_laws(scenario, records, judging.only, late);
  // Over DDS a silent radio is cut by whatever carries the samples, if at all.
  const bool told_of_links = !(judging.over_dds && scenario.radio.silent);
  if (wants("protocol"))
    add(all, "protocol",
        broken_protocol(
            records, command_limit(scenario) + late,
            told_of_links ? std::optional(late + comes_after_a_cut(scenario)) : std::nullopt));
  if (wants("healing") && told_of_links)
    add(all, "healing", broken_healing(records, limits_of(scenario, late)));
  if (wants("contact") && !judging.over_dds)
    add(all, "contact", broken_contacts(scenario, records));
  return all;
}

}  // namespace

std::vector<Statement> judged_by() {
  std::vector<Statement> all;
  for (const Law& law : all_laws()) all.push_back({{law.name}, law.says});
  all.push_back({{"protocol"},
                 "tasks go through their states, commands are settled once, messages come once and "
                 "in order"});
  all.push_back(
      {{"healing"}, "what was waiting comes soon after a link is back, no event is lost unsaid"});
  all.push_back({{"contact"}, "nobody is in contact whom the radio does not connect"});
  return all;
}

std::vector<Violation> judge(const scenario::Scenario& scenario, const std::vector<Record>& records,
                             const Judging& judging) {
  if (!judging.over_dds) return judge_told(scenario, records, judging);
  return judge_told(scenario, by_cause(records, *judging.over_dds), judging);
}

}  // namespace skein::laws
