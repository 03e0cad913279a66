// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/base/run_csv.h"

#include "backend/core/number_text.h"

namespace teleta::scene_run {

core::Expected<RunCsv> RunCsv::open(const std::string& outFolder, const std::string& file,
                                    std::string_view header) {
    RunCsv csv;
    if (!outFolder.empty()) {
        TELETA_TRY(csv.m_csv, core::CsvWriter::create(outFolder + "/" + file, header));
    }
    return csv;
}

core::Expected<RunCsv> RunCsv::openFrames(const std::string& outFolder, std::size_t taxels) {
    std::string header = "time_s";
    for (std::size_t taxel = 0; taxel < taxels; ++taxel)
        header.append(",t").append(core::NumberText(taxel).view());
    return open(outFolder, "frames.csv", header);
}

} // namespace teleta::scene_run
