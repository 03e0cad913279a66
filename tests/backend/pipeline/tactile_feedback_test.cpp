// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pipeline/touch/tactile_feedback.h"
#include "backend/playback/pattern_program.h"

#include <gtest/gtest.h>

#include <vector>

namespace teleta::pipeline {
namespace {

playback::Program builtInProgram(const std::string& id) {
    const pattern::Pattern* pattern = pattern::findBuiltIn(id);
    return pattern == nullptr ? playback::Program{} : playback::programOf(*pattern);
}

using contour::Shape;
using stiffness::Material;

TouchRecord touchOf(std::uint64_t number, std::optional<Material> material) {
    TouchRecord record;
    record.number = number;
    record.ready_ns = 1000 * static_cast<std::int64_t>(number);
    record.arrived_ns = record.ready_ns + 20;
    if (material) {
        record.stiffness.emplace();
        record.stiffness->material = *material;
    }
    return record;
}

ExploredContour contourOf(std::size_t points, Shape shape, double confidence) {
    ExploredContour contour;
    contour.points_m.resize(points, contour::Point::Zero());
    if (points < ExploredContour::kLeastPoints)
        return contour;
    contour.recognition.emplace();
    contour.recognition->shape = shape;
    contour.recognition->confidence = confidence;
    return contour;
}

class TactileFeedbackTest : public testing::Test {
protected:
    TactileFeedbackTest() { m_feedback.setMap(pattern::PatternMap::defaults(), builtInProgram); }

    void felt(const TouchRecord& record, const ExploredContour& contour) {
        m_feedback.onTouch(record);
        m_feedback.onContour(record, contour);
    }

    std::vector<FeedbackSent> sent() {
        std::vector<FeedbackSent> all;
        for (FeedbackSent one; m_feedback.popSent(one);)
            all.push_back(one);
        return all;
    }

    std::vector<playback::Program> m_played;
    bool m_takes = true;
    TactileFeedback m_feedback{[this](playback::Program program) {
        m_played.push_back(std::move(program));
        return m_takes;
    }};
};

} // namespace

TEST_F(TactileFeedbackTest, aTouchPlaysThePatternOfItsLevel) {
    m_feedback.onTouch(touchOf(1, Material::rubber));
    const pattern::Pattern& expected = *pattern::findBuiltIn("stiffness.C.dynamic");
    ASSERT_EQ(m_played.size(), 1U);
    EXPECT_EQ(m_played[0].duration_s, expected.duration_s);
    for (const double t_s : {0.0, 0.1, 0.3, 0.7, 1.9})
        EXPECT_EQ(m_played[0].evaluate(t_s), pattern::evaluate(expected, t_s)) << t_s;
    const auto messages = sent();
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages[0].patternId, "stiffness.C.dynamic");
    EXPECT_EQ(messages[0].material, Material::rubber);
    EXPECT_EQ(messages[0].touch, 1U);
    EXPECT_EQ(messages[0].felt_ns, 1000);
    EXPECT_EQ(messages[0].arrived_ns, 1020);
}

TEST_F(TactileFeedbackTest, aTouchWithoutStiffnessPlaysNothing) {
    m_feedback.onTouch(touchOf(1, std::nullopt));
    EXPECT_TRUE(m_played.empty());
    EXPECT_TRUE(sent().empty());
}

TEST_F(TactileFeedbackTest, aNewShapeFollowsTheStiffnessAfterAPause) {
    felt(touchOf(9, Material::metal), contourOf(9, Shape::circle, 0.95));
    const pattern::Pattern& level = *pattern::findBuiltIn("stiffness.E.dynamic");
    const pattern::Pattern& shape = *pattern::findBuiltIn("shape.A.dynamic");
    ASSERT_EQ(m_played.size(), 2U) << "the stiffness at once, then both";
    EXPECT_DOUBLE_EQ(m_played[0].duration_s, level.duration_s);
    const double begin_s = level.duration_s + TactileFeedback::kPause_s;
    EXPECT_DOUBLE_EQ(m_played[1].duration_s, begin_s + shape.duration_s);
    EXPECT_EQ(m_played[1].evaluate(0.1), pattern::evaluate(level, 0.1));
    EXPECT_EQ(m_played[1].evaluate(begin_s - 0.1), core::Intensities{});
    EXPECT_EQ(m_played[1].evaluate(begin_s + 0.25), pattern::evaluate(shape, begin_s + 0.25 - begin_s));
    EXPECT_EQ(sent().size(), 2U);
}

TEST_F(TactileFeedbackTest, theSameShapeIsToldOnce) {
    m_feedback.setMode(FeedbackMode::shape);
    for (std::uint64_t touch = 8; touch < 12; ++touch)
        felt(touchOf(touch, Material::wood), contourOf(touch, Shape::rectangle, 0.97));
    EXPECT_EQ(m_played.size(), 1U);
    felt(touchOf(12, Material::wood), contourOf(12, Shape::triangle, 0.97));
    EXPECT_EQ(m_played.size(), 2U);
}

TEST_F(TactileFeedbackTest, aNewObjectIsToldAgainAfterTheContourBeganAnew) {
    m_feedback.setMode(FeedbackMode::shape);
    felt(touchOf(8, Material::wood), contourOf(8, Shape::circle, 0.97));
    felt(touchOf(9, Material::wood), contourOf(1, Shape::point, 1.0));
    felt(touchOf(17, Material::wood), contourOf(8, Shape::circle, 0.97));
    EXPECT_EQ(m_played.size(), 2U);
}

TEST_F(TactileFeedbackTest, aShapeThatIsNotSureIsNotTold) {
    m_feedback.setMode(FeedbackMode::shape);
    felt(touchOf(2, Material::wood), contourOf(2, Shape::line, 1.0));
    felt(touchOf(9, Material::wood), contourOf(9, Shape::circle, 0.6));
    EXPECT_TRUE(m_played.empty());
    EXPECT_TRUE(sent().empty());
}

TEST_F(TactileFeedbackTest, whatTheMapHasNothingForIsReportedButNotPlayed) {
    m_feedback.setMode(FeedbackMode::shape);
    felt(touchOf(9, Material::wood), contourOf(9, Shape::unknown, 0.95));
    EXPECT_TRUE(m_played.empty());
    const auto messages = sent();
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages[0].shape, Shape::unknown);
    EXPECT_EQ(messages[0].patternId, "");
}

TEST_F(TactileFeedbackTest, anIdThatTheLibraryDoesNotKnowPlaysNothing) {
    pattern::PatternMap map = pattern::PatternMap::defaults();
    map.stiffness[0] = "no.such.pattern";
    m_feedback.setMap(map, builtInProgram);
    m_feedback.onTouch(touchOf(1, Material::sponge));
    EXPECT_TRUE(m_played.empty());
    const auto messages = sent();
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_TRUE(messages[0].missing);
    EXPECT_EQ(messages[0].patternId, "no.such.pattern");
}

TEST_F(TactileFeedbackTest, playsPatternsOfTheUsersOwn) {
    pattern::PatternMap map = pattern::PatternMap::defaults();
    map.stiffness[0] = "mine.wave";
    m_feedback.setMap(map, [](const std::string& id) {
        return id == "mine.wave" ? playback::Program{[](double) { return core::Intensities{0.25}; }, 1.5}
                                 : builtInProgram(id);
    });
    m_feedback.onTouch(touchOf(1, Material::sponge));
    ASSERT_EQ(m_played.size(), 1U);
    EXPECT_EQ(m_played[0].duration_s, 1.5);
    EXPECT_EQ(m_played[0].evaluate(0.0)[0], 0.25);
    EXPECT_FALSE(sent().front().missing);
}

TEST_F(TactileFeedbackTest, saysWhenNobodyTakesThePattern) {
    m_feedback.onTouch(touchOf(1, Material::sponge));
    m_takes = false;
    felt(touchOf(2, Material::sponge), contourOf(9, Shape::circle, 0.95));
    const auto messages = sent();
    ASSERT_EQ(messages.size(), 3U);
    EXPECT_FALSE(messages[0].refused);
    EXPECT_TRUE(messages[1].refused);
    EXPECT_TRUE(messages[2].refused);
    EXPECT_FALSE(messages[2].missing);
}

TEST_F(TactileFeedbackTest, offPlaysNothing) {
    m_feedback.setMode(FeedbackMode::off);
    felt(touchOf(9, Material::metal), contourOf(9, Shape::circle, 0.95));
    EXPECT_TRUE(m_played.empty());
    EXPECT_TRUE(sent().empty());
}

} // namespace teleta::pipeline
