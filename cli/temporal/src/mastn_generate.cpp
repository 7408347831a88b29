// SPDX-License-Identifier: Apache-2.0
// `skein mastn generate`.
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/temporal_files/network_text.hpp"
#include "skein/temporal_tool/mastn.hpp"
#include "write_file.hpp"

namespace skein::temporal_tool {

int generate_mastn(const MastnGenerateOptions& options, std::ostream& out, std::ostream& err) {
  temporal::Mastn mastn = temporal::generate_mastn(options.shape, options.seed);
  mastn.steps = temporal::make_scenario(mastn, temporal::chain_arcs(options.shape),
                                        options.scenario, options.seed);
  const std::string text = temporal::write_mastn(mastn);
  if (options.out.empty() || options.out == "-") {
    out << text;
    return kExitOk;
  }
  if (const std::optional<Failure> failed = write_file(options.out, text)) {
    err << options.out << ": " << failed->why << '\n';
    return kExitSystem;
  }
  return kExitOk;
}

}  // namespace skein::temporal_tool
