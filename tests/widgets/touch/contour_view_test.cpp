// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/touch/contour_view.h"

#include <QImage>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace teleta;
using touch::ContourView;

namespace {

pipeline::ExploredContour square() {
    pipeline::ExploredContour contour;
    contour.revision = 1;
    contour.height_m = 0.05;
    contour.points_m = {{0.1, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.1, 0.1}};
    contour.curve_m = {{0.1, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.1, 0.1}, {0.1, 0.0}};
    contour.recognition.emplace();
    contour.recognition->shape = contour::Shape::rectangle;
    contour.recognition->confidence = 0.934;
    contour.recognition->closed = true;
    contour.recognition->vertices_m = contour.points_m;
    return contour;
}

} // namespace

/// The explored contour from above.
class ContourViewTest : public QObject {
    Q_OBJECT

private slots:
    void saysWhatToDoWhileNothingWasExplored() {
        ContourView view;
        QVERIFY(view.accessibleDescription().contains("nothing explored yet"));
        QVERIFY(!view.picture().mapping(QSizeF(400, 300)));
        view.resize(400, 300);
        QVERIFY(!view.grab().isNull());
    }

    void namesShapeConfidenceAndMeasures() {
        ContourView view;
        view.setContour(square());
        QVERIFY(view.picture().headline().contains("rectangle"));
        QVERIFY(view.picture().headline().contains("93 %"));
        QVERIFY2(view.picture().details().contains("100"), qPrintable(view.picture().details()));
        QVERIFY(view.picture().details().contains("4 point"));
        pipeline::ExploredContour round = square();
        round.recognition->shape = contour::Shape::circle;
        round.recognition->vertices_m.clear();
        round.recognition->circle = contour::Circle{{0.15, 0.05}, 0.0707, 0.0};
        view.setContour(round);
        QVERIFY2(view.picture().details().contains("70.7"), qPrintable(view.picture().details()));
        QVERIFY(view.accessibleDescription().contains("circle"));
    }

    void namesTheShapesThatComeIntoQuestion() {
        ContourView view;
        pipeline::ExploredContour contour = square();
        contour.recognition->confidence = 0.52;
        contour.recognition->probability = {0.4, 0.52, 0.0, 0.0, 0.0, 0.0, 0.08};
        view.setContour(contour);
        QCOMPARE(view.picture().headline(), QString("undecided: rectangle (52 %) or circle (40 %)"));
    }

    void isToScaleWithYUpwards() {
        ContourView view;
        view.setContour(square());
        const auto mapping = view.picture().mapping(QSizeF(800, 300));
        QVERIFY(mapping.has_value());
        const QPointF origin = mapping->map(QPointF(0.1, 0.0));
        const QPointF right = mapping->map(QPointF(0.2, 0.0));
        const QPointF up = mapping->map(QPointF(0.1, 0.1));
        QVERIFY(std::abs((right.x() - origin.x()) - (origin.y() - up.y())) < 1e-6);
        QVERIFY(right.x() > origin.x());
        QVERIFY(up.y() < origin.y());
    }

    void drawsTheCurveWhereItIs() {
        for (const bool dark : {false, true}) {
            base::applyTheme(dark ? base::ThemeChoice::dark : base::ThemeChoice::light);
            ContourView view;
            view.resize(500, 400);
            pipeline::ExploredContour contour = square();
            contour.recognition.reset();
            view.setContour(contour);
            const QImage picture = view.grab().toImage();
            const auto mapping = view.picture().mapping(QSizeF(view.size()));
            const QPoint middle = mapping->map(QPointF(0.15, 0.1)).toPoint();
            const QColor curve = view.palette().color(QPalette::Link);
            bool found = false;
            for (int dy = -2; dy <= 2; ++dy)
                found = found || picture.pixelColor(middle + QPoint(0, dy)) == curve;
            QVERIFY(found);
        }
        base::applyTheme(base::ThemeChoice::light);
    }

    void drawsTheShapeThatWasRecognisedInFrontOfTheSpline() {
        ContourView view;
        view.resize(500, 400);
        view.setContour(square());
        const QImage picture = view.grab().toImage();
        const auto mapping = view.picture().mapping(QSizeF(view.size()));
        const QColor shape = base::statusColours(view.palette()).stale;
        int dashes = 0;
        for (double x_m = 0.11; x_m < 0.19; x_m += 0.0005) {
            const QPoint at = mapping->map(QPointF(x_m, 0.1)).toPoint();
            for (int dy = -1; dy <= 1; ++dy)
                dashes += picture.pixelColor(at + QPoint(0, dy)) == shape ? 1 : 0;
        }
        QVERIFY2(dashes > 20, qPrintable(QString::number(dashes)));
    }

    void aLargeCircleStaysInsideTheChart() {
        ContourView view;
        view.resize(500, 400);
        pipeline::ExploredContour arc;
        arc.revision = 1;
        arc.points_m = {{0.1, 0.0}, {0.1007, 0.01}, {0.1027, 0.02}};
        arc.curve_m = arc.points_m;
        arc.recognition.emplace();
        arc.recognition->shape = contour::Shape::arc;
        arc.recognition->confidence = 0.9;
        arc.recognition->circle = contour::Circle{{0.175, 0.0}, 0.075, 0.0};
        view.setContour(arc);
        const QImage picture = view.grab().toImage();
        // Below the heading, with room for the labels of the axes.
        const double em = QFontMetricsF(view.font()).height();
        const QRectF plot(4.0 * em, 4.3 * em, view.width() - 5.0 * em, view.height() - 6.5 * em);
        const QColor circle = base::statusColours(view.palette()).stale;
        int inside = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (picture.pixelColor(x, y) == circle) {
                    ++inside;
                    QVERIFY2(plot.adjusted(-2, -2, 2, 2).contains(x, y),
                             qPrintable(QString("%1, %2").arg(x).arg(y)));
                }
        QVERIFY(inside > 20);
    }

    void aSinglePointHasAPicture() {
        pipeline::ExploredContour one;
        one.points_m = {{0.3, -0.2}};
        ContourView view;
        view.resize(400, 300);
        view.setContour(one);
        QVERIFY(view.picture().mapping(QSizeF(view.size())).has_value());
        QVERIFY(!view.grab().isNull());
    }

    void savesPictureAndPoints() {
        const QTemporaryDir folder;
        ContourView view;
        view.resize(400, 300);
        view.setContour(square());
        const base::Figure figure = view.figure();
        view.clear(); // the figure is what it was
        QVERIFY(base::saveFigure(figure, folder.filePath("contour.svg")));
        QVERIFY(base::saveFigure(figure, folder.filePath("contour.csv")));
        QFile csv(folder.filePath("contour.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QCOMPARE(csv.readAll(), QByteArray("x_m,y_m\n0.1,0\n0.2,0\n0.2,0.1\n0.1,0.1\n"));
    }

    void numbersBelowZeroHaveATrueMinus() {
        pipeline::ExploredContour below = square();
        below.recognition.reset();
        for (auto* points : {&below.points_m, &below.curve_m})
            for (contour::Point& point : *points)
                point.y() -= 0.3;
        const QTemporaryDir folder;
        ContourView view;
        view.resize(400, 300);
        view.setContour(below);
        QVERIFY(base::saveFigure(view.figure(), folder.filePath("contour.svg")));
        QFile svg(folder.filePath("contour.svg"));
        QVERIFY(svg.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(svg.readAll());
        QVERIFY(text.contains(QStringLiteral(">\u2212250")));
        QVERIFY(!text.contains(QStringLiteral(">-")));
    }
};

static const test::Registration<ContourViewTest> kRegistration;
#include "contour_view_test.moc"
