// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/base/frame_log.h"

#include "backend/core/number_text.h"

#include <string_view>
#include <vector>

namespace teleta::scene_run {

core::Expected<FrameLog> FrameLog::open(const std::string& outFolder, std::size_t taxels) {
    FrameLog log;
    if (outFolder.empty())
        return log;
    std::vector<std::string> names{"time_s"};
    for (std::size_t taxel = 0; taxel < taxels; ++taxel)
        names.emplace_back("t").append(core::NumberText(taxel).view());
    const std::vector<std::string_view> columns(names.begin(), names.end());
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(outFolder + "/frames.csv", columns));
    log.m_csv = std::move(csv);
    return log;
}

void FrameLog::add(double time_s, std::span<const float> values) {
    if (!m_csv)
        return;
    m_csv->number(time_s);
    for (const float value : values)
        m_csv->number(value);
    m_csv->endRow();
}

core::Expected<void> FrameLog::finish() {
    return m_csv ? m_csv->finish() : core::Expected<void>();
}

} // namespace teleta::scene_run
