// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/study_report.h"
#include "tests/backend/core/temporary_folder.h"

#include <QXmlStreamReader>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace teleta::study {

namespace {

/// Three participants, two conditions, two patterns; the third one is only right when it is dynamic.
std::vector<TaskResults> results(const std::string& third = "P3") {
    TrialTally tally;
    const auto add = [&](const std::string& person, const char* condition, const char* stimulus,
                         const char* response) {
        EXPECT_TRUE(tally.add({person, "shape", condition, Phase::test, stimulus, response, 1.25}));
    };
    for (const char* condition : {"static", "dynamic"}) {
        for (const char* stimulus : {"A", "B"}) {
            add("P1", condition, stimulus, stimulus);
            add("P1", condition, stimulus, "");
            add("P2", condition, stimulus, "A");
            add("P2", condition, stimulus, stimulus);
            add(third, condition, stimulus, condition == std::string("dynamic") ? stimulus : "B");
            add(third, condition, stimulus, condition == std::string("dynamic") ? stimulus : "A");
        }
    }
    return studyResults(tally);
}

ReportHeading heading(std::optional<Mode> mode = Mode::run) {
    return {"Results", mode, {"study & more"}, "0.1.0"};
}

/// How often each element occurs; nothing when the page is not well-formed.
std::map<QString, int> elementsOf(const std::string& html) {
    QXmlStreamReader reader(QString::fromStdString(html));
    std::map<QString, int> elements;
    while (!reader.atEnd()) {
        if (reader.readNext() == QXmlStreamReader::StartElement)
            ++elements[reader.name().toString()];
    }
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString() << " in line "
                                    << reader.lineNumber();
    return elements;
}

bool has(const std::string& html, const std::string& text) {
    return html.find(text) != std::string::npos;
}

} // namespace

TEST(StudyReport, hasASectionAboutThresholds) {
    LevelTrials trials;
    LevelTaskFacts& facts = trials.factsOf(std::string_view("detect"));
    facts.design = Design::interval;
    facts.intervals = 2;
    facts.unit = "drive";
    facts.procedure = "constant";
    // The first data set of the fits, 40 trials a level: threshold 0.06182, interval 0.0448 to 0.0799.
    const double levels[] = {.02, .04, .06, .08, .12, .16};
    const int right[] = {22, 25, 29, 33, 38, 39};
    for (int i = 0; i < 6; ++i) {
        for (int trial = 0; trial < 40; ++trial)
            trials.trackOf({"detect", "rest", "t<1>", "P1"})
                .trials.push_back(*levelTrialOf(Design::interval, levels[i], 0.0, trial % 2,
                                                (trial < right[i]) == (trial % 2 == 0) ? 0U : 1U));
    }
    ReportHeading shown = heading();
    const std::string without = reportHtml({}, shown);
    EXPECT_FALSE(has(without, "Thresholds"));
    shown.thresholds = thresholdResults(trials);
    shown.detection = detectionResults(trials);
    const std::string page = reportHtml({}, shown);
    (void)elementsOf(page);
    EXPECT_TRUE(has(page, "Thresholds: detect"));
    EXPECT_TRUE(has(page, "0.06182")) << page;
    EXPECT_TRUE(has(page, "0.04484 to 0.07995"));
    EXPECT_TRUE(has(page, "t&lt;1&gt;"));
    EXPECT_TRUE(has(page, "fewer than 5 participants")) << "why there is no fit of all";
    EXPECT_TRUE(has(page, "2 intervals"));
}

TEST(StudyReport, comparesNoSharesOfATaskWithLevels) {
    ReportHeading page = heading();
    EXPECT_TRUE(has(reportHtml(results(), page), "Analysis of variance within participants"));
    for (const TaskResults& task : results()) {
        page.thresholds.lines.emplace_back();
        page.thresholds.lines.back().task = task.task;
    }
    const std::string levels = reportHtml(results(), page);
    EXPECT_FALSE(has(levels, "Analysis of variance within participants"));
    EXPECT_TRUE(has(levels, "Participants"));
}

TEST(StudyReport, hasEveryFigureWithATableBesideIt) {
    auto elements = elementsOf(reportHtml(results(), heading()));
    // Accuracy, two confusion matrices, patterns, times, cumulative times, transfer. Participants, ANOVA,
    // ratios of times, effect sizes, pairs and ranks are tables only.
    EXPECT_EQ(elements[QStringLiteral("svg")], 7);
    EXPECT_EQ(elements[QStringLiteral("figure")], 7);
    EXPECT_EQ(elements[QStringLiteral("table")], 12);
    EXPECT_EQ(elements[QStringLiteral("caption")], 12);
    EXPECT_EQ(elements[QStringLiteral("h1")], 1);
}

TEST(StudyReport, showsWhatWasExcludedWithAndWithoutTheRules) {
    ReportHeading page = heading();
    EXPECT_FALSE(has(reportHtml(results(), page), "Exclusions"));
    page.exclusions.lines.push_back(
        {"fast", ExclusionKind::responseTimeBelow_s, 0.2, true, {}, 24, 2, 0, 0, 0});
    page.exclusions.withoutRules = results();
    auto elements = elementsOf(reportHtml(results(), page));
    EXPECT_EQ(elements[QStringLiteral("table")], 14);
    const std::string html = reportHtml(results(), page);
    EXPECT_TRUE(has(html, "fast: response_time_below_s 0.2 (made after the data)"));
    EXPECT_TRUE(has(html, "Correct without rules, %"));
}

TEST(StudyReport, saysWhenATaskWasOnlyPractised) {
    TaskResults practised;
    practised.task = "shape";
    practised.patterns = {"A", "B"};
    practised.conditions = {"static"};
    const std::string html = reportHtml({practised}, heading());
    EXPECT_TRUE(has(html, "There are no test trials."));
    EXPECT_EQ(elementsOf(html)[QStringLiteral("svg")], 0);
}

TEST(StudyReport, needsNothingElse) {
    const std::string html = reportHtml(results(), heading());
    EXPECT_FALSE(has(html, "<script"));
    EXPECT_FALSE(has(html, "<link"));
    EXPECT_FALSE(has(html, "<img"));
    EXPECT_FALSE(has(html, "url("));
    EXPECT_FALSE(has(html, " src="));
    EXPECT_FALSE(has(html, " href="));
}

TEST(StudyReport, showsTheNumbersOfTheResults) {
    const std::string html = reportHtml(results(), heading());
    // Static: 1/2 and 3/4 and 1/2 right, so the mean is 58.3 %; P1 leaves two of four unanswered.
    EXPECT_TRUE(has(html, "<td>58.3</td>"));
    EXPECT_TRUE(has(html, "<td>2/4</td><td>2</td>"));
    EXPECT_TRUE(has(html, "condition:pattern"));
    EXPECT_TRUE(has(html, "study &amp; more"));
    EXPECT_TRUE(has(html, "few trials"));
}

TEST(StudyReport, escapesNames) {
    const std::string html = reportHtml(results("<script>\"&'\n参加者"), heading());
    EXPECT_FALSE(has(html, "<script>"));
    EXPECT_TRUE(has(html, "&lt;script&gt;&quot;&amp;'\n参加者"));
    (void)elementsOf(html);
}

TEST(StudyReport, saysLoudlyThatDataAreNotThoseOfAStudy) {
    EXPECT_TRUE(has(reportHtml(results(), heading(Mode::simulated)), "<p class=\"mode\">SIMULATED"));
    EXPECT_TRUE(has(reportHtml(results(), heading(Mode::pilot)), "<p class=\"mode\">PILOT"));
    EXPECT_FALSE(has(reportHtml(results(), heading(Mode::run)), "class=\"mode\""));
    EXPECT_FALSE(has(reportHtml(results(), heading({})), "class=\"mode\""));
}

TEST(StudyReport, saysHowTheStimuliWerePlayedWhereThatIsKnown) {
    EXPECT_FALSE(has(reportHtml(results(), heading()), "were played on a bracelet"));
    ReportHeading played = heading();
    played.frames = {.trials = 110, .longestWrite_ms = 0.754, .missed = 7, .trialsWithMisses = 3};
    EXPECT_TRUE(
        has(reportHtml(results(), played),
            "110 trial(s) were played on a bracelet; the longest write of a frame took 0.75 ms. Frames "
            "were missed in 3 of them, 7 in all."));
    // Without timed writes nothing was written to a bracelet.
    played.frames.longestWrite_ms.reset();
    const std::string html = reportHtml(results(), played);
    EXPECT_TRUE(
        has(html, "the frames of 110 trial(s) were counted. Frames were missed in 3 of them, 7 in all."));
    EXPECT_FALSE(has(html, "bracelet;"));
    EXPECT_FALSE(has(html, "longest write"));
}

TEST(StudyReport, isWrittenIntoTheFolder) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeReport(results(), heading(), folder.path("out")));
    EXPECT_EQ(test::readAll(folder.path("out/report.html")), reportHtml(results(), heading()));
    EXPECT_FALSE(writeReport(results(), heading(), folder.write("file", "in the way")));
}

// html5lib follows the standard's parser and in its strict mode fails at the first error.
TEST(StudyReport, isHtml5) {
    if (std::system("/usr/bin/python3 -c 'import html5lib' > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "python3-html5lib is not installed";
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeReport(results("<&>"), heading(Mode::pilot), folder.path("out")));
    const std::string command = "/usr/bin/python3 -c 'import html5lib, sys; "
                                "html5lib.HTMLParser(strict=True).parse(open(sys.argv[1], \"rb\"))' '" +
                                folder.path("out/report.html") + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::string damaged = folder.write("damaged.html", "<!DOCTYPE html><html><p></b></html>");
    EXPECT_NE(std::system(("/usr/bin/python3 -c 'import html5lib, sys; "
                           "html5lib.HTMLParser(strict=True).parse(open(sys.argv[1], \"rb\"))' '" +
                           damaged + "' 2> /dev/null")
                              .c_str()),
              0);
}

} // namespace teleta::study
