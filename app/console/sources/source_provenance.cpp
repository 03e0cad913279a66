// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/source_provenance.h"

namespace teleta::console {

base::Provenance provenanceOf(const SourceManager::Item& item) {
    if (!item.isOpen())
        return base::Provenance::live;
    const pipeline::ChannelSummary summary = item.channel->summary();
    if (summary.simulated)
        return summary.recorded ? base::Provenance::recordedSimulation : base::Provenance::simulated;
    return summary.recorded  ? base::Provenance::recorded
           : summary.guarded ? base::Provenance::live
                             : base::Provenance::unguarded;
}

} // namespace teleta::console
