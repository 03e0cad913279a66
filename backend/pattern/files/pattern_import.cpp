// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/pattern_import.h"

#include "backend/core/failure.h"
#include "backend/pattern/files/foreign_formats.h"

#include <QCoreApplication>

#include <array>
#include <string_view>
#include <utility>
#include <variant>

namespace teleta::pattern {

namespace {

struct ImportText {
    Q_DECLARE_TR_FUNCTIONS(PatternFile)
};

/// The number 1..6 at the end of a text, counted from 0; empty when there is none or it has more digits.
std::optional<std::size_t> tactorAtEnd(std::string_view text) {
    const std::size_t digits = text.find_last_not_of("0123456789") + 1;
    if (text.size() - digits != 1 || text[digits] < '1' || text[digits] > '6')
        return std::nullopt;
    return static_cast<std::size_t>(text[digits] - '1');
}

std::optional<std::size_t> tactorOfName(std::string_view name, std::string_view ending) {
    if (!name.ends_with(ending))
        return std::nullopt;
    name.remove_suffix(ending.size());
    return tactorAtEnd(name);
}

std::vector<std::size_t> allTactorIndices() {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < core::kTactors; ++i)
        all.push_back(i);
    return all;
}

} // namespace

void placeSignal(Pattern& pattern, const ImportOptions& options, const std::string& source,
                 LossCounter& losses) {
    std::vector<std::size_t> tactors = options.tactors;
    if (tactors.empty() && source.starts_with(kSourceTactor) && source.size() == kSourceTactor.size() + 1) {
        if (const std::optional<std::size_t> own = tactorAtEnd(source))
            tactors = {*own};
    }
    const bool isOwn = options.tactors.empty() && !tactors.empty(); // the file says where it belongs
    if (tactors.empty())
        tactors = allTactorIndices();
    const Track signal = std::exchange(pattern.tracks[0], {});
    std::vector<int> numbers;
    std::string list;
    for (const std::size_t tactor : tactors) {
        pattern.tracks[tactor] = signal;
        numbers.push_back(static_cast<int>(tactor));
        list += (list.empty() ? "" : ", ") + std::to_string(tactor + 1);
    }
    for (PatternObject& object : pattern.objects) {
        if (auto* ramp = std::get_if<Ramp>(&object.form))
            ramp->tactors = numbers;
    }
    if (!isOwn)
        losses.note(LossKind::oneSignal, tactors.size(), list);
}

core::Expected<PatternImport> importSignal(std::string text, const std::string& file,
                                           const ImportOptions& options, AddSignal add) {
    PatternImport result;
    result.oneSignal = true;
    LossCounter losses;
    TELETA_TRY(const std::string source, add(std::move(text), file, 0, result.pattern, losses));
    placeSignal(result.pattern, options, source, losses);
    result.losses = losses.take();
    return result;
}

core::Expected<PatternImport> importSignals(std::vector<ZipEntry> entries, const std::string& file,
                                            const std::string& ending, AddSignal add) {
    PatternImport result;
    LossCounter losses;
    std::array<bool, core::kTactors> taken{};
    for (ZipEntry& entry : entries) {
        const std::optional<std::size_t> tactor = tactorOfName(entry.name, ending);
        if (!tactor || taken[*tactor])
            return core::failed(
                core::ErrorKind::badInput,
                ImportText::tr("there is no tactor for the file \"%1\"")
                    .arg(QString::fromStdString(entry.name)),
                ImportText::tr("files tactor1%1 to tactor6%1, each once").arg(QString::fromStdString(ending)),
                {file, 0, 0});
        taken[*tactor] = true;
        losses.setWhere(entry.name);
        TELETA_CHECK(add(std::move(entry.content), file + '/' + entry.name, *tactor, result.pattern, losses));
    }
    result.losses = losses.take();
    return result;
}

} // namespace teleta::pattern
