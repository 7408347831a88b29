// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/protocol.hpp"

#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "ways.hpp"

namespace skein::laws {

namespace {

using journal::Record;

constexpr double kMoment = 0.5;  ///< [s] more than any latency of a test
/// Long messages are numbered from here on, and have an order of their own.
constexpr std::int64_t kFirstLongMessage = std::int64_t{1} << 50;

std::string text(const Record& record, const char* key) { return std::string(record.text(key)); }
std::int64_t whole(const Record& record, const char* key) {
  return static_cast<std::int64_t>(record.number(key));
}

class Checker {
 public:
  explicit Checker(Duration command_limit) : command_limit_(command_limit) {}

  std::vector<std::string> check(const std::vector<Record>& records) {
    for (const Record& record : records) {
      see(record);
      last_ = record.at();
    }
    for (const auto& [number, command] : commands_) unsettled(number, command);
    return std::move(breaches_);
  }

 private:
  struct Command {
    MissionTime issued;
    bool delivered = false, settled = false;
  };
  using Task = std::tuple<std::string, std::string, std::int64_t>;  ///< MLE at, UAV, id
  using Job = std::pair<std::string, std::int64_t>;                 ///< UAV, id
  using Channel = std::pair<std::string, std::string>;              ///< from, to
  using Rendezvous = std::tuple<std::int64_t, std::string, std::string>;

  void see(const Record& record) {
    if (record.at() < last_) breach(record, "time goes back");
    const std::string& kind = record.kind();
    if (kind == "task") see_task(record);
    if (kind == "degree") see_degree(text(record, "uav"));
    if (kind == "command") see_command(record);
    if (kind == "sync") see_sync(record);
    if (kind == "message") see_message(record);
    if (kind == "link") see_link(record);
    if (kind == "route" && record.find("via") != nullptr) relays_.insert(text(record, "via"));
    if (kind == "fault") see_fault(record);
  }

  void breach(const Record& record, const std::string& why) {
    breaches_.push_back(to_text(record.at()) + " s: " + why + ": " + journal::to_json(record));
  }

  static bool may_follow(std::string_view before, std::string_view after) {
    static const std::set<std::pair<std::string_view, std::string_view>> kAllowed{
        {"", "scheduled"},        {"", "aborted"},        {"scheduled", "started"},
        {"scheduled", "aborted"}, {"started", "running"}, {"started", "ended"},
        {"started", "aborting"},  {"started", "aborted"}, {"running", "ended"},
        {"running", "aborting"},  {"running", "aborted"}, {"aborting", "aborted"}};
    return kAllowed.count({before, after}) > 0;
  }

  void see_task(const Record& record) {
    const Job job{text(record, "uav"), whole(record, "task")};
    std::string& state = tasks_[{record.node(), job.first, job.second}];
    const std::string next = text(record, "state");
    if (!may_follow(state, next) && !may_go_on(job, next)) {
      breach(record, "a task goes from '" + state + "' to '" + next + "'");
    }
    state = latest_[job] = next;
  }

  // What is not over may change hands with the degree: who takes it over goes on where the other
  // was, or begins with telling that it has it.
  void see_degree(const std::string& uav) {
    for (const auto& [job, state] : latest_) {
      if (job.first == uav && state != "ended" && state != "aborted") handed_over_[job] = state;
    }
  }

  bool may_go_on(const Job& job, const std::string& next) {
    const auto handed = handed_over_.find(job);
    if (handed == handed_over_.end()) return false;
    const bool allowed = next == "scheduled" || may_follow(handed->second, next);
    handed_over_.erase(handed);
    return allowed;
  }

  void see_command(const Record& record) {
    const std::int64_t number = whole(record, "command");
    const bool issue = record.text("state") == "issued";
    const auto known = commands_.find(number);
    if (issue) {
      if (known != commands_.end()) breach(record, "a command is issued twice");
      commands_[number] = {record.at()};
      return;
    }
    const std::string state = text(record, "state");
    const std::string what = state == "delivered" ? "delivered" : "settled";
    if (known == commands_.end())
      return breach(record, "a command is " + what + " before its issue");
    Command& command = known->second;
    if (command.settled) breach(record, "a command is " + what + " twice or after its end");
    if (record.at() > command.issued + command_limit_) {
      breach(record, "a command is " + what + " too late");
    }
    if (state == "delivered") return see_delivered(record, command);
    if (state == "acknowledged" && !command.delivered) {
      breach(record, "a command is acknowledged that was not delivered");
    }
    command.settled = true;
  }

  void see_delivered(const Record& record, Command& command) {
    if (command.delivered) breach(record, "a command is delivered twice");
    command.delivered = true;
  }

  void unsettled(std::int64_t number, const Command& command) {
    if (command.settled || command.issued + command_limit_ >= last_) return;
    breaches_.push_back("command " + std::to_string(number) + " of " + to_text(command.issued) +
                        " s was never settled");
  }

  void see_sync(const Record& record) {
    const Rendezvous rendezvous{whole(record, "id"), text(record, "from"), text(record, "to")};
    if (record.text("direction") == "sent") {
      syncs_.insert(rendezvous);
    } else if (syncs_.count(rendezvous) == 0) {
      breach(record, "a synchronisation message nobody sent is received");
    }
  }

  void see_message(const Record& record) {
    const Channel channel{text(record, "from"), text(record, "to")};
    const std::int64_t sequence = whole(record, "sequence");
    if (record.text("direction") == "sent") {
      sent_[channel].insert(sequence);
      return;
    }
    if (sent_[channel].count(sequence) == 0) breach(record, "a message nobody sent is received");
    std::int64_t& last = (sequence < kFirstLongMessage ? received_ : received_long_)[channel];
    if (sequence <= last) breach(record, "a message is received twice or late");
    last = sequence;
    if (!may_have_come(channel, record.at())) {
      breach(record, "a message is received over a link that is down");
    }
  }

  // Over the link itself, or past nodes that somebody has told to be relays: a moment a link.
  bool may_have_come(const Channel& channel, MissionTime at) const {
    for (std::size_t links = 1; links <= relays_.size() + 1; ++links) {
      const Duration moment = Duration::seconds(kMoment * static_cast<double>(links));
      const auto carries = [&](const std::string& from, const std::string& to) {
        const auto down = down_since_.find({from, to});
        return down == down_since_.end() || at <= down->second + moment;
      };
      if (has_way(channel.first, channel.second, relays_, links, carries)) return true;
    }
    return false;
  }

  void see_link(const Record& record) {
    const Channel channel{text(record, "from"), text(record, "to")};
    if (simulator_dead_) {
      unheard_[channel] = record.truth("up");
    } else {
      set_link(channel, record.truth("up"), record.at());
    }
  }

  void set_link(const Channel& channel, bool up, MissionTime at) {
    if (up) {
      down_since_.erase(channel);
    } else {
      down_since_.emplace(channel, at);
    }
  }

  // As long as there is no simulator, its radio stays as it was.
  void see_fault(const Record& record) {
    const std::string what = text(record, "what"), target = text(record, "target");
    const bool comes_back = what == "restart" || what == "resume";
    if (what == "restart") see_birth(target);
    if (target != "sim") return;
    simulator_dead_ = what == "kill" || (simulator_dead_ && !comes_back);
    if (simulator_dead_) return;
    for (const auto& [channel, up] : unheard_) set_link(channel, up, record.at());
    unheard_.clear();
  }

  // What the node knew is gone: the plans of its MLEs, what it has received, its commands.

  // It knows nothing, and numbers its messages anew.
  void see_birth(const std::string& node) {
    std::erase_if(tasks_, [&](const auto& one) { return std::get<0>(one.first) == node; });
    for (auto* one : {&received_, &received_long_})
      std::erase_if(*one, [&](const auto& last) { return last.first.second == node; });
    if (node == "ground") commands_.clear();
    const auto from_node = [&](const auto& one) { return one.first.first == node; };
    std::erase_if(sent_, from_node);
    for (auto* one : {&received_, &received_long_}) std::erase_if(*one, from_node);
  }

  Duration command_limit_;
  MissionTime last_;
  std::map<Task, std::string> tasks_;
  std::map<Job, std::string> latest_;       ///< whoever told it
  std::map<Job, std::string> handed_over_;  ///< as it was when the degree changed
  std::map<std::int64_t, Command> commands_;
  std::set<Rendezvous> syncs_;
  std::map<Channel, std::set<std::int64_t>> sent_;
  std::map<Channel, std::int64_t> received_, received_long_;
  std::map<Channel, MissionTime> down_since_;
  std::set<std::string> relays_;  ///< past whom somebody has told that its samples go
  bool simulator_dead_ = false;
  std::map<Channel, bool> unheard_;  ///< that nobody is told before it is back
  std::vector<std::string> breaches_;
};

}  // namespace

std::vector<std::string> broken_protocol(const std::vector<Record>& records,
                                         Duration command_limit) {
  return Checker(command_limit).check(records);
}

std::string to_text(const std::vector<std::string>& breaches) {
  std::string text;
  for (const std::string& breach : breaches) text += breach + "\n";
  return text;
}

}  // namespace skein::laws
