// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/wts/wts_device.h"

#include <algorithm>
#include <utility>

namespace teleta::wts {

namespace {

constexpr double kBitsPerByte = 10.0; // with start and stop bit

/// Highest frame rate that the delay and the serial line allow; 0 (unknown) when neither limits it. The
/// sensor may be slower.
double nominalRate_Hz(const WtsConfig& config, const MatrixInfo& matrix) {
    double period_s = config.delay_ms * 1e-3;
    if (const auto* serial = std::get_if<SerialAddress>(&config.address)) {
        const auto bytes =
            static_cast<double>(kHeaderBytes + kFrameHeaderBytes + 2 * matrix.cells() + kChecksumBytes);
        period_s = std::max(period_s, bytes * kBitsPerByte / serial->baud);
    }
    return period_s > 0.0 ? 1.0 / period_s : 0.0;
}

} // namespace

core::Expected<std::unique_ptr<WtsDevice>> WtsDevice::open(WtsConfig config) {
    TELETA_TRY(auto session, WtsSession::open(config, nullptr));
    const MatrixInfo& matrix = session.matrix();
    core::SourceDescription description{.name = displayName(config.address),
                                        .layout = {matrix.rows, matrix.columns, matrix.cellWidth_10um / 1e5},
                                        .unit = "counts",
                                        .nominalRate_Hz = nominalRate_Hz(config, matrix)};
    return std::unique_ptr<WtsDevice>(
        new WtsDevice(std::move(session), std::move(description), std::move(config)));
}

WtsDevice::WtsDevice(WtsSession session, core::SourceDescription description, WtsConfig config)
    : m_description(std::move(description))
    , m_matrix(session.matrix())
    , m_worker(std::move(session), m_description, std::move(config)) {
}

} // namespace teleta::wts
