// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/frame_parts.h"

#include "backend/frames/npz_writer.h"

#include <array>

namespace teleta::sweep {

void FrameParts::beginRun(std::uint64_t run, std::uint64_t cell, std::uint64_t seed,
                          const core::ArrayLayout& layout) {
    m_layout = layout;
    m_run = static_cast<std::int64_t>(run);
    m_cell = static_cast<std::int64_t>(cell);
    m_seed = static_cast<std::int64_t>(seed);
    m_before = {m_time_s.size(), m_values.size(), m_force_N.size()};
}

void FrameParts::add(const scene_run::LabelledFrame& frame) {
    m_values.insert(m_values.end(), frame.values.begin(), frame.values.end());
    m_runs.push_back(m_run);
    m_cells.push_back(m_cell);
    m_seeds.push_back(m_seed);
    m_time_s.push_back(frame.time_s);
    m_begin.push_back(static_cast<std::int64_t>(m_force_N.size()));
    for (const scene_run::ContactLabel& contact : frame.contacts) {
        m_place_m.insert(m_place_m.end(), {contact.x_m, contact.y_m});
        m_force_N.push_back(contact.force_N);
        m_normal.insert(m_normal.end(), contact.normal.begin(), contact.normal.end());
        m_object.push_back(contact.object);
        m_identity.push_back(contact.identity);
    }
}

void FrameParts::endRun(bool keep) {
    if (!keep)
        cutTo(m_before);
}

void FrameParts::cutTo(const Sizes& sizes) {
    m_values.resize(sizes.values);
    m_time_s.resize(sizes.frames);
    for (std::vector<std::int64_t>* column : {&m_runs, &m_cells, &m_seeds, &m_begin})
        column->resize(sizes.frames);
    m_force_N.resize(sizes.contacts);
    m_place_m.resize(2 * sizes.contacts);
    m_normal.resize(3 * sizes.contacts);
    for (std::vector<std::int64_t>* column : {&m_object, &m_identity})
        column->resize(sizes.contacts);
}

core::Expected<void> FrameParts::write(const std::string& path) {
    const std::uint64_t n = m_time_s.size();
    const std::uint64_t m = m_force_N.size();
    m_begin.push_back(static_cast<std::int64_t>(m));
    using frames::NpzArray;
    const auto whole = [](const std::vector<std::int64_t>& values) {
        return std::span<const std::int64_t>(values);
    };
    const auto real = [](const std::vector<double>& values) { return std::span<const double>(values); };
    const std::array layout{static_cast<std::int64_t>(m_layout.rows),
                            static_cast<std::int64_t>(m_layout.columns)};
    const std::array arrays{NpzArray("frames", {n, m_layout.taxels()}, std::span<const float>(m_values)),
                            NpzArray("run", {n}, whole(m_runs)),
                            NpzArray("cell", {n}, whole(m_cells)),
                            NpzArray("seed", {n}, whole(m_seeds)),
                            NpzArray("run_time_s", {n}, real(m_time_s)),
                            NpzArray("contact_begin", {n + 1}, whole(m_begin)),
                            NpzArray("contact_place_m", {m, 2}, real(m_place_m)),
                            NpzArray("contact_force_N", {m}, real(m_force_N)),
                            NpzArray("contact_normal", {m, 3}, real(m_normal)),
                            NpzArray("contact_object", {m}, whole(m_object)),
                            NpzArray("contact_identity", {m}, whole(m_identity)),
                            NpzArray("layout", {2}, std::span<const std::int64_t>(layout)),
                            NpzArray("pitch_m", {}, std::span<const double>(&m_layout.pitchX_m, 1))};
    TELETA_CHECK(frames::writeNpz(path, arrays));
    cutTo({});
    return {};
}

} // namespace teleta::sweep
