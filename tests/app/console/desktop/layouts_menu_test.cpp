// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/desktop/layouts_menu.h"
#include "app/console/operate/docks/operate_docks.h"

#include <QComboBox>
#include <QDockWidget>
#include <QInputDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using teleta::console::ConsoleSettings;
using teleta::console::LayoutsMenu;
using teleta::console::OperateDocks;

class LayoutsMenuTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<ConsoleSettings> m_settings;
    std::unique_ptr<QMainWindow> m_window;
    OperateDocks* m_docks = nullptr;
    LayoutsMenu* m_layouts = nullptr;
    QMenu* m_view = nullptr;

    QDockWidget* dock(const char* name) const {
        return m_docks->findChild<QDockWidget*>(QLatin1String(name));
    }

    QStringList texts() const {
        auto* menu = m_view->findChild<QMenu*>("layouts");
        emit menu->aboutToShow();
        QStringList texts;
        for (const QAction* action : menu->actions())
            if (!action->isSeparator())
                texts << action->text();
        return texts;
    }
    void trigger(const QString& text, const QString& below = {}) const {
        auto* menu = m_view->findChild<QMenu*>("layouts");
        emit menu->aboutToShow();
        for (QAction* action : menu->actions()) {
            if (!below.isEmpty() && action->text() == below)
                for (QAction* part : action->menu()->actions())
                    if (part->text() == text)
                        part->trigger();
            if (below.isEmpty() && action->text() == text) {
                action->trigger();
                return;
            }
        }
    }

private slots:
    void init() {
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        m_settings = std::make_unique<ConsoleSettings>(false);
        m_window = std::make_unique<QMainWindow>();
        m_docks = new OperateDocks(m_window.get());
        for (std::size_t i = 0; i < OperateDocks::kDocks; ++i)
            m_docks->add(static_cast<OperateDocks::Dock>(i), new QWidget);
        m_docks->begin();
        m_window->setCentralWidget(m_docks);
        m_window->resize(900, 700);
        m_layouts = new LayoutsMenu(*m_docks, *m_settings, m_window.get());
        m_view = new QMenu(m_window.get());
        m_layouts->fill(*m_view);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup() {
        m_window.reset();
        m_settings.reset();
        QFile::remove(m_folder.filePath("teleta/console.ini"));
    }

    void aLayoutIsSavedUnderANameChosenAndDeleted() {
        QCOMPARE(texts().size(), 1); // to save
        dock("processing")->close();
        m_layouts->save("  wide & low ");
        m_docks->resetLayout();
        QVERIFY(dock("processing")->isVisible());
        QVERIFY(texts().contains("wide && low"));
        trigger("wide && low");
        QVERIFY(!dock("processing")->isVisible());
        // It is still there for the next start.
        QCOMPARE(ConsoleSettings(false).namedLayouts().keys(), QStringList{"wide & low"});
        trigger("wide && low", texts().last());
        QCOMPARE(texts().size(), 1);
        QVERIFY(ConsoleSettings(false).namedLayouts().isEmpty());
    }

    void theNameIsTypedAndOneThatIsThereIsReplaced() {
        m_layouts->save("mine");
        dock("charts")->close();
        trigger(texts().filter("Save").last());
        auto* dialog = m_window->findChild<QInputDialog*>();
        QVERIFY(dialog != nullptr);
        QVERIFY(QTest::qWaitForWindowExposed(dialog));
        auto* box = dialog->findChild<QComboBox*>();
        box->lineEdit()->selectAll();
        QTest::keyClicks(box->lineEdit(), "mine");
        QTest::keyClick(box->lineEdit(), Qt::Key_Return);
        QTRY_COMPARE(m_settings->namedLayouts().size(), 1);
        m_docks->resetLayout();
        m_layouts->choose("mine");
        QVERIFY(!dock("charts")->isVisible());
    }

    void nothingIsSavedUnderNoName() {
        m_layouts->save("   ");
        QVERIFY(m_settings->namedLayouts().isEmpty());
    }

    void aDamagedLayoutIsToldAndTheDefaultOneShown() {
        QSignalSpy told(m_layouts, &LayoutsMenu::notRestored);
        m_settings->setNamedLayout("broken", "no layout");
        dock("charts")->close();
        m_layouts->choose("broken");
        QCOMPARE(told.count(), 1);
        QCOMPARE(told.front().front().toString(), QString("broken"));
        QVERIFY(dock("charts")->isVisible());
    }
};

QTEST_MAIN(LayoutsMenuTest)
#include "layouts_menu_test.moc"
