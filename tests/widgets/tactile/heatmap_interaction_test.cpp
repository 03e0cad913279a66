// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/input_events.h"
#include "tests/widgets/sample_touch.h"
#include "tests/widgets/test_registry.h"
#include "widgets/tactile/heatmap_view.h"

#include <QClipboard>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include <limits>
#include <memory>
#include <optional>

using namespace teleta;
using namespace teleta::tactile;
using teleta::test::hover;
using teleta::test::turnWheel;

namespace {

constexpr core::ArrayLayout kArray{6, 14, 0.0034};

pipeline::TouchSnapshot touched() {
    std::vector<float> load_N(kArray.taxels(), 0.0F);
    load_N[static_cast<std::size_t>(3 * kArray.columns + 7)] = 1.25F;
    return test::snapshotOf(kArray, load_N);
}

} // namespace

class HeatmapInteractionTest : public QObject {
    Q_OBJECT

    std::unique_ptr<HeatmapView> m_view;

    [[nodiscard]] QPoint centreOf(int row, int column) const {
        return m_view->layoutNow().taxelRect({row, column}).center().toPoint();
    }

    /// What is painted, with plain spaces.
    [[nodiscard]] QString header() const {
        m_view->grab();
        QString text = m_view->headerText();
        return text.remove(QChar(0x2007)).replace(QChar(0xA0), QLatin1Char(' '));
    }
    [[nodiscard]] QString headerStart() const { return header().section(QLatin1Char(' '), 0, 0); }

private slots:
    void init() {
        m_view = std::make_unique<HeatmapView>();
        m_view->resize(760, 460);
        m_view->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
        m_view->setSnapshot(touched());
    }
    void cleanup() { m_view.reset(); }

    void hoveringReadsTheTaxel() {
        hover(m_view.get(), centreOf(3, 7));
        QCOMPARE(m_view->cursorTaxel(), std::optional(Taxel{3, 7}));
        const QString text = m_view->readout();
        QVERIFY2(text.contains(QStringLiteral("row 3, column 7")), qPrintable(text));
        QVERIFY(text.contains(QStringLiteral("1.25\u00a0N")));
        QVERIFY(text.contains(QStringLiteral("contact #1")));
        QVERIFY(text.contains(QStringLiteral("1.70 mm"))); // (7 - 6.5) 3.4 mm and (3 - 2.5) 3.4 mm
        QCOMPARE(m_view->accessibleDescription(), text);
    }

    void hoveringBesideTheArrayReadsNothing() {
        hover(m_view.get(), centreOf(3, 7));
        QTest::mouseMove(m_view.get(), QPoint(3, 3));
        QVERIFY(!m_view->cursorTaxel());
        QVERIFY(m_view->readout().isEmpty());
    }

    void theReadoutFollowsTheData() {
        hover(m_view.get(), centreOf(3, 7));
        pipeline::TouchSnapshot next = touched();
        next.load_N[static_cast<std::size_t>(3 * kArray.columns + 7)] = 0.75F;
        m_view->setSnapshot(next);
        QVERIFY(m_view->readout().contains(QStringLiteral("0.75")));
    }

    void loadsByACalibrationHaveTheirErrors() {
        m_view->resize(1600, 500);
        QCOMPARE(headerStart(), QStringLiteral("force"));
        const auto read = [&](double force_N, double moment_Nm, double error_N, double error_Nm) {
            pipeline::LoadReading reading{1, {"force_n", "moment_nm"}, {}};
            reading.at.loads = Eigen::Vector2d(force_N, moment_Nm);
            reading.at.errors = Eigen::Vector2d(error_N, error_Nm);
            m_view->setLoads(reading);
            return header().section(QStringLiteral(", "), 0, 1);
        };
        QCOMPARE(read(1.25, -0.003, 0.05, 0.0002),
                 QStringLiteral("load 1.250 \u00b1 0.050 N, moment \u22123.00 \u00b1 0.20 mNm"));
        QCOMPARE(read(0.0123, -2.5, 0.0012, 0.13),
                 QStringLiteral("load 0.0123 \u00b1 0.0012 N, moment \u22122.50 \u00b1 0.13 Nm"));
        constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(read(kNaN, kNaN, 0.1, 0.1), QStringLiteral("load \u2014 N, moment \u2014 mNm"));
        m_view->setLoads(std::nullopt);
        QCOMPARE(headerStart(), QStringLiteral("force"));
    }

    void aLoadIsNeverShownWithoutItsMark() {
        pipeline::LoadReading reading{1, {"force_n", "moment_nm"}, {}};
        reading.at.loads = Eigen::Vector2d(8.0, 0.1);
        reading.at.errors = Eigen::Vector2d(0.05, 0.01);
        reading.at.extrapolated = true;
        m_view->setLoads(reading);
        bool wasShown = false, wasHidden = false, wasShort = false;
        for (int width = m_view->minimumWidth(); width < 1600; width += 7) {
            m_view->resize(width, 500);
            const QString text = header();
            const bool hasLoad = text.contains(QStringLiteral("load "));
            QCOMPARE(text.contains(QStringLiteral("extrapolated")), hasLoad || text.contains("moment"));
            wasShown = wasShown || text.contains(QStringLiteral("moment"));
            wasShort = wasShort || (hasLoad && !text.contains(QStringLiteral("moment")));
            wasHidden = wasHidden || !hasLoad;
        }
        QVERIFY(wasShown && wasShort && wasHidden);
    }

    void arrowKeysMoveTheReadoutAndStopAtTheBorder() {
        QTest::keyClick(m_view.get(), Qt::Key_Right);
        QCOMPARE(m_view->cursorTaxel(), std::optional(Taxel{3, 7})); // starts in the middle
        QTest::keyClick(m_view.get(), Qt::Key_Right);
        QTest::keyClick(m_view.get(), Qt::Key_Up);
        QCOMPARE(m_view->cursorTaxel(), std::optional(Taxel{4, 8}));
        QTest::keyClick(m_view.get(), Qt::Key_Down);
        QTest::keyClick(m_view.get(), Qt::Key_Left);
        QCOMPARE(m_view->cursorTaxel(), std::optional(Taxel{3, 7}));
        for (int i = 0; i < 30; ++i) {
            QTest::keyClick(m_view.get(), Qt::Key_Left);
            QTest::keyClick(m_view.get(), Qt::Key_Down);
        }
        QCOMPARE(m_view->cursorTaxel(), std::optional(Taxel{0, 0}));
    }

    void theKeyboardReadoutStaysWhenTheMouseLeaves() {
        QTest::keyClick(m_view.get(), Qt::Key_Right);
        hover(m_view.get(), centreOf(0, 0));
        QTest::mouseMove(m_view.get(), QPoint(3, 3));
        QCOMPARE(m_view->cursorTaxel(), std::optional(Taxel{3, 7}));
    }

    void ctrlWheelZoomsAroundTheMouse() {
        const QPointF point = m_view->layoutNow().taxelRect({4, 10}).center();
        const QPointF before = m_view->layoutNow().gridAt(point);
        QVERIFY(turnWheel(m_view.get(), point, 4, Qt::ControlModifier));
        QVERIFY(m_view->zoomFactor() > 2.0);
        const QPointF after = m_view->layoutNow().gridAt(point);
        QVERIFY2((after - before).manhattanLength() < 0.05,
                 qPrintable(QString::number((after - before).manhattanLength())));
        QVERIFY(turnWheel(m_view.get(), point, -10, Qt::ControlModifier));
        QCOMPARE(m_view->zoomFactor(), 1.0);
    }

    void aPlainWheelIsLeftToTheWindow() {
        QVERIFY(!turnWheel(m_view.get(), centreOf(3, 7), 1));
        QCOMPARE(m_view->zoomFactor(), 1.0);
    }

    void draggingMovesAZoomedPictureAndStopsAtItsEnd() {
        turnWheel(m_view.get(), centreOf(3, 7), 6, Qt::ControlModifier);
        const QPoint start = m_view->layoutNow().visible().center().toPoint();
        const QPointF grabbed = m_view->layoutNow().gridAt(start);
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, start);
        QTest::mouseMove(m_view.get(), start + QPoint(40, 10));
        QMouseEvent move(QEvent::MouseMove, start + QPoint(40, 10),
                         m_view->mapToGlobal(start + QPoint(40, 10)), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(m_view.get(), &move);
        const QPointF under = m_view->layoutNow().gridAt(start + QPoint(40, 10));
        QVERIFY((under - grabbed).manhattanLength() < 0.1);
        QMouseEvent far(QEvent::MouseMove, start + QPoint(9000, 0),
                        m_view->mapToGlobal(start + QPoint(9000, 0)), Qt::NoButton, Qt::LeftButton,
                        Qt::NoModifier);
        QApplication::sendEvent(m_view.get(), &far);
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, start);
        QVERIFY(std::abs(m_view->layoutNow().sensor().left() - m_view->layoutNow().visible().left()) < 1.0);
    }

    void doubleClickShowsTheWholeArray() {
        turnWheel(m_view.get(), centreOf(3, 7), 6, Qt::ControlModifier);
        QTest::mouseDClick(m_view.get(), Qt::LeftButton, {},
                           m_view->layoutNow().visible().center().toPoint());
        QCOMPARE(m_view->zoomFactor(), 1.0);
    }

    void theKeyboardZoomsToo() {
        QTest::keyClick(m_view.get(), Qt::Key_Plus);
        QCOMPARE(m_view->zoomFactor(), 1.25);
        QTest::keyClick(m_view.get(), Qt::Key_Minus);
        QCOMPARE(m_view->zoomFactor(), 1.0);
        QTest::keyClick(m_view.get(), Qt::Key_Plus);
        QTest::keyClick(m_view.get(), Qt::Key_0);
        QCOMPARE(m_view->zoomFactor(), 1.0);
    }

    void anotherArrayIsShownWhole() {
        turnWheel(m_view.get(), centreOf(3, 7), 6, Qt::ControlModifier);
        QTest::keyClick(m_view.get(), Qt::Key_Right);
        m_view->setSnapshot(test::snapshotOf({3, 3, 0.001}, std::vector<float>(9, 0.0F)));
        QCOMPARE(m_view->zoomFactor(), 1.0);
        QVERIFY(!m_view->cursorTaxel());
    }

    void theUpperEndIsTypedOnTheBar() {
        const auto type = [this](const QString& text) {
            QTest::mouseDClick(m_view.get(), Qt::LeftButton, {},
                               m_view->layoutNow().colourBar().center().toPoint());
            auto* edit = m_view->findChild<QLineEdit*>();
            QVERIFY(edit);
            edit->selectAll();
            if (text.isEmpty())
                QTest::keyClick(edit, Qt::Key_Delete);
            else
                QTest::keyClicks(edit, text);
            QTest::keyClick(edit, Qt::Key_Return);
            QTRY_VERIFY(!m_view->findChild<QLineEdit*>());
        };
        type(QStringLiteral("4.5"));
        QCOMPARE(m_view->fixedRange(), std::optional(4.5));
        QCOMPARE(m_view->rangeTop(), 4.5);
        type(QString());
        QVERIFY(!m_view->fixedRange());
        QCOMPARE(m_view->rangeTop(), 1.25);
    }

    void escapeTakesBackWhatWasTyped() {
        QTest::mouseDClick(m_view.get(), Qt::LeftButton, {},
                           m_view->layoutNow().colourBar().center().toPoint());
        auto* edit = m_view->findChild<QLineEdit*>();
        QVERIFY(edit);
        QTest::keyClicks(edit, QStringLiteral("9"));
        QTest::keyClick(edit, Qt::Key_Escape);
        QTRY_VERIFY(!m_view->findChild<QLineEdit*>());
        QVERIFY(!m_view->fixedRange());
    }

    void textThatIsNoNumberChangesNothing() {
        m_view->setFixedRange(3.0);
        QTest::mouseDClick(m_view.get(), Qt::LeftButton, {},
                           m_view->layoutNow().colourBar().center().toPoint());
        auto* edit = m_view->findChild<QLineEdit*>();
        QVERIFY(edit);
        QTest::keyClicks(edit, QStringLiteral("much"));
        QTest::keyClick(edit, Qt::Key_Return);
        QCOMPARE(m_view->fixedRange(), std::optional(3.0));
    }

    void aRangeThatMakesNoSenseIsIgnored() {
        for (const double top : {0.0, -1.0, qInf(), qQNaN()})
            m_view->setFixedRange(top);
        QVERIFY(!m_view->fixedRange());
    }

    void theAutomaticRangeDoesNotFollowSmallChanges() {
        const double top = m_view->rangeTop();
        pipeline::TouchSnapshot next = touched();
        for (int i = 1; i <= 60; ++i) {
            next.time_ns = i * 33'000'000LL;
            next.features.peak_N = 1.15 + 0.1 * (i % 2);
            m_view->setSnapshot(next);
            QCOMPARE(m_view->rangeTop(), top);
        }
    }

    void everyOverlayCanBeSwitchedFromTheMenu() {
        QMenu menu;
        m_view->populateMenu(menu);
        for (const auto overlay : {HeatmapView::Overlay::contacts, HeatmapView::Overlay::values}) {
            QAction* action = m_view->overlayAction(overlay);
            QVERIFY(menu.actions().contains(action));
            QVERIFY(!action->text().isEmpty() && !action->toolTip().isEmpty());
            const QImage before = m_view->grab().toImage();
            action->trigger();
            QVERIFY(m_view->grab().toImage() != before);
        }
    }

    void theMenuFixesAndFreesTheRange() {
        QMenu menu;
        m_view->populateMenu(menu);
        QMenu* range = nullptr;
        for (QAction* action : menu.actions())
            if (action->menu())
                range = action->menu();
        QVERIFY(range);
        range->actions().at(1)->trigger();
        QCOMPARE(m_view->fixedRange(), std::optional(1.25));
        range->actions().at(0)->trigger();
        QVERIFY(!m_view->fixedRange());
    }

    void ctrlCCopiesThePicture() {
        QGuiApplication::clipboard()->clear();
        QTest::keySequence(m_view.get(), QKeySequence::Copy);
        QVERIFY(QGuiApplication::clipboard()->mimeData()->hasImage());
    }

    void theDataAreOneRowATaxel() {
        const QString csv = m_view->figure().csv();
        const QStringList lines = csv.split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), qsizetype(1 + 6 * 14));
        QCOMPARE(lines.first(), QStringLiteral("row,column,x_m,y_m,load_n,dead,contact_id"));
        QCOMPARE(lines.at(1 + 3 * 14 + 7), QStringLiteral("3,7,0.0017,0.0017,1.25,0,1"));
        QCOMPARE(lines.at(1), QStringLiteral("0,0,-0.0221,-0.0085,0,0,0"));
    }

    void aFigureKeepsTheFrameOfWhichItWasMade() {
        const base::Figure figure = m_view->figure();
        m_view->setSnapshot(test::snapshotOf(kArray, std::vector<float>(kArray.taxels(), 0.0F)));
        QVERIFY(figure.csv().contains(QStringLiteral("1.25")));
    }

    void anInconsistentSnapshotIsNotShown() {
        pipeline::TouchSnapshot broken = touched();
        broken.load_N.pop_back();
        m_view->setSnapshot(broken);
        hover(m_view.get(), centreOf(3, 7));
        QVERIFY(m_view->readout().isEmpty());
        QCOMPARE(m_view->figure().csv().count(u'\n'), qsizetype(1));
    }

    void withoutDataTheViewSaysWhatToDo() {
        (void)m_view->grab();
        QVERIFY(m_view->headerText().contains(QStringLiteral("force")));
        m_view->clear();
        const QImage silent = m_view->grab().toImage();
        QCOMPARE(m_view->headerText(), QString());
        m_view->setEmptyText(QStringLiteral("No source. Open a demo scene."));
        QVERIFY(m_view->grab().toImage() != silent);
    }

    void itCanBeUsedWithoutSeeing() {
        QVERIFY(!m_view->accessibleName().isEmpty());
        QVERIFY(!m_view->whatsThis().isEmpty());
        QCOMPARE(m_view->focusPolicy(), Qt::StrongFocus);
    }

    void escapeIsLeftToStop() {
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QApplication::sendEvent(m_view.get(), &escape);
        QVERIFY(!escape.isAccepted());
    }
};

static const teleta::test::Registration<HeatmapInteractionTest> registration;

#include "heatmap_interaction_test.moc"
