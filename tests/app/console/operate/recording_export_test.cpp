// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_export.h"
#include "backend/recording/recorder.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWidget>

#include <array>

using namespace teleta;
using console::RecordingExport;

/// Exports of recordings in the window.
class RecordingExportTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QWidget m_window;

    [[nodiscard]] QString recording() const { return m_folder.filePath("run.teleta"); }
    [[nodiscard]] QString csv() const { return m_folder.filePath("csv"); }
    void cancel() { m_window.findChild<QProgressDialog*>()->findChild<QPushButton*>()->click(); }

private slots:
    /// So long that an export is usually far from its end when it is cancelled.
    void initTestCase() {
        recording::RecordingHead head;
        head.start_ns = 1;
        auto recorder = recording::Recorder::start(recording().toStdString(), head,
                                                   {.simulatedTime = true, .queueBlocks = 10'000});
        QVERIFY(recorder);
        recording::StreamInfo info;
        info.name = "frames";
        info.kind = recording::StreamKind::array;
        info.type = recording::ValueType::float32;
        info.shape = {16, 16};
        const auto tap = (*recorder)->addStream(info);
        const std::array<float, 256> values{0.1F, 0.2F, 0.3F};
        for (int i = 0; i < 10'000; ++i)
            tap->append(1 + i * 1'000'000LL, 0.001 * i, std::span<const float>(values));
        QVERIFY((*recorder)->stop());
    }

    void theQuestionsSayThatSomethingIsExported() {
        RecordingExport exporter(&m_window);
        m_window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&m_window));
        exporter.ask(recording());
        auto* files = m_window.findChild<QFileDialog*>();
        QVERIFY(files != nullptr);
        QCOMPARE(files->labelText(QFileDialog::Accept), QStringLiteral("Export\u2026"));
        QTRY_VERIFY(files->isVisible());
        QTest::keyClick(files, Qt::Key_Escape);
        QTRY_VERIFY(m_window.findChild<QFileDialog*>() == nullptr);
        exporter.askMcap(recording());
        files = m_window.findChild<QFileDialog*>();
        QVERIFY(files != nullptr);
        QCOMPARE(files->labelText(QFileDialog::Accept), QStringLiteral("Export\u2026"));
        QTRY_VERIFY(files->isVisible());
        QTest::keyClick(files, Qt::Key_Escape);
        QTRY_VERIFY(m_window.findChild<QFileDialog*>() == nullptr);
        m_window.hide();
        QVERIFY(!exporter.isBusy());
    }

    void anExportThatIsCancelledLeavesNoFiles() {
        RecordingExport exporter(&m_window);
        QSignalSpy busy(&exporter, &RecordingExport::busyChanged);
        QSignalSpy finished(&exporter, &RecordingExport::finished);
        exporter.start(recording(), csv());
        QVERIFY(exporter.isBusy());
        cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!exporter.isBusy(), 60'000);
        QCOMPARE(finished.size(), 0);
        QVERIFY(!QDir(csv()).exists());
        QCOMPARE(busy.size(), 2);
        QVERIFY(busy[0][0].toBool() && !busy[1][0].toBool());
    }

    void aFolderThatWasThereStaysWithWhatIsInIt() {
        QVERIFY(QDir().mkpath(csv() + "/mine"));
        RecordingExport exporter(&m_window);
        exporter.start(recording(), csv());
        cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!exporter.isBusy(), 60'000);
        QCOMPARE(QDir(csv()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList("mine"));
    }

    void anExportThatWasWholeWhenItWasCancelledLeavesNoFilesEither() {
        RecordingExport exporter(&m_window);
        QSignalSpy finished(&exporter, &RecordingExport::finished);
        exporter.start(recording(), csv());
        // No event is handled meanwhile: the window has not seen that it is done.
        const QFileInfo events(csv() + "/events.csv");
        for (int wait = 0; wait < 6000 && !QFileInfo::exists(events.filePath()); ++wait)
            QThread::msleep(10);
        QVERIFY(QFileInfo::exists(events.filePath()));
        cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!exporter.isBusy(), 60'000);
        QCOMPARE(finished.size(), 0);
        QCOMPARE(QDir(csv()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList("mine"));
    }

    void anMcapFileIsWrittenAndOneThatIsCancelledIsNot() {
        RecordingExport exporter(&m_window);
        QSignalSpy finished(&exporter, &RecordingExport::finishedMcap);
        const QString file = m_folder.filePath("run.mcap");
        exporter.startMcap(recording(), file);
        QVERIFY(exporter.isBusy());
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, 60'000);
        QCOMPARE(finished[0][0].toString(), file);
        QCOMPARE(finished[0][1].toInt(), 0);
        QVERIFY(finished[0][2].toBool());
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QVERIFY(written.read(8) == QByteArray("\x89MCAP0\r\n", 8));
        exporter.startMcap(recording(), m_folder.filePath("never.mcap"));
        cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!exporter.isBusy(), 60'000);
        QCOMPARE(finished.size(), 1);
        QVERIFY(!QFileInfo::exists(m_folder.filePath("never.mcap")));
    }

    void anotherExportMeanwhileIsRefusedAndSaysSo() {
        RecordingExport exporter(&m_window);
        QSignalSpy failed(&exporter, &RecordingExport::failed);
        exporter.start(recording(), m_folder.filePath("first"));
        exporter.start(recording(), m_folder.filePath("second"));
        QCOMPARE(failed.size(), 1);
        QCOMPARE(failed[0][0].toString(), QString("run.teleta"));
        QVERIFY(!QDir(m_folder.filePath("second")).exists());
        cancel();
        QTRY_VERIFY_WITH_TIMEOUT(!exporter.isBusy(), 60'000);
    }
};

QTEST_MAIN(RecordingExportTest)
#include "recording_export_test.moc"
