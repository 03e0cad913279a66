// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/arrays/numpy_file.h"

#include "backend/core/failure.h"
#include "backend/frames/arrays/npy_header.h"

#include <QCoreApplication>
#include <QFile>

#include <string_view>
#include <utility>
#include <zip.h>

namespace teleta::frames {

namespace {

struct NumpyFileText {
    Q_DECLARE_TR_FUNCTIONS(NumpyFileText)
};

constexpr zip_int64_t kMostEntries = 4096;

core::Unexpected badFile(const std::string& path, const QString& message, const QString& expected) {
    return core::failed(core::ErrorKind::badInput, message, expected, {path});
}

class NpyFile : public ArrayFile {
public:
    explicit NpyFile(const std::string& path)
        : ArrayFile(path)
        , m_file(QString::fromStdString(path)) {}

    core::Expected<void> open() {
        if (!m_file.open(QIODevice::ReadOnly))
            return core::failed(core::ErrorKind::ioFailed, m_file.errorString(), {}, {m_path});
        TELETA_TRY(m_header, readNpyHeader(reader(), m_path));
        m_values = m_file.pos();
        m_arrays.push_back(m_header.head);
        return {};
    }

    core::Expected<void> read(std::size_t /*array*/, const Take& take) override {
        if (!m_file.seek(m_values))
            return core::failed(core::ErrorKind::ioFailed, m_file.errorString(), {}, {m_path});
        const std::uint64_t count = valuesOf(m_header.head.shape).value_or(0);
        const auto bytes = static_cast<std::uint64_t>(m_file.size() - m_values);
        if (bytes < count * m_header.type.bytes)
            return badFile(m_path,
                           NumpyFileText::tr("the file ends after %1 of %2 values")
                               .arg(bytes / m_header.type.bytes)
                               .arg(count),
                           NumpyFileText::tr("a whole file"));
        return readNpyValues(reader(), m_header, m_path, take);
    }

private:
    ReadBytes reader() {
        return [this](std::span<char> to) -> core::Expected<std::size_t> {
            const qint64 got = m_file.read(to.data(), static_cast<qint64>(to.size()));
            if (got < 0)
                return core::failed(core::ErrorKind::ioFailed, m_file.errorString(), {}, {m_path});
            return static_cast<std::size_t>(got);
        };
    }

    QFile m_file;
    NpyHeader m_header;
    qint64 m_values = 0;
};

struct DiscardZip {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseZipEntry {
    void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using ZipEntryPointer = std::unique_ptr<zip_file_t, CloseZipEntry>;

class NpzFile : public ArrayFile {
public:
    explicit NpzFile(const std::string& path)
        : ArrayFile(path) {}

    core::Expected<void> open() {
        int code = 0;
        m_archive.reset(zip_open(m_path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code));
        if (!m_archive) {
            zip_error_t error;
            zip_error_init_with_code(&error, code);
            const QString reason = QString::fromUtf8(zip_error_strerror(&error));
            zip_error_fini(&error);
            return badFile(m_path, NumpyFileText::tr("the zip archive is damaged: %1").arg(reason),
                           NumpyFileText::tr("a whole npz file"));
        }
        const zip_int64_t count = zip_get_num_entries(m_archive.get(), 0);
        if (count > kMostEntries)
            return badFile(m_path, NumpyFileText::tr("the zip archive has too many files"),
                           NumpyFileText::tr("at most %1").arg(kMostEntries));
        constexpr std::string_view kEnding = ".npy";
        for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
            const char* name = zip_get_name(m_archive.get(), i, ZIP_FL_ENC_GUESS);
            if (name == nullptr || !std::string_view(name).ends_with(kEnding))
                continue;
            TELETA_TRY(const ZipEntryPointer entry, openEntry(i));
            TELETA_TRY(NpyHeader header, readNpyHeader(reader(entry.get(), name), placeOf(name)));
            header.head.name = std::string(name).substr(0, std::string_view(name).size() - kEnding.size());
            m_arrays.push_back(header.head);
            m_entries.push_back({i, name, std::move(header)});
        }
        if (m_arrays.empty())
            return badFile(m_path, NumpyFileText::tr("the zip archive has no array of NumPy"),
                           NumpyFileText::tr("an npz file, with files that end in .npy"));
        return {};
    }

    core::Expected<void> read(std::size_t array, const Take& take) override {
        const Entry& from = m_entries[array];
        TELETA_TRY(const ZipEntryPointer entry, openEntry(from.index));
        const ReadBytes bytes = reader(entry.get(), from.name);
        TELETA_CHECK(readNpyHeader(bytes, placeOf(from.name)));
        return readNpyValues(bytes, from.header, placeOf(from.name), take);
    }

private:
    struct Entry {
        zip_uint64_t index = 0;
        std::string name;
        NpyHeader header;
    };

    /// The file, and what of it.
    [[nodiscard]] std::string placeOf(const std::string& name) const { return m_path + ":" + name; }

    core::Expected<ZipEntryPointer> openEntry(zip_uint64_t index) {
        ZipEntryPointer entry(zip_fopen_index(m_archive.get(), index, 0));
        if (!entry)
            return badFile(m_path,
                           NumpyFileText::tr("the zip archive is damaged: %1")
                               .arg(QString::fromUtf8(zip_strerror(m_archive.get()))),
                           NumpyFileText::tr("a whole npz file that is not encrypted"));
        return entry;
    }

    ReadBytes reader(zip_file_t* entry, const std::string& name) {
        return [this, entry, name](std::span<char> to) -> core::Expected<std::size_t> {
            std::size_t done = 0;
            while (done < to.size()) {
                const zip_int64_t got = zip_fread(entry, to.data() + done, to.size() - done);
                if (got < 0)
                    return badFile(placeOf(name),
                                   NumpyFileText::tr("the zip archive is damaged: %1")
                                       .arg(QString::fromUtf8(zip_file_strerror(entry))),
                                   NumpyFileText::tr("a whole npz file"));
                if (got == 0)
                    break;
                done += static_cast<std::size_t>(got);
            }
            return done;
        };
    }

    std::unique_ptr<zip_t, DiscardZip> m_archive;
    std::vector<Entry> m_entries;
};

template <typename File>
core::Expected<std::unique_ptr<ArrayFile>> opened(const std::string& path) {
    auto file = std::make_unique<File>(path);
    TELETA_CHECK(file->open());
    return file;
}

} // namespace

core::Expected<std::unique_ptr<ArrayFile>> openNpy(const std::string& path) {
    return opened<NpyFile>(path);
}

core::Expected<std::unique_ptr<ArrayFile>> openNpz(const std::string& path) {
    return opened<NpzFile>(path);
}

} // namespace teleta::frames
