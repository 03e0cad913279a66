// SPDX-License-Identifier: GPL-3.0-or-later
// Replays inputs that fuzzing has found, and its seeds, through the same functions in every test run. A
// broken contract ends the program (fuzz_targets.h).
#include "tests/backend/core/temporary_folder.h"
#include "tests/fuzz/fuzz_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using teleta::fuzz::Input;
using teleta::fuzz::inputs;
using teleta::fuzz::targets;

namespace {

bool isAccepted(const Input& input) {
    const std::string bytes = teleta::test::readAll(input.path);
    return targets().at(input.target)({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

std::string nameOf(const testing::TestParamInfo<Input>& info) {
    return teleta::fuzz::nameOf(info.param);
}

class Seed : public testing::TestWithParam<Input> {};
class Regression : public testing::TestWithParam<Input> {};

} // namespace

TEST_P(Seed, isAcceptedSoThatFuzzingBeginsBehindTheFirstCheck) {
    EXPECT_TRUE(isAccepted(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Fuzzing, Seed, testing::ValuesIn(inputs("seed")), nameOf);

TEST_P(Regression, keepsTheContractOfItsParser) {
    (void)isAccepted(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Fuzzing, Regression, testing::ValuesIn(inputs("regression")), nameOf);

TEST(EveryParser, hasASeed) {
    const std::vector<Input> seeds = inputs("seed");
    for (const auto& [name, target] : targets())
        EXPECT_TRUE(std::any_of(seeds.begin(), seeds.end(), [&](const Input& seed) {
            return seed.target == name;
        })) << name;
}

TEST(EveryParser, refusesNothingAtAllAndNoise) {
    std::string noise;
    for (unsigned k = 0; k < 300; ++k)
        noise += static_cast<char>((k * 2654435761U) >> 24U);
    for (const auto& [name, target] : targets()) {
        for (const std::string& bytes : {std::string(), std::string(1, '\0'), noise}) {
            const bool accepted = target({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
            EXPECT_FALSE(accepted) << name << ", " << bytes.size() << " bytes";
        }
    }
}
