// SPDX-License-Identifier: GPL-3.0-or-later
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
        QTest::keyClick(m_panel->allSlider(), Qt::Key_PageDown);
        QCOMPARE(changed.size(), 1);
        for (std::size_t i = 0; i < teleta::core::kTactors; ++i) {
            QCOMPARE(m_panel->strongest()[i], 0.9);
            QCOMPARE(m_panel->slider(i)->value(), 90);
        }
        QTest::keyClick(m_panel->allSlider(), Qt::Key_Home);
        QCOMPARE(m_panel->strongest(), Intensities{});
    }

    void eachMotorHasASliderThatIsShownOnRequest() {
        QVERIFY(!m_panel->slider(2)->isVisible());
        QTest::mouseClick(m_panel->eachButton(), Qt::LeftButton);
        QVERIFY(m_panel->slider(2)->isVisible());
        QSignalSpy changed(m_panel.get(), &StrengthPanel::strongestChanged);
        QTest::keyClick(m_panel->slider(2), Qt::Key_PageDown);
        QTest::keyClick(m_panel->slider(2), Qt::Key_Left);
        QCOMPARE(changed.size(), 2);
        QCOMPARE(m_panel->strongest(), (Intensities{1.0, 1.0, 0.89, 1.0, 1.0, 1.0}));
        QCOMPARE(m_panel->allSlider()->value(), 100);
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
