// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/signal/signal_drop_area.h"
#include "widgets/signal/signal_table.h"
#include "widgets/signal/signal_tree.h"
#include "widgets/signal/signals_mime.h"

#include <QAction>
#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>
#include <QTreeWidget>
#include <QUrl>

using namespace teleta;
using namespace teleta::signal;

class SignalTreeTest : public QObject {
    Q_OBJECT

    std::unique_ptr<SignalTree> m_tree;
    std::vector<SourceEntry> m_entries;

    [[nodiscard]] QModelIndex child(const QModelIndex& parent, int row) const {
        return m_tree->view().model()->index(row, 0, parent);
    }

private slots:
    void init() {
        m_entries = {
            {"skin", {}, {{"features", {{"force_n", "N"}, {"cop_x_m", "m"}}}, {"frames", {{"t0", "N"}}}}},
            {"run.teleta", "whole recording", {{"joints", {{"q1", "rad"}}}}}};
        m_tree = std::make_unique<SignalTree>();
        m_tree->setValues([](const SignalId& id) { return QString::fromStdString("value of " + id.column); });
        m_tree->setSources(m_entries);
        m_tree->resize(400, 500);
        m_tree->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_tree.get()));
    }

    void listsSourcesStreamsAndSignals() {
        const QAbstractItemModel& model = *m_tree->view().model();
        QCOMPARE(model.rowCount(), 2);
        QVERIFY(child({}, 1).data().toString().contains("whole recording"));
        const QModelIndex features = child(child({}, 0), 0);
        QCOMPARE(model.rowCount(features), 2);
        QCOMPARE(child(features, 0).data().toString(), QString("force_n (N)"));
    }

    void saysWhatAColumnMeansAndChoosesItByItsName() {
        m_tree->setSources({{"arm", {}, {{"joints", {{"q1", "rad"}, {"q2", "rad"}}, {"shoulder roll"}}}}});
        m_tree->view().expandAll();
        const QModelIndex joints = child(child({}, 0), 0);
        QCOMPARE(child(joints, 0).data().toString(), QString("q1, shoulder roll (rad)"));
        QCOMPARE(child(joints, 1).data().toString(), QString("q2 (rad)"));
        QTest::keyClicks(&m_tree->search(), "shoulder");
        m_tree->view().setCurrentIndex(child(child(child({}, 0), 0), 0));
        QCOMPARE(m_tree->selected(), (std::vector<SignalId>{{"arm", "joints", "q1"}}));
    }

    void enterAndDoubleClickChoose() {
        QTreeView& view = m_tree->view();
        view.expandAll();
        QSignalSpy chosen(m_tree.get(), &SignalTree::chosen);
        view.setFocus();
        view.setCurrentIndex(child({}, 0));
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(&view, Qt::Key_Down);
        QTest::keyClick(&view, Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(m_tree->selected().front(), (SignalId{"skin", "features", "cop_x_m"}));
        const QModelIndex force = child(child(child({}, 0), 0), 0);
        const QPoint place = view.visualRect(force).center();
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, place);
        QTest::mouseDClick(view.viewport(), Qt::LeftButton, {}, place);
        QCOMPARE(chosen.count(), 2);
        const auto ids = chosen.last().front().value<std::vector<SignalId>>();
        QCOMPARE(ids.front().column, std::string("force_n"));
    }

    void enterOnAStreamOpensIt() {
        QTreeView& view = m_tree->view();
        QSignalSpy chosen(m_tree.get(), &SignalTree::chosen);
        const QModelIndex frames = child(child({}, 0), 1);
        view.setCurrentIndex(frames);
        QVERIFY(!view.isExpanded(frames));
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(view.isExpanded(frames));
        QCOMPARE(chosen.count(), 0);
    }

    void theSearchFindsSignalsAndOpensTheirStreams() {
        QTest::keyClicks(&m_tree->search(), "Q1");
        QCOMPARE(m_tree->view().model()->rowCount(), 1);
        const QModelIndex joints = child(child({}, 0), 0);
        QCOMPARE(m_tree->view().model()->rowCount(joints), 1);
        QVERIFY(m_tree->view().isExpanded(joints));
        QTest::keyClick(&m_tree->search(), Qt::Key_Down);
        QVERIFY(m_tree->view().hasFocus());
        m_tree->search().clear();
        QTest::keyClicks(&m_tree->search(), "skin");
        QCOMPARE(m_tree->view().model()->rowCount(child({}, 0)), 2);
    }

    void whatIsOpenStaysOpenWhenASourceComes() {
        const QModelIndex features = child(child({}, 0), 0);
        m_tree->view().setExpanded(features, true);
        m_entries.push_back({"arm", {}, {{"joints", {{"q1", "rad"}}}}});
        m_tree->setSources(m_entries);
        QCOMPARE(m_tree->view().model()->rowCount(), 3);
        QVERIFY(m_tree->view().isExpanded(child(child({}, 0), 0)));
        m_entries.erase(m_entries.begin());
        m_tree->setSources(m_entries);
        QCOMPARE(m_tree->view().model()->rowCount(), 2);
    }

    void signalsAreDraggedAndDroppedButNotFiles() {
        const QModelIndex force = child(child(child({}, 0), 0), 0);
        QVERIFY(force.flags() & Qt::ItemIsDragEnabled);
        QVERIFY(!(child({}, 0).flags() & Qt::ItemIsDragEnabled));
        const std::unique_ptr<QMimeData> mime(m_tree->view().model()->mimeData({force}));
        SignalDropArea area;
        QSignalSpy dropped(&area, &SignalDropArea::dropped);
        area.resize(100, 100);
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, mime.get(), Qt::LeftButton, {});
        QApplication::sendEvent(&area, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(10, 10), Qt::CopyAction, mime.get(), Qt::LeftButton, {});
        QApplication::sendEvent(&area, &drop);
        QCOMPARE(dropped.count(), 1);
        const auto ids = dropped.first().front().value<std::vector<SignalId>>();
        QCOMPARE(ids.size(), std::size_t{1});
        QCOMPARE(ids.front(), (SignalId{"skin", "features", "force_n"}));
        QMimeData files;
        files.setUrls({QUrl::fromLocalFile("/tmp/run.teleta")});
        QDragEnterEvent other(QPoint(10, 10), Qt::CopyAction, &files, Qt::LeftButton, {});
        other.ignore();
        QApplication::sendEvent(&area, &other);
        QVERIFY2(!other.isAccepted(), "the window opens them");
    }

    void theTableShowsDifferencesAndObeysKeys() {
        SignalTable table;
        table.setRows({{"force_n, skin", {}, "N", 1, false, false},
                       {"q1, arm", "is being read", "rad", 2, true, false}});
        table.setReadings({{1.5, std::nullopt}, {}}, std::nullopt);
        table.show();
        QVERIFY(QTest::qWaitForWindowActive(&table));
        QVERIFY(table.view().isColumnHidden(3));
        table.setReadings({{1.5, 4.0}, {}}, 0.5);
        QVERIFY(!table.view().isColumnHidden(3));
        QCOMPARE(table.view().topLevelItem(0)->text(3), QString("2.5"));
        QVERIFY(table.view().topLevelItem(1)->text(0).contains("is being read"));
        QVERIFY2(table.times().contains("2.00"), qPrintable(table.times()));
        QSignalSpy removed(&table, &SignalTable::removeRequested);
        QSignalSpy slope(&table, &SignalTable::derivativeRequested);
        QSignalSpy spectrum(&table, &SignalTable::spectrumRequested);
        table.view().setFocus();
        table.view().setCurrentItem(table.view().topLevelItem(0));
        QTest::keyClick(&table.view(), Qt::Key_D);
        QTest::keyClick(&table.view(), Qt::Key_S);
        QTest::keyClick(&table.view(), Qt::Key_Delete);
        QCOMPARE(slope.count(), 1);
        QCOMPARE(spectrum.count(), 1);
        QCOMPARE(spectrum.first().at(1).toBool(), true);
        QCOMPARE(removed.count(), 1);
        table.view().setCurrentItem(table.view().topLevelItem(1));
        QVERIFY2(!table.rowActions().first()->isEnabled(), "a derivative has none");
    }
};

static const test::Registration<SignalTreeTest> kSignalTreeTest;
#include "signal_tree_test.moc"
