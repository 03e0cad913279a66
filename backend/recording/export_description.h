// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/recording/recording.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace teleta::recording {

/// An exported table, for the description beside it.
struct DescribedTable {
    std::string path;
    const StreamInfo* stream = nullptr; ///< null: the events
    std::vector<std::string> columns;
    std::uint64_t rows = 0;
    std::uint64_t damagedBlocks = 0;
};

/// What recording.json says of exported tables: start and anchors in UTC, which version recorded and which
/// one exported, the SHA-256 of the recording, and of each table its stream, rows and the unit of each
/// column. goOn: called now and then; once it returns false the sum is left out (null). Error: ioFailed.
[[nodiscard]] core::Expected<std::string> exportDescription(const Recording& recording,
                                                            const std::vector<DescribedTable>& tables,
                                                            const std::function<bool()>& goOn);

/// Unix time in s with nine decimals, as text: a double keeps 0.24 us of it. By the first anchor, so that it
/// never goes back; "NA" when the recording has none.
[[nodiscard]] std::string unixSeconds(const Recording& recording, std::int64_t time_ns);

} // namespace teleta::recording
