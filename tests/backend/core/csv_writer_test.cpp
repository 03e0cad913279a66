// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"
#include "backend/core/data/csv_writer.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <random>
#include <string>

using teleta::core::CsvReader;
using teleta::core::CsvWriter;
using teleta::core::ErrorKind;
using teleta::core::Expected;
using teleta::core::makeFolder;
using teleta::core::OutputFile;
using teleta::test::readAll;
using teleta::test::TemporaryFolder;

namespace {

constexpr std::array<std::string_view, 3> kColumns{"time_s", "x_m", "type"};

void writeRow(CsvWriter& csv, double time_s, std::optional<double> x_m, std::string_view type) {
    csv.number(time_s);
    csv.number(x_m);
    csv.text(type);
    csv.endRow();
}

} // namespace

TEST(CsvWriter, writesNumbersShortestAndWhatIsUndefinedAsNA) {
    const TemporaryFolder folder;
    Expected<CsvWriter> csv = CsvWriter::create(folder.path("a.csv"), kColumns);
    ASSERT_TRUE(csv);
    writeRow(*csv, 0.1, -2.0, "point");
    writeRow(*csv, 1e-7, std::nullopt, "none");
    writeRow(*csv, 1e300, std::nan(""), "a,\"b\"");
    csv->integer(-12);
    csv->number(-std::numeric_limits<double>::infinity());
    csv->text("two\nlines");
    csv->endRow();
    ASSERT_TRUE(csv->finish());
    EXPECT_EQ(readAll(folder.path("a.csv")), "time_s,x_m,type\n0.1,-2,point\n1e-07,NA,none\n"
                                             "1e+300,NA,\"a,\"\"b\"\"\"\n-12,-inf,\"two\nlines\"\n");
}

TEST(CsvWriter, writesARowOfTextsNumbersRangesAndOptionals) {
    const TemporaryFolder folder;
    Expected<CsvWriter> csv = CsvWriter::create(folder.path("a.csv"), "name,count,x,a,b,known,unknown,word");
    ASSERT_TRUE(csv);
    csv->row(std::string("p,q"), std::size_t{3}, 0.1F, std::array{1.5, std::nan("")}, std::optional(2),
             std::optional<double>(), std::optional("w"));
    ASSERT_TRUE(csv->finish());
    EXPECT_EQ(readAll(folder.path("a.csv")),
              "name,count,x,a,b,known,unknown,word\n\"p,q\",3,0.1,1.5,NA,2,NA,w\n")
        << "0.1F has the digits of a float";
}

TEST(CsvWriter, whatItWritesReadsBackAsTheSameNumbers) {
    constexpr std::array<std::string_view, 2> kTwo{"a", "b"};
    const TemporaryFolder folder;
    std::mt19937_64 random(1);
    std::vector<double> written;
    Expected<CsvWriter> csv = CsvWriter::create(folder.path("a.csv"), kTwo);
    ASSERT_TRUE(csv);
    while (written.size() < 20000) {
        const double value = std::bit_cast<double>(random());
        if (!std::isfinite(value))
            continue;
        written.push_back(value);
        csv->number(value);
        if (written.size() % 2 == 0)
            csv->endRow();
    }
    ASSERT_TRUE(csv->finish());

    Expected<CsvReader> reader = CsvReader::open(folder.path("a.csv"));
    ASSERT_TRUE(reader);
    std::vector<double> row;
    for (std::size_t i = 0; i < written.size(); i += 2) {
        ASSERT_TRUE(reader->next(row).value());
        ASSERT_EQ(row[0], written[i]);
        ASSERT_EQ(row[1], written[i + 1]);
    }
}

TEST(OutputFile, appearsOnlyWhenItIsComplete) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.csv", "old");
    {
        Expected<CsvWriter> csv = CsvWriter::create(path, kColumns);
        ASSERT_TRUE(csv);
        writeRow(*csv, 1.0, 2.0, "point");
        csv->flush();
        EXPECT_EQ(readAll(path), "old");
    }
    EXPECT_EQ(readAll(path), "old");
    EXPECT_EQ(folder.entries(), 1U) << "the temporary file is gone";

    Expected<CsvWriter> csv = CsvWriter::create(path, kColumns);
    ASSERT_TRUE(csv);
    ASSERT_TRUE(csv->finish());
    EXPECT_EQ(readAll(path), "time_s,x_m,type\n");
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(OutputFile, aFolderThatIsMissingIsAnErrorWithTheName) {
    const TemporaryFolder folder;
    const Expected<OutputFile> file = OutputFile::create(folder.path("missing/a.csv"));
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().kind, ErrorKind::ioFailed);
    EXPECT_EQ(file.error().where.file, folder.path("missing/a.csv"));
    EXPECT_FALSE(OutputFile::create(folder.path("")));
}

TEST(OutputFile, aFolderIsMadeWithThoseAboveItAndNamedWhenItCannotBeMade) {
    const TemporaryFolder folder;
    ASSERT_TRUE(makeFolder(folder.path("a/b")));
    EXPECT_TRUE(std::filesystem::is_directory(folder.path("a/b")));
    EXPECT_TRUE(makeFolder(folder.path("a/b"))) << "it is there";
    const std::string inFile = folder.write("file", "text") + "/c";
    const Expected<void> made = makeFolder(inFile);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().kind, ErrorKind::ioFailed);
    EXPECT_EQ(made.error().where.file, inFile);
}

TEST(OutputFile, aFullDeviceIsReportedAtTheEnd) {
    Expected<OutputFile> file = OutputFile::create("/dev/full");
    ASSERT_TRUE(file);
    file->write("text");
    file->flush();
    EXPECT_TRUE(file->failed());
    const Expected<void> finished = file->finish();
    ASSERT_FALSE(finished);
    EXPECT_EQ(finished.error().kind, ErrorKind::ioFailed);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")) << "a device is not replaced";
}
