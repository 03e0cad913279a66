// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/redo_keys.h"

#include <QKeyEvent>
#include <QTest>

using namespace teleta;

class RedoKeysTest : public QObject {
    Q_OBJECT

private slots:
    void areThoseOfTheDesktopAndCtrlYEachOnce() {
        const QList<QKeySequence> keys = base::redoKeys();
        for (const QKeySequence& desktop : QKeySequence::keyBindings(QKeySequence::Redo))
            QCOMPARE(keys.count(desktop), qsizetype(1));
        QCOMPARE(keys.count(QKeySequence(Qt::CTRL | Qt::Key_Y)), qsizetype(1));
    }

    void areToldFromOtherKeys() {
        QVERIFY(base::isRedo(QKeyEvent(QEvent::KeyPress, Qt::Key_Y, Qt::ControlModifier)));
        QVERIFY(!base::isRedo(QKeyEvent(QEvent::KeyPress, Qt::Key_Y, Qt::NoModifier)));
        QVERIFY(!base::isRedo(QKeyEvent(QEvent::KeyPress, Qt::Key_Z, Qt::ControlModifier)));
    }
};

static const test::Registration<RedoKeysTest> registration;
#include "redo_keys_test.moc"
