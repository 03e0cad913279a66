// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/desktop/last_session.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

using namespace teleta;
using namespace teleta::console;
using last_session::Entry;
using last_session::OpenSource;

class LastSessionTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsOpenIsKeptOnceEach() {
        app::CsvRequest csv;
        csv.path = "/data/run.csv";
        const std::vector<OpenSource> open{{app::SceneRequest{":/scenes/teleta-touch.toml", 7}},
                                           {app::RecordingRequest{"/data/a.teleta", "frames", "skin"}},
                                           {app::RecordingRequest{"/data/a.teleta", "camera", "skin"}},
                                           {csv},
                                           {app::CameraRequest{"0", "camera.json"}},
                                           {app::ArmRequest{"/data/arm.toml"}}};
        QCOMPARE(
            last_session::entriesOf(open, "/data/study"),
            (QStringList{"scene::/scenes/teleta-touch.toml", "recording:/data/a.teleta",
                         "recording:/data/run.csv", "camera:", "arm:/data/arm.toml", "study:/data/study"}));
        QCOMPARE(last_session::entriesOf({}), QStringList());
    }

    void ofASourceListTheListAloneIsKept() {
        const std::vector<OpenSource> open{
            {app::WtsRequest{}, "/data/both.toml"},
            {app::SceneRequest{":/scenes/teleta-touch.toml"}, "/data/both.toml"},
            {app::WtsRequest{}}};
        QCOMPARE(last_session::entriesOf(open), QStringList("list:/data/both.toml"));
    }

    void aRelativePathIsKeptWithItsFolder() {
        QCOMPARE(last_session::entriesOf({{app::SceneRequest{"mine.toml"}}}),
                 QStringList{"scene:" + QDir::current().absoluteFilePath("mine.toml")});
    }

    void aSceneThatComesWithTheProgramIsFoundAgainByItsName() {
        const QStringList kept = last_session::entriesOf({{app::SceneRequest{"vtacarm-multicontact"}}});
        QCOMPARE(kept, QStringList{"scene::/scenes/vtacarm-multicontact.toml"});
        const auto entries = last_session::entriesFrom(kept);
        QCOMPARE(entries.size(), std::size_t(1));
        QCOMPARE(entries[0].kind, Entry::Kind::scene);
        QCOMPARE(entries[0].path, ":/scenes/vtacarm-multicontact.toml");
    }

    void whatIsGoneOrNotUnderstoodIsLeftOut() {
        QTemporaryDir folder;
        const QString there = folder.filePath("run.teleta");
        QFile file(there);
        QVERIFY(file.open(QIODevice::WriteOnly));
        const auto entries =
            last_session::entriesFrom({"recording:" + there, "recording:" + folder.filePath("gone.teleta"),
                                       "planet:mars", "", "camera:", "study:" + folder.path()});
        QCOMPARE(entries.size(), std::size_t(3));
        QCOMPARE(entries[0].kind, Entry::Kind::recording);
        QCOMPARE(entries[0].path, there);
        QCOMPARE(entries[1].kind, Entry::Kind::camera);
        QCOMPARE(entries[2].kind, Entry::Kind::study);
        const QString study = QFileInfo(folder.path()).fileName();
        QCOMPARE(last_session::text(entries, {}), "run, camera, " + study);
        QCOMPARE(last_session::text(entries, {{there, {"Teleoperation", "2026-11-29 10:00, 12 s", {}}}}),
                 "Teleoperation, 2026-11-29 10:00, 12 s, camera, " + study);
        QVERIFY(last_session::entriesFrom({}).empty());
    }
};

QTEST_GUILESS_MAIN(LastSessionTest)
#include "last_session_test.moc"
