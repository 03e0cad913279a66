// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/random_stream.h"
#include "backend/study/methods/adaptive/psychometric_function.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace teleta::study {

/// A simulated observer who is right with the share that a function gives. Levels may be logarithms of those
/// of the function.
class Observer {
public:
    Observer(const PsychometricFunction& function, core::RandomStream& random)
        : m_function(function)
        , m_random(random) {}
    [[nodiscard]] bool answers(double level) { return m_random.uniform() < m_function.shareAt(level); }

private:
    PsychometricFunction m_function;
    core::RandomStream& m_random;
};

/// Mean and root mean square of errors.
struct Errors {
    double sum = 0.0;
    double squares = 0.0;
    std::size_t count = 0;
    void add(double error) {
        sum += error;
        squares += error * error;
        ++count;
    }
    [[nodiscard]] double bias() const { return sum / static_cast<double>(count); }
    [[nodiscard]] double rmse() const { return std::sqrt(squares / static_cast<double>(count)); }
};

} // namespace teleta::study
