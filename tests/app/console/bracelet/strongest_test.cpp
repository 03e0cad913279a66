// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/patterns/patterns_page.h"
#include "app/console/study/running/bracelet_stimulus.h"
#include "backend/core/steady_time.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/playback/pattern_program.h"
#include "tests/app/console/bracelet/patient_bracelet.h"
#include "tests/widgets/parts.h"
#include "widgets/bracelet/strength_panel.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <memory>

using namespace teleta;
using namespace teleta::console;

/// The wearer's limit: set by hand, kept for the bracelet, and held whoever drives it.
class StrongestTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_config;
    core::StopSwitch m_stop;
    std::unique_ptr<BraceletService> m_station;
    QTimer m_clock;
    double m_seen = 0.0; ///< strongest that was given

    [[nodiscard]] static QString limitsFile() {
        return QString::fromStdString(motors::limitsPath("simulated"));
    }
    void connectBracelet() {
        m_station->choose(BraceletChoice::simulated);
        QTRY_VERIFY(m_station->isReady());
    }
    /// What is driven is as strong as the limit and no stronger.
    void expectLimit(double limit) {
        m_seen = 0.0;
        QTRY_VERIFY(m_seen > limit - 1e-9);
        QTest::qWait(50);
        QVERIFY2(m_seen < limit + 1e-9, qPrintable(QString::number(m_seen)));
    }

private slots:
    // Limits of their own, whatever else runs meanwhile.
    void initTestCase() { qputenv("XDG_CONFIG_HOME", m_config.path().toLocal8Bit()); }
    void init() {
        QFile::remove(limitsFile());
        m_station = test::patientBracelet(m_stop);
        m_clock.disconnect();
        connect(&m_clock, &QTimer::timeout, this, [this] {
            m_station->tick();
            m_seen = std::max(m_seen, std::ranges::max(m_station->given()));
        });
        m_clock.start(5);
        connectBracelet();
    }
    void cleanup() {
        m_clock.stop();
        m_station.reset();
        QFile::remove(limitsFile());
    }

    void holdsForPatternsHeldMotorsTouchesAndStudies() {
        core::Intensities strongest{};
        strongest.fill(0.4);
        m_station->setStrongest(strongest);
        const pattern::Pattern& full = *pattern::findBuiltIn("stiffness.E.static");
        m_station->play(playback::programOf(full), true);
        expectLimit(0.4);
        m_station->stopPlaying();
        QTRY_VERIFY(!m_station->isDriven());

        m_station->hold(2);
        expectLimit(0.4);
        m_station->hold(std::nullopt);
        QTRY_VERIFY(!m_station->isDriven());

        m_station->setMap(pattern::PatternMap::defaults());
        m_station->setMode(pipeline::FeedbackMode::stiffness);
        pipeline::TouchRecord touch;
        touch.number = 1;
        touch.stiffness.emplace();
        touch.stiffness->material = stiffness::Material::metal;
        m_station->feedback()->onTouch(touch);
        expectLimit(0.4);
        m_station->stopPlaying();
        QTRY_VERIFY(!m_station->isDriven());

        m_station->reserve(true);
        BraceletStimulus stimulus(*m_station, m_stop);
        stimulus.begin(full, 2.0, OnsetFrame::notZero, core::steadyNow_ns());
        expectLimit(0.4);
        // A limit that is lowered holds at once, also for a study.
        strongest.fill(0.1);
        m_station->setStrongest(strongest);
        QTRY_VERIFY(std::ranges::max(m_station->given()) <= 0.1);
        stimulus.stop();
        m_station->reserve(false);
    }

    void isKeptForTheBraceletAndThereWhenItComesBack() {
        m_station->setStrongest({0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
        m_station->choose(BraceletChoice::none);
        QCOMPARE(m_station->strongest(), (core::Intensities{1.0, 1.0, 1.0, 1.0, 1.0, 1.0}));
        QTRY_VERIFY(QFile::exists(limitsFile()));
        connectBracelet();
        QCOMPARE(m_station->strongest(), (core::Intensities{0.1, 0.2, 0.3, 0.4, 0.5, 0.6}));
        m_station->play(playback::programOf(*pattern::findBuiltIn("stiffness.E.static")), true);
        expectLimit(0.6);
        QCOMPARE(m_station->given()[0], 0.1);
    }

    void isWeakWhereItsFileIsDamaged() {
        m_station->choose(BraceletChoice::none);
        QVERIFY(QDir().mkpath(QFileInfo(limitsFile()).path()));
        QFile file(limitsFile());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("format = 'teleta-limits'\nversion = 1\n");
        file.close();
        QSignalSpy failures(m_station.get(), &BraceletService::strongestFailed);
        connectBracelet();
        QCOMPARE(failures.size(), 1);
        m_station->play(playback::programOf(*pattern::findBuiltIn("stiffness.E.static")), true);
        expectLimit(motors::kUnknownStrongest);
    }

    void hasASliderByThePictureOfTheBracelet() {
        QTemporaryDir folder;
        PatternCollection collection(folder.filePath("patterns"));
        PatternsPage page(*m_station, collection, QString());
        page.resize(1500, 900);
        page.show();
        auto* panel = page.findChild<bracelet::StrengthPanel*>();
        QVERIFY(panel && panel->isEnabled());
        QTest::keyClick(test::part<QSlider>(*panel, "all"), Qt::Key_PageDown);
        QCOMPARE(m_station->strongest()[3], 0.9);
        QTest::mouseClick(test::part<QToolButton>(*panel, "each"), Qt::LeftButton);
        QTest::keyClick(test::part<QSlider>(*panel, "motor4"), Qt::Key_Home);
        QCOMPARE(m_station->strongest()[3], 0.0);
        QTRY_VERIFY(QFile::exists(limitsFile()));
        m_station->choose(BraceletChoice::none);
        QVERIFY(!panel->isEnabled());
    }
};

QTEST_MAIN(StrongestTest)
#include "strongest_test.moc"
