// SPDX-License-Identifier: Apache-2.0
#include "skein/world/radio_reader.hpp"

#include "skein/world/environment_reader.hpp"

namespace skein::world {

using config::Reader;

namespace {

std::optional<LinkBudget> read_budget(const Reader& reader) {
  if (!reader.optional("power").present()) {
    for (const char* key : {"sensitivity", "reference_loss", "exponent"})
      if (const Reader figure = reader.optional(key); figure.present())
        figure.error(std::string(key) + " without power", "the emission power in dBm");
    return std::nullopt;
  }
  if (const Reader range = reader.optional("range"); range.present())
    range.error("a range beside a link budget, from which it follows", "one of the two");
  LinkBudget budget;
  budget.emission_power = reader.required("power").number(20, {-100, 100, "dBm"});
  budget.sensitivity = reader.required("sensitivity").number(-90, {-200, 100, "dBm"});
  budget.reference_loss = reader.optional("reference_loss").number(40, {0, 200, "dB"});
  budget.path_loss_exponent = reader.optional("exponent").number(2, {1, 8, ""});
  return budget;
}

}  // namespace

RadioModel read_radio_figures(const Reader& reader) {
  RadioModel radio;
  radio.range = reader.optional("range").number(10'000, {1, kFarthest, "m"});
  radio.budget = read_budget(reader);
  radio.needs_line_of_sight = reader.optional("line_of_sight").boolean(true);
  radio.latency = Duration::seconds(reader.optional("latency").number(0.02, {0, 60, "s"}));
  radio.loss = reader.optional("loss").number(0, {0, 0.99, ""});
  if (const Reader capacity = reader.optional("capacity"); capacity.present())
    radio.capacity = capacity.number(1'000'000, {1, 1e12, "bit/s"});
  radio.hysteresis = reader.optional("hysteresis").number(0.05, {0, 1, ""});
  if (radio.budget)
    for (const std::string& problem : problems_of(radio)) reader.error(problem);
  return radio;
}

}  // namespace skein::world
