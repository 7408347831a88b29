// SPDX-License-Identifier: Apache-2.0
// Event log lines for effects of the ground station that are only reported (docs/journal.md).
#pragma once

#include "skein/ground_station/ground_control.hpp"
#include "skein/ground_station/team_desk.hpp"
#include "skein/journal/record.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ground {

journal::Record line_of(const translation::Writer& writer,
                        const ground_station::OperatorAsked& effect);
journal::Record line_of(const translation::Writer& writer,
                        const ground_station::HandChanged& effect);
journal::Record line_of(const translation::Writer& writer,
                        const ground_station::LocalRequestAnswered& effect);
journal::Record line_of(const translation::Writer& writer, const ground_station::LocalSync& effect);
journal::Record line_of(const translation::Writer& writer,
                        const ground_station::HeldPlanChanged& effect);
journal::Record line_of(const translation::Writer& writer,
                        const ground_station::PerceptionLogged& effect);
journal::Record line_of(const translation::Writer& writer, const ground_station::StepDone& effect);
journal::Record line_of(const translation::Writer& writer,
                        const ground_station::OperatorDid& effect);
journal::Record line_of(const translation::Writer& writer,
                        const ground_station::UavRestarted& effect);
journal::Record line_of(const translation::Writer& writer, const ground_station::Anomaly& effect);
journal::Record line_of(const translation::Writer& writer,
                        const ground_station::TeamTokenChanged& effect);

}  // namespace skein::ground
