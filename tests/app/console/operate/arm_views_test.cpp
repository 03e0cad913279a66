// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_service.h"
#include "app/console/main_window.h"
#include "app/console/operate/arm_views.h"
#include "app/console/operate/docks/operate_docks.h"
#include "app/console/operate/operate_page.h"
#include "app/console/patterns/patterns_page.h"
#include "backend/core/steady_time.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/playback/pattern_program.h"
#include "tests/backend/pipeline/scripted_arm_source.h"
#include "tests/backend/pipeline/scripted_source.h"
#include "widgets/base/theme.h"
#include "widgets/bracelet/bracelet_view.h"
#include "widgets/charts/joint_chart_view.h"
#include "widgets/chrome/message_bar.h"
#include "widgets/chrome/page_rail.h"
#include "widgets/pattern/document/pattern_document.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/touch/contour_view.h"
#include "widgets/touch/jog/jog_panel.h"
#include "widgets/touch/pattern_map_table.h"
#include "widgets/touch/run_sheet.h"
#include "widgets/touch/stiffness_gauge.h"
#include "widgets/touch/touch_table.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/gl_setup.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QItemSelectionModel>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTranslator>

#include <cmath>
#include <memory>

using namespace teleta;
using console::BraceletChoice;
using console::ConsoleOptions;
using console::ConsoleSettings;
using console::MainWindow;
using console::OperateDocks;
using core::ArmDrive;

namespace {

/// An arm that tells what the test puts into its queue, and keeps what it is told.
struct ScriptedChannel {
    void tell() const {
        core::JointSample sample;
        sample.time_ns = core::steadyNow_ns();
        sample.sourceTime_s = static_cast<double>(sample.time_ns) * 1e-9;
        sample.angle_rad = sample.reference_rad = {0.1, -0.2, 0.3, 1.5};
        (void)arm->push(sample);
        (void)channel->process();
    }

    test::ScriptedArmSource* arm = new test::ScriptedArmSource; // owned by the channel
    std::shared_ptr<pipeline::ArmChannel> channel = std::make_shared<pipeline::ArmChannel>(
        std::unique_ptr<core::ArmSource>(arm),
        std::make_shared<pipeline::TouchChannel>(
            std::unique_ptr<core::TactileSource>(std::make_unique<test::ScriptedSource>(
                core::ArrayLayout{.rows = 9, .columns = 9, .pitchX_m = 0.005})),
            pipeline::ChannelSettings{}));
};

} // namespace

/// The views of an arm in the window, on a real display: from the first contact to gauge, table and bracelet.
class ArmViewsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<core::StopSwitch> m_stop;
    std::unique_ptr<ConsoleSettings> m_settings;
    std::unique_ptr<MainWindow> m_window;

    /// The touch scene with its metal object alone, which is met after a moment.
    QString metalScene() {
        QFile shipped(QStringLiteral(TELETA_SOURCE_DIR "/resources/scenes/teleta-touch.toml"));
        if (!shipped.open(QIODevice::ReadOnly))
            qFatal("the touch scene is missing");
        QByteArray text = shipped.readAll();
        const qsizetype first = text.indexOf("[[object]]");
        const qsizetype metal = text.lastIndexOf("[[object]]");
        text.remove(first, metal - first);
        text.replace("travel_rad_per_s = 0.12", "travel_rad_per_s = 0.5");
        text.replace("clearance_rad = 0.004", "clearance_rad = 0.002");
        QFile file(m_folder.filePath(QStringLiteral("metal.toml")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write the scene");
        return file.fileName();
    }

    void openArm() {
        m_stop = std::make_unique<core::StopSwitch>();
        m_settings = std::make_unique<ConsoleSettings>(true);
        ConsoleOptions options;
        options.scenes = {metalScene()};
        options.dock = QStringLiteral("contour");
        m_window = std::make_unique<MainWindow>(options, *m_settings, *m_stop);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_window->openRequested(options);
        QTRY_VERIFY_WITH_TIMEOUT(arm() != nullptr && arm()->generation() > 0, 20'000);
    }

    template <typename Widget>
    Widget* child() const {
        return m_window->findChild<Widget*>();
    }
    pipeline::ArmChannel* arm() const { return m_window->operatePage().armViews().arm().get(); }

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void cleanup() { m_window.reset(); }

    void showsATouchFromTheFirstContactToGaugeTableAndBracelet() {
        openArm();
        QVERIFY(!child<touch::StiffnessGauge>()->content().touch);
        QTRY_VERIFY_WITH_TIMEOUT(child<touch::TouchTable>()->touches() == 1, 30'000);
        const auto& touch = child<touch::StiffnessGauge>()->content().touch;
        QVERIFY(touch.has_value());
        QVERIFY(touch->object.onlyBound()); // rigid
        QCOMPARE(touch->material, stiffness::Material::metal);
        QVERIFY2(child<touch::StiffnessGauge>()->content().age_s.has_value(), "how old the word is");
        // The gauge has it in the same tick as the table, within the second of the first contact.
        const auto& record = arm()->snapshot().lastTouch;
        QVERIFY(record && record->located);
        QVERIFY(record->ready_s - record->start_s < 1.0);
        // Level 5 on the simulated bracelet, and how long that took.
        auto& bracelet = m_window->bracelet();
        QTRY_VERIFY(bracelet.lastEvent() && bracelet.lastEvent()->onset_s);
        QCOMPARE(QString::fromStdString(bracelet.lastEvent()->sent.patternId),
                 QStringLiteral("stiffness.E.dynamic"));
        QCOMPARE(child<touch::PatternMapTable>()->recognisedRow(), std::optional(4));
        QVERIFY(child<charts::JointChartView>()->showTouch(1));
    }

    void tellsWhatWouldBeFeltWithoutABracelet() {
        openArm();
        auto& bracelet = m_window->bracelet();
        bracelet.choose(BraceletChoice::none);
        QTRY_VERIFY_WITH_TIMEOUT(bracelet.lastEvent(), 30'000);
        QVERIFY(!bracelet.lastEvent()->onset_s);
        QVERIFY(!bracelet.reading());
        const auto told = [this] {
            return m_window->operatePage().findChild<bracelet::BraceletView*>()->accessibleDescription();
        };
        QVERIFY(told().contains(QString::fromStdString(pattern::findBuiltIn("stiffness.E.dynamic")->name)));
        // What was felt before the language was changed is told in the new one, too.
        struct Metal : QTranslator {
            bool isEmpty() const override { return false; }
            QString translate(const char*, const char* text, const char*, int) const override {
                return QLatin1String(text) == QLatin1String("metal") ? QStringLiteral("m\u00e9tal")
                                                                     : QString();
            }
        } translator;
        QVERIFY(!told().contains(QStringLiteral("m\u00e9tal")));
        QCoreApplication::installTranslator(&translator);
        QTRY_VERIFY(told().contains(QStringLiteral("m\u00e9tal")));
        QCoreApplication::removeTranslator(&translator);
    }

    void theTitleOfTheBraceletSaysWhatIsPlayedAndThatItHasEnded() {
        openArm();
        const auto* view = m_window->operatePage().findChild<bracelet::BraceletView*>();
        const auto& bracelet = m_window->bracelet();
        const QString name = QString::fromStdString(pattern::findBuiltIn("stiffness.E.dynamic")->name);
        const auto says = [&](const QString& text) { return view->accessibleDescription().contains(text); };
        QTRY_VERIFY_WITH_TIMEOUT(bracelet.isFeedbackPlaying(), 30'000);
        QTRY_VERIFY(says(name));
        QVERIFY(!says(QStringLiteral("Nothing is played")));
        m_window->operatePage().armViews().setProgramRunning(false); // no other touch
        QTRY_VERIFY_WITH_TIMEOUT(says(QStringLiteral("Nothing is played (last: ")), 30'000);
        QVERIFY(says(name));
    }

    void whatWasFoundIsForgottenWhenTheProgramBeginsAnew() {
        openArm();
        const auto* touches = child<touch::TouchTable>();
        const auto* gauge = child<touch::StiffnessGauge>();
        auto& sheet = child<touch::RunSheet>()->model();
        QTRY_COMPARE_WITH_TIMEOUT(sheet.rowCount(), 1, 30'000);
        const std::uint64_t number = sheet.object(0).number;
        sheet.rename(number, QStringLiteral("post"));
        QTRY_VERIFY(touches->touches() > 0 && gauge->content().touch);
        QTest::keyClick(m_window.get(), Qt::Key_F5, Qt::ControlModifier);
        QTRY_COMPARE(touches->touches(), 0);
        QCOMPARE(sheet.rowCount(), 0);
        QVERIFY(!gauge->content().touch);
        QVERIFY(!child<touch::PatternMapTable>()->recognisedRow());
        QVERIFY(!sheet.undoStack().canUndo());
        // The same object is the first one again, without the name of before.
        QTRY_COMPARE_WITH_TIMEOUT(sheet.rowCount(), 1, 30'000);
        QCOMPARE(sheet.object(0).number, number);
        QVERIFY(sheet.nameOf(number).isEmpty());
        QCOMPARE(touches->touches(), 1);
    }

    void jogsWhileTheDeadManIsHeldAndStandsStillAfterwards() {
        openArm();
        auto* jog = child<touch::JogPanel>();
        jog->setSpeed(100);
        jog->setFocus();
        const double before_rad = arm()->snapshot().newest.reference_rad[0];
        QTest::keyPress(jog, Qt::Key_Shift);
        QTest::keyPress(jog, Qt::Key_A, Qt::ShiftModifier);
        QTRY_COMPARE(arm()->snapshot().drive, ArmDrive::jog);
        QTRY_VERIFY(arm()->snapshot().newest.reference_rad[0] < before_rad - 0.02);
        QTest::keyRelease(jog, Qt::Key_A, Qt::ShiftModifier);
        QTest::keyRelease(jog, Qt::Key_Shift);
        QTRY_COMPARE(arm()->snapshot().drive, ArmDrive::held);
        const double after_rad = arm()->snapshot().newest.reference_rad[0];
        const auto samples = arm()->snapshot().samplesProcessed;
        QTRY_VERIFY(arm()->snapshot().samplesProcessed > samples + 200);
        QCOMPARE(arm()->snapshot().newest.reference_rad[0], after_rad);
        m_window->operatePage().armViews().setProgramRunning(true);
        QTRY_COMPARE(arm()->snapshot().drive, ArmDrive::program);
    }

    void theZeroThatEndsAJogGoesToTheArmThatWasJogged() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        core::StopSwitch stop;
        console::BraceletService station(stop);
        console::ArmViews views(stop, station, scene, &parent);
        ScriptedChannel former;
        ScriptedChannel next;
        former.tell();
        next.tell();
        QVERIFY(former.channel->update() && next.channel->update());
        views.setArm(former.channel, base::Provenance::live);
        views.setHand(touch::HandMotion{}, {});
        views.setHand(touch::HandMotion{{1.0, 0.0, 0.0}, true}, {});
        QVERIFY(!former.arm->commands.empty());
        QVERIFY(former.arm->commands.back().rate_radPerS != core::JointVector::zeros(4));
        views.setArm(next.channel, base::Provenance::live);
        QCOMPARE(former.arm->commands.back().rate_radPerS, core::JointVector::zeros(4));
        QVERIFY(next.arm->commands.empty());
    }

    void anArmWhoseReadingsWaitOnTheWayIsNotMoved() {
        QWidget parent;
        view3d::Scene3dView scene(&parent);
        core::StopSwitch stop;
        console::BraceletService station(stop);
        console::ArmViews views(stop, station, scene, &parent);
        const auto* panel = parent.findChild<touch::JogPanel*>();
        ScriptedChannel arm; // whose device never says that anything is wrong
        arm.tell();
        views.setArm(arm.channel, base::Provenance::live);
        views.tick();
        QVERIFY2(panel->refusal().isEmpty(), qPrintable(panel->refusal()));
        QTRY_VERIFY((views.tick(), panel->refusal().contains(QLatin1String("old"))));
        arm.tell();
        views.tick();
        QVERIFY2(panel->refusal().isEmpty(), "it tells again");
    }

    void stopHaltsArmAndBracelet() {
        openArm();
        auto& bracelet = m_window->bracelet();
        QTRY_VERIFY(bracelet.isReady());
        bracelet.play(playback::programOf(*pattern::findBuiltIn("stiffness.E.static")), false);
        QTRY_VERIFY(bracelet.given()[0] > 0.5);
        QTest::keyClick(m_window.get(), Qt::Key_Period, Qt::ControlModifier);
        QVERIFY(m_stop->engaged());
        QTRY_COMPARE(bracelet.given(), core::Intensities{});
        QTRY_COMPARE(arm()->snapshot().drive, ArmDrive::stopped);
        QVERIFY(!bracelet.isReady());
        QVERIFY(!child<touch::JogPanel>()->refusal().isEmpty());
    }

    void aStationEndsWhileItsBraceletsAreBeingOpenedAndClosed() {
        for (int i = 0; i < 20; ++i) {
            core::StopSwitch stop; // which devices must not look at any more
            console::BraceletService station(stop);
            for (const BraceletChoice choice :
                 {BraceletChoice::simulated, BraceletChoice::none, BraceletChoice::simulated}) {
                station.choose(choice);
                if (i % 2 == 1)
                    station.tick();
            }
        }
        core::StopSwitch stop;
        console::BraceletService station(stop);
        station.choose(BraceletChoice::simulated);
        station.choose(BraceletChoice::none);
        station.choose(BraceletChoice::simulated);
        station.tick();
        QTRY_VERIFY((station.tick(), station.isReady()));
    }

    void anObjectPickedInTheReconstructionIsSelectedOnTheRunSheet() {
        openArm();
        auto* sheet = child<touch::RunSheet>();
        QTRY_COMPARE_WITH_TIMEOUT(sheet->model().rowCount(), 1, 30'000);
        auto* scene = child<view3d::Scene3dView>();
        const auto* selection = sheet->view()->selectionModel();
        emit scene->objectPicked(sheet->model().object(0).number + 1); // gone meanwhile
        QVERIFY(!selection->hasSelection());
        emit scene->objectPicked(sheet->model().object(0).number);
        QVERIFY(selection->isRowSelected(0));
    }

    void whatWasTypedOnTheRunSheetIsThereAgainAfterALookAtAnotherSource() {
        openArm();
        const auto& sheet = child<touch::RunSheet>()->model();
        QTRY_COMPARE_WITH_TIMEOUT(sheet.rowCount(), 1, 30'000);
        child<touch::RunSheet>()->model().rename(sheet.object(0).number, QStringLiteral("post"));
        const int touches = child<touch::TouchTable>()->touches();
        const auto samples = child<charts::JointChartView>()->history().size();
        QVERIFY(touches > 0 && samples > 0);
        const auto armKey = m_window->sources().items().front().key;
        ConsoleOptions other;
        other.scenes = {QStringLiteral(":/scenes/tactile-indenter.toml")};
        m_window->openRequested(other);
        QTRY_COMPARE_WITH_TIMEOUT(sheet.rowCount(), 0, 20'000);
        QVERIFY(!child<touch::RunSheet>()->model().undoStack().canUndo());
        QCOMPARE(child<touch::TouchTable>()->touches(), 0);
        QVERIFY(child<charts::JointChartView>()->history().empty());
        // At once: of a recording that is paused nothing new comes.
        m_window->sources().activate(armKey);
        QCOMPARE(child<touch::TouchTable>()->touches(), touches);
        QVERIFY(child<charts::JointChartView>()->history().size() >= samples);
        QCOMPARE(sheet.rowCount(), 1);
        QCOMPARE(sheet.nameOf(sheet.object(0).number), QStringLiteral("post"));
        QVERIFY(child<touch::RunSheet>()->model().undoStack().canUndo());
    }

    void whatAnArmTouchesWhileAnotherSourceIsShownIsToldWhenItIsShownAgain() {
        openArm();
        const auto channel = m_window->operatePage().armViews().arm();
        const auto armKey = m_window->sources().items().front().key;
        ConsoleOptions other;
        other.scenes = {QStringLiteral(":/scenes/tactile-indenter.toml")};
        m_window->openRequested(other);
        QTRY_VERIFY_WITH_TIMEOUT(arm() == nullptr, 20'000);
        // It meets its object only now.
        channel->restartProgram();
        const auto ready_ns = core::steadyNow_ns();
        const auto hasTouched = [&] {
            (void)channel->update();
            const auto& last = channel->snapshot().lastTouch;
            return last && last->ready_ns > ready_ns;
        };
        QTRY_VERIFY_WITH_TIMEOUT(hasTouched(), 30'000);
        QVERIFY(arm() == nullptr);
        m_window->sources().activate(armKey);
        QTRY_VERIFY(child<touch::StiffnessGauge>()->content().touch.has_value());
        QCOMPARE(child<touch::StiffnessGauge>()->content().touch->material, stiffness::Material::metal);
        QCOMPARE(child<touch::TouchTable>()->touches(), 1);
    }

    void saysThatTheBraceletDoesNotPlayAnArmThatIsNotShown() {
        openArm();
        m_window->bracelet().choose(BraceletChoice::simulated);
        QTRY_VERIFY(m_window->bracelet().isReady());
        const auto remark = [this] { return m_window->operatePage().readings().back().remark; };
        QVERIFY(remark().isEmpty());
        const auto armKey = m_window->sources().items().front().key;
        const QString name = m_window->sources().items().front().name;
        ConsoleOptions other;
        other.scenes = {QStringLiteral(":/scenes/tactile-indenter.toml")};
        m_window->openRequested(other);
        QTRY_VERIFY_WITH_TIMEOUT(arm() == nullptr, 20'000);
        QVERIFY2(remark().contains(name), qPrintable(remark()));
        auto& notices = m_window->operatePage().messages();
        QTRY_COMPARE(notices.count(), 1);
        QTest::mouseClick(notices.findChild<QToolButton*>(QStringLiteral("action")), Qt::LeftButton);
        QCOMPARE(m_window->sources().active()->key, armKey);
        QVERIFY(remark().isEmpty());
        // Nothing is felt of an arm on purpose: no word about it.
        m_window->operatePage().armViews().feedbackPanel().setMode(pipeline::FeedbackMode::off);
        m_window->sources().activate(m_window->sources().items().back().key);
        QVERIFY(arm() == nullptr && remark().isEmpty());
        QCOMPARE(notices.count(), 0);
    }

    void aTactorIsFeltWhileItIsHeld() {
        openArm();
        auto& bracelet = m_window->bracelet();
        auto* view = m_window->operatePage().findChild<bracelet::BraceletView*>();
        QTRY_VERIFY(bracelet.isReady());
        view->setFocus();
        QTRY_VERIFY(view->hasFocus());
        m_window->operatePage().tick();
        QTest::keyPress(view, Qt::Key_3);
        QTRY_VERIFY(bracelet.given()[2] > 0.5);
        QCOMPARE(bracelet.given()[0], 0.0);
        QTest::keyRelease(view, Qt::Key_3);
        QTRY_COMPARE(bracelet.given(), core::Intensities{});
    }

    void thePatternsPageEditsPlaysSavesAndOpensAgain() {
        openArm();
        auto& page = m_window->patternsPage();
        auto* rail = child<chrome::PageRail>();
        emit rail->pageRequested(QStringLiteral("patterns"));
        QVERIFY(page.isVisible());
        auto& bracelet = m_window->bracelet();
        m_window->operatePage().armViews().setProgramRunning(false); // no touch may play in between
        QTRY_VERIFY(bracelet.isReady());
        page.open(QStringLiteral("stiffness.E.static"));
        emit page.editor().playRequested(page.editor().document()->pattern());
        QTRY_VERIFY(bracelet.given()[5] > 0.5);
        QTRY_VERIFY(page.editor().isPlaying());
        emit page.editor().stopRequested();
        QTRY_COMPARE(bracelet.given(), core::Intensities{});
        QTRY_VERIFY(!page.editor().isPlaying());

        page.editor().document()->setName(QStringLiteral("Mine"));
        QVERIFY(page.editor().document()->isDirty());
        const QString path = m_folder.filePath(QStringLiteral("mine.json"));
        page.saveAs(path);
        QTRY_VERIFY(!page.editor().document()->isDirty());
        QCOMPARE(page.editor().document()->path(), path);
        page.open(QStringLiteral("shape.A.static"));
        page.open(path);
        QTRY_COMPARE(page.editor().document()->pattern().name, std::string("Mine"));
        page.open(m_folder.filePath(QStringLiteral("none.json")));
        QTRY_COMPARE(page.messages().count(), 1);
        QCOMPARE(page.editor().document()->pattern().name, std::string("Mine"));
    }

    void anArrayAndAnArmHaveLayoutsOfTheirOwn() {
        openArm();
        auto& docks = m_window->operatePage().docks();
        QCOMPARE(docks.kind(), OperateDocks::Kind::arm);
        // As the option says: before the others behind the same tabs.
        QVERIFY(!child<touch::ContourView>()->visibleRegion().isEmpty());
        QVERIFY(child<charts::JointChartView>()->visibleRegion().isEmpty());
        auto* gauge = m_window->findChild<QDockWidget*>("stiffness");
        auto* touches = m_window->findChild<QDockWidget*>("touches");
        QVERIFY(!gauge->isHidden());
        touches->close();
        m_window->openRequested([] {
            ConsoleOptions options;
            options.scenes = {QStringLiteral(":/scenes/tactile-indenter.toml")};
            return options;
        }());
        QTRY_COMPARE_WITH_TIMEOUT(docks.kind(), OperateDocks::Kind::array, 20'000);
        QVERIFY(gauge->isHidden());
        QVERIFY(!gauge->toggleViewAction()->isVisible());
        m_window->sources().activate(m_window->sources().items().front().key);
        QTRY_COMPARE(docks.kind(), OperateDocks::Kind::arm);
        QVERIFY(!gauge->isHidden());
        QVERIFY(touches->isHidden()); // as it was left
    }
};

int main(int argc, char* argv[]) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    ArmViewsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "arm_views_test.moc"
