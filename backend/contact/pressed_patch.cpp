// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/pressed_patch.h"

#include <algorithm>
#include <cmath>

namespace teleta::contact {

std::optional<PressedPatch> pressedPatch(std::span<const float> loads_N) {
    if (loads_N.empty())
        return std::nullopt;
    const auto highest = std::ranges::max_element(loads_N);
    const double peak_N = static_cast<double>(*highest);
    if (!(peak_N > 0.0) || !std::isfinite(peak_N))
        return std::nullopt;
    const int size = static_cast<int>(loads_N.size());
    const int top = static_cast<int>(highest - loads_N.begin());
    // Shares of the peak, so that all numbers are of order one.
    const auto share = [&](int i) {
        return i < 0 || i >= size ? 0.0 : static_cast<double>(loads_N[static_cast<std::size_t>(i)]) / peak_N;
    };
    double total = 0.0;
    for (int i = 0; i < size; ++i)
        total += share(i) * share(i);

    // For each set of wholly covered taxels with the top among them the best load is their mean, and the two
    // neighbours are explained wholly. What remains is the scatter of the set and all beyond the neighbours.
    constexpr double kRounding = 1e-12;
    PressedPatch best;
    double least = total * 2.0;
    double sumBefore = 0.0;
    double squaresBefore = 0.0;
    for (int first = top; first >= 0; --first) {
        sumBefore += share(first);
        squaresBefore += share(first) * share(first);
        double sum = sumBefore;
        double squares = squaresBefore;
        for (int last = top; last < size; ++last) {
            if (last > top) {
                sum += share(last);
                squares += share(last) * share(last);
            }
            const int covered = last - first + 1;
            const double load = sum / covered;
            const double before = share(first - 1);
            const double after = share(last + 1);
            if (before >= load || after >= load)
                continue;
            const double scatter = squares - sum * load;
            const double beyond = total - squares - before * before - after * after;
            const double left = std::max(0.0, scatter) + std::max(0.0, beyond);
            if (left > least - kRounding * total)
                continue;
            least = left;
            best.centre = 0.5 * (first + last) + 0.5 * (after - before) / load;
            best.load_N = load * peak_N;
            best.first = first;
            best.last = last;
            best.before = before / load;
            best.after = after / load;
            best.misfit_N = peak_N * std::sqrt(left / std::max(1, covered - 1));
        }
    }
    return best;
}

double PressedPatch::centreSe(double noise_N) const {
    const int covered = last - first + 1;
    const double s = std::max(noise_N, misfit_N) / load_N;
    const double skew = after - before;
    double narrow = 0.0;
    if (covered == 1 && std::min(before, after) * load_N <= 2.0 * noise_N)
        narrow = (0.5 - 0.5 * std::abs(skew)) / std::sqrt(3.0);
    return std::sqrt(0.25 * s * s * (2.0 + skew * skew / covered) + kShapeSe * kShapeSe + narrow * narrow);
}

} // namespace teleta::contact
