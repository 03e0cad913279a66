// SPDX-License-Identifier: GPL-3.0-or-later
// An operator who feels for what stands at three bearings, twice at each, in a process of his own: one
// process joins one domain.
//   loop_operator FILE
// At the end it prints what the console would show, a line of JSON.
#include "loop_place.h"
#include "operator_side.h"

#include <QCoreApplication>

#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>
#include <numbers>

using namespace teleta;
using nlohmann::json;
using test::OperatorSide;

namespace {

constexpr std::size_t kYaw = 2;
constexpr std::size_t kElbow = 3;
constexpr int kPresses = 2;
constexpr double kAbove_m = 0.001;
/// 5 kN/m pass the window of 0.03 Nm in 86 ms then; less than 75 ms would be refused.
constexpr double kApproach_mPerS = 0.0004;
constexpr double kDeepest_m = 0.008;
constexpr double kStill_s = 0.7;

/// False: nothing was felt there.
bool feel(OperatorSide& hand, double bearing_rad) {
    bool felt = hand.turnTo(kElbow, test::kLifted_rad, 0.1) && hand.turnTo(kYaw, bearing_rad, 0.15);
    for (int press = 0; felt && press < kPresses; ++press) {
        felt = hand.turnTo(kElbow, -kAbove_m / test::kPad_m, 0.05);
        hand.wait(kStill_s);
        const std::size_t before = hand.locatedTouches();
        const double from_rad = hand.angle(kElbow);
        felt = felt && hand.turn(kElbow, kApproach_mPerS / test::kPad_m, 60.0, [&] {
            return hand.locatedTouches() > before ||
                   (hand.angle(kElbow) - from_rad) * test::kPad_m > kDeepest_m;
        }) && hand.locatedTouches() > before;
    }
    return hand.turnTo(kElbow, test::kLifted_rad, 0.1) && felt;
}

json toJson(const pipeline::TouchRecord& touch) {
    json row{{"distance_m", touch.contactDistance_m}};
    if (touch.refusal)
        row["refusal"] = stiffness::toString(*touch.refusal);
    if (!touch.stiffness)
        return row;
    const stiffness::Stiffness& object = touch.stiffness->object;
    if (object.value_NPerM)
        row["value"] = *object.value_NPerM;
    if (object.lower95_NPerM)
        row["lower"] = *object.lower95_NPerM;
    if (object.upper95_NPerM)
        row["upper"] = *object.upper95_NPerM;
    row["reliable"] = touch.stiffness->reliable;
    row["warnings"] = json::array();
    for (const stiffness::TouchWarning warning : touch.stiffness->warnings)
        row["warnings"].push_back(stiffness::toString(warning));
    return row;
}

json report(const OperatorSide& hand, const std::vector<std::size_t>& bounds) {
    json told{{"places", json::array()}, {"objects", json::array()},  {"latency_s", json::array()},
              {"rests", json::array()},  {"presses", hand.presses()}, {"lost", hand.samplesLost()},
              {"clock_bound_s", 0.0},    {"clock_offset_s", 0.0},     {"not_located", 0}};
    std::size_t touch = 0;
    for (const std::size_t bound : bounds) {
        json place = json::array();
        for (; touch < bound; ++touch) {
            if (hand.touches()[touch].located)
                place.push_back(toJson(hand.touches()[touch]));
            else
                told["not_located"] = told["not_located"].get<int>() + 1;
        }
        told["places"].push_back(place);
    }
    for (const pipeline::FoundObject& object : hand.objects()) {
        told["objects"].push_back(
            {{"x_m", object.p_Base_Centre_m.x()},
             {"y_m", object.p_Base_Centre_m.y()},
             {"material", object.material ? json(stiffness::toString(*object.material)) : json()}});
    }
    for (const console::TouchReceipt& receipt : hand.receipts()) {
        if (!receipt.onset_s || !receipt.clock)
            continue;
        told["latency_s"].push_back(*receipt.onset_s);
        const double bound_s = 1e-9 * static_cast<double>(receipt.clock->bound_ns);
        const double offset_s = std::abs(1e-9 * static_cast<double>(receipt.clock->offset_ns));
        told["clock_bound_s"] = std::max(told["clock_bound_s"].get<double>(), bound_s);
        told["clock_offset_s"] = std::max(told["clock_offset_s"].get<double>(), offset_s);
    }
    for (const test::Rest& rest : hand.rests())
        told["rests"].push_back({rest.from_ns, rest.to_ns});
    return told;
}

int fail(const std::string& why) {
    std::cerr << "loop_operator: " << why << '\n';
    return 1;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2)
        return 2;
    const QCoreApplication application(count, arguments);
    OperatorSide hand(arguments[1]);
    if (!hand.opened())
        return fail("arm, pad or bracelet cannot be opened: " + hand.error());
    if (!hand.takeControl())
        return fail("control was not granted");
    std::vector<std::size_t> bounds;
    for (const double bearing_rad : test::kBearing_rad) {
        if (!feel(hand, bearing_rad))
            std::cerr << "loop_operator: nothing was felt at " << bearing_rad << " rad\n";
        bounds.push_back(hand.touches().size());
    }
    hand.wait(0.5);
    std::cout << report(hand, bounds) << std::endl;
    return 0;
}
