// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace teleta::pattern {

namespace {

constexpr std::array kEndings{std::pair{".json", PatternFormat::own},
                              std::pair{".hjif", PatternFormat::hjif},
                              std::pair{".haptic.zip", PatternFormat::hapticZip},
                              std::pair{".haptic", PatternFormat::haptic},
                              std::pair{".ahap.zip", PatternFormat::ahapZip},
                              std::pair{".ahap", PatternFormat::ahap},
                              std::pair{".tact", PatternFormat::tact},
                              std::pair{".csv", PatternFormat::csv},
                              std::pair{".wav", PatternFormat::wav}};

bool endsWith(std::string_view text, std::string_view ending) {
    return text.size() > ending.size() &&
           std::equal(ending.rbegin(), ending.rend(), text.rbegin(), [](char a, char b) {
               return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
           });
}

} // namespace

std::optional<PatternFormat> formatOf(std::string_view path) {
    for (const auto& [ending, format] : kEndings) {
        if (endsWith(path, ending))
            return format;
    }
    return std::nullopt;
}

bool isReadable(PatternFormat format) {
    return format != PatternFormat::csv && format != PatternFormat::wav;
}

std::string allEndings() {
    std::string all;
    for (const auto& [ending, format] : kEndings)
        all += (all.empty() ? "" : ", ") + std::string(ending);
    return all;
}

std::string baseName(std::string_view path) {
    std::string_view name = path.substr(path.find_last_of('/') + 1);
    for (const auto& [ending, format] : kEndings) {
        if (endsWith(name, ending))
            return std::string(name.substr(0, name.size() - std::string_view(ending).size()));
    }
    return std::string(name);
}

} // namespace teleta::pattern
