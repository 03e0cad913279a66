// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/joint_state_joiner.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/support/floating_point_traps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace teleta::fuzz {

namespace {

/// Reads numbers from the bytes; zeros after their end.
class Source {
public:
    explicit Source(Bytes bytes)
        : m_bytes(bytes) {}

    [[nodiscard]] bool atEnd() const { return m_bytes.empty(); }
    template <typename Number>
    Number next() {
        Number number{};
        const std::size_t count = std::min(sizeof number, m_bytes.size());
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

} // namespace

bool rosJointStates(Bytes bytes) {
    const test::FloatingPointTraps traps;
    ros::JointStateJoiner joiner({"a", "b", "c"}, 0.1);
    Source source(bytes);
    bool joined = false;
    std::uint64_t messages = 0;
    std::size_t unknownNames = 0;
    std::int64_t now_ns = 0;
    while (!source.atEnd()) {
        now_ns += std::int64_t{source.next<std::uint8_t>()} * 1'000'000;
        ros::JointState message{};
        message.header.stamp = {source.next<std::int32_t>(), source.next<std::uint32_t>()};
        // Names of one character, the third joint's among them; an empty one is a null pointer.
        std::vector<std::array<char, 2>> names(source.next<std::uint8_t>() % 8U);
        std::vector<char*> pointers;
        for (std::array<char, 2>& name : names) {
            name = {source.next<char>(), '\0'};
            pointers.push_back(name[0] == '\0' ? nullptr : name.data());
        }
        // 0: as many as names, 1: none, 2: one too many.
        const auto sizes = source.next<std::uint8_t>();
        const auto count = [&](unsigned shift) -> std::size_t {
            const unsigned kind = (unsigned{sizes} >> shift) & 3U;
            return kind == 0 ? names.size() : kind == 1 ? 0 : names.size() + 1;
        };
        std::vector<double> position = source.numbers(count(0));
        std::vector<double> velocity = source.numbers(count(2));
        std::vector<double> effort = source.numbers(count(4));
        ros::lend(message.name, std::span(pointers));
        ros::lend(message.position, std::span(position));
        ros::lend(message.velocity, std::span(velocity));
        ros::lend(message.effort, std::span(effort));

        const std::optional<ros::JoinedJoints> sample = joiner.take(message, now_ns);
        ++messages;
        unknownNames += joiner.takeUnknownNames().size();
        require(sample.has_value() <= joiner.missing(now_ns).empty(), "a sample misses no joint");
        if (!sample)
            continue;
        joined = true;
        require(sample->position.size() == 3, "a sample has all joints");
        for (const core::JointVector* values : {&sample->position, &sample->velocity, &sample->effort}) {
            require(values->empty() || values->size() == 3, "values are told for all joints or for none");
            require(std::ranges::all_of(*values, [](double value) { return std::isfinite(value); }),
                    "a sample is finite");
        }
    }
    require(joiner.counters().messages == messages, "every message is counted");
    require(joiner.counters().malformed <= messages, "a message is malformed once");
    require(unknownNames <= ros::JointStateJoiner::kMostUnknownNames, "few unknown names are remembered");
    return joined;
}

} // namespace teleta::fuzz
