// SPDX-License-Identifier: Apache-2.0
#include "skein/journal/kinds.hpp"

#include "skein/journal/lines/deliberation.hpp"
#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/joint.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/run.hpp"
#include "skein/journal/lines/team.hpp"
#include "skein/journal/lines/truth.hpp"

namespace skein::journal {

namespace {

template <class... Line>
std::vector<Kind> described() {
  return {kind_of<Line>()...};
}

std::vector<Kind> all() {
  using namespace lines;
  return described<Mission, Phase, Step, Operator, Asked, Hand, Command, Degree, Held, LostUav,
                   FoundUav, Contact, Notice, Alarm, Perception, Seen, Request, Task, Sync,
                   Functional, Goal, Plan, Planned, Decision, Answer, Air, Meeting, Frontier, Joint,
                   Role, RoleTask, Place, Scm, Negotiation, GlobalMission, Owner, Token, Sale, Bid,
                   TeamTask, Message, Resumed, Route, Reach, Expired, Lost, Unsent, Dropped,
                   Transport, Link, Telemetry, Object, Fault, Process, Waiting, Expectation>();
}

}  // namespace

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> kAll = all();
  return kAll;
}

const Kind* find_kind(std::string_view name) {
  for (const Kind& one : kinds())
    if (one.name == name) return &one;
  return nullptr;
}

}  // namespace skein::journal
