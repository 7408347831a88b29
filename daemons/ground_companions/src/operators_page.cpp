// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_companions/operators_page.hpp"

#include <CLI/CLI.hpp>

#include "skein/console/console.hpp"
#include "skein/designer/workbench.hpp"
#include "skein/ground_setup/belief_layer.hpp"
#include "skein/ground_setup/page_world.hpp"

namespace skein::ground_companions {

void OperatorsPage::declare(CLI::App& app) {
  app.add_option("--console", address_,
                 "Serve the operators' page at ADDRESS:PORT, or at PORT of this machine alone");
  app.add_option("--console-name", names_,
                 "Name by which browsers call this machine; may be repeated")
      ->allow_extra_args(false)
      ->delimiter(',');
}

Result<daemon_main::CompanionSource::Opened, Failure> OperatorsPage::open(
    const daemon_main::Surroundings& surroundings) {
  if (address_.empty()) return Opened{};
  console::ConsoleConfig config;
  config.names = names_;
  config.world = ground_setup::page_world(surroundings.scenario);
  const auto models = designer::models_of(surroundings.scenario_file);
  if (!models.empty()) config.annex = std::make_shared<designer::Workbench>(models);
  const auto belief = std::make_shared<ground_setup::BeliefLayer>(surroundings.scenario);
  config.explain = [belief](const wire::Sample& sample) { return belief->see(sample); };
  if (auto read = console::read_address(address_, config); !read)
    return failure("--console: " + read.error().why);
  auto page = console::Console::open(std::move(config));
  if (!page) return failure("--console: " + page.error().why);
  std::string notice = "console at " + (*page)->url();
  return Opened{std::move(*page), std::move(notice)};
}

}  // namespace skein::ground_companions
