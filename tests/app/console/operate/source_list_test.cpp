// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/source_list.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using teleta::app::ArmRequest;
using teleta::app::CameraRequest;
using teleta::app::CsvRequest;
using teleta::app::guessCsv;
using teleta::app::isArmFile;
using teleta::app::isSourceList;
using teleta::app::readSourceList;
using teleta::app::SceneRequest;
using teleta::app::TaxelsRequest;
using teleta::app::WtsRequest;

/// Source lists, and what a recording's file tells of itself.
class SourceListTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    QString write(const QString& name, const QByteArray& content) {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(name));
        return file.fileName();
    }

    QString writeRecording(const QString& name, int taxels) {
        QByteArray text = "time_s";
        for (int taxel = 0; taxel < taxels; ++taxel)
            text += ",t" + QByteArray::number(taxel);
        text += "\n0" + QByteArray(",1").repeated(taxels) + "\n";
        return write(name, text);
    }

private slots:
    void guessesKnownArraysAndTheUnloadedRecordingBesideThem() {
        const QString empty = writeRecording("bed_empty1.csv", 72);
        const auto guess = guessCsv(writeRecording("bed_left1.csv", 72).toStdString());
        QVERIFY(guess.has_value());
        QCOMPARE(guess->layout.rows, 12);
        QCOMPARE(guess->layout.columns, 6);
        QCOMPARE(QString::fromStdString(guess->tarePath), empty);
        const auto unloaded = guessCsv(empty.toStdString());
        QVERIFY(unloaded.has_value());
        QVERIFY(unloaded->tarePath.empty());
    }

    void takesTheMostSquareShapeForAnUnknownArray() {
        const auto guess = guessCsv(writeRecording("unknown.csv", 35).toStdString());
        QVERIFY(guess.has_value());
        QCOMPARE(guess->layout.rows, 5);
        QCOMPARE(guess->layout.columns, 7);
        const auto prime = guessCsv(writeRecording("prime.csv", 13).toStdString());
        QVERIFY(prime.has_value());
        QCOMPARE(prime->layout.rows, 1);
        QCOMPARE(prime->layout.columns, 13);
    }

    void readsCamerasAndVideosWithTheirCalibration() {
        const auto list = readSourceList(write("cameras.toml", "[[source]]\n"
                                                               "camera = \"0\"\n"
                                                               "camera_model = \"tube.json\"\n"
                                                               "[[source]]\n"
                                                               "camera = \"run.avi\"\n"
                                                               "camera_model = \"tube.json\"\n"
                                                               "loop = false\n")
                                             .toStdString());
        QVERIFY(list.has_value());
        QCOMPARE(list->size(), std::size_t(2));
        const auto& connected = std::get<CameraRequest>((*list)[0]);
        QCOMPARE(connected.source, std::string("0"));
        QCOMPARE(QString::fromStdString(connected.modelPath), m_folder.filePath("tube.json"));
        const auto& video = std::get<CameraRequest>((*list)[1]);
        QCOMPARE(QString::fromStdString(video.source), m_folder.filePath("run.avi"));
        QVERIFY(!video.loop);
        const auto without = readSourceList(write("bad.toml", "[[source]]\ncamera = \"0\"\n").toStdString());
        QVERIFY(!without.has_value());
        QVERIFY(without.error().where.line > 0);
    }

    void readsArmsAndKnowsTheFileOfOne() {
        const auto list =
            readSourceList(write("arms.toml", "[[source]]\narm = \"robot.toml\"\n").toStdString());
        QVERIFY(list.has_value());
        QCOMPARE(QString::fromStdString(std::get<ArmRequest>(list->front()).path),
                 m_folder.filePath("robot.toml"));
        QVERIFY(isArmFile(write("robot.toml", "kind = \"ros_arm\"\nwrong = 1\n").toStdString()));
        QVERIFY(!isArmFile(write("scene.toml", "kind = \"arm\"\n").toStdString()));
        QVERIFY(!isArmFile(write("number.toml", "kind = 3\n").toStdString()));
        QVERIFY(!isArmFile(m_folder.filePath("missing.toml").toStdString()));
    }

    void readsRecordingsAndScenesInTheirOrderWithPathsBesideTheList() {
        writeRecording("a.csv", 84);
        const QString list =
            write("list.toml",
                  "[[source]]\nrecording = \"a.csv\"\nrate_Hz = 200\nthreshold = 0.5\n"
                  "inverted = true\ngains = \"gains.csv\"\n[[source]]\nscene = \"demo.toml\"\nseed = 7\n");
        const auto requests = readSourceList(list.toStdString());
        QVERIFY2(requests.has_value(), requests ? "" : describe(requests.error()).c_str());
        QCOMPARE(requests->size(), std::size_t(2));
        const auto& recording = std::get<CsvRequest>((*requests)[0]);
        QCOMPARE(QString::fromStdString(recording.path), m_folder.filePath("a.csv"));
        QCOMPARE(recording.layout.rows, 6);
        QCOMPARE(QString::fromStdString(recording.gainsPath), m_folder.filePath("gains.csv"));
        QCOMPARE(recording.rate_Hz, 200.0);
        QCOMPARE(recording.threshold_N, 0.5);
        QVERIFY(recording.inverted);
        const auto& scene = std::get<SceneRequest>((*requests)[1]);
        QCOMPARE(QString::fromStdString(scene.path), m_folder.filePath("demo.toml"));
        QCOMPARE(scene.seed, std::uint64_t(7));
    }

    void readsConnectedArrays() {
        const QString list =
            write("wts.toml", "[[source]]\nwts = \"/dev/ttyUSB0\"\nbaud = 921600\ndelay_ms = 5\n"
                              "run_length = true\ntare = true\nthreshold = 30\n"
                              "[[source]]\nwts = \"tcp://hand:1000\"\ngain = 0.01\nunit = \"N\"\n"
                              "gains = \"/hand/gains.csv\"\n");
        const auto requests = readSourceList(list.toStdString());
        QVERIFY2(requests.has_value(), requests ? "" : describe(requests.error()).c_str());
        QCOMPARE(requests->size(), std::size_t(2));
        const auto& serial = std::get<WtsRequest>((*requests)[0]);
        QVERIFY(serial.config.address ==
                teleta::link::Address(teleta::link::SerialAddress{"/dev/ttyUSB0", 921600}));
        QCOMPARE(serial.config.delay_ms, std::uint16_t(5));
        QVERIFY(serial.config.runLength);
        QVERIFY(serial.config.tare);
        QCOMPARE(serial.threshold.value_or(0.0), 30.0);
        QCOMPARE(QString::fromStdString(serial.loadUnit), QStringLiteral("counts"));
        QCOMPARE(displayName((*requests)[0]), QStringLiteral("ttyUSB0"));
        const auto& tcp = std::get<WtsRequest>((*requests)[1]);
        QVERIFY(tcp.config.address == teleta::link::Address(teleta::link::TcpAddress{"hand", 1000}));
        QVERIFY(!tcp.config.tare);
        QVERIFY(!tcp.threshold.has_value());
        QCOMPARE(tcp.gain, 0.01);
        QCOMPARE(QString::fromStdString(tcp.gainsPath), QStringLiteral("/hand/gains.csv"));
        QVERIFY(serial.gainsPath.empty());
        QCOMPARE(displayName((*requests)[1]), QStringLiteral("hand:1000"));
    }

    void aRecordingIsCalledByWhatItHasAndWhen() {
        teleta::app::RecordingRequest recording;
        recording.source = "Unknown objects";
        recording.path = "/data/run-7.teleta";
        QCOMPARE(teleta::app::displayName(recording), QStringLiteral("run-7 (Unknown objects)"));
        recording.path = "/data/20261130T091014Z-teleoperation.teleta";
        const QDateTime recorded(QDate(2026, 11, 30), QTime(9, 10, 14), Qt::UTC);
        QCOMPARE(teleta::app::displayName(recording),
                 QStringLiteral("Unknown objects (%1)")
                     .arg(recorded.toLocalTime().toString(QStringLiteral("HH:mm:ss"))));
        recording.source.clear();
        QCOMPARE(teleta::app::displayName(recording), QStringLiteral("20261130T091014Z-teleoperation"));
    }

    void readsDescribedArraysAndTakesOneForAList() {
        const auto list =
            readSourceList(write("lists.toml", "[[source]]\ntaxels = \"glove.toml\"\n").toStdString());
        QVERIFY(list.has_value());
        QCOMPARE(QString::fromStdString(std::get<TaxelsRequest>(list->front()).path),
                 m_folder.filePath("glove.toml"));
        QCOMPARE(displayName(list->front()), QStringLiteral("glove"));

        QFile example(QStringLiteral(TELETA_SOURCE_DIR "/resources/devices/taxels-glove.toml"));
        QVERIFY(example.open(QIODevice::ReadOnly));
        const QByteArray text = example.readAll();
        const QString glove = write("glove.toml", text);
        QVERIFY(isSourceList(glove.toStdString()));
        const auto alone = readSourceList(glove.toStdString());
        QVERIFY2(alone.has_value(), alone ? "" : describe(alone.error()).c_str());
        QCOMPARE(QString::fromStdString(std::get<TaxelsRequest>(alone->front()).path), glove);

        const auto wrong = readSourceList(
            write("wrong.toml", QByteArray(text).replace("rows = 6", "rows = 7")).toStdString());
        QVERIFY(!wrong.has_value());
        QVERIFY(wrong.error().message.find("98 taxels") != std::string::npos);
    }

    void namesThePlaceOfAWrongAddressOrSetting_data() {
        QTest::addColumn<QByteArray>("lines");
        QTest::addColumn<int>("line");
        QTest::addColumn<int>("column");
        QTest::newRow("no port") << QByteArray("wts = \"tcp://hand\"") << 2 << 7;
        QTest::newRow("no baud rate over TCP")
            << QByteArray("wts = \"tcp://hand:1\"\nbaud = 115200") << 3 << 1;
        QTest::newRow("delay too long") << QByteArray("wts = \"/dev/ttyUSB0\"\ndelay_ms = 65536") << 3 << 12;
        QTest::newRow("no threshold") << QByteArray("wts = \"/dev/ttyUSB0\"\nthreshold = 0") << 3 << 13;
        QTest::newRow("two sources in one")
            << QByteArray("wts = \"/dev/ttyUSB0\"\nrecording = \"a\"") << 3 << 1;
    }
    void namesThePlaceOfAWrongAddressOrSetting() {
        QFETCH(QByteArray, lines);
        QFETCH(int, line);
        QFETCH(int, column);
        const auto requests = readSourceList(write("bad.toml", "[[source]]\n" + lines + "\n").toStdString());
        QVERIFY(!requests.has_value());
        QCOMPARE(int(requests.error().where.line), line);
        QCOMPARE(int(requests.error().where.column), column);
    }

    void aListIsKnownByItsContentWhateverIsWrongWithIt_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<bool>("isList");
        QTest::newRow("a list") << QByteArray("[[source]]\nscene = \"demo.toml\"\n") << true;
        QTest::newRow("in one line") << QByteArray("source = [{scene = \"demo.toml\"}]\n") << true;
        QTest::newRow("a key that is unknown") << QByteArray("[[source]]\nspeeed = 2\n") << true;
        QTest::newRow("no source in it") << QByteArray("source = []\n") << true;
        QTest::newRow("a scene") << QByteArray("name = \"x\"\n[array]\nrows = 2\n") << false;
        QTest::newRow("no TOML") << QByteArray("[[source\n") << false;
        QTest::newRow("one array") << QByteArray("kind = \"taxels\"\nwrong = 1\n") << true;
        QTest::newRow("another device") << QByteArray("kind = \"modbus\"\n") << false;
        QTest::newRow("empty") << QByteArray() << false;
    }
    void aListIsKnownByItsContentWhateverIsWrongWithIt() {
        QFETCH(QByteArray, content);
        QFETCH(bool, isList);
        QCOMPARE(isSourceList(write("some.toml", content).toStdString()), isList);
        QVERIFY(!isSourceList(m_folder.filePath("nowhere.toml").toStdString()));
    }

    void namesThePlaceOfWhatIsWrong() {
        writeRecording("b.csv", 84);
        const QString list = write("wrong.toml", "[[source]]\nrecording = \"b.csv\"\nspeeed = 2\n");
        const auto requests = readSourceList(list.toStdString());
        QVERIFY(!requests.has_value());
        QCOMPARE(requests.error().where.line, 3LL);
        QCOMPARE(requests.error().where.column, 1LL);
        QVERIFY(requests.error().message.find("speeed") != std::string::npos);

        const auto missing = readSourceList(m_folder.filePath("nowhere.toml").toStdString());
        QVERIFY(!missing.has_value());
        QCOMPARE(missing.error().kind, teleta::core::ErrorKind::notFound);
    }
};

QTEST_GUILESS_MAIN(SourceListTest)
#include "source_list_test.moc"
