// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/touch_receipt.h"

#include "backend/contour/shape_recogniser.h"
#include "backend/core/data/csv_writer.h"
#include "backend/stiffness/material.h"

#include <cstdint>
#include <string_view>

namespace teleta::console {

namespace {

std::string_view recognisedIn(const pipeline::FeedbackSent& sent) {
    if (sent.shape)
        return contour::toString(*sent.shape);
    return sent.material ? stiffness::toString(*sent.material) : "unknown";
}

std::string_view outcomeOf(const TouchReceipt& receipt) {
    if (receipt.sent.patternId.empty())
        return "no_pattern";
    if (receipt.sent.missing)
        return "missing";
    if (receipt.sent.refused)
        return "refused";
    return receipt.onset_s ? "played" : "sent";
}

} // namespace

core::Expected<void> writeReceipts(const std::string& path, std::span<const TouchReceipt> receipts) {
    TELETA_TRY(auto file, core::CsvWriter::create(
                              path, "touch,recognised,pattern,outcome,read_ns,site_read_ns,clock_bound_s,"
                                    "arrived_s,evaluated_s,first_frame_s,felt_s"));
    for (const TouchReceipt& receipt : receipts) {
        std::optional<long long> siteRead_ns;
        if (receipt.clock)
            siteRead_ns = receipt.sent.felt_ns + receipt.clock->offset_ns;
        file.row(static_cast<long long>(receipt.sent.touch), recognisedIn(receipt.sent),
                 std::string_view(receipt.sent.patternId), outcomeOf(receipt),
                 static_cast<long long>(receipt.sent.felt_ns), siteRead_ns, receipt.clockBound_s(),
                 receipt.arrived_s(), receipt.evaluated_s(), receipt.begin_s, receipt.onset_s);
    }
    return file.finish();
}

} // namespace teleta::console
