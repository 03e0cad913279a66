// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/analysis/confusion_matrix.h"

#include <string>
#include <vector>

namespace teleta::study {

/// Tables 4 to 7 of the TeleTA paper: percentages as printed and the counts that they come from. Every row is
/// of 30 trials: 6 participants, 5 presentations.
struct PaperTable {
    std::string name;
    std::vector<std::vector<double>> percent;
    std::vector<std::vector<int>> counts;
};

inline const std::vector<PaperTable> kPaperTables = {
    {"Table 4, shape dynamic",
     {{100.0, 0, 0, 0, 0, 0},
      {0, 83.3, 13.3, 0, 0, 3.3},
      {0, 3.3, 96.7, 0, 0, 0},
      {3.3, 0, 0, 73.3, 10.0, 13.3},
      {3.3, 3.3, 3.3, 3.3, 86.7, 0},
      {0, 3.3, 0, 0, 3.3, 93.3}},
     {{30, 0, 0, 0, 0, 0},
      {0, 25, 4, 0, 0, 1},
      {0, 1, 29, 0, 0, 0},
      {1, 0, 0, 22, 3, 4},
      {1, 1, 1, 1, 26, 0},
      {0, 1, 0, 0, 1, 28}}},
    {"Table 5, shape static",
     {{60.0, 26.7, 6.7, 3.3, 3.3, 0},
      {33.3, 26.7, 26.7, 3.3, 10.0, 0},
      {10.0, 33.3, 43.3, 0, 13.3, 0},
      {0, 3.3, 6.7, 76.7, 10.0, 3.3},
      {0, 10.0, 20.0, 16.7, 53.3, 0},
      {0, 0, 0, 0, 3.3, 96.7}},
     {{18, 8, 2, 1, 1, 0},
      {10, 8, 8, 1, 3, 0},
      {3, 10, 13, 0, 4, 0},
      {0, 1, 2, 23, 3, 1},
      {0, 3, 6, 5, 16, 0},
      {0, 0, 0, 0, 1, 29}}},
    {"Table 6, stiffness dynamic",
     {{100.0, 0, 0, 0, 0},
      {0, 80.0, 13.3, 6.7, 0},
      {0, 16.7, 73.3, 10.0, 0},
      {0, 0, 20.0, 70.0, 10.0},
      {0, 0, 0, 3.3, 96.7}},
     {{30, 0, 0, 0, 0}, {0, 24, 4, 2, 0}, {0, 5, 22, 3, 0}, {0, 0, 6, 21, 3}, {0, 0, 0, 1, 29}}},
    {"Table 7, stiffness static",
     {{73.3, 20.0, 6.7, 0, 0},
      {13.3, 50.0, 16.7, 20.0, 0},
      {0, 16.7, 50.0, 20.0, 13.3},
      {0, 0, 23.3, 53.3, 23.3},
      {0, 0, 6.7, 23.3, 70.0}},
     {{22, 6, 2, 0, 0}, {4, 15, 5, 6, 0}, {0, 5, 15, 6, 4}, {0, 0, 7, 16, 7}, {0, 0, 2, 7, 21}}}};

inline ConfusionMatrix matrixOf(const std::vector<std::vector<int>>& counts) {
    ConfusionMatrix matrix(counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
        for (std::size_t j = 0; j < counts[i].size(); ++j)
            matrix.add(i, j, counts[i][j]);
    }
    return matrix;
}

} // namespace teleta::study
