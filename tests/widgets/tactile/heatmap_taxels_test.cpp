// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/taxels/frame_analysis.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/colour_maps.h"
#include "widgets/tactile/heatmap_view.h"

#include <QApplication>
#include <QTest>

#include <memory>
#include <vector>

using namespace teleta;
using namespace teleta::tactile;
using Overlay = HeatmapView::Overlay;
using core::ArrayLayout;
using core::TaxelLayout;
using core::TaxelPlace;
using core::TaxelPlaces;

namespace {

pipeline::TouchSnapshot snapshotOf(const TaxelLayout& layout, const std::vector<float>& raw) {
    contact::FrameAnalysis analysis(layout);
    pipeline::TouchSnapshot snapshot;
    snapshot.layout = layout;
    snapshot.loadUnit = std::string("N");
    analysis.analyse(raw, 0.0, snapshot);
    snapshot.labels.assign(analysis.labels().begin(), analysis.labels().end());
    snapshot.threshold_N = snapshot.features.threshold_N;
    return snapshot;
}

/// A triangle of taxels, 10 mm apart along x.
TaxelLayout triangle(int components = 1) {
    return TaxelLayout(std::make_shared<const TaxelPlaces>(
                           std::vector<TaxelPlace>{{-0.005, -0.004}, {0.005, -0.004}, {0.0, 0.006}}),
                       components);
}

class View {
public:
    explicit View(const pipeline::TouchSnapshot& snapshot, bool shear = false) {
        view.resize(760, 460);
        for (const Overlay overlay : {Overlay::contacts, Overlay::centreOfPressure, Overlay::centreOfContact,
                                      Overlay::principalAxis, Overlay::values, Overlay::shear})
            view.overlayAction(overlay)->setChecked(shear && overlay == Overlay::shear);
        view.setSnapshot(snapshot);
        image = view.grab().toImage();
    }
    [[nodiscard]] QRgb at(const QPointF& pixel) const {
        return image.pixel(static_cast<int>(pixel.x() * image.devicePixelRatio()),
                           static_cast<int>(pixel.y() * image.devicePixelRatio()));
    }
    [[nodiscard]] QString csv() { return QString::fromUtf8(view.figure().csv().toUtf8()); }

    HeatmapView view;
    QImage image;
};

QRgb ground() {
    return qApp->palette().color(QPalette::Base).rgb();
}

} // namespace

class HeatmapTaxelsTest : public QObject {
    Q_OBJECT
private slots:
    void cellsHaveTheShapeOfTheArrays() {
        const ArrayLayout array{3, 4, 0.004, 0.010};
        const HeatmapLayout layout(QRectF(0, 0, 700, 420), QFontMetricsF(QApplication::font()), array,
                                   {1.0, {2.0, 1.5}}, 1.0);
        const QRectF cell = layout.taxelRect({1, 2});
        QVERIFY(std::abs(cell.height() / cell.width() - 2.5) < 1e-9);
        QCOMPARE(layout.taxelSide(), cell.width());
        QCOMPARE(cell.width(), std::round(cell.width()));
        for (const Taxel taxel : {Taxel{0, 0}, Taxel{2, 3}, Taxel{1, 2}}) {
            const QPointF centre = layout.pixelOf(array.x_m(taxel.column), array.y_m(taxel.row));
            QVERIFY((centre - layout.taxelRect(taxel).center()).manhattanLength() < 1e-6);
            QCOMPARE(layout.taxelAt(centre), std::optional(taxel));
        }
        QVERIFY(layout.visible().contains(layout.sensor().adjusted(1, 1, -1, -1)));
    }

    void taxelsOffAGridAreDiscsWhereTheyStand() {
        const TaxelLayout layout = triangle();
        View picture(snapshotOf(layout, {1.0F, 0.0F, 0.5F}));
        const HeatmapLayout map = picture.view.layoutNow();
        for (int taxel = 0; taxel < 3; ++taxel) {
            const auto i = static_cast<std::size_t>(taxel);
            const QPointF centre = map.pixelOf(layout.x_m(i), layout.y_m(i));
            QCOMPARE(map.taxelAt(centre), std::optional(Taxel{0, taxel}));
            QVERIFY(map.visible().contains(map.taxelRect({0, taxel}).adjusted(1, 1, -1, -1)));
            QVERIFY(std::abs(map.taxelRect({0, taxel}).width() -
                             map.perMetre() * layout.places()->spacing_m(i)) < 1e-6);
        }
        const base::ColourMap& map1 = base::cividis();
        const double top = picture.view.rangeTop();
        QCOMPARE(picture.at(map.pixelOf(-0.005, -0.004)), base::colourAt(map1, 1.0 / top));
        QCOMPARE(picture.at(map.pixelOf(0.005, -0.004)), base::colourAt(map1, 0.0));
        QCOMPARE(picture.at(map.pixelOf(0.0, 0.006)), base::colourAt(map1, 0.5 / top));
        QCOMPARE(map.taxelAt(map.pixelOf(0.009, 0.006)), std::nullopt);
        QCOMPARE(picture.at(map.pixelOf(0.009, 0.006)), ground());
    }

    void theReadOutNamesATaxelOffAGridByItsNumber() {
        View picture(snapshotOf(triangle(), {1.0F, 0.0F, 0.5F}));
        QTest::keyClick(&picture.view, Qt::Key_Right);
        QTest::keyClick(&picture.view, Qt::Key_Right);
        QCOMPARE(picture.view.cursorTaxel(), std::optional(Taxel{0, 2}));
        QVERIFY2(picture.view.readout().startsWith(QStringLiteral("taxel 2 ")),
                 qPrintable(picture.view.readout()));
        QTest::keyClick(&picture.view, Qt::Key_Up);
        QCOMPARE(picture.view.cursorTaxel(), std::optional(Taxel{0, 2}));
        QVERIFY2(picture.csv().startsWith(
                     QStringLiteral("taxel,x_m,y_m,load_n,dead,contact_id\n0,-0.005,-0.004,1,0,1\n")),
                 qPrintable(picture.csv()));
    }

    void aSingleTaxelAndALineOfTaxelsHaveRoom() {
        for (const auto& places : {std::vector<TaxelPlace>{{0.0, 0.0}},
                                   std::vector<TaxelPlace>{{-0.01, 0.0}, {0.0, 0.001}, {0.012, 0.0}}}) {
            const TaxelLayout layout(std::make_shared<const TaxelPlaces>(places));
            const View picture(snapshotOf(layout, std::vector<float>(places.size(), 1.0F)));
            const HeatmapLayout map = picture.view.layoutNow();
            for (std::size_t i = 0; i < places.size(); ++i) {
                const QRectF disc = map.taxelRect({0, static_cast<int>(i)});
                QVERIFY(disc.width() >= 8.0);
                QVERIFY(picture.at(disc.center()) != ground());
            }
        }
    }

    void aPlaceWithoutATaxelHasTheColourOfTheGround() {
        TaxelLayout layout(ArrayLayout{2, 2, 0.004});
        layout.setAbsent({0, 1, 0, 0});
        View picture(snapshotOf(layout, {1.0F, std::nanf(""), 0.0F, 0.0F}));
        const HeatmapLayout map = picture.view.layoutNow();
        QCOMPARE(picture.at(map.taxelRect({0, 1}).center()), ground());
        QVERIFY(picture.at(map.taxelRect({1, 1}).center()) != ground());
        QCOMPARE(picture.csv().count(QLatin1Char('\n')), 4); // the heading and three taxels
    }

    void shearIsAnArrowWhoseLengthIsItsSize() {
        const TaxelLayout layout(ArrayLayout{1, 3, 0.004}, 3);
        // The middle taxel is pushed along x, the others along -y.
        const pipeline::TouchSnapshot snapshot =
            snapshotOf(layout, {0.0F, -0.2F, -1.0F, 0.5F, 0.0F, -2.0F, 0.0F, -0.2F, -1.0F});
        const View with(snapshot, true);
        const View without(snapshot);
        const HeatmapLayout map = with.view.layoutNow();
        const QPointF centre = map.taxelRect({0, 1}).center();
        const double side = map.taxelSide();
        // The longest arrow is as long as a taxel is wide: 0.5 N.
        for (const double share : {-0.45, 0.0, 0.45}) {
            const QPointF on = centre + QPointF(share * side, 0.0);
            QVERIFY(qGray(with.at(on)) > 240);
            QVERIFY(qGray(without.at(on)) <= 240);
        }
        const auto isWhite = [&](const QPointF& on) { return qGray(with.at(on)) > 240; };
        QVERIFY(!isWhite(centre + QPointF(0.0, 0.3 * side)));
        // 0.2 N: from 0.2 taxels above the centre to 0.2 below. The head, at most 12 px long, is below.
        const QPointF left = map.taxelRect({0, 0}).center();
        QVERIFY(isWhite(left + QPointF(0.0, 0.15 * side)) && isWhite(left - QPointF(0.0, 0.15 * side)));
        QVERIFY(!isWhite(left + QPointF(0.0, 0.3 * side)) && !isWhite(left - QPointF(0.0, 0.3 * side)));
        const QPointF barb(-3.6, 0.2 * side - 6.0);
        QVERIFY2(isWhite(left + barb) && !isWhite(left - barb), "-y points down");
        QVERIFY(with.image.copy(map.legend().toRect()) != without.image.copy(map.legend().toRect()));
        QVERIFY(with.image.copy(map.header().toRect()) != without.image.copy(map.header().toRect()));
    }

    void aLegendBesideTheArrayHasTheLengthOfTheArrows() {
        const TaxelLayout layout(ArrayLayout{2, 2, 0.004}, 3);
        std::vector<float> raw(layout.values(), -1.0F);
        const View with(snapshotOf(layout, raw), true);
        const View without(snapshotOf(layout, raw));
        const HeatmapLayout map = with.view.layoutNow();
        QVERIFY(map.isLegendBeside());
        QVERIFY(with.image.copy(map.legend().toRect()) != without.image.copy(map.legend().toRect()));
    }

    /// Sizes of the heatmap in a window of 1024 x 700: of a source with an arm, and without.
    void theWholeLegendHasRoomInASmallWindow_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("with an arm") << QSize(244, 265);
        QTest::newRow("without") << QSize(376, 265);
    }
    void theWholeLegendHasRoomInASmallWindow() {
        QFETCH(QSize, size);
        const TaxelLayout layout(ArrayLayout{4, 14, 0.004}, 3);
        std::vector<float> raw(layout.values(), 0.1F);
        for (std::size_t i = 2; i < raw.size(); i += 3)
            raw[i] = -1.0F;
        pipeline::TouchSnapshot snapshot = snapshotOf(layout, raw);
        snapshot.features.dead = 1;
        HeatmapView view;
        view.resize(size);
        view.setSnapshot(snapshot);
        const HeatmapLayout map = view.layoutNow();
        QVERIFY(!map.isLegendBeside());
        QVERIFY(map.taxelSide() >= 6.0); // or else there are no arrows
        QVERIFY(map.legend().top() > map.visible().bottom());
        const auto legend = [&] { return view.grab().toImage().copy(map.legend().toRect()); };
        const QImage whole = legend();
        for (const Overlay overlay :
             {Overlay::centreOfPressure, Overlay::centreOfContact, Overlay::principalAxis, Overlay::shear}) {
            view.overlayAction(overlay)->setChecked(false);
            QVERIFY2(legend() != whole, qPrintable(view.overlayAction(overlay)->text()));
            view.overlayAction(overlay)->setChecked(true);
        }
        // The last of all; that of the shear is not cut.
        snapshot.features.dead = 2;
        view.setSnapshot(snapshot);
        QVERIFY(legend() != whole);
    }

    void shearStandsInTheReadOutAndInTheData() {
        View picture(snapshotOf(TaxelLayout(ArrayLayout{1, 1, 0.004}, 3), {0.3F, -0.4F, -1.0F}));
        QTest::keyClick(&picture.view, Qt::Key_Right);
        QVERIFY2(picture.view.readout().simplified().contains(QStringLiteral("shear 0.50 N")),
                 qPrintable(picture.view.readout()));
        QVERIFY2(picture.view.readout()
                     .simplified()
                     .replace(QChar(0xA0), QLatin1Char(' '))
                     .contains(QStringLiteral("contact #1 with shear 0.50 N, friction 0.50")),
                 qPrintable(picture.view.readout()));
        QVERIFY2(
            picture.csv().startsWith(QStringLiteral("row,column,x_m,y_m,load_n,shear_x_n,shear_y_n,dead,"
                                                    "contact_id\n0,0,0,0,1,0.300000012,-0.400000006,0,1\n")),
            qPrintable(picture.csv()));
    }

    void arraysOfLoadsShowNoShear() {
        const pipeline::TouchSnapshot snapshot =
            snapshotOf(TaxelLayout(ArrayLayout{1, 2, 0.004}), {1.0F, 0.5F});
        const View with(snapshot, true);
        const View without(snapshot);
        QCOMPARE(with.image, without.image);
    }

    void aSnapshotWithoutItsShearIsRefused() {
        pipeline::TouchSnapshot snapshot =
            snapshotOf(TaxelLayout(ArrayLayout{1, 1, 0.004}, 3), {0.0F, 0.0F, -1.0F});
        QVERIFY(isConsistent(snapshot));
        snapshot.shearY_N.clear();
        QVERIFY(!isConsistent(snapshot));
    }
};

static const teleta::test::Registration<HeatmapTaxelsTest> registration;

#include "heatmap_taxels_test.moc"
