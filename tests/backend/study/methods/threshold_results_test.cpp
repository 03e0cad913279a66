// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/study/methods/figures/threshold_figures.h"
#include "backend/study/methods/results/bracelet_results.h"
#include "backend/study/methods/results/detection_results.h"
#include "backend/study/methods/results/level_trial_source.h"
#include "backend/study/methods/results/threshold_files.h"
#include "backend/study/methods/results/threshold_results.h"
#include "tests/backend/study/methods/fit_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace teleta::study {
namespace {

class ThresholdResultsTest : public testing::Test {
protected:
    void SetUp() override {
        m_folder =
            std::filesystem::path(testing::TempDir()) / ("teleta-thresholds-" + std::to_string(::getpid()));
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    [[nodiscard]] std::string write(const std::string& text) const {
        const std::string path = (m_folder / "trials.csv").string();
        std::ofstream(path) << text;
        return path;
    }
    [[nodiscard]] core::Expected<LevelTrials> read(const std::string& text) const {
        LevelTrials trials;
        ModeFilter modes;
        TELETA_CHECK(addLevelTrials(write(text), modes, trials, [](std::uint64_t) { return true; }));
        return trials;
    }
    [[nodiscard]] std::string contentOf(const std::string& name) const {
        std::ifstream file(m_folder / name);
        std::ostringstream content;
        content << file.rdbuf();
        return content.str();
    }

    std::filesystem::path m_folder;
};

const std::string kHandMade = "participant_id,task,condition,phase,track,level,correct\n";

/// Rows of one participant: as many right answers at each level.
std::string rowsOf(const std::string& participant, const std::vector<LevelCount>& counts,
                   const std::string& more = "") {
    std::ostringstream rows;
    for (const LevelCount& count : counts) {
        for (std::int64_t i = 0; i < count.trials; ++i)
            rows << participant << ",detect,rest,test,t1," << count.level << ','
                 << (i < count.correct ? 1 : 0) << more << '\n';
    }
    return rows.str();
}

std::string messageOf(const core::Expected<LevelTrials>& trials) {
    return trials ? std::string() : core::describe(trials.error());
}

} // namespace

TEST_F(ThresholdResultsTest, ofAHandMadeTableAreThoseOfItsCounts) {
    const auto trials = read(kHandMade + "P01,detect,rest,practice,t1,0.02,0\n" + rowsOf("P01", dataP1()));
    ASSERT_TRUE(trials) << messageOf(trials);
    FitChoices choices;
    choices.guess = 0.5;
    const ThresholdResults results = thresholdResults(*trials, choices);
    ASSERT_EQ(results.lines.size(), 1U);
    const ThresholdLine& line = results.lines.front();
    EXPECT_EQ(line.model.shape, RiseShape::weibull);
    EXPECT_EQ(line.fit.trials, 240);
    EXPECT_NEAR(*line.fit.threshold, .06182085, 1e-7);
    ASSERT_TRUE(line.fit.goodness) << "equally often shown levels are constant stimuli";
    EXPECT_EQ(line.note(), "");
}

TEST_F(ThresholdResultsTest, needAGuessRateWhereNothingTellsIt) {
    const auto trials = read(kHandMade + rowsOf("P01", dataP1()));
    const ThresholdResults results = thresholdResults(*trials);
    EXPECT_FALSE(results.lines.front().fit.threshold);
    EXPECT_EQ(results.lines.front().note(), "guessUnknown");
    EXPECT_TRUE(detectionResults(*trials).empty());
}

TEST_F(ThresholdResultsTest, takeTheGuessRateFromTheDesign) {
    const std::string header =
        "participant_id,task,condition,phase,track,level,correct,design,n_alternatives\n";
    const auto three = read(header + rowsOf("P01", dataP3(), ",interval,3"));
    ASSERT_TRUE(three) << messageOf(three);
    EXPECT_NEAR(*thresholdResults(*three).lines.front().fit.threshold, .1992582, 1e-6);
    // 30 trials without anything, all answered rightly with no: 0.5 / 31.
    const auto yesNo = read(header + rowsOf("P01", countsOf({0}, {30}, 30), ",yes_no,2") +
                            rowsOf("P01", dataP1(), ",yes_no,2"));
    const ThresholdResults results = thresholdResults(*yesNo);
    EXPECT_NEAR(*results.lines.front().model.guess, 0.5 / 31.0, 1e-12);
    EXPECT_EQ(results.lines.front().fit.trials, 240) << "catch trials are not fitted";
    const auto noCatch = read(header + rowsOf("P01", dataP1(), ",yes_no,2"));
    EXPECT_EQ(thresholdResults(*noCatch).lines.front().model.guess, 0.02);
}

// A comparison's right answer is the one that has more; of an equal pair the answer says which was taken.
TEST_F(ThresholdResultsTest, ofAComparisonCountWhatWasTakenAsMore) {
    const std::string header =
        "participant_id,task,condition,phase,track,level,stimulus,response,design,reference,level_unit\n";
    std::string rows;
    const auto add = [&](double level, const char* right, const char* answer, int times) {
        for (int i = 0; i < times; ++i)
            rows += "P01,steps,ref5,test,all," + std::to_string(level) + ',' + right + ',' + answer +
                    ",compare,0.5,drive\n";
    };
    // The counts of P2: "more" 0 2 5 9 15 19 20 of 20. Below the reference, "more" is the wrong answer.
    const int more[] = {0, 2, 5, 9, 15, 19, 20};
    for (int i = 0; i < 7; ++i) {
        const double level = 0.2 + 0.1 * i;
        const bool isBelow = i < 3;
        add(level, "1", isBelow ? "2" : "1", more[i]);
        add(level, "1", isBelow ? "1" : "2", 20 - more[i]);
    }
    add(0.3, "1", "NA", 5); // no answer says nothing
    const auto trials = read(header + rows);
    ASSERT_TRUE(trials) << messageOf(trials);
    FitChoices choices;
    choices.lapse = {0.0, 0.0};
    const ThresholdResults results = thresholdResults(*trials, choices);
    const ThresholdLine& line = results.lines.front();
    EXPECT_EQ(line.fit.trials, 140);
    EXPECT_EQ(line.model.shape, RiseShape::gauss);
    EXPECT_EQ(line.model.scale, LevelScale::linear);
    EXPECT_NEAR(*line.equality(), .4986224, 1e-6);
    EXPECT_NEAR(*line.justNoticeable(), .0887456, 1e-6);
    EXPECT_NEAR(*line.weber(), .1774913, 1e-6);
}

TEST_F(ThresholdResultsTest, groupsAverageOnTheScaleAndTellWhoIsMissing) {
    std::vector<LevelCount> doubled = dataP1();
    for (LevelCount& count : doubled)
        count.level *= 2.0;
    const auto trials = read(kHandMade + rowsOf("P01", dataP1()) + rowsOf("P02", doubled) +
                             rowsOf("P03", countsOf(kSixLevels, {40, 40, 40, 40, 40, 40}, 40)));
    FitChoices choices;
    choices.guess = 0.5;
    const ThresholdResults results = thresholdResults(*trials, choices);
    ASSERT_EQ(results.groups.size(), 1U);
    const ThresholdGroup& group = results.groups.front();
    EXPECT_EQ(group.participants, 2U);
    EXPECT_NEAR(*group.threshold, .06182085 * std::sqrt(2.0), 1e-6);
    // Student's t of two values: mean +- 12.7062047 * sd / sqrt 2 = mean +- 12.7062047 * half their distance.
    EXPECT_NEAR(group.interval->high, .06182085 * std::sqrt(2.0) * std::pow(2.0, 0.5 * 12.7062047), 1e-4);
    EXPECT_EQ(group.note(), "1 of 3 without threshold");
    EXPECT_EQ(results.lines.back().note(), "belowRange (below 0.02)");
}

// The staircase of the protocol, shown and answered; its estimate is that of the rules.
TEST_F(ThresholdResultsTest, haveTheEstimatesOfTheProcedure) {
    LevelTrials trials;
    LevelTaskFacts& facts = trials.factsOf(std::string_view("detect"));
    facts.design = Design::interval;
    facts.intervals = 2;
    facts.range = LevelRange{LevelScale::linear, 0.0, 1.0};
    facts.scale = LevelScale::linear;
    facts.procedure = "staircase";
    StaircaseSettings settings;
    settings.first = 0.6;
    settings.stepUp = 0.05;
    settings.fastFactor = 2.0;
    settings.reversals = 8;
    facts.settings = settings;
    const double levels[] = {.6, .6,  .5,  .5, .4, .4,  .3,  .4, .4,  .35, .4,
                             .4, .35, .35, .4, .4, .45, .45, .4, .45, .45};
    const std::string answers = "111111011011101011011";
    auto& track = trials.trackOf({"detect", "rest", "t1", "P01"});
    for (std::size_t i = 0; i < answers.size(); ++i)
        track.trials.push_back(
            *levelTrialOf(Design::interval, levels[i], 0.0, 0, answers[i] == '1' ? 0U : 1U));
    const ThresholdLine line = thresholdResults(trials).lines.front();
    EXPECT_NEAR(*line.procedure.staircase, .4125, 1e-12);
    EXPECT_EQ(line.procedure.reversals, 8U);
    EXPECT_EQ(line.procedure.reversalTrials.front(), 6U);
    EXPECT_FALSE(line.fit.goodness) << "never of adaptive tracks";
    EXPECT_GT(trackFigure(line).standalone().size(), 1000U);
}

TEST_F(ThresholdResultsTest, haveThePosteriorOfABayesianProcedure) {
    LevelTrials trials;
    LevelTaskFacts& facts = trials.factsOf(std::string_view("detect"));
    facts.design = Design::interval;
    facts.intervals = 2;
    facts.range = LevelRange{};
    facts.scale = LevelScale::log10;
    facts.procedure = "bayes";
    facts.settings = BayesSettings{};
    const double places[] = {-.9,  -1.05, -1.2, -.75, -.8,  -.9,  -1., -.7, -.8, -.85, -.85, -.65, -.7,
                             -.75, -.8,   -.9,  -.9,  -.75, -.75, -.8, -.8, -.7, -.7,  -.75, -.75};
    const std::string answers = "1101110111011111011101111";
    auto& track = trials.trackOf({"detect", "rest", "t1", "P01"});
    for (std::size_t i = 0; i < answers.size(); ++i)
        track.trials.push_back(
            *levelTrialOf(Design::interval, std::pow(10.0, places[i]), 0.0, 0, answers[i] == '1' ? 0U : 1U));
    const ThresholdLine line = thresholdResults(trials).lines.front();
    EXPECT_NEAR(std::log10(*line.procedure.bayesMean), -.8908002, 1e-6);
    EXPECT_GT(*line.procedure.bayesSd, 0.0);
    EXPECT_EQ(line.procedure.beliefs.size(), answers.size());
    EXPECT_EQ(line.procedure.note, TrackNote::none);
}

TEST_F(ThresholdResultsTest, haveSignalDetection) {
    const std::string header = "participant_id,task,condition,phase,track,level,stimulus,response,design\n";
    std::string rows;
    const auto add = [&](const char* person, double level, const char* right, const char* answer, int times) {
        for (int i = 0; i < times; ++i)
            rows += std::string(person) + ",detect,rest,test,t1," + std::to_string(level) + ',' + right +
                    ',' + answer + ",yes_no\n";
    };
    add("P01", 0.1, "yes", "yes", 18);
    add("P01", 0.1, "yes", "no", 7);
    add("P01", 0.0, "no", "yes", 10);
    add("P01", 0.0, "no", "NA", 15); // no answer is not yes
    add("P02", 0.1, "yes", "yes", 10);
    const auto trials = read(header + rows);
    ASSERT_TRUE(trials) << messageOf(trials);
    const DetectionResults results = detectionResults(*trials);
    ASSERT_EQ(results.lines.size(), 2U);
    EXPECT_EQ(results.lines[0].hits, 18);
    EXPECT_EQ(results.lines[0].falseAlarms, 10);
    EXPECT_NEAR(results.lines[0].detection->sensitivity, .8012889, 1e-6);
    EXPECT_FALSE(results.lines[1].detection) << "no catch trials";
    EXPECT_EQ(results.groups.front().participants, 1U);
    ASSERT_TRUE(writeThresholds(thresholdResults(*trials), results, m_folder.string()));
    EXPECT_TRUE(contentOf("sdt.csv").starts_with(
        "participant_id,task,condition,track,hits,n_signal,false_alarms,n_noise,dprime,lo,hi,c,method\n"
        "P01,detect,rest,t1,18,25,10,25,0.80"));
    EXPECT_NE(contentOf("sdt.csv").find("\nGROUP,detect,rest,t1,NA,NA,NA,NA,0.80"), std::string::npos);
}

TEST_F(ThresholdResultsTest, twoIntervalsHaveABiasWhereTheAnswersAreKnown) {
    const std::string header = "participant_id,task,condition,phase,track,level,stimulus,response,design\n";
    std::string rows;
    const auto add = [&](const char* right, const char* answer, int times) {
        for (int i = 0; i < times; ++i)
            rows += std::string("P01,detect,rest,test,t1,0.1,") + right + ',' + answer + ",interval\n";
    };
    add("1", "1", 26);
    add("1", "2", 4);
    add("2", "1", 9);
    add("2", "2", 21);
    const auto known = read(header + rows);
    EXPECT_NEAR(detectionResults(*known).lines.front().detection->sensitivity, 1.105454, 1e-6);
    const std::string withDesign = "participant_id,task,condition,phase,track,level,correct,design\n";
    const auto unknown = read(withDesign + rowsOf("P01", countsOf({.1}, {30}, 40), ",interval"));
    const DetectionLine line = detectionResults(*unknown).lines.front();
    EXPECT_NEAR(line.detection->sensitivity, .9269088, 1e-6);
    EXPECT_FALSE(line.detection->criterion);
}

TEST_F(ThresholdResultsTest, areWrittenWithTheirColumns) {
    const auto trials = read(kHandMade + rowsOf("P01", dataP1()));
    FitChoices choices;
    choices.guess = 0.5;
    ASSERT_TRUE(
        writeThresholds(thresholdResults(*trials, choices), detectionResults(*trials), m_folder.string()));
    const std::string table = contentOf("thresholds.csv");
    EXPECT_TRUE(table.starts_with(
        "participant_id,task,condition,track,design,function,n,threshold,lo,hi,interval,unit,spread,guess,"
        "lapse,"
        "deviance,p_deviance,jnd,weber,pse,stair_estimate,stair_reversals,bayes_mean,bayes_sd,note\n"
        "P01,detect,rest,t1,NA,weibull,240,0.0618208"))
        << table;
    EXPECT_NE(table.find("\nGROUP,detect,rest,t1,NA,weibull,1,0.0618208"), std::string::npos) << table;
    EXPECT_FALSE(std::filesystem::exists(m_folder / "sdt.csv")) << "nothing to detect";
    EXPECT_NE(
        contentOf("levels.csv").find("P01,detect,rest,t1,NA,weibull,log10,0.5,0,0.06,0.02,NA,0,40,22\n"),
        std::string::npos);
    const auto figures = thresholdFigures(thresholdResults(*trials, choices), {}, Mode::pilot);
    ASSERT_EQ(figures.size(), 3U);
    EXPECT_EQ(figures[1].name, "curve_detect_rest_t1_P01");
    EXPECT_NE(figures[1].picture.standalone().find("PILOT"), std::string::npos);
}

TEST_F(ThresholdResultsTest, tablesOfOtherTasksHaveNone) {
    const auto none =
        read("participant_id,task,condition,phase,stimulus,response\nP01,shape,static,test,A,B\n");
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->empty());
    const auto missing =
        read("participant_id,task,condition,phase,level,correct\nP01,shape,static,test,NA,1\n");
    EXPECT_TRUE(missing->empty());
    EXPECT_TRUE(thresholdResults(*missing).empty());
    ASSERT_TRUE(writeThresholds({}, {}, m_folder.string()));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "thresholds.csv"));
}

TEST_F(ThresholdResultsTest, leaveOutWhatDoesNotCount) {
    const auto trials = read("participant_id,task,condition,phase,level,correct,outcome,excluded\n"
                             "P01,detect,rest,test,0.1,1,correct,NA\n"
                             "P01,detect,rest,test,0.1,0,aborted,NA\n"
                             "P01,detect,rest,test,0.1,0,device_error,NA\n"
                             "P01,detect,rest,test,0.1,1,correct,slow\n");
    ASSERT_TRUE(trials) << messageOf(trials);
    EXPECT_EQ(trials->tracks().begin()->second.trials.size(), 1U);
    EXPECT_EQ(trials->tracks().begin()->first.track, "all");
}

// Answers that a rule leaves out would move threshold, guess rate and d' if they counted.
TEST_F(ThresholdResultsTest, areThoseWithoutTheExcludedTrials) {
    const std::string header =
        "participant_id,task,condition,phase,track,level,stimulus,response,design,n_alternatives\n";
    std::string rows;
    const auto add = [&](const std::string& who, const std::string& level, const char* right,
                         const char* answer, int times) {
        for (int i = 0; i < times; ++i)
            rows += who + ",detect,rest,test,t1," + level + ',' + right + ',' + answer + ",yes_no,2\n";
    };
    for (const LevelCount& count : dataP1()) {
        add("P01", std::to_string(count.level), "yes", "yes", static_cast<int>(count.correct));
        add("P01", std::to_string(count.level), "yes", "no", static_cast<int>(count.trials - count.correct));
    }
    add("P01", "0", "no", "yes", 3);
    add("P01", "0", "no", "no", 17);
    const auto clean = read(header + rows);
    ASSERT_TRUE(clean) << messageOf(clean);
    add("P01", "0.16", "yes", "no", 30);
    add("P01", "0", "no", "yes", 30);
    add("P02", "0.16", "yes", "no", 5);
    auto marked = read(header + rows);
    ASSERT_TRUE(marked) << messageOf(marked);
    LevelTrials::Track& track = marked->trackOf({"detect", "rest", "t1", "P01"});
    for (std::size_t i = 260; i < track.trials.size(); ++i)
        track.trials[i].isExcluded = true;
    for (LevelTrial& trial : marked->trackOf({"detect", "rest", "t1", "P02"}).trials)
        trial.isExcluded = true;
    const ThresholdResults expected = thresholdResults(*clean);
    const ThresholdResults results = thresholdResults(*marked);
    ASSERT_EQ(results.lines.size(), 1U) << "nothing is left of P02";
    EXPECT_EQ(results.lines[0].fit.trials, 240);
    EXPECT_EQ(results.lines[0].model.guess, 3.5 / 21.0);
    EXPECT_EQ(results.lines[0].fit.threshold, expected.lines[0].fit.threshold);
    EXPECT_EQ(results.lines[0].trials.size(), 320U) << "a picture of the track has all";
    const DetectionResults detection = detectionResults(*marked);
    ASSERT_EQ(detection.lines.size(), 1U);
    EXPECT_EQ(detection.lines[0].falseAlarms, 3);
    EXPECT_EQ(detection.lines[0].noiseTrials, 20);
    EXPECT_FALSE(clean->withoutRules());
    const auto all = marked->withoutRules();
    ASSERT_TRUE(all);
    EXPECT_EQ(thresholdResults(*all).lines.size(), 2U);
    EXPECT_EQ(thresholdResults(*all).lines[0].fit.trials, 270);
}

TEST_F(ThresholdResultsTest, leaveOutTheRowsThatRulesName) {
    const std::string path =
        write(kHandMade + "P01,detect,rest,test,t1,0.1,1\nP01,detect,rest,test,t1,0.2,0\n");
    LevelTrials trials;
    ModeFilter modes;
    ASSERT_TRUE(addLevelTrials(
        path, modes, trials, [](std::uint64_t) { return true; }, [](long long row) { return row == 0; }));
    const auto& left = trials.tracks().begin()->second.trials;
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].kept.level, 0.2);
}

// Six people of 2AFC, levels in s: lme4 (glmer, nAGQ 25) with the link of psyphy.
TEST_F(ThresholdResultsTest, haveAFitOfAllBesideTheMean) {
    const std::string header =
        "participant_id,task,condition,phase,track,level,correct,design,n_alternatives,level_unit\n";
    const int right[6][5] = {{11, 13, 16, 19, 20}, {10, 11, 13, 16, 19}, {12, 16, 18, 20, 20},
                             {9, 12, 14, 18, 19},  {11, 12, 17, 19, 20}, {10, 14, 15, 17, 20}};
    std::string rows;
    const auto add = [&](int person) {
        std::vector<LevelCount> counts = countsOf({.2, .5, .8, 1.2, 1.6}, {0, 0, 0, 0, 0}, 20);
        for (std::size_t i = 0; i < 5; ++i)
            counts[i].correct = right[person][i];
        rows += rowsOf("P" + std::to_string(person), counts, ",interval,2,s");
    };
    for (int person = 0; person < 4; ++person)
        add(person);
    FitChoices choices;
    choices.lapse = {0.0, 0.0};
    const auto few = read(header + rows);
    ASSERT_TRUE(few) << messageOf(few);
    const ThresholdGroup four = thresholdResults(*few, choices).groups.at(0);
    EXPECT_FALSE(four.hierarchical);
    EXPECT_EQ(four.withoutHierarchical, "fewer than 5 participants");
    add(4);
    add(5);
    const auto trials = read(header + rows);
    const ThresholdResults results = thresholdResults(*trials, choices);
    const ThresholdGroup& group = results.groups.at(0);
    ASSERT_TRUE(group.hierarchical);
    EXPECT_EQ(group.hierarchical->participants, 6U);
    EXPECT_NEAR(group.hierarchical->threshold, .7702117, 1e-4 * .7702117);
    EXPECT_NEAR(group.hierarchical->participantSd, .1694535, 1e-4 * .1694535);
    EXPECT_LT(*group.hierarchical->interval.low, group.hierarchical->threshold);
    EXPECT_DOUBLE_EQ(group.hierarchical->guess, 0.5);
    ASSERT_TRUE(writeThresholds(results, {}, m_folder.string()));
    EXPECT_NE(contentOf("thresholds.csv").find("\nGROUP,detect,rest,t1,interval,gauss,6,0.7702"),
              std::string::npos)
        << contentOf("thresholds.csv");
    EXPECT_NE(contentOf("thresholds.csv").find(",hierarchical; sd of participants 0.1694"),
              std::string::npos);
}

// The counts of R's glm in the test of bestOnset, and steps of 0.1 from 0 to 1.
TEST_F(ThresholdResultsTest, haveStepsAndBestTimesWhereTheyAreAsked) {
    std::string rows = "participant_id,task,condition,phase,track,level,stimulus,response,design,reference,"
                       "level_unit,procedure\n";
    const int yes[] = {3, 9, 17, 20, 15, 6};
    const char* onsets[] = {"0.02", "0.05", "0.08", "0.11", "0.14", "0.2"};
    for (int i = 0; i < 6; ++i) {
        for (int trial = 0; trial < 24; ++trial)
            rows += std::string("P01,motion,rest,test,all,") + onsets[i] + ",yes," +
                    (trial < yes[i] ? "yes" : "no") + ",yes_no,0,s,constant\n";
    }
    const auto trials = read(rows);
    ASSERT_TRUE(trials) << messageOf(trials);
    const std::vector<OnsetLine> best = bestOnsetsOf(thresholdResults(*trials));
    ASSERT_EQ(best.size(), 1U);
    EXPECT_NEAR(best[0].best.onset_s, .1160469, 1e-6);

    ThresholdResults compared;
    for (const double reference : {0.3, 0.5, 0.7}) {
        ThresholdLine& line = compared.lines.emplace_back();
        line.participant = "P01";
        line.task = "steps";
        line.track = "all";
        line.facts.design = Design::compare;
        line.facts.unit = "drive";
        line.reference = reference;
        line.model.shape = RiseShape::gauss;
        line.fit.threshold = reference;
        line.fit.spread = 0.1 / 0.6744897501960817; // of which the JND is 0.1
        line.fit.guess = 0.0;
        line.fit.lapse = 0.0;
    }
    const std::vector<StepsLine> steps = intensityStepsOf(compared);
    ASSERT_EQ(steps.size(), 1U);
    EXPECT_EQ(steps[0].references, 3U);
    EXPECT_EQ(steps[0].wanted, 3U);
    EXPECT_EQ(steps[0].steps, 10U);
    ThresholdResults incomplete = compared;
    incomplete.lines[1].fit.spread.reset();
    ASSERT_EQ(intensityStepsOf(incomplete).size(), 1U);
    EXPECT_EQ(intensityStepsOf(incomplete)[0].references, 2U);
    EXPECT_FALSE(intensityStepsOf(incomplete)[0].steps) << "a reference without a difference";
    compared.lines.resize(1);
    EXPECT_TRUE(intensityStepsOf(compared).empty()) << "one reference says nothing of the others";
}

TEST_F(ThresholdResultsTest, refuseRowsThatCannotBe) {
    const auto fails = [&](const std::string& header, const std::string& row, const char* what) {
        const auto trials = read(header + "\n" + row + "\n");
        ASSERT_FALSE(trials) << what;
        EXPECT_NE(messageOf(trials).find("trials.csv:2"), std::string::npos) << messageOf(trials);
        EXPECT_NE(messageOf(trials).find(what), std::string::npos) << messageOf(trials);
    };
    const std::string header = "participant_id,task,condition,phase,level,correct,design";
    fails(header, "P01,detect,rest,test,high,1,interval", "high");
    fails(header, "P01,detect,rest,test,0.1,yes,interval", "0 or 1");
    fails(header, "P01,detect,rest,first,0.1,1,interval", "practice or test");
    fails(header, "P01,detect,rest,test,0.1,1,guess", "same_different");
    fails(header, "NA,detect,rest,test,0.1,1,interval", "a value");
    fails("participant_id,task,condition,phase,level,stimulus,response,design",
          "P01,detect,rest,test,0.1,1,3,interval", "1, 2");
    const auto noAnswers = read("participant_id,task,condition,phase,level\nP01,detect,rest,test,0.1\n");
    EXPECT_NE(messageOf(noAnswers).find("a column correct"), std::string::npos) << messageOf(noAnswers);
    const auto modes = read("participant_id,task,condition,phase,level,correct,mode\n"
                            "P01,detect,rest,test,0.1,1,run\nP01,detect,rest,test,0.1,1,pilot\n");
    EXPECT_NE(messageOf(modes).find("different modes"), std::string::npos) << messageOf(modes);
}

} // namespace teleta::study
