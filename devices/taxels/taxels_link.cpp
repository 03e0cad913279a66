// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/taxels_link.h"

#include "backend/core/steady_time.h"

namespace teleta::taxels {

core::Expected<link::ByteLink> openLink(const TaxelsFile& file, const link::WakePipe* wake) {
    TELETA_TRY(auto link, link::ByteLink::open(file.address,
                                               core::steadyNow_ns() + file.times.connect_ms * kMs_ns, wake));
    link.tell(file.greeting, wake);
    return link;
}

std::unique_ptr<FrameDecoder> makeDecoder(const FrameFormat& format, const link::ByteLink& link) {
    return makeDecoder(format,
                       link.isDatagrams() ? FrameDecoder::Framing::datagrams : FrameDecoder::Framing::stream);
}

FrameDecoder::Rest restOf(const link::ByteLink& link) {
    return link.ended() ? FrameDecoder::Rest::ended : FrameDecoder::Rest::willNotCome;
}

} // namespace teleta::taxels
