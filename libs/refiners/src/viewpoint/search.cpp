// SPDX-License-Identifier: Apache-2.0
#include "viewpoint/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace skein::refiners {
namespace {

/// The first lattice.
constexpr std::int32_t kFirstTurn = Bearing::kTurn / 48;
constexpr double kFirstTilt = std::numbers::pi / 20;
constexpr int kFirstRanges = 8;
/// How often a box of it may be cut in two along each axis.
constexpr int kDepth = 4;
/// The best that can still come is at most so much better, of the utility, or absolutely.
constexpr double kSlack = 0.002, kLeastSlack = 1e-5;
/// Polishing: how often the step is halved.
constexpr int kPolishing = 7;
/// About what it takes to judge a place [ns].
constexpr std::uint32_t kLook = 20'000;

int tilts_of(const BearingCell& whole) {
  return std::max(
      1, static_cast<int>(std::ceil((whole.elevation_end - whole.elevation) / kFirstTilt)));
}

double part(double from, double to, int index, int count) {
  return from + (to - from) * index / count;
}

/// Where a box is looked at: at its first and last azimuth, in the middle and at the corners.
std::array<Bearing, 10> samples_of(const BearingCell& cell) {
  const Bearing middle = cell.middle();
  std::array<Bearing, 10> samples{};
  std::size_t next = 0;
  for (const std::int32_t azimuth : {cell.azimuth, cell.azimuth_end}) {
    const std::int32_t turned = azimuth % Bearing::kTurn;
    samples[next++] = {turned, middle.elevation, middle.range};
    for (const double elevation : {cell.elevation, cell.elevation_end})
      for (const double range : {cell.range, cell.range_end})
        samples[next++] = {turned, elevation, range};
  }
  return samples;
}

}  // namespace

std::optional<Found> ViewpointSearch::best(const IsApart& is_apart) {
  return search(field_.whole(), is_apart);
}

std::optional<Found> ViewpointSearch::best_along(std::int32_t azimuth) {
  BearingCell plane = field_.whole();
  plane.azimuth = plane.azimuth_end = azimuth;
  return search(plane, {});
}

std::optional<Found> ViewpointSearch::search(const BearingCell& whole, const IsApart& is_apart) {
  is_apart_ = &is_apart;
  heap_.clear();
  best_.reset();
  open_lattice(whole);
  while (!heap_.empty() && !countdown_.over()) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Open next = heap_.back();
    heap_.pop_back();
    if (is_settled(next.bound)) break;
    if (explore(next.cell)) split(next.cell);
  }
  if (best_) polish(whole.azimuth != whole.azimuth_end);
  return best_;
}

void ViewpointSearch::open_lattice(const BearingCell& whole) {
  const std::int32_t turns =
      std::max<std::int32_t>(1, (whole.azimuth_end - whole.azimuth) / kFirstTurn);
  const int tilts = tilts_of(whole);
  const std::int32_t width = (whole.azimuth_end - whole.azimuth) / turns;
  for (std::int32_t turn = 0; turn < turns; ++turn)
    for (int tilt = 0; tilt < tilts; ++tilt)
      open_directions({whole.azimuth + turn * width, whole.azimuth + (turn + 1) * width,
                       part(whole.elevation, whole.elevation_end, tilt, tilts),
                       part(whole.elevation, whole.elevation_end, tilt + 1, tilts), whole.range,
                       whole.range_end});
}

// A box for each part of the range.
void ViewpointSearch::open_directions(const BearingCell& all) {
  const Aspect aspect = field_.aspect_of(all);
  BearingCell cell = all;
  for (int range = 0; range < kFirstRanges; ++range) {
    cell.range = part(all.range, all.range_end, range, kFirstRanges);
    cell.range_end = part(all.range, all.range_end, range + 1, kFirstRanges);
    open(cell, aspect);
  }
}

void ViewpointSearch::open(const BearingCell& cell, const Aspect& aspect) {
  const double bound = field_.utility_bound(cell, aspect);
  if (is_settled(bound)) return;
  heap_.push_back({cell, bound, opened_++});
  std::push_heap(heap_.begin(), heap_.end());
}

bool ViewpointSearch::is_settled(double bound) const {
  return best_ &&
         bound <= best_->utility + std::max(kLeastSlack, kSlack * std::abs(best_->utility));
}

/// True when it is good; `verdict` is what became of it, else it is judged only if it is better.
bool ViewpointSearch::consider(const Bearing& bearing, Verdict* verdict) {
  const Place place = field_.place(bearing);
  if (!verdict && best_ && place.utility <= best_->utility) return false;
  if (!countdown_.step()) return false;
  const bool taken = *is_apart_ && !(*is_apart_)(bearing, place.position);
  const Verdict found = taken ? Verdict{Fate::kTaken} : field_.judge(bearing, place);
  if (verdict) *verdict = found;
  if (found.fate != Fate::kGood) return false;
  if (!best_ || place.utility > best_->utility)
    best_ = Found{bearing, place.position, place.utility};
  return true;
}

/// False when nothing of it is worth looking at more closely.
bool ViewpointSearch::explore(const BearingCell& cell) {
  const bool small = is_small(cell);
  std::optional<Verdict> first;
  bool hopeless = true;
  for (const Bearing& sample : samples_of(cell)) {
    Verdict verdict;
    const bool good = consider(sample, hopeless ? &verdict : nullptr);
    if (countdown_.over()) return false;
    if (!hopeless) continue;
    if (!first) first = verdict;
    hopeless = !good && (small || verdict == *first);
  }
  return !hopeless;
}

bool ViewpointSearch::is_small(const BearingCell& cell) const {
  const BearingCell& whole = field_.whole();
  constexpr double quarter = 0.25 * 1.01;
  return cell.azimuth_end - cell.azimuth <= kFirstTurn / 4 &&
         cell.elevation_end - cell.elevation <=
             quarter * (whole.elevation_end - whole.elevation) / tilts_of(whole) &&
         cell.range_end - cell.range <= quarter * (whole.range_end - whole.range) / kFirstRanges;
}

void ViewpointSearch::split(const BearingCell& cell) {
  const BearingCell& whole = field_.whole();
  constexpr double parts = 1 << kDepth;
  const double tilt = cell.elevation_end - cell.elevation, reach = cell.range_end - cell.range;
  const double least_tilt = (whole.elevation_end - whole.elevation) / tilts_of(whole) / parts;
  const double least_reach = (whole.range_end - whole.range) / kFirstRanges / parts;
  const std::int32_t turn = cell.azimuth_end - cell.azimuth;
  const double inner = std::cos(std::min(std::abs(cell.elevation), std::abs(cell.elevation_end)));
  // The longest side is cut.
  const double along_azimuth = turn > kFirstTurn / static_cast<std::int32_t>(parts)
                                   ? Bearing::radians(turn) * inner * cell.range_end
                                   : 0;
  const double along_elevation = tilt > 1.5 * least_tilt ? tilt * cell.range_end : 0;
  const double along_range = reach > 1.5 * least_reach ? reach : 0;
  const double longest = std::max({along_azimuth, along_elevation, along_range});
  if (longest <= 0) return;
  const Bearing middle = cell.middle();
  BearingCell low = cell, high = cell;
  if (longest == along_azimuth)
    low.azimuth_end = high.azimuth = middle.azimuth;
  else if (longest == along_elevation)
    low.elevation_end = high.elevation = middle.elevation;
  else
    low.range_end = high.range = middle.range;
  open(low, field_.aspect_of(low));
  open(high, field_.aspect_of(high));
}

/// Tries the places around; true when one of them was better.
bool ViewpointSearch::improve(const Bearing& around, std::int32_t turn, double tilt, double reach) {
  const BearingCell& whole = field_.whole();
  const double before = best_->utility;
  for (int t = turn > 0 ? -1 : 0; t <= (turn > 0 ? 1 : 0); ++t)
    for (int e = -1; e <= 1; ++e)
      for (int r = -1; r <= 1; ++r)
        consider({(around.azimuth + t * turn + Bearing::kTurn) % Bearing::kTurn,
                  std::clamp(around.elevation + e * tilt, whole.elevation, whole.elevation_end),
                  std::clamp(around.range + r * reach, whole.range, whole.range_end)},
                 nullptr);
  return best_->utility > before;
}

void ViewpointSearch::polish(bool turning) {
  const BearingCell& whole = field_.whole();
  std::int32_t turn = turning ? kFirstTurn >> kDepth : 0;
  double tilt = kFirstTilt / (1 << kDepth);
  double reach = (whole.range_end - whole.range) / kFirstRanges / (1 << kDepth);
  for (int halving = 0; halving < kPolishing; ++halving) {
    constexpr int most_moves = 4;
    for (int moves = 0; moves < most_moves && improve(best_->bearing, turn, tilt, reach);) ++moves;
    turn /= 2;
    tilt /= 2;
    reach /= 2;
  }
}

ViewpointSearch::Survey ViewpointSearch::survey(Deadline& deadline) {
  constexpr int turns = 32, tilts = 16, ranges = 8;
  const BearingCell& whole = field_.whole();
  Survey survey;
  for (int turn = 0; turn < turns; ++turn)
    for (int tilt = 0; tilt <= tilts; ++tilt)
      for (int range = 0; range <= ranges; ++range) {
        if (deadline.passed_after(kLook)) return survey;
        const Bearing bearing{Bearing::kTurn / turns * turn,
                              part(whole.elevation, whole.elevation_end, tilt, tilts),
                              part(whole.range, whole.range_end, range, ranges)};
        const Place place = field_.place(bearing);
        const Verdict verdict = field_.judge(bearing, place);
        ++survey.places;
        ++survey.fates[verdict];
        if (verdict.fate != Fate::kGood) continue;
        if (!survey.best || place.utility > survey.best->utility)
          survey.best = Found{bearing, place.position, place.utility};
      }
  return survey;
}

}  // namespace skein::refiners
