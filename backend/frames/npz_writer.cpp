// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/npz_writer.h"

#include "backend/core/failure.h"
#include "backend/frames/arrays/npy_header.h"

#include <QCoreApplication>

#include <array>
#include <bit>
#include <memory>
#include <utility>
#include <zip.h>

namespace teleta::frames {

namespace {

struct NpzWriterText {
    Q_DECLARE_TR_FUNCTIONS(NpzWriterText)
};

static_assert(std::endian::native == std::endian::little, "npz files are written little-endian");

struct DiscardNpz {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};

/// 2026-01-01, so that equal arrays give equal bytes.
constexpr zip_uint16_t kNpzDate = (46U << 9U) | (1U << 5U) | 1U;

core::Unexpected notWritten(const std::string& path, const QString& reason) {
    return core::failed(core::ErrorKind::ioFailed, NpzWriterText::tr("cannot write the file: %1").arg(reason),
                        {}, {path});
}

/// The head and the values are two pieces of one file of the archive.
bool addArray(zip_t* archive, const NpzArray& array) {
    std::array<zip_buffer_fragment_t, 2> pieces{};
    // The library does not change what it reads from.
    const auto bytesOf = [](const void* data) {
        return static_cast<zip_uint8_t*>(
            const_cast<void*>(data)); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    };
    pieces[0] = {bytesOf(array.head.data()), array.head.size()};
    pieces[1] = {bytesOf(array.values.data()), array.values.size()};
    zip_source_t* source =
        zip_source_buffer_fragment(archive, pieces.data(), array.values.empty() ? 1 : 2, 0);
    if (source == nullptr)
        return false;
    const zip_int64_t index = zip_file_add(archive, (array.name + ".npy").c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        return false;
    }
    const auto entry = static_cast<zip_uint64_t>(index);
    return zip_set_file_compression(archive, entry, ZIP_CM_STORE, 0) == 0 &&
           zip_file_set_dostime(archive, entry, 0, kNpzDate, 0) == 0;
}

} // namespace

NpzArray::NpzArray(std::string name_, std::vector<std::uint64_t> shape, std::span<const float> values_)
    : name(std::move(name_))
    , head(npyHead("<f4", shape))
    , values(std::as_bytes(values_)) {
}

NpzArray::NpzArray(std::string name_, std::vector<std::uint64_t> shape, std::span<const double> values_)
    : name(std::move(name_))
    , head(npyHead("<f8", shape))
    , values(std::as_bytes(values_)) {
}

NpzArray::NpzArray(std::string name_, std::vector<std::uint64_t> shape, std::span<const std::int64_t> values_)
    : name(std::move(name_))
    , head(npyHead("<i8", shape))
    , values(std::as_bytes(values_)) {
}

core::Expected<void> writeNpz(const std::string& path, std::span<const NpzArray> arrays) {
    int code = 0;
    std::unique_ptr<zip_t, DiscardNpz> archive(zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
    if (!archive) {
        zip_error_t error;
        zip_error_init_with_code(&error, code);
        const QString reason = QString::fromUtf8(zip_error_strerror(&error));
        zip_error_fini(&error);
        return notWritten(path, reason);
    }
    for (const NpzArray& array : arrays)
        if (!addArray(archive.get(), array))
            return notWritten(path, QString::fromUtf8(zip_strerror(archive.get())));
    if (zip_close(archive.get()) != 0)
        return notWritten(path, QString::fromUtf8(zip_strerror(archive.get())));
    (void)archive.release();
    return {};
}

} // namespace teleta::frames
