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

/// What is said of the bracelet. Thread: GUI.
class BraceletTexts {
    Q_DECLARE_TR_FUNCTIONS(BraceletTexts)

public:
    /// One line on its state; empty when there is nothing to say.
    [[nodiscard]] static QString note(const BraceletService& bracelet);
    /// For the status bar; empty without a bracelet.
    [[nodiscard]] static std::optional<chrome::DeviceReading> reading(const BraceletService& bracelet);

private:
    /// What its board tells of itself, a line each.
    [[nodiscard]] static QStringList boardDetails(const core::BraceletTelemetry& telemetry);
};

} // namespace teleta::console
