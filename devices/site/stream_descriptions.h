// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/recording/recording_types.h"

#include <string>
#include <vector>

namespace teleta::site_link {

/// What a site says of its streams: a JSON document that has for each what a recording has of it.
///   {"streams": [{"name": .., "kind": .., "type": .., "source": .., "shape": [..], "unit": ..,
///                 "columns": [{"name": .., "unit": ..}], "rate_hz": .., "details": ..}]}
/// Thread: any (pure).
[[nodiscard]] std::string describeStreams(const std::vector<recording::StreamInfo>& streams);

/// The inverse. A stream of a kind or type that is not known here, of a newer site, is left out. from: names
/// the site in errors. Error: badInput.
[[nodiscard]] core::Expected<std::vector<recording::StreamInfo>> readStreams(const std::string& text,
                                                                             const std::string& from);

/// Whether a stream has the pictures of a gel with markers, as pipeline::gelStream() describes it.
[[nodiscard]] bool isGel(const recording::StreamInfo& stream);
/// Whether it has those of such a gel at rest, as pipeline::gelReferenceStream() describes it.
[[nodiscard]] bool isGelAtRest(const recording::StreamInfo& stream);

/// The frame in which a stream's values are: the base of an arm's joints, the tip for a force at the wrist,
/// the link that bears an array. Empty: nobody knows. all: of the site.
[[nodiscard]] std::string frameOf(const recording::StreamInfo& stream,
                                  const std::vector<recording::StreamInfo>& all);

} // namespace teleta::site_link
