// SPDX-License-Identifier: Apache-2.0
// Real-time execution of a dispatchable network: nodes that may start, and their deadlines.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/temporal/dispatchable_network.hpp"

namespace skein::temporal {

/// Time has passed.
struct TimePassed {
  bool operator==(const TimePassed&) const = default;
};
/// The host has executed a node that `MayStart` offered.
struct Executed {
  NodeIndex node = 0;
  bool operator==(const Executed&) const = default;
};
/// The end of a contingent link has been observed.
struct Observed {
  NodeIndex node = 0;
  bool operator==(const Observed&) const = default;
};
/// All happen at `now`: plain dynamic controllability knows no delay of observation.
using DispatchInput = std::variant<TimePassed, Executed, Observed>;

/// A node may be executed from now until `until` (later executions may narrow this: see `window`).
struct MayStart {
  NodeIndex node = 0;
  std::optional<MissionTime> until;  ///< absent: no limit
  bool operator==(const MayStart&) const = default;
};
/// A contingent duration violated its bounds: the guarantee of the network is void, and the plan
/// needs repair. No nodes are offered any more; observations are still recorded.
struct Contingency {
  enum class Kind : std::uint8_t {
    kEarly,    ///< ended before min
    kLate,     ///< ended after max
    kOverdue,  ///< not ended, and max is past
    kUnasked,  ///< ended though it was never activated
  };
  std::uint32_t link = 0;
  Kind kind = Kind::kOverdue;
  Duration elapsed;  ///< since the activation; 0 for kUnasked
  bool operator==(const Contingency&) const = default;
};
/// The host missed the latest date of a node. No nodes are offered any more.
struct Missed {
  NodeIndex node = 0;
  MissionTime deadline;
  bool operator==(const Missed&) const = default;
};
/// An invalid input, which had no effect except on the time.
struct Refused {
  enum class Why : std::uint8_t {
    kUnknownNode,
    kNotControlled,
    kNotContingent,
    kAlreadyDone,
    kNotEnabled,
    kTooEarly,
    kStopped,
    kTimeWentBack
  };
  NodeIndex node = 0;
  Why why = Why::kUnknownNode;
  bool operator==(const Refused&) const = default;
};
/// Every node has been executed or observed. Emitted once.
struct Completed {
  bool operator==(const Completed&) const = default;
};
using DispatchEffect = std::variant<MayStart, Contingency, Missed, Refused, Completed>;

/// Current window of dates in which a node may be executed.
struct DispatchWindow {
  MissionTime from;
  std::optional<MissionTime> until;  ///< absent: no limit
  bool operator==(const DispatchWindow&) const = default;
};

/// Sans-IO executor of the RTE* kind. The host executes nodes offered by `MayStart` before their
/// windows close, and reports each execution and each contingent end at its instant. If it does so
/// and contingent durations keep their bounds, no requirement is violated, whatever dates the host
/// chooses.
/// Cost of an input: O(degree of the node + n). Thread rule: not safe to share.
/// Source: spec 5.2; Hunsberger, Posenato 2024.
class Dispatcher {
 public:
  /// The origin is executed at `origin_at`; the first call of `handle` gives the first offers.
  Dispatcher(const DispatchableNetwork& network, MissionTime origin_at);

  std::vector<DispatchEffect> handle(const DispatchInput& input, MissionTime now);
  /// The next date at which `TimePassed` has an effect, if nothing happens before.
  std::optional<MissionTime> next_wakeup() const;

  /// Window of a controlled node that is not executed; absent otherwise, and while it has to wait
  /// for another node.
  std::optional<DispatchWindow> window(NodeIndex node) const;
  /// Date of execution or observation of the node; absent: not yet.
  std::optional<MissionTime> date(NodeIndex node) const;
  /// Nodes that may be executed at the instant of the last input, in the order of their numbers.
  std::vector<NodeIndex> startable() const;
  /// The earliest limit of the enabled nodes, by which a node must be executed.
  std::optional<MissionTime> must_act_by() const;
  bool stopped() const { return stopped_; }
  bool complete() const { return remaining_ == 0; }

 private:
  struct Neighbour {
    NodeIndex node = 0;
    Ticks weight = 0;
  };
  struct Wait {
    NodeIndex node = 0;
    std::uint32_t link = 0;
    Ticks delay = 0;
  };
  struct NodeState {
    Ticks earliest = 0;  ///< without waits
    Ticks latest = kInfinite;
    std::uint32_t blockers = 0;    ///< edges and waits that want a node first which has not come
    std::uint32_t ended_link = 0;  ///< the contingent link that ends here, or none
    bool done = false;
    bool offered = false;
    Ticks date = 0;
  };

  void index_edges(const DispatchableNetwork& network);
  void index_waits(const DispatchableNetwork& network);
  void index_links(const DispatchableNetwork& network);
  void record(NodeIndex node, Ticks at);
  std::optional<Refused::Why> refusal(const Executed& input) const;
  std::optional<Refused::Why> refusal(const Observed& input) const;
  void take(const TimePassed& input, std::vector<DispatchEffect>& out);
  void take(const Executed& input, std::vector<DispatchEffect>& out);
  void take(const Observed& input, std::vector<DispatchEffect>& out);
  void check_observed(const NodeState& end, std::vector<DispatchEffect>& out);
  void find_overdue(std::vector<DispatchEffect>& out);
  void find_missed(std::vector<DispatchEffect>& out);
  void offer(std::vector<DispatchEffect>& out);
  bool controlled(const NodeState& node) const;
  bool enabled(NodeIndex node) const;
  Ticks earliest(NodeIndex node) const;
  std::optional<MissionTime> limit(Ticks ticks) const;

  MissionTime origin_at_;
  std::vector<NodeState> nodes_;
  std::vector<ContingentLink> links_;
  std::vector<bool> overdue_;  ///< of each link: told
  std::vector<std::uint32_t> out_begin_, in_begin_, wait_begin_;
  std::vector<Neighbour> out_, in_;
  std::vector<Wait> waits_;  ///< by node
  std::vector<std::vector<NodeIndex>>
      waiting_for_;  ///< of each node, those with a wait on a link it activates
  std::size_t remaining_ = 0;
  Ticks now_ = 0;
  bool stopped_ = false;
  bool told_complete_ = false;
};

}  // namespace skein::temporal
