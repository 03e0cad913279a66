// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/cost/cost_figure.h"
#include "backend/cost/cost_file.h"
#include "backend/cost/frontier.h"
#include "backend/recording/recording.h"
#include "backend/servo_figure/servo_figure.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/fuzz/memory_file.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::fuzz {

namespace {

/// A picture contains only finite numbers and is complete.
void requirePicture(const std::string& svg) {
    constexpr std::size_t kMostBytes = 50'000'000;
    require(svg.ends_with("</svg>\n") || svg.ends_with("</svg>"), "a picture is complete");
    require(svg.size() < kMostBytes, "a picture has an end");
}

/// Qt finds its database drivers through the application.
void makeApplication() {
    static int argc = 1;
    static std::array<char, 5> name{"fuzz"};
    static std::array<char*, 2> argv{name.data(), nullptr};
    if (QCoreApplication::instance() == nullptr)
        static const QCoreApplication kApplication(argc, argv.data());
}

} // namespace

bool servoCsv(Bytes bytes) {
    const MemoryFile file(bytes);
    const core::Expected<servo_figure::ServoCurves> run = servo_figure::readServoCurves(file.path());
    if (!run) {
        requireExplained(run.error(), file.path());
        return false;
    }
    require(std::ranges::is_sorted(run->time_s), "times never fall");
    require(std::ranges::all_of(run->time_s, [](double time_s) { return std::isfinite(time_s); }),
            "times are finite");
    require(run->force_N.size() == run->time_s.size(), "a curve has a value a time");
    requirePicture(servo_figure::servoFigure(std::span(&*run, 1)).standalone());
    return true;
}

bool costCsv(Bytes bytes) {
    const MemoryFile file(bytes);
    const core::Expected<std::vector<cost::LadderCost>> ladders = cost::readCostFile(file.path());
    if (!ladders) {
        requireExplained(ladders.error(), file.path());
        return false;
    }
    for (cost::LadderCost ladder : *ladders) {
        require(!ladder.rungs.empty(), "a ladder has rungs");
        requirePicture(cost::costSvg(ladder, ladder.ladder));
        const cost::RungCost* best = cost::bestWithin(ladder.rungs, 0.008);
        require(best == nullptr || best->timeP99_s <= 0.008, "the best rung keeps within its budget");
        cost::markFrontier(ladder.rungs);
    }
    return true;
}

bool recording(Bytes bytes) {
    makeApplication();
    // SQLite opens the file by its real name.
    const test::TemporaryFolder folder;
    const std::string path = folder.write("input.teleta", textOf(bytes));
    const core::Expected<recording::Recording> opened = recording::Recording::open(path);
    if (!opened) {
        require(!opened.error().message.empty(), "an error has a message");
        require(opened.error().where.file == path, "an error names its file");
        return false;
    }
    bool whole = true;
    constexpr int kMostBlocks = 1000;
    for (std::size_t i = 0; i < opened->streams().size(); ++i) {
        const recording::StreamInfo& stream = opened->streams()[i];
        recording::StreamReader reader = opened->reader(i);
        core::TappedFrames block;
        for (int blocks = 0; blocks < kMostBlocks; ++blocks) {
            const core::Expected<bool> any = reader.next(block);
            whole = whole && any.has_value();
            if ((any && !*any) || !reader.canGoOn())
                break;
            if (!any)
                continue;
            require(block.frames() > 0 && block.hasTimesInOrder(), "times of a block never fall");
            require(!block.image.isEmpty() ||
                        block.values.size() == block.frames() * stream.channels() * stream.bytesPerValue(),
                    "a block has the values of its shape");
        }
    }
    return whole;
}

} // namespace teleta::fuzz
