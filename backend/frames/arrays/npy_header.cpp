// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/arrays/npy_header.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

namespace teleta::frames {

namespace {

struct NpyText {
    Q_DECLARE_TR_FUNCTIONS(NpyText)
};

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kMostHead = std::size_t{1} << 20U;
constexpr std::size_t kMostDimensions = 32; // as NumPy 1
constexpr std::size_t kPiece = 8192;        // values

core::Unexpected damaged(const std::string& path, const QString& message, const QString& expected) {
    return core::failed(core::ErrorKind::badInput, message, expected, {path});
}

core::Unexpected atByte(const std::string& path, std::size_t byte, const QString& expected) {
    return damaged(path, NpyText::tr("the head of the array is damaged at byte %1").arg(byte), expected);
}

core::Unexpected cutOff(const std::string& path) {
    return damaged(path, NpyText::tr("the file ends within the head of the array"),
                   NpyText::tr("a whole file"));
}

/// The literal of Python in the head.
class HeadParser {
public:
    HeadParser(std::string_view text, std::size_t offset, const std::string& path)
        : m_text(text)
        , m_offset(offset)
        , m_path(path) {}

    core::Expected<NpyHeader> parse() {
        NpyHeader header;
        TELETA_CHECK(need('{'));
        for (;;) {
            if (takes('}'))
                break;
            TELETA_TRY(const std::string key, text());
            TELETA_CHECK(need(':'));
            if (key == "descr") {
                TELETA_CHECK(descr(header));
            } else if (key == "fortran_order") {
                TELETA_CHECK(order(header));
            } else if (key == "shape") {
                TELETA_CHECK(shape(header));
            } else {
                return wrong(NpyText::tr("descr, fortran_order and shape"));
            }
            if (!takes(',') && !sees('}'))
                return wrong(QStringLiteral(", or }"));
        }
        skipBlanks();
        if (m_at != m_text.size())
            return wrong(NpyText::tr("the end of the head"));
        if (!m_hasDescr || !m_hasOrder || !m_hasShape)
            return wrong(NpyText::tr("descr, fortran_order and shape"));
        return header;
    }

private:
    [[nodiscard]] core::Unexpected wrong(const QString& expected) const {
        return atByte(m_path, m_offset + m_at, expected);
    }
    void skipBlanks() {
        while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\n'))
            ++m_at;
    }
    [[nodiscard]] bool sees(char c) {
        skipBlanks();
        return m_at < m_text.size() && m_text[m_at] == c;
    }
    [[nodiscard]] bool takes(char c) {
        if (!sees(c))
            return false;
        ++m_at;
        return true;
    }
    core::Expected<void> need(char c) {
        if (!takes(c))
            return wrong(QString(QLatin1Char(c)));
        return {};
    }
    core::Expected<std::string> text() {
        if (!sees('\'') && !sees('"'))
            return wrong(NpyText::tr("a text in quotes"));
        const std::size_t end = m_text.find(m_text[m_at], m_at + 1);
        if (end == std::string_view::npos)
            return wrong(NpyText::tr("a closing quote"));
        std::string result(m_text.substr(m_at + 1, end - m_at - 1));
        m_at = end + 1;
        return result;
    }

    /// The type of the values; a list stands for a structured one and is passed over.
    core::Expected<void> descr(NpyHeader& header) {
        m_hasDescr = true;
        if (!sees('[')) {
            TELETA_TRY(header.head.type, text());
            header.head.problem = setType(header).toStdString();
            return {};
        }
        header.head.type = "structured";
        header.head.problem = NpyText::tr("its values are structured, with fields").toStdString();
        for (int depth = 0; m_at < m_text.size();) {
            const char c = m_text[m_at];
            if (c == '\'' || c == '"') {
                TELETA_CHECK(text());
                continue;
            }
            ++m_at;
            depth += c == '[' || c == '(' ? 1 : c == ']' || c == ')' ? -1 : 0;
            if (depth == 0)
                return {};
        }
        return wrong(QStringLiteral("]"));
    }

    /// What is wrong with the type; empty: nothing.
    static QString setType(NpyHeader& header) {
        const std::string& type = header.head.type;
        const std::string shown = type.substr(0, 20);
        const QString other = NpyText::tr("its values are of type \"%1\"").arg(QString::fromStdString(shown));
        if (type == "O" || (type.size() > 1 && type[1] == 'O'))
            return NpyText::tr("its values are objects of Python, which were pickled");
        if (type.size() < 3 || std::string_view("<>|=").find(type[0]) == std::string_view::npos)
            return other;
        const char kind = type[1];
        std::size_t bytes = 0;
        const char* end = type.data() + type.size();
        const auto [stop, code] = std::from_chars(type.data() + 2, end, bytes);
        if (kind == 'c')
            return NpyText::tr("its values are complex numbers");
        if (kind == 'U' || kind == 'S')
            return NpyText::tr("its values are texts");
        const bool isKnown = code == std::errc() && stop == end &&
                             ((kind == 'b' && bytes == 1) ||
                              ((kind == 'i' || kind == 'u') && std::has_single_bit(bytes) && bytes <= 8) ||
                              (kind == 'f' && std::has_single_bit(bytes) && bytes >= 2 && bytes <= 8));
        if (!isKnown)
            return other;
        header.type = {kind, bytes, type[0] == '>'};
        return {};
    }

    core::Expected<void> order(NpyHeader& header) {
        m_hasOrder = true;
        skipBlanks();
        for (const auto& [word, value] :
             {std::pair{std::string_view("True"), true}, std::pair{std::string_view("False"), false}}) {
            if (m_text.substr(m_at, word.size()) == word) {
                header.head.isColumnMajor = value;
                m_at += word.size();
                return {};
            }
        }
        return wrong(QStringLiteral("True, False"));
    }

    core::Expected<void> shape(NpyHeader& header) {
        m_hasShape = true;
        header.head.shape.clear();
        TELETA_CHECK(need('('));
        while (!takes(')')) {
            skipBlanks();
            std::uint64_t side = 0;
            const char* end = m_text.data() + m_text.size();
            const auto [stop, code] = std::from_chars(m_text.data() + m_at, end, side);
            if (code != std::errc() || header.head.shape.size() == kMostDimensions)
                return wrong(NpyText::tr("whole numbers of 0 or more"));
            m_at = static_cast<std::size_t>(stop - m_text.data());
            if (m_at < m_text.size() && m_text[m_at] == 'L') // Python 2
                ++m_at;
            header.head.shape.push_back(side);
            if (!takes(',') && !sees(')'))
                return wrong(QStringLiteral(", or )"));
        }
        return {};
    }

    std::string_view m_text;
    std::size_t m_offset;
    const std::string& m_path;
    std::size_t m_at = 0;
    bool m_hasDescr = false;
    bool m_hasOrder = false;
    bool m_hasShape = false;
};

/// A number of 16 bits of IEEE 754.
double halfOf(std::uint16_t bits) {
    const int exponent = (bits >> 10U) & 0x1fU;
    const double fraction = bits & 0x3ffU;
    double value = 0.0;
    if (exponent == 0)
        value = std::ldexp(fraction, -24);
    else if (exponent == 31)
        value = fraction == 0.0 ? std::numeric_limits<double>::infinity()
                                : std::numeric_limits<double>::quiet_NaN();
    else
        value = std::ldexp(1024.0 + fraction, exponent - 25);
    return (bits & 0x8000U) != 0 ? -value : value;
}

double numberOf(const char* bytes, const NpyType& type) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
        const auto byte = static_cast<unsigned char>(bytes[type.isBigEndian ? i : type.bytes - 1 - i]);
        bits = (bits << 8U) | byte;
    }
    switch (type.kind) {
    case 'b':
        return bits != 0 ? 1.0 : 0.0;
    case 'u':
        return static_cast<double>(bits);
    case 'i': {
        const auto unused = static_cast<unsigned>(64U - 8U * type.bytes);
        return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
    }
    default:
        break;
    }
    if (type.bytes == 2)
        return halfOf(static_cast<std::uint16_t>(bits));
    return type.bytes == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                           : std::bit_cast<double>(bits);
}

} // namespace

core::Expected<NpyHeader> readNpyHeader(const ReadBytes& read, const std::string& path) {
    char start[12] = {};
    TELETA_TRY(const std::size_t got, read(std::span(start, 8)));
    if (got >= kMagic.size() && std::string_view(start, kMagic.size()) != kMagic)
        return atByte(path, 0, QStringLiteral("\\x93NUMPY"));
    if (got < 8)
        return cutOff(path);
    const auto major = static_cast<unsigned char>(start[6]);
    const auto minor = static_cast<unsigned char>(start[7]);
    if (major < 1 || major > 3 || minor != 0)
        return damaged(path, NpyText::tr("npy of version %1.%2").arg(major).arg(minor),
                       NpyText::tr("version 1.0, 2.0 or 3.0"));
    const std::size_t lengthBytes = major == 1 ? 2 : 4;
    TELETA_TRY(const std::size_t lengthGot, read(std::span(start + 8, lengthBytes)));
    if (lengthGot < lengthBytes)
        return cutOff(path);
    std::size_t length = 0;
    for (std::size_t i = lengthBytes; i-- > 0;)
        length = (length << 8U) | static_cast<unsigned char>(start[8 + i]);
    if (length > kMostHead)
        return atByte(path, 8, NpyText::tr("a head of at most 1 MiB"));
    std::string text(length, '\0');
    TELETA_TRY(const std::size_t textGot, read(text));
    if (textGot < length)
        return cutOff(path);
    return HeadParser(text, 8 + lengthBytes, path).parse();
}

core::Expected<void> readNpyValues(const ReadBytes& read, const NpyHeader& header, const std::string& path,
                                   const ArrayFile::Take& take) {
    const std::uint64_t count = valuesOf(header.head.shape).value_or(0);
    std::vector<char> bytes(kPiece * header.type.bytes);
    std::vector<double> values(kPiece);
    for (std::uint64_t done = 0; done < count;) {
        const std::size_t piece = std::min<std::uint64_t>(kPiece, count - done);
        const std::size_t wanted = piece * header.type.bytes;
        TELETA_TRY(const std::size_t got, read(std::span(bytes.data(), wanted)));
        if (got < wanted)
            return damaged(path,
                           NpyText::tr("the file ends after %1 of %2 values")
                               .arg(done + got / header.type.bytes)
                               .arg(count),
                           NpyText::tr("a whole file"));
        for (std::size_t i = 0; i < piece; ++i)
            values[i] = numberOf(bytes.data() + i * header.type.bytes, header.type);
        if (!take(std::span(values.data(), piece)))
            return core::Unexpected(core::Error{core::ErrorKind::cancelled, {}, {}, {}});
        done += piece;
    }
    // Reading to the end also lets the archive check its checksum.
    TELETA_TRY(const std::size_t more, read(std::span(bytes.data(), 1)));
    if (more > 0)
        return damaged(path, NpyText::tr("the file goes on behind the %1 values of its array").arg(count),
                       NpyText::tr("one array"));
    return {};
}

std::string npyHead(const std::string& descr, std::span<const std::uint64_t> shape) {
    std::string sides;
    for (const std::uint64_t side : shape)
        sides += (sides.empty() ? "" : ", ") + std::to_string(side);
    if (shape.size() == 1)
        sides += ',';
    std::string text = "{'descr': '" + descr + "', 'fortran_order': False, 'shape': (" + sides + "), }";
    // The values begin at a multiple of 64 bytes.
    constexpr std::size_t kBefore = 10;
    text.append(63 - (kBefore + text.size()) % 64, ' ');
    text += '\n';
    std::string head(kMagic);
    head += {'\x01', '\x00', static_cast<char>(text.size() & 0xffU), static_cast<char>(text.size() >> 8U)};
    return head + text;
}

} // namespace teleta::frames
