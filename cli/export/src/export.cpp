// SPDX-License-Identifier: Apache-2.0
#include "skein/export_tool/export.hpp"

#include <fstream>
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/foxglove/export.hpp"
#include "skein/mcap/writer.hpp"
#include "skein/recording/run.hpp"

namespace skein::export_tool {

Result<std::uint64_t, Failure> write_mcap(const report::RunInfo& info,
                                          const std::vector<journal::Record>& records,
                                          const std::string& file, mcap::Compression compression) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  mcap::WriterOptions options;
  options.library = "skein " + info.version;
  options.compression = compression;
  mcap::Writer writer(options, [&](std::string_view bytes) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
  foxglove::export_run(info, records, writer);
  writer.close();
  out.close();
  if (!out) return failure("cannot write " + file);
  return writer.messages();
}

int export_run(const ExportOptions& options, std::ostream& out, std::ostream& err) {
  const auto run = recording::read_run(options.folder);
  if (!run) {
    err << to_text(run.error());
    return kExitBadInput;
  }
  err << to_text(run->damaged);  // the rest is still worth a file
  if (!run->info.origin)
    err << options.folder << ": of a version that did not say where on Earth it was: no map\n";
  const auto written = write_mcap(run->info, run->records, options.mcap, options.compression);
  if (!written) {
    err << written.error().why << '\n';
    return kExitSystem;
  }
  out << options.mcap << ": " << *written << " messages\n";
  return kExitOk;
}

}  // namespace skein::export_tool
