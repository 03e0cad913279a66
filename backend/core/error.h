// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace teleta::core {

/// What kind of failure an Error reports; decides the exit code of the command line and the icon in the
/// console.
enum class ErrorKind {
    badInput,    ///< a file or a value is wrong; the place is in Error::where
    notFound,    ///< a file, a device or a name does not exist
    ioFailed,    ///< reading or writing failed
    refused,     ///< the request is well-formed but cannot be answered (degenerate data, unsafe)
    cancelled,   ///< the user stopped the work
    unavailable, ///< a device or a service is not there now
};

/// A place in an input file. line and column count from 1; 0 means unknown.
struct SourcePlace {
    std::string file;
    long long line = 0;
    long long column = 0;
};

/// One failure, ready to be shown: what happened, where, and what was expected.
/// Texts are UTF-8 and already translated.
struct Error {
    ErrorKind kind = ErrorKind::badInput;
    std::string message;  ///< what happened, a sentence without the place
    std::string expected; ///< what was expected instead; may be empty
    SourcePlace where;
};

/// "file:line:column: message (expected ...)", leaving out what is unknown.
[[nodiscard]] std::string describe(const Error& error);

template <typename T>
using Expected = tl::expected<T, Error>;

using Unexpected = tl::unexpected<Error>;

} // namespace teleta::core

#define TELETA_JOIN_NAMES(a, b) a##b
#define TELETA_UNIQUE_NAME(name, line) TELETA_JOIN_NAMES(name, line)

/// Evaluates the expression, an Expected. Returns its error from the enclosing function if it has one, and
/// otherwise declares a variable with its value:
///   TELETA_TRY(const Pattern pattern, loadPattern(path));
/// At most one a line. The enclosing function returns an Expected of any type.
#define TELETA_TRY(declaration, ...)                                                                         \
    auto TELETA_UNIQUE_NAME(tried_, __LINE__) = (__VA_ARGS__);                                               \
    if (!TELETA_UNIQUE_NAME(tried_, __LINE__))                                                               \
        return ::teleta::core::Unexpected(std::move(TELETA_UNIQUE_NAME(tried_, __LINE__)).error());          \
    declaration = *std::move(TELETA_UNIQUE_NAME(tried_, __LINE__))

/// Evaluates the expression, an Expected, and returns its error from the enclosing function if it has one:
///   TELETA_CHECK(savePattern(pattern, path));
#define TELETA_CHECK(...)                                                                                    \
    do {                                                                                                     \
        auto&& checked_ = (__VA_ARGS__);                                                                     \
        if (!checked_)                                                                                       \
            return ::teleta::core::Unexpected(checked_.error());                                             \
    } while (false)
