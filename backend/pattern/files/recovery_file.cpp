// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/recovery_file.h"

#include "backend/core/data/json_document.h"
#include "backend/core/failure.h"
#include "backend/pattern/files/pattern_file.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace teleta::pattern {

namespace {

struct RecoveryText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

constexpr const char* kKey = "recovery";
constexpr long long kLatest_ms = 1LL << 53U; ///< a number of JSON is exact up to it

bool isRecovery(const std::pair<std::string, std::string>& unknown) {
    return unknown.first == kKey;
}

} // namespace

core::Expected<void> writeRecovery(const std::string& file, const RecoveredPattern& recovered) {
    Pattern pattern = recovered.pattern;
    std::erase_if(pattern.unknown, isRecovery);
    const nlohmann::ordered_json about{{"path", recovered.path}, {"edited_ms", recovered.edited_ms}};
    pattern.unknown.emplace_back(
        kKey, about.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return savePattern(pattern, file);
}

core::Expected<RecoveredPattern> readRecovery(const std::string& file) {
    core::Expected<Pattern> pattern = loadPattern(file);
    TELETA_CHECK(pattern);
    const auto found = std::ranges::find_if(pattern->unknown, isRecovery);
    if (found == pattern->unknown.end())
        return core::failed(core::ErrorKind::badInput, RecoveryText::tr("this is not a recovery file"),
                            RecoveryText::tr("the key \"recovery\""), {file, 0, 0});
    TELETA_TRY(const core::JsonDocument about, core::JsonDocument::parse(found->second, file));
    core::JsonReader reader(about);
    RecoveredPattern recovered;
    recovered.path = reader.text(reader.root(), "path", {});
    recovered.edited_ms = reader.integer(reader.member(reader.root(), "edited_ms"), 0, kLatest_ms);
    if (reader.error()) {
        core::Error error = *reader.error();
        error.where = {file, 0, 0}; // lines within the value are not lines of the file
        return core::Unexpected(std::move(error));
    }
    pattern->unknown.erase(found);
    recovered.pattern = std::move(*pattern);
    return recovered;
}

} // namespace teleta::pattern
