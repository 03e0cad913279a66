// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/recording.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <vector>

using namespace teleta::recording;

namespace {

constexpr int kPatience_ms = 60'000;

/// The times of the frames of the first array; empty while there is no recording.
std::vector<std::int64_t> timesOf(const QString& path) {
    std::vector<std::int64_t> times_ns;
    const auto recording = Recording::open(path.toStdString());
    if (!recording)
        return times_ns;
    const auto array = recording->first(StreamKind::array);
    if (!array)
        return times_ns;
    StreamReader reader = recording->reader(*array);
    teleta::core::TappedFrames block;
    while (reader.next(block).value_or(false))
        times_ns.insert(times_ns.end(), block.time_ns.begin(), block.time_ns.end());
    return times_ns;
}

} // namespace

/// The console is killed while it records.
class RecordingKillTest : public QObject {
    Q_OBJECT

private slots:
    void whatWasInTheFileStaysThereAndTheFileOpens() {
        const QTemporaryDir folder;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("XDG_CONFIG_HOME"), folder.filePath(QStringLiteral("config")));
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
        for (int kill = 0; kill < 3; ++kill) {
            const QString path = folder.filePath(QStringLiteral("run%1.teleta").arg(kill));
            QProcess console;
            console.setProcessEnvironment(environment);
            console.start(QStringLiteral(TELETA_CONSOLE_PROGRAM),
                          {QStringLiteral("--scene"), QStringLiteral("tactile-indenter"),
                           QStringLiteral("--bracelet"), QStringLiteral("none"), QStringLiteral("--record"),
                           path});
            QVERIFY(console.waitForStarted());
            std::vector<std::int64_t> before;
            QTRY_VERIFY_WITH_TIMEOUT((before = timesOf(path)).size() >=
                                             50U * (1U + static_cast<unsigned>(kill)) ||
                                         console.state() == QProcess::NotRunning,
                                     kPatience_ms);
            QVERIFY2(console.state() == QProcess::Running, console.readAllStandardError().constData());
            console.kill();
            QVERIFY(console.waitForFinished());
            const auto recording = Recording::open(path.toStdString());
            QVERIFY2(recording, recording ? "" : teleta::core::describe(recording.error()).c_str());
            QVERIFY(!recording->isComplete());
            const std::vector<std::int64_t> after = timesOf(path);
            QVERIFY(after.size() >= before.size());
            QVERIFY(std::equal(before.begin(), before.end(), after.begin()));
        }
    }
};

QTEST_GUILESS_MAIN(RecordingKillTest)
#include "console_recording_kill_test.moc"
