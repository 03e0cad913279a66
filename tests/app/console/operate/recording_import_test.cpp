// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_files.h"
#include "app/console/operate/recording/recording_import.h"
#include "app/console/sources/frame_dialog.h"
#include "backend/frames/frame_request.h"
#include "backend/mcap/recorded/mcap_export.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/recorder.h"
#include "backend/recording/recording.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWidget>

#include <array>
#include <memory>
#include <vector>

using namespace teleta;
using console::RecordingFiles;
using console::RecordingImport;

namespace {

constexpr int kPatience_ms = 60'000;
constexpr int kFrames = 10'000;

/// A console's sources, settings and window, with what opens its recordings. The settings stay in a folder
/// of their own.
struct OpenedHere {
    core::StopSwitch stop;
    console::SourceManager sources{stop};
    QTemporaryDir kept;
    std::unique_ptr<console::ConsoleSettings> settings;
    std::unique_ptr<QWidget> window = std::make_unique<QWidget>();
    RecordingFiles* files = nullptr;

    explicit OpenedHere(bool fresh) {
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, kept.path());
        settings = std::make_unique<console::ConsoleSettings>(fresh);
        files = new RecordingFiles(sources, *settings, window.get());
    }
    ~OpenedHere() {
        sources.closeAll();
        window.reset();
    }
};

} // namespace

/// MCAP files, and frames of other programs, that are opened in the window.
class RecordingImportTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QWidget m_window;

    [[nodiscard]] QString mcap() const { return m_folder.filePath("run.mcap"); }
    [[nodiscard]] QString file(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] QStringList files() const {
        return QDir(m_folder.path()).entryList({"*.teleta", "*.mcap", "*part*"}, QDir::Files, QDir::Name);
    }

private slots:
    /// So long that an import is usually far from its end when it is cancelled.
    void initTestCase() {
        const std::string path = file("source.teleta").toStdString();
        recording::RecordingHead head;
        head.start_ns = 1;
        auto recorder =
            recording::Recorder::start(path, head, {.simulatedTime = true, .queueBlocks = kFrames});
        QVERIFY(recorder);
        const core::SourceDescription description{.name = "array",
                                                  .layout = core::ArrayLayout{16, 16, 0.0034},
                                                  .unit = "N",
                                                  .nominalRate_Hz = 1000.0};
        const auto tap = (*recorder)->addStream(pipeline::arrayStream("frames", description, {}));
        const std::array<float, 256> values{0.1F, 0.2F, 0.3F};
        for (int i = 0; i < kFrames; ++i)
            tap->append(1 + i * 1'000'000LL, 0.001 * i, std::span<const float>(values));
        QVERIFY((*recorder)->stop());
        {
            const auto recorded = recording::Recording::open(path);
            QVERIFY(recorded);
            QVERIFY(mcap::exportMcap(*recorded, mcap().toStdString()));
        }
        QVERIFY(QFile::remove(file("source.teleta")));
        QCOMPARE(files(), QStringList("run.mcap"));
    }
    void cleanup() {
        for (const QString& name : files())
            if (name != "run.mcap")
                QVERIFY(QFile::remove(m_folder.filePath(name)));
    }

    void theRecordingGoesBesideTheFileOrWhereItCanBeWritten() {
        QCOMPARE(RecordingImport::recordingOf(file("a.b.mcap"), "/other"), file("a.b.teleta"));
        QCOMPARE(RecordingImport::recordingOf("/not/there/run.mcap", "/other"), QString("/other/run.teleta"));
    }

    void aNameIsFreeWithTheFirstNumberThatIs() {
        QCOMPARE(RecordingImport::freeName(file("x.teleta")), file("x.teleta"));
        for (const char* name : {"x.teleta", "x-2.teleta"}) {
            QFile taken(file(name));
            QVERIFY(taken.open(QIODevice::WriteOnly));
        }
        QCOMPARE(RecordingImport::freeName(file("x.teleta")), file("x-3.teleta"));
    }

    void everyFrameIsInTheRecording() {
        RecordingImport importer(&m_window);
        QSignalSpy imported(&importer, &RecordingImport::imported);
        importer.start(mcap(), file("new/run.teleta"));
        QVERIFY(importer.isBusy());
        QTRY_COMPARE_WITH_TIMEOUT(imported.size(), 1, kPatience_ms);
        QVERIFY(!importer.isBusy());
        QCOMPARE(imported[0], (QVariantList{mcap(), file("new/run.teleta"), QString()}));
        const auto recording = recording::Recording::open(file("new/run.teleta").toStdString());
        QVERIFY(recording);
        const auto extent = recording->extent(0);
        QVERIFY(extent && *extent);
        QCOMPARE((*extent)->frames, std::uint64_t(kFrames));
        QVERIFY(QFile::remove(file("new/run.teleta")));
    }

    void oneThatIsCancelledLeavesNothing() {
        RecordingImport importer(&m_window);
        QSignalSpy cancelled(&importer, &RecordingImport::cancelled);
        QSignalSpy imported(&importer, &RecordingImport::imported);
        importer.start(mcap(), file("run.teleta"));
        m_window.findChild<QProgressDialog*>()->findChild<QPushButton*>()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!importer.isBusy(), kPatience_ms);
        QCOMPARE(cancelled.size() + imported.size(), 1);
        QCOMPARE(files().contains("run.teleta"), imported.size() == 1);
    }

    void theEndOfTheProgramLeavesNothingHalfDone() {
        { RecordingImport(&m_window).start(mcap(), file("run.teleta")); }
        QVERIFY(files().filter("part").isEmpty());
    }

    void aFileThatIsNotMcapFailsWithTheReason() {
        QFile text(file("text.mcap"));
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("time_s,t0\n");
        text.close();
        RecordingImport importer(&m_window);
        QSignalSpy failed(&importer, &RecordingImport::failed);
        importer.start(text.fileName(), file("text.teleta"));
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience_ms);
        QCOMPARE(failed[0][0].toString(), text.fileName());
        const auto error = failed[0][1].value<core::Error>();
        QCOMPARE(error.kind, core::ErrorKind::badInput);
        QCOMPARE(QString::fromStdString(error.where.file), text.fileName());
        QCOMPARE(files(), (QStringList{"run.mcap", "text.mcap"}));
    }

    void twoIntoOneRecordingAtOnceAreRefused() {
        RecordingImport importer(&m_window);
        QSignalSpy failed(&importer, &RecordingImport::failed);
        QSignalSpy imported(&importer, &RecordingImport::imported);
        importer.start(mcap(), file("run.teleta"));
        importer.start(mcap(), file("run.teleta"));
        QCOMPARE(failed.size(), 1);
        QTRY_COMPARE_WITH_TIMEOUT(imported.size(), 1, kPatience_ms);
    }

    void framesOfAnotherProgramBecomeARecording() {
        // NumPy's format, by hand: 3 frames of 2 x 2 taxels, without times.
        QFile array(file("frames.npy"));
        QVERIFY(array.open(QIODevice::WriteOnly));
        QByteArray header = "{'descr': '<f4', 'fortran_order': False, 'shape': (3, 2, 2), }";
        header = header.leftJustified(117) + '\n';
        array.write(QByteArray("\x93NUMPY\x01\x00", 8) + char(header.size()) + '\0' + header);
        for (int i = 0; i < 12; ++i) {
            const auto value = static_cast<float>(i);
            array.write(reinterpret_cast<const char*>(&value), sizeof value);
        }
        array.close();

        OpenedHere here(false);
        RecordingFiles* recordings = here.files;
        QWidget* window = here.window.get();
        QSignalSpy opened(recordings, &RecordingFiles::opened);
        QSignalSpy cancelled(recordings, &RecordingFiles::cancelled);
        const auto dialog = [window] { return window->findChild<console::FrameDialog*>(); };
        recordings->open(array.fileName());
        // The file does not tell how fast it was.
        QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr, kPatience_ms);
        QVERIFY(dialog()->findChild<QLabel*>("why")->text().contains("frames.npy"));
        dialog()->reject();
        QCOMPARE(cancelled.size(), 1);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(!files().contains("frames.teleta"));

        recordings->open(array.fileName());
        QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr, kPatience_ms);
        auto* columns = dialog()->findChild<QLineEdit*>("taxelColumns");
        auto* open = dialog()->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
        columns->setText("2..");
        QVERIFY(!open->isEnabled());
        columns->clear();
        QVERIFY(open->isEnabled());
        dialog()->findChild<QDoubleSpinBox*>("rate")->setValue(50.0);
        open->click();
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, kPatience_ms);
        QCOMPARE(opened[0][0].toString(), file("frames.teleta"));
        const auto recording = recording::Recording::open(file("frames.teleta").toStdString());
        QVERIFY(recording.has_value());
        QCOMPARE(recording->streams().front().shape, (std::vector<std::size_t>{2, 2}));
        QCOMPARE(recording->streams().front().nominalRate_Hz, 50.0);
        const auto extent = recording->extent(0);
        QVERIFY(extent && *extent);
        QCOMPARE((*extent)->frames, std::uint64_t(3));

        // The next file of this kind is read in the same way, unless a person says otherwise.
        const auto known = here.settings->frameRequest(frames::familyOf(array.fileName().toStdString()));
        QVERIFY(known && known->rate_Hz == 50.0);
        recordings->open(array.fileName());
        QTRY_VERIFY_WITH_TIMEOUT(window->findChild<QMessageBox*>() != nullptr, kPatience_ms);
        window->findChild<QMessageBox*>()->findChild<QPushButton*>("importOtherwise")->click();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr, kPatience_ms);
        QVERIFY(!dialog()->findChild<QLabel*>("why")->isVisible());
        QCOMPARE(dialog()->findChild<QDoubleSpinBox*>("rate")->value(), 50.0);
        dialog()->findChild<QDoubleSpinBox*>("rate")->setValue(25.0);
        dialog()->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)->click();
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 2, kPatience_ms);
        QCOMPARE(opened[1][0].toString(), file("frames-2.teleta"));
        const auto slower = recording::Recording::open(file("frames-2.teleta").toStdString());
        QVERIFY(slower && slower->streams().front().nominalRate_Hz == 25.0);
        QVERIFY(QFile::remove(array.fileName()));
    }

    void loadsInAnotherUnitThanNewtonsAreAskedForAThreshold() {
        const QString frames = file("field.h5");
        QVERIFY(QFile::copy(TELETA_SOURCE_DIR "/tests/data/frames/field.h5", frames));
        OpenedHere here(false);
        RecordingFiles* recordings = here.files;
        QWidget* window = here.window.get();
        QSignalSpy opened(recordings, &RecordingFiles::opened);
        recordings->open(frames);
        QTRY_VERIFY_WITH_TIMEOUT(window->findChild<console::FrameDialog*>() != nullptr, kPatience_ms);
        auto* dialog = window->findChild<console::FrameDialog*>();
        const QString why = dialog->findChild<QLabel*>("why")->text();
        QVERIFY2(why.contains(QString::fromUtf8("\u00b5T")), qPrintable(why));
        dialog->findChild<QDoubleSpinBox*>("threshold")->setValue(2.5);
        dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)->click();
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, kPatience_ms);
        const auto recording = recording::Recording::open(file("field.teleta").toStdString());
        QVERIFY(recording.has_value());
        const auto array = pipeline::recordedArray(recording->streams().front(), recording->path());
        QVERIFY(array.has_value());
        QCOMPARE(array->settings.segmentation.threshold_N, 2.5);
        QCOMPARE(QString::fromStdString(array->settings.loadUnit), QString::fromUtf8("\u00b5T"));
        // The next file of this kind has the same one.
        const auto known = here.settings->frameRequest(frames::familyOf(frames.toStdString()));
        QVERIFY(known && known->threshold == 2.5);
        QVERIFY(QFile::remove(frames));
    }

    void aRecordingThatIsThereIsOpenedOrTheFileImportedAgain() {
        OpenedHere here(true);
        RecordingFiles* recordings = here.files;
        QWidget* window = here.window.get();
        QSignalSpy opened(recordings, &RecordingFiles::opened);
        recordings->open(mcap());
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, kPatience_ms);
        QCOMPARE(opened[0][0].toString(), file("run.teleta"));
        const auto answer = [&](const char* button) {
            recordings->open(mcap());
            auto* box = window->findChild<QMessageBox*>();
            QVERIFY(box != nullptr);
            box->findChild<QPushButton*>(QLatin1String(button))->click();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        };
        answer("openRecording");
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 2, kPatience_ms);
        QCOMPARE(opened[1][0].toString(), file("run.teleta"));
        answer("importAgain");
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 3, kPatience_ms);
        QCOMPARE(opened[2][0].toString(), file("run-2.teleta"));
        QCOMPARE(files(), (QStringList{"run-2.teleta", "run.mcap", "run.teleta"}));
    }
};

QTEST_MAIN(RecordingImportTest)
#include "recording_import_test.moc"
