// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/recording/recording_types.h"

#include <compare>
#include <string>
#include <vector>

namespace teleta::signal {

/// Which signal: a column of a stream of a source.
struct SignalId {
    std::string source, stream, column;
    auto operator<=>(const SignalId&) const = default;
};

/// The columns of a stream: as it tells them, else t0, t1, ... in the stream's unit. None of pictures.
/// Thread: any (pure).
[[nodiscard]] std::vector<recording::Column> columnsOf(const recording::StreamInfo& stream);

/// Its frames are single events, which no line joins: touches, contacts.
[[nodiscard]] bool isOfEvents(const recording::StreamInfo& stream);

/// The name of a column in a file: with its unit at the end, where the name does not say it already
/// ("tau1", "Nm": "tau1_nm"; "force_n", "N": "force_n"). Thread: any (pure).
[[nodiscard]] std::string nameWithUnit(const std::string& name, const std::string& unit);

} // namespace teleta::signal
