// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/gel/gel_contacts.h"
#include "backend/vision/gel/marker_gel.h"
#include "backend/vision/gel/marker_gel_file.h"

#include <opencv2/core.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace teleta::vision {

/// Follows a flat gel through a stream of pictures, from the first one on: collects those from which the
/// places at rest are found, follows the markers, makes contacts of their motion, and says in words what is
/// wrong. Takes pictures as MarkerGel::part() gives them. Thread: one.
class GelFollower {
public:
    explicit GelFollower(MarkerGelFile file)
        : m_file(std::move(file)) {}

    /// The next picture. time_s: rises.
    void next(const cv::Mat1b& part, double time_s);
    /// The gel at rest, from pictures taken earlier. Error: as MarkerGel::make(), or there are none; then the
    /// rest is as before, and problem() says so until one is taken.
    [[nodiscard]] core::Expected<void> setReference(std::span<const cv::Mat1b> parts);
    /// The next pictures show the gel with nothing touching it. Until there are enough, and they show it, the
    /// former rest holds.
    void renewReference();
    /// The next picture does not follow from the last one.
    void forget();

    [[nodiscard]] bool hasReference() const { return m_gel.has_value(); }
    /// How often the rest was taken.
    [[nodiscard]] std::size_t references() const { return m_references; }
    /// The pictures from which the rest was taken.
    [[nodiscard]] const std::vector<cv::Mat1b>& reference() const { return m_reference; }
    /// Pictures that are still to come before the rest can be taken; 0: none is being taken.
    [[nodiscard]] std::size_t missing() const {
        return m_collects ? MarkerGel::kReferencePictures - m_collected.size() : 0;
    }

    /// Undefined before there is a reference.
    [[nodiscard]] const MarkerGel& gel() const { return *m_gel; }
    /// Of the newest picture; empty when it could not be used.
    [[nodiscard]] const std::vector<GelContactState>& contacts() const { return m_contacts; }
    /// The markers were followed into the newest picture.
    [[nodiscard]] bool usable() const { return m_usable; }
    /// Of the newest picture.
    [[nodiscard]] const GelFaults& faults() const { return m_faults; }
    /// What is wrong with the newest picture, the gel or its rest; translated; empty: nothing.
    [[nodiscard]] const std::string& problem() const { return m_problem; }

private:
    /// A jump of light is told for so long.
    static constexpr double kTold_s = 3.0;

    [[nodiscard]] core::Expected<MarkerGel> made(std::span<const cv::Mat1b> parts) const;
    [[nodiscard]] cv::Mat1b withDarkMarkers(const cv::Mat1b& part) const;
    void take(MarkerGel gel, std::span<const cv::Mat1b> parts);
    void collect(const cv::Mat1b& part);
    void follow(const cv::Mat1b& part, double time_s);

    MarkerGelFile m_file;
    std::optional<MarkerGel> m_gel;
    GelContacts m_finder;
    std::vector<GelContactState> m_contacts;
    GelFaults m_faults;
    bool m_collects = true;
    std::vector<cv::Mat1b> m_collected;
    std::vector<cv::Mat1b> m_reference;
    std::size_t m_references = 0;
    bool m_usable = false;
    std::string m_whyNoReference; ///< of the last attempt
    std::string m_problem;
    double m_jumped_s = -std::numeric_limits<double>::infinity();
};

} // namespace teleta::vision
