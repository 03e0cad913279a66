// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/tactile/heatmap_layout.h"

#include <QApplication>
#include <QTest>

using namespace teleta::tactile;
using teleta::core::ArrayLayout;

namespace {

constexpr ArrayLayout kArray{6, 14, 0.0034};

HeatmapLayout layoutOf(const HeatmapZoom& zoom = {1.0, {7.0, 3.0}}, double ratio = 1.0) {
    return {QRectF(0, 0, 700, 420), QFontMetricsF(QApplication::font()), kArray, zoom, ratio};
}

} // namespace

class HeatmapLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void theFrameIsSeenFromOutsideWithXRightAndYUp() {
        const HeatmapLayout layout = layoutOf();
        QCOMPARE(layout.pixelOf(0.0, 0.0), layout.sensor().center());
        QVERIFY(layout.pixelOf(0.01, 0.0).x() > layout.pixelOf(0.0, 0.0).x());
        QVERIFY(layout.pixelOf(0.0, 0.01).y() < layout.pixelOf(0.0, 0.0).y());
        QVERIFY(layout.taxelRect({0, 0}).top() > layout.taxelRect({5, 0}).top());
    }

    void taxelCentresAreWhereTheArraySaysTheyAre() {
        const HeatmapLayout layout = layoutOf();
        for (const Taxel taxel : {Taxel{0, 0}, Taxel{5, 13}, Taxel{2, 7}}) {
            const QPointF centre = layout.pixelOf(kArray.x_m(taxel.column), kArray.y_m(taxel.row));
            QVERIFY((centre - layout.taxelRect(taxel).center()).manhattanLength() < 1e-6);
            QCOMPARE(layout.taxelAt(centre), std::optional(taxel));
        }
    }

    void taxelsAreSquareAndWholeDevicePixels_data() {
        QTest::addColumn<double>("ratio");
        for (const double ratio : {1.0, 1.25, 1.5, 2.0})
            QTest::addRow("ratio %g", ratio) << ratio;
    }
    void taxelsAreSquareAndWholeDevicePixels() {
        QFETCH(double, ratio);
        const HeatmapLayout layout = layoutOf({1.0, {7.0, 3.0}}, ratio);
        const double pixels = layout.taxelSide() * ratio;
        QVERIFY(std::abs(pixels - std::round(pixels)) < 1e-9);
        QCOMPARE(layout.sensor().width() / kArray.columns, layout.sensor().height() / kArray.rows);
        const double left = layout.sensor().left() * ratio;
        QVERIFY(std::abs(left - std::round(left)) < 1e-9);
    }

    void partsDoNotOverlap() {
        for (const HeatmapZoom& zoom : {HeatmapZoom{1.0, {7.0, 3.0}}, HeatmapZoom{4.0, {7.0, 3.0}}}) {
            const HeatmapLayout layout = layoutOf(zoom);
            const std::vector<QRectF> parts{layout.header(), layout.visible(), layout.colourBar(),
                                            layout.legend(), layout.readout()};
            for (std::size_t i = 0; i < parts.size(); ++i) {
                QVERIFY(QRectF(0, 0, 700, 420).contains(parts[i]));
                for (std::size_t j = i + 1; j < parts.size(); ++j)
                    QVERIFY2(!parts[i].intersects(parts[j]),
                             qPrintable(QStringLiteral("%1 and %2").arg(i).arg(j)));
            }
        }
    }

    void aNarrowArrayInALowViewHasItsLegendAndLabelsBesideIt() {
        const QRectF bounds(0, 0, 390, 210);
        const HeatmapLayout layout(bounds, QFontMetricsF(QApplication::font()), ArrayLayout{64, 27, 0.01},
                                   {1.0, {13.5, 32.0}}, 1.0);
        QVERIFY(layout.isLegendBeside());
        QVERIFY(layout.legend().left() > layout.colourBar().right());
        QVERIFY(layout.readout().left() > layout.colourBar().right());
        QVERIFY(layout.labels().left() >= layout.visible().right());
        const std::vector<QRectF> parts{layout.header(),    layout.visible(), layout.labels(),
                                        layout.colourBar(), layout.legend(),  layout.readout()};
        for (std::size_t i = 0; i < parts.size(); ++i) {
            QVERIFY2(bounds.contains(parts[i]), qPrintable(QString::number(i)));
            for (std::size_t j = i + 1; j < parts.size(); ++j)
                QVERIFY2(!parts[i].intersects(parts[j]),
                         qPrintable(QStringLiteral("%1 and %2").arg(i).arg(j)));
        }
        // A wide one keeps them below it.
        const HeatmapLayout wide(bounds, QFontMetricsF(QApplication::font()), kArray, {1.0, {7.0, 3.0}}, 1.0);
        QVERIFY(!wide.isLegendBeside());
        QVERIFY(wide.labels().isEmpty());
    }

    void aZoomedPictureStaysOnTheArray() {
        const HeatmapLayout layout = layoutOf({4.0, {-100.0, 100.0}});
        QVERIFY(std::abs(layout.sensor().left() - layout.visible().left()) < 1.0); // whole device pixels
        QVERIFY(std::abs(layout.sensor().top() - layout.visible().top()) < 1.0);
        QVERIFY(layout.sensor().width() > layout.visible().width());
    }

    void nothingIsUnderAPointOutside() {
        const HeatmapLayout layout = layoutOf();
        QVERIFY(!layout.taxelAt(layout.sensor().topLeft() - QPointF(2, 2)));
        QVERIFY(!layout.taxelAt(layout.colourBar().center()));
    }

    void aViewWithoutRoomHasADefinedLayout() {
        const HeatmapLayout layout(QRectF(0, 0, 10, 10), QFontMetricsF(QApplication::font()),
                                   ArrayLayout{256, 256, 0.001}, {1.0, {128.0, 128.0}}, 1.0);
        QVERIFY(layout.taxelSide() > 0.0);
        QVERIFY(std::isfinite(layout.colourBar().height()));
    }
};

static const teleta::test::Registration<HeatmapLayoutTest> registration;

#include "heatmap_layout_test.moc"
