// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/start/recent_names.h"
#include "backend/recording/recording_writer.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cstdint>
#include <string>
#include <vector>

using namespace teleta;
using console::RecentFileNames;

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kStart_ns = 500 * kSecond_ns;
const QDateTime kStart(QDate(2026, 11, 29), QTime(10, 22, 31));

/// Begins at kStart and has a frame at its start and after so many seconds.
core::Expected<void> writeRecording(const QString& path, const std::string& scene, std::int64_t seconds) {
    recording::RecordingWriter writer(path.toStdString(), std::vector<recording::TimeAnchor>{
                                                              {.time_ns = kStart_ns, .utc = kStart.toUTC()}});
    TELETA_CHECK(writer.begin(
        {.appVersion = "1", .scene = scene, .sceneText = {}, .configuration = {}, .start_ns = kStart_ns}));
    recording::StreamInfo info;
    info.name = "array-frames";
    info.source = "left hand";
    info.shape = {1, 1};
    TELETA_CHECK(writer.addStream(info));
    for (const std::int64_t at_s : {std::int64_t{0}, seconds}) {
        core::TappedFrames frames;
        frames.time_ns = {kStart_ns + at_s * kSecond_ns};
        frames.sourceTime_s = {static_cast<double>(at_s)};
        frames.values.resize(sizeof(float));
        writer.take(0, std::move(frames));
        TELETA_CHECK(writer.commit());
    }
    return writer.finish();
}

} // namespace

/// What recordings are called on the start page and in menus.
class RecentNamesTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString at(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

private slots:
    void aRecordingIsCalledByItsSceneWithItsStartAndLength() {
        QVERIFY(writeRecording(at("scene.teleta"), "teleta-touch", 75));
        const auto name = console::nameOfRecording(at("scene.teleta"));
        QVERIFY(name);
        QCOMPARE(name->title, QStringLiteral("teleta-touch"));
        QCOMPARE(name->about, QStringLiteral("2026-11-29 10:22, 1 min 15 s"));
        QCOMPARE(name->exact, QStringLiteral("2026-11-29 10:22:31, 1 min 15 s"));
    }

    void withoutASceneItIsCalledByItsSource() {
        QVERIFY(writeRecording(at("live.teleta"), {}, 8));
        const auto name = console::nameOfRecording(at("live.teleta"));
        QVERIFY(name);
        QCOMPARE(name->title, QStringLiteral("left hand"));
        QCOMPARE(name->about, QStringLiteral("2026-11-29 10:22, 8 s"));
    }

    void namesComeTogetherAndOnceAndWhatIsNoRecordingHasNone() {
        QVERIFY(writeRecording(at("one.teleta"), "one", 1));
        QVERIFY(writeRecording(at("two.teleta"), "two", 2));
        QFile damaged(at("damaged.teleta"));
        QVERIFY(damaged.open(QIODevice::WriteOnly));
        damaged.write("no database");
        damaged.close();
        RecentFileNames names;
        QSignalSpy changed(&names, &RecentFileNames::changed);
        const QStringList files{at("one.teleta"), at("damaged.teleta"), at("gone.teleta"), at("run.csv"),
                                at("two.teleta")};
        names.ask(files);
        names.ask(files);
        QTRY_COMPARE(changed.size(), 1);
        QCOMPARE(names.names().size(), 2);
        QCOMPARE(names.names().value(at("two.teleta")).title, QStringLiteral("two"));
        names.ask(files);
        QCoreApplication::processEvents();
        QCOMPARE(changed.size(), 1);
    }
};

QTEST_MAIN(RecentNamesTest)
#include "recent_names_test.moc"
