// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/keys/keys.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::core {

/// What every kind of Keys does with lists: of numbers, key = [1, 2], of rows of them, key = [[1, 2], [3,
/// 4]], and of texts, key = ["a", "b"]; apart from Keys, since few files have one. Thread: one.
class KeyLists {
public:
    KeyLists() = default;
    virtual ~KeyLists() = default;
    KeyLists(const KeyLists&) = delete;
    KeyLists& operator=(const KeyLists&) = delete;

    virtual void list(std::string_view key, std::vector<double>& values, const NumberRange& range,
                      const WholeRange& count, std::string_view about, Need need) = 0;
    virtual void rows(std::string_view key, std::vector<std::vector<double>>& values,
                      const NumberRange& range, std::size_t count, std::size_t perRow, std::string_view about,
                      Need need) = 0;
    virtual void texts(std::string_view key, std::vector<std::string>& values, std::string_view about,
                       Need need) = 0;
};

/// Describes a list of numbers, each in the range. count: how many there may be. One that is not given stays
/// as it is.
void describeList(Keys& keys, std::string_view key, std::vector<double>& values, const NumberRange& range,
                  const WholeRange& count, std::string_view about, Need need = Need::required);

/// Describes a list of so many rows (0: at least one) of so many numbers. One that is not given stays as it
/// is.
void describeRows(Keys& keys, std::string_view key, std::vector<std::vector<double>>& values,
                  const NumberRange& range, std::size_t count, std::size_t perRow, std::string_view about,
                  Need need = Need::required);

/// Describes a list of texts. One that is not given stays as it is.
void describeTexts(Keys& keys, std::string_view key, std::vector<std::string>& values, std::string_view about,
                   Need need = Need::required);

/// "a list of 1 to 15, each a number from 0 to 1", translated.
[[nodiscard]] std::string listText(const NumberRange& range, const WholeRange& count);

} // namespace teleta::core
