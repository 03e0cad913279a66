// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace teleta::core {

/// Which numbers a key accepts.
struct NumberRange {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool lowOpen = false; ///< low itself is not accepted
    bool allowNonFinite = false;
    const char* lowIs = nullptr; ///< what low is made from, when it depends on other keys

    [[nodiscard]] static constexpr NumberRange any() { return {}; }
    [[nodiscard]] static constexpr NumberRange anyOrNan() { return {.allowNonFinite = true}; }
    [[nodiscard]] static constexpr NumberRange positive() { return {.low = 0.0, .lowOpen = true}; }
    [[nodiscard]] static constexpr NumberRange notNegative() { return {.low = 0.0}; }
    [[nodiscard]] static constexpr NumberRange between(double low, double high) {
        return {.low = low, .high = high};
    }
    [[nodiscard]] static constexpr NumberRange positiveUpTo(double high) {
        return {.low = 0.0, .high = high, .lowOpen = true};
    }

    [[nodiscard]] bool accepts(double value) const;
    /// "a number above 0, at most 1", translated.
    [[nodiscard]] std::string text() const;
};

/// Which whole numbers a key accepts: low .. high inclusive.
struct WholeRange {
    long long low = 0;
    long long high = std::numeric_limits<long long>::max();
    const char* highIs = nullptr; ///< what high is made from, when it depends on other keys

    [[nodiscard]] bool accepts(long long value) const { return value >= low && value <= high; }
    /// "a whole number from 0 to 9", translated.
    [[nodiscard]] std::string text() const;
};

enum class Need {
    required,
    optional, ///< a value that is not given stays as it is
};

/// One of the names that a key accepts.
struct KeyName {
    KeyName(const char* known) // NOLINT(google-explicit-constructor): a list of names is a list of literals
        : name(known) {}
    KeyName(std::string_view known, std::string_view meaning)
        : name(known)
        , about(meaning) {}

    std::string_view name;
    std::string_view about; ///< what it stands for; may be empty
};
using KeyNames = std::vector<KeyName>;

/// The keys of a table in a file, described one after the other: name, where the value lies, what it accepts,
/// what it means. A type describes its keys once, in its member
///   void describeKeys(core::Keys& keys);
/// and each kind of Keys uses the descriptions: TomlKeys reads a file, KeyCheck checks a value that a program
/// made, KeyReference writes the handbook's page. So each range is written down once.
/// about: one English sentence without a full stop at its end. Thread: one.
class Keys {
public:
    Keys() = default;
    virtual ~Keys() = default;
    Keys(const Keys&) = delete;
    Keys& operator=(const Keys&) = delete;

    using Describe = std::function<void(Keys&)>;
    /// Describes the keys of one of several alternatives or tables.
    using DescribeAt = std::function<void(Keys&, std::size_t)>;

    virtual void number(std::string_view key, double& value, const NumberRange& range, std::string_view about,
                        Need need = Need::required) = 0;
    /// A table of numbers: key = { a = 1, b = 2 }.
    virtual void numbers(std::string_view key, std::span<const std::string_view> names,
                         std::span<double> values, const NumberRange& range, std::string_view about,
                         Need need = Need::required) = 0;
    /// An integer of any type.
    template <typename Integer>
    void whole(std::string_view key, Integer& value, const WholeRange& range, std::string_view about,
               Need need = Need::required) {
        auto number = static_cast<long long>(value);
        wholeNumber(key, number, range, about, need);
        value = static_cast<Integer>(number);
    }
    /// One that need not be given and has no stand-in.
    template <typename Integer>
    void whole(std::string_view key, std::optional<Integer>& value, const WholeRange& range,
               std::string_view about) {
        if (isThere(key, value.has_value()))
            whole(key, value ? *value : value.emplace(), range, about, Need::optional);
    }
    void number(std::string_view key, std::optional<double>& value, const NumberRange& range,
                std::string_view about) {
        if (isThere(key, value.has_value()))
            number(key, value ? *value : value.emplace(), range, about, Need::optional);
    }
    /// true or false; never required.
    virtual void flag(std::string_view key, bool& value, std::string_view about) = 0;
    /// Text that is not empty.
    virtual void text(std::string_view key, std::string& value, std::string_view about,
                      Need need = Need::required) = 0;
    /// One of the names; value: an enumeration in their order.
    template <typename Enumeration>
    void choice(std::string_view key, Enumeration& value, const KeyNames& names, std::string_view about,
                Need need = Need::required) {
        choose(key, static_cast<std::size_t>(value), names, about, need,
               [&value](Keys&, std::size_t chosen) { value = static_cast<Enumeration>(chosen); });
    }
    /// A text that is always the same: the kind of a file.
    void word(std::string_view key, const char* text, std::string_view about) {
        choose(key, 0, {text}, about, Need::required, [](Keys&, std::size_t) {});
    }
    /// One of the names, on which the keys that follow depend: describe(keys, index) describes those of one
    /// name.
    virtual void choose(std::string_view key, std::size_t value, const KeyNames& names,
                        std::string_view about, Need need, const DescribeAt& describe) = 0;
    /// One of the alternatives, whose names stand in their order, and the keys that it has.
    template <typename... Alternatives>
    void variant(std::string_view key, std::variant<Alternatives...>& value, const KeyNames& names,
                 std::string_view about) {
        choose(key, value.index(), names, about, Need::required, [&value](Keys& keys, std::size_t chosen) {
            select(value, chosen, std::index_sequence_for<Alternatives...>());
            std::visit([&keys](auto& alternative) { alternative.describeKeys(keys); }, value);
        });
    }

    /// A table in the table.
    virtual void table(std::string_view key, std::string_view about, Need need, const Describe& describe) = 0;
    template <typename T>
    void table(std::string_view key, T& value, std::string_view about, Need need = Need::required) {
        table(key, about, need, [&value](Keys& keys) { value.describeKeys(keys); });
    }
    /// One that need not be there: describe(keys, value) describes the keys of its value.
    template <typename T, typename DescribeOne>
    void table(std::string_view key, std::optional<T>& value, std::string_view about, DescribeOne describe) {
        if (!isThere(key, value.has_value()))
            return;
        if (!value)
            value.emplace();
        table(key, about, Need::optional, [&value, describe](Keys& keys) { describe(keys, *value); });
    }
    template <typename T>
    void table(std::string_view key, std::optional<T>& value, std::string_view about) {
        table(key, value, about, [](Keys& keys, T& known) { known.describeKeys(keys); });
    }

    /// A list of at least `minimum` tables: describe(keys, values, index) describes one.
    template <typename T, typename DescribeOne>
    void tables(std::string_view key, std::vector<T>& values, std::size_t minimum, std::string_view about,
                DescribeOne describe) {
        tableList(
            key, minimum, about, values.size(), [&values](std::size_t count) { values.resize(count); },
            [&values, describe](Keys& keys, std::size_t i) { describe(keys, values, i); });
    }
    template <typename T>
    void tables(std::string_view key, std::vector<T>& values, std::size_t minimum, std::string_view about) {
        tables(key, values, minimum, about,
               [](Keys& keys, std::vector<T>& known, std::size_t i) { known[i].describeKeys(keys); });
    }

    /// Exactly one of two keys may be given.
    virtual void oneOf(std::string_view first, std::string_view second, const std::string& message,
                       const std::string& expected) = 0;
    /// Says that the value of a key does not go with the others, in translated words.
    virtual void refuse(std::string_view key, const std::string& message, const std::string& expected) = 0;

protected:
    virtual void wholeNumber(std::string_view key, long long& value, const WholeRange& range,
                             std::string_view about, Need need) = 0;
    virtual void tableList(std::string_view key, std::size_t minimum, std::string_view about,
                           std::size_t count, const std::function<void(std::size_t)>& resize,
                           const DescribeAt& describe) = 0;
    /// Whether to describe a table that need not be there; known: the value has it.
    [[nodiscard]] virtual bool isThere(std::string_view key, bool known) = 0;

private:
    template <typename Variant, std::size_t... I>
    static void select(Variant& value, std::size_t chosen, std::index_sequence<I...>) {
        (void)((I == chosen && value.index() != I ? (value.template emplace<I>(), true) : false) || ...);
    }
};

} // namespace teleta::core
