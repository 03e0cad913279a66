// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/recording_export.h"
#include "backend/recording/recorder.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
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
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        RecordingExport exporter(&m_window);
        QSignalSpy finished(&exporter, &RecordingExport::finished);
        m_window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&m_window));
        const auto dialog = [this] { return m_window.findChild<QFileDialog*>(); };
        const auto accept = [&] {
            for (auto* button : dialog()->findChildren<QPushButton*>())
                if (button->isVisible() && button->isDefault())
                    return button;
            return static_cast<QPushButton*>(nullptr);
        };
        const auto name = [&] { return dialog()->findChild<QLineEdit*>(QStringLiteral("fileNameEdit")); };
        exporter.ask(recording());
        // As soon as the folder is read, the recording is chosen.
        QTRY_COMPARE(name()->text(), QStringLiteral("run.teleta"));
        QTRY_VERIFY(accept() != nullptr && accept()->isEnabled());
        QCOMPARE(accept()->text(), QStringLiteral("Export\u2026"));
        QTest::mouseClick(accept(), Qt::LeftButton);
        QTRY_VERIFY(dialog() != nullptr && dialog()->fileMode() == QFileDialog::Directory &&
                    dialog()->isVisible() && accept() != nullptr);
        name()->selectAll();
        QTest::keyClicks(name(), m_folder.path());
        QCOMPARE(accept()->text(), QStringLiteral("Export here"));
        QTest::mouseClick(accept(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, 60'000);
        QVERIFY(QFile::exists(m_folder.filePath(QStringLiteral("run/events.csv"))));

        exporter.askMcap(recording());
        QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible() && accept() != nullptr);
        QCOMPARE(accept()->text(), QStringLiteral("Export\u2026"));
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QTRY_VERIFY(dialog() == nullptr);
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
