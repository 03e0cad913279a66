// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace teleta::python {

namespace py = pybind11;

/// An array that takes over the values: no copy, writable. values.size() is the product of the shape. Needs
/// the interpreter's lock.
template <typename T>
[[nodiscard]] py::array arrayOf(std::vector<T>&& values, std::vector<py::ssize_t> shape) {
    auto kept = std::make_unique<std::vector<T>>(std::move(values));
    T* const data = kept->data();
    const py::capsule owner(kept.get(), [](void* all) { delete static_cast<std::vector<T>*>(all); });
    kept.release();
    return py::array_t<T>(std::move(shape), data, owner);
}
template <typename T>
[[nodiscard]] py::array arrayOf(std::vector<T>&& values) {
    const auto count = static_cast<py::ssize_t>(values.size());
    return arrayOf(std::move(values), {count});
}

/// The same for memory that was allocated without a value.
template <typename T>
[[nodiscard]] py::array arrayOf(std::unique_ptr<T[]> values, std::vector<py::ssize_t> shape) {
    T* const data = values.get();
    const py::capsule owner(data, [](void* all) { delete[] static_cast<T*>(all); });
    values.release();
    return py::array_t<T>(std::move(shape), data, owner);
}

/// Words of at most kLength ASCII characters, for a column of text.
template <std::size_t kLength>
class WordColumn {
public:
    void reserve(std::size_t words) { m_words.reserve(words); }
    using Word = std::array<char32_t, kLength>; ///< as numpy keeps text; zeros fill the rest

    [[nodiscard]] static Word wordOf(std::string_view text) {
        Word word{};
        std::copy_n(text.begin(), std::min(text.size(), kLength), word.begin());
        return word;
    }
    void add(const Word& word) { m_words.push_back(word); }
    void add(std::string_view text) { add(wordOf(text)); }
    /// numpy's str_ array of them, one-dimensional. Needs the interpreter's lock.
    [[nodiscard]] py::array array() && {
        auto kept = std::make_unique<std::vector<Word>>(std::move(m_words));
        const auto count = static_cast<py::ssize_t>(kept->size());
        void* const data = kept->data();
        const py::capsule owner(kept.get(), [](void* all) { delete static_cast<std::vector<Word>*>(all); });
        kept.release();
        return py::array(py::dtype("U" + std::to_string(kLength)), {count}, {py::ssize_t(sizeof(Word))}, data,
                         owner);
    }

private:
    std::vector<Word> m_words;
};

/// NaN where there is no value.
[[nodiscard]] inline double orNaN(const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// A number, or None. Needs the interpreter's lock.
[[nodiscard]] inline py::object orNone(const std::optional<double>& value) {
    return value ? py::object(py::float_(*value)) : py::object(py::none());
}

} // namespace teleta::python
