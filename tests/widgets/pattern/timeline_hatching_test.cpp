// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/timeline/timeline_view.h"

#include <QImage>
#include <QPixmap>
#include <QTest>

using namespace teleta;
using namespace teleta::pattern;

namespace {

/// Hatched pixels of a stretch, of its neighbours down to the left, and of those down to the right.
struct Hatching {
    int pixels = 0;
    int hatched = 0;
    int downLeft = 0;
    int downRight = 0;
};

Hatching hatchingOf(const QImage& image, const QRect& place, QRgb colour) {
    Hatching found;
    for (int y = place.top(); y < place.bottom(); ++y)
        for (int x = place.left() + 1; x < place.right(); ++x) {
            ++found.pixels;
            if (image.pixel(x, y) != colour)
                continue;
            ++found.hatched;
            found.downLeft += image.pixel(x - 1, y + 1) == colour ? 1 : 0;
            found.downRight += image.pixel(x + 1, y + 1) == colour ? 1 : 0;
        }
    return found;
}

struct Desk {
    explicit Desk(bool dark) {
        view.setPalette(base::designedPalette(dark));
        view.resize(900, 520);
        view.show();
    }
    [[nodiscard]] QImage picture() { return view.grab().toImage().convertToFormat(QImage::Format_RGB32); }
    [[nodiscard]] QRgb colour() const { return base::statusColours(view.palette()).stale.rgb(); }
    /// Of the first lane.
    [[nodiscard]] QRect place(Span span, double low, double high) const {
        const TimelineGeometry geometry = view.geometryNow();
        return QRectF(QPointF(geometry.xOf(span.begin_s), geometry.yOf(0, high)),
                      QPointF(geometry.xOf(span.end_s), geometry.yOf(0, low)))
            .toRect();
    }

    PatternDocument document;
    TimelineView view{&document};
};

} // namespace

/// Lines, not colour alone, tell where a motor cannot follow.
class TimelineHatchingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }

    void diagonalLinesFillWhatTheMotorCannotFollow() {
        QFETCH_GLOBAL(bool, dark);
        Desk desk(dark);
        Pattern step;
        step.id = "mine.step";
        step.duration_s = 4.0;
        step.tracks[0] = {{0.0, 1.0}, {4.0, 1.0}};
        MotorProfiles slow = assumedMotors();
        slow[0].riseTime_s = 0.5;
        desk.document.setMotors(slow);
        desk.document.setPattern(step);
        desk.view.showSpan(0.0, 4.0);
        const QImage picture = desk.picture();
        // The prediction is below 0.42 until 0.2 s.
        const Hatching behind = hatchingOf(picture, desk.place({0.02, 0.2}, 0.5, 0.9), desk.colour());
        QVERIFY(behind.pixels > 300);
        QVERIFY2(behind.hatched > behind.pixels / 20 && behind.hatched < behind.pixels / 2,
                 qPrintable(QStringLiteral("%1 of %2").arg(behind.hatched).arg(behind.pixels)));
        QVERIFY(behind.downLeft > 9 * behind.hatched / 10);
        QVERIFY(behind.downRight < behind.hatched / 10);
        const Hatching there = hatchingOf(picture, desk.place({3.0, 3.8}, 0.1, 0.9), desk.colour());
        QVERIFY(there.pixels > 300);
        QCOMPARE(there.hatched, 0);
    }

    /// Far zoomed out: a strip along the floor of the lane.
    void aStripOfDiagonalLinesMarksWhereBurstsAreTooShort() {
        QFETCH_GLOBAL(bool, dark);
        Desk desk(dark);
        Pattern bursts;
        bursts.id = "mine.bursts";
        bursts.duration_s = 1200.0;
        for (int k = 0; k < 600; ++k) {
            const double begin_s = k;
            bursts.tracks[0].insert(
                bursts.tracks[0].end(),
                {{begin_s, 0.0}, {begin_s, 1.0}, {begin_s + 0.02, 1.0}, {begin_s + 0.02, 0.0}});
        }
        desk.document.setPattern(bursts);
        desk.view.zoomToFit();
        // The floor's own line and the upper edge are left out.
        const double em = desk.view.geometryNow().em * desk.view.geometryNow().intensityPerPixel();
        const double low = 0.1 * em;
        const double high = 0.33 * em;
        Hatching marked;
        QImage picture;
        QTRY_VERIFY_WITH_TIMEOUT(
            (picture = desk.picture(),
             marked = hatchingOf(picture, desk.place({50.0, 550.0}, low, high), desk.colour()),
             marked.hatched > 0),
            60'000);
        QVERIFY(marked.pixels > 300);
        QVERIFY2(marked.hatched > marked.pixels / 20 && marked.hatched < marked.pixels / 2,
                 qPrintable(QStringLiteral("%1 of %2").arg(marked.hatched).arg(marked.pixels)));
        QVERIFY(marked.downLeft > 8 * marked.hatched / 10);
        QVERIFY(marked.downRight < marked.hatched / 5);
        QCOMPARE(hatchingOf(picture, desk.place({650.0, 1150.0}, low, high), desk.colour()).hatched, 0);
    }
};

namespace {
const test::Registration<TimelineHatchingTest> registration;
}
#include "timeline_hatching_test.moc"
