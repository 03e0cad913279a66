// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_service.h"
#include "app/console/operate/operate_page.h"
#include "app/console/operate/scene_views.h"
#include "app/console/sources/source_manager.h"
#include "app/sources/source_list.h"
#include "backend/core/device/colour_image.h"
#include "backend/pipeline/recorded/recorded_scene_camera.h"
#include "backend/recording/recorder.h"
#include "tests/app/console/operate/operate_bench.h"
#include "widgets/camera/scene/scene_panel.h"

#include <QDockWidget>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include <memory>
#include <string>
#include <vector>

using namespace teleta;
using camera::SceneTile;
using console::OperateDocks;
using console::OperatePage;
using console::SourceManager;

/// Cameras that are only looked at, from a list of sources to the dock Scene of the Operate page.
class SceneViewsTest : public test::OperateBench {
    Q_OBJECT

    QTemporaryDir m_folder;

    std::string write(const char* name, const std::string& text) {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text.c_str()) < 0)
            qFatal("cannot write %s", name);
        return file.fileName().toStdString();
    }
    void writeVideo(const char* name, const cv::Scalar& bgr) {
        cv::VideoWriter writer(m_folder.filePath(name).toStdString(),
                               cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25.0, {64, 48});
        QVERIFY(writer.isOpened());
        for (int i = 0; i < 25; ++i)
            writer.write(cv::Mat(48, 64, CV_8UC3, bgr));
    }
    camera::ScenePanel& panel() { return m_page->sceneViews().panel(); }
    QDockWidget& dock() { return *m_page->docks().findChild<QDockWidget*>("scene"); }
    SceneTile& tile(std::size_t index) { return *panel().tile(panel().cameras().at(index)); }
    static bool isNear(const core::ColourImage& image, int red, int green, int blue) {
        if (image.isEmpty())
            return false;
        const std::uint8_t* pixel = image.pixels.get() + 3 * (20 * image.width_px + 30);
        return std::abs(pixel[0] - red) < 12 && std::abs(pixel[1] - green) < 12 &&
               std::abs(pixel[2] - blue) < 12;
    }

private slots:
    void initTestCase() {
        writeVideo("red.avi", {20, 40, 200});
        writeVideo("blue.avi", {200, 40, 20});
    }

    void init() {
        makePage();
        m_page->show();
    }

    void cleanup() { closePage(); }

    void aListNamesCamerasAndAFileOverRosIsAListOfItself() {
        const auto list = app::readSourceList(write(
            "list.toml", "[[source]]\nscene_camera = \"red.avi\"\nloop = false\n[[source]]\nscene_camera = "
                         "\"0\"\nwidth_px = 640\nheight_px = 480\nrate_Hz = 15\n"));
        QVERIFY2(list.has_value(), list ? "" : describe(list.error()).c_str());
        QCOMPARE(list->size(), std::size_t{2});
        const auto& video = std::get<app::SceneCameraRequest>(list->front());
        QCOMPARE(video.source, m_folder.filePath("red.avi").toStdString());
        QVERIFY(!video.loop);
        const auto& connected = std::get<app::SceneCameraRequest>(list->back());
        QCOMPARE(connected.source, std::string("0"));
        QCOMPARE(connected.width_px, 640);
        QCOMPARE(connected.height_px, 480);
        QCOMPARE(connected.rate_Hz, 15.0);
        QCOMPARE(app::displayName(connected), QStringLiteral("/dev/video0"));

        const std::string ros =
            write("front.toml", "kind = \"ros_camera\"\nname = \"front\"\ntopic = \"/image\"\n");
        QVERIFY(app::isSourceList(ros));
        const auto alone = app::readSourceList(ros);
        QVERIFY(alone.has_value());
        QCOMPARE(std::get<app::SceneCameraRequest>(alone->front()).source, ros);
        QCOMPARE(app::displayName(alone->front()), QStringLiteral("front"));
        const auto wrong = app::readSourceList(write("wrong.toml", "kind = \"ros_camera\"\ntopics = 3\n"));
        QVERIFY(!wrong.has_value());
        const auto tooWide =
            app::readSourceList(write("wide.toml", "[[source]]\nscene_camera = \"0\"\nwidth_px = -1\n"));
        QVERIFY(!tooWide.has_value());
        QCOMPARE(tooWide.error().where.line, 3);
    }

    void severalCamerasAreShownSideBySide() {
        QVERIFY(dock().isHidden());
        m_sources->open(app::SceneCameraRequest{m_folder.filePath("red.avi").toStdString()});
        m_sources->open(app::SceneCameraRequest{m_folder.filePath("blue.avi").toStdString()});
        QVERIFY(comes([&] { return panel().cameras().size() == 2; }));
        QVERIFY(!dock().isHidden());
        QVERIFY(m_page->docks().kind() == OperateDocks::Kind::scene);
        QVERIFY(comes([&] {
            return isNear(tile(0).picture().image, 200, 40, 20) &&
                   isNear(tile(1).picture().image, 20, 40, 200);
        }));
        QCOMPARE(tile(0).accessibleName(), QStringLiteral("Picture of red.avi"));
        QVERIFY(tile(0).picture().provenance == base::Provenance::recorded);
        QVERIFY(comes([&] { return tile(0).picture().numbers.size() == 3; }));
        const auto readings = m_page->readings();
        QCOMPARE(readings.size(), std::size_t{2});
        QVERIFY(readings[0].displayed > 0 && readings[1].displayed > 0);
        QVERIFY(readings[0].latency_s.has_value());
    }

    void aCameraDoesNotTakeThePlaceOfAnArray() {
        m_sources->open(app::SceneRequest{":/scenes/teleta-touch.toml"});
        QVERIFY(comes([&] { return m_sources->active() != nullptr; }));
        const auto array = m_sources->active()->key;
        QVERIFY(dock().isHidden());
        QAction* const action = dock().toggleViewAction();
        QVERIFY(!action->isEnabled());
        const auto key = m_sources->open(app::SceneCameraRequest{m_folder.filePath("red.avi").toStdString()});
        QVERIFY(comes([&] { return panel().tile(key) != nullptr && !tile(0).picture().isEmpty(); }));
        QCOMPARE(m_sources->active()->key, array);
        QVERIFY(!dock().isHidden());
        QVERIFY(action->isEnabled());
        // A person closes it; it stays closed until it is opened, or another camera comes.
        action->trigger();
        QVERIFY(dock().isHidden());
        m_sources->activate(key);
        QVERIFY(m_page->docks().kind() == OperateDocks::Kind::scene);
        m_sources->activate(array);
        QVERIFY(dock().isHidden());
        action->trigger();
        QVERIFY(!dock().isHidden());
        // Maximised, it is alone until the camera goes.
        m_page->docks().setMaximised(QStringLiteral("scene"));
        QCOMPARE(m_page->docks().maximised(), QStringLiteral("scene"));
        m_sources->close(key);
        QVERIFY(comes([&] { return panel().cameras().empty(); }));
        QVERIFY(dock().isHidden());
        QVERIFY(m_page->docks().maximised().isEmpty());
        QVERIFY(!m_page->docks().findChild<QDockWidget*>("heatmap")->isHidden());
        m_sources->open(app::SceneCameraRequest{m_folder.filePath("blue.avi").toStdString()});
        QVERIFY(comes([&] { return !panel().cameras().empty(); }));
        QVERIFY(!dock().isHidden());
    }

    void aVideoThatEndsKeepsItsLastPictureUndimmed() {
        m_sources->open(
            app::SceneCameraRequest{.source = m_folder.filePath("red.avi").toStdString(), .loop = false});
        QVERIFY(comes([&] {
            return !panel().cameras().empty() && tile(0).picture().state == core::DeviceState::finished;
        }));
        QVERIFY(isNear(tile(0).picture().image, 200, 40, 20));
        QVERIFY(tile(0).picture().problem.isEmpty());
    }

    void aRecordingIsPlayedInColour() {
        const std::string path = m_folder.filePath("run.teleta").toStdString();
        {
            auto recorder = recording::Recorder::start(path, {});
            QVERIFY(recorder.has_value());
            const auto tap = (*recorder)->addStream(
                pipeline::sceneCameraStream("front-scene", {.name = "front", .nominalRate_Hz = 10.0}));
            for (int i = 0; i < 10; ++i) {
                auto bytes = std::make_shared<std::vector<std::uint8_t>>();
                for (int pixel = 0; pixel < 64 * 48; ++pixel)
                    bytes->insert(bytes->end(), {200, 40, 20});
                core::CameraFrame frame;
                frame.image = core::bytesOf({{bytes, bytes->data()}, 64, 48});
                frame.time_ns = 1'000'000'000 + i * 100'000'000;
                frame.capture_s = 0.1 * i;
                tap->append(frame);
            }
            QVERIFY((*recorder)->stop().has_value());
        }
        const auto requests = app::recordingRequestsOf(path);
        QVERIFY(requests.has_value());
        QCOMPARE(requests->size(), std::size_t{1});
        const auto key = m_sources->open(requests->front());
        QCOMPARE(m_sources->find(key)->name, QStringLiteral("run (front)"));
        QVERIFY(comes([&] {
            return !panel().cameras().empty() && isNear(tile(0).picture().image, 200, 40, 20) &&
                   tile(0).picture().state == core::DeviceState::finished;
        }));
        QCOMPARE(tile(0).picture().name, QStringLiteral("front"));
        QCOMPARE(tile(0).picture().image.width_px, 64);
        QVERIFY(tile(0).picture().provenance == base::Provenance::recorded);
        QVERIFY(m_sources->find(key)->playback() != nullptr);
        QVERIFY(tile(0).picture().problem.isEmpty());
    }

    void aRosCameraThatNobodyPublishesSaysSo() {
        const std::string path =
            write("front.toml", "kind = \"ros_camera\"\nname = \"front\"\ntopic = \"/front/image_raw\"\n"
                                "[ros]\ndomain = 131\ninterface = \"lo\"\n");
        m_sources->open(app::SceneCameraRequest{path});
        QVERIFY(comes([&] {
            return !panel().cameras().empty() &&
                   tile(0).picture().reason == QLatin1String("nobody publishes /front/image_raw");
        }));
        QVERIFY(!tile(0).picture().problem.isEmpty());
        QVERIFY(tile(0).picture().isEmpty());
    }
};

QTEST_MAIN(SceneViewsTest)
#include "scene_views_test.moc"
