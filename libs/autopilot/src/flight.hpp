// SPDX-License-Identifier: Apache-2.0
// Motions as steps: what the autopilot is asked, and what then has to come true.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "commands.hpp"
#include "hand.hpp"
#include "picture.hpp"

namespace skein::autopilot {

// ---- what has to come true ----

struct Answered {};
struct InMode {
  CustomMode mode;
};
struct Armed {};
struct AtHeight {
  double height;  ///< ENU z [m]
};
struct Near {
  world::Vector3 point;
  bool stops;  ///< and slow
};
struct OnGround {};
struct AtRest {};
using Goal = std::variant<Answered, InMode, Armed, AtHeight, Near, OnGround, AtRest>;

struct Step {
  Command command;
  Goal goal;
  std::vector<CustomMode> modes = {};  ///< that the command leads to; empty: it changes none
  bool moves = false;                  ///< once it is accepted the vehicle does what was asked for
  bool may_fail = false;               ///< if it is refused the motion goes on without it
  std::string activity = {};
};

/// How steps are made from what is known of the vehicle.
class Pilotage {
 public:
  Pilotage(const BridgeConfig& config, const Picture& picture, std::uint8_t system)
      : config_(config), picture_(picture), system_(system) {}

  std::deque<Step> take_off(double height) const;
  std::deque<Step> fly(const std::vector<world::Vector3>& way, double speed) const;
  std::deque<Step> land() const;
  /// Where it can stop.
  std::deque<Step> come_to_rest() const;

 private:
  mavlink::CommandLong command(std::uint16_t number) const;
  mavlink::CommandLong set_mode(CustomMode mode) const;
  mavlink::CommandInt reposition(const world::Vector3& at, double speed) const;

  const BridgeConfig& config_;
  const Picture& picture_;
  std::uint8_t system_;
};

/// One motion under way.
class Flight {
 public:
  enum class Stage : std::uint8_t {
    kNone,    ///< nothing is under way
    kAsking,  ///< asked for, not begun
    kUnderWay,
    kDone,
    kFailed
  };

  explicit Flight(const world::VehicleModel& model);

  /// Instead of what is under way.
  void begin(std::deque<Step> steps);
  void drop() { begin({}); }
  void hear(const Commands::Outcome& outcome);
  /// Asks and looks for what has come true.
  Stage step(const Picture& picture, Duration now, Commands& commands, Hand& hand, Outbox& out);
  const std::string& why() const { return why_; }
  std::string activity() const;

 private:
  bool is_true(const Goal& goal, const Picture& picture, Duration now);
  void ask(Duration now, Commands& commands, Hand& hand, Outbox& out);
  void fail(std::string why);

  double tolerance_;
  std::deque<Step> steps_;
  Stage stage_ = Stage::kNone;
  std::string why_;
  std::optional<Commands::Ticket> ticket_;  ///< of the first step, once it was asked for
  bool answered_ = false;
  Duration answered_at_{};
  std::optional<Duration> still_since_;
};

}  // namespace skein::autopilot
