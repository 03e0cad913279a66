// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::test {

/// Whether a sanitizer watches. Then everything takes five to fifteen times as long, and errors of the kinds
/// that it looks for show in a few runs: the many that a statistic needs are left to the other builds.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

} // namespace teleta::test
