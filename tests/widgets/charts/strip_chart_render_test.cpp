// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/sample_touch.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/charts/strip_chart_view.h"
#include "widgets/charts/strip_plot.h"

#include <QApplication>
#include <QPainter>
#include <QSet>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>

using namespace teleta;
using namespace teleta::charts;

namespace {

/// A view with the given strips, 10 s of a contact at 200 Hz, gone between 4 s and 6 s.
class Chart {
public:
    explicit Chart(const std::vector<Strip>& strips = {Strip::force, Strip::positionX}) {
        view.resize(900, 480);
        for (const Strip strip : kAllStrips)
            view.stripAction(strip)->setChecked(std::ranges::find(strips, strip) != strips.end());
        view.setLoadUnit(QStringLiteral("N"));
        view.show();
        QCoreApplication::processEvents();
    }
    void feed(double from_s, double to_s) {
        for (int i = qRound(from_s / 0.005); i < qRound(to_s / 0.005); ++i)
            view.append(test::rollingSample(0.005 * i, i < 800 || i >= 1200));
    }
    QImage draw() {
        view.refresh();
        QCoreApplication::processEvents();
        return view.plot()->grab().toImage();
    }
    /// The picture that leaves the program.
    QImage saved() {
        view.refresh();
        QCoreApplication::processEvents();
        const base::Figure figure = view.figure();
        QImage image(figure.size_px.toSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        figure.paint(painter);
        return image;
    }
    /// Coloured pixels (curves; axes and grid are grey) of a strip between two times before the right end.
    [[nodiscard]] int curvePixels(const QImage& image, Strip strip, double from_s, double to_s) const {
        const QRect rect = view.plot()->laneRect(strip);
        int found = 0;
        for (int x = qCeil(view.plot()->xOf(from_s)); x <= qFloor(view.plot()->xOf(to_s)); ++x)
            for (int y = rect.top() + 1; y < rect.bottom(); ++y)
                found += isCurve(image.pixel(x, y)) ? 1 : 0;
        return found;
    }
    static bool isCurve(QRgb pixel) { return QColor(pixel).hsvSaturation() > 60; }
    [[nodiscard]] QRgb colourOf(Strip strip, std::size_t series) const {
        return view.plot()->laneGraph(strip, series)->pen().color().rgb();
    }

    StripChartView view;
};

} // namespace

class StripChartRenderTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { base::applyTheme(base::ThemeChoice::light); }

    void undefinedValuesLeaveAGapInThePicture() {
        Chart chart;
        chart.feed(0.0, 10.0);
        const QImage image = chart.draw();
        QVERIFY(chart.curvePixels(image, Strip::positionX, -9.9, -6.1) > 100);
        QCOMPARE(chart.curvePixels(image, Strip::positionX, -5.9, -4.1), 0);
        QVERIFY(chart.curvePixels(image, Strip::positionX, -3.9, -0.1) > 100);
        // The force is known all the time: it is zero there.
        QVERIFY(chart.curvePixels(image, Strip::force, -5.9, -4.1) > 100);
    }

    void lostSamplesLeaveAGapInEveryStrip() {
        Chart chart;
        chart.feed(0.0, 2.0);
        chart.feed(7.0, 10.0);
        const QImage image = chart.draw();
        for (const Strip strip : {Strip::force, Strip::positionX})
            QCOMPARE(chart.curvePixels(image, strip, -7.9, -3.1), 0);
    }

    void aJumpIsADottedLineThroughAllStrips() {
        Chart chart;
        chart.feed(0.0, 2.0);
        const QImage before = chart.draw();
        pipeline::FeatureSample back = test::rollingSample(0.5, true);
        back.time_ns = 2'000'000'000;
        back.discontinuity = true;
        chart.view.append(back);
        chart.feed(0.505, 2.0);
        const QImage image = chart.draw();
        const double jump_s = -(1.995 - 0.5);
        const int x = qRound(chart.view.plot()->xOf(jump_s));
        for (const Strip strip : {Strip::force, Strip::positionX}) {
            const QRect rect = chart.view.plot()->laneRect(strip);
            int dots = 0;
            for (int y = rect.top(); y < rect.bottom(); ++y)
                dots += qGray(image.pixel(x, y)) < 160 ? 1 : 0;
            QVERIFY2(dots > rect.height() / 4, qPrintable(QString::number(dots)));
        }
    }

    void valuesLieAtTheirHeight() {
        Chart chart({Strip::force});
        for (int i = 0; i < 2000; ++i) {
            pipeline::FeatureSample sample = test::rollingSample(0.005 * i, true);
            sample.features.force_N = 3.0;
            sample.features.threshold_N = 1.3;
            chart.view.append(sample);
        }
        const QImage image = chart.draw();
        const QRect rect = chart.view.plot()->laneRect(Strip::force);
        const ValueRange range = chart.view.plot()->laneRange(Strip::force);
        QCOMPARE(range.low, 0.0);
        QVERIFY(range.high >= 5.0 * 1.3 && range.high <= 10.0);
        const double pad = 0.05 * range.high; // of each end
        const auto yOf = [&](double v) {
            return rect.bottom() - rect.height() * (v + pad) / (range.high + 2.0 * pad);
        };
        const int x = rect.center().x() + 7;
        bool found = false;
        for (int dy = -2; dy <= 2; ++dy)
            found = found || Chart::isCurve(image.pixel(x, qRound(yOf(3.0)) + dy));
        QVERIFY(found);
        // The threshold is dotted at its own height.
        const auto darkNear = [&](double value) {
            int dark = 0;
            for (int i = 0; i < 40; ++i)
                for (int dy = -1; dy <= 1; ++dy)
                    dark += qGray(image.pixel(x + i, qRound(yOf(value)) + dy)) < 215 ? 1 : 0;
            return dark;
        };
        QVERIFY2(darkNear(1.3) > 10 && darkNear(1.3) < 80, qPrintable(QString::number(darkNear(1.3))));
        QCOMPARE(darkNear(1.6), 0);
    }

    void forceIsShownFromZeroAndAnglesOverTheirWholeRange() {
        Chart chart({Strip::force, Strip::orientation});
        chart.feed(0.0, 3.0);
        chart.draw();
        QCOMPARE(chart.view.plot()->laneRange(Strip::force).low, 0.0);
        QVERIFY(std::abs(chart.view.plot()->laneRange(Strip::orientation).low + 90.0) < 1e-9);
        QVERIFY(std::abs(chart.view.plot()->laneRange(Strip::orientation).high - 90.0) < 1e-9);
    }

    void onlyAnArrayOfVectorsHasShear() {
        Chart chart({Strip::force, Strip::shear});
        QCOMPARE(chart.view.shownStrips(), std::vector{Strip::force});
        QVERIFY(!chart.view.stripAction(Strip::shear)->isVisible());
        chart.view.setVectors(true);
        QCOMPARE(chart.view.shownStrips(), (std::vector{Strip::force, Strip::shear}));
        pipeline::FeatureSample sample = test::rollingSample(0.5, true);
        sample.features.shear = contact::ShearLoad{0.25, -0.5, 0.0, 0.1};
        chart.view.append(sample);
        (void)chart.draw();
        const auto lines = chart.view.plot()->lanePanel(Strip::shear)->lines();
        QVERIFY2(lines[0].value.contains("0.25") && lines[0].value.endsWith("N"), qPrintable(lines[0].value));
        QVERIFY2(lines[1].value.contains("0.5"), qPrintable(lines[1].value));
        chart.view.setVectors(false);
        QCOMPARE(chart.view.shownStrips(), std::vector{Strip::force});
    }

    void millimetresAndDegreesAreShown() {
        Chart chart({Strip::positionX, Strip::orientation, Strip::spread});
        pipeline::FeatureSample sample = test::rollingSample(0.0, true);
        sample.features.copX_m = 0.0123;
        sample.features.alphaZ_rad = 0.5235987755982988; // pi / 6
        sample.features.lambda1_m2 = 25e-6;              // (5 mm)^2
        chart.view.append(sample);
        chart.draw();
        const auto value = [&](Strip strip) {
            return chart.view.plot()->lanePanel(strip)->lines().front().value.trimmed().remove(QChar(0x2007));
        };
        QCOMPARE(value(Strip::positionX), QStringLiteral("12.3\u00a0mm"));
        QCOMPARE(value(Strip::orientation), QStringLiteral("30.0\u00b0"));
        QCOMPARE(value(Strip::spread), QStringLiteral("5.00\u00a0mm"));
    }

    void undefinedIsADashBesideTheStrip() {
        Chart chart({Strip::force, Strip::positionX});
        chart.view.append(test::rollingSample(0.0, false));
        chart.draw();
        QVERIFY(
            chart.view.plot()->lanePanel(Strip::positionX)->lines().front().value.contains(QChar(0x2014)));
        QVERIFY(chart.view.plot()
                    ->lanePanel(Strip::force)
                    ->lines()
                    .front()
                    .value.contains(QStringLiteral("0.00")));
    }

    void allStripsHaveTheSameHeightAndTimeAxis() {
        Chart chart({Strip::force, Strip::positionX, Strip::dzmp, Strip::active});
        chart.draw();
        const QRect first = chart.view.plot()->laneRect(Strip::force);
        QVERIFY(first.height() > 40);
        for (const Strip strip : {Strip::positionX, Strip::dzmp, Strip::active}) {
            const QRect rect = chart.view.plot()->laneRect(strip);
            QVERIFY(std::abs(rect.height() - first.height()) <= 1);
            QCOMPARE(rect.left(), first.left());
            QCOMPARE(rect.right(), first.right());
        }
    }

    void theCurvesDoNotMoveSidewaysWhenTheNumbersGrow() {
        Chart chart({Strip::force});
        chart.feed(0.0, 1.0);
        chart.draw();
        const int left = chart.view.plot()->laneRect(Strip::force).left();
        pipeline::FeatureSample heavy = test::rollingSample(1.0, true);
        heavy.features.force_N = 987.0;
        chart.view.append(heavy);
        chart.draw();
        QCOMPARE(chart.view.plot()->laneRect(Strip::force).left(), left);
    }

    void aMarkIsALabelledLineInEveryStrip() {
        Chart chart;
        chart.feed(0.0, 10.0);
        const QImage before = chart.draw();
        QVERIFY(chart.view.addMark(8.0, QStringLiteral("bump")));
        const QImage after = chart.draw();
        const int x = qRound(chart.view.plot()->xOf(8.0 - 9.995));
        const QRgb accent = qApp->palette().color(QPalette::Highlight).rgb();
        for (const Strip strip : {Strip::force, Strip::positionX})
            QCOMPARE(after.pixel(x, chart.view.plot()->laneRect(strip).bottom() - 4), accent);
        QVERIFY(before.pixel(x, chart.view.plot()->laneRect(Strip::force).bottom() - 4) != accent);
    }

    void coloursFollowThePalette() {
        Chart chart;
        chart.feed(0.0, 2.0);
        const QImage light = chart.draw();
        const QRgb lightCurve = chart.colourOf(Strip::force, 0);
        base::applyTheme(base::ThemeChoice::dark);
        QCoreApplication::processEvents();
        const QImage dark = chart.draw();
        QVERIFY(qGray(light.pixel(2, light.height() / 2)) > 200);
        QVERIFY(qGray(dark.pixel(2, dark.height() / 2)) < 60);
        QVERIFY(chart.colourOf(Strip::force, 0) != lightCurve);
    }

    /// By a stripe on the screen, by the word in a picture that leaves the program.
    void dataThatAreNotLiveAreLabelledInTheirColour() {
        Chart chart;
        chart.feed(0.0, 1.0);
        const base::StatusColours& colours = base::statusColours(qApp->palette());
        const auto has = [&](const QImage& image, const QColor& colour) {
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < image.width(); ++x)
                    if (image.pixel(x, y) == colour.rgb())
                        return true;
            return false;
        };
        const auto hasViolet = [&](const QImage& image) { return has(image, colours.simulated); };
        QVERIFY(!hasViolet(chart.saved()));
        QVERIFY(!hasViolet(chart.view.grab().toImage()));
        chart.view.setProvenance(base::Provenance::simulated);
        QVERIFY(hasViolet(chart.saved()));
        QVERIFY(!hasViolet(chart.draw()));
        QVERIFY(hasViolet(chart.view.grab().toImage()));
        chart.view.setProvenance(base::Provenance::recorded);
        QVERIFY(has(chart.saved(), colours.recorded));
        QVERIFY(!hasViolet(chart.saved()));
    }

    void theBadgeSpeaksTheLanguageOfNow() {
        Chart chart;
        chart.feed(0.0, 1.0);
        chart.view.setProvenance(base::Provenance::simulated);
        const QImage before = chart.saved();
        struct Long : QTranslator {
            bool isEmpty() const override { return false; }
            QString translate(const char*, const char* text, const char*, int) const override {
                return QLatin1String(text) == QLatin1String("SIMULATED") ? QStringLiteral("S I M U L A T E D")
                                                                         : QString();
            }
        } translator;
        QCoreApplication::installTranslator(&translator);
        QTRY_VERIFY(chart.saved() != before);
        QCoreApplication::removeTranslator(&translator);
        QTRY_VERIFY(chart.saved() == before);
    }

    void thePictureForPaperIsOnWhiteAlsoFromADarkScreen() {
        base::applyTheme(base::ThemeChoice::dark);
        Chart chart;
        chart.feed(0.0, 10.0);
        const QImage screen = chart.draw();
        const base::Figure figure = chart.view.figure();
        QImage paper(figure.size_px.toSize(), QImage::Format_RGB32);
        paper.fill(Qt::white);
        QPainter painter(&paper);
        figure.paint(painter);
        painter.end();
        QCOMPARE(paper.pixel(2, paper.height() / 2), qRgb(255, 255, 255));
        const QRect rect = chart.view.plot()->laneRect(Strip::force);
        QSet<QRgb> colours;
        for (int y = rect.top(); y < rect.bottom(); ++y)
            colours.insert(paper.pixel(rect.center().x(), y));
        QVERIFY(colours.size() > 2);
        QCOMPARE(chart.draw(), screen); // the screen is as it was
    }

    void thePictureIsVectorArt() {
        Chart chart;
        chart.feed(0.0, 10.0);
        chart.draw();
        QTemporaryDir directory;
        const QString path = directory.filePath(QStringLiteral("chart.svg"));
        QVERIFY(base::saveFigure(chart.view.figure(), path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray svg = file.readAll();
        QVERIFY(QSvgRenderer(path).isValid());
        QVERIFY(svg.count("<polyline") + svg.count("<path") > 20);
        QVERIFY(svg.count("<image") == 0);
        QVERIFY(svg.contains("threshold"));
    }

    void noStripAtAllIsAPictureToo() {
        Chart chart(std::vector<Strip>{});
        chart.feed(0.0, 1.0);
        QVERIFY(!chart.draw().isNull());
        QCOMPARE(chart.view.plot()->timeAt(100.0), 0.0);
    }
};

static const teleta::test::Registration<StripChartRenderTest> registration;

#include "strip_chart_render_test.moc"
