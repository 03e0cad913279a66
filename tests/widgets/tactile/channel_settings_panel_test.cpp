// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/channel_settings_panel.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabBar>
#include <QTest>

#include <algorithm>
#include <cstddef>
#include <limits>

using teleta::pipeline::ChannelSettings;
using teleta::tactile::ChannelSettingsPanel;

Q_DECLARE_METATYPE(teleta::pipeline::ChannelSettings)

/// The panel of processing settings.
class ChannelSettingsPanelTest : public QObject {
    Q_OBJECT

    static constexpr teleta::core::ArrayLayout kTwoTaxels{.rows = 1, .columns = 2, .pitchX_m = 0.004};

    template <typename Widget>
    static Widget* named(const ChannelSettingsPanel& panel, const QString& accessibleName) {
        for (auto* widget : panel.findChildren<Widget*>()) {
            if (widget->accessibleName() == accessibleName)
                return widget;
        }
        return nullptr;
    }

    static QPushButton* button(const ChannelSettingsPanel& panel, const QString& text) {
        for (auto* candidate : panel.findChildren<QPushButton*>()) {
            if (candidate->text().remove('&') == text)
                return candidate;
        }
        return nullptr;
    }

    static ChannelSettings unusual() {
        ChannelSettings settings;
        settings.conditioning.gain = 2.5;
        settings.conditioning.inverted = true;
        settings.conditioning.tare = {1.0F, std::numeric_limits<float>::quiet_NaN()};
        settings.features.threshold_N = 10.0;
        settings.features.orientation = teleta::contact::OrientationMode::weighted;
        settings.features.range = teleta::contact::MomentRange::active;
        settings.features.edgeRatio = 6.0;
        settings.features.pointRatio = 3.0;
        settings.segmentation.threshold_N = 10.0;
        settings.segmentation.noiseHeight = 0.25;
        settings.segmentation.minimumTaxels = 3;
        settings.loadUnit = "counts";
        return settings;
    }

private slots:
    void initTestCase() { qRegisterMetaType<ChannelSettings>(); }

    void everyNumberHasItsUnit() {
        ChannelSettingsPanel panel;
        ChannelSettings settings = unusual();
        panel.setSettings(settings, kTwoTaxels);
        QCOMPARE(named<QDoubleSpinBox>(panel, "Gain")->suffix(), QStringLiteral(" counts/raw unit"));
        QCOMPARE(named<QDoubleSpinBox>(panel, "Threshold")->suffix(), QStringLiteral(" counts"));
        QCOMPARE(named<QSpinBox>(panel, "Smallest contact")->suffix(), QStringLiteral(" taxels"));
        settings.segmentation.minimumTaxels = 1;
        panel.setSettings(settings, kTwoTaxels);
        QCOMPARE(named<QSpinBox>(panel, "Smallest contact")->suffix(), QStringLiteral(" taxel"));
        for (const auto* field : panel.findChildren<QAbstractSpinBox*>())
            QVERIFY2(!field->property("suffix").toString().isEmpty(), qPrintable(field->accessibleName()));
    }

    void givesBackWhatItShowsWithoutASignal() {
        ChannelSettingsPanel panel;
        QSignalSpy changes(&panel, &ChannelSettingsPanel::settingsChanged);
        panel.setSettings(unusual(), kTwoTaxels);
        QCOMPARE(changes.size(), 0);
        const ChannelSettings shown = panel.settings();
        QCOMPARE(shown.conditioning.gain, 2.5);
        QVERIFY(shown.conditioning.inverted);
        QCOMPARE(shown.conditioning.tare.size(), std::size_t(2));
        QCOMPARE(shown.features.threshold_N, 10.0);
        QVERIFY(shown.features.orientation == teleta::contact::OrientationMode::weighted);
        QVERIFY(shown.features.range == teleta::contact::MomentRange::active);
        QCOMPARE(shown.features.edgeRatio, 6.0);
        QCOMPARE(shown.features.pointRatio, 3.0);
        QCOMPARE(shown.segmentation.noiseHeight, 0.25);
        QCOMPARE(shown.segmentation.minimumTaxels, 3);
        QCOMPARE(shown.loadUnit, std::string("counts"));
    }

    void aTypedThresholdActsOnFeaturesAndContactsAlike() {
        ChannelSettingsPanel panel;
        QSignalSpy changes(&panel, &ChannelSettingsPanel::settingsChanged);
        auto* threshold = named<QDoubleSpinBox>(panel, "Threshold");
        QVERIFY(threshold != nullptr);
        threshold->selectAll();
        QTest::keyClicks(threshold, "0.5");
        QCOMPARE(changes.size(), 0);
        QTest::keyClick(threshold, Qt::Key_Return);
        QCOMPARE(changes.size(), 1);
        const auto settings = changes[0][0].value<ChannelSettings>();
        QCOMPARE(settings.features.threshold_N, 0.5);
        QCOMPARE(settings.segmentation.threshold_N, 0.5);
    }

    void isANarrowColumnWithTwoTabs() {
        ChannelSettingsPanel panel;
        panel.setSettings(unusual(), kTwoTaxels);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QVERIFY(panel.minimumSizeHint().width() <= 14 * panel.fontMetrics().height());
        auto* gain = named<QDoubleSpinBox>(panel, "Gain");
        auto* edge = named<QDoubleSpinBox>(panel, "Edge above");
        QVERIFY(gain->isVisible() && !edge->isVisible());
        auto* tabs = panel.findChild<QTabBar*>();
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(1).center());
        QVERIFY(!gain->isVisible() && edge->isVisible());
    }

    void keepsTheTwoRatiosApart() {
        ChannelSettingsPanel panel;
        auto* edge = named<QDoubleSpinBox>(panel, "Edge above");
        QVERIFY(edge != nullptr);
        edge->setValue(2.0);
        QVERIFY(panel.settings().features.pointRatio < panel.settings().features.edgeRatio);
    }

    void defaultsLeaveTareDeadTaxelsAndUnit() {
        ChannelSettingsPanel panel;
        panel.setSettings(unusual(), kTwoTaxels);
        QSignalSpy changes(&panel, &ChannelSettingsPanel::settingsChanged);
        QTest::mouseClick(button(panel, "Defaults"), Qt::LeftButton);
        QCOMPARE(changes.size(), 1);
        const auto settings = changes[0][0].value<ChannelSettings>();
        QCOMPARE(settings.features.threshold_N, ChannelSettings{}.features.threshold_N);
        QCOMPARE(settings.conditioning.tare.size(), std::size_t(2));
        QCOMPARE(settings.loadUnit, std::string("counts"));
    }

    /// A cross on a grid of 3 by 3, with three components each, of which one lacks a component.
    void countsTaxelsWithoutAReadingAndNoneWhereThereIsNone() {
        teleta::core::TaxelLayout cross({.rows = 3, .columns = 3, .pitchX_m = 0.007}, 3);
        cross.setAbsent({1, 0, 1, 0, 0, 0, 1, 0, 1});
        ChannelSettings settings;
        settings.conditioning.tare.assign(cross.values(), 1.0F);
        for (const std::size_t taxel : {0U, 2U, 6U, 8U})
            std::fill_n(settings.conditioning.tare.begin() + 3 * taxel, 3,
                        std::numeric_limits<float>::quiet_NaN());
        ChannelSettingsPanel panel;
        panel.setSettings(settings, cross);
        const auto tells = [&panel](const QString& text) {
            const auto labels = panel.findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(),
                               [&](const QLabel* label) { return label->text() == text; });
        };
        QVERIFY(tells(QStringLiteral("Tared")));
        settings.conditioning.tare[3 * 4 + 1] = std::numeric_limits<float>::quiet_NaN();
        settings.conditioning.tare[3 * 4 + 2] = std::numeric_limits<float>::quiet_NaN();
        panel.setSettings(settings, cross);
        QVERIFY(tells(QStringLiteral("Tared, 1 taxel(s) without a reading")));
    }

    void asksForTareAndOnlyOffersToClearOneThatIsThere() {
        ChannelSettingsPanel panel;
        QVERIFY(!button(panel, "Clear tare")->isEnabled());
        panel.setSettings(unusual(), kTwoTaxels);
        QVERIFY(button(panel, "Clear tare")->isEnabled());
        QSignalSpy tares(&panel, &ChannelSettingsPanel::tareRequested);
        QSignalSpy clears(&panel, &ChannelSettingsPanel::clearTareRequested);
        QTest::mouseClick(button(panel, "Tare now"), Qt::LeftButton);
        QTest::mouseClick(button(panel, "Clear tare"), Qt::LeftButton);
        QCOMPARE(tares.size(), 1);
        QCOMPARE(clears.size(), 1);
    }
};

QTEST_MAIN(ChannelSettingsPanelTest)
#include "channel_settings_panel_test.moc"
