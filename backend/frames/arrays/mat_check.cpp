// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/arrays/mat_check.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QFile>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>
#include <zlib.h>

namespace teleta::frames {

namespace {

struct MatCheckText {
    Q_DECLARE_TR_FUNCTIONS(MatCheckText)
};

constexpr std::uint32_t kPacked = 15;

core::Unexpected brokenAt(const std::string& path, qint64 offset, const QString& what) {
    return core::failed(core::ErrorKind::badInput,
                        MatCheckText::tr("the MAT file is damaged at byte %1: %2").arg(offset).arg(what),
                        MatCheckText::tr("a whole MAT file"), {path});
}

core::Expected<void> openFile(QFile& file, const std::string& path) {
    if (!file.open(QIODevice::ReadOnly))
        return core::failed(core::ErrorKind::ioFailed, file.errorString(), {}, {path});
    return {};
}

std::uint32_t numberAt(const char* bytes, bool isBigEndian) {
    return isBigEndian ? qFromBigEndian<std::uint32_t>(bytes) : qFromLittleEndian<std::uint32_t>(bytes);
}

/// Whether so many bytes from the place of the file are one whole stream of zlib.
bool unpacks(QFile& file, qint64 bytes) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK)
        return false;
    std::vector<unsigned char> packed(std::size_t{1} << 16U);
    std::vector<unsigned char> unpacked(std::size_t{1} << 16U);
    int result = Z_OK;
    while (result == Z_OK && (bytes > 0 || stream.avail_in > 0)) {
        if (stream.avail_in == 0) {
            const qint64 got = file.read(reinterpret_cast<char*>(packed.data()),
                                         std::min<qint64>(bytes, static_cast<qint64>(packed.size())));
            if (got <= 0)
                break;
            bytes -= got;
            stream.next_in = packed.data();
            stream.avail_in = static_cast<uInt>(got);
        }
        stream.next_out = unpacked.data();
        stream.avail_out = static_cast<uInt>(unpacked.size());
        result = inflate(&stream, Z_NO_FLUSH);
    }
    // What is unpacked may fill the buffer at the very end of what is packed.
    while (result == Z_OK && stream.avail_out == 0) {
        stream.next_out = unpacked.data();
        stream.avail_out = static_cast<uInt>(unpacked.size());
        result = inflate(&stream, Z_NO_FLUSH);
    }
    inflateEnd(&stream);
    return result == Z_STREAM_END;
}

} // namespace

core::Expected<void> checkMat5(const std::string& path) {
    QFile file(QString::fromStdString(path));
    TELETA_CHECK(openFile(file, path));
    constexpr qint64 kHead = 128;
    const QByteArray head = file.read(kHead);
    if (head.size() < kHead)
        return brokenAt(path, head.size(), MatCheckText::tr("it ends within its header"));
    const bool isBigEndian = head.endsWith("MI");
    for (qint64 offset = kHead; offset < file.size();) {
        std::array<char, 8> tag{};
        if (!file.seek(offset) || file.read(tag.data(), tag.size()) != static_cast<qint64>(tag.size()))
            return brokenAt(path, offset, MatCheckText::tr("it ends within the header of a variable"));
        const std::uint32_t type = numberAt(tag.data(), isBigEndian);
        const qint64 bytes = numberAt(tag.data() + 4, isBigEndian);
        const qint64 end = offset + static_cast<qint64>(tag.size()) + bytes;
        if (end > file.size())
            return brokenAt(path, offset,
                            MatCheckText::tr("a variable has %1 bytes, there are %2")
                                .arg(bytes)
                                .arg(file.size() - offset - static_cast<qint64>(tag.size())));
        if (type == kPacked && !unpacks(file, bytes))
            return brokenAt(path, offset, MatCheckText::tr("a compressed variable cannot be decompressed"));
        offset = end;
    }
    return {};
}

core::Expected<void> checkMat4(const std::string& path) {
    QFile file(QString::fromStdString(path));
    TELETA_CHECK(openFile(file, path));
    for (qint64 offset = 0; offset < file.size();) {
        std::array<char, 20> head{};
        if (!file.seek(offset) || file.read(head.data(), head.size()) != static_cast<qint64>(head.size()))
            return brokenAt(path, offset, MatCheckText::tr("it ends within the header of a variable"));
        const bool isBigEndian = numberAt(head.data(), false) > 4052;
        const auto number = [&](std::size_t i) { return numberAt(head.data() + 4 * i, isBigEndian); };
        constexpr std::array<std::uint32_t, 6> kBytes{8, 4, 4, 2, 2, 1};
        const std::uint32_t precision = number(0) / 10 % 10;
        const std::uint64_t parts = number(3) == 0 ? 1 : 2;
        constexpr std::uint64_t kMostSide = std::uint64_t{1} << 31U;
        if (number(0) > 5052 || precision >= kBytes.size() || number(1) > kMostSide ||
            number(2) > kMostSide || (number(1) != 0 && number(2) > kMostSide / number(1)))
            return brokenAt(path, offset, MatCheckText::tr("this is not the header of a variable"));
        const std::uint64_t bytes =
            number(4) + std::uint64_t{number(1)} * number(2) * kBytes[precision] * parts;
        const std::uint64_t left =
            static_cast<std::uint64_t>(file.size() - offset) - std::uint64_t{head.size()};
        if (bytes > left)
            return brokenAt(path, offset,
                            MatCheckText::tr("a variable has %1 bytes, there are %2").arg(bytes).arg(left));
        offset += static_cast<qint64>(head.size() + bytes);
    }
    return {};
}

} // namespace teleta::frames
