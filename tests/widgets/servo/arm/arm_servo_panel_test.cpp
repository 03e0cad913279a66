// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/arm_servo/servo_bench.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/controls/hold_button.h"
#include "widgets/servo/arm/arm_servo_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

using namespace teleta;
using arm_servo::ArmServoPanel;
using arm_servo::ArmTask;

namespace {

/// The panel in a window with another field.
struct Window {
    Window() {
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(panel);
        layout->addWidget(other);
        window.show();
        window.activateWindow();
        (void)QTest::qWaitForWindowActive(&window);
        panel->setFocus();
    }
    [[nodiscard]] base::HoldButton* button() const {
        return panel->findChild<base::HoldButton*>("armServoHold");
    }
    [[nodiscard]] QString text(const char* name) const { return panel->findChild<QLabel*>(name)->text(); }

    QWidget window;
    ArmServoPanel* panel = new ArmServoPanel(&window);
    QLineEdit* other = new QLineEdit(&window);
};

} // namespace

class ArmServoPanelTest : public QObject {
    Q_OBJECT

private slots:
    void theButtonAndSpaceAreTheSwitch() {
        Window at;
        QSignalSpy held(at.panel, &ArmServoPanel::heldChanged);
        QTest::mousePress(at.button(), Qt::LeftButton);
        QVERIFY(at.panel->isHeld());
        QTest::mouseRelease(at.button(), Qt::LeftButton);
        QVERIFY(!at.panel->isHeld());
        QTest::keyPress(at.panel, Qt::Key_Space);
        QVERIFY(at.panel->isHeld());
        QTest::keyRelease(at.panel, Qt::Key_Space);
        QVERIFY(!at.panel->isHeld());
        QCOMPARE(held.count(), 4);
        // Other keys are not.
        QTest::keyPress(at.panel, Qt::Key_Shift);
        QTest::keyPress(at.panel, Qt::Key_Space, Qt::ShiftModifier);
        QVERIFY(!at.panel->isHeld());
    }

    void losingTheKeyboardOrBeingHiddenLetsGo() {
        Window at;
        QTest::keyPress(at.panel, Qt::Key_Space);
        QVERIFY(at.panel->isHeld());
        at.other->setFocus();
        QVERIFY(!at.panel->isHeld());
        // The key is still down: what repeats it does not hold again.
        at.panel->setFocus();
        QVERIFY(!at.panel->isHeld());
        QTest::keyPress(at.panel, Qt::Key_Space);
        QVERIFY(at.panel->isHeld());
        at.panel->hide();
        QVERIFY(!at.panel->isHeld());
        at.panel->show();
        QVERIFY(!at.panel->isHeld());
        QTest::mousePress(at.button(), Qt::LeftButton);
        QVERIFY(at.panel->isHeld());
        at.panel->setEnabled(false);
        QVERIFY(!at.panel->isHeld());
    }

    void anotherTaskOrForceIsToldAndLetsGo() {
        Window at;
        QSignalSpy changed(at.panel, &ArmServoPanel::taskChanged);
        QTest::keyPress(at.panel, Qt::Key_Space);
        auto* tasks = at.panel->findChild<QComboBox*>("armTask");
        QCOMPARE(tasks->count(), int(arm_servo::kArmTasks.size()));
        tasks->setCurrentIndex(1);
        QVERIFY(!at.panel->isHeld());
        QCOMPARE(changed.count(), 1);
        QCOMPARE(at.panel->task(), ArmTask::explore);
        at.panel->findChild<QDoubleSpinBox*>("armForce")->setValue(5.0);
        QCOMPARE(changed.count(), 2);
        QCOMPARE(at.panel->force_N(), 5.0);
    }

    void itSaysWhatTheNextPressDoes() {
        Window at;
        arm_servo::test::ServoBench bench;
        const auto show = [&] { at.panel->setState(bench.servo, bench.newest, QString()); };
        show();
        QVERIFY(at.text("armServoStage").contains("rehearsal"));
        QVERIFY(at.button()->text().contains("rehearse"));
        bench.press();
        bench.run(2.0);
        show();
        QVERIFY(at.text("armServoStage").contains("the arm gets no command"));
        bench.release();
        bench.run(0.1);
        show();
        QVERIFY(at.text("armServoStage").contains("MOVES THE ARM"));
        QVERIFY(at.button()->text().contains("move the arm"));
        bench.press();
        bench.run(0.5);
        show();
        QVERIFY(at.text("armServoStage").contains("THE ARM MOVES"));
        bench.stopped = true;
        bench.run(0.1);
        show();
        QVERIFY(at.text("armServoEnding").contains("STOP"));
        const auto* ending = at.panel->findChild<QLabel*>("armServoEnding");
        const auto* stage = at.panel->findChild<QLabel*>("armServoStage");
        QTRY_VERIFY(ending->y() < stage->y());
        QVERIFY(ending->palette().color(QPalette::WindowText) !=
                stage->palette().color(QPalette::WindowText));
        QVERIFY(at.text("armServoStage").contains("rehearsal"));
        at.panel->setRefusal("the pad is made of stone");
        QVERIFY(at.text("armServoStage").contains("the pad is made of stone"));
        QVERIFY(!at.button()->isEnabled());
        QTest::keyPress(at.panel, Qt::Key_Space);
        QVERIFY(!at.panel->isHeld());
    }
};

namespace {
const teleta::test::Registration<ArmServoPanelTest> registration;
}
#include "arm_servo_panel_test.moc"
