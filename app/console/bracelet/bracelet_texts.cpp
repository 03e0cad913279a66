// SPDX-License-Identifier: GPL-3.0-or-later
// BraceletService: its texts about the bracelet.
#include "app/console/bracelet/bracelet_service.h"
#include "backend/core/device/device_state.h"
#include "backend/core/steady_time.h"
#include "widgets/base/numbers/quantity_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace teleta::console {

namespace {

struct BraceletTexts {
    Q_DECLARE_TR_FUNCTIONS(BraceletTexts)
};

/// What a sound card reports of itself: no board answers, and nobody watches the coils.
QStringList soundDetails(const core::SoundReport& sound, const core::BraceletDescription& bracelet) {
    return {
        BraceletTexts::tr("confirmed: played by the callback of the sound card"),
        std::isfinite(bracelet.measuredLatency_s)
            ? BraceletTexts::tr("latency %1 ms, as measured")
                  .arg(base::fixedDigits(1e3 * bracelet.measuredLatency_s, 1))
            : BraceletTexts::tr("latency at most %1 ms, as stated, not measured")
                  .arg(base::fixedDigits(1e3 * bracelet.statedLatency_s, 1)),
        BraceletTexts::tr("callback takes %1 % of a period, longest %2 %")
            .arg(base::fixedDigits(1e2 * sound.meanShare, 1), base::fixedDigits(1e2 * sound.longestShare, 1)),
        BraceletTexts::tr("periods missed: %1").arg(sound.missedPeriods)};
}

/// What its board reports, a line each.
QStringList boardDetails(const core::BraceletSource& bracelet) {
    const core::BraceletTelemetry telemetry = bracelet.telemetry();
    QStringList lines;
    if (telemetry.board.tooHot)
        lines << BraceletTexts::tr("too hot: off until it has cooled down");
    if (telemetry.board.supplyLow)
        lines << BraceletTexts::tr("supply low");
    if (telemetry.framesRefused > 0)
        lines << BraceletTexts::tr("frames refused: %1").arg(telemetry.framesRefused);
    if (std::isfinite(telemetry.board.supply_V))
        lines << BraceletTexts::tr("supply %1 V").arg(base::fixedDigits(telemetry.board.supply_V, 2));
    if (std::isfinite(telemetry.board.temperature_degC))
        lines << BraceletTexts::tr("temperature %1 \u00b0"
                                   "C")
                     .arg(base::fixedDigits(telemetry.board.temperature_degC, 1));
    if (telemetry.board.sound)
        lines << soundDetails(*telemetry.board.sound, bracelet.description());
    return lines;
}

} // namespace

QString BraceletService::note() const {
    if (isStopped())
        return BraceletTexts::tr("STOP is engaged: the bracelet is off.");
    if (choice() == BraceletChoice::none)
        return BraceletTexts::tr("No bracelet: what would be played is named in the table of patterns.");
    const auto& session = m_session;
    if (!session)
        return BraceletTexts::tr("Connecting to the bracelet\u2026");
    if (session->source().connection() == 0)
        return BraceletTexts::tr("The bracelet is not connected. %1")
            .arg(QString::fromStdString(session->source().status().message));
    if (state() == core::DeviceState::connecting)
        return BraceletTexts::tr("Connecting to the bracelet\u2026");
    if (!isLive())
        return BraceletTexts::tr("The bracelet does not answer.");
    if (isTooHot())
        return BraceletTexts::tr("The bracelet is too hot: it is off until it has cooled down.");
    if (isReserved())
        return BraceletTexts::tr("A study uses the bracelet.");
    const core::BraceletTelemetry telemetry = session->source().telemetry();
    if (telemetry.board.supplyLow)
        return std::isfinite(telemetry.board.supply_V)
                   ? BraceletTexts::tr("The supply of the bracelet is low: %1 V.")
                         .arg(base::fixedDigits(telemetry.board.supply_V, 2))
                   : BraceletTexts::tr("The supply of the bracelet is low.");
    if (session->player().counters().framesRefused > 0)
        return BraceletTexts::tr("The bracelet refused what was played last: it did not understand it.");
    if (!calibration().measured())
        return BraceletTexts::tr("The motors are not calibrated (page Calibrate).");
    return {};
}

std::optional<chrome::DeviceReading> BraceletService::reading() const {
    if (choice() == BraceletChoice::none)
        return std::nullopt;
    chrome::DeviceReading reading;
    reading.name = BraceletTexts::tr("Bracelet");
    reading.state = core::DeviceState::connecting;
    const auto& session = m_session;
    if (!session)
        return reading;
    const core::DeviceStatus status = session->source().status();
    const std::int64_t now_ns = core::steadyNow_ns();
    reading.provenance = isSimulated() ? base::Provenance::simulated : base::Provenance::live;
    reading.state = state();
    reading.age_s = status.lastData_ns > 0 ? static_cast<double>(now_ns - status.lastData_ns) * 1e-9 : 0.0;
    reading.rate_Hz = status.rate_Hz;
    reading.lost = status.framesLost;
    reading.details = QString::fromStdString(status.message);
    if (reading.details.isEmpty()) {
        QStringList lines;
        if (status.framesRead > 0)
            lines = boardDetails(session->source());
        if (!calibration().measured())
            lines << BraceletTexts::tr("not calibrated: the motors are assumed");
        reading.details = lines.join(QLatin1Char('\n'));
    }
    reading.touchToSkin_s = newestTouchToSkin_s();
    return reading;
}

} // namespace teleta::console
