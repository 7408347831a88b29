// SPDX-License-Identifier: Apache-2.0
// skein-air: carries packets between the network namespaces of scripts/radio-lab.
#include <CLI/CLI.hpp>
#include <iostream>

#include "skein/air/run_air.hpp"
#include "skein/foundation/exit_code.hpp"

int main(int argc, char** argv) try {
  using namespace skein;  // NOLINT(google-build-using-namespace)
  CLI::App app{"Carries packets between network namespaces as the simulator's radio says",
               "skein-air"};
  air::AirOptions options;
  double delay = 0, bits = 0;
  app.add_option("--scenario", options.scenario, "Scenario file (YAML)")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_flag("--list", options.list, "Print the nodes that are on the air, and end");
  app.add_option("--fault", options.faults, "Fault script (YAML); may be repeated")
      ->allow_extra_args(false)
      ->check(CLI::ExistingFile);
  app.add_option("--write", options.write,
                 "Write the scenario with the fault scripts to this file, and end");
  app.add_option("--spaces", options.spaces, "Folder of the namespaces, named like the nodes")
      ->capture_default_str();
  app.add_option("--domain", options.domain, "DDS domain id")->check(CLI::Range(0, 100));
  app.add_option("--interface", options.network.interfaces, "IPv4 address where the simulator is")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--security", options.network.keys,
                 "Folder of keys that may hear the world: those of spy");
  app.add_option("--loss", options.everywhere.loss, "Share of packets lost on every link")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--delay", delay, "On every link [s]")->check(CLI::Range(0.0, 60.0));
  app.add_option("--bits", bits, "On every link [bit/s]; 0: any")->check(CLI::Range(0.0, 1e12));
  app.add_option("--queue", options.longest_queue, "What waits longer before a link is lost [s]")
      ->check(CLI::Range(0.0, 60.0))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Of the losses")->capture_default_str();
  app.add_option("--report", options.report, "File for what went over each link, as JSON");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitBadInput;
  }
  options.everywhere.delay = Duration::seconds(delay);
  options.everywhere.rate = bits / 8;
  return air::run_air(options, std::cout, std::cerr);
} catch (const std::exception& error) {
  std::cerr << "skein-air: " << error.what() << '\n';
  return skein::kExitInternal;
}
