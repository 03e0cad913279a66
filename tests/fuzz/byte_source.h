// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/fuzz_targets.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

namespace teleta::fuzz {

/// Reads numbers from the bytes; zeros after their end. Thread: one.
class ByteSource {
public:
    explicit ByteSource(Bytes bytes)
        : m_bytes(bytes) {}

    [[nodiscard]] bool atEnd() const { return m_bytes.empty(); }
    template <typename Number>
    Number next() {
        Number number{};
        const std::size_t count = std::min(sizeof number, m_bytes.size());
        if (count > 0) // no bytes may have no address
            std::memcpy(&number, m_bytes.data(), count);
        m_bytes = m_bytes.subspan(count);
        return number;
    }
    std::vector<double> numbers(std::size_t count) {
        std::vector<double> values(count);
        for (double& value : values)
            value = next<double>();
        return values;
    }

private:
    Bytes m_bytes;
};

} // namespace teleta::fuzz
