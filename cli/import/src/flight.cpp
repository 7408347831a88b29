// SPDX-License-Identifier: Apache-2.0
#include "flight.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "skein/foundation/overloaded.hpp"

namespace skein::import_tool {
namespace {

using namespace mission_files;  // NOLINT(google-build-using-namespace): its steps, each in turn
using world::Vector3;

constexpr const char* kGeoidWanted =
    "--geoid METRES, how high the sea is over the ellipsoid there, or a home with its height";
/// Over which a way home and to a landing keeps from the ground [m].
constexpr double kSafeHeight = 5;

class Planner {
 public:
  Planner(const FlightOptions& options, const Site& site, const world::VehicleModel& model,
          const std::vector<world::Volume>& closed, Log& log)
      : options_(options),
        site_(site),
        model_(model),
        closed_(closed),
        log_(log),
        at_(site.home()) {}

  void take(const Item& item) {
    mark_ = &item.mark;
    if (stays_)
      return log_.leave_out(*mark_, "what comes after a place at which it stays for ever");
    std::visit(
        Overloaded{[&](const TakeOff& step) { take_off(step); },
                   [&](const FlyTo& step) { fly_to(step); }, [&](const Land& step) { land(step); },
                   [&](const ReturnHome&) { go_home(); },
                   [&](const Delay& step) { wait(step.seconds); },
                   [&](const ChangeSpeed& step) { change_speed(step.speed); },
                   [&](const TakePictures& step) { take_pictures(step.count); },
                   [&](const StopPictures&) { stop_pictures(); }},
        item.step);
  }

  Flight finish() {
    end_way();
    stop_pictures();
    flight_.lands = !airborne_ && flight_.last > 0;
    put_behind_what_they_wait_for();
    return std::move(flight_);
  }

 private:
  void take_off(const TakeOff& step) {
    if (airborne_) return log_.leave_out(*mark_, "a takeoff in the air");
    const auto top = site_.height_at(at_, step.to);
    if (!top) return log_.wrong(*mark_, "its height counts from sea level", kGeoidWanted);
    leave_ground(*top - at_.z());
  }

  /// To a height over the ground, on which it stands.
  void leave_ground(double height) {
    if (height < kLeastHeight || height > model_.ceiling)
      log_.wrong(*mark_, "a takeoff to " + figure(height) + " m over the ground",
                 fmt::format("{:g} to {:g} m", kLeastHeight, model_.ceiling));
    add("takeoff", "{altitude: " + figure(height) + "}", height / std::max(model_.climb_rate, 0.1));
    at_.z() += height;
    airborne_ = true;
  }

  void fly_to(const FlyTo& step) {
    const Height height = step.to.height.value_or(Height{options_.altitude, HeightOver::kGround});
    const auto point = site_.at(step.to.at, height);
    if (!point) return log_.wrong(*mark_, "its height counts from sea level", kGeoidWanted);
    fly(*point);
    if (step.hold > 0) wait(step.hold);
    stays_ = step.stays;
  }

  void fly(const Vector3& point) {
    check(point);
    if (!airborne_) {
      const double height = std::max(point.z() - site_.ground_at(at_), kSafeHeight);
      log_.say(
          fmt::format("takes off first, to {} m: the mission does not say it", figure(height)));
      leave_ground(std::min(height, model_.ceiling));
    }
    way_.push_back(point);
  }

  void check(const Vector3& point) {
    const double height = point.z() - site_.ground_at(point);
    if (height < kLeastHeight - 0.005 || height > model_.ceiling)
      log_.wrong(*mark_, figure(height) + " m over the ground there",
                 fmt::format("{:g} to {:g} m, which '{}' flies at", kLeastHeight, model_.ceiling,
                             model_.name));
    for (const world::Volume& volume : closed_)
      if (point.z() >= volume.floor && point.z() <= volume.ceiling &&
          world::contains(volume.polygon, point.head<2>()))
        log_.wrong(*mark_, "in closed air: '" + volume.name + "'");
  }

  void land(const Land& step) {
    if (!airborne_ && way_.empty()) return log_.leave_out(*mark_, "a landing on the ground");
    if (step.at) {
      const world::Vector2 there = site_.on_ground(*step.at);
      over_to(there);
    }
    end_way();
    touch_down();
  }

  void go_home() {
    if (!airborne_) return log_.leave_out(*mark_, "a return without a flight");
    over_to(site_.home().head<2>());
    end_way();
    touch_down();
  }

  /// At the height that it has, or higher where the ground is.
  void over_to(const world::Vector2& there) {
    const Vector3 last = way_.empty() ? at_ : way_.back();
    const double ground = site_.terrain().elevation(there.x(), there.y());
    fly({there.x(), there.y(), std::max(last.z(), ground + kSafeHeight)});
  }

  void touch_down() {
    const double height = at_.z() - site_.ground_at(at_);
    add("land", "", height / std::max(model_.descent_rate, 0.1));
    at_.z() -= height;
    airborne_ = false;
  }

  void wait(double seconds) {
    end_way();
    add("wait", "{duration: " + figure(seconds) + "}", seconds);
  }

  void change_speed(double speed) {
    if (speed > model_.max_speed)
      return log_.wrong(
          *mark_, figure(speed) + " m/s",
          fmt::format("at most {:g} m/s, which '{}' flies", model_.max_speed, model_.name));
    end_way();
    speed_ = speed;
  }

  void take_pictures(int count) {
    if (options_.camera.empty())
      return log_.leave_out(*mark_, "pictures, since no --camera takes them");
    if (count == 0 && taking_) return;  // surveys say it again on every lane
    end_way();
    FlightTask shots{next_id(), "takeshot", "{device: " + options_.camera + "}", flight_.last, 0};
    if (count > 0) shots.params = fmt::format("{{device: {}, shots: {}}}", options_.camera, count);
    flight_.tasks.push_back(std::move(shots));
    if (count == 0) taking_ = flight_.tasks.size() - 1;
  }

  void stop_pictures() {
    if (!taking_) return;
    end_way();
    FlightTask& shots = flight_.tasks[*taking_];
    taking_.reset();
    if (flight_.last > shots.after)
      shots.until_end_of = flight_.last;
    else
      shots.params.insert(shots.params.size() - 1, ", shots: 1");
  }

  /// What was collected of way-points is one task.
  void end_way() {
    if (way_.empty()) return;
    std::string points;
    const double speed = speed_.value_or(model_.cruise_speed);
    double seconds = 0;
    for (const Vector3& point : way_) {
      points += fmt::format("{}[{}, {}, {}]", points.empty() ? "" : ", ", figure(point.x()),
                            figure(point.y()), figure(point.z()));
      seconds += (point - at_).norm() / std::max(speed, 0.1) + 10;
      at_ = point;
    }
    std::string params = way_.size() == 1 ? "{to: " + points : "{to: [" + points + "]";
    if (speed_) params += ", speed: " + figure(*speed_);
    way_.clear();
    add("goto", params + "}", seconds);
  }

  /// Conditions are on tasks that are there already.
  void put_behind_what_they_wait_for() {
    const auto place = [](const FlightTask& task) {
      return std::pair(std::max(task.id, task.until_end_of), task.until_end_of > 0);
    };
    std::sort(flight_.tasks.begin(), flight_.tasks.end(),
              [&](const FlightTask& a, const FlightTask& b) { return place(a) < place(b); });
  }

  int next_id() const { return static_cast<int>(flight_.tasks.size()) + 1; }

  void add(const char* type, std::string params, double seconds) {
    flight_.tasks.push_back({next_id(), type, std::move(params), flight_.last, 0});
    flight_.last = flight_.tasks.back().id;
    flight_.seconds += seconds;
  }

  const FlightOptions& options_;
  const Site& site_;
  const world::VehicleModel& model_;
  const std::vector<world::Volume>& closed_;
  Log& log_;
  const Mark* mark_ = nullptr;
  Flight flight_;
  Vector3 at_;  ///< at the end of the tasks made so far
  bool airborne_ = false, stays_ = false;
  std::optional<double> speed_;
  std::vector<Vector3> way_;           ///< points that are no task yet
  std::optional<std::size_t> taking_;  ///< index of the task that takes pictures until it is told
};

}  // namespace

std::string figure(double value) { return fmt::format("{}", std::round(value * 100) / 100 + 0.0); }

Flight flight_of(const std::vector<Item>& items, const FlightOptions& options, const Site& site,
                 const world::VehicleModel& model, const std::vector<world::Volume>& closed,
                 Log& log) {
  Planner planner(options, site, model, closed, log);
  for (const Item& item : items) planner.take(item);
  return planner.finish();
}

}  // namespace skein::import_tool
