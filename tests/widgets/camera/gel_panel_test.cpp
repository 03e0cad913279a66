// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/camera/sample_gel.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/theme.h"
#include "widgets/camera/gel/gel_event_table.h"
#include "widgets/camera/gel/gel_panel.h"
#include "widgets/camera/gel/gel_view.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

using namespace teleta;
using camera::GelEventModel;
using camera::GelEventTable;
using camera::GelPanel;
using camera::GelPicture;
using camera::GelView;
using pipeline::GelEvent;

/// The dock of a flat gel, and the list of its events.
class GelPanelTest : public QObject {
    Q_OBJECT

    static constexpr QColor kGround{90, 90, 90};

    static QPoint inView(const GelView& view, double u_px, double v_px) {
        return view.picture().toPicture({u_px, v_px}, QSizeF(view.size())).toPoint();
    }
    static int pixelsOf(const QImage& picture, const QColor& colour) {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                count += picture.pixelColor(x, y) == colour ? 1 : 0;
        return count;
    }

private slots:
    void withoutAGelThePanelIsDisabledAndDrawn() {
        GelPanel panel;
        panel.resize(600, 500);
        QVERIFY(!panel.isEnabled());
        QVERIFY(!panel.grab().isNull());
        panel.resize(30, 30);
        QVERIFY(!panel.grab().isNull());
        QVERIFY(panel.view().figure().csv().startsWith("frame,time_s,marker"));
    }

    void anArrowIsAsLongAsItsDisplacementEnlarged() {
        GelPanel panel;
        panel.resize(900, 800);
        const pipeline::GelSnapshot snapshot = test::sampleGel();
        panel.setSnapshot(&snapshot);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        GelView& view = panel.view();
        // The arrow of the middle marker, clear of the outline: 5 px, enlarged 4 times.
        const QPoint within = inView(view, 160.0 + 18.0, 120.0);
        const QPoint beyond = inView(view, 160.0 + 24.0, 120.0);
        QVERIFY(view.grab().toImage().pixelColor(within) != kGround);
        QCOMPARE(view.grab().toImage().pixelColor(beyond), kGround);
        // A marker at rest has none.
        QCOMPARE(view.grab().toImage().pixelColor(inView(view, 88.0, 40.0)), kGround);
        auto* enlargement = panel.findChild<QComboBox*>("gelEnlargement");
        enlargement->setCurrentIndex(enlargement->findData(1));
        QCOMPARE(view.grab().toImage().pixelColor(within), kGround);
        QVERIFY(view.grab().toImage().pixelColor(inView(view, 160.0 + 3.0, 120.0)) != kGround);
        QTest::mouseClick(panel.findChild<QCheckBox*>("gelArrows"), Qt::LeftButton, {}, QPoint(8, 8));
        QCOMPARE(view.grab().toImage().pixelColor(inView(view, 160.0 + 3.0, 120.0)), kGround);
    }

    void theLegendIsARoundLengthDrawnToTheScaleOfTheArrows() {
        GelPicture picture;
        QCOMPARE(picture.legend({640.0, 480.0}).length_px, 0.0);
        picture.shown = test::sampleGel();
        for (const double enlargement : {1.0, 4.0, 16.0}) {
            picture.enlargement = enlargement;
            const GelPicture::Legend legend = picture.legend({640.0, 480.0});
            // 2 pixels of the view for one of the picture, that is 0.1 mm.
            QVERIFY(std::abs(legend.length_px - legend.length_m / 1e-4 * 2.0 * enlargement) < 1e-9);
            QVERIFY(legend.length_px <= 120.0 && legend.length_px > 120.0 / 2.6);
        }
        picture.enlargement = 4.0;
        QVERIFY(std::abs(picture.legend({640.0, 480.0}).length_m - 1e-3) < 1e-9);
    }

    void aContactHasItsOutlineAndItsSlipInColourAndNumber() {
        GelView view;
        view.resize(640, 480);
        pipeline::GelSnapshot snapshot = test::sampleGel();
        const base::StatusColours& colours = base::statusColours(base::designedPalette(true));
        const auto shows = [&](std::optional<double> slip) {
            snapshot.contacts[0].slipIndex = slip;
            view.setSnapshot(&snapshot);
            return view.grab().toImage();
        };
        QVERIFY(pixelsOf(shows(0.1), base::identityColour(2, true)) > 300);
        QVERIFY(pixelsOf(shows(0.1), colours.live) > 100);
        QVERIFY(pixelsOf(shows(0.42), colours.stale) > 100);
        QVERIFY(pixelsOf(shows(0.9), colours.lost) > 100);
        QVERIFY(pixelsOf(shows(std::nullopt), colours.neutral) > 100);
        QCOMPARE(GelPicture::slipText(snapshot.contacts[0]), QStringLiteral("slip unknown"));
        snapshot.contacts[0].slipIndex = 0.42;
        QCOMPARE(GelPicture::slipText(snapshot.contacts[0]), QStringLiteral("slip 0.42"));
        const QString words = GelPicture::wordsFor(snapshot.contacts[0]);
        for (const char* part : {"Contact 2", "16.0", "12.0", "64.0", "90", "5.7", "0.42"})
            QVERIFY2(words.contains(QLatin1String(part)), qPrintable(words));
        QCOMPARE(view.picture().contactAt(inView(view, 130.0, 90.0), QSizeF(view.size())), 0);
        QCOMPARE(view.picture().contactAt(inView(view, 30.0, 90.0), QSizeF(view.size())), -1);
    }

    void aLostMarkerIsACrossInItsPlace() {
        GelView view;
        view.resize(640, 480);
        pipeline::GelSnapshot snapshot = test::sampleGel();
        view.setSnapshot(&snapshot);
        QVERIFY(view.grab().toImage().pixelColor(inView(view, 240.0, 200.0)) != kGround);
        snapshot.motions.back().found = true;
        view.setSnapshot(&snapshot);
        QCOMPARE(view.grab().toImage().pixelColor(inView(view, 240.0, 200.0)), kGround);
    }

    void theRestIsAskedForByTheButtonAndTheMenu() {
        GelPanel panel;
        panel.resize(900, 800);
        const pipeline::GelSnapshot snapshot = test::sampleGel();
        panel.setSnapshot(&snapshot);
        QSignalSpy asked(&panel, &GelPanel::referenceRequested);
        QTest::mouseClick(panel.findChild<QPushButton*>("gelReference"), Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
        QMenu menu;
        panel.view().populateMenu(menu);
        for (QAction* action : menu.actions())
            if (action->text().contains(QStringLiteral("rest")))
                action->trigger();
        QCOMPARE(asked.count(), 2);
    }

    void loadsOfACalibrationAreToldWithTheirErrors() {
        pipeline::GelSnapshot snapshot = test::sampleGel();
        QVERIFY(GelPicture::loadTexts(snapshot, 0).isEmpty());
        snapshot.loadNames = {"force_n", "moment_nm"};
        snapshot.loads.resize(snapshot.contacts.size());
        snapshot.loads[0].loads = Eigen::Vector2d(1.25, 0.003);
        snapshot.loads[0].errors = Eigen::Vector2d(0.05, 0.0002);
        QCOMPARE(GelPicture::loadTexts(snapshot, 0),
                 (QStringList{QString::fromUtf8("load 1.250 \u00b1 0.050\u00a0N"),
                              QString::fromUtf8("moment 3.00 \u00b1 0.20\u00a0mNm")}));
        snapshot.loads[0].extrapolated = true;
        QVERIFY(GelPicture::wordsFor(snapshot, 0)
                    .contains(QString::fromUtf8("load 1.250 \u00b1 0.050\u00a0N, extrapolated")));
    }

    void whatIsWrongIsTold() {
        GelPanel panel;
        auto* problem = panel.findChild<QLabel*>("problem");
        pipeline::GelSnapshot snapshot = test::sampleGel();
        panel.setSnapshot(&snapshot);
        QVERIFY(problem->isHidden());
        snapshot.problem = "The light has jumped.";
        panel.setSnapshot(&snapshot);
        QCOMPARE(problem->text(), QStringLiteral("The light has jumped."));
        QVERIFY(!problem->isHidden());
        snapshot.problem.clear();
        snapshot.missing = 3;
        panel.setSnapshot(&snapshot);
        QVERIFY2(problem->text().contains(QStringLiteral("3 more picture")), qPrintable(problem->text()));
        const QString counts = panel.findChild<QLabel*>("gelCounts")->text();
        QVERIFY2(counts.startsWith(QStringLiteral("8 of 9 markers")), qPrintable(counts));
    }

    void anArmThatReactsIsToldAndAllowed() {
        GelPanel panel;
        pipeline::GelSnapshot snapshot = test::sampleGel();
        panel.setSnapshot(&snapshot);
        auto* box = panel.findChild<QCheckBox*>("cameraMayReact");
        auto* line = panel.findChild<QLabel*>("arm");
        QVERIFY2(!box->isVisibleTo(&panel), "no arm carries this gel");
        snapshot.carrier =
            pipeline::CarrierReport{.doing = pipeline::CarrierReport::Doing::retreats, .contact = 2};
        snapshot.mayReact = true;
        panel.setSnapshot(&snapshot);
        QVERIFY(box->isVisibleTo(&panel));
        QVERIFY(box->isChecked());
        QCOMPARE(line->text(), QStringLiteral("The arm is retreating from contact 2."));
        QSignalSpy asked(&panel, &GelPanel::mayReactChanged);
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(5, box->height() / 2));
        QCOMPARE(asked, (QList<QVariantList>{{false}}));
    }

    void aFrozenPictureStays() {
        GelPanel panel;
        pipeline::GelSnapshot snapshot = test::sampleGel();
        panel.setSnapshot(&snapshot);
        QTest::keyClick(&panel.view(), Qt::Key_Space);
        QVERIFY(panel.isPaused());
        snapshot.frame = 41;
        panel.setSnapshot(&snapshot);
        QCOMPARE(panel.view().picture().shown.frame, std::uint64_t(40));
        panel.setSnapshot(nullptr);
        QVERIFY(!panel.isPaused());
    }

    void theMarkersAreCopiedAsATable() {
        GelView view;
        const pipeline::GelSnapshot snapshot = test::sampleGel();
        view.setSnapshot(&snapshot);
        const QStringList lines = view.figure().csv().split(QLatin1Char('\n'));
        QCOMPARE(lines.size(), 11);
        QCOMPARE(
            lines[0],
            QStringLiteral("frame,time_s,marker,row,column,rest_u_px,rest_v_px,u_px,v_px,dx_m,dy_m,found"));
        QCOMPARE(lines[5], QStringLiteral("40,1.5,4,1,1,160,120,165,120,5e-04,0,1"));
        QCOMPARE(lines[9], QStringLiteral("40,1.5,8,2,2,240,200,NA,NA,NA,NA,0"));
    }

    void eventsAreListedNewestFirstAndCopied() {
        GelEventTable table;
        GelEvent event{.kind = GelEvent::Kind::begins,
                       .time_s = 1.0,
                       .contact = 1,
                       .centre_m = {0.016, 0.012},
                       .shear_m = {3e-4, 4e-4},
                       .slipIndex = {}};
        table.append(event);
        event.kind = GelEvent::Kind::slip;
        event.time_s = 2.0;
        event.slipIndex = 0.85;
        table.append(event);
        table.append({.kind = GelEvent::Kind::torn, .time_s = 3.0, .slipIndex = {}});
        GelEventModel& model = table.model();
        QCOMPARE(model.rowCount(), 3);
        QVERIFY(!model.index(0, GelEventModel::contact).data().isValid());
        QCOMPARE(model.index(1, GelEventModel::event).data().toString(), QStringLiteral("SLIP"));
        QCOMPARE(model.index(1, GelEventModel::slipIndex).data().toString(), QStringLiteral("0.85"));
        QVERIFY(model.index(1, GelEventModel::shear).data().toString().contains(QStringLiteral("0.50")));
        QCOMPARE(model.index(1, GelEventModel::event).data(Qt::ForegroundRole).value<QColor>(),
                 base::statusColours(QGuiApplication::palette()).lost);
        QTest::keyClick(&table.table(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text(),
                 QStringLiteral("time_s,event,contact_id,x_m,y_m,shear_x_m,shear_y_m,slip_index\n"
                                "1,begin,1,0.016,0.012,3e-04,4e-04,NA\n"
                                "2,slip,1,0.016,0.012,3e-04,4e-04,0.85\n"
                                "3,gel_torn,NA,NA,NA,NA,NA,NA\n"));
        for (std::size_t i = 0; i < GelEventModel::kCapacity + 10; ++i)
            table.append(event);
        QCOMPARE(model.rowCount(), static_cast<int>(GelEventModel::kCapacity));
        table.clear();
        QCOMPARE(model.rowCount(), 0);
    }
};

static const test::Registration<GelPanelTest> kRegistration;
#include "gel_panel_test.moc"
