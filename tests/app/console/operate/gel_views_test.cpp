// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_service.h"
#include "app/console/operate/gel_views.h"
#include "app/console/operate/operate_page.h"
#include "app/console/sources/source_manager.h"
#include "tests/app/cli/gel_video.h"
#include "tests/app/console/operate/operate_bench.h"
#include "widgets/camera/gel/gel_event_table.h"
#include "widgets/camera/gel/gel_panel.h"
#include "widgets/camera/gel/gel_view.h"
#include "widgets/view3d/scene3d_view.h"

#include <QFile>
#include <QFileInfo>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <memory>
#include <string>

using namespace teleta;
using console::OperateDocks;
using console::OperatePage;
using console::SourceManager;

/// A video of a flat gel from its sensor file to the views of the Operate page.
class GelViewsTest : public test::OperateBench {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::string m_file;

    camera::GelPanel& panel() { return m_page->gelViews().panel(); }
    const pipeline::GelSnapshot& shown() { return panel().view().picture().shown; }
    long listed(const QString& event) {
        const camera::GelEventModel& model = m_page->gelViews().events().model();
        long count = 0;
        for (int row = 0; row < model.rowCount(); ++row)
            count += model.index(row, camera::GelEventModel::event).data().toString() == event ? 1 : 0;
        return count;
    }

private slots:
    void initTestCase() {
        QVERIFY(test::writeGelVideo(m_folder.filePath("press.avi").toStdString(), 30));
        QFile file(m_folder.filePath("gel.toml"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("source = \"press.avi\"\n");
        file.write(test::kGelFile);
        m_file = file.fileName().toStdString();
    }

    void init() {
        makePage();
        m_sources->open(app::GelRequest{m_file});
        QVERIFY(comes([&] { return m_sources->active() != nullptr && m_sources->active()->isOpen(); }));
    }

    void cleanup() { closePage(); }

    void aDragIsSeenAndToldAndTheVideoStartsAgain() {
        QVERIFY(m_page->docks().kind() == OperateDocks::Kind::gel);
        QVERIFY(comes([&] { return panel().isEnabled() && shown().hasReference(); }));
        QVERIFY(panel().view().picture().provenance == base::Provenance::recorded);
        QVERIFY(comes([&] { return !shown().contacts.empty(); }));
        QVERIFY(comes([&] { return listed("touched") > 0; }));
        QCOMPARE(listed("rest taken"), 1L);
        QVERIFY(comes([&] { return listed("restarted") > 0; }));
        const auto readings = m_page->readings();
        QVERIFY(readings.front().displayed > 0);
        QVERIFY(readings.front().latency_s.has_value());
    }

    void theReconstructionHasTheGelEnlargedAsInItsPictureUntilItGoes() {
        QVERIFY(comes([&] { return !shown().contacts.empty(); }));
        const QString path = m_folder.filePath("gel.stl");
        QVERIFY(m_page->reconstruction().saveGeometry(path));
        const qint64 whole = QFileInfo(path).size();
        // 80 markers, each a disc: far more than the gel's six faces.
        QVERIFY(whole > 84 + 50 * 80 * 20);
        m_sources->closeAll();
        QVERIFY(comes([&] { return !panel().isEnabled(); }));
        QVERIFY2(!m_page->reconstruction().saveGeometry(path), "nothing is left");
    }

    void theButtonTakesTheRestAnew() {
        QVERIFY(comes([&] { return listed("rest taken") == 1; }));
        QTest::mouseClick(panel().findChild<QPushButton*>("gelReference"), Qt::LeftButton);
        QVERIFY(comes([&] { return listed("rest taken") == 2; }));
    }

    void eventsStayWithTheirSourceAndTheDocksBelongToGels() {
        QVERIFY(comes([&] { return listed("touched") > 0; }));
        const auto first = m_sources->active()->key;
        const auto second = m_sources->open(app::GelRequest{m_file});
        QVERIFY(comes([&] { return m_sources->active() != nullptr && m_sources->active()->key == second; }));
        m_sources->activate(first);
        QVERIFY(comes([&] { return m_sources->active()->key == first; }));
        QVERIFY(listed("rest taken") >= 1);
        QVERIFY(OperateDocks::belongs(OperateDocks::Kind::gel, OperateDocks::gel));
        QVERIFY(OperateDocks::belongs(OperateDocks::Kind::gel, OperateDocks::reconstruction));
        QVERIFY(!OperateDocks::belongs(OperateDocks::Kind::gel, OperateDocks::camera));
        QVERIFY(!OperateDocks::belongs(OperateDocks::Kind::camera, OperateDocks::gel));
        m_sources->closeAll();
        QVERIFY(comes([&] { return !panel().isEnabled(); }));
        QVERIFY(panel().view().picture().isEmpty());
    }
};

QTEST_MAIN(GelViewsTest)
#include "gel_views_test.moc"
