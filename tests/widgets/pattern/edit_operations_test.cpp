// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/pattern/document/edit_operations.h"

#include <QTest>

#include <limits>

using namespace teleta;
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
        QVERIFY(stretchedPoints(rampUp(), {{1, 0}, {1, 2}}, nan).pattern == rampUp());
        QVERIFY(stretchedPoints(rampUp(), {{1, 0}, {1, 2}}, -1.0).pattern == rampUp());
        QVERIFY(pastedPoints(rampUp(), {}, 1.0).pattern == rampUp());
    }

    void aClipTakesThePlaceOfWhatLiesUnderIt() {
        const PointClip clip = copiedPoints(rampUp(), {{1, 0}, {1, 2}}, {});
        const Edited inPlace = pastedPoints(rampUp(), clip, 0.0);
        QVERIFY(inPlace.pattern.tracks[1] == (Track{{0.2, 0.0}, {1.0, 1.0}}));
        const Edited later = pastedPoints(rampUp(), clip, 1.5);
        QCOMPARE(later.pattern.duration_s, 2.5);
        QCOMPARE(later.pattern.tracks[1].size(), std::size_t(5));
        QVERIFY(later.points == PointRefs({{1, 3}, {1, 4}}));
    }

    void breakpointsStretchFromTheFirstOneOn() {
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
