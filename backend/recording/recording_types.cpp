// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/recording_types.h"

#include <functional>
#include <numeric>

namespace teleta::recording {

const char* toString(StreamKind kind) {
    switch (kind) {
    case StreamKind::array:
        return "array";
    case StreamKind::features:
        return "features";
    case StreamKind::joints:
        return "joints";
    case StreamKind::touches:
        return "touches";
    case StreamKind::camera:
        return "camera";
    case StreamKind::contacts:
        return "contacts";
    case StreamKind::tactors:
        return "tactors";
    }
    return "";
}

const char* toString(ValueType type) {
    switch (type) {
    case ValueType::float32:
        return "float32";
    case ValueType::float64:
        return "float64";
    case ValueType::grey8:
        return "grey8";
    }
    return "";
}

std::size_t StreamInfo::channels() const {
    if (type == ValueType::grey8)
        return 0;
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

} // namespace teleta::recording
