// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/vision/simulated_pairs.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/camera/pair_model.h"
#include "widgets/camera/residual_view.h"

#include <QImage>
#include <QSignalSpy>
#include <QTest>

using namespace teleta;
using camera::CalibratedPairs;
using camera::PairModel;
using camera::ResidualPicture;
using camera::ResidualView;

namespace {

/// Three pairs: kept and 10 px to the right, wrong, excluded.
CalibratedPairs threePairs() {
    CalibratedPairs pairs;
    pairs.pairs = {{{400.0, 300.0}, {0.025, 0.0, 0.02}},
                   {{1200.0, 300.0}, {0.0, 0.025, 0.05}},
                   {{820.0, 1000.0}, {0.0, -0.025, 0.08}}};
    pairs.used = {true, true, false};
    pairs.residuals.resize(3);
    pairs.residuals[0].kept = true;
    pairs.residuals[0].error_px = Eigen::Vector2d(10.0, 0.0);
    pairs.residuals[0].located_m = Eigen::Vector3d(0.025, 0.0, 0.021);
    pairs.residuals[0].error_m = 0.001;
    pairs.residuals[1].error_px = Eigen::Vector2d(300.0, 0.0);
    pairs.camera = *vision::CameraModel::create(vision::paperCamera());
    return pairs;
}

QColor pixelOf(ResidualView& view, const QPointF& at) {
    return view.grab().toImage().pixelColor(at.toPoint());
}

} // namespace

/// Residuals as pictures, and the table of pairs.
class ResidualViewTest : public QObject {
    Q_OBJECT

private slots:
    void anEmptyCalibrationIsDrawn() {
        for (const auto surface : {ResidualPicture::Surface::image, ResidualPicture::Surface::cylinder}) {
            ResidualView view(surface);
            view.resize(500, 400);
            QVERIFY(!view.grab().isNull());
            QVERIFY(view.picture().headline().contains("no pairs yet"));
            view.resize(20, 20);
            QVERIFY(!view.grab().isNull());
        }
    }

    void theWordsUnderAPlotThatIsNarrowerAreWhole() {
        ResidualView view(ResidualPicture::Surface::image);
        CalibratedPairs pairs = threePairs();
        pairs.pairs[2].pixel = {static_cast<double>(pairs.width_px), static_cast<double>(pairs.height_px)};
        view.setPairs(pairs);
        const int em = base::em(&view, 1);
        view.resize(44 * em, 16 * em); // low: the plot with its square pixels is narrow
        const QImage picture = view.grab().toImage();
        const double dpr = picture.devicePixelRatio();
        const QPointF corner = view.picture().position(2, QSizeF(view.size()));
        QVERIFY(corner.x() < 32 * em);
        int inked = 0;
        for (double y = corner.y() + 2.2 * em; y < corner.y() + 3.3 * em; y += 1.0 / dpr)
            for (double x = corner.x() + em; x < view.width() - em; x += 1.0 / dpr)
                inked +=
                    picture.pixelColor((QPointF(x, y) * dpr).toPoint()) != picture.pixelColor(1, 1) ? 1 : 0;
        QVERIFY(inked > 0);
    }

    void theHeadlineKeepsClearOfTheScale() {
        ResidualView view(ResidualPicture::Surface::cylinder);
        view.setPairs(threePairs());
        const int em = base::em(&view, 1);
        view.resize(44 * em, 30 * em);
        const QImage picture = view.grab().toImage();
        const int y = static_cast<int>(1.8 * em * picture.devicePixelRatio());
        for (int x = 0; x < 3.4 * em * picture.devicePixelRatio(); ++x)
            QCOMPARE(picture.pixelColor(x, y), picture.pixelColor(1, 1));
    }

    void theImageIsToScaleWithVDownwardsAndTheCylinderHasZUpwards() {
        ResidualView image(ResidualPicture::Surface::image);
        image.setPairs(threePairs());
        const QSizeF size(700, 500);
        const QPointF a = image.picture().position(0, size);
        const QPointF b = image.picture().position(1, size);
        const QPointF c = image.picture().position(2, size);
        QCOMPARE(a.y(), b.y());
        QVERIFY(c.y() > a.y());
        QVERIFY(std::abs((b.x() - a.x()) / 800.0 - (c.y() - a.y()) / 700.0) < 1e-9);
        ResidualView cylinder(ResidualPicture::Surface::cylinder);
        cylinder.setPairs(threePairs());
        QVERIFY(cylinder.picture().position(1, size).y() < cylinder.picture().position(0, size).y());
        QVERIFY(cylinder.picture().position(1, size).x() > cylinder.picture().position(0, size).x());
        QVERIFY(cylinder.picture().position(2, size).x() < cylinder.picture().position(0, size).x());
    }

    void thePlaceToBeProbedNextIsRingedWhereTheCameraWouldSeeIt() {
        CalibratedPairs pairs = threePairs();
        // Where the second pair's point is.
        pairs.next_m = pairs.pairs[1].p_Sensor_m;
        ResidualView cylinder(ResidualPicture::Surface::cylinder);
        ResidualView image(ResidualPicture::Surface::image);
        for (ResidualView* view : {&cylinder, &image}) {
            view->resize(600, 500);
            view->setPairs(pairs);
        }
        const QPointF onCylinder = *cylinder.picture().nextPosition(cylinder.size());
        QVERIFY((onCylinder - cylinder.picture().position(1, cylinder.size())).manhattanLength() < 1e-9);
        pairs.pairs[0].pixel = *pairs.camera->project(*pairs.next_m);
        image.setPairs(pairs);
        const QPointF inImage = *image.picture().nextPosition(image.size());
        QVERIFY((inImage - image.picture().position(0, image.size())).manhattanLength() < 1e-9);
        const double radius = 0.7 * QFontMetricsF(image.picture().font).height();
        QCOMPARE(pixelOf(image, inImage - QPointF(radius, 0.0)), image.palette().color(QPalette::Highlight));
        // Without a camera by that of the design.
        pairs.camera.reset();
        image.setPairs(pairs);
        QVERIFY(image.picture().nextPosition(image.size()).has_value());
        pairs.next_m.reset();
        image.setPairs(pairs);
        QVERIFY(!image.picture().nextPosition(image.size()).has_value());
    }

    void keptPairsAreDrawnInTheirColourInBothThemes() {
        for (const bool dark : {false, true}) {
            base::applyTheme(dark ? base::ThemeChoice::dark : base::ThemeChoice::light);
            ResidualView view(ResidualPicture::Surface::image);
            view.resize(800, 600);
            view.setPairs(threePairs());
            // Away from the arrow, which starts at the dot's centre to the right.
            const QPointF at = view.picture().position(0, QSizeF(800, 600)) - QPointF(1, 0);
            QCOMPARE(pixelOf(view, at), base::statusColours(view.palette()).live);
        }
        base::applyTheme(base::ThemeChoice::light);
    }

    void aClickChoosesThePairAndDeleteAsksToLeaveItOut() {
        ResidualView view(ResidualPicture::Surface::image);
        view.resize(800, 600);
        view.setPairs(threePairs());
        QSignalSpy chosen(&view, &ResidualView::selected);
        QSignalSpy toggled(&view, &ResidualView::toggleRequested);
        QTest::keyClick(&view, Qt::Key_Delete);
        QCOMPARE(toggled.count(), 0);
        QTest::mouseClick(&view, Qt::LeftButton, {}, view.picture().position(1, QSizeF(800, 600)).toPoint());
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.takeFirst().at(0).value<std::size_t>(), 1U);
        QVERIFY(view.accessibleDescription().contains("wrong"));
        QTest::keyClick(&view, Qt::Key_Delete);
        QCOMPARE(toggled.count(), 1);
        QCOMPARE(toggled.takeFirst().at(0).value<std::size_t>(), 1U);
    }

    void arrowKeysGoThroughAllPairsAndAround() {
        ResidualView view(ResidualPicture::Surface::cylinder);
        view.setPairs(threePairs());
        std::vector<std::size_t> way;
        connect(&view, &ResidualView::selected, this, [&](std::size_t pair) { way.push_back(pair); });
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(&view, Qt::Key_Right);
        QTest::keyClick(&view, Qt::Key_Left);
        QTest::keyClick(&view, Qt::Key_Left);
        QCOMPARE(way, (std::vector<std::size_t>{0, 1, 2, 0, 2, 1}));
    }

    void theFigureKeepsItsData() {
        base::Figure figure;
        {
            ResidualView view(ResidualPicture::Surface::image);
            view.resize(400, 300);
            view.setPairs(threePairs());
            figure = view.figure();
        }
        const QStringList lines = figure.csv().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 4);
        QCOMPARE(lines[0], QStringLiteral("u_px,v_px,x_m,y_m,z_m,used,kept,du_px,dv_px,error_m"));
        QCOMPARE(lines[1], QStringLiteral("400,300,0.025,0,0.02,1,1,10,0,0.001"));
        QCOMPARE(lines[3], QStringLiteral("820,1000,0,-0.025,0.08,0,0,NA,NA,NA"));
    }

    void theTableGrowsAndShrinksAtItsEnd() {
        PairModel model;
        CalibratedPairs pairs = threePairs();
        model.setPairs(pairs);
        QSignalSpy reset(&model, &PairModel::modelReset);
        QSignalSpy added(&model, &PairModel::rowsInserted);
        pairs.pairs.push_back({{1.5, 2.5}, {0.0, 0.025, 0.01}});
        pairs.used.push_back(true);
        pairs.residuals.emplace_back();
        model.setPairs(pairs);
        QCOMPARE(added.count(), 1);
        QCOMPARE(model.index(3, PairModel::pixel).data().toString(), QStringLiteral("1.5, 2.5"));
        pairs = threePairs();
        pairs.pairs[0].pixel.x() = 7.0;
        model.setPairs(pairs);
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.index(0, PairModel::pixel).data().toString(), QStringLiteral("7.0, 300.0"));
        QCOMPARE(reset.count(), 0);
    }

    void theTableTellsStatesAndAsksForUse() {
        PairModel model;
        model.setPairs(threePairs());
        QCOMPARE(model.rowCount(), 3);
        const auto state = [&](int row) { return model.index(row, PairModel::condition).data().toString(); };
        QCOMPARE(state(0), QStringLiteral("kept"));
        QCOMPARE(state(1), QStringLiteral("wrong"));
        QCOMPARE(state(2), QStringLiteral("excluded"));
        QCOMPARE(model.index(1, PairModel::pixel).data().toString(), QStringLiteral("1200.0, 300.0"));
        QCOMPARE(model.index(2, PairModel::point).data().toString(),
                 QStringLiteral("0.00, \u221225.00, 80.00"));
        QSignalSpy asked(&model, &PairModel::useRequested);
        const QModelIndex tick = model.index(2, PairModel::number);
        QCOMPARE(tick.data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Unchecked));
        QVERIFY(model.setData(tick, Qt::Checked, Qt::CheckStateRole));
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked[0][0].value<std::size_t>(), 2U);
        QCOMPARE(asked[0][1].toBool(), true);
        // An intent changes nothing by itself.
        QCOMPARE(tick.data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Unchecked));
    }
};

static const test::Registration<ResidualViewTest> kRegistration;
#include "residual_view_test.moc"
