// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_settings.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using teleta::console::ConsoleSettings;
using teleta::console::RecordingRequest;

/// What the console remembers.
class ConsoleSettingsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    [[nodiscard]] QString file() const { return m_folder->filePath("teleta/console.ini"); }

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder->path());
    }

    void remembersFromOneStartToTheNext() {
        {
            ConsoleSettings settings(false);
            settings.setTheme("dark");
            settings.setLayout("operate", QByteArray("\0\1\2", 3));
            settings.addRecentFile("/somewhere/a.csv");
            settings.addRecentFile("/somewhere/b.csv");
            settings.addRecentFile("/somewhere/a.csv");
        }
        const ConsoleSettings settings(false);
        QCOMPARE(settings.theme(), QString("dark"));
        QCOMPARE(settings.layout("operate"), QByteArray("\0\1\2", 3));
        QCOMPARE(settings.recentFiles(), QStringList({"/somewhere/a.csv", "/somewhere/b.csv"}));
        QVERIFY(settings.layout("elsewhere").isEmpty());
    }

    void remembersHowARecordingWasOpened() {
        RecordingRequest request;
        request.path = "/somewhere/run.csv";
        request.layout = {64, 27, 0.025};
        request.inverted = true;
        request.threshold_N = 8.0;
        request.loadUnit = "counts";
        ConsoleSettings(false).setRecording(request);

        const auto known = ConsoleSettings(false).recording("/somewhere/run.csv");
        QVERIFY(known.has_value());
        QCOMPARE(known->layout.columns, 27);
        QCOMPARE(known->layout.pitch_m, 0.025);
        QVERIFY(known->inverted);
        QCOMPARE(known->threshold_N, 8.0);
        QCOMPARE(known->loadUnit, std::string("counts"));
        QVERIFY(!ConsoleSettings(false).recording("/somewhere/other.csv").has_value());
    }

    void remembersNothingWhenFresh() {
        {
            ConsoleSettings settings(true);
            settings.setTheme("dark");
            QCOMPARE(settings.theme(), QString("system"));
        }
        QVERIFY(!QFile::exists(file()));
    }

    void leavesTheFileOfANewerVersionAlone() {
        QVERIFY(QDir(m_folder->path()).mkpath("teleta"));
        const QByteArray newer = "[General]\nversion=99\ntheme=purple\n";
        {
            QFile written(file());
            QVERIFY(written.open(QIODevice::WriteOnly) && written.write(newer) == newer.size());
        }
        {
            ConsoleSettings settings(false);
            QCOMPARE(settings.theme(), QString("system"));
            settings.setTheme("dark");
        }
        QFile read(file());
        QVERIFY(read.open(QIODevice::ReadOnly));
        QCOMPARE(read.readAll(), newer);
    }

    void startsWithDefaultsFromADamagedFile() {
        QVERIFY(QDir(m_folder->path()).mkpath("teleta"));
        {
            QFile written(file());
            QVERIFY(written.open(QIODevice::WriteOnly));
            written.write("\x00\xff[[[garbage\nrecent=@Variant(nonsense)\n");
        }
        ConsoleSettings settings(false);
        QCOMPARE(settings.theme(), QString("system"));
        settings.setTheme("light");
        QCOMPARE(settings.theme(), QString("light"));
    }
};

QTEST_GUILESS_MAIN(ConsoleSettingsTest)
#include "console_settings_test.moc"
