// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_file.h"
#include "app/console/sources/source_manager.h"
#include "backend/pipeline/camera_channel.h"
#include "backend/simulation/camera/simulated_tube.h"
#include "backend/vision/calibration/camera_file.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <opencv2/videoio.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace teleta;
using console::SourceManager;

/// A video of the camera in the tube, opened as the console opens it.
class CameraSourceTest : public QObject {
    Q_OBJECT

    static constexpr double kRate_Hz = 10.0;
    QTemporaryDir m_folder;
    std::unique_ptr<simulation::SimulatedTube> m_tube;
    const simulation::SkinPress m_press{.centre = {1.0, 0.03}, .ballRadius_m = 0.01, .depth_m = 0.0012};

    [[nodiscard]] std::string path(const char* name) const { return m_folder.filePath(name).toStdString(); }
    static void poll(SourceManager& sources, const auto& until) {
        QTRY_VERIFY_WITH_TIMEOUT((sources.poll(), until()), 120'000);
    }

private slots:
    void initTestCase() {
        m_tube = std::move(
            *simulation::SimulatedTube::make(*app::readScene(":/scenes/vtacarm-calibration.toml"), 1));
        cv::VideoWriter writer(path("tube.avi"), cv::VideoWriter::fourcc('F', 'F', 'V', '1'), kRate_Hz,
                               {1640, 1232}, false);
        QVERIFY(writer.isOpened());
        cv::Mat1b frame;
        for (int i = 0; i < 60; ++i) {
            if (i < 10)
                m_tube->untouched(frame);
            else if (i == 10)
                m_tube->pressed({m_press}, frame);
            writer.write(frame);
        }
        QVERIFY(vision::writeCamera({.camera = m_tube->camera(), .summary = {}, .others = {}},
                                    path("camera.json")));
    }

    void aVideoBecomesASourceThatShowsTheContact() {
        core::StopSwitch stop;
        SourceManager sources(stop);
        QSignalSpy failed(&sources, &SourceManager::failed);
        const auto key = sources.open(app::CameraRequest{path("tube.avi"), path("camera.json"), false});
        QCOMPARE(sources.find(key)->name, QStringLiteral("tube"));
        QVERIFY(!sources.find(key)->isOpen());
        poll(sources, [&] { return sources.find(key) == nullptr || sources.find(key)->isOpen(); });
        QCOMPARE(failed.count(), 0);
        const auto channel = sources.find(key)->camera();
        QVERIFY(channel != nullptr);
        QVERIFY(channel->description().recorded);
        QTRY_VERIFY_WITH_TIMEOUT((channel->update(), !channel->snapshot().contacts.empty()), 120'000);
        const auto& contact = channel->snapshot().contacts.front().contact;
        const Eigen::Vector3d truth(0.025 * std::cos(m_press.centre.angle_rad),
                                    0.025 * std::sin(m_press.centre.angle_rad), m_press.centre.z_m);
        QVERIFY2((contact.p_Sensor_Centre_m - truth).norm() < 0.001,
                 qPrintable(QString::number((contact.p_Sensor_Centre_m - truth).norm())));
        QTRY_VERIFY_WITH_TIMEOUT(channel->status().state == core::DeviceState::finished, 60'000);
        sources.closeAll();
        QVERIFY(sources.items().empty());
    }

    void whatCannotBeOpenedIsToldWithItsFile() {
        core::StopSwitch stop;
        SourceManager sources(stop);
        std::vector<std::string> failed;
        connect(&sources, &SourceManager::failed, this, [&failed](const QString&, const core::Error& error) {
            failed.push_back(core::describe(error));
        });
        sources.open(app::CameraRequest{path("tube.avi"), path("missing.json"), false});
        poll(sources, [&] { return failed.size() == 1; });
        sources.open(app::CameraRequest{path("missing.avi"), path("camera.json"), false});
        poll(sources, [&] { return failed.size() == 2; });
        sources.open(app::CameraRequest{path("camera.json"), path("camera.json"), false});
        poll(sources, [&] { return failed.size() == 3; });
        sources.open(app::CameraRequest{"9876", path("camera.json"), false});
        poll(sources, [&] { return failed.size() == 4; });
        const std::array<const char*, 4> told{"missing.json", "missing.avi", "camera.json", "9876"};
        for (std::size_t i = 0; i < told.size(); ++i)
            QVERIFY2(failed[i].find(told[i]) != std::string::npos, failed[i].c_str());
        QVERIFY(sources.items().empty());
    }
};

QTEST_MAIN(CameraSourceTest)
#include "camera_source_test.moc"
