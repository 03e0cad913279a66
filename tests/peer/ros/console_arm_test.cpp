// SPDX-License-Identifier: GPL-3.0-or-later
// The console with a robot of Fast DDS and MuJoCo, over the loopback interface: it is opened by its file,
// shown, and moved by keys. The robot's log says where the arm was.
#include "app/console/console_options.h"
#include "app/console/operate/docks/operate_docks.h"
#include "app/console/operate/operate_page.h"
#include "tests/app/console/window_bench.h"
#include "tests/support/peer_process.h"
#include "widgets/base/theme.h"
#include "widgets/charts/joint_chart_view.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ios>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace teleta;
using console::ConsoleOptions;
using console::OperateDocks;
using nlohmann::json;

namespace {

constexpr int kPatience_ms = 30'000;
constexpr std::size_t kJoint = 2; ///< joint_3, which turns the arm about its own axis when it is stretched

} // namespace

class ConsoleArmTest : public QObject, protected test::WindowBench {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<test::PeerProcess> m_robot;

    [[nodiscard]] QString armFile() const { return m_folder.filePath("robot.toml"); }

    /// domain: no other test's.
    void startRobot(int domain, const QStringList& more = {}) {
        const QString urdf = QStringLiteral(TELETA_SOURCE_DIR "/resources/arms/seven-joints.urdf");
        m_robot = std::make_unique<test::PeerProcess>();
        QFile::remove(m_folder.filePath("log"));
        m_robot->start(QStringLiteral(TELETA_ROS_ROBOT),
                       QStringList{"--domain", QString::number(domain), "--urdf", urdf, "--start-from",
                                   "desired", "--json", m_folder.filePath("log"), "--seconds", "120",
                                   "--commands"} +
                           more,
                       true);
        QVERIFY(m_robot->waitFor("ready").has_value());
        std::ofstream file(armFile().toStdString());
        file << "kind = \"ros_arm\"\nname = \"Robot\"\nbase_frame = \"base_link\"\ntip_frame = \"tool0\"\n"
                "controller = \"/arm_controller\"\neffort_unit = \"Nm\"\njoint_timeout_s = 0.25\n"
             << "[ros]\ndomain = " << domain << "\ninterface = \"lo\"\n"
             << "[limits]\nspeed_scale = 1.0\ntip_turn_radPerS = 1.0\n";
    }

    void openArm(const QString& record = {}) {
        ConsoleOptions options;
        options.arms = {armFile()};
        options.record = record;
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->operatePage().armViews().joints() != nullptr, kPatience_ms);
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_jog = m_window->findChild<touch::JogPanel*>();
        m_jog->setFocus();
    }

    [[nodiscard]] std::vector<json> logOf(const std::string& event) const {
        std::vector<json> found;
        std::ifstream file(m_folder.filePath("log").toStdString());
        for (std::string line; std::getline(file, line);) {
            const json one = json::parse(line, nullptr, false);
            if (!one.is_discarded() && one["event"] == event)
                found.push_back(one);
        }
        return found;
    }
    /// The newest state in the log, of which only the end is read: the window must not wait for the disk.
    [[nodiscard]] json newestState() const {
        constexpr std::streamoff kEnd = 16'384;
        std::ifstream file(m_folder.filePath("log").toStdString(), std::ios::binary);
        file.seekg(0, std::ios::end);
        file.seekg(std::max<std::streamoff>(0, file.tellg() - kEnd));
        json newest;
        for (std::string line; std::getline(file, line);) {
            json one = json::parse(line, nullptr, false);
            if (!one.is_discarded() && one.is_object() && one["event"] == "state")
                newest = std::move(one);
        }
        return newest;
    }
    [[nodiscard]] double position() const {
        const json state = newestState();
        return state.is_null() ? 0.0 : state["position"][kJoint].get<double>();
    }
    [[nodiscard]] double speed() const {
        const json state = newestState();
        return state.is_null() ? 1.0 : std::abs(state["velocity"][kJoint].get<double>());
    }

    [[nodiscard]] bool panelSays(const QString& text) const {
        return std::ranges::any_of(m_jog->findChildren<QLabel*>(),
                                   [&](const QLabel* label) { return label->text().contains(text); });
    }
    /// Until other programs would have been found, nothing moves.
    void waitUntilReady() {
        QTRY_VERIFY_WITH_TIMEOUT(m_window->operatePage().armViews().joints()->device().hindrance().empty(),
                                 kPatience_ms);
    }
    void press() {
        QTest::keyPress(m_jog, Qt::Key_Shift);
        QTest::keyPress(m_jog, Qt::Key_E, Qt::ShiftModifier);
    }
    /// Presses until the joint is beyond a place, and leaves the keys down. On a busy machine the window may
    /// be so late that the arm is held, and the keys have to be pressed anew.
    [[nodiscard]] bool moveBeyond(double place_rad) {
        constexpr int kOnePress_ms = 3000;
        for (int presses = 0; presses < kPatience_ms / kOnePress_ms; ++presses) {
            press();
            if (QTest::qWaitFor([&] { return position() > place_rad; }, kOnePress_ms))
                return true;
            letGo();
        }
        return false;
    }
    void letGo() {
        QTest::keyRelease(m_jog, Qt::Key_E, Qt::ShiftModifier);
        QTest::keyRelease(m_jog, Qt::Key_Shift);
    }

    touch::JogPanel* m_jog = nullptr;

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void cleanup() {
        m_window.reset();
        m_robot.reset();
    }

    void anArmIsShownWhereItIs() {
        startRobot(69, {"--position", "0.1,0.2,0.3,0.4,0.5,0.6,0.7"});
        const QString recording = m_folder.filePath("robot.teleta");
        openArm(recording);
        QCOMPARE(m_window->operatePage().docks().kind(), OperateDocks::Kind::joints);
        auto* chart = m_window->findChild<charts::JointChartView*>();
        // Long enough for a recording that begins a moment later.
        QTRY_VERIFY_WITH_TIMEOUT(chart->history().size() > 1500, kPatience_ms);
        const std::size_t newest = chart->history().size() - 1;
        for (std::size_t joint = 0; joint < 7; ++joint)
            QVERIFY(std::abs(chart->history().value(7 + joint, newest) -
                             0.1 * (1.0 + static_cast<double>(joint))) < 0.02);
        QVERIFY(!m_window->findChild<view3d::Scene3dView*>()->armBox_m().isEmpty());
        QVERIFY(panelSays("joint_7"));
        QVERIFY2(m_jog->refusal().isEmpty(), qPrintable(m_jog->refusal()));

        // The recording of it is played without the robot.
        m_window.reset();
        m_robot.reset();
        ConsoleOptions options;
        options.files = {recording};
        openWindow(options);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->operatePage().armViews().joints() != nullptr, kPatience_ms);
        QCOMPARE(m_window->operatePage().docks().kind(), OperateDocks::Kind::joints);
        chart = m_window->findChild<charts::JointChartView*>();
        QTRY_VERIFY_WITH_TIMEOUT(chart->history().size() > 50, kPatience_ms);
        QVERIFY(std::abs(chart->history().value(13, 0) - 0.7) < 0.02);
        QVERIFY2(!m_window->findChild<view3d::Scene3dView*>()->armBox_m().isEmpty(),
                 "its links were recorded");
        m_jog = m_window->findChild<touch::JogPanel*>();
        QVERIFY(m_jog->refusal().contains("recording"));
    }

    void keysMoveItAndItStandsWhenTheyAreLetGoOrStopIsPressed() {
        startRobot(70);
        openArm();
        waitUntilReady();
        const double before = position();
        QVERIFY(moveBeyond(before + 0.1));
        letGo();
        QTRY_VERIFY_WITH_TIMEOUT(speed() < 1e-3, kPatience_ms);
        const double rested = position();
        QTest::qWait(500);
        QVERIFY(std::abs(position() - rested) < 2e-3);

        QVERIFY(moveBeyond(rested + 0.05));
        m_stop->engage();
        QTRY_VERIFY_WITH_TIMEOUT(speed() < 1e-3, kPatience_ms);
        const double stopped = position();
        // The keys are still down when STOP is released: nothing moves until they are pressed anew.
        m_stop->release();
        QTest::qWait(500);
        QVERIFY(std::abs(position() - stopped) < 2e-3);
        letGo();
        QVERIFY(moveBeyond(stopped + 0.05));
        letGo();
        QTRY_VERIFY_WITH_TIMEOUT(speed() < 1e-3, kPatience_ms);
        for (const json& trajectory : logOf("trajectory"))
            QVERIFY2(trajectory["accepted"] == true, trajectory.dump().c_str());
    }

    void whatIsInTheWayIsSaidAndAFreshPressGoesOn() {
        startRobot(71);
        openArm();
        waitUntilReady();
        QVERIFY(moveBeyond(position() + 0.05));
        QVERIFY(m_robot->command("fault nan"));
        QTRY_VERIFY_WITH_TIMEOUT(panelSays("a position that is not a number"), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(speed() < 1e-3, kPatience_ms);
        QVERIFY(m_robot->command("fault none"));
        const double held = position();
        QTest::qWait(500);
        QVERIFY2(std::abs(position() - held) < 2e-3, "the keys are still down");
        letGo();
        QVERIFY(moveBeyond(held + 0.05));
        letGo();
    }

    void anArmThatIsNotThereIsWaitedForByNobody() {
        std::ofstream file(armFile().toStdString());
        file << "kind = \"ros_arm\"\nname = \"Robot\"\nbase_frame = \"base_link\"\ntip_frame = \"tool0\"\n"
                "controller = \"/arm_controller\"\n[ros]\ndomain = 68\ninterface = \"lo\"\n";
        file.close();
        ConsoleOptions options;
        options.arms = {armFile()};
        openWindow(options);
        QTRY_COMPARE_WITH_TIMEOUT(m_window->sources().items().size(), std::size_t(1), kPatience_ms);
        // It would wait for the description of the robot.
        m_window->sources().closeAll();
        options.arms.clear();
        options.scenes = {QStringLiteral(":/scenes/tactile-indenter.toml")};
        m_window->openRequested(options);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->sources().items().empty() &&
                                     m_window->sources().items().front().isOpen(),
                                 kPatience_ms);
        QVERIFY(std::ranges::none_of(m_window->findChildren<QLabel*>(), [](const QLabel* label) {
            return label->text().contains("robot_description");
        }));
    }

    void aFileThatIsWrongIsTold() {
        std::ofstream file(armFile().toStdString());
        file << "kind = \"ros_arm\"\nname = \"Robot\"\nwrong = 1\n";
        file.close();
        ConsoleOptions options;
        options.arms = {armFile()};
        openWindow(options);
        const auto told = [this](const QString& text) {
            return std::ranges::any_of(m_window->findChildren<QLabel*>(),
                                       [&](const QLabel* label) { return label->text().contains(text); });
        };
        QTRY_VERIFY_WITH_TIMEOUT(told("robot.toml"), kPatience_ms);
        QVERIFY(m_window->sources().items().empty());
    }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    ConsoleArmTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "console_arm_test.moc"
