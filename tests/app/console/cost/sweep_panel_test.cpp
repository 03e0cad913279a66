// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/scene_file.h"
#include "app/console/cost/cost_page.h"
#include "app/console/cost/sweep_panel.h"
#include "backend/cost/ladders/ladders.h"
#include "widgets/base/figure/svg_view.h"
#include "widgets/base/theme.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace teleta;
using console::CostPage;
using console::SweepPanel;

class SweepPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_page = std::make_unique<CostPage>(&cost::allLadders, QString());
        m_page->resize(1100, 700);
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
        auto* tabs = m_page->findChild<QTabWidget*>(QStringLiteral("costTabs"));
        tabs->setCurrentIndex(1);
        m_panel = &m_page->sweeps();
        QVERIFY(m_panel->isVisible());
        QVERIFY(m_folder.isValid());
    }
    void cleanup() { m_page.reset(); }

    void opensASweepThatComesWithTheProgram() {
        QVERIFY(!start()->isEnabled());
        choose(QStringLiteral("contour-ladder"));
        QTRY_VERIFY(start()->isEnabled());
        QCOMPARE(m_panel->findChild<QLabel*>(QStringLiteral("sweepTitle"))->text(),
                 QStringLiteral("Curve through contact points"));
        QCOMPARE(measures()->count(), 0);
    }

    void saysWhatASweepVariesBeforeItRuns() {
        const auto* plan = m_panel->findChild<QLabel*>(QStringLiteral("sweepPlan"));
        choose(QStringLiteral("servo-friction"));
        QTRY_VERIFY(plan->text().contains(QStringLiteral("servo-bent-bar")));
        for (const char* part : {"radius_m", "0.0015, 0.003, 0.006, 0.012", "coefficient", "delay_s",
                                 "completed, force_rms_error_n"})
            QVERIFY2(plan->text().contains(QLatin1String(part)), qPrintable(plan->text()));
        QVERIFY(plan->isVisible());
    }

    void everySweepThatComesWithTheProgramHasATitleBelowAHeading() {
        const auto* list = m_panel->findChild<QListWidget*>(QStringLiteral("sweeps"));
        QVERIFY(!list->item(0)->flags().testFlag(Qt::ItemIsEnabled));
        int sweeps = 0;
        for (int row = 0; row < list->count(); ++row) {
            const QString name = list->item(row)->data(Qt::UserRole).toString();
            sweeps += name.isEmpty() ? 0 : 1;
            QVERIFY2(!list->item(row)->text().isEmpty() && list->item(row)->text() != name, qPrintable(name));
        }
        QCOMPARE(sweeps, app::sweepNames().size());
    }

    void runsASweepAndDrawsIt() {
        choose(QStringLiteral("contour-ladder"));
        QTRY_VERIFY(start()->isEnabled());
        const QString folder = m_folder.filePath(QStringLiteral("run"));
        m_panel->running().start(folder);
        QVERIFY(m_panel->running().isRunning());
        QVERIFY(!start()->isEnabled());
        QVERIFY(cancel()->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!m_panel->running().isRunning(), 60'000);
        QVERIFY(QFile::exists(folder + QStringLiteral("/runs.csv")));
        QCOMPARE(measures()->itemText(0), QStringLiteral("error"));
        auto* table = m_panel->findChild<QTableWidget*>(QStringLiteral("sweepCells"));
        QCOMPARE(table->rowCount(), 12); // six numbers of points with two kinds of splines
        QCOMPARE(table->item(0, 1)->text(), QStringLiteral("40"));
        auto* picture = m_panel->findChild<base::SvgView*>(QStringLiteral("sweepPicture"));
        QVERIFY(picture->picture().has_value());
        const QString first = table->item(0, 3)->text();
        QTest::keyClick(measures(), Qt::Key_Down);
        QCOMPARE(measures()->currentText(), QStringLiteral("time_s"));
        QVERIFY(table->item(0, 3)->text() != first);
        QCOMPARE(picture->picture()->file, QStringLiteral("time_s"));

        // The results open again in another window.
        CostPage other(&cost::allLadders, QString());
        other.sweeps().running().open(folder);
        QTRY_VERIFY(other.sweeps().running().shown() != nullptr);
        QCOMPARE(other.sweeps().running().shown()->results->done, std::uint64_t{480});
    }

    void canBeCancelledAndGoesOn() {
        QFile file(m_folder.filePath(QStringLiteral("long.toml")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("[sweep]\nscene = \"tactile-two-contacts\"\nseeds = "
                   "\"1:400\"\n[sweep.vary]\n\"duration_s\" = [2.0, 3.0]\n");
        file.close();
        m_panel->running().open(file.fileName());
        QTRY_VERIFY(start()->isEnabled());
        const QString folder = m_folder.filePath(QStringLiteral("cancelled"));
        m_panel->running().start(folder);
        QTRY_VERIFY_WITH_TIMEOUT(m_panel->running().progress() && m_panel->running().progress()->done > 0,
                                 30'000);
        m_panel->tick();
        QTest::mouseClick(cancel(), Qt::LeftButton);
        QVERIFY(m_panel->running().isCancelled());
        QTRY_VERIFY_WITH_TIMEOUT(!m_panel->running().isRunning(), 30'000);
        const auto& results = m_panel->running().shown()->results;
        QVERIFY(results.has_value());
        QVERIFY(results->done > 0);
        QVERIFY(results->done < 800);
    }

    void saysWhatIsWrongWithAFile() {
        QFile file(m_folder.filePath(QStringLiteral("bad.toml")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("[sweep]\nscene = \"teleta-touch\"\n[sweep.vary]\n\"skin.pitch\" = [1.0]\n");
        file.close();
        m_panel->running().open(file.fileName());
        QTRY_VERIFY(start()->isEnabled());
        QSignalSpy failed(m_panel, &SweepPanel::failed);
        m_panel->running().start(m_folder.filePath(QStringLiteral("bad")));
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(failed.at(0).at(1).toString().contains(QStringLiteral("bad.toml:4")));
        QTRY_VERIFY(!m_panel->running().isRunning());
        m_panel->running().open(m_folder.filePath(QStringLiteral("none.toml")));
        QTRY_COMPARE(failed.size(), 2);
    }

private:
    void choose(const QString& name) {
        auto* list = m_panel->findChild<QListWidget*>(QStringLiteral("sweeps"));
        for (int row = 0; row < list->count(); ++row)
            if (list->item(row)->data(Qt::UserRole).toString() == name)
                QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                                  list->visualItemRect(list->item(row)).center());
        QVERIFY(list->currentItem() != nullptr);
        QCOMPARE(list->currentItem()->data(Qt::UserRole).toString(), name);
    }
    QPushButton* start() { return m_panel->findChild<QPushButton*>(QStringLiteral("startSweep")); }
    QPushButton* cancel() { return m_panel->findChild<QPushButton*>(QStringLiteral("cancelSweep")); }
    QComboBox* measures() { return m_panel->findChild<QComboBox*>(QStringLiteral("sweepMeasure")); }

    QTemporaryDir m_folder;
    std::unique_ptr<CostPage> m_page;
    SweepPanel* m_panel = nullptr;
};

QTEST_MAIN(SweepPanelTest)
#include "sweep_panel_test.moc"
