// SPDX-License-Identifier: Apache-2.0
#include "spy_commands.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "actions.hpp"
#include "argument_checks.hpp"
#include "network_options.hpp"
#include "skein/spy_tool/record.hpp"
#include "skein/spy_tool/spy.hpp"

namespace skein::cli {

namespace {

using Action = std::function<int()>;
using spy_tool::SpyOptions;
using spy_tool::Verb;
using Shared = std::shared_ptr<SpyOptions>;

constexpr const char* kSpyExamples = R"(
Examples:
  skein spy --domain 1                               nodes, slots and rates
  skein spy --domain 1 echo TaskEvent SyncMessage    samples of two slots as they come
  skein spy --domain 1 echo Telemetry --from marvin --json -n 10
  skein spy --domain 1 echo TaskEvent --where "id > 3 && state == ended" --field uav --field id
  skein spy --domain 1 --partition 'radio/marvin>ground'
  skein spy --domain 1 links --every 1               who hears whom, live
  skein spy --domain 1 doctor                        what is wrong here
  skein spy --domain 1 record flight.mcap            everything, byte for byte, until Ctrl-C
  skein spy --domain 1 record flight.mcap --passive   likewise, as root: nodes do nothing for it
  skein spy --domain 5 play flight.mcap --rate 10
Exit codes: 0, 1 the doctor found something, 2 wrong options, 3 DDS refused, 4 nothing heard.)";

/// What all commands of the spy share.
struct Spy {
  CLI::App& command;
  const Shared& options;
  Action& action;
  const Actions& actions;
};

/// A verb that shows something.
CLI::App* add_verb(const Spy& spy, const char* name, const char* description, Verb verb) {
  CLI::App* one = spy.command.add_subcommand(name, description);
  one->callback([options = spy.options, verb, &action = spy.action, &actions = spy.actions] {
    options->verb = verb;
    action = [options, &actions] { return actions.carry_out(*options); };
  });
  return one;
}

void add_slots(CLI::App* verb, const Shared& options, const char* what) {
  verb->add_option("slots", options->slots, what);
  verb->add_option("--topic", options->topics,
                   "Topics of others' types, by name or pattern, in any partition; may be repeated")
      ->allow_extra_args(false);
}

void add_echo(const Spy& spy) {
  const Shared& options = spy.options;
  CLI::App* echo = add_verb(spy, "echo", "Print samples as they come", Verb::kEcho);
  add_slots(echo, options, "Slots to print, by name or pattern (default: all)");
  auto* count = echo->add_option("-n,--count", options->count, "Stop after so many samples");
  echo->add_flag_callback(
          "--once", [options] { options->count = 1; }, "Stop after one sample")
      ->excludes(count);
  echo->add_option("--timeout", options->timeout,
                   "Give up after so many seconds without a sample, and say why")
      ->check(positive_problem);
  echo->add_option("--where", options->where,
                   "Only samples that fulfil this: \"task.id > 3 && uav == marvin\"");
  echo->add_option("--field", options->fields,
                   "Print only this field: task.id, tasks[0].state; may be repeated")
      ->allow_extra_args(false);
}

void add_lists(const Spy& spy) {
  const Shared& options = spy.options;
  CLI::App* ls = add_verb(spy, "ls", "List topics with their writers and readers", Verb::kTopics);
  ls->add_option("topics", options->slots, "Only these, by name or pattern");
  ls->add_flag("--unmatched", options->unmatched, "Only topics of which some endpoint is alone");
  ls->add_flag("--mismatch", options->mismatch,
               "Only topics of which DDS keeps endpoints apart: QoS or types");
  ls->add_flag("-v,--endpoints", options->endpoints, "Every endpoint too");
  add_verb(spy, "ps", "List the programs that take part", Verb::kNodes);
  CLI::App* events = add_verb(
      spy, "events", "Tell who comes and goes, and each sample, a line each", Verb::kEvents);
  add_slots(events, options, "Slots whose samples are told of (default: all)");
  events->add_option("-n,--count", options->count, "Stop after so many lines");
}

void add_rates(const Spy& spy) {
  const Shared& options = spy.options;
  const auto add = [&](const char* name, const char* description, Verb verb) {
    CLI::App* one = add_verb(spy, name, description, verb);
    add_slots(one, options, "Slots (default: all)");
    one->add_option("--window", options->window, "Samples of a flow to look back on")
        ->check(CLI::Range(std::uint64_t{2}, std::uint64_t{1'000'000}))
        ->capture_default_str();
    one->add_option("--every", options->every,
                    "Show it every so many seconds, not at the end alone")
        ->check(positive_problem);
  };
  add("hz", "How often samples come, flow by flow", Verb::kRate);
  add("bw", "How many bytes come, flow by flow", Verb::kBandwidth);
  add("delay", "How late samples come, flow by flow, by the clocks of both machines", Verb::kDelay);
  CLI::App* links = add_verb(spy, "links", "Who hears whom", Verb::kLinks);
  links
      ->add_option("--every", options->every, "Show it every so many seconds, not at the end alone")
      ->check(positive_problem);
}

void add_record(CLI::App& spy, const Shared& common, Action& action, const Actions& actions) {
  auto options = std::make_shared<spy_tool::RecordOptions>();
  CLI::App* record = spy.add_subcommand("record", "Write samples to an MCAP file as they come");
  record->add_option("file", options->file, "The file")->required();
  record->add_option("slots", common->slots, "Slots to record (default: all)");
  record->add_option("-n,--count", common->count, "Stop after so many samples");
  record->add_flag("--with-json", options->with_json, "Each sample as JSON too: opens everywhere");
  record->add_flag("--passive", options->passive,
                   "Look at what passes the interface instead of reading: nodes do nothing for it. "
                   "Needs CAP_NET_RAW; nothing of what was said before, nothing with keys");
  record->callback([options, common, &action, &actions] {
    action = [options, common, &actions] {
      options->spy = *common;
      return actions.carry_out(*options);
    };
  });
}

void add_play(CLI::App& spy, const Shared& common, Action& action, const Actions& actions) {
  auto options = std::make_shared<spy_tool::PlayOptions>();
  CLI::App* play = spy.add_subcommand("play", "Write the samples of a recording again");
  play->add_option("file", options->file, "Made by skein spy record")->required();
  play->add_option("--rate", options->rate, "Seconds of the recording per second")
      ->check(positive_problem)
      ->capture_default_str();
  play->add_option("--wait", options->wait, "Seconds in which readers find the writers, at first")
      ->check(CLI::Range(0.0, 60.0))
      ->capture_default_str();
  play->callback([options, common, &action, &actions] {
    action = [options, common, &actions] {
      options->domain = common->domain;
      options->network = common->network;
      return actions.carry_out(*options);
    };
  });
}

}  // namespace

void add_spy(CLI::App& app, Action& action, const Actions& actions) {
  auto options = std::make_shared<SpyOptions>();
  CLI::App* spy = app.add_subcommand("spy", "What is on the wire");
  spy->fallthrough();
  spy->require_subcommand(0, 1);
  spy->add_option("--domain", options->domain, "DDS domain id")
      ->check(CLI::Range(0, 100))
      ->envname("SKEIN_DOMAIN");
  add_network(spy, options->network);
  spy->add_option("--partition", options->partitions,
                  "DDS partition, with * and ? (default: world, onboard/*, radio/*)")
      ->allow_extra_args(false);
  spy->add_option("--from", options->from, "Only samples made by this node");
  spy->add_option("--duration", options->duration, "Seconds to listen")->check(positive_problem);
  spy->add_flag("--json", options->json, "JSON: one object a line (without a verb: one document)");
  spy->footer(kSpyExamples);
  spy->callback([options, &action, &actions] {
    if (!action)
      action = [options, &actions] { return actions.carry_out(*options); };  // without a verb
  });
  const Spy whole{*spy, options, action, actions};
  add_lists(whole);
  add_echo(whole);
  add_rates(whole);
  add_verb(whole, "doctor", "Find what is wrong: interfaces, multicast, buffers, versions, types",
           Verb::kDoctor);
  add_record(*spy, options, action, actions);
  add_play(*spy, options, action, actions);
}

}  // namespace skein::cli
