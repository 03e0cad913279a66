// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/store/pseudonym_key.h"

#include "backend/core/data/csv_reader.h"
#include "backend/core/data/csv_writer.h"
#include "backend/core/data/input_file.h"
#include "backend/core/data/private_files.h"
#include "backend/core/failure.h"
#include "backend/study/store/file_claim.h"
#include "backend/study/store/store_values.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <random>
#include <string_view>
#include <utility>

namespace teleta::study {

namespace {

struct KeyText {
    Q_DECLARE_TR_FUNCTIONS(PseudonymKey)
};

constexpr std::array<std::string_view, 4> kKeyColumns{"participant_id", "name", "note", "time_utc"};

/// Whether a path lies in a folder, through all links; the path itself need not be there.
bool liesIn(const std::string& path, const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path inner = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
    const fs::path outer = fs::weakly_canonical(fs::absolute(folder, ignored), ignored);
    const auto [in, out] = std::mismatch(inner.begin(), inner.end(), outer.begin(), outer.end());
    (void)in;
    // A folder that is written with a slash at its end has an empty last part.
    return out == outer.end() || out->empty();
}

/// Holds the file while it is read, changed and written.
core::Expected<std::unique_ptr<FileClaim>> heldKey(const std::string& path) {
    TELETA_TRY(std::unique_ptr<FileClaim> claim, FileClaim::take(path + ".lock", {}));
    if (claim == nullptr)
        return core::failed(core::ErrorKind::refused, KeyText::tr("another program changes the file"),
                            KeyText::tr("to try again in a moment"), {path});
    return claim;
}

} // namespace

core::Expected<PseudonymKey> PseudonymKey::open(const std::string& path, const std::string& studyFolder) {
    if (liesIn(path, studyFolder))
        return core::failed(
            core::ErrorKind::refused, KeyText::tr("the key of the pseudonyms lies in the study's folder"),
            KeyText::tr("a file apart from the data, which are copied and published"), {path});
    PseudonymKey key(path);
    TELETA_CHECK(key.read());
    return key;
}

core::Expected<void> PseudonymKey::read() {
    m_entries.clear();
    const core::Expected<void> isFile = core::requireFile(m_path);
    if (!isFile && isFile.error().kind == core::ErrorKind::notFound)
        return {};
    TELETA_CHECK(isFile);
    TELETA_TRY(core::CsvReader csv, core::CsvReader::open(m_path));
    TELETA_TRY(const std::vector<std::size_t> columns, csv.columns(kKeyColumns));
    std::vector<std::string_view> fields;
    for (;;) {
        TELETA_TRY(const bool any, csv.nextText(fields));
        if (!any)
            return {};
        const auto field = [&](std::size_t i) { return std::string(fields[columns[i]]); };
        const std::string note = field(2);
        m_entries.push_back({field(0), field(1), note == "NA" ? std::string() : note,
                             timeOf(QString::fromStdString(field(3)))});
        if (m_entries.back().pseudonym.empty())
            return core::failed(core::ErrorKind::badInput, KeyText::tr("a row has no participant"),
                                KeyText::tr("a participant of the study"), csv.place(columns[0]));
    }
}

core::Expected<void> PseudonymKey::write() const {
    const core::PrivateFiles forOwner;
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(m_path, kKeyColumns));
    for (const KeyEntry& entry : m_entries) {
        csv.text(entry.pseudonym);
        csv.text(entry.name);
        csv.text(entry.note.empty() ? "NA" : entry.note);
        csv.text(timeText(entry.time).toStdString());
        csv.endRow();
    }
    return csv.finish();
}

std::optional<KeyEntry> PseudonymKey::find(const std::string& pseudonym) const {
    const auto found = std::ranges::find(m_entries, pseudonym, &KeyEntry::pseudonym);
    return found == m_entries.end() ? std::nullopt : std::optional(*found);
}

core::Expected<void> PseudonymKey::add(const KeyEntry& entry) {
    TELETA_TRY(const auto held, heldKey(m_path));
    TELETA_CHECK(read());
    if (find(entry.pseudonym))
        return core::failed(core::ErrorKind::refused,
                            KeyText::tr("the key has a person for \"%1\" already")
                                .arg(QString::fromStdString(entry.pseudonym)),
                            KeyText::tr("another name"), {m_path});
    m_entries.push_back(entry);
    return write();
}

core::Expected<bool> PseudonymKey::remove(const std::string& pseudonym) {
    TELETA_TRY(const auto held, heldKey(m_path));
    TELETA_CHECK(read());
    if (std::erase_if(m_entries, [&](const KeyEntry& entry) { return entry.pseudonym == pseudonym; }) == 0)
        return false;
    TELETA_CHECK(write());
    return true;
}

std::string randomPseudonym(const std::vector<std::string>& taken) {
    // Without 0 and O, 1 and I and L, and U and V.
    static constexpr std::string_view kSigns = "23456789ABCDEFGHJKMNPQRSTWXYZ";
    constexpr int kLength = 5;
    std::random_device source;
    std::uniform_int_distribution<std::size_t> sign(0, kSigns.size() - 1);
    for (;;) {
        std::string pseudonym = "P";
        for (int i = 0; i < kLength; ++i)
            pseudonym += kSigns[sign(source)];
        if (std::ranges::find(taken, pseudonym) == taken.end())
            return pseudonym;
    }
}

} // namespace teleta::study
