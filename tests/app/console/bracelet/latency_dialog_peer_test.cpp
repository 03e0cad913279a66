// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog that measures the latency of a bracelet on a sound card, against PipeWire: clicks come back at
// the monitor of a sink that nobody hears. Runs in with_sound_session.sh.
#include "app/console/bracelet/bracelet_menu.h"
#include "app/console/bracelet/latency_dialog.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"
#include "tests/app/console/bracelet/patient_bracelet.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/peer/sound/sound_server.h"
#include "widgets/calibrate/latency_chart.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStandardPaths>
#include <QTest>
#include <QTimer>
#include <QWidget>

#include <cmath>
#include <memory>

using namespace teleta;
using console::BraceletChoice;
using console::BraceletMenu;
using console::BraceletService;
using console::ConsoleSettings;
using console::LatencyDialog;

class LatencyDialogPeerTest : public QObject {
    Q_OBJECT

    static constexpr int kLong_ms = 40'000;

    peer::SoundServer m_server;
    test::TemporaryFolder m_folder;
    core::StopSwitch m_stop;
    std::unique_ptr<BraceletService> m_station;
    QWidget m_window;
    std::unique_ptr<ConsoleSettings> m_settings;
    std::unique_ptr<BraceletMenu> m_menu;
    QMenu m_shown;
    QTimer m_clock;
    std::string m_file;

    template <typename Widget>
    Widget* find(const char* name) {
        auto* dialog = m_window.findChild<LatencyDialog*>();
        return dialog == nullptr ? nullptr : dialog->findChild<Widget*>(QLatin1String(name));
    }
    QAction* entry() {
        for (QAction* action : m_shown.actions())
            if (action->text().contains(QStringLiteral("latency")))
                return action;
        return nullptr;
    }
    /// With the input at which tactor 1 is heard.
    void openDialog() {
        emit m_shown.aboutToShow();
        QVERIFY(entry()->isEnabled());
        entry()->trigger();
        auto* input = find<QComboBox>("input");
        QVERIFY(input != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(input->count() > 0, kLong_ms);
        for (int i = 0; i < input->count(); ++i)
            QVERIFY2(!input->itemText(i).startsWith(QStringLiteral("TeleTA")), "that would be no latency");
        input->setCurrentText(QStringLiteral("tactors:monitor_AUX0"));
        QCOMPARE(input->currentText(), QStringLiteral("tactors:monitor_AUX0"));
        QTRY_VERIFY(find<QPushButton>("measure")->isEnabled());
        QVERIFY(!find<QPushButton>("save")->isEnabled());
    }
    void click(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
    std::size_t clicks() { return m_window.findChild<calibrate::LatencyChart*>()->clicks_s().size(); }
    [[nodiscard]] bool isMeasuring() {
        return find<QPushButton>("measure")->text() != QStringLiteral("&Measure");
    }

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        QVERIFY(m_server.start());
    }
    void init() {
        m_file = m_folder.write("coils.toml", "kind = 'sound_bracelet' # ours\nname = 'coils'\n"
                                              "device = 'pipewire:tactors'\nchannels = [1, 2, 3, 4, 5, 6]\n");
        m_stop.release();
        m_station = test::patientBracelet(m_stop);
        m_settings = std::make_unique<ConsoleSettings>(true);
        m_menu = std::make_unique<BraceletMenu>(*m_station, *m_settings, &m_window);
        m_shown.clear();
        m_menu->fill(m_shown);
        QVERIFY2(!entry()->isEnabled(), "there is no bracelet");
        connect(&m_clock, &QTimer::timeout, m_station.get(), &BraceletService::tick);
        m_clock.start(10);
        m_station->choose(BraceletChoice::file, QString::fromStdString(m_file));
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isOnSoundCard() && m_station->isLive(), kLong_ms);
    }
    void cleanup() {
        m_clock.stop();
        delete m_window.findChild<LatencyDialog*>();
        m_menu.reset();
        m_station.reset();
    }

    void tenClicksAreMeasuredAndKeptInTheDeviceFile() {
        openDialog();
        // A busy machine may miss too many periods.
        for (int attempt = 0; attempt < 3 && !find<QPushButton>("save")->isEnabled(); ++attempt) {
            QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("measure")->isEnabled(), kLong_ms);
            click("measure");
            QTRY_VERIFY_WITH_TIMEOUT(!isMeasuring(), kLong_ms);
        }
        QVERIFY2(find<QPushButton>("save")->isEnabled(), qPrintable(find<QLabel>("trouble")->text()));
        QCOMPARE(clicks(), std::size_t{sound::kClicks});
        QVERIFY(std::isnan(m_station->session()->source().description().measuredLatency_s));
        click("save");
        QTRY_VERIFY(find<QLabel>("result")->text().contains(QStringLiteral("coils.toml")));
        const auto kept = sound::readSoundBracelet(m_file);
        QVERIFY(kept && kept->latency_ms && kept->latencySpread_ms);
        QVERIFY(*kept->latency_ms > 0.0);
        // The bracelet is opened anew, with it.
        QTRY_VERIFY_WITH_TIMEOUT(
            m_station->session() &&
                std::abs(1e3 * m_station->session()->source().description().measuredLatency_s -
                         *kept->latency_ms) < 1e-9,
            kLong_ms);
        QVERIFY(!find<QPushButton>("save")->isEnabled());
    }

    void stopEndsAMeasurementAndNothingIsKept() {
        openDialog();
        click("measure");
        QTRY_VERIFY_WITH_TIMEOUT(clicks() > 0, kLong_ms);
        m_stop.engage();
        QTRY_VERIFY(!isMeasuring());
        QVERIFY(find<QLabel>("trouble")->text().contains(QStringLiteral("STOP")));
        QVERIFY(!find<QPushButton>("save")->isEnabled());
        QVERIFY2(!find<QPushButton>("measure")->isEnabled(), "until STOP is released");
        m_stop.release();
        QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("measure")->isEnabled(), kLong_ms);
    }

    void aStudyHasTheBraceletAtOnce() {
        openDialog();
        click("measure");
        QTRY_VERIFY_WITH_TIMEOUT(clicks() > 0, kLong_ms);
        m_station->reserve(true);
        QTRY_VERIFY(!isMeasuring());
        QVERIFY(!find<QPushButton>("measure")->isEnabled());
        m_station->reserve(false);
        QTRY_VERIFY(find<QPushButton>("measure")->isEnabled());
    }

    void somethingElseThatIsPlayedEndsIt() {
        openDialog();
        click("measure");
        QTRY_VERIFY_WITH_TIMEOUT(clicks() > 0, kLong_ms);
        // Longer than a click and the pause before it, again and again: it falls into one.
        QTRY_VERIFY_WITH_TIMEOUT(
            [this] {
                m_station->play({[](double) { return core::Intensities{}; }, 0.001}, false);
                return !isMeasuring();
            }(),
            kLong_ms);
        QVERIFY(!find<QLabel>("trouble")->text().isEmpty());
        QVERIFY(!find<QPushButton>("save")->isEnabled());
    }

    void escapeClosesItAndEndsTheClicks() {
        openDialog();
        click("measure");
        QTRY_VERIFY_WITH_TIMEOUT(clicks() > 0, kLong_ms);
        auto* dialog = m_window.findChild<LatencyDialog*>();
        QTest::keyClick(dialog, Qt::Key_Escape);
        QVERIFY(!dialog->isVisible());
        QTRY_VERIFY(!isMeasuring());
        QTRY_VERIFY(!m_station->isDriven());
    }

    void aFileThatIsGoneIsTold() {
        openDialog();
        QVERIFY(QFile::remove(QString::fromStdString(m_file)));
        click("again");
        QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>("trouble")->text().contains(QStringLiteral("coils.toml")),
                                 kLong_ms);
        QVERIFY(!find<QPushButton>("measure")->isEnabled());
    }
};

QTEST_MAIN(LatencyDialogPeerTest)
#include "latency_dialog_peer_test.moc"
