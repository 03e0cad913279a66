// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <dds/dds.h>
#include <memory>

namespace teleta::dds {

struct QosDeleter {
    void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
/// Qualities that are freed with their owner.
using Qos = std::unique_ptr<dds_qos_t, QosDeleter>;

} // namespace teleta::dds
