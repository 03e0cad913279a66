// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_service.h"
#include "app/console/operate/camera_views.h"
#include "app/console/operate/operate_page.h"
#include "app/console/sources/camera_dialog.h"
#include "app/console/start/start_page.h"
#include "devices/simulated/simulated_camera_device.h"
#include "tests/app/console/operate/operate_bench.h"
#include "tests/support/form_labels.h"
#include "widgets/camera/camera_panel.h"
#include "widgets/camera/camera_view.h"
#include "widgets/camera/event_model.h"
#include "widgets/camera/event_table.h"
#include "widgets/view3d/scene3d_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <future>
#include <vector>

using namespace teleta;
using app::CameraRequest;
using app::SceneRequest;
using console::CameraDialog;
using console::CameraSourceField;
using console::OperateDocks;
using console::OperatePage;
using console::SourceManager;

namespace {

/// A small tube, so that frames are drawn quickly: a tool pokes it after half a second.
constexpr char kScene[] = R"(
name = "poke"
description = "A tool pokes a small tube."
duration_s = 1.2
rate_Hz = 40.0
[camera]
width_px = 410
height_px = 308
focal_length_px = 147.0
behind_m = 0.020
[skin]
radius_m = 0.025
length_m = 0.060
dot_pitch_m = 0.005
dot_diameter_m = 0.002
reach_m = 0.0015
[[finger]]
name = "tool"
radius_m = 0.008
keyframes = [
    { time_s = 0.0, angle_rad = 0.8, z_m = 0.020, depth_m = -0.010 },
    { time_s = 0.4, angle_rad = 0.8, z_m = 0.020, depth_m = 0.003 },
    { time_s = 1.2, angle_rad = 0.8, z_m = 0.020, depth_m = 0.003 },
]
[reaction]
kind = "bump"
speed_m_per_s = 0.02
depth_m = 0.0015
retreat_m = 0.02
[limits]
speed_m_per_s = 0.25
acceleration_m_per_s2 = 5.0
[[effects]]
name = "lens_distortion"
why = "A lens of 160 degrees is no pinhole."
k1 = 0.77777778
k2 = 0.06772487
k4 = 1.11111111
k5 = 0.23809524
)";

} // namespace

/// A simulated camera from its scene file to the views of the Operate page.
class CameraViewsTest : public test::OperateBench {
    Q_OBJECT

    QTemporaryDir m_folder;

    camera::CameraPanel& panel() { return m_page->cameraViews().panel(); }
    camera::EventModel& events() { return m_page->cameraViews().events().model(); }
    bool lists(const QString& event) {
        const camera::EventModel& model = events();
        for (int row = 0; row < model.rowCount(); ++row)
            if (model.index(row, camera::EventModel::event).data().toString() == event)
                return true;
        return false;
    }

private slots:
    void init() {
        makePage();
        QFile file(m_folder.filePath("poke.toml"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(kScene);
        file.close();
        m_sources->open(SceneRequest{file.fileName().toStdString(), 1});
        QSignalSpy failed(m_sources.get(), &SourceManager::failed);
        QVERIFY(comes([&] { return m_sources->active() != nullptr || !failed.isEmpty(); }));
        if (!failed.isEmpty())
            QFAIL(core::describe(failed[0][1].value<core::Error>()).c_str());
    }

    void cleanup() { closePage(); }

    void aPokeIsSeenToldAndTheArmDrawsBack() {
        QVERIFY(m_page->docks().kind() == OperateDocks::Kind::camera);
        QVERIFY(comes([&] { return panel().isEnabled(); }));
        QVERIFY(panel().view().picture().provenance == base::Provenance::simulated);
        QVERIFY(comes([&] { return lists("BUMP"); }));
        QVERIFY(lists("touched"));
        QVERIFY(comes([&] { return lists("restarted"); }));
        const auto readings = m_page->readings();
        QVERIFY(!readings.empty());
        QVERIFY(readings.front().provenance == base::Provenance::simulated);
        QVERIFY(readings.front().displayed > 0);
        QVERIFY(readings.front().latency_s.has_value());
    }

    void anotherRungIsUsedFromTheNextFrameOn() {
        QVERIFY(comes([&] { return panel().isEnabled(); }));
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
        auto* rungs = panel().findChild<QComboBox*>("cameraRung");
        rungs->setFocus();
        QTest::keyClick(rungs, Qt::Key_Down);
        QVERIFY(comes([&] { return panel().view().picture().shown.rung == "paper"; }));
        QCOMPARE(rungs->currentData().toString(), QStringLiteral("paper"));
    }

    void stopTakesTheArmsPermissionUntilTheBoxIsTickedAgain() {
        QVERIFY(comes([&] { return panel().isEnabled(); }));
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
        auto* mayReact = panel().findChild<QCheckBox*>("cameraMayReact");
        QVERIFY(mayReact->isChecked());
        m_stop.engage();
        QVERIFY(comes([&] { return !mayReact->isChecked(); }));
        m_stop.release();
        const std::uint64_t frame = panel().view().picture().shown.frame;
        QVERIFY(comes([&] { return panel().view().picture().shown.frame > frame + 2; }));
        QVERIFY(!mayReact->isChecked());
        QTest::mouseClick(mayReact, Qt::LeftButton, {}, QPoint(8, mayReact->height() / 2));
        QVERIFY(comes([&] { return panel().view().picture().shown.mayReact; }));
        QVERIFY(mayReact->isChecked());
    }

    void anUnpluggedCameraIsToldAndComesBack() {
        QVERIFY(comes([&] { return panel().isEnabled(); }));
        auto& device =
            dynamic_cast<simulated::SimulatedCameraDevice&>(m_sources->active()->camera()->source());
        device.setFaults({.unplugged = true});
        QVERIFY(comes([&] {
            const core::DeviceState state = m_page->readings().front().state;
            return state == core::DeviceState::lost || state == core::DeviceState::reconnecting;
        }));
        device.setFaults({});
        QVERIFY(comes([&] { return lists("restarted"); }));
        QVERIFY(comes([&] { return m_page->readings().front().rate_Hz > 0.0; }));
    }

    void aCameraThatIsLookedAtAgainListsTheEventsThatItListed() {
        QVERIFY(comes([&] { return lists("BUMP"); }));
        const pipeline::ChannelKey first = m_sources->active()->key;
        m_sources->open(SceneRequest{m_folder.filePath("poke.toml").toStdString(), 2});
        QVERIFY(comes([&] { return m_sources->items().size() == 2 && m_sources->items()[1].isOpen(); }));
        const pipeline::ChannelKey second = m_sources->items()[1].key;
        m_sources->activate(first);
        poll();
        const QString listed = events().csv();
        QVERIFY(listed.contains(",bump,"));
        m_sources->activate(second);
        poll();
        const QString listedOfSecond = events().csv();
        m_sources->activate(first);
        QVERIFY(events().csv().startsWith(listed));
        m_sources->activate(second);
        QVERIFY(events().csv().startsWith(listedOfSecond));
    }

    void whatACameraSeesWhileAnotherIsShownIsToldWhenItIsShownAgain() {
        QVERIFY(comes([&] { return lists("BUMP"); }));
        const pipeline::ChannelKey first = m_sources->active()->key;
        const QString listed = events().csv();
        m_sources->open(SceneRequest{m_folder.filePath("poke.toml").toStdString(), 2});
        QVERIFY(comes([&] { return m_sources->active()->key != first; }));
        // A run of the scene is 1.2 s of 40 frames a second.
        const auto frames = [&] { return m_sources->items()[0].camera()->framesProcessed(); };
        const std::uint64_t before = frames();
        QVERIFY(comes([&] { return frames() > before + 100; }));
        m_sources->activate(first);
        const QString now = events().csv();
        QVERIFY(now.startsWith(listed));
        QVERIFY2(now.mid(listed.size()).contains(",begin,"), qPrintable(now.mid(listed.size())));
    }

    void aClosedCameraLeavesNothingBehind() {
        QVERIFY(comes([&] { return panel().isEnabled(); }));
        m_sources->closeAll();
        poll();
        QVERIFY(!panel().isEnabled());
        QVERIFY(m_page->docks().kind() == OperateDocks::Kind::array);
        QVERIFY(m_page->readings().empty() || !m_page->readings().front().active);
    }

    void whileTheFirstSourceOpensThePageIsCalmAndSaysSo() {
        m_sources->closeAll();
        connect(m_page.get(), &OperatePage::closeRequested, m_sources.get(), &SourceManager::close);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
        QVERIFY(m_page->startPage().isVisible());
        const std::string scene = m_folder.filePath("poke.toml").toStdString();
        m_sources->open(SceneRequest{scene, 1});
        // No docks yet, since these may be of another kind: what opens, and a way back.
        auto* cancel = m_page->findChild<QPushButton*>(QStringLiteral("cancelOpening"));
        QVERIFY(cancel != nullptr && cancel->isVisible());
        QVERIFY(!m_page->docks().isVisible());
        const QString headline = cancel->parentWidget()->accessibleName();
        QVERIFY2(headline.contains(m_sources->items().front().name), qPrintable(headline));
        QTest::mouseClick(cancel, Qt::LeftButton);
        QVERIFY(m_sources->items().empty());
        QVERIFY(m_page->startPage().isVisible());
        // The docks appear with those of a camera, and never with others.
        m_sources->open(SceneRequest{scene, 1});
        QVERIFY(comes([&] {
            if (m_page->docks().isVisible() && m_page->docks().kind() != OperateDocks::Kind::camera)
                qFatal("the docks of another kind of source");
            return m_page->docks().isVisible();
        }));
        QVERIFY(panel().isVisible());
        QVERIFY(!cancel->isVisible());
        // What is shown stays while another source opens beside it.
        m_sources->open(SceneRequest{scene, 2});
        QVERIFY(m_page->docks().isVisible() && panel().isVisible());
    }

    void theDialogAsksForACameraAndItsCalibration() {
        CameraDialog dialog({}, nullptr, [] {
            return std::vector<camera::CameraInfo>{{.number = 0, .name = "inside"},
                                                   {.number = 2, .name = {}}};
        });
        QCOMPARE(test::labelsWithBareMnemonic(dialog), QStringList());
        auto* open = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
        QVERIFY(!open->isEnabled());
        QTRY_COMPARE(dialog.request().source, std::string("0")); // once the drivers have answered
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        // Without a calibration it is only looked at.
        QVERIFY(open->isEnabled());
        const app::SourceRequest looking = dialog.sourceRequest();
        QVERIFY(std::holds_alternative<app::SceneCameraRequest>(looking));
        QCOMPARE(std::get<app::SceneCameraRequest>(looking).source, std::string("0"));
        auto* model = dialog.findChild<QLineEdit*>("cameraModel");
        model->setFocus();
        QTest::keyClicks(model, "camera.json");
        QVERIFY(open->isEnabled());
        QVERIFY(!dialog.findChild<QCheckBox*>()->isEnabled()); // a camera does not begin again
        dialog.findChild<QComboBox*>("cameraSource")->setCurrentText("run.avi");
        QVERIFY(dialog.findChild<QCheckBox*>()->isEnabled());
        QCOMPARE(dialog.request().source, std::string("run.avi"));
        QCOMPARE(dialog.request().modelPath, std::string("camera.json"));
        QVERIFY(std::holds_alternative<app::CameraRequest>(dialog.sourceRequest()));
    }

    void aSourceThatWasTypedInStaysWhenTheCamerasAreThere() {
        std::promise<void> drivers;
        const std::shared_future<void> answered = drivers.get_future().share();
        CameraSourceField field({}, [answered] {
            answered.wait();
            return std::vector<camera::CameraInfo>{{.number = 3, .name = "outside"}};
        });
        field.show();
        QVERIFY(QTest::qWaitForWindowExposed(&field));
        auto* box = field.findChild<QComboBox*>("cameraSource");
        QTest::keyClicks(box, "run.avi");
        drivers.set_value();
        QTRY_COMPARE(box->count(), 1);
        QCOMPARE(field.source(), QStringLiteral("run.avi"));
        QCOMPARE(box->itemData(0, Qt::ToolTipRole).toString(), QStringLiteral("outside"));
    }
};

QTEST_MAIN(CameraViewsTest)
#include "camera_views_test.moc"
