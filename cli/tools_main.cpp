// SPDX-License-Identifier: Apache-2.0
// skein-tools: the commands of `skein` about one component, without any daemon: temporal networks,
// models, traces, auctions. `skein` starts it.
#include "actions.hpp"
#include "commands.hpp"
#include "on_streams.hpp"
#include "skein/allocate_tool/allocate.hpp"
#include "skein/mle_tool/mle.hpp"
#include "skein/model_tool/model_files.hpp"
#include "skein/model_tool/run_model.hpp"
#include "skein/temporal_tool/mastn.hpp"
#include "skein/temporal_tool/stn.hpp"

int main(int argc, char** argv) {
  using namespace skein;  // NOLINT(google-build-using-namespace): the whole program is this
                          // function
  cli::Actions actions(cli::start_skein_instead);
  actions.add(cli::on_file(allocate_tool::allocate, &allocate_tool::AllocateOptions::file));
  actions.add(cli::on_file(mle_tool::run_mle, &mle_tool::MleOptions::input_name));
  actions.add(cli::on_file(model_tool::run_model, &model_tool::RunOptions::input_name));
  actions.add(cli::on_streams(model_tool::check_models));
  actions.add(cli::on_streams(model_tool::draw_models));
  actions.add(cli::on_streams(temporal_tool::generate_mastn));
  actions.add(cli::on_streams(temporal_tool::run_mastn));
  actions.add(cli::on_streams(temporal_tool::bench_mastn));
  actions.add(cli::on_streams(temporal_tool::check_stn));
  actions.add(cli::on_streams(temporal_tool::check_stn_batch));
  actions.add(cli::on_streams(temporal_tool::check_stn_controllability));
  actions.add(cli::on_streams(temporal_tool::follow_stn_changes));
  actions.add(cli::on_streams(temporal_tool::dispatch_stn));
  actions.add(cli::on_streams(temporal_tool::generate_stn));
  actions.add(cli::on_streams(temporal_tool::write_stn_dispatchable));
  actions.add(cli::on_streams(temporal_tool::draw_stn));
  actions.add(cli::on_streams(temporal_tool::convert_stn));
  return cli::run_command_line(argc, argv, actions);
}
