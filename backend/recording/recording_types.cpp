// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/recording_types.h"

#include "backend/core/words.h"

#include <functional>
#include <numeric>

namespace teleta::recording {

namespace {

constexpr core::Words<StreamKind, 9> kKinds{
    {"array", "features", "joints", "touches", "camera", "contacts", "tactors", "wrench", "numbers"}};
constexpr core::Words<ValueType, 3> kTypes{{"float32", "float64", "grey8"}};

} // namespace

const char* toString(StreamKind kind) {
    return kKinds.of(kind);
}

const char* toString(ValueType type) {
    return kTypes.of(type);
}

std::optional<StreamKind> streamKindOf(std::string_view word) {
    return kKinds.find(word);
}

std::optional<ValueType> valueTypeOf(std::string_view word) {
    return kTypes.find(word);
}

std::size_t StreamInfo::channels() const {
    if (type == ValueType::grey8)
        return 0;
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

} // namespace teleta::recording
