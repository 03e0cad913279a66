// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/sample_touch.h"
#include "tests/widgets/test_registry.h"
#include "widgets/charts/feature_history.h"

#include <QTest>

using namespace teleta;
using namespace teleta::charts;

namespace {

pipeline::FeatureSample at(double source_s, double steady_s, bool discontinuity = false) {
    pipeline::FeatureSample sample;
    sample.sourceTime_s = source_s;
    sample.time_ns = std::llround(steady_s * 1e9);
    sample.discontinuity = discontinuity;
    return sample;
}

/// 200 Hz from 0, one steady second a stream second.
FeatureHistory steadyHistory(int samples, std::size_t capacity = 65536) {
    FeatureHistory history(capacity);
    for (int i = 0; i < samples; ++i)
        history.append(at(0.005 * i, 0.005 * i));
    return history;
}

} // namespace

class FeatureHistoryTest : public QObject {
    Q_OBJECT
private slots:
    void undefinedFeaturesAreNotANumberAndNeverZero() {
        FeatureHistory history;
        history.append(test::rollingSample(0.0, false));
        for (const Channel channel :
             {Channel::copX, Channel::copY, Channel::cocX, Channel::cocY, Channel::dzmpX, Channel::dzmpY,
              Channel::alphaZ, Channel::lambda1, Channel::lambda2, Channel::ratio})
            QVERIFY(std::isnan(history.value(channel, 0)));
        QCOMPARE(history.value(Channel::force, 0), 0.0);
        QCOMPARE(history.value(Channel::active, 0), 0.0);
    }

    void definedFeaturesAreKeptInSi() {
        FeatureHistory history;
        pipeline::FeatureSample sample = test::rollingSample(1.0, true);
        sample.features.lambda1_m2 = 12e-6;
        sample.features.lambda2_m2 = 4e-6;
        history.append(sample);
        QCOMPARE(history.value(Channel::copX, 0), *sample.features.copX_m);
        QCOMPARE(history.value(Channel::alphaZ, 0), *sample.features.alphaZ_rad);
        QCOMPARE(history.value(Channel::ratio, 0), 3.0);
        sample.features.lambda2_m2 = 0.0;
        history.append(sample);
        QVERIFY(std::isnan(history.value(Channel::ratio, 1)));
    }

    void anEvenStreamHasNoBreaks() {
        const FeatureHistory history = steadyHistory(1000);
        QCOMPARE(history.size(), std::size_t(1000));
        QVERIFY(std::abs(history.newestTime_s() - 999 * 0.005) < 1e-9);
        for (std::size_t i = 1; i < history.size(); ++i)
            QCOMPARE(history.breakBefore(i), Break::none);
    }

    void lostSamplesLeaveAGapOfTheirOwnLength() {
        FeatureHistory history = steadyHistory(200);
        const double before_s = history.newestTime_s();
        history.append(at(0.995 + 0.6, 0.995 + 0.6));
        QCOMPARE(history.breakBefore(200), Break::missing);
        QVERIFY(std::abs(history.newestTime_s() - before_s - 0.6) < 1e-9);
    }

    /// Five periods, but never less than 0.1 s: jitter of a fast stream is no gap.
    void jitterIsNoGap() {
        FeatureHistory history = steadyHistory(200);
        history.append(at(0.995 + 0.09, 0.995 + 0.09));
        QCOMPARE(history.breakBefore(200), Break::none);
        QCOMPARE(history.longestStep_s(), 0.1);
    }

    void aSlowStreamHasLongerSteps() {
        FeatureHistory history;
        for (int i = 0; i < 20; ++i)
            history.append(at(0.5 * i, 0.5 * i));
        QVERIFY(std::abs(history.longestStep_s() - 2.5) < 1e-9);
        QCOMPARE(history.breakBefore(1), Break::none);
    }

    void aSeekBackGoesOnToTheRight() {
        FeatureHistory history = steadyHistory(200);
        const double before_s = history.newestTime_s();
        history.append(at(0.1, 1.5, true));
        QCOMPARE(history.breakBefore(200), Break::jump);
        QVERIFY(std::abs(history.newestTime_s() - before_s - 0.505) < 1e-9); // steady time that passed
        QCOMPARE(history.sourceTime_s(200), 0.1);
    }

    void aJumpTakesAQuarterToTwoSeconds() {
        FeatureHistory history = steadyHistory(200);
        double before_s = history.newestTime_s();
        history.append(at(500.0, 1.0, true));
        QVERIFY(std::abs(history.newestTime_s() - before_s - 0.25) < 1e-9);
        before_s = history.newestTime_s();
        history.append(at(0.0, 1000.0, true));
        QVERIFY(std::abs(history.newestTime_s() - before_s - 2.0) < 1e-9);
    }

    void timeThatRunsBackUnannouncedIsAJumpToo() {
        FeatureHistory history = steadyHistory(200);
        history.append(at(0.2, 1.0));
        QCOMPARE(history.breakBefore(200), Break::jump);
        QVERIFY(history.newestTime_s() > history.time_s(199));
        history.append(at(qQNaN(), 1.1));
        QCOMPARE(history.breakBefore(201), Break::jump);
        QVERIFY(std::isfinite(history.newestTime_s()));
    }

    void theOldestSamplesAreOverwritten() {
        const FeatureHistory history = steadyHistory(250, 100);
        QCOMPARE(history.size(), std::size_t(100));
        QCOMPARE(history.appended(), std::uint64_t(250));
        QCOMPARE(history.sourceTime_s(0), 0.005 * 150);
        QCOMPARE(history.sourceTime_s(99), 0.005 * 249);
        for (std::size_t i = 1; i < history.size(); ++i)
            QVERIFY(history.time_s(i) > history.time_s(i - 1));
    }

    void samplesAreFoundByTime() {
        const FeatureHistory history = steadyHistory(200);
        QCOMPARE(history.firstAt(-1.0), std::size_t(0));
        QCOMPARE(history.firstAt(0.5), std::size_t(100));
        QCOMPARE(history.firstAt(0.5 + 1e-6), std::size_t(101));
        QCOMPARE(history.firstAt(99.0), std::size_t(200));
        QCOMPARE(history.nearest(0.5024), std::optional<std::size_t>(100));
        QCOMPARE(history.nearest(0.5026), std::optional<std::size_t>(101));
        QVERIFY(!history.nearest(5.0));
        QVERIFY(!FeatureHistory().nearest(0.0));
    }

    void nothingIsNearInTheMiddleOfAGap() {
        FeatureHistory history = steadyHistory(200);
        history.append(at(3.0, 3.0));
        QVERIFY(!history.nearest(2.0));
        QVERIFY(history.nearest(2.95));
    }

    void aTimeOfTheStreamMeansItsNewestPass() {
        FeatureHistory history = steadyHistory(200);
        for (int i = 0; i < 100; ++i)
            history.append(at(0.005 * i, 2.0 + 0.005 * i, i == 0));
        QCOMPARE(history.nearestSource(0.25), std::optional<std::size_t>(250));
        QCOMPARE(history.nearestSource(0.9),
                 std::optional<std::size_t>(180)); // only the first pass came so far
    }

    void aTimeOfTheClockMeansWhatWasTheNewestThen() {
        FeatureHistory history(100);
        QVERIFY(!history.newestAt(0));
        // Played at twice its speed, then paused for a second.
        for (int i = 0; i < 100; ++i)
            history.append(at(0.01 * i, 5.0 + 0.005 * i));
        history.append(at(1.0, 6.5));
        const auto newestAt = [&](double time_s) { return history.newestAt(std::llround(time_s * 1e9)); };
        QCOMPARE(newestAt(5.25), std::optional<std::size_t>(49)); // one sample was overwritten
        QCOMPARE(newestAt(5.2549), std::optional<std::size_t>(49));
        QCOMPARE(newestAt(6.0), std::optional<std::size_t>(98));
        QCOMPARE(newestAt(9.0), std::optional<std::size_t>(99));
        QVERIFY(!newestAt(5.0));
    }

    void clearForgetsAll() {
        FeatureHistory history = steadyHistory(10);
        history.clear();
        QVERIFY(history.empty());
        QCOMPARE(history.newestTime_s(), 0.0);
        history.append(at(7.0, 7.0));
        QCOMPARE(history.size(), std::size_t(1));
    }

    /// Header and NA as the command `teleta features` writes them.
    void theDataAreWrittenLikeTheCommandDoes() {
        FeatureHistory history;
        history.append(test::rollingSample(0.5, false));
        pipeline::FeatureSample touched = test::rollingSample(0.505, true);
        touched.features = {};
        touched.features.type = contact::ContactType::point;
        touched.features.force_N = 1.5;
        touched.features.copX_m = 0.0017;
        touched.features.copY_m = -0.001;
        touched.features.active = 1;
        history.append(touched);
        QCOMPARE(
            featuresCsv(history, 0, 2, QStringLiteral("N"), false),
            QStringLiteral("time_s,contact_type,force_n,cop_x_m,cop_y_m,coc_x_m,coc_y_m,dzmp_x_m,dzmp_y_m,"
                           "alpha_z_rad,lambda1_m2,lambda2_m2,active\n"
                           "0.5,none,0,NA,NA,NA,NA,NA,NA,NA,NA,NA,0\n"
                           "0.505,point,1.5,0.0017,-0.001,NA,NA,NA,NA,NA,NA,NA,1\n"));
        // What is no force is not called one in N.
        QVERIFY(featuresCsv(history, 0, 2, QStringLiteral("\u00b5T"), false)
                    .startsWith(QStringLiteral("time_s,contact_type,force_ut,cop_x_m,")));
        QVERIFY(featuresCsv(history, 0, 2, {}, false).contains(QStringLiteral(",force_counts,")));
        touched.time_ns += 5'000'000;
        touched.sourceTime_s = 0.51;
        touched.features.shear = contact::ShearLoad{0.3, -0.4, 0.002, 0.25};
        history.append(touched);
        const QStringList rows =
            featuresCsv(history, 1, 3, QStringLiteral("N"), true).split(QLatin1Char('\n'));
        QVERIFY2(rows[0].endsWith(QLatin1String(",active,shear_x_n,shear_y_n,moment_z_nm,friction_ratio")),
                 qPrintable(rows[0]));
        QVERIFY2(rows[1].endsWith(QLatin1String(",1,NA,NA,NA,NA")), qPrintable(rows[1]));
        QVERIFY2(rows[2].endsWith(QLatin1String(",1,0.3,-0.4,0.002,0.25")), qPrintable(rows[2]));
    }
};

static const teleta::test::Registration<FeatureHistoryTest> registration;

#include "feature_history_test.moc"
