// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/input_events.h"
#include "tests/widgets/parts.h"
#include "tests/widgets/test_registry.h"
#include "widgets/calibrate/gain_map.h"
#include "widgets/calibrate/gains_view.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace teleta;
using namespace teleta::calibrate;
using equilibration::TaxelGains;
using equilibration::TaxelState;

namespace {

std::shared_ptr<const TaxelGains> someGains() {
    auto gains = std::make_shared<TaxelGains>();
    gains->layout = {.rows = 2, .columns = 3, .pitchX_m = 0.01};
    gains->presses = 1;
    gains->frames = 400;
    for (const double gain : {1.25, 0.8, 1.0, 1.0, 1.1, 0.9})
        gains->taxels.push_back({.state = TaxelState::good, .gain = gain, .error = 0.01 * gain});
    gains->taxels[3] = {.state = TaxelState::stuck, .gain = std::nan(""), .error = std::nan("")};
    return gains;
}

GainCalibration onePress() {
    return {{std::make_shared<const RecordedPress>(RecordedPress{std::vector<float>(6, 1.0F), {}})},
            someGains()};
}

struct GainsDesk {
    GainsDesk() {
        view.resize(1000, 600);
        view.show();
        active = QTest::qWaitForWindowActive(&view);
        view.setFacts({.name = QStringLiteral("Array"), .tared = true, .usable = 6, .loaded = 0});
        QObject::connect(&view, &GainsView::calibrationChanged,
                         [this](const GainCalibration& calibration) { changes.push_back(calibration); });
    }
    [[nodiscard]] QColor colourOf(std::size_t taxel) {
        const QRectF rect = map->taxelRect(taxel);
        const QImage image = map->grab().toImage();
        // Beside the number in the middle.
        const QPointF at = rect.topLeft() + QPointF(0.15 * rect.width(), 0.15 * rect.height());
        return image.pixelColor((at * image.devicePixelRatio()).toPoint());
    }

    GainsView view;
    GainMap* map = view.findChild<GainMap*>();
    bool active = false;
    std::vector<GainCalibration> changes;
};

} // namespace

class GainsViewTest : public QObject {
    Q_OBJECT

private slots:
    void itsStepSaysHowFarItIs() {
        GainsDesk desk;
        QCOMPARE(desk.view.step(), StepReading{});
        desk.view.setProgress(PressProgress{.waiting = false, .collected_s = 0.5, .wanted_s = 2.0});
        QCOMPARE(desk.view.step(), (StepReading{.state = StepState::running, .share = 0.25}));
        desk.view.setProgress(std::nullopt);
        desk.view.setBusy(true);
        QCOMPARE(desk.view.step(), StepReading{.state = StepState::running});
        desk.view.setBusy(false);
        desk.view.showTrouble("no load");
        QCOMPARE(desk.view.step(), StepReading{.state = StepState::failed});
        desk.view.take(onePress());
        QCOMPARE(desk.view.step(), StepReading{.state = StepState::notSaved});
        desk.view.showTrouble("no load");
        QCOMPARE(desk.view.step(), StepReading{.state = StepState::notSaved}); // gains could be lost
        desk.view.take(onePress());
        desk.view.markSaved();
        QCOMPARE(desk.view.step(), StepReading{.state = StepState::done});
    }

    void thePictureOfTheLoadsIsSeenBeforeAndBesideTheGains() {
        GainsDesk desk;
        auto* loads = new QLabel(&desk.view);
        desk.view.setLivePicture(loads);
        QTRY_VERIFY(loads->width() > desk.view.width() / 2 && loads->height() > desk.view.height() / 2);
        QVERIFY(!desk.map->isVisible());
        desk.view.take(onePress());
        QVERIFY(loads->isVisible());
        QTRY_VERIFY(desk.map->isVisible() && desk.map->y() > loads->geometry().bottom());
        desk.view.resize(1600, 500);
        QTRY_VERIFY2(desk.map->x() > loads->geometry().right(), "side by side where that is larger");
    }

    void theDifferenceOfTheTaxelsIsToldWithoutAndWithGains() {
        GainsDesk desk;
        QCOMPARE(test::textOf(desk.view, "unevenness"), QString());
        desk.view.setUnevenness(equilibration::Unevenness{.withGains = 0.447, .without = 0.447});
        QCOMPARE(test::textOf(desk.view, "unevenness"),
                 QStringLiteral("The taxels differ by 44.7 % under this load."));
        desk.view.take(onePress());
        desk.view.setUnevenness(equilibration::Unevenness{.withGains = 0.0312, .without = 0.447});
        QCOMPARE(test::textOf(desk.view, "unevenness"),
                 QStringLiteral("The taxels differ by 44.7 % without gains, by 3.12 % with them."));
        desk.view.setUnevenness(std::nullopt);
        QCOMPARE(test::textOf(desk.view, "unevenness"), QString());
    }

    void aPressThatWaitsSaysWhyAndLetsTheArrayBeTared() {
        GainsDesk desk;
        QSignalSpy tares(&desk.view, &GainsView::tareRequested);
        desk.view.setProgress(PressProgress{.waiting = true, .collected_s = 0.0, .wanted_s = 5.0});
        const auto labels = desk.view.findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() && label->text().contains(QLatin1String("0 of 6 now")) &&
                   label->text().contains(QLatin1String("tared under that load"));
        }));
        QTest::mouseClick(test::part(desk.view, "tare"), Qt::LeftButton);
        QCOMPARE(tares.size(), 1);
        desk.view.setProgress(PressProgress{.waiting = false, .collected_s = 0.5, .wanted_s = 5.0});
        QVERIFY(!test::part(desk.view, "tare")->isEnabled());
    }

    void withoutAnArrayItOffersTheDemoAndNothingElse() {
        GainsDesk desk;
        desk.view.setFacts({});
        QSignalSpy demos(&desk.view, &GainsView::demoRequested);
        QVERIFY(!test::part(desk.view, "collect")->isVisible());
        QVERIFY(!test::part(desk.view, "tare")->isEnabled());
        QVERIFY(!test::part(desk.view, "load")->isEnabled());
        QTest::mouseClick(test::part(desk.view, "demo"), Qt::LeftButton);
        QCOMPARE(demos.size(), 1);
    }

    void asksForWhatTheStepsSay() {
        GainsDesk desk;
        QVERIFY(desk.active);
        QSignalSpy tares(&desk.view, &GainsView::tareRequested);
        QSignalSpy collects(&desk.view, &GainsView::collectRequested);
        QSignalSpy files(&desk.view, &GainsView::pressFilesRequested);
        QSignalSpy loads(&desk.view, &GainsView::loadRequested);
        QTest::mouseClick(test::part(desk.view, "tare"), Qt::LeftButton);
        test::part(desk.view, "collect")->setFocus();
        QTest::keyClick(test::part(desk.view, "collect"), Qt::Key_Space);
        QTest::mouseClick(test::part(desk.view, "files"), Qt::LeftButton);
        QTest::mouseClick(test::part(desk.view, "load"), Qt::LeftButton);
        QCOMPARE(tares.size() + collects.size() + files.size() + loads.size(), 4);
        QVERIFY(!test::part(desk.view, "save")->isEnabled());
        QVERIFY(!test::part(desk.view, "reset")->isEnabled());
    }

    void whileAPressIsCollectedItCanOnlyBeEnded() {
        GainsDesk desk;
        QSignalSpy ends(&desk.view, &GainsView::endRequested);
        desk.view.setProgress(PressProgress{.waiting = true, .collected_s = 0.0, .wanted_s = 5.0});
        QVERIFY(!test::part(desk.view, "collect")->isVisible());
        QVERIFY(!test::part(desk.view, "load")->isEnabled());
        QTest::mouseClick(test::part(desk.view, "end"), Qt::LeftButton);
        QCOMPARE(ends.size(), 1);
        desk.view.setProgress(std::nullopt);
        QVERIFY(test::part(desk.view, "collect")->isVisible());
        QVERIFY(test::part(desk.view, "load")->isEnabled());
    }

    void gainsTakeEffectAndCanBeUndone() {
        GainsDesk desk;
        desk.view.take(onePress());
        QCOMPARE(desk.changes.size(), std::size_t(1));
        QVERIFY(desk.changes.back().gains != nullptr);
        QVERIFY(!desk.view.isSaved());
        QVERIFY(test::textOf(desk.view, "verdict")
                    .contains(QLatin1String("5 of 6 taxels have gains from 0.80 to 1.25")));
        QVERIFY(test::textOf(desk.view, "verdict").contains(QLatin1String("1 stuck")));
        QTest::keyClick(&desk.view, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(desk.changes.size(), std::size_t(2));
        QVERIFY(desk.changes.back().gains == nullptr);
        QVERIFY(desk.view.calibration().presses.empty());
        QTest::mouseClick(test::part(desk.view, "redo"), Qt::LeftButton);
        QVERIFY(desk.changes.back().gains != nullptr);
        QTest::mouseClick(test::part(desk.view, "reset"), Qt::LeftButton);
        QVERIFY(desk.changes.back().gains == nullptr);
        QTest::mouseClick(test::part(desk.view, "undo"), Qt::LeftButton);
        QCOMPARE(desk.view.calibration().presses.size(), std::size_t(1));
    }

    void saysWhetherTheGainsAreSaved() {
        GainsDesk desk;
        desk.view.take(onePress());
        QVERIFY(test::textOf(desk.view, "state").contains(QLatin1String("not saved")));
        desk.view.markSaved();
        QVERIFY(desk.view.isSaved());
        QVERIFY(!test::textOf(desk.view, "state").contains(QLatin1String("not saved")));
        QTest::mouseClick(test::part(desk.view, "undo"), Qt::LeftButton);
        QVERIFY(!desk.view.isSaved());
    }

    void troubleChangesNothingAndGoesWithTheNextSuccess() {
        GainsDesk desk;
        desk.view.take(onePress());
        desk.view.showTrouble("Only 3 frames are under load.");
        QCOMPARE(test::textOf(desk.view, "verdict"), QStringLiteral("Only 3 frames are under load."));
        QVERIFY(desk.view.calibration().gains != nullptr);
        QCOMPARE(desk.changes.size(), std::size_t(1));
        desk.view.take(onePress());
        QVERIFY(test::textOf(desk.view, "verdict").contains(QLatin1String("5 of 6")));
    }

    void aTiltIsToldWithWhatHelps() {
        GainsDesk desk;
        auto gains = std::make_shared<TaxelGains>(*someGains());
        gains->isTilted = true;
        gains->tilt_x = 0.25;
        gains->tilt_y = -0.03;
        desk.view.take({{}, gains});
        QVERIFY(test::textOf(desk.view, "verdict")
                    .contains(QStringLiteral("25 % along x and \u22123 % along y")));
    }

    void anotherArrayLeavesNothingToUndo() {
        GainsDesk desk;
        desk.view.take(onePress());
        desk.view.setCalibration({});
        QVERIFY(!test::part(desk.view, "undo")->isEnabled());
        QVERIFY(desk.view.isSaved());
        QCOMPARE(desk.changes.size(), std::size_t(1));
    }

    void theMapShowsRaisedLoweredAndUnusedTaxels() {
        GainsDesk desk;
        desk.view.take(onePress());
        const QColor raised = desk.colourOf(0);
        const QColor lowered = desk.colourOf(1);
        QVERIFY(raised.red() > raised.blue());
        QVERIFY(lowered.blue() > lowered.red());
        // Row 0 is at the bottom.
        QVERIFY(desk.map->taxelRect(0).top() > desk.map->taxelRect(3).top());
    }

    void keysAndMouseReadATaxel() {
        GainsDesk desk;
        QVERIFY(desk.active);
        desk.view.take(onePress());
        GainMap* map = desk.map;
        map->setFocus();
        QTest::keyClick(map, Qt::Key_Right); // the first one
        QCOMPARE(map->readout(), QStringLiteral("Taxel 0, row 0, column 0: \u00d7 1.250 \u00b1 0.013"));
        QTest::keyClick(map, Qt::Key_Up);
        QCOMPARE(map->readout(), QStringLiteral("Taxel 3, row 1, column 0: stuck, not used"));
        QTest::keyClick(map, Qt::Key_Up);
        QCOMPARE(map->accessibleDescription(), map->readout());
        QTest::keyClick(map, Qt::Key_Escape);
        QVERIFY(map->readout().isEmpty());
        QTRY_VERIFY(map->y() < desk.view.height() / 4); // it has taken the room
        test::hover(map, map->taxelRect(4).center().toPoint());
        QVERIFY2(map->readout().startsWith(QLatin1String("Taxel 4")), qPrintable(map->readout()));
    }

    void thePictureComesWithItsTable() {
        GainsDesk desk;
        desk.view.take(onePress());
        const QString csv = desk.map->figure().csv();
        QVERIFY(
            csv.startsWith(QLatin1String("taxel,row,column,gain,gain_se,state\n0,0,0,1.25,0.0125,good\n")));
        QVERIFY(csv.contains(QLatin1String("3,1,0,NA,NA,stuck\n")));
    }
};

namespace {
const test::Registration<GainsViewTest> gainsRegistration;
}
#include "gains_view_test.moc"
