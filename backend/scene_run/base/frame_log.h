// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/csv_writer.h"
#include "backend/core/error.h"

#include <optional>
#include <span>
#include <string>

namespace teleta::scene_run {

/// The frames of a tactile array as CSV: time_s,t0,t1,... Without a folder nothing is written.
class FrameLog {
public:
    [[nodiscard]] static core::Expected<FrameLog> open(const std::string& outFolder, std::size_t taxels);

    void add(double time_s, std::span<const float> values);
    [[nodiscard]] bool failed() const { return m_csv && m_csv->failed(); }
    [[nodiscard]] core::Expected<void> finish();

private:
    std::optional<core::CsvWriter> m_csv;
};

} // namespace teleta::scene_run
