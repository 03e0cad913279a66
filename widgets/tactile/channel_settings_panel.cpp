// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/channel_settings_panel.h"

#include "widgets/base/compose.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace teleta::tactile {

namespace {

constexpr int kLetters = 12; ///< of a choice that have room
constexpr double kSmallest = 1e-6;
constexpr double kLargest = 1e9;
/// Smallest difference of the two ratios: the hysteresis between edge and point.
constexpr double kRatioGap = 0.1;

/// Shows 1 as "1", not "1.000000", however many decimals can be typed.
class NumberBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;
    [[nodiscard]] QString textFromValue(double value) const override {
        return locale().toString(value, 'g', 6);
    }
};

QDoubleSpinBox* makeNumber(QWidget* parent, double low, double high, int decimals) {
    auto* box = new NumberBox(parent);
    box->setDecimals(decimals);
    box->setRange(low, high);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false);
    return box;
}

} // namespace

ChannelSettingsPanel::ChannelSettingsPanel(QWidget* parent)
    : QWidget(parent)
    , m_parts(new QTabWidget(this))
    , m_loads(new QFormLayout)
    , m_contacts(new QFormLayout)
    , m_tare(base::named<QPushButton>("tareNow", this))
    , m_clearTare(new QPushButton(this))
    , m_tareState(new QLabel(this))
    , m_gain(makeNumber(this, kSmallest, kLargest, 6))
    , m_inverted(new QCheckBox(this))
    , m_threshold(makeNumber(this, kSmallest, kLargest, 4))
    , m_automatic(new QCheckBox(this))
    , m_noiseHeight(makeNumber(this, 0.0, 100.0, 1))
    , m_minimumTaxels(new QSpinBox(this))
    , m_orientation(new QComboBox(this))
    , m_range(new QComboBox(this))
    , m_edgeRatio(makeNumber(this, 1.0 + kRatioGap, 1000.0, 2))
    , m_pointRatio(makeNumber(this, 1.0, 1000.0, 2))
    , m_defaults(new QPushButton(this)) {
    m_minimumTaxels->setRange(1, 10'000);
    m_orientation->addItems({QString(), QString()});
    m_range->addItems({QString(), QString()});
    m_tareState->setWordWrap(true);

    // In a narrow column beside the pictures, to which it leaves the width.
    for (QFormLayout* form : {m_loads, m_contacts}) {
        auto* part = new QWidget(this);
        part->setLayout(form);
        form->setContentsMargins(0, base::grid(this), 0, 0);
        form->setRowWrapPolicy(QFormLayout::WrapAllRows);
        form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
        m_parts->addTab(part, QString());
    }
    m_parts->setDocumentMode(true);
    for (QComboBox* box : {m_orientation, m_range}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kLetters);
    }
    const QString unnamed(QLatin1Char(' ')); // makes a label that retranslate() fills
    m_loads->addRow(unnamed, m_gain);
    m_loads->addRow(m_inverted);
    m_loads->addRow(unnamed, m_threshold);
    m_loads->addRow(m_automatic);
    for (QWidget* field : std::initializer_list<QWidget*>{m_noiseHeight, m_minimumTaxels, m_orientation,
                                                          m_range, m_edgeRatio, m_pointRatio})
        m_contacts->addRow(unnamed, field);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_tare);
    layout->addWidget(m_clearTare);
    layout->addWidget(m_tareState);
    layout->addWidget(m_parts);
    layout->addWidget(m_defaults, 0, Qt::AlignLeft);
    layout->addStretch(1);

    connect(m_tare, &QPushButton::clicked, this, &ChannelSettingsPanel::tareRequested);
    connect(m_clearTare, &QPushButton::clicked, this, &ChannelSettingsPanel::clearTareRequested);
    for (QDoubleSpinBox* box : {m_gain, m_threshold, m_noiseHeight, m_edgeRatio, m_pointRatio})
        connect(box, &QDoubleSpinBox::valueChanged, this, &ChannelSettingsPanel::changed);
    connect(m_minimumTaxels, &QSpinBox::valueChanged, this, &ChannelSettingsPanel::showUnits);
    connect(m_minimumTaxels, &QSpinBox::valueChanged, this, &ChannelSettingsPanel::changed);
    for (QCheckBox* box : {m_inverted, m_automatic})
        connect(box, &QCheckBox::toggled, this, &ChannelSettingsPanel::changed);
    for (QComboBox* box : {m_orientation, m_range})
        connect(box, &QComboBox::currentIndexChanged, this, &ChannelSettingsPanel::changed);
    connect(m_defaults, &QPushButton::clicked, this, [this] {
        pipeline::ChannelSettings defaults;
        defaults.conditioning.tare = m_settings.conditioning.tare;
        defaults.conditioning.taxelGain = m_settings.conditioning.taxelGain;
        defaults.conditioning.dead = m_settings.conditioning.dead;
        defaults.loadUnit = m_settings.loadUnit;
        setSettings(defaults, m_layout);
        emit settingsChanged(settings());
    });
    retranslate();
    setSettings({}, {});
    base::onChange(this,
                   [this] {
                       retranslate();
                       showTare();
                   },
                   {QEvent::LanguageChange});
}

void ChannelSettingsPanel::setSettings(const pipeline::ChannelSettings& settings,
                                       const core::TaxelLayout& layout) {
    m_showing = true;
    m_settings = settings;
    m_layout = layout;
    m_gain->setValue(settings.conditioning.gain);
    m_inverted->setChecked(settings.conditioning.inverted);
    m_threshold->setValue(settings.features.threshold_N);
    m_automatic->setChecked(settings.features.automaticThreshold);
    m_noiseHeight->setValue(settings.segmentation.noiseHeight * 100.0);
    m_minimumTaxels->setValue(settings.segmentation.minimumTaxels);
    m_orientation->setCurrentIndex(settings.features.orientation == contact::OrientationMode::weighted ? 1
                                                                                                       : 0);
    m_range->setCurrentIndex(settings.features.range == contact::MomentRange::active ? 1 : 0);
    m_edgeRatio->setValue(settings.features.edgeRatio);
    m_pointRatio->setMaximum(settings.features.edgeRatio - kRatioGap);
    m_pointRatio->setValue(settings.features.pointRatio);
    showUnits();
    showTare();
    m_showing = false;
}

pipeline::ChannelSettings ChannelSettingsPanel::settings() const {
    pipeline::ChannelSettings settings = m_settings;
    settings.conditioning.gain = m_gain->value();
    settings.conditioning.inverted = m_inverted->isChecked();
    settings.features.threshold_N = m_threshold->value();
    settings.features.automaticThreshold = m_automatic->isChecked();
    settings.features.orientation = m_orientation->currentIndex() == 1 ? contact::OrientationMode::weighted
                                                                       : contact::OrientationMode::binarised;
    settings.features.range =
        m_range->currentIndex() == 1 ? contact::MomentRange::active : contact::MomentRange::image;
    settings.features.edgeRatio = m_edgeRatio->value();
    settings.features.pointRatio = std::min(m_pointRatio->value(), m_edgeRatio->value() - kRatioGap);
    settings.segmentation.threshold_N = m_threshold->value();
    settings.segmentation.noiseHeight = m_noiseHeight->value() * 0.01;
    settings.segmentation.minimumTaxels = m_minimumTaxels->value();
    return settings;
}

void ChannelSettingsPanel::changed() {
    if (m_showing)
        return;
    m_pointRatio->setMaximum(m_edgeRatio->value() - kRatioGap);
    m_settings = settings();
    emit settingsChanged(m_settings);
}

void ChannelSettingsPanel::showUnits() {
    const QString unit = QString::fromStdString(m_settings.loadUnit);
    m_gain->setSuffix(unit.isEmpty() ? QString()
                                     : tr(" %1/raw unit", "of a gain: load per raw unit").arg(unit));
    m_threshold->setSuffix(unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
    m_noiseHeight->setSuffix(tr(" %"));
    m_minimumTaxels->setSuffix(m_minimumTaxels->value() == 1 ? tr(" taxel") : tr(" taxels"));
    for (QDoubleSpinBox* ratio : {m_edgeRatio, m_pointRatio})
        ratio->setSuffix(QStringLiteral("\u00a0:\u00a01"));
}

void ChannelSettingsPanel::showTare() {
    const auto& tare = m_settings.conditioning.tare;
    int dead = 0;
    if (tare.size() == m_layout.values()) {
        const auto components = static_cast<std::ptrdiff_t>(m_layout.components());
        auto value = tare.begin();
        for (std::size_t taxel = 0; taxel < m_layout.taxels(); ++taxel, value += components)
            if (!m_layout.isAbsent(taxel) &&
                std::any_of(value, value + components, [](float each) { return std::isnan(each); }))
                ++dead;
    }
    QString text = tare.empty() ? tr("Not tared") : tr("Tared");
    if (dead > 0)
        text = tr("Tared, %n taxel(s) without a reading", nullptr, dead);
    if (!m_settings.conditioning.taxelGain.empty())
        text += QStringLiteral(" \u00b7 ") + tr("taxel gains in use");
    m_tareState->setText(text);
    m_clearTare->setEnabled(!tare.empty());
}

void ChannelSettingsPanel::retranslate() {
    const auto describe = [this](QWidget* field, const QString& name, const QString& help) {
        QWidget* label = m_loads->labelForField(field);
        qobject_cast<QLabel*>(label != nullptr ? label : m_contacts->labelForField(field))->setText(name);
        field->setToolTip(help);
        field->setWhatsThis(help);
        field->setAccessibleName(QString(name).remove(QLatin1Char('&')).remove(QLatin1Char(':')));
    };
    m_parts->setTabText(0, tr("Loads", "a group of settings"));
    m_parts->setTabText(1, tr("Contacts", "a group of settings"));
    m_tare->setText(tr("&Tare now"));
    m_tare->setToolTip(
        tr("Takes the mean of the next half second as the unloaded state. Nothing may touch the array."));
    m_clearTare->setText(tr("&Clear tare"));
    m_clearTare->setToolTip(tr("Uses the raw values again"));
    describe(m_gain, tr("&Gain:"), tr("Load per raw unit"));
    m_inverted->setText(tr("Values fall under load"));
    m_inverted->setToolTip(tr("For arrays whose raw values are highest when nothing touches them"));
    describe(m_threshold, tr("Thresho&ld:"), tr("A taxel is in contact from this load on"));
    m_automatic->setText(tr("A&utomatic threshold"));
    m_automatic->setToolTip(
        tr("Finds the lowest useful threshold in each frame; the value above is its lower bound"));
    describe(m_noiseHeight, tr("No&ise height:"),
             tr("Two peaks count as one contact when the lower one rises less than this above the saddle "
                "between them, in percent of the highest peak of the frame"));
    describe(m_minimumTaxels, tr("&Smallest contact:"), tr("In taxels; smaller contacts are ignored"));
    describe(m_orientation, tr("&Orientation:"), tr("Which taxels the principal axis is computed from"));
    m_orientation->setItemText(0, tr("active taxels equally"));
    m_orientation->setItemText(1, tr("weighted by load"));
    describe(m_range, tr("Force over:"),
             tr("Whole image: adds up every load. Active taxels: leaves out the noise of unloaded taxels"));
    m_range->setItemText(0, tr("whole image"));
    m_range->setItemText(1, tr("active taxels"));
    describe(m_edgeRatio, tr("&Edge above:"),
             tr("The contact becomes an edge when the ratio of the eigenvalues rises above this"));
    describe(m_pointRatio, tr("&Point below:"),
             tr("The contact becomes a point when the ratio of the eigenvalues falls below this"));
    m_defaults->setText(tr("&Defaults"));
    m_defaults->setToolTip(tr("Reset everything but the tare and the taxel gains"));
    showUnits();
}

} // namespace teleta::tactile
