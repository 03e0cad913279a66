// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/charts/feature_history.h"
#include "widgets/charts/polyline.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

using namespace teleta;
using namespace teleta::charts;

namespace {

FeatureHistory historyOf(int samples, double period_s,
                         const std::function<std::optional<double>(int)>& angle) {
    FeatureHistory history;
    for (int i = 0; i < samples; ++i) {
        pipeline::FeatureSample sample;
        sample.sourceTime_s = period_s * i;
        sample.time_ns = std::llround(period_s * i * 1e9);
        sample.features.alphaZ_rad = angle(i);
        sample.features.force_N = angle(i).value_or(0.0);
        history.append(sample);
    }
    return history;
}

/// The stretches of a line between the places where it is lifted.
std::vector<std::vector<PolylinePoint>> stretches(const std::vector<PolylinePoint>& line) {
    std::vector<std::vector<PolylinePoint>> result(1);
    for (const PolylinePoint& point : line) {
        if (std::isnan(point.value))
            result.emplace_back();
        else
            result.back().push_back(point);
    }
    if (result.back().empty())
        result.pop_back();
    return result;
}

std::vector<PolylinePoint> lineOf(const FeatureHistory& history, double from_s, double to_s, double bucket_s,
                                  double period = 0.0) {
    std::vector<PolylinePoint> line;
    makePolyline(history, static_cast<std::size_t>(Channel::alphaZ), from_s, to_s, bucket_s, period, line);
    return line;
}

} // namespace

class PolylineTest : public QObject {
    Q_OBJECT
private slots:
    void noPeakIsLost() {
        const FeatureHistory history = historyOf(10000, 0.001, [](int i) {
            return i == 4321 ? 99.0 : i == 8765 ? -99.0 : std::sin(0.01 * i);
        });
        const auto line = lineOf(history, 0.0, 10.0, 0.05);
        QVERIFY(line.size() <= 2 * 201 + 3);
        const auto has = [&](double time_s, double value) {
            return std::ranges::any_of(line, [&](const PolylinePoint& p) {
                return std::abs(p.time_s - time_s) < 1e-9 && p.value == value;
            });
        };
        QVERIFY(has(4.321, 99.0));
        QVERIFY(has(8.765, -99.0));
    }

    void timesNeverGoBack() {
        const FeatureHistory history = historyOf(5000, 0.001, [](int i) { return std::sin(0.37 * i); });
        const auto line = lineOf(history, 0.0, 5.0, 0.02);
        for (std::size_t i = 1; i < line.size(); ++i)
            QVERIFY(line[i].time_s >= line[i - 1].time_s);
    }

    void theRangeIsThatOfTheSamples() {
        const FeatureHistory history = historyOf(1000, 0.01, [](int i) { return 0.1 * (i % 37) - 1.0; });
        std::vector<PolylinePoint> line;
        const auto range =
            makePolyline(history, static_cast<std::size_t>(Channel::alphaZ), 0.0, 10.0, 0.3, 0.0, line);
        QVERIFY(range);
        QCOMPARE(range->low, -1.0);
        QCOMPARE(range->high, 2.6);
    }

    void undefinedValuesLiftThePen() {
        const FeatureHistory history = historyOf(300, 0.01, [](int i) -> std::optional<double> {
            return i >= 100 && i < 200 ? std::nullopt : std::optional(1.0);
        });
        const auto parts = stretches(lineOf(history, 0.0, 3.0, 0.05));
        QCOMPARE(parts.size(), std::size_t(2));
        QVERIFY(std::abs(parts[0].back().time_s - 0.99) < 1e-9);
        QVERIFY(std::abs(parts[1].front().time_s - 2.0) < 1e-9);
    }

    void aBucketThatHoldsAGapIsDrawnOnBothSidesOfIt() {
        const FeatureHistory history = historyOf(100, 0.01, [](int i) -> std::optional<double> {
            return i == 50 ? std::nullopt : std::optional(static_cast<double>(i));
        });
        const auto parts = stretches(lineOf(history, 0.0, 1.0, 10.0)); // one bucket for everything
        QCOMPARE(parts.size(), std::size_t(2));
        QCOMPARE(parts[0].back().value, 49.0);
        QCOMPARE(parts[1].front().value, 51.0);
    }

    void lostSamplesAndJumpsLiftThePen() {
        FeatureHistory history;
        const auto put = [&](double time_s, bool discontinuity) {
            pipeline::FeatureSample sample;
            sample.sourceTime_s = time_s;
            sample.time_ns = std::llround(time_s * 1e9);
            sample.discontinuity = discontinuity;
            sample.features.alphaZ_rad = 0.5;
            history.append(sample);
        };
        for (int i = 0; i < 100; ++i)
            put(0.01 * i, false);
        for (int i = 0; i < 100; ++i)
            put(2.0 + 0.01 * i, false);
        for (int i = 0; i < 100; ++i)
            put(3.0 + 0.01 * i, i == 0);
        QCOMPARE(stretches(lineOf(history, 0.0, 9.0, 0.02)).size(), std::size_t(3));
    }

    void anAngleThatWrapsIsNotDrawnAcross() {
        const FeatureHistory history =
            historyOf(400, 0.01, [](int i) { return std::remainder(0.05 * i, std::numbers::pi); });
        const auto parts = stretches(lineOf(history, 0.0, 4.0, 0.005, std::numbers::pi));
        QCOMPARE(parts.size(), std::size_t(7)); // 20 rad are 6.4 half turns, starting in the middle of one
        for (const auto& part : parts)
            for (std::size_t i = 1; i < part.size(); ++i)
                QVERIFY(part[i].value > part[i - 1].value);
    }

    void aSingleSampleIsADash() {
        const FeatureHistory history = historyOf(100, 0.01, [](int i) -> std::optional<double> {
            return i == 40 ? std::optional(2.0) : std::nullopt;
        });
        const auto parts = stretches(lineOf(history, 0.0, 1.0, 0.02));
        QCOMPARE(parts.size(), std::size_t(1));
        QCOMPARE(parts[0].size(), std::size_t(2));
        QCOMPARE(parts[0][0].value, parts[0][1].value);
        QVERIFY(std::abs(parts[0][1].time_s - parts[0][0].time_s - 0.02) < 1e-9);
    }

    void aConstantReachesItsLastSample() {
        const FeatureHistory history = historyOf(100, 0.01, [](int) { return 3.0; });
        const auto line = lineOf(history, 0.0, 5.0, 0.3);
        QVERIFY(std::abs(stretches(line).front().back().time_s - 0.99) < 1e-9);
    }

    /// A line that scrolls by less than a bucket keeps its inner points.
    void aScrollingLineDoesNotShimmer() {
        const FeatureHistory history =
            historyOf(4000, 0.005, [](int i) { return std::sin(1.7 * i) + 0.3 * std::sin(0.02 * i); });
        const auto first = lineOf(history, 5.0, 15.0, 0.1);
        const auto second = lineOf(history, 5.037, 15.037, 0.1);
        const auto inner = [](const std::vector<PolylinePoint>& line) {
            std::vector<std::pair<double, double>> points;
            for (const PolylinePoint& p : line)
                if (p.time_s >= 5.2 && p.time_s < 14.8)
                    points.emplace_back(p.time_s, p.value);
            return points;
        };
        QVERIFY(inner(first).size() > 100);
        QVERIFY(inner(first) == inner(second));
    }

    void theLineReachesBeyondBothEnds() {
        const FeatureHistory history = historyOf(1000, 0.01, [](int) { return 1.0; });
        const auto line = lineOf(history, 2.005, 4.005, 0.01);
        QVERIFY(line.front().time_s <= 2.005);
        QVERIFY(stretches(line).front().back().time_s >= 4.005);
    }

    void nothingGivesNothing() {
        std::vector<PolylinePoint> line{{1.0, 2.0}};
        QVERIFY(!makePolyline(FeatureHistory(), static_cast<std::size_t>(Channel::force), 0.0, 1.0, 0.1, 0.0,
                              line));
        QVERIFY(line.empty());
        const FeatureHistory undefined = historyOf(100, 0.01, [](int) { return std::nullopt; });
        QVERIFY(
            !makePolyline(undefined, static_cast<std::size_t>(Channel::alphaZ), 0.0, 1.0, 0.1, 0.0, line));
        QVERIFY(line.empty());
    }

    void whatLiesOutsideIsCutExactlyAtTheEnds() {
        std::vector<PolylinePoint> line{{0.0, 0.0}, {1.0, 10.0}, {2.0, 10.0}, {3.0, -10.0}, {4.0, 0.0}};
        cutPolyline(line, {-5.0, 5.0});
        const auto parts = stretches(line);
        QCOMPARE(parts.size(), std::size_t(3));
        const auto isAt = [](const PolylinePoint& p, double time_s, double value) {
            return std::abs(p.time_s - time_s) < 1e-12 && std::abs(p.value - value) < 1e-12;
        };
        QVERIFY(isAt(parts[0].front(), 0.0, 0.0) && isAt(parts[0].back(), 0.5, 5.0));
        QVERIFY(isAt(parts[1].front(), 2.25, 5.0) && isAt(parts[1].back(), 2.75, -5.0)); // right through
        QVERIFY(isAt(parts[2].front(), 3.5, -5.0) && isAt(parts[2].back(), 4.0, 0.0));
    }

    void cuttingKeepsGapsAndInnerLines() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        std::vector<PolylinePoint> inner{{0.0, 1.0}, {1.0, 2.0}, {1.0, nan}, {2.0, 3.0}, {3.0, 3.0}};
        cutPolyline(inner, {0.0, 3.0});
        QCOMPARE(inner.size(), std::size_t(5));
        cutPolyline(inner, {0.0, 1.5});
        const auto parts = stretches(inner);
        QCOMPARE(parts.size(), std::size_t(1));
        QCOMPARE(parts[0].back().value, 1.5);
        std::vector<PolylinePoint> away{{0.0, 9.0}, {1.0, 9.0}, {2.0, 8.0}};
        cutPolyline(away, {0.0, 1.0});
        QVERIFY(stretches(away).empty());
    }

    void infiniteValuesAreGaps() {
        const FeatureHistory history = historyOf(100, 0.01, [](int i) { return i == 50 ? qInf() : 1.0; });
        QCOMPARE(stretches(lineOf(history, 0.0, 1.0, 0.02)).size(), std::size_t(2));
    }
};

static const teleta::test::Registration<PolylineTest> registration;

#include "polyline_test.moc"
