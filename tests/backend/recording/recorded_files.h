// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/steady_time.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"
#include "tests/backend/core/temporary_folder.h"

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace teleta::test {

/// Qt finds its database drivers through the application.
inline void makeApplication() {
    static int argc = 1;
    static std::array<char, 5> name{"test"};
    static std::array<char*, 2> argv{name.data(), nullptr};
    static const QCoreApplication kApplication(argc, argv.data());
}

inline constexpr std::size_t kTaxels = 6;

inline recording::StreamInfo arrayInfo(const std::string& name = "frames") {
    recording::StreamInfo info;
    info.name = name;
    info.kind = recording::StreamKind::array;
    info.type = recording::ValueType::float32;
    info.source = "bench array";
    info.shape = {2, 3};
    info.unit = "N";
    info.nominalRate_Hz = 200.0;
    info.details = R"({"pitch_m":0.0034})";
    return info;
}

inline recording::RecordingHead headAt(std::int64_t start_ns) {
    return {.appVersion = "1.2.3",
            .scene = "a scene",
            .sceneText = "[scene]\n",
            .configuration = "{}",
            .start_ns = start_ns};
}

inline void appendFrame(core::StreamTap& tap, std::int64_t time_ns, float first) {
    std::array<float, kTaxels> values{};
    for (std::size_t i = 0; i < kTaxels; ++i)
        values[i] = first + static_cast<float>(i) * 0.125F;
    tap.append(time_ns, static_cast<double>(time_ns) / 1e9, std::span<const float>(values));
}

/// Of a block that is many pages of its file.
inline constexpr int kLargeFrames = 10;
inline constexpr std::size_t kLargeTaxels = 32 * 32;

/// Records so many large blocks of one array, with a millisecond between frames; the number of a frame is all
/// its values.
inline void recordLargeBlocks(const std::string& path, std::int64_t first_ns, int blocks) {
    makeApplication();
    auto recorder = recording::Recorder::start(path, headAt(first_ns), {.simulatedTime = true});
    ASSERT_TRUE(recorder);
    recording::StreamInfo info = arrayInfo();
    info.shape = {32, 32};
    const auto tap = (*recorder)->addStream(info);
    for (int block = 0; block < blocks; ++block) {
        std::vector<std::int64_t> time_ns;
        std::vector<float> values;
        for (int i = block * kLargeFrames; i < (block + 1) * kLargeFrames; ++i) {
            time_ns.push_back(first_ns + i * 1'000'000LL);
            values.insert(values.end(), kLargeTaxels, static_cast<float>(i));
        }
        const std::vector<double> time_s(time_ns.size(), 0.0);
        tap->append(std::span<const std::int64_t>(time_ns), std::span<const double>(time_s),
                    std::span<const float>(values), /*discontinuity=*/true);
    }
    ASSERT_TRUE((*recorder)->stop());
}

/// Overwrites the page of a file that has this, as a bad sector of a disk does.
inline void damagePageWith(const std::string& path, std::string_view bytes) {
    constexpr std::size_t kPage = 4096;
    std::string content = readAll(path);
    const std::size_t place = content.find(bytes);
    ASSERT_NE(place, std::string::npos);
    content.replace(place / kPage * kPage, kPage, kPage, '\xff');
    std::ofstream(path, std::ios::binary) << content;
}

/// A page in the middle of a large block.
inline void damageLargeBlock(const std::string& path, int block) {
    const std::vector<float> values(16, static_cast<float>(block * kLargeFrames + kLargeFrames / 2));
    damagePageWith(path,
                   {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values.front())});
}

/// Another program's view of the file.
inline std::string askFile(const std::string& path, const QString& sql) {
    makeApplication();
    QString answer;
    {
        QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("asked"));
        database.setDatabaseName(QString::fromStdString(path));
        if (database.open()) {
            QSqlQuery query(database);
            answer = query.exec(sql) && query.next() ? query.value(0).toString() : query.lastError().text();
        }
    }
    QSqlDatabase::removeDatabase(QStringLiteral("asked"));
    return answer.toStdString();
}

/// All frames of a stream, block by block.
struct ReadFrames {
    std::vector<std::int64_t> time_ns;
    std::vector<double> sourceTime_s;
    std::vector<float> values;
    std::size_t blocks = 0;
    std::size_t jumps = 0;
};

inline ReadFrames readAllFrames(recording::StreamReader reader) {
    ReadFrames all;
    core::TappedFrames block;
    for (;;) {
        const auto any = reader.next(block);
        EXPECT_TRUE(any) << core::describe(any.error());
        if (!any || !*any)
            return all;
        ++all.blocks;
        all.jumps += block.discontinuity ? 1 : 0;
        all.time_ns.insert(all.time_ns.end(), block.time_ns.begin(), block.time_ns.end());
        all.sourceTime_s.insert(all.sourceTime_s.end(), block.sourceTime_s.begin(), block.sourceTime_s.end());
        for (std::size_t frame = 0; frame < block.frames(); ++frame) {
            const auto values = recording::valuesOf<float>(block, frame, kTaxels);
            all.values.insert(all.values.end(), values.begin(), values.end());
        }
    }
}

} // namespace teleta::test
