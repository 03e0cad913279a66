// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"

#include "backend/core/data/file_kind.h"
#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace teleta::core {

namespace {

constexpr std::size_t kMaximumLine = 16U << 20U;
constexpr std::size_t kFirstBuffer = 256U << 10U;
constexpr std::size_t kShownNames = 8;
constexpr qsizetype kShownCharacters = 40;

struct CsvReaderText {
    Q_DECLARE_TR_FUNCTIONS(CsvReaderText)
};

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

/// What the file has, fit for one line of a terminal: cut after some characters, nothing that is not
/// printable.
QString shown(std::string_view text) {
    QString result =
        QString::fromUtf8(text.data(), static_cast<qsizetype>(std::min<std::size_t>(text.size(), 400)));
    for (QChar& c : result) {
        if (!c.isPrint() && !c.isSurrogate())
            c = QChar(QChar::ReplacementCharacter);
    }
    if (result.size() > kShownCharacters)
        result = result.left(kShownCharacters) + QStringLiteral("…");
    return QStringLiteral("\"%1\"").arg(result);
}

template <typename Names>
QString shownNames(const Names& names) {
    QStringList list;
    for (const auto& name : names) {
        if (list.size() == static_cast<qsizetype>(kShownNames)) {
            list += QStringLiteral("…");
            break;
        }
        const QString text = shown(name);
        list += text.mid(1, text.size() - 2);
    }
    return list.join(QStringLiteral(", "));
}

/// One field of a row: its text without quotes and outer blanks, and where it ends (at the comma or the row's
/// end).
struct Field {
    std::string text;
    const char* end = nullptr;
    bool wellFormed = true; ///< false: something stands before or behind the quotes
};

Field readField(const char* begin, const char* rowEnd) {
    Field field;
    const char* p = std::find_if_not(begin, rowEnd, isBlank);
    if (p == rowEnd || *p != '"') {
        field.end = std::find(p, rowEnd, ',');
        const char* last = field.end;
        while (last > p && isBlank(last[-1]))
            --last;
        field.text.assign(p, last);
        return field;
    }
    for (++p; p < rowEnd; ++p) {
        if (*p == '"') {
            if (p + 1 == rowEnd || p[1] != '"')
                break;
            ++p;
        }
        field.text += *p;
    }
    p = std::find_if_not(std::min(p + 1, rowEnd), rowEnd, isBlank);
    field.end = std::find(p, rowEnd, ',');
    field.wellFormed = field.end == p;
    return field;
}

bool matches(std::errc code) {
    return code == std::errc{};
}

/// Number of a whole text in the C locale; blanks around it and a leading plus are allowed.
bool parseNumber(const char* begin, const char* end, double& value) {
    begin = std::find_if_not(begin, end, isBlank);
    while (end > begin && isBlank(end[-1]))
        --end;
    if (end - begin > 1 && *begin == '+' && begin[1] != '-')
        ++begin;
    const auto [stop, code] = std::from_chars(begin, end, value);
    if (stop != end)
        return false;
    if (code == std::errc::result_out_of_range) {
        // from_chars leaves the value alone here; strtod tells overflow (infinity) from underflow (0 or
        // denormal).
        static const locale_t cLocale = newlocale(LC_ALL_MASK, "C", nullptr);
        value = strtod_l(std::string(begin, end).c_str(), nullptr, cLocale);
        return true;
    }
    return matches(code);
}

Unexpected badInput(const QString& message, const QString& expected, SourcePlace where) {
    return failed(ErrorKind::badInput, message, expected, std::move(where));
}

} // namespace

Unexpected CsvReader::systemError(ErrorKind kind, const QString& what, int code) const {
    return failed(kind, what.arg(QString::fromStdString(std::generic_category().message(code))), {},
                  {m_path});
}

SourcePlace CsvReader::placeOf(const char* position) const {
    SourcePlace place{m_path, m_line, 1};
    for (const char* p = row(); p < position; ++p) {
        if (*p == '\n') {
            ++place.line;
            place.column = 1;
        } else if ((static_cast<unsigned char>(*p) & 0xC0U) != 0x80U) {
            ++place.column; // UTF-8 continuation bytes belong to the character before
        }
    }
    return place;
}

Unexpected CsvReader::tooLong(const char* position) const {
    return badInput(CsvReaderText::tr("the row is too long: more than %1 values").arg(m_header.size()),
                    CsvReaderText::tr("one value per column: %1").arg(m_header.size()), placeOf(position));
}

Unexpected CsvReader::tooShort(std::size_t values, const char* position) const {
    return badInput(
        CsvReaderText::tr("the row is too short: %1 of %2 values").arg(values).arg(m_header.size()),
        CsvReaderText::tr("one value per column: %1").arg(m_header.size()), placeOf(position));
}

SourcePlace CsvReader::place(std::size_t column) const {
    const char* p = row();
    for (; column > 0; --column) {
        p = readField(p, rowEnd()).end;
        if (p == rowEnd())
            break;
        ++p;
    }
    return placeOf(p);
}

Expected<void> CsvReader::openFile() {
    m_file.reset(std::fopen(m_path.c_str(), "re"));
    if (!m_file) {
        const int code = errno;
        if (code == EINTR)
            return systemError(ErrorKind::cancelled, CsvReaderText::tr("opening was interrupted: %1"), code);
        return systemError(code == ENOENT || code == ENOTDIR ? ErrorKind::notFound : ErrorKind::ioFailed,
                           CsvReaderText::tr("cannot open the file: %1"), code);
    }
    struct stat status = {};
    if (::fstat(::fileno(m_file.get()), &status) != 0)
        return systemError(ErrorKind::ioFailed, CsvReaderText::tr("cannot read the file: %1"), errno);
    if (S_ISDIR(status.st_mode))
        return badInput(CsvReaderText::tr("this is a folder"), CsvReaderText::tr("a CSV file"), {m_path});
    if (S_ISREG(status.st_mode)) {
        m_seekable = true;
        m_size = static_cast<std::uint64_t>(status.st_size);
        ::posix_fadvise(::fileno(m_file.get()), 0, 0, POSIX_FADV_SEQUENTIAL);
    }
    m_buffer.resize(kFirstBuffer);
    return {};
}

Expected<void> CsvReader::readHeader() {
    TELETA_CHECK(fill());
    const FileKind kind = fileKindOf({m_buffer.data(), std::min(m_end, kFileKindBytes)});
    if (kind != FileKind::text && kind != FileKind::utf16)
        return badInput(CsvReaderText::tr("the file is %1").arg(describe(kind)),
                        CsvReaderText::tr("a CSV file"), {m_path});
    TELETA_TRY(const bool any, readRow());
    if (!any)
        return badInput(CsvReaderText::tr("the file is empty"),
                        CsvReaderText::tr("a header line with the names of the columns"), {m_path, 1, 1});
    if (m_rowLength >= 2 &&
        (std::memcmp(row(), "\xFF\xFE", 2) == 0 || std::memcmp(row(), "\xFE\xFF", 2) == 0))
        return badInput(CsvReaderText::tr("the file is UTF-16"), CsvReaderText::tr("UTF-8"), {m_path, 1, 1});
    for (const char* p = row();; ++p) {
        Field field = readField(p, rowEnd());
        if (!field.wellFormed)
            return badInput(CsvReaderText::tr("text outside the quotes of a column name"),
                            CsvReaderText::tr("a comma after the closing quote"), placeOf(p));
        m_header.push_back(std::move(field.text));
        p = field.end;
        if (p == rowEnd())
            break;
    }
    return {};
}

/// Gets more bytes behind the ones that are not used yet.
Expected<void> CsvReader::fill() {
    if (m_begin > 0) {
        std::memmove(m_buffer.data(), m_buffer.data() + m_begin, m_end - m_begin);
        m_bufferOffset += m_begin;
        m_end -= m_begin;
        m_begin = 0;
    }
    if (m_end == m_buffer.size())
        m_buffer.resize(std::min(m_buffer.size() * 2, kMaximumLine + kFirstBuffer));
    const ssize_t count = ::read(::fileno(m_file.get()), m_buffer.data() + m_end, m_buffer.size() - m_end);
    if (count < 0) {
        const int code = errno;
        return systemError(code == EINTR ? ErrorKind::cancelled : ErrorKind::ioFailed,
                           CsvReaderText::tr("cannot read the file: %1"), code);
    }
    m_end += static_cast<std::size_t>(count);
    m_atEnd = count == 0;
    return {};
}

/// Finds the next row that is not empty. A line feed inside quotes belongs to the row.
Expected<bool> CsvReader::readRow() {
    for (;;) {
        std::size_t scanned = 0;
        std::ptrdiff_t quotes = 0;
        const char* lineFeed = nullptr;
        for (;;) {
            const char* from = m_buffer.data() + m_begin + scanned;
            const std::size_t unscanned = m_end - m_begin - scanned;
            lineFeed =
                unscanned == 0 ? nullptr : static_cast<const char*>(std::memchr(from, '\n', unscanned));
            const char* to = lineFeed != nullptr ? lineFeed : from + unscanned;
            quotes += std::count(from, to, '"');
            scanned += static_cast<std::size_t>(to - from);
            if (scanned > kMaximumLine)
                return badInput(CsvReaderText::tr("the line is longer than 16 MiB"),
                                quotes % 2 != 0 ? CsvReaderText::tr("a closing quote")
                                                : CsvReaderText::tr("a line end"),
                                {m_path, m_nextLine});
            if (lineFeed != nullptr) {
                if (quotes % 2 == 0)
                    break;
                ++scanned;
            } else if (m_atEnd) {
                break;
            } else if (const Expected<void> filled = fill(); !filled) {
                return Unexpected(filled.error());
            }
        }
        if (scanned == 0 && lineFeed == nullptr)
            return false;

        if (m_bufferOffset + m_begin == 0 && scanned >= 3 &&
            std::memcmp(m_buffer.data(), "\xEF\xBB\xBF", 3) == 0) {
            m_begin = 3;
            scanned -= 3;
        }
        m_rowBegin = m_begin;
        m_rowLength = scanned;
        m_line = m_nextLine;
        m_begin += scanned + (lineFeed != nullptr ? 1 : 0);
        m_nextLine += (lineFeed != nullptr ? 1 : 0) + (quotes > 0 ? std::count(row(), rowEnd(), '\n') : 0);
        if (quotes % 2 != 0)
            return badInput(CsvReaderText::tr("a quote is not closed"), CsvReaderText::tr("a closing quote"),
                            placeOf(std::find(row(), rowEnd(), '"')));
        if (m_rowLength > 0 && rowEnd()[-1] == '\r')
            --m_rowLength;
        if (!std::all_of(row(), rowEnd(), isBlank))
            return true;
    }
}

/// A field that is not a plain number followed by a comma: quoted, NA, out of range, or wrong.
Expected<double> CsvReader::slowField(const char* begin, const char*& end, bool allowNonFinite) const {
    const Field field = readField(begin, rowEnd());
    end = field.end;
    const QString wanted =
        allowNonFinite ? CsvReaderText::tr("a number, nan, inf or NA") : CsvReaderText::tr("a finite number");
    const char* text = field.text.c_str();
    double value = std::numeric_limits<double>::quiet_NaN();
    if (field.text.empty())
        return badInput(CsvReaderText::tr("the field is empty"), wanted, placeOf(begin));
    if (!field.wellFormed || (field.text != "NA" && !parseNumber(text, text + field.text.size(), value)))
        return badInput(CsvReaderText::tr("%1 is not a number").arg(shown({begin, field.end})), wanted,
                        placeOf(begin));
    if (!allowNonFinite && !std::isfinite(value))
        return badInput(CsvReaderText::tr("%1 is not a finite number").arg(shown(field.text)), wanted,
                        placeOf(begin));
    return value;
}

Expected<CsvReader> CsvReader::open(const std::string& path) {
    CsvReader reader;
    reader.m_path = path;
    TELETA_CHECK(reader.openFile());
    TELETA_CHECK(reader.readHeader());
    return reader;
}

Expected<std::size_t> CsvReader::column(std::string_view name) const {
    TELETA_TRY(const std::vector<std::size_t> found, columns({&name, 1}));
    return found.front();
}

Expected<std::vector<std::size_t>> CsvReader::columns(std::span<const std::string_view> names) const {
    std::vector<std::size_t> found;
    std::vector<std::string_view> missing;
    for (const std::string_view name : names) {
        const auto first = std::ranges::find(m_header, name);
        if (first == m_header.end()) {
            missing.push_back(name);
            continue;
        }
        if (std::find(first + 1, m_header.end(), name) != m_header.end())
            return badInput(CsvReaderText::tr("the column %1 appears twice").arg(shown(name)),
                            CsvReaderText::tr("each name only once"), {m_path, 1, 1});
        found.push_back(static_cast<std::size_t>(first - m_header.begin()));
    }
    if (!missing.empty())
        return badInput(CsvReaderText::tr("missing columns: %1; the file has: %2")
                            .arg(shownNames(missing), shownNames(m_header)),
                        CsvReaderText::tr("the columns %1").arg(shownNames(names)), {m_path, 1, 1});
    return found;
}

Expected<bool> CsvReader::next(std::vector<double>& values, bool allowNonFinite) {
    const Expected<bool> any = readRow();
    if (!any || !*any)
        return any;
    const std::size_t columns = m_header.size();
    values.resize(columns);
    const char* const end = rowEnd();
    const char* p = row();
    for (std::size_t i = 0;; ++i, ++p) {
        if (i == columns)
            return tooLong(p);
        const auto [stop, code] = std::from_chars(p, end, values[i]);
        if (matches(code) && (stop == end || *stop == ',') && (allowNonFinite || std::isfinite(values[i]))) {
            p = stop;
        } else {
            TELETA_TRY(const double value, slowField(p, p, allowNonFinite));
            values[i] = value;
        }
        if (p == end) {
            if (i + 1 < columns)
                return tooShort(i + 1, p);
            return true;
        }
    }
}

Expected<bool> CsvReader::nextText(std::vector<std::string_view>& fields) {
    const Expected<bool> any = readRow();
    if (!any || !*any)
        return any;
    const std::size_t columns = m_header.size();
    fields.resize(columns);
    m_quoted.clear();
    const char* const end = rowEnd();
    const char* p = row();
    for (std::size_t i = 0;; ++i, ++p) {
        if (i == columns)
            return tooLong(p);
        const char* first = std::find_if_not(p, end, isBlank);
        if (first != end && *first == '"') {
            Field field = readField(p, end);
            if (!field.wellFormed)
                return badInput(CsvReaderText::tr("text outside the quotes of a value"),
                                CsvReaderText::tr("a comma after the closing quote"), placeOf(p));
            p = field.end;
            fields[i] = m_quoted.emplace_back(std::move(field.text));
        } else {
            const void* comma = std::memchr(first, ',', static_cast<std::size_t>(end - first));
            p = comma != nullptr ? static_cast<const char*>(comma) : end;
            const char* last = p;
            while (last > first && isBlank(last[-1]))
                --last;
            fields[i] = {first, static_cast<std::size_t>(last - first)};
        }
        if (p == end) {
            if (i + 1 < columns)
                return tooShort(i + 1, p);
            return true;
        }
    }
}

Expected<void> CsvReader::seek(std::uint64_t byteOffset, long long line) {
    if (!m_seekable)
        return failed(ErrorKind::refused, CsvReaderText::tr("a pipe cannot be rewound"),
                      CsvReaderText::tr("a file"), {m_path});
    if (byteOffset >= m_bufferOffset && byteOffset - m_bufferOffset <= m_end) {
        m_begin = static_cast<std::size_t>(byteOffset - m_bufferOffset);
    } else {
        if (::lseek(::fileno(m_file.get()), static_cast<off_t>(byteOffset), SEEK_SET) < 0)
            return systemError(ErrorKind::ioFailed, CsvReaderText::tr("cannot read the file: %1"), errno);
        m_bufferOffset = byteOffset;
        m_begin = 0;
        m_end = 0;
    }
    m_atEnd = false;
    m_rowBegin = m_begin;
    m_rowLength = 0;
    m_line = line;
    m_nextLine = line;
    return {};
}

} // namespace teleta::core
