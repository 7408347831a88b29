// SPDX-License-Identifier: Apache-2.0
#include "skein/refiners/dubins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "skein/foundation/contract.hpp"

namespace skein::refiners {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kNoTurn = 1e-9;  // [rad]

world::Vector2 left_of(double heading) { return {-std::sin(heading), std::cos(heading)}; }

/// What is turned by from one heading to another, one way round: [0, 2π), where anything within
/// `noise` of a full turn is none.
double turned(double angle, double noise) {
  const double positive = angle - kFullTurn * std::floor(angle / kFullTurn);
  return positive >= kFullTurn - noise ? 0 : positive;
}

}  // namespace

double chord_angle(double radius, double tolerance) {
  SKEIN_EXPECTS(radius > 0 && tolerance > 0);
  const double sagitta = std::min(1.0, tolerance / radius);
  return std::min(std::numbers::pi / 4, 2 * std::acos(1 - sagitta));
}

/// One of the six sequences of pieces, by the centres of its two outer circles. Where `a` is the
/// heading at the end of the first piece and `b` at the start of the last, with u(x) the unit
/// vector along x and n(x) the one to its left, the centres are apart by
///   s u(a), s u(a) ∓ 2 r n(a)       (straight in the middle, same and opposite turns)
///   ± 2 r (n(b) - n(a)) = 4 r sin(p/2) u(a ∓ p/2)   (a turn by p in the middle),
/// from which a, s and p follow.
struct DubinsCurve::Word {
  const Pose& from;
  const Pose& to;
  double radius;
  world::Vector2 left_of_from = left_of(from.heading), left_of_to = left_of(to.heading);

  static double side(Piece piece) { return piece == Piece::kLeft ? 1 : -1; }

  /// None: there is no such curve, or it is at least `least` long.
  std::optional<std::array<double, 3>> lengths(Piece first, Piece last, bool arc_between,
                                               double least) const {
    const world::Vector2 apart = (to.at + side(last) * radius * left_of_to) -
                                 (from.at + side(first) * radius * left_of_from);
    const double distance = apart.norm();
    const std::optional<double> straight =
        first == last ? std::optional(distance) : between_opposite(distance);
    if (arc_between ? distance > 4 * radius : !straight || *straight >= least) return std::nullopt;
    const bool concentric = distance < 1e-9 * radius;
    const double along = concentric ? from.heading : std::atan2(apart.y(), apart.x());
    const double size = from.at.norm() + to.at.norm() + radius;
    const double noise = kNoTurn + (concentric ? 0 : 1e-15 * size / distance);
    return arc_between ? with_arc(first, distance, along, noise)
                       : with_line(first, last, *straight, along, noise);
  }

 private:
  /// Length of a line between circles that are turned on opposite ways; none: they overlap.
  std::optional<double> between_opposite(double distance) const {
    const double square = distance * distance - 4 * radius * radius;
    return square < 0 ? std::nullopt : std::optional(std::sqrt(square));
  }

  std::array<double, 3> outer_turns(Piece first, Piece last, double a, double b, double middle,
                                    double noise) const {
    return {radius * turned(side(first) * (a - from.heading), noise), middle,
            radius * turned(side(last) * (to.heading - b), noise)};
  }

  std::array<double, 3> with_line(Piece first, Piece last, double straight, double along,
                                  double noise) const {
    if (first == last) return outer_turns(first, last, along, along, straight, noise);
    const double a = along + side(first) * std::atan2(2 * radius, straight);
    return outer_turns(first, last, a, a, straight, noise);
  }

  /// Precondition: the circles are no further apart than a third one between them reaches.
  std::array<double, 3> with_arc(Piece outer, double distance, double along, double noise) const {
    // Of the two circles that touch both, the one that is turned on by more than half: the other
    // is never part of a shortest curve.
    const double middle = kFullTurn - 2 * std::asin(distance / (4 * radius));
    const double a = along + side(outer) * middle / 2, b = along - side(outer) * middle / 2;
    return outer_turns(outer, outer, a, b, radius * middle, noise);
  }
};

DubinsCurve DubinsCurve::shortest(const Pose& from, const Pose& to, double radius) {
  SKEIN_EXPECTS(radius > 0 && std::isfinite(radius) && from.at.allFinite() && to.at.allFinite() &&
                std::isfinite(from.heading) && std::isfinite(to.heading));
  DubinsCurve best;
  best.from_ = from;
  best.to_ = to;
  best.radius_ = radius;
  double least = std::numeric_limits<double>::infinity();
  const Word word{from, to, radius};
  const auto consider = [&](Piece first, Piece middle, Piece last) {
    const auto lengths = word.lengths(first, last, middle != Piece::kStraight, least);
    if (!lengths) return;
    const double length = (*lengths)[0] + (*lengths)[1] + (*lengths)[2];
    if (length >= least) return;
    least = length;
    best.pieces_ = {first, middle, last};
    best.lengths_ = *lengths;
  };
  for (const Piece first : {Piece::kLeft, Piece::kRight})
    for (const Piece last : {Piece::kLeft, Piece::kRight}) consider(first, Piece::kStraight, last);
  consider(Piece::kLeft, Piece::kRight, Piece::kLeft);
  consider(Piece::kRight, Piece::kLeft, Piece::kRight);
  return best;
}

DubinsCurve DubinsCurve::circle(const Pose& from, double radius, bool left) {
  SKEIN_EXPECTS(radius > 0);
  DubinsCurve curve;
  curve.from_ = curve.to_ = from;
  curve.radius_ = radius;
  curve.pieces_.fill(left ? Piece::kLeft : Piece::kRight);
  curve.lengths_ = {kFullTurn * radius, 0, 0};
  return curve;
}

DubinsCurve DubinsCurve::arc(const Pose& from, double radius, bool left, double angle) {
  SKEIN_EXPECTS(angle >= 0 && std::isfinite(angle));
  DubinsCurve curve = circle(from, radius, left);
  curve.lengths_[0] = angle * radius;
  curve.to_ = curve.advanced(from, curve.pieces_[0], curve.lengths_[0]);
  return curve;
}

Pose DubinsCurve::advanced(const Pose& from, Piece piece, double length) const {
  if (piece == Piece::kStraight) {
    const world::Vector2 ahead(std::cos(from.heading), std::sin(from.heading));
    return {from.at + length * ahead, from.heading};
  }
  const double side = Word::side(piece);
  const double heading = from.heading + side * length / radius_;
  return {from.at + side * radius_ * (left_of(from.heading) - left_of(heading)), heading};
}

Pose DubinsCurve::at(double along) const {
  if (along >= length()) return to_;
  Pose pose = from_;
  double left = std::max(0.0, along);
  for (std::size_t i = 0; i < pieces_.size() && left > 0; ++i) {
    const double part = std::min(left, lengths_[i]);
    pose = advanced(pose, pieces_[i], part);
    left -= part;
  }
  return pose;
}

/// None of a piece that is left out.
std::size_t DubinsCurve::chords_of(std::size_t piece, double tolerance) const {
  if (lengths_[piece] <= kNoTurn * radius_) return 0;
  if (pieces_[piece] == Piece::kStraight) return 1;
  const double most = radius_ * chord_angle(radius_, tolerance);
  return static_cast<std::size_t>(std::ceil(lengths_[piece] / most - kNoTurn));
}

std::vector<world::Vector2> DubinsCurve::sampled(double tolerance) const {
  std::vector<world::Vector2> points = {from_.at};
  Pose start = from_;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const std::size_t chords = chords_of(i, tolerance);
    if (chords == 0) continue;
    for (std::size_t k = 1; k <= chords; ++k)
      points.push_back(advanced(start, pieces_[i],
                                lengths_[i] * static_cast<double>(k) / static_cast<double>(chords))
                           .at);
    start = advanced(start, pieces_[i], lengths_[i]);
  }
  points.back() = to_.at;
  return points;
}

double DubinsCurve::sampled_length(double tolerance) const {
  double length = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const auto chords = static_cast<double>(chords_of(i, tolerance));
    if (chords == 0) continue;
    length += pieces_[i] == Piece::kStraight
                  ? lengths_[i]
                  : 2 * radius_ * chords * std::sin(lengths_[i] / (2 * chords * radius_));
  }
  return length;
}

}  // namespace skein::refiners
