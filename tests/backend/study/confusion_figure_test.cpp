// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/confusion_figure.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/backend/study/paper_tables.h"

#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace teleta::study {

namespace {

/// Texts of the picture in their order; nothing when it is not well-formed.
std::vector<std::string> textsOf(const std::string& svg) {
    QXmlStreamReader reader(QString::fromStdString(svg));
    std::vector<std::string> texts;
    while (!reader.atEnd()) {
        if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == QStringLiteral("text"))
            texts.push_back(reader.readElementText().toStdString());
    }
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
    return texts;
}

std::vector<std::string> letters(std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i)
        names.emplace_back(1, static_cast<char>('A' + static_cast<char>(i)));
    return names;
}

} // namespace

TEST(ConfusionFigure, showsTheTablesOfThePaperFromTheirCounts) {
    for (const PaperTable& table : kPaperTables) {
        const std::size_t k = table.counts.size();
        std::vector<std::string> expected = {table.name, "Subject response, %", "Actual pattern"};
        for (const std::string& name : letters(k))
            expected.push_back(name);
        for (std::size_t i = 0; i < k; ++i) {
            expected.push_back(letters(k)[i]);
            for (const double percent : table.percent[i]) {
                char text[16];
                std::snprintf(text, sizeof text, percent == 0.0 ? "0" : "%.1f", percent);
                expected.emplace_back(text);
            }
        }
        EXPECT_EQ(textsOf(confusionSvg(matrixOf(table.counts), letters(k), table.name)), expected);
    }
}

TEST(ConfusionFigure, hasAColumnForSilenceOnlyWhenThereWasSome) {
    ConfusionMatrix matrix(2);
    matrix.add(0, 0);
    const auto without = textsOf(confusionSvg(matrix, {"A", "B"}, "t"));
    EXPECT_EQ(std::count(without.begin(), without.end(), "NONE"), 0);
    EXPECT_EQ(std::count(without.begin(), without.end(), "NA"), 2) << "B was never presented";
    matrix.add(1, std::nullopt);
    const auto with = textsOf(confusionSvg(matrix, {"A", "B"}, "t"));
    EXPECT_EQ(std::count(with.begin(), with.end(), "NONE"), 1);
}

TEST(ConfusionFigure, namesMayHaveAnyCharacters) {
    ConfusionMatrix matrix(1);
    matrix.add(0, 0);
    EXPECT_EQ(textsOf(confusionSvg(matrix, {"<&>"}, "\"a\" & b")).front(), "\"a\" & b");
}

TEST(WriteFigures, makesAFileForEachTaskAndCondition) {
    TrialTally tally;
    for (const char* condition : {"static", "fast/slow"})
        ASSERT_TRUE(tally.add({"P", "shape", condition, Phase::test, "A", "A", 1.0}));
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFigures(studyResults(tally), folder.path("out")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/confusion_shape_static.svg")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/confusion_shape_fast_slow.svg")));
    ASSERT_TRUE(tally.add({"P", "shape", "fast_slow", Phase::test, "A", "A", 1.0}));
    EXPECT_EQ(writeFigures(studyResults(tally), folder.path("out")).error().kind, core::ErrorKind::refused);
}

} // namespace teleta::study
