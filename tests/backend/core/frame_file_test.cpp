// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/frame_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

using teleta::core::ArrayLayout;
using teleta::core::describe;
using teleta::core::Error;
using teleta::core::ErrorKind;
using teleta::core::Expected;
using teleta::core::FrameFile;
using teleta::core::readTare;
using teleta::test::TemporaryFolder;

namespace {

constexpr ArrayLayout kTwoByTwo{2, 2, 0.001};
constexpr const char* kHeader = "time_s,t0,t1,t2,t3\n";

class FrameFileTest : public testing::Test {
protected:
    std::string write(const std::string& content) { return m_folder.write("f.csv", content); }

    /// Error of opening or of reading to the end; nothing when all is well.
    std::optional<Error> readAll(const std::string& content) {
        Expected<FrameFile> file = FrameFile::open(write(content), kTwoByTwo);
        if (!file)
            return file.error();
        for (;;) {
            const Expected<bool> any = file->next(m_time_s, m_values);
            if (!any)
                return any.error();
            if (!*any)
                return std::nullopt;
        }
    }

    TemporaryFolder m_folder;
    double m_time_s = 0.0;
    std::vector<float> m_values = std::vector<float>(4);
};

} // namespace

TEST_F(FrameFileTest, readsFramesInOrder) {
    Expected<FrameFile> file =
        FrameFile::open(write(std::string(kHeader) + "0,1,2,3,4\n0.1,5,6,7,8\n"), kTwoByTwo);
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->next(m_time_s, m_values).value());
    EXPECT_EQ(m_values, (std::vector<float>{1, 2, 3, 4}));
    ASSERT_TRUE(file->next(m_time_s, m_values).value());
    EXPECT_EQ(m_time_s, 0.1);
    EXPECT_EQ(m_values, (std::vector<float>{5, 6, 7, 8}));
    EXPECT_FALSE(file->next(m_time_s, m_values).value());
}

TEST_F(FrameFileTest, countsTheTaxelColumns) {
    EXPECT_EQ(FrameFile::countTaxels(write(kHeader)).value(), 4U);
    EXPECT_FALSE(FrameFile::countTaxels(write("time_s\n")));
    EXPECT_FALSE(FrameFile::countTaxels(m_folder.path("missing.csv")));
}

TEST_F(FrameFileTest, aLayoutThatDoesNotFitIsRefusedWithBothNumbers) {
    const Expected<FrameFile> file = FrameFile::open(write(kHeader), ArrayLayout{3, 5, 0.001});
    ASSERT_FALSE(file);
    EXPECT_EQ(describe(file.error()),
              m_folder.path("f.csv") +
                  ":1:19: the file has 4 taxel columns (expected 15 = 3 rows x 5 columns)");
}

TEST_F(FrameFileTest, wrongHeadersAreFoundWithTheirPlace) {
    std::optional<Error> error = readAll("time,t0,t1,t2,t3\n");
    ASSERT_TRUE(error);
    EXPECT_NE(error->message.find("missing columns: time_s"), std::string::npos);
    error = readAll("t0,time_s,t1,t2,t3\n");
    ASSERT_TRUE(error);
    EXPECT_EQ(error->where.column, 1);
    EXPECT_EQ(error->expected, "time_s");
    error = readAll("time_s,t0,t1,t3\n");
    ASSERT_TRUE(error);
    EXPECT_EQ(error->where.column, 14);
    EXPECT_EQ(error->expected, "t2");
    error = readAll("time_s,t0,t01,t2,t3\n");
    ASSERT_TRUE(error);
    EXPECT_EQ(error->expected, "t1");
}

TEST_F(FrameFileTest, aDeadTaxelMayBeNotFiniteAndTimeMayNot) {
    EXPECT_FALSE(readAll(std::string(kHeader) + "0,nan,inf,NA,-inf\n"));
    EXPECT_TRUE(std::isnan(m_values[0]));
    EXPECT_TRUE(std::isinf(m_values[1]));
    EXPECT_TRUE(std::isnan(m_values[2]));
    for (const char* time : {"nan", "inf", "NA"}) {
        const std::optional<Error> error =
            readAll(std::string(kHeader) + "0,1,2,3,4\n" + time + ",1,2,3,4\n");
        ASSERT_TRUE(error) << time;
        EXPECT_EQ(error->where.line, 3);
        EXPECT_EQ(error->where.column, 1);
    }
}

TEST_F(FrameFileTest, timeMayStandStillButNotGoBack) {
    EXPECT_FALSE(readAll(std::string(kHeader) + "-1,0,0,0,0\n2,0,0,0,0\n2,0,0,0,0\n"));
    const std::optional<Error> error = readAll(std::string(kHeader) + "2.5,0,0,0,0\n2.25,0,0,0,0\n");
    ASSERT_TRUE(error);
    EXPECT_EQ(describe(*error), m_folder.path("f.csv") +
                                    ":3:1: the time goes back from 2.5 to 2.25 (expected times "
                                    "that do not decrease)");
}

TEST_F(FrameFileTest, aRecordingWithoutFramesIsAnError) {
    const std::optional<Error> error = readAll(kHeader);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind, ErrorKind::badInput);
    EXPECT_NE(error->message.find("no frames"), std::string::npos);
    EXPECT_FALSE(readTare(write(kHeader), kTwoByTwo));
}

TEST_F(FrameFileTest, seekComesBackToAFrame) {
    Expected<FrameFile> file = FrameFile::open(
        write(std::string(kHeader) + "0,1,0,0,0\n\n1,2,0,0,0\n2,3,0,0,0\n3,x,0,0,0\n"), kTwoByTwo);
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->next(m_time_s, m_values).value());
    const std::uint64_t offset = file->offset();
    const long long line = file->line();
    ASSERT_TRUE(file->next(m_time_s, m_values).value());
    ASSERT_TRUE(file->next(m_time_s, m_values).value());
    ASSERT_TRUE(file->seek(offset, line));
    ASSERT_TRUE(file->next(m_time_s, m_values).value());
    EXPECT_EQ(m_time_s, 1.0);
    EXPECT_EQ(m_values[0], 2.0F);
    ASSERT_TRUE(file->next(m_time_s, m_values).value());
    const Expected<bool> wrong = file->next(m_time_s, m_values);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().where.line, 6);
    EXPECT_EQ(wrong.error().where.column, 3);
}

TEST_F(FrameFileTest, tareIsTheMeanOfTheFiniteValuesOfEachTaxel) {
    const Expected<std::vector<float>> tare =
        readTare(write(std::string(kHeader) + "0,1,nan,5,NA\n1,2,4,inf,nan\n2,6,8,6,inf\n"), kTwoByTwo);
    ASSERT_TRUE(tare);
    EXPECT_EQ((*tare)[0], 3.0F);
    EXPECT_EQ((*tare)[1], 6.0F);
    EXPECT_EQ((*tare)[2], 5.5F);
    EXPECT_TRUE(std::isnan((*tare)[3]));
}

TEST_F(FrameFileTest, tareOfARealArrayIsTheMeanOfItsRows) {
    const std::string path = TELETA_SOURCE_DIR "/../shared/data/popu/sensomatt_empty1.csv";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "skipped: the recordings are not here";
    const Expected<std::vector<float>> tare = readTare(path, ArrayLayout{12, 6, 0.01});
    ASSERT_TRUE(tare) << describe(tare.error());
    // awk -F, 'NR>1{for(i=2;i<=NF;i++)s[i]+=$i} END{print s[2]/(NR-1), s[9]/(NR-1), s[73]/(NR-1)}'
    EXPECT_FLOAT_EQ((*tare)[0], 483.2F);
    EXPECT_FLOAT_EQ((*tare)[7], 481.9F);
    EXPECT_FLOAT_EQ((*tare)[71], 485.4F);
}
