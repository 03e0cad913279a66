// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/confusion_figure.h"
#include "backend/study/report/study_figures.h"
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

TEST(ConfusionFigure, showsCountsAndBothInTheSamePlaces) {
    ConfusionMatrix matrix(2);
    matrix.add(0, 0, 3);
    matrix.add(0, 1, 1);
    matrix.add(1, std::nullopt, 2);
    const std::vector<std::string> counts = {"t",
                                             "Subject response, trials",
                                             "Actual pattern",
                                             "A",
                                             "B",
                                             "NONE",
                                             "A",
                                             "3",
                                             "1",
                                             "0",
                                             "B",
                                             "0",
                                             "0",
                                             "2"};
    EXPECT_EQ(textsOf(confusionSvg(matrix, {"A", "B"}, "t", ConfusionValues::counts)), counts);
    const auto both = textsOf(confusionSvg(matrix, {"A", "B"}, "t", ConfusionValues::both));
    EXPECT_EQ(std::count(both.begin(), both.end(), "75.0"), 1);
    EXPECT_EQ(std::count(both.begin(), both.end(), "3/4"), 1);
}

TEST(ConfusionFigure, saysAcrossThatItsDataAreNotThoseOfAStudy) {
    ConfusionMatrix matrix(2);
    matrix.add(0, 0);
    const auto last = [&](std::optional<Mode> mode) {
        return textsOf(confusionSvg(matrix, {"A", "B"}, "t", ConfusionValues::percent, mode)).back();
    };
    EXPECT_EQ(last(Mode::pilot), "PILOT");
    EXPECT_EQ(last(Mode::simulated), "SIMULATED");
    EXPECT_EQ(last(Mode::run), last(std::nullopt));
    EXPECT_NE(last(Mode::run), "PILOT");
}

TEST(StudyFigures, areOneOfEachKindAndWellFormed) {
    TrialTally tally;
    for (const char* person : {"P1", "P2", "P3"})
        for (const char* condition : {"static", "dynamic"})
            for (const char* answer : {"A", "B", ""})
                ASSERT_TRUE(tally.add({person, "shape", condition, Phase::test, "A", answer, 1.5}));
    const auto figures = studyFigures(studyResults(tally), Mode::simulated);
    std::vector<std::string> names;
    for (const StudyFigure& figure : figures) {
        names.push_back(figure.name);
        const auto texts = textsOf(figure.picture.standalone());
        EXPECT_EQ(std::count(texts.begin(), texts.end(), "SIMULATED"), 1) << figure.name;
    }
    const std::vector<std::string> expected = {"confusion_shape_dynamic", "confusion_counts_shape_dynamic",
                                               "confusion_shape_static",  "confusion_counts_shape_static",
                                               "accuracy_shape",          "patterns_shape",
                                               "response_time_shape",     "cumulative_time_shape",
                                               "transfer_shape"};
    EXPECT_EQ(names, expected);
}

// One of three right at each of two participants and two of three at the third: mean 4/9.
TEST(StudyFigures, drawTheMeanWhereItsValueIs) {
    TrialTally tally;
    const char* answers[3][3] = {{"A", "B", "B"}, {"A", "B", "B"}, {"A", "A", "B"}};
    const char* people[3] = {"P1", "P2", "P3"};
    for (int i = 0; i < 3; ++i)
        for (const char* answer : answers[i])
            ASSERT_TRUE(tally.add({people[i], "t", "static", Phase::test, "A", answer, 1.0}));
    const std::string svg = accuracyFigure(studyResults(tally).front(), {}).standalone();
    // The plotting area is 300 px high and begins at 64: 64 + 300 (1 - 4/9) = 230.67.
    EXPECT_NE(svg.find("cy=\"230.67\" r=\"5\" class=\"series0\""), std::string::npos) << svg;
}

TEST(WriteFigures, makesAFileForEachTaskAndCondition) {
    TrialTally tally;
    for (const char* condition : {"static", "fast/slow"})
        ASSERT_TRUE(tally.add({"P", "shape", condition, Phase::test, "A", "A", 1.0}));
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFigures(studyResults(tally), folder.path("out")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/confusion_shape_static.svg")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/confusion_shape_fast_slow.svg")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/figures/accuracy_shape.svg")));
    ASSERT_TRUE(tally.add({"P", "shape", "fast_slow", Phase::test, "A", "A", 1.0}));
    ASSERT_TRUE(writeFigures(studyResults(tally), folder.path("more")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("more/figures/confusion_shape_fast_slow.svg")));
    EXPECT_TRUE(std::filesystem::exists(folder.path("more/figures/confusion_shape_fast_slow-2.svg")));
}

TEST(StudyFigures, haveFilesOfTheirOwnWhateverTheLettersOfTheirTasks) {
    TrialTally tally;
    // "form" and "colour" in Japanese, the same in another case, and what other names look like together.
    for (const char* task : {"\u5f62", "\u8272", "shape", "Shape", "a"})
        for (const char* condition : {"static", "b_c"})
            ASSERT_TRUE(tally.add({"P", task, condition, Phase::test, "A", "A", 1.0}));
    ASSERT_TRUE(tally.add({"P", "a_b", "c", Phase::test, "A", "A", 1.0}));
    std::set<QString> names;
    const auto figures = studyFigures(studyResults(tally), {});
    for (const StudyFigure& figure : figures) {
        EXPECT_TRUE(names.insert(QString::fromStdString(figure.name).toLower()).second) << figure.name;
        EXPECT_EQ(
            figure.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_-0123456789"),
            std::string::npos)
            << figure.name;
    }
    EXPECT_EQ(figures.size(), 5U * 9U + 7U);
}

} // namespace teleta::study
