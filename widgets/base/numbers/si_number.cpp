// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/numbers/si_number.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace teleta::base {

SiNumber siNumber(double value) {
    constexpr std::array<char16_t, 9> kPrefixes{u'p', u'n', u'\u00b5', u'm', 0, u'k', u'M', u'G', u'T'};
    constexpr int kNoPrefix = 4;
    int index = kNoPrefix;
    double mantissa = value;
    while (std::abs(mantissa) >= 999.5 && index + 1 < static_cast<int>(kPrefixes.size())) {
        mantissa /= 1000.0;
        ++index;
    }
    while (mantissa != 0.0 && std::abs(mantissa) < 0.9995 && index > 0) {
        mantissa *= 1000.0;
        --index;
    }
    return {mantissa, kPrefixes[static_cast<std::size_t>(index)]};
}

int threeDigitDecimals(double value) {
    const double magnitude = std::abs(value);
    if (magnitude < 9.995)
        return 2;
    return magnitude < 99.95 ? 1 : 0;
}

} // namespace teleta::base
