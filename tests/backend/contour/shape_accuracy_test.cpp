// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/shape_recogniser.h"
#include "tests/backend/contour/random_shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <iostream>

namespace teleta::contour {
namespace {

constexpr int kPoses = 1000;

using Maker = std::function<Points(RandomShapes&, double size_m, const Exploration&)>;

struct Kind {
    const char* name;
    Shape shape;
    Maker make;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all = {
        {"circle", Shape::circle,
         [](RandomShapes& r, double s, const Exploration& e) { return r.circle(s, e); }},
        {"rectangle", Shape::rectangle,
         [](RandomShapes& r, double s, const Exploration& e) { return r.rectangle(s, e); }},
        {"square", Shape::rectangle,
         [](RandomShapes& r, double s, const Exploration& e) { return r.rectangle(s, e, 1.0); }},
        {"triangle", Shape::triangle,
         [](RandomShapes& r, double s, const Exploration& e) { return r.triangle(s, e); }},
        {"arc", Shape::arc, [](RandomShapes& r, double s, const Exploration& e) { return r.arc(s, e); }},
        {"line", Shape::line, [](RandomShapes& r, double s, const Exploration& e) { return r.line(s, e); }},
        {"point", Shape::point,
         [](RandomShapes& r, double, const Exploration& e) { return r.point(r.uniform(0.0, 0.0034), e); }},
        {"ellipse", Shape::unknown,
         [](RandomShapes& r, double s, const Exploration& e) { return r.ellipse(s, e); }},
        {"pentagon", Shape::unknown,
         [](RandomShapes& r, double s, const Exploration& e) { return r.pentagon(s, e); }},
        {"random walk", Shape::unknown,
         [](RandomShapes& r, double s, const Exploration& e) { return r.randomWalk(s, e); }}};
    return all;
}

double shareRight_percent(const Kind& kind, int poses, double smallestNoise, double largestNoise) {
    RandomShapes random(1000);
    int right = 0;
    for (int i = 0; i < poses; ++i) {
        const Exploration e = random.exploration(largestNoise, smallestNoise);
        const double size_m = random.uniform(0.02, 0.15);
        right += recogniseShape(kind.make(random, size_m, e))->shape == kind.shape ? 1 : 0;
    }
    const double percent = 100.0 * right / poses;
    std::cout << kind.name << ": " << percent << " % of " << poses << " right, noise "
              << 100.0 * smallestNoise << ".." << 100.0 * largestNoise << " % of the size\n";
    ::testing::Test::RecordProperty(std::string("right_percent_") + kind.name, std::to_string(percent));
    return percent;
}

} // namespace

TEST(ShapeAccuracy, shapesAreRightInNineteenOfTwentyRandomPosesWithNoiseUpToTwoPercent) {
    for (const Kind& kind : kinds())
        if (kind.shape != Shape::unknown) {
            EXPECT_GE(shareRight_percent(kind, kPoses, 0.0, 0.02), 95.0) << kind.name;
        }
}

TEST(ShapeAccuracy, whatIsNoneOfThemIsUnknown) {
    // A random walk of eight steps may look like an arc or a line by chance.
    for (const Kind& kind : kinds())
        if (kind.shape == Shape::unknown) {
            EXPECT_GE(shareRight_percent(kind, 300, 0.0, 0.02),
                      kind.name == std::string("random walk") ? 90.0 : 95.0)
                << kind.name;
        }
}

TEST(ShapeAccuracy, mostShapesAreStillRightWithNoiseOfFivePercent) {
    // Eight points with this much noise do not distinguish a square from a circle; the right answer is the
    // one that more points give.
    for (const Kind& kind : kinds())
        if (kind.shape != Shape::unknown) {
            EXPECT_GE(shareRight_percent(kind, 300, 0.05, 0.05),
                      kind.name == std::string("square") ? 60.0 : 80.0)
                << kind.name;
        }
}

TEST(ShapeAccuracy, theConfidenceIsTheShareOfAnswersThatAreRight) {
    // All shapes, noise from none to 5 %, in bins of confidence: of the answers given with a confidence about
    // c, a share of c is right, up to the error of the share (three standard errors) and a tolerance of the
    // models.
    constexpr double kTolerance = 0.08;
    constexpr int kBins = 5;
    std::array<double, kBins> count{};
    std::array<double, kBins> right{};
    std::array<double, kBins> confidence{};
    RandomShapes random(2000);
    for (int i = 0; i < 250; ++i)
        for (const Kind& kind : kinds()) {
            if (kind.shape == Shape::point)
                continue;
            const Exploration e = random.exploration(i % 2 == 0 ? 0.02 : 0.05);
            const auto seen = recogniseShape(kind.make(random, random.uniform(0.02, 0.15), e));
            const auto bin = static_cast<std::size_t>(std::min(kBins - 1.0, kBins * seen->confidence));
            count[bin] += 1.0;
            right[bin] += seen->shape == kind.shape ? 1.0 : 0.0;
            confidence[bin] += seen->confidence;
        }
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        if (count[bin] < 20.0)
            continue;
        const double mean = confidence[bin] / count[bin];
        const double share = right[bin] / count[bin];
        std::cout << "confidence " << mean << ": " << share << " of " << count[bin] << " right\n";
        EXPECT_NEAR(share, mean, kTolerance + 3.0 * std::sqrt(mean * (1.0 - mean) / count[bin]));
    }
}

} // namespace teleta::contour
