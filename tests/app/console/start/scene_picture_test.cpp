// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_file.h"
#include "app/console/start/scene_picture.h"
#include "app/console/start/start_pictures.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <sched.h>
#include <stop_token>

using namespace teleta;
using console::StartPictures;

namespace {

constexpr QSize kSize(112, 80);
constexpr int kPatience_ms = 60'000;

QImage pictureOf(const char* name) {
    const auto scene = app::readScene(std::string(":/scenes/") + name + ".toml");
    const auto picture = scene ? console::scenePicture(*scene, kSize, base::designedPalette(true))
                               : core::Expected<QImage>(core::Unexpected(scene.error()));
    return picture ? *picture : QImage();
}

int pixelsOf(const QImage& picture, QRgb colour) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += picture.pixel(x, y) == colour ? 1 : 0;
    return count;
}

} // namespace

/// Pictures of scenes on the start page.
class ScenePictureTest : public QObject {
    Q_OBJECT

private slots:
    void anArrayShowsWhereItIsPressed_data() {
        QTest::addColumn<QString>("scene");
        QTest::newRow("ball") << "tactile-indenter";
        QTest::newRow("two balls") << "tactile-two-contacts";
        QTest::newRow("servo") << "servo-roll";
    }
    void anArrayShowsWhereItIsPressed() {
        QFETCH(QString, scene);
        const QImage picture = pictureOf(qPrintable(scene));
        QCOMPARE(picture.size(), kSize);
        // The strongest taxel has the last colour of the map; most of the array is not pressed.
        QVERIFY(pixelsOf(picture, base::colourAt(base::cividis(), 1.0)) > 0);
        QVERIFY(pixelsOf(picture, base::colourAt(base::cividis(), 0.0)) > kSize.width() * kSize.height() / 4);
    }

    void anArmShowsItsLinksAndWhatItTouches() {
        const QImage picture = pictureOf("teleta-touch");
        QVERIFY(pixelsOf(picture, base::spaceColours(true).shell.rgb()) > 100);
        QVERIFY(pixelsOf(picture, base::spaceColours(true).joint.rgb()) > 20);
        QVERIFY2(pixelsOf(picture, base::colourAt(base::cividis(), 1.0)) > 4, "the contact");
    }

    void aCameraShowsItsImage() {
        const QImage picture = pictureOf("vtacarm-bump");
        QVERIFY(!picture.isNull());
        const QRgb corner = picture.pixel(0, 0);
        QVERIFY2(pixelsOf(picture, corner) < picture.width() * picture.height() / 2, "it is no flat area");
    }

    void picturesAreMadeOnceAndKept() {
        const QTemporaryDir folder;
        const QString kept = folder.filePath("scenes");
        const QStringList scenes{":/scenes/servo-roll.toml", ":/scenes/no-such-scene.toml",
                                 ":/scenes/tactile-two-contacts.toml"};
        QImage first;
        {
            StartPictures pictures(kept);
            QSignalSpy made(&pictures, &StartPictures::made);
            pictures.request(scenes, kSize, base::designedPalette(false));
            QTRY_COMPARE_WITH_TIMEOUT(made.count(), 2, kPatience_ms);
            QCOMPARE(made[0][0].toString(), scenes[0]);
            QCOMPARE(made[1][0].toString(), scenes[2]);
            first = made[0][1].value<QImage>();
        }
        const QStringList files = QDir(kept).entryList(QDir::Files);
        QCOMPARE(files.size(), 2);
        // A picture that is there is not made again.
        QImage other(kSize, QImage::Format_RGB32);
        other.fill(Qt::magenta);
        for (const QString& file : files)
            QVERIFY(other.save(QDir(kept).filePath(file)));
        StartPictures pictures(kept);
        QSignalSpy made(&pictures, &StartPictures::made);
        pictures.request({scenes[0]}, kSize, base::designedPalette(false));
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 1, kPatience_ms);
        QCOMPARE(made[0][1].value<QImage>().pixel(5, 5), qRgb(255, 0, 255));
        // A damaged one is, and so is one of the other theme.
        for (const QString& file : files) {
            QFile damaged(QDir(kept).filePath(file));
            QVERIFY(damaged.open(QIODevice::WriteOnly));
        }
        pictures.request({scenes[0]}, kSize, base::designedPalette(false));
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 2, kPatience_ms);
        QCOMPARE(made[1][1].value<QImage>().convertToFormat(QImage::Format_RGB32),
                 first.convertToFormat(QImage::Format_RGB32));
        pictures.request({scenes[0]}, kSize, base::designedPalette(true));
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 3, kPatience_ms);
        QCOMPARE(QDir(kept).entryList(QDir::Files).size(), 3);
    }

    void aPictureOfAnotherVersionIsNotUsed() {
        const QTemporaryDir folder;
        const QString before = QCoreApplication::applicationVersion();
        for (const char* version : {"1.0.0", "1.0.1"}) {
            QCoreApplication::setApplicationVersion(QLatin1String(version));
            StartPictures pictures(folder.path());
            QSignalSpy made(&pictures, &StartPictures::made);
            pictures.request({":/scenes/servo-roll.toml"}, kSize, base::designedPalette(false));
            QTRY_COMPARE_WITH_TIMEOUT(made.count(), 1, kPatience_ms);
        }
        QCoreApplication::setApplicationVersion(before);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 2);
    }

    void nothingIsMadeDuringAPause() {
        const QTemporaryDir folder;
        StartPictures pictures(folder.path());
        QSignalSpy made(&pictures, &StartPictures::made);
        pictures.pause();
        pictures.request({":/scenes/servo-roll.toml"}, kSize, base::designedPalette(false));
        pictures.request({":/scenes/tactile-two-contacts.toml"}, kSize, base::designedPalette(false));
        pictures.resume();
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 1, kPatience_ms);
        QCOMPARE(made[0][0].toString(), QString(":/scenes/tactile-two-contacts.toml"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1); // the first was not run
    }

    void aPauseStopsASceneThatIsRunAgainLater() {
        const QStringList scenes{":/scenes/servo-roll.toml", ":/scenes/tactile-two-contacts.toml"};
        StartPictures pictures({});
        QSignalSpy made(&pictures, &StartPictures::made);
        pictures.request(scenes, kSize, base::designedPalette(false));
        pictures.pause();
        pictures.resume();
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 2, kPatience_ms);
        QCOMPARE(made[0][0].toString(), scenes[0]);
        QCOMPARE(made[1][0].toString(), scenes[1]);
    }

    void aSceneIsStoppedWhileItIsRun_data() {
        QTest::addColumn<QString>("scene");
        for (const char* scene : {"tactile-indenter", "servo-roll", "teleta-touch", "vtacarm-bump"})
            QTest::newRow(scene) << scene;
    }
    void aSceneIsStoppedWhileItIsRun() {
        QFETCH(QString, scene);
        const auto read = app::readScene(":/scenes/" + scene.toStdString() + ".toml");
        QVERIFY(read.has_value());
        std::stop_source stop;
        stop.request_stop();
        const auto picture =
            console::scenePicture(*read, kSize, base::designedPalette(true), stop.get_token());
        QVERIFY(!picture.has_value());
        QCOMPARE(picture.error().kind, core::ErrorKind::cancelled);
    }

    /// Linux runs its thread only when no other one wants the processor.
    void theThreadIsIdle() {
        StartPictures pictures({});
        QSignalSpy made(&pictures, &StartPictures::made);
        pictures.request({":/scenes/servo-roll.toml"}, kSize, base::designedPalette(false));
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 1, kPatience_ms);
        int idle = 0;
        for (const QString& task : QDir("/proc/self/task").entryList(QDir::Dirs | QDir::NoDotAndDotDot))
            idle += sched_getscheduler(task.toInt()) == SCHED_IDLE ? 1 : 0;
        QCOMPARE(idle, 1); // it waits for more work
    }
};

QTEST_MAIN(ScenePictureTest)

#include "scene_picture_test.moc"
