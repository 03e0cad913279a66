// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/recorded/recorded_layout.h"

#include "backend/core/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace teleta::pipeline {

using nlohmann::ordered_json;

namespace {

/// Three numbers.
std::array<double, 3> readVector(core::JsonReader& reader, const ordered_json& json, double most) {
    std::array<double, 3> values{};
    const ordered_json& list = reader.array(json, 3, 3);
    for (std::size_t i = 0; i < values.size() && i < list.size(); ++i)
        values[i] = reader.number(list[i], -most, most);
    return values;
}

/// Nothing: there are places that are the same, or a normal that is not of length 1.
std::optional<std::vector<core::TaxelPlace>> readPlaces(core::JsonReader& reader, std::size_t taxels) {
    constexpr double kFurthest_m = 10.0;
    constexpr double kOffUnit = 1e-6;
    std::vector<core::TaxelPlace> places;
    for (const ordered_json& each :
         reader.array(reader.member(reader.root(), "positions_m"), taxels, taxels)) {
        const std::array<double, 3> place_m = readVector(reader, each, kFurthest_m);
        places.push_back({place_m[0], place_m[1], place_m[2]});
    }
    if (const ordered_json* normals = reader.find(reader.root(), "normals")) {
        const ordered_json& list = reader.array(*normals, taxels, taxels);
        for (std::size_t i = 0; i < places.size() && i < list.size(); ++i) {
            places[i].normal = readVector(reader, list[i], 1.0);
            const auto& [x, y, z] = places[i].normal;
            if (std::abs(x * x + y * y + z * z - 1.0) > kOffUnit)
                return std::nullopt;
        }
    }
    if (reader.error() || core::TaxelPlaces::sameOf(places))
        return std::nullopt;
    return places;
}

core::ArrayLayout readGrid(core::JsonReader& reader, const std::vector<std::size_t>& shape, bool isVector) {
    constexpr long long kSide = core::ArrayLayout::kMaximumSide;
    const ordered_json& root = reader.root();
    core::ArrayLayout grid;
    if (isVector) {
        grid.rows = static_cast<int>(reader.integer(reader.member(root, "rows"), 1, kSide));
        grid.columns = static_cast<int>(reader.integer(reader.member(root, "columns"), 1, kSide));
    } else {
        grid.rows = static_cast<int>(shape[0]);
        grid.columns = static_cast<int>(shape[1]);
    }
    const bool isSquare = reader.find(root, "pitch_x_m") == nullptr;
    grid.pitchX_m = reader.number(reader.member(root, isSquare ? "pitch_m" : "pitch_x_m"), 1e-9, 1e3);
    grid.pitchY_m = isSquare ? grid.pitchX_m : reader.number(reader.member(root, "pitch_y_m"), 1e-9, 1e3);
    return grid;
}

} // namespace

std::vector<std::size_t> shapeOf(const core::TaxelLayout& layout) {
    if (layout.isVector())
        return {layout.taxels(), core::TaxelLayout::kVector};
    if (!layout.isGrid())
        return {layout.taxels()};
    return {static_cast<std::size_t>(layout.grid().rows), static_cast<std::size_t>(layout.grid().columns)};
}

std::vector<recording::Column> componentColumns(const core::TaxelLayout& layout, const std::string& unit) {
    std::vector<recording::Column> columns;
    if (!layout.isVector())
        return columns;
    for (std::size_t taxel = 0; taxel < layout.taxels(); ++taxel)
        for (const char* axis : {"_x", "_y", "_z"})
            columns.push_back({std::string("t").append(core::NumberText(taxel).view()).append(axis), unit});
    return columns;
}

ordered_json layoutJson(const core::TaxelLayout& layout) {
    ordered_json json;
    if (layout.isVector())
        json["components"] = layout.components();
    if (!layout.isGrid()) {
        ordered_json positions = ordered_json::array();
        ordered_json normals = ordered_json::array();
        bool anyNormal = false;
        for (const core::TaxelPlace& place : layout.places()->all()) {
            positions.push_back({place.x_m, place.y_m, place.z_m});
            normals.push_back(place.normal);
            anyNormal = anyNormal || place.normal != core::TaxelPlace{}.normal;
        }
        json["positions_m"] = std::move(positions);
        if (anyNormal)
            json["normals"] = std::move(normals);
        return json;
    }
    // Older versions know "pitch_m" alone, and refuse what is no grid of loads on squares.
    const core::ArrayLayout& grid = layout.grid();
    if (layout.isVector())
        json.update({{"rows", grid.rows}, {"columns", grid.columns}});
    if (!layout.isVector() && grid.pitchX_m == grid.pitchY_m)
        json["pitch_m"] = grid.pitchX_m;
    else
        json.update({{"pitch_x_m", grid.pitchX_m}, {"pitch_y_m", grid.pitchY_m}});
    if (!layout.absent().empty()) {
        ordered_json mask = ordered_json::array();
        for (std::size_t i = 0; i < layout.taxels(); ++i)
            if (layout.isAbsent(i))
                mask.push_back(i);
        json["mask"] = std::move(mask);
    }
    return json;
}

std::optional<core::TaxelLayout> readLayout(core::JsonReader& reader, const std::vector<std::size_t>& shape) {
    constexpr std::size_t kSide = core::ArrayLayout::kMaximumSide;
    const ordered_json& root = reader.root();
    const bool isPlaces = reader.find(root, "positions_m") != nullptr;
    const double told = reader.number(root, "components", 1.0, core::TaxelLayout::kVector, 1.0);
    const bool isVector = told == core::TaxelLayout::kVector;
    if (!isVector && told != 1.0)
        return std::nullopt;
    if (shape.size() != (isVector || !isPlaces ? 2 : 1) || std::ranges::find(shape, 0) != shape.end())
        return std::nullopt;
    if (isVector && shape[1] != core::TaxelLayout::kVector)
        return std::nullopt;
    const int components = isVector ? core::TaxelLayout::kVector : 1;
    if (isPlaces) {
        if (shape[0] > core::TaxelPlaces::kMost)
            return std::nullopt;
        auto places = readPlaces(reader, shape[0]);
        if (!places)
            return std::nullopt;
        return core::TaxelLayout(std::make_shared<const core::TaxelPlaces>(std::move(*places)), components);
    }
    if (!isVector && (shape[0] > kSide || shape[1] > kSide))
        return std::nullopt;
    const core::ArrayLayout grid = readGrid(reader, shape, isVector);
    if (reader.error() || (isVector && grid.taxels() != shape[0]))
        return std::nullopt;
    core::TaxelLayout layout(grid, components);
    if (const ordered_json* mask = reader.find(root, "mask")) {
        std::vector<std::uint8_t> absent(grid.taxels(), 0);
        const auto last = static_cast<long long>(grid.taxels()) - 1;
        for (const ordered_json& place : reader.array(*mask, 0, grid.taxels()))
            absent[static_cast<std::size_t>(reader.integer(place, 0, last))] = 1;
        layout.setAbsent(std::move(absent));
    }
    return layout;
}

std::optional<core::TaxelLayout> layoutOf(const recording::StreamInfo& stream) {
    if (stream.kind != recording::StreamKind::array)
        return std::nullopt;
    const auto document = core::JsonDocument::parse(stream.details, {});
    if (!document)
        return std::nullopt;
    core::JsonReader reader(*document);
    auto layout = readLayout(reader, stream.shape);
    return reader.error() ? std::nullopt : layout;
}

} // namespace teleta::pipeline
