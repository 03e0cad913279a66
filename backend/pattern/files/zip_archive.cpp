// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pattern/files/zip_archive.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <memory>
#include <utility>
#include <zip.h>

namespace teleta::pattern {

namespace {

struct ZipText {
    Q_DECLARE_TR_FUNCTIONS(ZipText)
};

struct DiscardArchive {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
    void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
struct FreeSource {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Archive = std::unique_ptr<zip_t, DiscardArchive>;
using Source = std::unique_ptr<zip_source_t, FreeSource>;

constexpr zip_uint16_t kDosDate =
    (46U << 9U) | (1U << 5U) | 1U; // 2026-01-01, so that equal entries give equal bytes

core::Unexpected bad(const std::string& file, const QString& message, const QString& expected) {
    return core::failed(core::ErrorKind::badInput, message, expected, {file, 0, 0});
}

core::Unexpected damaged(const std::string& file) {
    return bad(file, ZipText::tr("the zip archive is damaged"),
               ZipText::tr("a zip archive that is not encrypted"));
}

core::Unexpected notCreated() {
    return core::failed(core::ErrorKind::ioFailed, ZipText::tr("the zip archive could not be created"));
}

/// The archive takes ownership of the source when it opens.
Archive openArchive(Source& source, int flags) {
    zip_error_t error;
    zip_error_init(&error);
    Archive archive(zip_open_from_source(source.get(), flags, &error));
    zip_error_fini(&error);
    if (archive)
        (void)source.release();
    return archive;
}

} // namespace

core::Expected<std::vector<ZipEntry>> readZip(const std::string& bytes, const std::string& file) {
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr));
    const Archive archive = source ? openArchive(source, ZIP_RDONLY | ZIP_CHECKCONS) : Archive();
    if (!archive)
        return damaged(file);
    const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
    if (count <= 0)
        return damaged(file); // the library takes zero bytes for an empty archive
    if (count > static_cast<zip_int64_t>(kMostZipEntries))
        return bad(file, ZipText::tr("the zip archive has too many files"),
                   ZipText::tr("at most %1").arg(kMostZipEntries));
    std::vector<ZipEntry> entries;
    std::size_t total = 0;
    for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
        const char* name = zip_get_name(archive.get(), i, ZIP_FL_ENC_GUESS);
        const std::unique_ptr<zip_file_t, CloseEntry> entry(zip_fopen_index(archive.get(), i, 0));
        if (name == nullptr || !entry)
            return damaged(file);
        if (std::string_view(name).ends_with('/'))
            continue;
        ZipEntry read{name, {}};
        std::string block(1U << 16U, '\0');
        for (;;) {
            const zip_int64_t got = zip_fread(entry.get(), block.data(), block.size());
            if (got < 0)
                return damaged(file);
            if (got == 0)
                break;
            total += static_cast<std::size_t>(got);
            if (total > kMostZipBytes)
                return bad(file, ZipText::tr("the unpacked zip archive is too large"),
                           ZipText::tr("at most %1 MiB").arg(kMostZipBytes >> 20U));
            read.content.append(block, 0, static_cast<std::size_t>(got));
        }
        entries.push_back(std::move(read));
    }
    return entries;
}

core::Expected<std::string> writeZip(const std::vector<ZipEntry>& entries) {
    Source buffer(zip_source_buffer_create(nullptr, 0, 0, nullptr));
    if (!buffer)
        return notCreated();
    zip_source_keep(buffer.get()); // read below, after the archive has released it
    const Source kept(buffer.get());
    Archive archive = openArchive(buffer, ZIP_TRUNCATE);
    if (!archive)
        return notCreated();
    for (const ZipEntry& entry : entries) {
        Source content(zip_source_buffer(archive.get(), entry.content.data(), entry.content.size(), 0));
        const zip_int64_t index =
            content ? zip_file_add(archive.get(), entry.name.c_str(), content.get(), ZIP_FL_ENC_UTF_8) : -1;
        if (index < 0)
            return notCreated();
        (void)content.release();
        zip_file_set_dostime(archive.get(), static_cast<zip_uint64_t>(index), 0, kDosDate, 0);
    }
    if (zip_close(archive.get()) != 0)
        return notCreated();
    (void)archive.release();

    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_source_open(kept.get()) != 0 || zip_source_stat(kept.get(), &stat) != 0)
        return notCreated();
    std::string bytes(stat.size, '\0');
    const zip_int64_t got = zip_source_read(kept.get(), bytes.data(), bytes.size());
    zip_source_close(kept.get());
    if (got != static_cast<zip_int64_t>(bytes.size()))
        return notCreated();
    return bytes;
}

} // namespace teleta::pattern
