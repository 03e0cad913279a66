// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/shear_load.h"
#include "backend/core/data/array_layout.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace teleta::contact {

/// One contact region of a frame, in the sensor frame {s}.
struct Contact {
    int id = 0;       ///< stable from frame to frame, counts from 1; 0 before tracking
    int region = 0;   ///< value of its taxels in the label image; counts from 1
    double x_m = 0.0; ///< load-weighted centroid, TeleTA eq. (1)
    double y_m = 0.0;
    double force_N = 0.0;
    double peak_N = 0.0;
    double area_m2 = 0.0;
    int taxels = 0;
    int minRow = 0, maxRow = 0, minColumn = 0, maxColumn = 0; ///< bounding box, inclusive
    std::optional<ShearLoad> shear{};                         ///< of frames of vectors
};

struct SegmentationSettings {
    double threshold_N = 0.2; ///< taxels below it belong to no contact; > 0
    double noiseHeight = 0.3; ///< h of the h-maxima, as a share of the frame's peak load, 0..1: a summit that
                              ///< rises less than this above its saddle to a higher summit is merged into
                              ///< that one. An edge oblique to the grid is a chain of summits that rise by up
                              ///< to 0.29; two balls that touch 3 taxels apart rise by 0.4
    double noiseHeight_N = 0.0; ///< the same in N; the larger of the two applies
    int minimumTaxels = 1;      ///< smaller regions are dropped
};

/// Segments a frame into contacts by watershed. The load is flooded downwards from its maxima in one exact
/// pass (8-neighbourhood, union-find over the taxels sorted by load). Maxima lower than h are suppressed, so
/// that noise does not split a contact. A plateau is one region. The result does not depend on the unit of
/// load: loads of 1e-12 and 1e12 segment alike. Contacts are returned by falling force. Dead and non-finite
/// taxels belong to no region. Thread: one; allocates nothing after the first frames. Source: TeleTA section
/// 1, eq. (1); spec teleta.md section 1.
class ContactSegmenter {
public:
    explicit ContactSegmenter(const core::ArrayLayout& layout, const SegmentationSettings& settings = {});

    [[nodiscard]] std::span<Contact> segment(std::span<const float> load_N,
                                             std::span<const std::uint8_t> dead = {});
    /// Contact::region of each taxel of the last frame, row-major; 0: no contact.
    [[nodiscard]] std::span<const std::int32_t> labels() const { return m_labels; }

    void setSettings(const SegmentationSettings& settings) { m_settings = settings; }
    [[nodiscard]] const SegmentationSettings& settings() const { return m_settings; }

private:
    /// Consecutive active taxels [begin, end) of one row; later those of one basin.
    struct Run {
        std::int32_t begin = 0;
        std::int32_t end = 0;
        std::int32_t row = 0;
        std::int32_t basin = 0;
    };
    /// The taxels from which steepest ascent leads to one summit; after merging, the region of its highest
    /// summit.
    struct Basin {
        std::int32_t summit = 0; ///< taxel
        std::int32_t parent = 0; ///< basin into which it was merged, or itself
        std::int32_t region = 0;
        std::int32_t taxels = 0;
        std::int32_t minRow = 0, maxRow = 0, minColumn = 0, maxColumn = 0;
        double load = 0.0, loadX = 0.0, loadY = 0.0; ///< sums of load, load times column, load times row
    };

    void forgetLastFrame();
    void findActive(std::span<const float> load_N, std::span<const std::uint8_t> dead);
    void findRuns();
    void findAscents();
    [[nodiscard]] std::size_t placeOf(std::int32_t taxel, std::int32_t row) const;
    void climb();
    [[nodiscard]] std::int32_t climbFrom(std::int32_t taxel);
    void findPasses(double height_N);
    void addPasses(const Run& upper, const Run& lower, double height_N);
    void addPass(std::int32_t first, std::int32_t second, double height_N);
    void mergeOver(std::int32_t pass, double height_N);
    [[nodiscard]] std::int32_t rootOf(std::int32_t basin);
    [[nodiscard]] bool isHigher(std::int32_t taxel, std::int32_t other) const;
    void measure();
    void number();

    core::ArrayLayout m_layout;
    SegmentationSettings m_settings;
    std::vector<std::int32_t> m_labels;
    std::vector<Contact> m_contacts;

    const float* m_load = nullptr; ///< of the frame that is segmented; read where a taxel is active

    // Working memory, allocated once for the worst case. Keys and maxima have a border of zeros, see
    // placeOf(), and are 0 where no taxel is active: a frame undoes what it has written in the runs of the
    // last one.
    std::vector<std::uint8_t> m_active; ///< 0 or 255
    std::vector<double> m_key;          ///< orders taxels by falling load, then by index
    std::vector<double> m_rowMaximum;   ///< largest key of a taxel and its neighbours in the row
    std::vector<std::int32_t>
        m_ascent; ///< the highest of a taxel and its eight neighbours; where it is active
    std::vector<Run> m_runs,
        m_segments; ///< runs of active taxels; runs of one basin, from the last to the first
    std::vector<Basin> m_basins;
    std::vector<double> m_passes; ///< their keys
    std::vector<std::int32_t> m_order;
};

} // namespace teleta::contact
