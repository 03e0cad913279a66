// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/calibrate/gain_calibrator.h"
#include "app/console/sources/source_manager.h"
#include "backend/equilibration/taxel_gain_file.h"
#include "tests/widgets/parts.h"
#include "widgets/base/theme.h"
#include "widgets/calibrate/gains_view.h"
#include "widgets/tactile/heatmap_view.h"

#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace teleta;
using console::GainCalibrator;
using console::SourceManager;

namespace {

constexpr core::ArrayLayout kLayout{.rows = 2, .columns = 3, .pitchX_m = 0.01};
constexpr std::array kResponse{1.0, 2.0, 3.0, 2.0, 1.0, 3.0}; // mean 2

} // namespace

/// The taxels of an array whose recording is played, quickly and again and again.
class GainCalibratorTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    core::StopSwitch m_stop;
    std::unique_ptr<SourceManager> m_sources;
    std::unique_ptr<QWidget> m_window;
    GainCalibrator* m_calibrator = nullptr;
    QTimer m_clock;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    calibrate::GainsView& view() { return m_calibrator->view(); }
    std::shared_ptr<pipeline::TouchChannel> channel() { return m_sources->active()->array(); }

    void writeFrames(const char* name, int frames, double from_s, double load) {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QByteArray text = "time_s,t0,t1,t2,t3,t4,t5\n";
        for (int frame = 0; frame < frames; ++frame) {
            const double time_s = 0.02 * frame;
            const bool pressed = time_s >= from_s;
            text += QByteArray::number(time_s);
            for (const double response : kResponse)
                text +=
                    ',' + QByteArray::number(100.0 + (pressed ? response * (load + 0.1 * (frame % 3)) : 0.0));
            text += '\n';
        }
        file.write(text);
    }

    void openRecording(const std::string& gainsPath = {}) {
        app::CsvRequest request;
        request.path = path("run.csv").toStdString();
        request.layout = kLayout;
        request.tarePath = path("empty.csv").toStdString();
        request.gainsPath = gainsPath;
        request.speed = 20.0;
        m_sources->closeAll();
        m_sources->open(request);
        QTRY_VERIFY(m_sources->active() != nullptr && m_sources->active()->channel != nullptr);
        QTRY_VERIFY(test::part(view(), "collect")->isEnabled());
    }

    [[nodiscard]] bool gainsAreRight() {
        const auto gains = view().calibration().gains;
        for (std::size_t i = 0; gains && i < kResponse.size(); ++i) {
            if (!(std::abs(gains->taxels[i].gain * kResponse[i] - 2.0) < 1e-4))
                return false;
        }
        return gains != nullptr;
    }

private slots:
    void initTestCase() {
        base::applyTheme(base::ThemeChoice::light);
        writeFrames("empty.csv", 5, 100.0, 0.0);
        writeFrames("run.csv", 500, 1.0, 2.0);
        writeFrames("press.csv", 60, 0.0, 3.0);
        writeFrames("short.csv", 10, 0.0, 3.0);
    }
    void init() {
        m_sources = std::make_unique<SourceManager>(m_stop);
        m_window = std::make_unique<QWidget>();
        m_calibrator = new GainCalibrator(*m_sources, m_window.get());
        m_window->resize(1000, 600);
        view().resize(1000, 600);
        m_window->show();
        connect(&m_clock, &QTimer::timeout, m_calibrator, [this] {
            m_sources->poll();
            for (SourceManager::Item& item : m_sources->items()) {
                if (const auto array = item.array())
                    (void)array->update();
            }
            m_calibrator->tick();
        });
        m_clock.start(5);
    }
    void cleanup() {
        m_clock.stop();
        m_window.reset();
        m_sources.reset();
    }

    void collectsOnlyWhatIsUnderLoadAndUsesTheGainsAtOnce() {
        openRecording();
        QTest::mouseClick(test::part(view(), "collect"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(view().calibration().gains != nullptr, 30'000);
        QVERIFY2(gainsAreRight(), qPrintable(test::textOf(view(), "verdict")));
        // The responses 1, 2, 3, 2, 1, 3 differ by the root of 0.8 over 2.
        QTRY_VERIFY_WITH_TIMEOUT(
            test::textOf(view(), "unevenness").contains(QLatin1String("44.7 % without gains")), 30'000);
        // 5 s of frames that are 20 ms apart, and one more each time that the recording begins again.
        const std::size_t frames = view().calibration().gains->frames;
        QVERIFY2(frames >= 251 && frames <= 253, qPrintable(QString::number(frames)));
        QTRY_COMPARE(channel()->settings().conditioning.taxelGain.size(), kLayout.taxels());
        QTest::mouseClick(test::part(view(), "undo"), Qt::LeftButton);
        QTRY_VERIFY(channel()->settings().conditioning.taxelGain.empty());
        QTest::mouseClick(test::part(view(), "redo"), Qt::LeftButton);
        QTRY_COMPARE(channel()->settings().conditioning.taxelGain.size(), kLayout.taxels());
    }

    void theArrayIsSeenBeforeAnythingIsDone() {
        openRecording();
        auto* loads = test::part<tactile::HeatmapView>(view(), "liveLoads");
        QTRY_VERIFY_WITH_TIMEOUT(!loads->headerText().isEmpty(), 30'000);
        QTRY_COMPARE_WITH_TIMEOUT(test::textOf(view(), "unevenness"),
                                  QStringLiteral("The taxels differ by 44.7 % under this load."), 30'000);
    }

    void aTareUnderLoadIsAskedAbout() {
        openRecording();
        QTRY_VERIFY_WITH_TIMEOUT(!test::textOf(view(), "unevenness").isEmpty(), 30'000);
        const auto question = [this] { return view().findChild<QMessageBox*>("tareUnderLoad"); };
        const std::vector<float> before = channel()->settings().conditioning.tare;
        m_clock.stop(); // the plate stays on
        QTest::mouseClick(test::part(view(), "tare"), Qt::LeftButton);
        QVERIFY(question() != nullptr);
        QCOMPARE(question()->text(), QString("6 of 6 taxels are under load."));
        QTest::keyClick(question(), Qt::Key_Return);
        QTRY_VERIFY(question() == nullptr);
        QCOMPARE(channel()->settings().conditioning.tare, before);
        QTest::mouseClick(test::part(view(), "tare"), Qt::LeftButton);
        for (QAbstractButton* button : question()->buttons())
            if (question()->buttonRole(button) == QMessageBox::AcceptRole)
                QTest::mouseClick(button, Qt::LeftButton);
        m_clock.start(5);
        QTRY_VERIFY_WITH_TIMEOUT(channel()->settings().conditioning.tare != before, 30'000);
    }

    void aPressCanBeEndedEarlyAndIsRefusedWhenItIsTooShort() {
        openRecording();
        m_calibrator->collect();
        QTest::mouseClick(test::part(view(), "end"), Qt::LeftButton);
        QTRY_VERIFY(!test::textOf(view(), "verdict").isEmpty());
        QVERIFY2(test::textOf(view(), "verdict").contains(QLatin1String("20")),
                 qPrintable(test::textOf(view(), "verdict")));
        QVERIFY(view().calibration().presses.empty());
    }

    void recordedPressesAreAddedAndTroubleKeepsThem() {
        openRecording();
        m_calibrator->openPresses({path("press.csv"), path("press.csv")});
        QTRY_VERIFY(view().calibration().gains != nullptr);
        QVERIFY(gainsAreRight());
        QCOMPARE(view().calibration().presses.size(), std::size_t(2));
        m_calibrator->openPresses({path("short.csv")});
        QTRY_VERIFY(test::textOf(view(), "verdict").contains(QLatin1String("at least 20")));
        QCOMPARE(view().calibration().presses.size(), std::size_t(2));
        QVERIFY(gainsAreRight());
        m_calibrator->openPresses({path("missing.csv")});
        QTRY_VERIFY(test::textOf(view(), "verdict").contains(QLatin1String("missing.csv")));
        QVERIFY(gainsAreRight());
    }

    void whatIsSavedIsLoadedAndOpenedWithARecording() {
        openRecording();
        m_calibrator->openPresses({path("press.csv")});
        QTRY_VERIFY(view().calibration().gains != nullptr);
        m_calibrator->save(path("gains.csv"));
        QTRY_VERIFY(view().isSaved());
        const auto written = equilibration::readTaxelGains(path("gains.csv").toStdString(), kLayout);
        QVERIFY(written.has_value());
        QTest::mouseClick(test::part(view(), "reset"), Qt::LeftButton);
        QVERIFY(view().calibration().gains == nullptr);
        m_calibrator->load(path("gains.csv"));
        QTRY_VERIFY(view().calibration().gains != nullptr);
        QVERIFY(gainsAreRight());

        openRecording(path("gains.csv").toStdString());
        QTRY_VERIFY(view().calibration().gains != nullptr);
        QVERIFY(gainsAreRight());
        QVERIFY(!test::part(view(), "undo")->isEnabled());
        QCOMPARE(channel()->settings().conditioning.taxelGain.size(), kLayout.taxels());
    }

    void anArrayThatIsLeftKeepsWhatWasFound() {
        openRecording();
        const pipeline::ChannelKey key = m_sources->active()->key;
        m_calibrator->openPresses({path("press.csv")});
        QTRY_VERIFY(view().calibration().gains != nullptr);
        m_sources->open(app::SceneRequest{":/scenes/tactile-even-load.toml", 1});
        QTRY_VERIFY(test::textOf(view(), "state").contains(QLatin1String("SIMULATED")));
        QVERIFY(view().calibration().gains == nullptr);
        QVERIFY(view().isSaved());
        QVERIFY(!m_calibrator->isSaved());
        QVERIFY(!m_calibrator->isSaved(key));
        QVERIFY(m_calibrator->isSaved(m_sources->active()->key));
        m_sources->activate(key);
        QTRY_COMPARE(view().calibration().presses.size(), std::size_t(1));
        QVERIFY(gainsAreRight());
        QVERIFY(!view().isSaved());
        QVERIFY(!test::part(view(), "undo")->isEnabled());
        m_calibrator->save(path("left.csv"));
        QTRY_VERIFY(m_calibrator->isSaved());
        m_sources->closeAll();
        QTRY_VERIFY(view().calibration().gains == nullptr);
        QVERIFY(m_calibrator->isSaved());
    }

    void aCollectionBeginsAnewWithAnotherTareAndDoesWithoutGains() {
        openRecording();
        // Wrong gains would tell every taxel dead, and no press would be seen.
        channel()->setTaxelGain(std::vector<float>(kLayout.taxels(), std::nanf("")));
        QTRY_COMPARE(channel()->settings().conditioning.taxelGain.size(), kLayout.taxels());
        console::PressCollector collector(channel());
        const auto isCollected = [&] {
            collector.update();
            return collector.isComplete();
        };
        QTRY_VERIFY(isCollected());
        QVERIFY(!collector.conditioning().tare.empty());
        const std::uint64_t revision = channel()->settingsRevision();
        channel()->clearTare();
        QTRY_VERIFY(channel()->settingsRevision() != revision);
        const std::size_t before = collector.takeFrames().size();
        QVERIFY(before > 0);
        collector.update();
        QVERIFY(collector.conditioning().tare.empty());
        QTRY_VERIFY(isCollected());
    }

    void aFolderThatCannotBeWrittenIsTold() {
        openRecording();
        m_calibrator->openPresses({path("press.csv")});
        QTRY_VERIFY(view().calibration().gains != nullptr);
        QSignalSpy troubles(m_calibrator, &GainCalibrator::trouble);
        m_calibrator->save(QStringLiteral("/proc/none/gains.csv"));
        QTRY_COMPARE(troubles.size(), 1);
        QVERIFY(!view().isSaved());
    }

    void anotherArrayEndsACollection() {
        openRecording();
        m_calibrator->collect();
        QVERIFY(test::part(view(), "end")->isVisibleTo(&view()));
        m_sources->closeAll();
        QTRY_VERIFY(test::part(view(), "demo")->isVisibleTo(&view()));
        QVERIFY(!test::part(view(), "end")->isVisibleTo(&view()));
        QVERIFY(view().calibration().gains == nullptr);
    }

    void theDemoIsAnEvenLoadThatCanBeCalibrated() {
        m_sources->open(app::SceneRequest{":/scenes/tactile-even-load.toml", 1});
        QTRY_VERIFY(m_sources->active() != nullptr && m_sources->active()->channel != nullptr);
        QTRY_VERIFY(test::textOf(view(), "state").contains(QLatin1String("SIMULATED")));
        QTRY_COMPARE(channel()->snapshot().load_N.size(), std::size_t(84));
        QTest::mouseClick(test::part(view(), "collect"), Qt::LeftButton);
        QTRY_VERIFY(test::part(view(), "end")->isVisibleTo(&view()));
        // Pressed from 2.7 s on; a good second of it is enough.
        QTRY_VERIFY_WITH_TIMEOUT(channel()->snapshot().sourceTime_s > 4.0, 20'000);
        QTest::mouseClick(test::part(view(), "end"), Qt::LeftButton);
        QTRY_VERIFY2(view().calibration().gains != nullptr, qPrintable(test::textOf(view(), "verdict")));
        QCOMPARE(view().calibration().gains->good(), std::size_t(84));
    }
};

QTEST_MAIN(GainCalibratorTest)
#include "gain_calibrator_test.moc"
