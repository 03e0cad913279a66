// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_device.h"
#include "widgets/chrome/device_strip.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <optional>

namespace teleta::console {

class BraceletService;

/// Texts about the bracelet. Thread: GUI.
class BraceletTexts {
    Q_DECLARE_TR_FUNCTIONS(BraceletTexts)

public:
    /// A line about its state; empty when there is nothing to report.
    [[nodiscard]] static QString note(const BraceletService& bracelet);
    /// For the status bar; empty without a bracelet.
    [[nodiscard]] static std::optional<chrome::DeviceReading> reading(const BraceletService& bracelet);

private:
    /// What its board reports, a line each.
    [[nodiscard]] static QStringList boardDetails(const core::BraceletTelemetry& telemetry);
};

} // namespace teleta::console
