// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/input_events.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/controls/inline_edit.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/timeline/timeline_curves.h"
#include "widgets/pattern/timeline/timeline_view.h"

#include <QImage>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace teleta;
using namespace teleta::pattern;

namespace {

Pattern sample() {
    Pattern pattern;
    pattern.id = "mine.1";
    pattern.name = "Sample";
    pattern.duration_s = 2.0;
    pattern.tracks[0] = {{0.2, 0.2}, {0.5, 0.8}, {1.0, 0.4}};
    pattern.tracks[2] = {{0.5, 0.5}, {1.5, 0.5}};
    return pattern;
}

struct Fixture {
    PatternDocument document;
    TimelineView view{&document};

    explicit Fixture(const Pattern& pattern = sample()) {
        document.setPattern(pattern);
        view.resize(900, 520);
        view.show();
        view.setFocus();
        (void)view.grab();
    }
    [[nodiscard]] QPoint at(std::size_t track, double time_s, double intensity) const {
        const TimelineGeometry geometry = view.geometryNow();
        return QPointF(geometry.xOf(time_s), geometry.yOf(track, intensity)).toPoint();
    }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&view, Qt::LeftButton, modifiers, from);
        for (int step = 1; step <= 4; ++step) {
            const QPointF between = QPointF(from) + QPointF(to - from) * (0.25 * step);
            QMouseEvent move(QEvent::MouseMove, between.toPoint(), view.mapToGlobal(between.toPoint()),
                             Qt::NoButton, Qt::LeftButton, modifiers);
            QApplication::sendEvent(&view, &move);
        }
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, to);
    }
};

/// Whether a pixel differs from the ground of an empty timeline at the same place.
bool painted(const QImage& image, const QImage& empty, const QPoint& at) {
    for (int dx = -1; dx <= 1; ++dx)
        for (int dy = -1; dy <= 1; ++dy)
            if (image.pixel(at + QPoint(dx, dy)) != empty.pixel(at + QPoint(dx, dy)))
                return true;
    return false;
}

} // namespace

/// Mouse, keys and pixels of the timeline.
class TimelineViewTest : public QObject {
    Q_OBJECT

private slots:
    void timesAndPlacesAgree() {
        const TimelineGeometry geometry(QRectF(0, 0, 800, 500), QFont(), 1.5, 4.0);
        for (const double t_s : {1.5, 2.0, 5.5})
            QVERIFY(std::abs(geometry.timeAt(geometry.xOf(t_s)) - t_s) < 1e-9);
        for (std::size_t lane = 0; lane < 6; ++lane)
            for (const double i : {0.0, 0.3, 1.0}) {
                QVERIFY(std::abs(geometry.intensityAt(lane, geometry.yOf(lane, i)) - i) < 1e-9);
                QVERIFY(geometry.laneAt(geometry.yOf(lane, i)) == lane);
            }
        QCOMPARE(timeText(0.25, 0.05), QString("0.25"));
        QCOMPARE(timeText(65.0, 5.0), QString("1:05"));
        QCOMPARE(timeText(3600.0, 600.0), QString("1:00:00"));
    }

    /// From rest the speed is (1 - 10^(-t / rise)) of the steady one.
    void thePredictedCurveIsTheStepResponse() {
        Pattern step;
        step.duration_s = 2.0;
        step.tracks[0] = {{0.0, 1.0}, {2.0, 1.0}};
        const MotorProfiles motors = assumedMotors();
        const TimelineCurves curves = sampleCurves(step, CompiledPattern(step), motors, {0.0, 1.0}, 201);
        QVERIFY(curves.hasPrediction());
        const double full_Hz = steadySpeed_Hz(motors[0], 1.0);
        for (std::size_t k = 0; k < curves.times_s.size(); ++k) {
            const double speed_Hz =
                full_Hz * (1.0 - std::pow(10.0, -curves.times_s[k] / motors[0].riseTime_s));
            QVERIFY(std::abs(curves.predicted[0][k] - intensityOfSpeed(motors[0], speed_Hz)) < 1e-6);
            QCOMPARE(curves.commanded[0][k], curves.times_s[k] < 0.0 ? 0.0 : 1.0);
        }
        // The prediction does not depend on where the view begins.
        const TimelineCurves later = sampleCurves(step, CompiledPattern(step), motors, {0.05, 0.1}, 3);
        QVERIFY(std::abs(later.predicted[0][0] -
                         intensityOfSpeed(motors[0],
                                          full_Hz * (1.0 - std::pow(10.0, -0.05 / motors[0].riseTime_s)))) <
                1e-6);
    }

    void curvesLieWhereThePatternIs() {
        for (const bool dark : {false, true}) {
            base::applyTheme(dark ? base::ThemeChoice::dark : base::ThemeChoice::light);
            Pattern nothing;
            nothing.id = "mine.0";
            nothing.duration_s = 2.0;
            Fixture empty(nothing);
            Fixture f;
            const QImage ground = empty.view.grab().toImage();
            const QImage image = f.view.grab().toImage();
            QVERIFY(painted(image, ground, f.at(0, 0.35, 0.5))); // on the line
            QVERIFY(painted(image, ground, f.at(2, 0.8, 0.5)));
            QVERIFY(painted(image, ground, f.at(2, 0.8, 0.25))); // below it
            QVERIFY(!painted(image, ground, f.at(2, 0.8, 0.9))); // above
            QVERIFY(!painted(image, ground, f.at(2, 0.3, 0.5))); // before
            QVERIFY(!painted(image, ground, f.at(4, 0.8, 0.5))); // another lane
            QCOMPARE(f.view.drawnHandles(), 5);
        }
        base::applyTheme(base::ThemeChoice::light);
    }

    void aDoubleClickAddsABreakpointOnTheGrid() {
        Fixture f;
        QTest::mouseDClick(&f.view, Qt::LeftButton, {}, f.at(4, 0.703, 0.5));
        const Track& track = f.document.pattern().tracks[4];
        QCOMPARE(track.size(), std::size_t(1));
        QVERIFY(std::abs(track[0].time_s - 0.7) < 1e-9);
        QVERIFY(std::abs(track[0].intensity - 0.5) < 0.02);
        QTest::keySequence(&f.view, QKeySequence::Undo);
        QVERIFY(f.document.pattern() == sample());
        QTest::keySequence(&f.view, QKeySequence::Redo);
        QCOMPARE(f.document.pattern().tracks[4].size(), std::size_t(1));
    }

    void thePenAddsWithEveryClick() {
        Fixture f;
        QTest::keyClick(&f.view, Qt::Key_P);
        QVERIFY(f.view.pen());
        QTest::mouseClick(&f.view, Qt::LeftButton, {}, f.at(5, 0.4, 0.2));
        QTest::mouseClick(&f.view, Qt::LeftButton, {}, f.at(5, 0.9, 0.9));
        QCOMPARE(f.document.pattern().tracks[5].size(), std::size_t(2));
        QTest::keyClick(&f.view, Qt::Key_P);
        QVERIFY(!f.view.pen());
    }

    void aDragMovesOnTheGridAndIsOneUndo() {
        Fixture f;
        f.drag(f.at(0, 0.5, 0.8), f.at(0, 0.703, 0.6));
        const Breakpoint moved = f.document.pattern().tracks[0][1];
        QVERIFY2(std::abs(std::remainder(moved.time_s, 0.01)) < 1e-9,
                 qPrintable(QString::number(moved.time_s)));
        QVERIFY(std::abs(moved.time_s - 0.7) < 0.006);
        QVERIFY(std::abs(moved.intensity - 0.6) < 0.03);
        QCOMPARE(f.document.undoStack()->count(), 1);
        f.document.undoStack()->undo();
        QVERIFY(f.document.pattern() == sample());
    }

    void altLeavesTheGrid() {
        Fixture f;
        f.document.setSnapStep(0.5);
        f.drag(f.at(0, 0.5, 0.8), f.at(0, 0.63, 0.8), Qt::AltModifier);
        QVERIFY(std::abs(f.document.pattern().tracks[0][1].time_s - 0.63) < 0.005);
    }

    void aBoxSelectsAndDeleteDeletes() {
        Fixture f;
        f.drag(f.at(0, 0.1, 1.0), f.at(2, 0.6, 0.1));
        QVERIFY(f.document.selection().points == PointRefs({{0, 0}, {0, 1}, {2, 0}}));
        f.drag(f.at(0, 0.9, 0.9), f.at(0, 1.1, 0.1), Qt::ShiftModifier);
        QCOMPARE(f.document.selection().points.size(), std::size_t(4));
        QTest::keyClick(&f.view, Qt::Key_Delete);
        QCOMPARE(f.document.pattern().tracks[0].size(), std::size_t(0));
        QCOMPARE(f.document.pattern().tracks[2].size(), std::size_t(1));
        f.document.undoStack()->undo();
        QCOMPARE(f.document.selection().points.size(), std::size_t(4));
        QTest::mouseClick(&f.view, Qt::LeftButton, {}, f.at(5, 1.8, 0.5));
        QVERIFY(f.document.selection().empty());
    }

    void arrowsNudge() {
        Fixture f;
        QTest::mouseClick(&f.view, Qt::LeftButton, {}, f.at(0, 0.5, 0.8));
        QTest::keyClick(&f.view, Qt::Key_Right);
        QTest::keyClick(&f.view, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&f.view, Qt::Key_Down);
        QTest::keyClick(&f.view, Qt::Key_Down, Qt::ShiftModifier);
        const Breakpoint moved = f.document.pattern().tracks[0][1];
        QVERIFY(std::abs(moved.time_s - 0.61) < 1e-9);
        QVERIFY(std::abs(moved.intensity - 0.74) < 1e-9);
        QCOMPARE(f.document.undoStack()->count(), 1);
    }

    void cutAndPasteInPlaceIsNoChange() {
        Fixture f;
        QTest::keySequence(&f.view, QKeySequence::SelectAll);
        QTest::keySequence(&f.view, QKeySequence::Cut);
        QVERIFY(f.document.pattern().tracks[0].empty());
        QTest::keySequence(&f.view, QKeySequence::Paste);
        QVERIFY(f.document.pattern() == sample());
        QTest::keyClick(&f.view, Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(f.document.pattern().tracks[0].size(), std::size_t(6));
    }

    void everythingIsThereByKeyboard() {
        Fixture f;
        QTest::keyClick(&f.view, Qt::Key_PageDown);
        QTest::keyClick(&f.view, Qt::Key_PageDown);
        QCOMPARE(f.view.currentLane(), std::size_t(2));
        QTest::keyClick(&f.view, Qt::Key_Period);
        QVERIFY(f.document.selection().points == PointRefs({{2, 0}}));
        QTest::keyClick(&f.view, Qt::Key_Period);
        QVERIFY(f.document.selection().points == PointRefs({{2, 1}}));
        QTest::keyClick(&f.view, Qt::Key_Comma);
        QVERIFY(f.document.selection().points == PointRefs({{2, 0}}));
        QSignalSpy moves(&f.view, &TimelineView::playheadMoved);
        QTest::keyClick(&f.view, Qt::Key_End);
        QCOMPARE(f.view.playhead_s(), 2.0);
        QTest::keyClick(&f.view, Qt::Key_Home);
        QCOMPARE(f.view.playhead_s(), 0.0);
        QCOMPARE(moves.size(), 2);
        f.view.setPlayhead(1.0);
        QCOMPARE(moves.size(), 2);
        QTest::keyClick(&f.view, Qt::Key_Insert);
        QCOMPARE(f.document.pattern().tracks[2].size(), std::size_t(3));
        QVERIFY(std::abs(f.document.pattern().tracks[2][1].intensity - 0.5) < 1e-9);
        QSignalSpy plays(&f.view, &TimelineView::playToggled);
        QTest::keyClick(&f.view, Qt::Key_Space);
        QCOMPARE(plays.size(), 1);
    }

    void numbersAreTypedOverABreakpoint() {
        Fixture f;
        QTest::mouseDClick(&f.view, Qt::LeftButton, {}, f.at(0, 0.5, 0.8));
        auto* edit = f.view.findChild<base::InlineEdit*>(QStringLiteral("pointEdit"));
        QVERIFY(edit);
        edit->selectAll();
        QTest::keyClicks(edit, "0.75 s; 33 %");
        QTest::keyClick(edit, Qt::Key_Return);
        QCOMPARE(f.document.pattern().tracks[0][1].time_s, 0.75);
        QVERIFY(std::abs(f.document.pattern().tracks[0][1].intensity - 0.33) < 1e-12);
        QCOMPARE(f.document.undoStack()->count(), 1);
    }

    void ctrlAndWheelZoomsAtTheMouse() {
        Fixture f;
        const QPointF mouse = f.at(0, 0.5, 0.8);
        const double span_s = f.view.span_s();
        QVERIFY(test::turnWheel(&f.view, mouse, 3, Qt::ControlModifier));
        QVERIFY(std::abs(f.view.span_s() - span_s / std::pow(1.2, 3)) < 1e-9);
        QVERIFY(std::abs(f.view.geometryNow().timeAt(mouse.x()) - 0.5) < 0.01);
        const double begin_s = f.view.begin_s();
        QVERIFY(test::turnWheel(&f.view, mouse, -1, Qt::ShiftModifier));
        QVERIFY(std::abs(f.view.begin_s() - begin_s - 0.1 * f.view.span_s()) < 1e-9);
        QVERIFY(!test::turnWheel(&f.view, mouse, 1));
        QVERIFY(test::turnWheel(&f.view, mouse, -20, Qt::ControlModifier));
        QVERIFY(std::abs(f.view.span_s() - span_s) < 1e-9);
        QTest::keyClick(&f.view, Qt::Key_Plus, Qt::ControlModifier);
        QVERIFY(f.view.span_s() < span_s);
        QTest::keyClick(&f.view, Qt::Key_0, Qt::ControlModifier);
        QVERIFY(std::abs(f.view.span_s() - span_s) < 1e-9);
    }

    void theRulerMovesThePlayheadAndSetsTheLoop() {
        Fixture f;
        const TimelineGeometry geometry = f.view.geometryNow();
        const auto ruler = [&](double t_s) {
            return QPointF(geometry.xOf(t_s), geometry.ruler.center().y()).toPoint();
        };
        QSignalSpy moves(&f.view, &TimelineView::playheadMoved);
        f.drag(ruler(0.3), ruler(1.2));
        QVERIFY(std::abs(f.view.playhead_s() - 1.2) < 0.006);
        QVERIFY(moves.size() >= 2);
        f.drag(ruler(1.5), ruler(0.5), Qt::ShiftModifier);
        QVERIFY(f.view.loop().has_value());
        QVERIFY(std::abs(f.view.loop()->begin_s - 0.5) < 0.006);
        QVERIFY(std::abs(f.view.loop()->end_s - 1.5) < 0.006);
        f.view.setLoop(Span{3.0, 5.0});
        QVERIFY(!f.view.loop());
    }

    void anObjectIsSelectedMovedAndActivated() {
        Pattern pattern = sample();
        pattern.objects.push_back({"", Ramp{0.4, 0.5, {4}}, {}});
        Fixture f(pattern);
        f.drag(f.at(4, 0.6, 0.5), f.at(4, 0.8, 0.5));
        QVERIFY(f.document.selection().object == std::size_t(0));
        QVERIFY(std::abs(std::get<Ramp>(f.document.pattern().objects[0].form).start_s - 0.6) < 0.006);
        QCOMPARE(f.document.undoStack()->count(), 1);
        QSignalSpy activated(&f.view, &TimelineView::objectActivated);
        QTest::mouseDClick(&f.view, Qt::LeftButton, {}, f.at(4, 0.8, 0.5));
        QCOMPARE(activated.size(), 1);
        QTest::keyClick(&f.view, Qt::Key_Delete);
        QVERIFY(f.document.pattern().objects.empty());
    }

    /// An hour with 100 000 breakpoints: drawing depends on the visible part only.
    void aLongPatternPaintsOnlyWhatIsVisible() {
        Pattern hour;
        hour.id = "mine.hour";
        hour.duration_s = 3600.0;
        constexpr int kPoints = 100'000;
        for (int i = 0; i < kPoints; ++i)
            hour.tracks[static_cast<std::size_t>(i % 6)].push_back(
                {3600.0 * i / kPoints, i % 12 < 6 ? 0.2 : 0.9});
        Fixture f(hour);
        QCOMPARE(f.view.drawnHandles(), 0); // all of them would overlap
        f.view.showSpan(1800.0, 3.6);
        (void)f.view.grab();
        // 100 breakpoints in 3.6 s, and those whose handles reach in from outside.
        QVERIFY2(f.view.drawnHandles() >= 100 && f.view.drawnHandles() <= 104,
                 qPrintable(QString::number(f.view.drawnHandles())));
        const TimelineCurves curves = sampleCurves(f.document.pattern(), f.document.compiled(),
                                                   f.document.motors(), {0.0, 3600.0}, 1600);
        QVERIFY(curves.times_s.size() <= 1610U);
        QVERIFY(!curves.hasPrediction());
        f.document.selectAll();
        f.view.zoomToFit();
        (void)f.view.grab();
        QCOMPARE(f.view.drawnHandles(), 0);
    }

    /// Bursts narrower than a pixel are drawn nevertheless, with their prediction.
    void anHourSeenAsAWholeShowsEveryBurst() {
        Pattern hour;
        hour.id = "mine.hour";
        hour.duration_s = 3600.0;
        const Pattern silent = hour;
        hour.tracks[2] = {{1800.0, 0.0}, {1800.0, 0.9}, {1800.2, 0.9}, {1800.2, 0.0}};
        Fixture f(hour);
        QTRY_VERIFY(f.view.overview()->isCurrent());
        QVERIFY(f.view.overview()->commanded() && f.view.overview()->predicted());
        const TimelineBands bands = bandsOf(*f.view.overview()->commanded(),
                                            f.view.overview()->predicted().get(), {0.0, 3600.0}, 500);
        QCOMPARE(bands.tracks[2].commanded[250].high, 0.9);
        QVERIFY(bands.tracks[2].predicted[250].high > 0.5F);
        QCOMPARE(bands.tracks[2].commanded[100].high, 0.0);
        f.view.zoomToFit();
        const QImage with = f.view.grab().toImage();
        Fixture empty(silent);
        QTRY_VERIFY(empty.view.overview()->isCurrent());
        empty.view.zoomToFit();
        QVERIFY(painted(with, empty.view.grab().toImage(), f.at(2, 1800.0, 0.4)));
        QVERIFY(!painted(with, empty.view.grab().toImage(), f.at(2, 900.0, 0.4)));
    }

    void theRangesOfSamplesAreThoseOfTheirColumns() {
        TimelineCurves ramp; // 0, 0.1 ... 1 in one second; the fourth fifth of it has no sample
        for (int k = 0; k <= 10; ++k)
            if (k != 6 && k != 7)
                ramp.times_s.push_back(0.1 * k + 1e-9);
        ramp.commanded.fill(ramp.times_s);
        const TimelineBands bands = bandsOf(ramp, {0.0, 1.0}, 5);
        const auto& columns = bands.tracks[3].commanded;
        QCOMPARE(columns.size(), 5U);
        QVERIFY(!bands.hasPrediction());
        const double expected[5][2] = {{0.0, 0.1}, {0.1, 0.3}, {0.3, 0.5}, {0.5, 0.5}, {0.5, 0.9}};
        for (std::size_t k = 0; k < columns.size(); ++k) {
            QVERIFY(std::abs(columns[k].low - expected[k][0]) < 1e-6);
            QVERIFY(std::abs(columns[k].high - expected[k][1]) < 1e-6);
        }
    }

    /// Lines and areas with many corners are drawn piece by piece: none may be missing.
    void everyBurstOfACrowdedStretchIsPainted() {
        Pattern crowded;
        crowded.id = "mine.crowded";
        crowded.duration_s = 10.0;
        const Pattern silent = crowded;
        constexpr int kBursts = 100;
        for (int k = 0; k < kBursts; ++k)
            for (const Breakpoint& point :
                 {Breakpoint{0.1 * k, 0.0}, {0.1 * k, 0.9}, {0.1 * k + 0.05, 0.9}, {0.1 * k + 0.05, 0.0}})
                crowded.tracks[2].push_back(point);
        Fixture f(crowded);
        f.view.zoomToFit();
        const QImage with = f.view.grab().toImage();
        Fixture empty(silent);
        empty.view.zoomToFit();
        const QImage without = empty.view.grab().toImage();
        for (int k = 0; k < kBursts; ++k) {
            QVERIFY2(painted(with, without, f.at(2, 0.1 * k + 0.025, 0.4)), qPrintable(QString::number(k)));
            QVERIFY2(!painted(with, without, f.at(2, 0.1 * k + 0.025, 0.99)), qPrintable(QString::number(k)));
        }
    }

    void theFigureHasItsNumbers() {
        Fixture f;
        const base::Figure figure = f.view.figure();
        const QStringList lines = figure.csv().split('\n');
        QVERIFY(lines[0].startsWith("time_s,t1,t2,t3,t4,t5,t6,predicted1"));
        bool found = false;
        for (const QString& line : lines)
            found = found || line.startsWith("0.5,0.8,");
        QVERIFY(found);
        QImage image(figure.size_px.toSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        figure.paint(painter);
        painter.end();
        bool ink = false;
        for (int x = 0; x < image.width() && !ink; ++x)
            ink = image.pixelColor(x, image.height() / 3) != QColor(Qt::white);
        QVERIFY(ink);
    }
};

namespace {
const test::Registration<TimelineViewTest> registration;
}
#include "timeline_view_test.moc"
