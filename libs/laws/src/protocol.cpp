// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/protocol.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"
#include "told_links.hpp"
#include "ways.hpp"

namespace skein::laws {

namespace {

namespace lines = journal::lines;

using journal::Record;
using journal::Written;

constexpr Duration kSettling = Duration::milliseconds(6'000);
/// Life of the words that another UAV is lost, or found again (docs/interaction.md).
constexpr Duration kNews = Duration::milliseconds(600'000);
/// On the way from a vehicle to its UAV's decision node.
constexpr Duration kOnBoard = Duration::milliseconds(500);
constexpr double kMoment = 0.5;  ///< [s] more than any latency of a test
/// Long messages are numbered from here on, and have an order of their own.
constexpr std::uint64_t kFirstLongMessage = std::uint64_t{1} << 50;

class Checker {
 public:
  Checker(Duration command_limit, std::optional<Duration> late)
      : command_limit_(command_limit), late_(late) {}

  std::vector<std::string> check(const std::vector<Record>& records) {
    for (const Record& record : records) {
      if (record.kind() == lines::Fault::kKind && record.text("what") == "kill")
        deaths_[std::string(record.text("target"))].push_back(record.at());
    }
    for (const Record& record : records) {
      if (record.at() < last_) breach(record, "time goes back");
      const bool read =
          journal::hand_on<lines::Task, lines::Functional, lines::Degree, lines::Command,
                           lines::Sync, lines::Message, lines::Link, lines::Route, lines::Fault,
                           lines::Resumed, lines::Unsent>(record, *this);
      if (!read) breach(record, "a line lacks what one of its kind must have");
      last_ = record.at();
    }
    for (const auto& [number, command] : commands_) unsettled(number, command);
    return std::move(breaches_);
  }

  void hear(const lines::Task& line, const Written& when) {
    const Job job{line.uav, line.task};
    std::string& state = tasks_[{when.node, job.first, job.second}];
    if (!may_follow(state, line.state) && !may_go_on(when.node, job, line.state))
      breach(when.record, "a task goes from '" + state + "' to '" + line.state + "'");
    if (when.node == line.uav && line.state == "aborted" && has_answer(job, state, when.at) &&
        line.reason.ends_with("no answer within the time-out"))
      breach(when.record, "a task is aborted for want of an answer that its UAV was sent");
    state = latest_[job] = line.state;
  }

  void hear(const lines::Functional& line, const Written& when) {
    answers_[{line.uav, line.task}] = {line.state, when.at};
  }

  // What is not over may change hands with the degree: who takes it over goes on where the other
  // was, or begins with telling that it has it. The other one may not know yet, and goes on with
  // what it took over itself before: each does so once.
  void hear(const lines::Degree& line, const Written&) {
    for (const auto& [job, state] : latest_)
      if (job.first == line.uav && state != "ended" && state != "aborted")
        handed_over_[job] = {state, {}};
  }

  void hear(const lines::Command& line, const Written& when) {
    const auto known = commands_.find(line.command);
    if (line.state == "issued") {
      if (known != commands_.end()) breach(when.record, "a command is issued twice");
      commands_[line.command] = {when.at, ground_away(when.at), limit_of(line)};
      return;
    }
    const std::string what = line.state == "delivered" ? "delivered" : "settled";
    if (known == commands_.end())
      return breach(when.record, "a command is " + what + " before its issue");
    Command& command = known->second;
    if (command.settled) breach(when.record, "a command is " + what + " twice or after its end");
    if (age_of(command, when.at) > command.limit)
      breach(when.record, "a command is " + what + " too late");
    if (line.state == "delivered") return see_delivered(when.record, command);
    if (line.state == "acknowledged" && !command.delivered)
      breach(when.record, "a command is acknowledged that was not delivered");
    command.settled = true;
  }

  void hear(const lines::Sync& line, const Written& when) {
    const Rendezvous rendezvous{line.id, line.from, line.to};
    if (line.direction == "sent") {
      syncs_.insert(rendezvous);
    } else if (!syncs_.contains(rendezvous) && !took_words_with_it(line.from, when.at)) {
      breach(when.record, "a synchronisation message nobody sent is received");
    }
  }

  void hear(const lines::Message& line, const Written& when) {
    const Channel channel{line.from, line.to};
    if (line.direction == "sent") {
      sent_[channel].insert_or_assign(line.sequence, when.at);
      return;
    }
    const auto sent = sent_[channel].find(line.sequence);
    if (sent == sent_[channel].end() && !took_words_with_it(line.from, when.at))
      breach(when.record, "a message nobody sent is received");
    std::uint64_t& last = (line.sequence < kFirstLongMessage ? received_ : received_long_)[channel];
    if (line.sequence <= last) breach(when.record, "a message is received twice or late");
    last = line.sequence;
    const MissionTime since = sent == sent_[channel].end() ? when.at : sent->second;
    if (!may_have_come(channel, since, when.at))
      breach(when.record, "a message is received over a link that is down");
  }

  void hear(const lines::Link& line, const Written& when) {
    const Channel channel{line.from, line.to};
    if (line.from == kEveryLink) {
      others_are_up_ = line.up;
      if (!line.up) others_down_since_ = when.at;
    } else if (simulator_dead_) {
      unheard_[channel] = line.up;
    } else {
      set_link(channel, line.up, when.at);
    }
  }

  void hear(const lines::Route& line, const Written&) {
    if (!line.via.empty()) relays_.insert(line.via);
  }

  void hear(const lines::Unsent& line, const Written& when) {
    const bool is_wrong = line.why == "malformed" || line.why == "too long";
    if (is_wrong) breach(when.record, "a node has something to say that the wire does not take");
    if (line.why == "no channel to there for this slot")
      breach(when.record, "a node speaks to where no channel leads");
  }

  // As long as there is no simulator, its radio stays as it was.
  void hear(const lines::Fault& line, const Written& when) {
    const bool comes_back = line.what == "restart" || line.what == "resume";
    if (line.what == "restart") see_birth(line.target);
    if (line.target == "ground" && line.what == "kill" && !ground_dead_since_)
      ground_dead_since_ = when.at;
    if (line.target == "ground" && line.what == "restart") see_ground_back(when.at);
    if (line.target != "sim") return;
    simulator_dead_ = line.what == "kill" || (simulator_dead_ && !comes_back);
    if (simulator_dead_) return;
    for (const auto& [channel, up] : unheard_) set_link(channel, up, when.at);
    unheard_.clear();
  }

  void hear(const lines::Resumed&, const Written& when) {
    if (when.node == "ground") see_ground_back(when.at);
  }

 private:
  struct Command {
    MissionTime issued;
    Duration away_before;  ///< that the ground station was dead before its issue
    Duration limit;        ///< until it is settled
    bool delivered = false, settled = false;
  };
  struct HandedOver {
    std::string state;               ///< as it was when the degree changed
    std::set<std::string> taken_by;  ///< MLEs
  };
  struct Said {
    std::string state;
    MissionTime at;
  };
  using Task = std::tuple<std::string, std::string, std::uint64_t>;  ///< MLE at, UAV, id
  using Job = std::pair<std::string, std::uint64_t>;                 ///< UAV, id
  using Channel = std::pair<std::string, std::string>;               ///< from, to
  using Rendezvous = std::tuple<std::uint64_t, std::string, std::string>;

  void breach(const Record& record, const std::string& why) {
    breaches_.push_back(to_text(record.at()) + " s: " + why + ": " + journal::to_json(record));
  }

  /// A process that is killed takes with it the lines of what it has just said; the clocks of
  /// others may differ from the runner's as much as they may be late.
  bool took_words_with_it(const std::string& node, MissionTime at) const {
    const auto found = deaths_.find(node);
    if (found == deaths_.end() || !late_ || *late_ == Duration()) return false;
    return std::ranges::any_of(found->second, [&](MissionTime death) {
      return at >= death - *late_ && at <= death + *late_;
    });
  }

  /// The vehicle has said before that the task runs, to a UAV that waits for it to begin, or that
  /// it is over.
  bool has_answer(const Job& job, std::string_view state, MissionTime at) const {
    const auto answer = answers_.find(job);
    if (answer == answers_.end() || answer->second.at + kOnBoard >= at) return false;
    const std::string& said = answer->second.state;
    return said == "ended" || said == "aborted" || (said == "running" && state == "started");
  }

  static bool may_follow(std::string_view before, std::string_view after) {
    static const std::set<std::pair<std::string_view, std::string_view>> kAllowed{
        {"", "scheduled"},        {"", "aborted"},        {"scheduled", "started"},
        {"scheduled", "aborted"}, {"started", "running"}, {"started", "ended"},
        {"started", "aborting"},  {"started", "aborted"}, {"running", "ended"},
        {"running", "aborting"},  {"running", "aborted"}, {"aborting", "aborted"}};
    return kAllowed.count({before, after}) > 0;
  }

  bool may_go_on(const std::string& mle, const Job& job, const std::string& next) {
    const auto handed = handed_over_.find(job);
    if (handed == handed_over_.end() || !handed->second.taken_by.insert(mle).second) return false;
    return next == "scheduled" || may_follow(handed->second.state, next);
  }

  // Words of who is lost or found again are news for longer than commands are.
  Duration limit_of(const lines::Command& line) const {
    const std::string& what = line.what;
    const bool is_news =
        what.starts_with("PROCESS-MSG lost ") || what.starts_with("PROCESS-MSG found ");
    return is_news ? std::max(command_limit_, kNews + kSettling) : command_limit_;
  }

  void see_delivered(const Record& record, Command& command) {
    if (command.delivered) breach(record, "a command is delivered twice");
    command.delivered = true;
  }

  void see_ground_back(MissionTime at) {
    ground_away_ = ground_away(at);
    ground_dead_since_.reset();
  }

  /// For how long the ground station has been dead until then, over all its deaths.
  Duration ground_away(MissionTime at) const {
    return ground_dead_since_ ? ground_away_ + (at - *ground_dead_since_) : ground_away_;
  }

  /// How long a command has been open to its ground station, which settles none while it is dead.
  Duration age_of(const Command& command, MissionTime at) const {
    return (at - command.issued) - (ground_away(at) - command.away_before);
  }

  void unsettled(std::uint64_t number, const Command& command) {
    if (command.settled || age_of(command, last_) <= command.limit) return;
    breaches_.push_back("command " + std::to_string(number) + " of " + to_text(command.issued) +
                        " s was never settled");
  }

  // Over the link itself, or past nodes that somebody has told to be relays: a moment a link. With
  // a relay it may wait until the next link has room, and may have left the first before it went
  // down.
  bool may_have_come(const Channel& channel, MissionTime sent, MissionTime at) const {
    if (!late_) return true;
    for (std::size_t links = 1; links <= relays_.size() + 1; ++links) {
      const Duration moment = Duration::seconds(kMoment * static_cast<double>(links)) + *late_;
      const auto carries = [&](const std::string& from, const std::string& to) {
        const auto down = down_since_.find({from, to});
        const bool is_down = down != down_since_.end();
        if (!is_down && (others_are_up_ || told_.contains({from, to}))) return true;
        const MissionTime since = is_down ? down->second : others_down_since_;
        return (links == 1 ? at : sent) <= since + moment;
      };
      if (has_way(channel.first, channel.second, relays_, links, carries)) return true;
    }
    return false;
  }

  void set_link(const Channel& channel, bool up, MissionTime at) {
    told_.insert(channel);
    if (up) {
      down_since_.erase(channel);
    } else {
      down_since_.emplace(channel, at);
    }
  }

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
  std::optional<Duration> late_;
  std::map<std::string, std::vector<MissionTime>> deaths_;  ///< by node, all of the run
  MissionTime last_;
  std::map<Task, std::string> tasks_;
  std::map<Job, Said> answers_;        ///< of vehicles, last
  std::map<Job, std::string> latest_;  ///< whoever told it
  std::map<Job, HandedOver> handed_over_;
  std::map<std::uint64_t, Command> commands_;
  std::set<Rendezvous> syncs_;
  std::map<Channel, std::map<std::uint64_t, MissionTime>> sent_;
  std::map<Channel, std::uint64_t> received_, received_long_;
  std::map<Channel, MissionTime> down_since_;
  std::set<Channel> told_;     ///< links that some line is about
  bool others_are_up_ = true;  ///< all other links
  MissionTime others_down_since_;
  std::set<std::string> relays_;  ///< past whom somebody has told that its samples go
  bool simulator_dead_ = false;
  std::optional<MissionTime> ground_dead_since_;
  Duration ground_away_;             ///< in deaths that are over
  std::map<Channel, bool> unheard_;  ///< that nobody is told before it is back
  std::vector<std::string> breaches_;
};

}  // namespace

Duration command_limit(const scenario::Scenario& scenario) {
  return scenario.ground.script.command_lifetime + kSettling;
}

std::vector<std::string> broken_protocol(const std::vector<Record>& records, Duration command_limit,
                                         std::optional<Duration> late) {
  return Checker(command_limit, late).check(records);
}

std::string to_text(const std::vector<std::string>& breaches) {
  std::string text;
  for (const std::string& breach : breaches) text += breach + "\n";
  return text;
}

}  // namespace skein::laws
