// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/trial_order.h"

#include "backend/core/random_stream.h"

#include <span>

namespace teleta::study {

const char* toString(OrderMethod method) {
    return method == OrderMethod::fullRandom ? "full_random" : "blocked_random";
}

std::vector<std::size_t> trialOrder(OrderMethod method, std::size_t patterns, std::size_t repetitions,
                                    std::uint64_t seed) {
    std::vector<std::size_t> order(patterns * repetitions);
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i % patterns;
    core::RandomStream random(seed);
    const std::span<std::size_t> all(order);
    if (method == OrderMethod::fullRandom) {
        random.shuffle(all);
    } else {
        for (std::size_t repetition = 0; repetition < repetitions; ++repetition)
            random.shuffle(all.subspan(repetition * patterns, patterns));
    }
    return order;
}

std::vector<std::vector<std::size_t>> williamsSquare(std::size_t conditions) {
    std::vector<std::size_t> first(conditions);
    for (std::size_t i = 0; i < conditions; ++i)
        first[i] = i % 2 == 1 ? (i + 1) / 2 : (conditions - i / 2) % conditions;
    std::vector<std::vector<std::size_t>> rows;
    for (std::size_t shift = 0; shift < conditions; ++shift) {
        std::vector<std::size_t> row(conditions);
        for (std::size_t i = 0; i < conditions; ++i)
            row[i] = (first[i] + shift) % conditions;
        rows.push_back(std::move(row));
    }
    if (conditions % 2 == 1 && conditions > 1) {
        for (std::size_t i = 0; i < conditions; ++i)
            rows.emplace_back(rows[i].rbegin(), rows[i].rend());
    }
    return rows;
}

std::uint64_t derivedSeed(std::uint64_t seed, std::uint64_t part) {
    std::uint64_t z = seed + (part + 1) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

} // namespace teleta::study
