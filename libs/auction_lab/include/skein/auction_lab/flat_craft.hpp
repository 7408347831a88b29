// SPDX-License-Identifier: Apache-2.0
// A vehicle in the plane that flies straight at one speed.
#pragma once

#include <memory>
#include <optional>

#include "skein/auction/catalogue.hpp"
#include "skein/auction/craft.hpp"

namespace skein::auction {

struct FlatVehicle {
  Place begin;
  std::optional<Place> end{};  ///< none: its plan ends where its last task does
  double speed = 1;            ///< [m/s]
  Abilities abilities = 0;
  double energy = std::numeric_limits<double>::infinity();  ///< a joule a metre [J]
  double free_from = 0;                                     ///< [s]
};

/// Its cost is the way in metres.
class FlatCraft : public Craft {
 public:
  FlatCraft(FlatVehicle vehicle, std::shared_ptr<const Catalogue> catalogue)
      : vehicle_(vehicle), catalogue_(std::move(catalogue)) {}
  Abilities abilities() const override { return vehicle_.abilities; }
  double free_from() const override { return vehicle_.free_from; }
  double energy() const override { return vehicle_.energy; }
  std::optional<Leg> leg(Stopover from, Stopover to) const override;

 private:
  Place place(Stopover of) const;
  FlatVehicle vehicle_;
  std::shared_ptr<const Catalogue> catalogue_;
};

}  // namespace skein::auction
