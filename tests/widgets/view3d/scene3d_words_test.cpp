// SPDX-License-Identifier: GPL-3.0-or-later
// What the 3-D view says of what is under the mouse.
#include "tests/widgets/camera/sample_gel.h"
#include "tests/widgets/view3d/scene3d_stage.h"
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/scene/gel_part.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHelpEvent>
#include <QMenu>
#include <QTest>
#include <QToolTip>

#include <array>
#include <cstddef>

using namespace teleta;
using namespace teleta::test;

class Scene3dWordsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { base::applyTheme(base::ThemeChoice::light); }
    void cleanup() { base::applyTheme(base::ThemeChoice::light); }

    void aGelIsSeenWithTheColourOfItsSlipAndSaysWhatItsPictureSays_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void aGelIsSeenWithTheColourOfItsSlipAndSaysWhatItsPictureSays() {
        QFETCH(bool, dark);
        base::applyTheme(dark ? base::ThemeChoice::dark : base::ThemeChoice::light);
        Stage stage;
        QVERIFY(stage.ready());
        const std::size_t before = countColours(shown(stage.view));
        pipeline::GelSnapshot gel = test::sampleGel();
        gel.contacts.front().normalProxy_m2 = 0.0;
        const std::array words{view3d::GelWords{QStringLiteral("slip 0.42"),
                                                QStringLiteral("Contact 2\nslip index 0.42"),
                                                {QColor(200, 0, 200), QColor(0, 200, 0)}}};
        stage.view.setGel(&gel, 4.0, words);
        const QImage picture = shown(stage.view);
        QVERIFY2(countColours(picture) > before + 100, "only the empty scene");
        const QPoint centre = pixelOf(stage.view, {5e-5, 5e-5, 2.5e-3});
        QVERIFY2(hasHueOf(picture.pixel(centre), words.front().slipColour[dark ? 1 : 0]),
                 qPrintable(QColor(picture.pixel(centre)).name()));
        QWidget* canvas = vtkOf(stage.view).focusProxy();
        const QPoint there =
            (QPointF(pixelOf(stage.view, {5e-5, 5e-5, 0.0})) / stage.view.devicePixelRatioF()).toPoint();
        QHelpEvent on(QEvent::ToolTip, there, canvas->mapToGlobal(there));
        QApplication::sendEvent(canvas, &on);
        QCOMPARE(QToolTip::text(), words.front().all);
        QToolTip::hideText();
        stage.view.setGel(nullptr, 1.0, {});
        QCOMPARE(countHue(shown(stage.view), words.front().slipColour[dark ? 1 : 0]), 0);
    }

    void theShearOfAContactStandsInItsWordsAndItsRow() {
        Stage stage;
        QVERIFY(stage.ready());
        auto snapshot = test::pressed(kLayout, {{2, kLayout.x_m(10), kLayout.y_m(1), 1.0, 0.003}});
        snapshot.layout = core::TaxelLayout(kLayout, 3);
        snapshot.shearX_N.assign(kLayout.taxels(), 0.0F);
        snapshot.shearY_N.assign(kLayout.taxels(), 0.0F);
        QCOMPARE(snapshot.contacts.size(), std::size_t{1});
        snapshot.contacts[0].shear = contact::ShearLoad{0.3, -0.4, 0.001, 0.25};
        stage.view.setSnapshot(snapshot);
        stage.settle();
        QWidget* canvas = vtkOf(stage.view).focusProxy();
        const QPoint there = (QPointF(pixelOf(stage.view, peakOf(kLayout.x_m(10), kLayout.y_m(1)))) /
                              stage.view.devicePixelRatioF())
                                 .toPoint();
        QHelpEvent on(QEvent::ToolTip, there, canvas->mapToGlobal(there));
        QApplication::sendEvent(canvas, &on);
        QVERIFY2(QToolTip::text().contains(QStringLiteral("Shear 0.5")), qPrintable(QToolTip::text()));
        QVERIFY2(QToolTip::text().contains(QStringLiteral("friction 0.25")), qPrintable(QToolTip::text()));
        QToolTip::hideText();
        QMenu menu;
        stage.view.fillMenu(menu);
        for (QAction* action : menu.actions())
            if (action->text() == QStringLiteral("Copy &data"))
                action->trigger();
        const QString csv = QGuiApplication::clipboard()->text();
        QVERIFY2(csv.startsWith(QStringLiteral("time_s,contact_id,x_m,y_m,force_n,peak_n,area_m2,shear_x_n,"
                                               "shear_y_n,moment_z_nm,friction_ratio\n")),
                 qPrintable(csv));
        QVERIFY2(csv.trimmed().endsWith(QStringLiteral(",0.3,-0.4,0.001,0.25")), qPrintable(csv));
    }
};

int main(int argc, char** argv) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    Scene3dWordsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "scene3d_words_test.moc"
