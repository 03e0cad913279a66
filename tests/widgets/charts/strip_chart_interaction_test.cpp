// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/input_events.h"
#include "tests/widgets/sample_touch.h"
#include "tests/widgets/test_registry.h"
#include "widgets/charts/strip_chart_view.h"
#include "widgets/charts/strip_plot.h"

#include <QAction>
#include <QClipboard>
#include <QMainWindow>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

using namespace teleta;
using namespace teleta::charts;
using teleta::test::hover;
using teleta::test::turnWheel;

class StripChartInteractionTest : public QObject {
    Q_OBJECT

    std::unique_ptr<StripChartView> m_view;

    void feed(int from, int to) {
        std::vector<pipeline::FeatureSample> samples;
        for (int i = from; i < to; ++i)
            samples.push_back(test::rollingSample(0.005 * i, true));
        m_view->append(samples);
        draw();
    }
    void draw() {
        m_view->refresh();
        QCoreApplication::processEvents();
    }
    [[nodiscard]] QPoint pointAt(double time_s, Strip strip = Strip::force) const {
        return {qRound(m_view->plot()->xOf(time_s)), m_view->plot()->laneRect(strip).center().y()};
    }
    [[nodiscard]] QString valueOf(Strip strip, std::size_t line = 0) const {
        return m_view->plot()->lanePanel(strip)->lines().at(line).value.trimmed().remove(QChar(0x2007));
    }
    void dragBy(int pixels) {
        StripPlot* plot = m_view->plot();
        const QPoint start = pointAt(-5.0);
        QTest::mousePress(plot, Qt::LeftButton, {}, start);
        const QPoint end = start + QPoint(pixels, 0);
        QMouseEvent move(QEvent::MouseMove, end, plot->mapToGlobal(end), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(plot, &move);
        QTest::mouseRelease(plot, Qt::LeftButton, {}, end);
    }

private slots:
    void init() {
        m_view = std::make_unique<StripChartView>();
        m_view->resize(900, 600);
        m_view->setLoadUnit(QStringLiteral("N"));
        m_view->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
        feed(0, 4000); // 20 s
    }
    void cleanup() { m_view.reset(); }

    void withoutACursorTheNewestValuesAreShown() {
        const double force_N = test::rollingSample(0.005 * 3999, true).features.force_N;
        QVERIFY(std::abs(QLocale::c().toDouble(valueOf(Strip::force).section(QChar(0x00a0), 0, 0)) -
                         force_N) <= 0.01);
    }

    void theCursorReadsAllStripsAtItsTime() {
        hover(m_view->plot(), pointAt(-4.0));
        QVERIFY(m_view->cursorTime_s());
        const double cursor_s = *m_view->cursorTime_s();
        QVERIFY(std::abs(cursor_s + 4.0) < 0.02);
        const auto sample = test::rollingSample(0.005 * std::round((19.995 + cursor_s) / 0.005), true);
        const auto shown = [&](Strip strip) {
            return QLocale::c().toDouble(
                valueOf(strip).section(QChar(0x00a0), 0, 0).replace(QChar(0x2212), u'-'));
        };
        QVERIFY(std::abs(shown(Strip::force) - sample.features.force_N) <= 0.006);
        QVERIFY(std::abs(shown(Strip::positionX) - *sample.features.copX_m * 1e3) <= 0.006);
        QVERIFY(std::abs(shown(Strip::dzmp) - *sample.features.dzmpX_m * 1e3) <= 0.006);
        QVERIFY(m_view->plot()->headerText().contains(QString::number(sample.sourceTime_s, 'f', 3)));
    }

    void theCursorIsALineThroughAllStrips() {
        const QImage before = m_view->plot()->grab().toImage();
        hover(m_view->plot(), pointAt(-4.0));
        QCoreApplication::processEvents();
        QVERIFY(m_view->cursorTime_s());
        const QImage after = m_view->plot()->grab().toImage();
        const int x = qRound(m_view->plot()->xOf(*m_view->cursorTime_s()));
        const QRgb ink = m_view->palette().color(QPalette::Text).rgb();
        for (const Strip strip : m_view->shownStrips()) {
            const QRect rect = m_view->plot()->laneRect(strip);
            QCOMPARE(after.pixel(x, rect.top() + 3), ink);
            QVERIFY(before.pixel(x, rect.top() + 3) != ink);
        }
    }

    void leavingTheCurvesEndsTheCursor() {
        hover(m_view->plot(), pointAt(-4.0));
        QTest::mouseMove(m_view->plot(), QPoint(2, 2));
        QVERIFY(!m_view->cursorTime_s());
    }

    void inAGapTheCursorReadsNothing() {
        for (int i = 0; i < 200; ++i)
            m_view->append(test::rollingSample(25.0 + 0.005 * i, true));
        draw();
        m_view->setCursorTime(-3.0);
        QVERIFY(valueOf(Strip::force).contains(QChar(0x2014)));
        QVERIFY(m_view->plot()->headerText().contains(QStringLiteral("no sample")));
    }

    void pausingFreezesThePictureAndKeepsTheSamples() {
        QTest::keyClick(m_view.get(), Qt::Key_Space);
        QVERIFY(m_view->isPaused());
        QVERIFY(m_view->findChild<QAction*>("pause")->isChecked());
        draw();
        const double end_s = m_view->end_s();
        const auto points = *m_view->plot()->laneGraph(Strip::force, 0)->data()->constBegin();
        feed(4000, 5000);
        QCOMPARE(m_view->end_s(), end_s);
        QCOMPARE(m_view->plot()->laneGraph(Strip::force, 0)->data()->constBegin()->value, points.value);
        QCOMPARE(m_view->history().size(), std::size_t(5000));
        QVERIFY(m_view->plot()->headerText().contains(QStringLiteral("PAUSED")));
        QTest::keyClick(m_view.get(), Qt::Key_Space);
        QVERIFY(!m_view->isPaused());
        QVERIFY(std::abs(m_view->end_s() - 24.995) < 1e-6);
    }

    void refreshingWithoutNewsDrawsNothing() {
        QSignalSpy replots(m_view->plot(), &QCustomPlot::afterReplot);
        draw();
        QCOMPARE(replots.size(), qsizetype(0));
        m_view->append(test::rollingSample(20.1, true));
        QCOMPARE(replots.size(), qsizetype(0));
        draw();
        QCOMPARE(replots.size(), qsizetype(1));
        // Less than a pixel later: it is drawn when no other sample follows.
        m_view->append(test::rollingSample(20.105, true));
        draw();
        QCOMPARE(replots.size(), qsizetype(1));
        draw();
        QCOMPARE(replots.size(), qsizetype(2));
        m_view->setPaused(true);
        draw();
        replots.clear();
        m_view->append(test::rollingSample(20.11, true));
        draw();
        QCOMPARE(replots.size(), qsizetype(0));
    }

    void ctrlWheelChangesTheSpan() {
        QVERIFY(turnWheel(m_view->plot(), pointAt(-5.0), 1, Qt::ControlModifier));
        QCOMPARE(m_view->span_s(), 8.0);
        QVERIFY(turnWheel(m_view->plot(), pointAt(-5.0), -1, Qt::ControlModifier));
        QCOMPARE(m_view->span_s(), 10.0);
        QVERIFY(!m_view->isPaused());
        turnWheel(m_view->plot(), pointAt(-5.0), 100, Qt::ControlModifier);
        QCOMPARE(m_view->span_s(), StripChartView::kShortestSpan_s);
        turnWheel(m_view->plot(), pointAt(-0.1), -200, Qt::ControlModifier);
        QCOMPARE(m_view->span_s(), StripChartView::kLongestSpan_s);
    }

    void whilePausedTheWheelZoomsAroundTheMouse() {
        m_view->setPaused(true);
        m_view->scrollBy(-2.0);
        draw();
        const double under_s = m_view->end_s() - 5.0;
        turnWheel(m_view->plot(), pointAt(-5.0), 2, Qt::ControlModifier);
        draw();
        const double now_s = m_view->end_s() + m_view->plot()->timeAt(pointAt(-5.0 * 0.64).x());
        QVERIFY2(std::abs(now_s - under_s) < 0.05, qPrintable(QString::number(now_s - under_s)));
        QVERIFY(m_view->isPaused());
    }

    void shiftWheelScrollsAndComesBackToLive() {
        QVERIFY(turnWheel(m_view->plot(), pointAt(-5.0), 1, Qt::ShiftModifier));
        QVERIFY(m_view->isPaused());
        QVERIFY(std::abs(m_view->end_s() - 18.995) < 1e-6);
        turnWheel(m_view->plot(), pointAt(-5.0), -2, Qt::ShiftModifier);
        QVERIFY(!m_view->isPaused());
    }

    void aPlainWheelIsLeftToTheWindow() { QVERIFY(!turnWheel(m_view->plot(), pointAt(-5.0), 1)); }

    void draggingScrolls() {
        const double perPixel_s = m_view->span_s() / m_view->plot()->laneRect(Strip::force).width();
        dragBy(100);
        QVERIFY(m_view->isPaused());
        QVERIFY(std::abs(m_view->end_s() - (19.995 - 100 * perPixel_s)) < 2.0 * perPixel_s);
        dragBy(-300);
        QVERIFY(!m_view->isPaused());
    }

    void scrollingStopsAtTheOldestSample() {
        m_view->scrollBy(-1000.0);
        QVERIFY(std::abs(m_view->end_s() - m_view->span_s()) < 1e-6);
        QTest::keyClick(m_view.get(), Qt::Key_End);
        QVERIFY(!m_view->isPaused());
        QTest::keyClick(m_view.get(), Qt::Key_Home);
        QVERIFY(std::abs(m_view->end_s() - m_view->span_s()) < 1e-6);
    }

    void theSpanIsChosenWithOneClick() {
        for (QToolButton* button : m_view->findChildren<QToolButton*>())
            if (button->text() == QStringLiteral("30 s"))
                QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(m_view->span_s(), 30.0);
        m_view->setSpan(qQNaN());
        QCOMPARE(m_view->span_s(), 30.0);
    }

    void arrowKeysMoveTheCursorAndShiftScrolls() {
        QTest::keyClick(m_view.get(), Qt::Key_Left);
        QCOMPARE(m_view->cursorTime_s(), std::optional(-0.1));
        QTest::keyClick(m_view.get(), Qt::Key_Right);
        QTest::keyClick(m_view.get(), Qt::Key_Right);
        QCOMPARE(m_view->cursorTime_s(), std::optional(0.0));
        QTest::keyClick(m_view.get(), Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(std::abs(m_view->end_s() - 18.995) < 1e-6);
        QVERIFY(!m_view->accessibleDescription().isEmpty());
    }

    void plusAndMinusChangeTheSpan() {
        QTest::keyClick(m_view.get(), Qt::Key_Plus);
        QCOMPARE(m_view->span_s(), 8.0);
        QTest::keyClick(m_view.get(), Qt::Key_Minus);
        QCOMPARE(m_view->span_s(), 10.0);
    }

    void aMarkIsAskedForAtTheCursor() {
        QSignalSpy asked(m_view.get(), &StripChartView::markRequested);
        QTest::keyClick(m_view.get(), Qt::Key_M);
        QCOMPARE(asked.size(), qsizetype(1));
        QCOMPARE(asked.at(0).at(0).toLongLong(), 5'000'000LL * 3999);
        m_view->setCursorTime(-5.0);
        QTest::keyClick(m_view.get(), Qt::Key_M);
        QVERIFY(std::abs(asked.at(1).at(0).toLongLong() - 14'995'000'000LL) <= 3'000'000);
        QCOMPARE(m_view->marks(), std::size_t(0)); // the view owns no truth
    }

    void theKeyOfMarksIsTheChartsWhileItHasTheFocusAndTheWindowsElse() {
        QMainWindow window;
        auto* view = new StripChartView;
        auto* other = new QPushButton;
        auto* both = new QWidget;
        auto* layout = new QVBoxLayout(both);
        layout->addWidget(view);
        layout->addWidget(other);
        window.setCentralWidget(both);
        QAction markNow;
        markNow.setShortcut(Qt::Key_M);
        window.addAction(&markNow);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        for (int i = 0; i < 4000; ++i)
            view->append(test::rollingSample(0.005 * i, true));
        view->refresh();
        view->setCursorTime(-5.0);
        QSignalSpy now(&markNow, &QAction::triggered);
        QSignalSpy asked(view, &StripChartView::markRequested);
        view->setFocus();
        QTest::keyClick(view, Qt::Key_M);
        QCOMPARE(asked.size(), 1);
        QCOMPARE(now.size(), 0);
        other->setFocus();
        QTest::keyClick(other, Qt::Key_M);
        QCOMPARE(asked.size(), 1);
        QCOMPARE(now.size(), 1);
    }

    void aMarkWhereNothingWasKeptIsRefused() {
        QVERIFY(m_view->addMark(10.0, QStringLiteral("a")));
        QVERIFY(!m_view->addMark(500.0, QStringLiteral("b")));
        QCOMPARE(m_view->marks(), std::size_t(1));
    }

    void stripsAreChosenFromTheMenu() {
        QVERIFY(m_view->plot()->laneRect(Strip::active).isEmpty());
        m_view->stripAction(Strip::active)->trigger();
        m_view->stripAction(Strip::force)->trigger();
        draw();
        QVERIFY(!m_view->plot()->laneRect(Strip::active).isEmpty());
        QVERIFY(m_view->plot()->laneRect(Strip::force).isEmpty());
    }

    void theEndsOfAnAxisAreTyped() {
        const QPoint axis(m_view->plot()->laneRect(Strip::dzmp).left() - 10,
                          m_view->plot()->laneRect(Strip::dzmp).center().y());
        const auto type = [&](const QString& text) {
            test::typeAt(m_view.get(), m_view->plot(), axis, text);
        };
        type(QStringLiteral("-3 7"));
        const auto fixed = m_view->plot()->fixedLaneRange(Strip::dzmp);
        QVERIFY(fixed);
        QCOMPARE(fixed->low, -3.0);
        QCOMPARE(fixed->high, 7.0);
        draw();
        QVERIFY(std::abs(m_view->plot()->laneRange(Strip::dzmp).high - 7.0) < 1e-9);
        for (const QString& nonsense : {QStringLiteral("7 -3"), QStringLiteral("x y"), QStringLiteral("1")})
            type(nonsense);
        QCOMPARE(m_view->plot()->fixedLaneRange(Strip::dzmp)->low, -3.0);
        type(QString());
        QVERIFY(!m_view->plot()->fixedLaneRange(Strip::dzmp));
    }

    void theContextMenuHasWhatAUserExpects() {
        QMenu menu;
        m_view->populateMenu(menu,
                             m_view->plot()->mapToParent(m_view->plot()->laneRect(Strip::force).center()));
        QStringList texts;
        for (QAction* action : menu.actions())
            texts << action->text().remove(u'&');
        for (const char* wanted : {"Strips", "Span", "Pause", "Mark", "Automatic range", "Copy picture",
                                   "Copy data", "Save picture…", "Save data…"})
            QVERIFY2(texts.contains(QString::fromUtf8(wanted)), wanted);
    }

    void theDataAreThoseOfTheShownStretch() {
        m_view->setPaused(true);
        m_view->scrollBy(-5.0);
        m_view->setSpan(5.0);
        const QStringList lines = m_view->figure().csv().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(1 + 1001)); // 5 s at 200 Hz, both ends
        QVERIFY(std::abs(lines.at(1).section(u',', 0, 0).toDouble() - (m_view->end_s() - 5.0)) < 0.006);
        QVERIFY(std::abs(lines.last().section(u',', 0, 0).toDouble() - m_view->end_s()) < 0.006);
    }

    void ctrlCCopiesThePicture() {
        QGuiApplication::clipboard()->clear();
        QTest::keySequence(m_view.get(), QKeySequence::Copy);
        QVERIFY(QGuiApplication::clipboard()->mimeData()->hasImage());
    }

    void clearingGoesLiveAndForgets() {
        m_view->addMark(10.0, QStringLiteral("a"));
        m_view->setPaused(true);
        m_view->clear();
        draw();
        QVERIFY(!m_view->isPaused());
        QCOMPARE(m_view->marks(), std::size_t(0));
        QVERIFY(valueOf(Strip::force).contains(QChar(0x2014)));
        m_view->append(test::rollingSample(3.0, true));
        draw();
        QVERIFY(!valueOf(Strip::force).contains(QChar(0x2014)));
    }

    void theReadoutDoesNotFlickerLive() {
        const QString before = valueOf(Strip::positionY);
        pipeline::FeatureSample sample = test::rollingSample(19.995, true);
        for (int i = 1; i <= 20; ++i) {
            sample.sourceTime_s += 0.005;
            *sample.features.copY_m += (i % 2 == 0 ? 1.0 : -1.0) * 2e-6; // 2 um, shown in steps of 10 um
            m_view->append(sample);
            draw();
            QCOMPARE(valueOf(Strip::positionY), before);
        }
    }

    void escapeIsLeftToStop() {
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QApplication::sendEvent(m_view.get(), &escape);
        QVERIFY(!escape.isAccepted());
    }

    void itCanBeUsedWithoutSeeing() {
        QVERIFY(!m_view->accessibleName().isEmpty());
        QVERIFY(!m_view->whatsThis().isEmpty());
        QCOMPARE(m_view->focusPolicy(), Qt::StrongFocus);
        for (QToolButton* button : m_view->findChildren<QToolButton*>())
            QVERIFY(!button->toolTip().isEmpty());
    }
};

static const teleta::test::Registration<StripChartInteractionTest> registration;

#include "strip_chart_interaction_test.moc"
