// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/contact_outline.h"

#include <array>
#include <bit>
#include <cstddef>

namespace teleta::tactile {

namespace {

/// Directions, each a left turn from the one before.
enum Direction : unsigned { east, north, west, south };

struct Step {
    int column, row;
};
constexpr std::array<Step, 4> kStep{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

constexpr Direction leftOf(unsigned direction) {
    return static_cast<Direction>((direction + 1) % 4);
}

/// Border edges leaving each grid point of the box, one bit per direction.
class EdgeGrid {
public:
    EdgeGrid(std::span<const std::int32_t> labels, int columns, std::int32_t region, const TaxelBox& box)
        : m_box(box)
        , m_width(box.maxColumn - box.minColumn + 2)
        , m_leaving(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(box.maxRow - box.minRow + 2),
                    0) {
        const auto inside = [&](int row, int column) {
            return row >= box.minRow && row <= box.maxRow && column >= box.minColumn &&
                   column <= box.maxColumn &&
                   labels[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                          static_cast<std::size_t>(column)] == region;
        };
        for (int row = box.minRow; row <= box.maxRow; ++row)
            for (int column = box.minColumn; column <= box.maxColumn; ++column) {
                if (!inside(row, column))
                    continue;
                if (!inside(row - 1, column))
                    add(column, row, east);
                if (!inside(row, column + 1))
                    add(column + 1, row, north);
                if (!inside(row + 1, column))
                    add(column + 1, row + 1, west);
                if (!inside(row, column - 1))
                    add(column, row + 1, south);
            }
    }

    [[nodiscard]] std::uint8_t& at(int column, int row) {
        return m_leaving[static_cast<std::size_t>(row - m_box.minRow) * static_cast<std::size_t>(m_width) +
                         static_cast<std::size_t>(column - m_box.minColumn)];
    }

private:
    void add(int column, int row, Direction direction) {
        at(column, row) = static_cast<std::uint8_t>(at(column, row) | (1U << direction));
    }

    TaxelBox m_box;
    int m_width;
    std::vector<std::uint8_t> m_leaving;
};

OutlineLoop followLoop(EdgeGrid& edges, int column, int row) {
    OutlineLoop loop;
    const Step start{column, row};
    const auto first = static_cast<unsigned>(std::countr_zero(edges.at(column, row)));
    unsigned direction = first;
    const auto corner = [&](unsigned in, unsigned out) {
        const Step a = kStep[leftOf(in)];
        const Step b = kStep[leftOf(out)];
        loop.push_back({column, row, a.column + b.column, a.row + b.row});
    };
    for (;;) {
        std::uint8_t& leaving = edges.at(column, row);
        leaving = static_cast<std::uint8_t>(leaving & ~(1U << direction));
        column += kStep[direction].column;
        row += kStep[direction].row;
        if (column == start.column && row == start.row &&
            (edges.at(column, row) & (1U << leftOf(direction))) == 0)
            break;
        // Left turns first: where two taxels touch at a corner, this stays with the same one.
        const std::uint8_t next = edges.at(column, row);
        for (const unsigned turn : {1U, 0U, 3U}) {
            const unsigned candidate = (direction + turn) % 4;
            if ((next & (1U << candidate)) == 0)
                continue;
            if (candidate != direction)
                corner(direction, candidate);
            direction = candidate;
            break;
        }
    }
    if (direction != first)
        corner(direction, first);
    return loop;
}

} // namespace

std::vector<OutlineLoop> traceOutline(std::span<const std::int32_t> labels, int columns, std::int32_t region,
                                      const TaxelBox& box) {
    EdgeGrid edges(labels, columns, region, box);
    std::vector<OutlineLoop> loops;
    for (int row = box.minRow; row <= box.maxRow + 1; ++row)
        for (int column = box.minColumn; column <= box.maxColumn + 1; ++column)
            while (edges.at(column, row) != 0)
                loops.push_back(followLoop(edges, column, row));
    return loops;
}

} // namespace teleta::tactile
