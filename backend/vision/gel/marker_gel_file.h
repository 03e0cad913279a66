// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/keys/keys.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::vision {

enum class GelChannel { grey, red, green, blue };
enum class MarkerPolarity { dark, bright };
enum class MarkerGrid { rectangular, hexagonal, free };

/// A flat gel with markers, watched by a camera, as a TOML file of kind = "marker_gel" describes it.
struct MarkerGelFile {
    std::string name = "gel";
    std::string source; ///< as of a camera: its number, a video or a pattern of images; empty: none
    int width_px = 0;   ///< asked of a camera; 0: its own
    int height_px = 0;
    std::vector<double>
        crop;           ///< x, y, width, height in whole pixels of the camera's picture; empty: all of it
    bool flipX = false; ///< left and right are exchanged, after the crop
    bool flipY = false;
    double rate_Hz = 0.0; ///< asked of a camera; 0: its own
    GelChannel channel = GelChannel::grey;
    MarkerPolarity polarity = MarkerPolarity::dark;
    double diameter_px = 0.0; ///< of a marker; 0: found from the picture
    MarkerGrid grid = MarkerGrid::free;
    int rows = 0; ///< of a rectangular grid
    int columns = 0;

    /// One of three: how a pixel of the cropped and flipped picture becomes a place on the gel's surface.
    struct Plane {
        std::optional<double> mmPerPx;
        std::vector<double> homography; ///< pixel to m, row-major; 9 numbers or none
        std::optional<double> pitch_mm; ///< distance of neighbouring markers
    } plane;

    /// In pixels of the cropped and flipped picture; distortion as in OpenCV.
    struct Lens {
        double fx_px = 0.0, fy_px = 0.0, cx_px = 0.0, cy_px = 0.0;
        double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;
    };
    std::optional<Lens> lens;
    std::string loads; ///< file with which loads in N follow from contacts; empty: none

    void describeKeys(core::Keys& keys) { describeKeys(keys, core::Need::required); }
    void describeKeys(core::Keys& keys, core::Need needOfPlane);
};

/// Error: notFound, badInput with file, line and column. Thread: any.
[[nodiscard]] core::Expected<MarkerGelFile> readMarkerGel(const std::string& path);
/// The same, where [plane] may be absent or empty: it is about to be found.
[[nodiscard]] core::Expected<MarkerGelFile> readMarkerGelWithoutPlane(const std::string& path);
[[nodiscard]] core::Expected<MarkerGelFile> parseMarkerGel(std::string_view text, const std::string& file);
/// As TOML, without `loads`, which parseMarkerGel() reads back. Thread: any (pure).
[[nodiscard]] std::string markerGelText(const MarkerGelFile& gel);

} // namespace teleta::vision
