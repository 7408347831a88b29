// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/contact.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "radio_limits.hpp"
#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"
#include "told_links.hpp"
#include "ways.hpp"

namespace skein::laws {

namespace {

namespace lines = journal::lines;

using journal::Record;
using journal::Written;

/// What is heard may have been under way for so long [over one link].
constexpr Duration kUnderWay = Duration::milliseconds(500);

/// Where a link is narrow, behind so many others.
constexpr int kBefore = 3;

class ContactJudge {
 public:
  explicit ContactJudge(const scenario::Scenario& scenario)
      : relays_(scenario.radio.relays.begin(), scenario.radio.relays.end()),
        under_way_(kUnderWay +
                   Duration::seconds(kBefore * airtime_of_an_event(scenario.radio).to_seconds())) {
    const std::vector<std::string> uavs = scenario.uav_names();
    nodes_.insert(uavs.begin(), uavs.end());
    nodes_.insert("ground");
  }

  std::vector<std::string> judge(const std::vector<Record>& records) {
    for (const Record& record : records)
      journal::hand_on<lines::Link, lines::Reach, lines::Fault>(record, *this);
    if (is_mortal_ || !links_.are_told()) return {};
    for (const Contact& contact : contacts_)
      if (!may_be(contact)) breach(contact);
    return std::move(breaches_);
  }

  void hear(const lines::Link& line, const Written& when) {
    links_.tell(line.from, line.to, line.up, when.at);
  }
  void hear(const lines::Reach& line, const Written& when) {
    if (line.reachable && nodes_.contains(line.peer) && nodes_.contains(when.node))
      contacts_.push_back({when.at, line.peer, when.node});
  }
  void hear(const lines::Fault& line, const Written&) {
    is_mortal_ = is_mortal_ || (line.what == "kill" && line.target == "sim");
  }

 private:
  struct Contact {
    MissionTime at;
    std::string of, by;
  };

  bool may_be(const Contact& contact) const {
    for (std::size_t links = 1; links <= relays_.size() + 1; ++links) {
      const auto since =
          contact.at - Duration::nanoseconds(under_way_.count() * static_cast<std::int64_t>(links));
      const auto carried = [&](const std::string& from, const std::string& to) {
        return links_.were_up(from, to, since, contact.at);
      };
      if (has_way(contact.of, contact.by, relays_, links, carried)) return true;
    }
    return false;
  }

  void breach(const Contact& contact) {
    breaches_.push_back(to_text(contact.at) + " s: " + contact.by + " is in contact with " +
                        contact.of + ", from which no link leads to it");
  }

  std::set<std::string> relays_, nodes_;
  Duration under_way_;
  ToldLinks links_;
  std::vector<Contact> contacts_;
  bool is_mortal_ = false;
  std::vector<std::string> breaches_;
};

}  // namespace

std::vector<std::string> broken_contacts(const scenario::Scenario& scenario,
                                         const std::vector<Record>& records) {
  return ContactJudge(scenario).judge(records);
}

}  // namespace skein::laws
