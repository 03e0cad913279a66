// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/keys.h"
#include "devices/link/link_address.h"
#include "devices/taxels/frames/frame_format.h"
#include "devices/taxels/taxel_grid.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace teleta::taxels {

/// Times in ms; all > 0 unless 0 has a meaning.
struct TaxelsTimes {
    int connect_ms = 2000;    ///< TCP connection
    int lineSilence_ms = 200; ///< after this, the rest of a frame is not expected any more
    int stale_ms = 0;         ///< age of the newest frame that is stale; 0: core::staleAfter_ns of the rate
    int noFrames_ms = 2000;  ///< time without a good frame after which the sensor is lost; at least 5 periods
    int unusable_ms = 0;     ///< the same while frames come that cannot be used; 0: no other time
    int firstRetry_ms = 100; ///< wait before connecting again; doubles
    int longestRetry_ms = 2000; ///< up to this
};

/// An array of any make as a file describes it: how it is reached, what its frames look like, and where its
/// taxels are. The numbers of a frame are those of its grid: valuesOf(format) == grid.values().
struct TaxelsFile {
    std::string name;
    link::Address address;
    std::string greeting;            ///< sent when the link is open; empty: nothing
    std::string goodbye;             ///< sent before it is closed
    double rate_Hz = 0.0;            ///< frames a second that the sensor sends; 0: not known
    std::optional<double> threshold; ///< load from which a taxel counts as touched
    /// Frames at the opening whose median is what the unloaded array reads; 0: it reads nothing.
    int restFrames = 0;
    /// The last numbers of a frame are so many temperatures of chips, in degC.
    std::size_t temperatures = 0;
    std::string loads; ///< file with which loads in N follow from the signals; empty: none
    TaxelsTimes times{};
    FrameFormat format;
    TaxelGrid grid;

    void describeKeys(core::Keys& keys);
    /// The key "loads".
    void describeLoads(core::Keys& keys);

    /// The threshold, or 0.2 N.
    [[nodiscard]] double touchedFrom() const;
};

/// Whether a file of this kind describes an array: "taxels", "magnetometers" or "xela".
[[nodiscard]] bool isArrayKind(std::string_view kind);

/// Reads the description of an array, of kind "taxels", "magnetometers" or "xela"; paths of ports and files
/// in it start at its folder. path: a TOML file, or ":/devices/NAME.toml" for one that comes with the
/// program. Error: notFound, ioFailed, or badInput with line and column. Thread: any.
[[nodiscard]] core::Expected<TaxelsFile> readTaxels(const std::string& path);
[[nodiscard]] core::Expected<TaxelsFile> parseTaxels(std::string_view text, const std::string& file);

} // namespace teleta::taxels
