// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/console_options.h"

#include <QTest>

using teleta::console::parseOptions;

/// The command line of teleta-console.
class ConsoleOptionsTest : public QObject {
    Q_OBJECT

private slots:
    void takesNoArgumentsAsAnEmptyStart() {
        const auto parsed = parseOptions({"teleta-console"});
        QVERIFY(parsed.options.has_value());
        QVERIFY(parsed.options->scenes.isEmpty());
        QVERIFY(parsed.options->recordings.empty());
        QCOMPARE(parsed.options->after_s, 3.0);
    }

    void pairsTheOptionsOfARecordingByTheirOrder() {
        const auto parsed = parseOptions({"teleta-console", "--replay", "a.csv", "--rows", "64", "--columns",
                                          "27", "--replay", "b.csv", "--rows", "12", "--columns", "6",
                                          "--threshold", "10", "--pitch-mm", "25"});
        QVERIFY(parsed.options.has_value());
        QCOMPARE(parsed.options->recordings.size(), std::size_t(2));
        const auto& first = parsed.options->recordings[0];
        const auto& second = parsed.options->recordings[1];
        QCOMPARE(first.path, QString("a.csv"));
        QCOMPARE(*first.rows, 64);
        QCOMPARE(*second.rows, 12);
        QCOMPARE(*second.columns, 6);
        QCOMPARE(*first.threshold_N, 10.0);
        QVERIFY2(*second.threshold_N == 10.0, "the last value goes on to the recordings that follow");
        QCOMPARE(*second.pitch_m, 0.025);
        QVERIFY(!first.tarePath.has_value());
    }

    void refusesWrongUsageWithTheReason_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("reason");
        QTest::newRow("unknown option") << QStringList{"--frobnicate"} << "frobnicate";
        QTest::newRow("stray argument") << QStringList{"run.png"} << "run.png";
        QTest::newRow("rows not a number") << QStringList{"--replay", "a", "--rows", "six"} << "six";
        QTest::newRow("rows out of range") << QStringList{"--replay", "a", "--rows", "0"} << "1 to 1024";
        QTest::newRow("rate not finite") << QStringList{"--rate", "nan"} << "nan";
        QTest::newRow("unknown dock") << QStringList{"--dock", "nowhere"} << "stiffness";
        QTest::newRow("unknown page") << QStringList{"--page", "nowhere"} << "operate";
        QTest::newRow("unknown language") << QStringList{"--language", "xx"} << "en, fr, ja or zh_CN";
        QTest::newRow("a language without texts") << QStringList{"--language", "de"} << "en, fr, ja or zh_CN";
        QTest::newRow("unknown theme") << QStringList{"--theme", "pink"} << "light, dark or system";
        QTest::newRow("size without x") << QStringList{"--size", "1600"} << "WIDTHxHEIGHT";
        QTest::newRow("size too small") << QStringList{"--size", "10x10"} << "320x240";
        QTest::newRow("no column") << QStringList{"--plot", "arm/force"} << "SOURCE/STREAM/COLUMN";
        QTest::newRow("no port") << QStringList{"--foxglove", "70000"} << "1 to 65535";
        QTest::newRow("value missing") << QStringList{"--screenshot"} << "screenshot";
    }
    void refusesWrongUsageWithTheReason() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, reason);
        const auto parsed = parseOptions(QStringList{"teleta-console"} + arguments);
        QVERIFY(!parsed.options.has_value());
        QCOMPARE(parsed.exitCode, 2);
        QVERIFY2(parsed.text.contains(reason), qPrintable(parsed.text));
    }

    void takesACameraWithItsCalibrationOnly() {
        const auto both = parseOptions({"teleta-console", "--camera", "0", "--camera-model", "camera.json"});
        QVERIFY(both.options.has_value());
        QCOMPARE(both.options->camera->source, std::string("0"));
        QCOMPARE(both.options->camera->modelPath, std::string("camera.json"));
        const auto alone = parseOptions({"teleta-console", "--camera", "0"});
        QVERIFY(!alone.options.has_value());
        QCOMPARE(alone.exitCode, 2);
        QVERIFY(alone.text.contains("--camera-model"));
    }

    void takesFilesAndTheNameOfARecordingToMake() {
        const auto parsed = parseOptions(
            {"teleta-console", "a.teleta", "b.mcap", "frames.CSV", "lab.toml", "--record", "new.teleta"});
        QVERIFY(parsed.options.has_value());
        QCOMPARE(parsed.options->files, (QStringList{"a.teleta", "b.mcap", "frames.CSV", "lab.toml"}));
        QVERIFY(parsed.options->opensAnything());
        QVERIFY(!parseOptions({"teleta-console", "--theme", "dark"}).options->opensAnything());
        QCOMPARE(parsed.options->record, QString("new.teleta"));
    }

    void takesTheLiveViewWithAndWithoutAPort() {
        QVERIFY(!parseOptions({"teleta-console"}).options->startsLiveView);
        const auto usual = parseOptions({"teleta-console", "--foxglove", "run.teleta"});
        QVERIFY(usual.options.has_value());
        QVERIFY(usual.options->startsLiveView);
        QCOMPARE(usual.options->liveView.port, 8765);
        QCOMPARE(usual.options->liveView.address, std::string("127.0.0.1"));
        QCOMPARE(usual.options->files, QStringList("run.teleta"));
        const auto other =
            parseOptions({"teleta-console", "--foxglove", "9000", "--foxglove-address", "0.0.0.0"});
        QVERIFY(other.options.has_value());
        QCOMPARE(other.options->liveView.port, 9000);
        QCOMPARE(other.options->liveView.address, std::string("0.0.0.0"));
    }

    void printsHelpAndVersionWithoutFailing() {
        const auto help = parseOptions({"teleta-console", "--help"});
        QVERIFY(!help.options.has_value());
        QCOMPARE(help.exitCode, 0);
        for (const char* option : {"--scene", "--replay", "--study", "--page", "--dock", "--screenshot",
                                   "--after", "--theme", "--tare"})
            QVERIFY2(help.text.contains(QLatin1String(option)), option);
        const auto all = parseOptions({"teleta-console", "--help-all"});
        QVERIFY(!all.options.has_value());
        QCOMPARE(all.text, help.text);
        QCOMPARE(parseOptions({"teleta-console", "--version"}).exitCode, 0);
    }
};

QTEST_GUILESS_MAIN(ConsoleOptionsTest)
#include "console_options_test.moc"
