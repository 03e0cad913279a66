// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sources/source_request.h"

#include <QString>

#include <optional>

namespace teleta::console {

/// What the command line says about one recording; what it leaves out is guessed from the file.
struct RecordingArguments {
    QString path;
    std::optional<int> rows;
    std::optional<int> columns;
    std::optional<double> pitch_m;
    std::optional<QString> tarePath;
    std::optional<double> gain;
    std::optional<double> threshold_N;
    std::optional<double> rate_Hz;
    std::optional<QString> unit;
    bool inverted = false;
};

/// Completes what the command line says about a recording with what the file's header tells. Reads the file.
[[nodiscard]] core::Expected<app::CsvRequest> completeRecording(const RecordingArguments& recording);

} // namespace teleta::console
