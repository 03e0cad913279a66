// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_file.h"
#include "app/console/calibrate/camera/camera_calibrator.h"
#include "app/console/calibrate/camera/live_probing_dialog.h"
#include "app/console/calibrate/camera/live_probing_panel.h"
#include "app/console/calibrate/camera/tube_fields.h"
#include "backend/core/steady_time.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "devices/camera/camera_device.h"
#include "tests/widgets/parts.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include <opencv2/videoio.hpp>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace teleta;
using console::CameraCalibrator;
using core::DeviceState;

namespace {

constexpr double kRate_Hz = 10.0;
/// Six of the holes of the shipped scene.
constexpr vision::HoleGrid kGrid{.around = 3, .along = 2, .first_z_m = 0.015, .last_z_m = 0.045};

std::unique_ptr<simulation::SimulatedTube> tube() {
    scene::Scene scene = *app::readScene(":/scenes/vtacarm-calibration.toml");
    auto& world = std::get<scene::CameraWorld>(scene.world);
    world.probing->around = kGrid.around;
    world.probing->along = kGrid.along;
    world.probing->first_z_m = kGrid.first_z_m;
    world.probing->last_z_m = kGrid.last_z_m;
    world.probing->wrongShare = 0.0;
    // Two touches of the same hole can be told apart.
    scene.effects.push_back({"", scene::SensorNoiseSpec{.read = 1.0, .shot = 2.5}});
    scene.rate_Hz = kRate_Hz;
    scene.duration_s = world.probing->hole_s * static_cast<double>(kGrid.size());
    return std::move(*simulation::SimulatedTube::make(scene, 1));
}

/// A camera whose frames the test gives it.
class HandCamera : public core::CameraSource {
public:
    struct Shared {
        std::mutex mutex;
        std::deque<core::CameraFrame> frames;
        core::DeviceStatus status;
        core::Wakeup* consumer = nullptr;
        double time_s = 0.0;
        bool discontinuity = false;
        bool drained = false; ///< all frames were worked on
        bool hangs = false;   ///< and does not stop
        std::condition_variable changed;

        void give(const cv::Mat1b& image) {
            const std::scoped_lock lock(mutex);
            core::CameraFrame frame;
            frame.image = core::greyImageOf(image.clone());
            frame.capture_s = time_s;
            frame.discontinuity = std::exchange(discontinuity, false);
            time_s += 1.0 / kRate_Hz;
            frames.push_back(std::move(frame));
            drained = false;
            status.state = DeviceState::live;
            if (consumer != nullptr)
                consumer->notify();
        }
        /// Without an event of the GUI's thread.
        void waitUntilDrained() {
            std::unique_lock lock(mutex);
            changed.wait(lock, [this] { return drained; });
        }
        void hang(bool on) {
            const std::scoped_lock lock(mutex);
            hangs = on;
            changed.notify_all();
        }
        void enter(DeviceState state, const std::string& why = {}) {
            const std::scoped_lock lock(mutex);
            status.state = state;
            status.message = why;
            if (state == DeviceState::lost) {
                discontinuity = true;
                time_s = 0.0; // of the next connection
            }
            if (consumer != nullptr)
                consumer->notify();
        }
    };

    explicit HandCamera(std::shared_ptr<Shared> shared)
        : m_shared(std::move(shared)) {}

    [[nodiscard]] const core::CameraDescription& description() const override { return m_description; }
    void start(core::Wakeup& consumer) override {
        const std::scoped_lock lock(m_shared->mutex);
        m_shared->consumer = &consumer;
    }
    void stop() override {
        std::unique_lock lock(m_shared->mutex);
        m_shared->changed.wait(lock, [this] { return !m_shared->hangs; });
        m_shared->consumer = nullptr;
    }
    bool pop(core::CameraFrame& frame) override {
        const std::scoped_lock lock(m_shared->mutex);
        if (m_shared->frames.empty()) {
            m_shared->drained = true;
            m_shared->changed.notify_all();
            return false;
        }
        frame = std::move(m_shared->frames.front());
        m_shared->frames.pop_front();
        return true;
    }
    [[nodiscard]] core::DeviceStatus status() const override {
        const std::scoped_lock lock(m_shared->mutex);
        return m_shared->status;
    }

private:
    std::shared_ptr<Shared> m_shared;
    core::CameraDescription m_description{.name = "hand", .nominalRate_Hz = kRate_Hz};
};

} // namespace

/// A tube that is probed in front of a camera, or of a video of one.
class LiveProbingTest : public QObject {
    Q_OBJECT

    static console::LiveProbing::Opener by(std::shared_ptr<HandCamera::Shared> shared) {
        return [shared]() -> core::Expected<std::unique_ptr<core::CameraSource>> {
            return std::make_unique<HandCamera>(shared);
        };
    }
    static void expectNear(const vision::CalibrationPair& pair, const vision::CylinderCamera& camera) {
        const auto truth = camera.camera().project(pair.p_Sensor_m);
        QVERIFY(truth.has_value());
        QVERIFY2((pair.pixel - *truth).norm() < 4.0,
                 qPrintable(QString::number((pair.pixel - *truth).norm())));
    }

private slots:
    void aVideoOfAProbingGivesThePairsOfAllHoles() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("probing.avi").toStdString();
        const auto world = tube();
        {
            cv::VideoWriter writer(path, cv::VideoWriter::fourcc('F', 'F', 'V', '1'), kRate_Hz, {1640, 1232},
                                   false);
            QVERIFY(writer.isOpened());
            cv::Mat1b frame;
            world->untouched(frame);
            writer.write(frame);
            while (world->time_s() < world->probing()->duration_s()) {
                world->next({}, frame);
                writer.write(frame);
            }
        }
        CameraCalibrator calibrator;
        calibrator.resize(1400, 900);
        calibrator.show();
        QVERIFY(QTest::qWaitForWindowActive(&calibrator));
        QSignalSpy told(&calibrator, &CameraCalibrator::message);
        calibrator.probeWith(
            [path]() -> core::Expected<std::unique_ptr<core::CameraSource>> {
                auto feed = camera::CameraDevice::open({.source = path, .paced = false});
                if (!feed)
                    return core::Unexpected(feed.error());
                return std::unique_ptr<core::CameraSource>(std::move(*feed));
            },
            kGrid);
        QVERIFY(calibrator.live().isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.live().isRunning(), 240'000);
        QCOMPARE(calibrator.work().pairs.size(), kGrid.size());
        for (std::size_t i = 0; i < kGrid.size(); ++i) {
            const vision::CalibrationPair& pair = calibrator.work().pairs[i];
            QVERIFY((pair.p_Sensor_m - vision::holesOnSkin_m(kGrid, {})[i]).norm() < 1e-12);
            expectNear(pair, world->camera());
        }
        QVERIFY(!calibrator.work().simulated);
        QVERIFY(!calibrator.live().isVisible());
        QCOMPARE(told.count(), 1);
        QVERIFY(told[0][0].toString().contains("All holes"));
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
    }

    void aPersonSkipsGoesBackTakesBackAndGoesOnAfterTheCameraWasLost() {
        const auto world = tube();
        const std::vector<Eigen::Vector3d> holes_m = vision::holesOnSkin_m(kGrid, {});
        auto shared = std::make_shared<HandCamera::Shared>();
        CameraCalibrator calibrator;
        calibrator.resize(1400, 900);
        calibrator.show();
        QVERIFY(QTest::qWaitForWindowActive(&calibrator));
        console::LiveProbingPanel& live = calibrator.live();
        QSignalSpy begun(&live, &console::LiveProbingPanel::begun);
        calibrator.probeWith(by(shared), kGrid);
        QVERIFY(live.stateText().contains("first frame"));
        cv::Mat1b untouched;
        world->untouched(untouched);
        shared->give(untouched);
        QVERIFY(begun.wait(60'000));
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Press the stick"), 60'000);
        const auto lift = [&] {
            shared->give(untouched);
            shared->give(untouched);
        };
        const auto press = [&](std::size_t hole) {
            cv::Mat1b frame;
            for (int i = 0; i < 6; ++i) {
                world->pressed({{.centre = {kGrid.angle_rad(hole), kGrid.z_m(hole)},
                                 .ballRadius_m = 0.008,
                                 .depth_m = 0.001}},
                               frame);
                shared->give(frame);
            }
        };
        QCOMPARE(live.hole(), std::size_t(0));
        QVERIFY(live.holeText().startsWith("Hole 1 of 6: ring 1"));
        QVERIFY(calibrator.shown().next_m.has_value());
        press(0);
        QTRY_COMPARE_WITH_TIMEOUT(calibrator.work().pairs.size(), std::size_t(1), 60'000);
        QTRY_VERIFY(live.stateText().contains("Lift"));
        QCOMPARE(live.hole(), std::size_t(1));
        // The second one cannot be reached.
        QTest::mouseClick(test::part(live, "skip"), Qt::LeftButton);
        QCOMPARE(live.hole(), std::size_t(2));
        lift();
        press(2);
        QTRY_COMPARE_WITH_TIMEOUT(calibrator.work().pairs.size(), std::size_t(2), 60'000);
        QCOMPARE(calibrator.work().pairs[1].p_Sensor_m, holes_m[2]);
        // Taken back: it is next again.
        QTest::keyClick(&calibrator, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(calibrator.work().pairs.size(), std::size_t(1));
        QCOMPARE(live.hole(), std::size_t(2));
        QVERIFY(live.isRunning());
        // The camera is gone for a while.
        shared->enter(DeviceState::lost, "unplugged");
        QTRY_VERIFY(live.stateText().contains("unplugged"));
        lift();
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Press the stick"), 60'000);
        press(2);
        QTRY_COMPARE_WITH_TIMEOUT(calibrator.work().pairs.size(), std::size_t(2), 60'000);
        expectNear(calibrator.work().pairs[1], world->camera());
        // A hole that is probed again has one pair.
        QTest::mouseClick(test::part(live, "back"), Qt::LeftButton);
        QCOMPARE(live.hole(), std::size_t(2));
        const Eigen::Vector2d before = calibrator.work().pairs[1].pixel;
        lift();
        press(2);
        QTRY_VERIFY_WITH_TIMEOUT(calibrator.work().pairs[1].pixel != before, 60'000);
        QCOMPARE(calibrator.work().pairs.size(), std::size_t(2));
        QCOMPARE(live.hole(), std::size_t(3));
        QTest::mouseClick(test::part(live, "stop"), Qt::LeftButton);
        QVERIFY(!live.isRunning());
        QVERIFY(!calibrator.shown().next_m.has_value());
        QCOMPARE(calibrator.work().pairs.size(), std::size_t(2));
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
    }

    void aCameraThatGivesNoFrameIsToldAndDoesNotHoldUpTheEnd() {
        CameraCalibrator calibrator;
        auto shared = std::make_shared<HandCamera::Shared>();
        calibrator.probeWith(by(shared), kGrid);
        QTRY_VERIFY_WITH_TIMEOUT(calibrator.live().stateText().contains("sends no frames"), 60'000);
        QVERIFY(calibrator.live().isRunning());
        calibrator.live().cancel();
        QVERIFY(!calibrator.live().isRunning());
    }

    void aSourceThatDoesNotOpenIsToldWithItsName() {
        CameraCalibrator calibrator;
        QSignalSpy told(&calibrator, &CameraCalibrator::message);
        calibrator.probeWith(console::cameraOpener("/nowhere/probing.avi", {}), kGrid);
        QVERIFY(told.wait(60'000));
        QVERIFY(told[0][1].toBool());
        QVERIFY(told[0][0].toString().contains("/nowhere/probing.avi"));
        QVERIFY(!calibrator.live().isRunning());
    }

    void aTouchAcrossSkipOrUndoIsNotFiledUnderAnotherHole() {
        const auto world = tube();
        auto shared = std::make_shared<HandCamera::Shared>();
        CameraCalibrator calibrator;
        calibrator.resize(1400, 900);
        calibrator.show();
        QVERIFY(QTest::qWaitForWindowActive(&calibrator));
        console::LiveProbingPanel& live = calibrator.live();
        calibrator.probeWith(by(shared), kGrid);
        cv::Mat1b untouched;
        world->untouched(untouched);
        shared->give(untouched);
        shared->give(untouched);
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Press the stick"), 60'000);
        const auto press = [&](std::size_t hole, int frames) {
            cv::Mat1b frame;
            for (int i = 0; i < frames; ++i) {
                world->pressed({{.centre = {kGrid.angle_rad(hole), kGrid.z_m(hole)},
                                 .ballRadius_m = 0.008,
                                 .depth_m = 0.001}},
                               frame);
                shared->give(frame);
            }
        };
        // It has begun, but is not steady yet.
        press(0, 2);
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Hold still"), 60'000);
        QTest::mouseClick(test::part(live, "skip"), Qt::LeftButton);
        QCOMPARE(live.hole(), std::size_t(1));
        press(0, 6);
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Lift the stick first"), 60'000);
        shared->waitUntilDrained();
        shared->give(untouched);
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Press the stick"), 60'000);
        QVERIFY(calibrator.work().pairs.empty());
        // It is steady, but nobody has heard of it yet.
        press(1, 6);
        shared->waitUntilDrained();
        QTest::mouseClick(test::part(live, "back"), Qt::LeftButton);
        QCOMPARE(live.hole(), std::size_t(0));
        shared->give(untouched);
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Press the stick"), 60'000);
        QVERIFY(calibrator.work().pairs.empty());
        // Taken back while the next hole is touched.
        press(0, 6);
        QTRY_COMPARE_WITH_TIMEOUT(calibrator.work().pairs.size(), std::size_t(1), 60'000);
        shared->give(untouched);
        press(1, 2);
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Hold still"), 60'000);
        QTest::keyClick(&calibrator, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(live.hole(), std::size_t(0));
        press(1, 6);
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Lift the stick first"), 60'000);
        shared->waitUntilDrained();
        shared->give(untouched);
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Press the stick"), 60'000);
        QVERIFY(calibrator.work().pairs.empty());
        press(0, 6);
        QTRY_COMPARE_WITH_TIMEOUT(calibrator.work().pairs.size(), std::size_t(1), 60'000);
        expectNear(calibrator.work().pairs[0], world->camera());
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
    }

    void ofSeveralPairsThatAreTakenBackTheFirstOnesHoleIsNext() {
        const std::vector<Eigen::Vector3d> holes_m = vision::holesOnSkin_m(kGrid, {});
        CameraCalibrator calibrator;
        calibrator.probeWith(by(std::make_shared<HandCamera::Shared>()), kGrid);
        for (std::size_t i = 0; i < 4; ++i)
            calibrator.addPair({{100.0 + 10.0 * static_cast<double>(i), 200.0}, holes_m[i]});
        QCOMPARE(calibrator.live().hole(), std::size_t(4));
        calibrator.removePairs({1, 2, 3});
        QCOMPARE(calibrator.live().hole(), std::size_t(1));
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
    }

    void undoBringsNoSimulatedPairsUnderThoseOfACamera() {
        CameraCalibrator calibrator;
        console::LiveProbingPanel& live = calibrator.live();
        QSignalSpy begun(&live, &console::LiveProbingPanel::begun);
        cv::Mat1b untouched;
        tube()->untouched(untouched);
        const auto probe = [&] {
            auto shared = std::make_shared<HandCamera::Shared>();
            calibrator.probeWith(by(shared), kGrid);
            shared->give(untouched);
            QVERIFY(begun.wait(60'000));
        };
        calibrator.probe();
        QTRY_VERIFY_WITH_TIMEOUT(calibrator.work().simulated, 60'000);
        probe();
        QVERIFY(!calibrator.work().simulated);
        calibrator.undoStack().undo();
        QVERIFY(calibrator.work().simulated);
        QVERIFY(!live.isRunning());
        // Nor by the undo of a loading that was before the probing.
        calibrator.setPairs({});
        probe();
        QVERIFY(live.isRunning());
        calibrator.undoStack().undo();
        QVERIFY(calibrator.work().simulated);
        QVERIFY(!live.isRunning());
        // Nor pairs of another image.
        vision::CalibrationSettings other = calibrator.work().settings;
        other.width_px /= 2;
        calibrator.setPairs({});
        calibrator.setSettings(other);
        probe();
        QCOMPARE(calibrator.work().settings.width_px, untouched.cols);
        calibrator.undoStack().undo();
        QCOMPARE(calibrator.work().settings.width_px, other.width_px);
        QVERIFY(!live.isRunning());
        QTRY_VERIFY_WITH_TIMEOUT(!calibrator.isBusy(), 60'000);
    }

    void theImageThatIsSetIsAskedOfTheCameraAndStaysWhileItProbes() {
        const vision::CalibrationSettings settings{1280, 960, {}};
        const camera::CameraConfig config = console::probingCamera("2", settings);
        QCOMPARE(config.source, std::string("2"));
        QCOMPARE(config.width_px, 1280);
        QCOMPARE(config.height_px, 960);
        CameraCalibrator calibrator;
        const auto* fields = calibrator.findChild<console::TubeFields*>();
        QVERIFY(fields->isEnabled());
        calibrator.probeWith(by(std::make_shared<HandCamera::Shared>()), kGrid);
        QVERIFY(!fields->isEnabled());
        calibrator.live().cancel();
        QVERIFY(fields->isEnabled());
    }

    void aCameraThatHangsHoldsUpNeitherTheEndNorTheNextProbing() {
        auto hung = std::make_shared<HandCamera::Shared>();
        auto other = std::make_shared<HandCamera::Shared>();
        CameraCalibrator calibrator;
        console::LiveProbingPanel& live = calibrator.live();
        calibrator.probeWith(by(hung), kGrid);
        hung->waitUntilDrained();
        hung->hang(true);
        live.cancel();
        QVERIFY(!live.isRunning());
        calibrator.probeWith(by(other), kGrid);
        QVERIFY(live.isRunning());
        QVERIFY(live.stateText().contains("first frame"));
        hung->hang(false);
        cv::Mat1b untouched;
        tube()->untouched(untouched);
        other->give(untouched);
        other->give(untouched);
        QTRY_VERIFY_WITH_TIMEOUT(live.stateText().contains("Press the stick"), 60'000);
    }

    void aFrameWithoutDotsIsNoReferenceAndTheNextOneIsTried() {
        CameraCalibrator calibrator;
        auto shared = std::make_shared<HandCamera::Shared>();
        calibrator.probeWith(by(shared), kGrid);
        shared->give(cv::Mat1b(1232, 1640, std::uint8_t{90}));
        QTRY_VERIFY_WITH_TIMEOUT(
            calibrator.live().stateText().contains("Waiting for a frame in which nothing touches"), 60'000);
        cv::Mat1b untouched;
        tube()->untouched(untouched);
        shared->give(untouched);
        QTRY_VERIFY_WITH_TIMEOUT(calibrator.live().stateText().contains("Press the stick"), 60'000);
    }
};

QTEST_MAIN(LiveProbingTest)
#include "live_probing_test.moc"
