// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/bracelet_texts.h"

#include "app/console/bracelet/bracelet_service.h"
#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "widgets/base/numbers/quantity_text.h"

#include <QStringList>

#include <cmath>

namespace teleta::console {

QString BraceletTexts::note(const BraceletService& bracelet) {
    if (bracelet.isStopped())
        return tr("STOP is engaged: the bracelet is off.");
    if (bracelet.choice() == BraceletChoice::none)
        return tr("No bracelet: what would be played is named in the table of patterns.");
    const auto& session = bracelet.session();
    if (!session)
        return tr("Connecting to the bracelet\u2026");
    if (session->source().connection() == 0)
        return tr("The bracelet is not connected. %1")
            .arg(QString::fromStdString(session->source().status().message));
    if (bracelet.state() == core::DeviceState::connecting)
        return tr("Connecting to the bracelet\u2026");
    if (!bracelet.isLive())
        return tr("The bracelet does not answer.");
    if (bracelet.isTooHot())
        return tr("The bracelet is too hot: it is off until it has cooled down.");
    if (bracelet.isReserved())
        return tr("A study uses the bracelet.");
    const core::BraceletTelemetry telemetry = session->source().telemetry();
    if (telemetry.board.supplyLow)
        return std::isfinite(telemetry.board.supply_V)
                   ? tr("The supply of the bracelet is low: %1 V.")
                         .arg(base::fixedDigits(telemetry.board.supply_V, 2))
                   : tr("The supply of the bracelet is low.");
    if (session->player().counters().framesRefused > 0)
        return tr("The bracelet refused what was played last: it did not understand it.");
    if (!bracelet.calibration().measured())
        return tr("The motors are not calibrated (page Calibrate).");
    return {};
}

QStringList BraceletTexts::boardDetails(const core::BraceletTelemetry& telemetry) {
    QStringList lines;
    if (telemetry.board.tooHot)
        lines << tr("too hot: off until it has cooled down");
    if (telemetry.board.supplyLow)
        lines << tr("supply low");
    if (telemetry.framesRefused > 0)
        lines << tr("frames refused: %1").arg(telemetry.framesRefused);
    if (std::isfinite(telemetry.board.supply_V))
        lines << tr("supply %1 V").arg(base::fixedDigits(telemetry.board.supply_V, 2));
    if (std::isfinite(telemetry.board.temperature_degC))
        lines << tr("temperature %1 \u00b0"
                    "C")
                     .arg(base::fixedDigits(telemetry.board.temperature_degC, 1));
    return lines;
}

std::optional<chrome::DeviceReading> BraceletTexts::reading(const BraceletService& bracelet) {
    if (bracelet.choice() == BraceletChoice::none)
        return std::nullopt;
    chrome::DeviceReading reading;
    reading.name = tr("Bracelet");
    reading.state = core::DeviceState::connecting;
    const auto& session = bracelet.session();
    if (!session)
        return reading;
    const core::DeviceStatus status = session->source().status();
    const std::int64_t now_ns = core::steadyNow_ns();
    reading.provenance = bracelet.isSimulated() ? base::Provenance::simulated : base::Provenance::live;
    reading.state = bracelet.state();
    reading.age_s = status.lastData_ns > 0 ? static_cast<double>(now_ns - status.lastData_ns) * 1e-9 : 0.0;
    reading.rate_Hz = status.rate_Hz;
    reading.lost = status.framesLost;
    reading.details = QString::fromStdString(status.message);
    if (reading.details.isEmpty()) {
        QStringList lines;
        if (status.framesRead > 0)
            lines = boardDetails(session->source().telemetry());
        if (!bracelet.calibration().measured())
            lines << tr("not calibrated: the motors are assumed");
        reading.details = lines.join(QLatin1Char('\n'));
    }
    reading.touchToSkin_s = bracelet.newestTouchToSkin_s();
    return reading;
}

} // namespace teleta::console
