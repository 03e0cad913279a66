// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/input_events.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/controls/status_glyph.h"
#include "widgets/base/theme.h"
#include "widgets/camera/scene/scene_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

using namespace teleta;
using camera::ScenePanel;
using camera::ScenePicture;
using camera::SceneReading;
using camera::SceneTile;
using core::DeviceState;

/// The dock with the pictures of cameras that are only looked at.
class ScenePanelTest : public QObject {
    Q_OBJECT

    static constexpr std::int64_t kSecond_ns = 1'000'000'000;

    static core::ColourImage filled(int width_px, int height_px, const QColor& colour) {
        auto bytes = std::make_shared<std::vector<std::uint8_t>>();
        for (int i = 0; i < width_px * height_px; ++i)
            for (const int part : {colour.red(), colour.green(), colour.blue()})
                bytes->push_back(static_cast<std::uint8_t>(part));
        return {{bytes, bytes->data()}, width_px, height_px};
    }
    static SceneReading live(double age_s, double now_s, double rate_Hz = 30.0) {
        return {.state = DeviceState::live,
                .age_s = age_s,
                .rate_Hz = rate_Hz,
                .reason = {},
                .now_ns = static_cast<std::int64_t>(now_s * 1e9)};
    }
    static QString numbersOf(const SceneTile& tile) {
        return tile.picture()
            .numbers.join(QLatin1Char(' '))
            .remove(QChar(0x2007))
            .replace(QChar(0xa0), QLatin1Char(' '));
    }
    static QPoint middleOf(const SceneTile& tile) {
        return tile.picture().imageRect(QSizeF(tile.size())).center().toPoint();
    }
    static QColor shownAt(SceneTile& tile, const QPoint& point) {
        return tile.grab().toImage().pixelColor(point);
    }

private slots:
    void aPictureIsShownInItsColoursAndItsShape() {
        SceneTile tile;
        tile.resize(400, 400);
        tile.setName(QStringLiteral("front"));
        const QColor red(200, 30, 10);
        tile.setImage(filled(64, 32, red));
        tile.setReading(live(0.01, 1.0));
        QCOMPARE(shownAt(tile, middleOf(tile)), red);
        const QRectF place = tile.picture().imageRect(QSizeF(tile.size()));
        QCOMPARE(place.width(), 400.0);
        QCOMPARE(place.height(), 200.0);
        const QColor ground = tile.palette().color(QPalette::Base);
        QCOMPARE(shownAt(tile, {200, static_cast<int>(place.bottom()) + 5}), ground);
        QCOMPARE(shownAt(tile, {200, static_cast<int>(place.top()) - 5}), ground);
        tile.resize(120, 30);
        QVERIFY(!tile.grab().isNull());
        tile.resize(4, 4);
        QVERIFY(!tile.grab().isNull());
    }

    void thePixelsAreSharedAndStayWhileTheyAreNeeded() {
        core::ColourImage image = filled(8, 8, Qt::blue);
        const std::weak_ptr<const std::uint8_t> pixels = image.pixels;
        ScenePicture picture;
        picture.image = std::move(image);
        QImage shared = picture.shared();
        QCOMPARE(static_cast<const void*>(shared.constBits()), static_cast<const void*>(pixels.lock().get()));
        picture.image = {};
        QVERIFY(!pixels.expired());
        QCOMPARE(shared.pixelColor(3, 3), QColor(Qt::blue));
        shared = {};
        QVERIFY(pixels.expired());
        QVERIFY(picture.shared().isNull());
    }

    void theNumbersSayTheSizeTheRateAndTheGreatestAge() {
        SceneTile tile;
        tile.setImage(filled(640, 480, Qt::gray));
        tile.setReading(live(0.012, 1.0));
        QCOMPARE(numbersOf(tile), QStringLiteral("640 \u00d7 480 30.0 Hz 12 ms"));
        // They stay for half a second, whatever comes.
        tile.setReading(live(0.034, 1.2));
        tile.setReading(live(0.008, 1.4));
        QCOMPARE(numbersOf(tile), QStringLiteral("640 \u00d7 480 30.0 Hz 12 ms"));
        tile.setReading(live(0.002, 1.5));
        QCOMPARE(numbersOf(tile), QStringLiteral("640 \u00d7 480 30.0 Hz 34 ms"));
        tile.setImage(filled(320, 240, Qt::gray));
        tile.setReading(live(0.009, 1.55));
        QVERIFY2(numbersOf(tile).startsWith(QLatin1String("320")), "another size is told at once");
        QVERIFY(tile.accessibleDescription().contains(QLatin1String("live")));
        QVERIFY(tile.accessibleDescription().contains(QLatin1String("320")));
    }

    void whatWaitsForNoNewPictureIsNotPaintedAgain() {
        SceneTile tile;
        tile.resize(300, 300);
        tile.setImage(filled(64, 48, Qt::gray));
        tile.setReading(live(0.01, 1.0));
        tile.show();
        QVERIFY(QTest::qWaitForWindowExposed(&tile));
        QTest::qWait(0);
        struct Counter : QObject {
            int paints = 0;
            bool eventFilter(QObject*, QEvent* event) override {
                paints += event->type() == QEvent::Paint ? 1 : 0;
                return false;
            }
        } counter;
        tile.installEventFilter(&counter);
        for (int i = 1; i < 10; ++i) {
            tile.setReading(live(0.02, 1.0 + 0.03 * i));
            QApplication::processEvents();
        }
        QCOMPARE(counter.paints, 0);
        tile.setImage(filled(64, 48, Qt::red));
        QTRY_COMPARE(counter.paints, 1);
    }

    void aPictureThatIsTooOldIsDimmedWithItsAgeAndTheReason() {
        SceneTile tile;
        tile.resize(400, 340);
        tile.setName(QStringLiteral("front"));
        const QColor white(250, 250, 250);
        tile.setImage(filled(64, 48, white));
        tile.setReading(live(SceneTile::kOldest_s, 1.0));
        const QPoint corner =
            tile.picture().imageRect(QSizeF(tile.size())).topLeft().toPoint() + QPoint(3, 3);
        QCOMPARE(shownAt(tile, corner), white);
        // One picture in five seconds is what a slow camera gives.
        tile.setReading(live(4.0, 1.5));
        QCOMPARE(shownAt(tile, corner), white);
        SceneReading old = live(1.24, 2.0);
        old.state = DeviceState::stale;
        old.reason = QStringLiteral("/front/image_raw is silent");
        tile.setReading(old);
        QCOMPARE(tile.picture().problem, QStringLiteral("No picture for 1.2 s"));
        const QColor dimmed = shownAt(tile, corner);
        QVERIFY(base::contrast(dimmed, Qt::white) >= 4.5);
        // Its numbers are of no picture that is there now.
        QCOMPARE(numbersOf(tile), QStringLiteral("64 \u00d7 48"));
        for (const char* part : {"stale", "No picture for 1.2 s", "/front/image_raw is silent"})
            QVERIFY2(tile.accessibleDescription().contains(QLatin1String(part)),
                     qPrintable(tile.accessibleDescription()));
        tile.setReading(live(0.02, 2.1));
        QCOMPARE(shownAt(tile, corner), white);
        QVERIFY2(numbersOf(tile).endsWith(QLatin1String("20 ms")), "not what it was before");
        QVERIFY(tile.picture().problem.isEmpty());
        // A lost camera is dimmed at once.
        SceneReading lost = live(0.02, 2.2);
        lost.state = DeviceState::lost;
        tile.setReading(lost);
        QCOMPARE(tile.picture().problem, QStringLiteral("No picture for 0.0 s"));
        QCOMPARE(shownAt(tile, corner), dimmed);
    }

    void aPlaybackThatPausesOrEndsIsNotOld() {
        SceneTile tile;
        tile.setImage(filled(64, 48, Qt::gray));
        for (const DeviceState state : {DeviceState::paused, DeviceState::finished}) {
            SceneReading reading = live(100.0, 5.0);
            reading.state = state;
            tile.setReading(reading);
            QVERIFY(tile.picture().problem.isEmpty());
            QVERIFY2(!numbersOf(tile).contains(QLatin1String("ms")), "nor has it an age");
        }
    }

    void beforeTheFirstPictureItSaysThatItWaitsAndWhy() {
        SceneTile tile;
        tile.resize(300, 240);
        tile.setReading({.state = DeviceState::connecting,
                         .age_s = 0.0,
                         .rate_Hz = 0.0,
                         .reason = QStringLiteral("nobody publishes /front/image_raw"),
                         .now_ns = kSecond_ns});
        QVERIFY(!tile.picture().problem.isEmpty());
        QVERIFY(tile.accessibleDescription().contains(QLatin1String("nobody publishes")));
        QVERIFY(!tile.grab().isNull());
    }

    void theColumnsMakeThePicturesLargest() {
        const double shape = 4.0 / 3.0;
        QCOMPARE(ScenePanel::columnsFor(1, shape, {400, 300}, 0), 1);
        // Two in a wide room stand side by side, in a high one below each other.
        QCOMPARE(ScenePanel::columnsFor(2, shape, {800, 300}, 0), 2);
        QCOMPARE(ScenePanel::columnsFor(2, shape, {400, 600}, 0), 1);
        QCOMPARE(ScenePanel::columnsFor(4, shape, {800, 600}, 0), 2);
        QCOMPARE(ScenePanel::columnsFor(3, shape, {1200, 300}, 0), 3);
        // Room that is none changes nothing.
        QCOMPARE(ScenePanel::columnsFor(3, shape, {0, 0}, 20), 1);
    }

    void tilesStayWithTheirCamerasAndDoNotCoverEachOther() {
        ScenePanel panel;
        panel.resize(900, 400);
        panel.setCameras({7, 8, 9});
        SceneTile* const middle = panel.tile(8);
        QVERIFY(middle != nullptr);
        QVERIFY(panel.tile(1) == nullptr);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const QRect all = panel.rect();
        for (const std::uint64_t one : panel.cameras()) {
            QVERIFY(all.contains(panel.tile(one)->geometry()));
            for (const std::uint64_t other : panel.cameras())
                QVERIFY(one == other ||
                        !panel.tile(one)->geometry().intersects(panel.tile(other)->geometry()));
        }
        // The keyboard goes from one to the next.
        panel.tile(7)->setFocus();
        QTRY_COMPARE(QApplication::focusWidget(), panel.tile(7));
        QTest::keyClick(panel.tile(7), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), middle);
        panel.setCameras({8});
        QCOMPARE(panel.tile(8), middle);
        QVERIFY(panel.tile(7) == nullptr);
        QCOMPARE(middle->geometry().width(), panel.width());
        // Wide pictures are laid out as wide ones.
        panel.setCameras({8, 5});
        panel.resize(800, 500);
        panel.tile(8)->setImage(filled(160, 20, Qt::gray));
        panel.tile(5)->setImage(filled(160, 20, Qt::gray));
        QCOMPARE(panel.tile(8)->x(), panel.tile(5)->x());
        panel.setCameras({});
        QVERIFY(panel.cameras().empty());
    }

    void aSavedPictureHasThePixelsOfTheCamera() {
        SceneTile tile;
        tile.resize(200, 150);
        tile.setName(QStringLiteral("front"));
        core::ColourImage image = filled(64, 48, QColor(10, 120, 240));
        tile.setImage(image);
        tile.setReading(live(0.01, 1.0));
        QTemporaryDir folder;
        const QString path = folder.filePath("front.png");
        const base::Figure figure = tile.figure();
        QCOMPARE(figure.name, QStringLiteral("front"));
        QVERIFY(base::saveFigure(figure, path));
        const QImage saved(path);
        QCOMPARE(saved.size(), QSize(64, 48));
        for (const QPoint& point : {QPoint(0, 0), QPoint(63, 0), QPoint(31, 20), QPoint(63, 47)})
            QCOMPARE(saved.pixelColor(point), QColor(10, 120, 240));
        QVERIFY(figure.csv().startsWith(QLatin1String("width_px,height_px,rate_hz,age_ms\n64,48,")));
        // What leaves the program says that it was recorded.
        tile.setProvenance(base::Provenance::recorded);
        core::ColourImage large = filled(640, 480, QColor(10, 120, 240));
        tile.setImage(large);
        QVERIFY(base::saveFigure(tile.figure(), path));
        const QImage labelled(path);
        int other = 0;
        for (int x = 0; x < labelled.width(); ++x)
            for (int y = 0; y < 100; ++y)
                other += labelled.pixelColor(x, y) != QColor(10, 120, 240) ? 1 : 0;
        QVERIFY(other > 100);
        // Without a picture there is nothing in it, and nothing fails.
        SceneTile none;
        QVERIFY(base::saveFigure(none.figure(), path));
    }

    void theMenuAndTheKeyCopyThePicture() {
        ScenePanel panel;
        panel.setCameras({3});
        SceneTile& tile = *panel.tile(3);
        tile.setImage(filled(64, 48, Qt::green));
        QMenu menu;
        tile.populateMenu(menu);
        QVERIFY(menu.actions().size() >= 2);
        QApplication::clipboard()->clear();
        QTest::keyClick(&tile, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->image().size(), QSize(64, 48));
        QSignalSpy failed(&panel, &ScenePanel::exportFailed);
        emit tile.exportFailed(QStringLiteral("full"));
        QCOMPARE(failed.count(), 1);
    }
};

namespace {
const test::Registration<ScenePanelTest> kRegistration;
} // namespace

#include "scene_panel_test.moc"
