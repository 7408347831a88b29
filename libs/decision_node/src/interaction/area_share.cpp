// SPDX-License-Identifier: Apache-2.0
#include "interaction/area_share.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "interaction/area_cutting.hpp"
#include "skein/supervisor/area_sweep.hpp"
#include "skein/supervisor/way_home.hpp"
#include "skein/world/segment.hpp"

namespace skein::decision_node {

namespace {

using interaction::Row;
using interaction::Rows;
using world::Polygon;
using world::Vector2;
using world::Vector3;

constexpr const char* kRound = "round";
constexpr const char* kLeft = "left";
constexpr const char* kTaken = "taken";                     // with whose it was
constexpr double kCovered = 0.95;                           // of a part: somebody else has it
constexpr Duration kSoon = Duration::milliseconds(60'000);  // closed when it sets out
constexpr std::size_t kLookAhead = 3;  // way-points, some of which may lie within one step

/// Whether nearly all of a polygon lies in others that do not overlap.
bool is_covered(const Polygon& polygon, const std::vector<Polygon>& others) {
  double covered = 0;
  for (const Polygon& other : others) covered += common_area(polygon, other);
  return covered >= kCovered * world::area(polygon);
}

std::vector<Polygon> named(const Rows& rows, const std::string& name, const std::string& text) {
  std::vector<Polygon> all;
  for (const Row& row : rows)
    if (row.name == name && row.text == text && row.numbers.size() >= 6)
      all.push_back(polygon_of(row));
  return all;
}

/// In which round of divisions it was told; absent: it tells of none.
std::optional<int> round_of(const Rows& left) {
  const bool tells = !left.empty() && left.front().name == kRound &&
                     left.front().numbers.size() == 1 && left.front().numbers[0] >= 1 &&
                     left.front().numbers[0] <= interaction::kMostDivisions;
  return tells ? std::optional(static_cast<int>(left.front().numbers[0])) : std::nullopt;
}

/// The row by which the session shares anew what this member has left; null: it does not.
const Row* anew_of(const std::string& uav, const interaction::Terms& terms) {
  const auto anew = std::ranges::find_if(terms.parameters, [&](const Row& row) {
    return row.name == interaction::kAnew && row.text == uav;
  });
  return anew == terms.parameters.end() ? nullptr : &*anew;
}

/// Across its longest leg from a point on.
Vector2 across(const refiners::Way& way, std::size_t from) {
  Vector2 longest = Vector2::UnitX();
  double length = 0;
  for (std::size_t i = from; i + 1 < way.size(); ++i) {
    const Vector2 leg = (way[i + 1] - way[i]).head<2>();
    if (leg.norm() <= length) continue;
    length = leg.norm();
    longest = leg / length;
  }
  return {-longest.y(), longest.x()};
}

/// Sweeps of pieces one after the other, and the pieces of which there is none now, with the first
/// reason.
struct Outing {
  struct Swept {
    Polygon area;
    supervisor::AreaSweep sweep;
  };
  std::vector<Swept> swept;
  std::vector<Polygon> held_back;
  std::optional<supervisor::NoSweep> why;
  double seconds = 0, energy = 0;
  supervisor::SweepStart end;  ///< of the next one

  bool add(const Polygon& area, const SweepSetting& setting) {
    auto sweep = supervisor::sweep_of(setting.knowledge, setting.world, setting.now, end, area,
                                      setting.device);
    if (!sweep) {
      if (!why) why = sweep.error();
      why->opens = earliest(why->opens, sweep.error().opens);
      return false;
    }
    seconds += sweep->seconds;
    energy += sweep->energy;
    end = {sweep->way.back(), end.earliest + sweep->shortest, end.latest + sweep->longest};
    swept.push_back({area, std::move(*sweep)});
    return true;
  }
};

/// Where a piece cannot be swept as a whole, closed air is cut out of it.
Outing outing_over(const std::vector<Polygon>& areas, const SweepSetting& setting) {
  Outing outing;
  outing.end = {setting.state.position};
  const auto swath = supervisor::shared_swath_of(*setting.knowledge, setting.device);
  for (const Polygon& area : areas) {
    if (outing.add(area, setting)) continue;
    std::vector<Polygon> beside{area};
    for (const world::Volume& volume : setting.world->volumes)
      if (swath && volume.polygon.size() > 2 &&
          volume.when.overlaps({setting.now, setting.now + kSoon}))
        cut_out(volume.polygon, *swath / 2, beside, outing.held_back);
    for (Polygon& part : beside) {
      const bool is_all = beside.size() == 1 && world::area(part) >= world::area(area) - kNoArea;
      if (is_all || !outing.add(part, setting)) outing.held_back.push_back(std::move(part));
    }
  }
  if (outing.why) outing.why->why = "its part cannot be swept: " + outing.why->why;
  return outing;
}

}  // namespace

// ---- what is left ----

// Lanes come beside each other, as a rule in their order: what those still to be flown see.
Polygon AreaShare::Piece::left() const {
  if (passed <= 1) return area;
  if (passed == lanes.size()) return {};
  const Vector2 normal = across(lanes, passed - 1);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = passed - 1; i < lanes.size(); ++i) {
    const double off = lanes[i].head<2>().dot(normal);
    lowest = std::min(lowest, off);
    highest = std::max(highest, off);
  }
  return between(area, normal, lowest - reach, highest + reach);
}

std::vector<Polygon> AreaShare::own_left() const {
  std::vector<Polygon> all;
  for (const Piece& piece : own_) {
    Polygon left = piece.left();
    if (world::area(left) > kNoArea) all.push_back(std::move(left));
  }
  return all;
}

Rows AreaShare::left() const {
  if (!agreed()) return {};
  Rows rows{{kRound, "", {static_cast<double>(round_)}}};
  for (const Polygon& polygon : own_left()) rows.push_back(interaction::row_of(kLeft, polygon));
  for (const auto& [uav, areas] : taken_) {
    for (const Polygon& area : areas) {
      rows.push_back(interaction::row_of(kTaken, area));
      rows.back().text = uav;
    }
  }
  return rows;
}

double AreaShare::area_left() const {
  double sum = 0;
  for (const Polygon& polygon : own_left()) sum += world::area(polygon);
  return sum;
}

// ---- who has what ----

void AreaShare::agree(const Rows& result, const Rows& parameters) {
  there_.clear();
  for (const Row& row : parameters) {
    if (row.name == interaction::kDivisions || row.name == interaction::kAnew)
      round_ = std::max(round_, static_cast<int>(row.numbers.front()));
    if (row.name != interaction::kAnew) continue;
    if (row.text == self_) own_.clear();
    others_.erase(row.text);
  }
  ++round_;
  std::vector<Polygon> shared;
  for (const Row& row : result) {
    newcomers_.erase(row.name);
    if (row.numbers.empty()) continue;
    shared.push_back(polygon_of(row));
    if (row.name == self_)
      add(shared.back());
    else
      others_[row.name].push_back(shared.back());
  }
  for (auto& [uav, areas] : lost_)
    std::erase_if(areas, [&](const Polygon& one) { return is_covered(one, shared); });
  std::erase_if(lost_, [](const auto& one) { return one.second.empty(); });
}

void AreaShare::add(Polygon area) {
  for (const auto& [uav, theirs] : lost_) {
    const bool had = theirs.empty() || std::ranges::any_of(theirs, [&](const Polygon& one) {
                       return common_area(area, one) > kNoArea;
                     });
    if (had) taken_[uav].push_back(area);
  }
  own_.push_back({std::move(area)});
}

void AreaShare::take(const std::vector<Polygon>& areas) {
  there_.clear();
  ++round_;
  for (const Polygon& area : areas) add(area);
  lost_.clear();
}

// Who is lost before the first division may be given any of it, or take all.
void AreaShare::lose(const std::string& uav) {
  newcomers_.erase(uav);
  if (!agreed()) lost_.try_emplace(uav);
  auto theirs = others_.extract(uav);
  if (theirs.empty()) return;
  std::vector<Polygon>& lost = lost_[uav];
  lost.insert(lost.end(), theirs.mapped().begin(), theirs.mapped().end());
}

void AreaShare::leave_to(const std::string& uav) {
  there_.erase(uav);
  others_.erase(uav);
  lost_.erase(uav);
}

std::vector<Polygon> AreaShare::nobodys() const {
  std::vector<Polygon> all;
  for (const auto& [uav, areas] : lost_) all.insert(all.end(), areas.begin(), areas.end());
  return all;
}

void AreaShare::told(const std::string& uav, const Rows& left) {
  const auto round = round_of(left);
  if (!round) return;
  if (!agreed()) there_[uav] = left;
  const auto theirs = others_.find(uav);
  if (theirs != others_.end() && *round >= round_) theirs->second = named(left, kLeft, "");
}

Rows AreaShare::to_share() const {
  Rows rows;
  const auto share = [&](const std::vector<Polygon>& areas) {
    for (const Polygon& area : areas) rows.push_back(interaction::row_of(kArea, area));
  };
  const auto anew = [&](const std::string& uav, int round, const std::vector<Polygon>& left) {
    rows.push_back({interaction::kAnew, uav, {static_cast<double>(round)}});
    share(left);
  };
  for (const auto& [uav, left] : there_) {
    if (lost_.contains(uav))
      share(named(left, kLeft, ""));
    else
      anew(uav, *round_of(left), named(left, kLeft, ""));
  }
  share(nobodys());
  if (newcomers_.empty() || !agreed()) return rows;
  anew(self_, round_, own_left());
  for (const auto& [uav, left] : others_) anew(uav, round_, left);
  return rows;
}

std::string AreaShare::outdated(const interaction::Terms& terms) const {
  const Row* anew = anew_of(self_, terms);
  if (anew == nullptr) {
    const bool comes = agreed() && newcomers_.contains(terms.opener);
    return comes ? "'" + terms.opener + "' does not know yet what it has left" : "";
  }
  return anew->numbers.front() == round_ ? "" : "what it has left was shared since";
}

bool AreaShare::yield_to(const std::string& uav, const Rows& left) {
  const auto with = [&](std::map<std::string, std::vector<Polygon>>& all, const char* name,
                        const std::string& text) {
    all[uav] = named(left, name, text);
    std::vector<Polygon> result;
    for (const auto& [other, areas] : all) result.insert(result.end(), areas.begin(), areas.end());
    return result;
  };
  const std::vector<Polygon> taken = with(taken_by_, kTaken, self_),
                             theirs = with(kept_by_, kLeft, "");
  return std::erase_if(own_, [&](const Piece& piece) {
           const Polygon rest = piece.left();
           return world::area(rest) > kNoArea &&
                  (is_covered(rest, taken) || is_covered(rest, theirs));
         }) > 0;
}

// ---- flights ----

Result<Rows, Failure> AreaShare::offer(const interaction::Terms& terms,
                                       const SweepSetting& setting) const {
  if (std::string why = outdated(terms); !why.empty()) return failure(std::move(why));
  const supervisor::Knowledge& knowledge = *setting.knowledge;
  const auto swath = supervisor::shared_swath_of(knowledge, setting.device);
  if (!swath) return failure(swath.error());
  const bool gives_its_own = anew_of(self_, terms) != nullptr;
  const Outing before = outing_over(gives_its_own ? std::vector<Polygon>{} : own_left(), setting);
  const double home = supervisor::least_to_come_home(knowledge, *setting.world, setting.now,
                                                     setting.state.position);
  const double spare = setting.state.energy - before.energy - home;
  if (spare <= 0) return failure("it has no energy for more");
  interaction::Sweeper sweeper;
  sweeper.vehicle = knowledge.vehicle;
  sweeper.vehicle.energy.capacity *= spare;
  sweeper.vehicle.energy.reserve = 0;
  sweeper.vehicle.position_precision = world::tracking_spread(knowledge.vehicle);
  sweeper.start = before.end.from.head<2>();
  sweeper.altitude = std::min(knowledge.altitude, knowledge.vehicle.ceiling);
  sweeper.swath = *swath;
  sweeper.busy = before.seconds;
  return offer_of(sweeper);
}

Result<refiners::Way, supervisor::NoSweep> AreaShare::set_out(const SweepSetting& setting) {
  Outing outing = outing_over(own_left(), setting);
  if (outing.swept.empty() && outing.why) return tl::unexpected(*outing.why);
  own_.clear();
  refiners::Way way;
  for (Outing::Swept& one : outing.swept) {
    const refiners::Way& whole = one.sweep.way;
    const auto first = whole.begin() + static_cast<std::ptrdiff_t>(one.sweep.lanes);
    way.insert(way.end(), whole.begin() + 1, whole.end());
    own_.push_back({std::move(one.area), {first, whole.end()}, 0, one.sweep.reach});
  }
  for (Polygon& area : outing.held_back) own_.push_back({std::move(area)});
  at_ = {setting.state.position};
  return way;
}

void AreaShare::fly(const Vector3& to, double reach) {
  const Vector3 from = at_.empty() ? to : at_.front();
  at_ = {to};
  const auto current = std::find_if(own_.begin(), own_.end(), [](const Piece& piece) {
    return piece.passed < piece.lanes.size();
  });
  if (current == own_.end()) return;
  const refiners::Way& lanes = current->lanes;
  // It comes to where they begin from anywhere.
  const std::size_t beyond = current->passed + (current->passed == 0 ? 1 : kLookAhead);
  for (std::size_t next = current->passed; next < std::min(lanes.size(), beyond); ++next) {
    if (world::to_segment(lanes[next], from, to) <= reach) current->passed = next + 1;
  }
}

void AreaShare::flown() {
  std::erase_if(own_, [](const Piece& piece) { return !piece.lanes.empty(); });
}

}  // namespace skein::decision_node
