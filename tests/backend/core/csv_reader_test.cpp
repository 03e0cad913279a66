// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <limits>
#include <optional>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

using teleta::core::CsvReader;
using teleta::core::describe;
using teleta::core::Error;
using teleta::core::ErrorKind;
using teleta::core::Expected;
using teleta::test::TemporaryFolder;

namespace {

class CsvReaderTest : public testing::Test {
protected:
    Expected<CsvReader> open(std::string_view content) {
        return CsvReader::open(m_folder.write("a.csv", content));
    }

    /// Reads all rows; the rows that came before an error are kept.
    std::vector<std::vector<double>> rows(std::string_view content, bool allowNonFinite = false) {
        m_error.reset();
        std::vector<std::vector<double>> result;
        Expected<CsvReader> csv = open(content);
        if (!csv) {
            m_error = csv.error();
            return result;
        }
        std::vector<double> values;
        for (;;) {
            const Expected<bool> any = csv->next(values, allowNonFinite);
            if (!any)
                m_error = any.error();
            if (!any || !*any)
                return result;
            result.push_back(values);
        }
    }

    /// "line:column" of the error that rows() met; "none" without an error.
    std::string place() const {
        return m_error ? std::to_string(m_error->where.line) + ':' + std::to_string(m_error->where.column)
                       : "none";
    }

    TemporaryFolder m_folder;
    std::optional<Error> m_error;
};

using Rows = std::vector<std::vector<double>>;

} // namespace

TEST_F(CsvReaderTest, readsHeaderAndRows) {
    const Expected<CsvReader> csv = open("a,b c,d\n1,2,3\n");
    ASSERT_TRUE(csv);
    EXPECT_EQ(csv->header(), (std::vector<std::string>{"a", "b c", "d"}));
    EXPECT_EQ(csv->column("b c").value(), 1U);
    EXPECT_EQ(rows("a,b\n1,-2.5\n3e2,+4\n.5,6.\n"), (Rows{{1, -2.5}, {300, 4}, {0.5, 6}}));
    EXPECT_EQ(place(), "none");
}

TEST_F(CsvReaderTest, lineEndsBlankLinesAndByteOrderMarkMakeNoDifference) {
    const Rows expected{{1, 2}, {3, 4}};
    EXPECT_EQ(rows("a,b\n1,2\n3,4\n"), expected);
    EXPECT_EQ(rows("a,b\n1,2\n3,4"), expected);
    EXPECT_EQ(rows("a,b\r\n1,2\r\n3,4\r\n"), expected);
    EXPECT_EQ(rows("\xEF\xBB\xBF\r\n a , b \r\n\r\n1,2\n\n  \n3 ,\t4\n\n\n"), expected);
    EXPECT_EQ(open("\xEF\xBB\xBFtime_s,b\n")->header().front(), "time_s");
}

TEST_F(CsvReaderTest, quotedFieldsFollowRfc4180) {
    const Expected<CsvReader> csv = open("\"a,1\",\"say \"\"b\"\"\",\"two\nlines\"\n");
    ASSERT_TRUE(csv);
    EXPECT_EQ(csv->header(), (std::vector<std::string>{"a,1", "say \"b\"", "two\nlines"}));
    EXPECT_EQ(csv->nextLine(), 3);
    EXPECT_EQ(rows("\"a\",b\n\"1.5\",2\n3,\"4\"\n"), (Rows{{1.5, 2}, {3, 4}}));
}

TEST_F(CsvReaderTest, numbersAreReadToTheLastBit) {
    // Shortest texts of these doubles, from the IEEE 754 definition of their bit patterns.
    const Rows read =
        rows("a,b,c,d\n0.1,1.7976931348623157e308,4.9406564584124654e-324,2.2250738585072014e-308\n");
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0][0], 0x1.999999999999ap-4);
    EXPECT_EQ(read[0][1], std::numeric_limits<double>::max());
    EXPECT_EQ(read[0][2], std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(read[0][3], std::numeric_limits<double>::min());
}

TEST_F(CsvReaderTest, tooSmallNumbersAreZeroAndTooLargeOnesInfinite) {
    EXPECT_EQ(rows("a,b\n1e-400,-1e-400\n"), (Rows{{0.0, 0.0}}));
    EXPECT_EQ(rows("a,b\n1e400,-1e400\n", true),
              (Rows{{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}}));
    EXPECT_TRUE(rows("a,b\n1,1e400\n").empty());
    EXPECT_EQ(place(), "2:3");
}

TEST_F(CsvReaderTest, nonFiniteValuesNeedPermission) {
    const Rows read = rows("a,b,c,d\nnan,inf,NA,-Infinity\n", true);
    ASSERT_EQ(read.size(), 1U);
    EXPECT_TRUE(std::isnan(read[0][0]));
    EXPECT_EQ(read[0][1], std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(read[0][2]));
    EXPECT_EQ(read[0][3], -std::numeric_limits<double>::infinity());
    for (const char* text : {"nan", "inf", "NA"}) {
        EXPECT_TRUE(rows(std::string("a,b\n1,2\n3,") + text + "\n").size() == 1U);
        EXPECT_EQ(place(), "3:3");
        EXPECT_EQ(m_error->kind, ErrorKind::badInput);
        EXPECT_NE(m_error->message.find(text), std::string::npos);
    }
}

TEST_F(CsvReaderTest, textInsteadOfANumberIsFoundWithItsPlace) {
    EXPECT_EQ(rows("a,b\n1,2\n3,x1\n"), (Rows{{1, 2}}));
    EXPECT_EQ(describe(*m_error),
              m_folder.path("a.csv") + ":3:3: \"x1\" is not a number (expected a finite number)");
    for (const char* text :
         {"1.5.2", "0x10", "1,5;", "--1", "+-1", "1 2", "1e", "-", "NaNa", "\"1\"2", "1\"2\""}) {
        EXPECT_TRUE(rows(std::string("a,b\n9,") + text + "\n", true).empty()) << text;
        EXPECT_TRUE(m_error) << text;
    }
    rows("a,b\r\n\r\n1,2\r\n,3\r\n");
    EXPECT_EQ(place(), "4:1");
    rows("a,b\n1,\n");
    EXPECT_EQ(place(), "2:3");
}

TEST_F(CsvReaderTest, columnsOfErrorsCountCharactersNotBytes) {
    rows("a,b,c\n\"ä€𝄞\",x\n");
    EXPECT_EQ(place(), "2:1");
    rows("a,b,c\n\" 1\",\xE2\x82\xAC,1\n");
    EXPECT_EQ(place(), "2:6");
    const Expected<CsvReader> csv = open("ä€,b\n");
    EXPECT_EQ(csv->place(1).column, 4);
}

TEST_F(CsvReaderTest, placesInRowsOfSeveralLinesAreExact) {
    const Expected<CsvReader> csv = open("\n\"two\nlines\",b\n");
    EXPECT_EQ(csv->place(0).line, 2);
    EXPECT_EQ(csv->place(1).line, 3);
    EXPECT_EQ(csv->place(1).column, 8);
}

TEST_F(CsvReaderTest, rowsOfTheWrongLengthAreErrors) {
    EXPECT_EQ(rows("a,b,c\n1,2,3\n4,5\n"), (Rows{{1, 2, 3}}));
    EXPECT_EQ(place(), "3:4");
    EXPECT_NE(m_error->message.find("2 of 3"), std::string::npos);
    EXPECT_EQ(rows("a,b,c\n1,2,3\n4,5,6,7\n"), (Rows{{1, 2, 3}}));
    EXPECT_EQ(place(), "3:7");
    rows("a,b,c\n4,5,6,\n");
    EXPECT_EQ(place(), "2:7");
}

TEST_F(CsvReaderTest, anEmptyFileIsAnErrorAndAHeaderAloneIsNot) {
    for (const char* content : {"", "\n\r\n \n", "\xEF\xBB\xBF"}) {
        rows(content);
        ASSERT_TRUE(m_error);
        EXPECT_EQ(m_error->kind, ErrorKind::badInput);
        EXPECT_EQ(place(), "1:1");
    }
    EXPECT_TRUE(rows("a,b").empty());
    EXPECT_EQ(place(), "none");
}

TEST_F(CsvReaderTest, missingColumnsAreAllNamed) {
    const Expected<CsvReader> csv = open("time_s,torque\n");
    constexpr std::array<std::string_view, 3> kNames{"joint_angle_rad", "time_s", "joint_torque_nm"};
    const auto found = csv->columns(kNames);
    ASSERT_FALSE(found);
    EXPECT_EQ(describe(found.error()),
              m_folder.path("a.csv") +
                  ":1:1: missing columns: joint_angle_rad, joint_torque_nm; the file has: "
                  "time_s, torque (expected the columns joint_angle_rad, time_s, "
                  "joint_torque_nm)");
    EXPECT_FALSE(csv->column("Time_s"));
    EXPECT_FALSE(open("a,b,a\n")->column("a"));
    EXPECT_TRUE(open("a,b,a\n")->column("b"));
}

TEST_F(CsvReaderTest, whatCannotBeOpenedSaysWhy) {
    const Expected<CsvReader> missing = CsvReader::open(m_folder.path("missing.csv"));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::notFound);
    EXPECT_EQ(missing.error().where.file, m_folder.path("missing.csv"));
    const Expected<CsvReader> folder = CsvReader::open(m_folder.path(""));
    ASSERT_FALSE(folder);
    EXPECT_EQ(folder.error().kind, ErrorKind::badInput);
    const Expected<CsvReader> utf16 = open(std::string_view("\xFF\xFE\x61\0\x0A\0", 6));
    ASSERT_FALSE(utf16);
    EXPECT_NE(utf16.error().message.find("UTF-16"), std::string::npos);
}

TEST_F(CsvReaderTest, foundTextIsShownShortAndPrintable) {
    rows(std::string("a\n\x1b[31m\x01") + std::string(5000, 'x') + "\n");
    ASSERT_TRUE(m_error);
    EXPECT_EQ(m_error->message.find('\x1b'), std::string::npos);
    EXPECT_LT(m_error->message.size(), 100U);
}

TEST_F(CsvReaderTest, aLineOf16MebibytesIsReadAndALongerOneRefused) {
    constexpr std::size_t kLimit = 16U << 20U;
    const std::string padding(kLimit - 3, ' ');
    EXPECT_EQ(rows("a,b\n1," + padding + "2\n3,4\n"), (Rows{{1, 2}, {3, 4}}));
    EXPECT_EQ(rows("a,b\n1,2\n3, " + padding + "4\n"), (Rows{{1, 2}}));
    EXPECT_EQ(m_error->where.line, 3);
    EXPECT_EQ(m_error->kind, ErrorKind::badInput);
    rows("a,b\n1, " + padding + "2");
    EXPECT_EQ(m_error->where.line, 2);
}

TEST_F(CsvReaderTest, anOpenQuoteIsFoundWhereItOpens) {
    rows("a,b\n1,2\n3,\"4\n5,6\n");
    EXPECT_EQ(place(), "3:3");
    rows("a,b\n1,\"" + std::string(17U << 20U, '\n'));
    EXPECT_EQ(m_error->where.line, 2);
}

TEST_F(CsvReaderTest, seekComesBackToARowThatWasReportedBefore) {
    // Rows of different length over several buffer loads, so that seeks go inside and outside of the buffer.
    std::string content = "a,b\r\n";
    for (int i = 0; i < 60000; ++i)
        content += std::to_string(i) + ',' + std::string(static_cast<std::size_t>(i % 7), ' ') + "0.5\r\n" +
                   (i % 1000 == 0 ? "\n" : "");
    Expected<CsvReader> csv = open(content);
    ASSERT_TRUE(csv);
    EXPECT_EQ(csv->bytesTotal(), content.size());
    struct Mark {
        std::uint64_t offset;
        long long line;
        double value;
    };
    std::vector<Mark> marks;
    std::vector<double> values;
    for (int i = 0; i < 60000; ++i) {
        if (i % 9973 == 0)
            marks.push_back({csv->bytesRead(), csv->nextLine(), static_cast<double>(i)});
        ASSERT_TRUE(csv->next(values).value());
        ASSERT_EQ(values[0], i);
    }
    EXPECT_FALSE(csv->next(values).value());
    EXPECT_EQ(csv->bytesRead(), content.size());
    for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
        ASSERT_TRUE(csv->seek(mark->offset, mark->line));
        ASSERT_TRUE(csv->next(values).value());
        EXPECT_EQ(values[0], mark->value);
        ASSERT_TRUE(csv->next(values).value());
        EXPECT_EQ(values[0], mark->value + 1);
    }
    ASSERT_TRUE(csv->seek(marks[1].offset, marks[1].line));
    ASSERT_TRUE(csv->next(values).value());
    // Header, 9973 rows before, and the ten empty lines behind rows 0, 1000, ... 9000.
    EXPECT_EQ(csv->line(), 1 + 9973 + 10 + 1);
}

TEST_F(CsvReaderTest, aPipeIsReadAsItComesAndHasNoPositions) {
    const std::string path = m_folder.path("pipe");
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    std::thread writer([&] {
        const int file = ::open(path.c_str(), O_WRONLY);
        for (const std::string_view part : {"a,", "b\n1", ",2\n3,", "4"})
            EXPECT_EQ(::write(file, part.data(), part.size()), static_cast<ssize_t>(part.size()));
        ::close(file);
    });
    Expected<CsvReader> csv = CsvReader::open(path);
    ASSERT_TRUE(csv);
    std::vector<double> values;
    EXPECT_TRUE(csv->next(values).value());
    EXPECT_TRUE(csv->next(values).value());
    EXPECT_EQ(values, (std::vector<double>{3, 4}));
    EXPECT_FALSE(csv->next(values).value());
    writer.join();
    EXPECT_EQ(csv->bytesTotal(), 0U);
    const Expected<void> sought = csv->seek(4, 2);
    ASSERT_FALSE(sought);
    EXPECT_EQ(sought.error().kind, ErrorKind::refused);
}

TEST_F(CsvReaderTest, aSignalEndsTheWaitForAPipeAndReadingGoesOnAfterIt) {
    const std::string path = m_folder.path("pipe");
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    struct sigaction action = {};
    action.sa_handler = [](int) {};
    struct sigaction before = {};
    ASSERT_EQ(sigaction(SIGUSR1, &action, &before), 0);

    const int both = ::open(path.c_str(), O_RDWR);
    ASSERT_EQ(::write(both, "a\n1", 3), 3);
    Expected<CsvReader> csv = CsvReader::open(path);
    ASSERT_TRUE(csv);
    std::atomic<bool> done = false;
    const pthread_t reader = pthread_self();
    // The signal may come before the wait began, so it is sent until the wait has ended.
    std::thread sender([&] {
        while (!done) {
            pthread_kill(reader, SIGUSR1);
            std::this_thread::yield();
        }
    });
    std::vector<double> values;
    const Expected<bool> interrupted = csv->next(values);
    done = true;
    sender.join();
    ASSERT_FALSE(interrupted);
    EXPECT_EQ(interrupted.error().kind, ErrorKind::cancelled);
    ASSERT_EQ(::write(both, "5\n", 2), 2);
    EXPECT_TRUE(csv->next(values).value());
    EXPECT_EQ(values, (std::vector<double>{15}));
    ::close(both);
    sigaction(SIGUSR1, &before, nullptr);
}

TEST_F(CsvReaderTest, readsTextWithoutItsQuotesAndOuterBlanks) {
    Expected<CsvReader> csv =
        open("a,b,c\r\nx, two words ,\r\n\"a,b\",\"say \"\"no\"\"\",\"two\nlines\"\r\n");
    ASSERT_TRUE(csv);
    std::vector<std::string_view> fields;
    ASSERT_TRUE(csv->nextText(fields).value());
    EXPECT_EQ(fields, (std::vector<std::string_view>{"x", "two words", ""}));
    ASSERT_TRUE(csv->nextText(fields).value());
    EXPECT_EQ(fields, (std::vector<std::string_view>{"a,b", "say \"no\"", "two\nlines"}));
    EXPECT_FALSE(csv->nextText(fields).value());
}

TEST_F(CsvReaderTest, textRowsOfAnotherLengthAndTextBesideQuotesAreErrorsWithTheirPlace) {
    struct Case {
        std::string row;
        long long column;
    };
    for (const Case& wrong : {Case{"1", 2}, Case{"1,2,3", 5}, Case{"1,\"2\"3", 3}}) {
        Expected<CsvReader> csv = open("a,b\nx,y\n" + wrong.row + "\n");
        ASSERT_TRUE(csv);
        std::vector<std::string_view> fields;
        ASSERT_TRUE(csv->nextText(fields).value());
        const Expected<bool> row = csv->nextText(fields);
        ASSERT_FALSE(row) << wrong.row;
        EXPECT_EQ(row.error().kind, ErrorKind::badInput);
        EXPECT_EQ(row.error().where.line, 3);
        EXPECT_EQ(row.error().where.column, wrong.column) << wrong.row;
    }
}
