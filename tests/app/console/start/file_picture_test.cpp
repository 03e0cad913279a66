// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/start/file_picture.h"
#include "backend/recording/recording_writer.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <stop_token>
#include <vector>

using namespace teleta;
using console::startPicture;
using console::startPictureKey;

namespace {

constexpr QSize kSize(112, 80);
constexpr std::size_t kRows = 2;
constexpr std::size_t kColumns = 4;
constexpr std::int64_t kMillisecond_ns = 1'000'000;

core::Expected<QImage> pictureOf(const QString& place) {
    return startPicture(place, kSize, base::designedPalette(true));
}

/// An array of 2 x 4 taxels whose raw values begin at 5; in the middle of 40 blocks the last taxel of the
/// upper row is loaded.
core::Expected<void> writeRecording(const QString& path, recording::StreamKind kind) {
    recording::RecordingWriter writer(path.toStdString(), std::vector<recording::TimeAnchor>());
    TELETA_CHECK(
        writer.begin({.appVersion = "1", .scene = {}, .sceneText = {}, .configuration = {}, .start_ns = 0}));
    recording::StreamInfo info;
    info.name = "array-frames";
    info.kind = kind;
    info.shape = {kRows, kColumns};
    info.nominalRate_Hz = 100.0;
    TELETA_CHECK(writer.addStream(info));
    for (std::int64_t block = 0; block < 40; ++block) {
        std::vector<float> values(kRows * kColumns, 5.0F);
        if (block >= 15 && block < 25)
            values[kRows * kColumns - 1] = 9.0F;
        core::TappedFrames frames;
        frames.time_ns = {block * 10 * kMillisecond_ns};
        frames.sourceTime_s = {0.01 * static_cast<double>(block)};
        frames.values.resize(values.size() * sizeof(float));
        std::memcpy(frames.values.data(), values.data(), frames.values.size());
        writer.take(0, std::move(frames));
        TELETA_CHECK(writer.commit());
    }
    return writer.finish();
}

} // namespace

/// Pictures of what the start page offers.
class FilePictureTest : public QObject {
    Q_OBJECT

private slots:
    void aRecordingShowsItsStrongestFrame() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("press.teleta");
        const auto written = writeRecording(path, recording::StreamKind::array);
        QVERIFY2(written.has_value(), written ? "" : core::describe(written.error()).c_str());
        const auto picture = pictureOf(path);
        QVERIFY2(picture.has_value(), picture ? "" : core::describe(picture.error()).c_str());
        QCOMPARE(picture->size(), kSize);
        // Cells of 28 px: the last taxel is at the upper right, since rows count upwards.
        const QRgb loaded = base::colourAt(base::cividis(), 1.0);
        const QRgb free = base::colourAt(base::cividis(), 0.0);
        QCOMPARE(picture->pixel(98, 26), loaded);
        QCOMPARE(picture->pixel(98, 54), free);
        QCOMPARE(picture->pixel(14, 26), free);
    }

    void aRecordingWithoutAnArrayOrADamagedOneHasNone() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("other.teleta");
        QVERIFY(writeRecording(path, recording::StreamKind::features).has_value());
        QVERIFY(!pictureOf(path).has_value());
        QFile damaged(folder.filePath("damaged.teleta"));
        QVERIFY(damaged.open(QIODevice::WriteOnly));
        damaged.write("no database");
        damaged.close();
        QVERIFY(!pictureOf(damaged.fileName()).has_value());
        QVERIFY(!pictureOf(folder.filePath("missing.teleta")).has_value());
        QVERIFY(!pictureOf(folder.filePath("table.csv")).has_value());
    }

    void patternsAndStudiesHavePicturesOfTheirStimuli() {
        const auto circle = pictureOf("pattern:shape.A.static");
        const auto triangle = pictureOf("pattern:shape.C.static");
        const auto study = pictureOf("study:rehearsal");
        QVERIFY(circle.has_value() && triangle.has_value() && study.has_value());
        QVERIFY(*circle != *triangle);
        QCOMPARE(study->size(), kSize);
        // The circle's picture is in the study's, at the upper left, but smaller.
        QVERIFY(*study != *circle);
        QVERIFY(!pictureOf("pattern:shape.Z.static").has_value());
    }

    void aPictureIsStopped() {
        std::stop_source stop;
        stop.request_stop();
        const auto picture =
            startPicture(":/scenes/servo-roll.toml", kSize, base::designedPalette(true), stop.get_token());
        QVERIFY(!picture.has_value());
        QCOMPARE(picture.error().kind, core::ErrorKind::cancelled);
    }

    void theKeyChangesWithTheFile() {
        const QTemporaryDir folder;
        QFile file(folder.filePath("a.teleta"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("one");
        file.close();
        const QByteArray before = startPictureKey(file.fileName());
        QCOMPARE(startPictureKey(file.fileName()), before);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("longer");
        file.close();
        QVERIFY(startPictureKey(file.fileName()) != before);
        QVERIFY(startPictureKey(":/scenes/servo-roll.toml") !=
                startPictureKey(":/scenes/servo-bent-bar.toml"));
    }
};

QTEST_MAIN(FilePictureTest)
#include "file_picture_test.moc"
