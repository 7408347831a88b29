// SPDX-License-Identifier: Apache-2.0
// A spatial constraint model over places and numbers of its own.
#include <algorithm>
#include <numbers>

#include "library_reader.hpp"
#include "skein/foundation/nearest.hpp"

namespace skein::interaction {

namespace {

using config::Reader;
using Quantity = SpatialConstraint::Quantity;

class ScmReader {
 public:
  explicit ScmReader(std::string name) { scm_.name = std::move(name); }

  Scm read(const Reader& reader) {
    reader.keys({"parameters", "constraints"});
    for (const auto& [name, kind] : reader.optional("parameters").entries()) {
      if (name == "scm") kind.error("'scm' is no name of a parameter", "another name");
      scm_.parameters.push_back({name, kind.choice({"Place", "Number"}) == 0});
    }
    const Reader constraints = reader.required("constraints");
    for (const Reader& one : constraints.items()) read_constraint(one);
    if (constraints.is_sequence() && constraints.items().empty()) {
      constraints.error("no constraints", "at least one");
    }
    return std::move(scm_);
  }

 private:
  void read_constraint(const Reader& reader) {
    SpatialConstraint constraint;
    const Reader distance = reader.optional("distance-to");
    const Reader azimuth = reader.optional("azimuth");
    const Reader altitude = reader.optional("altitude");
    if (distance.present() + azimuth.present() + altitude.present() != 1) {
      return reader.error("no constraint", "exactly one of distance-to, azimuth and altitude");
    }
    reader.keys({"distance-to", "azimuth", "altitude", "is", "than", "tolerance"});
    if (distance.present()) {
      constraint.of = {read_place(distance)};
    } else {
      const Reader frame = azimuth.present() ? azimuth : altitude;
      constraint.quantity = azimuth.present() ? Quantity::kAzimuth : Quantity::kAltitude;
      for (const Reader& one : frame.items()) constraint.of.push_back(read_place(one));
      if (constraint.of.size() != 2) frame.error("no celestial frame", "[ORIGIN, AZIMUTH-0]");
    }
    const Reader is = reader.required("is");
    const auto relation = relation_of(is.text("="));
    if (!relation) is.error("unknown relation '" + is.text() + "'", "<, <=, =, >= or >");
    constraint.relation = relation.value_or(Relation::kEqual);
    read_reference(reader.required("than"), constraint);
    read_tolerance(reader, constraint);
    scm_.constraints.push_back(std::move(constraint));
  }

  void read_reference(const Reader& reader, SpatialConstraint& constraint) {
    const bool distance = constraint.quantity == Quantity::kDistance;
    if (reader.is_sequence()) {
      std::vector<std::string> places;
      for (const Reader& one : reader.items()) places.push_back(read_place(one));
      if (!distance || places.size() != 2) {
        reader.error("no reference",
                     distance ? "a number, or [PLACE, PLACE]" : "a number or a place");
      }
      constraint.than = std::move(places);
      return;
    }
    const std::string name = reader.text();
    if (const Scm::Formal* formal = formal_named(name)) {
      if (formal->place && distance) reader.error("a place where a distance is meant", "a number");
      if (formal->place) {
        constraint.than = std::vector<std::string>{name};
      } else {
        constraint.than = Term(name);
      }
      return;
    }
    const double low = constraint.quantity == Quantity::kAltitude ? -std::numbers::pi / 2 : 0;
    const double high = constraint.quantity == Quantity::kAltitude ? std::numbers::pi / 2
                        : distance                                 ? 1e9
                                                                   : 2 * std::numbers::pi;
    constraint.than = Term(reader.number(0, {low, high, distance ? "m" : "rad"}));
  }

  static void read_tolerance(const Reader& reader, SpatialConstraint& constraint) {
    const Reader tolerance = reader.optional("tolerance");
    if (constraint.relation == Relation::kEqual && !tolerance.present()) {
      reader.error("= without tolerance", "tolerance: NUMBER");
    }
    if (constraint.relation != Relation::kEqual && tolerance.present()) {
      tolerance.error("a tolerance without =", "no tolerance");
    }
    constraint.tolerance = tolerance.number(0, {0, 1e9, ""});
    if (tolerance.present() && constraint.tolerance <= 0) {
      tolerance.error("nothing is equal to the last digit", "more than 0");
    }
  }

  std::string read_place(const Reader& reader) {
    const std::string name = reader.text();
    const Scm::Formal* formal = formal_named(name);
    if (formal != nullptr && formal->place) return name;
    std::vector<std::string> places;
    for (const Scm::Formal& one : scm_.parameters) {
      if (one.place) places.push_back(one.name);
    }
    reader.error("unknown place '" + name + "'", "a parameter of kind Place",
                 nearest_name(name, places));
    return name;
  }

  const Scm::Formal* formal_named(const std::string& name) const {
    const auto found = std::find_if(scm_.parameters.begin(), scm_.parameters.end(),
                                    [&](const Scm::Formal& one) { return one.name == name; });
    return found == scm_.parameters.end() ? nullptr : &*found;
  }

  Scm scm_;
};

}  // namespace

Scm read_scm(const std::string& name, const Reader& reader) { return ScmReader(name).read(reader); }

}  // namespace skein::interaction
