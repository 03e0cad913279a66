// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "tests/widgets/touch/sample_arm.h"
#include "widgets/touch/jog/jog_panel.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace teleta;
using touch::JogPanel;

/// The room that the jog panel needs.
class JogRoomTest : public QObject {
    Q_OBJECT

private slots:
    void inASmallWindowItNeedsLessRoomAndSaysTheSame() {
        JogPanel panel;
        panel.setArm(test::sampleArm());
        panel.setDrive(core::ArmDrive::held);
        panel.setHandText("3D mouse: none is plugged in.");
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const auto least = [&panel] {
            QCoreApplication::processEvents();
            return panel.minimumSizeHint();
        };
        const QSize usual = least();
        panel.setCompact(true, false);
        const QSize low = least();
        QVERIFY(low.height() < usual.height() - 2 * panel.fontMetrics().height());
        QCOMPARE(low.width(), usual.width());
        panel.setCompact(true, true);
        QVERIFY(least().width() < usual.width());
        auto* run = panel.findChild<QPushButton*>("run");
        QVERIFY(run->text().isEmpty());
        QCOMPARE(run->accessibleName(), QStringLiteral("Run"));
        QVERIFY(run->toolTip().startsWith("Run: "));
        const QSignalSpy asked(&panel, &JogPanel::programRunRequested);
        QTest::mouseClick(run, Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
        panel.setCompact(false, false);
        QCOMPARE(least(), usual);
    }
};

namespace {
const test::Registration<JogRoomTest> registration;
}
#include "jog_room_test.moc"
