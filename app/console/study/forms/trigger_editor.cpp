// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/trigger_editor.h"

#include "widgets/base/compose.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSpinBox>

#include <cstdint>
#include <initializer_list>

namespace teleta::console {

namespace {

using TriggerKind = core::TriggerSettings::Kind;

constexpr double kLongestPulse_ms = 1000.0;

} // namespace

TriggerEditor::TriggerEditor(const core::TriggerSettings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_kind(base::named<QComboBox>("triggerKind", this))
    , m_device(base::named<QLineEdit>("triggerDevice", this))
    , m_pulse_ms(base::named<QDoubleSpinBox>("triggerPulse", this))
    , m_host(base::named<QLineEdit>("triggerHost", this))
    , m_port(base::named<QSpinBox>("triggerPort", this)) {
    m_kind->addItems({tr("none"), tr("serial port"), tr("OSC by UDP")});
    m_kind->setCurrentIndex(static_cast<int>(settings.kind));
    m_device->setText(QString::fromStdString(settings.device));
    m_device->setPlaceholderText(QStringLiteral("/dev/ttyUSB0"));
    m_device->setAccessibleName(tr("Serial port"));
    m_pulse_ms->setRange(0.0, kLongestPulse_ms);
    m_pulse_ms->setDecimals(3);
    m_pulse_ms->setSuffix(QStringLiteral(" ms"));
    m_pulse_ms->setPrefix(tr("back to 0 after ", "before a number of milliseconds"));
    m_pulse_ms->setSpecialValueText(tr("not back to 0"));
    m_pulse_ms->setValue(settings.pulse_ms);
    m_host->setText(QString::fromStdString(settings.host));
    m_host->setAccessibleName(tr("Name or address of the receiver"));
    m_port->setRange(1, 65535);
    m_port->setPrefix(tr("port ", "before a number"));
    m_port->setValue(settings.port);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    base::addWidgets(line, {m_kind, m_device, m_pulse_ms, m_host, m_port});
    setFocusProxy(m_kind);
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
        showFields();
        emit changed();
    });
    for (QLineEdit* edit : {m_device, m_host})
        connect(edit, &QLineEdit::textChanged, this, &TriggerEditor::changed);
    connect(m_pulse_ms, &QDoubleSpinBox::valueChanged, this, &TriggerEditor::changed);
    connect(m_port, &QSpinBox::valueChanged, this, &TriggerEditor::changed);
    showFields();
}

core::TriggerSettings TriggerEditor::settings() const {
    core::TriggerSettings settings = m_settings;
    settings.kind = static_cast<TriggerKind>(m_kind->currentIndex());
    if (settings.kind == TriggerKind::serial) {
        settings.device = m_device->text().trimmed().toStdString();
        settings.pulse_ms = m_pulse_ms->value();
    } else if (settings.kind == TriggerKind::osc) {
        settings.host = m_host->text().trimmed().toStdString();
        settings.port = static_cast<std::uint16_t>(m_port->value());
    }
    return settings;
}

void TriggerEditor::showFields() {
    const auto kind = static_cast<TriggerKind>(m_kind->currentIndex());
    for (QWidget* field : std::initializer_list<QWidget*>{m_device, m_pulse_ms})
        field->setVisible(kind == TriggerKind::serial);
    for (QWidget* field : std::initializer_list<QWidget*>{m_host, m_port})
        field->setVisible(kind == TriggerKind::osc);
}

} // namespace teleta::console
