// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/recording_dialog.h"
#include "tests/support/form_labels.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

using teleta::app::CsvRequest;
using teleta::console::RecordingDialog;

/// How a recording is to be read.
class RecordingDialogTest : public QObject {
    Q_OBJECT

    static CsvRequest guess() {
        CsvRequest request;
        request.path = "/somewhere/run.csv";
        request.layout = {12, 6, 0.05};
        request.tarePath = "/somewhere/empty.csv";
        request.gainsPath = "/somewhere/gains.csv";
        request.threshold_N = 5.0;
        request.loadUnit = "counts";
        return request;
    }

    static QSpinBox* spin(const RecordingDialog& dialog, const QString& name) {
        for (auto* box : dialog.findChildren<QSpinBox*>()) {
            if (box->accessibleName() == name)
                return box;
        }
        return nullptr;
    }

private slots:
    void givesBackTheGuessWhenNothingIsChanged() {
        const RecordingDialog dialog(guess());
        QCOMPARE(teleta::test::labelsWithBareMnemonic(dialog), QStringList());
        const CsvRequest request = dialog.request();
        QCOMPARE(request.path, guess().path);
        QCOMPARE(request.layout.rows, 12);
        QCOMPARE(request.layout.columns, 6);
        QCOMPARE(request.layout.pitchX_m, 0.05);
        QCOMPARE(request.tarePath, guess().tarePath);
        QCOMPARE(request.gainsPath, guess().gainsPath);
        QCOMPARE(request.threshold_N, 5.0);
        QCOMPARE(request.loadUnit, std::string("counts"));
        QCOMPARE(request.rate_Hz, 0.0);
        QVERIFY(!request.inverted);
    }

    void opensOnlyAnArrayThatFitsTheFile() {
        RecordingDialog dialog(guess());
        auto* open = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
        QVERIFY(open->isEnabled());
        auto* rows = spin(dialog, "Rows");
        QVERIFY(rows != nullptr);
        QTest::keyClick(rows, Qt::Key_Up);
        QVERIFY(!open->isEnabled());
        rows->setValue(6);
        spin(dialog, "Columns")->setValue(12);
        QVERIFY2(open->isEnabled(), "72 taxels are 6 x 12 as well");
        QCOMPARE(dialog.request().layout.rows, 6);
    }

    void acceptsWithReturnAndTakesTheSign() {
        RecordingDialog dialog(guess());
        dialog.show();
        QSignalSpy accepted(&dialog, &QDialog::accepted);
        for (auto* box : dialog.findChildren<QCheckBox*>()) {
            if (box->text().contains("fall"))
                QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
        }
        QTest::keyClick(&dialog, Qt::Key_Return);
        QCOMPARE(accepted.size(), 1);
        QVERIFY(dialog.request().inverted);
    }
};

QTEST_MAIN(RecordingDialogTest)
#include "recording_dialog_test.moc"
