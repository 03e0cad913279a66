// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/parts.h"
#include "widgets/base/theme.h"
#include "widgets/bracelet/strength_panel.h"

#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <limits>
#include <memory>

using teleta::bracelet::StrengthPanel;
using teleta::core::Intensities;

/// The sliders that limit the motors.
class StrengthPanelTest : public QObject {
    Q_OBJECT

    std::unique_ptr<StrengthPanel> m_panel;

private slots:
    void initTestCase() { teleta::base::applyTheme(teleta::base::ThemeChoice::light); }
    void init() {
        m_panel = std::make_unique<StrengthPanel>();
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    }
    void cleanup() { m_panel.reset(); }

    void oneKeyOnTheSliderOfAllMovesThemAll() {
        QSignalSpy changed(m_panel.get(), &StrengthPanel::strongestChanged);
        QTest::keyClick(teleta::test::part<QSlider>(*m_panel, "all"), Qt::Key_PageDown);
        QCOMPARE(changed.size(), 1);
        for (std::size_t i = 0; i < teleta::core::kTactors; ++i) {
            QCOMPARE(m_panel->strongest()[i], 0.9);
            QCOMPARE(teleta::test::part<QSlider>(*m_panel, qPrintable(QStringLiteral("motor%1").arg(i + 1)))
                         ->value(),
                     90);
        }
        QTest::keyClick(teleta::test::part<QSlider>(*m_panel, "all"), Qt::Key_Home);
        QCOMPARE(m_panel->strongest(), Intensities{});
    }

    void eachMotorHasASliderThatIsShownOnRequest() {
        QVERIFY(!teleta::test::part<QSlider>(*m_panel, "motor3")->isVisible());
        QTest::mouseClick(teleta::test::part<QToolButton>(*m_panel, "each"), Qt::LeftButton);
        QVERIFY(teleta::test::part<QSlider>(*m_panel, "motor3")->isVisible());
        QSignalSpy changed(m_panel.get(), &StrengthPanel::strongestChanged);
        QTest::keyClick(teleta::test::part<QSlider>(*m_panel, "motor3"), Qt::Key_PageDown);
        QTest::keyClick(teleta::test::part<QSlider>(*m_panel, "motor3"), Qt::Key_Left);
        QCOMPARE(changed.size(), 2);
        QCOMPARE(m_panel->strongest(), (Intensities{1.0, 1.0, 0.89, 1.0, 1.0, 1.0}));
        QCOMPARE(teleta::test::part<QSlider>(*m_panel, "all")->value(), 100);
    }

    void valuesBeyondTheRangeAreTheNearestSafeOnes() {
        QSignalSpy changed(m_panel.get(), &StrengthPanel::strongestChanged);
        m_panel->setStrongest({-1.0, 7.0, std::numeric_limits<double>::quiet_NaN(), 0.5, 0.25, 0.0});
        QCOMPARE(m_panel->strongest(), (Intensities{0.0, 1.0, 0.0, 0.5, 0.25, 0.0}));
        QVERIFY(changed.isEmpty());
    }
};

QTEST_MAIN(StrengthPanelTest)
#include "strength_panel_test.moc"
