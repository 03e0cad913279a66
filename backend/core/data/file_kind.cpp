// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/file_kind.h"

#include "backend/core/data/input_file.h"
#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>
#include <array>
#include <cstdint>

namespace teleta::core {

namespace {

struct FileKindText {
    Q_DECLARE_TR_FUNCTIONS(FileKindText)
};

struct Signature {
    std::string_view bytes;
    std::size_t at;
    FileKind kind;
};

using namespace std::string_view_literals;

/// The first that fits counts.
constexpr std::array kSignatures{
    Signature{"\x93NUMPY"sv, 0, FileKind::npy},
    Signature{"PK\x03\x04"sv, 0, FileKind::zip},
    Signature{"PK\x05\x06"sv, 0, FileKind::zip},
    Signature{"\x89HDF\r\n\x1a\n"sv, 0, FileKind::hdf5},
    Signature{"\x89HDF\r\n\x1a\n"sv, 512, FileKind::matlab7},
    Signature{"MATLAB 5.0 MAT-file"sv, 0, FileKind::matlab},
    Signature{"\x00\x01IM"sv, 124, FileKind::matlab},
    Signature{"\x01\x00MI"sv, 124, FileKind::matlab},
    Signature{"SQLite format 3\x00"sv, 0, FileKind::sqlite},
    Signature{"\x89MCAP0\r\n"sv, 0, FileKind::mcap},
    Signature{"\x1f\x8b"sv, 0, FileKind::gzip},
    Signature{"\x28\xb5\x2f\xfd"sv, 0, FileKind::zstd},
    Signature{"\x89PNG"sv, 0, FileKind::png},
    Signature{"\xff\xd8\xff"sv, 0, FileKind::jpeg},
    Signature{"%PDF-"sv, 0, FileKind::pdf},
    Signature{"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"sv, 0, FileKind::excel},
    Signature{"PAR1"sv, 0, FileKind::parquet},
    Signature{"\x80\x02"sv, 0, FileKind::pickle},
    Signature{"\x80\x03"sv, 0, FileKind::pickle},
    Signature{"\x80\x04"sv, 0, FileKind::pickle},
    Signature{"\x80\x05"sv, 0, FileKind::pickle},
    Signature{"ftyp"sv, 4, FileKind::video},
    Signature{"AVI "sv, 8, FileKind::video},
    Signature{"\x1a\x45\xdf\xa3"sv, 0, FileKind::video},
    Signature{"WAVE"sv, 8, FileKind::wav},
    Signature{"\xff\xfe"sv, 0, FileKind::utf16},
    Signature{"\xfe\xff"sv, 0, FileKind::utf16},
};

/// Control characters that no text has.
bool isBinary(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != '\v' && c != '\x1a';
}

/// Whether the bytes begin with the head of a variable of a MAT file of version 4, which has no signature:
/// five numbers of 32 bit (order, precision and kind as MOPT, rows, columns, an imaginary part, length of the
/// name), and a name of MATLAB that ends with a zero.
bool isMat4(std::string_view head) {
    constexpr std::size_t kHead = 20;
    if (head.size() < kHead)
        return false;
    const bool isBigEndian = head[0] == 0 && (head[1] != 0 || head[2] != 0);
    const auto number = [&](std::size_t i) {
        std::uint32_t value = 0;
        for (std::size_t k = 0; k < 4; ++k)
            value = value << 8U | static_cast<unsigned char>(head[4 * i + (isBigEndian ? k : 3 - k)]);
        return value;
    };
    const std::uint32_t form = number(0);
    const std::uint32_t order = isBigEndian ? 1 : 0;
    if (form / 1000 != order || form / 100 % 10 != 0 || form / 10 % 10 > 5 || form % 10 > 2 ||
        number(3) > 1 || number(4) < 2 || number(4) > 64 || head.size() < kHead + number(4))
        return false;
    const std::string_view name = head.substr(kHead, number(4) - 1);
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return head[kHead + name.size()] == '\0' && isLetter(name[0]) && std::ranges::all_of(name, [&](char c) {
               return isLetter(c) || c == '_' || (c >= '0' && c <= '9');
           });
}

} // namespace

FileKind fileKindOf(std::string_view head) {
    for (const Signature& signature : kSignatures)
        if (head.size() >= signature.at + signature.bytes.size() &&
            head.substr(signature.at, signature.bytes.size()) == signature.bytes)
            return signature.kind;
    if (isMat4(head))
        return FileKind::matlab;
    return std::ranges::any_of(head, isBinary) ? FileKind::binary : FileKind::text;
}

Expected<FileKind> fileKind(const std::string& path) {
    TELETA_CHECK(requireFile(path));
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly))
        return failed(ErrorKind::ioFailed, file.errorString(), {}, {path});
    const QByteArray head = file.read(kFileKindBytes);
    return fileKindOf({head.constData(), static_cast<std::size_t>(head.size())});
}

QString describe(FileKind kind) {
    switch (kind) {
    case FileKind::text:
        return FileKindText::tr("text");
    case FileKind::npy:
        return FileKindText::tr("a NumPy array (npy)");
    case FileKind::zip:
        return FileKindText::tr("a zip archive (npz is one)");
    case FileKind::hdf5:
        return FileKindText::tr("an HDF5 file");
    case FileKind::matlab:
        return FileKindText::tr("a MAT file");
    case FileKind::matlab7:
        return FileKindText::tr("a MAT file of version 7.3");
    case FileKind::sqlite:
        return FileKindText::tr("an SQLite database, such as a recording");
    case FileKind::mcap:
        return FileKindText::tr("an MCAP file");
    case FileKind::gzip:
        return FileKindText::tr("a file that gzip has packed");
    case FileKind::zstd:
        return FileKindText::tr("a file that zstd has packed");
    case FileKind::png:
        return FileKindText::tr("a PNG picture");
    case FileKind::jpeg:
        return FileKindText::tr("a JPEG picture");
    case FileKind::pdf:
        return FileKindText::tr("a PDF document");
    case FileKind::excel:
        return FileKindText::tr("an old Excel file");
    case FileKind::parquet:
        return FileKindText::tr("a Parquet file");
    case FileKind::pickle:
        return FileKindText::tr("a pickle of Python");
    case FileKind::video:
        return FileKindText::tr("a video");
    case FileKind::wav:
        return FileKindText::tr("a WAV sound");
    case FileKind::utf16:
        return FileKindText::tr("text in UTF-16");
    case FileKind::binary:
        return FileKindText::tr("binary data of no known format");
    }
    return {};
}

} // namespace teleta::core
