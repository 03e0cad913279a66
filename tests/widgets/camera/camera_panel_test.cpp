// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/camera/sample_camera.h"
#include "tests/widgets/parts.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"
#include "widgets/camera/camera_panel.h"
#include "widgets/camera/camera_view.h"
#include "widgets/camera/event_model.h"
#include "widgets/camera/event_table.h"
#include "widgets/camera/finder_names.h"
#include "widgets/camera/stage_bar.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QPushButton>
#include <QSet>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>

using namespace teleta;
using camera::CameraPanel;
using camera::CameraView;
using camera::EventModel;
using camera::EventTable;
using pipeline::CameraEvent;
using pipeline::CarrierReport;

/// The dock of the camera in the soft tube, and the list of its events.
class CameraPanelTest : public QObject {
    Q_OBJECT

    static QPointF inView(const CameraView& view, double u_px, double v_px) {
        return view.picture().toPicture({u_px, v_px}, QSizeF(view.size()));
    }

private slots:
    void withoutACameraThePanelIsDisabledAndDrawn() {
        CameraPanel panel;
        panel.resize(600, 500);
        QVERIFY(!panel.isEnabled());
        QVERIFY(!panel.grab().isNull());
        panel.resize(30, 30);
        QVERIFY(!panel.grab().isNull());
    }

    void contactsAreDrawnWhereTheyAreInTheColourOfTheirNumber() {
        CameraView view;
        view.resize(820, 616);
        pipeline::CameraSnapshot snapshot = test::sampleCamera();
        view.setSnapshot(&snapshot);
        const QImage with = view.grab().toImage();
        snapshot.contacts.clear();
        view.setSnapshot(&snapshot);
        const QImage without = view.grab().toImage();
        const QPoint rim = inView(view, 410.0 + 60.0, 308.0).toPoint();
        QVERIFY(with.pixelColor(rim) != without.pixelColor(rim));
        QCOMPARE(without.pixelColor(rim), QColor(90, 90, 90));
        QCOMPARE(with.pixelColor(inView(view, 200.0, 500.0).toPoint()), QColor(90, 90, 90));
    }

    void theNumberOfAContactStandsOnALabelInItsColour() {
        CameraView view;
        view.resize(820, 616);
        const pipeline::CameraSnapshot snapshot = test::sampleCamera();
        view.setSnapshot(&snapshot);
        const QImage picture = view.grab().toImage();
        const double dpr = picture.devicePixelRatio();
        const QSizeF label = base::badgeSize(view.font(), QStringLiteral("3"));
        const QPointF corner = inView(view, 410.0 + 60.0, 308.0 - 60.0);
        const QRectF around(corner - QPointF(0.0, label.height()), 3.0 * label);
        const QRect pixels = QRectF(dpr * around.topLeft(), dpr * around.size()).toAlignedRect();
        int coloured = 0;
        for (int y = pixels.top(); y < pixels.bottom(); ++y)
            for (int x = pixels.left(); x < pixels.right(); ++x)
                coloured += picture.pixelColor(x, y) == base::identityColour(3, true) ? 1 : 0;
        QVERIFY(coloured > 0.5 * dpr * dpr * label.width() * label.height());
    }

    void everyFinderIsExplained() {
        CameraPanel panel;
        const auto* rungs = panel.findChild<QComboBox*>("cameraRung");
        QSet<QString> told;
        for (int i = 0; i < rungs->count(); ++i) {
            const QString text = rungs->itemData(i, Qt::ToolTipRole).toString();
            QVERIFY2(!text.isEmpty() && !told.contains(text), qPrintable(rungs->itemText(i)));
            told.insert(text);
            // The list says it in plain words, and each finder in others; the code stands behind.
            for (const int role :
                 {int(Qt::DisplayRole), camera::FinderDelegate::kCost, camera::FinderDelegate::kCode}) {
                const QString words = rungs->itemData(i, role).toString();
                QVERIFY2(!words.isEmpty(), qPrintable(text));
                QVERIFY(role == camera::FinderDelegate::kCost || !told.contains(words));
                told.insert(words);
            }
            QVERIFY(rungs->whatsThis().contains(rungs->itemText(i)));
            QVERIFY(rungs->view()->minimumWidth() >=
                    rungs->view()->sizeHintForIndex(rungs->model()->index(i, 0)).width());
        }
        QCOMPARE(rungs->itemText(rungs->findData("fast-2-changed")),
                 QStringLiteral("Quick flow, changed parts"));
        QVERIFY(rungs->itemData(rungs->findData("fast-2-changed"), camera::FinderDelegate::kCost)
                    .toString()
                    .contains("25 % of the picture's points"));
    }

    void displacementsAreDrawnEnlargedAndCanBeHidden() {
        CameraPanel panel;
        panel.resize(900, 800);
        const pipeline::CameraSnapshot snapshot = test::sampleCamera();
        panel.setSnapshot(&snapshot);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        CameraView& view = panel.view();
        const double tip_px = 100.0 + 0.9 * view.picture().enlargement * 8.0;
        const QPoint tip = inView(view, tip_px, 100.0).toPoint();
        QVERIFY(view.grab().toImage().pixelColor(tip) != QColor(90, 90, 90));
        QTest::mouseClick(panel.findChild<QCheckBox*>("cameraArrows"), Qt::LeftButton, {}, QPoint(8, 8));
        QVERIFY(!view.picture().arrows);
        QCOMPARE(view.grab().toImage().pixelColor(tip), QColor(90, 90, 90));
    }

    void theWheelZoomsAroundTheMouseAndADoubleClickShowsAll() {
        CameraView view;
        view.resize(820, 616);
        const pipeline::CameraSnapshot snapshot = test::sampleCamera();
        view.setSnapshot(&snapshot);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const QPointF at(500.0, 200.0);
        const QPointF pixel = view.picture().toPixel(at, QSizeF(view.size()));
        QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::ControlModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view, &wheel);
        QVERIFY(view.picture().zoom > 1.5);
        const QPointF after = view.picture().toPixel(at, QSizeF(view.size()));
        QVERIFY(std::abs(after.x() - pixel.x()) < 1e-6 && std::abs(after.y() - pixel.y()) < 1e-6);
        QTest::mouseDClick(&view, Qt::LeftButton);
        QCOMPARE(view.picture().zoom, 1.0);
        QTest::keyClick(&view, Qt::Key_Plus);
        QVERIFY(view.picture().zoom > 1.0);
        QTest::keyClick(&view, Qt::Key_Home);
        QCOMPARE(view.picture().zoom, 1.0);
    }

    void pausedThePictureStaysAndSpaceLetsItGoOn() {
        CameraPanel panel;
        pipeline::CameraSnapshot snapshot = test::sampleCamera();
        panel.setSnapshot(&snapshot);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QTest::mouseClick(panel.findChild<QToolButton*>("cameraPause"), Qt::LeftButton);
        QVERIFY(panel.isPaused());
        snapshot.frame = 41;
        panel.setSnapshot(&snapshot);
        QCOMPARE(panel.view().picture().shown.frame, std::uint64_t(40));
        QTest::keyClick(&panel.view(), Qt::Key_Space);
        QVERIFY(!panel.isPaused());
        panel.setSnapshot(&snapshot);
        QCOMPARE(panel.view().picture().shown.frame, std::uint64_t(41));
    }

    void aRungIsAskedForAndShowsOnceItIsInUse() {
        CameraPanel panel;
        pipeline::CameraSnapshot snapshot = test::sampleCamera();
        panel.setSnapshot(&snapshot);
        auto* rungs = panel.findChild<QComboBox*>("cameraRung");
        QCOMPARE(rungs->count(), 13);
        QCOMPARE(rungs->currentData().toString(), QStringLiteral("dots"));
        QSignalSpy chosen(&panel, &CameraPanel::rungChosen);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        rungs->setFocus();
        QTest::keyClick(rungs, Qt::Key_Down);
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen[0][0].toString(), QStringLiteral("paper"));
        panel.setSnapshot(&snapshot);
        QCOMPARE(rungs->currentData().toString(), QStringLiteral("paper")); // asked for, not yet in use
        snapshot.problem = "Too dark.";
        panel.setSnapshot(&snapshot);
        QCOMPARE(rungs->currentData().toString(),
                 QStringLiteral("paper")); // a frame's problem is not the finder's
        QCOMPARE(test::textOf(panel, "problem"), QStringLiteral("Picture not used: Too dark."));
        snapshot.problem.clear();
        snapshot.nextRung = "paper";
        panel.setSnapshot(&snapshot);
        QCOMPARE(test::textOf(panel, "problem"), QStringLiteral("Preparing the finder: As published."));
        snapshot.nextRung = {};
        snapshot.refusedRung = "paper";
        snapshot.whyRefused = "It cannot.";
        panel.setSnapshot(&snapshot);
        QCOMPARE(rungs->currentData().toString(), QStringLiteral("dots"));
        QCOMPARE(test::textOf(panel, "problem"), QStringLiteral("This finder cannot be used: It cannot."));
    }

    /// In a dock of a window of 1024 x 700 it is wrapped; in a very low one the pointer shows the rest.
    void whyAFinderCannotBeUsedIsReadToItsEnd() {
        CameraPanel panel;
        pipeline::CameraSnapshot snapshot = test::sampleCamera();
        snapshot.refusedRung = "paper";
        snapshot.whyRefused = "The reference picture has 42 of 400 dots (expected at least 200): take a new "
                              "reference while nothing touches the tube, with the light as it is now";
        panel.resize(507, 580);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.setSnapshot(&snapshot);
        auto* problem = panel.findChild<QLabel*>("problem");
        const auto isWhole = [problem] {
            const QRect needed = problem->fontMetrics().boundingRect(
                QRect(0, 0, problem->contentsRect().width(), 10'000), Qt::TextWordWrap, problem->text());
            return needed.width() <= problem->contentsRect().width() &&
                   needed.height() <= problem->contentsRect().height();
        };
        QVERIFY(problem->text().endsWith(QLatin1String("as it is now")));
        QTRY_VERIFY(isWhole());
        QVERIFY(problem->height() > 2 * problem->fontMetrics().height() - 2); // more than a line
        QHelpEvent pointed(QEvent::ToolTip, QPoint(5, 5), problem->mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(problem, &pointed);
        QCOMPARE(QToolTip::text(), problem->text());
        QToolTip::hideText();
    }

    void theArmIsToldInWordsAndMayBeLetReactAgain() {
        CameraPanel panel;
        pipeline::CameraSnapshot snapshot = test::sampleCamera();
        panel.setSnapshot(&snapshot);
        auto* mayReact = panel.findChild<QCheckBox*>("cameraMayReact");
        QVERIFY(!mayReact->isVisibleTo(&panel)); // no arm
        snapshot.carrier = CarrierReport{.doing = CarrierReport::Doing::follows, .contact = 3};
        panel.setSnapshot(&snapshot);
        QVERIFY(mayReact->isVisibleTo(&panel));
        QCOMPARE(test::textOf(panel, "arm"), QStringLiteral("The arm follows contact 3."));
        snapshot.carrier->doing = CarrierReport::Doing::held;
        snapshot.mayReact = false;
        panel.setSnapshot(&snapshot);
        QVERIFY(!mayReact->isChecked());
        QVERIFY(test::textOf(panel, "arm").contains("let it react again"));
        QSignalSpy changed(&panel, &CameraPanel::mayReactChanged);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QTest::mouseClick(mayReact, Qt::LeftButton, {}, QPoint(8, mayReact->height() / 2));
        QCOMPARE(changed.size(), 1);
        QCOMPARE(changed[0][0].toBool(), true);
    }

    void aBumpIsPointedAtForASecondOfTheCamerasTime() {
        CameraView view;
        pipeline::CameraSnapshot snapshot = test::sampleCamera();
        snapshot.bump = vision::BumpDetector::Bump{.contact = 3};
        view.setSnapshot(&snapshot);
        QCOMPARE(view.picture().bumpFade, 1.0);
        snapshot.bump.reset();
        snapshot.time_s = 1.5;
        view.setSnapshot(&snapshot);
        QCOMPARE(view.picture().bumpFade, 0.5);
        snapshot.time_s = 2.1;
        view.setSnapshot(&snapshot);
        QCOMPARE(view.picture().bumpFade, 0.0);
    }

    void withoutAReferenceThePanelSaysWhatItWaitsFor() {
        CameraPanel panel;
        pipeline::CameraSnapshot snapshot = test::sampleCamera();
        snapshot.hasReference = false;
        panel.setSnapshot(&snapshot);
        QVERIFY(test::textOf(panel, "problem").contains("nothing touching it"));
        snapshot.usable = false;
        snapshot.problem = "The frame could not be decoded.";
        panel.setSnapshot(&snapshot);
        QVERIFY(test::textOf(panel, "problem").contains("could not be decoded"));
    }

    void stageTimesAreAveragedAndCountsAreInWords() {
        CameraPanel panel;
        pipeline::CameraSnapshot snapshot = test::sampleCamera();
        snapshot.passedOver = 1;
        panel.setSnapshot(&snapshot, 40.0);
        QCOMPARE(panel.stages().whole_ms(), 4.9);
        snapshot.whole_ns = 24'900'000;
        panel.setSnapshot(&snapshot, 40.0);
        QVERIFY(panel.stages().whole_ms() > 4.9 && panel.stages().whole_ms() < 7.0);
        QVERIFY(panel.stages().text().contains(QStringLiteral("1 skipped")));
        snapshot.rung = "paper";
        panel.setSnapshot(&snapshot, 40.0);
        QCOMPARE(panel.stages().whole_ms(), 24.9); // another rung begins anew
    }

    void aNarrowBarOfStagesSaysLessAndCutsNothing() {
        camera::StageBar bar;
        pipeline::CameraSnapshot snapshot = test::sampleCamera();
        snapshot.passedOver = 22;
        bar.setSnapshot(&snapshot, 40.0);
        bar.resize(bar.fontMetrics().height() * 40, 40);
        QCOMPARE(bar.shownText(), bar.text());
        QVERIFY(bar.text().contains("22 skipped"));
        bar.resize(bar.fontMetrics().horizontalAdvance(bar.text()) / 2, 40);
        QVERIFY(bar.shownText() != bar.text());
        QVERIFY(bar.text().startsWith(bar.shownText()));
        QVERIFY(bar.shownText().contains("ms"));
        bar.setSnapshot(nullptr, 0.0);
        QVERIFY(bar.shownText().isEmpty());
    }

    void thePictureIsExportedWithItsContactsAsData() {
        CameraView view;
        view.resize(400, 300);
        const pipeline::CameraSnapshot snapshot = test::sampleCamera();
        view.setSnapshot(&snapshot);
        const QStringList lines = view.figure().csv().trimmed().split('\n');
        QCOMPARE(lines.size(), 2);
        const QStringList cells = lines[1].split(',');
        const std::vector<double> expected{40.0, 1.0, 3.0, 410.0, 308.0, 0.0,   0.025,
                                           0.04, 0.0, 0.0, 0.01,  0.0,   0.0002};
        QCOMPARE(cells.size(), static_cast<qsizetype>(expected.size()));
        for (std::size_t i = 0; i < expected.size(); ++i)
            QVERIFY(std::abs(cells[static_cast<qsizetype>(i)].toDouble() - expected[i]) < 1e-12);
        QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
        QVERIFY(!QGuiApplication::clipboard()->image().isNull());
    }

    void eventsAreListedTheNewestFirstAndCopiedAsCsv() {
        EventTable table;
        table.append({.kind = CameraEvent::Kind::reference, .time_s = 0.0});
        table.append({.kind = CameraEvent::Kind::bumps,
                      .time_s = 0.475,
                      .contact = 2,
                      .located = true,
                      .p_Sensor_m = {0.025, 0.0, 0.04},
                      .depth_m = 0.002});
        EventModel& model = table.model();
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(0, EventModel::event).data().toString(), QStringLiteral("BUMP"));
        QCOMPARE(model.index(0, EventModel::contact).data().toInt(), 2);
        QCOMPARE(model.index(1, EventModel::contact).data().isValid(), false);
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        QTest::keyClick(&table.table(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text().trimmed(),
                 QStringLiteral("time_s,event,contact_id,x_m,y_m,z_m,depth_m\n"
                                "0,reference,NA,NA,NA,NA,NA\n"
                                "0.475,bump,2,0.025,0,0.04,0.002"));
        table.append({.kind = CameraEvent::Kind::begins, .time_s = 123.41, .contact = 3});
        table.append({.kind = CameraEvent::Kind::bumps, .time_s = 123.46, .contact = 3});
        QCOMPARE(model.index(1, EventModel::time).data().toString(), QStringLiteral("123.410"));
        QCOMPARE(model.index(0, EventModel::time).data().toString(), QStringLiteral("123.460"));
        // Neither a word nor a number is cut in a narrow dock, and titles stand over them.
        table.resize(24 * table.fontMetrics().height(), 300);
        QCoreApplication::processEvents();
        const auto isCut = [&table](int column) {
            const auto* view = static_cast<const QAbstractItemView*>(&table.table());
            return table.table().columnWidth(column) < view->sizeHintForColumn(column);
        };
        for (int column = 0; column < EventModel::kColumns; ++column) {
            QVERIFY(!isCut(column));
            QCOMPARE(model.headerData(column, Qt::Horizontal, Qt::TextAlignmentRole).toInt(),
                     model.index(0, column).data(Qt::TextAlignmentRole).toInt());
        }
        // Nor when longer ones come.
        table.append({.kind = CameraEvent::Kind::bumps, .time_s = 9'876'543.21, .contact = 1'234'567});
        QCoreApplication::processEvents();
        for (int column = 0; column < EventModel::kColumns; ++column)
            QVERIFY(!isCut(column));
        for (std::size_t i = 0; i < EventModel::kCapacity + 10; ++i)
            table.append({.time_s = static_cast<double>(i), .contact = 1});
        QCOMPARE(model.rowCount(), static_cast<int>(EventModel::kCapacity));
        table.clear();
        QCOMPARE(model.rowCount(), 0);
    }
};

static const test::Registration<CameraPanelTest> kRegistration;
#include "camera_panel_test.moc"
