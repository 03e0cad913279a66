// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"
#include "backend/recording/stream_columns.h"
#include "backend/signal/recorded_signals.h"
#include "backend/signal/signal_csv.h"
#include "tests/backend/recording/recorded_files.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

using namespace teleta;
using namespace teleta::signal;
using namespace teleta::test;

namespace {

constexpr std::int64_t kStart_ns = 77'000'000'000;

class RecordedSignalsTest : public testing::Test {
protected:
    RecordedSignalsTest() {
        makeApplication();
        auto recorder =
            recording::Recorder::start(m_path, headAt(kStart_ns), {.simulatedTime = true}).value();
        const auto frames = recorder->addStream(arrayInfo());
        const auto joints = recorder->addStream(recording::jointStream(100.0, 1));
        for (int i = 0; i < 1000; ++i) {
            appendFrame(*frames, kStart_ns + 5'000'000LL * i, 0.001F * static_cast<float>(i));
            const std::vector<double> values{0.5 * i, 2.0, std::numeric_limits<double>::quiet_NaN()};
            joints->append(kStart_ns + 10'000'000LL * i, 0.01 * i, std::span<const double>(values));
        }
        EXPECT_TRUE(recorder->stop());
    }

    TemporaryFolder m_folder;
    const std::string m_path = m_folder.path("run.teleta");
};

} // namespace

TEST_F(RecordedSignalsTest, listsTheStreams) {
    const auto streams = signalStreamsOf(m_path);
    ASSERT_TRUE(streams) << core::describe(streams.error());
    ASSERT_EQ(streams->size(), 2U);
    EXPECT_EQ(columnsOf((*streams)[0]).size(), kTaxels);
    EXPECT_EQ(columnsOf((*streams)[1])[1].name, "tau1");
}

TEST(SimulatedSources, areThoseOfWhichAStreamSaysSo) {
    const std::vector<recording::StreamInfo> streams{
        {.name = "touches", .source = "arm", .details = ""},
        {.name = "joints", .source = "arm", .details = R"({"simulated": true, "joints": 1})"},
        {.name = "taxels", .source = "pad", .details = R"({"simulated": false})"},
        {.name = "broken", .source = "camera", .details = R"({"simulated": tr)"}};
    EXPECT_EQ(simulatedSourcesOf(streams), std::set<std::string>{"arm"});
    EXPECT_TRUE(simulatedSourcesOf({}).empty());
}

TEST_F(RecordedSignalsTest, readsWholeColumns) {
    double done = 0.0;
    const auto read =
        readSignals(m_path, "joints", std::vector<std::string>{"tau1", "q1"}, [&](double share) {
            done = share;
            return true;
        });
    ASSERT_TRUE(read) << core::describe(read.error());
    ASSERT_EQ(read->series.size(), 2U);
    EXPECT_EQ(read->damagedBlocks, 0U);
    EXPECT_DOUBLE_EQ(done, 1.0);
    const Series& angle = read->series[1];
    ASSERT_EQ(angle.size(), 1000U);
    EXPECT_EQ(angle.value(999), 499.5);
    EXPECT_NEAR(angle.time_s(999), 9.99, 1e-9);
    EXPECT_EQ(read->series[0].value(500), 2.0);
}

TEST_F(RecordedSignalsTest, canBeStoppedAndNamesWhatIsMissing) {
    const auto stopped =
        readSignals(m_path, "joints", std::vector<std::string>{"q1"}, [](double) { return false; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, core::ErrorKind::cancelled);
    const auto none = readSignals(m_path, "joints", std::vector<std::string>{"q9"}, {});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, core::ErrorKind::notFound);
    EXPECT_NE(none.error().message.find("q9"), std::string::npos);
}

TEST_F(RecordedSignalsTest, areWrittenAsCsvOnOneTimeAxis) {
    Series fast, slow;
    for (int i = 0; i < 6; ++i)
        fast.append(0.5 * i, i);
    slow.append(0.0, 10.0);
    slow.append(2.0, 12.0);
    const std::vector<CsvSignal> written{{"fast_n", fast}, {"slow_rad", slow}};
    const std::string path = m_folder.path("out.csv");
    ASSERT_TRUE(writeSignalCsv(path, written, 0.5, 2.0));
    EXPECT_EQ(readAll(path), "time_s,fast_n,slow_rad\n0.5,1,NA\n1,2,NA\n1.5,3,NA\n2,4,12\n");
}
