// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/input_events.h"
#include "tests/widgets/sample_touch.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"
#include "widgets/tactile/heatmap_view.h"

#include <QApplication>
#include <QPainter>
#include <QSet>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>

#include <numbers>

using namespace teleta;
using namespace teleta::tactile;
using Overlay = HeatmapView::Overlay;

namespace {

constexpr core::ArrayLayout kArray{6, 14, 0.0034};
constexpr QSize kSize(760, 460);

/// A view in which only the named overlays are on.
class Picture {
public:
    explicit Picture(const pipeline::TouchSnapshot& snapshot, std::initializer_list<Overlay> on = {}) {
        view.resize(kSize);
        for (const Overlay overlay : {Overlay::contacts, Overlay::centreOfPressure, Overlay::centreOfContact,
                                      Overlay::principalAxis, Overlay::values})
            view.overlayAction(overlay)->setChecked(std::ranges::find(on, overlay) != on.end());
        view.setSnapshot(snapshot);
        image = view.grab().toImage();
    }
    [[nodiscard]] QRgb at(const QPointF& pixel) const {
        return image.pixel(static_cast<int>(pixel.x() * image.devicePixelRatio()),
                           static_cast<int>(pixel.y() * image.devicePixelRatio()));
    }
    /// Colour in the middle of a taxel.
    [[nodiscard]] QRgb taxel(int row, int column) const {
        return at(view.layoutNow().taxelRect({row, column}).center());
    }
    /// Brightest pixel within one pixel: a thin line lies between two.
    [[nodiscard]] int brightnessNear(const QPointF& pixel) const {
        int brightest = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                brightest = std::max(brightest, qGray(at(pixel + QPointF(dx, dy))));
        return brightest;
    }
    /// Whether a border in the colour of this contact begins within five pixels.
    [[nodiscard]] bool hasBorder(int id, const QPointF& from, const QPointF& inwards) const {
        const QRgb identity = base::identityColour(id, true).rgb();
        for (int d = 0; d < 5; ++d)
            if (at(from + inwards * d) == identity)
                return true;
        return false;
    }
    [[nodiscard]] QSet<QRgb> coloursIn(const QRectF& rect) const {
        QSet<QRgb> colours;
        for (int y = qCeil(rect.top()); y < qFloor(rect.bottom()); ++y)
            for (int x = qCeil(rect.left()); x < qFloor(rect.right()); ++x)
                colours.insert(image.pixel(x, y));
        return colours;
    }
    /// The array without what is around it.
    [[nodiscard]] QImage array() const { return image.copy(view.layoutNow().visible().toRect()); }

    HeatmapView view;
    QImage image;
};

pipeline::TouchSnapshot ramp() {
    std::vector<float> load_N(kArray.taxels());
    for (std::size_t i = 0; i < load_N.size(); ++i)
        load_N[i] = 0.02F * static_cast<float>(i);
    return test::snapshotOf(kArray, load_N);
}

/// A straight edge contact: a rotated, narrow hill in the middle.
pipeline::TouchSnapshot edge(double angle_rad) {
    return test::snapshotOf(kArray, test::hills(kArray, {{0.0, 0.0, 2.0, 0.006, 0.0015, angle_rad}}));
}

} // namespace

class HeatmapRenderTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { base::applyTheme(base::ThemeChoice::light); }

    void everyTaxelHasTheColourOfItsLoad() {
        const Picture picture(ramp());
        const double top = picture.view.rangeTop();
        for (int row = 0; row < kArray.rows; ++row)
            for (int column = 0; column < kArray.columns; ++column) {
                const double load = 0.02 * (row * kArray.columns + column);
                const auto entry = static_cast<std::size_t>(255.0 * load / top);
                const QRgb seen = picture.taxel(row, column);
                QVERIFY2(seen == base::cividis()[entry] ||
                             seen == base::cividis()[std::min<std::size_t>(entry + 1, 255)],
                         qPrintable(QStringLiteral("row %1 column %2").arg(row).arg(column)));
            }
    }

    void theLargestLoadIsTheBrightestTaxel() {
        const Picture picture(
            test::snapshotOf(kArray, test::hills(kArray, {{kArray.x_m(4), kArray.y_m(4), 1.0}})));
        int brightest = -1;
        Taxel where;
        for (int row = 0; row < kArray.rows; ++row)
            for (int column = 0; column < kArray.columns; ++column)
                if (qGray(picture.taxel(row, column)) > brightest) {
                    brightest = qGray(picture.taxel(row, column));
                    where = {row, column};
                }
        QCOMPARE(where, (Taxel{4, 4}));
    }

    void aFixedRangeMapsItsEndToTheLastColour() {
        Picture picture(ramp());
        picture.view.setFixedRange(0.8);
        picture.image = picture.view.grab().toImage();
        QCOMPARE(picture.taxel(2, 12), base::cividis().back()); // 0.8 N
        QCOMPARE(picture.taxel(5, 13), base::cividis().back()); // beyond
        QVERIFY(picture.taxel(2, 0) != base::cividis().back()); // 0.56 N
    }

    void loadsBeyondAFixedRangeAreMarkedOnTheBar() {
        Picture picture(ramp());
        const QRectF bar = picture.view.layoutNow().colourBar();
        const QPointF tip(bar.center().x(), bar.top() - 2.0);
        const QRgb ground = qApp->palette().color(QPalette::Base).rgb();
        QCOMPARE(picture.at(tip), ground);
        picture.view.setFixedRange(0.8);
        picture.image = picture.view.grab().toImage();
        QVERIFY(picture.at(tip) != ground);
    }

    void theScaleOfTheLoadsDoesNotMatter_data() {
        QTest::addColumn<double>("scale");
        for (const double scale : {1e-12, 1.0, 1e12})
            QTest::addRow("%g", scale) << scale;
    }
    void theScaleOfTheLoadsDoesNotMatter() {
        QFETCH(double, scale);
        pipeline::TouchSnapshot snapshot = ramp();
        for (float& load : snapshot.load_N)
            load *= static_cast<float>(scale);
        snapshot.features.peak_N *= scale;
        snapshot.threshold_N *= scale;
        const Picture picture(snapshot);
        QVERIFY(std::abs(picture.view.rangeTop() / scale - 2.0) < 1e-6); // peak 1.66: the next round number
        QVERIFY(qGray(picture.taxel(5, 13)) > 2 * qGray(picture.taxel(0, 0)));
    }

    void deadTaxelsAreHatchedAndCounted() {
        std::vector<std::uint8_t> dead(kArray.taxels(), 0);
        dead[static_cast<std::size_t>(2 * kArray.columns + 5)] = 1;
        const Picture picture(test::snapshotOf(kArray, std::vector<float>(kArray.taxels(), 0.0F), dead));
        const HeatmapLayout layout = picture.view.layoutNow();
        const auto inner = [&](int row, int column) {
            return layout.taxelRect({row, column}).adjusted(3, 3, -3, -3);
        };
        QCOMPARE(picture.coloursIn(inner(2, 4)).size(), qsizetype(1));
        const QSet<QRgb> hatched = picture.coloursIn(inner(2, 5));
        QVERIFY(hatched.size() > 2);
        QVERIFY(!hatched.contains(base::cividis().front()));
        QVERIFY(picture.coloursIn(layout.legend()).size() > 2);

        const Picture whole(test::snapshotOf(kArray, std::vector<float>(kArray.taxels(), 0.0F)));
        QVERIFY(picture.image.copy(layout.legend().toRect()) != whole.image.copy(layout.legend().toRect()));
    }

    void theLastFrameOfASourceThatIsSilentIsFaded() {
        Picture picture(ramp());
        const QRgb ground = qApp->palette().color(QPalette::Window).rgb();
        const auto distance = [&](QRgb colour) {
            return std::abs(qRed(colour) - qRed(ground)) + std::abs(qGreen(colour) - qGreen(ground)) +
                   std::abs(qBlue(colour) - qBlue(ground));
        };
        const QRgb before = picture.taxel(0, 0);
        picture.view.setOld(true);
        picture.image = picture.view.grab().toImage();
        QVERIFY(4 * distance(picture.taxel(0, 0)) < 2 * distance(before));
        picture.view.setOld(false);
        picture.image = picture.view.grab().toImage();
        QCOMPARE(picture.taxel(0, 0), before);
    }

    void theCentreOfPressureIsACrossAtItsPlace() {
        pipeline::TouchSnapshot snapshot = ramp();
        snapshot.features.copX_m = 0.008;
        snapshot.features.copY_m = -0.004;
        const Picture picture(snapshot, {Overlay::centreOfPressure});
        const QPointF centre = picture.view.layoutNow().pixelOf(0.008, -0.004);
        QCOMPARE(picture.at(centre), qRgb(255, 255, 255));
        const Picture without(snapshot);
        QVERIFY(without.at(centre) != qRgb(255, 255, 255));
        for (const QPointF& arm : {QPointF(4, 4), QPointF(-4, 4), QPointF(4, -4), QPointF(-4, -4)})
            QVERIFY(qGray(picture.at(centre + arm)) > 200);
        for (const QPointF& gap : {QPointF(6, 0), QPointF(0, 6), QPointF(-6, 0), QPointF(0, -6)})
            QVERIFY(qGray(picture.at(centre + gap)) < 200);
    }

    void theCentreOfContactIsARing() {
        pipeline::TouchSnapshot snapshot =
            test::snapshotOf(kArray, std::vector<float>(kArray.taxels(), 0.0F));
        snapshot.features.cocX_m = kArray.x_m(3);
        snapshot.features.cocY_m = kArray.y_m(3);
        const Picture picture(snapshot, {Overlay::centreOfContact});
        const QPointF centre = picture.view.layoutNow().pixelOf(kArray.x_m(3), kArray.y_m(3));
        QCOMPARE(picture.at(centre), base::cividis().front());
        int bright = 0; // the ring is met once to each side
        for (int x = 0; x < 15; ++x)
            bright += qGray(picture.at(centre + QPointF(x, 0))) > 200 ? 1 : 0;
        QVERIFY(bright >= 1 && bright <= 4);
    }

    void whatIsUndefinedIsNotDrawn() {
        const pipeline::TouchSnapshot untouched =
            test::snapshotOf(kArray, std::vector<float>(kArray.taxels(), 0.0F));
        QVERIFY(!untouched.features.cocX_m);
        const Picture all(untouched, {Overlay::contacts, Overlay::centreOfPressure, Overlay::centreOfContact,
                                      Overlay::principalAxis});
        QCOMPARE(all.array(), Picture(untouched).array());
    }

    void thePrincipalAxisRunsAlongTheContact_data() {
        QTest::addColumn<double>("angle_deg");
        for (const double angle : {-60.0, 0.0, 30.0, 90.0})
            QTest::addRow("%g degrees", angle) << angle;
    }
    void thePrincipalAxisRunsAlongTheContact() {
        QFETCH(double, angle_deg);
        pipeline::TouchSnapshot snapshot = edge(0.0);
        const double angle = angle_deg * std::numbers::pi / 180.0;
        snapshot.features.alphaZ_rad = angle;
        const Picture picture(snapshot, {Overlay::principalAxis});
        const QPointF centre =
            picture.view.layoutNow().pixelOf(*snapshot.features.cocX_m, *snapshot.features.cocY_m);
        const QPointF along(std::cos(angle), -std::sin(angle)); // y up
        const double reach = 1.5 * picture.view.layoutNow().taxelSide();
        QVERIFY(picture.brightnessNear(centre + along * reach) > 160);
        QVERIFY(picture.brightnessNear(centre - along * reach) > 160);
        const QPointF across(along.y(), -along.x());
        QVERIFY(picture.brightnessNear(centre + across * reach) < 160);
    }

    void contactsAreOutlinedInsideTheirTaxelsInTheirOwnColour() {
        pipeline::TouchSnapshot snapshot =
            test::snapshotOf(kArray, std::vector<float>(kArray.taxels(), 0.0F));
        contact::Contact contact;
        contact.id = 3;
        contact.region = 1;
        contact.minRow = contact.maxRow = 2;
        contact.minColumn = 6;
        contact.maxColumn = 8;
        snapshot.contacts = {contact};
        for (int column = 6; column <= 8; ++column)
            snapshot.labels[static_cast<std::size_t>(2 * kArray.columns + column)] = 1;
        const Picture picture(snapshot, {Overlay::contacts});
        const HeatmapLayout layout = picture.view.layoutNow();
        const auto borderAt = [&picture](const QPointF& border, const QPointF& inwards) {
            return picture.hasBorder(3, border, inwards);
        };
        QVERIFY(borderAt(layout.gridPoint(6.0, 2.5), {1, 0}));
        QVERIFY(borderAt(layout.gridPoint(9.0, 2.5) - QPointF(1, 0), {-1, 0}));
        QVERIFY(borderAt(layout.gridPoint(7.5, 3.0), {0, 1}));
        QVERIFY(borderAt(layout.gridPoint(7.5, 2.0) - QPointF(0, 1), {0, -1}));
        // No line between the taxels of one contact, none outside of it.
        QVERIFY(!borderAt(layout.gridPoint(7.0, 2.5), {1, 0}));
        QVERIFY(!borderAt(layout.gridPoint(6.0, 2.5) - QPointF(1, 0), {-1, 0}));
        QCOMPARE(picture.taxel(2, 7), base::cividis().front());
    }

    void aContactOverTheSeamIsOneAndOpenThere() {
        pipeline::TouchSnapshot snapshot =
            test::snapshotOf(kArray, std::vector<float>(kArray.taxels(), 0.0F));
        // Columns 6 to 8 of the last row and of the first.
        for (const int row : {5, 0}) {
            contact::Contact part;
            part.id = 3;
            part.region = row == 5 ? 1 : 2;
            part.minRow = part.maxRow = row;
            part.minColumn = 6;
            part.maxColumn = 8;
            part.y_m = kArray.y_m(row);
            snapshot.contacts.push_back(part);
            for (int column = 6; column <= 8; ++column)
                snapshot.labels[static_cast<std::size_t>(row * kArray.columns + column)] = part.region;
        }
        Picture picture(snapshot, {Overlay::contacts});
        const HeatmapLayout layout = picture.view.layoutNow();
        const auto borderAt = [&picture](const QPointF& border, const QPointF& inwards) {
            return picture.hasBorder(3, border, inwards);
        };
        // Both parts in one colour, open at the upper and at the lower edge of the sheet.
        QVERIFY(borderAt(layout.gridPoint(6.0, 5.5), {1, 0}));
        QVERIFY(borderAt(layout.gridPoint(7.9, 5.0) - QPointF(0, 1), {0, -1}));
        QVERIFY(!borderAt(layout.gridPoint(7.9, 6.0) + QPointF(0, 1), {0, 1}));
        QVERIFY(borderAt(layout.gridPoint(6.0, 0.5), {1, 0}));
        QVERIFY(borderAt(layout.gridPoint(7.9, 1.0), {0, 1}));
        QVERIFY(!borderAt(layout.gridPoint(7.9, 0.0) - QPointF(0, 1), {0, -1}));
        // The header counts it once.
        QVERIFY2(picture.view.headerText().contains(QStringLiteral("contacts 1")),
                 qPrintable(picture.view.headerText()));
        // Its taxels on both sides belong to one contact, also in the saved data.
        QCOMPARE(picture.view.figure().csv().count(QStringLiteral(",0,3\n")), qsizetype(6));
        // Apart, each is closed and counts.
        snapshot.contacts.back().id = 4;
        picture.view.setSnapshot(snapshot);
        picture.image = picture.view.grab().toImage();
        QVERIFY(borderAt(layout.gridPoint(7.9, 6.0) + QPointF(0, 1), {0, 1}));
        QVERIFY(picture.view.headerText().contains(QStringLiteral("contacts 2")));
    }

    void theThresholdIsMarkedAtItsHeightOnTheBar() {
        const Picture picture(ramp());
        const QRectF bar = picture.view.layoutNow().colourBar();
        const double y = bar.bottom() - bar.height() * 0.2 / picture.view.rangeTop();
        QVERIFY(qGray(picture.at({bar.center().x() + 3, y})) > 180);
        QVERIFY(qGray(picture.at({bar.center().x() + 3, y - 8})) < 120);
        QVERIFY(qGray(picture.at({bar.center().x() + 3, y + 8})) < 120);
    }

    void numbersAppearOnlyWhereThereIsRoom() {
        Picture picture(ramp(), {Overlay::values});
        const QRectF inner = picture.view.layoutNow().taxelRect({2, 5}).adjusted(4, 4, -4, -4);
        QVERIFY(picture.coloursIn(inner).size() > 3);
        picture.view.resize(400, 260);
        picture.image = picture.view.grab().toImage();
        const QRectF small = picture.view.layoutNow().taxelRect({2, 5}).adjusted(3, 3, -3, -3);
        QCOMPARE(picture.coloursIn(small).size(), qsizetype(1));
    }

    /// By a stripe on the screen, by the word in a picture that leaves the program.
    void dataThatAreNotLiveAreLabelled() {
        Picture picture(ramp());
        const base::StatusColours& colours = base::statusColours(qApp->palette());
        const auto saved = [&] {
            const base::Figure figure = picture.view.figure();
            picture.image = QImage(figure.size_px.toSize(), QImage::Format_RGB32);
            picture.image.fill(Qt::white);
            QPainter painter(&picture.image);
            figure.paint(painter);
        };
        const QRectF header = picture.view.layoutNow().header();
        for (const auto& [provenance, colour] : {std::pair(base::Provenance::simulated, colours.simulated),
                                                 std::pair(base::Provenance::recorded, colours.recorded)}) {
            picture.view.setProvenance(provenance);
            picture.image = picture.view.grab().toImage();
            QCOMPARE(picture.image.pixel(picture.image.width() / 2, 1), colour.rgb());
            saved();
            QVERIFY(picture.coloursIn(header).contains(colour.rgb()));
        }
        picture.view.setProvenance(base::Provenance::live);
        saved();
        QVERIFY(!picture.coloursIn(header).contains(colours.simulated.rgb()));
    }

    void theDataLookTheSameInLightAndDark() {
        const pipeline::TouchSnapshot snapshot = edge(0.4);
        const auto all = {Overlay::contacts, Overlay::centreOfPressure, Overlay::centreOfContact,
                          Overlay::principalAxis, Overlay::values};
        const Picture light(snapshot, all);
        base::applyTheme(base::ThemeChoice::dark);
        QCoreApplication::processEvents();
        const Picture dark(snapshot, all);
        QCOMPARE(light.array(), dark.array());
        QVERIFY(qGray(light.at({2, 200})) > 200);
        QVERIFY(qGray(dark.at({2, 200})) < 60);
    }

    void arraysFromOneTaxelToManyAreDrawn_data() {
        QTest::addColumn<int>("side");
        for (const int side : {1, 2, 256})
            QTest::addRow("%d", side) << side;
    }
    void arraysFromOneTaxelToManyAreDrawn() {
        QFETCH(int, side);
        const core::ArrayLayout layout{side, side, 0.001};
        const double last_m = layout.x_m(side - 1); // upper right
        const std::vector<float> load_N = test::hills(layout, {{last_m, last_m, 1.0, 1e-4, 1e-4}});
        const Picture picture(test::snapshotOf(layout, load_N));
        const QRectF sensor = picture.view.layoutNow().sensor();
        QCOMPARE(picture.at(sensor.topRight() + QPointF(-0.5, 0.5)), base::cividis().back());
        if (side > 1)
            QCOMPARE(picture.at(sensor.bottomLeft() + QPointF(0.5, -0.5)), base::cividis().front());
    }

    /// SVG files know no clipping: what is drawn on the array must end there by itself.
    void nothingReachesBeyondTheArrayInAPictureForPaper() {
        const core::ArrayLayout array = kArray;
        Picture picture(test::snapshotOf(array, test::hills(array, {{0.0, 0.0, 2.0, 0.02, 0.002}})),
                        {Overlay::principalAxis, Overlay::centreOfPressure, Overlay::contacts});
        picture.view.resize(900, 300);
        const QPointF middle = picture.view.layoutNow().visible().center();
        test::turnWheel(&picture.view, middle, 5, Qt::ControlModifier);
        const base::Figure figure = picture.view.figure();
        QTemporaryDir directory;
        const QString path = directory.filePath(QStringLiteral("a.svg"));
        QVERIFY(base::saveFigure(figure, path));
        QImage paper(figure.size_px.toSize(), QImage::Format_RGB32);
        paper.fill(Qt::white);
        QPainter painter(&paper);
        QSvgRenderer(path).render(&painter, QRectF(QPointF(), figure.size_px));
        painter.end();
        picture.view.resetZoom();
        const HeatmapLayout layout = picture.view.layoutNow();
        const QRectF sensor = layout.sensor();
        for (double x = sensor.right() + 4.0; x < layout.colourBar().left() - 12.0; x += 1.0)
            QCOMPARE(paper.pixel(qRound(x), qRound(sensor.center().y())), qRgb(255, 255, 255));
        for (double x = layout.readout().left(); x < layout.readout().right(); x += 1.0)
            QCOMPARE(paper.pixel(qRound(x), qRound(layout.readout().center().y())), qRgb(255, 255, 255));
    }

    void aPictureForPaperIsOnWhiteAndHasTheSameColours() {
        base::applyTheme(base::ThemeChoice::dark);
        Picture picture(ramp());
        const base::Figure figure = picture.view.figure();
        QImage paper(figure.size_px.toSize(), QImage::Format_RGB32);
        paper.fill(Qt::white);
        QPainter painter(&paper);
        figure.paint(painter);
        painter.end();
        QCOMPARE(paper.pixel(2, 200), qRgb(255, 255, 255));
        const QPoint centre = picture.view.layoutNow().taxelRect({5, 13}).center().toPoint();
        QCOMPARE(paper.pixel(centre), picture.taxel(5, 13));
    }
};

static const teleta::test::Registration<HeatmapRenderTest> registration;

#include "heatmap_render_test.moc"
