// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/laws.h"
#include "tests/widgets/test_registry.h"
#include "widgets/pattern/edit_operations.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>

using namespace teleta;
using namespace teleta::editor;
using namespace teleta::pattern;

namespace {

Pattern rampUp() {
    Pattern pattern;
    pattern.duration_s = 2.0;
    pattern.tracks[1] = {{0.2, 0.0}, {0.6, 0.5}, {1.0, 1.0}};
    return pattern;
}

Pattern withForm(ObjectForm form) {
    Pattern pattern;
    pattern.duration_s = 4.0;
    pattern.objects.push_back({"", std::move(form), {}});
    return pattern;
}

} // namespace

/// What an editor does to a pattern, in closed form.
class EditOperationsTest : public QObject {
    Q_OBJECT

private slots:
    void aNewBreakpointGoesBehindThoseAtItsTime() {
        const Edited edited = withPoint(rampUp(), 1, {0.6, 0.9});
        QCOMPARE(edited.pattern.tracks[1].size(), std::size_t(4));
        QVERIFY(edited.points == PointRefs({{1, 2}}));
        QCOMPARE(edited.pattern.tracks[1][2].intensity, 0.9);
        const Edited outside = withPoint(rampUp(), 0, {9.0, 7.0});
        QCOMPARE(outside.pattern.tracks[0][0].time_s, 2.0);
        QCOMPARE(outside.pattern.tracks[0][0].intensity, 1.0);
        QVERIFY(withPoint(rampUp(), 6, {}).pattern == rampUp());
    }

    void aMoveIsLimitedToThePatternAndKeepsTheForm() {
        const Edited edited = movedPoints(rampUp(), {{1, 0}, {1, 2}}, -5.0, 0.25);
        QCOMPARE(edited.pattern.tracks[1][0].time_s, 0.0);
        QCOMPARE(edited.pattern.tracks[1][0].intensity, 0.25);
        QCOMPARE(edited.pattern.tracks[1][2].time_s, 0.8);
        QCOMPARE(edited.pattern.tracks[1][2].intensity, 1.0);
    }

    void breakpointsThatPassOthersChangePlaces() {
        const Edited edited = movedPoints(rampUp(), {{1, 0}}, 0.5, 0.0);
        QVERIFY(edited.points == PointRefs({{1, 1}}));
        QCOMPARE(edited.pattern.tracks[1][0].time_s, 0.6);
        QCOMPARE(edited.pattern.tracks[1][1].time_s, 0.7);
    }

    void nothingHappensWithoutAUsableMove() {
        QVERIFY(movedPoints(rampUp(), {{5, 3}}, 0.5, 0.0).pattern == rampUp());
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(movedPoints(rampUp(), {{1, 0}}, nan, 0.0).pattern == rampUp());
        QVERIFY(stretched(rampUp(), nan) == rampUp());
        QVERIFY(stretched(rampUp(), -1.0) == rampUp());
        QVERIFY(pasted(rampUp(), {}, 1.0).pattern == rampUp());
    }

    void aClipTakesThePlaceOfWhatLiesUnderIt() {
        const Clip clip = copied(rampUp(), {{1, 0}, {1, 2}}, {});
        const Edited inPlace = pasted(rampUp(), clip, 0.0);
        QVERIFY(inPlace.pattern.tracks[1] == (Track{{0.2, 0.0}, {1.0, 1.0}}));
        const Edited later = pasted(rampUp(), clip, 1.5);
        QCOMPARE(later.pattern.duration_s, 2.5);
        QCOMPARE(later.pattern.tracks[1].size(), std::size_t(5));
        QVERIFY(later.points == PointRefs({{1, 3}, {1, 4}}));
    }

    void sixRotationsAndTwoMirrorsAreNone() {
        Pattern pattern = rampUp();
        pattern.objects.push_back({"", Ring{.firstTactor = 2, .burst_s = {}}, {}});
        pattern.objects.push_back({"", Stroke{0.0, {{0.0, 0.5, 0.2}, {1.0, 1.5, 0.7}}, 1.0}, {}});
        Pattern around = pattern;
        for (int i = 0; i < 6; ++i)
            around = rotated(around, 1);
        QVERIFY(around.tracks == pattern.tracks);
        QVERIFY(around.objects[0] == pattern.objects[0]);
        QVERIFY(mirrored(mirrored(pattern)) == pattern);
        QVERIFY(rotated(pattern, -1).tracks == rotated(pattern, 5).tracks);
        QVERIFY(armsSwapped(armsSwapped(pattern)).tracks == pattern.tracks);
    }

    /// Every operation on the ring permutes what is felt: out[map(i)] = in[i] at every time.
    void ringOperationsPermuteWhatIsFelt_data() {
        QTest::addColumn<int>("sign");
        QTest::addColumn<int>("offset");
        QTest::newRow("rotated by one") << 1 << 1;
        QTest::newRow("rotated by two") << 1 << 2;
        QTest::newRow("mirrored") << -1 << 0;
        QTest::newRow("arms swapped") << -1 << 3;
    }
    void ringOperationsPermuteWhatIsFelt() {
        QFETCH(int, sign);
        QFETCH(int, offset);
        Pattern all = rampUp();
        all.duration_s = 4.0;
        for (const ObjectForm& form :
             {ObjectForm(Sweep{0.0, 0.1, {}, {0, 2, 3}, 0.7}),
              ObjectForm(Ring{.firstTactor = 1, .burst_s = {}, .intensity = 0.4}),
              ObjectForm(Phantom{.first = 4, .second = 5, .balanceTo = 1.0}),
              ObjectForm(Ramp{.tactors = {3}}), ObjectForm(PulseTrain{.tactors = {0, 4}, .intensity = 0.8}),
              ObjectForm(Stroke{2.0, {{0.0, 0.1, 0.1}, {1.5, 7.3, 0.9}}, 1.0})})
            all.objects.push_back({"", form, {}});
        const Pattern after = sign > 0      ? rotated(all, offset)
                              : offset == 0 ? mirrored(all)
                                            : armsSwapped(all);
        for (double t_s = 0.0137; t_s < 4.0; t_s += 0.031) {
            const core::Intensities before = evaluate(all, t_s);
            const core::Intensities now = evaluate(after, t_s);
            for (int i = 0; i < 6; ++i)
                QVERIFY2(std::abs(now[static_cast<std::size_t>((sign * i + offset + 6) % 6)] -
                                  before[static_cast<std::size_t>(i)]) < 1e-9,
                         qPrintable(QString("tactor %1 at %2 s").arg(i + 1).arg(t_s)));
        }
    }

    void aStretchedSweepKeepsTheLawWhereItCan() {
        const Pattern sweep = withForm(Sweep{0.5, 0.1, {}, {0, 1, 2}, 1.0});
        const Pattern longer = stretched(sweep, 2.0);
        const auto& form = std::get<Sweep>(longer.objects[0].form);
        QVERIFY(!form.onset_s);
        QCOMPARE(form.start_s, 1.0);
        const Span before = spanOf(sweep.objects[0].form);
        const Span after = spanOf(longer.objects[0].form);
        QCOMPARE(after.end_s - after.begin_s, 2.0 * (before.end_s - before.begin_s));
        // 2 * 47.3 ms alone are longer than a tenth of it: the law has no burst for that.
        const auto& shorter = std::get<Sweep>(stretched(sweep, 0.1).objects[0].form);
        QVERIFY(shorter.onset_s.has_value());
        QCOMPARE(*shorter.onset_s, 0.1 * apparentMotionOnset_s(0.1));
    }

    void aWholePatternStretches() {
        const Pattern longer = stretched(rampUp(), 3.0);
        QCOMPARE(longer.duration_s, 6.0);
        QCOMPARE(longer.tracks[1][1].time_s, 1.8);
        QCOMPARE(stretched(rampUp(), 1e9).duration_s, Pattern::kLongest_s);
        const Edited some = stretchedPoints(rampUp(), {{1, 0}, {1, 2}}, 5.0);
        QCOMPARE(some.pattern.duration_s, 4.2);
        QVERIFY(some.points == PointRefs({{1, 0}, {1, 2}}));
    }

    void anObjectStaysWithItsBeginInThePattern() {
        const Pattern ramp = withForm(Ramp{1.0, 1.0, {0}});
        QCOMPARE(spanOf(movedObject(ramp, 0, -9.0).objects[0].form).begin_s, 0.0);
        QCOMPARE(spanOf(movedObject(ramp, 0, 9.0).objects[0].form).begin_s, 4.0);
        QCOMPARE(withObject(Pattern{}, ramp.objects[0]).duration_s, 2.0);
        QVERIFY(withoutObject(ramp, 3) == ramp);
    }
};

namespace {
const test::Registration<EditOperationsTest> registration;
}
#include "edit_operations_test.moc"
