// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/base/console_settings.h"
#include "app/console/settings_notice.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using teleta::app::CsvRequest;
using teleta::console::ConsoleSettings;

namespace {

constexpr char kOtherConsole[] = "--other-console";

/// Another console with the settings of a folder: chooses a page and opens a file.
int runOtherConsole(const QString& folder) {
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
    ConsoleSettings settings(false);
    settings.setPage("study");
    settings.addRecentFile("/somewhere/b.csv");
    return 0;
}

} // namespace

/// What the console remembers.
class ConsoleSettingsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    [[nodiscard]] QString file() const { return m_folder->filePath("teleta/console.ini"); }
    void write(const QByteArray& content) const {
        QVERIFY(QDir(m_folder->path()).mkpath("teleta"));
        QFile written(file());
        QVERIFY(written.open(QIODevice::WriteOnly) && written.write(content) == content.size());
    }
    static QByteArray read(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

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
        CsvRequest request;
        request.path = "/somewhere/run.csv";
        request.layout = {64, 27, 0.025};
        request.inverted = true;
        request.threshold_N = 8.0;
        request.loadUnit = "counts";
        ConsoleSettings(false).setRecording(request);

        const auto known = ConsoleSettings(false).recording("/somewhere/run.csv");
        QVERIFY(known.has_value());
        QCOMPARE(known->layout.columns, 27);
        QCOMPARE(known->layout.pitchX_m, 0.025);
        QVERIFY(known->inverted);
        QCOMPARE(known->threshold_N, 8.0);
        QCOMPARE(known->loadUnit, std::string("counts"));
        QVERIFY(!ConsoleSettings(false).recording("/somewhere/other.csv").has_value());
    }

    void remembersHowFramesOfAFamilyAreRead() {
        teleta::frames::FrameRequest request;
        request.path = "/somewhere/a.csv";
        request.array = "pressure";
        request.axis = teleta::frames::FrameAxis::last;
        request.rows = 4;
        request.rate_Hz = 50.0;
        request.taxelColumns = {{2, 10}, {12, 12}};
        request.timeColumn = "stamp";
        request.timeUnit = "ms";
        request.knownPath = "/somewhere/skin.toml";
        { ConsoleSettings(false).setFrameRequest("family", request); }
        const ConsoleSettings settings(false);
        const auto known = settings.frameRequest("family");
        QVERIFY(known);
        QCOMPARE(known->path, std::string());
        QCOMPARE(known->array, std::string("pressure"));
        QVERIFY(known->axis == teleta::frames::FrameAxis::last);
        QVERIFY(known->rows == 4 && !known->columns && known->rate_Hz == 50.0 && !known->pitch_m);
        QCOMPARE(teleta::frames::textOf(known->taxelColumns), std::string("2..10,12"));
        QCOMPARE(known->timeColumn, std::string("stamp"));
        QCOMPARE(known->timeUnit, std::string("ms"));
        QCOMPARE(known->knownPath, std::string("/somewhere/skin.toml"));
        QVERIFY(!settings.frameRequest("another"));
        QVERIFY(!settings.frameRequest(""));
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
        const QByteArray newer = "[General]\nversion=99\ntheme=purple\n";
        write(newer);
        {
            ConsoleSettings settings(false);
            QCOMPARE(settings.theme(), QString("system"));
            settings.setTheme("dark");
        }
        QCOMPARE(read(file()), newer);
    }

    /// The oldest files had no version; the first bracelets with a file were Modbus ones.
    void takesOverTheFileOfAnOlderVersion() {
        write("[General]\ntheme=dark\nlanguage=fr\nbracelet=modbus:/somewhere/driver.toml\n"
              "recent=/somewhere/a.csv\n[layout]\noperate=abc\n");
        {
            const ConsoleSettings settings(false);
            QCOMPARE(settings.theme(), QString("dark"));
            QCOMPARE(settings.language(), QString("fr"));
            QCOMPARE(settings.bracelet(), QString("modbus:/somewhere/driver.toml"));
            QCOMPARE(settings.recentFiles(), QStringList("/somewhere/a.csv"));
            QCOMPARE(settings.layout("operate"), QByteArray("abc"));
        }
        QVERIFY(read(file()).contains("version=1"));
        QVERIFY(read(file()).contains("theme=dark"));
        QVERIFY2(!QFile::exists(file() + ".damaged"), "nothing is wrong with it");
    }

    void readsWhatItCanOfADamagedFileAndKeepsACopyOfIt() {
        const QByteArray damaged = QByteArray("[General]\ntheme=dark\n") + '\0' +
                                   QByteArray("\xff[[[garbage\nrecent=@Variant(nonsense)\n");
        write(damaged);
        {
            ConsoleSettings settings(false);
            QCOMPARE(int(settings.found()), int(ConsoleSettings::Found::damaged));
            QCOMPARE(settings.keptFile(), file() + ".damaged");
            QCOMPARE(settings.theme(), QString("dark"));
            QCOMPARE(settings.language(), QString());
            settings.setLanguage("ja");
        }
        QCOMPARE(read(file() + ".damaged"), damaged);
        const ConsoleSettings next(false);
        QCOMPARE(next.theme(), QString("dark"));
        QCOMPARE(next.language(), QString("ja"));
    }

    void claimsNoCopyOfADamagedFileThatCouldNotBeMade() {
        write("[General]\ntheme=dark\n\xff[[[garbage\n");
        QVERIFY(QDir().mkpath(file() + ".damaged/in the way"));
        const ConsoleSettings settings(false);
        QCOMPARE(int(settings.found()), int(ConsoleSettings::Found::damaged));
        QCOMPARE(settings.keptFile(), QString());
        QCOMPARE(settings.theme(), QString("dark"));
    }

    void tellsThatNothingCanBeKept() {
        // No folder, so that nobody can make one there, the administrator neither.
        QFile inTheWay(m_folder->filePath("teleta"));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        ConsoleSettings settings(false);
        QCOMPARE(int(settings.found()), int(ConsoleSettings::Found::unwritable));
        const auto notice = teleta::console::settingsNotice(settings);
        QVERIFY(notice.has_value());
        QVERIFY2(notice->advice.contains(file()), qPrintable(notice->advice));
        settings.setTheme("dark");
        QCOMPARE(settings.theme(), QString("dark"));
        const ConsoleSettings fresh(true);
        QCOMPARE(int(fresh.found()), int(ConsoleSettings::Found::usable));
    }

    void twoConsolesLoseNothingOfEachOther() {
        ConsoleSettings settings(false);
        settings.setTheme("dark");
        settings.addRecentFile("/somewhere/a.csv");
        QProcess other;
        other.start(QCoreApplication::applicationFilePath(), {kOtherConsole, m_folder->path()});
        QVERIFY(other.waitForFinished(60'000));
        QCOMPARE(other.exitCode(), 0);
        settings.addRecentFile("/somewhere/c.csv");
        QCOMPARE(settings.recentFiles(),
                 QStringList({"/somewhere/c.csv", "/somewhere/b.csv", "/somewhere/a.csv"}));
        QCOMPARE(settings.page(), QString("study"));
        QCOMPARE(settings.theme(), QString("dark"));
    }

    void manyRecordingsDoNotPushOutTheOneScene() {
        ConsoleSettings settings(false);
        settings.addRecentFile("/somewhere/scene.toml");
        for (int i = 0; i < 12; ++i)
            settings.addRecentFile(QString("/somewhere/%1.teleta").arg(i));
        const QStringList files = settings.recentFiles();
        QCOMPARE(files.size(), ConsoleSettings::kRecentFiles + 1);
        QCOMPARE(files.first(), QString("/somewhere/11.teleta"));
        QCOMPARE(files.last(), QString("/somewhere/scene.toml"));
        settings.addRecentStudy("/somewhere/study");
        settings.clearRecent();
        QVERIFY(settings.recentFiles().isEmpty() && settings.recentStudies().isEmpty());
    }
};

int main(int argc, char* argv[]) {
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 3 && arguments[1] == QLatin1String(kOtherConsole))
        return runOtherConsole(arguments[2]);
    ConsoleSettingsTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "console_settings_test.moc"
