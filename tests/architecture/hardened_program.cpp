// SPDX-License-Identifier: GPL-3.0-or-later
// Has something for each kind of hardening: arrays on the stack, calls that can be checked, and functions
// that can be called through pointers.
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <utility>

/// Copies a text over an array on the stack, which may be too short.
template <std::size_t N>
__attribute__((noinline)) int copied(const char* text) {
    char buffer[N + 8];
    std::strcpy(buffer, text);
    return std::printf("%s\n", buffer);
}

template <std::size_t... I>
constexpr std::array<int (*)(const char*), sizeof...(I)> functions(std::index_sequence<I...>) {
    return {copied<I>...};
}

int main(int count, char** arguments) {
    static constexpr auto kFunctions = functions(std::make_index_sequence<24>());
    return kFunctions[static_cast<std::size_t>(count) % kFunctions.size()](arguments[0]) < 0 ? 1 : 0;
}
