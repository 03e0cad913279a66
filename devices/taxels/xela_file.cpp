// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/xela_file.h"

#include "devices/taxels/frame_keys.h"

#include <optional>
#include <string>

namespace teleta::taxels {

namespace {

using core::Need;
using core::NumberRange;

constexpr int kRawRestFrames = 50;

enum class Values { calibrated, raw };

} // namespace

void XelaFile::describeKeys(core::Keys& keys) {
    keys.word("kind", "xela", "A XELA uSkin behind its xela_server");
    keys.text("name", taxels.name, "Name on the screen");
    // One message has all sensors of a server. A sensor is looked for anew before this time.
    constexpr int kSilence_ms = 10'000;
    link::WebAddress server{.url = "ws://127.0.0.1:5000", .textsOnly = true, .shared_ms = kSilence_ms};
    describeWebAddress(keys, server.url, "Address of its server", Need::optional);
    taxels.address = server;
    int sensor = 1;
    keys.whole("sensor", sensor, {0, 1000}, "Number of the sensor, as the server names it", Need::optional);
    std::string model;
    keys.text("model", model, "Its model, as the server names it; otherwise the first one that it names",
              Need::optional);
    auto values = Values::calibrated;
    keys.choice("values", values,
                {{"calibrated", "Forces in N, which only some models have, and only when switched on"},
                 {"raw", "Raw numbers, which are not 0 without load"}},
                "Which values are read");
    keys.number("rate_Hz", taxels.rate_Hz, NumberRange::between(0.0, 1e5), "Messages a second; 0: not known",
                Need::optional);
    keys.number("threshold", taxels.threshold, NumberRange::positive(),
                "Load, or change of the raw number, above which a taxel counts as touched; otherwise 0.2 N");
    if (values == Values::raw && !taxels.threshold)
        refuseWithoutThreshold(keys);
    std::optional<int> restFrames;
    keys.whole(
        "rest_frames", restFrames, {0, 10'000},
        "Frames read at opening; their median becomes the tare; otherwise 50 of raw numbers, and none of "
        "forces");
    taxels.restFrames = restFrames.value_or(values == Values::raw ? kRawRestFrames : 0);
    taxels.describeLoads(keys);
    taxels.grid.setComponents(TaxelGrid::kMostComponents);
    taxels.grid.setUnit(values == Values::calibrated ? "N" : "counts");
    taxels.grid.describeAxes(keys);
    keys.table("layout", "Where the taxels are: no order or pitch of a model is public", Need::required,
               [this](core::Keys& table) { taxels.grid.describePlaces(table); });
    const std::string place = '/' + std::to_string(sensor);
    taxels.format = JsonFormat{.values = place + (values == Values::raw ? "/data" : "/calibrated"),
                               .time = "/time",
                               .otherTime = place + "/time",
                               .mayLackTime = true,
                               .sensor = JsonSensor{place, taxels.grid.taxels(), model},
                               .counter = "/message",
                               .hex = values == Values::raw,
                               .count = taxels.grid.values()};
    taxels.times.stale_ms = 1000;
    taxels.times.noFrames_ms = 3000;
    taxels.times.unusable_ms = 1000;
    taxels.times.firstRetry_ms = 500;
    taxels.times.longestRetry_ms = 5000;
}

} // namespace teleta::taxels
