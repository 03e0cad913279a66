// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/python/base/array_output.h"
#include "backend/contact/contact_segmenter.h"
#include "backend/contact/feature_batch.h"
#include "backend/contact/summit.h"
#include "backend/contact/tactile_features.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace teleta::python {

/// The columns of `teleta features` without the time, one entry a frame. arrays() and addTypes() need no
/// lock, the others the interpreter's.
class FeatureColumns {
public:
    static constexpr std::array<const char*, 10> kNumbers{
        "force_n",  "cop_x_m",  "cop_y_m",     "coc_x_m",    "coc_y_m",
        "dzmp_x_m", "dzmp_y_m", "alpha_z_rad", "lambda1_m2", "lambda2_m2"};

    explicit FeatureColumns(std::size_t frames)
        : m_frames(frames)
        , m_active(std::make_unique_for_overwrite<std::int64_t[]>(frames)) {
        for (auto& column : m_numbers)
            column = std::make_unique_for_overwrite<double[]>(frames);
        m_types.reserve(frames);
    }

    [[nodiscard]] static std::array<double, kNumbers.size()>
    numbersOf(const contact::TactileFeatures& features) {
        return {features.force_N,          orNaN(features.copX_m),     orNaN(features.copY_m),
                orNaN(features.cocX_m),    orNaN(features.cocY_m),     orNaN(features.dzmpX_m),
                orNaN(features.dzmpY_m),   orNaN(features.alphaZ_rad), orNaN(features.lambda1_m2),
                orNaN(features.lambda2_m2)};
    }

    /// Where the features of the frames from `first` on go, types and thresholds elsewhere.
    [[nodiscard]] contact::FeatureArrays arrays(std::size_t first, std::span<contact::ContactType> types,
                                                std::span<double> thresholds_N) {
        const auto column = [&](std::size_t i) {
            return std::span(m_numbers[i].get() + first, m_frames - first);
        };
        return {types,
                column(0),
                column(1),
                column(2),
                column(3),
                column(4),
                column(5),
                column(6),
                column(7),
                column(8),
                column(9),
                thresholds_N,
                {m_active.get() + first, m_frames - first}};
    }
    /// The types of the next frames; at most as many as the constructor was told.
    void addTypes(std::span<const contact::ContactType> types) {
        using contact::ContactType;
        const std::array words{m_types.wordOf(toString(ContactType::none)),
                               m_types.wordOf(toString(ContactType::point)),
                               m_types.wordOf(toString(ContactType::edge))};
        for (const ContactType type : types)
            m_types.add(words[static_cast<std::size_t>(type)]);
    }

    /// Adds the columns to a table.
    void moveTo(py::dict& table) && {
        const auto rows = static_cast<py::ssize_t>(m_frames);
        table["contact_type"] = std::move(m_types).array();
        for (std::size_t i = 0; i < kNumbers.size(); ++i)
            table[kNumbers[i]] = arrayOf(std::move(m_numbers[i]), {rows});
        table["active"] = arrayOf(std::move(m_active), {rows});
    }

private:
    std::size_t m_frames;
    WordColumn<5> m_types;
    std::array<std::unique_ptr<double[]>, kNumbers.size()> m_numbers;
    std::unique_ptr<std::int64_t[]> m_active;
};

/// The columns of `teleta contacts` behind the time, one entry a contact.
class ContactColumns {
public:
    void add(std::span<const contact::Contact> contacts) {
        for (const contact::Contact& contact : contacts) {
            m_ids.push_back(contact.id);
            m_x_m.push_back(contact.x_m);
            m_y_m.push_back(contact.y_m);
            m_force_N.push_back(contact.force_N);
            m_peak_N.push_back(contact.peak_N);
            m_area_m2.push_back(contact.area_m2);
        }
    }

    void moveTo(py::dict& table) && {
        table["contact_id"] = arrayOf(std::move(m_ids));
        table["x_m"] = arrayOf(std::move(m_x_m));
        table["y_m"] = arrayOf(std::move(m_y_m));
        table["force_n"] = arrayOf(std::move(m_force_N));
        table["peak_n"] = arrayOf(std::move(m_peak_N));
        table["area_m2"] = arrayOf(std::move(m_area_m2));
    }

private:
    std::vector<std::int64_t> m_ids;
    std::vector<double> m_x_m, m_y_m, m_force_N, m_peak_N, m_area_m2;
};

/// The columns of --summit, one entry a frame or a contact.
class SummitColumns {
public:
    void add(const std::optional<contact::Summit>& summit) {
        const contact::Summit found = summit.value_or(contact::Summit{});
        m_x_m.push_back(summit ? found.x_m : std::numeric_limits<double>::quiet_NaN());
        m_y_m.push_back(summit ? found.y_m : std::numeric_limits<double>::quiet_NaN());
        m_xSe_m.push_back(orNaN(found.xSe_m));
        m_ySe_m.push_back(orNaN(found.ySe_m));
    }

    void moveTo(py::dict& table) && {
        table["summit_x_m"] = arrayOf(std::move(m_x_m));
        table["summit_y_m"] = arrayOf(std::move(m_y_m));
        table["summit_x_se_m"] = arrayOf(std::move(m_xSe_m));
        table["summit_y_se_m"] = arrayOf(std::move(m_ySe_m));
    }

private:
    std::vector<double> m_x_m, m_y_m, m_xSe_m, m_ySe_m;
};

} // namespace teleta::python
