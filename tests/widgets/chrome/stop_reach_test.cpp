// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/theme.h"
#include "widgets/chrome/stop_button.h"
#include "widgets/chrome/stop_reach.h"

#include <QComboBox>
#include <QDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWindow>

using teleta::chrome::StopButton;
using teleta::chrome::StopReach;

/// STOP by the mouse while a dialog, a menu or a list has the mouse.
class StopReachTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QWidget> m_window;
    StopButton* m_button = nullptr;
    QComboBox* m_list = nullptr;
    std::unique_ptr<StopReach> m_reach;
    std::unique_ptr<QSignalSpy> m_stops;

    [[nodiscard]] QPoint middle() const { return m_button->mapToGlobal(m_button->rect().center()); }
    /// As the window system does: to the window, where a modal dialog blocks it.
    static void press(QWidget& widget, const QPoint& global) {
        QTest::mousePress(widget.windowHandle(), Qt::LeftButton, {}, widget.mapFromGlobal(global));
        QTest::mouseRelease(widget.windowHandle(), Qt::LeftButton, {}, widget.mapFromGlobal(global));
    }
    [[nodiscard]] bool isOverTheButton() const {
        const StopButton* other = m_reach->substitute();
        return other != nullptr && other->isVisible() &&
               other->geometry() == QRect(m_button->mapToGlobal(QPoint()), m_button->size());
    }

private slots:
    void initTestCase() { teleta::base::applyTheme(teleta::base::ThemeChoice::light); }
    void init() {
        m_window = std::make_unique<QWidget>();
        m_button = new StopButton(m_window.get());
        m_list = new QComboBox(m_window.get());
        m_list->addItems({"one", "two"});
        auto* column = new QVBoxLayout(m_window.get());
        column->addWidget(m_list);
        column->addStretch();
        column->addWidget(m_button, 0, Qt::AlignRight);
        m_window->resize(600, 400);
        m_reach = std::make_unique<StopReach>(*m_button);
        m_stops = std::make_unique<QSignalSpy>(m_button, &StopButton::stopRequested);
        connect(m_button, &StopButton::stopRequested, this, [this] { m_button->setEngaged(true); });
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup() {
        m_reach.reset();
        m_stops.reset();
        m_window.reset();
    }

    void worksOverAModalDialog() {
        QDialog dialog(m_window.get());
        dialog.open();
        QTRY_VERIFY(isOverTheButton());
        // The window itself is blocked.
        press(*m_window, middle());
        QCOMPARE(m_stops->size(), 0);
        press(*m_reach->substitute(), middle());
        QCOMPARE(m_stops->size(), 1);
        QVERIFY(m_reach->substitute()->engaged());
        QVERIFY(dialog.isVisible());
        dialog.close();
        QTRY_VERIFY(m_reach->substitute() == nullptr);
        press(*m_window, middle());
        QCOMPARE(m_stops->size(), 1); // engaged: a click asks for nothing
    }

    void releasesOverADialogOnlyByHolding() {
        m_button->setEngaged(true);
        QDialog dialog(m_window.get());
        dialog.open();
        QTRY_VERIFY(isOverTheButton());
        QSignalSpy releases(m_button, &StopButton::releaseRequested);
        StopButton& other = *m_reach->substitute();
        press(other, middle());
        QCOMPARE(releases.size(), 0);
        QTest::mousePress(other.windowHandle(), Qt::LeftButton, {}, other.rect().center());
        QTRY_COMPARE_WITH_TIMEOUT(releases.size(), 1, 5 * StopButton::kHold_ms);
        QTest::mouseRelease(other.windowHandle(), Qt::LeftButton, {}, other.rect().center());
    }

    void followsTheWindowAndTheDialogOnTop() {
        QDialog dialog(m_window.get());
        dialog.open();
        QTRY_VERIFY(isOverTheButton());
        m_window->move(m_window->pos() + QPoint(40, 30));
        QTRY_VERIFY(isOverTheButton());
        m_window->resize(500, 300);
        QTRY_VERIFY(isOverTheButton());
        QMessageBox question(&dialog);
        question.open();
        QTRY_VERIFY(m_reach->substitute() != nullptr && m_reach->substitute()->parent() == &question);
        QTRY_VERIFY(isOverTheButton());
        press(*m_reach->substitute(), middle());
        QCOMPARE(m_stops->size(), 1);
        question.close();
        QTRY_VERIFY(m_reach->substitute() != nullptr && m_reach->substitute()->parent() == &dialog);
        QTRY_VERIFY(isOverTheButton());
    }

    void theKeyboardGoesBackToTheDialog() {
        QDialog dialog(m_window.get());
        dialog.open();
        QTRY_VERIFY(isOverTheButton());
        QTRY_VERIFY(QGuiApplication::focusWindow() == dialog.windowHandle());
        m_window->windowHandle()->requestActivate();
        QTRY_VERIFY(QGuiApplication::focusWindow() == dialog.windowHandle());
    }

    void aPressThatClosesAMenuStops() {
        QMenu menu(m_window.get());
        menu.addAction("Something");
        menu.popup(m_window->mapToGlobal(QPoint(10, 10)));
        QTRY_VERIFY(QApplication::activePopupWidget() == &menu);
        press(menu, middle());
        QCOMPARE(m_stops->size(), 1);
        QTRY_VERIFY(!menu.isVisible());
        // One that hits nothing only closes it.
        m_button->setEngaged(false);
        menu.popup(m_window->mapToGlobal(QPoint(10, 10)));
        QTRY_VERIFY(QApplication::activePopupWidget() == &menu);
        press(menu, m_window->mapToGlobal(QPoint(300, 200)));
        QCOMPARE(m_stops->size(), 1);
        // Nor does one on a menu that lies over it.
        menu.popup(m_button->mapToGlobal(QPoint()));
        QTRY_VERIFY(QApplication::activePopupWidget() == &menu);
        press(menu, menu.geometry().center());
        QCOMPARE(m_stops->size(), 1);
    }

    void aPressThatClosesAListStops() {
        m_list->showPopup();
        QTRY_VERIFY(QApplication::activePopupWidget() != nullptr);
        QWidget& list = *QApplication::activePopupWidget();
        press(list, middle());
        QCOMPARE(m_stops->size(), 1);
        QTRY_VERIFY(QApplication::activePopupWidget() == nullptr);
    }
};

QTEST_MAIN(StopReachTest)
#include "stop_reach_test.moc"
