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

struct Words {
  const char* kind;
  const char* field;
  std::vector<std::string> words;
};

/// docs/journal.md names the same (architecture_documents), and a test flies whole missions to find
/// others.
const std::vector<Words>& counted_words() {
  static const std::vector<Words> kWords = {
      {"mission", "state", {"started", "resumed", "finished", "time-limit"}},
      {"command", "state", {"issued", "delivered", "acknowledged", "refused", "expired"}},
      {"task", "state", {"scheduled", "started", "running", "aborting", "ended", "aborted"}},
      {"goal",
       "state",
       {"received", "planned", "under-way", "achieved", "failed", "cancelled", "handed-over"}},
      {"alarm", "state", {"raised", "confirmed", "infirmed"}},
      {"functional", "state", {"running", "ended", "aborted"}},
      {"global-mission", "state", {"given", "refused", "done"}},
      {"owner", "stage", {"for-sale", "owned", "granted", "done", "unsold"}},
      {"sale", "state", {"sold", "traded", "unsold", "dropped", "rejected"}},
      {"token", "state", {"taken", "lost"}},
      {"team-task", "state", {"begun", "done", "put-back", "kept"}},
      {"held", "state", {"held", "resumed", "dropped"}},
      {"process", "state", {"started", "ready", "exited", "crashed"}},
  };
  return kWords;
}

void put_words(std::vector<Kind>& kinds) {
  for (const Words& counted : counted_words()) {
    for (Kind& kind : kinds) {
      if (kind.name != counted.kind) continue;
      for (Kind::Field& field : kind.fields)
        if (field.name == counted.field) field.words = counted.words;
    }
  }
}

std::vector<Kind> all() {
  using namespace lines;
  std::vector<Kind> kinds =
      described<Mission, Phase, Step, Operator, Asked, Hand, Command, Degree, Held, LostUav,
                FoundUav, Contact, Notice, Alarm, Perception, Seen, Request, Task, Sync, Functional,
                Goal, Plan, Planned, Decision, Answer, Air, Meeting, Frontier, Joint, Role,
                RoleTask, Place, Scm, Negotiation, GlobalMission, Owner, Token, Sale, Bid, TeamTask,
                Message, Resumed, Route, Reach, Expired, Lost, Unsent, Dropped, Transport, Link,
                Telemetry, Object, Fault, Process, Waiting, Expectation>();
  put_words(kinds);
  return kinds;
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
